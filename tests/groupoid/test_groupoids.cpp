// Groupoids: their laws, the step on them, the map that a function generates, and input that has no answer.
#include <boost/test/unit_test.hpp>

#include "actio/groupoid/action_groupoid.hpp"
#include "actio/groupoid/diagonal_quotient.hpp"
#include "actio/groupoid/gauge_groupoid.hpp"
#include "actio/groupoid/group_as_groupoid.hpp"
#include "actio/groupoid/lagrange_equations.hpp"
#include "actio/groupoid/opposite_groupoid.hpp"
#include "actio/groupoid/pair_groupoid.hpp"
#include "actio/groups/motions.hpp"
#include "groupoid_laws.hpp"
#include "refused.hpp"
#include "witness/draw.hpp"

using namespace actio;
using namespace actio::testing;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
using Turn = Element<SO<3>, double>;

Vector<double> column(Draw& draw, int n) { return draw.vector<double>(n); }

/// Composition without the change of the vector: it is not associative with the targets.
struct Forgetful : ActionGroupoid<SO<3>> {
  template <class S>
  static CarriedVector<S> target(ActionArrow<SO<3>, S> const& g) { return {g.vector}; }
};

/// The trace Lagrangian of a body with a weight.
auto const heavy = [](auto const& g) {
  using S = typename std::decay_t<decltype(g)>::Scalar;
  Vector<double, 3> const lambda(0.5, 0.8, 1.3);
  S sum(0);
  for (int i = 0; i < 3; ++i) sum += (S(1) - g.element.value(i, i)) * S(lambda[i] / 0.1);
  return S(sum - g.vector[2] * S(0.05));
};

}  // namespace

BOOST_AUTO_TEST_SUITE(groupoids)

BOOST_AUTO_TEST_CASE(laws_hold_on_every_groupoid) {
  Draw draw(11);
  auto const r = [&] { return draw.element<double>(SO<3>{}); };
  for (int repeat = 0; repeat < 20; ++repeat) {
    Turn const a = r(), b = r(), c = r(), d = r();
    auto const good = [](BrokenLaw const& worst) {
      BOOST_TEST(worst.by <= 32 * eps, worst.law << " is broken by " << worst.by);
    };
    using PairOf = Arrow<PairGroupoid<SO<3>>, double>;
    good(groupoid_laws(PairGroupoid<SO<3>>{}, PairOf{a, b}, PairOf{b, c}, PairOf{c, d}));
    good(groupoid_laws(GroupAsGroupoid<SO<3>>{}, a, b, c));
    good(groupoid_laws(Opposite<GroupAsGroupoid<SO<3>>>{}, a, b, c));
    ActionGroupoid<SO<3>> const carrying;
    using Carried = Arrow<ActionGroupoid<SO<3>>, double>;
    Carried const x{a, column(draw, 3)}, y{b, carrying.target(x).value}, z{c, carrying.target(y).value};
    good(groupoid_laws(carrying, x, y, z));
    using Gauged = Arrow<GaugeGroupoid<SO<3>>, double>;
    Vector<double> const p = column(draw, 2), q = column(draw, 2), s = column(draw, 2), t = column(draw, 2);
    good(groupoid_laws(GaugeGroupoid<SO<3>>{{}, 2}, Gauged{p, q, a}, Gauged{q, s, b}, Gauged{s, t, c}));
    using Seen = Arrow<DiagonalQuotient<SO<3>, 2>, double>;
    good(
        groupoid_laws(DiagonalQuotient<SO<3>, 2>{}, Seen{{a}, {b}, c}, Seen{{b}, {c}, d}, Seen{{c}, {d}, a}));
  }
}

BOOST_AUTO_TEST_CASE(arrows_of_copies_are_pairs_of_configurations_up_to_a_motion_of_all) {
  Draw draw(16);
  using Three = DiagonalQuotient<SO<3>, 3>;
  auto const configuration = [&] {
    return std::array{draw.element<double>(SO<3>{}), draw.element<double>(SO<3>{}),
                      draw.element<double>(SO<3>{})};
  };
  auto const a = configuration(), b = configuration(), c = configuration();
  Turn const all = draw.element<double>(SO<3>{});
  auto const apart = [](auto const& g, auto const& h) {
    return (Three::entries(g) - Three::entries(h)).norm();
  };
  auto const moved = [&](auto const& g) { return std::array{all * g[0], all * g[1], all * g[2]}; };
  auto const moved_from_the_right = [&](auto const& g) {
    return std::array{g[0] * all, g[1] * all, g[2] * all};
  };
  auto const ab = Three::reduced<double>(a, b), bc = Three::reduced<double>(b, c);
  BOOST_TEST(apart(Three::reduced<double>(moved(a), moved(b)), ab) <= 32 * eps);
  BOOST_TEST(apart(Three::reduced<double>(moved_from_the_right(a), moved_from_the_right(b)), ab) > 0.1);
  BOOST_TEST(apart(Three::compose(ab, bc), Three::reduced<double>(a, c)) <= 32 * eps);
  // How each copy moves, and the arrow from these motions.
  for (int i = 0; i < 3; ++i)
    BOOST_TEST((ab.motion(i).value - (inverse(a[i]) * b[i]).value).norm() <= 32 * eps);
  BOOST_TEST(apart(Three::moving<double>(Three::seen_from_first<double>(a),
                                         {ab.motion(0), ab.motion(1), ab.motion(2)}),
                   ab) <= 32 * eps);
}

BOOST_AUTO_TEST_CASE(a_broken_law_is_found) {
  Draw draw(12);
  using Carried = Arrow<ActionGroupoid<SO<3>>, double>;
  Vector<double> const v = column(draw, 3);
  Carried const x{draw.element<double>(SO<3>{}), v}, y{draw.element<double>(SO<3>{}), v},
      z{draw.element<double>(SO<3>{}), v};
  auto const worst = groupoid_laws(Forgetful{}, x, y, z);
  BOOST_TEST(worst.by > 0.01);
}

BOOST_AUTO_TEST_CASE(a_step_solves_the_equation_and_the_generated_map_joins_its_ends) {
  ActionGroupoid<SO<3>> const gamma;
  Draw draw(13);
  auto const turn = exp(velocity(SO<3>{}, Vector<double, 3>(0.1, 0.25, -0.2)));
  Arrow<ActionGroupoid<SO<3>>, double> g{turn, column(draw, 3)};
  for (int k = 0; k < 50; ++k) {
    Arrow<ActionGroupoid<SO<3>>, double> const guess{g.element, gamma.target(g).value};
    auto const next = step_lagrange(gamma, heavy, g, guess);
    auto const scale = legendre_at_target(gamma, heavy, g).components.norm();
    BOOST_TEST(lagrange_equations(gamma, heavy, g, next.value).norm() <= 64 * eps * scale);
    BOOST_TEST(next.report.evaluations <= 6);
    auto const image = generated_map(gamma, heavy, legendre_at_target(gamma, heavy, g), guess);
    BOOST_TEST((image.components - legendre_at_target(gamma, heavy, next.value).components).norm() <=
               64 * eps * scale);
    g = next.value;
  }
}

BOOST_AUTO_TEST_CASE(the_two_legendre_maps_of_a_group_are_its_two_differentials) {
  Draw draw(14);
  GroupAsGroupoid<SE<3>> const gamma;
  auto const l = [](auto const& f) {
    auto sum = f.value(0, 1) * f.value(1, 2);
    for (int i = 0; i < 3; ++i) sum += f.value(i, 3) * f.value(i, 3) * (i + 1) - f.value(i, i) * (3 - i);
    return sum;
  };
  auto const f = draw.element<double>(SE<3>{});
  BOOST_TEST((legendre_at_target(gamma, l, f).components - left_differential(l, f).components).norm() <=
             64 * eps);
  BOOST_TEST((legendre_at_source(gamma, l, f).components - right_differential(l, f).components).norm() <=
             64 * eps);
}

BOOST_AUTO_TEST_CASE(what_has_no_answer_is_refused) {
  ActionGroupoid<SO<3>> const gamma;
  Draw draw(15);
  Arrow<ActionGroupoid<SO<3>>, double> const guess{identity<double>(SO<3>{}), column(draw, 3)};
  CHECK_REFUSED(arrow_with_source_covector(gamma, heavy, Vector<double, 3>(1, std::nan(""), 0), guess),
                NotFinite);
  // More momentum than any relative motion has: the trace Lagrangian is bounded.
  CHECK_REFUSED(arrow_with_source_covector(gamma, heavy, Vector<double, 3>(0, 0, 1000), guess), Error);
  auto const flat = [](auto const& g) { return g.element.value(0, 0) * 0; };
  CHECK_REFUSED(arrow_with_source_covector(gamma, flat, Vector<double, 3>(1, 0, 0), guess), Singular);
}

BOOST_AUTO_TEST_SUITE_END()
