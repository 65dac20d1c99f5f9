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
  bool of_all_elements() const;
  /// How many of the matrices have an odd power outside of the span. Powers beyond the number of rows are
  /// sums of the others.
  int that_leave() const;

 private:
  static constexpr std::int64_t prime = 2147483647;
  using Remainders = Matrix<std::int64_t, Dynamic, Dynamic>;

  static Remainders product(Remainders const& a, Remainders const& b);
  bool in_span(Remainders const& a) const;
};

}  // namespace actio
