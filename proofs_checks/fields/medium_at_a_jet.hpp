// A continuous medium of the most general kind at a jet, with the parts that the formulas of section 6.2 are
// made of.
#pragma once

#include "fields/fields.hpp"

namespace actio::checks {

/// A medium of the most general kind at a jet, and the parts that its formulas are made of, each computed by
/// itself.
template <class S, int n, int N>
struct MediumAtAJet {
  Continuum<AnyMetric<S, n>, AnyMetric<S, N>, AnyMass<S, n>, AnyEnergy<S, n, N>> L;
  Jet<S, n, N> j;
  Matrix<S, n, 1> x;
  Matrix<S, n, n> G;
  Matrix<S, N, N> g;
  S mass, root;  // rho and the root of det G

  explicit MediumAtAJet(Draw& draw)
      : L{draw_metric<S, n>(draw), draw_metric<S, N>(draw), draw_mass<S, n>(draw),
          draw_energy<S, n, N>(draw)},
        j(draw_jet<S, n, N>(draw)),
        x(j.particle()),
        G(L.G(x)),
        g(L.g(j.y)),
        mass(L.rho(x)),
        root(modulus(S(determinant(L.G.frame(x))))) {}

  S energy() const { return L.W(x, G, g, j.gradient()); }
  /// \f$\tfrac12g_{ab}v^a{}_0v^b{}_0\f$.
  S kinetic() const { return j.velocity().dot(g * j.velocity()) / S(2); }
  /// \f$\partial W/\partial v^a{}_i\f$, one after the other.
  Matrix<S, N, n> energy_gradient() const {
    using T = Dual<S>;
    Matrix<S, N, n> rate;
    for (int a = 0; a < N; ++a)
      for (int i = 0; i < n; ++i) {
        Matrix<T, N, n> F = j.gradient().template cast<T>();
        F(a, i).part[0] = S(1);
        rate(a, i) =
            L.W(x.template cast<T>().eval(), G.template cast<T>().eval(), g.template cast<T>().eval(), F)
                .part[0];
      }
    return rate;
  }
  /// \f$p_a{}^\mu\f$ as (6.4) has them.
  Matrix<S, N, n + 1> printed_momenta() const {
    Matrix<S, N, n + 1> p;
    p << g * j.velocity() * (mass * root), energy_gradient() * S(-mass * root);
    return p;
  }
  S sum_of_spatial_momenta() const {
    return printed_momenta().template rightCols<n>().cwiseProduct(j.gradient()).sum();
  }
};

}  // namespace actio::checks
