// Meshes of bodies: boxes and round shapes, their volumes and sides, and what is refused.
#include <boost/test/unit_test.hpp>

#include <numbers>

#include "actio/meshes/body_mesh_check.hpp"
#include "actio/meshes/body_shapes.hpp"
#include "caught.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::media;
using testing::caught;

namespace {

using Place = std::array<double, 3>;

double volume_of(BodyMesh const& mesh) {
  double sum = 0;
  for (int cell = 0; cell < int(mesh.cells.size()); ++cell)
    for (int b = 0; b < corner_count(mesh.shape); ++b)
      sum += corner_jacobian(mesh, cell, b).volume / corner_count(mesh.shape);
  return sum;
}

/// The volume that the sides enclose, by the divergence theorem for X: the flux of X through them, facets of
/// box-like cells cut into triangles, over the dimension.
double enclosed_by_sides(BodyMesh const& mesh) {
  double flux = 0;
  for (auto const& side : mesh.sides)
    for (auto const& at : facets_of_side(mesh, side.first)) {
      auto const& corners = facet_corners(mesh.shape, at.facet);
      auto const x = [&](int k) { return corner_place(mesh, at.cell, corners[k]); };
      if (mesh.dimension == 2) flux += x(0)[0] * x(1)[1] - x(1)[0] * x(0)[1];
      if (mesh.dimension == 3)
        for (auto const& [p, q, r] : {std::tuple(x(0), x(1), x(2)), std::tuple(x(0), x(2), x(3))})
          flux += (p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
                   p[2] * (q[0] * r[1] - q[1] * r[0])) /
                  2;
    }
  return flux / mesh.dimension;
}

/// A mesh that is wrong somewhere must be refused with these words and this cell.
void refused(BodyMesh const& mesh, std::string const& words, int cell) {
  auto const e = caught<NotABodyMesh>([&] { require_body_mesh(mesh); });
  BOOST_TEST(std::string(e.what()).find(words) != std::string::npos, e.what());
  BOOST_TEST(e.cell == cell, e.what());
}

}  // namespace

BOOST_AUTO_TEST_CASE(boxes_have_their_volume_and_their_sides_enclose_it) {
  // Each term is rounded a few times, and there are fewer than a thousand.
  double const bound = 1e-13;
  for (auto const& box : {box_mesh({-1, 2}, {3, 2.5}, {4, 3}), box_mesh({0, 0, 1}, {1, 2, 4}, {2, 3, 4})}) {
    require_body_mesh(box);
    double const exact = box.dimension == 2 ? 2 : 6;
    BOOST_TEST(std::abs(volume_of(box) - exact) < bound);
    BOOST_TEST(std::abs(enclosed_by_sides(box) - exact) < bound);
    BOOST_TEST(box.sides.size() == 2u * box.dimension);
  }
  auto const line = box_mesh({0}, {2}, {5});
  require_body_mesh(line);
  BOOST_TEST(volume_of(line) == 2);
  BOOST_TEST((line.sides.at("right")[0] == std::array<int, 4>{5, -1, -1, -1}));
  BOOST_TEST(line.nodes[5][0] == 2);
}

BOOST_AUTO_TEST_CASE(a_periodic_box_has_no_sides_across_its_seam_and_its_cells_lie_beyond_it) {
  for (std::vector<int> const& cells : {std::vector<int>{2, 3}, {3, 2, 2}}) {
    std::size_t const d = cells.size();
    std::vector<bool> periodic(d, true);
    periodic[1] = false;
    auto const box = box_mesh(std::vector<double>(d, 0), std::vector<double>(d, 2), cells, periodic);
    require_body_mesh(box);
    BOOST_TEST(std::abs(volume_of(box) - std::pow(2.0, d)) < 1e-13);
    BOOST_TEST(box.nodes.size() == (d == 2 ? 8u : 18u));
    BOOST_TEST(box.sides.size() == 2u);
    BOOST_TEST(box.periods[0] == 2);
    // A facet across the seam has its places from its cell: the side is as wide as the box.
    double width = 0;
    for (auto const& at : facets_of_side(box, "bottom")) {
      auto const& corners = facet_corners(box.shape, at.facet);
      width += corner_place(box, at.cell, corners[1])[0] - corner_place(box, at.cell, corners[0])[0];
    }
    BOOST_TEST(std::abs(width - (d == 2 ? 2 : 2.0 * cells[2])) < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(round_bodies_of_the_plane_have_the_area_of_their_polygons) {
  auto const polygon = [](int n, double radius) {
    return n * std::sin(2 * std::numbers::pi / n) / 2 * radius * radius;
  };
  for (int c : {1, 2, 5}) {
    auto const disc = disc_mesh(1.5, {c, 2 * c});
    require_body_mesh(disc);
    BOOST_TEST(std::abs(volume_of(disc) - polygon(8 * c, 1.5)) < 1e-13);
    BOOST_TEST(std::abs(enclosed_by_sides(disc) - polygon(8 * c, 1.5)) < 1e-13);
    auto const annulus = annulus_mesh(1, 2, {c, 7 * c});
    require_body_mesh(annulus);
    double const area = polygon(7 * c, 2) - polygon(7 * c, 1);
    BOOST_TEST(std::abs(volume_of(annulus) - area) < 1e-13);
    BOOST_TEST(std::abs(enclosed_by_sides(annulus) - area) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(ball_and_shell_fill_their_volume_to_second_order) {
  double const pi = std::numbers::pi;
  auto const order = [](auto const& make, double exact) {
    std::array<double, 2> error;
    for (int k = 0; k < 2; ++k) {
      auto const mesh = make(2 << k);
      require_body_mesh(mesh);
      error[k] = exact - volume_of(mesh);
      // Volume and sides are measured by different rules; both miss the same part of the sphere.
      BOOST_TEST(std::abs(enclosed_by_sides(mesh) - volume_of(mesh)) < std::abs(error[k]));
    }
    return std::log2(error[0] / error[1]);
  };
  BOOST_TEST(std::abs(order([](int n) { return ball_mesh(1, {n, 2 * n}); }, 4 * pi / 3) - 2) < 0.05);
  BOOST_TEST(std::abs(order([](int n) { return shell_mesh(1, 2, {n, 2 * n}); }, 28 * pi / 3) - 2) < 0.05);
}

BOOST_AUTO_TEST_CASE(cells_of_round_bodies_stay_far_from_flat_however_fine_they_are) {
  // The least volume of the edges at a corner over their product: a right angle has 1. Corners of the core,
  // where three cells meet in the plane, have about the sine of 120 degrees.
  auto const least = [](BodyMesh const& mesh) {
    double worst = 1;
    for (int cell = 0; cell < int(mesh.cells.size()); ++cell)
      for (int b = 0; b < corner_count(mesh.shape); ++b) {
        auto const J = corner_jacobian(mesh, cell, b);
        worst = std::min(worst, J.volume / J.box);
      }
    return worst;
  };
  for (int n : {1, 4, 12}) {
    BOOST_TEST(least(disc_mesh(1, {n, 2 * n})) > 0.75);
    if (n > 4) continue;
    BOOST_TEST(least(ball_mesh(1, {n, 2 * n})) > 0.6);
    BOOST_TEST(least(shell_mesh(1, 2, {n, 2 * n})) > 0.75);
  }
}

BOOST_AUTO_TEST_CASE(nodes_of_round_sides_lie_on_them) {
  for (auto const& mesh :
       {disc_mesh(2, {2, 3}), annulus_mesh(1, 2, {2, 9}), ball_mesh(2, {1, 3}), shell_mesh(1, 2, {2, 3})})
    for (auto const& [name, facets] : mesh.sides)
      for (auto const& facet : facets)
        for (int node : facet) {
          if (node < 0) continue;
          Place const& x = mesh.nodes[node];
          BOOST_TEST(std::abs(std::hypot(x[0], x[1], x[2]) - (name == "outer" ? 2 : 1)) < 1e-15);
        }
}

BOOST_AUTO_TEST_CASE(a_mesh_that_is_none_of_a_body_is_refused_with_the_cell_that_is_wrong) {
  auto const good = box_mesh({0, 0}, {3, 2}, {3, 2});
  auto with = [&](auto const& change) {
    auto mesh = good;
    change(mesh);
    return mesh;
  };
  refused(with([](BodyMesh& m) {
            std::swap(m.cells[4][0], m.cells[4][1]), std::swap(m.cells[4][2], m.cells[4][3]);
          }),
          "a cell is not inverted", 4);
  refused(with([](BodyMesh& m) { m.cells[2][3] = m.cells[2][1]; }), "a cell is not degenerate", 2);
  refused(with([](BodyMesh& m) { m.nodes[1] = m.nodes[0]; }), "a cell is not degenerate", 0);
  refused(with([](BodyMesh& m) { m.cells[3][2] = 99; }),
          "its corners are nodes of the mesh; node, measured 99, bound 11", 3);
  refused(with([](BodyMesh& m) { m.cells[3][2] = -1; }), "its corners are nodes of the mesh", 3);
  refused(with([](BodyMesh& m) { m.nodes.push_back({7, 7, 0}); }), "node 12 at (7, 7, 0)", -1);
  refused(with([](BodyMesh& m) { m.cells.push_back(m.cells[1]), m.cells.push_back(m.cells[1]); }),
          "have the same facet", 7);
  auto row = box_mesh({0, 0}, {3, 1}, {3, 1});
  row.cells.erase(row.cells.begin() + 1);
  refused(row, "is unconnected to cell 0", 1);
  refused(with([](BodyMesh& m) { m.sides["left"].push_back({0, 5, -1, -1}); }), "side left, facet 2", -1);
  refused(with([](BodyMesh& m) { m.dimension = 3; }), "it has the dimension of its cells", -1);
  refused(with([](BodyMesh& m) { m.cells.clear(); }), "there are cells", -1);
  CHECK_REFUSED(require_body_mesh(with([](BodyMesh& m) { m.nodes[3][1] = std::nan(""); })), NotFinite);
}

BOOST_AUTO_TEST_CASE(a_mesh_tells_the_memory_that_it_takes) {
  BodyMesh mesh = box_mesh({0, 0}, {3, 1}, {3, 1}, {true, false});
  mesh.node_tags.assign(mesh.nodes.size(), 1), mesh.element_tags.assign(mesh.cells.size(), 1);
  // Of a node three numbers, of a cell eight corners and how many periods each of them is away.
  std::size_t const all = 6 * 3 * sizeof(double) + 3 * 8 * sizeof(int) +
                          mesh.wraps.size() * sizeof(mesh.wraps[0]) + 6 * sizeof(mesh.node_tags[0]) +
                          3 * sizeof(mesh.element_tags[0]);
  BOOST_TEST(mesh.wraps.size() == 3);
  BOOST_TEST(mesh.bytes() == all);
}

BOOST_AUTO_TEST_CASE(boxes_and_shapes_that_do_not_exist_are_refused_before_memory_is_taken) {
  CHECK_REFUSED(box_mesh({}, {}, {}), NotABodyMesh);
  CHECK_REFUSED(box_mesh({0, 0}, {1}, {1, 1}), NotABodyMesh);
  CHECK_REFUSED(box_mesh({0}, {0}, {1}), NotABodyMesh);
  CHECK_REFUSED(box_mesh({0}, {1}, {0}), NotABodyMesh);
  CHECK_REFUSED(box_mesh({0}, {1}, {1}, {true}), NotABodyMesh);
  CHECK_REFUSED(box_mesh({0}, {std::nan("")}, {1}), NotFinite);
  CHECK_REFUSED(box_mesh({0, 0, 0}, {1, 1, 1}, {2000, 2000, 2000}), NotABodyMesh);
  CHECK_REFUSED(ball_mesh(1, {2000, 2000}), NotABodyMesh);
  CHECK_REFUSED(disc_mesh(-1, {2, 2}), NotABodyMesh);
  CHECK_REFUSED(disc_mesh(1, {0, 2}), NotABodyMesh);
  CHECK_REFUSED(annulus_mesh(0, 1, {2, 8}), NotABodyMesh);
  CHECK_REFUSED(annulus_mesh(1, 2, {2, 2}), NotABodyMesh);
  CHECK_REFUSED(shell_mesh(2, 1, {2, 2}), NotABodyMesh);
  CHECK_REFUSED(facets_of_side(disc_mesh(1, {1, 1}), "left"), NotABodyMesh);
}
