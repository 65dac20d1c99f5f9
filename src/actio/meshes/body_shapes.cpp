#include "actio/meshes/body_shapes.hpp"

namespace actio::media {

namespace detail {
namespace {

/// Refuses radii that do not increase from zero, and cells that are too few.
void require_round(char const* what, double inner, double outer, std::array<int, 2> const& cells,
                   int least_along) {
  if (!is_finite(inner) || !is_finite(outer)) throw NotFinite(what);
  if (!(inner >= 0)) throw NotABodyMesh(what, "the inner radius is positive; radius", inner, 0);
  if (!(outer > inner))
    throw NotABodyMesh(what, "the outer radius is above the inner one; radius", outer, inner);
  if (cells[0] < 1) throw NotABodyMesh(what, "there are cells across; cells", cells[0], 1);
  if (cells[1] < least_along)
    throw NotABodyMesh(what, "there are cells enough along; cells", cells[1], least_along);
}

/// The direction from the centre through a point of the surface of the cube \f$[-1, 1]^d\f$, a unit vector:
/// equal steps on an edge of the square see equal angles.
std::array<double, 3> direction_through(int d, std::array<double, 3> const& u) {
  std::array<double, 3> out{};
  double square = 0;
  for (int k = 0; k < d; ++k) {
    out[k] = std::abs(u[k]) == 1 ? u[k] : std::tan(std::atan(1.0) * u[k]);
    square += out[k] * out[k];
  }
  for (int k = 0; k < d; ++k) out[k] /= std::sqrt(square);
  return out;
}

/// The image of a point of the cube \f$[-1, 1]^d\f$ in the core of a disc or a ball of radius 1: half as
/// large, and with edges and corners drawn in half as far as a map onto the round body would draw them.
std::array<double, 3> in_core(int d, std::array<double, 3> const& u) {
  std::array<double, 3> out{};
  for (int k = 0; k < d; ++k) {
    double const p = u[(k + 1) % d] * u[(k + 1) % d], q = d < 3 ? 0 : u[(k + 2) % d] * u[(k + 2) % d];
    out[k] = 0.5 * u[k] * std::sqrt(1 - 0.5 * (p / 2 + q / 2 - p * q / 3));
  }
  return out;
}

}  // namespace

LayersOnCube::LayersOnCube(int d, std::array<int, 2> const& cells, bool with_core)
    : d_(d), layers_(cells[0]), core_(with_core), grid_{d, {cells[1], cells[1], d > 2 ? cells[1] : 1}} {
  grid_.examine();
  surface_.assign(std::size_t(grid_.nodes(0)) * grid_.nodes(1) * grid_.nodes(2), -1);
  for_lattice(grid_.nodes(0), [&](std::array<int, 3> const& at) {
    for (int k = 0; k < d_; ++k)
      if (at[k] == 0 || at[k] == grid_.cells[k]) {
        surface_[grid_.node(at)] = on_surface_++;
        break;
      }
  });
  double const nodes = double(surface_.size()) + double(layers_ + 1) * on_surface_;
  double const most = std::numeric_limits<int>::max();
  if (nodes > most) throw NotABodyMesh("mesh of a body", "nodes can be counted; nodes", nodes, most);
}

void LayersOnCube::add_cell(BodyMesh& mesh, std::array<int, 3> const& at, int k, int end, int layer) const {
  std::array<int, 8> corners{};
  for (int b = 0; b < 1 << d_; ++b) {
    auto here = at;
    for (int i = 0; i < d_; ++i) here[i] += b >> i & 1;
    bool const outer = k >= 0 && (b >> k & 1) == end;
    if (k >= 0) here[k] = end * grid_.cells[k];
    corners[b] = node(here, layer + outer);
  }
  int const cell = int(mesh.cells.size());
  mesh.cells.push_back(corners);
  if (k < 0) return;
  if (!core_ && layer == 0) mesh.sides["inner"].push_back(facet_nodes(mesh, {cell, 2 * k + 1 - end}));
  if (layer + 1 == layers_) mesh.sides["outer"].push_back(facet_nodes(mesh, {cell, 2 * k + end}));
}

BodyMesh filled_mesh(char const* what, int d, double radius, std::array<int, 2> const& cells) {
  require_round(what, 0, radius, cells, 1);
  return LayersOnCube(d, cells, true).mesh([&](std::array<double, 3> const& u, double t) {
    auto const core = in_core(d, u);
    if (t == 0) {
      std::array<double, 3> place{};
      for (int k = 0; k < d; ++k) place[k] = radius * core[k];
      return place;
    }
    auto place = direction_through(d, u);
    for (int k = 0; k < d; ++k) place[k] = radius * (t * place[k] + (1 - t) * core[k]);
    return place;
  });
}

}  // namespace detail

BodyMesh annulus_mesh(double inner, double outer, std::array<int, 2> const& cells) {
  detail::require_round("annulus", inner, outer, cells, 3);
  if (inner == 0)
    throw NotABodyMesh("annulus", "the inner radius is positive; a disc has none; radius", inner, 0);
  detail::CellGrid const grid{2, {cells[0], cells[1], 1}, {false, true, false}};
  auto mesh = grid.mesh([&](std::array<int, 3> const& at) {
    double const t = double(at[0]) / cells[0], angle = 8 * std::atan(1.0) * at[1] / cells[1];
    double const radius = inner * (1 - t) + outer * t;
    return std::array<double, 3>{radius * std::cos(angle), radius * std::sin(angle), 0};
  });
  mesh.sides = {{"inner", std::move(mesh.sides["left"])}, {"outer", std::move(mesh.sides["right"])}};
  return mesh;
}

BodyMesh shell_mesh(double inner, double outer, std::array<int, 2> const& cells) {
  detail::require_round("shell", inner, outer, cells, 1);
  if (inner == 0)
    throw NotABodyMesh("shell", "the inner radius is positive; a ball has none; radius", inner, 0);
  return detail::LayersOnCube(3, cells, false).mesh([&](std::array<double, 3> const& u, double t) {
    auto place = detail::direction_through(3, u);
    for (double& x : place) x *= inner * (1 - t) + outer * t;
    return place;
  });
}

}  // namespace actio::media
