// Ranks that are threads of one process, for tests and for who has no MPI.
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>

#include "actio/parallel/ranks.hpp"

namespace actio {

/// A rank that others wait for and that has ended.
struct RankLost : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Calls `work` for so many ranks at once, each on a thread of its own, and returns when all are done.
/// @throws what `work` has thrown on the first rank that did; the others are then told so (\ref RankLost)
///   where they wait for it
void on_thread_ranks(int count, std::function<void(Ranks&)> const& work);

}  // namespace actio
