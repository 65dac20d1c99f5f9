// The headers that nearly every check and test needs and that take seconds to read: read once, and stored
// compiled. The order is that of actio/numbers/scalar.hpp.
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/gmp.hpp>

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
