#include "program/systems/media/method.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "program/registry/common_keys.hpp"
#include "program/systems/method_input.hpp"
#include "program/systems/step_hint.hpp"

namespace actio::scene {
namespace {

StepKeys const medium_step_keys{
    "four tenths of the longest stable step, or less",
    "The time that a step takes. By default it is at most four tenths of the longest for which small "
    "motions about the start are stable and viscosity is damping; nine tenths of the former are the "
    "most. Where viscosity allows less on the way, as in a shock, a step is made in equal parts.",
    "0.01"};
struct MediumMethodKeys : KeyTable {
  Key<std::string> conserve =
      key("conserve", one_of("value of conserve", {"form", "energy"}), "form",
          "What steps conserve besides linear and angular momentum: the multisymplectic form, explicitly, "
          "where the energy oscillates with the square of the step; or the energy, by a discrete gradient, "
          "which is implicit and gives up the form.",
          "\"energy\"");
  AnyKey viscosity = key(
      "viscosity", "a table", LeftOut{"none"},
      "The viscosity of von Neumann and Richtmyer, which spreads a shock over a few cells: where a cell "
      "of extent l is compressed, a pressure of the present density times l r (quadratic l r + linear c) "
      "acts on it, with r the rate at which its volume falls over that volume and c the speed of sound. 2 "
      "and 0.5 are usual. What it takes of the energy is the quantity dissipated.",
      "{ linear = 0.5, quadratic = 2 }");
} const medium_method_keys{{"method"}};

media::ArtificialViscosity read_viscosity(SceneTable const& method, bool plain) {
  if (!method.has("viscosity")) return {};
  SceneTable const table = method.inside("viscosity");
  table.allow({"linear", "quadratic"});
  media::ArtificialViscosity out;
  for (auto const& [key, value] :
       {std::pair{"linear", &out.linear}, std::pair{"quadratic", &out.quadratic}}) {
    if (!table.has(key)) continue;
    *value = table.number(key);
    if (!(*value >= 0))
      table.fail(key, fmt::format("{}: a coefficient of viscosity is not negative, found {}", key, *value));
  }
  if (out.any() && !plain)
    medium_method_keys.viscosity.fail(method, "it is that of steps of order 2 with conserve = \"form\"");
  return out;
}

}  // namespace

double medium_step(Request const& request, double longest, double frequency,
                   std::vector<std::string>& remarks, double in_one, bool is_explicit) {
  SceneTable method = request.file.section("method");
  constexpr double stable_turn = 0.8, much = 0.25;  // radians that a wave turns in a step
  double const fastest = std::max(2 / std::min(longest, in_one), stable_turn / much * frequency),
               step = read_step(method, request.schedule, fastest, stable_turn);
  if (step * frequency > much * (1 + 1e-9))
    remarks.push_back(
        fmt::format("step: loads change as a wave that turns by {:.2g} rad in a step of "
                    "{}; steps of {:.2g} follow them",
                    step * frequency, step, much / frequency));
  // The largest frequency is known from below, within a per cent.
  bool const stable = step <= 0.99 * longest;
  if (stable && !(is_explicit && step > safe_part * longest)) return step;
  // The bound moves with the body: what is told has room for that.
  double const would = (is_explicit ? 0.94 * safe_part : 0.99 * (1 - 1e-9)) * longest;
  throw NumericsError(fmt::format(
      "{}: step: steps of length {} are not {}; a step of {} would do{}", method.place("step").text(), step,
      stable ? fmt::format("safe: small motions are stable up to {:.6g}, of which nine tenths are", longest)
             : "stable",
      would, step_that_meets(request.schedule, would)));
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
  if (medium_method_keys.conserve.read(method) == "energy") out.conserve = media::Conserve::energy;
  out.viscosity = read_viscosity(method, out.plain());
  return out;
}

std::vector<Parameter> medium_method_parameters() {
  return records_of({medium_step_keys, medium_method_keys});
}

}  // namespace actio::scene
