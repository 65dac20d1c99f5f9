// Error against processor time of a damped body with a wheel: steps of the natural chart with a force, beside
// Runge-Kutta methods on the same equations, of order 4 (RK4) and on the group (RKMK4, Munthe-Kaas).
//
// The friction is inside, so that the momentum in space is constant. The peers are written by hand for this
// body; the steps of the natural chart take Lagrangian and force as formulas.
#include <Eigen/Geometry>

#include "actio/any_group/chart_integrator.hpp"
#include "actio/any_group/named_algebra.hpp"
#include "actio/formula/parse_formula.hpp"
#include "actio/formula/tape_derivatives.hpp"
#include "actio/reduction/composition.hpp"
#include "benchmark.hpp"
#include "digits_plot.hpp"
#include "error_against_time.hpp"

using namespace actio;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Vector4 = Eigen::Vector4d;

namespace {

// Of the whole body, wheel included, the wheel's about the first axis, and the friction of its bearing.
constexpr double I1 = 1, I2 = 1.4, I3 = 2, J = 0.1, friction = 0.05, until = 40;
Vector4 const first_velocity(1, 0.1, 0.05, 0);

/// Momenta of body and wheel, and the attitude.
struct Tumbler {
  Vector4 p{I1, I2 * 0.1, I3 * 0.05, J};
  Matrix3d R = Matrix3d::Identity();
  Vector3d in_space() const { return R * p.head<3>(); }
};
double apart(Tumbler const& a, Tumbler const& b) {
  return std::max((a.p - b.p).cwiseAbs().maxCoeff(), (a.R - b.R).cwiseAbs().maxCoeff());
}

Vector3d turn(Vector4 const& p) { return {(p[0] - p[3]) / (I1 - J), p[1] / I2, p[2] / I3}; }
Vector4 change(Vector4 const& p) {
  Vector3d const w = turn(p), M = p.head<3>();
  Vector4 out;
  out << M.cross(w), -friction * (p[3] / J - w[0]);
  return out;
}

/// RK4 of momenta and quaternion.
Tumbler by_runge_kutta(long steps) {
  double const h = until / static_cast<double>(steps);
  Vector4 p = Tumbler().p, q(0, 0, 0, 1);  // the scalar part last
  auto const spin = [](Vector4 const& q, Vector4 const& p) {
    Vector3d const w = turn(p) / 2;
    return Vector4((Quaterniond(q) * Quaterniond(0, w[0], w[1], w[2])).coeffs());
  };
  for (long k = 0; k < steps; ++k) {
    Vector4 const a = change(p), u = spin(q, p), p2 = p + h / 2 * a, b = change(p2),
                  v = spin(q + h / 2 * u, p2), p3 = p + h / 2 * b, c = change(p3),
                  w = spin(q + h / 2 * v, p3), p4 = p + h * c, d = change(p4), x = spin(q + h * w, p4);
    p += h / 6 * (a + 2 * (b + c) + d), q += h / 6 * (u + 2 * (v + w) + x);
  }
  return {p, Quaterniond(q).normalized().toRotationMatrix()};
}

Quaterniond exponential(Vector3d const& turn) {
  double const angle = turn.norm() / 2, part = angle < 1e-8 ? 0.5 : std::sin(angle) / (2 * angle);
  return {std::cos(angle), part * turn[0], part * turn[1], part * turn[2]};
}

/// RKMK4: the rotation by an exponential in each step, with the two corrections by brackets.
Tumbler by_munthe_kaas(long steps) {
  double const h = until / static_cast<double>(steps);
  Vector4 p = Tumbler().p;
  Quaterniond q = Quaterniond::Identity();
  for (long k = 0; k < steps; ++k) {
    Vector4 const a = change(p), p2 = p + h / 2 * a, b = change(p2), p3 = p + h / 2 * b, c = change(p3),
                  p4 = p + h * c, d = change(p4);
    // The velocity depends on the momenta alone; for g' = g v the bracket has a plus sign.
    Vector3d const k1 = turn(p), k4 = turn(p4),
                   u = h / 6 * (k1 + 2 * (turn(p2) + turn(p3)) + k4) + h * h / 12 * k1.cross(k4);
    q = (q * exponential(u)).normalized();
    p += h / 6 * (a + 2 * (b + c) + d);
  }
  return {p, q.toRotationMatrix()};
}

/// The body by formulas.
std::shared_ptr<systems::ReducedSystem const> by_formulas() {
  auto const algebra = systems::named_algebra("SO(3) x R^1");
  auto names = algebra.components;
  std::map<std::string, double> const numbers{{"I1", I1}, {"I2", I2}, {"I3", I3}, {"J", J}, {"c", friction}};
  auto out = std::make_shared<systems::ReducedSystem>(
      algebra, systems::Side::left, 0,
      parse_formula("((I1 - J)*x1^2 + I2*x2^2 + I3*x3^2 + J*(x1 + x4)^2)/2", names, numbers));
  for (auto const& name : algebra.components) names.push_back("p_" + name);
  names.push_back("t");
  std::vector<Tape> force;
  for (char const* const text : {"0", "0", "0", "-c*x4"})
    force.push_back(parse_formula(text, names, numbers));
  out->force = systems::GeneralizedForce{joined(force)};
  return out;
}
Tumbler by_natural_chart(std::shared_ptr<systems::ReducedSystem const> const& system, int order, long steps) {
  Tumbler const first;
  systems::ChartIntegrator run(
      system, until / static_cast<double>(steps), symmetric_composition<double>(order),
      {{first.p.data(), first.p.data() + 4}, {}}, {first_velocity.data(), first_velocity.data() + 4});
  run.follow_configuration(Eigen::MatrixXd::Identity(system->length(), system->length()));
  for (long k = 0; k < steps; ++k) run.step();
  return {Vector4(run.point().momentum.data()), run.configuration().topLeftCorner<3, 3>()};
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Benchmark program(argc, argv, "a damped body with a wheel: momentum and state against time");
  auto const system = by_formulas();
  Tumbler const truth = by_natural_chart(system, 6, 8000), other = by_munthe_kaas(400000);
  Vector3d const momentum = Tumbler().in_space();
  using Run = std::function<Tumbler(long)>;
  std::vector<std::pair<std::string, Run>> const ways{
      {"natural chart, order 2", [&](long n) { return by_natural_chart(system, 2, n); }},
      {"natural chart, order 4", [&](long n) { return by_natural_chart(system, 4, n); }},
      {"RK4", by_runge_kutta},
      {"RKMK4", by_munthe_kaas}};
  benchmark::DigitsPlot states("correct digits of the state"), momenta("correct digits of the momentum");
  std::vector<book::Program::Row> rows;
  double worst_own = 0, own_seconds = HUGE_VAL, peer_momentum = HUGE_VAL, peer_seconds = HUGE_VAL;
  long const most = program.length(25600, 6400);
  for (auto const& [name, way] : ways) {
    bool const own = name.starts_with("natural");
    std::vector<benchmark::Timed> of_state, of_momentum;
    for (long n = 50; n <= most; n *= 2) {
      Tumbler end;
      double seconds = HUGE_VAL;
      for (int repeat = 0; repeat < 5; ++repeat)
        seconds = std::min(seconds, benchmark::processor_seconds_of([&] { end = way(n); }));
      double const state = apart(end, truth), moved = (end.in_space() - momentum).norm() / momentum.norm();
      of_state.push_back({static_cast<double>(n), state, seconds});
      of_momentum.push_back({static_cast<double>(n), moved, seconds});
      if (own) worst_own = std::max(worst_own, moved);
      if (state <= 1e-6 && own) own_seconds = std::min(own_seconds, seconds);
      if (state <= 1e-6 && !own && seconds < peer_seconds) peer_seconds = seconds, peer_momentum = moved;
      if (n == 100 || n == 400 || n == 1600)
        rows.push_back({name, std::to_string(n), book::number(1e3 * seconds, 2), book::number(state, 2),
                        book::number(moved, 2)});
    }
    states.line(of_state, name, own), momenta.line(of_momentum, name, own);
  }
  program.picture("momentum", momenta.svg(),
                  "Time for an accuracy of the momentum in space; the natural chart is bold, the peers are "
                  "written by hand.");
  program.picture("state", states.svg(), "The same for the state: momenta and attitude at the end.");
  program.table("forces", {"method", "steps", "ms", "error of the state", "change of the momentum in space"},
                rows, "To t = 40, set-up included; the change is relative.");
  double const reference = apart(truth, other);
  program.figure("apart", reference, "the reference solution against RKMK4 in 400000 steps");
  program.figure("momentum", worst_own, "the largest relative change of the momentum by the natural chart");
  program.figure("peer_momentum", peer_momentum,
                 "that of the peer that takes the least time for a state to 1e-6");
  program.figure("times", own_seconds / peer_seconds,
                 "times as long by the natural chart as by that peer, for a state to 1e-6");
  // A few roundings a step.
  program.claim(
      book::measured(worst_own) < 4 * std::numeric_limits<double>::epsilon() * static_cast<double>(most) * 5,
      "the natural chart conserves the momentum to a few roundings in each substep");
  program.claim(book::measured(reference) < 1e-10, "the reference solution and that of RKMK4 agree to 1e-10");
  program.claim(book::measured(100 * worst_own) < peer_momentum,
                "with a state to 1e-6 the momentum of the peers is off by a hundred times as much and more");
  program.headline("the momentum of a damped body with a wheel changes by " + book::number(worst_own) +
                       " at any step; by RK4 and RKMK4, with a state to 1e-6, by " +
                       book::number(peer_momentum),
                   worst_own);
  return program.finish();
}
