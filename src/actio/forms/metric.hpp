// Riemannian metrics as callables, and what is made of them: volume, Christoffel symbols, lowered and raised
// indices.
//
// A metric is a callable g(y) that returns the matrix g_ab at a point, over any scalar. `Euclidean<n>` is the
// metric whose matrix is the identity: it returns no matrix but a type, `Kronecker<n>`, for which every
// operation here is overloaded, so that a flat space costs nothing. A metric with the member
// `static constexpr bool constant = true` has no Christoffel symbols.
#pragma once

#include <array>
#include <string>

#include "actio/forms/forms.hpp"
#include "actio/numbers/derivative.hpp"
#include "actio/numbers/square_root.hpp"

namespace actio {

/// The value of the Euclidean metric at a point: the identity, known to the compiler.
template <int n>
struct Kronecker {};

/// The Euclidean metric in Cartesian coordinates.
template <int n>
struct Euclidean {
  static constexpr bool constant = true;  ///< its derivatives vanish
  template <class V>
  Kronecker<n> operator()(V const&) const { return {}; }
};

/// A metric whose matrix is the same everywhere.
template <class S, int n>
struct ConstantMetric {
  static constexpr bool constant = true;  ///< its derivatives vanish
  Matrix<S, n, n> matrix;                 ///< symmetric, positive definite
  template <class V>
  Matrix<typename V::Scalar, n, n> operator()(V const&) const {
    return matrix.template cast<typename V::Scalar>();
  }
};

/// Whether a metric is known to have vanishing derivatives.
template <class Metric>
inline constexpr bool is_constant_metric = false;
/// What the metric says of itself.
template <class Metric>
  requires requires { typename std::bool_constant<Metric::constant>; }
inline constexpr bool is_constant_metric<Metric> = Metric::constant;

/// A matrix that is no metric: not symmetric, or not positive definite; over a field without order the second
/// is left out.
struct NotAMetric : OutsideDomain {
  using OutsideDomain::OutsideDomain;
};

// ---- The value of a metric at a point: a symmetric matrix, or the identity as a type.

/// The matrix of a metric's value over the scalar S.
template <class S, int n>
Matrix<S, n, n> as_matrix(Matrix<S, n, n> const& g) { return g; }
/// The same for the Euclidean metric.
template <class S, int n>
Matrix<S, n, n> as_matrix(Kronecker<n>) { return Matrix<S, n, n>::Identity(); }

/// \f$g_{ab}u^aw^b\f$.
template <class S, int n>
S inner(Matrix<S, n, n> const& g, Matrix<S, n, 1> const& u, Matrix<S, n, 1> const& w) {
  S sum(0);
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) sum += g(a, b) * u[a] * w[b];
  return sum;
}
/// The same for the Euclidean metric.
template <class S, int n>
S inner(Kronecker<n>, Matrix<S, n, 1> const& u, Matrix<S, n, 1> const& w) {
  S sum(0);
  for (int a = 0; a < n; ++a) add_product(sum, u[a], w[a]);
  return sum;
}

/// \f$\sqrt{\det g}\f$.
/// @throws NotASquare  over the rationals, where it is irrational
template <class S, int n>
S volume(Matrix<S, n, n> const& g) { return square_root(determinant(g)); }
/// The same for the Euclidean metric.
template <class S, int n>
Base<S> volume(Kronecker<n>) { return Base<S>(1); }

/// The pulled-back metric \f$g_{ab}F^a{}_iF^b{}_j\f$.
template <class S, int N, int n>
Matrix<S, n, n> pulled_back(Matrix<S, N, N> const& g, Matrix<S, N, n> const& F) {
  return F.transpose() * (g * F).eval();
}
/// The same for the Euclidean metric.
template <class S, int N, int n>
Matrix<S, n, n> pulled_back(Kronecker<N>, Matrix<S, N, n> const& F) {
  Matrix<S, n, n> C;
#pragma GCC unroll 3
  for (int i = 0; i < n; ++i)
#pragma GCC unroll 3
    for (int j = 0; j <= i; ++j) {
      S sum = F(0, i) * F(0, j);
#pragma GCC unroll 3
      for (int a = 1; a < N; ++a) add_product(sum, F(a, i), F(a, j));
      C(i, j) = C(j, i) = sum;
    }
  return C;
}

/// \f$G^{-1}C\f$: the first index raised.
template <class S, int n, int k>
Matrix<S, n, k> raised(Matrix<S, n, n> const& G, Matrix<S, n, k> const& C) {
  return solve_linear(G, C, "raised");
}
/// The same for the Euclidean metric.
template <class S, int n, int k>
Matrix<S, n, k> raised(Kronecker<n>, Matrix<S, n, k> const& C) { return C; }
/// \f$g\,T\f$: the first index lowered.
template <class S, int n, int k>
Matrix<S, n, k> lowered(Matrix<S, n, n> const& g, Matrix<S, n, k> const& T) { return g * T; }
/// The same for the Euclidean metric.
template <class S, int n, int k>
Matrix<S, n, k> lowered(Kronecker<n>, Matrix<S, n, k> const& T) { return T; }

namespace detail {
/// A metric and the point that it is taken at, for a message.
template <class V>
std::string metric_at(char const* which, V const& y) {
  std::string text = std::string(which) + " at (";
  for (Index i = 0; i < y.size(); ++i) text += (i ? ", " : "") + show(to_double(y[i]));
  return text + ")";
}
}  // namespace detail

/// Refuses a matrix that is not symmetric to rounding, or not positive definite.
/// @param y  the point, for the message
/// @throws NotAMetric  with the asymmetry over the largest entry, or the pivot of the elimination that is not
///                     positive
template <class S, int n, class V>
void require_metric(Matrix<S, n, n> const& g, V const& y, char const* which) {
  auto const where = [&] { return detail::metric_at(which, y); };
  if (!is_finite(g)) throw NotFinite(where());
  Base<S> const size = magnitude(g);
  // Entries come out of a computation: some tens of roundings.
  Base<S> const bound = Base<S>(64) * epsilon<S>() * size;
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < a; ++b) {
      Base<S> const gap = magnitude(Base<S>(base_value(g(a, b)) - base_value(g(b, a))));
      if (gap > bound)
        throw NotAMetric(where(),
                         "a metric is symmetric; difference of g(a, b) and g(b, a) over the largest entry",
                         to_double(Base<S>(gap / size)), to_double(Base<S>(bound / size)));
    }
  if (!ordered_arithmetic<S>()) return;
  // Elimination without exchanges: all pivots of a positive definite matrix are positive.
  Matrix<Base<S>, n, n> left;
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) left(a, b) = base_value(g(a, b));
  for (int k = 0; k < n; ++k) {
    if (!(left(k, k) > bound))
      throw NotAMetric(where(), "a metric is positive definite; pivot of the elimination",
                       to_double(left(k, k)), to_double(bound));
    for (int i = k + 1; i < n; ++i) {
      Base<S> const factor = left(i, k) / left(k, k);
      for (int j = k; j < n; ++j) left(i, j) -= factor * left(k, j);
    }
  }
}
/// The same for the Euclidean metric.
template <int n, class V>
void require_metric(Kronecker<n>, V const&, char const*) {}

/// Refuses, over the rationals, a matrix whose volume is irrational.
/// @param y  the point, for the message
/// @throws NotASquare  with the determinant
template <class S, int n, class V>
void require_volume(Matrix<S, n, n> const& g, V const& y, char const* which) {
  if (exact_arithmetic<S>()) {
    S const square = determinant(g);
    try {
      square_root(base_value(square));
    } catch (NotASquare const& not_a_square) {
      throw NotASquare(detail::metric_at(which, y),
                       "over a field without all roots the determinant is the square of a number",
                       not_a_square.measured, 0);
    }
  }
}
/// The same for the Euclidean metric.
template <int n, class V>
void require_volume(Kronecker<n>, V const&, char const*) {}

// ---- Fields of metrics.

/// \f$\partial g_{ab}/\partial y^c\f$ for all c: `rates[c](a, b)`.
template <class Metric, class S, int n>
std::array<Matrix<S, n, n>, n> metric_derivatives(Metric const& g, Matrix<S, n, 1> const& y) {
  std::array<Matrix<S, n, n>, n> rates;
  if constexpr (is_constant_metric<Metric>) {
    for (auto& rate : rates) rate.setZero();
  } else {
    auto const d = derivative(g, y);
    for (int c = 0; c < n; ++c) rates[c] = d.partial(c);
  }
  return rates;
}

/// The Christoffel symbols \f$\gamma^c_{ab} = \tfrac12
/// g^{ce}(\partial_bg_{ae} + \partial_ag_{be} - \partial_eg_{ab})\f$ at a point: `gamma[c](a, b)`.
///
/// \snippet numbers.cpp metric
///
/// \implements{claim_6_2_christoffel}
/// @throws Singular  where g is
/// Accuracy: exact but for rounding; zero, without a computation, for constant metrics.
template <class Metric, class S, int n>
std::array<Matrix<S, n, n>, n> christoffel(Metric const& g, Matrix<S, n, 1> const& y) {
  std::array<Matrix<S, n, n>, n> gamma;
  for (auto& m : gamma) m.setZero();
  if constexpr (!is_constant_metric<Metric>) {
    auto const d = derivative(g, y);
    Matrix<S, n, n> const inverse = inverse_matrix(d.value, "christoffel");
    auto const dg = [&d](int c, int a, int b) -> S const& { return d.matrix(a + n * b, c); };
    for (int c = 0; c < n; ++c)
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b)
          for (int e = 0; e < n; ++e) {
            // [claim_6_2_christoffel]
            gamma[c](a, b) += inverse(c, e) * (dg(b, a, e) + dg(a, b, e) - dg(e, a, b)) / S(2);
            // [claim_6_2_christoffel]
          }
  }
  return gamma;
}

/// \f$\gamma^c_{ab}u^aw^b\f$.
template <class Metric, class S, int n>
Matrix<S, n, 1> connection(Metric const& g, Matrix<S, n, 1> const& y, Matrix<S, n, 1> const& u,
                           Matrix<S, n, 1> const& w) {
  Matrix<S, n, 1> sum = Matrix<S, n, 1>::Zero();
  if constexpr (!is_constant_metric<Metric>) {
    auto const gamma = christoffel(g, y);
    for (int c = 0; c < n; ++c) sum[c] = inner(gamma[c], u, w);
  }
  return sum;
}

// ---- Derivatives of vector fields.

/// The divergence \f$\frac1{\sqrt{\det g}}\,\partial_a(\sqrt{\det g}\,u^a)\f$ of a vector field with respect
/// to the volume of a metric.
///
/// \snippet numbers.cpp metric
/// @param g   metric, a callable on points
/// @param u   vector field: a callable on points, over any scalar. It may depend on time as well: then points
///            are (t, y), and the derivatives are those by y
/// @param at  point, with as many coordinates as the field has components; or (t, y)
/// Accuracy: exact but for the rounding of g and u.
template <class Metric, class Field, class S, int rows>
S divergence(Metric const& g, Field const& u, Matrix<S, rows, 1> const& at) {
  constexpr int n = std::remove_cvref_t<decltype(u(at))>::RowsAtCompileTime;
  static_assert(n == rows || n == rows - 1,
                "a vector field has as many components as the space has dimensions");
  auto const flux = [&]<class T>(Matrix<T, n, 1> const& y) -> Matrix<T, n, 1> {
    Matrix<T, rows, 1> point = at.template cast<T>();
    point.template tail<n>() = y;
    return u(point) * volume<T>(g(y));
  };
  Matrix<S, n, 1> const y = at.template tail<n>();
  return derivative(flux, y).matrix.trace() / volume<S>(g(y));
}
/// The divergence \f$\partial_\mu B^\mu\f$ with respect to the volume of the coordinates.
/// @param B  a callable on points, over any scalar, with as many components as a point has coordinates
template <class Field, class S, int rows>
S divergence(Field const& B, Matrix<S, rows, 1> const& x) { return divergence(Euclidean<rows>{}, B, x); }

/// The Lie derivative \f$k^c\partial_cg_{ab} + g_{cb}\,\partial_ak^c + g_{ac}\,\partial_bk^c\f$ of a metric
/// along a vector field: zero for Killing fields.
///
/// \implements{claim_9_0_isometries}
/// @param k  vector field: a callable on points, over any scalar
/// Accuracy: exact but for the rounding of g and k.
template <class Metric, class Field, class S, int n>
Matrix<S, n, n> lie_derivative(Metric const& g, Field const& k, Matrix<S, n, 1> const& y) {
  auto const metric = [&g]<class T>(Matrix<T, n, 1> const& z) { return as_matrix<T>(g(z)); };
  auto const [k_y, dk] = derivative(k, y);
  auto const [g_y, dg] = derivative_along(metric, y, k_y);
  return dg + dk.transpose() * g_y + g_y * dk;
}

}  // namespace actio
