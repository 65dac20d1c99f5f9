// The operations that a matrix and a view of one have in common: arithmetic, products, parts, norms.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <ostream>
#include <type_traits>
#include <utility>

#include "actio/numbers/matrix_entries.hpp"

namespace actio::detail {

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
  auto cast() const { return unaryExpr([](S const& x) -> T { return static_cast<T>(x); }); }
  template <class B, class F>
  auto binaryExpr(B const& b, F const& f) const {
    constexpr int rows = known(R, rows_of<B>), columns = known(C, columns_of<B>);
    Matrix<std::decay_t<decltype(f(at(0, 0), b(0, 0)))>, rows, columns> m(self().rows(), self().cols(),
                                                                          Sized{});
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
    return NumbersOf<std::remove_reference_t<decltype(*m.data())>>{m.data(), m.rows(), m.cols(),
                                                                   m.rowStride(), m.colStride()};
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
// A part of a matrix that can be changed, of one that cannot, and of a temporary one, of which it is a copy
// unless that is a view itself. In each the matrix is m; the part has `part_rows` and `part_columns` known
// when this is compiled, begins at (i0, j0) and has r0 rows and c0 columns.
#define ACTIO_PART(part_rows, part_columns, i0, j0, r0, c0, ...)                       \
  __VA_ARGS__& { return view<part_rows, part_columns>(self(), i0, j0, r0, c0); }       \
  __VA_ARGS__ const& { return view<part_rows, part_columns>(self(), i0, j0, r0, c0); } \
  __VA_ARGS__&& {                                                                      \
    if constexpr (std::same_as<M, PlainObject>)                                        \
      return view<part_rows, part_columns>(self(), i0, j0, r0, c0).eval();             \
    else                                                                               \
      return view<part_rows, part_columns>(self(), i0, j0, r0, c0);                    \
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
#define ACTIO_PART(length, k0, n0, ...)                                                                   \
  __VA_ARGS__& {                                                                                          \
    return view < lying ? 1 : length,                                                                     \
           lying ? length : 1 > (self(), lying ? 0 : k0, lying ? k0 : 0, lying ? 1 : n0, lying ? n0 : 1); \
  }                                                                                                       \
  __VA_ARGS__ const& {                                                                                    \
    return view < lying ? 1 : length,                                                                     \
           lying ? length : 1 > (self(), lying ? 0 : k0, lying ? k0 : 0, lying ? 1 : n0, lying ? n0 : 1); \
  }                                                                                                       \
  __VA_ARGS__&& {                                                                                         \
    auto part = view < lying ? 1 : length,                                                                \
         lying ? length : 1 > (self(), lying ? 0 : k0, lying ? k0 : 0, lying ? 1 : n0, lying ? n0 : 1);   \
    if constexpr (std::same_as<M, PlainObject>)                                                           \
      return part.eval();                                                                                 \
    else                                                                                                  \
      return part;                                                                                        \
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
  friend auto operator*(B const& c, M const& a) { return a.unaryExpr([&](S const& x) { return c * x; }); }
  template <class B>
    requires(!MatrixLike<B>)
  friend auto operator/(M const& a, B const& c) { return a.unaryExpr([&](S const& x) { return x / c; }); }
  template <class E>
  friend auto operator+(Eigen::MatrixBase<E> const& a, M const& b) { return own(a) + b; }
  template <class E>
  friend auto operator-(Eigen::MatrixBase<E> const& a, M const& b) { return own(a) - b; }
  template <class E>
  friend auto operator*(Eigen::MatrixBase<E> const& a, M const& b) { return own(a) * b; }
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
    return MatrixView<Entry, r, c>(m.data() + i * m.rowStride() + j * m.colStride(), r0, c0, m.rowStride(),
                                   m.colStride());
  }
  template <class Whole>
  static auto diagonal_of(Whole& m) {
    using Entry = std::remove_reference_t<decltype(*m.data())>;
    return MatrixView<Entry, R, 1>(m.data(), std::min(m.rows(), m.cols()), 1, m.rowStride() + m.colStride(),
                                   m.colStride());
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

}  // namespace actio::detail
