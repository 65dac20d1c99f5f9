// The derivative of a callable, exact but for the rounding of the callable itself.
//
// A function f of a number, of a vector or of a matrix, with values that are numbers, vectors or matrices, is
// evaluated on dual numbers (dual.hpp): no step size, nothing left out. Variables go through in batches of
// one size, so that the dimension of a space never enters the type of a scalar, and a function is compiled
// for the same few scalars wherever it is differentiated. f is a callable over any scalar; over dual numbers
// `derivative` gives second derivatives, and over the rationals the derivatives of rational functions as
// rational numbers.
#pragma once

#include <type_traits>

#include "actio/numbers/dual.hpp"

namespace actio {

/// How many directions a dual number carries at once. With the value they are four numbers: two pairs of
/// doubles.
inline constexpr int batch = 3;

/// The scalar on which one differential of a function at `S` is evaluated.
template <class S>
using Moved = Dual<S, batch>;

// ---- Functions of one number, and derivatives along one direction.

/// How a number changes in the direction of its dual numbers.
template <class S>
S rate_of(Dual<S> const& x) { return x.part[0]; }
/// How a matrix changes in the direction of its dual numbers.
template <class S, int R, int C>
Matrix<S, R, C> rate_of(Matrix<Dual<S>, R, C> const& x) {
  return x.unaryExpr([](Dual<S> const& entry) -> S { return entry.part[0]; });
}

namespace detail {
/// Values of dual numbers.
template <class S, int N>
S without_parts(Dual<S, N> const& x) { return x.value; }
/// Values of dual numbers.
template <class S, int N, int R, int C>
Matrix<S, R, C> without_parts(Matrix<Dual<S, N>, R, C> const& x) {
  return x.unaryExpr([](Dual<S, N> const& entry) -> S { return entry.value; });
}

/// What a function returned, over the dual numbers D: a number, or a matrix that owns its entries.
template <class D, class Y>
auto over_dual(Y const& y) {
  if constexpr (MatrixLike<Y>)
    return Matrix<D, int(Y::RowsAtCompileTime), int(Y::ColsAtCompileTime)>(y);
  else
    return D(y);
}
}  // namespace detail

/// The value of a function and its rate of change along one direction, a number, a vector or a matrix each.
template <class Value>
struct ValueAndRate {
  Value value;  ///< \f$f\f$
  Value rate;   ///< its derivative along the direction
};

namespace detail {
/// What a function returned, taken apart.
template <class D, class Y>
auto value_and_rate(Y const& y) {
  auto const dual = over_dual<D>(y);
  return ValueAndRate<decltype(without_parts(dual))>{without_parts(dual), rate_of(dual)};
}
}  // namespace detail

/// A number as a variable: \f$t + \epsilon\f$ with an infinitesimal \f$\epsilon\f$.
template <Scalar S>
Dual<S> variable(S const& t) {
  Dual<S> moved(t);
  moved.part[0] = S(1);
  return moved;
}

/// The derivative of a function of one number: \f$f(t)\f$ and \f$f'(t)\f$.
///
/// \snippet numbers.cpp derivative
/// @param f  a callable on numbers, over any scalar; its values are numbers, vectors or matrices
/// @param t  where, a plain number or one over dual numbers
/// Accuracy: exact but for the rounding of f.
template <class F, Scalar S>
auto derivative(F const& f, S const& t) { return detail::value_and_rate<Dual<S>>(f(variable(t))); }

/// \f$x + \epsilon w\f$ with an infinitesimal \f$\epsilon\f$: a number, a vector or a matrix moved along w.
template <class S, int R, int C>
Matrix<Dual<S>, R, C> moved_along(Matrix<S, R, C> const& x, Matrix<S, R, C> const& w) {
  Matrix<Dual<S>, R, C> moved = x.template cast<Dual<S>>();
  for (Index i = 0; i < x.size(); ++i) moved.data()[i].part[0] = w.data()[i];
  return moved;
}

/// The derivative along a direction: \f$f(x)\f$ and \f$\frac{d}{d\epsilon}f(x + \epsilon w)\f$ at
/// \f$\epsilon = 0\f$.
///
/// \snippet numbers.cpp derivative_along
/// @param f  a callable on vectors (or matrices), over any scalar; its values are numbers, vectors or
///           matrices
/// @param x  where
/// @param w  direction, with as many components as x
/// Accuracy: exact but for the rounding of f.
template <class F, class S, int R, int C>
auto derivative_along(F const& f, Matrix<S, R, C> const& x, Matrix<S, R, C> const& w) {
  return detail::value_and_rate<Dual<S>>(f(moved_along(x, w)));
}

// ---- Functions of several variables.

namespace detail {
/// How many entries a matrix of these sizes has, as far as they are known now.
constexpr int entries_of(int R, int C) { return R == Dynamic || C == Dynamic ? Dynamic : R * C; }
/// The same of a value; a number has one.
template <class Value>
constexpr int components_of() {
  if constexpr (MatrixLike<Value>)
    return entries_of(Value::RowsAtCompileTime, Value::ColsAtCompileTime);
  else
    return 1;
}
}  // namespace detail

/// The value of a function of R x C variables and the matrix of its derivatives.
/// @tparam Value  a number, a vector or a matrix over S
template <class S, class Value, int R, int C>
struct Derivative {
  Value value;  ///< \f$f(x)\f$
  /// \f$\partial f_i/\partial x_k\f$: a row for each component of the value, a column for each variable.
  /// Matrices count column by column.
  Matrix<S, detail::components_of<Value>(), detail::entries_of(R, C)> matrix;

  /// \f$\partial f/\partial x_k\f$, in the shape of the value.
  Value partial(Index k) const {
    if constexpr (MatrixLike<Value>) {
      Value rate = value;
      for (Index i = 0; i < rate.size(); ++i) rate.data()[i] = matrix(i, k);
      return rate;
    } else {
      return matrix(0, k);
    }
  }
  /// The derivatives of a number, in the shape of the variables: \f$\partial f/\partial x_{ab}\f$ in row a
  /// and column b.
  Matrix<S, R, C> gradient() const
    requires(!MatrixLike<Value>)
  {
    static_assert(C == 1 || detail::entries_of(R, C) != Dynamic, "variables of any number are a column");
    Matrix<S, R, C> d;
    if constexpr (R == Dynamic) d.resize(matrix.cols());
    for (Index k = 0; k < d.size(); ++k) d.data()[k] = matrix(0, k);
    return d;
  }
};

/// The derivative of a function of several variables: its value and the matrix of its derivatives.
///
/// f is evaluated once for each \ref batch of variables.
///
/// \snippet numbers.cpp derivative
/// @param f  a callable on vectors (or matrices) over any scalar; its values are numbers, vectors or matrices
/// @param x  where: a vector, or a matrix, whose entries are the variables column by column
/// Accuracy: exact but for the rounding of f.
template <class F, class S, int R, int C>
auto derivative(F const& f, Matrix<S, R, C> const& x) {
  using D = Moved<S>;
  Matrix<D, R, C> moved = x.template cast<D>();
  using Y = decltype(detail::over_dual<D>(f(moved)));
  using Value = decltype(detail::without_parts(std::declval<Y const&>()));
  Derivative<S, Value, R, C> d;
  Index const n = x.size();
  Index first = 0;
  do {
    for (Index a = 0; a < batch && first + a < n; ++a) moved.data()[first + a].part[a] = S(1);
    Y const y = detail::over_dual<D>(f(moved));
    for (Index a = 0; a < batch && first + a < n; ++a) moved.data()[first + a].part[a] = S(0);
    auto const store = [&](D const& component, Index i) {
      for (Index a = 0; a < batch && first + a < n; ++a) d.matrix(i, first + a) = component.part[a];
    };
    if constexpr (MatrixLike<Value>) {
      if (first == 0) {
        d.value = detail::without_parts(y);
        d.matrix.resize(y.size(), n);
      }
      for (Index i = 0; i < y.size(); ++i) store(y.data()[i], i);
    } else {
      if (first == 0) {
        d.value = y.value;
        d.matrix.resize(1, n);
      }
      store(y, 0);
    }
  } while ((first += batch) < n);
  return d;
}

}  // namespace actio
