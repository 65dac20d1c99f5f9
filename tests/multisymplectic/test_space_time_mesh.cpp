// Meshes of space-time: who meets whom, the volumes of corners, and what is refused.
#include <boost/test/unit_test.hpp>

#include <set>

#include "media.hpp"
#include "refused.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::media;
using namespace actio::testing;

namespace {

using Q = Number;
template <class S>
auto const unit_square = StraightBox<S, 2>{Matrix<S, 2, 1>(S(0), S(0)), Matrix<S, 2, 1>(S(1), S(1))};

template <class S>
SpaceTimeMesh<S, 2> square(GridIndex<2> const& cells, Sides<2> const& sides) {
  return {equal_steps(S(0), S(1), 2), cells, sides, bent_cube<S, 2>()};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_cells_at_a_node_are_those_that_have_it_as_that_corner) {
  Sides<2> const half{{{Side::periodic, Side::periodic}, {Side::free, Side::fixed}}};
  for (auto const& sides : {all_sides<2>(Side::free), all_sides<2>(Side::periodic), half}) {
    auto const mesh = square<double>({3, 4}, sides);
    std::multiset<std::array<int, 4>> from_nodes, from_cells;
    for (Index node = 0; node < mesh.node_count(); ++node)
      mesh.for_cells_at(node, [&](GridIndex<2> const& cell, int b) {
        from_nodes.insert({int(node), cell[0], cell[1], b});
      });
    mesh.for_cells([&](GridIndex<2> const& cell) {
      for (int b = 0; b < 4; ++b) from_cells.insert({int(mesh.node(cell, b)), cell[0], cell[1], b});
    });
    BOOST_TEST((from_nodes == from_cells));
    BOOST_TEST(from_cells.size() == 48u);
  }
}

BOOST_AUTO_TEST_CASE(nodes_on_a_seam_are_counted_once_and_those_of_fixed_sides_are_fixed) {
  Sides<2> const sides{{{Side::periodic, Side::periodic}, {Side::free, Side::fixed}}};
  auto const mesh = square<double>({3, 4}, sides);
  BOOST_TEST(mesh.node_count() == 15);
  int fixed = 0;
  for (Index node = 0; node < mesh.node_count(); ++node) {
    fixed += mesh.fixed(node);
    BOOST_TEST(mesh.fixed(node) == (mesh.place(node)[1] == 1));
  }
  BOOST_TEST(fixed == 3);
  // The copies of a node on a seam have one place, the near one.
  BOOST_TEST(mesh.place(mesh.node({{2, 0}}, 1))[0] == 0);
  BOOST_TEST(mesh.beyond_seam({{2, 0}}, 1, 0));
  BOOST_TEST(!mesh.beyond_seam({{2, 3}}, 2, 1));
}

BOOST_AUTO_TEST_CASE(volumes_of_corners_add_up_to_the_volume_of_a_quadrilateral) {
  WithArithmetic const exactly(Arithmetic::rationals());
  // The shoelace formula, on a cell that is no parallelogram.
  Matrix<Q, 2, 4> places;
  places << Q(0), Q(3), Q(1), Q(5), Q(0), Q(1), Q(2), Q(4);
  auto const geometry = cell_geometry<Q, 2>(places, "Q");
  Q sum(0);
  for (Q const& v : geometry.volume) sum += v;
  auto const shoelace = [&](std::array<int, 4> around) {
    Q twice(0);
    for (int k = 0; k < 4; ++k) {
      int const p = around[k], q = around[(k + 1) % 4];
      twice += places(0, p) * places(1, q) - places(0, q) * places(1, p);
    }
    return Q(twice / 2);
  };
  BOOST_TEST((sum == shoelace({0, 1, 3, 2})));
  // Corners of a cell that is none have volumes of their own.
  BOOST_TEST((geometry.volume[0] != geometry.volume[3]));
}

BOOST_AUTO_TEST_CASE(a_bent_box_is_filled_by_its_cells_whatever_its_inside) {
  WithArithmetic const exactly(Arithmetic::rationals());
  auto const mesh = square<Q>({3, 4}, all_sides<2>(Side::free));
  Q sum(0);
  mesh.for_cells([&](GridIndex<2> const& cell) {
    for (Q const& v : mesh.geometry(cell).volume) sum += v;
  });
  BOOST_TEST((sum == 1));
}

BOOST_AUTO_TEST_CASE(a_cell_that_is_turned_inside_out_is_refused_with_its_name_and_volume) {
  auto const mirrored = [](Matrix<double, 2, 1> const& u) { return Matrix<double, 2, 1>(u[1], u[0]); };
  auto const flat = [](Matrix<double, 2, 1> const& u) { return Matrix<double, 2, 1>(u[0], u[0]); };
  auto const build = [](auto const& shape) {
    SpaceTimeMesh<double, 2> const mesh({0.0, 1.0}, {2, 2}, all_sides<2>(Side::free), shape);
  };
  BOOST_CHECK_EXCEPTION(build(mirrored), InvertedCell, [](InvertedCell const& e) {
    return e.measured == -1 && std::string(e.what()).find("cell (0, 0), corner 0") != std::string::npos;
  });
  BOOST_CHECK_EXCEPTION(build(flat), InvertedCell, [](InvertedCell const& e) { return e.measured == 0; });
  // One corner pushed through the opposite edge: only a corner sees it, the cell as a whole has a volume.
  Matrix<double, 2, 4> dart;
  dart << 0, 1, 0, 0.4, 0, 0, 1, 0.4;
  BOOST_CHECK_EXCEPTION((cell_geometry<double, 2>(dart, "dart")), InvertedCell, [](InvertedCell const& e) {
    return std::string(e.what()).find("corner 3") != std::string::npos;
  });
  CHECK_REFUSED(build([](auto const& u) { return (u * std::nan("")).eval(); }), NotFinite);
}

BOOST_AUTO_TEST_CASE(a_mesh_that_does_not_exist_as_described_is_refused) {
  auto const build = [](std::vector<double> const& times, GridIndex<2> const& cells, Sides<2> const& sides,
                        auto const& shape) {
    SpaceTimeMesh<double, 2> const mesh(times, cells, sides, shape);
  };
  auto const& box = unit_square<double>;
  auto const free = all_sides<2>(Side::free), around = all_sides<2>(Side::periodic);
  CHECK_REFUSED(build({}, {2, 2}, free, box), NotAMesh);
  CHECK_REFUSED(build({0, 1, 1}, {2, 2}, free, box), NotAMesh);
  CHECK_REFUSED(build({0, std::nan("")}, {2, 2}, free, box), NotAMesh);
  CHECK_REFUSED(build({0, 1}, {2, 0}, free, box), NotAMesh);
  CHECK_REFUSED(build({0, 1}, {2, -3}, free, box), NotAMesh);
  CHECK_REFUSED(build({0, 1}, {2, 1}, around, box), NotAMesh);
  CHECK_REFUSED(build({0, 1}, {2, 2}, {{{Side::periodic, Side::free}, {Side::free, Side::free}}}, box),
                NotAMesh);
  CHECK_REFUSED(build({0, 1}, {2, 2}, all_sides<2>(Side::moved), box), NotAMesh);
  // A wedge does not close.
  auto const wedge = [](Matrix<double, 2, 1> const& u) {
    return Matrix<double, 2, 1>(u[0], u[1] * (1 + u[0]));
  };
  BOOST_CHECK_NO_THROW(build({0, 1}, {2, 2}, free, wedge));
  BOOST_CHECK_EXCEPTION(build({0, 1}, {2, 2}, around, wedge), NotAMesh,
                        [](NotAMesh const& e) { return e.measured == 0.5; });
}

BOOST_AUTO_TEST_CASE(a_restricted_section_knows_its_jump_across_a_seam) {
  WithArithmetic const exactly(Arithmetic::rationals());
  auto const mesh = square<Q>({3, 4}, all_sides<2>(Side::periodic));
  auto const stretched = [](Matrix<Q, 3, 1> const& x) {
    return Matrix<Q, 2, 1>(Q(2 * x[1] + x[2]), Q(3 * x[2] + x[0]));
  };
  auto const section = restricted(mesh, stretched, 2);
  Matrix<Q, 2, 2> const F = {{2, 1}, {0, 3}};
  BOOST_TEST((section.jump == F));
  // So that every cell, those at the seam too, has this gradient and this velocity.
  mesh.for_cells([&](GridIndex<2> const& cell) {
    auto const here = cell_of(mesh, section, 0, cell);
    for (int l = 0; l < here.nodes; ++l) {
      auto const j = discrete_jet(here, l);
      BOOST_TEST((j.gradient() == F));
      BOOST_TEST((j.velocity() == Matrix<Q, 2, 1>(Q(0), Q(1))));
    }
  });
  auto const none = [](auto const& x) { return Matrix<double, 1, 1>(x[0] / 0.0); };
  CHECK_REFUSED(restricted(square<double>({2, 2}, all_sides<2>(Side::free)), none, 1), NotFinite);
}
