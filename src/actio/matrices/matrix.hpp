// Matrices and vectors over any numbers: small, eager, plain loops.
//
// An operation is carried out where it is written, and its result is a matrix: no expression waits for later,
// nothing is aliased, and `auto` holds what it seems to. Names are those of Eigen, so that a formula written
// for Eigen's vectors reads and works the same; Eigen's own matrices go in and come out without a word.
// Columns lie one after the other, as Eigen's do.
//
// A part of a matrix (a column, a block, the diagonal) is a view of its entries (matrix_view.hpp): it can be
// read and, where the matrix can be changed, written.
#pragma once

#include <cassert>
#include <concepts>
#include <initializer_list>
#include <type_traits>
#include <utility>

#include "actio/matrices/matrix_operations.hpp"
#include "actio/matrices/matrix_view.hpp"

namespace actio {

/// A matrix of R rows and C columns, each fixed or `Dynamic`.
///
/// \snippet numbers.cpp matrix
template <class S, int R, int C>
struct Matrix : detail::MatrixOperations<Matrix<S, R, C>, S, R, C>, private detail::MatrixEntries<S, R, C> {
  using Operations = detail::MatrixOperations<Matrix, S, R, C>;  ///< what it has in common with a view
  using Entries = detail::MatrixEntries<S, R, C>;                ///< where its numbers are
  using Entries::cols, Entries::data, Entries::rows;
  /// Whether the compiler knows both sizes.
  static constexpr bool fixed = R != Dynamic && C != Dynamic;

  /// Without numbers yet; of size 0 where the size is not fixed.
  Matrix() = default;
  /// Of a size, without numbers yet.
  Matrix(Index r, Index c, detail::Sized) { this->set_size(r, c); }
  /// A vector of n places; or the number of a matrix that has one.
  template <class T>
    requires(!MatrixLike<T> && std::convertible_to<T, S>)
  explicit Matrix(T const& n) {
    if constexpr (fixed && R * C == 1)
      (*this)(0, 0) = n;
    else if constexpr (std::convertible_to<T, Index>)
      R == 1 ? this->set_size(1, static_cast<Index>(n))
             : this->set_size(static_cast<Index>(n), C == Dynamic ? 1 : C);
  }
  /// r rows and c columns; or the two numbers of a vector that has as many.
  template <class T, class U>
    requires(!MatrixLike<T> && !MatrixLike<U>)
  Matrix(T const& r, U const& c) {
    if constexpr (fixed && R * C == 2)
      entry_at(0) = S(r), entry_at(1) = S(c);
    else
      this->set_size(static_cast<Index>(r), static_cast<Index>(c));
  }
  /// The numbers of a vector.
  template <class T, class U, class V, class... More>
    requires(!MatrixLike<T> && !std::same_as<V, detail::Sized>)
  Matrix(T const& a, U const& b, V const& c, More const&... more) {
    this->set_size(R == 1 ? 1 : 3 + Index(sizeof...(more)), R == 1 ? 3 + Index(sizeof...(more)) : 1);
    entry_at(0) = S(a), entry_at(1) = S(b), entry_at(2) = S(c);
    Index k = 3;
    ((entry_at(k++) = S(more)), ...);
  }
  /// The numbers row by row; or, for a vector, all of them in one list.
  Matrix(std::initializer_list<std::initializer_list<S>> given) {
    Index const r = static_cast<Index>(given.size()),
                c = r > 0 ? static_cast<Index>(given.begin()->size()) : 0;
    if (C == 1 && r == 1 && c > 1) {
      this->set_size(c, 1);
      Index k = 0;
      for (S const& x : *given.begin()) entry_at(k++) = x;
      return;
    }
    this->set_size(r, c);
    Index i = 0;
    for (auto const& line : given) {
      Index j = 0;
      for (S const& x : line) (*this)(i, j++) = x;
      ++i;
    }
  }
  /// The numbers of another matrix, of a view or of an expression of Eigen.
  template <MatrixLike B>
    requires(!std::same_as<B, Matrix> && std::convertible_to<typename B::Scalar, S> &&
             detail::may_be<B, R, C>)
  Matrix(B const& b) {
    take(b);
  }
  /// Takes the numbers of another matrix, which may be a part of this one.
  template <MatrixLike B>
    requires(!std::same_as<B, Matrix> && detail::may_be<B, R, C>)
  Matrix& operator=(B const& b) {
    if constexpr (requires { b.data(); } && detail::is_own_matrix<B>) {
      // It may be a part of this one.
      Matrix copy(b);
      return *this = std::move(copy);
    } else {
      take(b);
      return *this;
    }
  }

  /// The number in row i and column j. Without NDEBUG an index outside ends the program; so does it below.
  S& operator()(Index i, Index j) {
    assert(detail::is_index(i, rows()) && detail::is_index(j, cols()));
    return data()[i + j * rows()];
  }
  /// The number in row i and column j.
  S const& operator()(Index i, Index j) const {
    assert(detail::is_index(i, rows()) && detail::is_index(j, cols()));
    return data()[i + j * rows()];
  }
  /// The k-th number, column by column.
  S& operator()(Index k) {
    assert(detail::is_index(k, rows() * cols()));
    return data()[k];
  }
  /// The k-th number, column by column.
  S const& operator()(Index k) const {
    assert(detail::is_index(k, rows() * cols()));
    return data()[k];
  }
  /// The k-th number of a vector.
  S& operator[](Index k) { return (*this)(k); }
  /// The k-th number of a vector.
  S const& operator[](Index k) const { return (*this)(k); }

  /// From one number to the next down a column.
  static constexpr Index rowStride() { return 1; }
  /// From one number to the next along a row.
  Index colStride() const { return rows(); }
  /// From one number of a vector to the next.
  Index along() const { return R == 1 ? colStride() : 1; }
  /// The first of all numbers, column by column.
  S* begin() { return data(); }
  /// After the last of them.
  S* end() { return data() + this->size(); }
  /// The first of all numbers, column by column.
  S const* begin() const { return data(); }
  /// After the last of them.
  S const* end() const { return data() + this->size(); }
  /// Another size; numbers are lost.
  void resize(Index r, Index c) { this->set_size(r, c); }
  /// Another length; numbers are lost.
  void resize(Index n) { R == 1 ? this->set_size(1, n) : this->set_size(n, C == Dynamic ? 1 : C); }
  /// Another size; numbers within both stay.
  void conservativeResize(Index r, Index c) {
    Matrix m(r, c, detail::Sized{});
    for (Index j = 0; j < c; ++j)
      for (Index i = 0; i < r; ++i) m(i, j) = i < rows() && j < cols() ? (*this)(i, j) : S(0);
    *this = std::move(m);
  }
  /// Another length; numbers within both stay.
  void conservativeResize(Index n) { conservativeResize(n, 1); }
  using Operations::setZero;
  /// Another size, and zero everywhere.
  Matrix& setZero(Index r, Index c) { return resize(r, c), setZero(); }

  /// x everywhere.
  static Matrix Constant(Index r, Index c, S const& x) {
    Matrix m(r, c, detail::Sized{});
    m.fill(x);
    return m;
  }
  /// x everywhere in a vector of n.
  static Matrix Constant(Index n, S const& x) { return R == 1 ? Constant(1, n, x) : Constant(n, 1, x); }
  /// x everywhere, of the fixed size.
  static Matrix Constant(S const& x) { return Constant(R, C, x); }
  /// Zero everywhere.
  static Matrix Zero(Index r, Index c) { return Constant(r, c, S(0)); }
  /// Zero everywhere in a vector of n.
  static Matrix Zero(Index n) { return Constant(n, S(0)); }
  /// Zero everywhere, of the fixed size.
  static Matrix Zero() { return Constant(R, C, S(0)); }
  /// 1 everywhere.
  static Matrix Ones(Index r, Index c) { return Constant(r, c, S(1)); }
  /// 1 everywhere in a vector of n.
  static Matrix Ones(Index n) { return Constant(n, S(1)); }
  /// 1 everywhere, of the fixed size.
  static Matrix Ones() { return Constant(R, C, S(1)); }
  /// 1 along the diagonal, 0 elsewhere.
  static Matrix Identity(Index r, Index c) {
    Matrix m(r, c, detail::Sized{});
    m.setIdentity();
    return m;
  }
  /// 1 along the diagonal, 0 elsewhere, of the fixed size.
  static Matrix Identity() { return Identity(R, C); }
  /// The vector of n with 1 in the k-th place, 0 elsewhere.
  static Matrix Unit(Index n, Index k) {
    Matrix m = Zero(n);
    m[k] = S(1);
    return m;
  }
  /// The vector of fixed length with 1 in the k-th place, 0 elsewhere.
  static Matrix Unit(Index k) { return Unit(R == 1 ? C : R, k); }
  /// The first vector of the basis.
  static Matrix UnitX() { return Unit(0); }
  /// The second vector of the basis.
  static Matrix UnitY() { return Unit(1); }
  /// The third vector of the basis.
  static Matrix UnitZ() { return Unit(2); }

  /// The same matrix as one of Eigen.
  template <int r, int c, int options, int most_rows, int most_columns>
    requires(detail::may_be<Matrix, r, c>)
  operator Eigen::Matrix<S, r, c, options, most_rows, most_columns>() const {
    Eigen::Matrix<S, r, c, options, most_rows, most_columns> m;
    m.resize(rows(), cols());
    for (Index j = 0; j < cols(); ++j)
      for (Index i = 0; i < rows(); ++i) m(i, j) = (*this)(i, j);
    return m;
  }

 private:
  S& entry_at(Index k) { return data()[k]; }
  template <class B>
  void take(B const& given) {
    decltype(auto) b = detail::evaluated(given);
    this->set_size(b.rows(), b.cols());
    for (Index j = 0; j < cols(); ++j)
      for (Index i = 0; i < rows(); ++i) (*this)(i, j) = b(i, j);
  }
};

/// The cross product of 3-space.
template <MatrixLike A, MatrixLike B>
auto cross(A const& v, B const& w) {
  using T = std::decay_t<decltype(v[0] * w[0])>;
  return Matrix<T, 3, 1>(v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]);
}

}  // namespace actio
