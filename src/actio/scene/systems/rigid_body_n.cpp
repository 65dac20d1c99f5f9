// A free rigid body in n dimensions (thesis, chapter 5).
#include <fmt/format.h>

#include "actio/large_body/moser_veselov_n.hpp"
#include "actio/large_body/natural_chart_n.hpp"
#include "actio/scene/systems/body_n_input.hpp"
#include "actio/scene/systems/method_input.hpp"
#include "actio/scene/systems/turning_body_n.hpp"

namespace actio::scene {
namespace {

using Group = SO<Eigen::Dynamic>;
using Eigen::MatrixXd;

/// A body at the start.
struct Start {
  Inertia<Eigen::Dynamic> inertia;
  MatrixXd attitude, velocity, momentum;
};

/// In steps of a scheme for n at run time.
template <class Scheme>
class SteppedMotion : public TurningBodyN {
 public:
  SteppedMotion(Scheme scheme, Start const& start, bool with_attitude) : scheme_(std::move(scheme)), body_(released(scheme_, start)), with_attitude_(with_attitude) {
    // Only the first step shows whether it is too long.
    auto body = body_;
    scheme_.step(body);
  }
  void advance(long steps) override {
    for (long k = 0; k < steps; ++k) with_attitude_ ? scheme_.step_with_attitude(body_) : scheme_.step(body_);
  }
  void remember(Memory& memory) override { body_.remember(memory); }
  MatrixXd body_momentum() const override {
    auto const pi = body_.momentum();
    return pi.group.hat(pi.components);
  }
  MatrixXd attitude() const override { return body_.attitude().value; }

 private:
  static auto released(Scheme const& scheme, Start const& start) {
    Group const group = scheme.inertia().group;
    return scheme.release({group, start.attitude}, {group, group.vee(start.momentum)});
  }
  Scheme scheme_;
  decltype(released(std::declval<Scheme>(), {})) body_;
  bool with_attitude_;
};

/// What does not move: the momentum, without an attitude, of a body all whose moments are equal; and the start of a motion that can take no step.
class ConstantMomentum : public TurningBodyN {
 public:
  explicit ConstantMomentum(MatrixXd momentum, MatrixXd attitude = {}) : momentum_(std::move(momentum)), attitude_(std::move(attitude)) {}
  MatrixXd body_momentum() const override { return momentum_; }
  MatrixXd attitude() const override { return attitude_; }

 private:
  MatrixXd momentum_, attitude_;
};

/// @throws SceneError  where energy, |M|^2 or a Casimir that was asked for is beyond the numbers
void require_finite_start(SceneTable const& initial, Start const& start, bool casimirs) {
  bool const finite = is_finite(start.momentum.squaredNorm()) && is_finite(start.momentum.cwiseAbs().cwiseProduct(start.velocity.cwiseAbs()).sum()) && is_finite(start.velocity.squaredNorm());
  if (!finite) initial.fail("angular_velocity", "angular_velocity: the numbers are too large: energy and |M|^2 are beyond 1e308");
  if (!casimirs) return;
  int const n = start.inertia.group.n;
  double const largest = skew_spectrum(start.momentum).maxCoeff(), most = largest_modulus_for_casimirs(n);
  if (largest > most)
    initial.fail("angular_velocity", fmt::format("angular_velocity: the largest modulus in the spectrum of M is {}; with more than {} casimir_{} is beyond 1e300 (spectrum tells as much)", largest, most, n / 2 * 2));
}

Start read_start(SceneTable const& system, SceneTable const& initial, bool casimirs, std::vector<std::string>& remarks) {
  Start start{read_lambda(system), {}, {}, {}};
  int const n = start.inertia.group.n;
  start.attitude = read_attitude_n(initial, n, remarks);
  start.velocity = read_velocity_n(initial, n);
  start.momentum = start.inertia.lambda.asDiagonal() * start.velocity + start.velocity * start.inertia.lambda.asDiagonal();
  require_finite_start(initial, start, casimirs);
  return start;
}

std::vector<Method> methods() {
  return {
      {"moser_veselov", {"2"}, "The scheme of Moser and Veselov: h M_0 = f^T Lambda - Lambda f, M_1 = f M_0 f^T. It keeps the spectrum of M, and that of a matrix polynomial with it.", "thm_5_2_1"},
      {"natural_chart", {"2"}, "The scheme of the natural chart: the action of a step is that of a turn with constant velocity. It keeps the spectrum of M.", "eq_5_4"},
  };
}

/// As many steps as take 5 ms or so: what a step takes beside its products, and n^3 times what these take.
long steps_in_5_ms(bool chart, int n) {
  double const cube = std::pow(n, 3), seconds = chart ? 7e-6 + 1e-8 * cube : 2e-7 + 7e-10 * cube;
  return std::max(1L, static_cast<long>(5e-3 / seconds));
}

std::unique_ptr<TurningBodyN> motion_of(bool chart, Start const& start, double step, bool with_attitude) {
  if (chart) return std::make_unique<SteppedMotion<FastNaturalChart>>(FastNaturalChart(start.inertia, step), start, with_attitude);
  return std::make_unique<SteppedMotion<FastMoserVeselov>>(FastMoserVeselov(start.inertia, step, Sweeps::beyond_rounding), start, with_attitude);
}

Simulation prepare(Request const& request) {
  SceneTable system = request.file.section("system"), initial = request.file.section("initial"), method = request.file.section("method");
  system.allow({"kind", "lambda"});
  initial.allow({"attitude", "angular_velocity"});
  method.allow({"name", "order", "step"});
  auto const asked = [&](char const* name) { return std::find(request.quantities.begin(), request.quantities.end(), name) != request.quantities.end(); };
  bool const with_attitude = asked("attitude");

  Simulation simulation(turning_body_n_quantities());
  Start const start = read_start(system, initial, asked("casimir"), simulation.remarks);
  bool const chart = read_method(method, methods()).name == "natural_chart";
  simulation.step = read_step(method, request.schedule, skew_spectrum(start.velocity).maxCoeff());
  simulation.steps_at_once = steps_in_5_ms(chart, start.inertia.group.n);
  std::unique_ptr<TurningBodyN> motion;
  try {
    motion = motion_of(chart, start, simulation.step, with_attitude);
  } catch (StepTooLong const& error) {
    fail_for_long_step(method, request.schedule, error);
  } catch (Error const& error) {
    simulation.failure = method.place("step").text() + ": " + error.what();
    motion = std::make_unique<ConstantMomentum>(start.momentum, start.attitude);
  }

  if (!with_attitude) simulation.shortcuts.push_back("momentum only: no attitude is reconstructed");
  if (!with_attitude && start.inertia.moments.maxCoeff() == start.inertia.moments.minCoeff()) {
    simulation.shortcuts.push_back("all moments are equal: the momentum is constant");
    motion = std::make_unique<ConstantMomentum>(start.momentum);
  }
  define_turning_body_n(simulation.quantities, *motion, start.inertia);
  simulation.quantities.ask(request.quantities);
  simulation.motion = std::move(motion);
  return simulation;
}

std::vector<Parameter> parameters() {
  return {
      {"system.lambda", fmt::format("n numbers, n from 2 to {}", most_dimensions), "needed",
       "The diagonal of Lambda: second moments of the mass along the body axes; mass x length^2. The sum of any two is positive, and is the moment of inertia in their plane."},
      {"initial.attitude", "a list of n rows of n numbers, a rotation", "the identity", "The rotation that takes the body to space; off by at most 1e-9 it is normalised, and said."},
      {"initial.angular_velocity", "n(n-1)/2 numbers", "needed",
       "The upper triangle of the body velocity g^-1 g', row by row: xi_12, xi_13, ..., xi_23, ...; 1/time. For n = 3: (xi_12, xi_13, xi_23) = (-w_z, w_y, -w_x)."},
      {"method.step", "a number > 0", "0.05 radians or less", "The time that a step takes; by default the plane that turns fastest turns by 0.05 radians or a little less, in a whole number of steps to each row."},
  };
}

}  // namespace

System rigid_body_n_system() {
  return {"rigid_body_n",
          "Free rigid body in n dimensions",
          "A rigid body that turns freely about its centre of mass in a space of n dimensions.",
          "chapter 5",
          parameters(),
          methods(),
          turning_body_n_quantities(),
          prepare,
          "[system]\nkind = \"rigid_body_n\"\nlambda = [1, 2, 3, 4]\n[initial]\nangular_velocity = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]\n[run]\nuntil = 20\nevery = 0.1\n[output]\nquantities = [\"momentum\", \"energy\"]\n"};
}

}  // namespace actio::scene
