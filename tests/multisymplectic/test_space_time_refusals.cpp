// Meshes of space-time and steps on them at the edge of what is accepted, and what is refused with which
// numbers; cells and nodes of a mesh of three dimensions, all counts of which differ.
#include <boost/test/unit_test.hpp>

#include "media.hpp"
#include "refuses.hpp"

using namespace actio;
using namespace actio::media;
using namespace actio::testing;

namespace {
template <int n>
StraightBox<double, n> unit_box() {
  Matrix<double, n, 1> low = Matrix<double, n, 1>::Zero(), high = low;
  for (int i = 0; i < n; ++i) high[i] = i + 1;
  return {low, high};
}
template <int n>
auto mesh_of(std::vector<double> const& times, GridIndex<n> const& cells, Sides<n> const& sides) {
  return [=] { return SpaceTimeMesh<double, n>(times, cells, sides, unit_box<n>()); };
}

/// The density of a wave that is pulled down.
struct Heavy {
  template <class T, int N>
  T operator()(Jet<T, 1, N> const& j) const {
    T sum(0);
    for (int a = 0; a < N; ++a) sum += j.v(a, 0) * j.v(a, 0) - j.v(a, 1) * j.v(a, 1) - j.y[a] * 3.0;
    return sum * 0.5;
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(space_time_refusals)

BOOST_AUTO_TEST_CASE(space_time_meshes_are_refused_with_what_they_lack) {
  auto const free = all_sides<2>(Side::free), around = all_sides<2>(Side::periodic);
  refuses<NotAMesh>(mesh_of<2>({}, {{1, 1}}, free), 0, 1, "time has a first level");
  refuses<NotAMesh>(mesh_of<2>({0, 1, 0.5}, {{1, 1}}, free), 0.5, 1, "level 2: times increase");
  refuses<NotAMesh>(mesh_of<2>({0, 0}, {{1, 1}}, free), 0, 0, "level 1: times increase");
  refuses<NotAMesh>(mesh_of<2>({0, 1}, {{1, 0}}, free), 0, 1, "direction 2: there are cells enough");
  refuses<NotAMesh>(mesh_of<2>({0, 1}, {{1, 2}}, around), 1, 2, "direction 1: there are cells enough");
  Sides<2> half = free;
  half[1][1] = Side::periodic;
  refuses<NotAMesh>(mesh_of<2>({0, 1}, {{2, 2}}, half), 1, 2, "direction 2: a periodic side");
  int const most = std::numeric_limits<int>::max();
  refuses<NotAMesh>(mesh_of<2>({0, 1}, {{most, most}}, free), std::pow(2.0, 62),
                    double(std::numeric_limits<Index>::max() / 4), "the nodes can be counted");
  BOOST_TEST(mesh_of<2>({0}, {{1, 1}}, free)().levels() == 1);
  BOOST_TEST(mesh_of<2>({0, 1}, {{2, 2}}, around)().node_count() == 4);
  // The far side is shifted by 0.25 at one of its ends; measured against the rounding of the larger place.
  auto const wedge = [] {
    SpaceTimeMesh<double, 2>(
        {0, 1}, {{2, 2}}, {{{Side::periodic, Side::periodic}, {Side::free, Side::free}}},
        [](Matrix<double, 2, 1> const& u) { return Matrix<double, 2, 1>(u[0], u[1] * (1 + 0.5 * u[0])); });
  };
  refuses<NotAMesh>(wedge, 0.25, 64 * epsilon<double>(), "x = (0, 0.5)");
}

BOOST_AUTO_TEST_CASE(cells_that_are_none_are_refused_with_their_volume_over_their_edges) {
  Matrix<double, 2, 4> sheared;
  sheared << 0, 1, 2, 2, 0, 1, 1, 1;
  // The edges (1, 1) and (2, 1) at corner 0: their determinant, -1, over their largest entries.
  refuses<InvertedCell>([&] { cell_geometry<double, 2>(sheared, "X"); }, -0.5, 64 * epsilon<double>(),
                        "cell X, corner 0 at x = (0, 0)");
  Matrix<double, 2, 4> point = Matrix<double, 2, 4>::Zero();
  refuses<InvertedCell>([&] { cell_geometry<double, 2>(point, "Y"); }, 0, 64 * epsilon<double>(), "cell Y");
}

BOOST_AUTO_TEST_CASE(a_mesh_of_three_dimensions_has_its_nodes_places_and_sides_where_they_are) {
  Sides<3> sides = all_sides<3>(Side::free);
  sides[0] = {Side::sliding, Side::fixed}, sides[1] = {Side::periodic, Side::periodic};
  sides[2] = {Side::free, Side::sliding};
  auto const mesh = mesh_of<3>({0, 0.5, 2}, {{2, 3, 4}}, sides)();
  BOOST_TEST(mesh.cell_count() == 24);
  BOOST_TEST(mesh.node_count() == 3 * 3 * 5);
  int cells = 0;
  mesh.for_cells([&](GridIndex<3> const& cell) {
    BOOST_TEST((cell[0] == cells % 2 && cell[1] == cells / 2 % 3 && cell[2] == cells / 6));
    ++cells;
    for (int b = 0; b < 8; ++b) {
      int const i = cell[0] + (b & 1), j = cell[1] + (b >> 1 & 1), k = cell[2] + (b >> 2);
      BOOST_TEST(mesh.node(cell, b) == i + 3 * (j % 3 + 3 * k));
      BOOST_TEST(mesh.beyond_seam(cell, b, 1) == (j == 3));
      BOOST_TEST(std::abs(mesh.geometry(cell).volume[b] - 0.5 * 2 / 3 * 0.75 / 8) < 1e-15);
      Matrix<double, 3, 1> const at(i / 2.0, j * 2 / 3.0, k * 0.75);
      BOOST_TEST(magnitude(Matrix<double, 3, 1>(mesh.geometry(cell).places.col(b) - at)) < 1e-15);
    }
  });
  for (Index node = 0; node < 45; ++node) {
    int const i = int(node) % 3, j = int(node) / 3 % 3, k = int(node) / 9;
    Matrix<double, 4, 1> const at(2, i / 2.0, j * 2 / 3.0, k * 0.75);
    BOOST_TEST(magnitude(Matrix<double, 4, 1>(mesh.event(2, node) - at)) < 1e-15);
    BOOST_TEST(mesh.fixed(node) == (i == 2));
    BOOST_TEST(mesh.held_across(node) == (i == 0 ? 1u : 0u) + (k == 4 ? 4u : 0u));
    int meeting = 0;
    mesh.for_cells_at(node, [&](GridIndex<3> const& cell, int corner) {
      ++meeting;
      BOOST_TEST(mesh.node(cell, corner) == node);
    });
    BOOST_TEST(meeting == (i == 1 ? 2 : 1) * 2 * (k > 0 && k < 4 ? 2 : 1));
  }
  auto const times = equal_steps(1.0, 0.25, 3);
  BOOST_TEST((times == std::vector<double>{1, 1.25, 1.5, 1.75}));
}

BOOST_AUTO_TEST_CASE(sections_and_slabs_that_a_mesh_does_not_have_are_refused) {
  auto const mesh = mesh_of<1>({0, 0.1, 0.2}, {{3}}, all_sides<1>(Side::free))();
  auto const wave = [](Matrix<double, 2, 1> const& x) { return Matrix<double, 1, 1>(x[1] * (1 - x[1])); };
  auto const section = restricted(mesh, wave, 3);
  auto with = [&](std::size_t levels) {
    auto out = section;
    out.levels.resize(levels, section.levels[0]);
    return out;
  };
  BOOST_CHECK_NO_THROW(require_section(mesh, section));
  refuses<NotAMesh>([&] { require_section(mesh, with(4)); }, 4, 3, "its levels are among those of the mesh");
  auto short_one = section;
  short_one.levels[2].pop_back();
  refuses<NotAMesh>([&] { require_section(mesh, short_one); }, 3, 4, "a value at each node");
  refuses<NotAMesh>([&] { require_slab(mesh, section, 2); }, 2, 1, "a slab lies between two of its levels");
  refuses<NotAMesh>([&] { require_slab(mesh, section, -1); }, -1, 1, "a slab lies between two of its levels");
  BOOST_CHECK_NO_THROW(require_slab(mesh, section, 1));
  auto one = with(1), two = with(2), all = section;
  refuses<NotAMesh>([&] { step(Heavy{}, mesh, one); }, 1, 2, "two levels determine the next one");
  refuses<NotAMesh>([&] { step(Heavy{}, mesh, all); }, 3, 2, "the mesh has a level to step to");
  refuses<NotAMesh>([&] { first_step(Heavy{}, mesh, two, two.levels[0]); }, 2, 1, "one level is given");
  auto const velocities = Level<double, 1>(3, Matrix<double, 1, 1>(0.0));
  refuses<NotAMesh>([&] { first_step(Heavy{}, mesh, one, velocities); }, 3, 4, "each node has a velocity");
  auto const flat = mesh_of<1>({0}, {{3}}, all_sides<1>(Side::free))();
  refuses<NotAMesh>([&] { first_step(Heavy{}, flat, one, one.levels[0]); }, 1, 0, "a level to step to");
  // A section of one component does not slide along sides of the second direction.
  auto const sliding = mesh_of<2>({0, 0.1, 0.2}, {{1, 1}}, all_sides<2>(Side::sliding))();
  auto flat_section = restricted(
      sliding, [](Matrix<double, 3, 1> const& x) { return Matrix<double, 1, 1>(x[1]); }, 2);
  auto const plain = []<class T>(Jet<T, 2, 1> const& j) -> T { return j.v(0, 0) * j.v(0, 0) * 0.5; };
  refuses<NotAMesh>([&] { step(plain, sliding, flat_section); }, 1, 2, "across their own components");
  BOOST_TEST(flat_section.last() == 1);
}

BOOST_AUTO_TEST_CASE(boxes_of_cells_end_where_the_mesh_does) {
  auto const mesh = mesh_of<2>({0, 0.1, 0.2, 0.3}, {{4, 3}},
                               {{{Side::periodic, Side::periodic}, {Side::free, Side::free}}})();
  auto const section = restricted(
      mesh, [](Matrix<double, 3, 1> const& x) { return Matrix<double, 1, 1>(x[1] * x[2]); }, 3);
  auto const box = [&](int slab, int slabs, GridIndex<2> const& first, GridIndex<2> const& cells) {
    return [&mesh, &section, b = CellBox<2>{slab, slabs, first, cells}] { require_box(mesh, section, b); };
  };
  BOOST_CHECK_NO_THROW(box(0, 2, {{3, 0}}, {{4, 3}})());
  BOOST_CHECK_NO_THROW(box(1, 1, {{0, 2}}, {{1, 1}})());
  refuses<NotAMesh>(box(1, 2, {{0, 0}}, {{1, 1}}), 3, 2, "its slabs lie between levels");
  refuses<NotAMesh>(box(-1, 1, {{0, 0}}, {{1, 1}}), 0, 2, "its slabs lie between levels");
  refuses<NotAMesh>(box(1, 0, {{0, 0}}, {{1, 1}}), 1, 2, "its slabs lie between levels");
  refuses<NotAMesh>(box(0, 1, {{0, 2}}, {{1, 2}}), 4, 3, "direction 2: its cells lie in the mesh");
  refuses<NotAMesh>(box(0, 1, {{0, -1}}, {{1, 1}}), 0, 3, "direction 2: its cells lie in the mesh");
  refuses<NotAMesh>(box(0, 1, {{0, 1}}, {{1, 0}}), 1, 3, "direction 2: its cells lie in the mesh");
  refuses<NotAMesh>(box(0, 1, {{0, 0}}, {{5, 1}}), 0, 4, "direction 1: its cells lie in the mesh");
  refuses<NotAMesh>(box(0, 1, {{5, 0}}, {{1, 1}}), 5, 4, "direction 1: its cells lie in the mesh");
  // Around the seam: the cells 3 and 0.
  CellBox<2> const across{0, 2, {{3, 1}}, {{2, 1}}};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j)
      BOOST_TEST(in_box(mesh, across, GridIndex<2>{{i, j}}) == ((i == 3 || i == 0) && j == 1));
  CellBox<2> const wide{0, 2, {{3, 0}}, {{2, 2}}};
  int inside = 0;
  for (Index node = 0; node < mesh.node_count(); ++node)
    for (int level = 0; level < 4; ++level)
      if (inside_box(mesh, wide, level, node)) {
        ++inside;
        BOOST_TEST(level == 1);
        BOOST_TEST((node == mesh.node({{0, 0}}, 0) || node == mesh.node({{0, 1}}, 0)));
      }
  BOOST_TEST(inside == 2);
}

BOOST_AUTO_TEST_SUITE_END()
