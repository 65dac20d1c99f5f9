// Maps that are Poisson by construction, to rounding at fifty digits, and one that is not.
#include <boost/test/unit_test.hpp>

#include "actio/numbers/multiprecision.hpp"
#include "actio/groups/rotations.hpp"
#include "actio/instruments/leaf_defect.hpp"
#include "actio/instruments/poisson_defect.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "small_maps.hpp"

using namespace actio;
using namespace actio::testing;

namespace {

DiagonalBody<SO<3>> const body{Vector<double, 3>(1, 2, 4)};
dec50 const h = ratio<dec50>(1, 5), eps50 = epsilon<dec50>();
Momentum<SO<3>, dec50> const pi{{}, {ratio<dec50>(3, 7), ratio<dec50>(-5, 3), ratio<dec50>(2, 3)}};

auto const of_midpoint = [](auto const& mu) {
  return implicit_midpoint(body, typename std::decay_t<decltype(mu)>::Scalar(h), mu);
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_splitting_is_poisson_to_fifty_digits) {
  auto const map = [](auto const& mu) {
    return splitting(body, typename std::decay_t<decltype(mu)>::Scalar(h), mu);
  };
  BOOST_TEST(poisson_defect(LiePoissonMinus{}, map, pi) < 100 * eps50);
  BOOST_TEST(orbit_defect(map, pi) < 100 * eps50);
}

BOOST_AUTO_TEST_CASE(the_discrete_lie_poisson_algorithm_is_poisson_to_fifty_digits) {
  auto const map = [](auto const& mu) {
    using S = typename std::decay_t<decltype(mu)>::Scalar;
    auto const residual = [](auto const& f, auto const& mu) {
      return left_differential(chart_lagrangian(body, h), f) + like(f, mu);
    };
    return lie_poisson_update_left(solve_implicit(residual, mu, exp(-S(h) * body.velocity(mu))), mu);
  };
  BOOST_TEST(poisson_defect(LiePoissonMinus{}, map, pi) < 1000 * eps50);
}

BOOST_AUTO_TEST_CASE(the_midpoint_rule_is_not_and_misses_by_what_it_must) {
  // As in double (test_closed_forms.cpp): the determinant of its tangent in closed form.
  auto const to = of_midpoint(pi);
  dec50 const m0 = (pi.components[0] + to.components[0]) / 2, m1 = (pi.components[1] + to.components[1]) / 2,
              m2 = (pi.components[2] + to.components[2]) / 2;
  dec50 const a = ratio<dec50>(-1, 4), b = ratio<dec50>(3, 4), c = ratio<dec50>(-1, 2);
  dec50 const second = -(a * b * m2 * m2 + a * c * m1 * m1 + b * c * m0 * m0),
              third = 2 * a * b * c * m0 * m1 * m2;
  dec50 const expected = magnitude(third) * h * h * h / 8 / (1 + second * h * h / 4);
  BOOST_TEST(expected > dec50(1) / 100000);
  BOOST_TEST(magnitude(dec50(poisson_defect(LiePoissonMinus{}, of_midpoint, pi) - expected)) < 100 * eps50);
  BOOST_TEST(orbit_defect(of_midpoint, pi) < 100 * eps50);
}
