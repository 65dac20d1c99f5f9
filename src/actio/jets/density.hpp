// Lagrangian densities, their momenta and the covariant Legendre transformation (sections 6.1 and 6.2 of the
// thesis).
//
// A density is a callable L on first jets, written once for every scalar; the (n+1)-form is L d^{n+1}x with
// d^{n+1}x = dt ^ dx^1 ^ ... ^ dx^n. It may have a member `examine(jet)` that refuses a jet at which it is
// not defined; it is asked once, on plain numbers, before L is differentiated.
#pragma once

#include <string>

#include "actio/jets/jet.hpp"

namespace actio {

/// A Lagrangian density over jets with n and N: `L(jet)` is the coefficient of \f$d^{n+1}x\f$, over any
/// scalar.
template <class L, class S, int n, int N>
concept DensityOver = requires(L const& density, Jet<S, n, N> const& jet) {
  { density(jet) } -> std::convertible_to<S>;
};

/// A density that has no derivative at a jet: the root of a strain that vanishes, for instance.
struct NoDerivative : NotFinite {
  using NotFinite::NotFinite;
};

/// Coordinates for a message: numbers in parentheses.
template <MatrixLike V>
std::string show(V const& v) {
  std::string text = "(";
  for (Index i = 0; i < v.size(); ++i) text += (i ? ", " : "") + show(to_double(v(i)));
  return text + ")";
}

/// Asks a density, a constraint or a medium whether it is defined at a jet: its member `examine(jet)`, where
/// it has one, refuses.
///
/// Over plain numbers alone: over dual numbers a jet is one of those around a jet that has been asked about.
template <class L, class S, int n, int N>
void examine(L const& density, Jet<S, n, N> const& jet) {
  if constexpr (Plain<S>)
    if constexpr (requires { density.examine(jet); }) density.examine(jet);
}

/// Refuses a derivative at a jet that is not finite.
/// @param where  who asks, for the message
/// @throws NoDerivative  with the point
template <MatrixLike M, class S, int n, int N>
void require_derivative(M const& derivative, Jet<S, n, N> const& jet, char const* where) {
  if constexpr (!is_exact<S>)
    if (!is_finite(derivative))
      throw NoDerivative(std::string(where) + " at x = " + show(jet.x) + ", y = " + show(jet.y) +
                         ": the density has no derivative there");
}

/// The partial derivatives \f$\partial L/\partial x^\mu\f$ of a density at a jet, with y and v held: not the
/// \ref total_derivative.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Event<S, n> partial_x(L const& density, Jet<S, n, N> const& jet) {
  auto const at_point = [&]<class T>(Event<T, n> const& x) -> T {
    return density(Jet<T, n, N>{x, jet.y.template cast<T>(), jet.v.template cast<T>()});
  };
  return derivative(at_point, jet.x).gradient();
}

/// The partial derivatives \f$\partial L/\partial y^a\f$ of a density at a jet, by the point of space.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Matrix<S, N, 1> partial_y(L const& density, Jet<S, n, N> const& jet) {
  auto const at_place = [&]<class T>(Matrix<T, N, 1> const& y) -> T {
    return density(Jet<T, n, N>{jet.x.template cast<T>(), y, jet.v.template cast<T>()});
  };
  return derivative(at_place, jet.y).gradient();
}

/// The partial derivatives \f$\partial L/\partial v^a{}_\mu\f$ of a density at a jet, by the velocities: a
/// row for each a, a column for each \f$\mu\f$.
///
/// \ref momenta is the same and asks the density first whether it is defined.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Matrix<S, N, n + 1> partial_v(L const& density, Jet<S, n, N> const& jet) {
  auto const at_velocities = [&]<class T>(Matrix<T, N, n + 1> const& v) -> T {
    return density(Jet<T, n, N>{jet.x.template cast<T>(), jet.y.template cast<T>(), v});
  };
  return derivative(at_velocities, jet.v).gradient();
}

/// The partial derivatives \f$\partial L/\partial v^a{}_\mu\f$ for one \f$\mu\f$ and all a: a column of
/// \ref momenta.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Matrix<S, N, 1> partial_v(L const& density, Jet<S, n, N> const& jet, int mu) {
  auto const at_velocity = [&]<class T>(Matrix<T, N, 1> const& v_mu) -> T {
    auto moved = jet.template cast<T>();
    moved.v.col(mu) = v_mu;
    return density(moved);
  };
  return derivative(at_velocity, Matrix<S, N, 1>(jet.v.col(mu))).gradient();
}

/// The momenta \f$p_a{}^\mu = \partial L/\partial v^a{}_\mu\f$ at a jet: a row for each a, a column for each
/// \f$\mu\f$ (6.4).
///
/// \implements{eq_6_4}
/// @throws NoDerivative  where the density has none; and what the density itself refuses
/// Accuracy: exact but for the rounding of L.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Matrix<S, N, n + 1> momenta(L const& density, Jet<S, n, N> const& jet) {
  examine(density, jet);
  // [eq_6_4]
  Matrix<S, N, n + 1> const p = partial_v(density, jet);
  // [eq_6_4]
  require_derivative(p, jet, "momenta");
  return p;
}

/// A point of the dual jet bundle \f$J^1Y^*\f$: the affine map
/// \f$v \mapsto (\Pi + p_a{}^\mu v^a{}_\mu)\,d^{n+1}x\f$ on the jets over (x, y).
template <class S, int n, int N>
struct DualJet {
  static constexpr int dimension = n + 1 + N + 1 + N * (n + 1);  ///< of the dual jet bundle

  Event<S, n> x;          ///< point of space-time, t first
  Matrix<S, N, 1> y;      ///< point of space
  S Pi;                   ///< \f$\Pi\f$, the affine component
  Matrix<S, N, n + 1> p;  ///< \f$p_a{}^\mu\f$, a row for each a
};

/// The value \f$\Pi + p_a{}^\mu v^a{}_\mu\f$ of a dual jet on a jet over the same point of Y.
template <class S, int n, int N>
S pairing(DualJet<S, n, N> const& z, Jet<S, n, N> const& jet) {
  S sum = z.Pi;
  for (int mu = 0; mu <= n; ++mu)
    for (int a = 0; a < N; ++a) sum += z.p(a, mu) * jet.v(a, mu);
  return sum;
}

/// The covariant Legendre transformation \f$J^1Y\to J^1Y^*\f$:
/// \f$p_a{}^\mu = \partial L/\partial v^a{}_\mu\f$, \f$\Pi = L - p_a{}^\mu v^a{}_\mu\f$.
///
/// \implements{eq_6_4,claim_6_2_affine_momentum}
/// @throws NoDerivative  where the density has none
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
DualJet<S, n, N> legendre(L const& density, Jet<S, n, N> const& jet) {
  // [claim_6_2_affine_momentum]
  DualJet<S, n, N> z{jet.x, jet.y, S(0), momenta(density, jet)};  // Pi = 0 for the moment
  z.Pi = density(jet) - pairing(z, jet);
  // [claim_6_2_affine_momentum]
  return z;
}

/// The energy density \f$e = p_a{}^0 v^a{}_0 - L\f$ (6.5), per unit of \f$d^{n+1}x\f$.
///
/// \implements{eq_6_5}
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
S energy_density(L const& density, Jet<S, n, N> const& jet) {
  examine(density, jet);
  Matrix<S, N, 1> const p0 = partial_v(density, jet, 0);
  require_derivative(p0, jet, "energy_density");
  // [eq_6_5]
  return p0.dot(jet.velocity()) - density(jet);
  // [eq_6_5]
}

/// The coordinates of a dual jet in one column: \f$x^\mu\f$, \f$y^a\f$, \f$\Pi\f$, then \f$p_a{}^\mu\f$ with
/// \f$\mu\f$ slowest.
template <class S, int n, int N>
Matrix<S, DualJet<S, n, N>::dimension, 1> coordinates(DualJet<S, n, N> const& z) {
  Matrix<S, DualJet<S, n, N>::dimension, 1> c;
  c.template head<n + 1>() = z.x;
  c.template segment<N>(n + 1) = z.y;
  c[n + 1 + N] = z.Pi;
  for (int mu = 0; mu <= n; ++mu) c.template segment<N>(n + 2 + N + N * mu) = z.p.col(mu);
  return c;
}

/// The dual jet with these coordinates.
template <int n, int N, MatrixLike C>
DualJet<typename C::Scalar, n, N> dual_jet_at(C const& c) {
  DualJet<typename C::Scalar, n, N> z;
  z.x = c.template head<n + 1>();
  z.y = c.template segment<N>(n + 1);
  z.Pi = c[n + 1 + N];
  for (int mu = 0; mu <= n; ++mu) z.p.col(mu) = c.template segment<N>(n + 2 + N + N * mu);
  return z;
}

}  // namespace actio
