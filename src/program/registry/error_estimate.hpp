// An estimate of the error of a run: how far attitude, momentum and what else a state has are from those of
// the true motion.
//
// A companion runs beside the run, with steps that are r = 2, 3 or 4 times as long, and a control with steps
// of twice that length; together they cost half of the run at most where r >= 3. A method of order p has the
// error C h^p t + ..., so that over n steps of the run, n = r m + k, the companion, which makes m long steps
// and a last one of k, has an error that is
//
//     R = (r^(p+1) m + k^(p+1)) / (r m + k)
//
// times as large. The two states are therefore apart by (R - 1) times the error of the run (Richardson). The
// control makes the same estimate. No number is told
//
// * where run and companion are further apart than a tenth of a radian or of the value: their difference is
//   then no multiple of the error any more. Once the control is a tenth apart, or the two are in another
//   respect, a hundredth is the limit, unless the control still tells the same error within a half;
// * where the two estimates differed by more than a factor of three while the control was near enough to be
//   compared: the steps are too long for the order to be seen. The rest of the expansion of the error by the
//   powers of h weighs r^2 times as much, at least, in the estimate of the control, so that the one of the
//   companion is closer than that.
//
// Instead it is told until when there was one. Where the true motion is known in closed form, that of a free
// body in space, it takes the place of the companion, and the difference is the error itself.
//
// What rounding adds is of the order of the rounding unit times the root of the number of steps, and that is
// added to the estimate. Where companion and control are as far from the run as each other, and not by more
// than rounding may have grown to, that distance is the error.
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "program/base/checkpoint_stream.hpp"
#include "program/registry/simulation.hpp"

namespace actio::scene {

/// The errors of one run, estimated from its companions.
class ErrorEstimate {
 public:
  /// @param simulation  of the run; it outlives the estimate
  explicit ErrorEstimate(Simulation& simulation) : run_(simulation), companion_(simulation.companion) {}

  /// Moves the companions on with the run, which has made so many steps.
  void follow(long steps);
  /// Compares the states at a row of the run, if that is due: where the companions have a step, and otherwise
  /// at rows that are some 8 steps apart in the first 2048, later some 64, or 128 where the companion is
  /// exact; and in the last row.
  /// @param time   of the row
  /// @param steps  of the run up to the row
  void see(long row, double time, long steps, bool last);

  /// The largest error so far in one respect, or why none is told.
  struct Entry {
    /// `attitude`, in radians; `configuration`, the distance that `ReducedMotion` has; `momentum` and
    /// `vectors`, relative to the largest modulus that they have had; or a quantity of which no error is told
    std::string name;
    double error = std::numeric_limits<double>::quiet_NaN();  ///< NaN: none is told
    std::string unit = "";                                    ///< " rad", or nothing
    std::string said = "";                                    ///< why none is told, a sentence
    /// the last time at which an error was told; NaN where there was none
    double until = std::numeric_limits<double>::quiet_NaN();
    double then = std::numeric_limits<double>::quiet_NaN();  ///< that error
    bool told() const { return said.empty(); }               ///< whether there is a number
  };
  /// Of what a state has; none where nothing is estimated.
  std::vector<Entry> entries() const;
  /// The largest of them, of what has an estimate at all, or one of which no number is told; none where
  /// nothing is estimated so far.
  std::optional<Entry> worst() const;
  /// In words: how it is estimated, or why it is not.
  std::string how() const;

  /// Saves, or restores, the companions and what was seen.
  void remember(CheckpointStream& stream);

 private:
  /// Of one respect: the largest so far, in its own unit.
  struct Seen {
    double error = 0, whole = 0,            // as estimated by the companion and by the control
        compared = 0, control = 0,          // the same, while the control was near
        apart = 0, control_apart = 0,       // they from the run
        modulus = 0, until = -1, then = 0;  // a time at which an error was told, and that
    bool near(double distance, double limit = 0.1) const { return distance <= limit * modulus; }
    bool linear() const { return near(apart) && (near(control_apart) || agree_closely()); }
    bool agree() const { return control <= 3 * compared && compared <= 3 * control; }
    bool agree_closely() const { return whole <= 1.5 * error && error <= 1.5 * whole; }
    bool as_rounding() const { return control_apart < 2 * apart && apart <= 1e-9 * modulus; }
    double value() const { return modulus > 0 ? (as_rounding() ? apart : error) / modulus : 0; }
  };
  /// A motion with longer steps.
  struct Follower {
    Motion* motion;
    long ratio;  // of the run to one of its steps
    long made;   // steps that it has made
    double time_beyond(double time, double step) const;
    double factor(double beyond, int order) const;
  };
  Follower companion() const { return {companion_.motion.get(), companion_.steps, made_}; }
  Follower control() const { return {companion_.control.get(), companion_.control_steps, control_made_}; }
  bool follow(Follower follower, long& made, long steps) const;
  void compare(double factor, double control_factor, long steps, double time);
  double limit() const;
  bool holds(Seen const& seen) const;
  Entry entry(std::string const& name, std::string const& unit, Seen const& seen) const;
  bool estimates() const { return companion_.motion && (seen_ || lost_); }

  Simulation& run_;
  Companion& companion_;
  long made_ = 0, control_made_ = 0;  // steps of the companion and of the control
  std::array<Seen, 3> largest_;       // attitude or configuration, momentum, carried vectors
  bool seen_ = false, lost_ = false;
};

}  // namespace actio::scene
