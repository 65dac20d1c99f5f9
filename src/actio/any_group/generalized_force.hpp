// A force on an invariant system, given at run time: a formula in velocity, momentum, carried vectors, time,
// and inputs that hold over a step.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "actio/formula/tape.hpp"

namespace actio::systems {

/// A number that is given to a force as a function of time, and held over each step: its value is that in
/// the middle of the step. A jump at the end of a step changes no step.
class HeldInput {
 public:
  /// A formula of the time.
  /// @param of_time  of one input and one output
  explicit HeldInput(Tape of_time) : of_time_(std::move(of_time)) {}
  /// The value of each row from its time on; the first one's before.
  /// @param rows  (time, value), the times in ascending order; at least one
  /// @throws OutsideDomain  where there is none, where one is not finite, where a time is not after the last
  explicit HeldInput(std::vector<std::pair<double, double>> rows);

  /// Its value at a time.
  double operator()(double t) const;

 private:
  Tape of_time_;
  std::vector<std::pair<double, double>> rows_;
};

/// A force as a covector in the components of the velocity, \f$F(v, a, p, t, u)\f$, energy: its power is
/// \f$\langle F, v\rangle\f$.
///
/// \snippet reduction.cpp force_across
struct GeneralizedForce {
  /// The components. The inputs are the velocity, the carried vectors one after the other, the momentum,
  /// the time, and the held inputs.
  Tape components;
  std::vector<HeldInput> held = {};  ///< u, in the order of the inputs
  /// A force that is added, of the same inputs, in components of the other side: in space on the left, of the
  /// body on the right. A step then needs the `frame` of its start.
  std::optional<Tape> across = {};

  /// Whether both ends of a step have the same force at one velocity and momentum.
  /// @param dimension  of the group
  bool is_same_at_both_ends(int dimension) const;
};

}  // namespace actio::systems
