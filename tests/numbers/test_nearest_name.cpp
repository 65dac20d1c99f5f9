#include <boost/test/unit_test.hpp>

#include "actio/numbers/nearest_name.hpp"

using namespace actio;

BOOST_AUTO_TEST_SUITE(nearest_names)

BOOST_AUTO_TEST_CASE(a_letter_dropped_swapped_or_added_leads_to_the_name) {
  std::vector<std::string> const known{"energy", "casimir", "attitude"};
  BOOST_TEST(nearest_name("enrgy", known) == "energy");
  BOOST_TEST(nearest_name("casmiir", known) == "casimir");
  BOOST_TEST(nearest_name("attitudes", known) == "attitude");
  BOOST_TEST(nearest_name("att", known) == "attitude");
}

BOOST_AUTO_TEST_CASE(a_word_that_is_near_to_nothing_leads_nowhere) {
  BOOST_TEST(nearest_name("pressure", {"energy", "casimir"}) == "");
  BOOST_TEST(nearest_name("", {"energy"}) == "");
  BOOST_TEST(nearest_name(std::string(100000, 'e'), {"energy"}) == "");
}

BOOST_AUTO_TEST_SUITE_END()
