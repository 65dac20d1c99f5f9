// Rods and shells with a director: bodies of one or two dimensions in space whose points carry a vector
// (chapters 7 and 10 of the thesis).
//
// The fibre is R^6: the position r in the first three components, the director d in the last three. The
// constraint ties the director down; its multipliers are the reactions that keep it so.
#pragma once

#include "actio/constraints/augmented.hpp"
#include "actio/forms/metric.hpp"

namespace actio {

/// The vectors that a strain energy may depend on, as columns:
/// \f$r_{,1},\dots,r_{,n},\ d,\ d_{,1},\dots,d_{,n}\f$.
template <class S, int n>
Matrix<S, 3, 2 * n + 1> director_frame(Jet<S, n, 6> const& j) {
  Matrix<S, 3, 2 * n + 1> frame;
  for (int i = 0; i < n; ++i) {
    frame.col(i) = j.v.col(i + 1).template head<3>();
    frame.col(n + 1 + i) = j.v.col(i + 1).template tail<3>();
  }
  frame.col(n) = j.y.template tail<3>();
  return frame;
}

/// The density \f$\tfrac12\rho|\dot r|^2 + \tfrac12\iota|\dot d|^2 - W\f$ of a rod (n = 1) or a shell (n = 2)
/// with a director.
///
/// \implements{claim_10_0_rods_and_shells}
/// @tparam Energy  W, a callable on the point of the body and the matrix of scalar products of
///                 \ref director_frame: such an energy is invariant under rotations of space
template <class S, class Energy>
struct DirectedBody {
  S rho;     ///< mass per length of a rod, per area of a shell
  S iota;    ///< inertia of the director: mass times the square of half the thickness, per length or area
  Energy W;  ///< strain energy per length or area

  /// Kinetic energy minus strain energy.
  template <class T, int n>
  T operator()(Jet<T, n, 6> const& j) const {
    auto const frame = director_frame(j);
    T kinetic(0);
    for (int a = 0; a < 3; ++a)
      kinetic += j.v(a, 0) * j.v(a, 0) * T(Base<T>(rho)) + j.v(a + 3, 0) * j.v(a + 3, 0) * T(Base<T>(iota));
    return kinetic / T(2) - W(j.particle(), Matrix<T, 2 * n + 1, 2 * n + 1>(frame.transpose() * frame));
  }
};

/// The constraint \f$\tfrac12(|d|^2 - 1) = 0\f$ of a director of fixed length.
struct UnitDirector {
  static constexpr int components = 1;  ///< one multiplier
  /// Half of the excess of the squared length.
  template <class S, int n>
  Matrix<S, 1, 1> operator()(Jet<S, n, 6> const& j) const {
    Matrix<S, 3, 1> const d = j.y.template tail<3>();
    Matrix<S, 1, 1> value;
    value[0] = (inner(Kronecker<3>{}, d, d) - S(1)) / S(2);
    return value;
  }
};

/// The constraint \f$d\cdot r_{,i} = 0,\ \tfrac12(|d|^2 - 1) = 0\f$ of a director that is the unit normal: no
/// shear (Kirchhoff and Love).
template <int n>
struct NormalDirector {
  static constexpr int components = n + 1;  ///< the shear forces, and one for the length
  /// The products with the tangents, and half of the excess of the squared length.
  template <class S>
  Matrix<S, n + 1, 1> operator()(Jet<S, n, 6> const& j) const {
    Matrix<S, 3, 1> const d = j.y.template tail<3>();
    Matrix<S, n + 1, 1> value;
    for (int i = 0; i < n; ++i)
      value[i] = inner(Kronecker<3>{}, d, Matrix<S, 3, 1>(j.v.col(i + 1).template head<3>()));
    value[n] = (inner(Kronecker<3>{}, d, d) - S(1)) / S(2);
    return value;
  }
};

}  // namespace actio
