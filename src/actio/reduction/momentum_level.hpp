// Explicit steps of order 8 that conserve the momentum of the symmetry by construction.
//
// On a level of that momentum the velocity is a function of the configuration: l'(xi) is the constant
// momentum, transported by Ad*. So a motion is a solution of a first-order equation on G, which a Runge-Kutta
// method solves in the natural chart at the earlier configuration. The momentum at the end of a step is that
// at its start, transported by the relative motion: it stays on its coadjoint orbit, and every Casimir and
// the momentum of the symmetry are what they were, whatever the error of the step. The step is no variational
// one: it does not preserve the bracket, and nothing bounds the error of the energy.
#pragma once

#include <any>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "actio/reduction/cooper_verner.hpp"
#include "actio/reduction/legendre_chord.hpp"
#include "actio/reduction/momentum_step.hpp"

namespace actio {

namespace detail {

/// The commutator of an algebra and its dual by the structure constants that are not zero.
template <Real B>
class Commutators {
 public:
  template <Group G>
  explicit Commutators(G const& group) {
    int const n = group.dimension();
    for (int a = 0; a < n; ++a)
      for (int b = a + 1; b < n; ++b) {
        auto const unit = [&](int k) {
          Coordinates<G, B> e = Coordinates<G, B>::Zero(n);
          e[k] = B(1);
          return Velocity<G, B>{group, e};
        };
        auto const c = actio::bracket(unit(a), unit(b)).coordinates;
        for (int k = 0; k < n; ++k)
          if (c[k] != B(0)) constants_.push_back({a, b, k, c[k]});
      }
  }
  /// \f$[v, w]\f$ in `out`.
  template <class V>
  void bracket(V const& v, V const& w, V& out) const {
    for (Index k = 0; k < out.size(); ++k) out[k] = typename V::Scalar(0);
    for (auto const& c : constants_) out[c.k] += (v[c.a] * w[c.b] - v[c.b] * w[c.a]) * c.value;
  }
  /// \f$\mathrm{ad}^*_v\,\mu\f$ in `out`.
  template <class V>
  void ad_star(V const& v, V const& mu, V& out) const {
    for (Index k = 0; k < out.size(); ++k) out[k] = typename V::Scalar(0);
    for (auto const& c : constants_) {
      auto const part = mu[c.k] * c.value;
      out[c.b] += v[c.a] * part, out[c.a] -= v[c.b] * part;
    }
  }

 private:
  struct Constant {
    int a, b, k;
    B value;
  };
  std::vector<Constant> constants_;
};

/// A step on a level of the momentum; side: +1 right, -1 left.
template <int side, class F, Real B>
struct MomentumLevelStep {
  F l;
  CooperVerner<B> method = {};
  mutable std::any memory = {};  ///< of the last call

  template <ExponentialGroup G, Real S>
  MomentumStep<G, S> operator()(MomentumState<G, S> const& from, std::type_identity_t<B> const& h) const {
    require_steppable(from, h);
    auto const& group = from.momentum.group;
    using Kept = Memory<G, S>;
    auto* kept = std::any_cast<Kept>(&memory);
    if (!kept) kept = &memory.template emplace<Kept>(group);
    kept->legendre.begin(l, from.velocity);
    Velocity<G, S> xi = from.velocity, eta{group, Coordinates<G, S>::Zero(group.dimension())};
    if (!stages(*kept, from, h, xi, eta)) stages(*kept, from, h, xi = from.velocity, eta);
    auto const f = exp(-eta);
    using Invariance = std::conditional_t<(side > 0), RightInvariant, LeftInvariant>;
    return {f, {Invariance::lie_poisson_update(f, from.momentum), xi}, kept->legendre.take_gradients()};
  }

 private:
  static constexpr int last = CooperVerner<B>::stages - 1;
  template <Group G, Real S>
  struct Memory {
    LegendreChord<G, S> legendre = {};
    Commutators<B> commutators;
    std::array<Coordinates<G, S>, last + 1> turned = {}, changed = {};  ///< rates at the stages
    explicit Memory(G const& group) : commutators(group) {
      for (int i = 0; i <= last; ++i) turned[i] = changed[i] = Coordinates<G, S>::Zero(group.dimension());
    }
  };

  /// The displacement over the step, and the velocity near its end.
  /// @return  false where velocities were taken for a linear function of momenta, and are none
  template <Group G, Real S>
  bool stages(Memory<G, S>& kept, MomentumState<G, S> const& from, B const& h, Velocity<G, S>& xi,
              Velocity<G, S>& eta) const {
    Momentum<G, S> mu = from.momentum;
    Coordinates<G, S> const zero = Coordinates<G, S>::Zero(mu.group.dimension());
    Coordinates<G, S> powers[] = {zero, zero, zero, zero, zero, zero};
    bool const linear = kept.legendre.linear();
    for (int i = 0; i <= last; ++i) {
      add(method.rows[i], kept.turned, h, zero, eta.coordinates);
      add(method.rows[i], kept.changed, h * B(-side), from.momentum.components, mu.components);
      if (linear) kept.legendre.by_line(mu, xi);
      if (!linear || i == last / 2 || i == last) {
        kept.legendre.solve(l, mu, xi);
        if (linear && !kept.legendre.linear()) return false;
      }
      // [momentum_level]
      kept.commutators.ad_star(xi.coordinates, mu.components, kept.changed[i]);
      rate_in_chart(kept.commutators, eta.coordinates, xi.coordinates, powers, kept.turned[i]);
      // [momentum_level]
    }
    add(method.rows[last + 1], kept.turned, h, zero, eta.coordinates);
    return true;
  }

  /// out = from + h times a row of the method.
  template <class V>
  static void add(typename CooperVerner<B>::Row const& row, std::array<V, last + 1> const& rates, B const& h,
                  V const& from, V& out) {
    out = from;
    for (int k = 0; k < row.count; ++k) {
      V const& rate = rates[row.of[k]];
      B const weight = h * row.weight[k];
      for (Index a = 0; a < out.size(); ++a) out[a] += rate[a] * weight;
    }
  }

  /// \f$\eta' = \mathrm{iex}(\pm\mathrm{ad}_\eta)^{-1}\xi\f$ up to the sixth power of ad: what follows is of
  /// the ninth order in h, since \f$\eta\f$ and \f$\xi\f$ commute to first order.
  template <class V>
  static void rate_in_chart(Commutators<B> const& commutators, V const& eta, V const& xi, V (&powers)[6],
                            V& rate) {
    using S = typename V::Scalar;
    V const* last_one = &xi;
    for (V& p : powers) commutators.bracket(eta, *last_one, p), last_one = &p;
    S const odd = S(-side) / S(2), of[] = {S(1) / S(12), S(-1) / S(720), S(1) / S(30240)};
    for (Index a = 0; a < rate.size(); ++a)
      rate[a] =
          xi[a] + powers[0][a] * odd + powers[1][a] * of[0] + powers[3][a] * of[1] + powers[5][a] * of[2];
  }
};

}  // namespace detail

/// A step of order 8 of a left-invariant system on a level of the momentum of its symmetry: a callable
/// (state, h) -> \ref MomentumStep on body momenta.
///
/// Solves \f$\dot g = g\,\xi\f$ with \f$\partial l/\partial\xi = \Pi\f$ by Cooper and Verner's explicit
/// method in the natural chart at g0, and transports \f$\Pi_1 = \mathrm{Ad}^*_{f^{-1}}\,\Pi_0\f$.
/// @param l  reduced Lagrangian, function of \f$g^{-1}\dot g\f$, energy; its Legendre map is regular
/// @throws OutsideDomain  when called, for a step that is zero or not finite
/// @throws NotConverged, Singular  when called, where the velocity of a momentum is not found
template <Real S, class F>
auto momentum_level_step_left(F l) {
  return detail::MomentumLevelStep<-1, F, S>{std::move(l)};
}
/// The same of a right-invariant system, on spatial momenta: \f$\mu_1 = \mathrm{Ad}^*_f\,\mu_0\f$.
/// @param l  reduced Lagrangian, function of \f$\dot g g^{-1}\f$, energy
template <Real S, class F>
auto momentum_level_step_right(F l) {
  return detail::MomentumLevelStep<1, F, S>{std::move(l)};
}

}  // namespace actio
