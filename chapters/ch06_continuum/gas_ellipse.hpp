// A round cloud of polytropic gas, pulled long and set turning, that spreads into empty space: x = A(t) X
// with |X| <= 1.
//
// Mass (1 - |X|^2)^(1/(gamma-1)), stored energy K (1 - |X|^2) J^(1-gamma)/(gamma-1) per unit mass, so that
// the pressure is K (rho/J)^gamma; then
//
//   A'' = b (det A)^(1-gamma) A^-T,   b = 2 K gamma/(gamma-1).
#pragma once

#include "actio/continuum/materials.hpp"
#include "graded_body.hpp"

struct EllipticGas {
  double K, gamma;

  double b() const { return 2 * K * gamma / (gamma - 1); }
  auto medium() const {
    return actio::Continuum{actio::Euclidean<2>{}, actio::Euclidean<2>{}, GradedMass{1 / (gamma - 1)},
                            GradedEnergy{actio::Barotropic{actio::Polytropic<double>{K, gamma}}}};
  }
  // A'' from A, over any scalar: the inverse transposed by its minors.
  template <class S>
  actio::Matrix<S, 2, 2> operator()(actio::Matrix<S, 2, 2> const& A) const {
    using std::exp, std::log;
    using B = actio::Base<S>;
    S const J = actio::determinant(A), factor = exp(log(J) * B(-gamma)) * B(b());
    actio::Matrix<S, 2, 2> minors;
    minors << A(1, 1), -A(1, 0), -A(0, 1), A(0, 0);
    return minors * factor;
  }
  // Twice the energy of all the gas, per unit of its second moment.
  template <class S>
  S energy(actio::Matrix<S, 2, 2> const& A, actio::Matrix<S, 2, 2> const& V) const {
    using std::pow;
    return V.squaredNorm() + 2 * b() / (gamma - 1) * pow(actio::determinant(A), 1 - gamma);
  }
};

// Drawn out to twice its width, leaning, turning and sheared.
inline LinearState<double, 2> thrown_gas() {
  actio::Matrix<double, 2, 2> A, V;
  A << 1.0, 0.3, 0.0, 0.5;
  V << 0.1, -0.9, 0.7, 0.2;
  return linear_state<double, 2>(A, V);
}
