// Section 2.1, over finite times: the action of a curve and its variation.
//
// Curves are polynomials in time (exact_motions.hpp), integrals are exact, so every residual is zero over the
// rationals.

#include "actio/variational/curves.hpp"
#include "actio/variational/euler_lagrange.hpp"
#include "actio/variational/lagrange_forms.hpp"
#include "actio/variational/momentum_map.hpp"

#include "charts.hpp"
#include "exact_motions.hpp"
#include "statement.hpp"
#include "top_in_any_group.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// Fifteen nodes and the nested rates of a flow magnify a rounding error about tenfold.
constexpr double amplification = 10;

/// The entries of a curve.
template <class S, class Curve>
auto entries_of(ExactMotions<S> const& m, Curve const& curve) {
  return [m, curve](auto const& t) {
    using T = std::decay_t<decltype(t)>;
    return m.read(Matrix<T>(curve(t).value));
  };
}
/// dL/dq - d/dt dL/dv in entries along a curve of entries.
template <class S, class Entries>
Vector<S> residual_in_entries(ExactMotions<S> const& m, Entries const& q, S const& t) {
  auto const L = [&](auto const& x, auto const& v) { return m.in_entries(x, v); };
  auto const rate = [&](auto const& s) { return rate_of(q, s); };
  return euler_lagrange_in_coordinates(L, Vector<S>(q(t)), rate_of(q, t), rate_of(rate, t));
}
/// dL/dv in entries along a curve of entries.
template <class S, class Entries>
Vector<S> momenta_in_entries(ExactMotions<S> const& m, Entries const& q, S const& t) {
  return momenta([&](auto const& x, auto const& v) { return m.in_entries(x, v); }, Vector<S>(q(t)),
                 rate_of(q, t));
}

}  // namespace

STATEMENT(eq_2_1, "the action of a curve") {
  claim.holds(
      "The integral does not depend on the coordinates in which $g$ and its rate are expressed; it "
      "depends on $a$ and $b$.");
  Quadrature<S> const rule(polynomial_degree);
  over_groups(entry_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_exact_motions<S>(draw, group);
    auto const curve = draw_polynomial_curve(draw, m);
    auto const q = entries_of(m, curve);
    S const a = ratio<S>(-1, 5), b = ratio<S>(2, 5);

    // The library integrates along tangents in TG; the formula of the page is written in entries and their
    // rates.
    S const intrinsic = action(m, curve, a, b, rule);
    claim.equal("integral along the tangent = integral in coordinates", model, intrinsic,
                rule([&](S const& t) { return m.in_entries(Vector<S>(q(t)), rate_of(q, t)); }, a, b),
                amplification);
    S const middle = ratio<S>(1, 7);
    claim.equal("additive over adjoining intervals", model,
                S(action(m, curve, a, middle, rule) + action(m, curve, middle, b, rule)), intrinsic,
                amplification);
    // Controls: a velocity that is not the curve's; another interval.
    claim.differs(
        "twice the velocity", model,
        rule([&](S const& t) { return m.in_entries(Vector<S>(q(t)), Vector<S>(rate_of(q, t) * S(2))); }, a,
             b),
        intrinsic);
    claim.differs("another end", model, action(m, curve, a, middle, rule), intrinsic);
  });
}

STATEMENT(eq_2_2, "the action is stationary at motions") {
  claim.holds();
  Quadrature<S> const rule(polynomial_degree);
  over_groups(entry_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_exact_motions<S>(draw, group);
    S const a = ratio<S>(-1, 5), b = ratio<S>(2, 5);
    auto const motion = m.motion(draw_near_state<S>(draw, group));
    auto const other = draw_polynomial_curve(draw, m);
    auto const fixed = draw_direction<S>(draw, group.dimension(), a, b, true),
               loose = draw_direction<S>(draw, group.dimension(), a, b, false);

    // Fixed ends: the first variation vanishes at a motion. Its terms are as large as those of the variation
    // with loose ends.
    S const with_loose_ends = action_variation(m, shifted(m, motion, loose), a, b, rule);
    claim.zero("dS = 0 at a motion, ends fixed", model,
               action_variation(m, shifted(m, motion, fixed), a, b, rule), size_of(with_loose_ends),
               amplification);
    // Only the first-order change of the curve counts: bend the family at second order, and bend its
    // parameter.
    auto const family = shifted(m, other, fixed), bent_family = [&](auto const& e, auto const& t) {
      using T = std::decay_t<decltype(t)>;
      return m.configuration(
          Vector<T>(m.read(Matrix<T>(other(t).value)) + fixed(t) * (e + e * e) + loose(t) * (e * e)));
    };
    S const off_motion = action_variation(m, family, a, b, rule);
    claim.equal("the same for every family with the same first-order change", model,
                action_variation(m, bent_family, a, b, rule), off_motion, amplification);
    // Controls.
    claim.refutes("ends that move", model, with_loose_ends, size_of(m(tangent(motion, a))));
    claim.refutes("a curve that is no motion", model, off_motion, size_of(m(tangent(other, a))));
  });
}

STATEMENT(eq_2_3, "first variation of the action, integrated by parts") {
  claim.holds("The last term is the boundary term; it vanishes for fixed ends.");
  Quadrature<S> const rule(polynomial_degree);
  over_groups(entry_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_exact_motions<S>(draw, group);
    S const a = ratio<S>(-1, 5), b = ratio<S>(2, 5);
    auto const curve = draw_polynomial_curve(draw, m);
    auto const q = entries_of(m, curve);
    auto const fixed = draw_direction<S>(draw, group.dimension(), a, b, true),
               loose = draw_direction<S>(draw, group.dimension(), a, b, false);
    auto const inside = [&](auto const& delta) {
      return rule([&](S const& t) { return S(Vector<S>(delta(t)).dot(residual_in_entries(m, q, t))); }, a, b);
    };
    auto const boundary = [&](auto const& delta, S const& t) {
      return S(momenta_in_entries(m, q, t).dot(Vector<S>(delta(t))));
    };

    S const dS = action_variation(m, shifted(m, curve, loose), a, b, rule);
    claim.equal("dS = integral + boundary", model, dS,
                S(inside(loose) + boundary(loose, b) - boundary(loose, a)), amplification);
    claim.equal("fixed ends: no boundary", model, action_variation(m, shifted(m, curve, fixed), a, b, rule),
                inside(fixed), amplification);
    // Controls: no boundary, ends in the other order.
    claim.differs("boundary term left out", model, dS, inside(loose));
    claim.differs("boundary term from b to a", model, dS,
                  S(inside(loose) + boundary(loose, a) - boundary(loose, b)));
  });
}

STATEMENT(eq_2_5, "first variation of the action with free ends") {
  claim.holds(
      "The boundary term is the one-form $(\\partial L/\\partial\\dot g)\\,dg$, which is the Lagrange "
      "one-form of the library.");
  Quadrature<S> const rule(polynomial_degree);
  over_groups(entry_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_exact_motions<S>(draw, group);
    S const a = ratio<S>(-1, 5), b = ratio<S>(2, 5);
    auto const motion = m.motion(draw_near_state<S>(draw, group));
    auto const q = entries_of(m, motion);
    auto const loose = draw_direction<S>(draw, group.dimension(), a, b, false);
    auto const boundary = [&](S const& t) { return S(momenta_in_entries(m, q, t).dot(Vector<S>(loose(t)))); };

    // Along a motion the integral is gone and the boundary term alone is left.
    S const dS = action_variation(m, shifted(m, motion, loose), a, b, rule), term = boundary(b) - boundary(a);
    claim.equal("at a motion dS is the boundary term", model, dS, term, amplification);
    // That term is a one-form on TG, applied to the lifted variation.
    auto const one_form = [&](S const& t) {
      return lagrange_one_form(m, tangent(motion, t), lifted_variation(shifted(m, motion, loose), t));
    };
    claim.equal("(dL/dg') dg is the Lagrange one-form", model, one_form(b), boundary(b), amplification);
    // Controls: only one end moves; a one-form with the whole velocity's change in it.
    claim.differs("the end a held fixed", model, dS, boundary(b));
    claim.differs(
        "momentum paired with the change of the velocity", model,
        pair(legendre(m, tangent(motion, b)), lifted_variation(shifted(m, motion, loose), b).velocity),
        boundary(b));
  });
}

STATEMENT(eq_2_6, "variation of the action: Euler-Lagrange map inside, one-form at the ends") {
  claim.corrected(
      R"(\hat\delta g(t) \equiv \frac{d}{d\epsilon}\Big|_{\epsilon=0}\frac{d}{dt}\Big|_{t=0} g_)"
      R"(\epsilon(t))",
      R"(\hat\delta g(t) \equiv \frac{d}{d\epsilon}\Big|_{\epsilon=0}\frac{d}{dt} g_\epsilon(t))",
      "The lifted variation in (2.6) is to be taken at the time $t$ of the end point, not at $t = 0$ "
      "as its definition below the formula is printed.");
  claim.same_slip_as("claim_2_1_lifted_variation");
  Quadrature<S> const rule(polynomial_degree);
  over_groups(entry_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_exact_motions<S>(draw, group);
    S const a = ratio<S>(-1, 5), b = ratio<S>(2, 5);
    auto const curve = draw_polynomial_curve(draw, m);
    auto const family = shifted(m, curve, draw_direction<S>(draw, group.dimension(), a, b, false));
    auto const inside = [&](S const& t) {
      auto const acceleration = second_tangent(curve, t).velocity;
      return pair(euler_lagrange(m, tangent(curve, t), acceleration),
                  lifted_variation(family, t).configuration);
    };
    auto const one_form = [&](S const& t) {
      return lagrange_one_form(m, tangent(curve, t), lifted_variation(family, t));
    };

    S const dS = action_variation(m, family, a, b, rule), integral = rule(inside, a, b),
            boundary = one_form(b) - one_form(a);
    claim.equal("(2.6), without coordinates", model, dS, S(integral + boundary), amplification);
    // Controls: the lift as printed; either part alone; the sign of the boundary.
    auto const at_zero = lifted_variation(family, S(0));
    claim.differs("the lift as printed, at t = 0", model, dS,
                  S(integral + lagrange_one_form(m, tangent(curve, b), at_zero) -
                    lagrange_one_form(m, tangent(curve, a), at_zero)));
    claim.differs("integral alone", model, dS, integral);
    claim.differs("boundary alone", model, dS, boundary);
    claim.differs("boundary with the other sign", model, dS, S(integral - boundary));
  });
}

STATEMENT(claim_2_1_lifted_variation, "the lift of a variation, at the time of the variation") {
  claim.corrected(R"(\hat\delta g(t) \equiv \frac{d}{d\epsilon}\Big|_{\epsilon=0}\frac{d}{dt}\Big|_{t=0} g_)"
                  R"(\epsilon(t))",
                  R"(\hat\delta g(t) \equiv \frac{d}{d\epsilon}\Big|_{\epsilon=0}\frac{d}{dt} g_\epsilon(t))",
                  "The derivative in time is to be taken at $t$, not at 0: as printed the lift does not "
                  "depend on $t$, and (2.6) fails unless it is evaluated at one end only.");
  Quadrature<S> const rule(polynomial_degree);
  over_groups(entry_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_exact_motions<S>(draw, group);
    S const a = ratio<S>(1, 5), b = ratio<S>(2, 5);
    auto const motion = m.motion(draw_near_state<S>(draw, group));
    auto const family = shifted(m, motion, draw_direction<S>(draw, group.dimension(), a, b, false));
    auto const lifted = lifted_variation(family, b), at_zero = lifted_variation(family, S(0));

    // The lift covers the variation, and its velocity part is theta' - [xi, theta].
    Dual<S> epsilon(S(0));
    epsilon.part[0] = S(1);
    claim.equal("the lift covers the variation", model, lifted.configuration,
                rate_right(family(epsilon, Dual<S>(b))), amplification);
    auto const along_time = [&](auto const& t) { return lifted_variation(family, t).configuration; };
    Dual<S> time(b);
    time.part[0] = S(1);
    auto const xi = tangent(motion, b).velocity;
    claim.equal("its velocity part", model, lifted.velocity,
                rate_of(along_time(time)) - bracket(xi, lifted.configuration), amplification);
    // (2.6) along a motion is its boundary part.
    S const dS = action_variation(m, family, a, b, rule);
    auto const end = [&](S const& t, auto const& w) { return lagrange_one_form(m, tangent(motion, t), w); };
    claim.equal("(2.6) with the lift at t", model, dS,
                S(end(b, lifted) - end(a, lifted_variation(family, a))), amplification);
    // Control: as printed.
    claim.differs("the lift as printed, at t = 0", model, dS, S(end(b, at_zero) - end(a, at_zero)));
  });
}

// ----
// Section 2.1, over finite times: the action of motions, their flow, and what it preserves.
//
// The flow is a polynomial in time (exact_motions.hpp), integrals are exact, so every residual is zero over
// the rationals. Flows that are no polynomials are tried in double and 50 digits.

namespace {

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
      "whole statement for a flow, on "
      "every group.");
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
      "For an abelian group of symmetries, whose flow is known in closed form, and for a group that acts on "
      "itself "
      "from the right and from the left, with flows by power series. In the last member $F_t$ commutes with "
      "the "
      "symmetry (claim_2_1_symmetry_of_solutions).");
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
  auto const curve = draw_curve<S>(draw, group);
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
      "With finite elements $k$ of the group: the Euler-Lagrange map and the vector field of the flow are "
      "carried along by multiplication from the right, from the left and by a one-parameter group; "
      "$F_t(k\\cdot v) = k\\cdot F_t(v)$ over finite times where the flow is a polynomial, and by power "
      "series.");
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
// Section 2.1, at a point: the Euler-Lagrange equations, charts, regularity, the Lagrange vector field.
//
// Every identity is one between derivatives at a random point, so it is exact over the rationals on every
// group.

namespace {

/// Coordinates of a second-order jet of a curve.
template <class S>
struct Jet {
  Vector<S> q, v, a;
};
template <class S>
Jet<S> draw_jet(Draw& draw, int n) {
  auto const q = draw_vector<S>(draw, n), v = draw_vector<S>(draw, n);
  return {q * ratio<S>(1, 2), v * S(2), draw_vector<S>(draw, n)};
}

}  // namespace

STATEMENT(eq_2_4, "Euler-Lagrange equations in coordinates, and without") {
  claim.holds();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_state_polynomial<S>(draw, group);
    auto const chart = chart_right(draw.template element<S>(group));
    auto const [q, v, a] = draw_jet<S>(draw, group.dimension());
    auto const state = state_in(chart, q, v);
    auto const acceleration = acceleration_in(chart, q, v, a);
    Matrix<S> const back = frame(chart, q).transpose();

    // The covector of the library, read in the chart, is dL/dq - d/dt dL/dq'.
    Vector<S> const coordinates = euler_lagrange_in_coordinates(in_coordinates(L, chart), q, v, a);
    auto const intrinsic = euler_lagrange(L, state, acceleration);
    claim.equal("D_EL L in a chart is (2.4)", model, Vector<S>(back * intrinsic.components), coordinates);
    // Controls: the turning of the frame left out, or counted with the other sign.
    auto const turning = ad_star(state.velocity, legendre(L, state));
    claim.differs("without ad*", model, Vector<S>(back * (intrinsic + turning).components), coordinates);
    claim.differs("+ ad* instead of - ad*", model, Vector<S>(back * (intrinsic + S(2) * turning).components),
                  coordinates);
  });
}

STATEMENT(claim_2_1_regular_second_order_ode, "regular Lagrangians have second-order equations") {
  claim.holds("Where the matrix has an inverse; the acceleration is then a function of the state.");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_state_polynomial<S>(draw, group);
    auto const chart = chart_right(draw.template element<S>(group));
    auto const [q, v, a] = draw_jet<S>(draw, group.dimension());
    auto const state = state_in(chart, q, v);
    int const n = group.dimension();

    // The fibre Hessian is d2L/dq'dq' read in the chart, and symmetric.
    auto const f = in_coordinates(L, chart);
    Matrix<S> in_chart(n, n), const_frame = frame(chart, q), hessian = fibre_hessian(L, state);
    for (int i = 0; i < n; ++i)
      in_chart.col(i) = rates(
          momenta(f, moving(q, Vector<S>(Vector<S>::Zero(n))), moving(v, Vector<S>(Vector<S>::Unit(n, i)))));
    claim.equal("fibre Hessian = d2L/dq'dq'", model,
                Matrix<S>(const_frame.transpose() * hessian * const_frame), in_chart);
    claim.equal("symmetric", model, hessian, Matrix<S>(hessian.transpose()));
    // The equation is affine in the acceleration, with this matrix in front, so it has one solution.
    auto const acceleration = lagrange_acceleration(L, state);
    auto const other = acceleration_in(chart, q, v, a);
    claim.zero("the equation solved for the acceleration", model, euler_lagrange(L, state, acceleration),
               size_of(euler_lagrange(L, state, other)), hessian_condition);
    claim.equal("any other acceleration misses by the Hessian", model,
                euler_lagrange(L, state, other).components,
                Vector<S>(hessian * (acceleration - other).coordinates), hessian_condition);
    // Controls: another acceleration; a Lagrangian blind to one direction of the velocity.
    claim.refutes("another acceleration", model, euler_lagrange(L, state, other),
                  size_of(ad_star(state.velocity, legendre(L, state))));
    auto singular = L;
    singular.kinetic.c.setZero();
    singular.kinetic.a.row(0).setZero(), singular.kinetic.a.col(0).setZero();
    claim.template refuses<Singular>("a Lagrangian that is not regular", model,
                                     [&] { lagrange_acceleration(singular, state); });
  });
}

STATEMENT(claim_2_1_action_chart_independent, "action and equations in two charts") {
  claim.holds(
      "The left side of (2.4) is a covector; the second derivatives in it are those of one curve in both "
      "charts.");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_state_polynomial<S>(draw, group);
    auto const h = draw.template element<S>(group), k = draw.template element<S>(group);
    auto const first = chart_right(h), second = chart_left(k);
    auto const [q, v, small] = draw_jet<S>(draw, group.dimension());
    // Turning fast and speeding up slowly, so that what charts do to accelerations counts.
    Vector<S> const a = small * ratio<S>(1, 4);
    int const n = group.dimension();

    // The change of charts r(q), and the curve in the second one.
    auto const change = [&](auto const& x) {
      using T = typename std::decay_t<decltype(x)>::Scalar;
      return Vector<T>(coordinates_left(k)(first(x)));
    };
    auto const carried = change(moving(moving(q, v), moving(v, a)));
    Vector<S> const r = values(values(carried)), r1 = rates(values(carried)), r2 = rates(rates(carried));
    Matrix<S> jacobian(n, n);
    for (int i = 0; i < n; ++i) jacobian.col(i) = rates(change(moving(q, Vector<S>(Vector<S>::Unit(n, i)))));

    auto const L1 = in_coordinates(L, first), L2 = in_coordinates(L, second);
    // Two charts and an inverse Cayley transform between them: a few digits' worth of elimination.
    claim.equal("the integrand of (2.1)", model, L1(q, v), L2(r, r1), hessian_condition);
    Vector<S> const e1 = euler_lagrange_in_coordinates(L1, q, v, a),
                    e2 = euler_lagrange_in_coordinates(L2, r, r1, r2);
    claim.equal("(2.4) is a covector", model, e1, Vector<S>(jacobian.transpose() * e2), hessian_condition);
    // Controls: carried like a vector; the second derivative carried as if it were a vector.
    claim.differs("carried like a vector", model, e1, Vector<S>(inverse_matrix(jacobian) * e2));
    Vector<S> const none = Vector<S>::Zero(n), as_vector = jacobian * a;
    auto const with = [&](Vector<S> const& second_rate) {
      return euler_lagrange_in_coordinates(L2, r, r1, second_rate);
    };
    claim.refutes("acceleration carried like a vector", model,
                  Vector<S>(e1 - jacobian.transpose() * with(as_vector)),
                  size_of(Vector<S>(with(as_vector) - with(none))));
  });
}

STATEMENT(claim_2_1_lagrange_vector_field, "the Lagrange vector field of a regular Lagrangian") {
  claim.holds();
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_state_polynomial<S>(draw, group);
    auto const chart = chart_right(draw.template element<S>(group));
    int const n = group.dimension();
    auto const [q, v, a] = draw_jet<S>(draw, n);
    auto const state = state_in(chart, q, v);
    auto const f = in_coordinates(L, chart);

    // omega_L is dq ^ d(dL/dq'), written in the chart.
    auto const in_chart = [&](Vector<S> const& dq, Vector<S> const& dv) {
      auto const moved_state = state_in(chart, moving(q, dq), moving(v, dv));
      return change_of(moved_state);
    };
    Vector<S> const dq1 = draw_vector<S>(draw, n), dv1 = draw_vector<S>(draw, n),
                    dq2 = draw_vector<S>(draw, n), dv2 = draw_vector<S>(draw, n);
    auto const w1 = in_chart(dq1, dv1), w2 = in_chart(dq2, dv2);
    auto const dp = [&](Vector<S> const& dq, Vector<S> const& dv) {
      return rates(momenta(f, moving(q, dq), moving(v, dv)));
    };
    claim.equal("theta_L = (dL/dq') dq", model, lagrange_one_form(L, state, w1),
                S(momenta(f, q, v).dot(dq1)));
    claim.equal("omega_L = dq ^ dp", model, lagrange_two_form(L, state, w1, w2),
                S(dq1.dot(dp(dq2, dv2)) - dq2.dot(dp(dq1, dv1))));

    // X_E contracted with omega_L is dE; the matrix of omega_L has an inverse, so no other field does it.
    auto const X = lagrange_vector_field(L, state);
    auto const dE = [&](auto const& w) { return energy(L, moved(state, w)).part[0]; };
    claim.equal("X_E contracted with omega_L is dE", model, lagrange_two_form(L, state, X, w1), dE(w1),
                hessian_condition);
    if (n <= 3) {
      Matrix<S> omega(2 * n, 2 * n);
      Vector<S> slope(2 * n);
      auto const unit = [&](int i) {
        return StateChange<SpannedGroup, S>{
            {group, i < n ? Vector<S>(Vector<S>::Unit(n, i)) : Vector<S>(Vector<S>::Zero(n))},
            {group, i < n ? Vector<S>(Vector<S>::Zero(n)) : Vector<S>(Vector<S>::Unit(n, i - n))}};
      };
      for (int i = 0; i < 2 * n; ++i) {
        slope[i] = dE(unit(i));
        for (int j = 0; j < 2 * n; ++j) omega(i, j) = lagrange_two_form(L, state, unit(j), unit(i));
      }
      Vector<S> x(2 * n);
      x << X.configuration.coordinates, X.velocity.coordinates;
      claim.equal("the only solution of X contracted with omega_L = dE", model, solve_linear(omega, slope), x,
                  hessian_condition);
    }
    // Its integral curves solve (2.4), read in the chart: find q'' with this xi'.
    Matrix<S> const columns = frame(chart, q);
    Vector<S> const none = Vector<S>::Zero(n);
    Vector<S> const second =
        solve_linear(columns, Vector<S>((X.velocity - acceleration_in(chart, q, v, none)).coordinates));
    claim.zero("integral curves solve (2.4)", model, euler_lagrange_in_coordinates(f, q, v, second),
               size_of(euler_lagrange_in_coordinates(f, q, v, none)), hessian_condition);

    // Controls: the other sign of omega_L; a field that is not second order; no field where L is not regular.
    claim.differs("omega_L = + d theta_L", model, S(-lagrange_two_form(L, state, X, w1)), dE(w1));
    claim.differs("acceleration left out", model,
                  lagrange_two_form(L, state, {X.configuration, S(0) * X.velocity}, w1), dE(w1));
    auto singular = L;
    singular.kinetic.c.setZero();
    singular.kinetic.a.row(0).setZero(), singular.kinetic.a.col(0).setZero();
    claim.template refuses<Singular>("a Lagrangian that is not regular", model,
                                     [&] { lagrange_vector_field(singular, state); });
  });
}

// ----
// Section 2.1, at a point: the theorem on the variation of the action, and that its map and its form are the
// only ones.
//
// Every identity is one between derivatives at a random point, so it is exact over the rationals on every
// group.

namespace {

/// \f$\langle W, g\rangle\,(\xi_0)_+^{k+1}\f$ where \f$\xi_0\f$ is positive; on the other side of the seam it
/// is zero. With this term a Lagrangian has k continuous derivatives and no more.
template <class S>
struct BeyondSeam {
  int k;
  Matrix<S> weight;
  template <class T>
  T operator()(State<SpannedGroup, T> const& v) const {
    T power = contract(weight, Matrix<T>(v.configuration.value));
    for (int i = 0; i <= k; ++i) power *= v.velocity.coordinates[0];
    return power;
  }
};
/// The coefficients of a polynomial with vectors for values, in rows: from its values at `count` nodes.
template <class S, class F>
Matrix<S> coefficients_of(F const& f, int count) {
  Matrix<S> powers(count, count), at_nodes(count, f(S(0)).size());
  for (int i = 0; i < count; ++i) {
    S const node = ratio<S>(2 * i - count + 1, count);
    for (int j = 0; j < count; ++j) powers(i, j) = j == 0 ? S(1) : S(powers(i, j - 1) * node);
    at_nodes.row(i) = f(node).transpose();
  }
  return solve_linear(powers, at_nodes, "coefficients_of");
}
/// A Lagrangian of class C^k has a map of class C^{k-2} and a form of class C^{k-1}, and no better: what the
/// two sides of a seam differ by, as a polynomial in the distance from it, begins with the power that
/// follows.
template <class S>
void lose_derivatives(Claim<S>& claim, Draw& draw, SpannedGroup const& group, int k) {
  std::string const name = "C^" + std::to_string(k) + ", seam in " + group.name();
  BeyondSeam<S> const beyond{k, draw_matrix<S>(draw, group.matrix_size(), group.matrix_size())};
  auto const v = draw_state<S>(draw, group);
  auto const acceleration = draw.template velocity<S>(group);
  auto const at = [&](S const& distance) {
    auto moved = v;
    moved.velocity.coordinates[0] = distance;
    return moved;
  };
  // k + 2 powers at most: the products of a power, a bracket and the derivative of the weight.
  auto const map = coefficients_of<S>(
      [&](S const& x) { return Vector<S>(euler_lagrange(beyond, at(x), acceleration).components); }, k + 3);
  auto const form =
      coefficients_of<S>([&](S const& x) { return Vector<S>(legendre(beyond, at(x)).components); }, k + 3);
  // Powers at up to seven nodes within 1: a condition below a thousand.
  double const condition = 1000;
  claim.zero("D_EL has k - 2 continuous derivatives", name, Matrix<S>(map.topRows(k - 1)), size_of(map),
             condition);
  claim.zero("theta_L has k - 1 continuous derivatives", name, Matrix<S>(form.topRows(k)), size_of(form),
             condition);
  claim.refutes("D_EL has one more", name, Matrix<S>(map.row(k - 1)), size_of(map));
  claim.refutes("theta_L has one more", name, Matrix<S>(form.row(k)), size_of(form));
}

}  // namespace

STATEMENT(thm_2_1_1, "the Euler-Lagrange map and the Lagrange one-form from the variation of the action") {
  claim.corrected(
      R"(\ddot G \subset TG, \qquad \hat\delta g(t) \equiv )"
      R"(\frac{d}{d\epsilon}\Big|_{\epsilon=0}\frac{d}{dt}\Big|_{t=0} g_\epsilon(t))",
      R"(\ddot G \subset T(TG), \qquad \hat\delta g(t) \equiv )"
      R"(\frac{d}{d\epsilon}\Big|_{\epsilon=0}\frac{d}{dt} g_\epsilon(t))",
      "The second-order set lies in $T(TG)$ rather than $TG$, and the lifted variation is taken at "
      "$t$ rather than at 0. Then (2.6) holds; that map and form are the only ones is "
      "claim_2_1_el_map_and_form_unique. The classes $C^{k-2}$ and $C^{k-1}$ are tried for $k = 2, 3, "
      "4$, with Lagrangians that have no more derivatives than that across a seam.");
  claim.same_slip_as("claim_2_1_lifted_variation");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_state_polynomial<S>(draw, group);
    auto const curve = draw_curve<S>(draw, group);
    auto const family = draw_family<S>(draw, group, curve);
    S const t = ratio<S>(1, 3);

    // (2.6) for all intervals is its derivative at the upper end, for all t: the rate of the boundary term
    // and the Euler-Lagrange term.
    S const variation = L(varied_tangent(family, t)).part[0];
    Dual<S> time(t);
    time.part[0] = S(1);
    S const boundary_rate =
        lagrange_one_form(L, tangent(curve, time), lifted_variation(family, time)).part[0];
    auto const state = tangent(curve, t);
    auto const acceleration = second_tangent(curve, t).velocity;
    S const inside = pair(euler_lagrange(L, state, acceleration), lifted_variation(family, t).configuration);
    claim.zero("(2.6), differentiated by its upper end", model, S(variation - inside - boundary_rate),
               S(size_of(variation) + size_of(inside) + size_of(boundary_rate)));
    // Controls: the lift as printed; a map on TG, which would have the same value at another curve with this
    // tangent; the sign of the map; no boundary.
    S const printed_rate =
        pair(legendre(L, tangent(curve, time)), over<Dual<S>>(lifted_variation(family, S(0)).configuration))
            .part[0];
    claim.differs("the lift as printed, at t = 0", model, variation, S(inside + printed_rate));
    auto const bend = draw.template velocity<S>(group);
    auto const bent = [&](auto const& s) {
      using T = std::decay_t<decltype(s)>;
      T const x = s - T(t);
      return retract((x * x) * over<T>(bend)) * curve(s);
    };
    auto const elsewhere = euler_lagrange(L, tangent(bent, t), second_tangent(bent, t).velocity);
    claim.differs("D_EL as a map on TG, taken from another curve with this tangent", model, variation,
                  S(pair(elsewhere, lifted_variation(family, t).configuration) + boundary_rate));
    claim.differs("D_EL with the other sign", model, variation, S(boundary_rate - inside));
    claim.differs("boundary term left out", model, variation, inside);
  });
  for (int const k : {2, 3, 4}) {
    lose_derivatives(claim, draw, spanned("Aff(1)", Aff1{}), k);
    lose_derivatives(claim, draw, spanned("SO(3)", SO<3>{}), k);
  }
}

STATEMENT(claim_2_1_el_map_and_form_unique, "there is one Euler-Lagrange map and one Lagrange one-form") {
  claim.holds("The action determines both; the equations of motion alone do not determine the form.");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_state_polynomial<S>(draw, group);
    auto const curve = draw_curve<S>(draw, group);
    int const n = group.dimension();
    S const t = ratio<S>(1, 3);
    Dual<S> time(t);
    time.part[0] = S(1);

    // Suppose d/de L = <D, theta> + d/dt <alpha, theta> + d/dt <beta, theta'> for all variations. The right
    // side is linear in (theta, theta', theta''); as many variations as there are unknown coefficients
    // determine them.
    Matrix<S> rows(3 * n, 3 * n);
    Vector<S> response(3 * n);
    for (int i = 0; i < 3 * n; ++i) {
      auto const family = draw_family<S>(draw, group, curve);
      auto const theta = [&](auto const& s) { return lifted_variation(family, s).configuration; };
      auto const theta_rate = [&](auto const& s) {
        using T = std::decay_t<decltype(s)>;
        Dual<T> moving_time(s);
        moving_time.part[0] = T(1);
        return rate_of(theta(moving_time));
      };
      rows.row(i) << theta(t).coordinates.transpose(), theta_rate(t).coordinates.transpose(),
          rate_of(theta_rate(time)).coordinates.transpose();
      response[i] = L(varied_tangent(family, t)).part[0];
    }
    // A system of random rows of up to 18 unknowns costs a few digits.
    double const condition = 1e4;
    Vector<S> const found = solve_linear(rows, response, "variations must be independent");

    // beta = 0; alpha is the one-form of the library; the coefficient of theta is D + alpha'.
    auto const state = tangent(curve, t);
    auto const mu = legendre(L, state), mu_rate = rate_of(legendre(L, tangent(curve, time)));
    auto const map = euler_lagrange(L, state, second_tangent(curve, t).velocity);
    claim.zero("the form does not depend on changes of the velocity", model, Vector<S>(found.tail(n)),
               size_of(mu), condition);
    claim.equal("the only form is theta_L", model, Vector<S>(found.segment(n, n)), mu.components, condition);
    claim.equal("the only map is D_EL L", model, Vector<S>(found.head(n) - mu_rate.components),
                map.components, condition);

    // Control: L + d/dt f has the same map and another form, so that the map of the one with the form of the
    // other do not add up.
    Matrix<S> const weights = draw_matrix<S>(draw, group.matrix_size(), group.matrix_size());
    auto const gauged = [&](auto const& v) {
      using T = typename std::decay_t<decltype(v)>::Scalar;
      Matrix<T> const g = v.configuration.value, g_rate = group.hat(v.velocity.coordinates) * g;
      return L(v) + contract(weights, g) * contract(weights, g_rate);
    };
    claim.equal("a total derivative does not change the map", model,
                euler_lagrange(gauged, state, second_tangent(curve, t).velocity), map);
    claim.differs("but it changes the form", model, legendre(gauged, state), mu);
    claim.refutes("map without the rate of the form", model, Vector<S>(found.head(n) - map.components),
                  size_of(map));
  });
}

// ----
// Section 2.1, at a point: where the Euler-Lagrange map lives, and Noether's theorem.
//
// Every identity is one between derivatives at a random point, so it is exact over the rationals on every
// group.

namespace {}  // namespace

STATEMENT(claim_2_1_second_order_set, "where the Euler-Lagrange map lives") {
  claim.corrected(R"(\ddot G \equiv \Bigl\{\frac{d^2 g}{dt^2}(0) \Bigm| q \text{ a } C^2 \text{ curve in } )"
                  R"(G\Bigr\} \text{ of } TG)",
                  R"(\ddot G \equiv \Bigl\{\frac{d^2 g}{dt^2}(0) \Bigm| g \text{ a } C^2 \text{ curve in } )"
                  R"(G\Bigr\} \subset T(TG))",
                  "Second derivatives are tangent vectors of $TG$, so the set lies in $T(TG)$: it holds "
                  "the $w$ for which $T\\tau_G(w)$ is the base point of $w$, where $\\tau_G\\colon TG\\to "
                  "G$ is the projection. As printed it would lie in $TG$; the curve is $g$, not $q$.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_state_polynomial<S>(draw, group);
    auto const curve = draw_curve<S>(draw, group);
    S const t = ratio<S>(1, 3);
    auto const state = tangent(curve, t);
    auto const second = second_tangent(curve, t);

    // The second derivative of a curve is a tangent vector of TG whose configuration part is the velocity of
    // its base point.
    claim.equal("second derivatives are second order", model, second.configuration, state.velocity);
    // The map depends on no more of the curve: change it at third order.
    auto const bend = draw.template velocity<S>(group);
    auto const third = [&](auto const& s) {
      using T = std::decay_t<decltype(s)>;
      T const x = s - T(t);
      return retract((x * x * x) * over<T>(bend)) * curve(s);
    };
    auto const map = euler_lagrange(L, state, second.velocity);
    claim.equal("the same for curves that agree to second order", model,
                euler_lagrange(L, tangent(third, t), second_tangent(third, t).velocity), map);
    // Control: curves with the same point of TG, different at second order. A map on a subset of TG could not
    // tell them apart.
    auto const first = [&](auto const& s) {
      using T = std::decay_t<decltype(s)>;
      T const x = s - T(t);
      return retract((x * x) * over<T>(bend)) * curve(s);
    };
    claim.equal("a curve with the same tangent", model, tangent(first, t).velocity, state.velocity);
    claim.differs("has another value of D_EL: the set is not in TG", model,
                  euler_lagrange(L, tangent(first, t), second_tangent(first, t).velocity), map);
    auto const other = draw.template velocity<S>(group);
    claim.differs("a tangent vector of TG that is not second order", model, other, state.velocity);
  });
}

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
      // The symmetry leaves L as it is; J is its lift contracted with theta_L; J generates it; J stays.
      claim.zero(what + ": the Lagrangian is invariant", model, L(moved(v, lifted)).part[0], size_of(J));
      claim.equal(what + ": J = lift contracted with theta_L", model, lagrange_one_form(L, v, lifted), J);
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
