// The numbers of a matrix or of a view of one: where each is, their sums, norms and largest ones.
#pragma once

#include <cmath>
#include <concepts>

#include "actio/matrices/matrix_like.hpp"

namespace actio::detail {

/// What a matrix and a view of one have in common that needs their numbers alone: M is either.
template <class M, class S, int R, int C>
struct MatrixNumbers {
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
    S const largest = size() > 0 ? self().cwiseAbs().maxCoeff() : S(0);
    if (!(S(0) < largest) || !(largest - largest == S(0))) return largest;  // zero, an infinity or no number
    return PlainObject(self() / largest).norm() * largest;
  }
  PlainObject stableNormalized() const {
    S const length = stableNorm();
    return S(0) < length ? PlainObject(*this / length) : eval();
  }
  PlainObject normalized() const { return self() / norm(); }
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

  /// Whether no number is larger than a bound.
  bool isZero(S const& bound = S(0)) const {
    bool zero = true;
    over([&](S const& x) { zero = zero && x <= bound && -bound <= x; });
    return zero;
  }

 private:
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
};

}  // namespace actio::detail
