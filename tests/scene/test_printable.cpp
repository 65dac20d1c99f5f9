#include <boost/test/unit_test.hpp>

#include "program/base/error.hpp"

using namespace actio::scene;

BOOST_AUTO_TEST_SUITE(printable_text)

BOOST_AUTO_TEST_CASE(letters_of_all_tongues_stay_as_they_are) {
  for (std::string const text :
       {"plain", "\xc3\xa9t\xc3\xa9", "\xe6\x97\xa5\xe6\x9c\xac", "\xf0\x9f\x8c\x8d", ""})
    BOOST_TEST(printable(text) == text);
}

BOOST_AUTO_TEST_CASE(what_would_command_a_terminal_is_told_in_letters) {
  BOOST_TEST(printable("a\x1b[31mb") == "a\\u001b[31mb");
  BOOST_TEST(printable(std::string("\0\n\r\t\x7f", 5)) == "\\u0000\\u000a\\u000d\\u0009\\u007f");
  BOOST_TEST(printable("\xc2\x9b"
                       "31m") == "\\u009b31m");  // the one-character escape
  BOOST_TEST(printable("\xe2\x80\xae"
                       "drows") == "\\u202edrows");  // from here on backwards
  // a line of its own; nothing to see
  BOOST_TEST(printable("\xe2\x80\xa8\xef\xbb\xbf") == "\\u2028\\ufeff");
  BOOST_TEST(printable("\xf3\xa0\x80\x81") == "\\U000e0001");
}

BOOST_AUTO_TEST_CASE(a_byte_that_is_no_utf_8_is_told_in_digits) {
  BOOST_TEST(printable("\xff"
                       "a\x80") == "\\xffa\\x80");
  BOOST_TEST(printable("\xc3") == "\\xc3");           // cut short
  BOOST_TEST(printable("\xc0\xaf") == "\\xc0\\xaf");  // longer than it need be
  BOOST_TEST(printable("\xe0\x80\xaf") == "\\xe0\\x80\\xaf");
  BOOST_TEST(printable("\xed\xa0\x80") == "\\xed\\xa0\\x80");  // half of a pair
  BOOST_TEST(printable("\xf4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");
}

BOOST_AUTO_TEST_CASE(what_is_printable_stays_so) {
  std::string all;
  for (int first = 0; first < 256; ++first)
    for (int second = 0; second < 256; ++second) all += {static_cast<char>(first), static_cast<char>(second)};
  std::string const once = printable(all);
  BOOST_TEST((printable(once) == once));
}

BOOST_AUTO_TEST_CASE(a_long_text_is_cut_between_characters) {
  BOOST_TEST(shown("\xc3\xa9\xc3\xa9\xc3\xa9", 2) == "\xc3\xa9\xc3\xa9...");
  BOOST_TEST(shown("abc", 3) == "abc");
  BOOST_TEST(shown(std::string(1 << 20, 'a')).size() == 63u);
}

BOOST_AUTO_TEST_CASE(no_complaint_breaks_its_line) {
  BOOST_TEST(std::string(SceneError({"a\nb", 3, 4}, "x\ry").what()) == "a\\u000ab:3:4: x\\u000dy");
  BOOST_TEST(std::string(FileError("a\nb").what()) == "a\\u000ab");
  BOOST_TEST(std::string(NumericsError("a\x1b").what()) == "a\\u001b");
}

BOOST_AUTO_TEST_SUITE_END()
