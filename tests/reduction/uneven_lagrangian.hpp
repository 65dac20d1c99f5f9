// A Lagrangian that is not even in the velocity, its flow written out by hand with commutators of matrices,
// and what is measured against it.
#pragma once

#include <vector>

#include "actio/groups/affine_line.hpp"
#include "actio/groups/linear_groups.hpp"
#include "actio/groups/motions.hpp"
#include "actio/reduction/momentum_step.hpp"
#include "actio/variational/lie_poisson.hpp"
#include "group_from_basis.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"
#include "witness/taylor_reference.hpp"

namespace actio::testing {

/// \f$\tfrac12\langle A\xi,\xi\rangle + \langle b,\xi\rangle + \tfrac\kappa3\langle c,\xi\rangle^3\f$:
/// neither even nor symmetric.
template <class S>
struct UnevenLagrangian {
  SpannedGroup group;
  Matrix<S> a;
  Vector<S> b, c;
  S kappa = ratio<S>(1, 4);

  UnevenLagrangian(Draw& draw, SpannedGroup const& of) : group(of) {
    int const n = group.dimension();
    a = Matrix<S>::Identity(n, n) * S(n + 1);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j <= i; ++j) a(i, j) = a(j, i) = a(i, j) + draw.number<S>();
    b = draw.vector<S>(n), c = draw.vector<S>(n);
  }
  template <class T>
  T operator()(Velocity<SpannedGroup, T> const& xi) const {
    Vector<T> const& x = xi.coordinates;
    T sum(0), along(0);
    for (Index i = 0; i < x.size(); ++i) {
      T row(0);
      for (Index j = 0; j < x.size(); ++j) row += x[j] * a(i, j);
      sum += x[i] * (row / S(2) + T(b[i]));
      along += x[i] * c[i];
    }
    return sum + along * along * along * (kappa / S(3));
  }
  /// \f$\partial l/\partial\xi\f$ by hand.
  template <class T>
  Vector<T> gradient_by_hand(Vector<T> const& x) const {
    T along(0);
    for (Index i = 0; i < x.size(); ++i) along += x[i] * T(c[i]);
    Vector<T> p(x.size());
    for (Index i = 0; i < x.size(); ++i) {
      p[i] = T(b[i]) + along * along * T(c[i]) * T(kappa);
      for (Index j = 0; j < x.size(); ++j) p[i] += x[j] * T(a(i, j));
    }
    return p;
  }
};

/// The equations of motion for (entries of g, xi); side: +1 right-invariant, g' = xi g; -1 left-invariant,
/// g' = g xi.
template <class S, int side>
struct FlowByHand {
  UnevenLagrangian<S> l;
  Matrix<S> inverse_a = inverse_matrix(l.a);

  /// \f$p'_k = \mp\langle p, [\xi, e_k]\rangle\f$.
  template <class T>
  Vector<T> momentum_rate(Vector<T> const& xi, Vector<T> const& p) const {
    auto const& group = l.group;
    int const d = group.dimension();
    Matrix<T> const x = group.hat(xi);
    Vector<T> p_rate(d);
    for (int k = 0; k < d; ++k) {
      Matrix<T> const e = group.hat(Vector<T>(Vector<T>::Unit(d, k)));
      T const turned = p.dot(group.vee(Matrix<T>(x * e - e * x)));
      p_rate[k] = side > 0 ? -turned : turned;
    }
    return p_rate;
  }
  /// \f$\xi' = (A + 2\kappa\langle c, \xi\rangle\,c\,c^T)^{-1}p'\f$ by the formula for a change of rank one.
  template <class T>
  Vector<T> acceleration(Vector<T> const& xi, Vector<T> const& p_rate) const {
    Index const d = xi.size();
    Vector<T> straight = Vector<T>::Zero(d), bent = straight;
    T along(0), up(0), down(0);
    for (int i = 0; i < d; ++i) {
      for (int j = 0; j < d; ++j)
        straight[i] += p_rate[j] * T(inverse_a(i, j)), bent[i] += T(inverse_a(i, j) * l.c[j]);
      along += xi[i] * T(l.c[i]);
    }
    for (int i = 0; i < d; ++i) up += straight[i] * T(l.c[i]), down += bent[i] * T(l.c[i]);
    T const bend = along * T(l.kappa) * T(2), share = bend * up / (T(1) + bend * down);
    for (int i = 0; i < d; ++i) straight[i] -= bent[i] * share;
    return straight;
  }
  template <class T>
  Vector<T> operator()(Vector<T> const& y) const {
    int const n = l.group.matrix_size(), d = l.group.dimension();
    Matrix<T> g(n, n);
    for (int i = 0; i < n * n; ++i) g(i % n, i / n) = y[i];
    Vector<T> const xi = y.segment(n * n, d);
    Matrix<T> const x = l.group.hat(xi), g_rate = side > 0 ? Matrix<T>(x * g) : Matrix<T>(g * x);
    Vector<T> rate(n * n + d);
    for (int i = 0; i < n * n; ++i) rate[i] = g_rate(i % n, i / n);
    rate.tail(d) = acceleration(xi, momentum_rate(xi, l.gradient_by_hand(xi)));
    return rate;
  }
  /// Configuration and momentum after a time, from the identity with velocity xi.
  std::pair<Matrix<S>, Vector<S>> after(Vector<S> const& xi, S const& time) const {
    int const n = l.group.matrix_size(), d = l.group.dimension();
    Vector<S> y = Vector<S>::Zero(n * n + d);
    for (int i = 0; i < n; ++i) y[i * n + i] = S(1);
    y.tail(d) = xi;
    y = taylor_reference<S>(*this, y, time);
    Matrix<S> g(n, n);
    for (int i = 0; i < n * n; ++i) g(i % n, i / n) = y[i];
    return {g, l.gradient_by_hand(Vector<S>(y.tail(d)))};
  }
};

/// The next configuration of a run; side as in \ref FlowByHand.
template <int side, class S>
Element<SpannedGroup, S> next_configuration(Element<SpannedGroup, S> const& g,
                                            Element<SpannedGroup, S> const& f) {
  if constexpr (side > 0)
    return reconstruct_right(g, f);
  else
    return reconstruct_left(g, f);
}
/// The momentum that the symmetry conserves, from the one that changes.
template <int side, class S>
Momentum<SpannedGroup, S> conserved_momentum(Element<SpannedGroup, S> const& g,
                                             Momentum<SpannedGroup, S> const& m) {
  if constexpr (side > 0)
    return Ad_star(g, m);
  else
    return Ad_star(inverse(g), m);
}

/// Largest relative error of configuration and momentum at the end of a run from the identity.
template <int side, class S, class Step>
double error_of_run(Step const& step, MomentumState<SpannedGroup, S> const& start,
                    std::vector<S> const& lengths, std::pair<Matrix<S>, Vector<S>> const& truth) {
  auto g = identity<S>(start.momentum.group);
  auto const end = take_steps(step, start, lengths, [&](auto const& done, auto const&) {
    g = restore(next_configuration<side>(g, done.relative_motion));
  });
  S const configuration = magnitude((g.value - truth.first).eval()) / magnitude(truth.first);
  S const momentum = magnitude((end.momentum.components - truth.second).eval()) / magnitude(truth.second);
  return to_double(configuration > momentum ? configuration : momentum);
}

/// Order of a method: the slope of the least squares line through the logarithms of (number of steps, error),
/// and the largest distance of a point from the line.
struct Order {
  double slope, spread;
};
inline Order order_of(std::vector<int> const& counts, std::vector<double> const& errors) {
  double const n = static_cast<double>(counts.size());
  double su = 0, sv = 0, suu = 0, suv = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    double const u = -std::log(counts[i]), v = std::log(errors[i]);
    su += u, sv += v, suu += u * u, suv += u * v;
  }
  double const slope = (n * suv - su * sv) / (n * suu - su * su), start = (sv - slope * su) / n;
  double spread = 0;
  for (std::size_t i = 0; i < counts.size(); ++i)
    spread = std::max(spread, std::abs(std::log(errors[i]) - start + slope * std::log(counts[i])));
  return {slope, spread};
}
/// The order of a step over a time, by runs of 50 digits in `counts` equal steps.
template <int side, class Step>
Order measured_order(Step const& step, UnevenLagrangian<Number> const& l,
                     Velocity<SpannedGroup, Number> const& xi, Number const& time,
                     std::vector<int> const& counts, std::pair<Matrix<Number>, Vector<Number>> const& truth) {
  auto const start = momentum_state(l, xi);
  std::vector<double> errors;
  for (int const count : counts)
    errors.push_back(
        error_of_run<side>(step, start, std::vector<Number>(count, Number(time / count)), truth));
  return order_of(counts, errors);
}

/// The tangent of the map of momenta that `after` is, at a momentum: `after` runs on dual numbers, solver and
/// all.
template <class Map>
Matrix<double> tangent_of(Map const& after, Momentum<SpannedGroup, double> const& m) {
  int const n = m.group.dimension();
  Matrix<double> tangent(n, n);
  over_batches(n, [&](int first) {
    auto moved = over<Moved<double>>(m);
    for (int a = 0; a < batch && first + a < n; ++a) moved.components[first + a].part[a] = 1;
    store_parts(tangent, after(moved).components, first);
  });
  return tangent;
}
/// By how much a map of momenta changes the Lie-Poisson bracket, relative to the bracket:
/// \f$T\,\Lambda(m)\,T^T - \Lambda(after(m))\f$.
template <class Map>
double bracket_defect(Map const& after, Momentum<SpannedGroup, double> const& m) {
  Matrix<double> const t = tangent_of(after, m), there = lie_poisson_tensor_plus(after(m));
  return magnitude((t * lie_poisson_tensor_plus(m) * t.transpose() - there).eval()) / magnitude(there);
}

/// The groups of these tests: one that hides sides and stars, and three that do not.
inline std::vector<SpannedGroup> const& four_groups() {
  static std::vector<SpannedGroup> const groups = {from_basis("SO(3)", SO<3>{}), from_basis("SL(2)", SL2{}),
                                                   from_basis("Aff(1)", Aff1{}),
                                                   from_basis("SE(3)", SE<3>{})};
  return groups;
}

}  // namespace actio::testing
