// A free rigid body in n dimensions (thesis, chapter 5).
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "actio/fast_body/any_dimension/skew_spectrum.hpp"
#include "program/registry/accuracy.hpp"
#include "program/registry/common_keys.hpp"
#include "program/registry/companion.hpp"
#include "program/registry/conservation.hpp"
#include "program/systems/bodies/body_n_input.hpp"
#include "program/systems/bodies/free_motion_n.hpp"
#include "program/systems/method_input.hpp"

namespace actio::scene {
namespace {

/// @throws SceneError  where energy, |M|^2 or a Casimir that was asked for is beyond the numbers
void require_finite_start(SceneTable const& initial, StartOfBodyN const& start, bool casimirs) {
  bool const finite = is_finite(start.momentum.squaredNorm()) &&
                      is_finite(start.momentum.cwiseAbs().cwiseProduct(start.velocity.cwiseAbs()).sum()) &&
                      is_finite(start.velocity.squaredNorm());
  if (!finite)
    initial.fail("angular_velocity",
                 "angular_velocity: the numbers are too large: energy and |M|^2 are beyond 1e308");
  if (!casimirs) return;
  int const n = start.inertia.group.n;
  double const largest = bodies::skew_spectrum(start.momentum).maxCoeff(),
               most = largest_modulus_for_casimirs(n);
  if (largest > most)
    initial.fail("angular_velocity",
                 fmt::format("angular_velocity: the largest modulus in the spectrum of M is {}; with more "
                             "than {} casimir_{} is beyond 1e300 (spectrum says as much)",
                             largest, most, n / 2 * 2));
}

StartOfBodyN read_start(SceneTable const& system, SceneTable const& initial, bool casimirs,
                        std::vector<std::string>& remarks) {
  StartOfBodyN start{read_lambda(system), {}, {}, {}};
  int const n = start.inertia.group.n;
  start.attitude = read_attitude_n(initial, n, remarks);
  start.velocity = read_velocity_n(initial, n);
  start.momentum =
      start.inertia.lambda.asDiagonal() * start.velocity + start.velocity * start.inertia.lambda.asDiagonal();
  require_finite_start(initial, start, casimirs);
  return start;
}

std::vector<Method> methods() {
  return {
      {"moser_veselov",
       {"6", "4", "2"},
       "The scheme of Moser and Veselov, order 2: h M_0 = f^T Lambda - Lambda f, M_1 = f M_0 f^T; "
       "composed of substeps 4 (Suzuki) and 6 (Kahan and Li). It conserves the spectrum of M, and that "
       "of a matrix polynomial with it.",
       "thm_5_2_1"},
      {"natural_chart",
       {"2", "4", "6"},
       "The scheme of the natural chart, order 2: the action of a step is that of a turn with constant "
       "velocity; composed of substeps 4 and 6. It conserves the spectrum of M.",
       "eq_5_4"},
  };
}

/// As many steps as take 5 ms or so: what a step takes beside its products, and n^3 times what these take.
long steps_in_5_ms(bool chart, int n) {
  double const cube = std::pow(n, 3), seconds = chart ? 7e-6 + 1e-8 * cube : 2e-7 + 7e-10 * cube;
  return std::max(1L, static_cast<long>(5e-3 / seconds));
}

/// The longest step of a composition is that of its longest substep; a little less is tried where a later
/// substep is still too long.
[[noreturn]] void fail_for_long_composition(StepsOfBodyN const& choice, StartOfBodyN const& start,
                                            SceneTable const& method, Schedule const& schedule, double step,
                                            StepTooLong const& error) {
  double longest = 0;
  for (double const fraction : fractions_of(choice.order)) longest = std::max(longest, std::abs(fraction));
  double largest = std::min(step, error.largest_step / longest);
  for (int k = 0; k < 40; ++k) try {
      stepped_motion_n(choice, start, largest);
      break;
    } catch (Error const&) {
      largest *= 0.9;
    }
  fail_for_long_step(method, schedule,
                     StepTooLong(choice.chart ? "natural chart" : "Moser-Veselov", step, largest));
}

/// By default a step of order 6 is so long that the error stays below 1e-6 until the end. With the fastest
/// plane turning by theta in a step and by Theta until the end, 400 bodies with random Lambda in 3 to 10
/// dimensions had errors of c theta^6 Theta: of the momentum c = 5e-4 in the median and 1e-3 at most, of the
/// attitude 1.4e-3 and 1.9e-3. A tenth of the bound is aimed at. A tenth of a radian is not exceeded; other
/// orders take a twentieth.
double default_turn(StepsOfBodyN const& choice, double fastest, double until) {
  if (choice.chart || choice.order != 6) return 0.05;
  return std::clamp(std::pow(1e-7 / (2e-3 * std::max(1.0, fastest * until)), 1.0 / 6), 1e-3, 0.1);
}

/// Steps four and eight times as long. Of Moser and Veselov's scheme they cost less than a half of the run up
/// to a tenth of a radian a step, as the companions need not solve each step to rounding, and up to three
/// fifths beyond; of the natural chart, which takes more sweeps for longer steps, a half to once the run.
Companion companion_of(StepsOfBodyN const& choice, StartOfBodyN const& start, double step,
                       std::optional<bool> wanted) {
  if (!wanted.value_or(true)) return {nullptr, 0, 0, choice.attitude, "left out by output.error_estimate"};
  if (choice.chart && !wanted)
    return {nullptr, 0, 0, choice.attitude,
            "not estimated: it costs more than half of the run; output.error_estimate = true asks for it"};
  bodies::Sweeps const sweeps =
      choice.order == 2 ? bodies::Sweeps::to_half_the_digits : bodies::Sweeps::to_rounding;
  return companions(
      [&](long multiple) {
        return stepped_motion_n(choice, start, static_cast<double>(multiple) * step, sweeps);
      },
      {4, 3, 2}, choice.order, choice.attitude);
}

Simulation prepare(Request const& request) {
  SceneTable system = request.file.section("system"), initial = request.file.section("initial"),
             method = request.file.section("method");
  auto const asked = [&](char const* name) {
    return std::find(request.quantities.begin(), request.quantities.end(), name) != request.quantities.end();
  };
  bool const with_attitude = asked("attitude");

  Simulation simulation(with_conserved("rigid_body_n", turning_body_n_quantities()));
  StartOfBodyN const start = read_start(system, initial, asked("casimir"), simulation.remarks);
  MethodChoice const asked_method = read_method(method, methods());
  StepsOfBodyN const choice{asked_method.name == "natural_chart", asked_method.number(), with_attitude};
  double const fastest = bodies::skew_spectrum(start.velocity).maxCoeff();
  simulation.step =
      read_step(method, request.schedule, fastest, default_turn(choice, fastest, request.schedule.until()));
  simulation.work = static_cast<double>(fractions_of(choice.order).size());
  simulation.steps_at_once =
      std::max(1L, steps_in_5_ms(choice.chart, start.inertia.group.n) / (choice.order == 2 ? 1 : 40));
  std::unique_ptr<TurningBodyN> motion;
  bool constant = false;
  try {
    motion = stepped_motion_n(choice, start, simulation.step);
  } catch (StepTooLong const& error) {
    if (choice.order != 2)
      fail_for_long_composition(choice, start, method, request.schedule, simulation.step, error);
    fail_for_long_step(method, request.schedule, error);
  } catch (Error const& error) {
    simulation.failure = method.place("step").text() + ": " + error.what();
    motion = constant_motion_n(start.momentum, start.attitude), constant = true;
  }

  if (!with_attitude) simulation.shortcuts.push_back("momentum only: no attitude is reconstructed");
  if (!with_attitude && start.inertia.moments.maxCoeff() == start.inertia.moments.minCoeff()) {
    simulation.shortcuts.push_back("all moments are equal: the momentum is constant");
    motion = constant_motion_n(start.momentum), constant = true;
  }
  simulation.companion = constant ? no_error("exact: the momentum is constant", false)
                                  : companion_of(choice, start, simulation.step, request.error_estimate);
  define_turning_body_n(simulation.quantities, *motion, start.inertia);
  simulation.quantities.ask(request.quantities);
  simulation.motion = std::move(motion);
  return simulation;
}

StepKeys const step_n{
    "from the time asked",
    "The time that a step takes, a whole number of times in the time between two rows. By default, for "
    "order 6, so long that the error stays below 1e-6 until the end, and at most 0.1 radians of the "
    "plane that turns fastest; otherwise 0.05 radians.",
    "0.01"};

}  // namespace

/// The free rigid body in n dimensions.
System rigid_body_n_system() {
  return {"rigid_body_n",
          "Free rigid body in n dimensions",
          "A rigid body that turns freely about its centre of mass in a space of n dimensions.",
          "chapter 5",
          records_of({body_n_parameters(), step_n, accuracy_keys}),
          methods(),
          turning_body_n_quantities(),
          prepare,
          "[system]\nkind = \"rigid_body_n\"\nlambda = [1, 2, 3, 4]\n[initial]\n"
          "angular_velocity = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]\n[run]\nuntil = 20\nevery = 0.1\n[output]\n"
          "quantities = [\"momentum\", \"energy\"]\n"};
}

}  // namespace actio::scene
