// Functions of power series in the time, over the rationals where their values at t = 0 are rational.
#include <boost/test/unit_test.hpp>

#include "actio/numbers/taylor.hpp"

using namespace actio;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr int order = 12;
using Series = Taylor<double>;

/// \f$c_k\f$ = f(k).
template <class Coefficient>
Series series_of(Coefficient const& f) {
  std::vector<double> c;
  for (int k = 0; k <= order; ++k) c.push_back(f(k));
  return Series::series(c);
}
Series time() {
  return series_of([](int k) { return k == 1 ? 1.0 : 0.0; });
}
/// A series whose coefficients all count and become smaller.
Series some(double first, double ratio) {
  return series_of([&](int k) { return first * std::pow(ratio, k) * (k % 3 == 1 ? -1 : 1) / (1 + k % 4); });
}
/// The largest difference of two coefficients.
double apart(Series const& x, Series const& y) {
  BOOST_TEST(x.order == y.order);
  double worst = 0;
  for (int k = 0; k <= order; ++k) worst = std::max(worst, std::abs(x.coefficient(k) - y.coefficient(k)));
  return worst;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(taylor_series)

BOOST_AUTO_TEST_CASE(functions_of_the_time_have_the_series_of_the_textbook) {
  double factorial[order + 1] = {1};
  for (int k = 1; k <= order; ++k) factorial[k] = k * factorial[k - 1];
  Series const t = time();
  BOOST_TEST(apart(exp(t), series_of([&](int k) { return 1 / factorial[k]; })) <= eps);
  BOOST_TEST(apart(log(1.0 + t), series_of([](int k) { return k == 0 ? 0 : (k % 2 ? 1.0 : -1.0) / k; })) <=
             order * eps);
  BOOST_TEST(apart(sin(t), series_of([&](int k) {
                     return k % 2 == 0 ? 0 : (k % 4 == 1 ? 1 : -1) / factorial[k];
                   })) <= eps);
  BOOST_TEST(apart(cos(t), series_of([&](int k) {
                     return k % 2 == 1 ? 0 : (k % 4 == 0 ? 1 : -1) / factorial[k];
                   })) <= eps);
  BOOST_TEST(apart(1.0 / (1.0 - t), series_of([](int) { return 1.0; })) == 0);
  double binomial = 1;
  BOOST_TEST(apart(sqrt(1.0 + t), series_of([&](int k) {
                     if (k > 0) binomial *= (1.5 - k) / k;
                     return binomial;
                   })) <= order * eps);
  BOOST_TEST(apart(atan2(t, Series(1.0)), series_of([](int k) {
                     return k % 2 == 0 ? 0 : (k % 4 == 1 ? 1.0 : -1.0) / k;
                   })) <= order * eps);
}

// Recurrences of twelve coefficients below 2, of which each sums products with those before.
BOOST_AUTO_TEST_CASE(functions_undo_one_another) {
  Series const x = some(1.5, 0.6), y = some(0.7, -0.5);
  double const bound = 200 * eps;
  BOOST_TEST(apart(log(exp(x)), x) <= bound);
  BOOST_TEST(apart(exp(log(x)), x) <= bound);
  BOOST_TEST(apart(sqrt(x) * sqrt(x), x) <= bound);
  BOOST_TEST(apart((x / y) * y, x) <= bound);
  BOOST_TEST(apart(sin(x) * sin(x) + cos(x) * cos(x), Series(1.0) + 0.0 * x) <= bound);
  BOOST_TEST(apart(atan2(y * sin(x), y * cos(x)), x) <= bound);
  BOOST_TEST(apart(atan2(y * sin(x), y * cos(x)), y) > 0.1);
  BOOST_TEST(apart(abs(-x), x) == 0);
}

BOOST_AUTO_TEST_CASE(a_derivative_is_known_to_one_power_less) {
  Series const x = some(1.5, 0.6), rate = derivative(x);
  BOOST_TEST(rate.order == order - 1);
  for (int k = 0; k < order; ++k) BOOST_TEST(rate.coefficient(k) == (k + 1) * x.coefficient(k + 1));
  BOOST_TEST(derivative(Series(3.0)).coefficient(0) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
