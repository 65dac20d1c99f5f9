// What a long run says of itself on standard error: one line on a terminal, a line every tenth in a pipe.
//
//      42.0 %   1.63e+08 steps/s   1 min 12 s left   worst drift 3.2e-15
//
// On a terminal a drift that deserves a look has a colour, unless NO_COLOR is set. Nothing is said in the
// first half second.
#pragma once

#include <chrono>
#include <cstdio>
#include <optional>
#include <string>

namespace actio::scene {

/// The progress of one run.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param unit  what is counted: "steps"
  Progress(bool quiet, std::string unit);
  /// Clears the line.
  ~Progress();
  Progress(Progress const&) = delete;
  Progress& operator=(Progress const&) = delete;

  /// From now on time is counted, from here.
  void start(double fraction, long count);
  /// Says how far the run is, where it is time to.
  /// @param fraction     done of the whole, 0 to 1
  /// @param count        steps, or rows, those before a resumption included
  /// @param worst_drift  none where nothing is conserved
  void show(Clock::time_point now, double fraction, long count, std::optional<double> worst_drift);

 private:
  void print(std::string const& line, std::size_t width);

  bool quiet_, terminal_, colour_;
  std::string unit_;
  std::size_t shown_ = 0;  // width of the line on the terminal
  int tenth_ = 0;
  double first_fraction_ = 0;
  long first_count_ = 0;
  Clock::time_point began_ = Clock::now(), last_ = began_;
};

/// `12 s`, `3 min 20 s`, `2 h 05 min`, `3 d 4 h`.
std::string duration_text(double seconds);
/// `812 bytes`, `3.4 kB`, `118 GB`.
std::string size_text(double bytes);
/// Writes to standard output or error, and ignores that there is no reader.
void say(std::FILE* stream, std::string const& text);

}  // namespace actio::scene
