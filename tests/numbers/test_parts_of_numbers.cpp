// Order, size and finiteness of numbers that carry derivatives: each of their parts counts.
#include <boost/test/unit_test.hpp>

#include "actio/numbers/dual.hpp"
#include "actio/numbers/second_order.hpp"

using namespace actio;

namespace {
/// Each number of which a number consists, the value first.
template <class S, int N, class Visit>
void visit_parts(Dual<S, N>& x, Visit const& visit) {
  visit(x.value);
  for (S& p : x.part) visit(p);
}
template <class S, int m, class Visit>
void visit_parts(SecondOrder<S, m>& x, Visit const& visit) {
  visit(x.value);
  for (S& p : x.first) visit(p);
  for (S& p : x.second) visit(p);
}
/// With its k-th part replaced.
template <class T>
T with_part(T x, int k, double part) {
  int at = 0;
  visit_parts(x, [&](auto& p) {
    if (at++ == k) p = part;
  });
  return x;
}
template <class T>
void order_size_and_finiteness(int parts) {
  // Every part is 1, so that no two parts and no two places are told apart by what stands in them.
  T one;
  int count = 0;
  visit_parts(one, [&](auto& p) { p = 1, ++count; });
  BOOST_TEST(count == parts);
  BOOST_TEST((one == T(one)));
  BOOST_TEST((one <= one && one >= one && !(one < one) && !(one > one)));
  BOOST_TEST(is_finite(one));
  BOOST_TEST(magnitude(one) == 1);
  BOOST_TEST(base_value(with_part(one, 0, 3)) == 3);
  for (int k = 0; k < parts; ++k) {
    BOOST_TEST_CONTEXT("part " << k) {
      T const more = with_part(one, k, 2), minus = with_part(one, k, -3),
              none = with_part(one, k, std::nan("")), endless = with_part(one, k, -HUGE_VAL);
      BOOST_TEST((!(one == more) && !(more == one)));
      BOOST_TEST((one < more) == (k == 0));
      BOOST_TEST((more > one) == (k == 0));
      BOOST_TEST((!(more < one) && !(one > more)));
      BOOST_TEST(((one <= more) && (more >= one)));
      BOOST_TEST((more <= one) == (k > 0));
      BOOST_TEST((one >= more) == (k > 0));
      BOOST_TEST(magnitude(more) == 2);
      BOOST_TEST(magnitude(minus) == 3);
      BOOST_TEST(magnitude(endless) == HUGE_VAL);
      BOOST_TEST(std::isnan(magnitude(none)));
      BOOST_TEST((!is_finite(none) && !is_finite(endless)));
    }
  }
}
}  // namespace

BOOST_AUTO_TEST_SUITE(parts_of_numbers)

BOOST_AUTO_TEST_CASE(order_is_that_of_the_values_and_size_that_of_the_largest_part) {
  order_size_and_finiteness<Dual<double, 1>>(2);
  order_size_and_finiteness<Dual<double, 2>>(3);
  order_size_and_finiteness<Dual<double, 3>>(4);
  order_size_and_finiteness<SecondOrder<double, 2>>(6);
}

BOOST_AUTO_TEST_SUITE_END()
