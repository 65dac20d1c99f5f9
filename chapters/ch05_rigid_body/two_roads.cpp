// Two roads to the same motion: the brick of NASA's check case on pairs of attitudes, and on relative motions
// with the attitude put back afterwards.
//
// What is shown. The discrete Euler-Lagrange equations on SO(3) x SO(3) know nothing of a symmetry. The
// reduced equations solve for the relative motion alone, and reconstruction puts the attitude back: the same
// numbers to rounding, for the natural-chart scheme and for Moser and Veselov's. Then the check case itself:
// body rates after 30 s, by both schemes, against a solution by somebody else's code. Read first.
// Section 3.2, and sections 5.1 and 5.2.
//
//   g      attitude, body to space                h     step, s
//   f      relative motion g1^-1 g0               p, q, r  body rates, degrees per second
#include "actio/bodies/body_catalogue.hpp"
#include "actio/rigid_body/moser_veselov.hpp"
#include "actio/rigid_body/natural_chart_scheme.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"
#include "witness/reference_solution.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;
using Rotation = Element<SO<3>, double>;

// Largest distance between attitudes on the two roads over `count` steps. The unreduced road solves (3.2) for
// `lifted`, a function of two configurations.
template <class Scheme>
double apart(Scheme const& scheme, Velocity<SO<3>, double> const& spin, int count,
             std::vector<double>& history) {
  auto const lifted = lift_left(scheme.lagrangian());
  auto const f10 = scheme.relative_motion(body_momentum(scheme.inertia(), spin)).value;
  Rotation const start = identity<double>(SO<3>{});
  Rotation a0 = start, a1 = reconstruct_left(start, f10);  // unreduced: a pair of configurations
  // reduced: a relative motion, and the configuration it leads to
  Rotation b1 = a1, f = f10;
  double largest = 0;
  for (int k = 0; k < count; ++k) {
    Rotation const a2 = step_euler_lagrange(lifted, a0, a1).value;
    a0 = a1, a1 = a2;
    f = scheme.step_euler_poincare(f).value;
    b1 = restore(reconstruct_left(b1, f));
    largest = std::max(largest, magnitude((a1.value - b1.value).eval()));
    history.push_back(std::max(largest, 1e-17));
  }
  return largest;
}

// Body rates after `duration`, in degrees per second: the velocity of the momentum.
template <class Scheme>
Vector3d rates_after(Scheme const& scheme, Velocity<SO<3>, double> const& spin, double duration) {
  auto pi = body_momentum(scheme.inertia(), spin);
  auto f = scheme.relative_motion(pi).value;
  for (long k = std::lround(duration / scheme.step()); k > 0; --k) {
    pi = scheme.momentum_after(f);
    if (k > 1) f = scheme.step_euler_poincare(f).value;
  }
  return body_velocity(scheme.inertia(), pi).coordinates * (180 / M_PI);
}

int main(int argc, char** argv) {
  book::Program program(
      argc, argv,
      "a tumbling brick on two roads, pairs of attitudes and relative motions: the same motion to rounding");

  // 1. The brick of the check case, and its two schemes.
  Body const brick = read_body(ACTIO_DATA "/bodies.toml", "nesc_brick");
  double const h = 0.1;
  int const count = 300;
  std::vector<double> history_chart, history_mv, time;
  for (int k = 1; k <= count; ++k) time.push_back(k * h);

  // 2. Reconstruction against the unreduced run.
  double const chart =
      apart(NaturalChartScheme<3>(brick.principal.inertia, h), brick.principal_spin(), count, history_chart);
  double const mv =
      apart(MoserVeselov<3>(brick.principal.inertia, h), brick.principal_spin(), count, history_mv);
  program.figure("apart_chart", chart,
                 "natural charts: the two roads apart after 30 s, largest entry of the attitude");
  program.figure("apart_mv", mv, "Moser-Veselov: the same");
  auto roads =
      book::Plot("time, s", "distance of the two roads so far").log_y().size(660, 320).y_range(1e-17, 1e-10);
  roads.curve(time, history_chart, "natural charts").curve(time, history_mv, "Moser-Veselov");
  program.picture("roads", roads.svg(),
                  "The attitude from pairs of configurations and from relative motions with reconstruction: "
                  "what lies between them is rounding.");

  // 3. The truth at 30 s, by the Prince-Dormand method of the GNU Scientific Library.
  Vector3d const I = brick.principal.inertia.moments;
  auto const euler = [&](double, Vector3d const& w) {
    return Vector3d(cross(I.cwiseProduct(w), w).cwiseQuotient(I));
  };
  Vector3d const truth =
      reference_solution(euler, Vector3d(brick.principal_spin().coordinates), 0, 30) * (180 / M_PI);
  Vector3d const nasa(12.61842377, -17.3974441, 31.11960301);

  // 4. Both schemes at five steps and more.
  std::vector<double> steps, errors_chart, errors_mv;
  std::vector<book::Program::Row> rows;
  auto const row = [](std::string const& name, Vector3d const& w, std::string const& error) {
    return book::Program::Row{name, book::number(w[0], 10), book::number(w[1], 10), book::number(w[2], 10),
                              error};
  };
  for (double step : {0.2, 0.1, 0.05, 0.025, 0.0125, 0.00625}) {
    Vector3d const a = rates_after(NaturalChartScheme<3>(brick.principal.inertia, step),
                                   brick.principal_spin(), 30),
                   b = rates_after(MoserVeselov<3>(brick.principal.inertia, step), brick.principal_spin(),
                                   30);
    steps.push_back(step), errors_chart.push_back((a - truth).norm()),
        errors_mv.push_back((b - truth).norm());
    if (step == 0.2 || step == 0.00625) {
      rows.push_back(row("natural charts, h = " + book::number(step), a, book::number(errors_chart.back())));
      rows.push_back(row("Moser-Veselov, h = " + book::number(step), b, book::number(errors_mv.back())));
    }
  }
  rows.push_back(row("NASA's reference tool", nasa, book::number((nasa - truth).norm())));
  rows.push_back(row("converged", truth, ""));
  program.table("check_case", {"method", "p", "q", "r", "error"}, rows,
                "Body rates of the tumbling brick after 30 s, degrees per second. Converged: rk8pd of the "
                "GNU Scientific Library.");
  auto plot = book::Plot("step, s", "error of the body rates after 30 s, degrees per second").log_x().log_y();
  plot.curve(steps, errors_chart, "natural charts", {.dots = true})
      .curve(steps, errors_mv, "Moser-Veselov", {.dots = true});
  program.picture("orders", plot.svg(), "Both schemes are of order two.");

  double const order_chart = book::exponent(steps, errors_chart), order_mv = book::exponent(steps, errors_mv);
  program.figure("order_chart", order_chart, "order of the natural-chart scheme");
  program.figure("order_mv", order_mv, "order of the Moser-Veselov scheme");
  double const known = (truth - Vector3d(12.6183907759, -17.3974747616, 31.1195888869)).norm();
  program.figure("known", known, "our converged rates against the published digits of another converged run");

  // 5. What must be so. The errors of the relative motions, a few epsilon each, add up over 300 steps, and
  //    the attitude adds those up again.
  program.claim(book::measured(chart) < 1e-10 && book::measured(mv) < 1e-10,
                "the two roads agree to rounding");
  program.claim(
      book::measured(std::abs(order_chart - 2)) < 0.05 && book::measured(std::abs(order_mv - 2)) < 0.05,
      "both schemes are of order two");
  program.claim(book::measured(known) < 1e-8, "the converged rates are those known");
  program.headline("two roads apart by " + book::number(std::max(chart, mv), 2) + " after 300 steps",
                   std::max(chart, mv));
  return program.finish();
}
