// Functions of the squared angle, against the sums of their series in long double, to which each term comes
// from its own closed form.
#include <boost/test/unit_test.hpp>
#include <numbers>

#include "actio/numbers/functions.hpp"

using namespace actio;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();

/// The K-th derivative at x of the series with these coefficients.
template <int K, class Coefficient>
long double derivative_of_series(Coefficient const& coefficient, long double x) {
  long double sum = 0, power = 1;
  for (int n = K; n < K + 200; ++n, power *= x) {
    long double c = coefficient(n);
    for (int i = 0; i < K; ++i) c *= n - i;
    sum += c * power;
  }
  return sum;
}
/// How far numbers are apart, relative to the second and in units of rounding.
double roundings(double x, long double exact) {
  return static_cast<double>(std::abs((x - exact) / exact)) / eps;
}

/// \f$\binom{2n}{n}/(4^n(2n+1))\f$, of \f$\arcsin\sqrt x/\sqrt x\f$.
long double of_arcsine(int n) {
  return std::exp(std::lgamma(2.0L * n + 1) - 2 * std::lgamma(n + 1.0L) - 2 * n * std::log(2.0L)) /
         (2 * n + 1);
}
/// \f$2\zeta(2m)/(2\pi)^{2m}\f$ with m = n + 1, by Bernoulli's numbers.
long double of_half_cotangent(int n) {
  long double const s = 2.0L * (n + 1), end = n < 10 ? 2000 : 60;
  long double zeta = 0;
  for (long double k = end - 1; k > 0; --k) zeta += std::pow(k, -s);
  // The rest of the sum is an integral, to which Euler and Maclaurin's terms are added.
  zeta += std::pow(end, 1 - s) / (s - 1) + std::pow(end, -s) / 2 + s * std::pow(end, -s - 1) / 12;
  return 2 * zeta / std::pow(2 * std::numbers::pi_v<long double>, s);
}

// Next to 1/64 from both sides, where the number of terms changes.
constexpr double small[] = {-0.2499, -1.0 / 63, -1.0 / 65, -1e-5, 0, 1e-5, 1.0 / 65, 1.0 / 63, 0.2499};

// Each coefficient of the cotangent is 1/39 of the one before and the difference of terms of which one is
// 1/12 of that: its error is about 39/12 times as large.
template <int K>
void derivatives_are_those_of_the_series() {
  for (double const x : small) {
    BOOST_TEST_CONTEXT("derivative " << K << " at " << x) {
      BOOST_TEST(roundings(asinc_derivative<K>(x), derivative_of_series<K>(of_arcsine, x)) <= 4);
      BOOST_TEST(roundings(half_cotangent_derivative<K>(x), derivative_of_series<K>(of_half_cotangent, x)) <=
                 4 * std::pow(39. / 12, K));
    }
  }
}
template <int K>
void stumpff_is_its_series() {
  for (double const x : {-0.99, -1.0 / 63, -1.0 / 65, 0.0, 1.0 / 65, 1.0 / 63, 0.99, 1.01, 7.0, 30.0}) {
    long double sum = 0, term = 1;
    for (int i = 2; i <= K; ++i) term /= i;
    for (int n = 0; n < 60; ++n) {
      sum += term;
      term *= -static_cast<long double>(x) / ((2.0L * n + K + 1) * (2.0L * n + K + 2));
    }
    BOOST_TEST_INFO("c_" << K << " at " << x);
    BOOST_TEST(std::abs(static_cast<double>(stumpff<K>(x) - sum)) * factorial(K) <= (x > 1 ? 16 : 2) * eps);
  }
}
}  // namespace

BOOST_AUTO_TEST_SUITE(functions)

BOOST_AUTO_TEST_CASE(derivatives_of_series_are_right_to_rounding_on_both_sides_of_their_switch) {
  derivatives_are_those_of_the_series<0>();
  derivatives_are_those_of_the_series<1>();
  derivatives_are_those_of_the_series<2>();
  derivatives_are_those_of_the_series<3>();
}

BOOST_AUTO_TEST_CASE(stumpffs_functions_are_right_to_rounding) {
  stumpff_is_its_series<0>();
  stumpff_is_its_series<1>();
  stumpff_is_its_series<2>();
  stumpff_is_its_series<3>();
  stumpff_is_its_series<4>();
}

// The rate of a dual number is the derivative of the series, or of the closed form.
BOOST_AUTO_TEST_CASE(dual_numbers_carry_the_derivatives_of_the_series) {
  auto const moved = [](double x) {
    Dual<double> m(x);
    m.part[0] = -3;
    return m;
  };
  auto const stumpff_slope = [](int k, long double x) {
    long double sum = 0, term = -1;  // -1/(2 + k)!, and so on, times n
    for (int i = 2; i <= 2 + k; ++i) term /= i;
    for (int n = 1; n < 60; ++n) {
      sum += n * term;
      term *= -x / ((2.0L * n + k + 1) * (2.0L * n + k + 2));
    }
    return static_cast<double>(sum);
  };
  for (double const x : {-0.9, -1.0 / 65, 0.0, 1.0 / 63, 0.99, 1.01, 7.0, 30.0}) {
    BOOST_TEST_CONTEXT("at " << x) {
      auto const close = [&](Dual<double> const& found, double value, double slope) {
        BOOST_TEST(found.value == value);
        BOOST_TEST(std::abs(found.part[0] + 3 * slope) <= 128 * eps);
      };
      close(stumpff<0>(moved(x)), stumpff<0>(x), stumpff_slope(0, x));
      close(stumpff<1>(moved(x)), stumpff<1>(x), stumpff_slope(1, x));
      close(stumpff<2>(moved(x)), stumpff<2>(x), stumpff_slope(2, x));
      close(stumpff<3>(moved(x)), stumpff<3>(x), stumpff_slope(3, x));
      // b = (1 - (y/2) cot(y/2))/x with y = sqrt(x), and its derivative; by its series below 1.
      long double const y = std::sqrt(std::abs(static_cast<long double>(x))), c = 1 / std::tan(y / 2);
      double const b = x < 1 ? half_cotangent_derivative<0>(x) : static_cast<double>((1 - y / 2 * c) / x);
      double const slope = x < 1 ? static_cast<double>(derivative_of_series<1>(of_half_cotangent, x))
                                 : static_cast<double>((y * (1 + c * c) / 8 - c / 4) / y / x - b / x);
      BOOST_TEST(std::abs(half_cotangent(x) - b) <= 16 * eps * (1 + b));
      auto const found = half_cotangent(moved(x));
      BOOST_TEST(std::abs(found.value - b) <= 16 * eps * (1 + b));
      BOOST_TEST(std::abs(found.part[0] + 3 * slope) <= 128 * eps * (1 + std::abs(slope)) * (1 + b));
    }
  }
  for (double const x : {-0.2, 0.0, 0.24})
    BOOST_TEST(
        roundings(asinc_derivative<0>(moved(x)).part[0], -3 * derivative_of_series<1>(of_arcsine, x)) <= 8);
}

BOOST_AUTO_TEST_SUITE_END()
