// What the general road costs: a DEP step on SO(3), Lagrangian given as a callable, against the classical Runge-Kutta method on the same body.
//
// The DEP step is that of the natural-chart scheme: residual by dual numbers, Newton on the group, nothing known of rotations but the group's primitives.
// Runge-Kutta has seven numbers, momentum and quaternion, and is written for this body. Both run in turns, so that a busy machine
// slows both; the ratio is that of the medians.
#include <algorithm>
#include <array>
#include <ctime>

#include "actio/reduction/discrete_euler_poincare.hpp"
#include "actio/rigid_body/body_catalogue.hpp"
#include "actio/rigid_body/moser_veselov.hpp"
#include "actio/rigid_body/natural_chart_scheme.hpp"
#include "book/program.hpp"

using namespace actio;
using Eigen::Vector3d;
using Seven = std::array<double, 7>;

// By hand, so that the ratio flatters nobody.
Seven rate(Seven const& J, Seven const& y) {
  double const a = y[0] * J[0], b = y[1] * J[1], c = y[2] * J[2];
  return {y[1] * c - y[2] * b,
          y[2] * a - y[0] * c,
          y[0] * b - y[1] * a,
          -0.5 * (y[4] * a + y[5] * b + y[6] * c),
          0.5 * (y[3] * a + y[5] * c - y[6] * b),
          0.5 * (y[3] * b + y[6] * a - y[4] * c),
          0.5 * (y[3] * c + y[4] * b - y[5] * a)};
}
Seven moved(Seven const& y, double h, Seven const& k) {
  Seven z;
  for (int i = 0; i < 7; ++i) z[i] = y[i] + h * k[i];
  return z;
}
/// @param J  inverse moments of inertia
Seven runge_kutta(Seven const& J, Seven const& y, double h) {
  Seven const k1 = rate(J, y), k2 = rate(J, moved(y, h / 2, k1)), k3 = rate(J, moved(y, h / 2, k2)), k4 = rate(J, moved(y, h, k3));
  Seven z;
  for (int i = 0; i < 7; ++i) z[i] = y[i] + h / 6 * (k1[i] + 2 * (k2[i] + k3[i]) + k4[i]);
  return z;
}

// Nanoseconds of processor time for one of `count` calls.
template <class Step>
double time_of(long count, Step const& step) {
  auto const began = std::clock();
  for (long k = 0; k < count; ++k) step();
  return 1e9 / CLOCKS_PER_SEC * static_cast<double>(std::clock() - began) / count;
}
double median(std::vector<double> v) {
  std::nth_element(v.begin(), v.begin() + v.size() / 2, v.end());
  return v[v.size() / 2];
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "a DEP step on the general road, in Runge-Kutta steps of the same body");
  Body const brick = read_body(ACTIO_DATA "/bodies.toml", "nesc_brick");
  Vector3d const I = brick.inertia.moments;
  Seven const J{1 / I[0], 1 / I[1], 1 / I[2]};
  double const h = 0.1 / brick.spin.coordinates.norm();

  NaturalChartScheme<3> const scheme(brick.inertia, h);
  MoserVeselov<3> const structured(brick.inertia, h);
  auto const l = scheme.lagrangian();
  auto f = scheme.relative_motion(body_momentum(brick.inertia, brick.spin)).value;
  auto body = release(brick.inertia, identity<double>(SO<3>{}), brick.spin);
  auto const& M = body.body_momentum.components;
  Seven y{M[0], M[1], M[2], 1, 0, 0, 0};

  std::vector<double> general, fixed, rk;
  int evaluations = 0;
  double residual = 0, tolerance = 0;
  for (int round = 0; round < 41; ++round) {
    general.push_back(time_of(500, [&] {
      auto const solved = step_euler_poincare_left(l, f);
      f = solved.value;
      evaluations = std::max(evaluations, solved.report.evaluations);
      if (solved.report.residuals.back() > residual) residual = solved.report.residuals.back(), tolerance = solved.report.tolerance;
    }));
    fixed.push_back(time_of(2000, [&] { advance(structured, body); }));
    rk.push_back(time_of(50000, [&] { y = runge_kutta(J, y, h); }));
  }
  double const ratio = median(general) / median(rk);
  program.table("time", {"step", "ns", "in Runge-Kutta steps"},
                {{"DEP, general road", book::number(median(general)), book::number(ratio)},
                 {"Moser-Veselov with attitude", book::number(median(fixed)), book::number(median(fixed) / median(rk))},
                 {"Runge-Kutta", book::number(median(rk)), "1"}});
  program.figure("evaluations", evaluations, "evaluations of the residual, most in a step");
  program.figure("residual", residual / tolerance, "largest residual over the rounding level it has to come under");
  program.figure("sum", y[0] + y[3] + f.value.sum() + body.attitude.value.sum(), "sum of the last states, so that nothing is left out");
  program.claim(ratio <= 250, "a DEP step costs at most 250 Runge-Kutta steps");
  program.claim(evaluations <= 4, "at most four evaluations of the residual a step");
  program.claim(residual <= 4 * tolerance, "the residual is at rounding");
  program.headline("a DEP step costs " + book::number(ratio) + " Runge-Kutta steps", ratio);
  return program.finish();
}
