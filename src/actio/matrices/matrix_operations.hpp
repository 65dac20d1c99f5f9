// The operations that a matrix and a view of one have in common: number by number, sums, differences,
// products.
#pragma once

#include <concepts>
#include <ostream>
#include <type_traits>
#include <utility>

#include "actio/matrices/matrix_entries.hpp"
#include "actio/matrices/matrix_parts.hpp"

namespace actio::detail {

/// What a matrix and a view of one have in common: M is either.
template <class M, class S, int R, int C>
struct MatrixOperations : MatrixParts<M, S, R, C> {
  using Numbers = MatrixNumbers<M, S, R, C>;
  using Numbers::at, Numbers::self, Numbers::size;
  using typename Numbers::PlainObject;

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
