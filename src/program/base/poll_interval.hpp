// How often a loop polls the clock: about a hundred times a second, however long a turn of it takes.
#pragma once

#include <algorithm>
#include <chrono>

namespace actio::scene {

/// The polling interval of a loop, adapted to how long its passes take: it counts the passes between two
/// looks at the clock. The interval at most doubles from one look to the next, so that a look is never far
/// off.
class PollInterval {
 public:
  using Clock = std::chrono::steady_clock;

  /// One pass more: whether it is time for a look.
  bool due() { return --left_ <= 0; }
  /// Looks at the clock.
  Clock::time_point look() {
    constexpr double between = 0.01;  // seconds
    auto const now = Clock::now();
    double const seconds = std::chrono::duration<double>(now - last_).count(),
                 made = static_cast<double>(passes_ - left_);
    double const fit = std::min(made * between / std::max(seconds, 1e-9), 2.0 * static_cast<double>(passes_));
    passes_ = left_ = std::max(1L, static_cast<long>(fit));
    last_ = now;
    return now;
  }

 private:
  long passes_ = 1, left_ = 1;
  Clock::time_point last_ = Clock::now();
};

}  // namespace actio::scene
