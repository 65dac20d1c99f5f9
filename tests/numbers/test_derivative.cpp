// The derivative of a callable is the one in closed form: of numbers, vectors and matrices, in more variables
// than a batch has, nested, and exactly over the rationals and over a prime field.
#include <boost/test/unit_test.hpp>

#include "actio/numbers/derivative.hpp"
#include "actio/numbers/second_order.hpp"
#include "actio/numbers/taylor.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"

using namespace actio;

namespace {

constexpr int variables = 2 * batch + 1;

/// \f$\sum_k (k + 1)\,x_k^2\,x_{k+1}\f$, the last factor of the last term being \f$x_0\f$.
struct Cubic {
  template <class T, int n>
  T operator()(Matrix<T, n, 1> const& x) const {
    T sum(0);
    for (Index k = 0; k < x.size(); ++k) sum += x[k] * x[k] * x[(k + 1) % x.size()] * T(Base<T>(k + 1));
    return sum;
  }
};
/// Its gradient, by hand.
template <class S, int n>
Matrix<S, n, 1> gradient_of_cubic(Matrix<S, n, 1> const& x) {
  Index const size = x.size();
  Matrix<S, n, 1> d(x);
  for (Index k = 0; k < size; ++k) {
    Index const before = (k + size - 1) % size;
    d[k] = x[k] * x[(k + 1) % size] * S(2 * (k + 1)) + x[before] * x[before] * S(before + 1);
  }
  return d;
}

/// The rational map \f$x \mapsto (x_0/x_1,\ x_1x_2)\f$.
struct Ratios {
  template <class T>
  Matrix<T, 2, 1> operator()(Matrix<T, 3, 1> const& x) const { return {x[0] / x[1], x[1] * x[2]}; }
};

template <class S, int n>
Matrix<S, n, 1> some_point() {
  Matrix<S, n, 1> x;
  for (int k = 0; k < n; ++k) x[k] = ratio<S>(2 * k + 3, k + 2);
  return x;
}

/// What does not depend on rounding: the checks over an exact arithmetic.
template <class S>
void exact_derivatives() {
  auto const x = some_point<S, variables>();
  auto const cubic = derivative(Cubic{}, x);
  BOOST_TEST((cubic.value == Cubic{}(x)));
  BOOST_TEST((cubic.gradient() == gradient_of_cubic(x)));
  for (int k = 0; k < variables; ++k) BOOST_TEST((cubic.partial(k) == gradient_of_cubic(x)[k]));

  auto const y = some_point<S, 3>();
  auto const ratios = derivative(Ratios{}, y);
  Matrix<S, 2, 3> expected = Matrix<S, 2, 3>::Zero();
  expected(0, 0) = S(1) / y[1], expected(0, 1) = -y[0] / (y[1] * y[1]), expected(1, 1) = y[2],
              expected(1, 2) = y[1];
  BOOST_TEST((ratios.matrix == expected));
  BOOST_TEST((ratios.partial(1) == expected.col(1)));

  // Nested: the derivative of the gradient is symmetric, and along a direction it is that of the cubic in
  // closed form.
  auto const hessian = derivative([](auto const& z) { return derivative(Cubic{}, z).gradient(); }, x).matrix;
  BOOST_TEST((hessian == hessian.transpose()));
  auto const by_hand = derivative([](auto const& z) { return gradient_of_cubic(z); }, x).matrix;
  BOOST_TEST((hessian == by_hand));
  auto const w = some_point<S, variables>();
  BOOST_TEST(
      (derivative_along([](auto const& z) { return gradient_of_cubic(z); }, x, w).rate == hessian * w));

  // A map from matrices to matrices, with the variables column by column.
  Matrix<S, 2, 2> A;
  A << S(2), S(1), S(-1), S(3);
  auto const square = derivative([](auto const& m) { return m * m; }, A);
  BOOST_TEST((square.value == A * A));
  for (int b = 0; b < 2; ++b)
    for (int a = 0; a < 2; ++a) {
      Matrix<S, 2, 2> E = Matrix<S, 2, 2>::Zero();
      E(a, b) = S(1);
      BOOST_TEST((square.partial(2 * b + a) == E * A + A * E));
    }
  // A number in the shape of its variables: the derivative of the determinant is the matrix of cofactors.
  auto const cofactors =
      derivative([](auto const& m) { return m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0); }, A).gradient();
  Matrix<S, 2, 2> cofactors_by_hand;
  cofactors_by_hand << S(3), S(1), S(-1), S(2);
  BOOST_TEST((cofactors == cofactors_by_hand));

  // A curve of matrices.
  auto const curve = [&](auto const& t) { return A.template cast<std::decay_t<decltype(t)>>() * (t * t); };
  auto const [place, velocity] = derivative(curve, S(3));
  BOOST_TEST((place == A * S(9)));
  BOOST_TEST((velocity == A * S(6)));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(derivatives)

BOOST_AUTO_TEST_CASE(derivatives_are_exact_over_the_rationals) {
  WithArithmetic const exactly(Arithmetic::rationals());
  exact_derivatives<Number>();
}

BOOST_AUTO_TEST_CASE(derivatives_are_exact_over_a_prime_field) {
  WithArithmetic const modulo_a_prime(Arithmetic::prime_field());
  exact_derivatives<Number>();
}

BOOST_AUTO_TEST_CASE(derivatives_in_double_are_those_of_closed_forms_to_rounding) {
  Draw draw(5);
  auto const x = draw.vector<double, Matrix<double, variables, 1>>(variables);
  auto const waves = [](auto const& z) {
    using std::exp, std::sin;
    return sin(z[0] * z[variables - 1]) * exp(z[2]);
  };
  auto const d = derivative(waves, x);
  double const s = std::sin(x[0] * x[variables - 1]), c = std::cos(x[0] * x[variables - 1]),
               e = std::exp(x[2]);
  // Each derivative is a product of a few numbers of size 1.
  double const bound = 16 * epsilon<double>();
  for (int k = 0; k < variables; ++k) {
    double const expected = k == 0               ? c * e * x[variables - 1]
                            : k == 2             ? s * e
                            : k == variables - 1 ? c * e * x[0]
                                                 : 0.0;
    BOOST_TEST(std::abs(d.matrix(0, k) - expected) <= bound, "variable " << k);
  }
  BOOST_TEST(d.value == waves(x));
}

BOOST_AUTO_TEST_CASE(a_number_of_variables_that_is_known_at_run_time_alone) {
  WithArithmetic const exactly(Arithmetic::rationals());
  Matrix<Number, Dynamic, 1> x(5);
  for (int k = 0; k < 5; ++k) x[k] = ratio<Number>(k + 1, 3);
  auto const d = derivative(Cubic{}, x);
  BOOST_TEST((d.gradient() == gradient_of_cubic(x)));
  auto const doubled = derivative([](auto const& z) { return z * 2; }, x);
  BOOST_TEST((doubled.matrix == Matrix<Number>::Identity(5, 5) * Number(2)));
}

BOOST_AUTO_TEST_CASE(the_root_of_the_square_of_a_series_is_the_series) {
  // Whole numbers divided by four: exact in double.
  std::vector<double> const root{2, 3, -1, 5, 7};
  auto const series = Taylor<double>::series(root);
  auto const found = sqrt(series * series);
  BOOST_TEST(found.order == 4);
  for (int k = 0; k <= 4; ++k) BOOST_TEST(found.coefficient(k) == root[k]);
}

BOOST_AUTO_TEST_CASE(numbers_to_second_order_are_equal_in_all_their_parts_only) {
  WithArithmetic const exactly(Arithmetic::rationals());
  using Bent = SecondOrder<Number, 2>;
  Bent const x = Bent::variable(ratio<Number>(2, 3), 0) * Bent::variable(ratio<Number>(1, 5), 1);
  auto other_value = x, other_slope = x, other_bend = x;
  other_value.value += 1, other_slope.first[1] += 1, other_bend.second[2] += 1;
  BOOST_TEST((x == Bent(x)));
  BOOST_TEST((!(x == other_value) && !(x == other_slope) && !(x == other_bend)));
}

BOOST_AUTO_TEST_CASE(the_size_of_a_number_to_second_order_is_that_of_its_largest_part) {
  SecondOrder<double, 2> value = SecondOrder<double, 2>::variable(0.25, 0) * 0.0, slope = value, bend = value;
  value.value = -3, slope.first[1] = -4, bend.second[2] = -5;
  BOOST_TEST(magnitude(value) == 3);
  BOOST_TEST(magnitude(slope) == 4);
  BOOST_TEST(magnitude(bend) == 5);
}

BOOST_AUTO_TEST_SUITE_END()
