#include "actio/incompressible_media/incompressible_sphere.hpp"

#include <map>
#include <numbers>
#include <set>

namespace actio::media {
namespace {

using Point = std::array<double, 3>;

Point on_sphere(Point p) {
  double const size = std::sqrt(detail::dot(p.data(), p.data()));
  for (double& one : p) one /= size;
  return p;
}

/// Moves each node to the mean of its neighbours along edges, again and again.
void smooth(BodyMesh& mesh, int rounds) {
  std::set<std::pair<int, int>> edges;  // both ways
  for (auto const& cell : mesh.cells)
    for (int b = 0; b < 4; ++b)
      for (int k = 0; k < 2; ++k) edges.insert({cell[b], cell[b ^ 1 << k]});
  std::vector<std::pair<int, int>> const in_a_row(edges.begin(), edges.end());
  for (int round = 0; round < rounds; ++round) {
    std::vector<Point> sums(mesh.nodes.size(), Point{});
    for (auto const& [node, other] : in_a_row)
      for (int a = 0; a < 3; ++a) sums[node][a] += mesh.nodes[other][a];
    for (std::size_t node = 0; node < sums.size(); ++node) mesh.nodes[node] = on_sphere(sums[node]);
  }
}

SharpPlaces reference_of(BodyMesh const& mesh) {
  SharpPlaces out;
  for (auto const& x : mesh.nodes) {
    double const off = std::abs(detail::dot(x.data(), x.data()) - 1);
    if (!(off <= 1e-12))
      throw NotABodyMesh("fluid on the sphere", "nodes are unit vectors; off by", off, 1e-12);
    out.y.insert(out.y.end(), x.begin(), x.end());
  }
  return out;
}

}  // namespace

BodyMesh sphere_mesh(int cells) {
  if (cells < 2) throw NotABodyMesh("sphere", "a face of the cube has two cells along an edge", cells, 2);
  BodyMesh mesh;
  mesh.dimension = 2;
  mesh.shape = BodyMesh::Shape::quadrilateral;
  std::map<std::array<int, 3>, int> numbers;  // of nodes, by their place in the lattice of the cube
  for (int axis = 0; axis < 3; ++axis)
    for (int const end : {0, cells}) {
      // Directions along the face such that it looks outwards.
      int const u = (axis + (end ? 1 : 2)) % 3, v = (axis + (end ? 2 : 1)) % 3;
      for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
          std::array<int, 8> corners{};
          for (int b = 0; b < 4; ++b) {
            std::array<int, 3> at{};
            at[axis] = end, at[u] = i + (b & 1), at[v] = j + (b >> 1);
            auto const [entry, is_new] = numbers.try_emplace(at, static_cast<int>(mesh.nodes.size()));
            if (is_new) {
              Point p;
              for (int a = 0; a < 3; ++a) p[a] = std::tan(std::numbers::pi / 4 * (2.0 * at[a] / cells - 1));
              mesh.nodes.push_back(on_sphere(p));
            }
            corners[b] = entry->second;
          }
          mesh.cells.push_back(corners);
        }
    }
  smooth(mesh, cells * cells / 2);
  return mesh;
}

IncompressibleSphere::IncompressibleSphere(BodyMesh mesh, Velocity const& velocity, double step,
                                           VolumeSolving const& solving)
    : IncompressibleSphere(std::make_unique<BodyMesh>(std::move(mesh)), velocity, step, solving) {}

IncompressibleSphere::IncompressibleSphere(std::unique_ptr<BodyMesh> mesh, Velocity const& velocity,
                                           double step, VolumeSolving const& solving)
    : IncompressibleMotion(*mesh, reference_of(*mesh), std::vector<double>(mesh->cells.size(), 1.0), {}, step,
                           solving),
      mesh_(std::move(mesh)) {
  std::vector<double> v;
  for (auto const& x : mesh_->nodes)
    for (double const rate : velocity(x)) {
      if (!is_finite(rate)) throw NotFinite("fluid on the sphere: velocity at the start");
      v.push_back(rate);
    }
  start(reference_of(*mesh_).y, std::move(v), true);
}

void IncompressibleSphere::move(SharpPlaces const& from, double h, double, std::vector<double>& v,
                                SharpPlaces& to) const {
  to = from;
  for (std::size_t k = 0; k < v.size(); k += 3) {
    // y = w + n y_k with w = y_k + h v, such that |y| = 1.
    double const* last = from.y.data() + k;
    double w[3];
    for (int a = 0; a < 3; ++a) w[a] = last[a] + h * v[k + a];
    double const up = detail::dot(w, last), n = -up + std::sqrt(up * up - detail::dot(w, w) + 1);
    for (int a = 0; a < 3; ++a) to.y[k + a] = w[a] + n * last[a], v[k + a] += n * last[a] / h;
  }
}

void IncompressibleSphere::tangent(std::vector<double> const& y, double, std::vector<double>& v) const {
  for (std::size_t k = 0; k < y.size(); k += 3) {
    double const up = detail::dot(v.data() + k, y.data() + k);
    for (int a = 0; a < 3; ++a) v[k + a] -= up * y[k + a];
  }
}

}  // namespace actio::media
