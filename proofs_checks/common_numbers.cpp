// What all checks compute with, compiled at -O2: dual numbers and matrices over Number. The sections are
// compiled at -Og, where a call stays a call; of a function that several files hold the linker takes the
// first, and this file stands first in every program. The checks gain a seventh of their time over the prime
// field, a sixth in double, little in 50 digits.
#include <array>
#include <vector>

#include "actio/numbers/derivative.hpp"
#include "actio/numbers/linear.hpp"
#include "witness/number.hpp"

namespace actio {

using Once = Dual<Number, 1>;
using Batch = Dual<Number, batch>;

#define ACTIO_DUAL_NUMBER(S, N) \
  template struct Dual<S, N>;   \
  template void add_product<S, N>(Dual<S, N>& __restrict, Dual<S, N> const&, Dual<S, N> const&)
ACTIO_DUAL_NUMBER(Number, 1);
ACTIO_DUAL_NUMBER(Number, batch);
ACTIO_DUAL_NUMBER(Once, 1);
ACTIO_DUAL_NUMBER(Batch, batch);

#define ACTIO_MATRIX(S)                            \
  template struct Matrix<S, Dynamic, Dynamic>;     \
  template struct Matrix<S, Dynamic, 1>;           \
  template struct MatrixView<S, Dynamic, Dynamic>; \
  template void detail::eliminate(Matrix<S, Dynamic, Dynamic>&, MatrixView<S, Dynamic, Dynamic>, char const*)
ACTIO_MATRIX(Number);
ACTIO_MATRIX(Once);
ACTIO_MATRIX(Batch);

}  // namespace actio

template struct std::array<actio::Number, 1>;
template struct std::array<actio::Number, actio::batch>;
template struct std::array<actio::Once, 1>;
template struct std::array<actio::Batch, actio::batch>;
template class std::vector<actio::Number>;
template class std::vector<actio::Once>;
template class std::vector<actio::Batch>;
