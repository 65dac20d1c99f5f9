// The requirements on a matrix, and the sizes of one.
#pragma once

#include <concepts>
#include <cstddef>

// Matrices of Eigen go in and come out where a program includes it; named here, so that no other has to.
namespace Eigen {
template <class Scalar, int rows, int columns, int options, int most_rows, int most_columns>
class Matrix;
template <class Derived>
class MatrixBase;
}  // namespace Eigen

namespace actio {

/// Rows, columns and their number.
using Index = std::ptrdiff_t;
/// A size that is known when the program runs.
inline constexpr int Dynamic = -1;

template <class S, int R = Dynamic, int C = Dynamic>
struct Matrix;
/// A column of n numbers: `Vector<double, 3>(1, 2, 3)`; with n = Dynamic `Vector<double>(n)`, whose entries
/// are to be set. It is the \ref Matrix of n rows and one column, and has what that has.
template <class S, int n = Dynamic>
using Vector = Matrix<S, n, 1>;
template <class S, int R, int C>
struct MatrixView;

/// Whatever has rows, columns and entries: a matrix, a view of one, or an expression of Eigen.
template <class M>
concept MatrixLike = requires(M const& m) {
  typename M::Scalar;
  typename M::PlainObject;
  { m.rows() } -> std::convertible_to<Index>;
  { m.cols() } -> std::convertible_to<Index>;
};

/// z += x y.
template <class S>
void add_product(S& z, S const& x, S const& y) { z += x * y; }

namespace detail {

/// Whether M is a matrix of our own, or a view of one.
template <class M>
inline constexpr bool is_own_matrix = false;
template <class S, int R, int C>
inline constexpr bool is_own_matrix<Matrix<S, R, C>> = true;
template <class S, int R, int C>
inline constexpr bool is_own_matrix<MatrixView<S, R, C>> = true;

/// Says that the two numbers before are sizes.
struct Sized {};

template <class M>
inline constexpr int rows_of = int(M::RowsAtCompileTime);
template <class M>
inline constexpr int columns_of = int(M::ColsAtCompileTime);
/// Of two sizes of which one may be known when the program runs alone, the one that is known now.
constexpr int known(int a, int b) { return a == Dynamic ? b : a; }

/// Whether a matrix may have R rows and C columns, as far as sizes are known now.
template <class M, int R, int C>
inline constexpr bool may_be = (rows_of<M> == R || rows_of<M> == Dynamic || R == Dynamic) &&
                               (columns_of<M> == C || columns_of<M> == Dynamic || C == Dynamic);
/// Whether there is such an entry.
constexpr bool is_index(Index k, Index count) { return k >= 0 && k < count; }
/// A matrix itself; an expression of Eigen as a matrix.
template <class B>
decltype(auto) evaluated(B const& b) {
  if constexpr (is_own_matrix<B>)
    return (b);
  else
    return b.eval();
}

}  // namespace detail

}  // namespace actio
