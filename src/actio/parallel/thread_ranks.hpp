// Ranks that are threads of one process, for tests and for who has no MPI.
#pragma once

#include <functional>
#include <memory>

#include "actio/parallel/ranks.hpp"

namespace actio {

/// Calls `work` for so many ranks at once, each on a thread of its own, and returns when all are done.
/// @throws what `work` has thrown on the first rank that did; it must throw on all of them, or on none
void on_thread_ranks(int count, std::function<void(Ranks&)> const& work);

}  // namespace actio
