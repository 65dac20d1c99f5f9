// Brings recorded entries into the order in which a tape carries them out.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "actio/formula/tape.hpp"
#include "actio/formula/tape_entries.hpp"

namespace actio {

namespace detail {
/// Sorts the entries that the outputs need: numbers, further constants, inputs, and what depends on them in
/// runs of one operation that are as long as may be.
class TapeSchedule {
 public:
  using Entry = TapeEntries::Entry;

  explicit TapeSchedule(TapeEntries const& entries) : entries_(entries), place_(entries.size(), nowhere) {}

  /// The tape.
  Tape run(std::span<Entry const> outputs);

 private:
  static constexpr std::uint32_t nowhere = 0xFFFFFFFF, needed = 0xFFFFFFFE;

  bool is_leaf(Entry e) const { return entries_.operation(e) <= Operation::pi; }
  /// Backwards from the outputs.
  void mark_needed(std::span<Entry const> outputs) {
    for (Entry output : outputs) place_[output] = needed;
    for (Entry e = entries_.size(); e-- > 0;)
      if (place_[e] == needed && !is_leaf(e)) place_[entries_.first(e)] = place_[entries_.second(e)] = needed;
  }
  bool is_needed(Entry e) const { return place_[e] == needed; }

  void append(std::vector<Tape::Run>& runs, Entry e);

  void place_constants();

  /// Who takes each entry as an operand, and how many operands each still waits for.
  void find_users();

  /// Of what can be done, the operation that most entries wait for, until none is left of it.
  void place_others();
  std::vector<Entry>& ready(Entry e) { return ready_[static_cast<std::size_t>(entries_.operation(e))]; }
  void finish(Entry e) {
    append(tape_.runs, e);
    for (std::uint32_t u = first_user_[e]; u < first_user_[e + 1]; ++u)
      if (--waits_for_[users_[u]] == 0) ready(users_[u]).push_back(users_[u]);
  }

  TapeEntries const& entries_;
  std::vector<std::uint32_t> place_;  // or whether it is needed
  std::uint32_t next_ = 0;
  Tape tape_;
  std::vector<std::uint32_t> waits_for_, first_user_;
  std::vector<Entry> users_;
  std::array<std::vector<Entry>, operations> ready_;
};
}  // namespace detail

/// These entries and what they need, as a tape with them as outputs.
inline Tape schedule(TapeEntries const& entries, std::span<TapeEntries::Entry const> outputs) {
  return detail::TapeSchedule(entries).run(outputs);
}

}  // namespace actio
