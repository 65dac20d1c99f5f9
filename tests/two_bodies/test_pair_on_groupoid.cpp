// The step of two bodies as a solution of the Lagrange equations on (SE(3) x SE(3))^2 / SE(3): residuals
// there and on pairs, Newton's way, reconstruction, brackets and leaves, and steps that are no solutions.
#include <boost/test/unit_test.hpp>

#include "../../chapters/ch04_groupoids/asteroid_pair.hpp"
#include "actio/instruments/discrete_spaces.hpp"
#include "actio/instruments/dual_of_algebroid.hpp"
#include "actio/instruments/leaf_defect.hpp"
#include "actio/instruments/poisson_defect.hpp"
#include "actio/instruments/symplectic_defect.hpp"
#include "refused.hpp"

using namespace asteroids;

namespace {

using Step = std::pair<Arrow<TwoPoses, double>, Momenta>;
constexpr TwoPoses gamma_{};
constexpr int steps = 200;

/// Both bodies turn about no axis of their own, and the whole has a momentum.
Momenta start() {
  Vector<double, 6> pose;
  pose << 0.4, -0.3, 0.2, 1.3, 0.2, -0.1;
  Fibre<TwoPoses, double> p;
  p << 0.02, 0.03, 0.05, -0.01, -0.13, 0.02, 0.001, 0.0012, 0.002, -0.02, 0.16, 0.01;
  return {{{exp(velocity(SE<3>{}, pose))}}, p};
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

}  // namespace

BOOST_AUTO_TEST_SUITE(pair_on_groupoid)

BOOST_AUTO_TEST_CASE(the_fast_step_solves_the_equations_of_the_groupoid_and_of_pairs) {
  for (int const order : {2, 4}) {
    auto const g = fast_motion(order, steps);
    auto const [reduced, unreduced, size] = put_into_equations(pair_of_order(order), g, 10);
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
  auto const off = put_together(pair_of_order(4), fast_motion(4, steps));
  for (std::size_t k = 0; k < off.size(); ++k) BOOST_TEST(off[k] <= 1e-12 * double(k + 1));
}

BOOST_AUTO_TEST_CASE(the_step_is_a_poisson_map_and_stays_on_its_leaf) {
  auto const pair = pair_of_order(4), coarse = pair_of_order(2);
  DualOfAlgebroid<SE<3>, 2> const space;
  auto const step = [&](auto const& t, auto const& p) { return pair.step(p, t); };
  auto const cut_torque = [&](auto const& t, auto const& p) { return own_series(pair, coarse, p, t); };
  auto const turned_wrongly = [&](auto const& t, auto const& p) { return wrong_side(pair, p, t); };
  auto const judged = [&](auto const& one) {
    auto const map = [&](auto const& p) {
      return one(typename std::decay_t<decltype(p)>::Scalar(h), p).second;
    };
    auto const family = [&](auto const& t, auto const& p) { return one(t, p).second; };
    return std::array{residual(pair, motion([&](Momenta const& p) { return one(h, p); }, steps)),
                      poisson_defect(space, map, start()), leaf_defect(space, family, h, start())};
  };
  auto const right = judged(step), cut = judged(cut_torque), turned = judged(turned_wrongly);
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
  auto const g0 = poses(fast);
  fast.step();
  auto const g1 = poses(fast);
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
  auto momenta = start(), configuration = start();
  momenta.components[3] = std::nan(""), configuration.base.others[0].value(0, 3) = std::nan("");
  CHECK_REFUSED(poisson_defect(space, map, momenta), NotFinite);
  CHECK_REFUSED(poisson_defect(space, map, configuration), NotFinite);
  // More angular momentum than any turn of the scheme has.
  auto fast = start();
  fast.components[0] = 100;
  CHECK_REFUSED(pair.step(fast, h), Error);
}

BOOST_AUTO_TEST_SUITE_END()
