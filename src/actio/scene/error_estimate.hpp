// An estimate of the error of a run: how far attitude and body momentum are from those of the true motion.
//
// A companion runs beside the run, with steps that are r = 3 or 4 times as long; it costs a quarter to a
// third of the run. A method of order p has the error C h^p t + ..., so that over n steps of the run, n = r
// m + k, the companion, which makes m long steps and a last one of k, has an error that is
//
//     R = (r^(p+1) m + k^(p+1)) / (r m + k)
//
// times as large. The two states are therefore apart by (R - 1) times the error of the run (Richardson).
// Where the true motion is known in closed form, that of a free body in space, it takes the place of the
// companion, and the difference is the error itself.
//
// What rounding adds is of the order of the rounding unit times the root of the number of steps, and that is
// added to the estimate.
#pragma once

#include "actio/scene/checkpoint_stream.hpp"
#include "actio/scene/simulation.hpp"

namespace actio::scene {

/// The errors of attitude and momentum of one run, estimated from its companion.
class ErrorEstimate {
 public:
  /// @param simulation  of the run; it outlives the estimate
  explicit ErrorEstimate(Simulation& simulation) : run_(simulation), companion_(simulation.companion) {}

  /// Whether errors are estimated, and have been so far.
  bool empty() const { return !companion_.motion || lost_ || !seen_; }
  /// Moves the companion on with the run, which has made so many steps.
  void follow(long steps);
  /// Compares the states at a row of the run, if that is due: where the companion has a step, every sixteenth
  /// row where it is exact, and in the last row.
  /// @param time   of the row
  /// @param steps  of the run up to the row
  void see(long row, double time, long steps, bool last);

  /// The largest error so far of one quantity.
  struct Entry {
    /// `attitude`, in radians, or `momentum`, or what else the system calls it, relative to the largest
    /// modulus that it has had
    std::string name;
    double error;  ///< in that unit
  };
  /// Of the attitude, where it is reconstructed, and of the momentum; none where nothing is estimated.
  std::vector<Entry> entries() const;
  /// In words: how it is estimated, or why it is not.
  std::string how() const;

  /// Saves, or restores, the companion and what was seen.
  void remember(CheckpointStream& stream);

 private:
  void compare(double factor, long steps);

  Simulation& run_;
  Companion& companion_;
  long made_ = 0;  // steps of the companion
  StateDistance largest_;
  bool seen_ = false, lost_ = false;
};

}  // namespace actio::scene
