// A stress between two deformations that does exactly the work which the stored energy takes, and turns
// nothing: a discrete gradient of the energy as a function of the Green tensor.
//
// With \f$C_s = F_s^TF_s\f$ and \f$\bar F = \tfrac12(F_0+F_1)\f$ the stress is \f$\bar P = \bar F\bar S\f$
// with a symmetric \f$\bar S\f$ for which \f$\tfrac12\bar S:(C_1-C_0) = W(F_1)-W(F_0)\f$. Then
// \f$\bar P:(F_1-F_0) = W(F_1)-W(F_0)\f$, which conserves energy, and \f$\bar P\bar F^T\f$ is symmetric,
// which conserves angular momentum about the middle of the step.
//
// \f$\bar S\f$ is the mean of \f$2\,\partial W/\partial C\f$ between \f$C_0\f$ and \f$C_1\f$ by Gauss' rule,
// whose work is right to rounding where the change is small; so no difference of energies is taken, which
// would lose their last places. Where the change is large, what is missing is added along \f$C_1-C_0\f$
// (Gonzalez).
#pragma once

#include "actio/numbers/gauss_quadrature.hpp"
#include "actio/stored_energy/stored_energies.hpp"

namespace actio::media {

namespace detail {
/// The largest entry of a change over a bound from below of the least eigenvalue of C, which is positive.
template <int d>
double relative_change(Matrix<double, d, d> const& C, Matrix<double, d, d> const& change) {
  double trace = 0, most = 0;
  for (int i = 0; i < d; ++i) trace += C(i, i);
  for (int k = 0; k < d * d; ++k) most = std::max(most, std::abs(change.data()[k]));
  // The others have a product of at most their mean to the power of their number.
  double others = 1;
  for (int i = 1; i < d; ++i) others *= trace / (d - 1);
  return most * others / small_determinant(C);
}
}  // namespace detail

/// The stress \f$\bar P\f$ between two deformations.
/// @param energy  W as a function of \f$H = F-1\f$, the same for F and QF with every rotation Q
/// @param stress  \f$2\,\partial W/\partial C\f$ as a function of Green's strain
/// @param H0      \f$F_0-1\f$; the determinant of \f$F_0\f$ is positive
/// @param change_of_F  \f$F_1-F_0\f$, which the difference of two rounded gradients would know less well;
///   \f$\det F_1\f$ is positive
/// Accuracy: the work is that of the energy up to the rounding of stresses, where the change is below 3 %;
/// and of energies, where it is larger.
template <int d, class Energy, class Stress>
Matrix<double, d, d> discrete_stress(Energy const& energy, Stress const& stress,
                                     Matrix<double, d, d> const& H0,
                                     Matrix<double, d, d> const& change_of_F) {
  using Square = Matrix<double, d, d>;
  Square const middle = beyond_identity<d>(H0 + change_of_F * 0.5), along = middle.transpose() * change_of_F,
               E0 = green_strain(H0), change = along + along.transpose();
  double const relative = detail::relative_change<d>(beyond_identity<d>(E0 * 2 + change * 0.5), change);
  auto S = Square::Zero();
  // The error of the work for 1/J, whose derivatives grow like those of all laws here: with two points 0.014
  // times the fifth power of the change, with four 8e-5 times the ninth, with eight 1.6e-9 times the 17th.
  // All are below 1e-17 here.
  static auto const rules =
      std::array{gauss_quadrature<double>(2), gauss_quadrature<double>(4), gauss_quadrature<double>(8)};
  auto const& rule = rules[relative < 3e-4 ? 0 : relative < 0.03 ? 1 : 2];
  for (std::size_t k = 0; k < rule.nodes.size(); ++k)
    S += stress(Square(E0 + change * (rule.nodes[k] / 2))) * rule.weights[k];
  if (relative > 0.3) {
    double missing = 2 * (energy(Square(H0 + change_of_F)) - energy(H0)), square = 0;
    for (int k = 0; k < d * d; ++k)
      missing -= S.data()[k] * change.data()[k], square += change.data()[k] * change.data()[k];
    S += change * (missing / square);
  }
  return middle * S;
}

}  // namespace actio::media
