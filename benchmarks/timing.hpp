// Time as the benchmarks measure it: processor time, contestants in turns, judged by the best rounds.
//
// A machine that others use as well slows down and speeds up within a second. So no program is timed alone:
// each round times every contestant once, for a few milliseconds. What else the machine does can only add to
// a time. Hence the time of a contestant is the one that a tenth of its rounds came under, and a ratio is
// that of two such times, each of its own best rounds: it favours neither side, and it is right as soon as a
// tenth of the rounds were undisturbed. The tenth of the ratios would not do: it takes the rounds in which
// the other side was disturbed. Nor would the median of the times, for a machine that is busy more than half
// of the time.
#pragma once

#include <time.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace benchmark {

/// Seconds of processor time that this process has used.
inline double processor_seconds() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
/// Seconds of processor time that `work` takes.
template <class Work>
double processor_seconds_of(Work const& work) {
  double const began = processor_seconds();
  work();
  return processor_seconds() - began;
}

/// The value at a share of a sorted sample: 0.5 is the median.
inline double quantile(std::vector<double> v, double share) {
  auto const at = v.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(v.size() - 1) + 0.5);
  std::nth_element(v.begin(), at, v.end());
  return *at;
}
inline double median(std::vector<double> v) { return quantile(std::move(v), 0.5); }

/// The time of a contestant on a machine that leaves it alone: a tenth of the rounds came under it.
inline double best_tenth(std::vector<double> seconds) { return quantile(std::move(seconds), 0.1); }
/// What one contestant takes in units of another: the ratio by which claims are judged.
inline double ratio_of_best(std::vector<double> const& a, std::vector<double> const& b) {
  return best_tenth(a) / best_tenth(b);
}

/// a over b, round by round: how far a busy machine moves the ratio.
inline std::vector<double> ratios(std::vector<double> const& a, std::vector<double> const& b) {
  std::vector<double> out;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) out.push_back(a[i] / b[i]);
  return out;
}

/// Something to be timed: `work` does `units` of it, such as steps.
struct Contestant {
  std::string name;            ///< for the table
  std::function<void()> work;  ///< a few hundred microseconds or more
  double units;                ///< how many steps that is
};

/// Seconds per unit: of each contestant, in each round.
inline std::vector<std::vector<double>> in_turns(int rounds, std::vector<Contestant> const& contestants) {
  std::vector<std::vector<double>> seconds(contestants.size());
  // A first round, not counted, fills caches and predictors.
  for (int round = -1; round < rounds; ++round)
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      double const taken = processor_seconds_of(contestants[i].work) / contestants[i].units;
      if (round >= 0) seconds[i].push_back(taken);
    }
  return seconds;
}

}  // namespace benchmark
