// The processes of a worker pool: a foreman (supervisor), which starts a worker and another one where it
// ends, and the worker, which takes orders from the sweep and answers with results. Sockets join them; a
// process ends when the other side of its socket has gone.
#pragma once

#include <sys/wait.h>

#include <functional>
#include <optional>
#include <string>

#include "program/sweep/member.hpp"

namespace actio::scene::worker {

/// What a worker is told to do.
struct Order {
  MemberTask task;  ///< what
  long member;      ///< with which
};

/// What a foreman tells: how the worker before ended, and the line to the next one.
struct Notice {
  int status = 0;  ///< as `waitpid` gives it
  int line = -1;   ///< open in the process that received it
};

/// A pair of sockets.
struct Line {
  int here = -1,   ///< for the one who makes it
      there = -1;  ///< for the other
  Line();
  /// Whether the system made it.
  bool made() const { return here >= 0; }
};

/// False where the other side has gone.
bool send_order(int line, Order const& order);
/// Nothing where the other side has gone before the whole of it came.
std::optional<std::string> receive_text(int line);
/// Nothing where the foreman has gone.
std::optional<Notice> receive_notice(int control);
/// Asks a foreman to make its worker end between two steps.
void ask_to_stop(int control);
/// Waits for the end of a child; how it ended.
int wait_for_end(int process);

/// Whether a worker ends after such a result: libraries may hold on to a file that could not be written.
bool retires_after(MemberResult const& result);
/// In a worker: whether it was told to end its member.
bool told_to_stop();

/// Makes workers until the sweep closes its side. What it does with signals its workers inherit.
[[noreturn]] void be_foreman(std::function<MemberResult(MemberTask, long)> const& work, int control);

}  // namespace actio::scene::worker
