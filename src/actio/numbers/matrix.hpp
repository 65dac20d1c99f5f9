// Matrices and vectors over any numbers: small, eager, plain loops.
//
// An operation is carried out where it is written, and its result is a matrix: no expression waits for later, nothing is aliased, and `auto` holds
// what it seems to. Names are those of Eigen, so that a formula written for Eigen's vectors reads and works the same; Eigen's own matrices go in
// and come out without a word. Columns lie one after the other, as Eigen's do.
//
// A part of a matrix (a column, a block, the transpose) is a view of its entries: it can be read and, where the matrix can be changed, written.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <concepts>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <ostream>
#include <type_traits>
#include <utility>
#include <vector>

namespace actio {

/// Rows, columns and their number.
using Index = std::ptrdiff_t;
/// A size that is known when the program runs.
inline constexpr int Dynamic = -1;

template <class S, int R = Dynamic, int C = Dynamic>
struct Matrix;
/// A column of n numbers.
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
void add_product(S& z, S const& x, S const& y) {
  z += x * y;
}

namespace detail {

/// Whether M is a matrix of this file, or a view of one.
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
/// A matrix itself; an expression of Eigen as a matrix.
template <class B>
decltype(auto) evaluated(B const& b) {
  if constexpr (is_own_matrix<B>)
    return (b);
  else
    return b.eval();
}

/// Entries of a matrix of fixed size.
template <class S, int R, int C>
struct MatrixEntries {
  S entry[R * C > 0 ? R * C : 1];

  static constexpr Index rows() { return R; }
  static constexpr Index cols() { return C; }
  S* data() { return entry; }
  S const* data() const { return entry; }
  void set_size(Index, Index) {}
};
/// Entries of a matrix whose size is known when the program runs.
template <class S, int R, int C>
  requires(R == Dynamic || C == Dynamic)
struct MatrixEntries<S, R, C> {
  std::vector<S> entry;
  Index row_count = R == Dynamic ? 0 : R, column_count = C == Dynamic ? 0 : C;

  Index rows() const { return row_count; }
  Index cols() const { return column_count; }
  S* data() { return entry.data(); }
  S const* data() const { return entry.data(); }
  void set_size(Index r, Index c) {
    row_count = r, column_count = c;
    entry.resize(static_cast<std::size_t>(r * c));
  }
};

/// Fills a matrix row by row: `m << a, b, c, d`. What follows may be numbers, or matrices that stand side by side.
template <class M>
struct MatrixFiller {
  M& matrix;
  Index row = 0, column = 0, height = 1;

  template <class T>
  MatrixFiller& operator,(T const& x) {
    if (column == matrix.cols()) row += height, column = 0;
    if constexpr (MatrixLike<T>) {
      for (Index i = 0; i < x.rows(); ++i)
        for (Index j = 0; j < x.cols(); ++j) matrix(row + i, column + j) = x(i, j);
      if (x.cols() > 0) height = x.rows(), column += x.cols();
    } else {
      matrix(row, column) = x;
      height = 1, ++column;
    }
    return *this;
  }
  /// The matrix.
  M& finished() { return matrix; }
};

/// The numbers of a matrix one by one, for `m.diagonal().array() += c`.
template <class S>
struct NumbersOf {
  S* first;
  Index rows, columns, inner, outer;

  template <class T>
  void operator+=(T c) {
    for (Index j = 0; j < columns; ++j)
      for (Index i = 0; i < rows; ++i) first[i * inner + j * outer] += c;
  }
  template <class T>
  void operator-=(T c) {
    for (Index j = 0; j < columns; ++j)
      for (Index i = 0; i < rows; ++i) first[i * inner + j * outer] -= c;
  }
};

/// What a matrix and a view of one have in common: M is either.
template <class M, class S, int R, int C>
struct MatrixOperations {
  using Scalar = S;
  using PlainObject = Matrix<S, R, C>;
  static constexpr int RowsAtCompileTime = R, ColsAtCompileTime = C;
  static constexpr int SizeAtCompileTime = R == Dynamic || C == Dynamic ? Dynamic : R * C;
  static constexpr bool IsVectorAtCompileTime = R == 1 || C == 1;
  /// A row.
  static constexpr bool lying = R == 1 && C != 1;

  M& self() { return static_cast<M&>(*this); }
  M const& self() const { return static_cast<M const&>(*this); }
  auto const& at(Index i, Index j) const { return self()(i, j); }

  Index rows() const { return self().rows(); }
  Index cols() const { return self().cols(); }
  Index size() const { return self().rows() * self().cols(); }
  Index innerSize() const { return self().rows(); }
  /// A copy.
  PlainObject eval() const { return PlainObject(self()); }
  M& noalias() { return self(); }
  M& derived() { return self(); }
  M const& derived() const { return self(); }

  // Numbers of the k-th place: along a vector, or column by column.

  auto const& operator[](Index k) const { return R == 1 ? at(0, k) : at(k, 0); }
  decltype(auto) operator[](Index k) { return R == 1 ? self()(0, k) : self()(k, 0); }
  auto const& x() const { return (*this)[0]; }
  auto const& y() const { return (*this)[1]; }
  auto const& z() const { return (*this)[2]; }
  auto const& w() const { return (*this)[3]; }
  decltype(auto) x() { return (*this)[0]; }
  decltype(auto) y() { return (*this)[1]; }
  decltype(auto) z() { return (*this)[2]; }
  decltype(auto) w() { return (*this)[3]; }
  S const& value() const { return at(0, 0); }

  // Sums and the like.

  S sum() const {
    S s(0);
    over([&](S const& x) { s += x; });
    return s;
  }
  S prod() const {
    S s(1);
    over([&](S const& x) { s *= x; });
    return s;
  }
  S trace() const {
    S s(0);
    for (Index i = 0; i < self().rows(); ++i) s += at(i, i);
    return s;
  }
  S squaredNorm() const {
    S s(0);
    over([&](S const& x) { add_product(s, x, x); });
    return s;
  }
  S norm() const {
    using std::sqrt;
    return sqrt(squaredNorm());
  }
  /// The norm, where squares of the numbers are too large or too small.
  S stableNorm() const {
    S const largest = size() > 0 ? cwiseAbs().maxCoeff() : S(0);
    if (!(S(0) < largest) || !(largest - largest == S(0))) return largest;  // zero, an infinity or no number
    return PlainObject(*this / largest).norm() * largest;
  }
  PlainObject stableNormalized() const {
    S const length = stableNorm();
    return S(0) < length ? PlainObject(*this / length) : eval();
  }
  PlainObject normalized() const { return *this / norm(); }
  void normalize() { self() /= norm(); }
  S maxCoeff() const {
    S m = at(0, 0);
    over([&](S const& x) {
      if (m < x) m = x;
    });
    return m;
  }
  S minCoeff() const {
    S m = at(0, 0);
    over([&](S const& x) {
      if (x < m) m = x;
    });
    return m;
  }
  template <class B>
  auto dot(B const& b) const {
    decltype(S() * typename B::Scalar()) s(0);
    for (Index k = 0; k < size(); ++k)
      if constexpr (std::same_as<S, typename B::Scalar>)
        add_product(s, (*this)[k], entry_of(b, k));
      else
        s += (*this)[k] * entry_of(b, k);
    return s;
  }
  template <class B>
  auto cross(B const& b) const {
    auto const& a = *this;
    using T = decltype(S() * typename B::Scalar());
    return Matrix<T, 3, 1>(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
  }
  bool allFinite() const {
    bool finite = true;
    over([&](S const& x) { finite = finite && is_finite(x); });
    return finite;
  }

  /// Whether no number is larger than a bound.
  bool isZero(S const& bound = S(0)) const {
    bool zero = true;
    over([&](S const& x) { zero = zero && x <= bound && -bound <= x; });
    return zero;
  }

  // Number by number.

  template <class F>
  auto unaryExpr(F const& f) const {
    Matrix<std::decay_t<decltype(f(at(0, 0)))>, R, C> m(self().rows(), self().cols(), Sized{});
    for (Index j = 0; j < m.cols(); ++j)
      for (Index i = 0; i < m.rows(); ++i) m(i, j) = f(at(i, j));
    return m;
  }
  template <class T>
  auto cast() const {
    return unaryExpr([](S const& x) -> T { return static_cast<T>(x); });
  }
  template <class B, class F>
  auto binaryExpr(B const& b, F const& f) const {
    constexpr int rows = known(R, rows_of<B>), columns = known(C, columns_of<B>);
    Matrix<std::decay_t<decltype(f(at(0, 0), b(0, 0)))>, rows, columns> m(self().rows(), self().cols(), Sized{});
    for (Index j = 0; j < m.cols(); ++j)
      for (Index i = 0; i < m.rows(); ++i) m(i, j) = f(at(i, j), b(i, j));
    return m;
  }
  template <class B>
  auto cwiseProduct(B const& b) const {
    return binaryExpr(b, [](auto const& x, auto const& y) { return x * y; });
  }
  template <class B>
  auto cwiseQuotient(B const& b) const {
    return binaryExpr(b, [](auto const& x, auto const& y) { return x / y; });
  }
  template <class B>
  auto cwiseMax(B const& b) const {
    return binaryExpr(b, [](S const& x, S const& y) { return x < y ? y : x; });
  }
  PlainObject cwiseAbs() const {
    return unaryExpr([](S const& x) { return x < S(0) ? S(-x) : x; });
  }
  PlainObject cwiseAbs2() const { return cwiseProduct(self()); }
  PlainObject cwiseInverse() const {
    return unaryExpr([](S const& x) { return S(S(1) / x); });
  }
  PlainObject cwiseSqrt() const {
    return unaryExpr([](S const& x) {
      using std::sqrt;
      return S(sqrt(x));
    });
  }
  /// The square matrix with these numbers along its diagonal.
  auto asDiagonal() const {
    constexpr int n = R == 1 ? C : R;
    Matrix<S, n, n> m = Matrix<S, n, n>::Zero(size(), size());
    for (Index i = 0; i < size(); ++i) m(i, i) = (*this)[i];
    return m;
  }
  auto array() {
    M& m = self();
    return NumbersOf<std::remove_reference_t<decltype(*m.data())>>{m.data(), m.rows(), m.cols(), m.rowStride(), m.colStride()};
  }

  // Changes in place.

  M& setZero() { return fill(S(0)); }
  M& setOnes() { return fill(S(1)); }
  M& setConstant(S const& c) { return fill(c); }
  M& fill(S const& number) {
    S const c = number;
    for (Index j = 0; j < self().cols(); ++j)
      for (Index i = 0; i < self().rows(); ++i) self()(i, j) = c;
    return self();
  }
  M& setIdentity() {
    for (Index j = 0; j < self().cols(); ++j)
      for (Index i = 0; i < self().rows(); ++i) self()(i, j) = S(i == j ? 1 : 0);
    return self();
  }
  template <MatrixLike B>
  M& operator+=(B const& b) {
    for (Index j = 0; j < self().cols(); ++j)
      for (Index i = 0; i < self().rows(); ++i) self()(i, j) += b(i, j);
    return self();
  }
  template <MatrixLike B>
  M& operator-=(B const& b) {
    for (Index j = 0; j < self().cols(); ++j)
      for (Index i = 0; i < self().rows(); ++i) self()(i, j) -= b(i, j);
    return self();
  }
  template <class T>
  M& operator*=(T const& c) {
    if constexpr (MatrixLike<T>) {
      self() = PlainObject(self() * c);
    } else {
      T const factor = c;  // which may be one of these numbers
      for (Index j = 0; j < self().cols(); ++j)
        for (Index i = 0; i < self().rows(); ++i) self()(i, j) *= factor;
    }
    return self();
  }
  template <class T>
  M& operator/=(T const& c) {
    T const divisor = c;  // which may be one of these numbers
    for (Index j = 0; j < self().cols(); ++j)
      for (Index i = 0; i < self().rows(); ++i) self()(i, j) /= divisor;
    return self();
  }
  template <class B>
  void swap(B&& b) {
    using std::swap;
    for (Index j = 0; j < self().cols(); ++j)
      for (Index i = 0; i < self().rows(); ++i) swap(self()(i, j), b(i, j));
  }
  template <class T>
  MatrixFiller<M> operator<<(T const& first) {
    MatrixFiller<M> filler{self()};
    filler, first;
    return filler;
  }

  // Parts.

  /// Rows and columns exchanged: a copy.
  auto transpose() const {
    Matrix<S, C, R> m(self().cols(), self().rows(), Sized{});
    for (Index j = 0; j < m.cols(); ++j)
      for (Index i = 0; i < m.rows(); ++i) m(i, j) = at(j, i);
    return m;
  }

/// @cond
// A part of a matrix that can be changed, of one that cannot, and of a temporary one, of which it is a copy unless that is a view itself. In each the
// matrix is m; the part has `part_rows` and `part_columns` known when this is compiled, begins at (i0, j0) and has r0 rows and c0 columns.
#define ACTIO_PART(part_rows, part_columns, i0, j0, r0, c0, ...)                      \
  __VA_ARGS__& {                                                                     \
    return view<part_rows, part_columns>(self(), i0, j0, r0, c0);                    \
  }                                                                                  \
  __VA_ARGS__ const& {                                                               \
    return view<part_rows, part_columns>(self(), i0, j0, r0, c0);                    \
  }                                                                                  \
  __VA_ARGS__&& {                                                                    \
    if constexpr (std::same_as<M, PlainObject>)                                      \
      return view<part_rows, part_columns>(self(), i0, j0, r0, c0).eval();           \
    else                                                                             \
      return view<part_rows, part_columns>(self(), i0, j0, r0, c0);                  \
  }
  ACTIO_PART(R, 1, 0, j, rows(), 1, auto col(Index j))
  ACTIO_PART(1, C, i, 0, 1, cols(), auto row(Index i))
  ACTIO_PART(Dynamic, Dynamic, i, j, r, c, auto block(Index i, Index j, Index r, Index c))
  ACTIO_PART(r, c, i, j, r, c, template <int r, int c> auto block(Index i, Index j))
  ACTIO_PART(Dynamic, C, 0, 0, r, cols(), auto topRows(Index r))
  ACTIO_PART(r, C, 0, 0, r, cols(), template <int r> auto topRows())
  ACTIO_PART(Dynamic, C, i, 0, r, cols(), auto middleRows(Index i, Index r))
  ACTIO_PART(r, C, i, 0, r, cols(), template <int r> auto middleRows(Index i))
  ACTIO_PART(Dynamic, C, rows() - r, 0, r, cols(), auto bottomRows(Index r))
  ACTIO_PART(r, C, rows() - r, 0, r, cols(), template <int r> auto bottomRows())
  ACTIO_PART(R, Dynamic, 0, 0, rows(), c, auto leftCols(Index c))
  ACTIO_PART(R, c, 0, 0, rows(), c, template <int c> auto leftCols())
  ACTIO_PART(R, Dynamic, 0, j, rows(), c, auto middleCols(Index j, Index c))
  ACTIO_PART(R, c, 0, j, rows(), c, template <int c> auto middleCols(Index j))
  ACTIO_PART(R, Dynamic, 0, cols() - c, rows(), c, auto rightCols(Index c))
  ACTIO_PART(R, c, 0, cols() - c, rows(), c, template <int c> auto rightCols())
  ACTIO_PART(Dynamic, Dynamic, 0, 0, r, c, auto topLeftCorner(Index r, Index c))
  ACTIO_PART(r, c, 0, 0, r, c, template <int r, int c> auto topLeftCorner())
  ACTIO_PART(Dynamic, Dynamic, 0, cols() - c, r, c, auto topRightCorner(Index r, Index c))
  ACTIO_PART(r, c, 0, cols() - c, r, c, template <int r, int c> auto topRightCorner())
  ACTIO_PART(Dynamic, Dynamic, rows() - r, 0, r, c, auto bottomLeftCorner(Index r, Index c))
  ACTIO_PART(r, c, rows() - r, 0, r, c, template <int r, int c> auto bottomLeftCorner())
  ACTIO_PART(Dynamic, Dynamic, rows() - r, cols() - c, r, c, auto bottomRightCorner(Index r, Index c))
  ACTIO_PART(r, c, rows() - r, cols() - c, r, c, template <int r, int c> auto bottomRightCorner())
#undef ACTIO_PART
// The same along a vector, from place k0 on.
#define ACTIO_PART(length, k0, n0, ...)                                                                                                      \
  __VA_ARGS__& {                                                                                                                            \
    return view<lying ? 1 : length, lying ? length : 1>(self(), lying ? 0 : k0, lying ? k0 : 0, lying ? 1 : n0, lying ? n0 : 1);            \
  }                                                                                                                                         \
  __VA_ARGS__ const& {                                                                                                                      \
    return view<lying ? 1 : length, lying ? length : 1>(self(), lying ? 0 : k0, lying ? k0 : 0, lying ? 1 : n0, lying ? n0 : 1);            \
  }                                                                                                                                         \
  __VA_ARGS__&& {                                                                                                                           \
    auto part = view<lying ? 1 : length, lying ? length : 1>(self(), lying ? 0 : k0, lying ? k0 : 0, lying ? 1 : n0, lying ? n0 : 1);       \
    if constexpr (std::same_as<M, PlainObject>)                                                                                             \
      return part.eval();                                                                                                                   \
    else                                                                                                                                    \
      return part;                                                                                                                          \
  }
  ACTIO_PART(Dynamic, k, n, auto segment(Index k, Index n))
  ACTIO_PART(n, k, n, template <int n> auto segment(Index k))
  ACTIO_PART(Dynamic, 0, n, auto head(Index n))
  ACTIO_PART(n, 0, n, template <int n> auto head())
  ACTIO_PART(Dynamic, size() - n, n, auto tail(Index n))
  ACTIO_PART(n, size() - n, n, template <int n> auto tail())
#undef ACTIO_PART
/// @endcond
  auto diagonal() & { return diagonal_of(self()); }
  auto diagonal() const& { return diagonal_of(self()); }
  auto diagonal() && { return diagonal_of(self()).eval(); }
  /// All numbers as one column, column by column.
  auto reshaped() const {
    Matrix<S, SizeAtCompileTime, 1> v(size(), 1, Sized{});
    Index k = 0;
    for (Index j = 0; j < self().cols(); ++j)
      for (Index i = 0; i < self().rows(); ++i) v[k++] = at(i, j);
    return v;
  }

  /// The numbers, column by column, as r rows and c columns.
  auto reshaped(Index r, Index c) const {
    Matrix<S> m(r, c, Sized{});
    for (Index k = 0; k < size(); ++k) m.data()[k] = at(k % self().rows(), k / self().rows());
    return m;
  }

  // Sums, differences and products; the other side may be Eigen's.

  template <MatrixLike B>
  friend auto operator+(M const& a, B const& b) {
    return a.binaryExpr(b, [](auto const& x, auto const& y) { return x + y; });
  }
  template <MatrixLike B>
  friend auto operator-(M const& a, B const& b) {
    return a.binaryExpr(b, [](auto const& x, auto const& y) { return x - y; });
  }
  friend PlainObject operator-(M const& a) {
    PlainObject m(a.rows(), a.cols(), Sized{});
    for (Index j = 0; j < m.cols(); ++j)
      for (Index i = 0; i < m.rows(); ++i) m(i, j) = -a(i, j);
    return m;
  }
  template <class B>
  friend auto operator*(M const& a, B const& b) {
    if constexpr (MatrixLike<B>)
      return product(a, b);
    else
      return a.unaryExpr([&](S const& x) { return x * b; });
  }
  template <class B>
    requires(!MatrixLike<B>)
  friend auto operator*(B const& c, M const& a) {
    return a.unaryExpr([&](S const& x) { return c * x; });
  }
  template <class B>
    requires(!MatrixLike<B>)
  friend auto operator/(M const& a, B const& c) {
    return a.unaryExpr([&](S const& x) { return x / c; });
  }
  template <class E>
  friend auto operator+(Eigen::MatrixBase<E> const& a, M const& b) {
    return own(a) + b;
  }
  template <class E>
  friend auto operator-(Eigen::MatrixBase<E> const& a, M const& b) {
    return own(a) - b;
  }
  template <class E>
  friend auto operator*(Eigen::MatrixBase<E> const& a, M const& b) {
    return own(a) * b;
  }
  template <MatrixLike B>
  friend bool operator==(M const& a, B const& b) {
    if (a.rows() != b.rows() || a.cols() != b.cols()) return false;
    for (Index j = 0; j < a.cols(); ++j)
      for (Index i = 0; i < a.rows(); ++i)
        if (!(a(i, j) == b(i, j))) return false;
    return true;
  }
  friend std::ostream& operator<<(std::ostream& out, M const& a) {
    for (Index i = 0; i < a.rows(); ++i)
      for (Index j = 0; j < a.cols(); ++j) out << a(i, j) << (j + 1 < a.cols() ? ' ' : '\n');
    return out;
  }

 private:
  template <int r, int c, class Whole>
  static auto view(Whole& m, Index i, Index j, Index r0, Index c0) {
    using Entry = std::remove_reference_t<decltype(*m.data())>;
    return MatrixView<Entry, r, c>(m.data() + i * m.rowStride() + j * m.colStride(), r0, c0, m.rowStride(), m.colStride());
  }
  template <class Whole>
  static auto diagonal_of(Whole& m) {
    using Entry = std::remove_reference_t<decltype(*m.data())>;
    return MatrixView<Entry, R, 1>(m.data(), std::min(m.rows(), m.cols()), 1, m.rowStride() + m.colStride(), m.colStride());
  }
  template <class F>
  void over(F const& f) const {
    for (Index j = 0; j < self().cols(); ++j)
      for (Index i = 0; i < self().rows(); ++i) f(at(i, j));
  }
  template <class B>
  static auto const& entry_of(B const& b, Index k) {
    if constexpr (B::RowsAtCompileTime == 1)
      return b(0, k);
    else
      return b(k, 0);
  }
  template <class E>
  static auto own(Eigen::MatrixBase<E> const& a) {
    return Matrix<typename E::Scalar, E::RowsAtCompileTime, E::ColsAtCompileTime>(a);
  }
  template <class B>
  static auto product(M const& a, B const& b) {
    using T = std::decay_t<decltype(a(0, 0) * b(0, 0))>;
    constexpr bool same = std::same_as<S, T> && std::same_as<typename B::Scalar, T>;
    Matrix<T, R, columns_of<B>> m(a.rows(), b.cols(), Sized{});
    for (Index j = 0; j < m.cols(); ++j)
      for (Index i = 0; i < m.rows(); ++i) {
        T sum(0);
        for (Index k = 0; k < a.cols(); ++k)
          if constexpr (same)
            add_product(sum, a(i, k), b(k, j));
          else
            sum += a(i, k) * b(k, j);
        m(i, j) = sum;
      }
    return m;
  }
};

}  // namespace detail

/// A matrix of R rows and C columns, each fixed or `Dynamic`.
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
      R == 1 ? this->set_size(1, static_cast<Index>(n)) : this->set_size(static_cast<Index>(n), C == Dynamic ? 1 : C);
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
    Index const r = static_cast<Index>(given.size()), c = r > 0 ? static_cast<Index>(given.begin()->size()) : 0;
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
    requires(!std::same_as<B, Matrix> && std::convertible_to<typename B::Scalar, S> && detail::may_be<B, R, C>)
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

  /// The number in row i and column j.
  S& operator()(Index i, Index j) { return data()[i + j * rows()]; }
  /// The number in row i and column j.
  S const& operator()(Index i, Index j) const { return data()[i + j * rows()]; }
  /// The k-th number, column by column.
  S& operator()(Index k) { return data()[k]; }
  /// The k-th number, column by column.
  S const& operator()(Index k) const { return data()[k]; }
  /// The k-th number of a vector.
  S& operator[](Index k) { return data()[k]; }
  /// The k-th number of a vector.
  S const& operator[](Index k) const { return data()[k]; }

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

/// R rows and C columns of numbers that lie elsewhere, `inner` apart down a column and `outer` apart along a row. S is constant where they may only
/// be read.
template <class S, int R, int C>
struct MatrixView : detail::MatrixOperations<MatrixView<S, R, C>, std::remove_const_t<S>, R, C> {
  /// @param inner  from one number to the next down a column
  /// @param outer  from one number to the next along a row
  MatrixView(S* first, Index rows, Index columns, Index inner, Index outer)
      : first_(first), rows_(rows), columns_(columns), inner_(inner), outer_(outer) {}
  /// The same numbers, seen twice.
  MatrixView(MatrixView const&) = default;
  /// Numbers take their places one by one; of another part of the same matrix, too.
  MatrixView& operator=(MatrixView const& b) { return assign(b); }
  /// Numbers take their places one by one.
  template <MatrixLike B>
  MatrixView& operator=(B const& b) {
    return assign(b);
  }

  /// How many rows.
  Index rows() const { return R == Dynamic ? rows_ : R; }
  /// How many columns.
  Index cols() const { return C == Dynamic ? columns_ : C; }
  /// From one number to the next down a column.
  Index rowStride() const { return inner_; }
  /// From one number to the next along a row.
  Index colStride() const { return outer_; }
  /// From one number of a vector to the next.
  Index along() const { return R == 1 ? outer_ : inner_; }
  /// The first number.
  S* data() const { return first_; }
  /// The number in row i and column j.
  S& operator()(Index i, Index j) const { return first_[i * inner_ + j * outer_]; }
  /// The k-th number of a vector.
  S& operator()(Index k) const { return first_[k * along()]; }
  /// The k-th number of a vector.
  S& operator[](Index k) const { return first_[k * along()]; }

  /// The same numbers as a matrix of Eigen.
  template <int r, int c, int options, int most_rows, int most_columns>
    requires(detail::may_be<MatrixView, r, c>)
  operator Eigen::Matrix<std::remove_const_t<S>, r, c, options, most_rows, most_columns>() const {
    return this->eval();
  }

 private:
  S* first_;
  Index rows_, columns_, inner_, outer_;

  template <class B>
  MatrixView& assign(B const& b) {
    typename B::PlainObject const copy = b;
    for (Index j = 0; j < cols(); ++j)
      for (Index i = 0; i < rows(); ++i) (*this)(i, j) = copy(i, j);
    return *this;
  }
};

/// Numbers that lie one after the other, as a matrix of R rows and C columns, column by column.
template <int R, int C, class S>
MatrixView<S, R, C> as_matrix(S* first) {
  return {first, R, C, 1, R};
}
/// Numbers that lie one after the other, as a column of n.
template <class S>
MatrixView<S, Dynamic, 1> as_vector(S* first, Index n) {
  return {first, n, 1, 1, n};
}

/// The cross product of 3-space.
template <MatrixLike A, MatrixLike B>
auto cross(A const& v, B const& w) {
  using T = std::decay_t<decltype(v[0] * w[0])>;
  return Matrix<T, 3, 1>(v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]);
}

}  // namespace actio
