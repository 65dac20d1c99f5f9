// Motions with an advected vector that remember what a step has found, on either side, and what is measured
// where a step on momenta is refused.
#include <boost/test/unit_test.hpp>

#include "actio/reduction/advected_steps.hpp"
#include "actio/reduction/composition.hpp"
#include "actio/reduction/galerkin.hpp"
#include "caught.hpp"
#include "refused.hpp"
#include "uneven_lagrangian.hpp"

using namespace actio;
using namespace actio::testing;
using testing::caught;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Refused with these figures.
template <class Call>
void is_refused(Call const& call, double measured, double bound) {
  auto const e = caught<OutsideDomain>(call);
  BOOST_TEST(e.measured == measured, e.what());
  BOOST_TEST(e.bound == bound, e.what());
}

/// A body without symmetry in a field that depends on where it is and on how it turns.
struct BodyInField {
  Matrix<double> inertia;
  Vector<double> slope;
  double h;

  template <class G, class T, int m>
  T operator()(Element<G, T> const& f, Matrix<T, m, 1> const& a) const {
    auto const w = log(f).coordinates;
    T kinetic(0), height(0);
    for (Index i = 0; i < w.size(); ++i)
      for (Index j = 0; j < w.size(); ++j) kinetic += w[i] * w[j] * inertia(i, j);
    for (Index i = 0; i < a.size(); ++i) height += a[i] * slope[i];
    return kinetic / (2 * h) - (height + height * height / 4 + height * w[0] / h) * h;
  }
};

template <int side>
void steps_are_those_from_scratch(SpannedGroup const& group) {
  Draw draw(31);
  double const h = 0.05;
  int const n = group.dimension(), steps = 25;
  BodyInField l{Matrix<double>::Identity(n, n) * (n + 1), draw.vector<double>(group.matrix_size()), h};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j) l.inertia(i, j) = l.inertia(j, i) = l.inertia(i, j) + draw.number<double>();
  Vector<double> a = draw.vector<double>(group.matrix_size());
  auto const first = a;
  auto f = exp(h * draw.velocity<double>(group));
  auto motion = [&] {
    if constexpr (side > 0)
      return AdvectedStepsRight(l, f, a);
    else
      return AdvectedStepsLeft(l, f, a);
  }();
  double worst = 0, motions = 0;
  BOOST_TEST_CONTEXT(group.name() << ", side " << side) {
    for (int k = 0; k < steps; ++k) {
      auto const next = side > 0 ? step_advected_euler_poincare_right(l, f, a).value
                                 : step_advected_euler_poincare_left(l, f, a).value;
      a = side > 0 ? advect_right(f, a) : advect_left(f, a);
      f = next;
      auto const& found = motion.advance();
      BOOST_TEST((found.value == motion.relative_motion().value));
      worst = std::max({worst, magnitude((found.value - f.value).eval())});
      motions = std::max(motions, magnitude(f.value));
      BOOST_REQUIRE(motion.report().residuals.back() <= 4 * motion.report().tolerance);
    }
    // Momentum and vector belong to the configuration that the last motion leads to.
    auto const after =
        side > 0 ? advected_momentum_after_right(l, f, a) : advected_momentum_after_left(l, f, a);
    Vector<double> const carried = side > 0 ? advect_right(f, a) : advect_left(f, a);
    // A relative motion is found to 16 eps, its velocity and the momentum to 16 eps/h, at each step.
    double const bound = 4 * 16 * eps / h * steps;
    BOOST_TEST(worst <= bound * motions);
    BOOST_TEST(magnitude((motion.state().momentum - after).components) <=
               bound * magnitude(after.components));
    BOOST_TEST(magnitude((motion.state().vector - carried).eval()) <= bound * magnitude(carried));
    BOOST_TEST(magnitude((carried - first).eval()) > 1e-2);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(advected_steps)

BOOST_AUTO_TEST_CASE(motions_that_remember_are_those_from_scratch_on_either_side) {
  for (auto const& group : four_groups())
    steps_are_those_from_scratch<-1>(group), steps_are_those_from_scratch<1>(group);
}

BOOST_AUTO_TEST_CASE(vectors_that_are_no_numbers_start_no_motion) {
  auto const& group = four_groups()[0];
  BodyInField const l{Matrix<double>::Identity(3, 3), Vector<double>(Vector<double, 3>(1, 2, 3)), 0.1};
  auto const f = exp(velocity(group, Vector<double>(Vector<double, 3>(0.1, 0.2, -0.1))));
  for (double const bad : {std::nan(""), HUGE_VAL}) {
    Vector<double> const a = Vector<double, 3>(0.5, bad, 1);
    CHECK_REFUSED(AdvectedStepsLeft(l, f, a), NotFinite);
    CHECK_REFUSED(AdvectedStepsRight(l, f, a), NotFinite);
  }
}

BOOST_AUTO_TEST_CASE(orders_degrees_and_steps_are_refused_with_what_they_are) {
  for (int const order : {0, 1, -2}) is_refused([&] { symmetric_composition<double>(order); }, order, 2);
  for (int const order : {3, 5, 7, 9, 10})
    is_refused([&] { symmetric_composition<double>(order); }, order, 8);
  for (int const order : {2, 4, 6, 8}) {
    auto const fractions = symmetric_composition<double>(order);
    BOOST_TEST(fractions.size() == static_cast<std::size_t>(std::lround(std::pow(5, order / 2 - 1))));
  }
  is_refused([] { PolynomialPath<double>(0); }, 0, 1);
  is_refused([] { PolynomialPath<double>(-3); }, -3, 1);
  is_refused([] { PolynomialPath<double>(9); }, 9, 8);
  BOOST_TEST(PolynomialPath<double>(8).degree() == 8);
  is_refused([] { detail::nonzero_step(0.0); }, 0, 0);
  BOOST_TEST(caught<OutsideDomain>([] { detail::nonzero_step(-HUGE_VAL); }).measured == -HUGE_VAL);
  BOOST_TEST(detail::nonzero_step(-0.25) == -0.25);
}

BOOST_AUTO_TEST_CASE(fractions_must_add_up_to_one_within_their_rounding) {
  using List = std::vector<double>;
  is_refused([] { detail::fractions_of_a_step(List{0.5, 0.25}); }, 0.75, 1);
  is_refused([] { detail::fractions_of_a_step(List{}); }, 0, 1);
  // Eight units in the last place for each unit of length, back and forth.
  auto const apart = [](double size, double by) {
    return [=] { detail::fractions_of_a_step(List{size, 1 - size + by}); };
  };
  BOOST_CHECK_NO_THROW(apart(0.5, 12 * eps)());
  CHECK_REFUSED(apart(0.5, 20 * eps)(), OutsideDomain);
  BOOST_CHECK_NO_THROW(apart(8.5, -16 * 8 * eps)());
  CHECK_REFUSED(apart(8.5, -16 * 10 * eps)(), OutsideDomain);
}

BOOST_AUTO_TEST_CASE(a_path_far_outside_of_the_chart_is_refused_with_its_size) {
  // Powers of a turn by sqrt(900 300) = 520 over factorials still grow after 300 terms.
  Matrix<double> w(2, 2);
  w << 0, 900, -300, 0;
  Vector<double> const v = Vector<double, 2>(1, 2);
  is_refused([&] { detail::iex_times(w, v); }, 900, 2 * M_PI);
  // iex(w) v = (e^w - 1)/w v; for a turn by 1/2 it is (sin 1/2, 1 - cos 1/2)/(1/2) of (1, 0).
  w << 0, -0.5, 0.5, 0;
  Vector<double> const turned = detail::iex_times(w, Vector<double>(Vector<double, 2>(1, 0)));
  BOOST_TEST(std::abs(turned[0] - std::sin(0.5) / 0.5) < 4 * eps);
  BOOST_TEST(std::abs(turned[1] - (1 - std::cos(0.5)) / 0.5) < 4 * eps);
}

BOOST_AUTO_TEST_CASE(a_composition_counts_the_looks_of_its_substeps_and_joins_their_motions) {
  Draw draw(6);
  auto const& group = four_groups()[1];
  UnevenLagrangian<double> const l(draw, group);
  auto const start = momentum_state(l, draw.velocity<double>(group));
  std::vector<double> const fractions{0.75, -0.5, 0.75};
  double const h = 0.1;
  auto const whole = ComposedRight(natural_chart_step_right(l), fractions)(start, h);
  auto const other = ComposedLeft(natural_chart_step_left(l), fractions)(start, h);
  int looks = 0, other_looks = 0;
  auto f = identity<double>(group), g = f;
  auto right = start, left = start;
  for (double const part : fractions) {
    auto const one = natural_chart_step_right(l)(right, part * h);
    auto const two = natural_chart_step_left(l)(left, part * h);
    f = f * one.relative_motion, g = two.relative_motion * g;
    right = one.state, left = two.state;
    looks += one.evaluations, other_looks += two.evaluations;
  }
  BOOST_TEST(whole.evaluations == looks);
  BOOST_TEST(other.evaluations == other_looks);
  BOOST_TEST(magnitude((whole.relative_motion.value - f.value).eval()) < 16 * eps);
  BOOST_TEST(magnitude((other.relative_motion.value - g.value).eval()) < 16 * eps);
  BOOST_TEST(magnitude((whole.relative_motion.value - other.relative_motion.value).eval()) > 1e-3);
}

BOOST_AUTO_TEST_SUITE_END()
