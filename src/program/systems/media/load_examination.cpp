#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "program/systems/media/examination.hpp"
#include "program/systems/media/points.hpp"

namespace actio::scene {
namespace {

/// Gravity and obstacle, in the order of the potentials.
template <int d>
std::vector<std::pair<SceneTable, std::string>> keys_of_potentials(SceneFile const& file) {
  std::vector<std::pair<SceneTable, std::string>> out;
  SceneTable const load = medium_keys.load.table(file), obstacle = medium_keys.obstacle.table(file);
  if (load.has("gravity")) out.emplace_back(load, "gravity");
  if (obstacle.has("potential")) out.emplace_back(obstacle, "potential");
  return out;
}

template <int d>
void examine_potentials(SceneFile const& file, MediumMesh const& mesh, media::BodyMesh const& body,
                        MediumLoads<d> const& loads, std::vector<PointOfBody<d>> const& places) {
  auto const keys = keys_of_potentials<d>(file);
  for (std::size_t p = 0; p < keys.size(); ++p) {
    auto const& [table, key] = keys[p];
    auto const& potential = loads.loads.potentials[p];
    double steepest = 0;
    for (std::size_t n = 0; n < places.size(); ++n) {
      PointOfBody<d> const g = potential.gradient(places[n]);
      if (!std::isfinite(potential.value(places[n])) || !std::isfinite(size_of(g)))
        table.fail(key,
                   fmt::format("{}: the potential and its gradient must be finite where the body "
                               "is; at x = {} they are {} and {}",
                               key, in_words(places[n]), std::abs(potential.value(places[n])), in_words(g)));
      steepest = std::max(steepest, size_of(g));
    }
    for (std::size_t k = 0; k < mesh.periodic.size(); ++k) {
      if (!mesh.periodic[k]) continue;
      for (std::size_t n = 0; n < places.size(); ++n) {
        if (body.nodes[n][k] != mesh.lower[k]) continue;
        PointOfBody<d> there = places[n];
        there[k] += mesh.upper[k] - mesh.lower[k];
        PointOfBody<d> const g = potential.gradient(places[n]), beyond = potential.gradient(there);
        if (distance(g, beyond) <= 1e-6 * steepest) continue;
        table.fail(
            key, fmt::format("{}: in a box that is periodic along {}, the potential is periodic along it "
                             "but for a constant; here its gradient is {} at x = {} and {} a period further",
                             key, "XYZ"[k], in_words(g), in_words(places[n]), in_words(beyond)));
      }
    }
  }
}

/// A force on a side that something else holds does nothing.
template <int d>
void examine_forces(SceneFile const& file, MediumMesh const& mesh, MediumLoads<d> const& loads) {
  using media::Side;
  auto const does = [&](std::string const& side) {
    auto const found = loads.sides.find(side);
    return found == loads.sides.end() ? Side::free : found->second.kind;
  };
  SceneTable const load = medium_keys.load.table(file);
  for (auto const& [side, traction] : loads.loads.tractions)
    if (Side const how = does(side); how == Side::fixed || how == Side::moved)
      load.inside("traction")
          .fail(side, fmt::format("traction: the side '{}' is {}, so that no force moves it; a traction "
                                  "acts on a side that is free or sliding",
                                  side, name_of(how)));
  for (auto const& [side, pressure] : loads.loads.pressures)
    if (Side const how = does(side); how != Side::free)
      load.inside("pressure")
          .fail(side, fmt::format("pressure: the side '{}' is {}, so that no pressure moves it; "
                                  "a pressure acts on a free side",
                                  side, name_of(how)));
  // What has no name on a mesh from a file is free as well.
  if (!load.has("pressure") || load.is_table("pressure") || mesh.read) return;
  for (auto const& entry : mesh.sides)
    if (does(entry.first) == Side::free) return;
  load.fail("pressure", "pressure: the body has no free side that a pressure from outside could move");
}

/// A node of sides that are held, as each of them has it.
template <int d>
struct Sided {
  std::string side;
  media::BodySide<d> const* does;
};

template <int d>
class MotionExamination {
 public:
  MotionExamination(SceneFile const& file, media::BodyMesh const& body, MediumLoads<d> const& loads,
                    ExaminedStart<d> const& start, double until)
      : motion_(medium_keys.load.table(file).inside("motion")), body_(body), start_(start), until_(until) {
    for (auto const& [name, side] : loads.sides) {
      if (side.kind != media::Side::moved && side.kind != media::Side::fixed) continue;
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
    for (auto const& [side, jump] : kicked_)
      out.push_back(
          fmt::format("motion.{} begins with another velocity than initial.velocity, by up to "
                      "{:.6g}: it pushes the body at t = 0",
                      side, jump));
    return out;
  }

 private:
  PointOfBody<d> reference(int node) const {
    PointOfBody<d> X;
    for (std::size_t a = 0; a < d; ++a) X[a] = body_.nodes[static_cast<std::size_t>(node)][a];
    return X;
  }
  PointOfBody<d> place(int node, Sided<d> const& one, double t) const {
    if (one.does->kind == media::Side::moved) return one.does->motion.place(reference(node), t);
    PointOfBody<d> x = start_.places[static_cast<std::size_t>(node)];
    for (std::size_t a = 0; a < d; ++a) x[a] += t * start_.velocities[static_cast<std::size_t>(node)][a];
    return x;
  }
  void begins(int node, Sided<d> const& one) {
    auto const n = static_cast<std::size_t>(node);
    if (one.does->kind == media::Side::fixed) return;
    PointOfBody<d> const X = reference(node), there = place(node, one, 0),
                         v = one.does->motion.velocity(X, 0);
    if (!std::isfinite(size_of(there)) || !std::isfinite(size_of(v)))
      motion_.fail(one.side, fmt::format("motion: a finite position and velocity are needed, "
                                         "and X = {} has {} and {} at t = 0",
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
    if (a.does->kind == media::Side::fixed && b.does->kind == media::Side::fixed) return;
    Sided<d> const& moved = a.does->kind == media::Side::moved ? a : b;
    Sided<d> const& other = a.does->kind == media::Side::moved ? b : a;
    for (double const t : {0.381966 * until_, until_}) {
      PointOfBody<d> const here = place(node, moved, t), there = place(node, other, t);
      if (distance(here, there) <= near_) continue;
      motion_.fail(
          moved.side,
          fmt::format("motion: the sides '{}' and '{}' share X = {}, and at t = {:.6g} the first has it at "
                      "{}, the second, which is {}, at {}",
                      moved.side, other.side, in_words(reference(node)), t, in_words(here),
                      name_of(other.does->kind), in_words(there)));
    }
  }

  SceneTable motion_;
  media::BodyMesh const& body_;
  ExaminedStart<d> const& start_;
  double until_, near_ = 0;
  std::map<int, std::vector<Sided<d>>> nodes_;
  std::map<std::string, double> kicked_;
};

}  // namespace

template <int d>
std::vector<std::string> examined_loads(SceneFile const& file, MediumMesh const& mesh,
                                        media::BodyMesh const& body, MediumLoads<d> const& loads,
                                        ExaminedStart<d> const& start, double until) {
  examine_forces<d>(file, mesh, loads);
  auto told = MotionExamination<d>(file, body, loads, start, until).run();
  examine_potentials<d>(file, mesh, body, loads, start.places);
  return told;
}

/// Along a line.
template std::vector<std::string> examined_loads<1>(SceneFile const&, MediumMesh const&,
                                                    media::BodyMesh const&, MediumLoads<1> const&,
                                                    ExaminedStart<1> const&, double);
/// In the plane.
template std::vector<std::string> examined_loads<2>(SceneFile const&, MediumMesh const&,
                                                    media::BodyMesh const&, MediumLoads<2> const&,
                                                    ExaminedStart<2> const&, double);
/// In space.
template std::vector<std::string> examined_loads<3>(SceneFile const&, MediumMesh const&,
                                                    media::BodyMesh const&, MediumLoads<3> const&,
                                                    ExaminedStart<3> const&, double);

}  // namespace actio::scene
