// Extrapolation of a sequence by one term: polynomials through its last terms, or nearest to them in least
// squares.
#pragma once

#include <array>
#include <cmath>
#include <vector>

namespace actio::bodies::detail {

/// Weights \f$w_a\f$ of \f$x_{k+1}\approx\sum_{a<m}w_ax_{k-a}\f$: the value of the polynomial of degree p-1
/// that is nearest to the last m terms, in the sense of least squares.
///
/// With m = p it goes through them, and independent errors of the terms come back multiplied by about
/// \f$2^p\f$. Two terms more divide that by 4 or 5, and let 3.5 times as much of the next power pass; four
/// terms more divide by 13 and let pass 11 times as much.
struct Weights {
  static constexpr int longest = 16;
  int degree = 0;  ///< p
  int length = 0;  ///< m
  std::array<double, longest> weight{};
  double amplification = 0;  ///< the length of the vector of weights
};

/// All that are worth trying, the shortest first: p up to 12, from p, p+2 and p+4 terms.
std::vector<Weights> const& all_extrapolations();

}  // namespace actio::bodies::detail
