#include "python/available_memory.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>

#include "actio/numbers/errors.hpp"

namespace actio::python {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

/// The number in a file that holds one; `unknown` where it is not there, or holds the word `max`.
double number_in(char const* path) {
  std::ifstream in(path);
  double value = 0;
  return in >> value ? value : unknown;
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

/// Without the pages of files that can be dropped.
double left_in_the_group() {
  double const most = number_in("/sys/fs/cgroup/memory.max");
  double const taken = number_in("/sys/fs/cgroup/memory.current");
  if (most == unknown || taken == unknown) return unknown;
  char const* const statistics = "/sys/fs/cgroup/memory.stat";
  double const dropped = number_after("inactive_file", statistics) + number_after("active_file", statistics);
  return std::max(0.0, most - taken + dropped);
}
double left_in_the_system() {
  double const kilobytes = number_after("MemAvailable:", "/proc/meminfo");
  return kilobytes > 0 ? 1024 * kilobytes : unknown;
}

std::string in_words(double bytes) {
  constexpr std::array<char const*, 6> units{"bytes", "kB", "MB", "GB", "TB", "PB"};
  std::size_t k = 0;
  while (bytes >= 1000 && k + 1 < units.size()) bytes /= 1000, ++k;
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%.4g %s", bytes, units[k]);
  return text.data();
}

}  // namespace

double available_memory() { return std::min(left_in_the_system(), left_in_the_group()); }

void check_that_it_fits(double rows, std::size_t columns) {
  double const bytes = 8 * rows * static_cast<double>(columns), available = available_memory();
  if (bytes <= available) return;
  std::array<char, 32> count;
  std::snprintf(count.data(), count.size(), "%.0f", rows);
  throw Error(std::string(count.data()) + " rows of " + std::to_string(columns) +
              " columns at 8 bytes a number take " + in_words(bytes) + ", and " + in_words(available) +
              " of memory are available; fewer rows or quantities would do, or the command "
              "`actio run`, which writes as it goes");
}

}  // namespace actio::python
