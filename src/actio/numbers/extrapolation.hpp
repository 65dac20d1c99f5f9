// The next term of a smooth sequence of vectors, by backward differences.
#pragma once

#include <algorithm>
#include <array>

#include "actio/numbers/scalar.hpp"

namespace actio {

/// Extrapolates a sequence of vectors, such as the velocities at equal steps, by the polynomial through the
/// last terms.
///
/// The degree is chosen anew for each term: as high as the differences fall,
/// \f$|\nabla^{d+1}x| < |\nabla^dx|\f$, so that neither rounding nor a sequence that is not smooth is
/// amplified.
template <class Vector>
class Extrapolation {
 public:
  /// Differences that are stored, of as many terms of the sequence.
  static constexpr int most_differences = 12;

  /// Appends a term.
  void push(Vector term) {
    for (int d = 0; d < count_; ++d) {
      Vector const difference = term - difference_[d];
      difference_[d] = term;
      term = difference;
    }
    if (count_ < most_differences) difference_[count_++] = term;
  }
  /// The term that comes next, as far as it can be told: \f$\sum_{d}\nabla^dx\f$. Not before there is a term.
  Vector next() const {
    Vector sum = difference_[0];
    auto size = sum.squaredNorm();
    for (int d = 1; d < count_; ++d) {
      auto const higher = difference_[d].squaredNorm();
      if (!(higher < size)) break;
      sum += difference_[d];
      size = higher;
    }
    return sum;
  }
  /// Whether there is no term yet.
  bool empty() const { return count_ == 0; }
  /// Forgets all terms.
  void clear() { count_ = 0; }

 private:
  std::array<Vector, most_differences> difference_;
  int count_ = 0;
};

}  // namespace actio
