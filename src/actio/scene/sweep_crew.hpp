// Who runs the members of a sweep: processes, each member in one of its own.
//
//     the sweep --> one foreman for each place at work --> one process for each member
//
// Processes and no threads: a member that crashes, or is killed for its memory, takes no other with it, and whatever a run keeps for its whole process
// (interrupts, the HDF5 library) is its own. The foremen come into being with the crew, before the sweep has threads, open files or a network, so that later no
// process has to be forked that holds such things.
#pragma once

#include <functional>
#include <optional>

#include "actio/scene/sweep_member.hpp"

namespace actio::scene {

/// Processes that work on members of a sweep, each on one at a time.
class SweepCrew {
 public:
  /// What is done with a member.
  using Work = std::function<MemberResult(MemberTask, long member)>;

  /// @param work  what is done with a member, in a process of its own
  /// @param size  how many at the same time
  /// @throws FileError  where the system makes no more processes
  SweepCrew(Work const& work, int size);
  ~SweepCrew();
  SweepCrew(SweepCrew const&) = delete;
  SweepCrew& operator=(SweepCrew const&) = delete;

  /// Whether somebody waits for work.
  bool idle() const;
  /// Whether somebody is at work.
  bool busy() const;
  /// Whether nobody is left, since the foremen were killed.
  bool gone() const { return foremen_.empty(); }
  /// Gives a member to one who is idle.
  void start(MemberTask task, long member);
  /// The results that came within so many milliseconds, and at least those that are there.
  std::vector<MemberResult> finished(int milliseconds);
  /// Asks all who are at work to end between two steps. Their results come as others do.
  void stop();
  /// In the process of a member: whether it is to end. Interrupts are for the sweep, which passes them on.
  static bool told_to_stop();

 private:
  struct Foreman {
    int process, socket;
    long member = -1;  // at work on it
  };
  std::optional<MemberResult> result_of(Foreman& foreman);

  std::vector<Foreman> foremen_;
};

}  // namespace actio::scene
