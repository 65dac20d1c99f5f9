// One member of a sweep: read, run, and told of.
#pragma once

#include "program/run/run.hpp"
#include "program/sweep/sweep.hpp"

namespace actio::scene {

/// How a member went.
struct MemberResult {
  long member = -1;  ///< its number
  /// the exit status that `actio run` would have; 128 + signal where one ended it
  int status = 0;
  std::string message;                      ///< where it did not end well: what went wrong
  long rows = 0;                            ///< of its series
  double bytes = 0;                         ///< that its series will take, about
  long steps = 0;                           ///< that were made
  double seconds = 0;                       ///< that it took
  std::vector<Drift::Entry> drift;          ///< of each conserved quantity
  std::vector<ErrorEstimate::Entry> error;  ///< of attitude and momentum, estimated
  std::vector<std::string> columns;         ///< of its series, the time first
  std::vector<double> last_row;             ///< one for each of them
  InputFiles inputs;                        ///< with which its scene was read, where that was the task
  bool input_changed = false;               ///< whether it ended since one of them is not what it was

  /// As bytes, for another process.
  std::string packed() const;
  /// @throws Error  where the bytes are not those of a result
  static MemberResult unpacked(std::string const& bytes);
};

/// What is done with a member.
enum class MemberTask {
  check,  ///< its scene is read
  run     ///< and run
};

/// Does it; whatever goes wrong is in the result. A member that has begun before goes on from its checkpoint,
/// or starts anew where there is none.
/// @param stop  whether to end between two steps
MemberResult work_on_member(SweepPlan const& plan, MemberTask task, long member,
                            std::function<bool()> const& stop = interrupted);

}  // namespace actio::scene
