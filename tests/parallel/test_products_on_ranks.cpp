// Products of matrices that are dealt out to ranks: those of Eigen, for any number of ranks.
#include <Eigen/Core>

#include <atomic>
#include <boost/test/unit_test.hpp>
#include <random>

#include "actio/parallel/thread_ranks.hpp"
#include "actio/skew_matrices/products_on_ranks.hpp"

using namespace actio;
using namespace actio::sphere;

namespace {

constexpr DealtBand everything{1 << 20, 1 << 20};
thread_local Ranks* here = nullptr;
std::atomic<bool> from_blocks = true;  ///< whether all rectangles began with a block

/// What all ranks have, put together on each of them.
template <class Real>
Eigen::MatrixX<Real> whole(DealtBlocks const& blocks, Real const* mine) {
  auto const n = static_cast<std::size_t>(blocks.size);
  std::vector<Real> const own(mine, mine + blocks.numbers_of(here->rank()));
  std::vector<Real> all(here->rank() == 0 ? n * n : 0);
  here->gather(bytes_of(own), bytes_of(all));
  all.resize(n * n);
  here->broadcast(bytes_of(all));
  Eigen::MatrixX<Real> out(blocks.size, blocks.size);
  std::size_t at = 0;
  for (int rank = 0; rank < here->size(); ++rank)
    blocks.visit(rank, everything, [&](int i, int j, int count, std::size_t) {
      for (int k = 0; k < count; ++k) out(i + k, j) = all[at++];
    });
  return out;
}

/// In the place of ScaLAPACK: each rank makes the product of all, and takes its own part of it.
template <class Real>
void multiply(DealtBlocks const& blocks, int m, int n, int k, Real const* a, DealtCorner of_a, Real const* b,
              DealtCorner of_b, Real* c, DealtCorner of_c) {
  for (DealtCorner const corner : {of_a, of_b, of_c})
    if (corner.row % blocks.block != 0 || corner.column % blocks.block != 0) from_blocks = false;
  Eigen::MatrixX<Real> out = whole(blocks, c);
  out.block(of_c.row, of_c.column, m, n) = whole(blocks, a).block(of_a.row, of_a.column, m, k) *
                                           whole(blocks, b).block(of_b.row, of_b.column, k, n);
  blocks.visit(here->rank(), everything, [&](int i, int j, int count, std::size_t at) {
    for (int l = 0; l < count; ++l) c[at + static_cast<std::size_t>(l)] = out(i + l, j);
  });
}

/// Factors that reach so far, their product by all ranks, and where it should be that of Eigen.
template <class Real>
void check(int n, int ranks, bool lower, Reach reach) {
  std::mt19937 draw(static_cast<unsigned>(n + ranks));
  std::uniform_real_distribution<Real> entry(-1, 1);
  auto const factor = [&](Eigen::Index reach) {
    return Eigen::MatrixX<Real>(Eigen::MatrixX<Real>::NullaryExpr(
        n, n, [&](auto i, auto j) { return std::abs(i - j) <= reach ? entry(draw) : 0; }));
  };
  Eigen::MatrixX<Real> const a = factor(reach.left), b = factor(reach.right);
  Eigen::MatrixX<Real> out(n, n);
  on_thread_ranks(ranks, [&](Ranks& rank) {
    here = &rank;
    DealtFunctions const functions{&multiply<double>, &multiply<float>};
    if (rank.rank() > 0) return DealtProduct(rank, functions).help();
    ProductsOnRanks const products(rank, functions, [] {});
    lower ? products.multiply_lower(a, b, out, reach) : products.multiply(a, b, out, reach);
  });
  Eigen::MatrixX<Real> difference = out - a * b;
  if (lower) difference.template triangularView<Eigen::StrictlyUpper>().setZero();
  // n terms of modulus at most 1, each rounded as often as there are sums.
  Real const bound = static_cast<Real>(n) * static_cast<Real>(n) * std::numeric_limits<Real>::epsilon();
  BOOST_TEST(difference.cwiseAbs().maxCoeff() <= bound,
             n << " on " << ranks << ": " << difference.cwiseAbs().maxCoeff() << " > " << bound);
}

}  // namespace

BOOST_AUTO_TEST_CASE(matrices_are_dealt_out_whole) {
  for (int const n : {1, 5, 64, 100, 257})
    for (int const ranks : {1, 2, 3, 4, 6, 7, 12}) {
      auto const blocks = DealtBlocks::of(n, ranks);
      BOOST_TEST(blocks.rows * blocks.columns == ranks);
      Eigen::MatrixXi times = Eigen::MatrixXi::Zero(n, n);
      for (int rank = 0; rank < ranks; ++rank) {
        std::size_t numbers = 0;
        blocks.visit(rank, everything, [&](int i, int j, int count, std::size_t at) {
          BOOST_TEST(at == numbers);
          times.col(j).segment(i, count).array() += 1, numbers += static_cast<std::size_t>(count);
        });
        BOOST_TEST(numbers == blocks.numbers_of(rank));
      }
      BOOST_TEST((times.array() == 1).all());
      // A band, in whole blocks.
      DealtBand const band{3, 20};
      Eigen::MatrixXi in_band = Eigen::MatrixXi::Zero(n, n);
      for (int rank = 0; rank < ranks; ++rank)
        blocks.visit(rank, band, [&](int i, int j, int count, std::size_t) {
          in_band.col(j).segment(i, count).array() += 1;
        });
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
          if (j - i <= band.above && i - j <= band.below) BOOST_TEST(in_band(i, j) == 1);
          if (j - i >= band.above + 2 * blocks.block || i - j >= band.below + 2 * blocks.block)
            BOOST_TEST(in_band(i, j) == 0);
        }
    }
}

BOOST_AUTO_TEST_CASE(ranks_multiply_as_one) {
  for (int const ranks : {1, 2, 6})
    for (int const n : {3, 64, 264})
      for (bool const lower : {false, true})
        for (Reach const reach : {Reach{}, Reach{9, 17}, Reach{0, 40}}) {
          check<double>(n, ranks, lower, reach);
          check<float>(n, ranks, lower, reach);
        }
  BOOST_TEST(from_blocks);
}
