// Extrapolation of a sequence by one term: polynomials through its last terms, or nearest to them in least
// squares.
#pragma once

#include <array>
#include <cmath>
#include <vector>

namespace actio::detail {

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

/// By orthogonal polynomials on the m nodes, each made from the one before and freed of all before it.
inline Weights extrapolation_weights(int p, int m) {
  using Values = std::array<long double, Weights::longest + 1>;  // at the m nodes and, last, at the next one
  std::vector<Values> basis;
  Weights result{p, m, {}, 0};
  for (int degree = 0; degree < p; ++degree) {
    Values v{};
    for (int a = 0; a <= m; ++a) {
      long double const node = a < m ? (m - 1) / 2.0L - a : (m + 1) / 2.0L;
      v[a] = degree ? node * basis.back()[a] : 1;
    }
    for (int twice = 0; twice < 2; ++twice)
      for (Values const& b : basis) {
        long double part = 0;
        for (int a = 0; a < m; ++a) part += v[a] * b[a];
        for (int a = 0; a <= m; ++a) v[a] -= part * b[a];
      }
    long double size = 0;
    for (int a = 0; a < m; ++a) size += v[a] * v[a];
    for (int a = 0; a <= m; ++a) v[a] /= std::sqrt(size);
    basis.push_back(v);
  }
  for (int a = 0; a < m; ++a) {
    long double w = 0;
    for (Values const& b : basis) w += b[a] * b[m];
    result.weight[a] = static_cast<double>(w), result.amplification += result.weight[a] * result.weight[a];
  }
  result.amplification = std::sqrt(result.amplification);
  return result;
}

/// All that are worth trying, the shortest first: p up to 12, from p, p+2 and p+4 terms.
inline std::vector<Weights> const& all_extrapolations() {
  static std::vector<Weights> const all = [] {
    std::vector<Weights> list;
    for (int m = 1; m <= Weights::longest; ++m)
      for (int p : {m, m - 2, m - 4})
        if (p >= 1 && p <= 12) list.push_back(extrapolation_weights(p, m));
    return list;
  }();
  return all;
}

}  // namespace actio::detail
