// Whether Cayley's transform maps an algebra of matrices into its group: whether the algebra is closed under
// odd powers.
//
// Cayley's transform of A is the exponential of A + A^3/12 + ..., a series of odd powers, so it stays in the
// group where all odd powers of A are in the algebra. If the cube of every element of the algebra is in the
// algebra, so are all odd powers, by polarization.
//
// The answer is exact, up to a chance of one in seven hundred million: remainders of whole numbers divided by
// a prime have no rounding.
#pragma once

#include <cstdint>
#include <vector>

#include "actio/numbers/scalar.hpp"

namespace actio {

/// An entry other than zero of one of the matrices that span an algebra, or of its dual basis.
struct SpanEntry {
  int direction;     ///< which of the matrices
  int row;           ///< of the entry
  int column;        ///< of the entry
  long coefficient;  ///< the entry
};

/// Whether the span of some matrices of whole numbers is closed under odd powers.
struct OddPowerClosure {
  using WholeMatrix = Matrix<int, Dynamic, Dynamic>;

  std::vector<WholeMatrix> const& basis;     ///< the matrices
  std::vector<SpanEntry> const& entries;     ///< of the basis
  std::vector<SpanEntry> const& projection;  ///< of the dual basis, times the denominator
  long denominator;                          ///< of the projection

  /// Whether the cube of every element is in the span: tried on one element with random coordinates.
  bool of_all_elements() const {
    std::int64_t coordinate = 20240131;
    Remainders a = Remainders::Zero(basis.front().rows(), basis.front().cols());
    for (WholeMatrix const& e : basis) {
      coordinate = coordinate * 48271 % prime;
      for (Index i = 0; i < a.rows(); ++i)
        for (Index j = 0; j < a.cols(); ++j) a(i, j) = (a(i, j) + coordinate * e(i, j)) % prime;
    }
    return in_span(product(product(a, a), a));
  }
  /// How many of the matrices have an odd power outside of the span. Powers beyond the number of rows are
  /// sums of the others.
  int that_leave() const {
    int leaving = 0;
    for (WholeMatrix const& e : basis) {
      Remainders power = e.cast<std::int64_t>();
      Remainders const square = product(power, power);
      bool stays = true;
      for (Index k = 1; stays && k < e.rows(); ++k) stays = in_span(power = product(power, square));
      leaving += !stays;
    }
    return leaving;
  }

 private:
  static constexpr std::int64_t prime = 2147483647;
  using Remainders = Matrix<std::int64_t, Dynamic, Dynamic>;

  static Remainders product(Remainders const& a, Remainders const& b) {
    Remainders c = Remainders::Zero(a.rows(), b.cols());
    for (Index i = 0; i < a.rows(); ++i)
      for (Index j = 0; j < b.cols(); ++j)
        for (Index k = 0; k < a.cols(); ++k) c(i, j) = (c(i, j) + a(i, k) * b(k, j)) % prime;
    return c;
  }
  bool in_span(Remainders const& a) const {
    std::vector<std::int64_t> v(basis.size(), 0);
    for (SpanEntry const& e : projection)
      v[e.direction] = (v[e.direction] + a(e.row, e.column) * (e.coefficient % prime)) % prime;
    Remainders left = a;
    for (Index i = 0; i < a.rows(); ++i)
      for (Index j = 0; j < a.cols(); ++j) left(i, j) = a(i, j) * (denominator % prime) % prime;
    for (SpanEntry const& e : entries)
      left(e.row, e.column) = (left(e.row, e.column) - v[e.direction] * e.coefficient) % prime;
    for (Index i = 0; i < a.rows(); ++i)
      for (Index j = 0; j < a.cols(); ++j)
        if (left(i, j) != 0) return false;
    return true;
  }
};

}  // namespace actio
