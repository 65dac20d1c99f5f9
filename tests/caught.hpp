// The error that a call throws, for a test that looks at its figures.
#pragma once

#include <stdexcept>

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

}  // namespace actio::testing
