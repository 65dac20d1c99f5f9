// Sides that hold the nodes of a body: what they leave of motions where they meet under any angle, and where
// they are moved.
#include <boost/test/unit_test.hpp>

#include "actio/meshes/body_sides.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::media;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
template <int d>
using Spot = std::array<double, d>;

/// The image of a box under X = c + A u with a matrix A of which no entry is zero: its sides are plane and
/// meet under no right angle.
template <int d>
BodyMesh oblique() {
  std::vector<double> const low(d, 0), high(d, 1);
  int const cells[] = {3, 2, 2};
  auto mesh = box_mesh(low, high, {cells, cells + d});
  for (auto& node : mesh.nodes) {
    auto const u = node;
    for (int i = 0; i < d; ++i) {
      node[i] = 0.7 - 0.3 * i;
      for (int k = 0; k < d; ++k) node[i] += (i == k ? 1.1 : 0.3 - 0.2 * i + 0.1 * k) * u[k];
    }
  }
  return mesh;
}
template <int d>
double dot(Spot<d> const& a, Spot<d> const& b) {
  double sum = 0;
  for (int i = 0; i < d; ++i) sum += a[i] * b[i];
  return sum;
}
/// The edges of the oblique box: a side across k is parallel to all of them but edge k.
template <int d>
Spot<d> edge(int k) {
  Spot<d> out;
  for (int i = 0; i < d; ++i) out[i] = i == k ? 1.1 : 0.3 - 0.2 * i + 0.1 * k;
  return out;
}
/// What of u runs along all sides across the directions of a set of bits.
template <int d>
Spot<d> along_sides(unsigned across, Spot<d> u) {
  if (across == 0) return u;
  Spot<d> out{};
  auto const add = [&](Spot<d> const& t) {
    for (int i = 0; i < d; ++i) out[i] += t[i] * dot<d>(t, u) / dot<d>(t, t);
  };
  std::vector<Spot<d>> left;
  for (int k = 0; k < d; ++k)
    if (!(across >> k & 1)) left.push_back(edge<d>(k));
  // One edge alone, or the plane of two: the second is made orthogonal to the first.
  if (left.size() == 2) {
    double const part = dot<d>(left[0], left[1]) / dot<d>(left[0], left[0]);
    for (int i = 0; i < d; ++i) left[1][i] -= part * left[0][i];
  }
  for (auto const& t : left) add(t);
  return out;
}

template <int d>
void slides_along(BodyMesh const& mesh, unsigned across_all) {
  // The lower sides across these directions; the others are free.
  BodySides<d> sides;
  for (int k = 0; k < d; ++k)
    if (mesh.sides.contains(media::detail::side_names[k][0]))
      sides[media::detail::side_names[k][0]].kind = across_all >> k & 1 ? Side::sliding : Side::free;
  HeldNodes<d> const held(mesh, sides);
  BOOST_TEST(!held.any_moved());
  std::vector<unsigned> across(mesh.nodes.size(), 0);
  for (int k = 0; k < d; ++k)
    if (across_all >> k & 1)
      for (auto const& facet : mesh.sides.at(media::detail::side_names[k][0]))
        for (int const node : facet)
          if (node >= 0) across[node] |= 1u << k;
  std::vector<double> given, u;
  for (std::size_t k = 0; k < d * mesh.nodes.size(); ++k) given.push_back(std::sin(1.0 + 3.0 * double(k)));
  u = given;
  held.restrict_to_allowed(u);
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    Spot<d> before, after;
    for (std::size_t a = 0; a < d; ++a) before[a] = given[node * d + a], after[a] = u[node * d + a];
    auto const expected = along_sides<d>(across[node], before);
    // Products of a few unit vectors whose angles are not small.
    for (int a = 0; a < d; ++a) BOOST_TEST(std::abs(after[a] - expected[a]) <= 100 * eps);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(held_nodes)

BOOST_AUTO_TEST_CASE(sides_leave_what_runs_along_all_of_them) {
  for (unsigned across = 0; across < 2; ++across) slides_along<1>(oblique<1>(), across);
  for (unsigned across = 0; across < 4; ++across) slides_along<2>(oblique<2>(), across);
  for (unsigned across = 0; across < 8; ++across) slides_along<3>(oblique<3>(), across);
  // Across a seam a facet has its places from its cell.
  auto const around = box_mesh({0, 0, 1}, {1, 1, 2}, {2, 3, 2}, {true, false, false});
  HeldNodes<3> const held(around, {{"bottom", {Side::sliding, {}}}});
  std::vector<double> u(3 * around.nodes.size(), 1.0);
  held.restrict_to_allowed(u);
  for (std::size_t k = 0; k < u.size(); ++k)
    BOOST_TEST(std::abs(u[k] - (k % 3 == 1 && around.nodes[k / 3][1] == 0 ? 0 : 1)) <= 4 * eps);
}

BOOST_AUTO_TEST_CASE(a_side_that_bends_or_lies_in_two_planes_is_none_to_slide_along) {
  auto bent = box_mesh({0, 0}, {2, 1}, {2, 1});
  bent.nodes[2][1] = 0.5;
  auto const slides = [](auto const& mesh, std::string const& side, double measured) {
    BOOST_CHECK_EXCEPTION((HeldNodes<2>(mesh, {{side, {Side::sliding, {}}}})), NotABodyMesh,
                          [&](NotABodyMesh const& e) {
                            return std::abs(e.measured - measured) <= 4 * eps && e.bound == 1e-9 &&
                                   std::string(e.what()).find("side '" + side + "'") != std::string::npos;
                          });
  };
  // One minus the cosine of the angle between the normals.
  slides(bent, "bottom", 1 - 1 / std::sqrt(1.25));
  // Two parallel lines at a distance of 1, half of the largest coordinate.
  auto two = box_mesh({0, 0}, {2, 1}, {2, 1});
  two.sides["walls"] = {{1, 4, -1, -1}, {2, 5, -1, -1}};
  slides(two, "walls", 0.5);
  // A bend below the bound is rounding.
  bent.nodes[2][1] = 1e-6;
  HeldNodes<2> const held(bent, {{"bottom", {Side::sliding, {}}}});
  bent.nodes[2][1] = 1e-3;
  slides(bent, "bottom", 1 - 1 / std::sqrt(1 + 1e-6));
}

BOOST_AUTO_TEST_CASE(moved_sides_are_where_their_motions_have_them_and_others_stay) {
  auto const mesh = box_mesh({0, 1}, {2, 4}, {2, 3});
  auto const chi = [](double by) {
    return prescribed_motion<2>([by]<class T>(Spot<2> const& X, T const& t) {
      using std::sin;
      return std::array<T, 2>{t * t * by + X[0], sin(t) * X[0] + t * X[1] * by};
    });
  };
  HeldNodes<2> const held(mesh, {{"bottom", {Side::moved, chi(0.3)}},
                                 {"left", {Side::fixed, {}}},
                                 {"top", {Side::moved, chi(0.7)}},
                                 {"right", {Side::free, {}}}});
  BOOST_TEST(held.any_moved());
  double const t = 0.6;
  std::vector<double> x(2 * mesh.nodes.size(), 5), v = x, u = x;
  held.put_places(x, t), held.put_velocities(v, t), held.restrict_to_allowed(u);
  std::vector<int> moved, expected;
  held.for_moved([&](int node) { moved.push_back(node); });
  for (int node = 0; node < int(mesh.nodes.size()); ++node) {
    double const X = mesh.nodes[node][0], Y = mesh.nodes[node][1], by = Y == 1 ? 0.3 : 0.7;
    bool const is_moved = Y == 1 || Y == 4;
    if (is_moved) expected.push_back(node);
    double const at[] = {X + t * t * by, X * std::sin(t) + t * Y * by},
                 rate[] = {2 * t * by, X * std::cos(t) + Y * by};
    for (int a = 0; a < 2; ++a) {
      BOOST_TEST(std::abs(x[2 * node + a] - (is_moved ? at[a] : 5)) <= 8 * eps);
      BOOST_TEST(std::abs(v[2 * node + a] - (is_moved ? rate[a] : 5)) <= 8 * eps);
      BOOST_TEST(u[2 * node + a] == (is_moved || X == 0 ? 0 : 5));
    }
  }
  BOOST_TEST((moved == expected));
}

BOOST_AUTO_TEST_CASE(a_motion_that_has_no_place_is_refused_with_its_node_and_time) {
  auto const mesh = box_mesh({0, 0}, {1, 1}, {1, 1});
  auto const nowhere = prescribed_motion<2>([]<class T>(Spot<2> const& X, T const& t) {
    return std::array<T, 2>{t * X[0], t / (1 - X[0])};
  });
  HeldNodes<2> const held(mesh, {{"top", {Side::moved, nowhere}}});
  std::vector<double> x(8, 0);
  auto const named = [](NotFinite const& e) {
    return std::string(e.what()).find("prescribed motion of node 3 at t = 0.25:") != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(held.put_places(x, 0.25), NotFinite, named);
  BOOST_CHECK_EXCEPTION(held.put_velocities(x, 0.25), NotFinite, named);
}

BOOST_AUTO_TEST_CASE(a_name_that_is_no_side_is_refused_with_those_that_are) {
  auto const says = [](auto const& mesh, std::string const& words) {
    BOOST_CHECK_EXCEPTION(require_side(mesh, "tpo"), UnknownSide, [&](UnknownSide const& e) {
      return std::string(e.what()).find(words) != std::string::npos;
    });
  };
  auto mesh = box_mesh({0, 0}, {1, 1}, {2, 2});
  BOOST_CHECK_NO_THROW(require_side(mesh, "top"));
  CHECK_REFUSED(HeldNodes<2>(mesh, {{"top", {Side::periodic, {}}}}), NotABodyMesh);
  says(mesh, "; the mesh has bottom, left, right, top");
  mesh.sides.clear();
  says(mesh, "the mesh has none");
}

BOOST_AUTO_TEST_SUITE_END()
