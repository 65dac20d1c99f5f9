// Broyden's formula does what defines it.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "actio/any_group/broyden_update.hpp"
#include "witness/draw.hpp"

using namespace actio;
using namespace actio::systems;

namespace {

using Row = std::vector<double>;

Row times(Row const& matrix, Row const& v, double factor) {
  Row out(v.size());
  for (std::size_t i = 0; i < v.size(); ++i)
    for (std::size_t j = 0; j < v.size(); ++j) out[i] += factor * matrix[i * v.size() + j] * v[j];
  return out;
}
Row some(Draw& draw, std::size_t count) {
  Row out(count);
  for (double& x : out) x = draw.number<double>();
  return out;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(broyden_updates)

BOOST_AUTO_TEST_CASE(the_new_inverse_has_the_last_step_and_changes_in_one_direction_alone) {
  constexpr std::size_t d = 5;
  Draw draw(3);
  int tried = 0;
  for (int k = 0; k < 20; ++k) {
    Row const old = some(draw, d * d), r = some(draw, d);
    Row next = some(draw, d), weights = some(draw, d);
    for (double& x : next) x /= 8;
    for (double& x : weights) x = 0.5 + x * x;
    Row const step = times(old, r, -1);
    Row inverse = old, update = times(old, next, -1);
    if (!broyden_update(inverse, step, weights, update)) {
      BOOST_TEST((inverse == old));
      continue;
    }
    ++tried;
    Row change(d), across = some(draw, d);
    for (std::size_t i = 0; i < d; ++i) change[i] = next[i] - r[i];
    Row const said = times(inverse, change, 1), again = times(inverse, next, -1);
    double size = 0;
    for (double x : inverse) size = std::max(size, std::abs(x));
    for (std::size_t i = 0; i < d; ++i) {
      BOOST_TEST(std::abs(said[i] - step[i]) < 1e-13 * (1 + size));
      BOOST_TEST(std::abs(again[i] - update[i]) < 1e-13 * (1 + size));
    }
    // What D s sees as nothing in B v stays as it was: v with (D s)^T B v = 0.
    Row seen(d);
    double length = 0, along = 0;
    for (std::size_t j = 0; j < d; ++j) {
      for (std::size_t i = 0; i < d; ++i) seen[j] += weights[i] * step[i] * old[i * d + j];
      length += seen[j] * seen[j], along += seen[j] * across[j];
    }
    for (std::size_t j = 0; j < d; ++j) across[j] -= along / length * seen[j];
    Row const before = times(old, across, 1), after = times(inverse, across, 1);
    for (std::size_t i = 0; i < d; ++i) BOOST_TEST(std::abs(before[i] - after[i]) < 1e-12 * (1 + size));
  }
  BOOST_TEST(tried > 5);
}

BOOST_AUTO_TEST_CASE(two_steps_that_are_the_same_change_nothing) {
  Row inverse{2, 1, 0, 3}, update{1, -1};
  BOOST_TEST(!broyden_update(inverse, {1, -1}, {1, 1}, update));
  BOOST_TEST((inverse == Row{2, 1, 0, 3}));
  BOOST_TEST((update == Row{1, -1}));
}

BOOST_AUTO_TEST_SUITE_END()
