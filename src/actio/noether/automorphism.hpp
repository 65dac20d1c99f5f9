// Automorphisms of the bundle Y and their prolongations (section 9.1 of the thesis).
//
// An automorphism moves points of space-time by eta_X and Y by eta_Y, which covers it: the point (x, y)
// goes to (eta_X(x), eta_Y(x, y)). Both maps are callables over any scalar. A prolongation needs the inverse
// of the tangent map of eta_X alone; only a section that is moved needs the inverse map.
#pragma once

#include "actio/jets/density.hpp"
#include "actio/jets/prolongation.hpp"
#include "actio/linear_algebra/linear.hpp"

namespace actio {

/// An automorphism \f$(x, y)\mapsto(\eta_X(x), \eta_Y(x, y))\f$ of Y.
/// @tparam Base   \f$\eta_X\f$, a callable from points of space-time to points of space-time
/// @tparam Fibre  \f$\eta_Y\f$, a callable from points (x, y) of Y, one column, to points of space
template <class Base, class Fibre>
struct Automorphism {
  Base base;    ///< \f$\eta_X\f$
  Fibre fibre;  ///< \f$\eta_Y\f$
};
/// The automorphism of two maps.
template <class Base, class Fibre>
Automorphism(Base, Fibre) -> Automorphism<Base, Fibre>;

/// Leaves the last N coordinates of a point (x, y) as they are: what the relabelling action does to fibres
/// (9.1).
template <int N>
struct FixedFibre {
  /// y of a point (x, y).
  template <class V>
  auto operator()(V const& point) const { return Matrix<typename V::Scalar, N, 1>(point.template tail<N>()); }
};

/// The relabelling \f$\eta_X(t, x) = (t, \eta(x))\f$ of the points of the body, which leaves the fibres alone
/// (9.1).
///
/// \implements{eq_9_1}
/// @param eta  a callable from points of the body to points of the body, over any scalar
template <int N, class Eta>
auto relabelling(Eta const& eta) {
  auto const base = [eta]<class T, int rows>(Matrix<T, rows, 1> const& x) {
    Matrix<T, rows, 1> moved;
    // [eq_9_1]
    moved << x[0], eta(Matrix<T, rows - 1, 1>(x.template tail<rows - 1>()));
    // [eq_9_1]
    return moved;
  };
  return Automorphism{base, FixedFibre<N>{}};
}

/// The tangent map of an automorphism at a point of Y, in blocks.
template <class S, int n, int N>
struct AutomorphismTangent {
  Event<S, n> x;                 ///< \f$\eta_X(x)\f$
  Matrix<S, N, 1> y;             ///< \f$\eta_Y(x, y)\f$
  Matrix<S, n + 1, n + 1> base;  ///< \f$\partial\eta_X^\mu/\partial x^\nu\f$
  Matrix<S, N, n + 1> along;     ///< \f$\partial\eta_Y^a/\partial x^\nu\f$
  Matrix<S, N, N> fibre;         ///< \f$\partial\eta_Y^a/\partial y^b\f$
};

/// The tangent map of an automorphism at (x, y).
template <int n, int N, class Eta, class S>
AutomorphismTangent<S, n, N> tangent(Eta const& eta, Event<S, n> const& x, Matrix<S, N, 1> const& y) {
  Matrix<S, n + 1 + N, 1> point;
  point << x, y;
  auto const on_X = derivative(eta.base, x);
  auto const on_Y = derivative(eta.fibre, point);
  return {on_X.value, on_Y.value, on_X.matrix, on_Y.matrix.template leftCols<n + 1>(),
          on_Y.matrix.template rightCols<N>()};
}

namespace detail {

/// Inverts one block of a tangent map.
template <class M, class X>
auto inverse_of_tangent(M const& block, char const* which, X const& at) {
  try {
    return inverse_matrix(block, which);
  } catch (Singular const& e) {
    throw Singular(std::string(which) + " at " + show(at),
                   "an automorphism has a tangent map with an inverse; pivot over the terms it is made from",
                   e.measured, e.bound);
  }
}

}  // namespace detail

/// The prolongation \f$\eta_{J^1Y}(\gamma) = T\eta_Y\circ\gamma\circ T\eta_X^{-1}\f$ of an automorphism
/// (9.2).
///
/// \implements{eq_9_2,claim_9_1_prolongation_coordinates}
/// @return  the jet over \f$\eta_X(x)\f$
/// @throws Singular  where \f$T\eta_X\f$ has no inverse, with the point
/// Accuracy: exact but for the rounding of the maps and of one elimination.
template <class Eta, class S, int n, int N>
Jet<S, n, N> prolongation(Eta const& eta, Jet<S, n, N> const& j) {
  auto const d = tangent<n, N>(eta, j.x, j.y);
  auto const inverse = detail::inverse_of_tangent(d.base, "prolongation of an automorphism", j.x);
  // [eq_9_2]
  return {d.x, d.y, (d.along + d.fibre * j.v) * inverse};
  // [eq_9_2]
}

/// The lift of an automorphism to the dual jet bundle: the one that preserves the value of dual jets on jets,
/// as forms on space-time.
///
/// \f$p' = (\partial\eta_Y/\partial y)^{-\mathsf T}\,p\,(T\eta_X)^{\mathsf T}/\det T\eta_X\f$, and \f$\Pi'\f$
/// the rest. It preserves the canonical forms, which prolongations to the jet bundle do only together
/// with the density.
///
/// \implements{claim_9_1_lifted_actions}
/// @throws Singular  where the automorphism has no inverse, with the point
template <class Eta, class S, int n, int N>
DualJet<S, n, N> dual_prolongation(Eta const& eta, DualJet<S, n, N> const& z) {
  auto const d = tangent<n, N>(eta, z.x, z.y);
  S const det = determinant(d.base);
  if (base_value(det) == Base<S>(0))
    throw Singular("dual_prolongation at " + show(z.x),
                   "an automorphism has a tangent map with an inverse; determinant", 0, 0);
  Matrix<S, N, n + 1> const q =
      detail::inverse_of_tangent(d.fibre, "dual_prolongation", z.x).transpose() * z.p;
  S Pi = z.Pi;
  for (int mu = 0; mu <= n; ++mu)
    for (int a = 0; a < N; ++a) Pi -= q(a, mu) * d.along(a, mu);
  return {d.x, d.y, S(Pi / det), (q * d.base.transpose()) / det};
}

/// The section \f$\eta_Y\circ\phi\circ\eta_X^{-1}\f$.
/// @param back  \f$\eta_X^{-1}\f$, a callable on points of space-time
template <class Eta, class Back, class Phi>
auto moved_section(Eta const& eta, Back const& back, Phi const& phi) {
  return [eta, back, phi]<class T, int rows>(Matrix<T, rows, 1> const& at) {
    Matrix<T, rows, 1> const x = back(at);
    auto const y = phi(x).eval();
    Matrix<T, rows + std::remove_cvref_t<decltype(y)>::RowsAtCompileTime, 1> point;
    point << x, y;
    return eta.fibre(point);
  };
}

}  // namespace actio
