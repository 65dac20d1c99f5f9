// Two roads on SE(3): a submarine in still water, stepped with its place and without it.
//
// What is shown. The water takes part in the motion of a body: pushed aside it weighs more than pushed ahead, and so the
// submarine tumbles without any force. Its energy does not care where it is (Kirchhoff's equations). One road solves the
// discrete Euler-Lagrange equations (3.2) for places; the other solves (3.11) for relative motions and puts the places
// together afterwards (3.15). They lead to the same places, and the second is shorter.
// Read first. The sections "From pairs to relative motions" and "Nothing is lost" of chapter 3.
//
//   g        place in SE(3), body to space            l     Lagrangian on the algebra, J; reduced discrete Lagrangian, J s
//   f        relative motion g1^-1 g0                 L     discrete Lagrangian on pairs of places, l(g1^-1 g0)
//   Pi, P    body momenta of turning and of gliding   h     step, s
#include <chrono>

#include "actio/foundations/groups/motions.hpp"
#include "actio/reduction/discrete_forms.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/reduction/natural_chart.hpp"
#include "actio/variational/euler_poincare.hpp"
#include "book/plot.hpp"

using namespace actio;
using Eigen::Vector3d;
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Place = Element<SE<3>, double>;

// Lamb's integrals of an ellipsoid in an ideal fluid: abc times the integral over u > 0 of du / ((a_i^2 + u) sqrt(prod (a_k^2 + u))).
Vector3d lamb(Vector3d const& half_axes) {
  Vector3d sum = Vector3d::Zero(), squares = half_axes.cwiseAbs2();
  for (double s = -4; s < 4; s += 0.01) {  // u = exp(2 sinh s): the trapezoidal rule is exact to rounding
    double const u = std::exp(2 * std::sinh(s)), du = 2 * std::cosh(s) * u * 0.01;
    Vector3d const d = squares.array() + u;
    sum += half_axes.prod() * du / std::sqrt(d.prod()) * d.cwiseInverse();
  }
  return sum;
}
// What Runge-Kutta steps: a place, and how fast it changes as the submarine feels it.
struct Motion {
  Eigen::Matrix4d g;
  Vector6d xi;
  Motion operator+(Motion const& b) const { return {g + b.g, xi + b.xi}; }
};
Motion operator*(double s, Motion const& a) { return {s * a.g, s * a.xi}; }
Motion runge_kutta(auto const& rate, Motion const& x, double h) {
  Motion const k1 = rate(x), k2 = rate(x + h / 2 * k1), k3 = rate(x + h / 2 * k2), k4 = rate(x + h * k3);
  return x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}
double seconds_of(auto const& work) {
  auto const start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "a submarine tumbles through still water: reduced and unreduced steps lead to the same places");

  // 1. The submarine: an ellipsoid 4 m long, 1.6 m wide, 1 m high, as heavy as the water it displaces, its mass spread
  //    evenly. To its own inertia comes that of the water (Lamb, Hydrodynamics, articles 114 and 115).
  Vector3d const a(2.0, 0.8, 0.5), b = a.cwiseAbs2(), alpha = lamb(a);
  double const mass = 1000 * 4 * M_PI / 3 * a.prod();
  Vector6d inertia;
  for (int i = 0; i < 3; ++i) {
    int const j = (i + 1) % 3, k = (i + 2) % 3;
    double const less = b[j] - b[k], sum = b[j] + b[k], tilt = alpha[k] - alpha[j];
    inertia[i] = mass / 5 * (sum + less * less * tilt / (2 * less - sum * tilt));
    inertia[3 + i] = mass * (1 + alpha[i] / (2 - alpha[i]));
  }
  program.say("the water makes it ", inertia[3] / mass, ", ", inertia[4] / mass, ", ", inertia[5] / mass, " times as heavy, axis by axis");

  // 2. Its Lagrangian, as a function of turning and gliding, and Kirchhoff's equations; the discrete Lagrangian of a
  //    natural chart (3.25), and the same as a function of two places.
  SE<3> const space;
  auto const energy = [&](auto const& xi) {
    auto sum = xi.coordinates[0] * xi.coordinates[0] * inertia[0];
    for (int i = 1; i < 6; ++i) sum += xi.coordinates[i] * xi.coordinates[i] * inertia[i];
    return sum / 2.0;
  };
  auto const kirchhoff = [&](Motion const& m) {
    return Motion{m.g * SE<3>::hat(m.xi), euler_poincare_acceleration_left(energy, velocity(space, m.xi)).coordinates};
  };
  double const h = 0.2;
  auto const l = natural_chart_lagrangian_left(energy, h);
  auto const L = lift_left(l);

  // 3. Cast off: ahead at 1 m/s, turning a little about each axis. The first relative motion takes up this momentum.
  Vector6d xi;
  xi << 0.15, 0.1, 0.06, 1.0, 0.1, 0.05;
  auto const cast_off = gradient(energy, velocity(space, xi));
  auto const first = [&](auto const& l, double h) {
    return relative_motion_from_momentum_left(l, cast_off, exp(velocity(space, Vector6d(-h * xi)))).value;
  };
  auto const g0 = identity<double>(space);
  auto const f0 = first(l, h);

  // 4. The two roads.
  int const steps = 240;
  std::vector<Place> reduced{g0, reconstruct_left(g0, f0)}, unreduced = reduced;
  double const reduced_time = seconds_of([&] {
    auto f = f0;
    for (int k = 1; k < steps; ++k) {
      f = step_euler_poincare_left(l, f).value;
      reduced.push_back(reconstruct_left(reduced[k], f));
    }
  });
  double const unreduced_time = seconds_of([&] {
    for (int k = 1; k < steps; ++k) unreduced.push_back(step_euler_lagrange(L, unreduced[k - 1], unreduced[k]).value);
  });
  double apart = 0;
  for (int k = 0; k <= steps; ++k) apart = std::max(apart, (reduced[k].value - unreduced[k].value).norm() / reduced[k].value.norm());

  // 5. Look at it from one side: the path, and the submarine by three of its sections every few seconds.
  auto plot = book::Plot("metres to the right", "metres upwards").equal().size(660, 220);
  Vector3d const right(0.96, 0.28, 0), up(-0.5 * 0.28, 0.5 * 0.96, std::sqrt(0.75));
  auto const draw = [&](std::vector<Vector3d> const& points, std::string const& label, book::Look look) {
    std::vector<double> x, y;
    for (auto const& p : points) x.push_back(right.dot(p)), y.push_back(up.dot(p));
    plot.curve(x, y, label, look);
  };
  std::vector<Vector3d> path, dots;
  for (int k = 0; k <= steps; ++k) {
    Eigen::Matrix4d const& g = reduced[k].value;
    path.push_back(g.topRightCorner<3, 1>());
    if (k % 4 == 0) dots.push_back(unreduced[k].value.topRightCorner<3, 1>());
    for (int i = 0; k % 24 == 0 && i < 3; ++i) {
      std::vector<Vector3d> section;
      for (int degree = 0; degree <= 360; degree += 5) {
        Vector3d p = Vector3d::Zero();
        p[(i + 1) % 3] = a[(i + 1) % 3] * std::cos(degree * M_PI / 180), p[(i + 2) % 3] = a[(i + 2) % 3] * std::sin(degree * M_PI / 180);
        section.push_back(g.topLeftCorner<3, 3>() * p + g.topRightCorner<3, 1>());
      }
      draw(section, "", {.colour = 6, .width = 1});
    }
  }
  draw(path, "reduced steps, put together", {.colour = 1}),
      draw(dots, "unreduced steps, every fourth", {.colour = 2, .dots = true, .radius = 2.2});
  program.picture(
      "path", plot.svg(),
      "A submarine cast off ahead (from the left), turning slowly, and left alone for 48 seconds; three of its sections every 4.8 "
      "seconds. It soon lies across its path and tumbles: a long body that glides ahead is not stable in an ideal fluid. The line comes "
      "from the reduced equation and reconstruction, the dots from the unreduced one.");

  // 6. Far longer: what a Kirchhoff motion keeps whatever its energy, |P|^2 and Pi . P. Runge-Kutta with the same step.
  auto const casimirs = [](Vector6d const& m) { return Eigen::Array2d(m.tail<3>().squaredNorm(), m.head<3>().dot(m.tail<3>())); };
  auto const error = [&](Vector6d const& m) { return (casimirs(m) / casimirs(cast_off.components) - 1).abs().eval(); };
  Eigen::Array2d discrete(0, 0), classical(0, 0);
  std::vector<double> time, curves[4];
  auto f = f0;
  Motion m{g0.value, xi};
  int const many = 10000;
  for (int k = 1; k <= many; ++k) {
    discrete = discrete.max(error(momentum_before_left(l, f).components));
    f = step_euler_poincare_left(l, f).value;
    m = runge_kutta(kirchhoff, m, h);
    classical = classical.max(error(inertia.cwiseProduct(m.xi)));
    if (k % 50 == 0) {
      time.push_back(k * h);
      for (int i = 0; i < 2; ++i) curves[i].push_back(discrete[i]), curves[2 + i].push_back(classical[i]);
    }
  }
  auto casimir_plot = book::Plot("time, s", "largest error so far, relative").log_y();
  char const* const names[] = {"|P|², reduced steps", "Π·P, reduced steps", "|P|², Runge-Kutta", "Π·P, Runge-Kutta"};
  for (int i = 0; i < 4; ++i) casimir_plot.curve(time, curves[i], names[i], {.colour = i / 2 + 1, .dashed = i % 2 == 1});
  program.picture(
      "casimirs", casimir_plot.svg(),
      "What the coadjoint orbit keeps, over 10 000 steps of 0.2 s. The reduced steps carry the momentum along its orbit (3.18), "
      "whatever the step; Runge-Kutta leaves it.");

  // 7. The order: halve the step five times, and look where the submarine is after eight seconds.
  double const until = 8;
  Motion reference{g0.value, xi};
  for (int k = 0; k < 8000; ++k) reference = runge_kutta(kirchhoff, reference, until / 8000);
  std::vector<std::vector<std::string>> orders;
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (int n = 20; n <= 640; n *= 2) {
    auto const l = natural_chart_lagrangian_left(energy, until / n);
    auto f = first(l, until / n);
    auto g = reconstruct_left(g0, f);
    for (int k = 1; k < n; ++k) f = step_euler_poincare_left(l, f).value, g = reconstruct_left(g, f);
    double const miss = (g.value - reference.g).topRightCorner<3, 1>().norm(), x = std::log(until / n), y = std::log(miss);
    sx += x, sy += y, sxx += x * x, sxy += x * y;
    orders.push_back({book::number(until / n), book::number(miss)});
  }
  double const order = (6 * sxy - sx * sy) / (6 * sxx - sx * sx);
  program.table("order", {"step, s", "miss, m"}, orders, "Distance of the place after eight seconds from that of the Kirchhoff equations.");

  // 8. What must be so. Rounding of the momentum, 16 times a step, moves the place by its square in the number of steps;
  //    that of the Casimirs adds up at worst.
  double const epsilon = 0x1p-52;
  program.claim(std::abs(alpha.sum() - 2) < 1e3 * epsilon, "Lamb's integrals add up to 2");
  program.claim(apart < 16.0 * steps * steps * epsilon, "both roads lead to the same places");
  program.claim(discrete.maxCoeff() < many * epsilon, "reduced steps keep the Casimirs to rounding");
  program.claim(classical.minCoeff() > 1e-4, "Runge-Kutta does not");
  program.claim(std::abs(order - 2) < 0.05, "the order is 2");
  program.figure("apart", apart, "distance of the two roads, relative");
  program.figure("cost", unreduced_time / reduced_time, book::number(unreduced_time / reduced_time, 2),
                 "time of the unreduced road over that of the reduced one");
  program.figure("casimirs", discrete.maxCoeff(), "change of the Casimirs by reduced steps, relative");
  program.figure("casimirs_classical", classical.maxCoeff(), "the same by Runge-Kutta");
  program.figure("order", order, book::number(order, 3), "order of the reduced steps, fitted");
  program.headline("both roads end in the same place, to " + book::number(apart, 2), apart);
  return program.finish();
}
