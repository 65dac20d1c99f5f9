#include "actio/formula/tape_schedule.hpp"

namespace actio {

namespace detail {

Tape TapeSchedule::run(std::span<Entry const> outputs) {
  tape_.inputs = entries_.inputs();
  mark_needed(outputs);
  place_constants();
  for (Entry i = 0; i < static_cast<Entry>(entries_.inputs()); ++i) place_[i] = next_++;
  place_others();
  for (Entry output : outputs) tape_.outputs.push_back(place_[output]);
  return std::move(tape_);
}

void TapeSchedule::append(std::vector<Tape::Run>& runs, Entry e) {
  Operation const operation = entries_.operation(e);
  if (runs.empty() || runs.back().operation != operation) runs.push_back({operation, 0});
  ++runs.back().count;
  tape_.instructions.push_back(
      {is_leaf(e) ? 0 : place_[entries_.first(e)], is_leaf(e) ? 0 : place_[entries_.second(e)]});
  place_[e] = next_++;
}

void TapeSchedule::place_constants() {
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

void TapeSchedule::find_users() {
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

void TapeSchedule::place_others() {
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

}  // namespace detail

}  // namespace actio
