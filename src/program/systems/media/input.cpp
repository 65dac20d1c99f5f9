#include "program/systems/media/input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actio/meshes/body_mesh_check.hpp"
#include "actio/meshes/body_shapes.hpp"
#include "actio/meshes/gmsh_mesh.hpp"
#include "actio/numbers/nearest_name.hpp"

namespace actio::scene {
namespace {

/// Numbers of cells, each 1 or more.
std::vector<int> read_cells(SceneTable const& mesh, std::size_t count) {
  auto const numbers = mesh.numbers("cells", static_cast<long>(count));
  std::vector<int> out;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (!(numbers[k] >= 1 && numbers[k] <= 1e9) || numbers[k] != std::floor(numbers[k]))
      throw SceneError(
          mesh.place("cells", k),
          fmt::format("cells: a whole number from 1 to 1000000000 is expected, found {}", numbers[k]));
    out.push_back(static_cast<int>(numbers[k]));
  }
  return out;
}

/// Refuses cells that are so thin that what strains along them store is rounding of what those across do.
void require_no_needles(SceneTable const& mesh, MediumMesh const& box) {
  std::size_t thin = 0, wide = 0;
  auto const edge = [&](std::size_t k) { return (box.upper[k] - box.lower[k]) / box.cells[k]; };
  for (std::size_t k = 0; k < box.cells.size(); ++k) {
    if (!(edge(k) <= edge(wide))) wide = k;
    if (edge(k) < edge(thin)) thin = k;
  }
  // Energies have the square of the ratio, and doubles have 2^53.
  if (double const ratio = edge(wide) / edge(thin); !(ratio <= 1e8))
    mesh.fail("cells", fmt::format("cells: the longest edge of a cell over the shortest, of {} along {} "
                                   "over {} along {}, measured {}, bound 1e8",
                                   edge(wide), axes()[wide], edge(thin), axes()[thin], ratio));
}

void read_box(SceneTable& mesh, MediumMesh& out) {
  mesh.allow({"shape", "lower", "upper", "cells", "periodic"});
  out.lower = mesh.numbers("lower");
  std::size_t const d = out.lower.size();
  if (d < 1 || d > 3)
    mesh.fail("lower", fmt::format("lower: one to three numbers are expected, as many as "
                                   "the body has dimensions, found {}",
                                   d));
  out.dimension = static_cast<int>(d);
  out.upper = mesh.numbers("upper", static_cast<long>(d));
  out.cells = read_cells(mesh, d);
  if (!mesh.has("periodic")) mesh.set("periodic", std::vector<bool>(d, false));
  out.periodic = mesh.booleans("periodic", static_cast<long>(d));
  for (std::size_t k = 0; k < d; ++k) {
    if (!(out.upper[k] > out.lower[k]))
      throw SceneError(
          mesh.place("upper", k),
          fmt::format("upper: a number greater than {} is expected, found {}", out.lower[k], out.upper[k]));
    if (out.periodic[k] && out.cells[k] < 2)
      throw SceneError(
          mesh.place("cells", k),
          fmt::format("cells: along a periodic direction there are at least 2, found {}", out.cells[k]));
  }
  require_no_needles(mesh, out);
}

void read_round(SceneTable& mesh, MediumMesh& out) {
  bool const hollow = out.shape == "annulus" || out.shape == "shell";
  out.dimension = out.shape == "disc" || out.shape == "annulus" ? 2 : 3;
  mesh.allow(hollow ? std::vector<std::string>{"shape", "inner", "outer", "cells"}
                    : std::vector<std::string>{"shape", "radius", "cells"});
  out.outer = mesh.positive(hollow ? "outer" : "radius");
  if (hollow) out.inner = mesh.positive("inner");
  if (hollow && !(out.inner < out.outer))
    mesh.fail("inner", fmt::format("inner: a radius less than outer = {} is expected, found {}", out.outer,
                                   out.inner));
  out.cells = read_cells(mesh, 2);
  if (out.shape == "annulus" && out.cells[1] < 3)
    throw SceneError(mesh.place("cells", 1),
                     fmt::format("cells: around an annulus there are at least 3, found {}", out.cells[1]));
}

/// Makes a side of a group of facets inside of a body, if there is one with this name.
/// @param key  of the table, where the name stands
void use_group(SceneTable const& table, std::string const& key, std::string const& name, bool pressure,
               media::BodyMesh& body) {
  if (auto const none = body.no_sides.find(name); none != body.no_sides.end())
    table.fail(key, fmt::format("{}: the group '{}' of the mesh is no side of the body: {}", table.name(),
                                shown(name), none->second));
  auto const inside = body.inside.find(name);
  if (inside == body.inside.end()) return;
  if (pressure)
    table.fail(key,
               fmt::format("{}: a pressure acts on a side of the body, and the group '{}' of the mesh lies "
                           "inside; it can be fixed, moved or drawn by a traction",
                           table.name(), shown(name)));
  body.sides.insert(body.inside.extract(inside));
}
/// Groups inside of a body are left, but for those that the scene names.
void use_groups(SceneFile const& scene, media::BodyMesh& body) {
  SceneTable const boundary = medium_keys.boundary.table(scene), load = medium_keys.load.table(scene),
                   loops = medium_keys.loops.table(scene);
  for (auto const& name : boundary.keys()) use_group(boundary, name, name, false, body);
  for (char const* kind : {"traction", "pressure", "motion"}) {
    if (!load.has(kind) || !load.is_table(kind)) continue;
    SceneTable const table = load.inside(kind);
    for (auto const& name : table.keys()) use_group(table, name, name, std::string(kind) == "pressure", body);
  }
  for (auto const& key : loops.keys())
    if (loops.is_text(key)) use_group(loops, key, loops.text(key), false, body);
}

void read_mesh_file(SceneFile const& scene, SceneTable& mesh, MediumMesh& out) {
  mesh.allow({"shape", "file"});
  auto const [path, text] = mesh.read_file("file", "a mesh of Gmsh");
  media::BodyMesh body;
  try {
    body = media::gmsh_mesh_of(text, path);
  } catch (Error const& error) {
    mesh.fail("file", std::string("file: ") + error.what());
  }
  use_groups(scene, body);
  out.read = std::make_shared<media::BodyMesh const>(std::move(body));
  out.dimension = out.read->dimension;
}

/// The names of the sides that are not periodic.
std::vector<std::string> side_names(MediumMesh const& mesh) {
  std::vector<std::string> out;
  if (mesh.read)
    for (auto const& [name, facets] : mesh.read->sides) out.push_back(name);
  else if (mesh.shape == "box")
    for (int k = 0; k < mesh.dimension; ++k)
      for (int end = 0; end < 2; ++end)
        if (!mesh.periodic[static_cast<std::size_t>(k)])
          out.emplace_back(actio::media::detail::side_names[k][end]);
  if (mesh.inner > 0) out.emplace_back("inner");
  if (mesh.outer > 0) out.emplace_back("outer");
  return out;
}

void read_sides(SceneFile const& file, MediumMesh& out) {
  auto const names = side_names(out);
  AnyKey const& boundary = medium_keys.boundary;
  SceneTable table = boundary.table(file);
  if (boundary.given(file) && !boundary.in(file).is_table("boundary"))
    boundary.fail(file,
                  fmt::format("a table of sides is expected, for example boundary.{} = \"fixed\", found {}",
                              names.empty() ? "left" : names.front(), boundary.in(file).found("boundary")));
  for (auto const& key : table.keys())
    if (std::find(names.begin(), names.end(), key) == names.end())
      table.fail(
          key, fmt::format("boundary: the body has no side '{}'{} (its sides: {})", shown(key),
                           did_you_mean(key, names), names.empty() ? "none, it is periodic" : listed(names)));
  // Those that a scene can ask for come first.
  std::vector<std::string> const words(media::names_of_sides.begin(), media::names_of_sides.begin() + 3);
  for (auto const& name : names) {
    if (!table.has(name)) table.set(name, words.front());
    std::string const does = table.choice(name, "condition of a side", words);
    out.sides[name] = static_cast<media::Side>(std::ranges::find(words, does) - words.begin());
  }
}

}  // namespace

double MediumMesh::cell_count() const {
  if (read) return static_cast<double>(read->cells.size());
  double count = 1;
  if (shape == "box") {
    for (int const n : cells) count *= n;
    return count;
  }
  double const across = cells[0], along = cells[1];
  if (shape == "annulus") return across * along;
  if (shape == "disc") return along * along + 4 * along * across;
  return 6 * along * along * across + (shape == "ball" ? along * along * along : 0);
}
double MediumMesh::node_count() const {
  if (read) return static_cast<double>(read->nodes.size());
  double count = 1;
  if (shape != "box") return cell_count() * 1.1 + 100;
  for (std::size_t k = 0; k < cells.size(); ++k) count *= cells[k] + !periodic[k];
  return count;
}

media::BodyMesh MediumMesh::make() const {
  if (read) return *read;
  if (shape == "box") return media::box_mesh(lower, upper, cells, periodic);
  std::array<int, 2> const n{cells[0], cells[1]};
  media::BodyMesh mesh = shape == "disc"      ? media::disc_mesh(outer, n)
                         : shape == "annulus" ? media::annulus_mesh(inner, outer, n)
                         : shape == "ball"    ? media::ball_mesh(outer, n)
                                              : media::shell_mesh(inner, outer, n);
  return mesh;
}

MediumMesh read_medium_mesh(SceneFile const& file) {
  std::vector<std::string> const shapes{"box", "disc", "annulus", "ball", "shell", "file"};
  SceneTable mesh = medium_keys.mesh.table(file);
  if (!mesh.has("shape")) {
    if (mesh.keys().empty())
      throw SceneError(file.section("system").place(),
                       fmt::format("[system.mesh] is needed, with a shape, one of {}", listed(shapes)));
    mesh.set("shape", mesh.has("file") ? "file" : "box");
  }
  MediumMesh out;
  out.shape = mesh.choice("shape", "shape", shapes);
  if (out.shape == "box")
    read_box(mesh, out);
  else if (out.shape == "file")
    read_mesh_file(file, mesh, out);
  else
    read_round(mesh, out);
  if (out.cell_count() > 1e9)
    mesh.fail("cells",
              fmt::format("cells: at most 1000000000 can be counted, these are {}", out.cell_count()));
  read_sides(file, out);
  return out;
}

std::string MediumKeys::euclidean(SceneTable const& system, std::string const& name) {
  if (system.is_text(name) && system.text(name) == "euclidean") return "euclidean";
  system.fail(name, "metric: media move in Euclidean space, \"euclidean\"; curved spaces are not there");
}

std::string MediumKeys::formula_or_positive(SceneTable system, std::string const& name) {
  if (!system.is_text(name)) system.set(name, fmt::format("{}", system.positive(name)));
  return system.text(name);
}

MediumStart read_medium_start(SceneFile const& file, int dimension) {
  auto const& [density, placement, velocity] =
      std::tie(medium_keys.density, medium_start_keys.placement, medium_start_keys.velocity);
  std::string const mass = density.read_or(file, "1");
  std::vector<std::string> const identity(axes().begin(), axes().begin() + dimension),
      rest(identity.size(), "0");
  MediumStart out{PlaceFormula(placement.in(file), placement.name(), identity),
                  PlaceFormula(velocity.in(file), velocity.name(), rest),
                  PlaceFormula(mass, dimension, density.in(file).text_place(density.name()))};
  out.uniform = out.density.is_constant();
  if (!out.uniform) return out;
  double rho = 0;
  out.density(std::array<double, 3>{}, &rho);
  if (!(rho > 0))
    density.fail(file, fmt::format("a positive mass per reference volume is expected, found {}", rho));
  return out;
}

}  // namespace actio::scene
