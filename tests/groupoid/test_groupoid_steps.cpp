// Steps on every groupoid, arrows that leave a point, opposite groupoids, and refusals with what was
// measured.
#include <boost/test/unit_test.hpp>

#include "actio/groupoid/action_groupoid.hpp"
#include "actio/groupoid/diagonal_quotient.hpp"
#include "actio/groupoid/gauge_groupoid.hpp"
#include "actio/groupoid/generating_series.hpp"
#include "actio/groupoid/group_as_groupoid.hpp"
#include "actio/groupoid/lagrange_equations.hpp"
#include "actio/groupoid/opposite_groupoid.hpp"
#include "actio/groupoid/pair_groupoid.hpp"
#include "actio/groups/motions.hpp"
#include "actio/groups/special_linear.hpp"
#include "caught.hpp"
#include "groupoid_laws.hpp"
#include "witness/draw.hpp"

using namespace actio;
using namespace actio::testing;
using testing::caught;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
using G = SE<2>;
using Column = Vector<double>;

/// Three arrows in a row of each groupoid; the group is neither commutative nor of rotations.
struct Arrows {
  Draw draw{23};
  auto element() { return draw.element<double>(G{}); }
  auto of(PairGroupoid<G> const&) {
    auto const a = element(), b = element(), c = element(), d = element();
    return std::array<PairArrow<G, double>, 3>{{{a, b}, {b, c}, {c, d}}};
  }
  auto of(GroupAsGroupoid<G> const&) { return std::array{element(), element(), element()}; }
  auto of(ActionGroupoid<G> const& gamma) {
    ActionArrow<G, double> const a{element(), draw.vector<double, Column>(3)},
        b{element(), gamma.target(a).value}, c{element(), gamma.target(b).value};
    return std::array{a, b, c};
  }
  auto of(GaugeGroupoid<G> const& gamma) {
    auto const x = [&] { return draw.vector<double, Column>(gamma.base); };
    Column const p = x(), q = x(), r = x(), s = x();
    return std::array<GaugeArrow<G, double>, 3>{{{p, q, element()}, {q, r, element()}, {r, s, element()}}};
  }
  template <int n>
  auto of(DiagonalQuotient<G, n> const&) {
    std::array<std::array<Element<G, double>, n>, 4> g;
    for (auto& configuration : g)
      for (auto& copy : configuration) copy = element();
    auto const arrow = [&](int k) {
      return DiagonalQuotient<G, n>::template reduced<double>(g[k], g[k + 1]);
    };
    return std::array{arrow(0), arrow(1), arrow(2)};
  }
};

/// A function of all numbers of an arrow that joins its two ends: of second degree, and a cubic.
template <class Gamma>
struct Lagrangian {
  Gamma const& gamma;
  Column away;
  Matrix<double> weight;
  template <class A>
  auto operator()(A const& g) const {
    auto const x = gamma.entries(g);
    using S = typename A::Scalar;
    S sum(0), along(0);
    for (Index i = 0; i < x.size(); ++i) {
      S row(0);
      for (Index k = 0; k < x.size(); ++k) row += (x[k] - S(away[k])) * S(weight(i, k));
      sum += (x[i] - S(away[i])) * row;
      along += (x[i] - S(away[i])) * S(weight(i, 0));
    }
    return S(sum + along * along * along / S(20));
  }
};

template <class Gamma>
void steps_and_opposites(Gamma const& gamma, char const* name) {
  Arrows arrows;
  auto const [g, h, k] = arrows.of(gamma);
  BOOST_TEST_CONTEXT(name) {
    Opposite<Gamma> const opposite{gamma};
    BrokenLaw const laws = groupoid_laws(gamma, g, h, k), other = groupoid_laws(opposite, k, h, g);
    BOOST_TEST(laws.by <= 64 * eps, laws.law);
    BOOST_TEST(other.by <= 64 * eps, other.law);
    BOOST_TEST(opposite.dimension() == gamma.dimension());
    BOOST_TEST(opposite.base_dimension() == gamma.base_dimension());
    // Arrows that leave a point do it at the rate of those infinitely near its unit.
    Column const v = arrows.draw.template vector<double, Column>(gamma.dimension());
    auto const leaves_as_near = [&](auto const& of) {
      Fibre<Gamma, Dual<double>> moving = Fibre<Gamma, Dual<double>>::Zero(gamma.dimension());
      for (Index a = 0; a < v.size(); ++a) moving[a].part[0] = v[a];
      auto const wide = of.source(of.template over<Dual<double>>(g));
      auto const left = of.entries(of.leave(wide, moving)), near = of.entries(of.near_unit(wide, moving));
      for (Index i = 0; i < near.size(); ++i) {
        BOOST_TEST(std::abs(left[i].value - near[i].value) <= 8 * eps);
        BOOST_TEST(std::abs(left[i].part[0] - near[i].part[0]) <= 32 * eps * (1 + std::abs(near[i].part[0])));
      }
    };
    leaves_as_near(gamma), leaves_as_near(opposite);

    // An arrow is found again from the covector at its source, and the step leads to the one whose covector
    // is that at the target of the one before.
    auto const finds = [&](auto const& of, auto const& first) {
      auto const x = of.target(first);
      Fibre<Gamma, double> const small = Fibre<Gamma, double>(v / 20), start = Fibre<Gamma, double>(v / 30);
      auto const sought = of.leave(x, small), guess = of.leave(x, start);
      Column const away = of.entries(of.unit(x));
      Matrix<double> weight = Matrix<double>::Identity(away.size(), away.size());
      for (Index i = 0; i < away.size(); ++i)
        weight.col(i) += arrows.draw.template vector<double, Column>(static_cast<int>(away.size()));
      Lagrangian<std::decay_t<decltype(of)>> const l{of, away, weight};
      Fibre<Gamma, double> const p = legendre_at_source(of, l, sought).components;
      auto const found = arrow_with_source_covector(of, l, p, guess);
      BOOST_TEST((of.entries(found.value) - of.entries(sought)).norm() < 4096 * eps);
      BOOST_TEST(found.report.tolerance == 16 * eps);
      BOOST_TEST(found.report.evaluations == static_cast<int>(found.report.residuals.size()));
      auto const end = legendre_at_target(of, l, found.value);
      auto const image = generated_map(of, l, DualPoint<std::decay_t<decltype(of)>, double>{x, p}, guess);
      BOOST_TEST((image.components - end.components).norm() < 4096 * eps);
      auto const cut = caught<NotConverged>([&] { arrow_with_source_covector(of, l, p, guess, 1); });
      BOOST_TEST(cut.residuals.size() == 1u);
      BOOST_TEST(cut.tolerance == 16 * eps);
    };
    finds(gamma, g), finds(opposite, h);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(groupoid_steps)

BOOST_AUTO_TEST_CASE(every_groupoid_has_an_opposite_and_finds_arrows_by_their_covectors) {
  steps_and_opposites(PairGroupoid<G>{}, "pairs");
  steps_and_opposites(GroupAsGroupoid<G>{}, "group");
  steps_and_opposites(ActionGroupoid<G>{}, "action");
  steps_and_opposites(GaugeGroupoid<G>{{}, 2}, "gauge");
  steps_and_opposites(DiagonalQuotient<G, 2>{}, "two copies");
  steps_and_opposites(DiagonalQuotient<G, 3>{}, "three copies");
}

BOOST_AUTO_TEST_CASE(quadratic_lagrangians_and_their_series_are_refused_with_their_figures) {
  using Square = Matrix<double, 3, 3>;
  auto const quadratic = [](Square const& a) { return QuadraticLagrangian<G, double>(G{}, a); };
  Square a;
  a << 4, 1, 0, 1, 5, -0.5, 0, -0.5, 8;
  Square skewed = a;
  skewed(0, 2) += 0.25, skewed(1, 2) += 0.125;
  auto const e = caught<OutsideDomain>([&] { quadratic(skewed); });
  BOOST_TEST(e.measured == 0.25);
  BOOST_TEST(e.bound == 16 * eps * 8);
  skewed = a, skewed(0, 2) += 16 * eps * 8;
  BOOST_CHECK_NO_THROW(quadratic(skewed));
  auto const series = caught<OutsideDomain>([&] { generating_series(quadratic(a), -1); });
  BOOST_TEST(series.measured == -1);
  BOOST_TEST(series.bound == 0);
  auto const g = exp(velocity(G{}, Vector<double, 3>(0.1, 0.2, 0.3)));
  BOOST_TEST(caught<OutsideDomain>([&] { ExactGeneratingFunction{quadratic(a)}(g, 0.0); }).measured == 0);
  // A group whose size is known when it runs.
  SL<> const sl(2);
  for (auto const& [rows, columns, length] : {std::array{2, 3, 3}, {3, 2, 3}, {3, 3, 2}, {4, 4, 3}}) {
    auto const wrong = caught<OutsideDomain>([&, r = rows, c = columns, n = length] {
      QuadraticLagrangian<SL<>, double>(sl, Matrix<double>::Identity(r, c), Column::Zero(n));
    });
    BOOST_TEST(wrong.measured == rows);
    BOOST_TEST(wrong.bound == 3);
  }
}

BOOST_AUTO_TEST_CASE(a_long_free_motion_is_two_of_half_the_time) {
  Matrix<double, 3, 3> a;
  a << 1.2, 0.1, -0.2, 0.1, 2.1, 0.3, -0.2, 0.3, 2.6;
  QuadraticLagrangian<G, double> const l(G{}, a, Vector<double, 3>(0.4, -0.3, 0.7));
  auto const pi = momentum(G{}, Vector<double, 3>(0.7, -1.1, 0.9));
  double const t = 6;
  auto const whole = free_motion_left(l, pi, t), first = free_motion_left(l, pi, t / 2),
             second = free_motion_left(l, first.pi, t / 2);
  double const room = 4096 * eps;
  BOOST_TEST((whole.f.value - (second.f * first.f).value).norm() < room);
  BOOST_TEST((whole.pi.components - second.pi.components).norm() < room);
  BOOST_TEST(std::abs(whole.action - first.action - second.action) < room);
  // The momentum goes with the motion, and the energy stays.
  BOOST_TEST((Ad_star(inverse(whole.f), pi).components - whole.pi.components).norm() < room);
  BOOST_TEST(std::abs(l(whole.pi) - l(pi)) < room);
  // Without halving the series does not get that far.
  auto const e = caught<NotConverged>([&] { free_motion_left(l, pi, 40.0, 0); });
  BOOST_TEST(e.tolerance == eps);
  BOOST_TEST_REQUIRE(e.residuals.size() == 1u);
  BOOST_TEST(e.residuals[0] > eps);
}

BOOST_AUTO_TEST_SUITE_END()
