// Two implementations to the same motion: the brick of NASA's check case on pairs of attitudes, and on
// relative motions with the attitude put back afterwards.
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

// 1. The two ways are taken over `count` steps; the result is the largest distance between their attitudes.
//    The unreduced way solves (3.2) for `lifted`, a function of two configurations.
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

// 2. Reconstruction is compared with the unreduced run, for both schemes, over 300 steps of 0.1 s.
struct Apart {
  double chart, mv;
};
Apart two_ways(book::Program& program, Body const& brick) {
  double const h = 0.1;
  int const count = 300;
  std::vector<double> history_chart, history_mv, time;
  for (int k = 1; k <= count; ++k) time.push_back(k * h);
  double const chart =
      apart(NaturalChartScheme<3>(brick.principal.inertia, h), brick.principal_spin(), count, history_chart);
  double const mv =
      apart(MoserVeselov<3>(brick.principal.inertia, h), brick.principal_spin(), count, history_mv);
  program.figure("apart_chart", chart,
                 "natural charts: the two ways apart after 30 s, largest entry of the attitude");
  program.figure("apart_mv", mv, "Moser-Veselov: the same");
  auto ways =
      book::Plot("time, s", "distance of the two ways so far").log_y().size(660, 320).y_range(1e-17, 1e-10);
  ways.curve(time, history_chart, "natural charts").curve(time, history_mv, "Moser-Veselov");
  program.picture("ways", ways.svg(),
                  "The attitude from pairs of configurations and from relative motions with "
                  "reconstruction: what lies between them is rounding.");
  return {chart, mv};
}

// 3. The truth at 30 s comes from the Prince-Dormand method of the GNU Scientific Library.
Vector3d converged_rates(Body const& brick) {
  Vector3d const I = brick.principal.inertia.moments;
  auto const euler = [&](double, Vector3d const& w) {
    return Vector3d(cross(I.cwiseProduct(w), w).cwiseQuotient(I));
  };
  return reference_solution(euler, Vector3d(brick.principal_spin().coordinates), 0, 30) * (180 / M_PI);
}

// 4. The body rates after `duration`, in degrees per second, are the velocity of the momentum.
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

// 5. The check case is run by both schemes at six lengths of the step, and compared with the truth, as NASA's
//    reference tool is. The errors are in degrees per second.
struct Errors {
  std::vector<double> steps, chart, mv;
};
Errors check_case(book::Program& program, Body const& brick, Vector3d const& truth) {
  Errors errors;
  std::vector<book::Program::Row> rows;
  auto const row = [&](std::string const& name, Vector3d const& w, std::string const& error) {
    rows.push_back({name, book::number(w[0], 10), book::number(w[1], 10), book::number(w[2], 10), error});
  };
  for (double step : {0.2, 0.1, 0.05, 0.025, 0.0125, 0.00625}) {
    NaturalChartScheme<3> const chart(brick.principal.inertia, step);
    MoserVeselov<3> const mv(brick.principal.inertia, step);
    Vector3d const a = rates_after(chart, brick.principal_spin(), 30),
                   b = rates_after(mv, brick.principal_spin(), 30);
    errors.steps.push_back(step), errors.chart.push_back((a - truth).norm()),
        errors.mv.push_back((b - truth).norm());
    if (step == 0.2 || step == 0.00625) {
      row("natural charts, h = " + book::number(step), a, book::number(errors.chart.back()));
      row("Moser-Veselov, h = " + book::number(step), b, book::number(errors.mv.back()));
    }
  }
  Vector3d const nasa(12.61842377, -17.3974441, 31.11960301);
  row("NASA's reference tool", nasa, book::number((nasa - truth).norm()));
  row("converged", truth, "");
  program.table("check_case", {"method", "p", "q", "r", "error"}, rows,
                "Body rates of the tumbling brick after 30 s, degrees per second. Converged: rk8pd "
                "of the GNU Scientific Library.");
  auto plot = book::Plot("step, s", "error of the body rates after 30 s, degrees per second").log_x().log_y();
  plot.curve(errors.steps, errors.chart, "natural charts", {.dots = true})
      .curve(errors.steps, errors.mv, "Moser-Veselov", {.dots = true});
  program.picture("orders", plot.svg(), "Both schemes are of order two.");
  return errors;
}

int main(int argc, char** argv) {
  book::Program program(
      argc, argv,
      "a tumbling brick on two ways, pairs of attitudes and relative motions: the same motion to rounding");
  Body const brick = read_body(ACTIO_DATA "/bodies.toml", "nesc_brick");
  auto const [chart, mv] = two_ways(program, brick);
  Vector3d const truth = converged_rates(brick);
  Errors const errors = check_case(program, brick, truth);
  double const order_chart = book::exponent(errors.steps, errors.chart),
               order_mv = book::exponent(errors.steps, errors.mv);
  program.figure("order_chart", order_chart, "order of the natural-chart scheme");
  program.figure("order_mv", order_mv, "order of the Moser-Veselov scheme");
  double const known = (truth - Vector3d(12.6183907759, -17.3974747616, 31.1195888869)).norm();
  program.figure("known", known, "our converged rates against the published digits of another converged run");

  // 6. What must be so. The errors of the relative motions, a few epsilon each, add up over 300 steps, and
  //    the attitude adds those up again.
  program.claim(book::measured(chart) < 1e-10 && book::measured(mv) < 1e-10,
                "the two ways agree to rounding");
  program.claim(
      book::measured(std::abs(order_chart - 2)) < 0.05 && book::measured(std::abs(order_mv - 2)) < 0.05,
      "both schemes are of order two");
  program.claim(book::measured(known) < 1e-8, "the converged rates are those known");
  program.headline("two ways apart by " + book::number(std::max(chart, mv), 2) + " after 300 steps",
                   std::max(chart, mv));
  return program.finish();
}
