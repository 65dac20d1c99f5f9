#include "actio/fast_body/any_dimension/least_squares_extrapolation.hpp"

namespace actio::bodies {
namespace detail {
namespace {

/// By orthogonal polynomials on the m nodes, each made from the one before and freed of all before it.
Weights extrapolation_weights(int p, int m) {
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

}  // namespace

std::vector<Weights> const& all_extrapolations() {
  static std::vector<Weights> const all = [] {
    std::vector<Weights> list;
    for (int m = 1; m <= Weights::longest; ++m)
      for (int p : {m, m - 2, m - 4})
        if (p >= 1 && p <= 12) list.push_back(extrapolation_weights(p, m));
    return list;
  }();
  return all;
}

}  // namespace detail

}  // namespace actio::bodies
