// The Moser-Veselov scheme without an iteration and without an error.
//
// What is shown. The true motion of a body, sampled at equal times, satisfies the equation of Moser and
// Veselov with other moments of inertia: the residual is rounding, at steps of three radians too, and with
// the body's own moments it is of the size of the square of the step. Cutting the series of these moments
// gives orders 4 to 10. Steps of three radians draw the flips of the T-handle, and one step of any length
// tells where Apophis will be. Read first. The page
// 5A, The exact free body; middle_axis_flip, polhode.
//
//   I      principal moments                  delta, T   numbers of the half turn and the twist of a step
//   M      body momentum, L its magnitude        f          relative motion, g1^T g0
//   g, q   attitude, matrix and quaternion    h          step
//
// Compiled at -O2: it takes many steps.
#include <Eigen/Geometry>

#include "actio/bodies/body_catalogue.hpp"
#include "actio/fast_body/space/free_steps.hpp"
#include "actio/numbers/multiprecision.hpp"
#include "actio/rigid_body/moser_veselov.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"
#include "witness/euler_series.hpp"

using namespace actio;
using namespace actio::bodies;
using Vector3d = actio::Vector<double, 3>;

// The reference solution: power series of Euler's equations, in fifty digits.
FreeState true_state(Body const& body, double t) {
  auto const fifty = [](auto const& v) { return v.template cast<dec50>().eval(); };
  auto const plain = [](auto const& v) {
    return v.unaryExpr([](dec50 const& x) { return to_double(x); }).eval();
  };
  Vector3d const I = body.principal.inertia.moments, M = I.cwiseProduct(body.principal_spin().coordinates);
  auto const end =
      euler_series<dec50>(fifty(I), {fifty(M), fifty(Vector<double, 4>::UnitX().eval())}, dec50(t));
  return {{SO<3>{}, plain(end.momentum)}, {SU2{}, plain(end.attitude)}};
}
FreeBody released(Body const& body) {
  return {body.principal.inertia, body_momentum(body.principal.inertia, body.principal_spin())};
}
Matrix<double, 3, 3> matrix_of(Element<SU2, double> const& q) {
  return Eigen::Quaterniond(q.value[0], q.value[1], q.value[2], q.value[3]).toRotationMatrix();
}

// The larger difference: of momenta over their amount, of quaternions up to their sign.
double apart(FreeState const& a, FreeState const& b) {
  double const turned =
      std::min((a.attitude.value - b.attitude.value).norm(), (a.attitude.value + b.attitude.value).norm());
  return std::max((a.body_momentum - b.body_momentum).components.norm() / b.body_momentum.components.norm(),
                  turned);
}

// The residual of f^T Lambda - Lambda f = h M, over h M, with these moments.
double residual(Vector3d const& I, Element<SO<3>, double> const& f, Momentum<SO<3>, double> const& M,
                double h) {
  Inertia<3, double> const inertia{
      SO<3>{}, Vector3d(I[1] + I[2] - I[0], I[2] + I[0] - I[1], I[0] + I[1] - I[2]) / 2, I};
  return (MoserVeselov<3>(inertia, h).momentum_before(f) - M).components.norm() / M.components.norm();
}

double const eps = std::numeric_limits<double>::epsilon();

// 1. The equation of the scheme along the true motion of the brick.
void equation_along_the_motion(book::Program& program, Body const& brick) {
  FreeBody const body = released(brick);
  Vector3d const I = brick.principal.inertia.moments;
  double const spin = brick.principal_spin().coordinates.norm();
  std::vector<book::Program::Row> rows;
  double worst = 0, least = 1;
  for (double const angle : {0.1, 0.5, 1.0, 2.0, 3.0}) {
    double const h = angle / spin;
    // axes as the steps name them: for ascending moments those of the body
    Three<double> const j = inertia_of(body.step_parameters(h));
    Vector3d const modified = (h * body.magnitude() / 2) * Vector3d(1 / j[0], 1 / j[1], 1 / j[2]);
    Element<SO<3>, double> const f{SO<3>{}, matrix_of(true_state(brick, h).attitude).transpose()};
    Momentum<SO<3>, double> const M = body_momentum(brick.principal.inertia, brick.principal_spin());
    double const with = residual(modified, f, M, h), without = residual(I, f, M, h);
    worst = std::max(worst, with / (eps * modified.cwiseAbs().maxCoeff() / I.maxCoeff() / angle)),
    least = std::min(least, without / (angle * angle));
    rows.push_back({book::number(angle), book::number(modified[0] / I[0], 6),
                    book::number(modified[1] / I[1], 6), book::number(modified[2] / I[2], 6),
                    book::number(with, 2), book::number(without, 2)});
  }
  program.table("equation", {"step, rad", "I1", "I2", "I3", "residual", "with its own moments"}, rows,
                "The modified moments of the brick over its own, and the residual of the equation of Moser "
                "and Veselov along the true motion, over the momentum.");
  program.figure("residual", worst,
                 "largest residual of the equation, in units of the round-off of its terms");
  program.claim(book::measured(worst) < 20,
                "the true motion satisfies the equation with modified moments, to rounding");
  program.claim(book::measured(least) > 1e-3,
                "with the body's own moments it does not, by the square of the step");
}

// How the error after `duration` falls with the step, for the scheme of one order.
void show_order(book::Program& program, book::Plot& plot, FreeBody const& body, double spin, double duration,
                FreeState const& end, int order) {
  std::vector<double> steps, errors;
  for (long count = order < 6 ? 800 : 400; count <= 12800 && steps.size() < 5; count *= 2) {
    double const h = duration / static_cast<double>(count);
    FreeSteps motion(body, h, body.moser_veselov_parameters(h, order));
    motion.advance(count);
    double const error = apart(motion.state(), end);
    if (error < 1e-12) break;
    steps.push_back(h * spin), errors.push_back(error);
  }
  plot.curve(steps, errors, "order " + std::to_string(order), {.colour = order / 2})
      .dots(steps, errors, "", {.colour = order / 2});
  double const measured = book::exponent({steps.end() - 2, steps.end()}, {errors.end() - 2, errors.end()});
  program.figure("order_" + std::to_string(order), measured, book::number(measured, 4),
                 "measured order, for " + std::to_string(order));
}

// 2. Orders: two hundred radians of the brick at finer and finer steps. Returns the largest error of the
//    exact ones.
double orders(book::Program& program, Body const& brick) {
  FreeBody const body = released(brick);
  double const spin = brick.principal_spin().coordinates.norm(), duration = 200 / spin;
  FreeState const end = true_state(brick, duration);
  auto plot = book::Plot("step, rad", "error after 200 rad").log_x().log_y();
  for (int order = 2; order <= 10; order += 2) show_order(program, plot, body, spin, duration, end, order);
  std::vector<double> steps, errors;
  for (long count = 50; count <= 12800; count *= 2) {
    FreeSteps motion(body, duration / static_cast<double>(count));
    motion.advance(count);
    steps.push_back(200.0 / static_cast<double>(count)), errors.push_back(apart(motion.state(), end));
  }
  plot.curve(steps, errors, "exact", {.colour = 6}).dots(steps, errors, "", {.colour = 6});
  program.picture("orders", plot.svg(),
                  "Momentum and attitude of the brick after 200 radians: the scheme with the series of its "
                  "modified moments cut off, and with their closed form.");
  double const exact = *std::max_element(errors.begin(), errors.end());
  program.figure("exact", exact, "largest error of the exact steps, from four radians a step to a sixtieth");
  program.claim(book::measured(exact) < 200 * 16 * eps,
                "the exact steps are exact: sixteen epsilon for each radian");
  return exact;
}

// 3. The T-handle in steps of three radians.
void flips(book::Program& program, Body const& handle) {
  FreeBody const thrown = released(handle);
  auto plot = book::Plot("time, s", "body velocity about the middle axis, rad/s").size(660, 300);
  std::vector<double> time, velocity, dot_time, dot_velocity;
  auto const middle = [&](FreeState const& s) {
    return s.body_momentum.components[1] / handle.principal.inertia.moments[1];
  };
  for (double t = 0; t <= 20; t += 0.01) time.push_back(t), velocity.push_back(middle(thrown.at(t)));
  FreeSteps coarse(thrown, 0.3);
  for (double t = 0; t <= 20; t += 0.3)
    dot_time.push_back(t), dot_velocity.push_back(middle(coarse.state())), coarse.advance();
  plot.curve(time, velocity, "one evaluation at each time", {.colour = 6})
      .dots(dot_time, dot_velocity, "steps of three radians", {.colour = 2});
  program.picture(
      "flips", plot.svg(),
      "The T-handle again: the curve is evaluated, each point from the start at once; the dots are steps.");
}

// 4. Apophis after ten of its precessions, in one go.
void far_ahead(book::Program& program, Body const& apophis) {
  double const later = 273.8547;
  double const error = apart(released(apophis).at(later), true_state(apophis, later));
  program.figure("apophis", error,
                 "Apophis after ten precessions: one evaluation against a power series in fifty digits");
  program.claim(book::measured(error) < 100 * 16 * eps, "one evaluation over ten precessions is exact, too");
}

int main(int argc, char** argv) {
  book::Program program(
      argc, argv, "the scheme with other moments of inertia is the exact motion, and needs no iteration");
  auto const body = [](char const* name) { return read_body(ACTIO_DATA "/bodies.toml", name); };
  equation_along_the_motion(program, body("nesc_brick"));
  double const exact = orders(program, body("nesc_brick"));
  flips(program, body("t_handle"));
  far_ahead(program, body("apophis"));
  program.headline("exact at every step length, to " + book::number(exact, 2), exact);
  return program.finish();
}
