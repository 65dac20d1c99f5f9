// Riemannian metrics as callables, and what is made of them: volume, Christoffel symbols, lowered and raised indices.
//
// A metric is a callable g(y) that returns the matrix g_ab at a point, over any scalar. `Euclidean<n>` is the metric whose matrix is the identity: it returns no
// matrix but a type, `Kronecker<n>`, for which every operation here is overloaded, so that a flat space costs nothing. A metric with the member
// `static constexpr bool constant = true` has no Christoffel symbols.
#pragma once

#include <array>
#include <string>

#include "actio/forms/forms.hpp"
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
  Kronecker<n> operator()(V const&) const {
    return {};
  }
};

/// A metric whose matrix is the same everywhere.
template <class S, int n>
struct ConstantMetric {
  static constexpr bool constant = true;  ///< its derivatives vanish
  Matrix<S, n, n> matrix;  ///< symmetric, positive definite
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

/// A matrix that is no metric: not symmetric, or not positive definite; over a field without order the second is left out.
struct NotAMetric : OutsideDomain {
  using OutsideDomain::OutsideDomain;
};

// ---- The value of a metric at a point: a symmetric matrix, or the identity as a type.

/// The matrix of a metric's value over the scalar S.
template <class S, int n>
Matrix<S, n, n> as_matrix(Matrix<S, n, n> const& g) {
  return g;
}
/// The same for the Euclidean metric.
template <class S, int n>
Matrix<S, n, n> as_matrix(Kronecker<n>) {
  return Matrix<S, n, n>::Identity();
}

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
S volume(Matrix<S, n, n> const& g) {
  return square_root(determinant(g));
}
/// The same for the Euclidean metric.
template <class S, int n>
Base<S> volume(Kronecker<n>) {
  return Base<S>(1);
}

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
Matrix<S, n, k> raised(Kronecker<n>, Matrix<S, n, k> const& C) {
  return C;
}
/// \f$g\,T\f$: the first index lowered.
template <class S, int n, int k>
Matrix<S, n, k> lowered(Matrix<S, n, n> const& g, Matrix<S, n, k> const& T) {
  return g * T;
}
/// The same for the Euclidean metric.
template <class S, int n, int k>
Matrix<S, n, k> lowered(Kronecker<n>, Matrix<S, n, k> const& T) {
  return T;
}

namespace detail {
/// A metric and the point that it is taken at, for a message.
template <class V>
std::string metric_at(char const* which, V const& at) {
  std::string text = std::string(which) + " at (";
  for (Index i = 0; i < at.size(); ++i) text += (i ? ", " : "") + show(to_double(at[i]));
  return text + ")";
}
}  // namespace detail

/// Refuses a matrix that is not symmetric to rounding, or not positive definite.
/// @param at  the point, for the message
/// @throws NotAMetric  with the asymmetry over the largest entry, or the pivot of the elimination that is not positive
template <class S, int n, class V>
void require_metric(Matrix<S, n, n> const& g, V const& at, char const* which) {
  auto const where = [&] { return detail::metric_at(which, at); };
  if (!is_finite(g)) throw NotFinite(where());
  Base<S> const size = magnitude(g);
  // Entries come out of a computation: some tens of roundings.
  Base<S> const bound = Base<S>(64) * epsilon<S>() * size;
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < a; ++b) {
      Base<S> const gap = magnitude(Base<S>(base_value(g(a, b)) - base_value(g(b, a))));
      if (gap > bound) throw NotAMetric(where(), "a metric is symmetric; difference of g(a, b) and g(b, a) over the largest entry", to_double(Base<S>(gap / size)), to_double(Base<S>(bound / size)));
    }
  if (!ordered_arithmetic<S>()) return;
  // Elimination without exchanges: all pivots of a positive definite matrix are positive.
  Matrix<Base<S>, n, n> left;
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) left(a, b) = base_value(g(a, b));
  for (int k = 0; k < n; ++k) {
    if (!(left(k, k) > bound)) throw NotAMetric(where(), "a metric is positive definite; pivot of the elimination", to_double(left(k, k)), to_double(bound));
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
/// @param at  the point, for the message
/// @throws NotASquare  with the determinant
template <class S, int n, class V>
void require_volume(Matrix<S, n, n> const& g, V const& at, char const* which) {
  if (exact_arithmetic<S>()) {
    S const square = determinant(g);
    try {
      square_root(base_value(square));
    } catch (NotASquare const& not_a_square) {
      throw NotASquare(detail::metric_at(which, at), "over a field without all roots the determinant is the square of a number", not_a_square.measured, 0);
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
  using D = Dual<S, n>;
  std::array<Matrix<S, n, n>, n> rates;
  if constexpr (is_constant_metric<Metric>) {
    for (auto& rate : rates) rate.setZero();
  } else {
    Matrix<D, n, 1> moved = y.template cast<D>();
    for (int c = 0; c < n; ++c) moved[c].part[c] = S(1);
    Matrix<D, n, n> const value = g(moved);
    for (int c = 0; c < n; ++c)
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) rates[c](a, b) = value(a, b).part[c];
  }
  return rates;
}

/// The Christoffel symbols \f$\gamma^c_{ab} = \tfrac12 g^{cd}(\partial_bg_{ad} + \partial_ag_{bd} - \partial_dg_{ab})\f$ at a point: `gamma[c](a, b)`.
///
/// \implements{claim_6_2_christoffel}
/// @throws Singular  where g is
/// Accuracy: exact but for rounding; zero, without a computation, for constant metrics.
template <class Metric, class S, int n>
std::array<Matrix<S, n, n>, n> christoffel(Metric const& g, Matrix<S, n, 1> const& y) {
  std::array<Matrix<S, n, n>, n> gamma;
  for (auto& m : gamma) m.setZero();
  if constexpr (!is_constant_metric<Metric>) {
    auto const rates = metric_derivatives(g, y);
    Matrix<S, n, n> const inverse = inverse_matrix(Matrix<S, n, n>(g(y)), "christoffel");
    for (int c = 0; c < n; ++c)
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b)
          for (int d = 0; d < n; ++d) {
            // [claim_6_2_christoffel]
            gamma[c](a, b) += inverse(c, d) * (rates[b](a, d) + rates[a](b, d) - rates[d](a, b)) / S(2);
            // [claim_6_2_christoffel]
          }
  }
  return gamma;
}

/// \f$\gamma^c_{ab}u^aw^b\f$.
template <class Metric, class S, int n>
Matrix<S, n, 1> connection(Metric const& g, Matrix<S, n, 1> const& y, Matrix<S, n, 1> const& u, Matrix<S, n, 1> const& w) {
  Matrix<S, n, 1> sum = Matrix<S, n, 1>::Zero();
  if constexpr (!is_constant_metric<Metric>) {
    auto const gamma = christoffel(g, y);
    for (int c = 0; c < n; ++c) sum[c] = inner(gamma[c], u, w);
  }
  return sum;
}

}  // namespace actio
