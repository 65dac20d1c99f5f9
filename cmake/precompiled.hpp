// The headers that nearly every check and test needs and that take seconds to read: read once, and stored
// compiled.
#include <Eigen/Core>

#include <array>
#include <cmath>
#include <concepts>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "actio/linear_algebra/compiled_doubles.hpp"
