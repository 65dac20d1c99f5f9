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
  Tape run(std::span<Entry const> outputs) {
    tape_.inputs = entries_.inputs();
    mark_needed(outputs);
    place_constants();
    for (Entry i = 0; i < static_cast<Entry>(entries_.inputs()); ++i) place_[i] = next_++;
    place_others();
    for (Entry output : outputs) tape_.outputs.push_back(place_[output]);
    return std::move(tape_);
  }

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

  void append(std::vector<Tape::Run>& runs, Entry e) {
    Operation const operation = entries_.operation(e);
    if (runs.empty() || runs.back().operation != operation) runs.push_back({operation, 0});
    ++runs.back().count;
    tape_.instructions.push_back(
        {is_leaf(e) ? 0 : place_[entries_.first(e)], is_leaf(e) ? 0 : place_[entries_.second(e)]});
    place_[e] = next_++;
  }

  void place_constants() {
    auto const constant = [&](Entry e, bool number) {
      return is_needed(e) && entries_.is_constant(e) && (entries_.ratio_of(e) != nullptr) == number;
    };
    for (Entry e = 0; e < entries_.size(); ++e)
      if (constant(e, true)) {
        tape_.numbers.push_back(*entries_.ratio_of(e));
        tape_.constants.push_back(entries_.value(e));
        place_[e] = next_++;
      }
    for (Entry e = 0; e < entries_.size(); ++e)
      if (constant(e, false)) {
        append(tape_.constant_runs, e);
        tape_.constants.push_back(entries_.value(e));
      }
  }

  /// Who takes each entry as an operand, and how many operands each still waits for.
  void find_users() {
    waits_for_.assign(entries_.size(), 0);
    first_user_.assign(entries_.size() + 1, 0);
    auto const each = [&](auto const& use) {
      for (Entry e = 0; e < entries_.size(); ++e) {
        if (!is_needed(e)) continue;
        if (is_needed(entries_.first(e))) use(entries_.first(e), e);
        if (entries_.second(e) != entries_.first(e) && is_needed(entries_.second(e)))
          use(entries_.second(e), e);
      }
    };
    each([&](Entry operand, Entry user) { ++first_user_[operand + 1], ++waits_for_[user]; });
    for (std::size_t i = 1; i < first_user_.size(); ++i) first_user_[i] += first_user_[i - 1];
    users_.resize(first_user_.back());
    std::vector<std::uint32_t> end(first_user_.begin(), first_user_.end() - 1);
    each([&](Entry operand, Entry user) { users_[end[operand]++] = user; });
  }

  /// Of what can be done, the operation that most entries wait for, until none is left of it.
  void place_others() {
    find_users();
    for (Entry e = 0; e < entries_.size(); ++e)
      if (is_needed(e) && waits_for_[e] == 0) ready(e).push_back(e);
    for (;;) {
      auto const most = std::max_element(ready_.begin(), ready_.end(),
                                         [](auto const& a, auto const& b) { return a.size() < b.size(); });
      if (most->empty()) return;
      for (std::size_t i = 0; i < most->size(); ++i) finish((*most)[i]);
      most->clear();
    }
  }
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
