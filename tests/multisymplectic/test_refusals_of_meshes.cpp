// Meshes of bodies at the edge of what is accepted: what lies there is taken, what lies beyond is refused
// with the number that was measured and the bound.
#include <boost/test/unit_test.hpp>

#include "actio/meshes/body_mesh_check.hpp"
#include "actio/meshes/body_shapes.hpp"
#include "refused.hpp"
#include "refuses.hpp"

using namespace actio;
using namespace actio::media;
using testing::refuses;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();

template <class F>
void refuses(F const& f, double measured, double bound, std::string const& words) {
  testing::refuses<NotABodyMesh>(f, measured, bound, words);
}
template <class Change>
BodyMesh with(Change const& change) {
  auto mesh = box_mesh({0, 0}, {3, 2}, {3, 2});
  change(mesh);
  return mesh;
}
template <class Change>
auto requiring(Change const& change) { return [change] { require_body_mesh(with(change)); }; }
}  // namespace

BOOST_AUTO_TEST_SUITE(refusals_of_meshes)

BOOST_AUTO_TEST_CASE(boxes_are_refused_with_what_they_lack) {
  refuses([] { box_mesh({}, {}, {}); }, 0, 3, "one to three dimensions");
  refuses([] { box_mesh({0, 0, 0, 0}, {1, 1, 1, 1}, {1, 1, 1, 1}); }, 4, 3, "one to three dimensions");
  refuses([] { box_mesh({0}, {1, 1}, {1, 1}); }, 1, 2, "each direction has its entry");
  refuses([] { box_mesh({0, 0}, {1, 1, 1}, {1, 1}); }, 3, 2, "each direction has its entry");
  refuses([] { box_mesh({0, 0}, {1, 1}, {1, 1}, {true}); }, 1, 2, "each direction has its entry");
  refuses([] { box_mesh({0, 2}, {1, 2}, {1, 1}); }, 2, 2, "box, direction 2: the upper end");
  refuses([] { box_mesh({0, 0}, {1, 2}, {1, 0}); }, 0, 1, "direction 2: there are cells enough");
  refuses(
      [] {
        box_mesh({0, 0}, {1, 2}, {1, 1}, {false, true});
      },
      1, 2, "direction 2: there are cells enough");
  refuses(
      [] {
        box_mesh({0, 0, 0}, {1, 1, 1}, {2000, 1999, 1999});
      },
      2001.0 * 2000 * 2000, 2147483647.0, "nodes can be counted");
  for (double const bad : {HUGE_VAL, std::nan("")}) {
    CHECK_REFUSED(box_mesh({0, -bad}, {1, 1}, {1, 1}), NotFinite);
    CHECK_REFUSED(box_mesh({0, 0}, {1, bad}, {1, 1}), NotFinite);
  }
  BOOST_TEST(box_mesh({0}, {1}, {1}).cells.size() == 1);
  BOOST_TEST(box_mesh({0, 0}, {1, 2}, {1, 2}, {false, true}).nodes.size() == 4);
}

BOOST_AUTO_TEST_CASE(nodes_of_a_box_lie_evenly_and_count_along_the_first_direction) {
  auto const box = box_mesh({-1, 2, 5}, {3, 5, 6}, {4, 3, 2});
  BOOST_REQUIRE(box.nodes.size() == 60);
  for (int k = 0; k < 60; ++k) {
    std::array<double, 3> const at{-1.0 + k % 5, 2.0 + k / 5 % 4, 5 + k / 20 / 2.0};
    for (std::size_t a = 0; a < 3; ++a) BOOST_TEST(std::abs(box.nodes[k][a] - at[a]) <= 8 * eps);
  }
  for (int cell = 0; cell < 24; ++cell)
    for (int b = 0; b < 8; ++b) {
      int const i = cell % 4 + (b & 1), j = cell / 4 % 3 + (b >> 1 & 1), l = cell / 12 + (b >> 2);
      BOOST_TEST(box.cells[cell][b] == i + 5 * (j + 4 * l));
    }
  // A facet belongs to the side whose nodes it has, all of them, and looks outwards.
  std::map<std::string, std::array<int, 2>> const faces{{"left", {0, -1}},  {"right", {0, 3}},
                                                        {"bottom", {1, 2}}, {"top", {1, 5}},
                                                        {"front", {2, 5}},  {"back", {2, 6}}};
  BOOST_TEST(box.sides.size() == 6);
  for (auto const& [name, at] : faces) {
    int const cells[] = {4, 3, 2};
    BOOST_TEST(int(box.sides.at(name).size()) == 24 / cells[at[0]]);
    for (auto const& facet : box.sides.at(name))
      for (int node : facet) BOOST_TEST(std::abs(box.nodes[node][at[0]] - at[1]) <= 8 * eps);
  }
  // Names by places, by tags of a file, and by numbers where a box has lost a cell.
  auto mesh = box_mesh({0, 0, 0}, {1, 1, 1}, {4, 3, 2});
  BOOST_TEST(mesh.cell_name(4 * 3 + 2 * 4 + 1) == "cell (1, 2, 1)");
  mesh.cells.pop_back();
  BOOST_TEST(mesh.cell_name(21) == "cell 21");
  BOOST_TEST(mesh.node_name(3) == "3");
  mesh.node_tags = {17, 11, 30}, mesh.element_tags.assign(23, 5), mesh.element_tags[21] = 99;
  BOOST_TEST(mesh.cell_name(21) == "element 99");
  BOOST_TEST(mesh.node_name(0) == "17");
  BOOST_TEST(mesh.node_name(2) == "30");
  BOOST_TEST(mesh.node_name(3) == "3");
  BOOST_TEST(mesh.node_name(-1) == "-1");
}

BOOST_AUTO_TEST_CASE(round_bodies_are_refused_with_what_they_lack) {
  refuses([] { annulus_mesh(-1, 1, {2, 8}); }, -1, 0, "annulus: the inner radius is positive");
  refuses([] { annulus_mesh(0, 1, {2, 8}); }, 0, 0, "a disc has none");
  refuses([] { annulus_mesh(2, 2, {2, 8}); }, 2, 2, "the outer radius is above the inner one");
  refuses([] { annulus_mesh(1, 2, {0, 8}); }, 0, 1, "there are cells across");
  refuses([] { annulus_mesh(1, 2, {1, 2}); }, 2, 3, "there are cells enough along");
  refuses([] { disc_mesh(0, {1, 1}); }, 0, 0, "the outer radius is above the inner one");
  refuses([] { disc_mesh(1, {1, 0}); }, 0, 1, "there are cells enough along");
  refuses([] { shell_mesh(0, 1, {1, 1}); }, 0, 0, "a ball has none");
  refuses([] { shell_mesh(3, 1, {1, 1}); }, 1, 3, "the outer radius is above the inner one");
  // The lattice of 4^3 nodes, and layers of the 56 on its surface.
  refuses([] { ball_mesh(1, {40000000, 3}); }, 64 + 40000001.0 * 56, 2147483647.0, "nodes can be counted");
  CHECK_REFUSED(disc_mesh(HUGE_VAL, {1, 1}), NotFinite);
  CHECK_REFUSED(annulus_mesh(std::nan(""), 1, {1, 3}), NotFinite);
  BOOST_TEST(annulus_mesh(1, 2, {1, 3}).cells.size() == 3);
  BOOST_TEST(disc_mesh(1, {1, 1}).cells.size() == 5);
  BOOST_TEST(ball_mesh(1, {1, 1}).nodes.size() == 16);
  BOOST_TEST(shell_mesh(1, 2, {2, 1}).nodes.size() == 24);
}

// The core of a disc or a ball is half of the square or the cube, with the squares of coordinates halfway to
// those of the map u_k sqrt(1 - p/2 - q/2 + p q/3), which takes the surface of the cube to the unit sphere.
BOOST_AUTO_TEST_CASE(the_core_of_a_round_body_lies_halfway_between_a_cube_and_a_ball) {
  for (int const c : {2, 3, 4}) {
    int const n = c + 1;
    auto const disc = disc_mesh(3, {2, c}), ball = ball_mesh(3, {1, c});
    for (int d = 2; d < 4; ++d) {
      auto const& mesh = d == 2 ? disc : ball;
      for (int k = 0; k < (d == 2 ? n * n : n * n * n); ++k) {
        int const at[] = {k % n, k / n % n, k / n / n};
        double square = 0;
        bool outside = false;
        for (int a = 0; a < d; ++a) {
          double const u = 2.0 * at[a] / c - 1, x = mesh.nodes[k][a] / 3;
          outside = outside || at[a] == 0 || at[a] == c;
          square += 8 * x * x - u * u;
          BOOST_TEST((std::abs(u) < 1e-9 ? std::abs(x) < 1e-9 : x / u > 0));
        }
        if (outside) BOOST_TEST(std::abs(square - 1) <= 30 * eps);
      }
    }
  }
  // Between the core and the circle nodes lie evenly on straight lines, at equal angles on the circle.
  auto const disc = disc_mesh(3, {2, 4});
  for (int k = 0; k < 16; ++k) {
    auto const &middle = disc.nodes[25 + k], &outer = disc.nodes[41 + k];
    double const angle = std::atan2(outer[1], outer[0]) / (std::atan(1.0) / 2);
    BOOST_TEST(std::abs(angle - std::round(angle)) <= 30 * eps);
    double nearest = HUGE_VAL;
    for (int core = 0; core < 25; ++core)
      nearest = std::min(nearest, std::hypot(2 * middle[0] - outer[0] - disc.nodes[core][0],
                                             2 * middle[1] - outer[1] - disc.nodes[core][1]));
    BOOST_TEST(nearest <= 30 * eps);
  }
}

BOOST_AUTO_TEST_CASE(meshes_of_no_body_are_refused_with_what_was_counted) {
  refuses(requiring([](BodyMesh& m) { m.dimension = 3; }), 3, 2, "mesh of a body of quadrilaterals");
  refuses(requiring([](BodyMesh& m) { m.cells.clear(); }), 0, 1, "there are cells");
  refuses(requiring([](BodyMesh& m) { m.wraps.resize(5); }), 5, 6, "how it lies across seams");
  refuses(requiring([](BodyMesh& m) { m.cells[3][2] = -1; }), -1, 11, "its corners are nodes");
  refuses(requiring([](BodyMesh& m) { m.cells[3][2] = 12; }), 12, 11, "its corners are nodes");
  refuses(requiring([](BodyMesh& m) { m.nodes.push_back({7, 7, 0}); }), 0, 1, "every node is a corner");
  // The corner (3, 2) of a unit cell drawn to (2.25, 1.25): its edges are (1/4, -3/4) and (-3/4, 1/4).
  refuses(requiring([](BodyMesh& m) {
            m.nodes[11] = {2.25, 1.25, 0};
          }),
          -0.8, 64 * eps, "a cell is not inverted");
  refuses(requiring([](BodyMesh& m) { m.nodes[11] = m.nodes[7]; }), 0, 64 * eps, "a cell is not degenerate");
  refuses(requiring([](BodyMesh& m) { m.cells.push_back(m.cells[1]), m.cells.push_back(m.cells[1]); }), 3, 2,
          "a facet belongs to two cells at most");
  refuses(requiring([](BodyMesh& m) {
            auto const other = box_mesh({7, 0}, {9, 1}, {2, 1});
            m.cells.insert(m.cells.end(), {{12, 13, 15, 16}, {13, 14, 16, 17}});
            m.nodes.insert(m.nodes.end(), other.nodes.begin(), other.nodes.end());
          }),
          2, 1, "cells are connected by their facets");
  refuses(requiring([](BodyMesh& m) {
            m.sides["left"].push_back({4, 9, -1, -1});
          }),
          4, -1, "side left, facet 2");
  refuses([] { facets_of_side(with([](BodyMesh&) {}), "front"); }, 0, 1, "sides with the name front");
}

BOOST_AUTO_TEST_CASE(corners_have_the_volume_of_their_edges) {
  // Cells along oblique edges: at every corner the determinant is the same.
  double const A[3][3] = {{1, 0.2, 0.1}, {-0.3, 1.2, 0.4}, {0.2, -0.1, 0.9}};
  for (std::size_t d = 1; d < 4; ++d) {
    auto mesh = box_mesh(std::vector<double>(d, 0), std::vector<double>(d, 1), std::vector<int>(d, 1));
    for (auto& node : mesh.nodes) {
      auto const u = node;
      node = {0, 0, 0};
      for (std::size_t i = 0; i < d; ++i)
        for (std::size_t k = 0; k < d; ++k) node[k] += u[i] * A[i][k];
    }
    double const det2 = 1.2 + 0.3 * 0.2, det3 = 1.2 * 0.9 + 0.04 - 0.2 * (-0.27 - 0.08) + 0.1 * (0.03 - 0.24);
    double const volume = d == 1 ? 1 : d == 2 ? det2 : det3;
    double box = 1;
    for (std::size_t i = 0; i < d; ++i) box *= std::hypot(A[i][0], d > 1 ? A[i][1] : 0, d > 2 ? A[i][2] : 0);
    for (int b = 0; b < 1 << d; ++b) {
      auto const J = corner_jacobian(mesh, 0, b);
      BOOST_TEST(std::abs(J.volume - volume) <= 20 * eps);
      BOOST_TEST(std::abs(J.box - box) <= 20 * eps);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
