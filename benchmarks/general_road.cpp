// What the general road costs: a DEP step on SO(3), Lagrangian given as a callable, against the classical Runge-Kutta method on the same body.
//
// The DEP step is that of the natural-chart scheme: residual by dual numbers, Newton on the group, nothing known of rotations but the group's primitives.
// Runge-Kutta has seven numbers, momentum and quaternion, and is written for this body. Both run in turns, so that a busy machine
// slows both; the ratio is that of the times that a tenth of the rounds came under.
#include <algorithm>

#include "actio/reduction/discrete_euler_poincare.hpp"
#include "actio/rigid_body/body_catalogue.hpp"
#include "actio/rigid_body/body_in_motion.hpp"
#include "actio/rigid_body/natural_chart_scheme.hpp"
#include "benchmark.hpp"
#include "peers/runge_kutta.hpp"
#include "timing.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;

int main(int argc, char** argv) {
  benchmark::Benchmark program(argc, argv, "a DEP step on the general road, in Runge-Kutta steps of the same body");
  Body const brick = read_body(ACTIO_DATA "/bodies.toml", "nesc_brick");
  Vector3d const I = brick.inertia.moments;
  double const h = 0.1 / brick.spin.coordinates.norm();

  NaturalChartScheme<3> const scheme(brick.inertia, h);
  MoserVeselov<3> const structured(brick.inertia, h);
  auto const l = scheme.lagrangian();
  auto f = scheme.relative_motion(body_momentum(brick.inertia, brick.spin)).value;
  auto body = release(brick.inertia, identity<double>(SO<3>{}), brick.spin);
  auto const& M = body.body_momentum.components;
  auto const classical = peers::runge_kutta().make({{I[0], I[1], I[2]}, {M[0], M[1], M[2]}}, h);
  auto const time_of = [](long count, auto const& step) {
    return 1e9 / count * benchmark::processor_seconds_of([&] {
      for (long k = 0; k < count; ++k) step();
    });
  };

  std::vector<double> general, fixed, rk;
  int evaluations = 0;
  double residual = 0, tolerance = 0;
  for (int round = 0; round < program.rounds(41); ++round) {
    general.push_back(time_of(500, [&] {
      auto const solved = step_euler_poincare_left(l, f);
      f = solved.value;
      evaluations = std::max(evaluations, solved.report.evaluations);
      if (solved.report.residuals.back() > residual) residual = solved.report.residuals.back(), tolerance = solved.report.tolerance;
    }));
    fixed.push_back(time_of(2000, [&] { advance(structured, body); }));
    rk.push_back(time_of(1, [&] { classical->advance(50000); }) / 50000);
  }
  double const ratio = benchmark::best_tenth(general) / benchmark::best_tenth(rk);
  program.table("time", {"step", "ns", "in Runge-Kutta steps"},
                {{"DEP, general road", book::number(benchmark::best_tenth(general)), book::number(ratio)},
                 {"Moser-Veselov with attitude", book::number(benchmark::best_tenth(fixed)), book::number(benchmark::best_tenth(fixed) / benchmark::best_tenth(rk))},
                 {"Runge-Kutta", book::number(benchmark::best_tenth(rk)), "1"}});
  program.figure("evaluations", evaluations, "evaluations of the residual, most in a step");
  program.figure("residual", residual / tolerance, "largest residual over the rounding level it has to come under");
  program.figure("sum", classical->state()[0] + classical->state()[3] + f.value.sum() + body.attitude.value.sum(), "sum of the last states, so that nothing is left out");
  program.claim_of_time(ratio <= 250, "a DEP step costs at most 250 Runge-Kutta steps");
  program.claim(evaluations <= 4, "at most four evaluations of the residual a step");
  program.claim(residual <= 4 * tolerance, "the residual is at rounding");
  program.headline("a DEP step costs " + book::number(ratio) + " Runge-Kutta steps", ratio);
  return program.finish();
}
