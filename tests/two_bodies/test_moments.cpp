// Moments of ellipsoids and polyhedra against closed forms and other integrals, over the rationals where
// there is no root.
#include <boost/test/unit_test.hpp>

#include "actio/numbers/gauss_quadrature.hpp"
#include "actio/two_bodies/extended_body.hpp"
#include "refused.hpp"
#include "shapes.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::Vector3d;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();

/// A box about the origin with these half edges.
template <class S>
Polyhedron<S> box(std::array<S, 3> const& half) {
  Polyhedron<S> body;
  for (int k = 0; k < 8; ++k)
    body.vertices.push_back(
        {k & 1 ? half[0] : -half[0], k & 2 ? half[1] : -half[1], k & 4 ? half[2] : -half[2]});
  body.faces = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return body;
}

/// The integral of x^i y^j z^l over a tetrahedron with a corner at the origin: powers of x = sum lambda_a p_a
/// are multiplied out, and the integral of a monomial in the lambda is a! b! c!/(a+b+c+3)! (Dirichlet).
rational dirichlet(std::array<Matrix<rational, 3, 1>, 3> const& p, int i, int j, int l) {
  rational sum(0);
  auto const binomial_term = [&](int n, int axis, int a, int b) {
    rational term(factorial(n) / (factorial(a) * factorial(b) * factorial(n - a - b)));
    for (int k = 0; k < n; ++k) term *= p[k < a ? 0 : k < a + b ? 1 : 2][axis];
    return term;
  };
  for (int a = 0; a <= i; ++a)
    for (int b = 0; a + b <= i; ++b)
      for (int c = 0; c <= j; ++c)
        for (int d = 0; c + d <= j; ++d)
          for (int e = 0; e <= l; ++e)
            for (int f = 0; e + f <= l; ++f) {
              int const first = a + c + e, second = b + d + f, third = i + j + l - first - second;
              sum += binomial_term(i, 0, a, b) * binomial_term(j, 1, c, d) * binomial_term(l, 2, e, f) *
                     rational(factorial(first) * factorial(second) * factorial(third)) /
                     rational(factorial(i + j + l + 3));
            }
  rational const six_volumes = p[0].dot(p[1].cross(p[2]));
  return sum * six_volumes;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(moments)

BOOST_AUTO_TEST_CASE(a_cube_has_its_moments_to_the_last_digit) {
  auto const cube = polyhedron_moments<rational>(box<rational>({1, 1, 1}), 1, 8);
  over_exponents(0, 8, [&](int i, int j, int l) {
    bool const odd = i % 2 || j % 2 || l % 2;
    BOOST_TEST((cube(i, j, l) == (odd ? rational(0) : rational(8) / rational((i + 1) * (j + 1) * (l + 1)))));
  });
}

BOOST_AUTO_TEST_CASE(a_drawn_mesh_agrees_with_the_integrals_of_dirichlet) {
  std::mt19937 random(testing::seed);
  auto const body = testing::drawn_octahedron<rational>(random, 3);
  auto const moments = polyhedron_moments<rational>(body, rational(7, 2), 4);
  over_exponents(0, 4, [&](int i, int j, int l) {
    rational sum(0);
    for (auto const& [a, b, c] : body.faces)
      sum += dirichlet({body.vertices[a], body.vertices[b], body.vertices[c]}, i, j, l);
    BOOST_TEST((moments(i, j, l) == sum * rational(7, 2)));
  });
}

BOOST_AUTO_TEST_CASE(moments_of_a_body_that_is_shifted_and_turned_are_those_of_its_mesh) {
  std::mt19937 random(testing::seed);
  auto const body = testing::drawn_octahedron<rational>(random, 2);
  auto const given = polyhedron_moments<rational>(body, 5, 6);
  Matrix<rational, 3, 1> const c(rational(1, 3), rational(-2, 5), rational(4, 7));
  auto const R = testing::rotation_of<rational>(1, 2, -3, 4);
  auto shifted = body, turned = body;
  for (auto& x : shifted.vertices) x = x - c;
  for (auto& x : turned.vertices) x = (R.transpose() * x).eval();
  auto const a = given.seen_from(c), b = polyhedron_moments<rational>(shifted, 5, 6);
  auto const p = given.along(R), q = polyhedron_moments<rational>(turned, 5, 6);
  BOOST_TEST((a.series.coefficients == b.series.coefficients));
  BOOST_TEST((p.series.coefficients == q.series.coefficients));
  BOOST_TEST((p.series.coefficients != given.series.coefficients));
}

BOOST_AUTO_TEST_CASE(an_ellipsoid_agrees_with_gauss_quadrature) {
  // In the ball: x = a s sqrt(1-u^2) cos v, y = b s sqrt(1-u^2) sin v, z = c s u, and dm = density a b c s^2
  // ds du dv.
  std::array<double, 3> const half{1.7, 1.1, 0.6};
  double const mass = 2.5;
  int const order = 8;
  auto const moments = ellipsoid_moments<double>(mass, half, order);
  auto const rule = gauss_quadrature<double>(8);
  int const turns = 16;  // equal angles integrate trigonometric polynomials of degree below 16
  over_exponents(0, order, [&](int i, int j, int l) {
    double sum = 0, size = 0;
    for (int r = 0; r < 8; ++r)
      for (int k = 0; k < 8; ++k)
        for (int v = 0; v < turns; ++v) {
          double const s = rule.nodes[r], u = 2 * rule.nodes[k] - 1, across = std::sqrt(1 - u * u),
                       angle = 2 * M_PI * (v + 0.5) / turns,
                       weight = 3 * mass * s * s * rule.weights[r] * rule.weights[k] / turns;
          double const f = std::pow(half[0] * s * across * std::cos(angle), i) *
                           std::pow(half[1] * s * across * std::sin(angle), j) * std::pow(half[2] * s * u, l);
          sum += weight * f, size += weight * std::abs(f);
        }
    // A thousand terms and some ten roundings in each, which partly cancel.
    BOOST_TEST(std::abs(moments(i, j, l) - sum) <= 64 * eps * size);
  });
}

BOOST_AUTO_TEST_CASE(a_box_off_the_origin_and_askew_is_found_in_its_principal_axes) {
  std::array<double, 3> const half{3, 2, 1};
  auto const straight = extended_body(polyhedron_moments<double>(box(half), 2, 4), 4);
  auto moved = box(half);
  Eigen::Matrix3d const R = testing::rotation_of<double>(3, 1, -2, 1);
  Vector3d const away(5, -1, 2);
  for (auto& x : moved.vertices) x = (R * x + away).eval();
  auto const from_mesh = polyhedron_body(moved, 2, 4);
  auto const from_moments = extended_body(polyhedron_moments<double>(moved, 2, 4), 10);
  // The axes of inertia 3, 2, 1 of the box in the order least, middle, largest, up to signs.
  // From moments about a far origin digits are lost: by the fourth power of the distance over the size.
  for (auto const& [body, room] : {std::pair{from_mesh, 1e-12}, {from_moments, 1e-10}}) {
    BOOST_TEST((body.centre - away).norm() <= 64 * eps * away.norm());
    Eigen::Matrix3d const turn = (R.transpose() * body.axes).cwiseAbs();
    BOOST_TEST((turn - Eigen::Matrix3d::Identity()).norm() <= 1e-12);
    for (int i = 0; i < 3; ++i) BOOST_TEST(std::abs(body.inertia[i] / straight.inertia[i] - 1) <= 1e-13);
    double const allowed = room * straight.moments(4, 0, 0);
    auto const& moments = body.moments;
    over_exponents(4, 4, [&](int i, int j, int l) {
      BOOST_TEST(std::abs(std::abs(moments(i, j, l)) - std::abs(straight.moments(i, j, l))) <= allowed);
    });
  }
  BOOST_TEST(std::abs(from_mesh.radius - std::sqrt(14.0)) <= 64 * eps * 4);
}

BOOST_AUTO_TEST_CASE(what_is_no_body_is_refused) {
  CHECK_REFUSED(sphere_moments<double>(0, 1, 2), OutsideDomain);
  CHECK_REFUSED(ellipsoid_moments<double>(1, {1, -2, 1}, 2), OutsideDomain);
  CHECK_REFUSED(ellipsoid_moments<double>(1, {1, 1, 1}, -1), OutsideDomain);
  auto const cube = box<double>({1, 1, 1});
  CHECK_REFUSED(polyhedron_moments<double>(cube, 0, 2), OutsideDomain);
  CHECK_REFUSED(polyhedron_moments<double>(cube, 1, -2), OutsideDomain);
  auto open = cube, inside_out = cube, one_turned = cube, beyond = cube;
  open.faces.pop_back();
  for (auto& f : inside_out.faces) std::swap(f[0], f[1]);
  std::swap(one_turned.faces[3][0], one_turned.faces[3][1]);
  beyond.faces[0][0] = 8;
  CHECK_REFUSED(polyhedron_moments<double>(open, 1, 2), OutsideDomain);
  CHECK_REFUSED(polyhedron_moments<double>(inside_out, 1, 2), OutsideDomain);
  CHECK_REFUSED(polyhedron_moments<double>(one_turned, 1, 2), OutsideDomain);
  CHECK_REFUSED(polyhedron_moments<double>(beyond, 1, 2), OutsideDomain);
  CHECK_REFUSED(sphere_body(1, 1, 1), OutsideDomain);
  auto moments = ellipsoid_moments<double>(1, {3, 2, 1}, 4);
  CHECK_REFUSED(extended_body(moments, 0), OutsideDomain);
  moments.set(4, 0, 0, moments(2, 0, 0) * moments(2, 0, 0) * 0.9);  // below the square of the second
  CHECK_REFUSED(extended_body(moments, 3), OutsideDomain);
  moments.set(4, 0, 0, std::nan(""));
  CHECK_REFUSED(extended_body(moments, 3), NotFinite);
  auto thin = ellipsoid_moments<double>(1, {3, 2, 1}, 2);
  thin.set(2, 0, 0, -0.1);
  CHECK_REFUSED(extended_body(thin, 3), UnphysicalInertia);
  auto massless = ellipsoid_moments<double>(1, {3, 2, 1}, 2);
  massless.set(0, 0, 0, -1);
  CHECK_REFUSED(extended_body(massless, 3), OutsideDomain);
}

BOOST_AUTO_TEST_SUITE_END()
