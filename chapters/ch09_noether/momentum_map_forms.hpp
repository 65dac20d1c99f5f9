// Two equations of section 9.1 of the thesis that are equalities of forms, as what they leave.
#pragma once

#include "actio/jets/action.hpp"
#include "actio/noether/automorphism.hpp"
#include "actio/noether/covariant_momentum_map.hpp"

// What (9.4) leaves at a jet, on n + 1 tangent vectors of the jet bundle.
template <int n, int N, class L, class Xi, class Coordinates, class Vectors>
auto momentum_map_defect(L const& density, Xi const& xi, Coordinates const& at, Vectors const& V) {
  using namespace actio;
  auto const Omega = multisymplectic_form<n, N>(density);
  auto const J = covariant_momentum_map<n, N>(density, xi);
  // [eq_9_4]
  return contract(prolonged<n, N>(xi), Omega)(at, V) - exterior_derivative(J)(at, V);
  // [eq_9_4]
}

// What (9.6) leaves: the action of the moved section over the moved box, less that of the section over the
// box.
template <class L, class Eta, class Back, class Phi, class Box>
double action_defect(L const& density, Eta const& eta, Back const& back, Phi const& phi, Box const& box,
                     Box const& moved_box, int degree) {
  using namespace actio;
  // [eq_9_6]
  return action(density, moved_section(eta, back, phi), moved_box, degree) -
         action(density, phi, box, degree);
  // [eq_9_6]
}

// k tangent vectors with D coordinates that have nothing in common.
template <int D, int k>
actio::Tangents<double, D, k> some_vectors() {
  actio::Tangents<double, D, k> V;
  for (int i = 0; i < D; ++i)
    for (int m = 0; m < k; ++m) V(i, m) = 1.0 / (1 + i + m) - (i % (m + 2)) * 0.3;
  return V;
}
