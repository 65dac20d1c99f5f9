// Inertia of a generalized rigid body on SO(n) (thesis, chapter 5).
//
// J(xi) = Lambda xi + xi Lambda with Lambda diagonal and Lambda_i + Lambda_j > 0. Lambda_i is the second
// moment of the mass along the i-th body axis; the moment of inertia in the plane (i, j) is
// Lambda_i + Lambda_j. In the coordinates of so(n) the operator J is diagonal, its entries being these
// moments; for n = 3 they are the principal moments of inertia I_1, I_2, I_3.
//
// Normalisation: (5.1) prints l = <xi, J xi>/4 with <A, B> = Tr(A^T B), which is half the sum of
// (Lambda_i + Lambda_j) xi_ij^2 over i < j: the kinetic energy. The pairing of the library is that of
// coordinates, Tr(A^T B)/2, so that l = <J xi, xi>/2 and J xi is the physical body momentum.
//
// No threshold is absolute: a molecule (1e-47 kg m^2) and a space station (1e8) get the same digits.
#pragma once

#include <Eigen/LU>

#include "actio/groups/group.hpp"
#include "actio/groups/rotations_of_any_size.hpp"
#include "actio/linear_algebra/eigenvalues.hpp"

namespace actio {

/// Inertia of a rigid body on SO(n), n fixed or `Dynamic`. Made by \ref inertia_from_lambda,
/// \ref inertia_from_moments or, from a tensor, \ref principal_inertia, which check it.
template <int n, Real S = double>
struct Inertia {
  [[no_unique_address]] SO<n> group;  ///< the rotations of the space the body lives in
  Matrix<S, n, 1> lambda;             ///< second moments of the mass along the body axes; mass x length^2
  /// \f$\Lambda_i+\Lambda_j\f$ of the plane of each coordinate; mass x length^2
  Coordinates<SO<n>, S> moments;

  /// The same inertia over another scalar.
  template <Real T>
  Inertia<n, T> over() const { return {group, lambda.template cast<T>(), moments.template cast<T>()}; }
};

/// How far rounding alone may push a moment across a bound, in units of the largest: each of three moments
/// comes with the rounding of an eigenvalue solver or of a sum over the parts of a body.
template <Real S>
S inertia_tolerance() { return S(16) * epsilon<S>(); }

/// Inertia of a generalized body from the diagonal of \f$\Lambda\f$.
///
/// \implements{claim_5_0_inertia_operator}
/// @param lambda  n numbers, mass x length^2; one of them may be zero or negative
/// @throws NotFinite          where one is no number
/// @throws UnphysicalInertia  where \f$\Lambda_i+\Lambda_j\f$ is not positive for some i, j: J would not be
///                         positive definite
template <int n, Real S>
Inertia<n, S> inertia_from_lambda(Matrix<S, n, 1> const& lambda) {
  if (!is_finite(lambda)) throw NotFinite("inertia: Lambda");
  int const size = static_cast<int>(lambda.size());
  if (size < 2) throw OutsideDomain("inertia", "a body turns in at least two dimensions", size, 2);
  Inertia<n, S> inertia;
  if constexpr (n == Dynamic) inertia.group.n = size;
  inertia.lambda = lambda;
  inertia.moments.resize(size * (size - 1) / 2);
  S const scale = magnitude(lambda);
  if (!is_finite(S(scale + scale))) throw NotFinite("inertia: sums of Lambda");
  over_planes(size, [&](int a, int i, int j) {
    inertia.moments[a] = lambda[i] + lambda[j];
    if (!(inertia.moments[a] > inertia_tolerance<S>() * scale))
      throw UnphysicalInertia(
          "inertia",
          "Lambda_" + std::to_string(std::min(i, j) + 1) + " + Lambda_" + std::to_string(std::max(i, j) + 1) +
              " must be positive, or turning in that plane has no energy (thesis, 5.1); "
              "in units of the largest Lambda",
          scale > S(0) ? to_double(S(inertia.moments[a] / scale)) : 0.0, to_double(inertia_tolerance<S>()));
  });
  return inertia;
}

/// Inertia of a body in 3-space from its principal moments: \f$\Lambda_i = \tfrac12(I_j + I_k - I_i)\f$.
///
/// Equality in the triangle inequality is a planar body, with \f$\Lambda_i = 0\f$ exactly.
/// @param moments  \f$I_1, I_2, I_3\f$ in any order; mass x length^2
/// @throws NotFinite          where one is no number
/// @throws UnphysicalInertia  where a moment is not positive, or exceeds the sum of the other two by more
///                         than rounding (16 epsilon of the largest)
template <Real S>
Inertia<3, S> inertia_from_moments(Matrix<S, 3, 1> const& moments) {
  if (!is_finite(moments)) throw NotFinite("inertia: principal moments");
  S const scale = magnitude(moments);
  // Halve before adding: the largest numbers of the scalar do not overflow.
  Inertia<3, S> inertia{{}, {}, moments};
  auto const name = [](int i) { return "I_" + std::to_string(i + 1); };
  for (int i = 0; i < 3; ++i)
    if (!(moments[i] > inertia_tolerance<S>() * scale))
      throw UnphysicalInertia("inertia",
                              name(i) +
                                  " must be positive: a body with extent has inertia about every axis; "
                                  "in units of the largest moment",
                              scale > S(0) ? to_double(S(moments[i] / scale)) : 0.0,
                              to_double(inertia_tolerance<S>()));
  for (int i = 0; i < 3; ++i) {
    int const j = (i + 1) % 3, k = (i + 2) % 3;
    S const lambda = moments[j] / S(2) + moments[k] / S(2) - moments[i] / S(2);
    if (lambda < -inertia_tolerance<S>() * scale)
      throw UnphysicalInertia("inertia",
                              name(i) +
                                  " must not exceed the sum of the other two (triangle "
                                  "inequality): no distribution of mass has such moments; excess "
                                  "in units of the largest moment",
                              to_double(S(-S(2) * lambda / scale)),
                              to_double(S(S(2) * inertia_tolerance<S>())));
    inertia.lambda[i] = magnitude(lambda) <= inertia_tolerance<S>() * scale ? S(0) : lambda;
  }
  return inertia;
}
/// The same from three numbers.
///
/// \snippet bodies.cpp inertia_from_moments
inline Inertia<3> inertia_from_moments(double i1, double i2, double i3) {
  return inertia_from_moments<double>(Eigen::Vector3d(i1, i2, i3));
}

/// \f$J(\xi) = \Lambda\xi+\xi\Lambda\f$: the body momentum, energy x time.
template <int n, Real S, Scalar T>
Momentum<SO<n>, T> body_momentum(Inertia<n, S> const& inertia, Velocity<SO<n>, T> const& xi) {
  return {xi.group, xi.coordinates.cwiseProduct(inertia.moments.template cast<T>())};
}
/// \f$J^{-1}(\mu)\f$: the body velocity, 1/time.
template <int n, Real S, Scalar T>
Velocity<SO<n>, T> body_velocity(Inertia<n, S> const& inertia, Momentum<SO<n>, T> const& pi) {
  return {pi.group, pi.components.cwiseQuotient(inertia.moments.template cast<T>())};
}
/// \f$l(\xi) = \tfrac12\langle J\xi, \xi\rangle\f$: the kinetic energy. \implements{eq_5_1}
template <int n, Real S, Scalar T>
T kinetic_energy(Inertia<n, S> const& inertia, Velocity<SO<n>, T> const& xi) {
  // [eq_5_1]
  return pair(body_momentum(inertia, xi), xi) / T(2);
  // [eq_5_1]
}
/// The kinetic energy of a body momentum: \f$\tfrac12\langle\mu, J^{-1}\mu\rangle\f$.
template <int n, Real S, Scalar T>
T kinetic_energy(Inertia<n, S> const& inertia, Momentum<SO<n>, T> const& pi) {
  return pair(pi, body_velocity(inertia, pi)) / T(2);
}

}  // namespace actio
