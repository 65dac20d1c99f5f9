// Two asteroids on a groupoid: their step by kicks and free rotors solves the Lagrange equations on
// (SE(3) x SE(3))^2 / SE(3).
//
// What is shown. Two ellipsoids attract each other. The step of the library, half a kick, free motion, half a
// kick, has no equation for both bodies to solve. The arrows of two hundred of its steps are put into the
// Lagrange equations of the groupoid of pairs of configurations modulo motions of space, and into those on
// pairs: what is left is rounding. Newton's iteration on the groupoid, started at a unit, arrives at the same
// arrow. The motion in space is put together from arrows. Then the step is judged as a map of T*M/SE(3),
// beside two steps with an error in them. Read first. Section 4.1, and "Testing what a map preserves".
//
//   g_1, g_2     principal axes of the bodies at their centres of mass
//   x = g_1^-1 g_2, k = g_1^-1 g_1' the second body as the first sees it, the motion of the first in a step
//   h            step; the masses are 4/5 and 1/5 and the constant of gravitation 1, lengths are of the order
//                1
#include "actio/groupoid/lagrange_equations.hpp"
#include "actio/instruments/dual_of_algebroid.hpp"
#include "actio/instruments/leaf_defect.hpp"
#include "actio/instruments/poisson_defect.hpp"
#include "actio/two_bodies/pair_on_groupoid.hpp"
#include "actio/two_bodies/two_bodies.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"

using namespace actio;
using namespace actio::bodies;
using Both = DirectProduct<SE<3>, SE<3>>;
using Places = std::array<Pose<double>, 2>;
using SpaceArrow = Arrow<TwoPoses, double>;
using Momenta = DualPoint<TwoPoses, double>;
double const h = 0.02;
int const steps = 200, order = 4;
TwoPoses const groupoid;

// 1. Two ellipsoids, and the fast step that chapter 5 would use. Each is given by its principal axes.
ExtendedBody const large = ellipsoid_body(0.8, {0.40, 0.36, 0.30}, order),
                   small = ellipsoid_body(0.2, {0.15, 0.24, 0.19}, order);
TwoBodies fast_pair() {
  auto const attitude = [](double a, double b, double c) {
    Eigen::Vector4d const q = Eigen::Vector4d(1, a, b, c).normalized();
    return Element<SU2, double>{{}, q};
  };
  return TwoBodies(
      large, small,
      state_of_velocities(large, small, {1.3, 0.1, -0.1}, {0.05, 0.8, 0.1}, attitude(0.2, -0.1, 0.3),
                          {0.3, 0.2, 1.1}, attitude(-0.4, 0.2, 0.1), {0.2, -0.5, 0.9}),
      {.order = order, .step = h, .method = moser_veselov_pair(), .G = 1});
}
Places places(TwoBodies const& pair) {
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

// 2. Its steps in both sets of equations.
struct Residuals {
  double on_arrows = 0, on_pairs = 0, momentum = 0;
};
Residuals put_into_equations(PairOnGroupoid const& pair, std::vector<Places> const& g) {
  auto const L = pair.lagrangian(h);
  Residuals found;
  for (std::size_t k = 1; k + 1 < g.size(); ++k) {
    SpaceArrow const before = TwoPoses::reduced(g[k - 1], g[k]), after = TwoPoses::reduced(g[k], g[k + 1]);
    found.on_arrows = std::max(found.on_arrows, lagrange_equations(groupoid, L, before, after).norm());
    auto const both = [&](std::size_t i) { return element_of_product(g[i][0], g[i][1]); };
    PairArrow<Both, double> const first{both(k - 1), both(k)}, second{both(k), both(k + 1)};
    found.on_pairs =
        std::max(found.on_pairs, lagrange_equations(PairGroupoid<Both>{}, L, first, second).norm());
    found.momentum = std::max(found.momentum, legendre_at_target(groupoid, L, before).components.norm());
  }
  return found;
}

// 3. The first arrow gives momenta, momenta the next arrow; the first body moves by the elements of the
//    arrows.
double put_together(PairOnGroupoid const& pair, std::vector<Places> const& g) {
  SpaceArrow arrow = TwoPoses::reduced(g[0], g[1]);
  Places at = g[0];
  double off = 0;
  for (int k = 1; k <= steps; ++k) {
    Pose<double> const first = at[0] * arrow.element;
    at = {first, first * arrow.to[0]};
    for (int i = 0; i < 2; ++i) off = std::max(off, (at[i].value - g[k][i].value).norm());
    arrow = pair.step(Momenta(legendre_at_target(groupoid, pair.lagrangian(h), arrow)), h).first;
  }
  return off;
}

// 4. Steps to be judged: the right one; one whose torque on the first body comes from a series of its own,
//    cut at order 2; one that turns the second body from the wrong side.
PairOnGroupoid const of_order_two(large, small, 2, 1);
template <class P, class T>
auto right_step(PairOnGroupoid const& pair, P const& p, T const& t) { return pair.step(p, t); }
template <class P, class T>
auto own_series(PairOnGroupoid const& pair, P const& p, T const& t) {
  auto const kicked = [&](P at) {
    auto const cut = of_order_two.interaction(at.base.others[0]).torque_1,
               whole = pair.interaction(at.base.others[0]).torque_1;
    at = pair.kicked(at, T(t / T(2)));
    for (int i = 0; i < 3; ++i) at.components[i] += t / T(2) * (cut[i] - whole[i]);
    return at;
  };
  auto const [arrow, end] = pair.drift(kicked(p), t);
  return std::pair{arrow, kicked(end)};
}
template <class P, class T>
auto wrong_side(PairOnGroupoid const& pair, P const& p, T const& t) {
  P const middle = pair.kicked(p, T(t / T(2)));
  auto const f = pair.free_motions(middle, t);
  auto arrow = TwoPoses::moving(p.base, f);
  arrow.to[0] = inverse(f[0]) * f[1] * p.base.others[0];
  P const end{TwoPoses::target(arrow), PairOnGroupoid::carried(f, middle.components)};
  return std::pair{arrow, pair.kicked(end, T(t / T(2)))};
}

// 5. What is judged: the residual along the motion, the bracket, the leaf, and the total momentum seen from
//    space, whose square is a Casimir function.
struct Verdict {
  double residual = 0, poisson = 0, leaf = 0, momentum = 0;
};
Eigen::Vector3d angular_momentum(Pose<double> const& first, Momenta const& p) {
  Pose<double> const second = first * p.base.others[0];
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  auto const add = [&](Pose<double> const& g, int at) {
    Eigen::Matrix3d const R = g.value.topLeftCorner<3, 3>();
    Eigen::Vector3d const place = g.value.topRightCorner<3, 1>(), M = p.components.segment<3>(at),
                          P = p.components.segment<3>(at + 3);
    sum += R * M + place.cross(Eigen::Vector3d(R * P));
  };
  add(first, 0), add(second, 6);
  return sum;
}
template <class One>
Verdict judge(PairOnGroupoid const& pair, Places const& start, Momenta const& p, One const& one) {
  auto const L = pair.lagrangian(h);
  DualOfAlgebroid<SE<3>, 2> const space;
  Verdict found;
  found.poisson = poisson_defect(
      space, [&](auto const& x) { return one(x, typename std::decay_t<decltype(x)>::Scalar(h)).second; }, p);
  found.leaf = leaf_defect(
      space, [&](auto const& t, auto const& x) { return one(x, t).second; }, h, p);
  auto [arrow, at] = one(p, h);
  Pose<double> first = start[0] * arrow.element;
  Eigen::Vector3d const J = angular_momentum(start[0], p);
  for (int k = 1; k < steps; ++k) {
    auto const [next, end] = one(at, h);
    found.residual = std::max(found.residual, lagrange_equations(groupoid, L, arrow, next).norm());
    arrow = next, at = end, first = first * arrow.element;
    found.momentum = std::max(found.momentum, (angular_momentum(first, at) - J).norm() / J.norm());
  }
  return found;
}

// 6. The paths of both centres of mass, and that of the second as the first body sees it.
void draw(book::Program& program, std::vector<Places> const& g) {
  std::array<std::vector<double>, 3> x, y;
  for (auto const& at : g)
    for (int i = 0; i < 3; ++i) {
      Pose<double> const pose = i < 2 ? at[i] : Pose<double>(inverse(at[0]) * at[1]);
      x[i].push_back(pose.value(0, 3)), y[i].push_back(pose.value(1, 3));
    }
  book::Plot plot("first coordinate", "second coordinate");
  plot.equal().size(620, 460);
  plot.curve(x[0], y[0], "first body, in space", {.colour = 1});
  plot.curve(x[1], y[1], "second body, in space", {.colour = 2});
  plot.curve(x[2], y[2], "the second as the first sees it", {.colour = 3});
  program.picture(
      "paths", plot.svg(),
      "The centres of mass in space, put together from arrows, and the base of the groupoid: where the "
      "second body is as the first sees it.");
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "two asteroids, whose step solves the Lagrange equations on a groupoid");
  PairOnGroupoid const pair(large, small, order, 1);
  auto fast = fast_pair();
  std::vector<Places> g{places(fast)};
  while (static_cast<int>(g.size()) <= steps + 1) fast.step(), g.push_back(places(fast));

  Residuals const left = put_into_equations(pair, g);
  program.figure("on_arrows", left.on_arrows, "residual of the Lagrange equations on the groupoid");
  program.figure("on_pairs", left.on_pairs, "residual of the discrete Euler-Lagrange equations on pairs");
  program.figure("momenta", left.momentum, "length of the momenta, for comparison");

  SpaceArrow const first = TwoPoses::reduced(g[0], g[1]);
  auto const L = pair.lagrangian(h);
  Momenta const p = legendre_at_source(groupoid, L, first);
  auto const found = arrow_with_source_covector(groupoid, L, p.components, groupoid.unit(p.base));
  double const newton = (groupoid.entries(found.value) - groupoid.entries(first)).norm();
  program.figure("newton", newton, "distance of Newton's arrow from that of the explicit step");
  program.figure("evaluations", found.report.evaluations, "evaluations of the residual and its derivative");
  double const off = put_together(pair, g);
  program.figure("put_together", off, "distance of the motion put together from arrows");

  std::vector<std::vector<std::string>> rows;
  std::vector<Verdict> verdicts;
  auto const judged = [&](std::string const& name, auto const& one) {
    Verdict const v = judge(pair, g[0], p, one);
    verdicts.push_back(v);
    rows.push_back({name, book::number(v.residual, 2), book::number(v.poisson, 2), book::number(v.leaf, 2),
                    book::number(v.momentum, 2)});
  };
  judged("kick, rotors, kick", [&](auto const& x, auto const& t) { return right_step(pair, x, t); });
  judged("own series for one torque", [&](auto const& x, auto const& t) { return own_series(pair, x, t); });
  judged("turned from the wrong side", [&](auto const& x, auto const& t) { return wrong_side(pair, x, t); });
  program.table(
      "steps", {"step", "residual", "Poisson defect", "leaf defect", "change of the angular momentum"}, rows,
      "Three steps of two bodies. Residual and change of momentum over two hundred steps, defects of one.");
  draw(program, g);

  using book::measured;
  program.claim(measured(left.on_arrows) < 1e-13, "the fast step solves the equations on the groupoid");
  program.claim(measured(left.on_pairs) < 1e-13, "and those on pairs");
  program.claim(measured(newton) < 1e-13, "Newton's iteration from a unit arrives at the explicit step");
  program.claim(measured(off) < 1e-11, "the motion is put together from arrows");
  program.claim(measured(verdicts[0].poisson) < 1e-14, "the step preserves the bracket");
  program.claim(measured(verdicts[0].leaf) < 1e-14, "and stays on its leaf");
  program.claim(measured(verdicts[0].momentum) < 1e-12, "and conserves the angular momentum");
  program.claim(measured(std::min(verdicts[1].residual, verdicts[2].residual)) > 1e-7,
                "the steps with an error in them do not solve the equations");
  program.claim(measured(std::min(verdicts[1].poisson, verdicts[2].poisson)) > 1e-7,
                "nor preserve the bracket");
  program.claim(measured(std::min(verdicts[1].leaf, verdicts[2].leaf)) > 1e-7, "nor stay on the leaf");
  program.headline("explicit step on (M x M)/SE(3), residual " + book::number(left.on_arrows, 2),
                   left.on_arrows);
  return program.finish();
}
