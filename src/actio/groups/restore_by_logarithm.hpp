// Back on a group of which the algebra alone is known, by way of the logarithm.
#pragma once

#include "actio/groups/matrix_group.hpp"

namespace actio::primitive {

/// The exponential of the projected logarithm, where that is near the logarithm; elsewhere the matrix as it
/// is, if it takes the algebra to itself.
/// @throws OutsideDomain  where it does not
template <class G, class S>
Matrix<S> restore_by_logarithm(G const& group, Matrix<S> const& a) {
  try {
    Matrix<S> const m = matrix_logarithm(a), nearest = group.hat(group.vee(m));
    if (row_norm(Matrix<S>(nearest - m)) < 0.1) return matrix_exponential(nearest);
  } catch (OutsideDomain const&) {
  }
  // An element, wherever it is, takes the algebra to itself: no more is known of it here.
  Matrix<S> const back = inverse_matrix(a, "restore");
  for (int c = 0; c < group.dimension(); ++c) {
    Matrix<S> const moved = a * group.hat(Vector<S>(Vector<S>::Unit(group.dimension(), c))) * back;
    double const outside = row_norm(Matrix<S>(group.hat(group.vee(moved)) - moved)) / row_norm(moved);
    if (!(outside < 0.1))
      throw OutsideDomain("restore",
                          "a matrix near the group is needed; relative distance of g e g^-1 from the algebra",
                          outside, 0.1);
  }
  return a;
}
/// With its derivative: rates of change are projected on those of elements.
template <class G, class S, int N>
Matrix<Dual<S, N>> restore_by_logarithm(G const& group, Matrix<Dual<S, N>> const& a) {
  int const n = group.matrix_size();
  auto const part = [&](int k) {
    Matrix<S> m(n, n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) m(i, j) = k < 0 ? a(i, j).value : a(i, j).part[k];
    return m;
  };
  Matrix<S> const value = part(-1), back = inverse_matrix(value, "restore"),
                  restored = restore_by_logarithm(group, value);
  Matrix<Dual<S, N>> result = restored.template cast<Dual<S, N>>();
  for (int k = 0; k < N; ++k) {
    Matrix<S> const rate = group.hat(group.vee(Matrix<S>(part(k) * back))) * restored;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) result(i, j).part[k] = rate(i, j);
  }
  return result;
}

}  // namespace actio::primitive
