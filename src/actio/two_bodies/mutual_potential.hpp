// The mutual potential of two bodies to any order, with the force and both torques.
//
// V = -G int int dm1 dm2 / |r + x2 - x1| depends on the two mass distributions by the series of the
// difference body alone, that of x2 - x1: the product of the series of the two,
//
//     T(s) = A(-s) B'(s),       B'(s) = B(R^T s) the second body seen from the first,
//     V = -G sum_k T_k D_k,     D_k = d^k (1/r),
//
// cut after total degree N. With E_c = sum_a (-1)^|a| A_a D_{a+c}, which is V's derivative by B'_c, the
// torque on the second body follows from the rotation of its series, -s x grad B'. The first body has what is
// left: V is invariant under rotations, t_1 + t_2 + r x F = 0, to rounding and not only to the order of the
// series.
#pragma once

#include "actio/numbers/square_root.hpp"
#include "actio/two_bodies/moments.hpp"
#include "actio/two_bodies/rotor_drift.hpp"

namespace actio::bodies {

/// What two bodies do to each other, seen from the first.
template <class S>
struct Interaction {
  S potential;        ///< energy
  Three<S> force;     ///< on the second body, \f$-\partial V/\partial r\f$
  Three<S> torque_1;  ///< on the first body about its centre of mass
  Three<S> torque_2;  ///< on the second body about its centre of mass
};

/// All derivatives \f$\partial^k(1/r)\f$ up to a degree, by
/// \f$|k|\,r^2D_k = -(2|k|-1)\sum_ik_ix_iD_{k-e_i} - (|k|-1)\sum_ik_i(k_i-1)D_{k-2e_i}\f$.
/// @throws NotASquare  over the rationals, where r is irrational
template <Scalar S>
Polynomial<S> derivatives_of_inverse_distance(Three<S> const& x, int degree) {
  Polynomial<S> D(degree);
  S const square = dot(x, x), inverse = S(1) / square;
  D(0, 0, 0) = S(1) / S(square_root(square));
  over_exponents(1, degree, [&](int i, int j, int l) {
    int const n = i + j + l;
    S once(0), twice(0);
    if (i > 0) once += x[0] * D(i - 1, j, l) * S(i);
    if (j > 0) once += x[1] * D(i, j - 1, l) * S(j);
    if (l > 0) once += x[2] * D(i, j, l - 1) * S(l);
    if (i > 1) twice += D(i - 2, j, l) * S(i * (i - 1));
    if (j > 1) twice += D(i, j - 2, l) * S(j * (j - 1));
    if (l > 1) twice += D(i, j, l - 2) * S(l * (l - 1));
    D(i, j, l) = -(once * S(2 * n - 1) + twice * S(n - 1)) * inverse / S(n);
  });
  return D;
}

/// The mutual potential of two bodies, of any order and over any scalar.
template <Scalar S = double>
class MutualPotential {
 public:
  /// @param first,second  moments, each body about its own centre of mass and in its own axes
  /// @param order         N, of the total degree; not above the orders of the moments
  /// @param G             constant of gravitation
  /// @throws OutsideDomain  where the order is negative or above that of the moments
  MutualPotential(Moments<S> const& first, Moments<S> const& second, int order, S const& G)
      : order_(order), G_(G), first_(first.series.cut(order).reflected()), second_(second.series.cut(order)) {
    int const known = first.order() < second.order() ? first.order() : second.order();
    if (order < 0 || order > known)
      throw OutsideDomain("mutual potential", "the order must lie between 0 and that of the moments", order,
                          order < 0 ? 0 : known);
  }
  /// N.
  int order() const { return order_; }

  /// Potential, force and torques.
  /// @param r  from the first centre of mass to the second, in the axes of the first body
  /// @param R  takes the axes of the second body to those of the first; R[i] are its rows
  Interaction<S> operator()(Three<S> const& r, std::array<Three<S>, 3> const& R) const {
    std::array<Three<S>, 3> transposed;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) transposed[i][j] = R[j][i];
    Polynomial<S> const D = derivatives_of_inverse_distance<S>(r, order_ + 1),
                        second = second_.substituted(transposed),
                        difference = Polynomial<S>::product(first_, second, order_);
    // [difference_body]
    S sum(0);
    Three<S> slope{S(0), S(0), S(0)};
    over_exponents(0, order_, [&](int i, int j, int l) {
      S const& T = difference(i, j, l);
      sum += T * D(i, j, l);
      slope[0] += T * D(i + 1, j, l), slope[1] += T * D(i, j + 1, l), slope[2] += T * D(i, j, l + 1);
    });
    // [difference_body]
    Three<S> const force{G_ * slope[0], G_ * slope[1], G_ * slope[2]}, torque_2 = torque(second, D),
                                                                       turned = cross_product(r, force);
    // [torque_by_invariance]
    Three<S> const torque_1{-(turned[0] + torque_2[0]), -(turned[1] + torque_2[1]),
                            -(turned[2] + torque_2[2])};
    // [torque_by_invariance]
    return {-(G_ * sum), force, torque_1, torque_2};
  }

 private:
  /// The torque on a body with the series B', by the derivatives \f$E_c\f$ of V by its coefficients.
  Three<S> torque(Polynomial<S> const& B, Polynomial<S> const& D) const {
    Three<S> t{S(0), S(0), S(0)};
    over_exponents(1, order_, [&](int i, int j, int l) {
      S E(0);
      over_exponents(0, order_ - (i + j + l), [&](int a, int b, int c) {
        if (S const& A = first_(a, b, c); A != S(0)) E += A * D(a + i, b + j, c + l);
      });
      // The coefficient of -s x grad B at these exponents.
      if (l > 0) t[0] += E * B(i, j + 1, l - 1) * S(j + 1);
      if (j > 0) t[0] -= E * B(i, j - 1, l + 1) * S(l + 1);
      if (i > 0) t[1] += E * B(i - 1, j, l + 1) * S(l + 1);
      if (l > 0) t[1] -= E * B(i + 1, j, l - 1) * S(i + 1);
      if (j > 0) t[2] += E * B(i + 1, j - 1, l) * S(i + 1);
      if (i > 0) t[2] -= E * B(i - 1, j + 1, l) * S(j + 1);
    });
    return {G_ * t[0], G_ * t[1], G_ * t[2]};
  }

  int order_;
  S G_;
  Polynomial<S> first_, second_;
};

}  // namespace actio::bodies
