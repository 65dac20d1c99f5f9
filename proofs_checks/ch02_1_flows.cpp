// Section 2.1, over finite times: the action of motions, their flow, and what it preserves.
//
// The flow is a polynomial in time (exact_motions.hpp), integrals are exact, so every residual is zero over
// the rationals. Flows that are no polynomials are tried in double and 50 digits.

#include "actio/variational/curves.hpp"
#include "actio/variational/euler_lagrange.hpp"
#include "actio/variational/lagrange_forms.hpp"
#include "actio/variational/momentum_map.hpp"

#include "models/charts.hpp"
#include "models/exact_motions.hpp"
#include "models/top_in_any_group.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// Fifteen nodes and the nested rates of a flow magnify a rounding error about tenfold.
constexpr double amplification = 10;

/// The tangent of the flow of exact motions.
template <class S>
StateChange<SpannedGroup, S> flow_tangent(ExactMotions<S> const& m, State<SpannedGroup, S> const& v,
                                          StateChange<SpannedGroup, S> const& w, S const& t) {
  return change_of(m.flow(moved(v, w), Dual<S>(t)));
}
/// S_t, the action of the motion from v, as (2.7) says it.
template <class T, class S>
T action_of_motion(ExactMotions<S> const& m, State<SpannedGroup, T> const& v, S const& t,
                   Quadrature<S> const& rule) {
  return rule([&](T const& s) { return m(m.flow(v, s)); }, T(0), T(t));
}

/// Groups on which flows are no polynomials. A hundred digits would take minutes here and are left out.
inline std::vector<SpannedGroup> const& turning_groups() {
  static std::vector<SpannedGroup> const groups = {spanned("SO(3)", SO<3>{}), spanned("SE(2)", SE<2>{})};
  return groups;
}
/// The one of them on which sides differ, for what takes several flows: in digits these take seconds.
inline std::vector<SpannedGroup> const& turning_group() {
  static std::vector<SpannedGroup> const groups = {spanned("SE(2)", SE<2>{})};
  return current_arithmetic().kind() == ArithmeticKind::hardware ? turning_groups() : groups;
}
inline bool has_series() { return !current_arithmetic().exact() && current_arithmetic().digits() <= 50; }
/// A dozen steps of the series, errors growing with the flow.
constexpr double series_amplification = 20;

}  // namespace

STATEMENT(eq_2_7, "the action as a function of the initial velocity") {
  claim.holds();
  Quadrature<S> const rule(polynomial_degree);
  over_groups(entry_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_exact_motions<S>(draw, group);
    auto const v = draw_near_state<S>(draw, group);
    S const t = ratio<S>(1, 3), s = ratio<S>(1, 5);
    auto const after = m.flow(v, t);

    // (g(s), g'(s)) = F_s(v) solves (2.4) and begins at v; F is a flow. This is what S_t integrates along.
    auto const motion = m.motion(v);
    claim.equal("F_s(v) is the tangent of a curve", model, after.velocity, tangent(motion, t).velocity,
                amplification);
    claim.zero("that solves the Euler-Lagrange equations", model,
               euler_lagrange(m, after, second_tangent(motion, t).velocity),
               size_of(ad_star(after.velocity, legendre(m, after))), 10 * amplification);
    // Motions follow one another, so their actions add up; the rate is the Lagrangian.
    S const whole = action_of_motion(m, v, S(t + s), rule), first = action_of_motion(m, v, t, rule);
    claim.equal("S_{t+s}(v) = S_t(v) + S_s(F_t v)", model, whole,
                S(first + action_of_motion(m, after, s, rule)), amplification);
    claim.equal("S_t is the action of the motion", model, first, action(m, motion, S(0), t, rule),
                amplification);
    // Controls: the second piece begun at v again; the action along another curve from v.
    claim.differs("second piece from v", model, whole, S(first + action_of_motion(m, v, s, rule)));
    auto const straight = [&](auto const& x) {
      using T = std::decay_t<decltype(x)>;
      Matrix<T> const g = v.configuration.value.template cast<T>(),
                      rate = Matrix<S>(group.hat(v.velocity.coordinates) * v.configuration.value)
                                 .template cast<T>();
      return m.configuration(Vector<T>(m.read(g) + m.read(rate) * x + m.fall.template cast<T>() * (x * x)));
    };
    claim.differs("another curve from v", model, action(m, straight, S(0), t, rule), first);
  });
}

STATEMENT(eq_2_8, "differential of the action on solutions") {
  claim.holds();
  Quadrature<S> const rule(polynomial_degree);
  over_groups(entry_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_exact_motions<S>(draw, group);
    auto const v = draw_near_state<S>(draw, group);
    auto const w = draw_change<S>(draw, group);
    S const t = ratio<S>(1, 3);

    S const dS = action_of_motion(m, moved(v, w), t, rule).part[0];
    S const after = lagrange_one_form(m, m.flow(v, t), flow_tangent(m, v, w, t)),
            before = lagrange_one_form(m, v, w);
    claim.equal("dS_t = F_t^* theta - theta", model, dS, S(after - before), amplification);
    // Controls: the form at the end not pulled back by the tangent of the flow; the sign; one end only.
    claim.differs("theta at the end on the vector at the start", model, dS,
                  S(lagrange_one_form(m, m.flow(v, t), w) - before));
    claim.differs("the other sign", model, dS, S(before - after));
    claim.differs("the end alone", model, dS, after);
  });

  // The same where the flow is no polynomial: flow and action by power series, from equations written out by
  // hand.
  if (has_series())
    over_groups(turning_groups(), claim, [&](auto const& group, auto const& model) {
      auto const L = draw_top<S>(draw, group);
      auto const v = draw_state<S>(draw, group);
      auto const w = draw_change<S>(draw, group);
      auto const [end, dS] = L.flow(moved(v, w), ratio<S>(1, 4));
      S const gain = lagrange_one_form(L, value_of(end), change_of(end)) - lagrange_one_form(L, v, w);
      claim.equal("dS_t = F_t^* theta - theta, by power series", model, dS.part[0], gain,
                  series_amplification);
    });
}

STATEMENT(claim_2_1_flow_preserves_form, "the flow is symplectic") {
  claim.holds(
      "Over finite times where the flow is known in closed form, and to first order in time, which is the "
      "whole statement for a flow, on every group.");
  over_groups(entry_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_exact_motions<S>(draw, group);
    auto const v = draw_near_state<S>(draw, group);
    auto const w1 = draw_change<S>(draw, group), w2 = draw_change<S>(draw, group);
    S const t = ratio<S>(1, 3);
    S const before = lagrange_two_form(m, v, w1, w2);
    claim.equal("F_t^* omega = omega", model,
                lagrange_two_form(m, m.flow(v, t), flow_tangent(m, v, w1, t), flow_tangent(m, v, w2, t)),
                before, amplification);
    // Control: a flow with friction, the velocity decaying along the way.
    auto const with_friction = [&](StateChange<SpannedGroup, S> const& w) {
      auto const moving = m.flow(moved(v, w), Dual<S>(t));
      return change_of(
          State<SpannedGroup, Dual<S>>{moving.configuration, Dual<S>(ratio<S>(3, 4)) * moving.velocity});
    };
    auto const end = m.flow(v, t);
    claim.differs(
        "a flow with friction", model,
        lagrange_two_form(m, State<SpannedGroup, S>{end.configuration, ratio<S>(3, 4) * end.velocity},
                          with_friction(w1), with_friction(w2)),
        before);
  });

  // To first order, on every group: the rate of omega(TF_t w1, TF_t w2) at t = 0. The tangent of the flow
  // moves w by theta' = d xi + [xi, theta], d xi' = dX.w.
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_state_polynomial<S>(draw, group);
    auto const v = draw_state<S>(draw, group);
    auto const w1 = draw_change<S>(draw, group), w2 = draw_change<S>(draw, group);
    auto const X = lagrange_vector_field(L, v);
    auto const rate_of_form = [&](auto const& vector_field) {
      auto const carried = [&](StateChange<SpannedGroup, S> const& w) {
        auto const change = vector_field(moved(v, w));
        auto const theta_rate = rate_of(change.configuration) + bracket(v.velocity, w.configuration),
                   xi_rate = rate_of(change.velocity);
        StateChange<SpannedGroup, Dual<S>> result{over<Dual<S>>(w.configuration), over<Dual<S>>(w.velocity)};
        for (int a = 0; a < group.dimension(); ++a) {
          result.configuration.coordinates[a].part[0] = theta_rate.coordinates[a];
          result.velocity.coordinates[a].part[0] = xi_rate.coordinates[a];
        }
        return result;
      };
      return lagrange_two_form(L, moved(v, X), carried(w1), carried(w2)).part[0];
    };
    auto const scale = size_of(lagrange_two_form(L, v, X, w1)) + size_of(lagrange_two_form(L, v, w1, w2));
    // Solving for the acceleration magnifies rounding by the condition of the fibre Hessian, below 100 for
    // these Lagrangians.
    claim.zero("rate of F_t^* omega", model,
               rate_of_form([&](auto const& state) { return lagrange_vector_field(L, state); }), scale, 100);
    // Control: a force that no Lagrangian has.
    claim.refutes("with friction", model, rate_of_form([&](auto const& state) {
                    auto field = lagrange_vector_field(L, state);
                    field.velocity = field.velocity - state.velocity;
                    return field;
                  }),
                  scale);
  });

  // Over a finite time where the flow is no polynomial: by power series, from equations written out by hand.
  if (has_series())
    over_groups(turning_groups(), claim, [&](auto const& group, auto const& model) {
      auto const L = draw_top<S>(draw, group);
      auto const v = draw_state<S>(draw, group);
      auto const w1 = draw_change<S>(draw, group), w2 = draw_change<S>(draw, group);
      auto const one = L.flow(moved(v, w1), ratio<S>(1, 4)).first,
                 two = L.flow(moved(v, w2), ratio<S>(1, 4)).first;
      claim.equal("F_t^* omega = omega, by power series", model,
                  lagrange_two_form(L, value_of(one), change_of(one), change_of(two)),
                  lagrange_two_form(L, v, w1, w2), series_amplification);
    });
}

STATEMENT(claim_2_1_symplecticity_from_action, "the flow is symplectic because $ddS = 0$") {
  claim.holds();
  Quadrature<S> const rule(polynomial_degree);
  over_groups(entry_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_exact_motions<S>(draw, group);
    auto const v = draw_near_state<S>(draw, group);
    S const t = ratio<S>(1, 3);
    // Two commuting vector fields: straight coordinates and their rates moved along fixed vectors.
    int const n = group.dimension();
    auto const [u, du] = m.straight_state(v);
    Vector<S> const x1 = draw_vector<S>(draw, 2 * n), x2 = draw_vector<S>(draw, 2 * n);
    auto const at = [&, u = u, du = du](auto const& e1, auto const& e2) {
      using T = std::decay_t<decltype(e1)>;
      Vector<T> const x = x1.template cast<T>() * e1 + x2.template cast<T>() * e2;
      return state_in(m.chart(), Vector<T>(u.template cast<T>() + x.head(n)),
                      Vector<T>(du.template cast<T>() + x.tail(n)));
    };
    using D = Dual<S>;
    using DD = Dual<D>;
    D e(S(0));
    e.part[0] = S(1);
    DD inner{D(S(0))};
    inner.part[0] = D(S(1));
    // alpha(second field) moved along the first, less the other way round, for alpha = F_t^* theta - theta
    // and a flow.
    auto const exterior = [&](auto const& flow) {
      auto const alpha = [&](auto const& moving) {
        return D(lagrange_one_form(m, value_of(flow(moving)), change_of(flow(moving))) -
                 lagrange_one_form(m, value_of(moving), change_of(moving)));
      };
      return S(alpha(at(DD(e), inner)).part[0] - alpha(at(inner, DD(e))).part[0]);
    };
    auto const motion = [&](auto const& moving) {
      return m.flow(moving, std::decay_t<decltype(moving.velocity.coordinates[0])>(t));
    };

    // ddS = 0: second derivatives of S_t commute. (They do for every function; here they are computed through
    // (2.8).)
    S const omega = lagrange_two_form(m, v, change_of(at(e, D(S(0)))), change_of(at(D(S(0)), e)));
    claim.zero("d(F_t^* theta - theta) = ddS_t = 0", model, exterior(motion), size_of(omega), amplification);
    // d commutes with the pull back, so this is -F_t^* omega + omega, computed from the two-form itself.
    auto const pulled = [&](auto const& flow) {
      auto const one = flow(at(e, D(S(0)))), two = flow(at(D(S(0)), e));
      return lagrange_two_form(m, value_of(one), change_of(one), change_of(two));
    };
    claim.equal("F_t^* omega = omega", model, pulled(motion), omega, amplification);
    auto const slowed = [&](auto const& moving) {
      auto const end = motion(moving);
      using T = std::decay_t<decltype(end.velocity.coordinates[0])>;
      return std::decay_t<decltype(end)>{end.configuration, ratio<T>(3, 4) * end.velocity};
    };
    claim.equal("d of the pull back is the pull back of d, for any map", model, exterior(slowed),
                S(omega - pulled(slowed)), amplification);
    // Control: curves that are no solutions, so that their action does not have (2.8).
    claim.refutes("a flow with friction", model, exterior(slowed), size_of(omega));
  });
}

namespace {

/// The members of (2.9) for a flow by power series and a generator.
template <class S>
struct NoetherMembers {
  S action, carried, difference, momentum;
};
template <class S, class Top, class Generator>
NoetherMembers<S> noether_members(Top const& L, State<SpannedGroup, S> const& v, Generator const& generator,
                                  S const& t) {
  auto const lifted = lifted_generator(v, generator);
  auto const [moving_end, rate] = L.flow(moved(v, lifted), t);
  auto const end = value_of(moving_end);
  S const J = lagrange_one_form(L, v, lifted);
  return {rate.part[0], lagrange_one_form(L, end, change_of(moving_end)) - J,
          lagrange_one_form(L, end, lifted_generator(end, generator)) - J, J};
}

}  // namespace

STATEMENT(eq_2_9, "infinitesimal invariance of the action on solutions") {
  claim.holds(
      "For an abelian group of symmetries, whose flow is known in closed form, and for a group that acts "
      "on itself from the right and from the left, with flows by power series. In the last member $F_t$ "
      "commutes with the symmetry (claim_2_1_symmetry_of_solutions).");
  Quadrature<S> const rule(polynomial_degree);
  over_groups(entry_groups(), claim, [&](auto const& group, auto const& model) {
    auto const v = draw_near_state<S>(draw, group);
    S const t = ratio<S>(1, 3);
    // The four members of (2.9) for the shift of straight coordinates along d.
    auto const members = [&](auto const& m, Vector<S> const& d) {
      auto const generator = m.shift(d);
      auto const lifted = lifted_generator(v, generator);
      auto const end = m.flow(v, t);
      S const dS = action_of_motion(m, moved(v, lifted), t, rule).part[0];
      S const carried =
          lagrange_one_form(m, end, flow_tangent(m, v, lifted, t)) - lagrange_one_form(m, v, lifted);
      S const difference =
          lagrange_one_form(m, end, lifted_generator(end, generator)) - lagrange_one_form(m, v, lifted);
      return std::array<S, 4>{dS, carried, difference, lagrange_one_form(m, v, lifted)};
    };
    // Make the Lagrangian invariant under shifts along d: neither c nor the total derivative depends on d.
    auto m = draw_exact_motions<S>(draw, group);
    Vector<S> d = draw_vector<S>(draw, group.dimension());
    d -= m.c * S(d.dot(m.c) / m.c.dot(m.c));
    auto broken = m;
    m.w = m.c, m.r = m.c;
    auto const [dS, carried, difference, J] = members(m, d);
    claim.zero("the action does not change along the symmetry", model, dS, size_of(J), amplification);
    claim.equal("contraction with (2.8)", model, S(carried + J), S(dS + J), amplification);
    claim.zero("J after less J before", model, difference, size_of(J), amplification);
    // Control: the force has a component along d.
    broken.w = m.c, broken.r = m.c;
    auto const [bS, bc, bd, bJ] = members(broken, m.c);
    claim.refutes("shift along the force: the action changes", model, bS, size_of(bJ));
    claim.refutes("shift along the force: J changes", model, bd, size_of(bJ));
  });

  // A group that acts on itself: tops without weight, from the right and from the left.
  if (has_series() && (claim.first() || current_arithmetic().kind() == ArithmeticKind::hardware))
    over_groups(turning_group(), claim, [&](auto const& group, auto const& model) {
      auto const right = draw_top_without_weight<S>(draw, group);
      InvertedTop<S> const left{right};
      auto const heavy = draw_top<S>(draw, group);
      auto const v = draw_state<S>(draw, group);
      auto const zeta = draw.template velocity<S>(group);
      S const t = ratio<S>(1, 4);
      auto const vanish = [&](std::string const& side, NoetherMembers<S> const& is) {
        // The members are differences of terms as large as J.
        claim.zero(side + ": the action does not change along the symmetry", model, is.action,
                   size_of(is.momentum) + S(1), series_amplification);
        claim.zero(side + ": contraction with (2.8)", model, is.carried, size_of(is.momentum) + S(1),
                   series_amplification);
        claim.zero(side + ": J after less J before", model, is.difference, size_of(is.momentum) + S(1),
                   series_amplification);
      };
      vanish("from the right", noether_members(right, v, right_translation(zeta), t));
      vanish("from the left", noether_members(left, v, left_translation(zeta), t));
      auto const broken = noether_members(heavy, v, right_translation(zeta), t),
                 wrong = noether_members(right, v, left_translation(zeta), t);
      claim.refutes("a weight: J changes", model, broken.difference, broken.momentum);
      claim.refutes("the other side: J changes", model, wrong.difference, wrong.momentum);
      claim.differs("a weight: contraction with (2.8), without the flow's part", model, broken.carried,
                    broken.difference);
    });
}

namespace {

/// Solving with a fibre Hessian magnifies rounding by its condition, about 30 for these Lagrangians.
constexpr double hessian_condition = 30;

/// \f$\langle W, g^{-1}\hat\zeta g\rangle\f$ added to a left-invariant Lagrangian: invariant from the left
/// under exp(t zeta) alone, as gravity is under turns about the vertical.
template <class S>
struct Upright {
  AlgebraPolynomial<S> kinetic;
  Matrix<S> weight;
  Velocity<SpannedGroup, S> zeta;
  template <class T>
  T operator()(State<SpannedGroup, T> const& v) const {
    auto const body = body_velocity(v);
    return kinetic(body) - contract(weight, v.configuration.group.hat(
                                                Ad(inverse(v.configuration), over<T>(zeta)).coordinates));
  }
};

/// On which side a group multiplies.
enum class Side { right, left };
/// A configuration carried by k, on a side.
template <class T>
Element<SpannedGroup, T> carried(Side side, Element<SpannedGroup, T> const& k,
                                 Element<SpannedGroup, T> const& g) {
  return side == Side::left ? k * g : g * k;
}
/// A state carried by k: its velocity is translated to the identity on the right.
template <class T>
State<SpannedGroup, T> carried(Side side, Element<SpannedGroup, T> const& k,
                               State<SpannedGroup, T> const& v) {
  return {carried(side, k, v.configuration), side == Side::left ? Ad(k, v.velocity) : v.velocity};
}

/// The Euler-Lagrange map and the Lagrange vector field of L at a curve and at the curve that k makes of it.
template <class S, class L>
void carry_solutions(Claim<S>& claim, Draw& draw, std::string const& what, std::string const& model,
                     Side side, Element<SpannedGroup, S> const& k, L const& lagrangian, bool symmetric) {
  auto const& group = k.group;
  auto const curve = draw_retracted_curve<S>(draw, group);
  S const t = ratio<S>(1, 3);
  auto const other = [&](auto const& s) {
    return carried(side, over<std::decay_t<decltype(s)>>(k), curve(s));
  };
  auto const v = tangent(curve, t), there = tangent(other, t);
  auto const theta = draw.template velocity<S>(group);
  // A variation of the curve is carried as its velocity is.
  auto const along = [&](Velocity<SpannedGroup, S> const& x) { return side == Side::left ? Ad(k, x) : x; };
  claim.equal("tangents are carried by the tangent map", model, carried(side, k, v).velocity, there.velocity);
  S const here = pair(euler_lagrange(lagrangian, v, second_tangent(curve, t).velocity), theta),
          carried_map =
              pair(euler_lagrange(lagrangian, there, second_tangent(other, t).velocity), along(theta));
  auto const X = lagrange_vector_field(lagrangian, v), at_k = lagrange_vector_field(lagrangian, there);
  if (symmetric) {
    // The terms of a Lagrangian are as large as momentum times velocity; carrying multiplies by Ad of k.
    claim.zero(what + ": the integrand of the action", model, S(lagrangian(there) - lagrangian(v)),
               S(size_of(legendre(lagrangian, there)) * size_of(there.velocity) + S(1)), amplification);
    claim.equal(what + ": the Euler-Lagrange map, off shell", model, carried_map, here);
    // The acceleration is that of the Hessian's solution.
    claim.equal(what + ": the vector field whose flow is F_t", model, at_k.velocity, along(X.velocity),
                hessian_condition);
  } else {
    claim.differs(what + ": the Euler-Lagrange map", model, carried_map, here);
    claim.differs(what + ": the vector field whose flow is F_t", model, at_k.velocity, along(X.velocity));
  }
}

}  // namespace

STATEMENT(claim_2_1_symmetry_of_solutions,
          "a symmetry takes solutions to solutions and commutes with the flow") {
  claim.holds(
      "With finite elements $k$ of the group: the Euler-Lagrange map and the vector field of the "
      "flow are carried along by multiplication from the right, from the left and by a "
      "one-parameter group; $F_t(k\\cdot v) = k\\cdot F_t(v)$ over finite times where the flow is a "
      "polynomial, and by power series.");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const kinetic = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const k = draw.template element<S>(group);
    auto const zeta = draw.template velocity<S>(group);
    Upright<S> const upright{kinetic, draw_matrix<S>(draw, group.matrix_size(), group.matrix_size()), zeta};
    auto const left = left_invariant(kinetic);
    auto const right = right_invariant(kinetic);
    carry_solutions(claim, draw, "from the left", model, Side::left, k, left, true);
    carry_solutions(claim, draw, "from the right", model, Side::right, k, right, true);
    carry_solutions(claim, draw, "a one-parameter group", model, Side::left, retract(ratio<S>(1, 2) * zeta),
                    upright, true);
    carry_solutions(claim, draw, "left-invariant, from the right", model, Side::right, k, left, false);
    carry_solutions(claim, draw, "right-invariant, from the left", model, Side::left, k, right, false);
    carry_solutions(claim, draw, "outside of the one-parameter group", model, Side::left, k, upright, false);
  });

  // Over finite times: shifts of straight coordinates along a direction without force.
  Quadrature<S> const rule(polynomial_degree);
  over_groups(entry_groups(), claim, [&](auto const& group, auto const& model) {
    auto m = draw_exact_motions<S>(draw, group);
    auto const v = draw_near_state<S>(draw, group);
    S const t = ratio<S>(1, 3);
    Vector<S> d = draw_vector<S>(draw, group.dimension()) * ratio<S>(1, 4);
    d -= m.c * S(d.dot(m.c) / m.c.dot(m.c));
    m.w = m.c, m.r = m.c;
    auto const shifted_state = [&](State<SpannedGroup, S> const& state) {
      auto const [u, rate] = m.straight_state(state);
      return state_in(m.chart(), Vector<S>(u + d), rate);
    };
    auto const moved_later = m.flow(shifted_state(v), t), later_moved = shifted_state(m.flow(v, t));
    claim.equal("F_t and a shift: configurations", model, moved_later.configuration,
                later_moved.configuration, amplification);
    claim.equal("F_t and a shift: velocities", model, moved_later.velocity, later_moved.velocity,
                amplification);
    claim.equal("the action of the motion that is shifted", model,
                action_of_motion(m, shifted_state(v), t, rule), action_of_motion(m, v, t, rule),
                amplification);
    // Control: the place is shifted, and the velocity not carried along.
    auto const without_velocity = [&](State<SpannedGroup, S> const& state) {
      return State<SpannedGroup, S>{shifted_state(state).configuration, state.velocity};
    };
    claim.differs("F_t and a shift that leaves the spatial velocity", model,
                  m.flow(without_velocity(v), t).velocity, without_velocity(m.flow(v, t)).velocity);
  });
  if (has_series() && (claim.first() || current_arithmetic().kind() == ArithmeticKind::hardware))
    over_groups(turning_group(), claim, [&](auto const& group, auto const& model) {
      auto const right = draw_top_without_weight<S>(draw, group);
      auto const v = draw_state<S>(draw, group);
      auto const k = draw.template element<S>(group);
      S const t = ratio<S>(1, 4);
      auto const commutes = [&](std::string const& what, auto const& L, Side side, bool symmetric) {
        auto const one = L.flow(carried(side, k, v), t).first, two = carried(side, k, L.flow(v, t).first);
        if (symmetric) {
          claim.equal(what + ", by power series: configurations", model, one.configuration, two.configuration,
                      series_amplification);
          claim.equal(what + ", by power series: velocities", model, one.velocity, two.velocity,
                      series_amplification);
        } else {
          claim.differs(what + ", by power series", model, one.velocity, two.velocity);
        }
      };
      commutes("F_t and multiplication from the right", right, Side::right, true);
      commutes("F_t and multiplication from the left", InvertedTop<S>{right}, Side::left, true);
      commutes("F_t of a top with weight and multiplication from the right", draw_top<S>(draw, group),
               Side::right, false);
      commutes("F_t of a left-invariant top and multiplication from the right", InvertedTop<S>{right},
               Side::right, false);
    });
}

// ----
// Noether's theorem, at a point.

STATEMENT(claim_2_1_noether_momentum, "momentum conserved because of a symmetry") {
  claim.holds();
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const kinetic = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const v = draw_state<S>(draw, group);
    auto const zeta = draw.template velocity<S>(group), other = draw.template velocity<S>(group);
    auto const w = draw_change<S>(draw, group);
    auto const rate_of_momentum = [&](auto const& L, auto const& generator) {
      return noether_momentum(L, moved(v, lagrange_vector_field(L, v)), generator).part[0];
    };
    auto const law = [&](std::string const& what, auto const& L, auto const& generator) {
      auto const lifted = lifted_generator(v, generator);
      S const J = noether_momentum(L, v, generator);
      // The symmetry leaves L as it is; J is its lift contracted with theta_L, here the slope of L at the
      // place of v along the fibre; J generates it; J stays.
      claim.zero(what + ": the Lagrangian is invariant", model, L(moved(v, lifted)).part[0], size_of(J));
      Velocity<SpannedGroup, S> const none{group, Vector<S>::Zero(group.dimension())};
      auto const along_fibre = moved(v, StateChange<SpannedGroup, S>{none, lifted.configuration});
      claim.equal(what + ": J = lift contracted with theta_L", model, L(along_fibre).part[0], J);
      claim.equal(what + ": lift contracted with omega_L is dJ", model, lagrange_two_form(L, v, lifted, w),
                  noether_momentum(L, moved(v, w), generator).part[0]);
      claim.zero(what + ": J is constant", model, rate_of_momentum(L, generator), size_of(J),
                 hessian_condition);
    };
    auto const left = left_invariant(kinetic);
    auto const right = right_invariant(kinetic);
    Upright<S> const upright{kinetic, draw_matrix<S>(draw, group.matrix_size(), group.matrix_size()), zeta};
    law("multiplication from the left", left, left_translation(zeta));
    law("multiplication from the right", right, right_translation(zeta));
    law("a one-parameter group", upright, left_translation(zeta));

    // Controls: the wrong side; a direction that is no symmetry; J without the turn of the frame.
    auto const scale_of = [&](auto const& L, auto const& generator) {
      return size_of(noether_momentum(L, v, generator));
    };
    claim.refutes("right translation of a left-invariant Lagrangian", model,
                  rate_of_momentum(left, right_translation(zeta)), scale_of(left, right_translation(zeta)));
    claim.refutes("left translation of a right-invariant Lagrangian", model,
                  rate_of_momentum(right, left_translation(zeta)), scale_of(right, left_translation(zeta)));
    claim.refutes("another direction than the symmetry's", model,
                  rate_of_momentum(upright, left_translation(other)),
                  scale_of(upright, left_translation(other)));
  });
}
