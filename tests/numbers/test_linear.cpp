// Small linear systems: matrices that have no inverse.
#include <boost/test/unit_test.hpp>
#include <random>

#include "actio/linear_algebra/linear.hpp"

using namespace actio;

// A product of an n by n - 1 and an n - 1 by n matrix has no inverse. What rounding leaves in the place of
// the last pivot is a few roundings for each of the n terms behind it, but where small pivots before have
// made it grow: one draw in twenty is left to that.
BOOST_AUTO_TEST_CASE(what_rounding_leaves_of_a_pivot_is_none) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> entry(-1, 1);
  int taken = 0;
  for (int const n : {2, 4, 8, 16})
    for (int draw = 0; draw < 200; ++draw) {
      Matrix<double> tall(n, n - 1), wide(n - 1, n), right(n, 1);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j + 1 < n; ++j) tall(i, j) = entry(random), wide(j, i) = entry(random);
      for (int i = 0; i < n; ++i) right(i, 0) = entry(random);
      Matrix<double> product(n, n);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          double sum = 0;
          for (int k = 0; k + 1 < n; ++k) sum += tall(i, k) * wide(k, j);
          product(i, j) = sum;
        }
      try {
        solve_linear(product, right);
        ++taken;
      } catch (Singular const&) {
      }
      // The control: moved by a thousandth it has one.
      for (int i = 0; i < n; ++i) product(i, i) += 1e-3 * (1 + i);
      BOOST_CHECK_NO_THROW(solve_linear(product, right));
    }
  BOOST_TEST(taken <= 4 * 200 / 20);
}
