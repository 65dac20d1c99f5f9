// Maps that are Poisson by construction, to rounding at fifty digits, and one that is not.
#include <boost/test/unit_test.hpp>

#include "actio/groups/rotations.hpp"
#include "actio/instruments/leaf_defect.hpp"
#include "actio/instruments/poisson_defect.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "small_maps.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::testing;

namespace {

DiagonalBody<SO<3>> const body{Vector<double, 3>(1, 2, 4)};

}  // namespace

/// A step and a momentum in 50 digits.
struct FiftyDigits {
  WithArithmetic const digits{Arithmetic::decimal(50)};
  Number const h = ratio<Number>(1, 5), eps50 = epsilon<Number>();
  Momentum<SO<3>, Number> const pi{{}, {ratio<Number>(3, 7), ratio<Number>(-5, 3), ratio<Number>(2, 3)}};
};

BOOST_FIXTURE_TEST_CASE(a_splitting_is_poisson_to_fifty_digits, FiftyDigits) {
  auto const map = [&](auto const& mu) {
    return splitting(body, typename std::decay_t<decltype(mu)>::Scalar(h), mu);
  };
  BOOST_TEST((poisson_defect(LiePoissonMinus{}, map, pi) < 100 * eps50));
  BOOST_TEST((orbit_defect(map, pi) < 100 * eps50));
}

BOOST_FIXTURE_TEST_CASE(the_discrete_lie_poisson_algorithm_is_poisson_to_fifty_digits, FiftyDigits) {
  auto const map = [&](auto const& mu) {
    using S = typename std::decay_t<decltype(mu)>::Scalar;
    auto const residual = [&](auto const& f, auto const& mu) {
      return left_differential(chart_lagrangian(body, h), f) + like(f, mu);
    };
    return lie_poisson_update_left(solve_implicit(residual, mu, exp(-S(h) * body.velocity(mu))), mu);
  };
  BOOST_TEST((poisson_defect(LiePoissonMinus{}, map, pi) < 1000 * eps50));
}

BOOST_FIXTURE_TEST_CASE(the_midpoint_rule_is_not_and_misses_by_what_it_must, FiftyDigits) {
  // As in double (test_closed_forms.cpp): the determinant of its tangent in closed form.
  auto const of_midpoint = [&](auto const& mu) {
    return implicit_midpoint(body, typename std::decay_t<decltype(mu)>::Scalar(h), mu);
  };
  auto const to = of_midpoint(pi);
  Number const m0 = (pi.components[0] + to.components[0]) / 2, m1 = (pi.components[1] + to.components[1]) / 2,
               m2 = (pi.components[2] + to.components[2]) / 2;
  Number const a = ratio<Number>(-1, 4), b = ratio<Number>(3, 4), c = ratio<Number>(-1, 2);
  Number const second = -(a * b * m2 * m2 + a * c * m1 * m1 + b * c * m0 * m0),
               third = 2 * a * b * c * m0 * m1 * m2;
  Number const expected = magnitude(third) * h * h * h / 8 / (1 + second * h * h / 4);
  BOOST_TEST((expected > Number(1) / 100000));
  BOOST_TEST(
      (magnitude(Number(poisson_defect(LiePoissonMinus{}, of_midpoint, pi) - expected)) < 100 * eps50));
  BOOST_TEST((orbit_defect(of_midpoint, pi) < 100 * eps50));
}
