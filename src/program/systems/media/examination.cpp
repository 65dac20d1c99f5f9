#include "program/systems/media/examination.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "program/systems/media/points.hpp"

namespace actio::scene {
namespace {

/// In a periodic box what places differ from X by, and velocities, are the same beyond a period.
template <int d>
void require_periodic(SceneTable const& initial, std::string const& key, PlaceFormula const& formula,
                      PointOfBody<d> const& X, PointOfBody<d> const& here, MediumMesh const& mesh) {
  for (std::size_t k = 0; k < mesh.periodic.size(); ++k) {
    if (!mesh.periodic[k] || X[k] != mesh.lower[k]) continue;
    PointOfBody<d> beyond = X, there;
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

/// Which direction a side of a box is across, and at which end.
std::pair<std::size_t, int> side_of_box(std::string const& side) {
  for (std::size_t k = 0; k < 3; ++k)
    for (int const end : {0, 1})
      if (side == actio::media::detail::side_names[k][end]) return {k, end};
  throw std::logic_error("a box has no side " + side);
}

/// The unit vector across a side that is plane; zero where it is none, which is refused later.
template <int d>
PointOfBody<d> direction_across(MediumMesh const& mesh, std::string const& side) {
  PointOfBody<d> out{};
  if (mesh.shape == "box") {
    out[side_of_box(side).first] = 1;
    return out;
  }
  try {
    return media::plane_normal<d>(mesh.make(), side);
  } catch (media::NotABodyMesh const&) {
    return out;
  }
}

/// A density is finite and not negative: at the nodes as well, where snapshots show it.
template <int d>
void require_density(SceneFile const& file, MediumStart const& start, PointOfBody<d> const& X) {
  double rho = 0;
  try {
    start.density(X, &rho);
  } catch (SceneError const& error) {
    throw SceneError(error.place, std::string(error.what()).substr(printable(error.place.text()).size() + 2) +
                                      "; max(0, ...) keeps what rounding makes negative from a root");
  }
  if (!(rho >= 0))
    medium_keys.density.fail(
        file,
        fmt::format("a mass per reference volume is not negative, found {} at X = {}", rho, in_words(X)));
}

}  // namespace

template <int d>
ExaminedStart<d> examined_start(SceneFile const& file, MediumStart const& start, MediumCells<d> const& cells,
                                MediumMesh const& mesh) {
  SceneTable const initial = file.section("initial");
  ExaminedStart<d> out;
  out.places.reserve(cells.nodes()), out.velocities.reserve(cells.nodes());
  for (std::size_t k = 0; k < cells.nodes(); ++k) {
    auto const X = cells.reference(k);
    PointOfBody<d> place, rate;
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
std::vector<std::size_t> nodes_of_side(MediumMesh const& mesh, MediumCells<d> const& cells,
                                       std::string const& side) {
  std::vector<std::size_t> out;
  if (mesh.shape == "box") {
    auto const [k, end] = side_of_box(side);
    double const far = 1e-9 * (mesh.upper[k] - mesh.lower[k]),
                 wall = end == 0 ? mesh.lower[k] : mesh.upper[k];
    for (std::size_t n = 0; n < cells.nodes(); ++n)
      if (std::abs(cells.reference(n)[k] - wall) <= far) out.push_back(n);
    return out;
  }
  std::set<int> nodes;
  media::BodyMesh const made = mesh.read ? media::BodyMesh{} : mesh.make();
  for (auto const& facet : (mesh.read ? *mesh.read : made).sides.at(side))
    nodes.insert(facet.begin(), facet.end());
  for (int const n : nodes)
    if (n >= 0) out.push_back(static_cast<std::size_t>(n));
  return out;
}

template <int d>
std::map<std::string, double> driven_sides(MediumMesh const& mesh, MediumCells<d> const& cells,
                                           ExaminedStart<d> const& start) {
  std::map<std::string, double> out;
  for (auto const& [side, does] : mesh.sides) {
    if (does == media::Side::free) continue;
    auto const across = does == media::Side::sliding ? direction_across<d>(mesh, side) : PointOfBody<d>{};
    double fastest = 0, rounding = 0;
    for (std::size_t const n : nodes_of_side(mesh, cells, side)) {
      auto const& v = start.velocities[n];
      double along = 0;
      for (std::size_t a = 0; a < d; ++a) along += across[a] * v[a];
      fastest = std::max(fastest, does == media::Side::fixed ? size_of(v) : std::abs(along));
      // Across a side that is oblique a velocity along it has a rounding.
      if (does == media::Side::sliding) rounding = std::max(rounding, 1e-14 * size_of(v));
    }
    if (fastest > rounding) out[side] = fastest;
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

void require_finite_energies(SceneFile const& file, media::BodyEnergies const& energies) {
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
template ExaminedStart<1> examined_start<1>(SceneFile const&, MediumStart const&, MediumCells<1> const&,
                                            MediumMesh const&);
/// In the plane.
template ExaminedStart<2> examined_start<2>(SceneFile const&, MediumStart const&, MediumCells<2> const&,
                                            MediumMesh const&);
/// In space.
template ExaminedStart<3> examined_start<3>(SceneFile const&, MediumStart const&, MediumCells<3> const&,
                                            MediumMesh const&);
/// Along a line.
template std::map<std::string, double> driven_sides<1>(MediumMesh const&, MediumCells<1> const&,
                                                       ExaminedStart<1> const&);
/// In the plane.
template std::map<std::string, double> driven_sides<2>(MediumMesh const&, MediumCells<2> const&,
                                                       ExaminedStart<2> const&);
/// In space.
template std::map<std::string, double> driven_sides<3>(MediumMesh const&, MediumCells<3> const&,
                                                       ExaminedStart<3> const&);
/// Along a line.
template std::vector<std::size_t> nodes_of_side<1>(MediumMesh const&, MediumCells<1> const&,
                                                   std::string const&);
/// In the plane.
template std::vector<std::size_t> nodes_of_side<2>(MediumMesh const&, MediumCells<2> const&,
                                                   std::string const&);
/// In space.
template std::vector<std::size_t> nodes_of_side<3>(MediumMesh const&, MediumCells<3> const&,
                                                   std::string const&);

}  // namespace actio::scene
