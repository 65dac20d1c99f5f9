#include "program/systems/rods/load_input.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "program/systems/rods/formulas.hpp"

namespace actio::scene {
namespace {

using Held = rods::RodEnd::Held;
using Vector = rods::Three<double>;

std::string const forms = "\"free\", \"clamped\" or \"pinned\", or a table with place, axis and angle",
                  meaning =
                      " of the rod is held: a clamped end keeps its place and its attitude, and a pinned "
                      "one its place. An end that is moved is a table: place, three formulas in t; angle, "
                      "a formula in t, and axis, by which it is turned from its attitude at the start. "
                      "Without angle it is pinned to its place, without place only turned.";

struct BoundaryKeys : KeyTable {
  AnyKey start = key("start", forms, LeftOut{"\"free\""}, "How the start" + meaning, "\"clamped\"");
  AnyKey end = key("end", forms, LeftOut{"\"free\""}, "How the end" + meaning,
                   "{ place = [\"1\", \"0.1*sin(t)\", \"0\"] }");
} const boundary_keys{{"system.boundary", LeftOut{"both ends are free"}, "How the ends of the rod are held.",
                       "{ start = \"clamped\" }", "a table with start and end"}};

struct LoadKeys : KeyTable {
  Key<Eigen::Vector3d> gravity = key("gravity", vector.in("length/time^2"), LeftOut{"none"},
                                     "The acceleration by gravity.", "[0, 0, -9.81]");
  AnyKey start_force =
      key("start_force", "three texts, each a formula in t", LeftOut{"none"},
          "The force on the start of the rod; its place is free.", "[\"0\", \"t < 1 ? 2 : 0\", \"0\"]");
  AnyKey end_force = key("end_force", "three texts, each a formula in t", LeftOut{"none"},
                         "The force on the end of the rod; its place is free.", "[\"0\", \"0\", \"-0.1\"]");
  AnyKey start_moment =
      key("start_moment", "three texts, each a formula in t", LeftOut{"none"},
          "The moment on the start of the rod; its attitude is free.", "[\"0\", \"0\", \"0.1*sin(t)\"]");
  AnyKey end_moment =
      key("end_moment", "three texts, each a formula in t", LeftOut{"none"},
          "The moment on the end of the rod; its attitude is free.", "[\"0\", \"0\", \"0.1\"]");
  AnyKey frame =
      key("frame", "a text, or a table with force and moment", LeftOut{"\"space\""},
          "In which axes forces and moments are given: \"space\", or \"body\", those of the section they act "
          "on, so that they turn with it; for both, or for each.",
          "{ force = \"space\", moment = \"body\" }");
} const load_keys{{"system.load", LeftOut{"none"}, "What acts on the rod from outside.",
                   "{ gravity = [0, 0, -9.81] }", "a table"}};

/// The motion of an end at a key of [system.boundary].
rods::RodEnd moved_end(SceneTable const& boundary, AnyKey const& key, rods::Placement const& at,
                       double length, SharedNames& shared) {
  SceneTable const table = boundary.inside(key.name());
  table.allow({"place", "axis", "angle"});
  bool const placed = table.has("place"), turned = table.has("angle");
  if (!placed && !turned)
    key.fail(boundary, "place or angle is needed, and an end that stays is \"clamped\" or \"pinned\"");
  bool const whole = turned == table.has("axis");
  std::string const lonely = turned ? "angle" : "axis";
  if (!whole) table.fail(lonely, key.name() + ": axis and angle go together");
  std::shared_ptr<RodFormulas const> place, angle;
  std::vector<std::string> const time{"t"};
  if (placed) place = std::make_shared<RodFormulas>(table, "place", time, shared);
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  if (turned) {
    angle = std::make_shared<RodFormulas>(table, "angle", time, shared, 1);
    axis = table.vector("axis");
    if (!(axis.stableNorm() > 0)) table.fail("axis", "axis: a direction is expected, found one of length 0");
    axis = axis.stableNormalized();
  }
  double const zero = 0;
  if (place) {
    auto const x = (*place)({&zero, 1});
    double const gap = std::hypot(x[0] - at.place[0], x[1] - at.place[1], x[2] - at.place[2]);
    if (!(gap <= 1e-9 * length))
      table.fail("place",
                 fmt::format("place: at t = 0 it is ({}, {}, {}), and the {} of the rod is at ({}, {}, {}), "
                             "{:.6g} away; bound {:.3g}, 1e-9 of the length",
                             x[0], x[1], x[2], key.name(), at.place[0], at.place[1], at.place[2], gap,
                             1e-9 * length));
  }
  if (angle)
    if (double const first = (*angle)({&zero, 1})[0]; !(std::abs(first) <= 1e-9))
      table.fail("angle", fmt::format("angle: at t = 0 it is {}, and must be 0 to 1e-9: it is counted from "
                                      "the attitude at the start",
                                      first));
  rods::RodEnd out;
  out.held = turned ? Held::clamped : Held::pinned;
  out.motion = [=](double t) {
    rods::Placement now = at;
    if (place) now.place = (*place)({&t, 1});
    if (angle) {
      double const half = (*angle)({&t, 1})[0] / 2, s = std::sin(half);
      now.attitude = bodies::compose(
          rods::Four<double>{std::cos(half), s * axis[0], s * axis[1], s * axis[2]}, at.attitude);
    }
    return now;
  };
  return out;
}

rods::RodEnd read_end(SceneTable boundary, AnyKey const& key, rods::Placement const& at, double length,
                      SharedNames& shared) {
  if (!key.given(boundary)) boundary.set(key.name(), "free");
  if (boundary.is_table(key.name())) return moved_end(boundary, key, at, length, shared);
  std::string const how = boundary.choice(key.name(), "support", {"free", "clamped", "pinned"});
  rods::RodEnd out;
  out.held = how == "free" ? Held::free : how == "pinned" ? Held::pinned : Held::clamped;
  return out;
}

/// Whether forces, and whether moments, are in the axes of the section.
std::array<bool, 2> read_frames(SceneTable load) {
  if (!load_keys.frame.given(load)) load.set("frame", "space");
  std::vector<std::string> const frames{"space", "body"};
  if (!load.is_table("frame")) {
    bool const body = load.choice("frame", "frame", frames) == "body";
    return {body, body};
  }
  SceneTable table = load.inside("frame");
  table.allow({"force", "moment"});
  std::array<bool, 2> out;
  for (std::size_t k = 0; k < 2; ++k) {
    std::string const name = k == 0 ? "force" : "moment";
    if (!table.has(name)) table.set(name, "space");
    out[k] = table.choice(name, "frame", frames) == "body";
  }
  return out;
}

/// The load at a key, on what must not be held.
std::function<Vector(double)> read_load(SceneTable const& load, AnyKey const& key, bool held,
                                        std::string const& what, SharedNames& shared) {
  if (!key.given(load)) return nullptr;
  if (held) key.fail(load, "system.boundary holds the " + what + " there, so that no such load acts on it");
  auto const formulas =
      std::make_shared<RodFormulas>(load, key.name(), std::vector<std::string>{"t"}, shared);
  return [formulas](double t) { return (*formulas)({&t, 1}); };
}

}  // namespace

std::vector<Parameter> rod_load_parameters() { return records_of({boundary_keys, load_keys}); }

SceneRodLoads read_rod_loads(SceneFile const& file, rods::RodShape const& start, double length,
                             SharedNames& shared) {
  SceneRodLoads out;
  SceneTable const boundary = file.section("system.boundary"), load = file.section("system.load");
  if (start.closed) {
    for (auto const* const key : {&boundary_keys.start, &boundary_keys.end})
      if (key->given(boundary)) key->fail(boundary, "a ring has no ends to be held");
    for (auto const* const key : {&load_keys.start_force, &load_keys.end_force, &load_keys.start_moment,
                                  &load_keys.end_moment, &load_keys.frame})
      if (key->given(load)) key->fail(load, "a ring has no ends on which loads act");
  } else {
    out.loads.start = read_end(boundary, boundary_keys.start, {start.places.front(), start.attitudes.front()},
                               length, shared);
    out.loads.end =
        read_end(boundary, boundary_keys.end, {start.places.back(), start.attitudes.back()}, length, shared);
  }
  if (file.section("system").has("load")) {
    auto const gravity = load_keys.gravity.find(load).value_or(Eigen::Vector3d::Zero());
    out.loads.gravity = {gravity[0], gravity[1], gravity[2]};
    for (bool const last : {false, true}) {
      auto& end = last ? out.loads.end : out.loads.start;
      auto const& [force, moment] = last ? std::tie(load_keys.end_force, load_keys.end_moment)
                                         : std::tie(load_keys.start_force, load_keys.start_moment);
      end.force = read_load(load, force, end.held != Held::free, "place", shared);
      end.moment = read_load(load, moment, end.held == Held::clamped, "attitude", shared);
      out.loaded = out.loaded || end.force || end.moment;
    }
    if (out.loaded) {
      auto const [force, moment] = read_frames(load);
      for (auto* const end : {&out.loads.start, &out.loads.end})
        end->force_in_body = force, end->moment_in_body = moment;
    } else if (load_keys.frame.given(load)) {
      load_keys.frame.fail(load, "there is no force and no moment to be given in it");
    }
  }
  for (auto const* const end : {&out.loads.start, &out.loads.end})
    out.held = out.held || end->held != Held::free, out.moved = out.moved || end->motion;
  return out;
}

}  // namespace actio::scene
