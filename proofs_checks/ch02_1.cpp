// Section 2.1, over finite times: the action of a curve and its variation.
//
// Curves are polynomials in time (exact_motions.hpp), integrals are exact, so every residual is zero over the
// rationals.

#include "actio/variational/curves.hpp"
#include "actio/variational/euler_lagrange.hpp"
#include "actio/variational/lagrange_forms.hpp"

#include "models/charts.hpp"
#include "models/exact_motions.hpp"
#include "statement.hpp"

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
      "The integral does not depend on the coordinates in which $g$ and its rate are "
      "expressed; it depends on $a$ and $b$.");
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
    auto const family = shifted(m, other, fixed);
    auto const bent_family = [&](auto const& e, auto const& t) {
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
      "The boundary term is the one-form $(\\partial L/\\partial\\dot g)\\,dg$, which is the "
      "Lagrange one-form of the library.");
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
  claim.corrected(R"(\hat\delta g(t) \equiv \frac{d}{d\epsilon}\Big|_{\epsilon=0}\frac{d}{dt}\Big|_{t=0} g_)"
                  R"(\epsilon(t))",
                  R"(\hat\delta g(t) \equiv \frac{d}{d\epsilon}\Big|_{\epsilon=0}\frac{d}{dt} g_\epsilon(t))",
                  "The lifted variation in (2.6) is to be taken at the time $t$ of the end point, not at "
                  "$t = 0$ as its definition below the formula is printed.");
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
// Section 2.1, at a point: the Euler-Lagrange equations, charts, regularity, the Lagrange vector field.
//
// Every identity is one between derivatives at a random point, so it is exact over the rationals on every
// group.

namespace {

/// Solving with a fibre Hessian magnifies rounding by its condition, about 30 for these Lagrangians.
constexpr double hessian_condition = 30;

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
      "The left side of (2.4) is a covector; the second derivatives in it are "
      "those of one curve in both charts.");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_state_polynomial<S>(draw, group);
    auto const h = draw.template element<S>(group), k = draw.template element<S>(group);
    auto const first = chart_right(h);
    auto const second = chart_left(k);
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

    auto const L1 = in_coordinates(L, first);
    auto const L2 = in_coordinates(L, second);
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
  claim.corrected(R"(\ddot G \subset TG, \qquad \hat\delta g(t) \equiv )"
                  R"(\frac{d}{d\epsilon}\Big|_{\epsilon=0}\frac{d}{dt}\Big|_{t=0} g_\epsilon(t))",
                  R"(\ddot G \subset T(TG), \qquad \hat\delta g(t) \equiv )"
                  R"(\frac{d}{d\epsilon}\Big|_{\epsilon=0}\frac{d}{dt} g_\epsilon(t))",
                  "The second-order set lies in $T(TG)$ rather than $TG$, and the lifted variation is "
                  "taken at $t$ rather than at 0. Then (2.6) holds; that map and form are the only ones is "
                  "claim_2_1_el_map_and_form_unique. The classes $C^{k-2}$ and $C^{k-1}$ are tried for $k "
                  "= 2, 3, 4$, with Lagrangians that have no more derivatives than that across a seam.");
  claim.same_slip_as("claim_2_1_lifted_variation");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_state_polynomial<S>(draw, group);
    auto const curve = draw_retracted_curve<S>(draw, group);
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
    auto const curve = draw_retracted_curve<S>(draw, group);
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
// Section 2.1, at a point: where the Euler-Lagrange map lives.
//
// Every identity is one between derivatives at a random point, so it is exact over the rationals on every
// group.

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
    auto const curve = draw_retracted_curve<S>(draw, group);
    S const t = ratio<S>(1, 3);
    auto const state = tangent(curve, t);
    auto const second = second_tangent(curve, t);

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
    // Every vector whose projection is its base point is one: a curve with this tangent and any rate of it.
    auto const wanted = draw.template velocity<S>(group);
    auto const through = [&](auto const& s) {
      using T = std::decay_t<decltype(s)>;
      T const x = s - T(t);
      return retract(x * over<T>(state.velocity) + (x * x * T(ratio<S>(1, 2))) * over<T>(wanted)) *
             over<T>(state.configuration);
    };
    claim.equal("a curve through any tangent", model, tangent(through, t).velocity, state.velocity);
    claim.equal("with any second-order vector for its second derivative", model,
                second_tangent(through, t).velocity, wanted);
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
