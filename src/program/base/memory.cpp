#include "program/base/memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

namespace actio::scene {

double bytes_of_machine() {
  double bytes =
      static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGE_SIZE));
  if (!(bytes > 0)) bytes = std::numeric_limits<double>::infinity();
  for (char const* path : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
    std::ifstream in(path);
    if (double limit = 0; in >> limit && limit > 0) bytes = std::min(bytes, limit);
  }
  // What others use is not there.
  std::ifstream memory("/proc/meminfo");
  for (std::string word; memory >> word;)
    if (double available = 0; word == "MemAvailable:" && memory >> available && available > 0)
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

}  // namespace actio::scene
