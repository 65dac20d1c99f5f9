// Section 3.1: symplecticity of the discrete flow. Compiled once per scalar.
//
// Degrees. Motions are made by design: the coefficients of the added terms come from a linear system with up to 8 rows (12 where numbers are rounded), whose entries have degree 30 at most, so
// with denominators cleared a Lagrangian has degree 300 at most. The tangent of the flow solves a system of 4 rows of such entries: degree 1500; a second step doubles it.
#include "pairs.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

STATEMENT(eq_3_6, "differential of the action along motions: one one-form at either end") {
  claim.corrected(R"(d\mathbb S=\theta^-_{\mathbb L}+F^*\theta^+_{\mathbb L})", R"(d\mathbb S=\theta^-_{\mathbb L}+(\mathbb F^{N-1})^*\theta^+_{\mathbb L})",
                  "The last of N pairs is N-1 steps of the flow from the first; the printed single step is right for N = 2 only. F is the flow, not the Legendre transformation.");
  claim.maybe_scan();
  claim.degree(5000);
  over_groups(groups_for_motions<S>(3), claim, [&](auto const& group, auto const& model) {
    // A motion of three pairs, and changes of its first pair carried along by the tangent of the flow.
    auto const g = draw_places<S>(draw, group, 4);
    auto const L = draw_with_motion<S>(draw, g);
    auto const w01 = draw_changes<S>(draw, group);
    std::vector<Change<S>> w12, w23;
    for (auto const& w : w01) w12.push_back(discrete_flow_tangent(L, g[0], g[1], g[2], w));
    for (auto const& w : w12) w23.push_back(discrete_flow_tangent(L, g[1], g[2], g[3], w));
    auto const along = [&](auto const& lagrangian) { return [&](auto const& q) { return discrete_action(lagrangian, q); }; };
    Vector<S> two(3), three(3), no_motion(3);
    auto const M = draw_pair_polynomial<S>(draw, group);
    for (int i = 0; i < 3; ++i) {
      two[i] = rate(Places<S>{g[0], g[1], g[2]}, {w01[i].first, w01[i].second, w12[i].second}, along(L));
      three[i] = rate(g, {w01[i].first, w01[i].second, w12[i].second, w23[i].second}, along(L));
      no_motion[i] = rate(g, {w01[i].first, w01[i].second, w12[i].second, w23[i].second}, along(M));
    }

    auto const minus = [&](auto const& lagrangian) { return on_each(w01, [&](auto const& w) { return discrete_one_form_minus(lagrangian, g[0], g[1], w); }); };
    auto const after_one = on_each(w12, [&](auto const& w) { return discrete_one_form_plus(L, g[1], g[2], w); });
    auto const after_two = [&](auto const& lagrangian) { return on_each(w23, [&](auto const& w) { return discrete_one_form_plus(lagrangian, g[2], g[3], w); }); };
    claim.equal("N = 2: one step, as printed", model, two, Vector<S>(minus(L) + after_one), flow_condition<S>(L, g[1], g[2]));
    claim.equal("N = 3: two steps", model, three, Vector<S>(minus(L) + after_two(L)), flow_condition<S>(L, g[1], g[2]) * flow_condition<S>(L, g[2], g[3]));
    claim.differs("N = 3 with one step, as printed", model, three, Vector<S>(minus(L) + after_one));
    claim.differs("along places that are no motion", model, no_motion, Vector<S>(minus(M) + after_two(M)));
  });
}

STATEMENT(claim_3_1_flow_symplectic, "the discrete flow keeps the discrete two-form") {
  claim.holds("Where the Lagrangian is regular, at every length of the step.");
  claim.degree(4000);
  over_groups(groups_for_motions<S>(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw_places<S>(draw, group, 3);
    auto const before = draw_changes<S>(draw, group);
    auto const carried = [&](auto const& lagrangian) {
      std::vector<Change<S>> after;
      for (auto const& w : before) after.push_back(discrete_flow_tangent(lagrangian, g[0], g[1], g[2], w));
      return after;
    };
    auto const form = [&](auto const& lagrangian, int k, auto const& w) { return on_pairs(w, [&](auto const& a, auto const& b) { return discrete_two_form(lagrangian, g[k], g[k + 1], a, b); }); };

    // The tangent of the flow is on trial too: along it the equation stays true, and the old second place is the new first.
    auto const L = draw_with_motion<S>(draw, g);
    auto const after = carried(L);
    double const condition = flow_condition<S>(L, g[1], g[2]);
    auto const left_behind = rates(D2(L, nudged(g[0], before[0].first), nudged(g[1], before[0].second)));
    auto const equation = rates(discrete_euler_lagrange(L, nudged(g[0], before[0].first), nudged(g[1], before[0].second), nudged(g[2], after[0].second)));
    claim.zero("the tangent of the flow keeps (3.2)", model, equation, size_of(left_behind), condition);
    claim.equal("the new first place moves as the old second did", model, after[0].first, before[0].second);

    claim.equal("the two-form after a step is that before", model, form(L, 1, after), form(L, 0, before), condition);
    claim.differs("with the opposite sign", model, form(L, 1, after), Vector<S>(-form(L, 0, before)));

    // Control: a constant spatial force f on the right side of (3.2) feeds the form with <f, [theta, theta']> at the middle place.
    auto const M = draw_pair_polynomial<S>(draw, group);
    auto const forced = form(M, 1, carried(M)), gain = Vector<S>(forced - form(M, 0, before));
    auto const force = discrete_euler_lagrange(M, g[0], g[1], g[2]);
    auto const fed = on_pairs(before, [&](auto const& a, auto const& b) { return pair(force, bracket(a.second, b.second)); });
    claim.zero("what a constant spatial force feeds into it", model, Vector<S>(gain - fed), size_of(forced), flow_condition<S>(M, g[1], g[2]));
    claim.refutes("with a constant spatial force", model, gain, size_of(force));
  });
}

STATEMENT(claim_3_1_symplecticity_chain, "symplecticity from the vanishing second differential of the action") {
  claim.corrected(R"(\mathbb F^*\omega_{\mathbb L}=\mathbb F^*(d\theta^+_{\mathbb L})=-d\theta^-_{\mathbb L}=\omega_{\mathbb L})",
                  R"(\mathbb F^*\omega_{\mathbb L}=-\mathbb F^*(d\theta^+_{\mathbb L})=d\theta^-_{\mathbb L}=\omega_{\mathbb L})",
                  "With the page's own omega = d theta- = -d theta+ the first and the last sign are wrong and cancel; the middle equality, from ddS = 0, is right. The chain holds as printed if omega is defined as d theta+.");
  claim.degree(4000);
  over_groups(groups_for_motions<S>(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw_places<S>(draw, group, 3);
    auto const L = draw_with_motion<S>(draw, g);
    auto const before = draw_changes<S>(draw, group);
    std::vector<Change<S>> after;
    for (auto const& w : before) after.push_back(discrete_flow_tangent(L, g[0], g[1], g[2], w));
    auto const minus = [&](auto const& g0, auto const& g1, auto const& w) { return discrete_one_form_minus(L, g0, g1, w); };
    auto const plus = [&](auto const& g0, auto const& g1, auto const& w) { return discrete_one_form_plus(L, g0, g1, w); };

    // d commutes with the pull-back: the exterior derivative at the new pair, on the carried vectors.
    auto const pulled_d_plus = on_pairs(after, [&](auto const& a, auto const& b) { return exterior_derivative(plus, g[1], g[2], a, b); });
    auto const d_minus = on_pairs(before, [&](auto const& a, auto const& b) { return exterior_derivative(minus, g[0], g[1], a, b); });
    auto const omega = on_pairs(before, [&](auto const& a, auto const& b) { return discrete_two_form(L, g[0], g[1], a, b); });
    auto const pulled_omega = on_pairs(after, [&](auto const& a, auto const& b) { return discrete_two_form(L, g[1], g[2], a, b); });
    double const condition = flow_condition<S>(L, g[1], g[2]);
    claim.equal("ddS = 0: F^*(d theta+) = -d theta-", model, pulled_d_plus, Vector<S>(-d_minus), condition);
    claim.equal("F^* omega = -F^*(d theta+)", model, pulled_omega, Vector<S>(-pulled_d_plus), condition);
    claim.equal("d theta- = omega", model, d_minus, omega);
    claim.equal("the two ends of the chain", model, pulled_omega, omega, condition);
    claim.differs("F^* omega = F^*(d theta+), as printed", model, pulled_omega, pulled_d_plus);
    claim.differs("-d theta- = omega, as printed", model, Vector<S>(-d_minus), omega);
  });
}
