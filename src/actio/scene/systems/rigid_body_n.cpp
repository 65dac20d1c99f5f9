// A free rigid body in n dimensions (thesis, chapter 5).
#include <fmt/format.h>

#include "actio/large_body/moser_veselov_n.hpp"
#include "actio/large_body/skew_spectrum.hpp"
#include "actio/scene/systems/body_n_input.hpp"

namespace actio::scene {
namespace {

using Group = SO<Eigen::Dynamic>;
using Eigen::MatrixXd;

/// The motion of a body in n dimensions.
class TurningBodyN : public Motion {
 public:
  virtual MatrixXd body_momentum() const = 0;
  /// Body to space.
  virtual MatrixXd attitude() const = 0;
};

/// In steps of a scheme for n at run time.
template <class Scheme>
class SteppedMotion : public TurningBodyN {
 public:
  SteppedMotion(Scheme scheme, MatrixXd const& attitude, MatrixXd const& momentum, bool with_attitude)
      : scheme_(std::move(scheme)), body_(released(scheme_, attitude, momentum)), with_attitude_(with_attitude) {
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
  static auto released(Scheme const& scheme, MatrixXd const& attitude, MatrixXd const& momentum) {
    Group const group = scheme.inertia().group;
    return scheme.release({group, attitude}, {group, group.vee(momentum)});
  }
  Scheme scheme_;
  decltype(released(std::declval<Scheme>(), {}, {})) body_;
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

std::vector<int> casimir_numbers(int n) {
  std::vector<int> numbers;
  for (int k = 1; k <= n / 2; ++k) numbers.push_back(2 * k);
  return numbers;
}
std::vector<int> whole_numbers(int n) {
  std::vector<int> numbers;
  for (int k = 1; k <= n; ++k) numbers.push_back(k);
  return numbers;
}

std::vector<Quantity> quantities() {
  using Kind = Quantity::Kind;
  return {
      {"attitude", Kind::matrix, "The rotation, n by n, that takes the body to space.", "g", "1", "claim_5_2_reconstruction", {}, false},
      {"momentum", Kind::skew, "The angular momentum in the frame of the body, a skew matrix.", "M = \\Lambda\\xi + \\xi\\Lambda", "energy x time", "eq_5_8", {}, false},
      {"energy", Kind::scalar, "The kinetic energy.", "H = \\tfrac12\\sum_{i<j}(\\Lambda_i+\\Lambda_j)\\,\\xi_{ij}^2", "energy", "eq_5_1", {"momentum"}, true},
      {"spectrum", Kind::list, "The moduli of the eigenvalues of the momentum in ascending order; those that rounding cannot tell from zero are zero.",
       "\\sigma_k = |\\lambda_k|,\\quad \\det(M-\\lambda_k) = 0", "energy x time", "claim_5_2_update_by_conjugation", {"momentum"}, true},
      {"casimir", Kind::list, "The traces of even powers of the momentum, which name the coadjoint orbit; made of the spectrum.",
       "C_{2k} = (-1)^k\\,\\mathrm{tr}\\,M^{2k} = \\sum_i\\sigma_i^{2k},\\quad k = 1,\\dots,\\lfloor n/2\\rfloor", "(energy x time)^2k", "claim_5_3_dual_casimir", {"spectrum"}, true},
  };
}

void define_quantities(QuantityGraph& graph, TurningBodyN const& motion, Inertia<Eigen::Dynamic> const& inertia) {
  using Kind = Quantity::Kind;
  int const n = inertia.group.n;
  graph.define("attitude", column_ends(Kind::matrix, n), [&motion, n](auto, double* g) {
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(g, n, n) = motion.attitude();
  });
  graph.define("momentum", column_ends(Kind::skew, n), [&motion](auto, double* M) {
    auto const upper = upper_triangle(motion.body_momentum());
    std::copy(upper.begin(), upper.end(), M);
  });
  graph.define("energy", {""}, [lambda = inertia.lambda, n](auto needs, double* energy) {
    double const* M = needs[0];
    double sum = 0;
    for (int i = 0; i < n; ++i)
      for (int j = i + 1; j < n; ++j, ++M) sum += *M / (lambda[i] + lambda[j]) * *M;
    *energy = sum / 2;
  });
  graph.define("spectrum", numbered(whole_numbers(n)), [n](auto needs, double* moduli) { Eigen::Map<Eigen::VectorXd>(moduli, n) = skew_spectrum(skew_matrix(needs[0], n)); });
  graph.define("casimir", numbered(casimir_numbers(n)), [n](auto needs, double* casimirs) {
    for (int k = 1; k <= n / 2; ++k) {
      casimirs[k - 1] = 0;
      for (int i = 0; i < n; ++i) casimirs[k - 1] += std::pow(needs[0][i], 2 * k);
    }
  });
}

/// Turns of 0.05 radians in the plane that turns fastest, or a little less, so that rows are at multiples of the step.
double default_step(Schedule const& schedule, double fastest) {
  double const divisor = schedule.common_divisor() > 0 ? schedule.common_divisor() : schedule.until();
  return divisor / std::max(1.0, std::ceil(divisor * fastest / 0.05));
}

/// Name and order; others are refused by name.
std::string read_method(SceneTable method) {
  if (!method.has("name")) method.set("name", "moser_veselov");
  if (!method.has("order")) method.set("order", 2L);
  std::string const name = method.choice("name", "method", {"moser_veselov", "natural_chart"}, "actio list methods");
  if (method.is_text("order")) method.fail("order", fmt::format("order: rigid_body_n takes order 2 of {}, found \"{}\"", name, method.text("order")));
  if (long const order = method.integer("order", std::numeric_limits<long>::min(), std::numeric_limits<long>::max()); order != 2)
    method.fail("order", fmt::format("order: rigid_body_n takes order 2 of {}, found {}", name, order));
  return name;
}

/// @throws SceneError  where energy, |M|^2 or a Casimir that was asked for is beyond the numbers
void require_finite_start(Request const& request, SceneTable const& initial, MatrixXd const& momentum, MatrixXd const& velocity) {
  bool const finite = is_finite(momentum.squaredNorm()) && is_finite(momentum.cwiseProduct(velocity).sum()) && is_finite(velocity.squaredNorm());
  if (!finite) initial.fail("angular_velocity", "angular_velocity: the numbers are too large: energy and |M|^2 are beyond 1e308");
  auto const& asked = request.quantities;
  int const n = static_cast<int>(momentum.rows());
  if (std::find(asked.begin(), asked.end(), "casimir") == asked.end()) return;
  double const largest = skew_spectrum(momentum).maxCoeff(), most = std::pow(1e300, 1.0 / (n / 2 * 2)) / n;
  if (largest > most)
    initial.fail("angular_velocity", fmt::format("angular_velocity: casimir_{} is beyond 1e300; the largest modulus in the spectrum of M is {}, where {} is taken; spectrum says the same",
                                                 n / 2 * 2, largest, most));
}

std::unique_ptr<TurningBodyN> motion_of(std::string const& method, Inertia<Eigen::Dynamic> const& inertia, double step, MatrixXd const& attitude, MatrixXd const& momentum, bool with_attitude) {
  (void)method;
  return std::make_unique<SteppedMotion<FastMoserVeselov>>(FastMoserVeselov(inertia, step, Sweeps::beyond_rounding), attitude, momentum, with_attitude);
}

Simulation prepare(Request const& request) {
  SceneTable system = request.file.section("system"), initial = request.file.section("initial"), method = request.file.section("method");
  system.allow({"kind", "lambda"});
  initial.allow({"attitude", "angular_velocity"});
  method.allow({"name", "order", "step"});

  Simulation simulation(quantities());
  Inertia<Eigen::Dynamic> const inertia = read_lambda(system);
  int const n = inertia.group.n;
  MatrixXd const attitude = read_attitude_n(initial, n, simulation.remarks), velocity = read_velocity_n(initial, n);
  MatrixXd const momentum = inertia.lambda.asDiagonal() * velocity + velocity * inertia.lambda.asDiagonal();
  require_finite_start(request, initial, momentum, velocity);

  std::string const name = read_method(method);
  if (!method.has("step")) method.set("step", default_step(request.schedule, skew_spectrum(velocity).maxCoeff()));
  simulation.step = method.positive("step");

  auto const& asked = request.quantities;
  bool const with_attitude = std::find(asked.begin(), asked.end(), "attitude") != asked.end();
  bool const equal_moments = inertia.moments.maxCoeff() == inertia.moments.minCoeff();
  std::unique_ptr<TurningBodyN> motion;
  try {
    motion = motion_of(name, inertia, simulation.step, attitude, momentum, with_attitude);
  } catch (Error const& error) {
    simulation.failure = method.place("step").text() + ": " + error.what();
    motion = std::make_unique<ConstantMomentum>(momentum, attitude);
  }
  if (!with_attitude) simulation.shortcuts.push_back("momentum only: no attitude is reconstructed");
  if (!with_attitude && equal_moments) {
    simulation.shortcuts.push_back("all moments are equal: the momentum is constant");
    motion = std::make_unique<ConstantMomentum>(momentum);
  }
  define_quantities(simulation.quantities, *motion, inertia);
  simulation.quantities.ask(asked);
  simulation.motion = std::move(motion);
  return simulation;
}

}  // namespace

System rigid_body_n_system() {
  return {"rigid_body_n",
          "Free rigid body in n dimensions",
          "A rigid body that turns freely about its centre of mass in a space of n dimensions.",
          "chapter 5",
          {},
          {},
          quantities(),
          prepare};
}

}  // namespace actio::scene
