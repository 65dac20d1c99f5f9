// The worker pool of a sweep: processes, each of which works on one member after the other, and a supervisor
// ("foreman") of each.
//
//     the sweep <--> one worker for each place at work
//          \----> its foreman, who makes it, and another one where it ends
//
// Processes and no threads: a member that crashes, or is killed for its memory, takes no other with it, and
// whatever a run keeps for its whole process
// (interrupts, the HDF5 library) is not that of the sweep. The foremen come into being with the crew, before
// the sweep has threads, open files or a network,
// so that later no process has to be forked that holds such things. A worker whose member failed in writing
// its files is replaced, too.
#pragma once

#include <functional>
#include <optional>

#include "program/sweep/member.hpp"

namespace actio::scene {

/// The worker pool: processes that work on members of a sweep, each on one at a time.
class SweepCrew {
 public:
  /// What is done with a member.
  using Work = std::function<MemberResult(MemberTask, long member)>;

  /// @param work  what is done with a member, in another process
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
  /// Whether no worker is left, since the foremen were killed.
  bool gone() const { return places_.empty(); }
  /// Gives a member to one who is idle.
  void start(MemberTask task, long member);
  /// The results that came within so many milliseconds, and at least those that are there.
  std::vector<MemberResult> finished(int milliseconds);
  /// Asks all who are at work to end between two steps. Their results come as others do.
  void stop();
  /// In the process of a worker: whether it is to end. Interrupts are for the sweep, which passes them on.
  static bool told_to_stop();

 private:
  /// One at a time works here.
  struct Place {
    int foreman, control;  // its process, and the line to it
    int line = -1;         // to the worker; -1 while there is none
    long member = -1;      // at work on it
  };
  std::optional<MemberResult> from_worker(Place& place);
  std::optional<MemberResult> from_foreman(Place& place);

  std::vector<Place> places_;
};

}  // namespace actio::scene
