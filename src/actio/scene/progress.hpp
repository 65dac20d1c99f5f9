// What a long run says of itself: one line on a terminal, a line every tenth in a pipe.
#pragma once

#include <chrono>
#include <cstdio>
#include <string>

namespace actio::scene {

/// The progress of one run, on standard error.
class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress();
  Progress(Progress const&) = delete;
  Progress& operator=(Progress const&) = delete;
  /// @param fraction  done of the whole, 0 to 1
  /// @param steps     done since the start of this process
  void show(double fraction, long steps, double worst_drift);

 private:
  using Clock = std::chrono::steady_clock;
  bool quiet_, terminal_, shown_ = false;
  int tenth_ = 0;
  Clock::time_point began_ = Clock::now(), last_ = began_;
  double first_fraction_ = -1;
};

}  // namespace actio::scene
