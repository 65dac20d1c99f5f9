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

// Two letters, or a third of those of the word; never all of them.
BOOST_AUTO_TEST_CASE(a_name_may_differ_in_two_letters_or_a_third_of_them) {
  BOOST_TEST(nearest_name("abcdef", {"abcdxy"}) == "abcdxy");
  BOOST_TEST(nearest_name("abcdef", {"abcxyz"}) == "");
  BOOST_TEST(nearest_name("abcdefgh", {"abcdexyz"}) == "");
  BOOST_TEST(nearest_name("abcdefghi", {"abcdefxyz"}) == "abcdefxyz");
  BOOST_TEST(nearest_name("abcdefghi", {"abcdewxyz"}) == "");
  BOOST_TEST(nearest_name("ab", {"cd"}) == "");
  BOOST_TEST(nearest_name("a", {"b"}) == "");
  BOOST_TEST(nearest_name("ab", {"cbd"}) == "cbd");
  BOOST_TEST(nearest_name("abc", {"xyc"}) == "xyc");
  // What a name begins with leads to it from three letters on.
  BOOST_TEST(nearest_name("abc", {"abcdefghijklm"}) == "abcdefghijklm");
  BOOST_TEST(nearest_name("ab", {"abcdefghijklm"}) == "");
  // The nearest one, and of those that are as near the first.
  BOOST_TEST(nearest_name("energi", {"enerxx", "energy", "enexgi"}) == "energy");
  BOOST_TEST(nearest_name("energy", {"enerxx", "enerzz", "energx"}) == "energx");
  // A word has 64 letters at most.
  std::string const name(63, 'e');
  BOOST_TEST(nearest_name(name + 'x', {name}) == name);
  BOOST_TEST(nearest_name(name + "xy", {name}) == "");
}

BOOST_AUTO_TEST_CASE(names_in_a_message) {
  BOOST_TEST(did_you_mean("enrgy", {"casimir", "energy"}) == "; did you mean 'energy'?");
  BOOST_TEST(did_you_mean("pressure", {"casimir", "energy"}) == "");
  BOOST_TEST((listed({}) == "" && listed({"a"}) == "a" && listed({"a", "b", "c"}) == "a, b, c"));
}

BOOST_AUTO_TEST_SUITE_END()
