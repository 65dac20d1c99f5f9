// A density along a section that solves nothing, and sections of the jet bundle that are no jets.
#pragma once

#include "actio/jets/field_equations.hpp"
#include "fields/variations.hpp"

namespace actio::checks {

/// A section of the jet bundle that is no jet: the values of one section and the derivatives of another.
template <class Phi, class Psi>
auto not_holonomic(Phi const& phi, Psi const& psi) {
  return [phi, psi]<class T, int rows>(Matrix<T, rows, 1> const& x) {
    auto j = first_jet(phi, x);
    j.v = first_jet(psi, x).v;
    return coordinates(j);
  };
}

/// A density, a section and a point of space-time, with the second jet there.
template <class S, int n, int N>
struct OffShell {
  static constexpr int dimension = Jet<S, n, N>::dimension;
  AnyDensity<S, n, N> L;
  AnySection<S, n, N> phi;
  Event<S, n> x;
  SecondJet<S, n, N> j;
  Matrix<S, N, 1> E;

  explicit OffShell(Draw& draw)
      : L(draw_density<S, n, N>(draw)),
        phi(draw_section<S, n, N>(draw)),
        x(draw_event<S, n>(draw)),
        j(second_jet(phi, x)),
        E(euler_lagrange(L, j)) {}

  /// The coefficient of \f$(j^1\phi)^*(W\lrcorner\,\Omega)\f$, or of a pull-back by another section of the
  /// jet bundle, for a constant field W on it.
  S contraction(Matrix<S, dimension, 1> const& W) const { return contraction(W, jet_extension(phi), L); }
  template <class Map, class Density>
  S contraction(Matrix<S, dimension, 1> const& W, Map const& map, Density const& density) const {
    return coefficient_of(
        pull_back(map, contract(ConstantField<S, dimension>{W}, multisymplectic_form<n, N>(density))), x);
  }
  Jet<S, n, N> const& first() const { return j; }
};

}  // namespace actio::checks
