// The Legendre map of a Lagrangian that is told at run time.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "own_system.hpp"

using namespace actio;

// The momentum is e^v. From a velocity far above Newton's moves are short, and the residual relative to its
// terms does not fall: what was found by then is no solution, and is not taken for one.
BOOST_AUTO_TEST_CASE(an_iteration_that_stalls_far_away_is_no_solution) {
  auto const system = own_system("SO(2)", Side::left, "exp(x1)");
  LegendreVelocity legendre(*system);
  std::vector<double> v{20};
  BOOST_CHECK_THROW(legendre.solve({1}, {}, v), NotConverged);
  v = {0.5};
  legendre.solve({1}, {}, v);
  // The condition of the map is 1, and the iteration ends at a few epsilon.
  BOOST_TEST(std::abs(v[0]) <= 64 * 0x1p-52);
}
