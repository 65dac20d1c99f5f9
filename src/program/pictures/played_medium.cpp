#include "program/pictures/played_medium.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace actio::scene {
namespace {

using MediumPoint = PlayedMedium::Point;

MediumPoint difference(MediumPoint const& a, MediumPoint const& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double product(MediumPoint const& a, MediumPoint const& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
MediumPoint of_unit_length(MediumPoint a) {
  double const length = std::sqrt(product(a, a));
  for (double& x : a) x = length > 0 ? x / length : 0;
  return a;
}

MediumPoint normal_of(DrawnMesh const& mesh, DrawnMesh::Face const& face) {
  auto const at = [&](std::size_t k) { return mesh.points[static_cast<std::size_t>(face.points[k])]; };
  MediumPoint const u = difference(at(1), at(0)), v = difference(at(2), at(0));
  return of_unit_length({u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]});
}

/// The facets of a cell in space whose corners VTK counts, seen from outside counterclockwise.
std::vector<std::array<int, 4>> const& facets_of(std::size_t corners) {
  static std::vector<std::array<int, 4>> const tetrahedron{
      {0, 2, 1, 1}, {0, 1, 3, 3}, {1, 2, 3, 3}, {0, 3, 2, 2}},
      hexahedron{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  return corners == 8 ? hexahedron : tetrahedron;
}

/// Numbers in their order, as a key.
template <std::size_t n>
std::array<int, n> sorted(std::array<int, n> all) {
  std::sort(all.begin(), all.end());
  return all;
}

/// What is the same for all that have these corners: those of a triangle are three.
std::array<int, 4> key_of(std::array<int, 4> corners) {
  if (corners[3] == corners[2]) corners[3] = -1;
  return sorted(corners);
}

/// An edge or a facet of a cell: what tells it from others, and its points in their order.
template <std::size_t n>
struct Counted {
  std::array<int, n> key, points;
  std::size_t cell;
};
/// Those that are there once.
template <std::size_t n>
std::vector<Counted<n>> of_one_cell(std::vector<Counted<n>> all) {
  std::stable_sort(all.begin(), all.end(), [](auto const& a, auto const& b) { return a.key < b.key; });
  std::vector<Counted<n>> out;
  for (std::size_t first = 0, end; first < all.size(); first = end) {
    for (end = first + 1; end < all.size() && all[end].key == all[first].key;) ++end;
    if (end == first + 1) out.push_back(all[first]);
  }
  return out;
}

/// Edges of a surface at which it turns by more than 40 degrees.
std::vector<std::array<int, 2>> sharp_edges(DrawnMesh const& mesh) {
  std::vector<Counted<2>> edges;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (std::size_t k = 0; k < 4; ++k) {
      std::array<int, 2> const edge{mesh.faces[f].points[k], mesh.faces[f].points[(k + 1) % 4]};
      if (edge[0] != edge[1]) edges.push_back({sorted(edge), edge, f});
    }
  std::stable_sort(edges.begin(), edges.end(), [](auto const& a, auto const& b) { return a.key < b.key; });
  std::vector<std::array<int, 2>> out;
  for (std::size_t k = 1; k < edges.size(); ++k)
    if (edges[k].key == edges[k - 1].key && product(normal_of(mesh, mesh.faces[edges[k].cell]),
                                                    normal_of(mesh, mesh.faces[edges[k - 1].cell])) < 0.766)
      out.push_back(edges[k].points);
  return out;
}

/// How many sides of the body meet at each point: sides that differ by more than 30 degrees are two.
std::vector<int> sides_at_points(DrawnMesh const& mesh) {
  std::vector<std::vector<MediumPoint>> normals(mesh.points.size());
  auto const see = [&](int point, MediumPoint const& normal) {
    auto& there = normals[static_cast<std::size_t>(point)];
    if (there.size() < 3 && std::all_of(there.begin(), there.end(),
                                        [&](auto const& other) { return product(other, normal) < 0.866; }))
      there.push_back(normal);
  };
  auto const at = [&](int point) { return mesh.points[static_cast<std::size_t>(point)]; };
  if (mesh.dimension == 2)
    for (auto const& [a, b] : mesh.outline) {
      MediumPoint const edge = difference(at(b), at(a)), normal = of_unit_length({edge[1], -edge[0], 0});
      see(a, normal), see(b, normal);
    }
  else
    for (auto const& face : mesh.faces) {
      MediumPoint const normal = normal_of(mesh, face);
      for (int const point : face.points) see(point, normal);
    }
  std::vector<int> out;
  for (auto const& there : normals) out.push_back(static_cast<int>(there.size()));
  return out;
}

/// For each point the one that stands for it, where space is divided into cubes of this size.
std::vector<int> representatives(DrawnMesh const& mesh, std::vector<int> const& sides,
                                 MediumPoint const& lower, double size) {
  std::map<std::array<long, 3>, int> of_cube;
  std::vector<std::array<long, 3>> cubes;
  auto const off_centre = [&](int point) {
    double sum = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      double const x = (mesh.points[static_cast<std::size_t>(point)][a] - lower[a]) / size;
      sum += std::pow(x - std::floor(x) - 0.5, 2);
    }
    return sum;
  };
  auto const better = [&](int a, int b) {
    int const ours = sides[static_cast<std::size_t>(a)], theirs = sides[static_cast<std::size_t>(b)];
    return ours != theirs ? ours > theirs : off_centre(a) < off_centre(b);
  };
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    std::array<long, 3> cube;
    for (std::size_t a = 0; a < 3; ++a)
      cube[a] = static_cast<long>(std::floor((mesh.points[k][a] - lower[a]) / size));
    cubes.push_back(cube);
    auto const [there, is_new] = of_cube.try_emplace(cube, static_cast<int>(k));
    if (!is_new && better(static_cast<int>(k), there->second)) there->second = static_cast<int>(k);
  }
  std::vector<int> out;
  for (auto const& cube : cubes) out.push_back(of_cube.at(cube));
  return out;
}

/// The mesh with others in place of its points; what has no extent then is left out, and what is there twice.
DrawnMesh with_points(DrawnMesh const& mesh, std::vector<int> const& instead) {
  DrawnMesh out;
  out.dimension = mesh.dimension;
  std::vector<int> number(mesh.points.size(), -1);
  auto const kept = [&](int point) {
    int const old = instead[static_cast<std::size_t>(point)];
    int& now = number[static_cast<std::size_t>(old)];
    if (now < 0) {
      now = static_cast<int>(out.points.size());
      out.points.push_back(mesh.points[static_cast<std::size_t>(old)]);
      out.nodes.push_back(mesh.nodes[static_cast<std::size_t>(old)]);
    }
    return now;
  };
  std::set<std::array<int, 4>> there;
  for (auto const& face : mesh.faces) {
    std::vector<int> around;
    for (int const point : face.points) {
      int const now = instead[static_cast<std::size_t>(point)];
      if (std::find(around.begin(), around.end(), now) == around.end()) around.push_back(now);
    }
    if (around.size() < 3) continue;
    if (around.size() == 3) around.push_back(around[2]);
    if (!there.insert(key_of({around[0], around[1], around[2], around[3]})).second) continue;
    out.faces.push_back({{kept(around[0]), kept(around[1]), kept(around[2]), kept(around[3])}, face.cell});
  }
  std::set<std::array<int, 2>> edges;
  for (auto const& [a, b] : mesh.outline) {
    std::array<int, 2> const edge{kept(a), kept(b)};
    if (edge[0] != edge[1] && edges.insert(sorted(edge)).second) out.outline.push_back(edge);
  }
  return out;
}

}  // namespace

double PlayedMedium::Field::lowest() const {
  double out = std::numeric_limits<double>::infinity();
  for (auto const& frame : values)
    for (double const x : frame) out = std::min(out, x);
  return out;
}
double PlayedMedium::Field::highest() const {
  double out = -std::numeric_limits<double>::infinity();
  for (auto const& frame : values)
    for (double const x : frame) out = std::max(out, x);
  return out;
}
std::array<PlayedMedium::Point, 2> PlayedMedium::box() const {
  constexpr double far = std::numeric_limits<double>::infinity();
  std::array<Point, 2> out{Point{far, far, far}, Point{-far, -far, -far}};
  for (auto const& frame : places)
    for (auto const& place : frame)
      for (std::size_t a = 0; a < 3; ++a)
        out[0][a] = std::min(out[0][a], place[a]), out[1][a] = std::max(out[1][a], place[a]);
  return out;
}

DrawnMesh DrawnMesh::of(int dimension, std::vector<PlayedMedium::Point> points, std::vector<int> nodes,
                        std::vector<std::int64_t> const& corners, std::size_t each) {
  DrawnMesh out{dimension, std::move(points), std::move(nodes), {}, {}};
  auto const corner = [&](std::size_t cell, int k) {
    return static_cast<int>(corners[cell * each + static_cast<std::size_t>(k)]);
  };
  std::size_t const cells = corners.size() / each;
  auto const node = [&](int point) { return out.nodes[static_cast<std::size_t>(point)]; };
  if (dimension == 2) {
    std::vector<Counted<2>> edges;
    int const last = static_cast<int>(each) - 1;
    for (std::size_t c = 0; c < cells; ++c) {
      out.faces.push_back({{corner(c, 0), corner(c, 1), corner(c, 2), corner(c, last)}, c});
      for (int k = 0; k <= last; ++k) {
        std::array<int, 2> const edge{corner(c, k), corner(c, k == last ? 0 : k + 1)};
        edges.push_back({sorted(std::array{node(edge[0]), node(edge[1])}), edge, c});
      }
    }
    for (auto const& edge : of_one_cell(std::move(edges))) out.outline.push_back(edge.points);
    return out;
  }
  // Facets at a seam belong to one cell alone, so that a periodic body is closed.
  std::vector<Counted<4>> facets;
  for (std::size_t c = 0; c < cells; ++c)
    for (auto const& facet : facets_of(each)) {
      std::array<int, 4> points_of;
      for (std::size_t k = 0; k < 4; ++k) points_of[k] = corner(c, facet[k]);
      facets.push_back({key_of(points_of), points_of, c});
    }
  for (auto const& facet : of_one_cell(std::move(facets))) out.faces.push_back({facet.points, facet.cell});
  out.outline = sharp_edges(out);
  return out;
}

DrawnMesh DrawnMesh::coarsened(std::size_t most_faces) const {
  std::vector<int> same(points.size());
  for (std::size_t k = 0; k < same.size(); ++k) same[k] = static_cast<int>(k);
  DrawnMesh const whole = with_points(*this, same);  // without points that no face has
  if (whole.faces.size() <= most_faces) return whole;
  PlayedMedium::Point lower = whole.points[0], upper = lower;
  for (auto const& point : whole.points)
    for (std::size_t a = 0; a < 3; ++a)
      lower[a] = std::min(lower[a], point[a]), upper[a] = std::max(upper[a], point[a]);
  double const extent =
      std::max({upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]}) * (1 + 1e-9);
  auto const sides = sides_at_points(whole);
  // So many cubes along the longest direction, fewer and fewer.
  double along =
      std::min(2 * std::sqrt(static_cast<double>(most_faces)) + 2, 1.0 * static_cast<double>(most_faces));
  for (;; along *= 0.85) {
    DrawnMesh out =
        with_points(whole, representatives(whole, sides, lower, extent / std::max(1.0, std::floor(along))));
    if (out.faces.size() <= most_faces || along < 2) return out;
  }
}

PlayedSize PlayedSize::of(std::size_t frames, std::size_t faces, int dimension, std::size_t fields) {
  constexpr std::size_t many = 120, few = 40;
  // Two bytes for each coordinate of about as many points as faces, and one for each colour.
  std::size_t const face = 2 * static_cast<std::size_t>(dimension) + fields;
  std::size_t const affordable = most_bytes / (face * std::max<std::size_t>(1, faces));
  std::size_t const shown = std::clamp(affordable, std::min(few, frames), std::min(many, frames));
  return {shown, std::min(most_faces, most_bytes / (face * std::max<std::size_t>(1, shown)))};
}

}  // namespace actio::scene
