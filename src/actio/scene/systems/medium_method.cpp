#include "actio/scene/systems/medium_method.hpp"

#include <fmt/format.h>

#include "actio/scene/systems/method_input.hpp"

namespace actio::scene {
namespace {

ArtificialViscosity read_viscosity(SceneTable const& method, bool plain) {
  if (!method.has("viscosity")) return {};
  SceneTable const table = method.inside("viscosity");
  table.allow({"linear", "quadratic"});
  ArtificialViscosity out;
  for (auto const& [key, value] :
       {std::pair{"linear", &out.linear}, std::pair{"quadratic", &out.quadratic}}) {
    if (!table.has(key)) continue;
    *value = table.number(key);
    if (!(*value >= 0))
      table.fail(key, fmt::format("{}: a coefficient of viscosity is not negative, found {}", key, *value));
  }
  if (out.any() && !plain)
    method.fail("viscosity", "viscosity: it is that of steps of order 2 with conserve = \"form\"");
  return out;
}

/// Rows and snapshots of a medium are at its steps.
void require_rows_at_steps(Request const& request, double step) {
  Schedule const& schedule = request.schedule;
  if (schedule.met_by(step)) return;
  double const below = schedule.step_up_to(step), above = schedule.step_from(step);
  std::string near = below > 0 ? fmt::format("; a step of {} meets them", below)
                               : std::string("; these times have no step in common");
  if (above > 0 && above != below) near += fmt::format("{} {}", below > 0 ? ", or" : "; a step of", above);
  if (schedule.between_steps())
    request.file.section("run").fail(
        "between_steps", "between_steps: the rows and snapshots of a medium are at its steps" + near);
  request.file.section("method").fail("step",
                                      fmt::format("step: the rows and snapshots of a medium are at multiples "
                                                  "of the step, and these are not at those of {}{}",
                                                  step, near));
}

/// Where rows and snapshots have no divisor in common: the last row beside multiples of run.every is told
/// with times that would do.
[[noreturn]] void fail_without_divisor(Request const& request) {
  SceneTable const run = request.file.section("run");
  std::string const why = "have no divisor in common, and rows and snapshots of a medium are at its steps";
  double const until = request.schedule.until();
  if (!run.has("every"))
    run.fail(run.has("at") ? "at" : "until",
             "the times of rows and snapshots " + why + "; run.every has them at multiples of one time");
  double const every = run.number("every"), parts = std::floor(until / every);
  run.fail("until", fmt::format("until = {} and every = {} {}; until = {:.12g} or {:.12g} would do", until,
                                every, why, parts * every, (parts + 1) * every));
}

}  // namespace

double medium_step(Request const& request, double longest, double frequency,
                   std::vector<std::string>& remarks) {
  SceneTable method = request.file.section("method");
  if (!method.has("step") && request.schedule.common_divisor() == 0) fail_without_divisor(request);
  constexpr double stable = 0.8, much = 0.25;  // radians that a wave turns in a step
  double const step =
      read_step(method, request.schedule, std::max(2 / longest, stable / much * frequency), stable);
  // The largest frequency is known from below, within a per cent.
  if (step > 0.99 * longest)
    fail_for_long_step(method, request.schedule, StepTooLong("medium", step, 0.99 * longest),
                       fmt::format("steps of length {} are not stable", step));
  require_rows_at_steps(request, step);
  if (step * frequency > much * (1 + 1e-9))
    remarks.push_back(
        fmt::format("step: loads change as a wave that turns by {:.2g} rad in a step of {}; steps of "
                    "{:.2g} follow them",
                    step * frequency, step, much / frequency));
  return step;
}

std::vector<Method> medium_methods() {
  return {
      {"multisymplectic",
       {"2", "4"},
       "The discrete Hamilton principle on space-time, with lumped masses and a deformation gradient at "
       "each corner of a cell: explicit. It conserves the multisymplectic form, linear and angular "
       "momentum; the energy oscillates with the square of the step. Composed of substeps order 4 in time.",
       "claim_10_0_variational_discretisation"}};
}

MediumMethod read_medium_method(SceneFile const& file) {
  SceneTable method = file.section("method");
  MediumMethod out;
  out.order = read_method(method, medium_methods()).number();
  if (!method.has("conserve")) method.set("conserve", "form");
  if (method.choice("conserve", "value of conserve", {"form", "energy"}) == "energy")
    out.conserve = Conserve::energy;
  out.viscosity = read_viscosity(method, out.plain());
  return out;
}

std::vector<Parameter> medium_method_parameters() {
  return {
      {"method.step", "a number > 0", "four tenths of the longest stable step, or less",
       "The time that a step takes, a whole number of times in the time between two rows, or two "
       "snapshots. By default it is at most four tenths of the longest for which small motions about "
       "the start are stable.",
       "time", "0.01"},
      {"run.between_steps", "true or false", "false",
       "Rows and snapshots of a medium are at its steps: true is refused where they are not.", "", "false"},
      {"method.conserve",
       "a text",
       "\"form\"",
       "What steps conserve besides linear and angular momentum: the multisymplectic form, explicitly, "
       "where the energy oscillates with the square of the step; or the energy, by a discrete gradient, "
       "which is implicit and gives up the form.",
       "",
       "\"energy\"",
       {"form", "energy"}},
      {"method.viscosity", "a table", "none",
       "The viscosity of von Neumann and Richtmyer, which spreads a shock over a few cells: where a cell of "
       "extent l is compressed, a pressure of the present density times l r (quadratic l r + linear c) acts "
       "on "
       "it, with r the rate at which its volume falls over that volume and c the speed of sound. 2 and 0.5 "
       "are "
       "usual. What it takes of the energy is the quantity dissipated.",
       "", "{ linear = 0.5, quadratic = 2 }"},
  };
}

}  // namespace actio::scene
