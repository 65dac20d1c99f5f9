// What a refusal says.
#pragma once

#include <string>

#include "actio/numbers/errors.hpp"

namespace actio::testing {

/// The message of the error of the library that a call throws; empty where it throws none.
template <class Call>
std::string message_of(Call const& call) {
  try {
    call();
  } catch (Error const& e) {
    return e.what();
  }
  return "";
}

}  // namespace actio::testing
