// A stress between two deformations that does exactly the work which the stored energy takes, and turns
// nothing: a discrete gradient of the energy as a function of the Green tensor.
//
// With \f$C_s = F_s^TF_s\f$ and \f$\bar F = \tfrac12(F_0+F_1)\f$ the stress is \f$\bar P = \bar F\bar S\f$
// with a symmetric \f$\bar S\f$ for which \f$\tfrac12\bar S:(C_1-C_0) = W(F_1)-W(F_0)\f$. Then
// \f$\bar P:(F_1-F_0) = W(F_1)-W(F_0)\f$, which keeps energy, and \f$\bar P\bar F^T\f$ is symmetric, which
// keeps angular momentum about the middle of the step.
//
// \f$\bar S\f$ is the mean of \f$2\,\partial W/\partial C\f$ between \f$C_0\f$ and \f$C_1\f$ by Gauss' rule,
// whose work is right to rounding where the change is small; so no difference of energies is taken, which
// would lose their last places. Where the change is large, what is missing is added along \f$C_1-C_0\f$
// (Gonzalez).
#pragma once

#include "actio/multisymplectic/stored_energies.hpp"
#include "actio/numbers/gauss_quadrature.hpp"

namespace actio {

namespace detail {
/// The upper triangle R with positive diagonal and \f$R^TR = C\f$.
template <int d>
Matrix<double, d, d> cholesky_upper(Matrix<double, d, d> const& C) {
  auto R = Matrix<double, d, d>::Zero();
  for (int j = 0; j < d; ++j)
    for (int i = 0; i <= j; ++i) {
      double sum = C(i, j);
      for (int k = 0; k < i; ++k) sum -= R(k, i) * R(k, j);
      R(i, j) = i == j ? std::sqrt(sum) : sum / R(i, i);
    }
  return R;
}
/// \f$R^{-1}P\f$ for an upper triangle R.
template <int d>
Matrix<double, d, d> upper_solved(Matrix<double, d, d> const& R, Matrix<double, d, d> P) {
  for (int j = 0; j < d; ++j)
    for (int i = d - 1; i >= 0; --i) {
      for (int k = i + 1; k < d; ++k) P(i, j) -= R(i, k) * P(k, j);
      P(i, j) /= R(i, i);
    }
  return P;
}
/// The largest entry of a change over the least stretch of C, about.
template <int d>
double relative_change(Matrix<double, d, d> const& C, Matrix<double, d, d> const& change) {
  Matrix<double, d, d> const R = cholesky_upper<d>(C);
  double least = HUGE_VAL, most = 0;
  for (int i = 0; i < d; ++i) least = std::min(least, R(i, i) * R(i, i));
  for (int k = 0; k < d * d; ++k) most = std::max(most, std::abs(change.data()[k]));
  return most / least;
}
}  // namespace detail

/// The stress \f$\bar P\f$ between two deformations.
/// @param energy  W(F), the same for F and QF with every rotation Q
/// @param stress  \f$\partial W/\partial F\f$
/// @param F0      the first deformation gradient, whose determinant is positive
/// @param change_of_F  \f$F_1-F_0\f$, which the difference of two rounded gradients would know less well;
///   \f$\det F_1\f$ is positive
/// Accuracy: the work is that of the energy up to the rounding of stresses, where the change is below 3 %;
/// and of energies, where it is larger.
template <int d, class Energy, class Stress>
Matrix<double, d, d> discrete_stress(Energy const& energy, Stress const& stress,
                                     Matrix<double, d, d> const& F0,
                                     Matrix<double, d, d> const& change_of_F) {
  using Square = Matrix<double, d, d>;
  Square const middle = F0 + change_of_F * 0.5, along = middle.transpose() * change_of_F,
               C0 = F0.transpose() * F0, change = along + along.transpose();
  double const relative = detail::relative_change<d>(Square(C0 + change * 0.5), change);
  auto S = Square::Zero();
  auto const add = [&](double s, double share) {
    Square const R = detail::cholesky_upper<d>(C0 + change * s);
    Square const half = detail::upper_solved<d>(R, stress(R));
    for (int i = 0; i < d; ++i)
      for (int j = 0; j < d; ++j) S(i, j) += share / 2 * (half(i, j) + half(j, i));
  };
  // The error of the work for 1/J, whose derivatives grow like those of all laws here: with two points 0.014
  // times the fifth power of the change, with four 8e-5 times the ninth, with eight 1.6e-9 times the 17th.
  // All are below 1e-17 here.
  static auto const rules =
      std::array{gauss_quadrature<double>(2), gauss_quadrature<double>(4), gauss_quadrature<double>(8)};
  auto const& rule = rules[relative < 3e-4 ? 0 : relative < 0.03 ? 1 : 2];
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) add(rule.nodes[k], rule.weights[k]);
  if (relative > 0.3) {
    double missing = 2 * (energy(Square(F0 + change_of_F)) - energy(F0)), square = 0;
    for (int k = 0; k < d * d; ++k)
      missing -= S.data()[k] * change.data()[k], square += change.data()[k] * change.data()[k];
    S += change * (missing / square);
  }
  return middle * S;
}

}  // namespace actio
