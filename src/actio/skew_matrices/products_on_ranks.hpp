// Products of matrices by all ranks of a run, commanded by rank 0.
//
// Rank 0 has the matrices. For each product it deals both factors out, all ranks multiply, and it collects
// the result: 3 N^2 numbers on their way, for 2 N^3 operations. Bits depend on the number of ranks, since the
// sums do.
#pragma once

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "actio/parallel/ranks.hpp"
#include "actio/skew_matrices/dealt_blocks.hpp"
#include "actio/skew_matrices/products.hpp"

namespace actio::sphere {

/// A rectangle of a matrix: where it begins, counted from 0. Always the first row and column of a block.
struct DealtCorner {
  int row;     ///< the first
  int column;  ///< the first
};

/// c = a b, for rectangles of square matrices that are dealt out in the same way: m times k, k times n, and m
/// times n numbers. Called by all ranks.
/// @param a, b, c  what this rank has of the matrices
template <class Real>
using DealtGemm = void(DealtBlocks const& blocks, int m, int n, int k, Real const* a, DealtCorner of_a,
                       Real const* b, DealtCorner of_b, Real* c, DealtCorner of_c);

/// What multiplies dealt matrices: pdgemm and psgemm of ScaLAPACK.
struct DealtFunctions {
  DealtGemm<double>* in_double = nullptr;  ///< in double precision
  DealtGemm<float>* in_single = nullptr;   ///< in single precision
};

/// One product, as rank 0 tells it to the others.
struct DealtCall {
  int size;     ///< N
  bool single;  ///< the precision
  bool lower;   ///< whether only what is on and below the diagonal is wanted
  int left;     ///< how far the first factor reaches (Reach)
  int right;    ///< the second
};

/// What a rank does for a product; with room that stays.
class DealtProduct {
 public:
  /// @param ranks  all of them multiply
  DealtProduct(Ranks& ranks, DealtFunctions functions) : ranks_(ranks), functions_(functions) {}

  /// The product that rank 0 makes. On a rank other than the first.
  void help() {
    DealtCall call{};
    tell(call);
    if (call.single)
      multiply<float>(call, nullptr, nullptr, nullptr);
    else
      multiply<double>(call, nullptr, nullptr, nullptr);
  }
  /// out = a b, on rank 0.
  template <class Part>
  void make(DealtCall call, Part const& a, Part const& b, Part& out) {
    tell(call);
    multiply(call, a.data(), b.data(), out.data());
  }

 private:
  template <class Real>
  struct Room {
    std::vector<Real> a, b, c;  ///< what this rank has of them
    std::vector<Real> sent;     ///< on the way: what another rank has, or on rank 0 what all others have
  };
  template <class Real>
  Room<Real>& room() {
    if constexpr (std::is_same_v<Real, double>)
      return double_;
    else
      return single_;
  }
  template <class Real>
  DealtGemm<Real>* gemm() const {
    if constexpr (std::is_same_v<Real, double>)
      return functions_.in_double;
    else
      return functions_.in_single;
  }

  void tell(DealtCall& call) { ranks_.broadcast(std::as_writable_bytes(std::span(&call, 1))); }

  /// @param a, b, out  on rank 0; elsewhere null
  template <class Real>
  void multiply(DealtCall const& call, Real const* a, Real const* b, Real* out) {
    auto const blocks = DealtBlocks::of(call.size, ranks_.size());
    Room<Real>& room = this->room<Real>();
    deal(blocks, {{{call.left, call.left}, {call.right, call.right}}}, {a, b}, room);
    room.c.assign(room.a.size(), 0);
    multiply_panels(call, blocks, room);
    int const reach = call.left + call.right;
    collect(blocks, {call.lower ? 0 : reach, reach}, room.c, room.sent, out);
  }
  /// Both factors, from rank 0 to all.
  template <class Real>
  void deal(DealtBlocks const& blocks, std::array<DealtBand, 2> bands, std::array<Real const*, 2> factors,
            Room<Real>& room) {
    std::array<std::vector<Real>*, 2> const mine{&room.a, &room.b};
    for (std::size_t k = 0; k < 2; ++k) {
      mine[k]->resize(blocks.numbers_of(ranks_.rank()));
      if (bands[k].below < blocks.size) std::fill(mine[k]->begin(), mine[k]->end(), Real(0));
    }
    room.sent.resize(count_sent(blocks, bands[0]) + count_sent(blocks, bands[1]));
    Real* on_the_way = room.sent.data();
    auto const each = [&](int rank, auto const& use) {
      for (std::size_t k = 0; k < 2; ++k)
        blocks.visit(rank, bands[k], [&](int i, int j, int count, std::size_t at) {
          use(k, place(blocks, i, j), static_cast<std::size_t>(count), at);
        });
    };
    if (ranks_.rank() > 0) {
      ranks_.scatter({}, bytes_of(room.sent));
      return each(ranks_.rank(), [&](std::size_t k, std::size_t, std::size_t count, std::size_t at) {
        std::copy_n(on_the_way, count, mine[k]->data() + at), on_the_way += count;
      });
    }
    each(0, [&](std::size_t k, std::size_t from, std::size_t count, std::size_t at) {
      std::copy_n(factors[k] + from, count, mine[k]->data() + at);
    });
    for (int rank = 1; rank < ranks_.size(); ++rank)
      each(rank, [&](std::size_t k, std::size_t from, std::size_t count, std::size_t) {
        on_the_way = std::copy_n(factors[k] + from, count, on_the_way);
      });
    ranks_.scatter(bytes_of(std::as_const(room.sent)), {});
  }
  /// From all to rank 0.
  template <class Real>
  void collect(DealtBlocks const& blocks, DealtBand band, std::vector<Real> const& mine,
               std::vector<Real>& sent, Real* matrix) {
    sent.resize(count_sent(blocks, band));
    Real* on_the_way = sent.data();
    if (!matrix) {
      blocks.visit(ranks_.rank(), band, [&](int, int, int count, std::size_t at) {
        on_the_way = std::copy_n(mine.data() + at, count, on_the_way);
      });
      return ranks_.gather(bytes_of(std::as_const(sent)), {});
    }
    ranks_.gather({}, bytes_of(sent));
    if (band.below < blocks.size) std::fill_n(matrix, place(blocks, 0, blocks.size), Real(0));
    for (int rank = 0; rank < ranks_.size(); ++rank)
      blocks.visit(rank, band, [&](int i, int j, int count, std::size_t at) {
        Real const* const from = rank == 0 ? mine.data() + at : std::exchange(on_the_way, on_the_way + count);
        std::copy_n(from, count, matrix + place(blocks, i, j));
      });
  }
  /// Numbers of a band that this rank sends or receives.
  std::size_t count_sent(DealtBlocks const& blocks, DealtBand band) const {
    std::size_t out = 0;
    auto const add = [&out](int, int, int count, std::size_t) { out += static_cast<std::size_t>(count); };
    if (ranks_.rank() > 0)
      blocks.visit(ranks_.rank(), band, add);
    else
      for (int rank = 1; rank < ranks_.size(); ++rank) blocks.visit(rank, band, add);
    return out;
  }
  /// Where an entry of the matrix is.
  static std::size_t place(DealtBlocks const& blocks, int i, int j) {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(blocks.size) + static_cast<std::size_t>(i);
  }

  /// What is not known to be zero, or not wanted: by panels of columns where that is not all, from the first
  /// row of a block on.
  template <class Real>
  void multiply_panels(DealtCall const& call, DealtBlocks const& blocks, Room<Real>& room) {
    int const n = call.size, round = blocks.block * blocks.columns;
    bool const whole =
        n < smallest_in_panels || (!call.lower && std::min(call.left + call.right, n) >= n / 2);
    int const width = whole ? n : ((n + 7) / 8 + round - 1) / round * round;
    auto const within = [&](int k) { return std::clamp(k, 0, n); };
    auto const from_block = [&](int k) { return within(k) / blocks.block * blocks.block; };
    for (int first = 0; first < n; first += width) {
      int const columns = std::min(width, n - first);
      int const inner = from_block(first - call.right), inner_end = within(first + columns + call.right);
      int const begin = std::max(call.lower ? first : 0, from_block(inner - call.left)),
                end = within(inner_end + call.left);
      gemm<Real>()(blocks, end - begin, columns, inner_end - inner, room.a.data(), {begin, inner},
                   room.b.data(), {inner, first}, room.c.data(), {begin, first});
    }
  }

  /// Smaller ones take longer to begin than to multiply.
  static constexpr int smallest_in_panels = 256;
  Ranks& ranks_;
  DealtFunctions functions_;
  Room<double> double_;
  Room<float> single_;
};

/// Products of real matrices by all ranks, on rank 0, used by one caller at a time.
///
/// The others call `DealtProduct::help` each time that they are woken.
class ProductsOnRanks : public ProductsBy<ProductsOnRanks> {
 public:
  /// @param wake  tells the others that a product follows
  ProductsOnRanks(Ranks& ranks, DealtFunctions functions, std::function<void()> wake)
      : product_(ranks, functions), wake_(std::move(wake)) {}

  /// out = a b.
  template <class Part>
  void whole(Part const& a, Part const& b, Part& out, Reach reach = {}) const {
    make(a, b, out, reach, false);
  }
  /// What is on and below the diagonal of out = a b, and some of what is above.
  template <class Part>
  void lower(Part const& a, Part const& b, Part& out, Reach reach = {}) const {
    make(a, b, out, reach, true);
  }

 private:
  template <class Part>
  void make(Part const& a, Part const& b, Part& out, Reach reach, bool lower) const {
    wake_();
    product_.make({static_cast<int>(a.rows()), sizeof(typename Part::Scalar) == sizeof(float), lower,
                   static_cast<int>(reach.left), static_cast<int>(reach.right)},
                  a, b, out);
  }
  mutable DealtProduct product_;
  std::function<void()> wake_;
};

}  // namespace actio::sphere
