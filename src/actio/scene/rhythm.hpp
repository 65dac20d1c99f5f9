// How often a loop looks at the clock: about a hundred times a second, however long a turn of it takes.
#pragma once

#include <algorithm>
#include <chrono>

namespace actio::scene {

/// Counts the turns of a loop between two looks at the clock. Turns grow longer slowly, so that a look is never far off; or they are told to be long.
class Rhythm {
 public:
  using Clock = std::chrono::steady_clock;

  /// One turn more: whether it is time for a look.
  bool due() { return --left_ <= 0; }
  /// Looks at the clock.
  Clock::time_point look() {
    constexpr double between = 0.01;  // seconds
    auto const now = Clock::now();
    double const seconds = std::chrono::duration<double>(now - last_).count(), made = static_cast<double>(turns_ - left_);
    double const fit = std::min(made * between / std::max(seconds, 1e-9), 2.0 * static_cast<double>(turns_));
    turns_ = left_ = std::max(1L, static_cast<long>(fit));
    last_ = now;
    return now;
  }

 private:
  long turns_ = 1, left_ = 1;
  Clock::time_point last_ = Clock::now();
};

}  // namespace actio::scene
