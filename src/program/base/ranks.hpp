// The ranks that share the runs of this process.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <thread>

#include "actio/parallel/ranks.hpp"

namespace actio::scene {

/// The ranks; null where this process is alone. Set before a scene is read.
inline Ranks*& shared_ranks() {
  static Ranks* ranks = nullptr;
  return ranks;
}
/// Whether runs are shared with other processes.
inline bool on_several_ranks() { return shared_ranks() && shared_ranks()->size() > 1; }

/// How many cores this process has for itself: the part of a rank where several share them.
inline int& cores_of_this_rank() {
  static int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return cores;
}
/// How many threads a large computation takes: one for each of these cores, unless the environment variable
/// ACTIO_THREADS says another number.
inline int threads_of_this_rank() {
  if (char const* const said = std::getenv("ACTIO_THREADS"))
    if (int const number = std::atoi(said); number > 0) return std::min(number, 64);
  return cores_of_this_rank();
}

}  // namespace actio::scene
