// Section 2.1, over finite times: the action of motions, their flow, and what it preserves. Compiled once per scalar.
//
// The flow is a polynomial in time (exact_motions.hpp), integrals are exact, so every residual is zero over the rationals. Flows that are no polynomials
// are tried in double and 50 digits. Degrees: the entries of a flow are
// quotients of polynomials of degree below 30 in the random numbers; forms and variations multiply at most eight of them and as many denominators.
#include "actio/variational/euler_lagrange.hpp"
#include "actio/variational/momentum_map.hpp"
#include "exact_motions.hpp"
#include "statement.hpp"
#include "top_in_any_group.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

constexpr int degree_bound = 500;
/// Fifteen nodes and the nested rates of a flow magnify a rounding error about tenfold.
constexpr double amplification = 10;

/// The tangent of the flow of exact motions.
template <class S>
StateChange<SpannedGroup, S> flow_tangent(ExactMotions<S> const& m, State<SpannedGroup, S> const& v, StateChange<SpannedGroup, S> const& w,
                                          S const& t) {
  return change_of(m.flow(moved(v, w), Dual<S>(t)));
}
/// S_t, the action of the motion from v, as (2.7) says it.
template <class T, class S>
T action_of_motion(ExactMotions<S> const& m, State<SpannedGroup, T> const& v, S const& t, Quadrature<S> const& rule) {
  return rule([&](T const& s) { return m(m.flow(v, s)); }, T(0), T(t));
}

/// Groups on which flows are no polynomials. A hundred digits would take minutes here and are left out.
inline std::vector<SpannedGroup> const& turning_groups() {
  static std::vector<SpannedGroup> const groups = {spanned("SO(3)", SO<3>{}), spanned("SE(2)", SE<2>{})};
  return groups;
}
template <class S>
inline constexpr bool has_series = Real<S> && !std::same_as<S, dec100>;
/// A dozen steps of the series, errors growing with the flow.
constexpr double series_amplification = 20;

}  // namespace

STATEMENT(eq_2_7, "the action as a function of the initial velocity") {
  claim.holds();
  claim.degree(degree_bound);
  Quadrature<S> const rule(polynomial_degree);
  over_groups(entry_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_exact_motions<S>(draw, group);
    auto const v = draw_near_state<S>(draw, group);
    S const t = ratio<S>(1, 3), s = ratio<S>(1, 5);
    auto const after = m.flow(v, t);

    // (g(s), g'(s)) = F_s(v) solves (2.4) and begins at v; F is a flow. This is what S_t integrates along.
    auto const motion = m.motion(v);
    claim.equal("F_s(v) is the tangent of a curve", model, after.velocity, tangent(motion, t).velocity, amplification);
    claim.zero("that solves the Euler-Lagrange equations", model, euler_lagrange(m, after, second_tangent(motion, t).velocity),
               size_of(ad_star(after.velocity, legendre(m, after))), 10 * amplification);
    // Motions follow one another, so their actions add up; the rate is the Lagrangian.
    S const whole = action_of_motion(m, v, S(t + s), rule), first = action_of_motion(m, v, t, rule);
    claim.equal("S_{t+s}(v) = S_t(v) + S_s(F_t v)", model, whole, S(first + action_of_motion(m, after, s, rule)), amplification);
    claim.equal("S_t is the action of the motion", model, first, action(m, motion, S(0), t, rule), amplification);
    // Controls: the second piece begun at v again; the action along another curve from v.
    claim.differs("second piece from v", model, whole, S(first + action_of_motion(m, v, s, rule)));
    auto const straight = [&](auto const& x) {
      using T = std::decay_t<decltype(x)>;
      Matrix<T> const g = v.place.value.template cast<T>(),
                      rate = Matrix<S>(group.hat(v.velocity.coordinates) * v.place.value).template cast<T>();
      return m.place(Vector<T>(m.read(g) + m.read(rate) * x + m.fall.template cast<T>() * (x * x)));
    };
    claim.differs("another curve from v", model, action(m, straight, S(0), t, rule), first);
  });
}

STATEMENT(eq_2_8, "differential of the action on solutions") {
  claim.holds();
  claim.degree(degree_bound);
  Quadrature<S> const rule(polynomial_degree);
  over_groups(entry_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_exact_motions<S>(draw, group);
    auto const v = draw_near_state<S>(draw, group);
    auto const w = draw_change<S>(draw, group);
    S const t = ratio<S>(1, 3);

    S const dS = action_of_motion(m, moved(v, w), t, rule).part[0];
    S const after = lagrange_one_form(m, m.flow(v, t), flow_tangent(m, v, w, t)), before = lagrange_one_form(m, v, w);
    claim.equal("dS_t = F_t^* theta - theta", model, dS, S(after - before), amplification);
    // Controls: the form at the end not pulled back by the tangent of the flow; the sign; one end only.
    claim.differs("theta at the end on the vector at the start", model, dS, S(lagrange_one_form(m, m.flow(v, t), w) - before));
    claim.differs("the other sign", model, dS, S(before - after));
    claim.differs("the end alone", model, dS, after);
  });

  // The same where the flow is no polynomial: flow and action by power series, from equations written out by hand.
  if constexpr (has_series<S>)
    over_groups(turning_groups(), claim, [&](auto const& group, auto const& model) {
      auto const L = draw_top<S>(draw, group);
      auto const v = draw_state<S>(draw, group);
      auto const w = draw_change<S>(draw, group);
      auto const [end, dS] = L.flow(moved(v, w), ratio<S>(1, 4));
      S const gain = lagrange_one_form(L, value_of(end), change_of(end)) - lagrange_one_form(L, v, w);
      claim.equal("dS_t = F_t^* theta - theta, by power series", model, dS.part[0], gain, series_amplification);
    });
}

STATEMENT(claim_2_1_flow_preserves_form, "the flow is symplectic") {
  claim.holds(
      "Over finite times where the flow is known in closed form, and to first order in time, which is the whole statement for a flow, on "
      "every group.");
  claim.degree(degree_bound);
  over_groups(entry_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_exact_motions<S>(draw, group);
    auto const v = draw_near_state<S>(draw, group);
    auto const w1 = draw_change<S>(draw, group), w2 = draw_change<S>(draw, group);
    S const t = ratio<S>(1, 3);
    S const before = lagrange_two_form(m, v, w1, w2);
    claim.equal("F_t^* omega = omega", model, lagrange_two_form(m, m.flow(v, t), flow_tangent(m, v, w1, t), flow_tangent(m, v, w2, t)),
                before, amplification);
    // Control: a flow with friction, the velocity decaying along the way.
    auto const with_friction = [&](StateChange<SpannedGroup, S> const& w) {
      auto const moving = m.flow(moved(v, w), Dual<S>(t));
      return change_of(State<SpannedGroup, Dual<S>>{moving.place, Dual<S>(ratio<S>(3, 4)) * moving.velocity});
    };
    auto const end = m.flow(v, t);
    claim.differs(
        "a flow with friction", model,
        lagrange_two_form(m, State<SpannedGroup, S>{end.place, ratio<S>(3, 4) * end.velocity}, with_friction(w1), with_friction(w2)),
        before);
  });

  // To first order, on every group: the rate of omega(TF_t w1, TF_t w2) at t = 0. The tangent of the flow moves w by theta' = d xi + [xi, theta], d xi' = dX.w.
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_state_polynomial<S>(draw, group);
    auto const v = draw_state<S>(draw, group);
    auto const w1 = draw_change<S>(draw, group), w2 = draw_change<S>(draw, group);
    auto const X = lagrange_vector_field(L, v);
    auto const rate_of_form = [&](auto const& vector_field) {
      auto const carried = [&](StateChange<SpannedGroup, S> const& w) {
        auto const change = vector_field(moved(v, w));
        auto const theta_rate = rate(change.place) + bracket(v.velocity, w.place), xi_rate = rate(change.velocity);
        StateChange<SpannedGroup, Dual<S>> result{over<Dual<S>>(w.place), over<Dual<S>>(w.velocity)};
        for (int a = 0; a < group.dimension(); ++a) {
          result.place.coordinates[a].part[0] = theta_rate.coordinates[a];
          result.velocity.coordinates[a].part[0] = xi_rate.coordinates[a];
        }
        return result;
      };
      return lagrange_two_form(L, moved(v, X), carried(w1), carried(w2)).part[0];
    };
    auto const scale = size_of(lagrange_two_form(L, v, X, w1)) + size_of(lagrange_two_form(L, v, w1, w2));
    // Solving for the acceleration magnifies rounding by the condition of the fibre Hessian, below 100 for these Lagrangians.
    claim.zero("rate of F_t^* omega", model, rate_of_form([&](auto const& state) { return lagrange_vector_field(L, state); }), scale, 100);
    // Control: a force that no Lagrangian has.
    claim.refutes("with friction", model, rate_of_form([&](auto const& state) {
                    auto field = lagrange_vector_field(L, state);
                    field.velocity = field.velocity - state.velocity;
                    return field;
                  }),
                  scale);
  });

  // Over a finite time where the flow is no polynomial: by power series, from equations written out by hand.
  if constexpr (has_series<S>)
    over_groups(turning_groups(), claim, [&](auto const& group, auto const& model) {
      auto const L = draw_top<S>(draw, group);
      auto const v = draw_state<S>(draw, group);
      auto const w1 = draw_change<S>(draw, group), w2 = draw_change<S>(draw, group);
      auto const one = L.flow(moved(v, w1), ratio<S>(1, 4)).first, two = L.flow(moved(v, w2), ratio<S>(1, 4)).first;
      claim.equal("F_t^* omega = omega, by power series", model, lagrange_two_form(L, value_of(one), change_of(one), change_of(two)),
                  lagrange_two_form(L, v, w1, w2), series_amplification);
    });
}

STATEMENT(claim_2_1_symplecticity_from_action, "the flow is symplectic because ddS = 0") {
  claim.holds();
  claim.degree(degree_bound);
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
      return state_in(m.chart(), Vector<T>(u.template cast<T>() + x.head(n)), Vector<T>(du.template cast<T>() + x.tail(n)));
    };
    using D = Dual<S>;
    using DD = Dual<D>;
    D e(S(0));
    e.part[0] = S(1);
    DD inner{D(S(0))};
    inner.part[0] = D(S(1));
    // alpha(second field) moved along the first, less the other way round, for alpha = F_t^* theta - theta and a flow.
    auto const exterior = [&](auto const& flow) {
      auto const alpha = [&](auto const& moving) {
        return D(lagrange_one_form(m, value_of(flow(moving)), change_of(flow(moving))) -
                 lagrange_one_form(m, value_of(moving), change_of(moving)));
      };
      return S(alpha(at(DD(e), inner)).part[0] - alpha(at(inner, DD(e))).part[0]);
    };
    auto const motion = [&](auto const& moving) { return m.flow(moving, std::decay_t<decltype(moving.velocity.coordinates[0])>(t)); };

    // ddS = 0: second derivatives of S_t commute. (They do for every function; here they are computed through (2.8).)
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
      return std::decay_t<decltype(end)>{end.place, ratio<T>(3, 4) * end.velocity};
    };
    claim.equal("d of the pull back is the pull back of d, for any map", model, exterior(slowed), S(omega - pulled(slowed)), amplification);
    // Control: curves that are no solutions, so that their action does not have (2.8).
    claim.refutes("a flow with friction", model, exterior(slowed), size_of(omega));
  });
}

STATEMENT(eq_2_9, "infinitesimal invariance of the action on solutions") {
  claim.holds();
  claim.degree(degree_bound);
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
      S const carried = lagrange_one_form(m, end, flow_tangent(m, v, lifted, t)) - lagrange_one_form(m, v, lifted);
      S const difference = lagrange_one_form(m, end, lifted_generator(end, generator)) - lagrange_one_form(m, v, lifted);
      return std::array<S, 4>{dS, carried, difference, lagrange_one_form(m, v, lifted)};
    };
    // Make the Lagrangian invariant under shifts along d: neither c nor the total derivative see d.
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
}
