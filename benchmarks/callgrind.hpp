// How many instructions a program executes, counted by valgrind: a figure that neither the load nor the make
// of the machine touches.
//
// A program counts itself: it starts itself anew under `valgrind --tool=callgrind`. Either the whole run is
// counted, or, where valgrind's header is there when the program is compiled, each piece of work that the
// program hands to `counted`.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#endif

namespace benchmark {

/// Whether valgrind is there.
inline bool instructions_can_be_counted() { return std::system("valgrind --version >/dev/null 2>&1") == 0; }
/// Whether it can also count pieces of a run.
inline bool pieces_can_be_counted() {
#if defined(CALLGRIND_ZERO_STATS)
  return instructions_can_be_counted();
#else
  return false;
#endif
}

/// Instructions of one whole run of a command, all threads; negative where valgrind gave no count.
inline double instructions_of(std::string const& command) {
  std::string const counted = "valgrind --tool=callgrind --callgrind-out-file=/dev/null " + command + " 2>&1";
  std::FILE* const pipe = popen(counted.c_str(), "r");
  if (!pipe) return -1;
  double count = -1;
  for (char line[512]; std::fgets(line, sizeof line, pipe);)
    if (char const* const at = std::strstr(line, "Collected :"))
      count = std::atof(at + std::strlen("Collected :"));
  return pclose(pipe) == 0 ? count : -1;
}

/// Does a piece of work twice: the second time valgrind counts it under a name. The first time has the
/// functions of the libraries found and the memory got.
template <class Work>
void counted([[maybe_unused]] char const* name, Work const& work) {
  work();
#if defined(CALLGRIND_ZERO_STATS)
  CALLGRIND_ZERO_STATS;
  work();
  CALLGRIND_DUMP_STATS_AT(name);
#endif
}

/// The pieces that a run of a command has `counted`: instructions by name, none where valgrind gave no count.
inline std::map<std::string, double> counted_pieces(std::string const& command) {
  std::map<std::string, double> counts;
  std::string folder = (std::filesystem::temp_directory_path() / "actio_count_XXXXXX").string();
  if (!::mkdtemp(folder.data())) return counts;
  if (std::system(("valgrind --tool=callgrind --callgrind-out-file='" + folder + "/count' " + command +
                   " >/dev/null 2>&1")
                      .c_str()) == 0)
    for (auto const& entry : std::filesystem::directory_iterator(folder)) {
      std::ifstream in(entry.path());
      std::string const mark = "desc: Trigger: Client Request: ", total = "totals: ";
      std::string name;
      for (std::string line; std::getline(in, line);) {
        if (line.starts_with(mark)) name = line.substr(mark.size());
        if (line.starts_with(total) && !name.empty()) counts[name] = std::atof(line.c_str() + total.size());
      }
    }
  std::filesystem::remove_all(folder);
  return counts;
}

}  // namespace benchmark
