// A pilot: the motion of a scene with longer steps than its run will have, over the whole time, for its
// error.
#pragma once

#include <functional>

#include "program/document/schedule.hpp"
#include "program/registry/error_estimate.hpp"

namespace actio::scene {

/// Whether to stop; empty: never.
using Stop = std::function<bool()>;

/// Whether pilots are made where a scene asks for an accuracy; otherwise it is read with its default step.
struct Pilots {
  bool made = true;  ///< whether they are
  Stop stop = {};    ///< asked between their steps
};

/// Someone wants no run any more, before it has begun.
struct Stopped : Error {
  Stopped() : Error("interrupted while the step was chosen") {}
};

/// What rounding adds to an error over so many steps, relative.
double rounding_over(double steps);

/// How the error of a motion grows with the time, by the estimate that its run would tell.
struct Pilot {
  /// The largest error up to a time.
  struct Point {
    double time;       ///< up to which
    double error;      ///< the largest
    std::string of;    ///< what has it
    std::string unit;  ///< of the error: " rad", or nothing
  };
  double step = 0;          ///< time
  double until = 0;         ///< the end of the run
  std::vector<Point> told;  ///< at the times at which a number is told
  std::string untold;       ///< why none is told at the end; empty: one is
  bool whole() const { return !told.empty() && untold.empty(); }  ///< whether one is told at the end
  /// Of a step of this length.
  double rounding(double length) const { return rounding_over(until / length); }
  /// The error at the end with steps of another length, by the order of the method.
  double error_with(double length, int order) const;
  /// The length with which the error at the end is this one; zero where rounding alone adds more.
  double step_for(double error, int order) const;
  /// The last time until which rounding, which grows as an error of the method has grown after its first
  /// steps, leaves less than an error; the growth up to the last number that was told.
  /// @return  the time; `until` where nothing speaks against it
  double met_until(double error) const;
};

/// Makes it. A motion that fails on the way is one of which no error is told. Within its first sixteen steps
/// it is looked at where the run has rows.
/// @throws Stopped
Pilot pilot(Simulation simulation, Schedule const& rows, Stop const& stop);

}  // namespace actio::scene
