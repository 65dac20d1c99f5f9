// The ranks that share the runs of this process.
#pragma once

#include "actio/parallel/ranks.hpp"

namespace actio::scene {

/// The ranks; null where this process is alone. Set before a scene is read.
inline Ranks*& shared_ranks() {
  static Ranks* ranks = nullptr;
  return ranks;
}
/// Whether runs are shared with other processes.
inline bool on_several_ranks() { return shared_ranks() && shared_ranks()->size() > 1; }

}  // namespace actio::scene
