// The error that a call throws, for a test that looks at its figures or its words.
#pragma once

#include <stdexcept>
#include <string>

#include "actio/numbers/errors.hpp"

namespace actio::testing {

/// The error of type E that the call throws; one of another type goes on.
/// @throws std::logic_error  where the call throws nothing, which ends the case
template <class E, class Call>
E caught(Call const& call) {
  try {
    call();
  } catch (E const& error) {
    return error;
  }
  throw std::logic_error("nothing was refused");
}

/// The message of the error of the library that a call throws; empty where it throws none.
template <class Call>
std::string message_of(Call const& call) {
  try {
    call();
  } catch (Error const& error) {
    return error.what();
  }
  return "";
}

}  // namespace actio::testing
