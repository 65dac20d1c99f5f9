#include "program/registry/companion.hpp"

#include <fmt/format.h>

namespace actio::scene {

Companion companions(std::function<std::unique_ptr<Motion>(long)> const& make,
                     std::initializer_list<long> multiples, int order, bool attitude) {
  for (long const multiple : multiples) try {
      Companion out{make(multiple), multiple, order, attitude,
                    fmt::format("estimated from companion runs with steps {} and {} times as long", multiple,
                                2 * multiple)};
      out.control = make(2 * multiple), out.control_steps = 2 * multiple;
      return out;
    } catch (Error const&) {
      // So long a step is beyond the scheme.
    }
  return {nullptr, 0, 0, attitude,
          "not estimated: steps four times as long are beyond the scheme; with half "
          "of the step there is an estimate"};
}

Companion no_error(std::string how, bool attitude) {
  Companion out{nullptr, 0, 0, attitude, std::move(how)};
  out.exact = true;
  return out;
}

}  // namespace actio::scene
