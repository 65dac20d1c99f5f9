// The logarithm on SO(4) and SO(5), where several angles may come near pi.
#include <boost/test/unit_test.hpp>

#include "angles_next_to_pi.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::testing;

// Pairs of angles: apart, equal, opposite, one of them zero or tiny, one of them next to pi.
BOOST_AUTO_TEST_CASE(log_on_SO4_and_SO5_is_good_to_rounding_for_all_pairs_of_angles) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  Draw draw(4);
  double worst4 = 0, worst5 = 0;
  Number const half = acos(Number(0)), tiny = ratio<Number>(1, 1000000000);
  for (int k = 0; k <= 8; ++k) {
    Number const a = angle_before_pi(k);
    std::vector<std::pair<Number, Number>> pairs = {{a, Number(1) / 3}, {a, Number(0)}, {a, tiny},
                                                    {a, -half},         {half, half},   {half, -half},
                                                    {half, Number(0)}};
    if (k == 0) pairs.insert(pairs.end(), {{a, a}, {a, -a}, {a, a + tiny}, {a, a + tiny / 10000000}});
    for (auto const& [first, second] : pairs)
      for (int repeat = 0; repeat < 10; ++repeat) {
        worst4 = std::max(worst4, error_of_log(SO<4>{}, in_a_random_frame<4>(draw, first, second)));
        worst5 = std::max(worst5, error_of_log(SO<5>{}, in_a_random_frame<5>(draw, first, second)));
      }
  }
  BOOST_TEST_MESSAGE("log on SO(4): worst error " << worst4 / eps << " epsilon, on SO(5): " << worst5 / eps);
  BOOST_TEST(worst4 < 32 * eps);
  BOOST_TEST(worst5 < 64 * eps);  // the Schur form brings more roundings than the pair of quaternions
}

// Where both angles come within d of pi the logarithm magnifies rounding by 1/d; its exponential is the
// rotation all the same.
BOOST_AUTO_TEST_CASE(two_angles_next_to_pi_cost_what_they_must) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  Draw draw(5);
  for (int repeat = 0; repeat < 20; ++repeat) {
    Number const a = angle_before_pi(8), b = angle_before_pi(7);
    auto const v = in_a_random_frame<4>(draw, a, b);
    auto const w = in_a_random_frame<5>(draw, a, -b);
    BOOST_TEST(error_of_log(SO<4>{}, v) < 32e8 * eps);
    BOOST_TEST(error_of_log(SO<5>{}, w) < 64e8 * eps);
    Element<SO<5>, double> const g{{}, in_double(exp(velocity(SO<5>{}, w)).value)};
    BOOST_TEST(magnitude((exp(log(g)).value - g.value).eval()) < 64 * eps);
  }
}
