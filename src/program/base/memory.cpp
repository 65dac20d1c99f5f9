#include "program/base/memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>

namespace actio::scene {

namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

/// The number in a file that holds one; `unknown` where it is not there, or holds the word `max`.
double number_in(char const* path) {
  std::ifstream in(path);
  double value = 0;
  return in >> value && value > 0 ? value : unknown;
}
/// The number after a word in a file of names and numbers, a line for each; zero where it is not there.
double number_after(char const* word, char const* path) {
  std::ifstream in(path);
  std::string name, rest;
  double value = 0;
  while (in >> name >> value && std::getline(in, rest))
    if (name == word) return value;
  return 0;
}
/// What the group of this process may still take, pages of files that can be dropped not counted as taken.
double left_in_the_group() {
  double const most = number_in("/sys/fs/cgroup/memory.max"),
               taken = number_in("/sys/fs/cgroup/memory.current");
  if (most == unknown || taken == unknown) return number_in("/sys/fs/cgroup/memory/memory.limit_in_bytes");
  char const* const statistics = "/sys/fs/cgroup/memory.stat";
  double const dropped = number_after("inactive_file", statistics) + number_after("active_file", statistics);
  return std::max(0.0, most - taken + dropped);
}

}  // namespace

double bytes_of_machine() {
  double bytes = left_in_the_group();
  // What others use is not there.
  if (double const available = number_after("MemAvailable:", "/proc/meminfo"); available > 0)
    bytes = std::min(bytes, 1024 * available);
  for (auto const which : {RLIMIT_AS, RLIMIT_DATA})
    if (rlimit limit{}; ::getrlimit(which, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
      bytes = std::min(bytes, static_cast<double>(limit.rlim_cur));
  return bytes;
}

std::string bytes_in_words(double bytes) {
  char const* const units[] = {"B", "kB", "MB", "GB", "TB", "PB", "EB"};
  int k = 0;
  while (bytes >= 999.5 && k < 6) bytes /= 1000, ++k;
  return fmt::format("{:.3g} {}", bytes, units[k]);
}

void require_memory(double needed, Place const& place, std::string const& what,
                    std::function<std::string(double there)> const& would_do) {
  if (double const there = bytes_of_machine(); needed > there)
    throw SceneError(place, what + " take about " + bytes_in_words(needed) +
                                " of memory in this scene, where " + bytes_in_words(there) + " are there; " +
                                would_do(there));
}

}  // namespace actio::scene
