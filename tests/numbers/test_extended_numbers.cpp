// Dual numbers against truncated polynomials, of which they are quotients.
#include <boost/test/unit_test.hpp>

#include <random>

#include "actio/numbers/dual.hpp"
#include "actio/numbers/multiprecision.hpp"
#include "actio/numbers/second_order.hpp"
#include "actio/numbers/square_root.hpp"

using namespace actio;

namespace {

std::mt19937_64 source(7);
/// k/7 with k from 1 to 13.
template <class S>
S drawn() { return ratio<S>(1 + static_cast<long>(source() % 13), 7); }
template <class S, int m>
SecondOrder<S, m> drawn_polynomial() {
  SecondOrder<S, m> x(drawn<S>());
  for (S& f : x.first) f = drawn<S>();
  for (S& s : x.second) s = drawn<S>() - S(1);
  return x;
}

/// What is left where all products vanish.
template <int N, class S>
Dual<S, N> quotient(SecondOrder<S, N> const& x) {
  Dual<S, N> y(x.value);
  for (int a = 0; a < N; ++a) y.part[a] = x.first[a];
  return y;
}

/// Everything that numbers of one kind can do with one another and with constants.
struct FieldOperations {
  template <class T>
  std::vector<T> operator()(T const& x, T const& y) const {
    using B = Base<T>;
    B const c = ratio<B>(3, 5);
    std::vector<T> all{x + y, x - y, -x,    +x,    x * y, x / y, x + 3, 3 + x, x - 3, 3 - x, x * 3, 3 * x,
                       x / 3, 3 / x, x + c, c + x, x - c, c - x, x * c, c * x, x / c, c / x, T(c),  T(5)};
    all.push_back(x * x * y - x / (y * y));
    all.push_back(x * (x + y) / (c + y));
    T z = x;
    z += y, all.push_back(z);
    z -= x, all.push_back(z);
    z *= y, all.push_back(z);
    z /= x, all.push_back(z);
    z *= c, all.push_back(z);
    z /= 3, all.push_back(z);
    T const before = z;
    add_product(z, x, y);
    all.push_back(z);
    all.push_back(z - before);
    return all;
  }
};
struct Functions {
  template <class T>
  std::vector<T> operator()(T const& x, T const& y) const {
    return {sqrt(x), exp(y), log(x), sin(x), cos(y), pow(x, -1.5), square_root(T(x * y))};
  }
};

/// Quotients of what is done with polynomials are what is done with quotients, to `bound`.
template <class T, class S, int m, class Take, class Operations>
void same_of(SecondOrder<S, m> const& x, SecondOrder<S, m> const& y, Take const& take,
             Operations const& operations, double bound) {
  auto const all = operations(x, y);
  std::vector<T> const quotients = operations(take(x), take(y));
  BOOST_TEST_REQUIRE(all.size() == quotients.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    T const expected = take(all[k]);
    BOOST_TEST(to_double(magnitude(T(quotients[k] - expected))) <= bound * to_double(1 + magnitude(expected)),
               "operation " << k);
    if (bound == 0) BOOST_TEST((quotients[k] == expected));
  }
}
template <int N, class S, class Operations>
void duals_agree(Operations const& operations, double bound) {
  auto const take = [](SecondOrder<S, N> const& x) { return quotient<N>(x); };
  same_of<Dual<S, N>>(drawn_polynomial<S, N>(), drawn_polynomial<S, N>(), take, operations, bound);
}

// Sums of a few products of numbers below 14 that are divided up to four times by one above 1/7: a term is at
// most 10^4 times as large as their sum, and each is rounded a few times.
double const rounding = 1e5 * epsilon<double>();

}  // namespace

BOOST_AUTO_TEST_SUITE(extended_numbers)

BOOST_AUTO_TEST_CASE(a_dual_number_is_a_quotient_of_truncated_polynomials) {
  for (int k = 0; k < 2; ++k) {
    duals_agree<2, rational>(FieldOperations{}, 0);
    duals_agree<3, rational>(FieldOperations{}, 0);
    duals_agree<1, double>(FieldOperations{}, rounding);
    duals_agree<2, double>(FieldOperations{}, rounding);
    duals_agree<3, double>(FieldOperations{}, rounding);
    duals_agree<5, double>(FieldOperations{}, rounding);
    duals_agree<2, double>(Functions{}, rounding);
    duals_agree<3, double>(Functions{}, rounding);
  }
}

namespace {
/// The angle and the absolute value of numbers of a kind, in all octants.
template <class T>
void angles(T const& radius, T const& turn) {
  for (int k = -3; k <= 4; ++k) {
    // pi/4 k is the value of the angle but for a part of an octant.
    T const angle = turn + (M_PI / 4 * k - 0.5);
    T const found = atan2(T(radius * sin(angle)), T(radius * cos(angle)));
    BOOST_TEST(magnitude(T(found - angle)) <= rounding * (1 + magnitude(angle)), "octant " << k);
  }
  BOOST_TEST((abs(T(-radius)) == radius));
  BOOST_TEST((abs(radius) == radius));
}
}  // namespace

BOOST_AUTO_TEST_CASE(an_angle_has_the_rates_of_the_turn) {
  auto u = drawn_polynomial<double, 3>(), v = drawn_polynomial<double, 3>();
  v.value = 0.3;
  angles(quotient<3>(u), quotient<3>(v));
}

BOOST_AUTO_TEST_SUITE_END()
