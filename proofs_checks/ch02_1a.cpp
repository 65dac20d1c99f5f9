// Scalars: rational, double (long: dec50, dec100)
// Section 2.1, over finite times: the action of a curve and its variation. Compiled once per scalar.
//
// Curves are polynomials in time (exact_motions.hpp), integrals are exact, so every residual is zero over the rationals. Degrees: the entries of a flow are
// quotients of polynomials of degree below 30 in the random numbers; forms and variations multiply at most eight of them and as many denominators.
#include "actio/variational/euler_lagrange.hpp"
#include "actio/variational/lagrange_forms.hpp"
#include "exact_motions.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

constexpr int degree_bound = 500;
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
  return momenta([&](auto const& x, auto const& v) { return m.in_entries(x, v); }, Vector<S>(q(t)), rate_of(q, t));
}

}  // namespace

STATEMENT(eq_2_1, "the action of a curve") {
  claim.holds("The integral does not see which coordinates express g and its rate; it depends on a and b.");
  claim.degree(degree_bound);
  Quadrature<S> const rule(polynomial_degree);
  over_groups(entry_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_exact_motions<S>(draw, group);
    auto const curve = draw_polynomial_curve(draw, m);
    auto const q = entries_of(m, curve);
    S const a = ratio<S>(-1, 5), b = ratio<S>(2, 5);

    // The library integrates along tangents in TG; the formula of the page is written in entries and their rates.
    S const intrinsic = action(m, curve, a, b, rule);
    claim.equal("integral along the tangent = integral in coordinates", model, intrinsic,
                rule([&](S const& t) { return m.in_entries(Vector<S>(q(t)), rate_of(q, t)); }, a, b), amplification);
    S const middle = ratio<S>(1, 7);
    claim.equal("additive over adjoining intervals", model, S(action(m, curve, a, middle, rule) + action(m, curve, middle, b, rule)),
                intrinsic, amplification);
    // Controls: a velocity that is not the curve's; another interval.
    claim.differs("twice the velocity", model,
                  rule([&](S const& t) { return m.in_entries(Vector<S>(q(t)), Vector<S>(rate_of(q, t) * S(2))); }, a, b), intrinsic);
    claim.differs("another end", model, action(m, curve, a, middle, rule), intrinsic);
  });
}

STATEMENT(eq_2_2, "the action is stationary at motions") {
  claim.holds();
  claim.degree(degree_bound);
  Quadrature<S> const rule(polynomial_degree);
  over_groups(entry_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_exact_motions<S>(draw, group);
    S const a = ratio<S>(-1, 5), b = ratio<S>(2, 5);
    auto const motion = m.motion(draw_near_state<S>(draw, group));
    auto const other = draw_polynomial_curve(draw, m);
    auto const fixed = draw_direction<S>(draw, group.dimension(), a, b, true),
               loose = draw_direction<S>(draw, group.dimension(), a, b, false);

    // Fixed ends: the first variation vanishes at a motion. Its terms are as large as those of the variation with loose ends.
    S const with_loose_ends = action_variation(m, shifted(m, motion, loose), a, b, rule);
    claim.zero("dS = 0 at a motion, ends fixed", model, action_variation(m, shifted(m, motion, fixed), a, b, rule),
               size_of(with_loose_ends), amplification);
    // Only the first-order change of the curve counts: bend the family at second order, and bend its parameter.
    auto const family = shifted(m, other, fixed), bent_family = [&](auto const&e, auto const&t) {
      using T = std::decay_t<decltype(t)>;
      return m.place(Vector<T>(m.read(Matrix<T>(other(t).value)) + fixed(t) * (e + e * e) + loose(t) * (e * e)));
    };
    S const off_motion = action_variation(m, family, a, b, rule);
    claim.equal("the same for every family with the same first-order change", model, action_variation(m, bent_family, a, b, rule),
                off_motion, amplification);
    // Controls.
    claim.refutes("ends that move", model, with_loose_ends, size_of(m(tangent(motion, a))));
    claim.refutes("a curve that is no motion", model, off_motion, size_of(m(tangent(other, a))));
  });
}

STATEMENT(eq_2_3, "first variation of the action, integrated by parts") {
  claim.holds("The last term is the boundary term; it vanishes for fixed ends.");
  claim.degree(degree_bound);
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
    auto const boundary = [&](auto const& delta, S const& t) { return S(momenta_in_entries(m, q, t).dot(Vector<S>(delta(t)))); };

    S const dS = action_variation(m, shifted(m, curve, loose), a, b, rule);
    claim.equal("dS = integral + boundary", model, dS, S(inside(loose) + boundary(loose, b) - boundary(loose, a)), amplification);
    claim.equal("fixed ends: no boundary", model, action_variation(m, shifted(m, curve, fixed), a, b, rule), inside(fixed), amplification);
    // Controls: no boundary, ends in the other order.
    claim.differs("boundary term left out", model, dS, inside(loose));
    claim.differs("boundary term from b to a", model, dS, S(inside(loose) + boundary(loose, a) - boundary(loose, b)));
  });
}

STATEMENT(eq_2_5, "first variation of the action with free ends") {
  claim.holds("The boundary term is the one-form (dL/dg') dg, which is the Lagrange one-form of the library.");
  claim.degree(degree_bound);
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
    claim.differs("the end a kept fixed", model, dS, boundary(b));
    claim.differs("momentum paired with the change of the velocity", model,
                  pair(legendre(m, tangent(motion, b)), lifted_variation(shifted(m, motion, loose), b).velocity), boundary(b));
  });
}

STATEMENT(eq_2_6, "variation of the action: Euler-Lagrange map inside, one-form at the ends") {
  claim.convention(
      "With the lifted variation taken at the time t of the end point, not at t = 0 as its definition below (2.6) is printed "
      "(claim_2_1_lifted_variation).");
  claim.degree(degree_bound);
  Quadrature<S> const rule(polynomial_degree);
  over_groups(entry_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_exact_motions<S>(draw, group);
    S const a = ratio<S>(-1, 5), b = ratio<S>(2, 5);
    auto const curve = draw_polynomial_curve(draw, m);
    auto const family = shifted(m, curve, draw_direction<S>(draw, group.dimension(), a, b, false));
    auto const inside = [&](S const& t) {
      auto const acceleration = second_tangent(curve, t).velocity;
      return pair(euler_lagrange(m, tangent(curve, t), acceleration), lifted_variation(family, t).place);
    };
    auto const one_form = [&](S const& t) { return lagrange_one_form(m, tangent(curve, t), lifted_variation(family, t)); };

    S const dS = action_variation(m, family, a, b, rule), integral = rule(inside, a, b), boundary = one_form(b) - one_form(a);
    claim.equal("(2.6), without coordinates", model, dS, S(integral + boundary), amplification);
    // Controls: either part alone; the sign of the boundary.
    claim.differs("integral alone", model, dS, integral);
    claim.differs("boundary alone", model, dS, boundary);
    claim.differs("boundary with the other sign", model, dS, S(integral - boundary));
  });
}

STATEMENT(claim_2_1_lifted_variation, "the lift of a variation, at the time of the variation") {
  claim.corrected(R"(\hat\delta g(t) \equiv \frac{d}{d\epsilon}\Big|_{\epsilon=0}\frac{d}{dt}\Big|_{t=0} g_\epsilon(t))",
                  R"(\hat\delta g(t) \equiv \frac{d}{d\epsilon}\Big|_{\epsilon=0}\frac{d}{dt} g_\epsilon(t))",
                  "The derivative in time is to be taken at t, not at 0: as printed the lift does not depend on t, and (2.6) fails unless "
                  "it is evaluated at one end only.");
  claim.degree(degree_bound);
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
    claim.equal("the lift covers the variation", model, lifted.place, rate_right(family(epsilon, Dual<S>(b))), amplification);
    auto const along_time = [&](auto const& t) { return lifted_variation(family, t).place; };
    Dual<S> time(b);
    time.part[0] = S(1);
    auto const xi = tangent(motion, b).velocity;
    claim.equal("its velocity part", model, lifted.velocity, rate(along_time(time)) - bracket(xi, lifted.place), amplification);
    // (2.6) along a motion is its boundary part.
    S const dS = action_variation(m, family, a, b, rule);
    auto const end = [&](S const& t, auto const& w) { return lagrange_one_form(m, tangent(motion, t), w); };
    claim.equal("(2.6) with the lift at t", model, dS, S(end(b, lifted) - end(a, lifted_variation(family, a))), amplification);
    // Control: as printed.
    claim.differs("the lift as printed, at t = 0", model, dS, S(end(b, at_zero) - end(a, at_zero)));
  });
}
