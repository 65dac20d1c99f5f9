// SE(n): rigid motions of n-space, as matrices ((R, t), (0, 1)).
//
// Coordinates: the rotation's first, then the translation's. Not compact, not unimodular in its coadjoint
// orbits' shape: a lost star or a wrong side shows here, where SO(n) would let it pass.
#pragma once

#include "actio/groups/rotations.hpp"

namespace actio {

/// SE(n), n = 2 or 3: turns and shifts of the plane or of space, as matrices with n + 1 rows. Coordinates of
/// a velocity are those of the turn, one number or three, and then the n of the shift.
///
/// \snippet numbers.cpp motions
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
    v << Rotations::vee(Matrix<S, n, n>(a.template topLeftCorner<n, n>())),
        Matrix<S, n, 1>(a.template topRightCorner<n, 1>());
    return v;
  }
  template <class S>
  static Matrix<S, n + 1, n + 1> inverse(Matrix<S, n + 1, n + 1> const& a) {
    Matrix<S, n, n> const back = a.template topLeftCorner<n, n>().transpose();
    return assemble<S>(back, -(back * a.template topRightCorner<n, 1>()));
  }

  /// \f$\mathrm{Ad}_{(R,t)}(\omega, v) = (R\omega,\ Rv + t\times R\omega)\f$.
  template <class S>
    requires(n == 3)
  static Matrix<S, 6, 1> Ad(Matrix<S, 4, 4> const& a, Matrix<S, 6, 1> const& v) {
    Matrix<S, 3, 3> const rotation = a.template topLeftCorner<3, 3>();
    Matrix<S, 3, 1> const shift = a.template topRightCorner<3, 1>(), turn = rotation * v.template head<3>();
    Matrix<S, 6, 1> out;
    out << turn, Matrix<S, 3, 1>(rotation * v.template tail<3>() + cross(shift, turn));
    return out;
  }
  /// \f$\mathrm{Ad}^*_{(R,t)}(\pi, p) = (R^T(\pi - t\times p),\ R^Tp)\f$.
  template <class S>
    requires(n == 3)
  static Matrix<S, 6, 1> Ad_star(Matrix<S, 4, 4> const& a, Matrix<S, 6, 1> const& mu) {
    Matrix<S, 3, 3> const back = a.template topLeftCorner<3, 3>().transpose();
    Matrix<S, 3, 1> const shift = a.template topRightCorner<3, 1>(), force = mu.template tail<3>(),
                          moment = mu.template head<3>();
    Matrix<S, 6, 1> out;
    out << Matrix<S, 3, 1>(back * (moment - cross(shift, force))), Matrix<S, 3, 1>(back * force);
    return out;
  }
  template <class S>
    requires(n == 3)
  static Matrix<S, 6, 1> bracket(Matrix<S, 6, 1> const& v, Matrix<S, 6, 1> const& w) {
    Matrix<S, 3, 1> const a = v.template head<3>(), b = w.template head<3>(), s = v.template tail<3>(),
                          t = w.template tail<3>();
    Matrix<S, 6, 1> out;
    out << cross(a, b), Matrix<S, 3, 1>(cross(a, t) - cross(b, s));
    return out;
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
    v << turn, Matrix<S, n, 1>(inverse_drift(turn) * shift);
    return v;
  }
  template <Real S>
  static Matrix<S, n + 1, n + 1> restore(Matrix<S, n + 1, n + 1> const& a) {
    return assemble<S>(Rotations::restore(Matrix<S, n, n>(a.template topLeftCorner<n, n>())),
                       a.template topRightCorner<n, 1>());
  }

 private:
  template <class S>
  static Matrix<S, n + 1, n + 1> assemble(Matrix<S, n, n> const& rotation, Matrix<S, n, 1> const& shift) {
    Matrix<S, n + 1, n + 1> a = Matrix<S, n + 1, n + 1>::Identity();
    a.template topLeftCorner<n, n>() = rotation;
    a.template topRightCorner<n, 1>() = shift;
    return a;
  }
  /// \f$\mathrm{iex}(\hat\omega) = 1 + c_2\hat\omega + c_3\hat\omega^2\f$: how far a unit of velocity carries
  /// while the frame turns.
  template <class S>
  static Matrix<S, n, n> drift(Matrix<S, turns, 1> const& turn) {
    S const square = turn.squaredNorm();
    return Rotations::turn_polynomial(turn, S(1), stumpff<2>(square), stumpff<3>(square));
  }
  /// \f$\mathrm{iex}(\hat\omega)^{-1} = 1 - \tfrac12\hat\omega + b(|\omega|^2)\,\hat\omega^2\f$ with \ref
  /// half_cotangent.
  template <class S>
  static Matrix<S, n, n> inverse_drift(Matrix<S, turns, 1> const& turn) {
    return Rotations::turn_polynomial(turn, S(1), S(ratio<S>(-1, 2)), half_cotangent(S(turn.squaredNorm())));
  }
};

}  // namespace actio
