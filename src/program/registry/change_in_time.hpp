// How fast a formula changes with time, without stepping over what is short: a torque of hours in a run of
// years.
//
// Looks at many times find what is wide. Here bounds of the second derivative over whole intervals of time
// are compared with its values: the interval with the largest bound is halved until the bounds are those of
// values that were found. So an interval is left whole only where nothing happens in it.
#pragma once

#include <vector>

#include "actio/formula/tape.hpp"

namespace actio::scene {

/// What is known of a formula over an interval of time, its other inputs fixed.
struct ChangeInTime {
  double least,      ///< the least of the values found
      most;          ///< the largest of them
  double bend = 0;   ///< the largest modulus of the second derivative found, 1/time^2
  double bound = 0;  ///< of that modulus, over the whole interval
  double from = 0,   ///< where the bound is that of, if it is not settled
      to = 0;        ///< and until when
  /// whether the bound is no more than four times what was found, but for events whose height may be, by the
  /// bound, at most a hundredth of the range of the values
  bool settled = true;

  /// Of both together.
  void join(ChangeInTime const& other);
  /// A wave in time has the square of its frequency for the ratio of the second derivative to itself; 1/time.
  double frequency() const;
};

/// Looks at it from 0 on.
/// @param second  value, first and second derivative by the last input, which is the time
/// @param inputs  the last of them is of no matter
/// @param enough  a second derivative that does not matter
/// @param most    intervals that are looked at
ChangeInTime change_in_time(Tape const& second, std::vector<double> inputs, double until, double enough,
                            int most);

}  // namespace actio::scene
