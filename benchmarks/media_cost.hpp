// What a step of a medium costs on one thread and on two, beside the same scheme as a plain loop and beside
// finite elements.
#pragma once

#include <chrono>
#include <cmath>

#include "actio/fast_media/fast_medium.hpp"
#include "benchmark.hpp"
#include "peers/finite_elements.hpp"
#include "timing.hpp"

namespace benchmark {

inline double seconds_of(std::function<void()> const& work) {
  auto const began = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}
/// Nanoseconds per unit on the wall: of each contestant what a tenth of its rounds came under.
inline std::vector<double> nanoseconds_on_the_wall(int rounds, std::vector<Contestant> const& contestants) {
  std::vector<std::vector<double>> seconds(contestants.size());
  for (int round = -1; round < rounds; ++round)
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      double const taken = seconds_of(contestants[i].work) / contestants[i].units;
      if (round >= 0) seconds[i].push_back(1e9 * taken);
    }
  std::vector<double> best;
  for (auto const& s : seconds) best.push_back(best_tenth(s));
  return best;
}

/// Nanoseconds for a cell and step.
struct Cost {
  double one, two, plain, elements;
};
/// @param box, small  for the optimised implementation, and for the other two
/// @param sum         gets something of the last states, so that nothing is left out
template <class Medium, class Stress, class Box, class Placement, class Velocity>
Cost cost_of(Benchmark const& program, Medium const& medium, Stress const& stress, Box const& box,
             Box const& small, int steps, Placement const& placement, Velocity const& velocity, double& sum) {
  using Fast = actio::media::FastMedium<Medium, Box>;
  double const dt = 0.1 * box.spacing[0], dt_small = 0.1 * small.spacing[0];
  Fast one(medium, box, dt, 1, placement, velocity), two(medium, box, dt, 1, placement, velocity, {2}),
      for_plain(medium, small, dt_small, 1, placement, velocity);
  auto plain = peers::gathered(stress, small, dt_small, for_plain.places(), for_plain.velocities());
  peers::FiniteElements elements(plain);
  auto const cells = [](Box const& of) {
    double all = 1;
    for (int const n : of.cells) all *= n;
    return all;
  };
  auto const t = nanoseconds_on_the_wall(program.rounds(30),
                                         {{"one thread", [&] { one.step(steps); }, cells(box) * steps},
                                          {"two threads", [&] { two.step(steps); }, cells(box) * steps},
                                          {"plain loop", [&] { plain.step(); }, cells(small)},
                                          {"elements", [&] { elements.step(); }, cells(small)}});
  sum += one.momentum()[0] + two.momentum()[0] + plain.v[7][0] + elements.medium.v[7][0];
  return {t[0], t[1], t[2], t[3]};
}

}  // namespace benchmark
