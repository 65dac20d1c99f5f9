// Runs of rods in explicit steps and by generalised-alpha, measured in the same way.
#pragma once

#include "actio/rods/rod.hpp"
#include "book/measure.hpp"
#include "book/program.hpp"
#include "witness/generalised_alpha.hpp"

namespace actio::rods {

/// What is asked of both: places, energy, momenta.
struct Look {
  std::vector<Three<double>> places;
  double energy;
  Eigen::Vector3d angular;
};
/// Of explicit steps.
inline Look look(Rod& run) {
  auto const frame = run.frame();
  auto const energies = run.energies(frame);
  auto const L = run.momentum().angular;
  return {frame.places, energies.kinetic + energies.strain, {L[0], L[1], L[2]}};
}
/// Of generalised-alpha.
inline Look look(GeneralisedAlpha& run) {
  return {run.now().shape.places, run.now().energy(run.rod()), run.now().momentum(run.rod()).tail<3>()};
}
/// So many steps.
inline void advance(Rod& run, long steps) { run.step(steps); }
/// The same.
inline void advance(GeneralisedAlpha& run, long steps) {
  for (long k = 0; k < steps; ++k) run.step();
}
/// How many systems of equations were solved.
inline double solves_of(Rod const&) { return 0; }
/// The same.
inline double solves_of(GeneralisedAlpha const& run) { return static_cast<double>(run.solves()); }

/// A run: its error at a time, what it takes, and what changes from then on, in free flight.
struct RodRun {
  double step = 0,              ///< h, time
      error = 0,                ///< of places
      microseconds = HUGE_VAL,  ///< of a step
      solves = 0,               ///< systems of equations in a step
      energy = 0,               ///< largest relative change
      lost = 0,                 ///< at the end, relative
      angular = 0;              ///< largest relative change
};
/// Runs from one start.
/// @param time    of the error
/// @param flight  how long it flies on; 0: it does not
/// @param truth   what the places are compared with
template <class Run>
RodRun measure(Run const& begin, double h, double time, double flight, RodMotion const& truth) {
  RodRun out;
  out.step = h;
  long const steps = std::lround(time / h);
  for (int k = 0; k < 9; ++k) {  // the shortest of some
    Run run = begin;
    double const seconds = book::seconds_of([&] { advance(run, steps); });
    out.microseconds = std::min(out.microseconds, 1e6 * seconds / static_cast<double>(steps));
  }
  Run run = begin;
  advance(run, steps);
  out.solves = solves_of(run) / static_cast<double>(steps);
  Look const then = look(run);
  for (std::size_t k = 0; k < then.places.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i)
      out.error = std::max(out.error, std::abs(then.places[k][i] - truth.shape.places[k][i]));
  long const every = std::max(1L, std::lround(0.1 / h));
  for (long k = 0; k < std::lround(flight / h); k += every) {
    advance(run, every);
    Look const now = look(run);
    out.lost = 1 - now.energy / then.energy, out.energy = std::max(out.energy, std::abs(out.lost));
    out.angular = std::max(out.angular, (now.angular - then.angular).norm() / then.angular.norm());
  }
  return out;
}
/// A row of a table.
/// @param flies  whether changes in flight are told
inline book::Program::Row row_of(std::string const& method, RodRun const& m, bool flies) {
  using book::number;
  book::Program::Row out{method, number(m.step), number(m.error, 2)};
  if (flies) out.insert(out.end(), {number(m.energy, 2), number(m.lost, 2), number(m.angular, 2)});
  out.insert(out.end(), {m.solves > 0 ? number(m.solves, 3) : "–", number(m.microseconds, 3)});
  return out;
}

}  // namespace actio::rods
