#include "actio/formula/tape_entries.hpp"

namespace actio {

TapeEntries::TapeEntries(int inputs, std::size_t most)
    : inputs_(inputs), most_(most + static_cast<std::size_t>(inputs)) {
  for (int i = 0; i < inputs; ++i)
    entries_.push_back({Operation::input, false, static_cast<Entry>(i), static_cast<Entry>(i), 0.0});
}

TapeEntries::Entry TapeEntries::make(Recorded const& recorded) {
  if (entries_.size() >= most_)
    throw Error("a formula with its derivatives takes at most " +
                std::to_string(most_ - static_cast<std::size_t>(inputs_)) +
                " instructions, and this one takes more; define its common parts once");
  entries_.push_back(recorded);
  return size() - 1;
}

TapeEntries::Entry TapeEntries::number(ExactRatio const& x) {
  auto const known = found_numbers_.find(x);
  if (known != found_numbers_.end()) return known->second;
  auto const which = static_cast<Entry>(numbers_.size());
  numbers_.push_back(x);
  return found_numbers_[x] = make({Operation::number, true, which, which, to_double(x)});
}

TapeEntries::Entry TapeEntries::pi() {
  std::uint64_t const key = static_cast<std::uint64_t>(Operation::pi) << 56;
  auto const known = found_.find(key);
  if (known != found_.end()) return known->second;
  return found_[key] = make({Operation::pi, true, 0, 0, half_turn<double>()});
}

double TapeEntries::value_of(Operation operation, double x, double y) const {
  switch (operation) {
    case Operation::add:
      return x + y;
    case Operation::subtract:
      return x - y;
    case Operation::multiply:
      return x * y;
    case Operation::divide:
      return x / y;
    case Operation::negate:
      return -x;
    case Operation::power:
      return power(x, y);
    case Operation::atan2:
      return angle_of(x, y);
    case Operation::hypot:
      return hypotenuse(x, y);
    default:
      return joins_two(operation) ? kinked(operation, x, y) : elementary(operation, x);
  }
}

TapeEntries::Entry TapeEntries::entry(Operation operation, Entry a, Entry b) {
  // Sums and products in one order, constants first.
  if (operation == Operation::add || operation == Operation::multiply)
    if (is_constant(a) == is_constant(b) ? b < a : is_constant(b)) std::swap(a, b);
  std::uint64_t const key = (static_cast<std::uint64_t>(operation) << 56) |
                            (static_cast<std::uint64_t>(a) << 28) | static_cast<std::uint64_t>(b);
  auto const known = found_.find(key);
  if (known != found_.end()) return known->second;
  bool const constant = is_constant(a) && is_constant(b);
  double const folded = constant ? value_of(operation, value(a), value(b)) : 0;
  return found_[key] = make({operation, constant, a, b, folded});
}

}  // namespace actio
