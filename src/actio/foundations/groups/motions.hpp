// SE(n): rigid motions of n-space, as matrices ((R, t), (0, 1)).
//
// Coordinates: the rotation's first, then the translation's. Not compact, not unimodular in its coadjoint orbits' shape: a lost star or
// a wrong side shows here, where SO(n) would let it pass.
#pragma once

#include "actio/foundations/groups/rotations.hpp"

namespace actio {

/// SE(n), n = 2 or 3.
template <int n>
struct SE : Matrices<n + 1, n*(n - 1) / 2 + n> {
  using Rotations = SO<n>;
  static constexpr int turns = Rotations::dim;
  static constexpr int dim = turns + n;

  template <MatrixLike V>
  static auto hat(V const& v) {
    using S = typename V::Scalar;
    Matrix<S, n + 1, n + 1> a = Matrix<S, n + 1, n + 1>::Zero();
    a.template topLeftCorner<n, n>() = Rotations::hat(v.template head<turns>());
    a.template topRightCorner<n, 1>() = v.template tail<n>();
    return a;
  }
  template <MatrixLike M>
  static auto vee(M const& a) {
    using S = typename M::Scalar;
    Matrix<S, dim, 1> v;
    v << Rotations::vee(Matrix<S, n, n>(a.template topLeftCorner<n, n>())), Matrix<S, n, 1>(a.template topRightCorner<n, 1>());
    return v;
  }
  template <class S>
  static Matrix<S, n + 1, n + 1> inverse(Matrix<S, n + 1, n + 1> const& a) {
    Matrix<S, n, n> const back = a.template topLeftCorner<n, n>().transpose();
    return assemble<S>(back, -(back * a.template topRightCorner<n, 1>()));
  }

  template <Real S>
  static Matrix<S, n + 1, n + 1> exp(Matrix<S, dim, 1> const& v) {
    Matrix<S, turns, 1> const turn = v.template head<turns>();
    return assemble<S>(Rotations::exp(turn), drift(turn) * v.template tail<n>());
  }
  /// @throws OutsideDomain  at a rotation by pi
  template <Real S>
  static Matrix<S, dim, 1> log(Matrix<S, n + 1, n + 1> const& a) {
    Matrix<S, turns, 1> const turn = Rotations::log(Matrix<S, n, n>(a.template topLeftCorner<n, n>()));
    Matrix<S, n, 1> const shift = a.template topRightCorner<n, 1>();
    Matrix<S, dim, 1> v;
    v << turn, Matrix<S, n, 1>(solve_linear(drift(turn), shift, "log"));
    return v;
  }
  template <Real S>
  static Matrix<S, n + 1, n + 1> restore(Matrix<S, n + 1, n + 1> const& a) {
    return assemble<S>(Rotations::restore(Matrix<S, n, n>(a.template topLeftCorner<n, n>())), a.template topRightCorner<n, 1>());
  }

 private:
  template <class S>
  static Matrix<S, n + 1, n + 1> assemble(Matrix<S, n, n> const& rotation, Matrix<S, n, 1> const& shift) {
    Matrix<S, n + 1, n + 1> a = Matrix<S, n + 1, n + 1>::Identity();
    a.template topLeftCorner<n, n>() = rotation;
    a.template topRightCorner<n, 1>() = shift;
    return a;
  }
  /// \f$\mathrm{iex}(\hat\omega) = 1 + c_2\hat\omega + c_3\hat\omega^2\f$: how far a unit of velocity carries while the frame turns.
  template <class S>
  static Matrix<S, n, n> drift(Matrix<S, turns, 1> const& turn) {
    S const square = turn.squaredNorm();
    auto const a = Rotations::hat(turn);
    Matrix<S, n, n> m = a * stumpff<2>(square) + a * a * stumpff<3>(square);
    m.diagonal().array() += S(1);
    return m;
  }
};

}  // namespace actio
