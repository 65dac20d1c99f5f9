// The name that a mistyped one is nearest to, as scenes and the command know it.
#pragma once

#include "actio/numbers/nearest_name.hpp"

namespace actio::scene {

using actio::did_you_mean, actio::listed, actio::nearest_name;

}  // namespace actio::scene
