#include "actio/scene/systems/vorticity_memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

namespace actio::scene {

double bytes_for_vorticity(int n, std::size_t substeps, sphere::Conserved conserved, bool to_rounding,
                           std::vector<std::string> const& quantities) {
  bool const poisson = conserved == sphere::Conserved::lie_poisson;
  // The state and a copy for a row between steps, the Laplacian, the start, and what a step has on the way.
  double count = 4 + 2 + 2 + 10;
  // Each substep: products, unknowns and what they are made of, directions, and steps to guess from, five, or
  // eight halves of two matrices; matrices of single precision count for half.
  bool const all = conserved == sphere::Conserved::all_invariants;
  double const before = to_rounding ? 5 * (poisson ? 2 : 4) : (poisson ? 8 : 5) * 2;
  double const plain = 5 + 14 + (all ? 6 : 0);
  count += static_cast<double>(substeps) * ((to_rounding ? plain : 18 + 5 + 16) + before);
  // A step that cannot be found in single precision is made by another one.
  if (!to_rounding) count += plain + 2;
  // A checkpoint holds half of each skew matrix, and is there twice while it is written.
  count += 2 * (1 + static_cast<double>(substeps) * (to_rounding ? before / 2 : before));
  // One quantity is evaluated after the other.
  double most = 2;
  for (auto const& [name, matrices] : {std::pair("casimirs", 14),
                                       {"eigenvalues", 6},
                                       {"extrema", 6},
                                       {"histogram", 6},
                                       {"spectrum", 4},
                                       {"splitting", 24}})
    if (std::find(quantities.begin(), quantities.end(), name) != quantities.end())
      most = std::max<double>(most, matrices);
  count += most;
  return count * sizeof(double) * n * n;
}

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
