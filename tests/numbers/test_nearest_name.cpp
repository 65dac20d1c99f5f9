#include <boost/test/unit_test.hpp>

#include "actio/numbers/nearest_name.hpp"

using namespace actio;

BOOST_AUTO_TEST_SUITE(nearest_names)

BOOST_AUTO_TEST_CASE(the_distance_counts_letters_changed_added_dropped_and_swapped) {
  using detail::letters_apart;
  BOOST_TEST(letters_apart("energy", "energy") == 0u);
  BOOST_TEST(letters_apart("", "abc") == 3u);
  BOOST_TEST(letters_apart("abc", "") == 3u);
  BOOST_TEST(letters_apart("kitten", "sitting") == 3u);
  BOOST_TEST(letters_apart("ab", "ba") == 1u);
  BOOST_TEST(letters_apart("xaby", "xbay") == 1u);
  BOOST_TEST(letters_apart("abcdef", "bacdfe") == 2u);
  // No letter is edited twice: swapping and then adding one between would be two.
  BOOST_TEST(letters_apart("ca", "abc") == 3u);
}

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
