// What all checks and many tests compute with, declared here and compiled in compiled_numbers.cpp: dual
// numbers and matrices over Number. Read at the end of number.hpp.
#pragma once

#include <array>
#include <vector>

#include "actio/linear_algebra/linear.hpp"
#include "actio/numbers/derivative.hpp"

namespace actio {

using Once = Dual<Number, 1>;
using Batch = Dual<Number, batch>;

}  // namespace actio

// With `extern` for ACTIO_TEMPLATE these are declared, without it they are compiled.
#define ACTIO_DUAL_NUMBER(S, N)     \
  ACTIO_TEMPLATE struct Dual<S, N>; \
  ACTIO_TEMPLATE void add_product<S, N>(Dual<S, N>& __restrict, Dual<S, N> const&, Dual<S, N> const&);
#define ACTIO_MATRIX(S)                                                                                \
  ACTIO_TEMPLATE struct Matrix<S, Dynamic, Dynamic>;                                                   \
  ACTIO_TEMPLATE struct Matrix<S, Dynamic, 1>;                                                         \
  ACTIO_TEMPLATE struct MatrixView<S, Dynamic, Dynamic>;                                               \
  ACTIO_TEMPLATE void detail::eliminate(Matrix<S, Dynamic, Dynamic>&, MatrixView<S, Dynamic, Dynamic>, \
                                        char const*);
#define ACTIO_COMPILED_NUMBERS                                   \
  namespace actio {                                              \
  ACTIO_DUAL_NUMBER(Number, 1)                                   \
  ACTIO_DUAL_NUMBER(Number, batch)                               \
  ACTIO_DUAL_NUMBER(Once, 1)                                     \
  ACTIO_DUAL_NUMBER(Batch, batch)                                \
  ACTIO_MATRIX(Number)                                           \
  ACTIO_MATRIX(Once)                                             \
  ACTIO_MATRIX(Batch)                                            \
  }                                                              \
  ACTIO_TEMPLATE struct std::array<actio::Number, 1>;            \
  ACTIO_TEMPLATE struct std::array<actio::Number, actio::batch>; \
  ACTIO_TEMPLATE struct std::array<actio::Once, 1>;              \
  ACTIO_TEMPLATE struct std::array<actio::Batch, actio::batch>;  \
  ACTIO_TEMPLATE class std::vector<actio::Number>;               \
  ACTIO_TEMPLATE class std::vector<actio::Once>;                 \
  ACTIO_TEMPLATE class std::vector<actio::Batch>;

#define ACTIO_TEMPLATE extern template
ACTIO_COMPILED_NUMBERS
#undef ACTIO_TEMPLATE
