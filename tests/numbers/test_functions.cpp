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

BOOST_AUTO_TEST_SUITE_END()
