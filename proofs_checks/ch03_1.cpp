// Section 3.1, the discrete action, its differential and the equations that come out of it.

#include "models/pairs.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// A discretization in Cayley's chart at the identity, wherever the configurations are: an approximation as
/// \ref discretize_at_the_configuration is, but with an origin. `where` = 1/2 is half-way, 0 is at the first
/// configuration.
template <class Lagrangian, class S>
auto discretize_at_the_identity(Lagrangian L, S h, S where) {
  return [=](auto const& g0, auto const& g1) {
    using T = typename std::decay_t<decltype(g0)>::Scalar;
    Vector<T> const x0 = g0.group.vee(inverse_cayley(g0.value)), x1 = g0.group.vee(inverse_cayley(g1.value));
    Vector<Dual<T>> middle(x0.size());
    for (Index a = 0; a < x0.size(); ++a) {
      middle[a] = Dual<T>(T(x0[a] + (x1[a] - x0[a]) * T(where)));
      middle[a].part[0] = (x1[a] - x0[a]) / T(h);
    }
    auto const q = retract(velocity(g0.group, middle));
    return L(state_of(q)) * T(h);
  };
}

}  // namespace

STATEMENT(eq_3_1, "the action sums over the pairs between the two configurations that are held") {
  claim.corrected(R"(\mathbb S=\sum_{k=1}^{N}\mathbb L(g_k,g_{k+1}))",
                  R"(\mathbb S=\sum_{k=0}^{N-1}\mathbb )"
                  R"(L(g_k,g_{k+1}))",
                  "The configurations are $g_0,\\dots,g_N$ and the ends $g_0$ and $g_N$ are held, so the "
                  "sum runs over the $N$ pairs between them; the printed range leaves $g_0$ out, needs a "
                  "configuration $g_{N+1}$, and its variation at $g_1$ is not (3.2).");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    // Configurations g_0, ..., g_N with N = 4, and g_5, which only the printed range asks for.
    auto const L = draw_pair_polynomial<S>(draw, group);
    auto const g = draw_points<S>(draw, group, 6);
    GroupElements<S> const held(g.begin(), g.begin() + 5);
    auto const action = discrete_action(L, held);
    claim.equal("the action of g_0, ..., g_4 is the sum over its four pairs", model, action,
                S(L(g[0], g[1]) + L(g[1], g[2]) + L(g[2], g[3]) + L(g[3], g[4])));
    claim.differs("the printed range, k = 1, ..., N", model, sum_over_pairs(L, g, 1, 4), action);

    // Its differential at g_1 is the left side of (3.2).
    int const d = group.dimension();
    Vector<S> const expected = (D2(L, g[0], g[1]) + D1(L, g[1], g[2])).components;
    auto const right = differential(held, [&](auto const& q) { return discrete_action(L, q); });
    auto const printed = differential(g, [&](auto const& q) { return sum_over_pairs(L, q, 1, 4); });
    claim.equal("its differential at g_1 is the left side of (3.2)", model, Vector<S>(right.segment(d, d)),
                expected);
    claim.differs("differential of the printed sum at g_1", model, Vector<S>(printed.segment(d, d)),
                  expected);
  });
}

STATEMENT(claim_3_1_discrete_from_continuous,
          "a discrete Lagrangian from an approximate configuration and an approximate velocity") {
  claim.convention(
      "For equal steps. The thesis leaves the step out as a factor, which divides the action and "
      "every momentum by it; where steps differ the factor $h$ belongs there, and the library's "
      "discrete Lagrangians carry it.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const lagrangian = draw_state_polynomial<S>(draw, group);
    auto const g = draw_points<S>(draw, group, 3);
    S const h = ratio<S>(1, 3);
    auto const per_step = [&](S const& step) {
      return [L = discretize_at_the_configuration(lagrangian, step), step](auto const& g0, auto const& g1) {
        return L(g0, g1) / typename std::decay_t<decltype(g0)>::Scalar(step);
      };
    };

    // Equal steps: the factor drops out of (3.2).
    auto const action = discretize_at_the_configuration(lagrangian, h);
    auto const with_factor = discrete_euler_lagrange(action, g[0], g[1], g[2]);
    claim.equal("(3.2) with the factor h is h times (3.2) without", model, with_factor,
                h * discrete_euler_lagrange(per_step(h), g[0], g[1], g[2]));
    // Control: a second step of half the length.
    auto const half = discretize_at_the_configuration(lagrangian, S(h / 2));
    auto const two_steps = D2(action, g[0], g[1]) + D1(half, g[1], g[2]);
    claim.differs("unequal steps without the factor", model,
                  h * (D2(per_step(h), g[0], g[1]) + D1(per_step(S(h / 2)), g[1], g[2])), two_steps);
  });

  // Along a smooth curve the approximate configuration and velocity tend to the true ones, and so does the
  // Lagrangian.
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
    if (!exact_arithmetic<S>()) {
      std::vector<double> steps, at_configuration, at_identity, backwards;
      for (int k = 6; k <= 12; ++k) {
        S const h = S(1) / S(1 << k);
        steps.push_back(to_double(h));
        at_configuration.push_back(error(discretize_at_the_configuration(lagrangian, h), h));
        at_identity.push_back(error(discretize_at_the_identity(lagrangian, h, ratio<S>(1, 2)), h));
        backwards.push_back(
            error([&](auto const& p,
                      auto const& q) { return discretize_at_the_configuration(lagrangian, h)(q, p); },
                  h));
      }
      claim.order("half-way in a chart at the configuration", model, steps, at_configuration, 2);
      claim.order("half-way in a chart at the identity", model, steps, at_identity, 2);
      // Control: earlier and later configuration exchanged, so that the velocity points backwards.
      claim.refutes_order("velocity from the later configuration to the earlier", model, steps, backwards, 2);
    }
  });
}

STATEMENT(rem_3_1_1,
          "a discretization without origin inherits the symmetry; lifted and diagonal actions agree") {
  claim.holds(
      "Instance: the half-way rule in Cayley's chart at the configuration, right- and "
      "left-invariant Lagrangians. A chart at the identity, as accurate, does not inherit: the "
      "choice in the remark is needed.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_algebra_polynomial<S>(draw, group.dimension());
    S const h = ratio<S>(1, 3);
    // Draws are small, so that every pair is inside Cayley's chart.
    auto const g0 = draw.template element<S>(group), g1 = draw.template element<S>(group),
               bar = draw.template element<S>(group);

    // The Lagrangian on TG is invariant under right multiplication, and so is the discrete one.
    auto const right = discretize_at_the_configuration(right_invariant(l), h);
    auto const left = discretize_at_the_configuration(left_invariant(l), h);
    claim.equal("right-invariant: unchanged under (g0 k, g1 k)", model, right(g0 * bar, g1 * bar),
                right(g0, g1));
    claim.equal("left-invariant: unchanged under (k g0, k g1)", model, left(bar * g0, bar * g1),
                left(g0, g1));

    // A pair of infinitely near configurations, moved diagonally, is the state moved by the lifted action.
    State<SpannedGroup, S> const v{g0, draw.template velocity<S>(group)};
    auto const near = nudged(v.configuration, v.velocity);
    auto const moved_right_ = state_of(near * over<Dual<S>>(bar)),
               moved_left_ = state_of(over<Dual<S>>(bar) * near);
    claim.equal("lifted right action: the spatial velocity stays", model, moved_right_.velocity, v.velocity);
    claim.equal("lifted left action: the spatial velocity turns by Ad", model, moved_left_.velocity,
                Ad(bar, v.velocity));
    claim.equal("right-invariant on TG", model, right_invariant(l)(moved_right_), right_invariant(l)(v));
    claim.equal("left-invariant on TG", model, left_invariant(l)(moved_left_), left_invariant(l)(v));

    // Controls: the other side, one configuration alone.
    claim.differs("right-invariant Lagrangian, multiplied on the left", model, right(bar * g0, bar * g1),
                  right(g0, g1));
    claim.differs("one configuration multiplied, not both", model, right(g0 * bar, g1), right(g0, g1));
  });
  // Where the group is nilpotent of class 2 even a chart at the identity inherits, so the last control has
  // its own groups.
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const g = draw_points<S>(draw, group, 3);
    auto const with_origin = discretize_at_the_identity(right_invariant(l), ratio<S>(1, 3), S(0));
    claim.differs("discretized in a chart at the identity", model, with_origin(g[0] * g[2], g[1] * g[2]),
                  with_origin(g[0], g[1]));
  });
}

STATEMENT(eq_3_2, "the discrete Euler-Lagrange equations are the stationarity of the action") {
  claim.holds();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    // Off shell, four steps: the differential at each configuration in between is the left side of (3.2)
    // there.
    auto const L = draw_pair_polynomial<S>(draw, group);
    auto const g = draw_points<S>(draw, group, 5);
    int const d = group.dimension();
    auto const inside = [&](auto const& lagrangian, GroupElements<S> const& q) {
      int const N = static_cast<int>(q.size()) - 1;
      return Vector<S>(differential(q, [&](auto const& r) {
                         return sum_over_pairs(lagrangian, r, 0, N - 1);
                       }).segment(d, d * (N - 1)));
    };
    std::vector<Momentum<SpannedGroup, S>> equations, exchanged, shifted;
    for (int k = 1; k <= 3; ++k) {
      equations.push_back(discrete_euler_lagrange(L, g[k - 1], g[k], g[k + 1]));
      exchanged.push_back(D1(L, g[k - 1], g[k]) + D2(L, g[k], g[k + 1]));
      shifted.push_back(D2(L, g[k], g[k + 1]) + D1(L, g[k], g[k + 1]));
    }
    claim.equal("differential of the action, its ends held", model, inside(L, g), in_one_column(equations));
    claim.differs("the two slots exchanged", model, inside(L, g), in_one_column(exchanged));
    claim.differs("both derivatives at the later pair", model, inside(L, g), in_one_column(shifted));

    // On shell: a Lagrangian of which three configurations are a motion has them as a stationary sequence.
    auto const M = draw_with_motion<S>(draw, GroupElements<S>{g[0], g[1], g[2]});
    auto const terms = size_of(D2(M, g[0], g[1]));
    claim.zero("a motion makes the action stationary", model, inside(M, {g[0], g[1], g[2]}), terms);
    claim.refutes("a sequence that is no motion", model, inside(M, {g[0], g[1], g[3]}), terms);
  });

  // The discrete flow finds the next configuration from the equation: four steps of the solver, the equation
  // written out with the directional derivative.
  if (!exact_arithmetic<S>())
    over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
      auto lagrangian = draw_state_polynomial<S>(draw, group);
      lagrangian.kinetic = draw_regular_algebra_polynomial<S>(draw, group);
      auto const L = discretize_at_the_configuration(lagrangian, ratio<S>(1, 64));
      GroupElements<S> g = {draw.template element<S>(group)};
      g.push_back(retract(draw.template velocity<S>(group, ratio<S>(1, 256))) * g[0]);
      for (int k = 1; k <= 4; ++k) {
        g.push_back(step_euler_lagrange(L, g[k - 1], g[k]).value);
        auto const whole = differential(GroupElements<S>{g[k - 1], g[k], g[k + 1]},
                                        [&](auto const& q) { return sum_over_pairs(L, q, 0, 1); });
        // The solver stops at 16 roundings of the derivative, which is 1/h = 64 times a momentum.
        claim.zero("the configuration that the step finds satisfies (3.2)", model,
                   Vector<S>(whole.segment(group.dimension(), group.dimension())),
                   size_of(D2(L, g[k - 1], g[k])), 8);
      }
    });
}

STATEMENT(eq_3_3, "differential of the discrete action, ends free") {
  claim.corrected(
      R"(d\mathbb S=\sum_{k=1}^{N}D_2\mathbb L(g_k,g_{k+1})\delta g_k+\sum_{k=0}^{N-1}D_1)"
      R"(\mathbb L(g_{k-1},g_k)\delta g_k=\dots)",
      R"(d\mathbb S=\sum_{k=1}^{N}D_2\mathbb L(g_{k-1},g_k)\delta g_k+\sum_{k=0}^{N-1}D_1)"
      R"(\mathbb L(g_k,g_{k+1})\delta g_k=\dots)",
      "In the first line the arguments of the two sums are exchanged, so that it asks for configurations "
      "$g_{-1}$ and $g_{N+1}$; the second line, with the boundary terms, holds as printed.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    // N = 3: configurations all[1], ..., all[4] are g_0, ..., g_3; all[0] and all[5] are the g_{-1} and g_4
    // that the thesis prints.
    int const N = 3;
    auto const L = draw_pair_polynomial<S>(draw, group);
    auto const all = draw_points<S>(draw, group, N + 3);
    auto const g = [&](int k) { return all[k + 1]; };
    std::vector<Momentum<SpannedGroup, S>> right(N + 1, zero_momentum<S>(group)), printed = right, regrouped;
    for (int k = 1; k <= N; ++k)
      right[k] = right[k] + D2(L, g(k - 1), g(k)), printed[k] = printed[k] + D2(L, g(k), g(k + 1));
    for (int k = 0; k <= N - 1; ++k)
      right[k] = right[k] + D1(L, g(k), g(k + 1)), printed[k] = printed[k] + D1(L, g(k - 1), g(k));
    regrouped.push_back(D1(L, g(0), g(1)));
    for (int k = 1; k <= N - 1; ++k) regrouped.push_back(D1(L, g(k), g(k + 1)) + D2(L, g(k - 1), g(k)));
    regrouped.push_back(D2(L, g(N - 1), g(N)));

    auto const dS = differential(GroupElements<S>{g(0), g(1), g(2), g(3)},
                                 [&](auto const& q) { return discrete_action(L, q); });
    claim.equal("first line, arguments exchanged back", model, dS, in_one_column(right));
    claim.equal("second line, as printed", model, dS, in_one_column(regrouped));
    claim.differs("first line as printed", model, dS, in_one_column(printed));
  });
}

STATEMENT(claim_3_1_action_differential_split,
          "first slots and second slots of the action, each with its own range") {
  claim.corrected(R"(\sum_{k=1}^{N}D_2\mathbb L(g_k,g_{k+1})\delta g_k+\sum_{k=0}^{N-1}D_1\mathbb )"
                  R"(L(g_{k-1},g_k)\delta g_k)",
                  R"(\sum_{k=1}^{N}D_2\mathbb L(g_{k-1},g_k)\delta g_k+\sum_{k=0}^{N-1}D_1\mathbb )"
                  R"(L(g_k,g_{k+1})\delta g_k)",
                  "A configuration is the second of the pair before it and the first of the pair after it: "
                  "$D_2$ goes with $(g_{k-1}, g_k)$, $D_1$ with $(g_k, g_{k+1})$. The ranges are right.");
  claim.same_slip_as("eq_3_3");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    // N = 4; all[0] and all[6] are the g_{-1} and g_5 that the thesis prints.
    int const N = 4;
    auto const L = draw_pair_polynomial<S>(draw, group);
    auto const all = draw_points<S>(draw, group, N + 3);
    auto const g = [&](int k) { return all[k + 1]; };
    // Two copies of the configurations: the pairs take their first configuration from one, their second from
    // the other.
    GroupElements<S> copies;
    for (int copy = 0; copy < 2; ++copy)
      for (int k = 0; k <= N; ++k) copies.push_back(g(k));
    auto const both = differential(copies, [&](auto const& q) {
      auto sum = L(q[0], q[N + 2]);
      for (int k = 1; k < N; ++k) sum += L(q[k], q[N + 1 + k + 1]);
      return sum;
    });
    Vector<S> const first = both.head(both.size() / 2), second = both.tail(both.size() / 2);

    std::vector<Momentum<SpannedGroup, S>> d1(N + 1, zero_momentum<S>(group)), d2 = d1, d1_printed = d1,
                                                                               d2_printed = d1;
    for (int k = 0; k <= N - 1; ++k) d1[k] = D1(L, g(k), g(k + 1)), d1_printed[k] = D1(L, g(k - 1), g(k));
    for (int k = 1; k <= N; ++k) d2[k] = D2(L, g(k - 1), g(k)), d2_printed[k] = D2(L, g(k), g(k + 1));
    claim.equal("first slots: D_1 at (g_k, g_{k+1}), k = 0, ..., N-1", model, first, in_one_column(d1));
    claim.equal("second slots: D_2 at (g_{k-1}, g_k), k = 1, ..., N", model, second, in_one_column(d2));
    claim.differs("first slots as printed", model, first, in_one_column(d1_printed));
    claim.differs("second slots as printed", model, second, in_one_column(d2_printed));
  });
}

STATEMENT(claim_3_1_action_differential_regrouped, "interior terms are (3.2), the ends leave one term each") {
  claim.holds("With the action summed over the pairs from $g_0$ to $g_N$, the corrected range of (3.1).");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    int const N = 4;
    auto const L = draw_pair_polynomial<S>(draw, group);
    auto const g = draw_points<S>(draw, group, N + 2);
    auto const dS = differential(g, [&](auto const& q) { return sum_over_pairs(L, q, 0, N - 1); });
    auto const none = zero_momentum<S>(group);

    std::vector<Momentum<SpannedGroup, S>> terms = {D1(L, g[0], g[1])};
    for (int k = 1; k <= N - 1; ++k) terms.push_back(D1(L, g[k], g[k + 1]) + D2(L, g[k - 1], g[k]));
    terms.push_back(D2(L, g[N - 1], g[N]));
    terms.push_back(none);
    claim.equal("interior and boundary terms", model, dS, in_one_column(terms));
    // Controls: the ends' derivatives exchanged, the sum of (3.1) as printed.
    auto exchanged = terms;
    exchanged[0] = D2(L, g[0], g[1]), exchanged[N] = D1(L, g[N - 1], g[N]);
    claim.differs("D_2 at the first end and D_1 at the last", model, dS, in_one_column(exchanged));
    claim.differs("the action summed over k = 1, ..., N", model,
                  differential(g, [&](auto const& q) { return sum_over_pairs(L, q, 1, N); }),
                  in_one_column(terms));
  });
}

// ----
// Section 3.1: the discrete Lagrange forms on G x G.

namespace {

/// The two one-forms as functions of (g0, g1, change), for \ref exterior_derivative.
template <class Lagrangian>
auto minus_form(Lagrangian const& L) {
  return
      [&L](auto const& g0, auto const& g1, auto const& w) { return discrete_one_form_minus(L, g0, g1, w); };
}
template <class Lagrangian>
auto plus_form(Lagrangian const& L) {
  return [&L](auto const& g0, auto const& g1, auto const& w) { return discrete_one_form_plus(L, g0, g1, w); };
}

}  // namespace

STATEMENT(eq_3_4, "the two one-forms add up to the differential of the Lagrangian") {
  claim.holds();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_pair_polynomial<S>(draw, group);
    auto const g = draw_points<S>(draw, group, 2);
    auto const w = draw_changes<S>(draw, group);
    auto const dL = on_each(w, [&](auto const& u) {
      return rate(g, {u.first, u.second}, [&](auto const& q) { return L(q[0], q[1]); });
    });
    auto const minus = on_each(w, [&](auto const& u) { return discrete_one_form_minus(L, g[0], g[1], u); });
    auto const plus = on_each(w, [&](auto const& u) { return discrete_one_form_plus(L, g[0], g[1], u); });
    claim.equal("theta- plus theta+ is dL", model, Vector<S>(minus + plus), dL);
    // Each lives in its own slot.
    auto const still = rest<S>(group);
    claim.equal("theta- is dL with the second configuration at rest", model, minus,
                on_each(w, [&](auto const& u) {
                  return rate(g, {u.first, still}, [&](auto const& q) { return L(q[0], q[1]); });
                }));
    claim.equal("theta+ is dL with the first configuration at rest", model, plus,
                on_each(w, [&](auto const& u) {
                  return rate(g, {still, u.second}, [&](auto const& q) { return L(q[0], q[1]); });
                }));
    // Controls: the sign of the momentum in theta-, the slots exchanged.
    claim.differs("theta+ minus theta-", model, Vector<S>(plus - minus), dL);
    claim.differs("slots exchanged", model,
                  on_each(w,
                          [&](auto const& u) {
                            return S(pair(D1(L, g[0], g[1]), u.second) + pair(D2(L, g[0], g[1]), u.first));
                          }),
                  dL);
  });
}

STATEMENT(claim_3_1_exterior_derivative_sum, "the exterior derivatives of the two one-forms cancel") {
  claim.holds();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_pair_polynomial<S>(draw, group);
    auto const g = draw_points<S>(draw, group, 2);
    auto const w = draw_changes<S>(draw, group);
    auto const d_minus = on_pairs(w, [&](auto const& a, auto const& b) {
      return exterior_derivative(minus_form(L), g[0], g[1], a, b);
    });
    auto const d_plus = on_pairs(
        w, [&](auto const& a, auto const& b) { return exterior_derivative(plus_form(L), g[0], g[1], a, b); });
    claim.zero("d theta- plus d theta+", model, Vector<S>(d_minus + d_plus), size_of(d_minus));
    // Controls: with equal signs they do not cancel, and the one-forms themselves are no negatives of each
    // other.
    claim.refutes("d theta- minus d theta+", model, Vector<S>(d_minus - d_plus), size_of(d_minus));
    claim.differs("theta- against minus theta+", model,
                  on_each(w, [&](auto const& u) { return discrete_one_form_minus(L, g[0], g[1], u); }),
                  on_each(w, [&](auto const& u) { return S(-discrete_one_form_plus(L, g[0], g[1], u)); }));
  });
}

STATEMENT(eq_3_5, "the discrete Lagrange two-form in coordinates") {
  claim.corrected(
      R"(d\theta^-_{\mathbb L}=\frac{\partial^2\mathbb L}{\partial g_k^i\,\partial g_{k+1}^j})"
      R"(\,dg_k^i\wedge dg_{k+1}^j)",
      R"(d\theta^-_{\mathbb L}=\frac{\partial^2\mathbb L}{\partial g_k^i\,\partial g_{k+1}^j})"
      R"(\,dg_{k+1}^j\wedge dg_k^i)",
      "The printed right side is $-d\\theta^- = d\\theta^+$ everywhere: the slip is in the definition, for "
      "with $\\omega = d\\theta^+$ the coordinates, the chain for symplecticity, the pull-back of "
      "$-d\\theta_0$ and Theorem 4.3.2 all hold as printed. The library has $\\omega = d\\theta^-$, which "
      "is $dq\\wedge dp$, as is $\\omega_L = -d\\theta_L$ of chapter 2.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_pair_polynomial<S>(draw, group);
    auto const g = draw_points<S>(draw, group, 2);
    auto const w = draw_changes<S>(draw, group);
    // Coordinates x -> exp(x) g_k, y -> exp(y) g_{k+1}: the mixed second derivative of L along x and y, on
    // dx^i ^ dy^j.
    auto const mixed = [&](auto const& x, auto const& y) {
      return L(nudged(over<Dual<S>>(g[0]), over<Dual<S>>(x)), over<Dual<Dual<S>>>(nudged(g[1], y)))
          .part[0]
          .part[0];
    };
    auto const printed = on_pairs(w, [&](auto const& a, auto const& b) {
      return S(mixed(a.first, b.second) - mixed(b.first, a.second));
    });

    auto const d_minus = on_pairs(w, [&](auto const& a, auto const& b) {
      return exterior_derivative(minus_form(L), g[0], g[1], a, b);
    });
    auto const d_plus = on_pairs(
        w, [&](auto const& a, auto const& b) { return exterior_derivative(plus_form(L), g[0], g[1], a, b); });
    auto const omega =
        on_pairs(w, [&](auto const& a, auto const& b) { return discrete_two_form(L, g[0], g[1], a, b); });
    claim.equal("d theta- with the later configuration first in the wedge", model, d_minus,
                Vector<S>(-printed));
    claim.equal("the library's two-form is d theta-", model, omega, d_minus);
    claim.equal("the library's two-form is -d theta+", model, omega, Vector<S>(-d_plus));
    claim.equal("the printed coordinates are those of d theta+", model, printed, d_plus);
    claim.differs("d theta- with the wedge as printed", model, printed, d_minus);
  });
}

STATEMENT(claim_3_1_pullback_canonical,
          "the two-form is the pull-back of the canonical one by the discrete Legendre transformation") {
  claim.convention(
      "With (3.5) put right: for $\\omega = d\\theta^+$, its printed coordinates, it is the pull-back of "
      "chapter 2's $-d\\theta_0$ by the printed $(g_k, D_1\\mathbb L)$. For the library's $\\omega = "
      "d\\theta^-$ it takes the physical momentum, $(g_k, -D_1\\mathbb L)$.");
  claim.same_slip_as("eq_3_5");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_pair_polynomial<S>(draw, group);
    auto const g = draw_points<S>(draw, group, 2);
    auto const w = draw_changes<S>(draw, group);
    // The form -d theta_0 on T*G at (g, mu), momenta translated to the identity on the right, pulled back by
    // (g0, g1) -> (g0 or g1, momentum).
    using Covector = Momentum<SpannedGroup, S>;
    auto const pulled_back = [&](auto const& momentum, auto const& configuration) {
      auto const mu = momentum(g[0], g[1]);
      auto const change = [&](Change<S> const& u) {
        return Covector{group, rates(momentum(nudged(g[0], u.first), nudged(g[1], u.second)))};
      };
      return on_pairs(w, [&](auto const& a, auto const& b) {
        return S(pair(change(b), configuration(a)) - pair(change(a), configuration(b)) -
                 pair(mu, bracket(configuration(a), configuration(b))));
      });
    };
    auto const first = [](Change<S> const& u) { return u.first; };
    auto const second = [](Change<S> const& u) { return u.second; };
    auto const omega =
        on_pairs(w, [&](auto const& a, auto const& b) { return discrete_two_form(L, g[0], g[1], a, b); });
    auto const printed = pulled_back([&](auto const& g0, auto const& g1) { return D1(L, g0, g1); }, first);
    claim.equal("d theta_0 by (g_k, D_1 L)", model, Vector<S>(-printed), omega);
    claim.equal(
        "-d theta_0 by (g_k, -D_1 L)", model,
        pulled_back([&](auto const& g0, auto const& g1) { return legendre_source(L, g0, g1); }, first),
        omega);
    claim.equal(
        "-d theta_0 by (g_{k+1}, D_2 L)", model,
        pulled_back([&](auto const& g0, auto const& g1) { return legendre_target(L, g0, g1); }, second),
        omega);
    // The one-form comes back as well: theta_0 by (g_k, D_1 L) is theta-.
    claim.equal("theta_0 by (g_k, D_1 L) is theta-", model,
                on_each(w, [&](auto const& u) { return pair(-legendre_source(L, g[0], g[1]), u.first); }),
                on_each(w, [&](auto const& u) { return discrete_one_form_minus(L, g[0], g[1], u); }));
    claim.differs("-d theta_0 by (g_k, D_1 L)", model, printed, omega);
  });
}

// ----
// Section 3.1: symplecticity of the discrete flow.

STATEMENT(eq_3_6, "differential of the action along motions: one one-form at either end") {
  claim.corrected(R"(d\mathbb S=\theta^-_{\mathbb L}+F^*\theta^+_{\mathbb L})",
                  R"(d\mathbb S=\theta^-_{)"
                  R"(\mathbb L}+(\mathbb F^{N-1})^*\theta^+_{\mathbb L})",
                  "The last of $N$ pairs is $N-1$ steps of the flow from the first; the printed single "
                  "step is right for $N = 2$ only. $F$ is the flow, not the Legendre transformation.");
  claim.maybe_scan();
  over_groups(groups_for_motions<S>(3), claim, [&](auto const& group, auto const& model) {
    // A motion of three pairs, and changes of its first pair mapped by the tangent of the flow.
    auto const g = draw_points<S>(draw, group, 4);
    auto const L = draw_with_motion<S>(draw, g);
    auto const w01 = draw_changes<S>(draw, group);
    std::vector<Change<S>> w12, w23;
    for (auto const& w : w01) w12.push_back(discrete_flow_tangent(L, g[0], g[1], g[2], w));
    for (auto const& w : w12) w23.push_back(discrete_flow_tangent(L, g[1], g[2], g[3], w));
    auto const along = [&](auto const& lagrangian) {
      return [&](auto const& q) { return discrete_action(lagrangian, q); };
    };
    Vector<S> two(3), three(3), no_motion(3);
    auto const M = draw_pair_polynomial<S>(draw, group);
    for (int i = 0; i < 3; ++i) {
      two[i] =
          rate(GroupElements<S>{g[0], g[1], g[2]}, {w01[i].first, w01[i].second, w12[i].second}, along(L));
      three[i] = rate(g, {w01[i].first, w01[i].second, w12[i].second, w23[i].second}, along(L));
      no_motion[i] = rate(g, {w01[i].first, w01[i].second, w12[i].second, w23[i].second}, along(M));
    }

    auto const minus = [&](auto const& lagrangian) {
      return on_each(w01, [&](auto const& w) { return discrete_one_form_minus(lagrangian, g[0], g[1], w); });
    };
    auto const after_one =
        on_each(w12, [&](auto const& w) { return discrete_one_form_plus(L, g[1], g[2], w); });
    auto const after_two = [&](auto const& lagrangian) {
      return on_each(w23, [&](auto const& w) { return discrete_one_form_plus(lagrangian, g[2], g[3], w); });
    };
    claim.equal("N = 2: one step, as printed", model, two, Vector<S>(minus(L) + after_one),
                flow_condition<S>(L, g[1], g[2]));
    claim.equal("N = 3: two steps", model, three, Vector<S>(minus(L) + after_two(L)),
                flow_condition<S>(L, g[1], g[2]) * flow_condition<S>(L, g[2], g[3]));
    claim.differs("N = 3 with one step, as printed", model, three, Vector<S>(minus(L) + after_one));
    claim.differs("along configurations that are no motion", model, no_motion,
                  Vector<S>(minus(M) + after_two(M)));
  });
}

STATEMENT(claim_3_1_flow_symplectic, "the discrete flow preserves the discrete two-form") {
  claim.holds("Where the Lagrangian is regular, at every length of the step.");
  over_groups(groups_for_motions<S>(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw_points<S>(draw, group, 3);
    auto const before = draw_changes<S>(draw, group);
    auto const carried = [&](auto const& lagrangian) {
      std::vector<Change<S>> after;
      for (auto const& w : before) after.push_back(discrete_flow_tangent(lagrangian, g[0], g[1], g[2], w));
      return after;
    };
    auto const form = [&](auto const& lagrangian, int k, auto const& w) {
      return on_pairs(w, [&](auto const& a, auto const& b) {
        return discrete_two_form(lagrangian, g[k], g[k + 1], a, b);
      });
    };

    // The tangent of the flow is on trial too: along it the equation stays true, and the old second
    // configuration is the new first.
    auto const L = draw_with_motion<S>(draw, g);
    auto const after = carried(L);
    double const condition = flow_condition<S>(L, g[1], g[2]);
    auto const end_momentum = rates(D2(L, nudged(g[0], before[0].first), nudged(g[1], before[0].second)));
    auto const equation = rates(discrete_euler_lagrange(
        L, nudged(g[0], before[0].first), nudged(g[1], before[0].second), nudged(g[2], after[0].second)));
    claim.zero("the tangent of the flow satisfies the linearized (3.2)", model, equation,
               size_of(end_momentum), condition);
    claim.equal("the new first configuration moves as the old second did", model, after[0].first,
                before[0].second);

    claim.equal("the two-form after a step is that before", model, form(L, 1, after), form(L, 0, before),
                condition);
    claim.differs("with the opposite sign", model, form(L, 1, after), Vector<S>(-form(L, 0, before)));

    // Control: a constant spatial force f on the right side of (3.2) feeds the form with <f, [theta, theta']>
    // at the middle configuration.
    auto const M = draw_pair_polynomial<S>(draw, group);
    auto const forced = form(M, 1, carried(M)), gain = Vector<S>(forced - form(M, 0, before));
    auto const force = discrete_euler_lagrange(M, g[0], g[1], g[2]);
    auto const fed = on_pairs(
        before, [&](auto const& a, auto const& b) { return pair(force, bracket(a.second, b.second)); });
    claim.zero("what a constant spatial force feeds into it", model, Vector<S>(gain - fed), size_of(forced),
               flow_condition<S>(M, g[1], g[2]));
    claim.refutes("with a constant spatial force", model, gain, size_of(force));
  });
}

STATEMENT(claim_3_1_symplecticity_chain,
          "symplecticity from the vanishing second differential of the action") {
  claim.convention(
      "With (3.5) put right, as $\\omega = d\\theta^+$. For the $\\omega = d\\theta^-$ of "
      "the definition the first and the last sign are wrong and cancel; the middle equality, "
      "from $ddS = 0$, has no $\\omega$.");
  claim.same_slip_as("eq_3_5");
  over_groups(groups_for_motions<S>(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw_points<S>(draw, group, 3);
    auto const L = draw_with_motion<S>(draw, g);
    auto const before = draw_changes<S>(draw, group);
    std::vector<Change<S>> after;
    for (auto const& w : before) after.push_back(discrete_flow_tangent(L, g[0], g[1], g[2], w));
    auto const minus = [&](auto const& g0, auto const& g1, auto const& w) {
      return discrete_one_form_minus(L, g0, g1, w);
    };
    auto const plus = [&](auto const& g0, auto const& g1, auto const& w) {
      return discrete_one_form_plus(L, g0, g1, w);
    };

    // d commutes with the pull-back: the exterior derivative at the new pair, on the carried vectors.
    auto const pulled_d_plus = on_pairs(
        after, [&](auto const& a, auto const& b) { return exterior_derivative(plus, g[1], g[2], a, b); });
    auto const d_minus = on_pairs(
        before, [&](auto const& a, auto const& b) { return exterior_derivative(minus, g[0], g[1], a, b); });
    auto const omega = on_pairs(
        before, [&](auto const& a, auto const& b) { return discrete_two_form(L, g[0], g[1], a, b); });
    auto const pulled_omega =
        on_pairs(after, [&](auto const& a, auto const& b) { return discrete_two_form(L, g[1], g[2], a, b); });
    double const condition = flow_condition<S>(L, g[1], g[2]);
    claim.equal("ddS = 0: F^*(d theta+) = -d theta-", model, pulled_d_plus, Vector<S>(-d_minus), condition);
    claim.equal("F^* omega = -F^*(d theta+)", model, pulled_omega, Vector<S>(-pulled_d_plus), condition);
    claim.equal("d theta- = omega", model, d_minus, omega);
    claim.equal("the two ends of the chain", model, pulled_omega, omega, condition);
    // The chain as printed, for minus the library's form.
    auto const other = Vector<S>(-omega), pulled_other = Vector<S>(-pulled_omega);
    claim.equal("omega = d theta+: F^* omega = F^*(d theta+)", model, pulled_other, pulled_d_plus, condition);
    claim.equal("omega = d theta+: -d theta- = omega", model, Vector<S>(-d_minus), other);
    claim.differs("F^* omega = F^*(d theta+) for omega = d theta-", model, pulled_omega, pulled_d_plus);
    claim.differs("-d theta- = omega, as printed", model, Vector<S>(-d_minus), omega);
  });
}
