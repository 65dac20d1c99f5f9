// The machine on which something was measured: said by every program that reports a time.
//
// A time means nothing without it. `report_machine` prints it and puts it into the report: the table "machine", and the figures "processor" and "date"
// for use in a sentence.
#pragma once

#include <chrono>
#include <ctime>
#include <fstream>
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
inline std::string processor_name() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name")) {
      auto const at = line.find_first_not_of(" \t", line.find(':') + 1);
      if (at != std::string::npos) return line.substr(at);
    }
  return "unknown";
}

/// The widest vectors among those that matter here.
inline std::string vector_instructions() {
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f")) return "AVX-512";
  if (__builtin_cpu_supports("avx2")) return __builtin_cpu_supports("fma") ? "AVX2 with FMA" : "AVX2";
  return __builtin_cpu_supports("avx") ? "AVX" : "SSE2";
#else
  return "unknown";
#endif
}

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
inline std::string date_of(std::time_t time) {
  std::tm parts{};
  gmtime_r(&time, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &parts);
  return text;
}

/// Prints and reports this machine, and when the program ran.
inline void report_machine(Program& program) {
  Machine const m = this_machine();
  std::time_t const now = std::time(nullptr);
  std::string const date = date_of(now) + " UTC";
  program.table("machine", {"", "measured on"},
                {{"processor", m.processor + ", " + std::to_string(m.cores) + " cores"},
                 {"vector instructions", m.vectors},
                 {"compiler", m.compiler},
                 {"flags", m.flags},
                 {"run", date}});
  program.figure("processor", m.cores, m.processor, "processor");
  program.figure("date", static_cast<double>(now), date, "run");
}

}  // namespace book
