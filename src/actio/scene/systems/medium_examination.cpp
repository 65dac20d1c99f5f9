#include "actio/scene/systems/medium_examination.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace actio::scene {
namespace {

template <int d>
using At = std::array<double, d>;

template <std::size_t d>
std::string in_words(std::array<double, d> const& x) {
  std::string out;
  for (double const one : x)
    out += fmt::format("{}{:.9g}", out.empty() ? "(" : ", ", std::isnan(one) ? std::abs(one) : one);
  return out + ")";
}
template <std::size_t d>
double distance(std::array<double, d> const& a, std::array<double, d> const& b) {
  double square = 0;
  for (std::size_t k = 0; k < d; ++k) square += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(square);
}
template <std::size_t d>
double size_of(std::array<double, d> const& a) {
  return distance(a, {});
}

/// In a periodic box what places differ from X by, and velocities, are the same beyond a period.
template <int d>
void require_periodic(SceneTable const& initial, std::string const& key, PlaceFormula& formula,
                      At<d> const& X, At<d> const& here, MediumMesh const& mesh) {
  for (std::size_t k = 0; k < mesh.periodic.size(); ++k) {
    if (!mesh.periodic[k] || X[k] != mesh.lower[k]) continue;
    At<d> beyond = X, there;
    beyond[k] = mesh.upper[k];
    formula(beyond, there.data());
    double const period = mesh.upper[k] - mesh.lower[k];
    for (std::size_t a = 0; a < d; ++a) {
      double const jump = there[a] - here[a] - (a == k && key == "placement" ? period : 0);
      if (std::abs(jump) > 1e-9 * (period + std::abs(here[a])))
        throw SceneError(
            initial.place(key, a),
            fmt::format("{}: in a box that is periodic along {}, {} is periodic along it; here it "
                        "jumps by {} from {} = {} to {}",
                        key, "XYZ"[k], key == "placement" ? "placement minus the identity" : "the velocity",
                        jump, "XYZ"[k], mesh.lower[k], mesh.upper[k]));
    }
  }
}

/// A density is finite and not negative: at the nodes as well, where snapshots show it.
template <int d>
void require_density(SceneFile const& file, MediumStart& start, At<d> const& X) {
  double rho = 0;
  try {
    start.density(X, &rho);
  } catch (SceneError const& error) {
    throw SceneError(error.place, std::string(error.what()).substr(printable(error.place.text()).size() + 2) +
                                      "; max(0, ...) keeps what rounding makes negative from a root");
  }
  if (!(rho >= 0))
    file.section("system").fail(
        "density", fmt::format("density: a mass per reference volume is not negative, found {} at X = {}",
                               rho, in_words(X)));
}

/// Gravity and obstacle, in the order of the potentials.
template <int d>
std::vector<std::pair<SceneTable, std::string>> keys_of_potentials(SceneFile const& file) {
  std::vector<std::pair<SceneTable, std::string>> out;
  SceneTable const load = file.section("system.load"), obstacle = file.section("system.obstacle");
  if (load.has("gravity")) out.emplace_back(load, "gravity");
  if (obstacle.has("potential")) out.emplace_back(obstacle, "potential");
  return out;
}

template <int d>
void examine_potentials(SceneFile const& file, MediumMesh const& mesh, BodyMesh const& body,
                        MediumLoads<d> const& loads, std::vector<At<d>> const& places) {
  auto const keys = keys_of_potentials<d>(file);
  for (std::size_t p = 0; p < keys.size(); ++p) {
    auto const& [table, key] = keys[p];
    auto const& potential = loads.loads.potentials[p];
    double steepest = 0;
    for (std::size_t n = 0; n < places.size(); ++n) {
      At<d> const g = potential.gradient(places[n]);
      if (!std::isfinite(potential.value(places[n])) || !std::isfinite(size_of(g)))
        table.fail(
            key, fmt::format("{}: the potential and its gradient must be finite where the body is; at x = {} "
                             "they are {} and {}",
                             key, in_words(places[n]), std::abs(potential.value(places[n])), in_words(g)));
      steepest = std::max(steepest, size_of(g));
    }
    for (std::size_t k = 0; k < mesh.periodic.size(); ++k) {
      if (!mesh.periodic[k]) continue;
      for (std::size_t n = 0; n < places.size(); ++n) {
        if (body.nodes[n][k] != mesh.lower[k]) continue;
        At<d> there = places[n];
        there[k] += mesh.upper[k] - mesh.lower[k];
        At<d> const g = potential.gradient(places[n]), beyond = potential.gradient(there);
        if (distance(g, beyond) <= 1e-6 * steepest) continue;
        table.fail(
            key, fmt::format("{}: in a box that is periodic along {}, the potential is periodic along it but "
                             "for a constant; here its gradient is {} at x = {} and {} a period further",
                             key, "XYZ"[k], in_words(g), in_words(places[n]), in_words(beyond)));
      }
    }
  }
}

/// A force on a side that something else holds does nothing.
template <int d>
void examine_forces(SceneFile const& file, MediumMesh const& mesh, MediumLoads<d> const& loads) {
  using Kind = typename BodySide<d>::Kind;
  auto const held = [&](std::string const& side) -> std::string {
    auto const found = loads.sides.find(side);
    if (found == loads.sides.end() || found->second.kind == Kind::free) return "";
    return found->second.kind == Kind::moved   ? "moved"
           : found->second.kind == Kind::fixed ? "fixed"
                                               : "sliding";
  };
  SceneTable const load = file.section("system.load");
  for (auto const& [side, traction] : loads.loads.tractions)
    if (std::string const how = held(side); how == "fixed" || how == "moved")
      load.inside("traction")
          .fail(side, fmt::format("traction: the side '{}' is {}, so that no force moves it; "
                                  "a traction acts on a side that is free or sliding",
                                  side, how));
  for (auto const& [side, pressure] : loads.loads.pressures)
    if (std::string const how = held(side); !how.empty())
      load.inside("pressure")
          .fail(side, fmt::format("pressure: the side '{}' is {}, so that no pressure moves it; "
                                  "a pressure acts on a free side",
                                  side, how));
  if (!load.has("pressure") || load.is_table("pressure")) return;
  for (auto const& [side, does] : mesh.sides)
    if (held(side).empty()) return;
  load.fail("pressure", "pressure: the body has no free side that a pressure from outside could move");
}

/// A node of sides that are held, as each of them has it.
template <int d>
struct Sided {
  std::string side;
  BodySide<d> const* does;
};

std::string drifting(std::string const& side, double speed) {
  return fmt::format("side {} is fixed to the velocity that it has at the start, up to {:.6g}", side, speed);
}

template <int d>
class MotionExamination {
 public:
  using Kind = typename BodySide<d>::Kind;
  MotionExamination(SceneFile const& file, BodyMesh const& body, MediumLoads<d> const& loads,
                    ExaminedStart<d> const& start, double until)
      : motion_(file.section("system.load").has("motion") ? file.section("system.load").inside("motion")
                                                          : file.section("system.load")),
        body_(body),
        start_(start),
        until_(until) {
    for (auto const& [name, side] : loads.sides) {
      if (side.kind != Kind::moved && side.kind != Kind::fixed) continue;
      for (auto const& facet : body.sides.at(name))
        for (int const node : facet)
          if (node >= 0 && (nodes_[node].empty() || nodes_[node].back().side != name))
            nodes_[node].push_back({name, &side});
    }
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (auto const& x : start.places)
      for (double const one : x) low = std::min(low, one), high = std::max(high, one);
    near_ = 1e-9 * (high - low);
  }

  std::vector<std::string> run() {
    for (auto const& [node, sides] : nodes_) {
      for (auto const& one : sides) begins(node, one);
      for (std::size_t k = 1; k < sides.size(); ++k) agree(node, sides[0], sides[k]);
    }
    std::vector<std::string> out;
    for (auto const& [side, speed] : drifting_) out.push_back(drifting(side, speed));
    for (auto const& [side, jump] : kicked_)
      out.push_back(
          fmt::format("motion.{} begins with another velocity than initial.velocity, by up to {:.6g}: it "
                      "pushes the body at t = 0",
                      side, jump));
    return out;
  }

 private:
  At<d> reference(int node) const {
    At<d> X;
    for (std::size_t a = 0; a < d; ++a) X[a] = body_.nodes[static_cast<std::size_t>(node)][a];
    return X;
  }
  At<d> place(int node, Sided<d> const& one, double t) const {
    if (one.does->kind == Kind::moved) return one.does->motion.place(reference(node), t);
    At<d> x = start_.places[static_cast<std::size_t>(node)];
    for (std::size_t a = 0; a < d; ++a) x[a] += t * start_.velocities[static_cast<std::size_t>(node)][a];
    return x;
  }
  void begins(int node, Sided<d> const& one) {
    auto const n = static_cast<std::size_t>(node);
    if (one.does->kind == Kind::fixed) {
      double& fastest = drifting_[one.side];
      fastest = std::max(fastest, size_of(start_.velocities[n]));
      if (fastest == 0) drifting_.erase(one.side);
      return;
    }
    At<d> const X = reference(node), there = place(node, one, 0), v = one.does->motion.velocity(X, 0);
    if (!std::isfinite(size_of(there)) || !std::isfinite(size_of(v)))
      motion_.fail(one.side,
                   fmt::format("motion: a finite place and velocity are needed, and X = {} has {} and {} at "
                               "t = 0",
                               in_words(X), in_words(there), in_words(v)));
    if (distance(there, start_.places[n]) > near_)
      motion_.fail(one.side,
                   fmt::format("motion: at t = 0 it has X = {} at {}, and initial.placement has it at {}",
                               in_words(X), in_words(there), in_words(start_.places[n])));
    double const jump = distance(v, start_.velocities[n]);
    if (jump > 1e-9 * size_of(v)) kicked_[one.side] = std::max(kicked_[one.side], jump);
  }
  /// Two sides that hold a node hold it at one place, at the end and on the way there.
  void agree(int node, Sided<d> const& a, Sided<d> const& b) const {
    if (a.does->kind == Kind::fixed && b.does->kind == Kind::fixed) return;
    Sided<d> const& moved = a.does->kind == Kind::moved ? a : b;
    Sided<d> const& other = a.does->kind == Kind::moved ? b : a;
    for (double const t : {0.381966 * until_, until_}) {
      At<d> const here = place(node, moved, t), there = place(node, other, t);
      if (distance(here, there) <= near_) continue;
      motion_.fail(
          moved.side,
          fmt::format("motion: the sides '{}' and '{}' share X = {}, and at t = {:.6g} the first has it "
                      "at {}, the second, which is {}, at {}",
                      moved.side, other.side, in_words(reference(node)), t, in_words(here),
                      other.does->kind == Kind::moved ? "moved" : "fixed", in_words(there)));
    }
  }

  SceneTable motion_;
  BodyMesh const& body_;
  ExaminedStart<d> const& start_;
  double until_, near_ = 0;
  std::map<int, std::vector<Sided<d>>> nodes_;
  std::map<std::string, double> drifting_, kicked_;
};

}  // namespace

template <int d>
ExaminedStart<d> examined_start(SceneFile const& file, MediumStart& start, MediumCells<d> const& cells,
                                MediumMesh const& mesh) {
  SceneTable const initial = file.section("initial");
  ExaminedStart<d> out;
  out.places.reserve(cells.nodes()), out.velocities.reserve(cells.nodes());
  for (std::size_t k = 0; k < cells.nodes(); ++k) {
    auto const X = cells.reference(k);
    At<d> place, rate;
    start.placement(X, place.data()), start.velocity(X, rate.data());
    require_periodic<d>(initial, "placement", start.placement, X, place, mesh);
    require_periodic<d>(initial, "velocity", start.velocity, X, rate, mesh);
    if (!start.uniform) require_density<d>(file, start, X);
    out.places.push_back(place), out.velocities.push_back(rate);
  }
  auto const [least, cell] = least_jacobian(cells, out.places);
  if (!(least > 0)) {
    auto const X = cells.reference(static_cast<std::size_t>(cells.cell(cell).nodes[0]));
    initial.fail("placement",
                 fmt::format("placement: the Jacobian must be positive, and it is {} in {} at X = {}",
                             std::isnan(least) ? std::abs(least) : least, cells.name(cell), in_words(X)));
  }
  return out;
}

template <int d>
std::vector<std::string> examined_loads(SceneFile const& file, MediumMesh const& mesh, BodyMesh const& body,
                                        MediumLoads<d> const& loads, ExaminedStart<d> const& start,
                                        double until) {
  examine_forces<d>(file, mesh, loads);
  auto told = MotionExamination<d>(file, body, loads, start, until).run();
  examine_potentials<d>(file, mesh, body, loads, start.places);
  return told;
}

template <int d>
std::vector<std::string> drifting_sides(MediumMesh const& box, MediumCells<d> const& cells,
                                        ExaminedStart<d> const& start) {
  std::vector<std::string> out;
  for (std::size_t k = 0; k < d; ++k)
    for (int end = 0; end < 2; ++end) {
      std::string const name = actio::detail::side_names[k][end];
      if (box.periodic[k] || box.sides.at(name) != "fixed") continue;
      double const far = 1e-9 * (box.upper[k] - box.lower[k]), wall = end == 0 ? box.lower[k] : box.upper[k];
      double fastest = 0;
      for (std::size_t n = 0; n < cells.nodes(); ++n)
        if (std::abs(cells.reference(n)[k] - wall) <= far)
          fastest = std::max(fastest, size_of(start.velocities[n]));
      if (fastest > 0) out.push_back(drifting(name, fastest));
    }
  return out;
}

void require_reachable_end(SceneFile const& file, double longest, double until) {
  double const steps = until / longest;
  if (steps < 9007199254740992) return;
  bool const loaded = has_loads(file);
  file.section("system").fail(
      loaded && file.section("system").has("load") ? "load" : "material",
      fmt::format("the longest stable step is {:.3g}, and {:.3g} of them are until = {}, where 2^53 are "
                  "possible: the moduli{} are too large for the density, the cells and the time",
                  longest, steps, until, loaded ? " or the loads" : ""));
}

void require_finite_energies(SceneFile const& file, BodyEnergies const& energies) {
  if (std::isfinite(energies.total())) return;
  // Forces that are none make velocities that are none: what is stored comes first.
  bool const stored = !std::isfinite(energies.stored) || std::isnan(energies.kinetic),
             loaded = !stored && !std::isfinite(energies.loads);
  std::string const key = stored ? "placement" : loaded ? "load" : "velocity";
  double const found = stored ? energies.total() : loaded ? energies.loads : energies.kinetic;
  file.section(loaded ? "system" : "initial")
      .fail(key,
            fmt::format("{}: the {} energy at the start is {}, where a number up to 1.8e308 is needed", key,
                        stored   ? "stored"
                        : loaded ? "loads'"
                                 : "kinetic",
                        std::isnan(found) ? std::abs(found) : found));
}

/// Along a line.
template ExaminedStart<1> examined_start<1>(SceneFile const&, MediumStart&, MediumCells<1> const&,
                                            MediumMesh const&);
/// In the plane.
template ExaminedStart<2> examined_start<2>(SceneFile const&, MediumStart&, MediumCells<2> const&,
                                            MediumMesh const&);
/// In space.
template ExaminedStart<3> examined_start<3>(SceneFile const&, MediumStart&, MediumCells<3> const&,
                                            MediumMesh const&);
/// In the plane.
template std::vector<std::string> drifting_sides<2>(MediumMesh const&, MediumCells<2> const&,
                                                    ExaminedStart<2> const&);
/// In space.
template std::vector<std::string> drifting_sides<3>(MediumMesh const&, MediumCells<3> const&,
                                                    ExaminedStart<3> const&);
/// Along a line.
template std::vector<std::string> examined_loads<1>(SceneFile const&, MediumMesh const&, BodyMesh const&,
                                                    MediumLoads<1> const&, ExaminedStart<1> const&, double);
/// In the plane.
template std::vector<std::string> examined_loads<2>(SceneFile const&, MediumMesh const&, BodyMesh const&,
                                                    MediumLoads<2> const&, ExaminedStart<2> const&, double);
/// In space.
template std::vector<std::string> examined_loads<3>(SceneFile const&, MediumMesh const&, BodyMesh const&,
                                                    MediumLoads<3> const&, ExaminedStart<3> const&, double);

}  // namespace actio::scene
