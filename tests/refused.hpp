// CHECK_REFUSED(expression, Type): the expression throws this, and its message is the one that was reviewed.
#pragma once

#include <boost/test/unit_test.hpp>

namespace refused {

/// Checks that this is one of the messages that tests/refusals.tsv has for the running case.
///
/// Words are compared as they are, numbers to six digits; below 1e-11, where they are rounding, to a factor
/// of a hundred. The history of an iteration that did not converge is not compared: it is another on each
/// machine. An error of the test gives the line that would do; ACTIO_WRITE_REFUSALS=FILE appends what is
/// missing to a file, to be read before it is believed.
/// @param said  the message of the exception
void check(char const* said);

}  // namespace refused

#define CHECK_REFUSED(expression, Type)                           \
  BOOST_CHECK_EXCEPTION(expression, Type, [](Type const& error) { \
    refused::check(error.what());                                 \
    return true;                                                  \
  })
