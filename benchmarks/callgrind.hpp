// How many instructions a program executes, counted by valgrind: a figure that the load of the machine does not touch.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace benchmark {

/// Instructions of one whole run of a command, all threads; negative where valgrind gave no count.
inline double instructions_of(std::string const& command) {
  std::string const counted = "valgrind --tool=callgrind --callgrind-out-file=/dev/null " + command + " 2>&1";
  std::FILE* const pipe = popen(counted.c_str(), "r");
  if (!pipe) return -1;
  double count = -1;
  for (char line[512]; std::fgets(line, sizeof line, pipe);)
    if (char const* const at = std::strstr(line, "Collected :")) count = std::atof(at + std::strlen("Collected :"));
  return pclose(pipe) == 0 ? count : -1;
}

}  // namespace benchmark
