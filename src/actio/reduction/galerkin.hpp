// Galerkin steps on a group: polynomial paths in the natural chart at the earlier configuration, Gauss
// quadrature, stationary action.
//
// The path is g(t) = g0 exp(eta(t)) in a left-invariant system and exp(eta(t)) g0 in a right-invariant one.
// eta is a polynomial of degree s through eta(0) = 0, xi_1, ..., xi_s at the times 0, h/s, ..., h. The action
// by Gauss's rule with s nodes is a function A(xi_1, ..., xi_s). It is stationary in the configurations in
// between, and its differential in the last one is the momentum, read in the chart. So a step from a given
// momentum solves s dim G equations; the momentum is transported by Ad*, so the coadjoint orbit, the bracket
// and the momentum of the symmetry are preserved exactly, and the order is 2s.
#pragma once

#include <optional>

#include "actio/groups/unipotent_groups.hpp"
#include "actio/reduction/momentum_step.hpp"
#include "actio/reduction/polynomial_path.hpp"

namespace actio {

namespace detail {

/// \f$\mathrm{iex}(w)\,v\f$ without the matrix of iex: its series, until no component changes any more.
/// @throws OutsideDomain  where 300 terms do not do, far beyond any chart
template <class M, class V>
V iex_times(M const& w, V const& v) {
  using S = typename V::Scalar;
  Base<S> const tiny(negligible<S>());
  V term = v, sum = v;
  for (int k = 2; k <= 300; ++k) {
    V const next = w * term;
    bool done = true;
    for (Index i = 0; i < v.size(); ++i) {
      term[i] = next[i] / Base<S>(k);
      sum[i] += term[i];
      done = done && !(magnitude(term[i]) > tiny * magnitude(sum[i]));
    }
    if (done) return sum;
  }
  throw OutsideDomain("galerkin", "a step must stay within the natural chart (3.19); size of ad", row_norm(w),
                      2 * M_PI);
}

/// \f$\eta\f$ at the i-th node of the rule, and as its infinitesimal part the rate at which it changes with
/// the fraction of the step.
template <Group G, Scalar S>
Velocity<G, Dual<S>> path_at_node(PolynomialPath<Base<S>> const& path, G const& group,
                                  Matrix<S, Dynamic, 1> const& xi, int i) {
  int const n = group.dimension();
  Velocity<G, Dual<S>> eta{group, Coordinates<G, Dual<S>>::Zero(n)};
  for (int nu = 0; nu < path.degree(); ++nu)
    for (int a = 0; a < n; ++a) {
      eta.coordinates[a].value += xi[nu * n + a] * path.value(i, nu);
      eta.coordinates[a].part[0] += xi[nu * n + a] * path.slope(i, nu);
    }
  return eta;
}

/// \f$\mathrm{iex}(\pm\mathrm{ad}_\eta)\,\eta'\f$: what the path turns by over the step, at the rate it has
/// where `eta` was taken. side: +1 right, -1 left.
template <int side, Group G, Scalar S>
Velocity<G, S> velocity_of_path(Velocity<G, Dual<S>> const& eta) {
  int const n = eta.group.dimension();
  Coordinates<G, S> signed_eta(n), rate(n);
  for (int a = 0; a < n; ++a)
    signed_eta[a] = eta.coordinates[a].value * Base<S>(side), rate[a] = eta.coordinates[a].part[0];
  return {eta.group, iex_times(ad_matrix(Velocity<G, S>{eta.group, signed_eta}), rate)};
}

/// The action of the path through \f$\xi_1, \dots, \xi_s\f$: \f$h\sum_i
/// b_i\,l(\tfrac1h\,\mathrm{iex}(\pm\mathrm{ad}_{\eta_i})\,\eta_i')\f$.
template <int side, Group G, Scalar S, class F>
S galerkin_action(F const& l, PolynomialPath<Base<S>> const& path, G const& group, Base<S> const& h,
                  Matrix<S, Dynamic, 1> const& xi) {
  S sum(0);
  for (int i = 0; i < path.degree(); ++i) {
    auto const eta = path_at_node(path, group, xi, i);
    // [galerkin_action]
    sum += l(velocity_of_path<side>(eta) / S(h)) * (h * path.weights[i]);
    // [galerkin_action]
  }
  return sum;
}

/// What a Lagrangian gives at a node: its momentum, and what a vector that the motion advects adds to the
/// rate at which that changes over the step; empty where there is none.
template <Group G, Scalar S>
struct AtNode {
  Momentum<G, S> momentum;
  std::optional<Momentum<G, S>> torque = std::nullopt;
};

/// A Lagrangian without a vector, at the nodes.
template <class F>
struct LagrangianAtNodes {
  F const& l;
  template <Group G, Scalar S>
  AtNode<G, S> operator()(int, auto const&, Velocity<G, S> const& velocity) const {
    return {gradient(l, velocity)};
  }
};

/// The differential of that action in \f$\xi_1, \dots, \xi_s\f$, written out with the variation of a reduced
/// velocity, \f$\delta\xi = \dot\vartheta \mp [\xi, \vartheta]\f$ with
/// \f$\vartheta = \mathrm{iex}(\pm\mathrm{ad}_\eta)\,\delta\eta\f$.
///
/// With \f$p = \partial l/\partial\xi\f$ it is \f$\sum_i
/// b_i\,(\lambda_\nu'(c_i)\,q_i + \lambda_\nu(c_i)\,\dot q_i)\f$, where
/// \f$q = \mathrm{iex}(\pm\mathrm{ad}_\eta)^T p\f$ changes along the path while p changes at the rate
/// \f$\mp\mathrm{ad}^*_\xi\,p\f$, and by the torque. One dual number carries both.
/// @param at_node  (i, eta, velocity) -> `AtNode`
template <int side, Group G, Scalar S, class At>
Matrix<S, Dynamic, 1> galerkin_differential(At const& at_node, PolynomialPath<Base<S>> const& path,
                                            G const& group, Base<S> const& h,
                                            Matrix<S, Dynamic, 1> const& xi) {
  int const n = group.dimension(), s = path.degree();
  Matrix<S, Dynamic, 1> differential = Matrix<S, Dynamic, 1>::Zero(s * n);
  for (int i = 0; i < s; ++i) {
    auto const eta = path_at_node(path, group, xi, i);
    auto const velocity = velocity_of_path<side>(eta);
    auto const [p, torque] = at_node(i, eta, velocity / S(h));
    auto along = ad_star(velocity, p);
    if (torque) along = along - *torque;
    Coordinates<G, Dual<S>> moving(n);
    for (int a = 0; a < n; ++a)
      moving[a].value = p.components[a],
      moving[a].part[0] = side > 0 ? -along.components[a] : along.components[a];
    auto const q = iex_times(ad_matrix(side > 0 ? eta : -eta).transpose().eval(), moving);
    for (int nu = 0; nu < s; ++nu)
      for (int a = 0; a < n; ++a)
        // [galerkin_differential]
        differential[nu * n + a] +=
            (q[a].value * path.slope(i, nu) + q[a].part[0] * path.value(i, nu)) * path.weights[i];
    // [galerkin_differential]
  }
  return differential;
}

/// The s dim G numbers that vanish for the path that leaves with a given momentum: the differential of the
/// action, less the momentum read in the chart, \f$\mathrm{iex}(\mp\mathrm{ad}_{\xi_s})^T\mu_0\f$, in its
/// last block.
/// @param mu  momentum at the start; with an advected vector it may change with the path by `at_node`, which
///            is called before it is read
template <int side, Group G, Scalar S, class At>
Matrix<S, Dynamic, 1> galerkin_residual(At const& at_node, PolynomialPath<Base<S>> const& path,
                                        Momentum<G, S> const& mu, Base<S> const& h,
                                        Matrix<S, Dynamic, 1> const& xi) {
  int const n = mu.group.dimension();
  auto left = galerkin_differential<side>(at_node, path, mu.group, h, xi);
  Velocity<G, S> const last{mu.group, xi.tail(n)};
  // [galerkin_momentum]
  left.tail(n) -= iex_times(ad_matrix(side > 0 ? -last : last).transpose().eval(), mu.components);
  // [galerkin_momentum]
  return left;
}

/// The nodes of the path of a step, one below the other, by a solver that remembers those of the last step.
/// @param residual  (path over any scalar R) -> its s dim G numbers
template <Group G, Real S, class Residual>
Matrix<S, Dynamic, 1> solve_galerkin(RememberedSolutions const& remembered, Velocity<G, S> const& from,
                                     Base<S> const& h, int s, Residual const& residual, int& evaluations) {
  int const n = from.group.dimension();
  // The initial guess repeats the last step: a line in the chart.
  Element<Translations<Dynamic>, S> start{{s * n}, {}};
  start.value.resize(s * n);
  for (int nu = 0; nu < s; ++nu)
    start.value.segment(nu * n, n) = from.coordinates * S(h * Base<S>(nu + 1) / Base<S>(s));
  auto& solver = remembered.template solver<Translations<Dynamic>>(from, h);
  auto const xi = solver.solve(
      [&]<class R>(Element<Translations<Dynamic>, R> const& x) {
        return Momentum<Translations<Dynamic>, R>{x.group, residual(x.value)};
      },
      start);
  evaluations += solver.report().evaluations;
  return xi.value;
}

/// The velocity at the end of a path, where the next step starts its search.
template <int side, Group G, Real S>
Velocity<G, S> velocity_at_end(PolynomialPath<Base<S>> const& path, G const& group, Base<S> const& h,
                               Matrix<S, Dynamic, 1> const& xi) {
  int const n = group.dimension(), s = path.degree();
  Velocity<G, Dual<S>> end{group, Coordinates<G, Dual<S>>::Zero(n)};
  for (int a = 0; a < n; ++a) {
    end.coordinates[a].value = xi[(s - 1) * n + a];
    for (int nu = 0; nu < s; ++nu) end.coordinates[a].part[0] += xi[nu * n + a] * path.final_slope[nu];
  }
  return velocity_of_path<side>(end) / S(h);
}

/// A Galerkin step; side: +1 right, -1 left.
template <int side, class F, Real B>
struct GalerkinStep {
  F l;
  PolynomialPath<B> path;
  RememberedSolutions remembered = {};

  template <ExponentialGroup G, Real S>
  MomentumStep<G, S> operator()(MomentumState<G, S> const& from, std::type_identity_t<B> const& h) const {
    require_steppable(from, h);
    auto const& mu = from.momentum;
    int const n = mu.group.dimension();
    int evaluations = 0;
    auto const xi = solve_galerkin(
        remembered, from.velocity, h, path.degree(),
        [&]<class R>(Matrix<R, Dynamic, 1> const& x) {
          return galerkin_residual<side>(LagrangianAtNodes<F>{l}, path, over<R>(mu), h, x);
        },
        evaluations);
    // The relative motion points backwards.
    auto const f = exp(Velocity<G, S>{mu.group, -xi.tail(n)});
    using Invariance = std::conditional_t<(side > 0), RightInvariant, LeftInvariant>;
    return {f,
            {Invariance::lie_poisson_update(f, mu), velocity_at_end<side>(path, mu.group, h, xi)},
            evaluations};
  }
};
}  // namespace detail

/// The Galerkin step of a right-invariant system, of order 2s: a callable (state, h) -> \ref MomentumStep on
/// spatial momenta.
///
/// Solves \f$\partial A/\partial\xi_\nu = 0\f$ for \f$\nu<s\f$ and \f$\partial
/// A/\partial\xi_s = \mathrm{iex}(-\mathrm{ad}_{\xi_s})^T\mu_0\f$; then \f$f = e^{-\xi_s}\f$ and
/// \f$\mu_1 = \mathrm{Ad}^*_f\,\mu_0\f$. With s = 1 it is the step by the natural chart (3.25).
/// @param l  reduced Lagrangian, function of \f$\dot g g^{-1}\f$, energy
/// @param s  degree and number of nodes, 1 to 8
/// @throws OutsideDomain  at once for a degree that is none of these; when called, for a step that is zero or
///                        not finite, or leaves every chart
/// @throws NotConverged, Singular  when called, where the step is too long for the momentum
template <Real S, class F>
auto galerkin_step_right(F l, int s) {
  return detail::GalerkinStep<1, F, S>{std::move(l), PolynomialPath<S>(s)};
}
/// The Galerkin step of a left-invariant system, of order 2s, on body momenta:
/// \f$\partial A/\partial\xi_s = \mathrm{iex}(\mathrm{ad}_{\xi_s})^T\Pi_0\f$ and
/// \f$\Pi_1 = \mathrm{Ad}^*_{f^{-1}}\,\Pi_0\f$. Otherwise as \ref galerkin_step_right.
///
/// \snippet reduction.cpp galerkin_step_left
/// @param l  reduced Lagrangian, function of \f$g^{-1}\dot g\f$, energy
/// @param s  degree and number of nodes, 1 to 8
template <Real S, class F>
auto galerkin_step_left(F l, int s) {
  return detail::GalerkinStep<-1, F, S>{std::move(l), PolynomialPath<S>(s)};
}

}  // namespace actio
