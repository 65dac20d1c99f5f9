// What the checks of section 3.1 share: sequences of configurations and their variations, tangent vectors to
// G x G, the exterior derivative of a one-form there, and Lagrangians of which a given sequence is a motion.
#pragma once

#include "actio/reduction/discrete_momentum.hpp"
#include "actio/reduction/relative_motion.hpp"
#include "models/models.hpp"

namespace actio::checks {

/// The groups for checks that solve for a motion: all of them, but over the rationals, where numbers grow
/// with the size of a system, those of dimension 4, or less, at most. SE(2) and Aff(1) are among these.
template <class S>
std::vector<SpannedGroup> groups_for_motions(int largest = 4) {
  std::vector<SpannedGroup> groups;
  for (auto const& group : all_groups())
    if (!numbers_grow() || group.dimension() <= largest) groups.push_back(group);
  return groups;
}

template <class S>
using GroupElement = Element<SpannedGroup, S>;
template <class S>
using GroupElements = std::vector<GroupElement<S>>;
template <class S>
using Variations = std::vector<Velocity<SpannedGroup, S>>;
template <class S>
using Change = PairChange<SpannedGroup, S>;

template <class S>
GroupElements<S> draw_points(Draw& draw, SpannedGroup const& group, int count,
                             std::type_identity_t<S> const& size = S(1)) {
  GroupElements<S> g;
  for (int k = 0; k < count; ++k) g.push_back(draw.template element<S>(group, size));
  return g;
}
/// Tangent vectors to G x G. Forms are tried on three of them, so that no control is small by accident.
template <class S>
std::vector<Change<S>> draw_changes(Draw& draw, SpannedGroup const& group) {
  std::vector<Change<S>> w;
  for (int k = 0; k < 3; ++k)
    w.push_back({draw.template velocity<S>(group), draw.template velocity<S>(group)});
  return w;
}
/// The values of a one-form on three tangent vectors.
template <class S, class Form>
Vector<S> on_each(std::vector<Change<S>> const& w, Form const& form) {
  Vector<S> values(3);
  for (int k = 0; k < 3; ++k) values[k] = form(w[k]);
  return values;
}
/// The values of a two-form on the three pairs of three tangent vectors.
template <class S, class Form>
Vector<S> on_pairs(std::vector<Change<S>> const& w, Form const& form) {
  Vector<S> values(3);
  for (int k = 0; k < 3; ++k) values[k] = form(w[k], w[(k + 1) % 3]);
  return values;
}
/// The variation that moves nothing.
template <class S>
Velocity<SpannedGroup, S> rest(SpannedGroup const& group) {
  return {group, Vector<S>::Zero(group.dimension())};
}

/// \f$(1 + \epsilon\vartheta)\,g\f$, written entry by entry.
template <class S>
GroupElement<Dual<S>> nudged(GroupElement<S> const& g, Velocity<SpannedGroup, S> const& theta) {
  GroupElement<Dual<S>> moved = over<Dual<S>>(g);
  Matrix<S> const rate = g.group.hat(theta.coordinates) * g.value;
  for (Index i = 0; i < rate.rows(); ++i)
    for (Index j = 0; j < rate.cols(); ++j) moved.value(i, j).part[0] = rate(i, j);
  return moved;
}
/// The covector zero.
template <class S>
Momentum<SpannedGroup, S> zero_momentum(SpannedGroup const& group) {
  return {group, Vector<S>::Zero(group.dimension())};
}

/// The sum over the pairs (first, first + 1), ..., (last, last + 1), written out.
template <class Lagrangian, class Sequence>
auto sum_over_pairs(Lagrangian const& L, Sequence const& g, int first, int last) {
  auto sum = L(g[first], g[first + 1]);
  for (int k = first + 1; k <= last; ++k) sum += L(g[k], g[k + 1]);
  return sum;
}

/// The configuration and the velocity of a curve at the instant at which its parameter is a dual number.
template <class S>
State<SpannedGroup, S> state_of(GroupElement<Dual<S>> const& q) {
  int const n = q.group.matrix_size();
  Matrix<S> configuration(n, n), change(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      configuration(i, j) = q.value(i, j).value, change(i, j) = q.value(i, j).part[0];
  GroupElement<S> const g{q.group, configuration};
  return {g, {q.group, q.group.vee(Matrix<S>(change * inverse(g).value))}};
}

/// A discretization that knows no origin: Cayley's chart at the configuration itself. Configuration half-way,
/// velocity c/h with retract(c) = g1 g0^-1.
template <class Lagrangian, class S>
auto discretize_at_the_configuration(Lagrangian L, S h) {
  return [=](auto const& g0, auto const& g1) {
    using T = typename std::decay_t<decltype(g0)>::Scalar;
    Velocity<SpannedGroup, T> const c{g0.group, g0.group.vee(inverse_cayley((g1 * inverse(g0)).value))};
    return L(State<SpannedGroup, T>{retract(c / T(2)) * g0, c / T(h)}) * T(h);
  };
}
/// How a function of a sequence of configurations changes along variations of them.
template <class S, class F>
S rate(GroupElements<S> const& g, Variations<S> const& theta, F const& f) {
  GroupElements<Dual<S>> moved;
  for (std::size_t k = 0; k < g.size(); ++k) moved.push_back(nudged(g[k], theta[k]));
  return f(moved).part[0];
}
/// The differential of a function of a sequence of configurations: its components at every configuration, one
/// after the other.
template <class S, class F>
Vector<S> differential(GroupElements<S> const& g, F const& f) {
  int const d = g[0].group.dimension(), count = static_cast<int>(g.size());
  Vector<S> all(d * count);
  for (int k = 0; k < count; ++k)
    for (int a = 0; a < d; ++a) {
      Variations<S> theta(g.size(), rest<S>(g[0].group));
      theta[k] = basis_velocity<S>(g[0].group, a);
      all[k * d + a] = rate(g, theta, f);
    }
  return all;
}
/// Covectors one after the other.
template <class S>
Vector<S> in_one_column(std::vector<Momentum<SpannedGroup, S>> const& mu) {
  Index const d = mu[0].components.size();
  Vector<S> all(d * static_cast<Index>(mu.size()));
  for (std::size_t k = 0; k < mu.size(); ++k) all.segment(static_cast<Index>(k) * d, d) = mu[k].components;
  return all;
}
/// The condition number of a matrix in the row norm: by how much a linear system magnifies rounding.
template <class S>
double condition_of(Matrix<S> const& m) { return row_norm(m) * row_norm(inverse_matrix(m)); }
/// By how much the tangent of the flow into (g1, g2) magnifies rounding: the condition of the linear system
/// that it solves.
template <class S, class Lagrangian>
double flow_condition(Lagrangian const& L, GroupElement<S> const& g1, GroupElement<S> const& g2) {
  return condition_of<S>(mixed_derivative(L, g1, g2));
}
/// The coordinates of the rates of change of a covector over dual numbers.
template <class S>
Vector<S> rates(Momentum<SpannedGroup, Dual<S>> const& mu) {
  Vector<S> v(mu.components.size());
  for (Index a = 0; a < v.size(); ++a) v[a] = mu.components[a].part[0];
  return v;
}

/// One slot of the surface \f$(s,t)\mapsto\mathrm{retract}(s\,a + t\,b)\,g\f$ along t = 0: the configuration,
/// and the velocity across, both with their rate in s.
template <class S>
std::pair<GroupElement<Dual<S>>, Velocity<SpannedGroup, Dual<S>>> along_and_across(
    GroupElement<S> const& g, Velocity<SpannedGroup, S> const& a, Velocity<SpannedGroup, S> const& b) {
  using D = Dual<S>;
  using DD = Dual<D>;
  int const n = g.group.dimension(), size = g.group.matrix_size();
  Vector<DD> v = Vector<DD>::Zero(n);
  for (int i = 0; i < n; ++i) v[i].value.part[0] = a.coordinates[i], v[i].part[0] = D(b.coordinates[i]);
  GroupElement<DD> const moved = retract(Velocity<SpannedGroup, DD>{g.group, v}) * over<DD>(g);
  GroupElement<D> configuration = over<D>(g);
  Matrix<D> across(size, size);
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j)
      configuration.value(i, j) = moved.value(i, j).value, across(i, j) = moved.value(i, j).part[0];
  return {configuration, {g.group, g.group.vee(Matrix<D>(across * inverse(configuration).value))}};
}
/// The exterior derivative of a one-form on G x G at (g0, g1), on two tangent vectors: \f$d\alpha(a,
/// b) = \partial_s\,\alpha(\partial_t) - \partial_t\,\alpha(\partial_s)\f$ on a surface with these tangents.
/// Needs no commutator of fields, so no convention about brackets enters.
/// @param form  (g0, g1, change) -> number, at every scalar
template <class S, class Form>
S exterior_derivative(Form const& form, GroupElement<S> const& g0, GroupElement<S> const& g1,
                      Change<S> const& a, Change<S> const& b) {
  auto const half = [&](Change<S> const& u, Change<S> const& v) {
    auto const [p0, across0] = along_and_across(g0, u.first, v.first);
    auto const [p1, across1] = along_and_across(g1, u.second, v.second);
    return form(p0, p1, Change<Dual<S>>{across0, across1}).part[0];
  };
  return half(a, b) - half(b, a);
}

/// A Lagrangian with terms added, linear in new coefficients, until `wrap` of it satisfies (3.2) at every
/// configuration of `g` between its ends.
///
/// @param l     a PairPolynomial (wrap: \ref as_it_is) or a GroupPolynomial (wrap: lift to pairs)
template <class S, class Polynomial, class Wrap>
Polynomial with_motion_along(Polynomial l, GroupElements<S> const& g, Draw& draw, Wrap const& wrap) {
  int const d = g[0].group.dimension(), n = g[0].group.matrix_size(), inner = static_cast<int>(g.size()) - 2;
  // Over the rationals as many terms as equations. Where numbers are rounded twice as many and the least of
  // their coefficients, so that they are small.
  int const terms = (exact_arithmetic<S>() ? 1 : 2) * d * inner;
  l.phi.clear(), l.psi.clear();
  for (int k = 0; k < 2 * d * inner; ++k)
    l.phi.push_back(draw_matrix<S>(draw, n, n)), l.psi.push_back(draw_matrix<S>(draw, n, n));
  l.phi.resize(terms), l.psi.resize(terms);
  l.correction = Vector<S>::Zero(terms);
  auto const equations = [&](Polynomial const& trial) {
    auto const lagrangian = wrap(trial);
    Vector<S> all(d * inner);
    for (int k = 0; k < inner; ++k)
      all.segment(k * d, d) = discrete_euler_lagrange(lagrangian, g[k], g[k + 1], g[k + 2]).components;
    return all;
  };
  Vector<S> const left = equations(l);
  Matrix<S> columns(d * inner, terms);
  for (int k = 0; k < terms; ++k) {
    auto one = l;
    one.correction[k] = S(1);
    columns.col(k) = equations(one) - left;
  }
  if (exact_arithmetic<S>()) {
    l.correction = -solve_linear(columns, left, "with_motion_along");
  } else {
    // The normal equations square the condition: twice again for the residual.
    Matrix<S> const transposed = columns.transpose(), square = columns * transposed;
    for (int pass = 0; pass < 3; ++pass)
      l.correction -= transposed * solve_linear(square, equations(l), "with_motion_along");
  }
  return l;
}
inline constexpr auto as_it_is = [](auto const& l) { return l; };
inline constexpr auto by_lift_right = [](auto const& l) { return lift_right(l); };
inline constexpr auto by_lift_left = [](auto const& l) { return lift_left(l); };

/// An algebra polynomial whose cubic term is too small to make it degenerate at velocities of order 1.
template <class S>
AlgebraPolynomial<S> draw_regular_algebra_polynomial(Draw& draw, SpannedGroup const& group) {
  auto l = draw_algebra_polynomial<S>(draw, group.dimension());
  l.kappa /= 16;
  return l;
}
/// A general Lagrangian on pairs of which the sequence is a motion.
template <class S>
PairPolynomial<S> draw_with_motion(Draw& draw, GroupElements<S> const& g) {
  return with_motion_along(draw_pair_polynomial<S>(draw, g[0].group), g, draw, as_it_is);
}
template <class S>
auto draw_right_invariant_with_motion(Draw& draw, GroupElements<S> const& g) {
  return lift_right(with_motion_along(draw_group_polynomial<S>(draw, g[0].group), g, draw, by_lift_right));
}
template <class S>
auto draw_left_invariant_with_motion(Draw& draw, GroupElements<S> const& g) {
  return lift_left(with_motion_along(draw_group_polynomial<S>(draw, g[0].group), g, draw, by_lift_left));
}

/// A Lagrangian on pairs, less the square of a height that depends only on the image of one basis vector.
template <class Lagrangian, class S>
struct WithHeight {
  Lagrangian lagrangian;
  Vector<S> heights;
  int fixed;
  template <class T>
  T operator()(GroupElement<T> const& g0, GroupElement<T> const& g1) const {
    T height(0);
    for (Index i = 0; i < heights.size(); ++i) height += g1.value(i, fixed) * T(heights[i]);
    return lagrangian(g0, g1) - height * height;
  }
};
/// Lifts a function on the group to a right-invariant Lagrangian, and takes such a square off.
template <class S>
auto lift_with_height(Vector<S> const& heights, int fixed) {
  return [=](auto const& l) {
    auto const lift = lift_right(l);
    return WithHeight<std::decay_t<decltype(lift)>, S>{lift, heights, fixed};
  };
}

}  // namespace actio::checks
