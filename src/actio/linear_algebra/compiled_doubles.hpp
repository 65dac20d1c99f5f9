// Systems of linear equations in double of the sizes that most programs have, compiled once: for units of
// programs that link the core.
#pragma once

#include "actio/linear_algebra/linear.hpp"
#include "actio/numbers/dual.hpp"

namespace actio::detail {

using ThreeSlopes = Dual<double, 3>;

/// @cond
// With `extern` for ACTIO_TEMPLATE these are declared, without it they are compiled.
#define ACTIO_COMPILED_ELIMINATION(S, size, columns) \
  ACTIO_TEMPLATE void eliminate(Matrix<S, size, size>&, MatrixView<S, size, columns>, char const*);
#define ACTIO_COMPILED_DOUBLES                               \
  ACTIO_COMPILED_ELIMINATION(double, 2, 1)                   \
  ACTIO_COMPILED_ELIMINATION(double, 2, 2)                   \
  ACTIO_COMPILED_ELIMINATION(double, 3, 1)                   \
  ACTIO_COMPILED_ELIMINATION(double, 3, 3)                   \
  ACTIO_COMPILED_ELIMINATION(double, Dynamic, 1)             \
  ACTIO_COMPILED_ELIMINATION(double, Dynamic, Dynamic)       \
  ACTIO_COMPILED_ELIMINATION(Dual<double>, Dynamic, Dynamic) \
  ACTIO_COMPILED_ELIMINATION(ThreeSlopes, Dynamic, Dynamic)

#define ACTIO_TEMPLATE extern template
ACTIO_COMPILED_DOUBLES
#undef ACTIO_TEMPLATE
/// @endcond

}  // namespace actio::detail
