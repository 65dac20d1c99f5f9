// Section 3.1, the discrete action, its differential and the equations that come out of it. Compiled once per scalar.
//
// Degrees. An element is a Cayley transform: entries of degree 4 at most over one denominator of degree 4. A Lagrangian on pairs is cubic in the
// entries with coefficients of degree 4 at most, so of degree 30 at most with denominators cleared; so are its derivatives.
#include "pairs.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// A discretization in Cayley's chart at the identity, wherever the places are: an approximation as \ref discretize_at_the_place is, but with an origin. `where` = 1/2 is half-way, 0 is at the first place.
template <class Lagrangian, class S>
auto discretize_at_the_identity(Lagrangian L, S h, S where) {
  return [=](auto const& g0, auto const& g1) {
    using T = typename std::decay_t<decltype(g0)>::Scalar;
    Vector<T> const x0 = g0.group.vee(inverse_cayley(g0.value)), x1 = g0.group.vee(inverse_cayley(g1.value));
    Vector<Dual<T>> middle(x0.size());
    for (Eigen::Index a = 0; a < x0.size(); ++a) {
      middle[a] = Dual<T>(T(x0[a] + (x1[a] - x0[a]) * T(where)));
      middle[a].part[0] = (x1[a] - x0[a]) / T(h);
    }
    auto const q = retract(velocity(g0.group, middle));
    return L(state_of(q)) * T(h);
  };
}

}  // namespace

STATEMENT(eq_3_1, "the action sums over the pairs between the two places that are held") {
  claim.corrected(R"(\mathbb S=\sum_{k=1}^{N}\mathbb L(g_k,g_{k+1}))", R"(\mathbb S=\sum_{k=0}^{N-1}\mathbb L(g_k,g_{k+1}))",
                  "The places are g_0, ..., g_N and the ends g_0 and g_N are held, so the sum runs over the N pairs between them; the printed range leaves "
                  "g_0 out, needs a place g_{N+1}, and its variation at g_1 is not (3.2).");
  claim.degree(300);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    // Places g_0, ..., g_N with N = 4, and g_5, which only the printed range asks for.
    auto const L = draw_pair_polynomial<S>(draw, group);
    auto const g = draw_places<S>(draw, group, 6);
    Places<S> const held(g.begin(), g.begin() + 5);
    auto const action = discrete_action(L, held);
    claim.equal("the action of g_0, ..., g_4 is the sum over its four pairs", model, action, S(L(g[0], g[1]) + L(g[1], g[2]) + L(g[2], g[3]) + L(g[3], g[4])));
    claim.differs("the printed range, k = 1, ..., N", model, sum_over_pairs(L, g, 1, 4), action);

    // Its differential at g_1 is the left side of (3.2).
    int const d = group.dimension();
    Vector<S> const expected = (D2(L, g[0], g[1]) + D1(L, g[1], g[2])).components;
    auto const right = differential(held, [&](auto const& q) { return discrete_action(L, q); });
    auto const printed = differential(g, [&](auto const& q) { return sum_over_pairs(L, q, 1, 4); });
    claim.equal("its differential at g_1 is the left side of (3.2)", model, Vector<S>(right.segment(d, d)), expected);
    claim.differs("differential of the printed sum at g_1", model, Vector<S>(printed.segment(d, d)), expected);
  });
}

STATEMENT(claim_3_1_discrete_from_continuous, "a discrete Lagrangian from an approximate place and an approximate velocity") {
  claim.convention("For equal steps. Print leaves the step out as a factor, which divides the action and every momentum by it; where steps differ the factor h belongs there, and the library's discrete Lagrangians carry it.");
  claim.degree(400);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const lagrangian = draw_state_polynomial<S>(draw, group);
    auto const g = draw_places<S>(draw, group, 3);
    S const h = ratio<S>(1, 3);
    auto const per_step = [&](S const& step) {
      return [L = discretize_at_the_place(lagrangian, step), step](auto const& g0, auto const& g1) { return L(g0, g1) / typename std::decay_t<decltype(g0)>::Scalar(step); };
    };

    // Equal steps: the factor drops out of (3.2).
    auto const action = discretize_at_the_place(lagrangian, h);
    auto const with_factor = discrete_euler_lagrange(action, g[0], g[1], g[2]);
    claim.equal("(3.2) with the factor h is h times (3.2) without", model, with_factor, h * discrete_euler_lagrange(per_step(h), g[0], g[1], g[2]));
    // Control: a second step of half the length.
    auto const half = discretize_at_the_place(lagrangian, S(h / 2));
    auto const two_steps = D2(action, g[0], g[1]) + D1(half, g[1], g[2]);
    claim.differs("unequal steps without the factor", model, h * (D2(per_step(h), g[0], g[1]) + D1(per_step(S(h / 2)), g[1], g[2])), two_steps);
  });

  // Along a smooth curve the approximate place and velocity tend to the true ones, and so does the Lagrangian.
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const lagrangian = draw_state_polynomial<S>(draw, group);
    auto const a = draw.template velocity<S>(group), b = draw.template velocity<S>(group);
    auto const g0 = draw.template element<S>(group);
    auto const curve = [&](auto const& t) {
      using T = std::decay_t<decltype(t)>;
      return retract(t * over<T>(a)) * retract(t * t * over<T>(b)) * over<T>(g0);
    };
    auto const error = [&](auto const& scheme, S const& h) {
      Dual<S> middle(S(h / 2));
      middle.part[0] = S(1);
      S const exact = lagrangian(state_of(curve(middle)));
      return std::abs(to_double(S(scheme(curve(S(0)), curve(h)) / h - exact)));
    };
    if constexpr (Real<S>) {
      std::vector<double> steps, at_place, at_identity, backwards;
      for (int k = 6; k <= 12; ++k) {
        S const h = S(1) / S(1 << k);
        steps.push_back(to_double(h));
        at_place.push_back(error(discretize_at_the_place(lagrangian, h), h));
        at_identity.push_back(error(discretize_at_the_identity(lagrangian, h, ratio<S>(1, 2)), h));
        backwards.push_back(error([&](auto const& p, auto const& q) { return discretize_at_the_place(lagrangian, h)(q, p); }, h));
      }
      claim.order("half-way in a chart at the place", model, steps, at_place, 2);
      claim.order("half-way in a chart at the identity", model, steps, at_identity, 2);
      // Control: earlier and later place exchanged, so that the velocity points backwards.
      claim.refutes_order("velocity from the later place to the earlier", model, steps, backwards, 2);
    }
  });
}

STATEMENT(rem_3_1_1, "a discretization without origin inherits the symmetry; lifted and diagonal actions agree") {
  claim.holds("Instance: the half-way rule in Cayley's chart at the place, right- and left-invariant Lagrangians. A chart at the identity, as accurate, does not inherit: the choice in the remark is needed.");
  claim.degree(600);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_algebra_polynomial<S>(draw, group.dimension());
    S const h = ratio<S>(1, 3);
    // Small draws keep every pair inside Cayley's chart.
    auto const g0 = draw.template element<S>(group), g1 = draw.template element<S>(group), bar = draw.template element<S>(group);

    // Right multiplication: the Lagrangian on TG does not see it, nor does the discrete one.
    auto const right = discretize_at_the_place(right_invariant(l), h), left = discretize_at_the_place(left_invariant(l), h);
    claim.equal("right-invariant: unchanged under (g0 k, g1 k)", model, right(g0 * bar, g1 * bar), right(g0, g1));
    claim.equal("left-invariant: unchanged under (k g0, k g1)", model, left(bar * g0, bar * g1), left(g0, g1));

    // A pair of infinitely near places, moved diagonally, is the state moved by the lifted action.
    State<SpannedGroup, S> const v{g0, draw.template velocity<S>(group)};
    auto const near = nudged(v.place, v.velocity);
    auto const moved_right_ = state_of(near * over<Dual<S>>(bar)), moved_left_ = state_of(over<Dual<S>>(bar) * near);
    claim.equal("lifted right action: the spatial velocity stays", model, moved_right_.velocity, v.velocity);
    claim.equal("lifted left action: the spatial velocity turns by Ad", model, moved_left_.velocity, Ad(bar, v.velocity));
    claim.equal("right-invariant on TG", model, right_invariant(l)(moved_right_), right_invariant(l)(v));
    claim.equal("left-invariant on TG", model, left_invariant(l)(moved_left_), left_invariant(l)(v));

    // Controls: the other side, one place alone.
    claim.differs("right-invariant Lagrangian, multiplied on the left", model, right(bar * g0, bar * g1), right(g0, g1));
    claim.differs("one place multiplied, not both", model, right(g0 * bar, g1), right(g0, g1));
  });
  // Where the group is nilpotent of class 2 even a chart at the identity inherits, so the last control has its own groups.
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const g = draw_places<S>(draw, group, 3);
    auto const with_origin = discretize_at_the_identity(right_invariant(l), ratio<S>(1, 3), S(0));
    claim.differs("discretized in a chart at the identity", model, with_origin(g[0] * g[2], g[1] * g[2]), with_origin(g[0], g[1]));
  });
}

STATEMENT(eq_3_2, "the discrete Euler-Lagrange equations are the stationarity of the action") {
  claim.holds();
  claim.degree(2000);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    // Off shell, four steps: the differential at each place in between is the left side of (3.2) there.
    auto const L = draw_pair_polynomial<S>(draw, group);
    auto const g = draw_places<S>(draw, group, 5);
    int const d = group.dimension();
    auto const inside = [&](auto const& lagrangian, Places<S> const& q) {
      int const N = static_cast<int>(q.size()) - 1;
      return Vector<S>(differential(q, [&](auto const& r) { return sum_over_pairs(lagrangian, r, 0, N - 1); }).segment(d, d * (N - 1)));
    };
    std::vector<Momentum<SpannedGroup, S>> equations, exchanged, shifted;
    for (int k = 1; k <= 3; ++k) {
      equations.push_back(discrete_euler_lagrange(L, g[k - 1], g[k], g[k + 1]));
      exchanged.push_back(D1(L, g[k - 1], g[k]) + D2(L, g[k], g[k + 1]));
      shifted.push_back(D2(L, g[k], g[k + 1]) + D1(L, g[k], g[k + 1]));
    }
    claim.equal("differential of the action, its ends held", model, inside(L, g), stacked(equations));
    claim.differs("the two slots exchanged", model, inside(L, g), stacked(exchanged));
    claim.differs("both derivatives at the later pair", model, inside(L, g), stacked(shifted));

    // On shell: a Lagrangian of which three places are a motion has them as a stationary sequence.
    auto const M = draw_with_motion<S>(draw, Places<S>{g[0], g[1], g[2]});
    auto const terms = size_of(D2(M, g[0], g[1]));
    claim.zero("a motion makes the action stationary", model, inside(M, {g[0], g[1], g[2]}), terms);
    claim.refutes("a sequence that is no motion", model, inside(M, {g[0], g[1], g[3]}), terms);
  });

  // The discrete flow finds the next place from the equation: four steps of the solver, the equation written out with the directional derivative.
  if constexpr (Real<S>)
    over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
      auto lagrangian = draw_state_polynomial<S>(draw, group);
      lagrangian.kinetic = draw_regular_algebra_polynomial<S>(draw, group);
      auto const L = discretize_at_the_place(lagrangian, ratio<S>(1, 64));
      Places<S> g = {draw.template element<S>(group)};
      g.push_back(retract(draw.template velocity<S>(group, ratio<S>(1, 256))) * g[0]);
      for (int k = 1; k <= 4; ++k) {
        g.push_back(step_euler_lagrange(L, g[k - 1], g[k]).value);
        auto const whole = differential(Places<S>{g[k - 1], g[k], g[k + 1]}, [&](auto const& q) { return sum_over_pairs(L, q, 0, 1); });
        // The solver stops at 16 roundings of the derivative, which is 1/h = 64 times a momentum.
        claim.zero("the place that the step finds satisfies (3.2)", model, Vector<S>(whole.segment(group.dimension(), group.dimension())), size_of(D2(L, g[k - 1], g[k])), 8);
      }
    });
}

STATEMENT(eq_3_3, "differential of the discrete action, ends free") {
  claim.corrected(R"(d\mathbb S=\sum_{k=1}^{N}D_2\mathbb L(g_k,g_{k+1})\delta g_k+\sum_{k=0}^{N-1}D_1\mathbb L(g_{k-1},g_k)\delta g_k=\dots)",
                  R"(d\mathbb S=\sum_{k=1}^{N}D_2\mathbb L(g_{k-1},g_k)\delta g_k+\sum_{k=0}^{N-1}D_1\mathbb L(g_k,g_{k+1})\delta g_k=\dots)",
                  "In the first line the arguments of the two sums are exchanged, so that it asks for places g_{-1} and g_{N+1}; the second line, with the boundary terms, holds as printed.");
  claim.degree(400);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    // N = 3: places all[1], ..., all[4] are g_0, ..., g_3; all[0] and all[5] are the g_{-1} and g_4 that print asks for.
    int const N = 3;
    auto const L = draw_pair_polynomial<S>(draw, group);
    auto const all = draw_places<S>(draw, group, N + 3);
    auto const g = [&](int k) { return all[k + 1]; };
    std::vector<Momentum<SpannedGroup, S>> right(N + 1, zero_momentum<S>(group)), printed = right, regrouped;
    for (int k = 1; k <= N; ++k) right[k] = right[k] + D2(L, g(k - 1), g(k)), printed[k] = printed[k] + D2(L, g(k), g(k + 1));
    for (int k = 0; k <= N - 1; ++k) right[k] = right[k] + D1(L, g(k), g(k + 1)), printed[k] = printed[k] + D1(L, g(k - 1), g(k));
    regrouped.push_back(D1(L, g(0), g(1)));
    for (int k = 1; k <= N - 1; ++k) regrouped.push_back(D1(L, g(k), g(k + 1)) + D2(L, g(k - 1), g(k)));
    regrouped.push_back(D2(L, g(N - 1), g(N)));

    auto const dS = differential(Places<S>{g(0), g(1), g(2), g(3)}, [&](auto const& q) { return discrete_action(L, q); });
    claim.equal("first line, arguments exchanged back", model, dS, stacked(right));
    claim.equal("second line, as printed", model, dS, stacked(regrouped));
    claim.differs("first line as printed", model, dS, stacked(printed));
  });
}

STATEMENT(claim_3_1_action_differential_split, "first slots and second slots of the action, each with its own range") {
  claim.corrected(R"(\sum_{k=1}^{N}D_2\mathbb L(g_k,g_{k+1})\delta g_k+\sum_{k=0}^{N-1}D_1\mathbb L(g_{k-1},g_k)\delta g_k)",
                  R"(\sum_{k=1}^{N}D_2\mathbb L(g_{k-1},g_k)\delta g_k+\sum_{k=0}^{N-1}D_1\mathbb L(g_k,g_{k+1})\delta g_k)",
                  "A place is the second of the pair before it and the first of the pair after it: D_2 goes with (g_{k-1}, g_k), D_1 with (g_k, g_{k+1}). The ranges are right.");
  claim.degree(400);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    // N = 4; all[0] and all[6] are the g_{-1} and g_5 that print asks for.
    int const N = 4;
    auto const L = draw_pair_polynomial<S>(draw, group);
    auto const all = draw_places<S>(draw, group, N + 3);
    auto const g = [&](int k) { return all[k + 1]; };
    // Two copies of the places: the pairs take their first place from one, their second from the other.
    Places<S> copies;
    for (int copy = 0; copy < 2; ++copy)
      for (int k = 0; k <= N; ++k) copies.push_back(g(k));
    auto const both = differential(copies, [&](auto const& q) {
      auto sum = L(q[0], q[N + 2]);
      for (int k = 1; k < N; ++k) sum += L(q[k], q[N + 1 + k + 1]);
      return sum;
    });
    Vector<S> const first = both.head(both.size() / 2), second = both.tail(both.size() / 2);

    std::vector<Momentum<SpannedGroup, S>> d1(N + 1, zero_momentum<S>(group)), d2 = d1, d1_printed = d1, d2_printed = d1;
    for (int k = 0; k <= N - 1; ++k) d1[k] = D1(L, g(k), g(k + 1)), d1_printed[k] = D1(L, g(k - 1), g(k));
    for (int k = 1; k <= N; ++k) d2[k] = D2(L, g(k - 1), g(k)), d2_printed[k] = D2(L, g(k), g(k + 1));
    claim.equal("first slots: D_1 at (g_k, g_{k+1}), k = 0, ..., N-1", model, first, stacked(d1));
    claim.equal("second slots: D_2 at (g_{k-1}, g_k), k = 1, ..., N", model, second, stacked(d2));
    claim.differs("first slots as printed", model, first, stacked(d1_printed));
    claim.differs("second slots as printed", model, second, stacked(d2_printed));
  });
}

STATEMENT(claim_3_1_action_differential_regrouped, "interior terms are (3.2), the ends leave one term each") {
  claim.holds("With the action summed over the pairs from g_0 to g_N, the corrected range of (3.1).");
  claim.degree(400);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    int const N = 4;
    auto const L = draw_pair_polynomial<S>(draw, group);
    auto const g = draw_places<S>(draw, group, N + 2);
    auto const dS = differential(g, [&](auto const& q) { return sum_over_pairs(L, q, 0, N - 1); });
    auto const none = zero_momentum<S>(group);

    std::vector<Momentum<SpannedGroup, S>> terms = {D1(L, g[0], g[1])};
    for (int k = 1; k <= N - 1; ++k) terms.push_back(D1(L, g[k], g[k + 1]) + D2(L, g[k - 1], g[k]));
    terms.push_back(D2(L, g[N - 1], g[N]));
    terms.push_back(none);
    claim.equal("interior and boundary terms", model, dS, stacked(terms));
    // Controls: the ends' derivatives exchanged, the sum of (3.1) as printed.
    auto exchanged = terms;
    exchanged[0] = D2(L, g[0], g[1]), exchanged[N] = D1(L, g[N - 1], g[N]);
    claim.differs("D_2 at the first end and D_1 at the last", model, dS, stacked(exchanged));
    claim.differs("the action summed over k = 1, ..., N", model, differential(g, [&](auto const& q) { return sum_over_pairs(L, q, 1, N); }), stacked(terms));
  });
}
