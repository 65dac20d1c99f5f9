// Random draws: reproducible, evenly spread, the same point at every scalar.
#include <boost/test/unit_test.hpp>

#include "actio/groups/motions.hpp"
#include "actio/numbers/multiprecision.hpp"
#include "witness/draw.hpp"

using namespace actio;

BOOST_AUTO_TEST_CASE(a_seed_fixes_the_sequence_on_every_machine) {
  // The generator is fixed by the standard and the rest is whole-number arithmetic: these fractions are the
  // same everywhere.
  Draw draw(1);
  BOOST_TEST(draw.number<rational>() == rational(64708, 65537));
  Draw again(1), other(2);
  BOOST_TEST(again.number<rational>() != other.number<rational>());
}

BOOST_AUTO_TEST_CASE(draws_over_all_scalars_are_the_same_point) {
  Draw a(5), b(5), c(5);
  for (int i = 0; i < 20; ++i) {
    auto const exact = a.element<rational>(SE<3>{});
    auto const rounded = b.element<double>(SE<3>{});
    auto const many = c.element<dec100>(SE<3>{});
    for (int r = 0; r < 4; ++r)
      for (int s = 0; s < 4; ++s) {
        BOOST_TEST(std::abs(to_double(exact.value(r, s)) - rounded.value(r, s)) < 32 * epsilon<double>());
        BOOST_TEST(to_double(magnitude(
                       dec100(dec100(numerator(exact.value(r, s))) / dec100(denominator(exact.value(r, s))) -
                              many.value(r, s)))) < 1e-98);
      }
  }
}

BOOST_AUTO_TEST_CASE(numbers_fill_their_interval_evenly) {
  Draw draw(9);
  std::array<int, 16> count{};
  int const tries = 160000;
  for (int i = 0; i < tries; ++i) {
    double const x = draw.number<double>();
    BOOST_REQUIRE(std::abs(x) < 1);
    ++count[static_cast<int>((x + 1) * 8)];
  }
  // Each sixteenth gets 10000, with a standard deviation of about 97: five of them allow for chance.
  for (int c : count) BOOST_TEST(std::abs(c - tries / 16) < 485);
}

BOOST_AUTO_TEST_CASE(draws_below_a_bound_hit_every_number) {
  Draw draw(3);
  std::array<int, 7> count{};
  for (int i = 0; i < 7000; ++i) ++count.at(draw.below(7));
  for (int c : count) BOOST_TEST(std::abs(c - 1000) < 150);  // five standard deviations of 29
}
