// G |x R^n: a group G of n by n matrices together with the translations of the space it acts on, x -> A
// x + t, as matrices ((A, t), (0, 1)).
//
// SO(n) |x R^n is SE(n); GL(n) |x R^n is the affine group. Every operation on A is that of G, so its
// structure, accuracy and refusals are the same.
#pragma once

#include "actio/groups/group.hpp"

namespace actio {

/// \f$G\ltimes\mathbb R^n\f$, n being the number of rows of G. Coordinates: those of G, then those of the
/// translation.
///
/// `SemidirectProduct<SL<3>>{}`, or `SemidirectProduct<G>{g}` of a group that carries data.
template <MatrixGroup G, int n = G::size>
  requires(n == G::size)
struct SemidirectProduct {
  [[no_unique_address]] G linear;  ///< G

  /// Whether n is known to the compiler.
  static constexpr bool fixed = n != Dynamic;
  static constexpr int size = fixed ? n + 1 : Dynamic;
  static constexpr int dim = fixed ? G::dim + n : Dynamic;
  constexpr int matrix_size() const { return linear.matrix_size() + 1; }
  constexpr int dimension() const { return linear.dimension() + linear.matrix_size(); }
  template <class S>
  using Matrix = actio::Matrix<S, size, size>;
  template <class S>
  using Vector = actio::Matrix<S, dim, 1>;
  /// A translation.
  template <class S>
  using Shift = actio::Matrix<S, n, 1>;

  template <MatrixLike V>
  auto hat(V const& v) const {
    using S = typename V::Scalar;
    return with_last_row<S>(linear.hat(head<S>(v)), tail<S>(v), S(0));
  }
  template <MatrixLike M>
  auto vee(M const& a) const {
    using S = typename M::Scalar;
    return stacked<S>(linear.vee(matrix<S>(a)), shift<S>(a));
  }
  template <class S>
  Matrix<S> inverse(Matrix<S> const& a) const {
    Storage<G, S> const back = primitive::inverse(linear, matrix<S>(a));
    return with_last_row<S>(back, -(back * shift<S>(a)), S(1));
  }
  /// \f$(\rho, \tfrac12(1+\rho)\,t)\f$ with \f$\rho\f$ the retraction of G. Where that is Cayley's transform,
  /// so is this.
  template <class S>
  Matrix<S> retract(Vector<S> const& v) const {
    Storage<G, S> const a = primitive::retract(linear, head<S>(v));
    Shift<S> const t = tail<S>(v);
    return with_last_row<S>(a, (t + a * t) / S(2), S(1));
  }
  /// \f$(e^{\hat v}, \mathrm{iex}(\hat v)\,t)\f$.
  template <Real S>
  Matrix<S> exp(Vector<S> const& v) const {
    Coordinates<G, S> const w = head<S>(v);
    return with_last_row<S>(primitive::exp(linear, w), drift<S>(w) * tail<S>(v), S(1));
  }
  /// @throws OutsideDomain  where G refuses, and where the last row is not (0, 1)
  template <Real S>
  Vector<S> log(Matrix<S> const& a) const {
    require_last_row(a, "log", 1e-8);
    Coordinates<G, S> const w = primitive::log_of<G, S>(linear, matrix<S>(a));
    return stacked<S>(w, solve_linear(drift<S>(w), shift<S>(a), "log"));
  }
  /// @throws OutsideDomain  where G refuses, and where the last row is not even near (0, 1)
  template <Real S>
  Matrix<S> restore(Matrix<S> const& a) const {
    require_last_row(a, "restore", 0.1);
    return with_last_row<S>(primitive::restore(linear, matrix<S>(a)), shift<S>(a), S(1));
  }

  // The parts of x -> A x + t and of its velocity, and what they make up.

  /// A.
  template <class S, MatrixLike M>
  Storage<G, S> matrix(M const& a) const {
    return a.topLeftCorner(linear.matrix_size(), linear.matrix_size());
  }
  /// t.
  template <class S, MatrixLike M>
  Shift<S> shift(M const& a) const { return a.col(linear.matrix_size()).head(linear.matrix_size()); }
  /// The coordinates of G.
  template <class S, MatrixLike V>
  Coordinates<G, S> head(V const& v) const { return v.head(linear.dimension()); }
  /// Those of the translation.
  template <class S, MatrixLike V>
  Shift<S> tail(V const& v) const { return v.tail(linear.matrix_size()); }
  /// The matrix ((A, t), (0, corner)).
  template <class S>
  Matrix<S> with_last_row(Storage<G, S> const& a, Shift<S> const& t, S const& corner) const {
    int const rows = linear.matrix_size();
    Matrix<S> at = Matrix<S>::Zero(rows + 1, rows + 1);
    at.topLeftCorner(rows, rows) = a;
    at.col(rows).head(rows) = t;
    at(rows, rows) = corner;
    return at;
  }
  /// Coordinates of G, then those of the translation.
  template <class S>
  Vector<S> stacked(Coordinates<G, S> const& v, Shift<S> const& t) const {
    Vector<S> vt(dimension());
    vt << v, t;
    return vt;
  }

 private:
  template <class S>
  Storage<G, S> drift(Coordinates<G, S> const& w) const { return iex(Storage<G, S>(linear.hat(w))); }
  template <class S>
  void require_last_row(Matrix<S> const& a, char const* where, double bound) const {
    int const rows = linear.matrix_size();
    double distance = std::abs(to_double(a(rows, rows)) - 1);
    for (int j = 0; j < rows; ++j) distance += std::abs(to_double(a(rows, j)));
    if (!(distance <= bound))
      throw OutsideDomain(where, "the last row (0, 1) is needed; sum of moduli of the differences", distance,
                          bound);
  }
};

}  // namespace actio
