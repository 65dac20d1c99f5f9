// Products of matrices that are dealt out to ranks, by ScaLAPACK.
#include "actio/skew_matrices/products_on_ranks.hpp"

extern "C" {
/// \cond
void Cblacs_get(int context, int what, int* out);
void Cblacs_gridinit(int* context, char const* order, int rows, int columns);
void Cblacs_pinfo(int* rank, int* ranks);
void pdgemm_(char const*, char const*, int const*, int const*, int const*, double const*, double const*,
             int const*, int const*, int const*, double const*, int const*, int const*, int const*,
             double const*, double*, int const*, int const*, int const*);
void psgemm_(char const*, char const*, int const*, int const*, int const*, float const*, float const*,
             int const*, int const*, int const*, float const*, int const*, int const*, int const*,
             float const*, float*, int const*, int const*, int const*);
/// \endcond

/// How many columns and rows ranks send to each other at a time, where ScaLAPACK asks for it: by itself it
/// takes 32, and a core multiplies such narrow panels at three quarters of its rate.
int pilaenv_(int const*, char const*) { return 128; }
}

namespace {

using namespace actio::sphere;

/// All ranks, row after row: made when first asked for.
int grid_of(DealtBlocks const& blocks) {
  static int const made = [&] {
    int context = 0;
    Cblacs_get(-1, 0, &context);
    Cblacs_gridinit(&context, "Row", blocks.rows, blocks.columns);
    return context;
  }();
  return made;
}

template <class Real>
void multiply(DealtBlocks const& blocks, int m, int n, int k, Real const* a, DealtCorner of_a, Real const* b,
              DealtCorner of_b, Real* c, DealtCorner of_c) {
  int rank = 0, ranks = 0;
  Cblacs_pinfo(&rank, &ranks);
  int const described[] = {1,
                           grid_of(blocks),
                           blocks.size,
                           blocks.size,
                           blocks.block,
                           blocks.block,
                           0,
                           0,
                           std::max(1, blocks.rows_of(rank))};
  Real const one = 1, zero = 0;
  // Counted from 1.
  for (DealtCorner* corner : {&of_a, &of_b, &of_c}) ++corner->row, ++corner->column;
  auto const gemm = [&](auto* function) {
    function("N", "N", &m, &n, &k, &one, a, &of_a.row, &of_a.column, described, b, &of_b.row, &of_b.column,
             described, &zero, c, &of_c.row, &of_c.column, described);
  };
  if constexpr (std::is_same_v<Real, double>)
    gemm(&pdgemm_);
  else
    gemm(&psgemm_);
}

}  // namespace

/// Its functions. MPI has begun, and its ranks are those of the products.
extern "C" void actio_scalapack(DealtFunctions& out) { out = {&multiply<double>, &multiply<float>}; }
