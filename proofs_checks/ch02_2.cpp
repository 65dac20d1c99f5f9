// Section 2.2: Euler-Poincare reduction.

#include "actio/variational/action.hpp"
#include "actio/variational/coadjoint_orbit.hpp"
#include "actio/variational/curves.hpp"
#include "actio/variational/euler_lagrange.hpp"
#include "actio/variational/euler_poincare.hpp"
#include "actio/variational/hamilton.hpp"
#include "actio/variational/lie_poisson.hpp"

#include "models/charts.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// Solving with a Hessian magnifies rounding by its condition, about 30 for these Lagrangians.
constexpr double hessian_condition = 30;

/// A polynomial of second degree in t with values in the algebra, times (t - a)(t - b) where `fixed`.
template <class S>
auto draw_path(Draw& draw, SpannedGroup const& group, S const& a, S const& b, bool fixed) {
  auto const x = draw.velocity<S>(group), y = draw.velocity<S>(group), z = draw.velocity<S>(group);
  return [=](auto const& t) {
    using T = std::decay_t<decltype(t)>;
    T const ends = fixed ? T((t - T(a)) * (t - T(b))) : T(1);
    return ends * (over<T>(x) + t * (over<T>(y) + t * over<T>(z)));
  };
}
/// l(xi + epsilon delta), its part along epsilon.
template <class S, class F>
S change_along(F const& l, Velocity<SpannedGroup, S> const& xi, Velocity<SpannedGroup, S> const& delta) {
  Velocity<SpannedGroup, Dual<S>> moving_xi{xi.group, moving(xi.coordinates, delta.coordinates)};
  return l(moving_xi).part[0];
}

/// On which side a group multiplies without changing a Lagrangian or a Hamiltonian.
enum class Side { right, left };
inline Side other(Side side) { return side == Side::right ? Side::left : Side::right; }

/// g' g^-1 where the right side counts, g^-1 g' where the left one does.
template <class T>
Velocity<SpannedGroup, T> reduced(Side side, State<SpannedGroup, T> const& v) {
  return side == Side::right ? v.velocity : body_velocity(v);
}
/// l of that velocity.
template <class F>
auto invariant(Side side, F const& l) { return [=](auto const& v) { return l(reduced(side, v)); }; }
/// The frame of a chart with its columns translated to the identity on a side.
template <class Chart, class T>
Matrix<T> frame_on(Side side, Chart const& chart, Vector<T> const& q) {
  Matrix<T> const columns = frame(chart, q);
  return side == Side::right ? columns : Matrix<T>(Ad_matrix(inverse(chart(q))) * columns);
}
/// What a statement about a side calls the other sign.
inline std::string sign_of_other(Side side) { return side == Side::right ? "+" : "-"; }

/// The Euler-Poincare equation of a side, its left-hand side along xi with its rate.
template <class F, class V>
auto equation_on(Side side, F const& l, V const& xi, V const& rate) {
  return side == Side::right ? euler_poincare_right(l, xi, rate) : euler_poincare_left(l, xi, rate);
}
/// The variation of xi that eta gives on a side.
template <class V>
V variation_on(Side side, V const& xi, V const& eta, V const& eta_rate) {
  return side == Side::right ? reduced_variation_right(xi, eta, eta_rate)
                             : reduced_variation_left(xi, eta, eta_rate);
}

/// The four conditions of Euler-Poincare reduction on one side, off shell.
template <class S>
void euler_poincare_conditions(Claim<S>& claim, Draw& draw, Side side, SpannedGroup const& group,
                               std::string const& model, Quadrature<S> const& rule) {
  auto const l = draw_algebra_polynomial<S>(draw, group.dimension());
  auto const L = invariant(side, l);

  // i and iii: (2.4) in a chart is the reduced equation, off shell, so one vanishes where the other does (the
  // frame has an inverse).
  auto const chart = chart_right(draw.template element<S>(group));
  Vector<S> const q = draw_vector<S>(draw, group.dimension()) * ratio<S>(1, 2),
                  v = draw_vector<S>(draw, group.dimension()), a = draw_vector<S>(draw, group.dimension());
  auto const xi = reduced(side, state_in(chart, q, v)),
             xi_rate = rate_of(reduced(side, state_in(chart, moving(q, v), moving(v, a))));
  Matrix<S> const columns = frame_on(side, chart, q);
  Vector<S> const full = euler_lagrange_in_coordinates(in_coordinates(L, chart), q, v, a);
  claim.equal("i and iii: (2.4) is the reduced equation", model, full,
              Vector<S>(-columns.transpose() * equation_on(side, l, xi, xi_rate).components));

  // ii and iv: every variation of g gives xi its variation in iv, so the actions vary alike.
  auto const curve = draw_retracted_curve<S>(draw, group);
  auto const family = draw_family<S>(draw, group, curve);
  S const t = ratio<S>(1, 3);
  auto const eta = [&](auto const& s) {
    auto const on_right = lifted_variation(family, s).configuration;
    return side == Side::right ? on_right : Ad(inverse(curve(s)), on_right);
  };
  auto const velocity = reduced(side, tangent(curve, t));
  S const varied = L(varied_tangent(family, t)).part[0];
  claim.equal("ii and iv: the integrands vary alike", model, varied,
              change_along<S>(l, velocity, variation_on(side, velocity, eta(t), rate_along(eta, t))));

  // iii and iv: integrate by parts along a path in the algebra, eta zero at the ends.
  S const from = ratio<S>(-1, 2), to = ratio<S>(1, 2);
  auto const path = draw_path<S>(draw, group, from, to, false),
             test = draw_path<S>(draw, group, from, to, true);
  auto const varied_action = [&](Side on) {
    return rule(
        [&](S const& s) {
          return change_along<S>(l, path(s), variation_on(on, path(s), test(s), rate_along(test, s)));
        },
        from, to);
  };
  S const against =
      rule([&](S const& s) { return pair(equation_on(side, l, path(s), rate_along(path, s)), test(s)); },
           from, to);
  claim.equal("iii and iv: integrated by parts", model, varied_action(side), S(-against), 10);

  // Controls: the sign that belongs to the other side, in iv and in iii; a Lagrangian of the other side.
  std::string const sign = sign_of_other(side);
  claim.differs("iv with variations eta' " + sign + " [xi, eta]", model, varied_action(other(side)),
                S(-against));
  claim.differs("the equation of the other side", model, full,
                Vector<S>(-columns.transpose() * equation_on(other(side), l, xi, xi_rate).components));
  claim.differs("a Lagrangian invariant on the other side", model,
                euler_lagrange_in_coordinates(in_coordinates(invariant(other(side), l), chart), q, v, a),
                full);
}

}  // namespace

STATEMENT(thm_2_2_1, "Euler-Poincare reduction: four conditions on a curve") {
  claim.corrected(R"(\delta\xi = \dot\eta - \mathrm{ad}_\xi\eta = \dot\eta + [\xi, \eta])",
                  R"(\delta\xi = \dot\eta - \mathrm{ad}_\xi\eta = \dot\eta - [\xi, \eta])",
                  "In condition iv the first expression is right, and the second one has the wrong sign. "
                  "With it the four conditions are equivalent: each step holds off shell.");
  claim.same_slip_as("claim_2_2_reduced_variation_bracket");
  Quadrature<S> const rule(14);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    euler_poincare_conditions(claim, draw, Side::right, group, model, rule);
  });
}

STATEMENT(claim_2_2_euler_poincare_equations,
          "the Euler-Poincare equations are the Euler-Lagrange equations of an invariant Lagrangian") {
  claim.holds(
      "For right-invariant Lagrangians; the paragraph before the theorem speaks of left-invariant ones, for "
      "which $\\ad^*$ has the other sign and $\\xi = g^{-1}\\dot g$ (also confirmed).");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const v = draw_state<S>(draw, group);

    // Right: the acceleration of the full system is that of the reduced one.
    auto const full = lagrange_acceleration(right_invariant(l), v),
               reduced = euler_poincare_acceleration_right(l, v.velocity);
    claim.equal("right-invariant: xi' of the reduced and of the full equations", model, full, reduced,
                hessian_condition);
    claim.zero("it solves d/dt dl/dxi + ad* dl/dxi = 0", model, euler_poincare_right(l, v.velocity, full),
               size_of(ad_star(v.velocity, gradient(l, v.velocity))), hessian_condition);
    // The rate of the momentum written out: minus the commutator with the velocity, transposed, on matrices.
    auto const rate_by_hand = [&](Velocity<SpannedGroup, S> const& xi) {
      auto const mu = gradient(l, xi);
      Vector<S> rate_of_mu(group.dimension());
      Matrix<S> const x = group.hat(xi.coordinates);
      for (int a = 0; a < group.dimension(); ++a) {
        Matrix<S> const e = group.hat(basis_velocity<S>(group, a).coordinates);
        rate_of_mu[a] = -mu.components.dot(group.vee(Matrix<S>(x * e - e * x)));
      }
      return rate_of_mu;
    };
    Vector<S> const momentum_rate = Matrix<S>(hessian(l, v.velocity)) * full.coordinates;
    claim.equal("rate of dl/dxi = - ad* dl/dxi, by commutators", model, momentum_rate,
                rate_by_hand(v.velocity), hessian_condition);
    // Left: xi = g^-1 g', whose rate is that of the full system in the body frame, Ad commuting with its own
    // velocity.
    auto const body = body_velocity(v);
    auto const body_rate = Ad(inverse(v.configuration), lagrange_acceleration(left_invariant(l), v));
    claim.equal("left-invariant: the same with the other sign", model, body_rate,
                euler_poincare_acceleration_left(l, body), 10 * hessian_condition);

    // Controls: sides exchanged; ad in place of its dual.
    claim.differs("+ ad* for a right-invariant Lagrangian", model, Vector<S>(-rate_by_hand(v.velocity)),
                  momentum_rate);
    claim.differs("the star lost", model,
                  Vector<S>(-ad_matrix(v.velocity) * gradient(l, v.velocity).components), momentum_rate);
  });
}

// ----
// Section 2.2: Lie-Poisson reduction and coadjoint orbits.
//
// The canonical bracket and Hamilton's equations are taken in coordinates (q, p) of T*G, {q, p} = 1, and
// mapped to the reduced ones.

namespace {

/// The frame of a chart is inverted: its condition is below 10 where coordinates stay below 1/2.
constexpr double frame_condition = 10;

/// The covector at chart(q) with components p, translated to the identity on the right: <mu, dg g^-1> = p.dq.
template <class Chart, class T>
Costate<SpannedGroup, T> costate_in(Chart const& chart, Vector<T> const& q, Vector<T> const& p) {
  auto const g = chart(q);
  return {g, {g.group, solve_linear(Matrix<T>(frame(chart, q).transpose()), p)}};
}
/// A function on T*G in coordinates.
template <class H, class Chart>
auto in_canonical(H const& h, Chart const& chart) {
  return [h, chart](auto const& q, auto const& p) { return h(costate_in(chart, q, p)); };
}
/// sum dF/dq dH/dp - dF/dp dH/dq.
template <class F, class H, class S>
S bracket_in_coordinates(F const& f, H const& h, Vector<S> const& q, Vector<S> const& p) {
  return slopes(f, q, p).dot(momenta(h, q, p)) - momenta(f, q, p).dot(slopes(h, q, p));
}
/// The costate of (q, p), moved along q' = dH/dp, p' = -dH/dq.
template <class H, class Chart, class S>
Costate<SpannedGroup, Dual<S>> moved_by_hamilton(H const& h, Chart const& chart, Vector<S> const& q,
                                                 Vector<S> const& p) {
  auto const f = in_canonical(h, chart);
  return costate_in(chart, moving(q, momenta(f, q, p)), moving(p, Vector<S>(-slopes(f, q, p))));
}

/// A function on T*G, invariant under nothing: \f$h(\mu) + \langle U, g\rangle\,(v\cdot\mu) + \langle W,
/// g\rangle^2\f$.
template <class S>
struct CostatePolynomial {
  AlgebraPolynomial<S> kinetic;
  Matrix<S> u, w;
  Vector<S> v;
  template <class T>
  T operator()(Costate<SpannedGroup, T> const& p) const {
    Matrix<T> const g = p.configuration.value;
    T along(0);
    for (Index i = 0; i < v.size(); ++i) along += p.momentum.components[i] * T(v[i]);
    T const well = contract(w, g);
    return kinetic(p.momentum) + contract(u, g) * along + well * well;
  }
};
template <class S>
CostatePolynomial<S> draw_costate_polynomial(Draw& draw, SpannedGroup const& group) {
  int const n = group.matrix_size();
  auto const kinetic = draw_algebra_polynomial<S>(draw, group.dimension());
  auto const u = draw_matrix<S>(draw, n, n), w = draw_matrix<S>(draw, n, n);
  return {kinetic, u, w, draw_vector<S>(draw, group.dimension())};
}

/// A chart, and a point of T*G in it.
template <class S>
auto draw_canonical(Draw& draw, SpannedGroup const& group) {
  auto const chart = chart_right(draw.element<S>(group));
  Vector<S> const q = draw_vector<S>(draw, group.dimension()) * ratio<S>(1, 2),
                  p = draw_vector<S>(draw, group.dimension());
  struct Point {
    decltype(chart_right(draw.element<S>(group))) chart;
    Vector<S> q, p;
  };
  return Point{chart, q, p};
}

}  // namespace

STATEMENT(thm_2_2_2, "the bracket that right-invariant functions give the dual algebra") {
  claim.holds(
      "With $\\{q, p\\} = +1$ on $T^*G$ and the commutator in the algebra; left-invariant "
      "functions give the minus bracket.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f = draw_algebra_polynomial<S>(draw, group.dimension()),
               h = draw_algebra_polynomial<S>(draw, group.dimension()),
               k = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const [chart, q, p] = draw_canonical<S>(draw, group);
    auto const at = costate_in(chart, q, p);

    // The canonical bracket of the lifted functions depends on lambda(p) alone, and is the plus bracket
    // there.
    S const canonical = bracket_in_coordinates(in_canonical(right_invariant_function(f), chart),
                                               in_canonical(right_invariant_function(h), chart), q, p);
    S const plus = lie_poisson_bracket_plus(f, h, at.momentum);
    claim.equal("canonical bracket of right-invariant functions", model, canonical, plus, frame_condition);
    S const from_left = bracket_in_coordinates(in_canonical(left_invariant_function(f), chart),
                                               in_canonical(left_invariant_function(h), chart), q, p);
    claim.equal("of left-invariant functions, at the body momentum: the minus bracket", model, from_left,
                lie_poisson_bracket_minus(f, h, body_momentum(at)), frame_condition);

    // It is a Poisson structure: Leibniz and Jacobi (antisymmetry is the commutator's).
    auto const product = [&](auto const& mu) { return f(mu) * k(mu); };
    auto const mu = at.momentum;
    claim.equal("Leibniz", model, lie_poisson_bracket_plus(product, h, mu),
                S(f(mu) * lie_poisson_bracket_plus(k, h, mu) + k(mu) * plus));
    auto const bracket_of = [](auto const& a, auto const& b) {
      return [&](auto const& nu) { return lie_poisson_bracket_plus(a, b, nu); };
    };
    S const cyclic[3] = {lie_poisson_bracket_plus(f, bracket_of(h, k), mu),
                         lie_poisson_bracket_plus(h, bracket_of(k, f), mu),
                         lie_poisson_bracket_plus(k, bracket_of(f, h), mu)};
    claim.zero("Jacobi", model, S(cyclic[0] + cyclic[1] + cyclic[2]),
               S(size_of(cyclic[0]) + size_of(cyclic[1]) + size_of(cyclic[2])));
    // Controls: the other sign; the bracket at the body momentum.
    claim.differs("the minus bracket", model, canonical, lie_poisson_bracket_minus(f, h, mu));
    claim.differs("at the body momentum", model, canonical,
                  lie_poisson_bracket_plus(f, h, body_momentum(at)));
  });
}

namespace {

/// \f$T_e^*R_gp\f$ where the right side counts, \f$T_e^*L_gp\f$ where the left one does.
template <class T>
Momentum<SpannedGroup, T> reduced(Side side, Costate<SpannedGroup, T> const& p) {
  return side == Side::right ? p.momentum : body_momentum(p);
}
/// h of that momentum.
template <class H>
auto invariant_function(Side side, H const& h) { return [=](auto const& p) { return h(reduced(side, p)); }; }
template <class S, class H>
Momentum<SpannedGroup, S> lie_poisson_rate(Side side, H const& h, Momentum<SpannedGroup, S> const& mu) {
  return side == Side::right ? lie_poisson_rate_right(h, mu) : lie_poisson_rate_left(h, mu);
}
template <class S, class F, class H>
S lie_poisson_bracket(Side side, F const& f, H const& h, Momentum<SpannedGroup, S> const& mu) {
  return side == Side::right ? lie_poisson_bracket_plus(f, h, mu) : lie_poisson_bracket_minus(f, h, mu);
}
/// g' g^-1 along Hamilton's equations, and its rate.
template <class H, class Chart, class S>
std::pair<Velocity<SpannedGroup, S>, Velocity<SpannedGroup, S>> velocity_and_rate(H const& in_chart,
                                                                                  Chart const& chart,
                                                                                  Vector<S> const& q,
                                                                                  Vector<S> const& p) {
  auto const q_later = moving(q, momenta(in_chart, q, p)),
             p_later = moving(p, Vector<S>(-slopes(in_chart, q, p)));
  auto const xi = rate_right(
      costate_in(chart, moving(q_later, momenta(in_chart, q_later, p_later)), moving(p_later, p_later))
          .configuration);
  return {value_of(xi), rate_of(xi)};
}

/// The four conditions of Lie-Poisson reduction on one side.
template <class S>
void lie_poisson_conditions(Claim<S>& claim, Draw& draw, Side side, SpannedGroup const& group,
                            std::string const& model) {
  auto const h = draw_algebra_polynomial<S>(draw, group.dimension()),
             f = draw_algebra_polynomial<S>(draw, group.dimension());
  auto const H = invariant_function(side, h);
  auto const F = draw_costate_polynomial<S>(draw, group);
  auto const [chart, q, p] = draw_canonical<S>(draw, group);
  auto const along = moved_by_hamilton(H, chart, q, p);
  auto const later = reduced(side, along);
  Momentum<SpannedGroup, S> const momentum{group, values(later.components)}, momentum_rate = rate_of(later);
  auto const on_right = rate_right(along.configuration);
  auto const velocity = side == Side::right ? on_right : Ad(inverse(value_of(along.configuration)), on_right);

  // i gives the equation for g, and iii; the equation for g and iii together give p', so they give i back.
  auto const reduced_rate = lie_poisson_rate(side, h, momentum);
  claim.equal("i: g' translated to the identity is dh/dmu", model, velocity, gradient(h, momentum),
              frame_condition);
  claim.equal("i and iii: the Lie-Poisson equations", model, momentum_rate, reduced_rate, frame_condition);
  Vector<S> const q_rate = solve_linear(frame_on(side, chart, q), gradient(h, momentum).coordinates);
  Vector<Dual<S>> const carried = frame_on(side, chart, moving(q, q_rate)).transpose() *
                                  moving(momentum.components, reduced_rate.components);
  claim.equal("iii and i: back to p' = - dH/dq", model, rates(carried),
              Vector<S>(-slopes(in_canonical(H, chart), q, p)), frame_condition);
  // ii and iv.
  claim.equal("ii: F' = {F, H}", model, F(along).part[0],
              bracket_in_coordinates(in_canonical(F, chart), in_canonical(H, chart), q, p), frame_condition);
  Momentum<SpannedGroup, Dual<S>> const by_iii{group, moving(momentum.components, reduced_rate.components)};
  claim.equal("iii and iv: f' is the Lie-Poisson bracket", model, f(by_iii).part[0],
              lie_poisson_bracket(side, f, h, momentum), frame_condition);

  // Controls: the sign; the momentum translated on the other side, which is constant; the other bracket.
  claim.differs("the Lie-Poisson equations with the other sign", model, momentum_rate,
                lie_poisson_rate(other(side), h, momentum));
  claim.refutes("the momentum translated on the other side", model,
                rate_of(reduced(other(side), along)) - momentum_rate, size_of(momentum) * size_of(velocity));
  claim.differs("the other bracket", model, f(by_iii).part[0],
                lie_poisson_bracket(other(side), f, h, momentum));
}

}  // namespace

STATEMENT(thm_2_2_3, "Lie-Poisson reduction of a right-invariant Hamiltonian") {
  claim.corrected(
      R"(\dot g = T_eR_g\frac{\delta h}{\delta\mu}, \quad \mu = p(0), \qquad \lambda(p) = T^*_{g}R_{g}\,p)",
      R"(\dot g = T_eR_g\frac{\delta h}{\delta\mu}, \quad \mu = \mu(t), \qquad \lambda(p) = T^*_eR_{g}\,p)",
      "The momentum in the equation for $g$ is that of the same instant; and with the index $g(t)$ in "
      "place of $e$ the map $\\lambda$ would start in another fibre. Then the four conditions are "
      "equivalent: i and ii as they stand, iii and iv together with the equation for $g$.");
  claim.same_slip_as("claim_2_2_reconstruction_velocity");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    lie_poisson_conditions(claim, draw, Side::right, group, model);
    // As printed: with the momentum at the start in the equation for g, its velocity would have no rate.
    auto const H = right_invariant_function(draw_algebra_polynomial<S>(draw, group.dimension()));
    auto const [chart, q, p] = draw_canonical<S>(draw, group);
    auto const [xi, xi_rate] = velocity_and_rate(in_canonical(H, chart), chart, q, p);
    claim.refutes("as printed: mu of the start in the equation for g", model, xi_rate, size_of(xi));
  });
}

STATEMENT(claim_2_2_reconstruction_velocity, "which momentum moves the group element") {
  claim.corrected(R"(\dot g = T_eR_g\frac{\delta h}{\delta\mu}, \quad \mu = p(0))",
                  R"(\dot g = T_eR_g\frac{\delta h}{\delta\mu}, \quad \mu = \mu(t) = \lambda(p(t)))",
                  "The momentum is that of the same instant, translated to the identity. With the momentum "
                  "frozen at its initial value $g$ would be a one-parameter group; and $p(0)$ is a "
                  "covector at $g(0)$, not an element of the dual algebra.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const h = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const H = right_invariant_function(h);
    auto const [chart, q, p] = draw_canonical<S>(draw, group);
    auto const at = costate_in(chart, q, p);

    // Hamilton's equations move g by the momentum of this instant,
    auto const xi = rate_right(moved_by_hamilton(H, chart, q, p).configuration);
    claim.equal("g' g^-1 = dh/dmu at mu(t)", model, xi, gradient(h, at.momentum), frame_condition);
    // at the next instant by that of the next: the rate of the velocity is that of dh/dmu along mu'.
    auto const xi_rate = velocity_and_rate(in_canonical(H, chart), chart, q, p).second;
    Momentum<SpannedGroup, Dual<S>> const later{
        group, moving(at.momentum.components, lie_poisson_rate_right(h, at.momentum).components)};
    claim.equal("and stays so", model, xi_rate, rate_of(gradient(h, later)), 10 * frame_condition);
    // Controls: the momentum frozen, whose velocity has no rate; the components of p(0) taken for an element
    // of the dual algebra.
    claim.refutes("mu frozen at its initial value", model, xi_rate, size_of(xi));
    claim.differs("components of p(0) in a chart", model, gradient(h, Momentum<SpannedGroup, S>{group, p}),
                  xi);
  });
}

STATEMENT(claim_2_2_lie_poisson_equivalence,
          "Hamilton's equations, Lie-Poisson equations and brackets say the same") {
  claim.holds(
      "Conditions iii and iv say nothing about $g$: the equation for $g$ is "
      "needed to come back to i and ii.");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    int const n = group.dimension();
    auto const F = draw_costate_polynomial<S>(draw, group), H = draw_costate_polynomial<S>(draw, group);
    auto const h = draw_algebra_polynomial<S>(draw, n);
    auto const invariant = right_invariant_function(h);
    auto const [chart, q, p] = draw_canonical<S>(draw, group);
    auto const at = costate_in(chart, q, p);

    // The canonical structure of the library, for functions invariant under nothing, against coordinates.
    claim.equal("canonical bracket without coordinates", model, canonical_bracket(F, H, at),
                bracket_in_coordinates(in_canonical(F, chart), in_canonical(H, chart), q, p),
                frame_condition);
    auto const along = moved_by_hamilton(H, chart, q, p);
    auto const field = hamiltonian_vector_field(H, at);
    claim.equal("Hamilton's equations, configuration", model, field.configuration,
                rate_right(along.configuration), frame_condition);
    claim.equal("Hamilton's equations, momentum", model, field.momentum, rate_of(along.momentum),
                frame_condition);
    claim.equal("i and ii: F' = {F, H}", model, F(moved(at, field)).part[0], canonical_bracket(F, H, at));

    // Brackets with the coordinate functions give all rates back: ii gives i, and iv gives iii.
    auto const reduced = hamiltonian_vector_field(invariant, at);
    for (int a = 0; a < n; ++a) {
      auto const component = [a](auto const& x) {
        if constexpr (requires { x.momentum; })
          return x.momentum.components[a];
        else
          return x.components[a];
      };
      S const expected = lie_poisson_rate_right(h, at.momentum).components[a];
      auto const scale = size_of(reduced.momentum);
      claim.zero("ii for the components of the momentum", model,
                 S(canonical_bracket(component, invariant, at) - expected), scale);
      claim.zero("iv for the components of the momentum", model,
                 S(lie_poisson_bracket_plus(component, h, at.momentum) - expected), scale);
    }
    // Controls: with g moved by something else iii and iv hold and i and ii do not; the canonical bracket
    // without its last term.
    auto astray = reduced;
    astray.configuration = draw.template velocity<S>(group);
    claim.differs("another motion of g", model, F(moved(at, astray)).part[0],
                  canonical_bracket(F, invariant, at));
    claim.differs("the term <mu, [F, H]> left out", model,
                  S(canonical_bracket(F, H, at) -
                    pair(at.momentum, bracket(momentum_derivative(F, at), momentum_derivative(H, at)))),
                  canonical_bracket(F, H, at));
    claim.differs("the reduced equations for a Hamiltonian that is not invariant", model, field.momentum,
                  -ad_star(field.configuration, at.momentum));
  });
}

STATEMENT(claim_2_2_left_reduction, "Euler-Poincare and Lie-Poisson reduction on the left") {
  claim.holds(
      "The theorems for multiplication from the left, with $\\xi = g^{-1}\\dot g$, $\\mu = T_e^*L_g\\,p$, "
      "the signs $\\frac{d}{dt}\\frac{\\delta l}{\\delta\\xi} = \\ad^*_\\xi\\frac{\\delta l}{\\delta\\xi}$, "
      "$\\delta\\xi = \\dot\\eta + [\\xi,\\eta]$, $\\dot\\mu = \\ad^*_{\\delta h/\\delta\\mu}\\mu$ and the "
      "minus bracket; the spatial momentum is constant, and $\\mu = \\Ad^*_g$ of it.");
  Quadrature<S> const rule(14);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    euler_poincare_conditions(claim, draw, Side::left, group, model, rule);
    lie_poisson_conditions(claim, draw, Side::left, group, model);

    // The bracket that left-invariant functions give is one of Poisson.
    auto const f = draw_algebra_polynomial<S>(draw, group.dimension()),
               h = draw_algebra_polynomial<S>(draw, group.dimension()),
               k = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const [chart, q, p] = draw_canonical<S>(draw, group);
    auto const at = costate_in(chart, q, p);
    auto const mu = body_momentum(at);
    S const canonical = bracket_in_coordinates(in_canonical(left_invariant_function(f), chart),
                                               in_canonical(left_invariant_function(h), chart), q, p),
            minus = lie_poisson_bracket_minus(f, h, mu);
    claim.equal("canonical bracket of left-invariant functions", model, canonical, minus, frame_condition);
    auto const product = [&](auto const& nu) { return f(nu) * k(nu); };
    claim.equal("Leibniz", model, lie_poisson_bracket_minus(product, h, mu),
                S(f(mu) * lie_poisson_bracket_minus(k, h, mu) + k(mu) * minus));
    claim.differs("at the spatial momentum", model, canonical, lie_poisson_bracket_minus(f, h, at.momentum));
    // Left-invariant motions keep the spatial momentum, and with it the orbit of the other.
    auto const along = moved_by_hamilton(left_invariant_function(h), chart, q, p);
    claim.zero("the spatial momentum is constant", model, rate_of(along.momentum),
               size_of(rate_of(body_momentum(along))), frame_condition);
    auto const curve = draw_retracted_curve<S>(draw, group);
    S const t = ratio<S>(1, 3);
    claim.equal("Ad*_g of a constant momentum solves mu' = ad*_xi mu", model,
                rate_of(Ad_star(curve(variable(t)), over<Dual<S>>(mu))),
                ad_star(body_velocity(tangent(curve, t)), Ad_star(curve(t), mu)), frame_condition);
    claim.differs("with the inverse of g", model,
                  rate_of(Ad_star(inverse(curve(variable(t))), over<Dual<S>>(mu))),
                  ad_star(body_velocity(tangent(curve, t)), Ad_star(inverse(curve(t)), mu)));
  });
}

namespace {

/// The Legendre transform of a function on the algebra, or on its dual, near one point: \f$y\cdot x - f(x)\f$
/// with \f$\partial f/\partial x = y\f$. The equation for x is solved by the iteration of Newton with the
/// slope at the point, which is exact over dual numbers after as many steps as they are nested.
template <class S, class F>
struct LegendreTransform {
  F f;
  Vector<S> x;
  Matrix<S> inverse_hessian;
  Velocity<SpannedGroup, S> form;  // the group

  template <class T>
  T operator()(Momentum<SpannedGroup, T> const& y) const { return value(y.components); }
  template <class T>
  T operator()(Velocity<SpannedGroup, T> const& y) const { return value(y.coordinates); }

 private:
  template <class T>
  T value(Vector<T> const& y) const {
    Velocity<SpannedGroup, T> at{form.group, x.template cast<T>()};
    for (int step = 0; step < 3; ++step)
      at.coordinates += inverse_hessian.template cast<T>() * (y - gradient(f, at).components);
    return y.dot(at.coordinates) - f(at);
  }
};
template <class S, class F>
LegendreTransform<S, F> legendre_transform(F const& f, Velocity<SpannedGroup, S> const& xi) {
  return {f, xi.coordinates, inverse_matrix(Matrix<S>(hessian(f, xi))), xi};
}

}  // namespace

STATEMENT(claim_2_2_euler_poincare_lie_poisson,
          "Euler-Poincare and Lie-Poisson equations, and Legendre's transformation") {
  claim.convention(
      "Where $l$, or $h$, is regular: with $\\mu = \\delta l/\\delta\\xi$ and $h = \\langle\\mu,\\xi\\rangle "
      "- l$ the one system is the other, off shell and on both sides, and from $h$ in the same way back; "
      "on $TG$ and $T^*G$, for right-invariant functions, the Legendre transformation of the Lagrangian "
      "takes its vector field to that of the Hamiltonian.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    int const n = group.dimension();
    auto const l = draw_algebra_polynomial<S>(draw, n);
    auto const xi = draw.template velocity<S>(group), xi_rate = draw.template velocity<S>(group);
    auto const mu = gradient(l, xi);
    auto const h = legendre_transform(l, xi);
    Momentum<SpannedGroup, S> const mu_rate{group, Vector<S>(hessian(l, xi) * xi_rate.coordinates)};

    // From l to h. The inverse of the Hessian enters.
    claim.equal("dh/dmu = xi", model, gradient(h, mu), xi, hessian_condition);
    claim.equal("the energy", model, h(mu), S(pair(mu, xi) - l(xi)), hessian_condition);
    claim.equal("Euler-Poincare = Lie-Poisson, from the right", model, euler_poincare_right(l, xi, xi_rate),
                mu_rate - lie_poisson_rate_right(h, mu), hessian_condition);
    claim.equal("Euler-Poincare = Lie-Poisson, from the left", model, euler_poincare_left(l, xi, xi_rate),
                mu_rate - lie_poisson_rate_left(h, mu), hessian_condition);
    // From a Hamiltonian back: its transform has xi for dh/dmu, and the same equations.
    auto const k = draw_algebra_polynomial<S>(draw, n);
    auto const velocity = gradient(k, mu);
    Velocity<SpannedGroup, S> const mu_as_point{group, mu.components};
    auto const back = legendre_transform(k, mu_as_point);
    claim.equal("dl/dxi = mu", model, gradient(back, velocity), mu, hessian_condition);
    auto const mu_rates = draw.template momentum<S>(group);
    Velocity<SpannedGroup, S> const accelerated{group,
                                                Vector<S>(hessian(k, mu_as_point) * mu_rates.components)};
    claim.equal("Lie-Poisson = Euler-Poincare, from the right", model,
                euler_poincare_right(back, velocity, accelerated), mu_rates - lie_poisson_rate_right(k, mu),
                hessian_condition);
    claim.equal("Lie-Poisson = Euler-Poincare, from the left", model,
                euler_poincare_left(back, velocity, accelerated), mu_rates - lie_poisson_rate_left(k, mu),
                hessian_condition);

    // On TG and T*G: the reduced momentum of the Legendre transformation, and the two vector fields.
    State<SpannedGroup, S> const v{draw.template element<S>(group), xi};
    auto const L = right_invariant(l);
    Costate<SpannedGroup, S> const p{v.configuration, legendre(L, v)};
    claim.equal("the Legendre transformation reduces to dl/dxi", model, p.momentum, mu);
    auto const field = hamiltonian_vector_field(right_invariant_function(h), p);
    claim.equal("its image of the Lagrange vector field: configuration", model, field.configuration, xi,
                hessian_condition);
    claim.equal("its image of the Lagrange vector field: momentum", model, field.momentum,
                rate_of(legendre(L, moved(v, lagrange_vector_field(L, v)))), hessian_condition);

    // Controls: the Lagrangian taken for the Hamiltonian, at its own velocity or at the components of mu; the
    // sign of the other side.
    claim.differs("l at the velocity of mu for the Hamiltonian", model,
                  Vector<S>(inverse_matrix(Matrix<S>(hessian(l, xi))) * mu.components), xi.coordinates);
    claim.differs("Lie-Poisson with the other sign", model, euler_poincare_right(l, xi, xi_rate),
                  mu_rate - lie_poisson_rate_left(h, mu));
    claim.differs("velocity and momentum exchanged: the gradient of l at mu", model, gradient(l, mu), xi);
  });
}

// ----
// Section 2.2: coadjoint orbits, their symplectic forms, and motion along them.

namespace {

/// Finding the generator of a tangent vector inverts ad* mu on its image, whose condition is below 100 for
/// generic momenta of order 1.
constexpr double orbit_condition = 100;

/// Dimension of the span of some vectors.
template <class S>
int rank_of(Matrix<S> m) {
  int rank = 0;
  Base<S> const floor = Base<S>(1000) * epsilon<S>() * magnitude(m);
  for (Index c = 0; c < m.cols() && rank < m.rows(); ++c) {
    Index best = rank;
    for (Index i = rank; i < m.rows(); ++i)
      if (magnitude(m(i, c)) > magnitude(m(best, c))) best = i;
    if (!(magnitude(m(best, c)) > floor)) continue;
    m.row(rank).swap(m.row(best));
    for (Index i = rank + 1; i < m.rows(); ++i) m.row(i) -= (m.row(rank) * S(m(i, c) / m(rank, c))).eval();
    ++rank;
  }
  return rank;
}

}  // namespace

namespace {

/// d omega on a surface in an orbit, \f$a\mapsto\Ad^*_{g(a)^{-1}}\mu\f$ with three parameters, where omega is
/// the form of the library times a function; and the size of its terms.
template <class S, class Factor>
std::pair<S, S> derivative_of_form(Momentum<SpannedGroup, S> const& mu,
                                   std::array<Velocity<SpannedGroup, S>, 3> const& along,
                                   Factor const& factor) {
  auto const surface = [&]<class T>(std::array<T, 3> const& a) {
    auto const g = retract(a[0] * over<T>(along[0])) * retract(a[1] * over<T>(along[1])) *
                   retract(a[2] * over<T>(along[2]));
    return Ad_star(inverse(g), over<T>(mu));
  };
  // The component (j, k) as a function of the parameters, which move in direction i.
  auto const component = [&](int i, int j, int k) {
    using D = Dual<S>;
    auto const at = [&](int moved) {
      std::array<Dual<D>, 3> a;
      for (int c = 0; c < 3; ++c) {
        D place(ratio<S>(c + 1, 7));
        place.part[0] = S(c == i ? 1 : 0);
        a[c] = Dual<D>(place);
        a[c].part[0] = D(S(c == moved ? 1 : 0));
      }
      return surface(a);
    };
    auto const v = at(j), w = at(k);
    Momentum<SpannedGroup, D> const here{mu.group, values(v.components)};
    return D(kirillov_kostant_plus(here, rate_of(v), rate_of(w)) * factor(here)).part[0];
  };
  S const parts[3] = {component(0, 1, 2), component(1, 2, 0), component(2, 0, 1)};
  return {S(parts[0] + parts[1] + parts[2]), S(size_of(parts[0]) + size_of(parts[1]) + size_of(parts[2]))};
}
/// The form is closed on orbits of dimension 4, and one times a function that is not constant on them is not.
template <class S>
void close_the_form(Claim<S>& claim, Draw& draw) {
  static std::vector<SpannedGroup> const groups = {spanned("SO(4)", SO<4>{}), spanned("SE(3)", SE<3>{})};
  over_groups(groups, claim, [&](auto const& group, auto const& model) {
    auto const mu = draw.template momentum<S>(group);
    auto const direction = [&] { return draw.template velocity<S>(group, ratio<S>(1, 2)); };
    auto const first = direction(), second = direction();
    std::array<Velocity<SpannedGroup, S>, 3> const along{first, second, direction()};
    auto const [closed, size] = derivative_of_form(
        mu, along, [](auto const& nu) { return typename std::decay_t<decltype(nu)>::Scalar(S(1)); });
    claim.zero("the form is closed, on an orbit of dimension 4", model, closed, size, orbit_condition);
    // A function that the orbit does not keep.
    auto const [open, terms] = derivative_of_form(mu, along, [](auto const& nu) { return nu.components[0]; });
    claim.refutes("times a component of the momentum", model, open, terms);
  });
}

}  // namespace

STATEMENT(claim_2_2_coadjoint_orbits, "coadjoint orbits lie in the dual algebra, and are symplectic") {
  claim.corrected(R"(\mathcal O \subset \mathfrak g)", R"(\mathcal O \subset \mathfrak g^*)",
                  "The orbit of a momentum under the coadjoint action lies in the dual of the algebra; "
                  "tangent vectors of orbits in the algebra are others. The form is not degenerate, closed "
                  "(its derivative on surfaces with three parameters in orbits of dimension 4), and the "
                  "only one that gives the bracket: fields of linear functions span the tangent space.");
  claim.maybe_scan();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const curve = draw_retracted_curve<S>(draw, group);
    auto const mu = draw.template momentum<S>(group);
    S const t = ratio<S>(1, 3);
    Dual<S> time(t);
    time.part[0] = S(1);
    auto const here = Ad_star(inverse(curve(t)), mu);

    // The orbit through mu: its tangent vectors are ad* of velocities, whatever the curve in G.
    auto const tangent_vector = rate_of(Ad_star(inverse(curve(time)), over<Dual<S>>(mu)));
    claim.equal("tangent vectors are ad*", model, ad_star(orbit_generator(here, tangent_vector), here),
                tangent_vector, orbit_condition);
    // The form is well defined: the generators that the library finds give what any others give.
    auto const xi = draw.template velocity<S>(group), eta = draw.template velocity<S>(group);
    auto const v = ad_star(xi, here), w = ad_star(eta, here);
    auto const form = kirillov_kostant_plus(here, v, w);
    claim.equal("the form does not depend on the generators", model, form, pair(here, bracket(xi, eta)),
                orbit_condition);
    claim.equal("antisymmetric", model, kirillov_kostant_plus(here, w, v), S(-form), orbit_condition);
    // Not degenerate: its rank is the dimension of the orbit, an even number.
    if (exact_arithmetic<S>()) {
      int const d = group.dimension();
      std::vector<Momentum<SpannedGroup, S>> basis;
      Matrix<S> tangents(d, d), form_matrix(d, d);
      for (int a = 0; a < d; ++a) {
        basis.push_back(ad_star(basis_velocity<S>(group, a), here));
        tangents.col(a) = basis[a].components;
      }
      for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b) form_matrix(a, b) = kirillov_kostant_plus(here, basis[a], basis[b]);
      claim.fact("rank of the form = dimension of the orbit, even", model,
                 rank_of(form_matrix) == rank_of(tangents) && rank_of(tangents) % 2 == 0);
    }
    // The form belongs to the bracket: omega_+(X_f, X_h) = {f, h}_+, which leaves no choice for it.
    auto const f = draw_algebra_polynomial<S>(draw, group.dimension()),
               h = draw_algebra_polynomial<S>(draw, group.dimension());
    S const plus = lie_poisson_bracket_plus(f, h, here);
    claim.equal("omega_+ of Hamiltonian fields is the plus bracket", model,
                kirillov_kostant_plus(here, lie_poisson_rate_right(f, here), lie_poisson_rate_right(h, here)),
                plus, orbit_condition);
    claim.equal("omega_- and the minus bracket", model,
                kirillov_kostant_minus(here, lie_poisson_rate_left(f, here), lie_poisson_rate_left(h, here)),
                S(-plus), orbit_condition);
    claim.differs(
        "omega_- for the plus bracket", model,
        kirillov_kostant_minus(here, lie_poisson_rate_right(f, here), lie_poisson_rate_right(h, here)), plus);
    // Control: orbits in the algebra, as printed. A tangent vector of the one is none of the other, but for
    // the groups closed under transposition.
    if (group.name() == "SE(3)" || group.name() == "SL(2)" || group.name() == "SE(2)") {
      Momentum<SpannedGroup, S> const misplaced{group, xi.coordinates},
          misplaced_tangent{group, bracket(eta, xi).coordinates};
      claim.template refuses<OutsideDomain>("a tangent vector of the orbit in the algebra", model,
                                            [&] { orbit_generator(misplaced, misplaced_tangent); });
    }
  });
  close_the_form(claim, draw);
}

STATEMENT(claim_2_2_reduced_motion, "reduced motion along the coadjoint orbit") {
  claim.corrected(
      R"(\mu(t) = \mathrm{Ad}^*_{g^{-1}(t)}\mu_0,\quad \mu_0 = J(g(t)))",
      R"(\mu(t) = \mathrm{Ad}^*_{g^{-1}(t)}\mu_0,\quad \mu_0 = J(p(t)))",
      "The momentum is no function of the configuration. $J = T_e^*L_g\\,p$ is the momentum map of "
      "multiplication from the right: for a right-invariant Hamiltonian the body momentum is constant and "
      "$\\mu(t)$ is the spatial one; $\\mu_0$ is its initial value only if $g(0) = e$. $\\Ad^*_{g^{-1}}$ "
      "is the dual of $\\Ad_{g^{-1}}$.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const h = draw_algebra_polynomial<S>(draw, group.dimension());
    Costate<SpannedGroup, S> const p{draw.template element<S>(group), draw.template momentum<S>(group)};
    auto const zeta = draw.template velocity<S>(group);
    auto const along = moved(p, hamiltonian_vector_field(right_invariant_function(h), p));
    auto const J = body_momentum(p);

    // J pairs p with the generator g zeta of multiplication from the right; along motions it is constant.
    Matrix<S> const generator =
        p.configuration.value * group.hat(zeta.coordinates) * inverse_matrix(p.configuration.value);
    claim.equal("J is the momentum map of multiplication from the right", model, pair(J, zeta),
                pair(p.momentum, Velocity<SpannedGroup, S>{group, group.vee(generator)}));
    claim.zero("J is constant along motions", model, rate_of(body_momentum(along)),
               size_of(rate_of(along.momentum)));
    // So mu is carried back from it by g, over whatever time.
    claim.equal("mu = Ad*_{g^-1} J", model, Ad_star(inverse(p.configuration), J), p.momentum);
    // The other way round: along any curve, mu(t) = Ad*_{g^-1(t)} mu_0 has the rate - ad*_xi mu of the
    // Lie-Poisson equations with xi = g' g^-1.
    auto const curve = draw_retracted_curve<S>(draw, group);
    S const t = ratio<S>(1, 3);
    Dual<S> time(t);
    time.part[0] = S(1);
    auto const mu = Ad_star(inverse(curve(t)), J),
               mu_rate = rate_of(Ad_star(inverse(curve(time)), over<Dual<S>>(J)));
    claim.equal("the formula solves mu' = - ad*_xi mu", model, mu_rate,
                -ad_star(tangent(curve, t).velocity, mu));

    // As printed, a function of the configuration: another momentum at the same one has another value.
    Costate<SpannedGroup, S> const beside{p.configuration, p.momentum + p.momentum};
    claim.differs("J a function of g, as printed", model, body_momentum(beside), J);
    // Controls: no inverse; the spatial momentum taken for the constant one; the initial value of mu although
    // g(0) is not e; a left-invariant Hamiltonian.
    claim.differs("Ad*_g", model, Ad_star(p.configuration, J), p.momentum);
    auto const without_inverse = rate_of(Ad_star(curve(time), over<Dual<S>>(J)));
    claim.differs("Ad*_g solves it too", model, without_inverse,
                  -ad_star(tangent(curve, t).velocity, Ad_star(curve(t), J)));
    auto const g0 = curve(S(0));
    claim.differs("mu_0 = mu(0) although g(0) is not e", model,
                  Ad_star(inverse(curve(t)), Ad_star(inverse(g0), J)), mu);
    auto const of_left = moved(p, hamiltonian_vector_field(left_invariant_function(h), p));
    claim.refutes("J of a left-invariant Hamiltonian", model, rate_of(body_momentum(of_left)), size_of(J));
  });
}

STATEMENT(claim_2_2_coadjoint_action_kk, "the coadjoint action preserves the Kirillov-Kostant forms") {
  claim.holds();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const mu = draw.template momentum<S>(group);
    auto const g = draw.template element<S>(group, S(1));
    auto const v = ad_star(draw.template velocity<S>(group), mu),
               w = ad_star(draw.template velocity<S>(group), mu);
    auto const act = [&](Momentum<SpannedGroup, S> const& nu) { return Ad_star(inverse(g), nu); };

    // Ad* is linear, so it carries tangent vectors as it carries momenta. The form finds its generators at
    // the new configuration afresh.
    S const before = kirillov_kostant_plus(mu, v, w);
    claim.equal("omega_+ at the new configuration on carried vectors", model,
                kirillov_kostant_plus(act(mu), act(v), act(w)), before, orbit_condition);
    claim.equal("omega_-", model, kirillov_kostant_minus(act(mu), act(v), act(w)), S(-before),
                orbit_condition);
    claim.equal("carried vectors are tangent to the orbit", model,
                ad_star(orbit_generator(act(mu), act(v)), act(mu)), act(v), orbit_condition);
    claim.equal("Ad* composes in the order of the group", model, act(Ad_star(inverse(g), v)),
                Ad_star(inverse(g * g), v));
    // Controls: another linear map of orbits to orbits; the star left out, on groups where that makes a
    // difference.
    auto const twice = [&](Momentum<SpannedGroup, S> const& nu) { return S(2) * nu; };
    claim.differs("multiplication by 2 instead", model, kirillov_kostant_plus(twice(mu), twice(v), twice(w)),
                  before);
    auto const starless = [&](Momentum<SpannedGroup, S> const& nu) {
      return Momentum<SpannedGroup, S>{group, Ad_matrix(g) * nu.components};
    };
    if (group.name() == "Aff(1)")
      claim.differs("Ad_g without its star", model,
                    kirillov_kostant_plus(starless(mu), starless(v), starless(w)), before);
    if (group.name() == "SE(3)" || group.name() == "Heisenberg" || group.name() == "SE(2)")
      claim.template refuses<OutsideDomain>("Ad_g without its star", model, [&] {
        kirillov_kostant_plus(starless(mu), starless(v), starless(w));
      });
  });
}

// ----
// Section 2.2: the variations of the reduced velocity.

namespace {}  // namespace

STATEMENT(claim_2_2_reduced_variation_ad, "variation of the reduced velocity, with $\\ad$") {
  claim.holds(
      "With $\\eta = \\delta g\\,g^{-1}$, $\\xi = \\dot g\\,g^{-1}$ and $\\ad_\\xi\\eta = [\\xi,\\eta]$, the "
      "commutator.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const curve = draw_retracted_curve<S>(draw, group);
    auto const family = draw_family<S>(draw, group, curve);
    S const t = ratio<S>(1, 3);
    auto const eta = [&](auto const& s) { return lifted_variation(family, s).configuration; };
    auto const xi = tangent(curve, t).velocity, eta_rate = rate_along(eta, t);

    // Differentiate g' g^-1 by epsilon, on matrices.
    auto const delta = lifted_variation(family, t).velocity;
    claim.equal("delta xi = eta' - ad_xi eta", model, delta, reduced_variation_right(xi, eta(t), eta_rate));
    // Every eta comes from a variation: the one with g_epsilon = retract(epsilon eta) g.
    auto const chosen = draw.template velocity<S>(group);
    auto const constant = [&](auto const& e, auto const& s) {
      using T = std::decay_t<decltype(s)>;
      return retract(e * over<T>(chosen)) * curve(s);
    };
    claim.equal("every eta occurs", model, lifted_variation(constant, t).configuration, chosen);
    claim.equal("a constant eta gives - ad_xi eta", model, lifted_variation(constant, t).velocity,
                -ad(xi, chosen));
    // Controls: the sign of left-invariant systems; ad left out.
    claim.differs("eta' + ad_xi eta", model, delta, reduced_variation_left(xi, eta(t), eta_rate));
    claim.differs("eta' alone", model, delta, eta_rate);
  });
}

STATEMENT(claim_2_2_reduced_variation_bracket, "variation of the reduced velocity, with the bracket") {
  claim.corrected(R"(\delta\xi = \dot\eta - \mathrm{ad}_\xi\eta = \dot\eta + [\xi, \eta])",
                  R"(\delta\xi = \dot\eta - \mathrm{ad}_\xi\eta = \dot\eta - [\xi, \eta])",
                  "The thesis defines $\\ad_\\xi\\eta = [\\xi,\\eta]$ (Theorem 2.2.3), so the two printed "
                  "expressions differ in every group that is not abelian. The plus sign belongs to $\\xi = "
                  "g^{-1}\\dot g$ and $\\eta = g^{-1}\\delta g$, the left-invariant case.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const curve = draw_retracted_curve<S>(draw, group);
    auto const family = draw_family<S>(draw, group, curve);
    S const t = ratio<S>(1, 3);
    auto const commutator = [&](Velocity<SpannedGroup, S> const& x, Velocity<SpannedGroup, S> const& y) {
      Matrix<S> const a = group.hat(x.coordinates), b = group.hat(y.coordinates);
      return Velocity<SpannedGroup, S>{group, group.vee(Matrix<S>(a * b - b * a))};
    };
    auto const eta = [&](auto const& s) { return lifted_variation(family, s).configuration; };
    auto const xi = tangent(curve, t).velocity, delta = lifted_variation(family, t).velocity;
    claim.equal("delta xi = eta' - [xi, eta]", model, delta, rate_along(eta, t) - commutator(xi, eta(t)));

    // Seen from the body the sign is plus.
    auto const body_eta = [&](auto const& s) { return Ad(inverse(curve(s)), eta(s)); };
    auto const varied = varied_tangent(family, t);
    auto const body_xi = Ad(inverse(varied.configuration), varied.velocity);
    claim.equal("g^-1 g' varies by eta' + [xi, eta]", model, rate_of(body_xi),
                rate_along(body_eta, t) + commutator(value_of(body_xi), body_eta(t)));
    // Control: as printed.
    claim.differs("as printed, eta' + [xi, eta]", model, delta, rate_along(eta, t) + commutator(xi, eta(t)));
  });
}
