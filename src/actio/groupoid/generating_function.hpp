// The generating function of a free motion: the action between two configurations, as a function of their
// relative motion and of the time.
//
// A free system has a quadratic Lagrangian on the algebra, l(xi) = <A xi, xi>/2 + <b, xi>; with b = 0 it is a
// rigid body, a body in an ideal fluid, or their like in any group. Its motion is a power series in the time
// whose coefficients follow from each other; the generating function is the action along the motion that
// joins the configurations, found by shooting with the initial momentum. Where l is invariant under Ad
// nothing has to be solved: then S(g, t) = t l(-log(g)/t), the discrete Lagrangian of the natural chart.
#pragma once

#include <vector>

#include "actio/groupoid/hamilton_jacobi.hpp"

namespace actio {

/// The Lagrangian \f$l(\xi) = \tfrac12\langle A\xi,\xi\rangle + \langle b,\xi\rangle\f$ with its Hamiltonian
/// \f$h(\mu) = \tfrac12\langle\mu-b, A^{-1}(\mu-b)\rangle\f$.
template <Group G, Scalar S>
struct QuadraticLagrangian {
  using Matrix = actio::Matrix<S, G::dim, G::dim>;  ///< as many rows as the algebra has dimensions
  [[no_unique_address]] G group;
  Matrix a;             ///< A, symmetric; mass, or mass x length^2
  Matrix inverse_a;     ///< its inverse
  Coordinates<G, S> b;  ///< momentum at rest: a charge in a magnetic field, a rotor

  /// @throws NotFinite      where an entry is no number
  /// @throws Singular       where A has no inverse
  /// @throws OutsideDomain  where A has not the size of the algebra, or is not symmetric to rounding
  QuadraticLagrangian(G g, Matrix inertia, Coordinates<G, S> at_rest)
      : group(std::move(g)), a(std::move(inertia)), b(std::move(at_rest)) {
    if (a.rows() != group.dimension() || a.cols() != group.dimension() || b.size() != group.dimension())
      throw OutsideDomain("QuadraticLagrangian",
                          "A must have as many rows as the algebra has dimensions; it has", double(a.rows()),
                          group.dimension());
    require_finite(a, "QuadraticLagrangian: A");
    require_finite(b, "QuadraticLagrangian: b");
    Base<S> const skew = magnitude((a - a.transpose()).eval()),
                  allowed = Base<S>(16) * epsilon<S>() * magnitude(a);
    if (skew > allowed)
      throw OutsideDomain("QuadraticLagrangian",
                          "A must be symmetric; largest difference across the diagonal", to_double(skew),
                          to_double(allowed));
    inverse_a = inverse_matrix(a, "QuadraticLagrangian: A");
  }
  /// With b = 0.
  QuadraticLagrangian(G g, Matrix inertia)
      : QuadraticLagrangian(g, std::move(inertia), Coordinates<G, S>::Zero(g.dimension())) {}

  /// l, energy
  template <Scalar T>
  T operator()(Velocity<G, T> const& xi) const {
    Coordinates<G, T> const p = a.template cast<T>() * xi.coordinates / T(2) + b.template cast<T>();
    return p.dot(xi.coordinates);
  }
  /// h, energy
  template <Scalar T>
  T operator()(Momentum<G, T> const& mu) const {
    Coordinates<G, T> const p = mu.components - b.template cast<T>();
    return p.dot(inverse_a.template cast<T>() * p) / T(2);
  }
  /// \f$\partial l/\partial\xi = A\xi + b\f$
  template <Scalar T>
  Momentum<G, T> momentum_of(Velocity<G, T> const& xi) const {
    return {xi.group, a.template cast<T>() * xi.coordinates + b.template cast<T>()};
  }
  /// \f$\partial h/\partial\mu\f$
  template <Scalar T>
  Velocity<G, T> velocity_of(Momentum<G, T> const& mu) const {
    return {mu.group, inverse_a.template cast<T>() * (mu.components - b.template cast<T>())};
  }
};

/// The power series in the time of a left-invariant free motion with a given initial body momentum:
/// coefficients of \f$t^k\f$.
///
/// \f$\dot\Pi = \mathrm{ad}^*_\xi\Pi\f$ with \f$\xi = \partial h/\partial\Pi\f$; \f$\dot f = -\xi f\f$ for
/// the relative motion \f$f = g(t)^{-1}g_0\f$; \f$\dot S = \langle\Pi,\xi\rangle - h\f$. Over any field.
template <MatrixGroup G, Scalar T>
struct FreeMotionSeries {
  std::vector<Storage<G, T>> f;       ///< relative motion
  std::vector<Coordinates<G, T>> pi;  ///< body momentum
  std::vector<T> action;              ///< energy x time

  /// The series up to \f$t^0\f$; \ref extend adds the powers after it.
  template <Scalar S>
  FreeMotionSeries(QuadraticLagrangian<G, S> const& l, Momentum<G, T> const& pi0) : energy(l(pi0)) {
    f.push_back(primitive::identity<T>(l.group));
    pi.push_back(pi0.components);
    action.push_back(T(0));
  }
  /// One power more.
  template <Scalar S>
  void extend(QuadraticLagrangian<G, S> const& l) {
    int const k = static_cast<int>(pi.size()) - 1;
    Velocity<G, T> xi{l.group, l.inverse_a.template cast<T>() *
                                   (k == 0 ? Coordinates<G, T>(pi[0] - l.b.template cast<T>()) : pi[k])};
    ad_star_of_xi.push_back(ad_matrix(xi).transpose());
    hat_of_xi.push_back(l.group.hat(xi.coordinates));
    velocities.push_back(xi.coordinates);
    Coordinates<G, T> next = Coordinates<G, T>::Zero(l.group.dimension());
    Storage<G, T> motion = f[0] * T(0);
    T power = k == 0 ? T(-energy) : T(0);
    for (int i = 0; i <= k; ++i) {
      next += ad_star_of_xi[i] * pi[k - i];
      motion -= hat_of_xi[i] * f[k - i];
      power += velocities[i].dot(pi[k - i]);
    }
    T const by(k + 1);
    pi.push_back(next / by), f.push_back(motion / by), action.push_back(power / by);
  }

 private:
  T energy;
  std::vector<actio::Matrix<T, G::dim, G::dim>> ad_star_of_xi;
  std::vector<Storage<G, T>> hat_of_xi;
  std::vector<Coordinates<G, T>> velocities;
};

/// A left-invariant free motion at the time t: relative motion, body momentum and action.
template <Group G, Scalar T>
struct FreeMotion {
  Element<G, T> f;    ///< relative motion \f$g(t)^{-1}g_0\f$
  Momentum<G, T> pi;  ///< body momentum at time t
  T action;           ///< \f$\int l\,dt\f$
};
/// The left-invariant free motion with initial body momentum `pi0`, by power series whose remainder is below
/// rounding.
///
/// @param t  time, of either sign
/// @throws NotFinite     where momentum or time is no number
/// @throws NotConverged  where a series of 4 terms a digit would need steps shorter than \f$2^{-12}t\f$
/// Accuracy: a few epsilon for each of its steps.
template <MatrixGroup G, Scalar S, Real T>
FreeMotion<G, T> free_motion_left(QuadraticLagrangian<G, S> const& l, Momentum<G, T> const& pi0,
                                  std::type_identity_t<T> const& t, int halvings_left = 12) {
  require_finite(pi0.components, "free_motion_left: momentum");
  if (!is_finite(t)) throw NotFinite("free_motion_left: time");
  FreeMotionSeries<G, T> series(l, pi0);
  FreeMotion<G, T> sum{identity<T>(l.group), pi0, T(0)};
  T power(1);
  Base<T> left(0);
  int const limit = 4 * decimal_digits<T>(), enough = 3;
  for (int k = 1, small = 0; k <= limit; ++k) {
    series.extend(l);
    power *= t;
    Storage<G, T> const turned = series.f[k] * power;
    Coordinates<G, T> const changed = series.pi[k] * power;
    T const gained = series.action[k] * power;
    sum.f.value += turned, sum.pi.components += changed, sum.action += gained;
    // The terms of the action are summed from nothing; those of the others from what they start with.
    auto const relative = [](Base<T> const& term, Base<T> const& whole) {
      return whole > Base<T>(0) ? Base<T>(term / whole) : term;
    };
    left = std::max({relative(magnitude(turned), magnitude(sum.f.value)),
                     relative(magnitude(changed), magnitude(sum.pi.components)),
                     relative(magnitude(gained), magnitude(sum.action))});
    small = left <= epsilon<T>() / Base<T>(8) ? small + 1 : 0;
    if (small == enough) return sum;
  }
  if (halvings_left == 0) throw NotConverged("free_motion_left", {to_double(left)}, to_double(epsilon<T>()));
  auto const first = free_motion_left(l, pi0, T(t / T(2)), halvings_left - 1);
  auto const second = free_motion_left(l, first.pi, T(t / T(2)), halvings_left - 1);
  return {second.f * first.f, second.pi, first.action + second.action};
}

/// The reduced generating function \f$S_L(g, t)\f$ of a left-invariant free system: the action along the
/// motion with \f$g = g(t)^{-1}g_0\f$.
///
/// It solves (4.1). Callable at every real scalar and at dual numbers over it, near the identity, where one
/// motion is nearest.
template <MatrixGroup G, Scalar S>
struct ExactGeneratingFunction {
  QuadraticLagrangian<G, S> l;  ///< of the free system

  /// S, energy x time
  /// @throws OutsideDomain  where g has no logarithm, or t is zero
  /// @throws NotConverged   where no motion near the straight one is found
  template <Real T>
  T operator()(Element<G, T> const& g, T const& t) const {
    return free_motion_left(l, initial_momentum(g, t), t).action;
  }
  /// The body momentum of the motion at time 0: solves \f$f(\Pi_0, t) = g\f$ by Newton's iteration.
  template <Real T>
  Momentum<G, T> initial_momentum(Element<G, T> const& g, T const& t) const {
    if constexpr (is_dual<T>) {
      // A root at the scalar below is a root up to infinitesimals; one iteration removes them.
      using U = decltype(T::value);
      Element<G, U> const below{g.group, g.value.unaryExpr([](T const& x) { return x.value; })};
      auto const pi0 = initial_momentum(below, t.value);
      auto const wide = over<T>(pi0);
      actio::Matrix<T, G::dim, G::dim> const slope = derivative(pi0, below, t.value).template cast<T>();
      return wide -
             Momentum<G, T>{wide.group,
                            solve_linear(slope, miss(wide, g, t),
                                         "ExactGeneratingFunction: derivative by the initial momentum")};
    } else {
      if (t == T(0)) throw OutsideDomain("ExactGeneratingFunction", "the time must differ from zero", 0, 0);
      auto pi0 = l.momentum_of(-log(g) / t);
      std::vector<double> residuals;
      double const tolerance = 16 * to_double(epsilon<T>());
      for (int iteration = 0; iteration < 60; ++iteration) {
        auto const value = miss(pi0, g, t);
        residuals.push_back(to_double(magnitude(value)));
        pi0.components -= solve_linear(derivative(pi0, g, t), value,
                                       "ExactGeneratingFunction: derivative by the initial momentum");
        double const size = residuals.back();
        if (size <= tolerance ||
            (size <= 64 * tolerance && iteration > 0 && size > residuals[iteration - 1] / 2))
          return pi0;
      }
      throw NotConverged("ExactGeneratingFunction", residuals, tolerance);
    }
  }

 private:
  /// How far f is from g, in coordinates.
  template <Real T>
  Coordinates<G, T> miss(Momentum<G, T> const& pi0, Element<G, T> const& g, T const& t) const {
    Storage<G, T> ratio = (inverse(g) * free_motion_left(l, pi0, t).f).value;
    ratio.diagonal().array() -= T(1);
    return l.group.vee(ratio);
  }
  template <Real T>
  auto derivative(Momentum<G, T> const& pi0, Element<G, T> const& g, T const& t) const {
    int const n = l.group.dimension();
    actio::Matrix<T, G::dim, G::dim> m(n, n);
    over_batches(n, [&](int first) {
      auto moved = over<Moved<T>>(pi0);
      for (int a = 0; a < batch && first + a < n; ++a) moved.components[first + a].part[a] = T(1);
      store_parts(m, miss(moved, over<Moved<T>>(g), Moved<T>(t)), first);
    });
    return m;
  }
};
/// From its Lagrangian alone.
template <MatrixGroup G, Scalar S>
ExactGeneratingFunction(QuadraticLagrangian<G, S>) -> ExactGeneratingFunction<G, S>;

}  // namespace actio
