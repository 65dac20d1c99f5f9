#include "actio/formula/tape.hpp"

namespace actio {

bool Tape::depends_on(int input) const {
  auto const place = static_cast<std::uint32_t>(constants.size()) + static_cast<std::uint32_t>(input);
  for (std::uint32_t output : outputs)
    if (output == place) return true;
  auto at = instructions.begin() + static_cast<std::ptrdiff_t>(constants.size() - numbers.size());
  for (Run const& run : runs)
    for (std::uint32_t i = 0; i < run.count; ++i, ++at)
      if (at->a == place || (joins_two(run.operation) && at->b == place)) return true;
  return false;
}

}  // namespace actio
