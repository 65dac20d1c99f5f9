// Error against processor time of any system: methods with many settings over the same task, and the cheapest
// run for each error.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "timing.hpp"

namespace benchmark {

/// A method that takes the system over the whole time.
struct Way {
  std::string name;
  std::function<double(double setting)>
      error;            ///< runs with so many steps, or a tolerance, and says the largest error on the way
  double first, ratio;  ///< settings: the first, and the factor from one to the next
  std::string curve =
      {};  ///< of the picture, where it shows the best of several ways as one; its own if empty
};

/// One run of a way.
struct Timed {
  double setting, error, seconds;
};
/// All runs of a way.
struct Line {
  std::string name;
  std::vector<Timed> runs;

  /// The cheapest run that comes under an error; null where there is none.
  Timed const* cheapest(double error) const {
    Timed const* best = nullptr;
    for (Timed const& r : runs)
      if (r.error <= error && (!best || r.seconds < best->seconds)) best = &r;
    return best;
  }
  /// The smallest error of all runs.
  double best_error() const {
    double best = std::numeric_limits<double>::infinity();
    for (Timed const& r : runs) best = std::min(best, r.error);
    return best;
  }
};

/// Runs from coarse to fine until one takes longer than `longest` seconds, or eight in a row were no better
/// than one before. The shortest of a few times counts.
inline Line runs_of(Way const& way, double longest) {
  Line line{way.name, {}};
  double best = std::numeric_limits<double>::infinity();
  int idle = 0;
  for (double setting = way.first; idle < 8; setting *= way.ratio) {
    Timed run{setting, 0, std::numeric_limits<double>::infinity()};
    double spent = 0;
    try {
      for (int repeat = 0; repeat < 3 || (repeat < 9 && spent < 2e-3); ++repeat) {
        double const seconds = processor_seconds_of([&] { run.error = way.error(setting); });
        run.seconds = std::min(run.seconds, seconds), spent += seconds;
      }
    } catch (std::exception const&) {
      if (++idle == 8) break;
      continue;  // the step is too long for the method
    }
    line.runs.push_back(run);
    idle = run.error < best ? 0 : idle + 1;
    best = std::min(best, run.error);
    if (run.seconds > longest) break;
  }
  return line;
}

}  // namespace benchmark
