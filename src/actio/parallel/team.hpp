// Threads that go through the same rounds, each with a part of its own.
#pragma once

#include <barrier>
#include <latch>
#include <system_error>
#include <thread>
#include <vector>

namespace actio {

/// Where the members of a team wait for each other. They give the processor away while they wait.
class Meeting {
 public:
  /// Of so many.
  explicit Meeting(int members) : barrier_(members), alone_(members == 1) {}
  /// Returns when all are here.
  void wait() {
    if (!alone_) barrier_.arrive_and_wait();
  }

 private:
  std::barrier<> barrier_;
  bool alone_;
};

/// Calls `work(k, meeting)` for k = 0, ..., members - 1 on as many threads, the caller's among them, and
/// returns when all are done. `work` does not throw.
/// @throws std::system_error  where there are no more threads to be had; then no work has been called
template <class Work>
void as_team(int members, Work const& work) {
  Meeting meeting(members);
  if (members == 1) return work(0, meeting);
  std::latch begin(1);
  bool complete = true;
  std::vector<std::jthread> others;
  try {
    for (int k = 1; k < members; ++k)
      others.emplace_back([&, k] {
        begin.wait();
        if (complete) work(k, meeting);
      });
  } catch (std::system_error const&) {
    complete = false;
    begin.count_down();
    throw;
  }
  begin.count_down();
  work(0, meeting);
}

}  // namespace actio
