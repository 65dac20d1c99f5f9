// How far from its diagonal a matrix reaches.
//
// The diagonal m of the matrix of a function holds its part that goes as exp(im phi). Where the function is
// smooth these parts fall faster than any power of m, and far from the diagonal there is nothing but
// rounding: a product of two such matrices takes O(N) operations for each pair of diagonals that they have.
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <limits>

#include "actio/skew_matrices/skew_hermitian.hpp"

namespace actio::sphere {

/// Up to how far from their diagonals the two factors of a product are looked at; by default all of them.
struct Reach {
  static constexpr Eigen::Index everything =
      std::numeric_limits<int>::max() / 4;  ///< more than any matrix has
  Eigen::Index left = everything;           ///< of the left factor
  Eigen::Index right = everything;          ///< of the right factor

  /// That of the product.
  Eigen::Index product() const { return std::min(left + right, everything); }
};

/// The diagonal, counted from the main one, below which all entries are at most this large: of a matrix that
/// is symmetric or skew, by its lower half. O(N^2) operations where it is far less than N, O(N) where it is
/// about N.
template <class Part>
Eigen::Index reach_of(Part const& m, typename Part::Scalar negligible, Eigen::Index at_least = 0) {
  Eigen::Index reach = at_least;
  for (Eigen::Index c = 0; c + reach + 1 < m.rows(); ++c) {
    auto const beyond = m.col(c).tail(m.rows() - c - reach - 1);
    if (beyond.cwiseAbs().maxCoeff() <= negligible) continue;
    Eigen::Index r = m.rows() - 1;
    while (std::abs(m(r, c)) <= negligible) --r;
    reach = r - c;
  }
  return reach;
}
/// The same of both parts.
template <class S>
Eigen::Index reach_of(SkewHermitian<S> const& m, S negligible) {
  return reach_of(m.imaginary, negligible, reach_of(m.real, negligible));
}

/// Matrices smaller than this are multiplied whole: their reach takes longer to find than it saves.
inline constexpr Eigen::Index smallest_with_reach = 96;
/// That of both parts of a matrix, where it is worth knowing.
template <class Part>
Eigen::Index useful_reach(Part const& real, Part const& imaginary, typename Part::Scalar negligible) {
  if (real.rows() < smallest_with_reach) return Reach::everything;
  return reach_of(imaginary, negligible, reach_of(real, negligible));
}

/// That beyond which are no entries that count in single precision.
Eigen::Index reach_in_single(SkewHermitian<float> const& m);

}  // namespace actio::sphere
