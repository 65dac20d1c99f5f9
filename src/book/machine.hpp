// The machine on which something was measured: said by every program that reports a time.
//
// A time means nothing without it. `report_machine` prints it and puts it into the report: the table
// "machine", and the figures "processor" and "date" for use in a sentence.
#pragma once

#include <chrono>
#include <ctime>
#include <thread>

#include "book/program.hpp"

namespace book {

/// What a time depends on.
struct Machine {
  std::string processor;  ///< its name, as the system gives it
  unsigned cores;         ///< how many it offers to this process
  std::string vectors;    ///< the widest vector instructions it has
  std::string compiler;   ///< name and version
  std::string flags;      ///< what the program was compiled with
};

/// The name in /proc/cpuinfo.
std::string processor_name();

/// The widest vectors among those that matter here.
std::string vector_instructions();

/// This machine and this program. Define `ACTIO_FLAGS` to have the flags told.
inline Machine this_machine() {
#if defined(__clang__)
  std::string const compiler = "Clang " __clang_version__;
#elif defined(__GNUC__)
  std::string const compiler = "GCC " __VERSION__;
#else
  std::string const compiler = "unknown";
#endif
#if defined(ACTIO_FLAGS)
  std::string const flags = ACTIO_FLAGS;
#else
  std::string const flags = "not told";
#endif
  return {processor_name(), std::thread::hardware_concurrency(), vector_instructions(), compiler, flags};
}

/// Day and time, UTC: 2026-11-21 20:15.
std::string date_of(std::time_t time);

/// Prints and reports a machine, and when the program ran.
void report_machine(Program& program, Machine const& machine);
/// The same for this machine.
inline void report_machine(Program& program) { report_machine(program, this_machine()); }

}  // namespace book
