// The machine that a report names.
#include <boost/test/unit_test.hpp>

#include "book/machine.hpp"

BOOST_AUTO_TEST_SUITE(machine)

BOOST_AUTO_TEST_CASE(dates_are_in_universal_time) {
  BOOST_TEST(book::date_of(0) == "1970-01-01 00:00");
  BOOST_TEST(book::date_of(951827696) == "2000-02-29 12:34");
}

BOOST_AUTO_TEST_CASE(nothing_is_left_blank) {
  auto const m = book::this_machine();
  BOOST_TEST(!m.processor.empty());
  BOOST_TEST(m.cores > 0u);
  BOOST_TEST(!m.vectors.empty());
  BOOST_TEST(m.compiler.find('.') != std::string::npos);
  BOOST_TEST(!m.flags.empty());
}

BOOST_AUTO_TEST_SUITE_END()
