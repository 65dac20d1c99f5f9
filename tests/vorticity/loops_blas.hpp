// A BLAS as its definition reads, three loops: to count what is asked of one, and to see that it can be
// exchanged.
#pragma once

#include "actio/skew_matrices/blas_products.hpp"

namespace actio::testing {

/// Multiplications of real numbers that `loops` have made.
inline double multiplications = 0;

template <class Real>
void loops(char const*, char const*, int const* m, int const* n, int const* k, Real const* alpha,
           Real const* a, int const* lda, Real const* b, int const* ldb, Real const*, Real* c,
           int const* ldc) {
  for (int j = 0; j < *n; ++j) {
    Real* const column = c + j * *ldc;
    for (int i = 0; i < *m; ++i) column[i] = 0;
    for (int l = 0; l < *k; ++l) {
      Real const factor = *alpha * b[l + j * *ldb];
      for (int i = 0; i < *m; ++i) column[i] += a[i + l * *lda] * factor;
    }
  }
}
inline sphere::BlasFunctions const by_loops{&loops<double>, &loops<float>};

/// The same, and counts. For one thread.
template <class Real>
void counting_loops(char const* ta, char const* tb, int const* m, int const* n, int const* k,
                    Real const* alpha, Real const* a, int const* lda, Real const* b, int const* ldb,
                    Real const* beta, Real* c, int const* ldc) {
  multiplications += static_cast<double>(*m) * *n * *k;
  loops(ta, tb, m, n, k, alpha, a, lda, b, ldb, beta, c, ldc);
}
inline sphere::BlasFunctions const by_counting_loops{&counting_loops<double>, &counting_loops<float>};

}  // namespace actio::testing
