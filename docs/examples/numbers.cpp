// Examples of the modules matrices, numbers, linear_algebra, groups, forms and formula.
#include "actio/formula/parse_formula.hpp"
#include "actio/forms/forms.hpp"
#include "actio/forms/metric.hpp"
#include "actio/groups/differential.hpp"
#include "actio/groups/direct_product.hpp"
#include "actio/groups/motions.hpp"
#include "actio/groups/solve.hpp"
#include "actio/groups/spanned_group.hpp"
#include "actio/linear_algebra/eigenvalues.hpp"
#include "actio/linear_algebra/iex.hpp"
#include "actio/linear_algebra/linear.hpp"
#include "actio/linear_algebra/matrix_logarithm.hpp"
#include "actio/linear_algebra/rank.hpp"
#include "actio/matrices/matrix.hpp"
#include "actio/numbers/derivative.hpp"
#include "actio/numbers/gauss_quadrature.hpp"
#include "actio/numbers/multiprecision.hpp"
#include "actio/numbers/taylor.hpp"
#include "actio/variational/action.hpp"

#include "example.hpp"

BOOST_AUTO_TEST_SUITE(examples_of_numbers)
using namespace actio;

// ---- matrices

BOOST_AUTO_TEST_CASE(matrices_over_any_scalar) {
  // [matrix]
  Matrix<rational, 2, 2> A;
  A << rational(1), rational(1, 2), rational(0), rational(3);
  Vector<rational, 2> const v(rational(2), rational(4));
  assert((A * v)[0] == 4 && (A * v)[1] == 12);  // no rounding over the rationals
  assert(A.trace() == 4 && (A.transpose() * A)(0, 1) == rational(1, 2));
  // [matrix]
}

// ---- numbers

BOOST_AUTO_TEST_CASE(derivatives) {
  // [derivative]
  auto const f = [](auto const& t) { using std::sin; return sin(t) * t; };
  auto const [value, rate] = derivative(f, 2.0);
  assert(std::abs(rate - (2 * std::cos(2.0) + std::sin(2.0))) < 1e-15);  // no step size, no error of one

  auto const g = [](auto const& x) { return x[0] * x[0] * x[1]; };
  auto const slope = derivative(g, Vector<double, 2>(3, 5)).gradient();
  assert(slope[0] == 30 && slope[1] == 9);
  // [derivative]
}

BOOST_AUTO_TEST_CASE(derivative_along_a_direction) {
  // [derivative_along]
  auto const turned = []<class T>(Vector<T, 2> const& x) { return Vector<T, 2>(T(-x[1]), x[0] * x[0]); };
  auto const [value, rate] = derivative_along(turned, Vector<double, 2>(2, 1), Vector<double, 2>(1, 3));
  assert(rate[0] == -3 && rate[1] == 4);
  // [derivative_along]
}

BOOST_AUTO_TEST_CASE(power_series) {
  // [taylor]
  auto const t = Taylor<double>::series({0, 1, 0, 0, 0, 0});  // known up to t^5
  auto const s = sin(t);
  assert(std::abs(s.coefficients[3] + 1.0 / 6) < 1e-16 && std::abs(s.coefficients[5] - 1.0 / 120) < 1e-16);
  // [taylor]
}

BOOST_AUTO_TEST_CASE(integrals) {
  // [quadrature]
  Quadrature<double> const rule(12);
  double const area = rule([](double x) { return std::exp(x); }, 0.0, 1.0);
  assert(std::abs(area - (std::numbers::e - 1)) < 1e-15);
  // [quadrature]
}

BOOST_AUTO_TEST_CASE(many_digits) {
  // [digits]
  auto const f = [](auto const& t) { using std::exp; return exp(t * t); };
  dec50 const rate = derivative(f, dec50(1)).rate;  // the same function, in fifty digits
  assert(abs(rate - 2 * exp(dec50(1))) < dec50("1e-48"));
  // [digits]
}

// ---- linear_algebra

BOOST_AUTO_TEST_CASE(linear_systems) {
  // [solve_linear]
  Matrix<double, 2, 2> A;
  A << 2.0, 1.0, 1.0, 3.0;
  Vector<double, 2> const x = solve_linear(A, Vector<double, 2>(4, 7));
  assert((A * x - Vector<double, 2>(4, 7)).norm() < 1e-15);
  A << 1.0, 2.0, 2.0, 4.0;
  BOOST_CHECK_THROW(solve_linear(A, Vector<double, 2>(1, 1)), Singular);  // and not a large number
  // [solve_linear]
  // [matrix_rank]
  assert(matrix_rank(A) == 1);
  // [matrix_rank]
}

BOOST_AUTO_TEST_CASE(exponentials_of_matrices) {
  // [iex]
  // A path exp(eta(t)) has the velocity iex(ad_eta) eta' (on the right).
  auto const eta = velocity(SO<3>{}, Vector<double, 3>(0.9, 0, 0)),
             rate = velocity(SO<3>{}, Vector<double, 3>(0, 1, 0));
  double const e = 1e-6;
  auto const moved = log(exp(eta + e * rate) * exp(-eta)) / e;
  assert((moved.coordinates - iex(ad_matrix(eta)) * rate.coordinates).norm() < 1e-6);
  // [iex]
  // [matrix_exponential]
  Matrix<double, 2, 2> turn;
  turn << 0.0, -1.0, 1.0, 0.0;
  auto const R = matrix_exponential(turn);
  assert(std::abs(R(0, 0) - std::cos(1.0)) < 1e-15 && std::abs(R(1, 0) - std::sin(1.0)) < 1e-15);
  assert((matrix_logarithm(R) - turn).norm() < 1e-14);
  // [matrix_exponential]
}

// ---- groups

BOOST_AUTO_TEST_CASE(elements_velocities_momenta) {
  // [group]
  SO<3> const group;
  auto const xi = velocity(group, Vector<double, 3>(0, 0, 0.5));  // half a radian about e_3
  auto const mu = momentum(group, Vector<double, 3>(1, 2, 3));
  auto const g = exp(xi), twice = g * g;
  assert(std::abs(log(twice).coordinates[2] - 1.0) < 1e-15);
  assert(pair(mu, xi) == 1.5);
  assert(log(inverse(g) * g).coordinates.norm() < 1e-15);
  // [group]
  // [adjoint]
  auto const eta = velocity(group, Vector<double, 3>(1, 0, 0));
  assert(std::abs(pair(Ad_star(g, mu), eta) - pair(mu, Ad(g, eta))) < 1e-15);  // Ad* is the transpose of Ad
  auto const turned = ad(xi, eta);  // on SO(3) the cross product
  assert((turned.coordinates - Vector<double, 3>(0, 0.5, 0)).norm() < 1e-15);
  // [adjoint]
}

BOOST_AUTO_TEST_CASE(rigid_motions_of_the_plane) {
  // [motions]
  // SE(2): a quarter of a turn while one moves ahead by pi/2 leads along a quarter of a circle of radius 1.
  double const quarter = std::numbers::pi / 2;
  auto const g = exp(velocity(SE<2>{}, Vector<double, 3>(quarter, quarter, 0)));
  assert(std::abs(g.value(0, 2) - 1) < 1e-15 && std::abs(g.value(1, 2) - 1) < 1e-15);
  // [motions]
}

BOOST_AUTO_TEST_CASE(differentials_on_a_group) {
  // [differential]
  // f(g) = tr g on SO(3): how it changes when g becomes exp(eps e_a) g.
  auto const f = [](auto const& g) { return g.value.trace(); };
  auto const g = exp(velocity(SO<3>{}, Vector<double, 3>(0, 0, 0.5)));
  auto const slope = right_differential(f, g);  // a momentum
  assert((slope.components - Vector<double, 3>(0, 0, -2 * std::sin(0.5))).norm() < 1e-15);
  // [differential]
}

BOOST_AUTO_TEST_CASE(newton_on_a_group) {
  // [solve_on_group]
  // The rotation g that takes e_3 to b and turns e_1 as little as that allows: three equations on SO(3).
  Vector<double, 3> const b(0.6, 0, 0.8);
  auto const residual = [&]<class T>(Element<SO<3>, T> const& g) {
    Vector<T, 3> const image = g.value.col(2);
    return momentum(g.group, Vector<T, 3>(image[0] - T(b[0]), image[1] - T(b[1]), g.value(1, 0)));
  };
  auto const [g, report] = solve_on_group(residual, identity<double>(SO<3>{}));
  assert((g.value.col(2) - b).norm() < 1e-15 && report.evaluations < 8);
  // [solve_on_group]
}

BOOST_AUTO_TEST_CASE(group_from_a_basis) {
  // [spanned_group]
  // The Heisenberg group, from a basis of its algebra: everything else follows.
  using M = SpannedGroup::WholeMatrix;
  M x = M::Zero(3, 3), y = M::Zero(3, 3), z = M::Zero(3, 3);
  x(0, 1) = y(1, 2) = z(0, 2) = 1;
  SpannedGroup const heisenberg("H", {x, y, z});
  auto const e = [&](int a) { return basis_velocity<double>(heisenberg, a); };
  assert(bracket(e(0), e(1)).coordinates[2] == 1);
  BOOST_CHECK_THROW(SpannedGroup("none", {x, y}), OutsideDomain);  // [x, y] is not in the span
  // [spanned_group]
}

// ---- forms

BOOST_AUTO_TEST_CASE(differential_forms) {
  // [forms]
  // omega = x dy on the plane; a form is a callable (point, tangents).
  auto const omega = []<class S>(Vector<S, 2> const& at, Tangents<S, 2, 1> const& V) {
    return S(at[0] * V(1, 0));
  };
  auto const d_omega = exterior_derivative(omega);  // dx ^ dy
  Tangents<double, 2, 2> const sides = Tangents<double, 2, 2>::Identity();
  assert(d_omega(Vector<double, 2>(3, 7), sides) == 1);
  // [forms]
}

BOOST_AUTO_TEST_CASE(metrics) {
  // [metric]
  // The plane in polar coordinates (r, a): a metric is a callable point -> matrix.
  auto const polar = []<class S>(Vector<S, 2> const& y) {
    Matrix<S, 2, 2> g;
    g << S(1), S(0), S(0), S(y[0] * y[0]);
    return g;
  };
  auto const outwards = []<class S>(Vector<S, 2> const& y) { return Vector<S, 2>(y[0], S(0)); };  // r e_r
  assert(std::abs(divergence(polar, outwards, Vector<double, 2>(2, 0.3)) - 2) < 1e-15);
  assert(christoffel(polar, Vector<double, 2>(2, 0.3))[0](1, 1) == -2);  // Gamma^r_aa = -r
  // [metric]
}

// ---- formula

BOOST_AUTO_TEST_CASE(formulas_as_texts) {
  // [parse_formula]
  Tape const l = parse_formula("e = c*v^2; (w^2 + e)/2", {"w", "v"}, {{"c", 6}});
  auto const value = [&]<class T>(Vector<T, 2> const& x) {
    std::vector<T> work;
    T y;
    l(x.data(), &y, work);
    return y;
  };
  assert(value(Vector<double, 2>(1, 2)) == 12.5);
  assert(derivative(value, Vector<double, 2>(1, 2)).gradient()[1] == 12);  // over dual numbers as well
  BOOST_CHECK_THROW(parse_formula("2*u", {"w", "v"}), FormulaError);
  // [parse_formula]
  // [read_formula]
  ReadFormula const m = read_formula("(w^2 + side)/2", {"w", "v"}, {{"c", 6}}, {}, {{"side", "c*v^2"}});
  assert(m.used.contains("side") && m.used.contains("c"));
  // [read_formula]
}

BOOST_AUTO_TEST_SUITE_END()
