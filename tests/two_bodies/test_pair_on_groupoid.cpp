// The step of two bodies as a solution of the Lagrange equations on (SE(3) x SE(3))^2 / SE(3): residuals
// there and on pairs, Newton's way, reconstruction, brackets and leaves, and steps that are no solutions.
#include <boost/test/unit_test.hpp>

#include "actio/groupoid/lagrange_equations.hpp"
#include "actio/instruments/discrete_spaces.hpp"
#include "actio/instruments/dual_of_algebroid.hpp"
#include "actio/instruments/leaf_defect.hpp"
#include "actio/instruments/poisson_defect.hpp"
#include "actio/instruments/symplectic_defect.hpp"
#include "actio/two_bodies/pair_on_groupoid.hpp"
#include "actio/two_bodies/two_bodies.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::bodies;

namespace {

using Both = DirectProduct<SE<3>, SE<3>>;
using Momenta = DualPoint<TwoPoses, double>;
using Step = std::pair<Arrow<TwoPoses, double>, Momenta>;
constexpr TwoPoses gamma_{};
/// Masses 0.8 and 0.2, G = 1, about one unit of length apart: an orbit takes some 6 units of time.
constexpr double h = 0.02;
constexpr int steps = 200;

ExtendedBody large() { return ellipsoid_body(0.8, {0.40, 0.36, 0.30}, 4); }
ExtendedBody small() { return ellipsoid_body(0.2, {0.15, 0.24, 0.19}, 4); }
PairOnGroupoid pair_of_order(int order) { return {large(), small(), order, 1}; }

/// Both bodies turn about no axis of their own, and the whole has a momentum.
Momenta start() {
  Vector<double, 6> place;
  place << 0.4, -0.3, 0.2, 1.3, 0.2, -0.1;
  Fibre<TwoPoses, double> p;
  p << 0.02, 0.03, 0.05, -0.01, -0.13, 0.02, 0.001, 0.0012, 0.002, -0.02, 0.16, 0.01;
  return {{{exp(velocity(SE<3>{}, place))}}, p};
}
/// The steps of `one`, from the start.
template <class One>
std::vector<Step> motion(One const& one, int count) {
  std::vector<Step> all{one(start())};
  while (static_cast<int>(all.size()) < count) all.push_back(one(all.back().second));
  return all;
}
/// The largest residual of the Lagrange equations, relative to the momenta.
double residual(PairOnGroupoid const& pair, std::vector<Step> const& motion) {
  auto const L = pair.lagrangian(h);
  double worst = 0;
  for (std::size_t k = 1; k < motion.size(); ++k)
    worst = std::max(worst, lagrange_equations(gamma_, L, motion[k - 1].first, motion[k].first).norm());
  return worst / start().components.norm();
}
/// The principal axes of both bodies at their places, the barycentre at rest.
std::array<Pose<double>, 2> places(TwoBodies const& pair) {
  auto const state = pair.state();
  double const m1 = pair.first().mass(), m2 = pair.second().mass(), M = m1 + m2;
  auto const pose = [](FreeState const& s, ExtendedBody const& body, Eigen::Vector3d const& x) {
    auto const& q = s.attitude.value;
    Eigen::Matrix4d a = Eigen::Matrix4d::Identity();
    a.topLeftCorner<3, 3>() = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix() * body.axes;
    a.topRightCorner<3, 1>() = x;
    return Pose<double>{{}, a};
  };
  return {pose(state.first, pair.first(), -m2 / M * state.position),
          pose(state.second, pair.second(), m1 / M * state.position)};
}
TwoBodies fast_pair(int order) {
  auto const at = [](double a, double b, double c) {
    Eigen::Vector4d const q = Eigen::Vector4d(1, a, b, c).normalized();
    return Element<SU2, double>{{}, q};
  };
  return TwoBodies(
      large(), small(),
      state_of_velocities(large(), small(), {1.3, 0.1, -0.1}, {0.05, 0.8, 0.1}, at(0.2, -0.1, 0.3),
                          {0.3, 0.2, 1.1}, at(-0.4, 0.2, 0.1), {0.2, -0.5, 0.9}),
      {.order = order, .step = h, .method = moser_veselov_pair(), .G = 1});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(pair_on_groupoid)

BOOST_AUTO_TEST_CASE(the_fast_step_solves_the_equations_of_the_groupoid_and_of_pairs) {
  for (int const order : {2, 4}) {
    auto const pair = pair_of_order(order);
    auto const L = pair.lagrangian(h);
    auto fast = fast_pair(order);
    std::vector<std::array<Pose<double>, 2>> g{places(fast)};
    for (int k = 0; k < steps; ++k) fast.step(), g.push_back(places(fast));
    double reduced = 0, unreduced = 0, size = 0;
    for (std::size_t k = 1; k + 1 < g.size(); ++k) {
      auto const before = TwoPoses::reduced<double>(g[k - 1], g[k]),
                 after = TwoPoses::reduced<double>(g[k], g[k + 1]);
      reduced = std::max(reduced, lagrange_equations(gamma_, L, before, after).norm());
      size = std::max(size, legendre_at_target(gamma_, L, before).components.norm());
      auto const both = [&](std::size_t i) { return element_of_product(g[i][0], g[i][1]); };
      using Pair = PairArrow<Both, double>;
      if (k % 10 == 0)
        unreduced =
            std::max(unreduced, lagrange_equations(PairGroupoid<Both>{}, L, Pair{both(k - 1), both(k)},
                                                   Pair{both(k), both(k + 1)})
                                    .norm());
    }
    BOOST_TEST_MESSAGE("order " << order << ": residual on the groupoid " << reduced << ", on pairs "
                                << unreduced << ", of momenta " << size);
    BOOST_TEST(reduced <= 1e-13);
    BOOST_TEST(unreduced <= 1e-13);
    // With moments of the other order it is no solution.
    auto const other = pair_of_order(6 - order).lagrangian(h);
    auto const wrong = lagrange_equations(gamma_, other, TwoPoses::reduced<double>(g[0], g[1]),
                                          TwoPoses::reduced<double>(g[1], g[2]));
    BOOST_TEST(wrong.norm() > 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(newtons_iteration_from_the_unit_finds_the_explicit_step) {
  auto const pair = pair_of_order(4);
  auto const L = pair.lagrangian(h);
  auto const [arrow, end] = pair.step(start(), h);
  auto const found = arrow_with_source_covector(gamma_, L, start().components, gamma_.unit(start().base));
  double const apart = (gamma_.entries(found.value) - gamma_.entries(arrow)).norm();
  BOOST_TEST_MESSAGE("apart by " << apart << " after " << found.report.evaluations << " evaluations");
  BOOST_TEST(apart <= 1e-13);
  BOOST_TEST(found.report.evaluations <= 6);
  BOOST_TEST((legendre_at_target(gamma_, L, found.value).components - end.components).norm() <= 1e-13);
}

BOOST_AUTO_TEST_CASE(the_motion_is_put_together_from_arrows) {
  auto const pair = pair_of_order(4);
  auto fast = fast_pair(4);
  auto g = places(fast);
  fast.step();
  // The first arrow from the fast step, all others by momenta; then the first body from the elements of
  // arrows.
  auto arrow = TwoPoses::reduced<double>(g, places(fast));
  for (int k = 1; k <= steps; ++k) {
    Pose<double> const first = g[0] * arrow.element;
    g = {first, first * arrow.to[0]};
    auto const there = places(fast);
    double const off = (g[0].value - there[0].value).norm() + (g[1].value - there[1].value).norm();
    BOOST_TEST(off <= 1e-12 * k);
    DualPoint<TwoPoses, double> const p = legendre_at_target(gamma_, pair.lagrangian(h), arrow);
    arrow = pair.step(p, h).first;
    fast.step();
  }
}

BOOST_AUTO_TEST_CASE(the_step_is_a_poisson_map_and_stays_on_its_leaf) {
  auto const pair = pair_of_order(4), coarse = pair_of_order(2);
  DualOfAlgebroid<SE<3>, 2> const space;
  auto const step = [&](auto const& t, auto const& p) { return pair.step(p, t); };
  // The torque on the first body from a series of its own, cut one term earlier than that of the potential.
  auto const own_series = [&]<class T, class P>(T const& t, P const& p) {
    auto const kicked = [&](P at) {
      auto const by = coarse.interaction(at.base.others[0]).torque_1,
                 of = pair.interaction(at.base.others[0]).torque_1;
      at = pair.kicked(at, T(t / T(2)));
      for (int i = 0; i < 3; ++i) at.components[i] += t / T(2) * (by[i] - of[i]);
      return at;
    };
    auto const [arrow, end] = pair.drift(kicked(p), t);
    return std::pair{arrow, kicked(end)};
  };
  // The second body turned from the wrong side.
  auto const wrong_side = [&]<class T, class P>(T const& t, P const& p) {
    P const middle = pair.kicked(p, T(t / T(2)));
    auto const f = pair.free_motions(middle, t);
    auto arrow = TwoPoses::moving(p.base, f);
    arrow.to[0] = inverse(f[0]) * f[1] * p.base.others[0];
    P const end{TwoPoses::target(arrow), PairOnGroupoid::carried(f, middle.components)};
    return std::pair{arrow, pair.kicked(end, T(t / T(2)))};
  };
  auto const judged = [&](auto const& one) {
    auto const map = [&](auto const& p) {
      return one(typename std::decay_t<decltype(p)>::Scalar(h), p).second;
    };
    auto const family = [&](auto const& t, auto const& p) { return one(t, p).second; };
    return std::array{residual(pair, motion([&](Momenta const& p) { return one(h, p); }, steps)),
                      poisson_defect(space, map, start()), leaf_defect(space, family, h, start())};
  };
  auto const right = judged(step), cut = judged(own_series), turned = judged(wrong_side);
  for (auto const& [name, found] : {std::pair{"right", right}, {"own series", cut}, {"wrong side", turned}})
    BOOST_TEST_MESSAGE(name << ": residual " << found[0] << ", Poisson defect " << found[1]
                            << ", leaf defect " << found[2]);
  BOOST_TEST(right[0] <= 1e-13);
  BOOST_TEST(right[1] <= 1e-14);
  BOOST_TEST(right[2] <= 1e-14);
  for (auto const& wrong : {cut, turned}) {
    BOOST_TEST(wrong[0] > 1e-7);
    BOOST_TEST(wrong[1] > 1e-7);
    BOOST_TEST(wrong[2] > 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(the_step_on_pairs_of_configurations_is_symplectic) {
  auto const pair = pair_of_order(2);
  auto const L = pair.lagrangian(h);
  auto const on_pairs = [&](auto const& g0, auto const& g1) {
    using T = typename std::decay_t<decltype(g0)>::Scalar;
    return L(PairArrow<Both, T>{g0, g1});
  };
  auto const map = [&](auto const& x) {
    using T = typename std::decay_t<decltype(x)>::Scalar;
    auto const [g1, g2] = factors(x.first);
    auto const [later_1, later_2] = factors(x.second);
    auto const arrow = TwoPoses::reduced<T>({g1, g2}, {later_1, later_2});
    auto const next = pair.step(legendre_at_target(gamma_, L, arrow), T(h)).first;
    Pose<T> const first = later_1 * next.element;
    return PairArrow<Both, T>{x.second, element_of_product(first, Pose<T>(first * next.to[0]))};
  };
  auto fast = fast_pair(2);
  auto const g0 = places(fast);
  fast.step();
  auto const g1 = places(fast);
  PairArrow<Both, double> const x{element_of_product(g0[0], g0[1]), element_of_product(g1[0], g1[1])};
  double const defect = symplectic_defect(PairsOfConfigurations{on_pairs}, map, x);
  BOOST_TEST_MESSAGE("symplectic defect " << defect);
  BOOST_TEST(defect <= 1e-11);
}

BOOST_AUTO_TEST_CASE(what_has_no_answer_is_refused) {
  // The moments are known up to order 4.
  CHECK_REFUSED(pair_of_order(5), OutsideDomain);
  CHECK_REFUSED(pair_of_order(-1), OutsideDomain);
  auto const pair = pair_of_order(2);
  auto const map = [&](auto const& p) { return p; };
  DualOfAlgebroid<SE<3>, 2> const space;
  auto momenta = start(), place = start();
  momenta.components[3] = std::nan(""), place.base.others[0].value(0, 3) = std::nan("");
  CHECK_REFUSED(poisson_defect(space, map, momenta), NotFinite);
  CHECK_REFUSED(poisson_defect(space, map, place), NotFinite);
  // More angular momentum than any turn of the scheme has.
  auto fast = start();
  fast.components[0] = 100;
  CHECK_REFUSED(pair.step(fast, h), Error);
}

BOOST_AUTO_TEST_SUITE_END()
