// Run time against error: each method with many step lengths over the same task, then for each error to be
// reached the longest step that reaches it.
//
// The error of a run is the largest at ten times on the way. At the end alone it would pass through zero now
// and then, and the step that happens to do so would win.
#pragma once

#include "error_against_time.hpp"
#include "peers/witness.hpp"

namespace benchmark {

/// How many times on the way, the end included, a run is compared with the reference solution.
inline constexpr int looks = 10;
using States = std::array<peers::Seven, looks>;
using Witnesses = std::array<peers::Exact, looks>;

/// All runs of one method, each with a number of steps, or the tolerance where steps are controlled.
struct Curve : Line {
  std::function<States(double setting)> solve;
};

/// How long the search for the best step continues.
struct Patience {
  double share = 1;  ///< of the longest time that a run may take
  int repeats = 3;   ///< of a run, at least
  int idle = 25;     ///< shorter steps that are tried after the last that helped
};

/// Runs with one setting; short ones are repeated, and the shortest time counts.
inline Timed run(Curve const& curve, double setting, Witnesses const& exact, Patience const& patience) {
  Timed out{setting, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  double spent = 0;
  for (int repeat = 0; repeat < patience.repeats || (repeat < 20 && spent < 2e-3); ++repeat) {
    States states{};
    double const seconds = processor_seconds_of([&] { states = curve.solve(setting); });
    spent += seconds;
    out.seconds = std::min(out.seconds, seconds);
    if (repeat == 0) {
      out.error = 0;
      for (int k = 0; k < looks; ++k) out.error = std::max(out.error, peers::error_of(states[k], exact[k]));
    }
    if (spent > 0.05 * patience.share) break;
  }
  return out;
}

/// Steps of one length, from long to short, until a run takes longer than `longest` seconds or no shorter
/// step has helped for a while.
inline Curve with_fixed_steps(peers::Task const& task, double time, peers::Method const& method,
                              Witnesses const& exact, double first, double ratio, double longest,
                              Patience const& patience) {
  Curve curve{{method.name, {}}, [=](double steps) {
                auto const stepper = method.make(task, time / steps);
                States states;
                for (peers::Seven& s : states)
                  stepper->advance(static_cast<long>(steps) / looks), s = stepper->state();
                return states;
              }};
  int idle = 0;
  double best = std::numeric_limits<double>::infinity();
  for (double steps = first; idle < patience.idle; steps = looks * std::round(steps * ratio / looks)) {
    try {
      curve.runs.push_back(run(curve, steps, exact, patience));
    } catch (std::exception const&) {
      continue;  // the step is too long for the method
    }
    Timed const& last = curve.runs.back();
    idle = last.error < best ? 0 : best < 1e-7 ? idle + 1 : 0;
    best = std::min(best, last.error);
    if (last.seconds > longest * patience.share) break;
  }
  return curve;
}

/// Step control: tolerances from 1e-5 to 1e-14, four to the decade.
template <class Solve>
Curve with_step_control(std::string name, Solve const& solve, Witnesses const& exact,
                        Patience const& patience) {
  Curve curve{{std::move(name), {}}, solve};
  // Near the rounding of double the control takes steps without end: 1e-14 is the last.
  for (int k = 20; k <= 56 && (curve.runs.empty() || curve.runs.back().seconds < 0.1 * patience.share); ++k)
    curve.runs.push_back(run(curve, std::pow(10.0, -k / 4.0), exact, patience));
  return curve;
}

}  // namespace benchmark
