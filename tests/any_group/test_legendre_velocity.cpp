// The Legendre map of a Lagrangian that is told at run time.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "own_system.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::systems;

namespace {

using List = std::vector<double>;
using Square = Eigen::MatrixXd;

Square matrix(int n, std::initializer_list<double> row_by_row) {
  Square m(n, n);
  Index k = 0;
  for (double const x : row_by_row) m(k / n, k % n) = x, ++k;
  return m;
}

}  // namespace

// The momentum is e^v. From a velocity far above Newton's moves are short, and the residual relative to its
// terms does not fall: what was found by then is no solution, and is not taken for one.
BOOST_AUTO_TEST_CASE(an_iteration_that_stalls_far_away_is_no_solution) {
  auto const system = own_system("SO(2)", Side::left, "exp(x1)");
  LegendreVelocity legendre(*system);
  std::vector<double> v{20};
  CHECK_REFUSED(legendre.solve({1}, {}, v), NotConverged);
  v = {0.5};
  legendre.solve({1}, {}, v);
  // The condition of the map is 1, and the iteration ends at a few epsilon.
  BOOST_TEST(std::abs(v[0]) <= 64 * 0x1p-52);
}

BOOST_AUTO_TEST_CASE(an_iteration_that_stalls_says_what_was_left_of_each_step) {
  auto const system = own_system("SO(2)", Side::left, "exp(x1)");
  LegendreVelocity legendre(*system);
  List v{20};
  try {
    legendre.solve({1}, {}, v);
    BOOST_TEST(false);
  } catch (NotConverged const& e) {
    BOOST_TEST(e.tolerance == 16 * 0x1p-52);
    BOOST_TEST_REQUIRE(!e.residuals.empty());
    // e^20 for 1, over 1 and e^20 and what the velocity contributes, 20 e^20.
    double const large = std::exp(20.0), first = (large - 1) / (1 + 21 * large);
    BOOST_TEST(std::abs(e.residuals.front() / first - 1) < 16 * 0x1p-52);
  }
}

BOOST_AUTO_TEST_CASE(momentum_energy_and_hessian_are_those_of_the_formula) {
  // Whole numbers, so that nothing is rounded.
  auto const system =
      own_system("SE(2)", Side::left,
                 "w^2 + 3*w*v1 + 5*w*v2 + 7*v1^2/2 + 11*v1*v2 + 13*v2^3/3 - 17*a1 + 19*a2*v1", true);
  LegendreVelocity legendre(*system);
  List const v{2, -1, 3}, a{4, 5, 1};
  BOOST_TEST((legendre.momentum(v, a) == List{2 * 2 - 3 + 15, 6 - 7 + 33 + 95, 10 - 11 + 13 * 9}));
  // Of a term of degree k in the velocity the energy has k - 1 times.
  double const quadratic = 4 - 6 + 30 + 3.5 - 33, cubic = 13 * 9;
  BOOST_TEST(legendre.energy(v, a) == quadratic + 2 * cubic + 17 * 4);
  BOOST_TEST((legendre.hessian(v, a) == matrix(3, {2, 3, 5, 3, 7, 11, 5, 11, 78})));
}

BOOST_AUTO_TEST_CASE(a_velocity_is_found_from_far_away_and_across_the_end_of_the_formula) {
  // The momentum is log v: from 1 the first step for -5 leads to -4, where there is none, and is halved.
  auto const system = own_system("SO(2)", Side::left, "x1*log(x1) - x1");
  LegendreVelocity legendre(*system);
  List v{1};
  legendre.solve({-5}, {}, v);
  // 64 roundings of a logarithm of size 5 are as many of the velocity, five times larger.
  BOOST_TEST(std::abs(v[0] / std::exp(-5.0) - 1) <= 5 * 64 * 0x1p-52);
  CHECK_REFUSED(legendre.momentum({-1}, {}), NotFinite);
}

BOOST_AUTO_TEST_CASE(a_quadratic_energy_is_inverted_whatever_its_units) {
  auto const system = own_system("R^3", Side::left, "(m*x1^2 + M*x2^2 + 3*x3^2)/2 + x1*x2/2 - x2*x3*b", false,
                                 {{"m", 1e-20}, {"M", 1e20}, {"b", 1e10}});
  LegendreVelocity legendre(*system);
  List const truth{3e10, -2e-10, 0.7}, p = legendre.momentum(truth, {});
  List v{0, 0, 0};
  legendre.solve(p, {}, v);
  // In units where the masses are 1 the matrix is ((1, 1/2, 0), (1/2, 1, -c), (0, -c, 1)), c = 1/sqrt(3).
  for (std::size_t i = 0; i < 3; ++i) BOOST_TEST(std::abs(v[i] / truth[i] - 1) < 256 * 0x1p-52);
}

BOOST_AUTO_TEST_CASE(an_energy_without_inverse_is_refused_with_its_condition) {
  auto const condition = [](double more) {
    auto const system =
        own_system("R^2", Side::left, "(x1^2 + 2*x1*x2 + (1 + d)*x2^2)/2", false, {{"d", more}});
    LegendreVelocity legendre(*system);
    List v{0, 0};
    try {
      legendre.solve({1, 2}, {}, v);
    } catch (Singular const& e) {
      BOOST_TEST(e.bound == 0x1p-50);
      return e.measured;
    }
    return HUGE_VAL;
  };
  BOOST_TEST(condition(0) == 0);
  // In its units the matrix is ((1, s), (s, 1)) with s = 1 - d/2, of condition (1 - s)/(1 + s) = d/4.
  BOOST_TEST(condition(0x1p-49) <= 0x1p-50);
  BOOST_TEST(condition(0x1p-44) == HUGE_VAL);
}

BOOST_AUTO_TEST_CASE(units_are_those_of_the_diagonal_or_else_of_the_row) {
  Eigen::VectorXd const units = units_of(matrix(4, {-4, 9, 0, 0, 9, 0, -25, 0, 0, -25, 16, 0, 0, 0, 0, 0}));
  BOOST_TEST((units == Eigen::Vector4d(0.5, 0.2, 0.25, 1)));
  // ((2, 1), (1, 1)) in units 2 and 4: the inverse is that of the matrix, the condition that of the units.
  InverseInUnits const inverse(matrix(2, {2, 1, 1, 1}), Eigen::Vector2d(2, 4));
  BOOST_TEST((inverse.matrix - matrix(2, {1, -1, -1, 2})).norm() < 16 * 0x1p-52);
  // ((8, 8), (8, 16)) has rows of size 24, its inverse ((1/4, -1/8), (-1/8, 1/8)) of size 3/8.
  BOOST_TEST(std::abs(inverse.condition - 1.0 / 9) < 16 * 0x1p-52);
  InverseInUnits const none(matrix(2, {1, 1, 1, 1}), Eigen::Vector2d(1, 1));
  BOOST_TEST(none.condition == 0);
  BOOST_TEST((none.matrix == Square::Zero(2, 2)));
  InverseInUnits const no_number(matrix(2, {1, std::nan(""), 0, 1}), Eigen::Vector2d(1, 1));
  BOOST_TEST(no_number.condition == 0);
  BOOST_TEST((no_number.matrix == Square::Zero(2, 2)));
}
