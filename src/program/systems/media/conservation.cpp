#include "program/systems/media/conservation.hpp"

#include <algorithm>
#include <cmath>

#include "program/systems/media/examination.hpp"

namespace actio::scene {
namespace {

/// Whether a potential grows along the way once around the box that a loop goes.
template <int d>
bool grows_around(media::SpacePotential<d> const& potential, MaterialLoop<d> const& loop,
                  std::vector<std::array<double, d>> const& x) {
  auto const& begin = loop.stops.front();
  auto const& end = loop.stops.back();
  auto from = x[begin.node], to = x[end.node];
  double way = 0;
  for (int a = 0; a < d; ++a)
    from[a] += begin.beyond[a], to[a] += end.beyond[a], way = std::max(way, std::abs(to[a] - from[a]));
  if (way == 0) return false;
  double const before = potential.value(from), after = potential.value(to);
  double steepest = 0;
  for (double const one : potential.gradient(from)) steepest = std::max(steepest, std::abs(one));
  return std::abs(after - before) > 1e-9 * (std::abs(before) + std::abs(after) + steepest * way);
}

}  // namespace

template <int d>
std::set<Feature> features_of(SceneFile const& file, MediumMesh const& mesh, MediumLoads<d> const& loads,
                              Material const& material, bool uniform) {
  using enum Feature;
  std::set<Feature> out;
  for (auto const& [name, side] : loads.sides) {
    if (side.kind != media::Side::free) out.insert(held_side);
    if (side.kind == media::Side::moved) out.insert(moved_side);
  }
  if (std::ranges::find(mesh.periodic, true) != mesh.periodic.end()) out.insert(periodic_box);
  if (!loads.loads.potentials.empty()) out.insert(potential);
  if (!loads.loads.tractions.empty()) out.insert(traction);
  if (!loads.loads.pressures.empty()) out.insert(pressure_on_a_side);
  if (file.section("method").has("viscosity")) out.insert(viscosity);
  if (!uniform && !pressure_is_of_density(material)) out.insert(pressure_of_the_jacobian);
  return out;
}

template <int d>
std::set<Feature> features_of_loops(MediumMesh const& mesh, MediumCells<d> const& cells,
                                    MediumLoads<d> const& loads, std::vector<MaterialLoop<d>> const& loops,
                                    std::vector<std::array<double, d>> const& x) {
  std::set<std::size_t> fixed, forced;
  for (auto const& [side, does] : mesh.sides) {
    bool const force = loads.loads.tractions.contains(side) || loads.loads.pressures.contains(side),
               moved = loads.sides.contains(side) && loads.sides.at(side).kind == media::Side::moved;
    if (force || moved || does == media::Side::fixed)
      for (std::size_t const node : nodes_of_side(mesh, cells, side))
        (does == media::Side::fixed ? fixed : forced).insert(node);
  }
  std::set<Feature> out;
  for (auto const& loop : loops) {
    auto const among = [&loop](std::set<std::size_t> const& nodes) {
      return std::ranges::count_if(loop.stops, [&](auto const& at) { return nodes.contains(at.node); });
    };
    auto const all = static_cast<std::ptrdiff_t>(loop.stops.size());
    if (among(forced) > 0 || (among(fixed) > 0 && among(fixed) < all)) out.insert(Feature::loop_at_a_side);
    for (auto const& potential : loads.loads.potentials)
      if (grows_around<d>(potential, loop, x)) out.insert(Feature::potential_around_a_loop);
  }
  return out;
}

/// Along a line.
template std::set<Feature> features_of<1>(SceneFile const&, MediumMesh const&, MediumLoads<1> const&,
                                          Material const&, bool);
/// In the plane.
template std::set<Feature> features_of<2>(SceneFile const&, MediumMesh const&, MediumLoads<2> const&,
                                          Material const&, bool);
/// In space.
template std::set<Feature> features_of<3>(SceneFile const&, MediumMesh const&, MediumLoads<3> const&,
                                          Material const&, bool);
/// Along a line.
template std::set<Feature> features_of_loops<1>(MediumMesh const&, MediumCells<1> const&,
                                                MediumLoads<1> const&, std::vector<MaterialLoop<1>> const&,
                                                std::vector<std::array<double, 1>> const&);
/// In the plane.
template std::set<Feature> features_of_loops<2>(MediumMesh const&, MediumCells<2> const&,
                                                MediumLoads<2> const&, std::vector<MaterialLoop<2>> const&,
                                                std::vector<std::array<double, 2>> const&);
/// In space.
template std::set<Feature> features_of_loops<3>(MediumMesh const&, MediumCells<3> const&,
                                                MediumLoads<3> const&, std::vector<MaterialLoop<3>> const&,
                                                std::vector<std::array<double, 3>> const&);

}  // namespace actio::scene
