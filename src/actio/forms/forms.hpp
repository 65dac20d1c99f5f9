// Differential forms as callables on tangent vectors.
//
// A k-form on a space with D coordinates is a callable: omega(at, V) takes a point (a column of D numbers)
// and k tangent vectors, the columns of V, and returns a number. It is alternating and linear in the columns,
// and written once for every scalar, so that pull-back and exterior derivative are exact.
#pragma once

#include "actio/linear_algebra/linear.hpp"

namespace actio {

/// k tangent vectors at a point with D coordinates, as columns.
template <class S, int D, int k>
using Tangents = Matrix<S, D, k>;

/// The determinant of a small square matrix whose size the compiler knows, along its first column: without a
/// division, over any ring.
template <class S, int k>
  requires(k >= 0)
S determinant(Matrix<S, k, k> const& m) {
  if constexpr (k == 0) {
    return S(1);
  } else if constexpr (k == 1) {
    return m(0, 0);
  } else if constexpr (k == 2) {
    return m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
  } else {
    // Along the first column.
    S sum(0);
    for (int i = 0; i < k; ++i) {
      if (m(i, 0) == S(0)) continue;
      Matrix<S, k - 1, k - 1> minor;
      for (int r = 0, to = 0; r < k; ++r) {
        if (r == i) continue;
        for (int c = 1; c < k; ++c) minor(to, c - 1) = m(r, c);
        ++to;
      }
      S const term = m(i, 0) * determinant(minor);
      if (i % 2 == 0)
        sum += term;
      else
        sum -= term;
    }
    return sum;
  }
}

/// The contraction \f$W\lrcorner\,\omega = \omega(W, \cdot,\dots)\f$ with a vector field: the field goes into
/// the first slot.
/// @param W  vector field: a callable from points to tangent vectors
template <class Field, class Form>
auto contract(Field const& W, Form const& omega) {
  return [W, omega]<class S, int D, int k>(Matrix<S, D, 1> const& at, Tangents<S, D, k> const& V) -> S {
    Tangents<S, D, k + 1> all;
    all.col(0) = W(at);
    if constexpr (k > 0) all.template rightCols<k>() = V;
    return omega(at, all);
  };
}

/// The tangent map of f at a point, applied to each column of V.
template <class S, int D, int k, class Map>
auto pushed(Map const& f, Matrix<S, D, 1> const& at, Tangents<S, D, k> const& V) {
  using T = Dual<S, k>;
  Matrix<T, D, 1> moved = at.template cast<T>();
  for (int i = 0; i < D; ++i)
    for (int c = 0; c < k; ++c) moved[i].part[c] = V(i, c);
  auto const image = f(moved);
  constexpr int to = std::remove_cvref_t<decltype(image)>::RowsAtCompileTime;
  Tangents<S, to, k> out;
  for (int i = 0; i < to; ++i)
    for (int c = 0; c < k; ++c) out(i, c) = image[i].part[c];
  return out;
}

/// The pull-back \f$f^*\omega\f$: \f$(f^*\omega)_x(V_1,\dots) = \omega_{f(x)}(Tf\,V_1,\dots)\f$.
/// @param f  a callable between coordinates, over any scalar
template <class Map, class Form>
auto pull_back(Map const& f, Form const& omega) {
  return [f, omega]<class S, int D, int k>(Matrix<S, D, 1> const& at, Tangents<S, D, k> const& V) -> S {
    if constexpr (k == 0) {
      auto const image = f(at);
      return omega(image.eval(), Tangents<S, std::remove_cvref_t<decltype(image)>::RowsAtCompileTime, 0>());
    } else {
      return omega(f(at).eval(), pushed(f, at, V));
    }
  };
}

/// The exterior derivative: \f$(d\omega)(V_0,\dots,V_k) = \sum_i
/// (-1)^i\,V_i\bigl[\omega(V_0,\dots,\widehat{V_i},\dots,V_k)\bigr]\f$ for constant fields.
///
/// \snippet numbers.cpp forms
template <class Form>
auto exterior_derivative(Form const& omega) {
  return [omega]<class S, int D, int k>(Matrix<S, D, 1> const& at, Tangents<S, D, k> const& V) -> S {
    using T = Dual<S>;
    S sum(0);
    for (int i = 0; i < k; ++i) {
      Matrix<T, D, 1> moved = at.template cast<T>();
      for (int r = 0; r < D; ++r) moved[r].part[0] = V(r, i);
      Tangents<T, D, k - 1> others;
      for (int c = 0, to = 0; c < k; ++c)
        if (c != i) others.col(to++) = V.col(c).template cast<T>();
      S const rate = omega(moved, others).part[0];
      if (i % 2 == 0)
        sum += rate;
      else
        sum -= rate;
    }
    return sum;
  };
}

}  // namespace actio
