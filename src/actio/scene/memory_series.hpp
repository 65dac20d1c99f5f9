// A table in memory: for a caller that uses the numbers in the same process.
#pragma once

#include "actio/scene/series.hpp"

namespace actio::scene {

/// Rows are added at the end of `table`, one after the other, which outlives the series.
std::unique_ptr<Series> memory_series(std::vector<double>& table);

}  // namespace actio::scene
