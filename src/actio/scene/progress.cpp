#include "actio/scene/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

namespace actio::scene {

Progress::Progress(bool quiet) : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) != 0) {}
Progress::~Progress() {
  if (shown_ && terminal_) std::fputs("\r\x1b[K", stderr);
}

void Progress::show(double fraction, long steps, double worst_drift) {
  if (quiet_) return;
  auto const now = Clock::now();
  if (first_fraction_ < 0) first_fraction_ = fraction, tenth_ = static_cast<int>(fraction * 10);
  double const seconds = std::chrono::duration<double>(now - began_).count();
  if (seconds < 0.5) return;
  if (terminal_ ? now - last_ < std::chrono::milliseconds(200) : static_cast<int>(fraction * 10) <= tenth_) return;
  last_ = now, tenth_ = static_cast<int>(fraction * 10), shown_ = true;
  double const done = fraction - first_fraction_, left = done > 0 ? seconds * (1 - fraction) / done : 0;
  std::string const line = fmt::format("{:5.1f} %  {:.3g} steps/s  {:.0f} s left  worst drift {:.1e}", 100 * fraction, static_cast<double>(steps) / seconds, left, worst_drift);
  fmt::print(stderr, "{}{}{}", terminal_ ? "\r" : "", line, terminal_ ? "\x1b[K" : "\n");
  std::fflush(stderr);
}

}  // namespace actio::scene
