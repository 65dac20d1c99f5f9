// Power series that are known to different orders, constants among them, against sums over all pairs of
// coefficients.
#include <boost/test/unit_test.hpp>

#include <random>

#include "actio/numbers/taylor.hpp"
#include "witness/number.hpp"

using namespace actio;

namespace {

using Q = Number;
constexpr int all = Taylor<Q>::all;
std::mt19937_64 source(3);

/// A series that is known up to `order`, of which the first `stored` coefficients are drawn and the others
/// are zero.
template <class S>
Taylor<S> drawn(int order, int stored) {
  std::vector<S> c;
  for (int k = 0; k < stored; ++k)
    c.push_back(ratio<S>(1 + static_cast<long>(source() % 13), k == 0 ? 3 : 7));
  Taylor<S> x = Taylor<S>::series(c);
  x.order = order;
  return x;
}
template <class S>
std::vector<Taylor<S>> some() {
  std::vector<Taylor<S>> found;
  for (auto const& [order, stored] :
       {std::pair(all, 1), {0, 1}, {1, 2}, {3, 2}, {5, 6}, {6, 1}, {7, 8}, {7, 3}})
    found.push_back(drawn<S>(order, stored));
  return found;
}
/// The k-th coefficient of a product.
template <class S>
S of_product(Taylor<S> const& x, Taylor<S> const& y, int k) {
  S sum(0);
  for (int i = 0; i <= k; ++i) sum += x.coefficient(i) * y.coefficient(k - i);
  return sum;
}
/// Known to this order, with these coefficients and none behind.
template <class S, class F>
bool is(Taylor<S> const& x, int order, F const& coefficient, S const& bound = S(0)) {
  bool same = x.order == order && (order == all ? x.stored() == 1 : x.stored() <= order + 1);
  for (int k = 0; k <= (order == all ? 3 : order); ++k)
    same = same && magnitude(S(x.coefficient(k) - coefficient(k))) <= bound;
  return same;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(taylor_orders)

BOOST_AUTO_TEST_CASE(a_result_is_known_as_far_as_both_operands_are) {
  WithArithmetic const exactly(Arithmetic::rationals());
  for (auto const& x : some<Q>())
    for (auto const& y : some<Q>()) {
      int const order = std::min(x.order, y.order);
      BOOST_TEST_CONTEXT("orders " << x.order << " and " << y.order) {
        auto const sum = [&](int k) { return Q(x.coefficient(k) + y.coefficient(k)); };
        auto const difference = [&](int k) { return Q(x.coefficient(k) - y.coefficient(k)); };
        auto const product = [&](int k) { return of_product(x, y, k); };
        auto z = x;
        BOOST_TEST(is(x + y, order, sum));
        BOOST_TEST(is(z += y, order, sum));
        BOOST_TEST(is(x - y, order, difference));
        BOOST_TEST(is((z = x) -= y, order, difference));
        BOOST_TEST(is(x * y, order, product));
        BOOST_TEST(is((z = x) *= y, order, product));
        // What the quotient, times the divisor, gives back.
        auto const quotient = x / y;
        BOOST_TEST((((z = x) /= y) == quotient));
        BOOST_TEST(quotient.order == order);
        for (int k = 0; k <= std::min(order, 9); ++k)
          BOOST_TEST((of_product(quotient, y, k) == x.coefficient(k)));
      }
    }
  for (auto const& x : some<Q>()) {
    BOOST_TEST(is(-x, x.order, [&](int k) { return Q(-x.coefficient(k)); }));
    BOOST_TEST((+x == x));
    Q value(0), power(1);
    for (int k = 0; k < 9; ++k) value += x.coefficient(k) * power, power *= ratio<Q>(2, 5);
    BOOST_TEST((x.at(ratio<Q>(2, 5)) == value));
    if (x.order != all && x.order > 0)
      BOOST_TEST(is(derivative(x), x.order - 1, [&](int k) { return Q(Q(k + 1) * x.coefficient(k + 1)); }));
  }
  BOOST_TEST(is(Taylor<Q>(5), all, [](int k) { return Q(k == 0 ? 5 : 0); }));
  BOOST_TEST(is(Taylor<Q>(), all, [](int) { return Q(0); }));
}

BOOST_AUTO_TEST_CASE(functions_solve_their_differential_equations_at_every_order) {
  // Each coefficient is a sum of up to eight products of numbers below 100, divided by one above 1/3.
  double const bound = 1e4 * epsilon<double>();
  auto const zero = [](int) { return 0.0; };
  for (auto const& drawn_x : some<double>()) {
    auto const x = drawn_x / Taylor<double>(2);
    double const first = x.coefficient(0);
    auto const root = sqrt(x), e = exp(x), l = log(x), s = sin(x), c = cos(x);
    for (auto const& f : {root, e, l, s, c}) BOOST_TEST(f.order == x.order);
    BOOST_TEST(std::abs(root.coefficient(0) - std::sqrt(first)) <= bound);
    BOOST_TEST(std::abs(e.coefficient(0) - std::exp(first)) <= bound);
    BOOST_TEST(std::abs(l.coefficient(0) - std::log(first)) <= bound);
    BOOST_TEST(std::abs(s.coefficient(0) - std::sin(first)) <= bound);
    BOOST_TEST(std::abs(c.coefficient(0) - std::cos(first)) <= bound);
    BOOST_TEST(is(root, x.order, [&](int k) { return root.coefficient(k); }));
    for (int k = 0; k <= std::min(x.order, 9); ++k)
      BOOST_TEST(std::abs(of_product(root, root, k) - x.coefficient(k)) <= bound);
    if (x.order == all || x.order == 0) continue;
    auto const dx = derivative(x);
    BOOST_TEST(is(derivative(e) - e * dx, x.order - 1, zero, bound));
    BOOST_TEST(is(x * derivative(l) - dx, x.order - 1, zero, bound));
    BOOST_TEST(is(derivative(s) - c * dx, x.order - 1, zero, bound));
    BOOST_TEST(is(derivative(c) + s * dx, x.order - 1, zero, bound));
  }
}

BOOST_AUTO_TEST_CASE(the_angle_of_a_constant_and_a_series_turns_as_their_point_does) {
  double const bound = 1e4 * epsilon<double>();
  for (auto const& x : some<double>())
    for (auto const& drawn_y : some<double>()) {
      auto const y = -drawn_y;
      auto const angle = atan2(y, x);
      int const order = std::min(x.order, y.order);
      BOOST_TEST(angle.order == order);
      BOOST_TEST(angle.coefficient(0) == std::atan2(y.coefficient(0), x.coefficient(0)));
      if (order == all || order == 0) continue;
      auto const turning = (x * x + y * y) * derivative(angle) - x * derivative(y) + y * derivative(x);
      BOOST_TEST(is(
          turning, order - 1, [](int) { return 0.0; }, bound));
    }
}

BOOST_AUTO_TEST_CASE(order_is_that_of_the_first_coefficients) {
  using Series = Taylor<double>;
  Series const x = Series::series({2, 5, 1}), same_value = Series::series({2, 7}),
               more = Series::series({3, 0});
  BOOST_TEST((x < more && more > x && x <= more && more >= x));
  BOOST_TEST((!(more < x) && !(x > more) && !(more <= x) && !(x >= more)));
  BOOST_TEST((!(x < same_value) && !(x > same_value) && x <= same_value && x >= same_value));
  BOOST_TEST((!(x == same_value) && !(x == Series::series({2, 5})) && x == Series::series({2, 5, 1, 0})));
  BOOST_TEST((Series::series({2, 5, 1, 0}) == x && !(Series::series({2, 5}) == x)));
  BOOST_TEST((abs(-x) == x && abs(x) == x));
  BOOST_TEST(abs(Series::series({0, -1})).coefficient(1) == -1);
  BOOST_TEST(base_value(x) == 2);
}

BOOST_AUTO_TEST_CASE(size_and_finiteness_are_those_of_all_coefficients) {
  for (int k = 0; k < 3; ++k) {
    std::vector<double> c{1, 1, 1};
    c[k] = -4;
    BOOST_TEST(magnitude(Taylor<double>::series(c)) == 4);
    BOOST_TEST(is_finite(Taylor<double>::series(c)));
    c[k] = std::nan("");
    BOOST_TEST(std::isnan(magnitude(Taylor<double>::series(c))));
    BOOST_TEST(!is_finite(Taylor<double>::series(c)));
  }
}

BOOST_AUTO_TEST_SUITE_END()
