// A material of a scene whose stored energy is a formula of the scene.
#pragma once

#include <array>
#include <cmath>

#include "actio/formula/tape.hpp"
#include "actio/stored_energy/energies_of_gradients.hpp"
#include "program/systems/media/constants.hpp"

namespace actio::scene::materials {

/// A stored energy per reference volume as a formula in \f$I_1=\Tr C\f$, \f$J=\det F\f$, in space
/// \f$I_2=\tfrac12(I_1^2-\Tr C^2)\f$, and the components of \f$C=F^TF\f$.
struct EnergyFormula {
  /// \cond
  static constexpr bool fluid = false;
  static constexpr char const* name = "formula";
  static constexpr char const* meaning =
      "A solid whose energy per reference volume is a formula of the scene, in I1 = tr C, J = det F, in "
      "space I2 = ((tr C)^2 - tr C^2)/2, and the components C11, C12, ... of C. Of d dimensions I1 = d at "
      "rest. Bulk and shear modulus at rest are positive.";
  static constexpr char const* formula = "\\rho W = w(I_1, I_2, J, C_{ij})";
  static std::vector<MaterialConstant> said();
  auto stored() const { return media::per_volume(*this); }
  /// \endcond

  /// The formula at `energy`, with the constants.
  /// @throws SceneError  where it is none or not smooth, has an unknown name, or leaves a constant unused
  static EnergyFormula read(SceneTable const& table, int d);
  /// That the second derivatives at C = 1 have a positive bulk modulus and positive shear moduli.
  /// @throws SceneError  where they have not, with the modulus
  void require_stable(SceneTable const& table, int d) const;
  /// The moduli at rest, and the stress where there is one.
  std::vector<std::string> remarks(int d) const;

  /// W and its derivatives by the inputs: I1, of a body in space I2, J, and C row by row from the diagonal
  /// on.
  Tape with_gradient;

  /// How many invariants there are among the inputs, of which J is the last.
  static constexpr int invariants(int d) { return d == 3 ? 3 : 2; }

  /// W and its derivatives.
  template <class T, int d>
  std::array<T, 10> values(Matrix<T, d, d> const& C, T const& J) const {
    static thread_local std::vector<T> work;
    std::array<T, 9> x{};
    T trace(0.0), square(0.0);
    int k = invariants(d);
    for (int i = 0; i < d; ++i)
      for (int j = i; j < d; ++j) {
        x[k++] = C(i, j);
        if (i == j) trace = trace + C(i, i);
        square = square + C(i, j) * C(i, j) * (i == j ? 1.0 : 2.0);
      }
    x[0] = trace, x[invariants(d) - 1] = J;
    if (d == 3) x[1] = (trace * trace - square) * 0.5;
    std::array<T, 10> out{};
    with_gradient(x.data(), out.data(), work);
    return out;
  }
  /// W.
  template <class T, int d>
  T operator()(Matrix<T, d, d> const& F) const {
    return values<T, d>(F.transpose() * F, media::small_determinant(F))[0];
  }
  /// \f$2\,\partial W/\partial C\f$.
  template <class T, int d>
  Matrix<T, d, d> green_stress(Matrix<T, d, d> const& C) const {
    using std::sqrt;
    return green_stress(C, T(sqrt(media::small_determinant(C))));
  }
  /// The same where J is known.
  template <class T, int d>
  Matrix<T, d, d> green_stress(Matrix<T, d, d> const& C, T const& J) const {
    std::array<T, 10> const w = values(C, J);
    T const *const rate = w.data() + 1, by_J = rate[invariants(d) - 1] / J;
    Matrix<T, d, d> S = media::cofactors(C);
    int k = invariants(d);
    for (int i = 0; i < d; ++i)
      for (int j = i; j < d; ++j, ++k) {
        T one = S(i, j) * by_J + rate[k] * (i == j ? 2.0 : 1.0);
        if (d == 3) one = one - C(i, j) * rate[1] * 2.0;
        S(i, j) = S(j, i) = one;
      }
    T along = rate[0];
    if (d == 3) along = along + (C(0, 0) + C(d / 2, d / 2) + C(d - 1, d - 1)) * rate[1];
    for (int i = 0; i < d; ++i) S(i, i) = S(i, i) + along * 2.0;
    return S;
  }
  /// \f$\partial W/\partial F\f$.
  template <class T, int d>
  friend Matrix<T, d, d> stress_of(EnergyFormula const& medium, Matrix<T, d, d> const& F) {
    return F * medium.green_stress<T, d>(F.transpose() * F, media::small_determinant(F));
  }
  /// \f$2\,\partial W/\partial C\f$.
  template <int d>
  friend Matrix<double, d, d> green_stress_of(EnergyFormula const& medium, Matrix<double, d, d> const& C) {
    return medium.green_stress(C);
  }
};

}  // namespace actio::scene::materials
