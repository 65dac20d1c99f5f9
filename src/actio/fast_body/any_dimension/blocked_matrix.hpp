// Matrices as arrays of blocks of four by four numbers, and their columns as four doubles side by side.
//
// A function that works on lanes is written once, always inlined, and compiled twice, plain and for AVX2
// (machine.hpp). Here lanes are read where matrices have them, in memory, and never cross a function boundary
// by value.
#pragma once

#include <cstddef>
#include <cstring>
#include <memory>
#include <new>
#include <utility>

#include "actio/fast_body/machine.hpp"

namespace actio::bodies::detail {

/// Four doubles; the compiler's operators work lane by lane, and with one double on all lanes.
typedef double FourLanes __attribute__((vector_size(32), may_alias));

/// The four doubles at p, which must lie on a multiple of 32 bytes.
[[gnu::always_inline]] inline FourLanes const& lanes(double const* p) {
  return *reinterpret_cast<FourLanes const*>(p);
}
[[gnu::always_inline]] inline FourLanes& lanes(double* p) { return *reinterpret_cast<FourLanes*>(p); }

/// Exchanges rows and columns of four by four numbers.
[[gnu::always_inline]] inline void transpose(FourLanes (&u)[4]) {
  FourLanes const a = __builtin_shufflevector(u[0], u[1], 0, 4, 2, 6),
                  b = __builtin_shufflevector(u[0], u[1], 1, 5, 3, 7);
  FourLanes const c = __builtin_shufflevector(u[2], u[3], 0, 4, 2, 6),
                  d = __builtin_shufflevector(u[2], u[3], 1, 5, 3, 7);
  u[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5), u[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
  u[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7), u[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}

/// The sum of the four.
[[gnu::always_inline]] inline double sum(FourLanes const& u) { return (u[0] + u[1]) + (u[2] + u[3]); }

/// An n by n matrix in blocks of four by four, each stored column by column; rows and columns beyond n are
/// zero.
///
/// A full matrix has its blocks row by row of blocks, so that four rows lie together, as products read them.
/// Of one that is symmetric or skew only the blocks on and below the diagonal are stored, column by column of
/// blocks, as sweeps pass over them; those on the diagonal are whole.
/// @tparam blocks_known  in a row; 0 where that is known only when the program runs
template <int blocks_known>
struct Blocked {
  int n;
  explicit Blocked(int size) : n(size) {}
  static constexpr int blocks() { return blocks_known; }
};
template <>
struct Blocked<0> {
  int n;
  explicit Blocked(int size) : n(size) {}
  int blocks() const { return (n + 3) / 4; }
};

/// How many numbers a full matrix has, and one of which half is stored.
inline std::size_t full_size(Blocked<0> const& shape) {
  return 16 * static_cast<std::size_t>(shape.blocks()) * static_cast<std::size_t>(shape.blocks());
}
inline std::size_t half_size(Blocked<0> const& shape) {
  return 8 * static_cast<std::size_t>(shape.blocks()) * static_cast<std::size_t>(shape.blocks() + 1);
}
/// Where block (i, j) of a full matrix begins.
template <int B>
[[gnu::always_inline]] inline std::ptrdiff_t full_block(Blocked<B> const& shape, int i, int j) {
  return 16 * (static_cast<std::ptrdiff_t>(i) * shape.blocks() + j);
}
/// Where block (i, j), i >= j, of a matrix of which half is stored.
template <int B>
[[gnu::always_inline]] inline std::ptrdiff_t half_block(Blocked<B> const& shape, int i, int j) {
  return 16 * (static_cast<std::ptrdiff_t>(j) * shape.blocks() - j * (j + 1) / 2 + i);
}
/// Where entry (i, j) of a full matrix is, and that of a half on or below the diagonal or in a block on it.
inline std::ptrdiff_t full_entry(Blocked<0> const& shape, int i, int j) {
  return full_block(shape, i / 4, j / 4) + j % 4 * 4 + i % 4;
}
inline std::ptrdiff_t half_entry(Blocked<0> const& shape, int i, int j) {
  return half_block(shape, i / 4, j / 4) + j % 4 * 4 + i % 4;
}

/// Zeros on a multiple of 64 bytes.
class Zeros {
 public:
  explicit Zeros(std::size_t count) : count_(count), data_(allocate(count)) {}
  Zeros(Zeros const& other) : Zeros(other.count_) {
    std::memcpy(data(), other.data(), count_ * sizeof(double));
  }
  Zeros(Zeros&&) noexcept = default;
  Zeros& operator=(Zeros other) noexcept {
    std::swap(count_, other.count_), std::swap(data_, other.data_);
    return *this;
  }
  double* data() { return data_.get(); }
  double const* data() const { return data_.get(); }

 private:
  struct Release {
    void operator()(double* p) const { ::operator delete[](p, std::align_val_t(64)); }
  };
  static std::unique_ptr<double[], Release> allocate(std::size_t count) {
    auto* const p = static_cast<double*>(::operator new[](count * sizeof(double), std::align_val_t(64)));
    std::memset(p, 0, count * sizeof(double));
    return std::unique_ptr<double[], Release>(p);
  }
  std::size_t count_;
  std::unique_ptr<double[], Release> data_;
};

}  // namespace actio::bodies::detail
