// Two asteroids on a groupoid: their step by kicks and free rotors solves the Lagrange equations on
// (SE(3) x SE(3))^2 / SE(3).
//
// What is shown. Two ellipsoids attract each other. The step of the library, half a kick, free motion, half a
// kick, has no equation for both bodies to solve. The arrows of two hundred of its steps are put into the
// Lagrange equations of the groupoid of pairs of configurations modulo motions of space, and into those on
// pairs; the residuals are rounding. Newton's iteration on the groupoid, started at a unit, arrives at the
// same arrow. The motion in space is put together from arrows. Then the step is judged as a map of T*M/SE(3),
// beside two steps with an error in them. Read first. Section 4.1, and "Testing what a map preserves".
//
//   g_1, g_2          principal axes of the bodies at their centres of mass
//   x = g_1^-1 g_2    the second body in the frame of the first
//   k = g_1^-1 g_1'   the motion of the first body in a step
//   h                 step
#include "actio/instruments/dual_of_algebroid.hpp"
#include "actio/instruments/leaf_defect.hpp"
#include "actio/instruments/poisson_defect.hpp"
#include "asteroid_pair.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"

using namespace asteroids;
int const steps = 200, order = 4;
TwoPoses const groupoid;

// 1. What is judged: the residual along the motion, the bracket, the leaf, and the total momentum in
//    space, whose square is a Casimir function.
struct Verdict {
  double residual = 0, poisson = 0, leaf = 0, momentum = 0;
};
Eigen::Vector3d angular_momentum(Pose<double> const& first, Momenta const& p) {
  Pose<double> const second = first * p.base.others[0];
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  auto const add = [&](Pose<double> const& g, int at) {
    Eigen::Matrix3d const R = g.value.topLeftCorner<3, 3>();
    Eigen::Vector3d const x = g.value.topRightCorner<3, 1>(), M = p.components.segment<3>(at),
                          P = p.components.segment<3>(at + 3);
    sum += R * M + x.cross(Eigen::Vector3d(R * P));
  };
  add(first, 0), add(second, 6);
  return sum;
}
template <class One>
Verdict judge(PairOnGroupoid const& pair, Poses const& start, Momenta const& p, One const& one) {
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

// 2. The paths of both centres of mass, and that of the second as the first body sees it.
void draw(book::Program& program, std::vector<Poses> const& g) {
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
  plot.curve(x[2], y[2], "the second in the frame of the first", {.colour = 3});
  program.picture(
      "paths", plot.svg(),
      "The centres of mass in space, put together from arrows, and the base of the groupoid: the second "
      "body in the frame of the first.");
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "two asteroids, whose step solves the Lagrange equations on a groupoid");
  PairOnGroupoid const pair = pair_of_order(order), coarse = pair_of_order(2);
  std::vector<Poses> const g = fast_motion(order, steps + 1);

  Residuals const left = put_into_equations(pair, g);
  program.figure("on_arrows", left.on_arrows, "residual of the Lagrange equations on the groupoid");
  program.figure("on_pairs", left.on_pairs, "residual of the discrete Euler-Lagrange equations on pairs");
  program.figure("momenta", left.momentum, "length of the momenta, for comparison");

  auto const first = TwoPoses::reduced<double>(g[0], g[1]);
  auto const L = pair.lagrangian(h);
  Momenta const p = legendre_at_source(groupoid, L, first);
  auto const found = arrow_with_source_covector(groupoid, L, p.components, groupoid.unit(p.base));
  double const newton = (groupoid.entries(found.value) - groupoid.entries(first)).norm();
  program.figure("newton", newton, "distance of Newton's arrow from that of the explicit step");
  program.figure("evaluations", found.report.evaluations, "evaluations of the residual and its derivative");
  double const off = std::ranges::max(put_together(pair, g));
  program.figure("put_together", off, "distance of the motion put together from arrows");

  std::vector<std::vector<std::string>> rows;
  std::vector<Verdict> verdicts;
  auto const judged = [&](std::string const& name, auto const& one) {
    Verdict const v = judge(pair, g[0], p, one);
    verdicts.push_back(v);
    rows.push_back({name, book::number(v.residual, 2), book::number(v.poisson, 2), book::number(v.leaf, 2),
                    book::number(v.momentum, 2)});
  };
  judged("kick, rotors, kick", [&](auto const& x, auto const& t) { return pair.step(x, t); });
  judged("own series for one torque",
         [&](auto const& x, auto const& t) { return own_series(pair, coarse, x, t); });
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
