// A sweep on its way: first every scene is read, so that a mistyped value is known before hours have passed,
// then those that are in order are run, by processes
// on one machine or on many.
#pragma once

#include "program/sweep/crew.hpp"

namespace actio::scene {

/// Who else works on the sweep, and how the work is shared. Of a sweep in one process: none.
class SweepSharing {
 public:
  virtual ~SweepSharing() = default;
  /// Whether this process speaks for the sweep: it gets all results, and writes the table.
  virtual bool speaks() const { return true; }
  /// The next member that no process has taken; any number beyond the last where there is none.
  virtual long next() { return next_++; }
  /// Tells the one who speaks. Called by the others.
  virtual void deliver(MemberResult const&) {}
  /// What was delivered since. Called by the one who speaks, every few milliseconds.
  virtual std::vector<MemberResult> delivered() { return {}; }
  /// This process takes no more members, and has delivered its last result.
  virtual void leave() {}
  /// Whether all others have left.
  virtual bool all_left() { return true; }
  /// What the one who speaks says, for all; then members are counted from 0 again.
  virtual std::string agree(std::string const& said) {
    next_ = 0;
    return said;
  }
  /// How many milliseconds may pass before it is looked at what others delivered.
  virtual int patience() const { return 100; }

 private:
  long next_ = 0;
};

/// How a sweep is run.
struct SweepOptions {
  bool quiet = false;    ///< no progress, no complaints of members, no closing line
  bool force = false;    ///< replaces the sweep that is in the folder
  bool resume = false;   ///< goes on with it
  bool dry_run = false;  ///< reads all scenes, tells what would be run, and writes nothing
};

/// Runs a sweep, tells failed members on standard error, and leaves the table `sweep.csv`, which is written
/// from time to time as well.
/// @return the exit status: 0 where all members are done, 130 where it was interrupted, otherwise the
/// largest of theirs
/// @throws FileError, SceneError  in the process that speaks
int run_sweep(SweepPlan const& plan, SweepCrew& crew, SweepSharing& sharing, SweepOptions const& options);

}  // namespace actio::scene
