// How a medium of the optimised implementation is computed.
#pragma once

#include "actio/parallel/ranks.hpp"
#include "actio/stored_energy/fast_lanes.hpp"

namespace actio::media {

/// How a medium of the optimised implementation is computed. Nothing of this changes any bit of the result
/// but the registers.
struct FastOptions {
  int threads = 1;                         ///< how many work; rows or planes are shared among them
  int levels = 0;                          ///< in the plane: steps in one pass; 0: as the cache allows
  Registers registers = best_registers();  ///< for which the steps are compiled
  Ranks* ranks = nullptr;  ///< processes among which rows or planes are shared; null: this one
  std::string told = {};                   ///< of the medium, to the other ranks (\ref share_parts)
};

}  // namespace actio::media
