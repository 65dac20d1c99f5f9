// Polhodes of two tumbling asteroids: the exact curve of the body momentum, and the steps of the
// Moser-Veselov scheme on it.
//
// What is shown. The momentum runs where a sphere (its magnitude) and an ellipsoid (the energy) meet. The
// scheme conserves both, so its steps lie on the exact curve to rounding, at every step length; what the step
// length costs is the time at which they get there, to second order. The spin of Apophis in the catalogue is
// the one that has the two periods of its light curves; the scheme gives them back, to second order. Read
// first. middle_axis_flip, and section 5.3.
//
//   I      principal moments (only their ratios are known), ascending
//   h      step, in the body's unit of time
//   M      body momentum, e = M/|M|
//   P_rot  period of M, once round its curve
//   g      attitude, body to space
//   P_prec mean period of the long axis about the momentum in space
//
// Compiled at -O2: it takes many steps.
#include <Eigen/Geometry>

#include "actio/bodies/body_catalogue.hpp"
#include "actio/rigid_body/body_in_motion.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"
#include "book/sphere.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;

// 1. Newton's method finds a point of the unit sphere with the energy of `e0` near `e`. It solves
//    e.D e = e0.D e0 and e.e = 1 with D = 1/I, along the gradients of both.
Vector3d onto_polhode(Vector3d e, Vector3d const& e0, Vector3d const& D) {
  for (int i = 0; i < 8; ++i) {
    Vector3d const a = 2 * e, b = 2 * D.cwiseProduct(e);
    Matrix<double, 2, 2> gram;
    gram << a.dot(a), a.dot(b), a.dot(b), b.dot(b);
    Vector<double, 2> const miss(e.squaredNorm() - e0.squaredNorm(), (e - e0).dot(D.cwiseProduct(e + e0)));
    Vector<double, 2> const x = solve_linear(gram, miss);
    e -= a * x[0] + b * x[1];
  }
  return e;
}

// 2. The exact curve follows the flow by small steps along M x omega and comes back on the curve after each.
std::vector<Vector3d> exact_polhode(Vector3d const& e0, Vector3d const& D) {
  std::vector<Vector3d> exact{e0};
  double const pace = 0.01;
  for (bool away = false; exact.size() < 2000;) {
    Vector3d const e = exact.back(), along = cross(e, D.cwiseProduct(e)).normalized();
    exact.push_back(onto_polhode(e + pace * along, e0, D));
    away = away || (exact.back() - e0).norm() > 3 * pace;
    if (away && (exact.back() - e0).norm() < pace) break;
  }
  exact.push_back(e0);
  return exact;
}

// 3. Forty-eight coarse steps are drawn on the curve of a body. The result is the largest distance from the
//    curve among every tenth of 100000 steps.
double steps_on_polhode(book::Program& program, Body const& body, double h, double azimuth) {
  auto const& inertia = body.principal.inertia;
  Vector3d const D = inertia.moments.cwiseInverse() * inertia.moments[2];
  Vector3d const M0 = body_momentum(inertia, body.principal_spin()).components, e0 = M0.normalized();
  MoserVeselov<3> const scheme(inertia, h);
  auto motion = release(inertia, identity<double>(SO<3>{}), body.principal_spin());
  double farthest = 0;
  std::vector<Vector3d> dots;
  for (int k = 0; k < 100000; ++k) {
    Vector3d const e = motion.body_momentum.components / M0.norm();
    if (k < 48) dots.push_back(e);
    if (k % 10 == 0) farthest = std::max(farthest, (onto_polhode(e, e0, D) - e).norm());
    advance(scheme, motion);
  }
  auto sphere = book::Sphere(azimuth, 20).axes({"long", "middle", "short"});
  sphere.curve(exact_polhode(e0, D), "sphere and ellipsoid: the exact curve", {.colour = 6, .width = 1.4})
      .dots(dots, "steps of the scheme", {.colour = 2, .radius = 3.2});
  program.picture(body.name, sphere.svg(),
                  body.title + ": the direction of its momentum in the body frame, 48 steps of " +
                      book::number(h) + " " + body.time + ".");
  return farthest;
}

// 4. The animation shows the curve of Apophis in time: half an hour lies between frames, and the half axes of
//    its ellipsoid of energy are in units of the amount of its momentum.
void orbit_of(book::Program& program, Body const& body) {
  auto const& inertia = body.principal.inertia;
  MoserVeselov<3> const scheme(inertia, 0.5);
  auto motion = release(inertia, identity<double>(SO<3>{}), body.principal_spin());
  double const amount = motion.body_momentum.components.norm(),
               energy = kinetic_energy(inertia, motion.body_momentum);
  std::vector<std::vector<double>> rows;
  for (int k = 0; k < 560; ++k) {
    Vector3d const e = motion.body_momentum.components / amount;
    rows.push_back({0.5 * k, e[0], e[1], e[2]});
    advance(scheme, motion);
  }
  program.motion("orbit", {"t", "x", "y", "z"}, rows);
  char const* const names[] = {"a", "b", "c"};
  for (int i = 0; i < 3; ++i)
    program.figure(names[i], std::sqrt(2 * energy * inertia.moments[i]) / amount,
                   "half axis of the ellipsoid of energy of Apophis, over the magnitude of the momentum");
}

// 5. The momentum of the body runs round the short axis. Both periods, over `turns` times round, come from
//    the angle of M and from that of the long axis about m.
std::pair<double, double> periods(Body const& body, double h, int turns) {
  MoserVeselov<3> const scheme(body.principal.inertia, h);
  auto motion = release(body.principal.inertia, identity<double>(SO<3>{}), body.principal_spin());
  // Space seen along the momentum.
  Vector3d const axis = Vector3d(motion.spatial_momentum().components).normalized(),
                 across = Eigen::Vector3d(axis).unitOrthogonal(), third = cross(axis, across);
  auto const round_axis = [](Vector3d const& M) { return std::atan2(M[1], M[0]); };
  auto const round_space = [&](Vector3d const& x) { return std::atan2(x.dot(third), x.dot(across)); };
  auto const unwrapped = [](double now, double before) { return std::remainder(now - before, 2 * M_PI); };
  double turned = 0, precessed = 0, t = 0;
  double u = round_axis(motion.body_momentum.components), v = round_space(motion.attitude.value.col(0));
  for (;;) {
    advance(scheme, motion);
    double const u1 = round_axis(motion.body_momentum.components),
                 v1 = round_space(motion.attitude.value.col(0));
    double const du = unwrapped(u1, u), dv = unwrapped(v1, v), left = 2 * M_PI * turns - std::abs(turned);
    double const part = std::min(1.0, left / std::abs(du));  // of the last step, what completes the last turn
    turned += du, precessed += part * dv, t += part * h;
    u = u1, v = v1;
    if (part < 1) return {t / turns, 2 * M_PI * t / std::abs(precessed)};
  }
}

// 6. Finer and finer steps give the periods of Apophis, with relative errors against its light curves.
struct Errors {
  std::vector<double> steps, rotation, precession;
};
Errors errors_of_periods(book::Program& program, Body const& apophis) {
  double const rotation = 264.178, precession = 27.38547;
  Errors errors;
  std::vector<double> square;
  std::vector<book::Program::Row> rows;
  for (double h = 2; h > 0.1; h /= 2) {
    auto const [rot, prec] = periods(apophis, h, 2);
    errors.steps.push_back(h), errors.rotation.push_back(std::abs(rot / rotation - 1)),
        errors.precession.push_back(std::abs(prec / precession - 1));
    square.push_back(errors.precession[0] * h * h / 4);
    rows.push_back({book::number(h), book::number(rot, 7), book::number(prec, 7)});
  }
  rows.push_back({"measured", book::number(rotation, 7), book::number(precession, 7)});
  program.table("periods", {"step, h", "rotation, h", "precession, h"}, rows,
                "Apophis: its two periods, from the scheme and from its light curves (Lee et al. 2022).");
  auto plot = book::Plot("step, h", "relative error of the period").log_x().log_y();
  plot.curve(errors.steps, errors.rotation, "rotation", {.dots = true})
      .curve(errors.steps, errors.precession, "precession", {.dots = true})
      .curve(errors.steps, square, "step squared", {.colour = 6, .dashed = true});
  program.picture("periods", plot.svg(), "How the periods of Apophis come out: to second order in the step.");
  return errors;
}

int main(int argc, char** argv) {
  book::Program program(argc, argv,
                        "two tumbling asteroids: the steps of the scheme on the exact curve, and the "
                        "periods that astronomers measured");
  Body const apophis = read_body(ACTIO_DATA "/bodies.toml", "apophis"),
             toutatis = read_body(ACTIO_DATA "/bodies.toml", "toutatis");
  double farthest = steps_on_polhode(program, apophis, 2.0, 50);
  farthest = std::max(farthest, steps_on_polhode(program, toutatis, 0.15, 25));
  orbit_of(program, apophis);
  program.figure(
      "distance", farthest,
      "largest distance from the exact curve among every tenth of 100000 steps, the sphere having radius 1");
  auto const [steps, of_rotation, of_precession] = errors_of_periods(program, apophis);
  double const order_rotation = book::exponent(steps, of_rotation),
               order_precession = book::exponent(steps, of_precession);
  program.figure("order_rotation", order_rotation, "order of the period of rotation");
  program.figure("order_precession", order_precession, "order of the period of precession");

  // 7. What must be so. The published periods have six and seven digits and the catalogue's spin ten.
  program.claim(book::measured(farthest) < 1e-12, "the steps lie on the exact curve to rounding");
  program.claim(book::measured(of_rotation.back()) < 1e-3 && book::measured(of_precession.back()) < 1e-3,
                "both periods of Apophis come out");
  program.claim(book::measured(std::abs(order_rotation - 2)) < 0.1 &&
                    book::measured(std::abs(order_precession - 2)) < 0.1,
                "the periods converge with order 2");
  program.headline("steps on the exact polhode to " + book::number(farthest, 2), farthest);
  return program.finish();
}
