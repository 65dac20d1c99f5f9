#include "program/sweep/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "program/base/progress.hpp"

namespace actio::scene {
namespace {

/// `10 795`
std::string in_groups(long n) {
  std::string digits = std::to_string(n);
  for (long at = static_cast<long>(digits.size()) - 3; at > 0 && digits.size() > 4; at -= 3)
    digits.insert(static_cast<std::size_t>(at), " ");
  return digits;
}

}  // namespace

SweepProgress::SweepProgress(bool quiet) : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) != 0) {}
SweepProgress::~SweepProgress() { clear(); }

void SweepProgress::begin(std::string what, long all, long done) {
  clear();
  what_ = std::move(what), all_ = all, before_ = done_ = done, failed_ = 0,
  tenth_ = done * 10 / std::max(all, 1L);
  began_ = last_ = Clock::now(), said_ = false;
}

void SweepProgress::one_more(bool failed) {
  ++done_, failed_ += failed;
  show();
}

void SweepProgress::show() {
  if (quiet_) return;
  auto const now = Clock::now();
  double const seconds = std::chrono::duration<double>(now - began_).count();
  long const tenth = done_ * 10 / std::max(all_, 1L);
  bool const due =
      terminal_ ? now - last_ >= std::chrono::milliseconds(200) : tenth != tenth_ || (!said_ && seconds >= 1);
  if (seconds < 0.5 || !due) return;
  last_ = now, tenth_ = tenth, said_ = true, shown_ = terminal_;
  std::string line = fmt::format("{} of {} {}   {} failed", done_, all_, what_, failed_);
  if (done_ > before_)
    line += fmt::format("   {} left", duration_text(seconds * static_cast<double>(all_ - done_) /
                                                    static_cast<double>(done_ - before_)));
  scene::say(stderr, (terminal_ ? "\r" : "") + line + (terminal_ ? "\x1b[K" : "\n"));
}

void SweepProgress::clear() {
  if (std::exchange(shown_, false)) scene::say(stderr, "\r\x1b[K");
}

void SweepComplaints::say(std::string const& who, std::string const& message) {
  constexpr int most_alike = 3;
  constexpr long most = 10;
  if (quiet_) return;
  if (said_ >= most || (alike_.size() <= 1000 && ++alike_[message] > most_alike)) {
    ++kept_back_;
    return;
  }
  ++said_;
  scene::say(stderr, who + ": " + message + "\n");
}

void SweepComplaints::close(std::string const& table) {
  if (kept_back_ > 0)
    scene::say(stderr, fmt::format("... and {} more; {} has each message\n", in_groups(kept_back_), table));
}

}  // namespace actio::scene
