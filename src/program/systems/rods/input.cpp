#include "program/systems/rods/input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actio/rods/step_limit.hpp"
#include "program/registry/common_keys.hpp"
#include "program/systems/rods/formulas.hpp"
#include "program/systems/rods/load_input.hpp"
#include "program/systems/rods/section_input.hpp"

namespace actio::scene {
namespace {

using Vector = rods::Three<double>;

struct NameKeys : KeyTable {
  AnyKey parameters =
      key("parameters", "a table by names of one's own", LeftOut{"none"},
          "Numbers by whose names the formulas of the rod use them; each is used.", "{ r = 0.1 }");
  AnyKey definitions =
      key("definitions", "a table of formulas by names of one's own", LeftOut{"none"},
          "Formulas by whose names those of the rod and each other use them, in the names that these have; "
          "each is used.",
          "{ bump = \"0.1*exp(-s^2)\" }");
} const name_keys{{"system"}};

struct VelocityKeys : KeyTable {
  AnyKey velocity =
      key("velocity", "three texts, each a formula in x, y, z, s", LeftOut{"[0, 0, 0]"},
          "The velocity at the start of the section at x, y, z, at the distance s along the rod; "
          "an end that is held moves as its support does.",
          "[\"-0.5*y\", \"0.5*x\", \"0\"]");
  AnyKey angular_velocity =
      key("angular_velocity", "three texts, each a formula in x, y, z, s", LeftOut{"[0, 0, 0]"},
          "The angular velocity at the start of the section at the distance s, in space.",
          "[\"0\", \"0\", \"0.5\"]");
} const velocity_keys{{"initial"}};

StepKeys const rod_step{
    "half of the longest that is stable",
    "The time that a step takes. By default the longest that divides the times of the rows and is at most "
    "half of the longest that is stable: the quantity step_limit.",
    "0.001"};

struct ThreadKeys : KeyTable {
  Key<int> threads = key("threads", whole("a whole number from 1 to 256", 1, 256), 1,
                         "How many threads share the sections of a step; no digit depends on it, and it pays "
                         "from some thousand sections on.",
                         "2");
} const thread_keys{{"method"}};

double length_of(Vector const& v) { return std::hypot(v[0], v[1], v[2]); }

/// The small waves of the rod, by its shortest element.
rods::RodWaves waves_of(rods::RodSection const& section, rods::RodShape const& rest) {
  double shortest = HUGE_VAL;
  for (auto const& element : rods::elements_at_rest(rest))
    shortest = std::min(shortest, 1 / element.inverse_length);
  return {section, shortest};
}

}  // namespace

std::vector<Parameter> rod_parameters() {
  return records_of(
      {rod_shape_parameters(), rod_load_parameters(), name_keys, velocity_keys, rod_step, thread_keys});
}

RodScene::RodScene(Request const& request, std::vector<Method> const& methods) {
  SceneFile const& file = request.file;
  if (!file.section("system").has("rod"))
    throw SceneError(file.section("system").place(), "[system.rod] is needed: length, elements and section");
  options.unshearable = read_unshearable(file);
  SharedNames shared(file.section("system"), {"x", "y", "z", "s", "t"}, {});
  rest = read_rest_shape(file, shared, remarks);
  section = read_rod_section(file.section("system.rod"), options.unshearable);
  start.shape = read_start_shape(file, rest, shared, remarks);
  auto const acting = read_rod_loads(file, start.shape, rest.length, shared);
  loads = acting.loads;
  if (length_of(loads.gravity) > 0) features.insert(Feature::gravity);
  if (acting.held) features.insert(Feature::held_end);
  if (acting.moved) features.insert(Feature::moved_end);
  if (acting.loaded) features.insert(Feature::end_load);
  read_velocities(file, shared);
  shared.require_used("formulas of the rod");
  read_method(file.section("method"), methods);
  read_steps(request);
  hold_ends();
}

void RodScene::read_velocities(SceneFile const& file, SharedNames& shared) {
  SceneTable initial = file.section("initial");
  std::vector<std::string> const names{"x", "y", "z", "s"}, zero(3, "0");
  for (char const* const key : {"velocity", "angular_velocity"})
    if (!initial.has(key)) initial.set(key, zero);
  RodFormulas const velocity(initial, "velocity", names, shared),
      turning(initial, "angular_velocity", names, shared);
  for (std::size_t k = 0; k < start.shape.sections(); ++k) {
    auto const& x = start.shape.places[k];
    double const at[] = {x[0], x[1], x[2], rest.distances[k]};
    start.velocity.push_back(velocity(at));
    start.angular_velocity.push_back(bodies::turned_back(start.shape.attitudes[k], turning(at)));
  }
}

void RodScene::read_steps(Request const& request) {
  SceneTable const method = request.file.section("method");
  options.threads = thread_keys.threads.read(method);
  auto const waves = waves_of(section, rest.shape);
  auto const fastest = waves.fastest(options.unshearable);
  longest_step = 2 / fastest.omega;
  options.step = read_step(method, request.schedule, 1 / longest_step, 0.5);
  if (!(options.step <= longest_step)) {
    double const otherwise = options.unshearable ? 0 : 2 / waves.fastest(true).omega;
    fail_for_long_step(
        method, request.schedule, StepTooLong("rod", options.step, longest_step),
        fmt::format("steps of {} are not stable, bound by waves of {}{}", options.step, fastest.what,
                    otherwise > 3 * longest_step
                        ? fmt::format("; with constraint = \"unshearable\" those up to {:.3g} are", otherwise)
                        : ""));
  }
}

void RodScene::hold_ends() {
  auto const hold = [this](rods::RodEnd const& end, std::size_t k, char const* name) {
    if (end.held == rods::RodEnd::Held::free) return;
    double const h = options.step;
    auto const& shape = start.shape;
    rods::Placement const here{shape.places[k], shape.attitudes[k]}, next = end.motion ? end.motion(h) : here;
    auto const put = [&](Vector& to, Vector const& by, char const* what) {
      Vector const off = rods::plus_times(to, -1.0, by);
      if (length_of(off) > 1e-9 * length_of(to) && length_of(to) > 0 && !end.motion)
        remarks.push_back(
            fmt::format("initial.{}: the {} of the rod is held, and begins as its support does, "
                        "not with {:.3g}",
                        what, name, length_of(to)));
      to = by;
    };
    put(start.velocity[k], rods::times(1 / h, rods::plus_times(next.place, -1.0, here.place)), "velocity");
    if (end.held != rods::RodEnd::Held::clamped) return;
    auto const e = bodies::compose(rods::inverse_turn(here.attitude), next.attitude);
    double const sign = e[0] < 0 ? -2 : 2;
    put(start.angular_velocity[k], {sign * e[1] / h, sign * e[2] / h, sign * e[3] / h}, "angular_velocity");
  };
  if (start.shape.closed) return;
  hold(loads.start, 0, "start"), hold(loads.end, start.shape.sections() - 1, "end");
}

rods::Rod RodScene::with_step(double step) const {
  auto with = options;
  with.step = step;
  return {section, rest.shape, start, loads, with};
}

}  // namespace actio::scene
