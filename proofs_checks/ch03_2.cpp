// Section 3.2, first part: quotient of pairs, discrete Euler-Poincare reduction, reconstruction.

#include "actio/reduction/discrete_euler_lagrange.hpp"
#include "actio/reduction/relative_motion.hpp"

#include "models/sequences.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// A sequence with one variation for each configuration.
template <class S>
struct VariedSequence {
  GroupElements<S> g;
  std::vector<Velocity<SpannedGroup, S>> theta;

  /// The configurations, varied: delta g = theta g, or g theta for `left`.
  GroupElements<Dual<S>> right() const {
    GroupElements<Dual<S>> out;
    for (std::size_t k = 0; k < g.size(); ++k) out.push_back(varied(g[k], from_left(theta[k], g[k])));
    return out;
  }
  GroupElements<Dual<S>> left() const {
    GroupElements<Dual<S>> out;
    for (std::size_t k = 0; k < g.size(); ++k) out.push_back(varied(g[k], from_right(g[k], theta[k])));
    return out;
  }
};

}  // namespace

STATEMENT(eq_3_9, "the quotient of pairs by right multiplication") {
  claim.holds();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw_configurations<S>(draw, group, 6);
    auto const f = relative_motion_right(g[0], g[1]);
    claim.equal("f g1 = g0, as matrices", model, Matrix<S>(f.value * g[1].value), g[0].value);
    claim.equal("invariant under right multiplication of both configurations", model,
                relative_motion_right(g[0] * g[2], g[1] * g[2]), f);
    // Onto: (f, 1) lies over f. One orbit over each f: whatever pair lies over it, g1^-1 p1 carries (g0, g1)
    // to it.
    claim.equal("(f, 1) lies over f", model, relative_motion_right(f, identity<S>(group)), f);
    auto const p1 = g[3], p0 = f * p1, carry = inverse(g[1]) * p1;
    claim.equal("two pairs with the same f differ by right multiplication", model, g[0] * carry, p0);
    // Controls: the other side of the action, the other order of the factors.
    auto const by_left = [&](int k) { return relative_motion_right(g[k] * g[0], g[k] * g[1]); };
    auto const other = [&](int k) { return relative_motion_left(g[0] * g[k], g[1] * g[k]); };
    auto const h = relative_motion_left(g[0], g[1]);
    claim.differs("left multiplication of both configurations", model,
                  stacked<S>({by_left(2), by_left(4), by_left(5)}), stacked<S>({f, f, f}));
    claim.differs("g1^-1 g0 under right multiplication", model, stacked<S>({other(2), other(4), other(5)}),
                  stacked<S>({h, h, h}));
  });
}

STATEMENT(claim_3_2_alternative_quotient, "g1 g0^-1 as the representative instead") {
  claim.holds(
      "It serves as well, but the equations that follow exchange their sides: $L^*\\tilde\\ell'$ at the "
      "new relative motion equals $R^*\\tilde\\ell'$ at the one before.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw_configurations<S>(draw, group, 4);
    auto const f01 = g[1] * inverse(g[0]), f12 = g[2] * inverse(g[1]);
    claim.equal("invariant under right multiplication of both configurations", model,
                (g[1] * g[3]) * inverse(g[0] * g[3]), f01);
    claim.equal("it is the inverse of the other representative", model,
                f01 * relative_motion_right(g[0], g[1]), identity<S>(group));

    // The Lagrangian that l~(g1 g0^-1) stands for, and its equations.
    auto const full = discrete_euler_lagrange([&](auto const& x, auto const& y) { return l(y * inverse(x)); },
                                              g[0], g[1], g[2]);
    claim.equal("the equations, sides exchanged", model,
                right_differential(l, f01) - left_differential(l, f12), full);
    // Control: (3.10) taken over verbatim.
    claim.differs("(3.10) verbatim", model, euler_poincare_right(l, f01, f12), full);
    claim.differs("(3.10) verbatim, sign changed", model, -euler_poincare_right(l, f01, f12), full);
  });
}

STATEMENT(claim_3_2_reduced_lagrangian,
          "an invariant discrete Lagrangian is a function of $f$, its action a sum over $f$") {
  claim.holds(
      "The sum over $k = 0,\\dots,N-1$ that is printed here belongs to the configurations "
      "$g_0,\\dots,g_N$; (3.1) prints $k = 1,\\dots,N$.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const invariant = lifted(l);
    auto const g = draw_configurations<S>(draw, group, 6);
    auto const one = identity<S>(group);
    // Restrict to pairs (f, 1), and lift again.
    auto const reduced = [&](auto const& f) { return invariant(f, like(f, one)); };
    auto const on_pairs = [&](auto const& lagrangian) {
      Vector<S> values(3);
      for (int k = 0; k < 3; ++k) values[k] = lagrangian(g[2 * k], g[2 * k + 1]);
      return values;
    };
    claim.equal("l(g0 g1^-1) = L(g0, g1)", model, on_pairs(lift_right(reduced)), on_pairs(invariant));
    GroupElements<S> const configurations(g.begin(), g.end() - 1);
    S const action = discrete_action(invariant, configurations);
    claim.equal("reduced action sum, k = 0, ..., N-1", model,
                reduced_sum(reduced, relative_motions_right(configurations)), action);

    // Controls: a Lagrangian that is not invariant is no function of f; the range of (3.1).
    auto const other = draw_pair_polynomial<S>(draw, group);
    claim.differs("no invariance", model,
                  on_pairs(lift_right([&](auto const& f) { return other(f, like(f, one)); })),
                  on_pairs(other));
    auto const from_one = several([&] {
      GroupElements<S> shifted(g.begin() + 1, g.end() - 1);
      shifted.push_back(draw.template element<S>(group));
      return S(reduced_sum(reduced, relative_motions_right(shifted)) - action);
    });
    claim.refutes("k = 1, ..., N", model, from_one, momenta_of(l, relative_motions_right(g)));
  });
}

STATEMENT(thm_3_2_1, "four ways to say that a sequence is a discrete motion") {
  claim.corrected(R"(s : G^{N+1}\to\mathbb R \text{ in condition (3), } N\ge3)",
                  R"(s : G^{N}\to\mathbb R,)"
                  R"(\quad N\ge2)",
                  "$N$ pairs have $N$ relative motions, so $s$ is a function on $G^N$; an extremum is a "
                  "stationary point; the equivalence holds from $N = 2$ on.");
  over_groups(groups_for_sequences<S>(), claim, [&](auto const& group, auto const& model) {
    for (int steps : {2, 3}) {
      std::string const of = " (N = " + std::to_string(steps) + ")";
      auto const f = draw_configurations<S>(draw, group, steps);
      auto const any = draw_reduced_lagrangian<S>(draw, group);
      auto const l = with_motions_right(any, f);
      auto const scale = momenta_of(l, f);
      auto const g = configurations_right(draw.template element<S>(group), f);
      std::vector<std::vector<Velocity<SpannedGroup, S>>> variations;
      for (int i = 0; i < 3; ++i) variations.push_back(draw_variations<S>(draw, group, steps + 1));

      // (1) The action, (2) its equations, (3) the reduced sum along induced variations, (4) its equations.
      auto const along_each = [&](auto const& derivative) {
        Vector<S> values(3);
        for (int i = 0; i < 3; ++i) values[i] = derivative(variations[i]);
        return values;
      };
      auto const first = [&](auto const& k) {
        return along_each([&](auto const& theta) {
          return discrete_action(lifted(k), VariedSequence<S>{g, theta}.right()).part[0];
        });
      };
      auto const second = [&](auto const& k, int i) {
        return discrete_euler_lagrange(lifted(k), g[i - 1], g[i], g[i + 1]);
      };
      auto const third = [&](auto const& k) {
        return along_each([&](auto const& theta) {
          S sum(0);
          for (int i = 0; i < steps; ++i)
            sum += slope(k, f[i], from_left(relative_variation_right(f[i], theta[i], theta[i + 1]), f[i]));
          return sum;
        });
      };
      auto const fourth = [&](auto const& k, int i) { return euler_poincare_right(k, f[i - 1], f[i]); };
      claim.zero("(1) the action is stationary" + of, model, first(l), scale);
      claim.zero("(3) the reduced sum is stationary" + of, model, third(l), scale);
      for (int i = 1; i < steps; ++i) {
        claim.zero("(2) the discrete Euler-Lagrange equations" + of, model, second(l, i), scale);
        claim.zero("(4) the discrete Euler-Poincare equations" + of, model, fourth(l, i), scale);
      }
      // Control: another Lagrangian, whose motion this is not, fails all four.
      claim.refutes("(1) off a motion" + of, model, first(any), momenta_of(any, f));
      claim.refutes("(2) off a motion" + of, model, second(any, 1), momenta_of(any, f));
      claim.refutes("(3) off a motion" + of, model, third(any), momenta_of(any, f));
      claim.refutes("(4) off a motion" + of, model, fourth(any, 1), momenta_of(any, f));

      // Control, as printed: N + 1 relative motions leave g_N free, and the sum over them is not stationary
      // along the motion.
      auto const end = several(
          [&] { return column(euler_poincare_right(l, f[steps - 1], draw.template element<S>(group))); });
      claim.refutes("s on G^{N+1}, derivative along g_N" + of, model, end, momenta_of(l, f));
    }
  });
}

STATEMENT(claim_3_2_reduced_action_domain, "the reduced action sum is a function of $N$ relative motions") {
  claim.corrected(R"(s : G^{N+1}\to\mathbb R)", R"(s : G^{N}\to\mathbb R)",
                  "$N+1$ configurations make $N$ relative motions, and any $N$: the quotient "
                  "of $G^{N+1}$ is $G^N$, on which the action sum is a function. $N+1$ of "
                  "them would have to multiply to 1.");
  claim.same_slip_as("thm_3_2_1");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    for (int steps : {3, 4}) {
      std::string const of = " (N = " + std::to_string(steps) + ")";
      auto const f = draw_configurations<S>(draw, group, steps, ratio<S>(1, 2));
      auto const g = configurations_right(draw.template element<S>(group), f);
      // Onto: any N relative motions are those of configurations. One orbit over each: configurations with
      // the same relative motions differ by one translation, and the action is the same on all of the orbit.
      // Condition: each configuration carries the rounding of the products before it.
      auto const again = configurations_right(draw.template element<S>(group), f);
      auto const carry = inverse(g[0]) * again[0];
      GroupElements<S> carried;
      for (auto const& one : g) carried.push_back(one * carry);
      claim.equal("any N are those of N + 1 configurations" + of, model, stacked(relative_motions_right(g)),
                  stacked(f), 10);
      claim.equal("which are one orbit" + of, model, stacked(carried), stacked(again), 10);
      S const sum = reduced_sum(l, f);
      claim.zero(
          "on which the action is the reduced sum" + of, model,
          Vector<S>{{S(discrete_action(lifted(l), g) - sum), S(discrete_action(lifted(l), again) - sum)}},
          momenta_of(l, f), 10);

      // The N + 1 that N + 1 configurations have, the last one back to the first, multiply to 1; any N + 1 do
      // not, so that a function of N + 1 is more than the configurations determine.
      auto const product = [&](GroupElement<S> const& last) {
        auto whole = f[0];
        for (int k = 1; k < steps; ++k) whole = whole * f[k];
        return whole * last;
      };
      claim.equal("N + 1 of them around multiply to 1" + of, model,
                  product(relative_motion_right(g[steps], g[0])), identity<S>(group), 10);
      claim.refutes("any N + 1 of them" + of, model, several([&] {
                      auto const last = draw.template element<S>(group);
                      return Matrix<S>(product(last).value - identity<S>(group).value);
                    }),
                    S(1));
      claim.refutes("the sum over N + 1 of them" + of, model, several([&] {
                      auto one_more = f;
                      one_more.push_back(draw.template element<S>(group));
                      return S(reduced_sum(l, one_more) - sum);
                    }),
                    momenta_of(l, f));

      // Every variation of the N comes from variations of the configurations, g_0 held: the tangent of the
      // quotient is onto.
      std::vector<Velocity<SpannedGroup, S>> theta{
          velocity(group, Vector<S>(Vector<S>::Zero(group.dimension())))};
      for (int k = 0; k < steps; ++k) {
        auto const wanted = draw.template velocity<S>(group);
        theta.push_back(Ad(inverse(f[k]), theta[k] - wanted));
        auto const pair_of_places = relative_motions_right(GroupElements<Dual<S>>{
            varied(g[k], from_left(theta[k], g[k])), varied(g[k + 1], from_left(theta[k + 1], g[k + 1]))});
        claim.equal("any N variations are induced" + of, model, rate(pair_of_places[0]),
                    from_left(wanted, f[k]));
      }
    }
  });
}

STATEMENT(claim_3_2_variation_of_f, "how the relative motion varies with its configurations") {
  claim.holds();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw_configurations<S>(draw, group, 2);
    auto const theta0 = draw.template velocity<S>(group), theta1 = draw.template velocity<S>(group);
    auto const f = relative_motion_right(g[0], g[1]);
    // Vary both configurations, eliminate f, and read off what epsilon multiplies.
    auto const moved = relative_motions_right(GroupElements<Dual<S>>{
        varied(g[0], from_left(theta0, g[0])), varied(g[1], from_left(theta1, g[1]))})[0];
    claim.equal("delta f = TR_f (theta0 - Ad_f theta1)", model,
                from_left(relative_variation_right(f, theta0, theta1), f), rate(moved));
    // Controls: Ad of the inverse, the sign of the second term, translation on the other side.
    auto const inverted = several([&] {
      auto const theta = draw.template velocity<S>(group);
      return column(Ad(inverse(f), theta) - Ad(f, theta));
    });
    claim.refutes("Ad of the inverse", model, inverted, S(1));
    claim.differs("sign of the second term", model, from_left(theta0 + Ad(f, theta1), f), rate(moved));
    auto const other_side = several([&] {
      auto const theta = draw.template velocity<S>(group);
      return Matrix<S>(from_right(f, theta) - from_left(theta, f));
    });
    claim.refutes("TL instead of TR", model, other_side, size_of(f));

    // The left quotient has its own formula.
    auto const back = relative_motion_left(g[0], g[1]);
    auto const moved_back = relative_motions_left(GroupElements<Dual<S>>{
        varied(g[0], from_right(g[0], theta0)), varied(g[1], from_right(g[1], theta1))})[0];
    claim.equal("left quotient: TL_f (theta0 - Ad_{f^-1} theta1)", model,
                from_right(back, relative_variation_left(back, theta0, theta1)), rate(moved_back));
  });
}

STATEMENT(eq_3_10, "discrete Euler-Poincare equations, right-invariant case") {
  claim.holds();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw_configurations<S>(draw, group, 3);
    auto const f01 = relative_motion_right(g[0], g[1]), f12 = relative_motion_right(g[1], g[2]);

    // Off shell: whatever the configurations, (3.10) is (3.2) of the invariant Lagrangian.
    auto const full = discrete_euler_lagrange(lifted(l), g[0], g[1], g[2]);
    claim.equal("(3.10) equals (3.2) of the invariant Lagrangian", model, euler_poincare_right(l, f01, f12),
                full);
    claim.equal("(3.10) from the definition of l', entry by entry", model,
                reduced_residual_right(l, GroupElements<S>{f01, f12}), column(full));
    // Controls: the two translations exchanged, the two motions exchanged, the signs equal.
    claim.differs("left and right translation exchanged", model,
                  left_differential(l, f12) - right_differential(l, f01), full);
    claim.differs("the two motions exchanged", model, euler_poincare_right(l, f12, f01), full);
    claim.differs("sign of the second term", model, right_differential(l, f12) + left_differential(l, f01),
                  full);
  });
}

STATEMENT(claim_3_2_dep_equivalence,
          "the four conditions are one and the same linear form of the variations") {
  claim.holds(
      "Stationary among induced variations only: for free variations of $f$ it would take $\\ell' = 0$.");
  over_groups(groups_for_sequences<S>(), claim, [&](auto const& group, auto const& model) {
    int const steps = 4;
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    VariedSequence<S> const sequence{draw_configurations<S>(draw, group, steps + 1, ratio<S>(1, 2)),
                                     draw_variations<S>(draw, group, steps + 1)};
    auto const& [g, theta] = sequence;
    auto const f = relative_motions_right(g);

    // Off shell, for arbitrary variations that vanish at the ends.
    S const of_action = discrete_action(lifted(l), sequence.right()).part[0];
    S of_equations(0), of_sum(0), of_reduced(0);
    for (int k = 1; k < steps; ++k) {
      of_equations += pair(discrete_euler_lagrange(lifted(l), g[k - 1], g[k], g[k + 1]), theta[k]);
      of_reduced += pair(euler_poincare_right(l, f[k - 1], f[k]), theta[k]);
    }
    for (int k = 0; k < steps; ++k)
      of_sum += slope(l, f[k], from_left(relative_variation_right(f[k], theta[k], theta[k + 1]), f[k]));
    auto const scale = momenta_of(l, f);
    claim.zero("(1) and (2)", model, S(of_action - of_equations), scale);
    claim.zero("(1) and (3)", model, S(of_action - of_sum), scale);
    claim.zero("(3) and (4)", model, S(of_sum - of_reduced), scale);
    // Control: an end that moves.
    auto const end_moves = several([&] {
      auto ends = sequence;
      ends.theta[steps] = draw.template velocity<S>(group);
      return S(discrete_action(lifted(l), ends.right()).part[0] - of_equations);
    });
    claim.refutes("the last configuration varies too", model, end_moves, scale);

    // Control: along a motion, variations of f that no variation of configurations induces.
    GroupElements<S> const three(f.begin(), f.begin() + 3);
    auto const with_motion = with_motions_right(l, three);
    auto const free = several([&] {
      S sum(0);
      for (auto const& step : three)
        sum += pair(right_differential(with_motion, step), draw.template velocity<S>(group));
      return sum;
    });
    claim.refutes("free variations of f along a motion", model, free, momenta_of(with_motion, three));
  });
}

STATEMENT(claim_3_2_proof_computation, "the derivative of the reduced action sum, line by line") {
  claim.holds(
      "The terms $k = 0$ of the first sum and $r = N$ of the second are "
      "absent because the ends do not vary.");
  over_groups(groups_for_sequences<S>(), claim, [&](auto const& group, auto const& model) {
    int const n = 4;
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    VariedSequence<S> const sequence{draw_configurations<S>(draw, group, n + 1, ratio<S>(1, 2)),
                                     draw_variations<S>(draw, group, n + 1)};
    auto const& g = sequence.g;
    auto const f = relative_motions_right(g);
    auto const value = [&](int k) -> Matrix<S> const& { return g[k].value; };
    auto const back = [&](int k) { return inverse(g[k]).value; };
    auto const sum = [](int from, int to, auto const& term) {
      S total(0);
      for (int k = from; k <= to; ++k) total += term(k);
      return total;
    };
    // The five expressions, as a function of the variations.
    auto const lines = [&](std::vector<Velocity<SpannedGroup, S>> const& theta) {
      auto const delta = [&](int k) { return from_left(theta[k], g[k]); };
      S const start = reduced_sum(l, relative_motions_right(VariedSequence<S>{g, theta}.right())).part[0];
      S const one = sum(0, n - 1, [&](int k) {
        return slope(l, f[k],
                     Matrix<S>(delta(k) * back(k + 1) - value(k) * back(k + 1) * delta(k + 1) * back(k + 1)));
      });
      S const two =
          sum(1, n - 1,
              [&](int k) { return slope(l, f[k], Matrix<S>(delta(k) * back(k) * value(k) * back(k + 1))); }) -
          sum(1, n - 1, [&](int r) {
            return slope(l, f[r - 1], Matrix<S>(value(r - 1) * back(r) * delta(r) * back(r)));
          });
      S const three = sum(1, n - 1, [&](int k) {
        return slope(l, f[k], from_left(theta[k], f[k])) - slope(l, f[k - 1], from_right(f[k - 1], theta[k]));
      });
      S const four =
          sum(1, n - 1, [&](int k) { return pair(euler_poincare_right(l, f[k - 1], f[k]), theta[k]); });
      return std::array<S, 5>{start, one, two, three, four};
    };
    auto const scale = momenta_of(l, f);
    auto const line = lines(sequence.theta);
    claim.zero("d/d epsilon of the sum, and line 1", model, S(line[0] - line[1]), scale);
    claim.zero("lines 1 and 2", model, S(line[1] - line[2]), scale);
    claim.zero("lines 2 and 3", model, S(line[2] - line[3]), scale);
    claim.zero("lines 3 and 4", model, S(line[3] - line[4]), scale);

    // Controls: ends that vary, first one and then the other; the range of the second sum shifted.
    for (int end : {0, n}) {
      auto const gap = several([&] {
        auto theta = sequence.theta;
        theta[end] = draw.template velocity<S>(group);
        auto const moving = lines(theta);
        return S(moving[1] - moving[2]);
      });
      claim.refutes(
          end == 0 ? "lines 1 and 2, first configuration varies" : "lines 1 and 2, last configuration varies",
          model, gap, scale);
    }
    auto const shifted = several([&] {
      auto const theta = draw_variations<S>(draw, group, n + 1);
      S const from_two =
          sum(1, n - 1, [&](int k) { return slope(l, f[k], from_left(theta[k], f[k])); }) -
          sum(2, n - 1, [&](int r) { return slope(l, f[r - 1], from_right(f[r - 1], theta[r])); });
      return S(lines(theta)[1] - from_two);
    });
    claim.refutes("second sum from r = 2", model, shifted, scale);
  });
}

STATEMENT(rem_3_2_1, "discrete Euler-Poincare equations for left-invariant Lagrangians") {
  claim.holds();
  over_groups(groups_for_sequences<S>(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const invariant = lifted_left(l);
    VariedSequence<S> const sequence{draw_configurations<S>(draw, group, 5, ratio<S>(1, 2)),
                                     draw_variations<S>(draw, group, 5)};
    auto const& [g, theta] = sequence;
    auto const f = relative_motions_left(g);
    auto const scale = momenta_of(l, f);
    auto const on_pairs = [&](auto const& move) {
      Vector<S> values(3);
      for (int k = 0; k < 3; ++k) values[k] = invariant(move(g[k]), move(g[k + 1]));
      return values;
    };
    auto const as_they_are = on_pairs([](auto const& x) { return x; });
    claim.zero("invariant under left multiplication of both configurations", model,
               Vector<S>(on_pairs([&](auto const& x) { return g[4] * x; }) - as_they_are), scale);
    claim.equal("the library's relative motion", model, relative_motion_left(g[0], g[1]), f[0]);

    // Vary the configurations by g theta: what stands beside theta_k is (3.11).
    S const of_action = discrete_action(invariant, sequence.left()).part[0];
    S of_equations(0);
    for (int k = 1; k < 4; ++k) of_equations += pair(euler_poincare_left(l, f[k - 1], f[k]), theta[k]);
    claim.zero("derivative of the action along g theta", model, S(of_action - of_equations), scale);
    // Controls: variations of the other form; the quotient of the other side.
    auto const other_form = several([&] {
      VariedSequence<S> const other{g, draw_variations<S>(draw, group, 5)};
      return S(discrete_action(invariant, other.right()).part[0] -
               discrete_action(invariant, other.left()).part[0]);
    });
    claim.refutes("variations of the form theta g", model, other_form, scale);
    auto const other_side = several([&] {
      auto const h = draw.template element<S>(group, S(1));
      return Vector<S>(on_pairs([&](auto const& x) { return x * h; }) - as_they_are);
    });
    claim.refutes("right multiplication of both configurations", model, other_side, scale);

    // Along a motion by design of three steps all of it vanishes.
    GroupElements<S> const three(f.begin(), f.begin() + 3), four(g.begin(), g.begin() + 4);
    auto const k = with_motions_left(l, three);
    auto const terms = momenta_of(k, three);
    for (int i : {1, 2}) {
      claim.zero("(3.11) along a motion", model, euler_poincare_left(k, three[i - 1], three[i]), terms);
      claim.zero("(3.2) along the same motion", model,
                 discrete_euler_lagrange(lifted_left(k), four[i - 1], four[i], four[i + 1]), terms);
    }
  });
}

STATEMENT(eq_3_11, "discrete Euler-Poincare equations, left-invariant case") {
  claim.holds();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw_configurations<S>(draw, group, 3);
    auto const f10 = relative_motion_left(g[0], g[1]), f21 = relative_motion_left(g[1], g[2]);

    // Off shell: (3.2) of the invariant Lagrangian, read on variations g theta: Ad* of the configuration
    // carries one reading to the other.
    auto const full = Ad_star(g[1], discrete_euler_lagrange(lifted_left(l), g[0], g[1], g[2]));
    claim.equal("(3.11) equals (3.2) of the invariant Lagrangian", model, euler_poincare_left(l, f10, f21),
                full);
    claim.equal("(3.11) from the definition of l', entry by entry", model,
                reduced_residual_left(l, GroupElements<S>{f10, f21}), column(full));
    // Controls: the equation of the other side, the two motions exchanged, f_{k,k+1} = g_k^-1 g_{k+1}
    // instead.
    claim.differs("left and right translation exchanged", model, euler_poincare_right(l, f10, f21), full);
    claim.differs("the two motions exchanged", model, euler_poincare_left(l, f21, f10), full);
    claim.differs("f_{k,k+1} instead of f_{k+1,k}", model, euler_poincare_left(l, inverse(f10), inverse(f21)),
                  full);
  });
}

STATEMENT(thm_3_2_3, "projection and reconstruction carry motions to motions") {
  claim.holds();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f01 = draw.template element<S>(group), f12 = draw.template element<S>(group);
    auto const l = with_motions_right(draw_reduced_lagrangian<S>(draw, group), GroupElements<S>{f01, f12});
    auto const scale = momenta_of(l, GroupElements<S>{f01, f12});
    claim.zero("(3.10) along the reduced motion", model, euler_poincare_right(l, f01, f12), scale);

    // Lift: each configuration follows from the one before and the relative motion.
    auto const g0 = draw.template element<S>(group, S(1));
    auto const g1 = reconstruct_right(g0, f01), g2 = reconstruct_right(g1, f12);
    claim.zero("(3.2) along the lifted motion", model, discrete_euler_lagrange(lifted(l), g0, g1, g2), scale);
    // Project it again.
    claim.zero("(3.10) along its projection", model,
               euler_poincare_right(l, relative_motion_right(g0, g1), relative_motion_right(g1, g2)), scale);
    // Controls: the last configuration lifted by f instead of its inverse, or on the other side.
    auto const left_over = [&](auto const& third) {
      std::vector<Momentum<SpannedGroup, S>> parts;
      for (int i = 0; i < 3; ++i) {
        auto const start = draw.template element<S>(group), next = reconstruct_right(start, f01);
        parts.push_back(discrete_euler_lagrange(lifted(l), start, next, third(next)));
      }
      return stacked(parts);
    };
    auto const size = momenta_of(l, GroupElements<S>{f01, f12});
    claim.refutes("lift by f instead of its inverse", model,
                  left_over([&](auto const& g) { return f12 * g; }), size);
    claim.refutes("lift on the other side", model,
                  left_over([&](auto const& g) { return reconstruct_left(g, f12); }), size);

    // Left-invariant systems.
    auto const k = with_motions_left(draw_reduced_lagrangian<S>(draw, group), GroupElements<S>{f01, f12});
    auto const h1 = reconstruct_left(g0, f01), h2 = reconstruct_left(h1, f12);
    claim.zero("left-invariant: (3.2) along the lifted motion", model,
               discrete_euler_lagrange(lifted_left(k), g0, h1, h2),
               momenta_of(k, GroupElements<S>{f01, f12}));
  });
}

STATEMENT(claim_3_2_projection_of_del,
          "a motion of the full equations projects to one of the reduced equations") {
  claim.holds("For the invariant Lagrangians that the section is about.");
  over_groups(groups_for_sequences<S>(), claim, [&](auto const& group, auto const& model) {
    // Three steps of a motion of (3.2), by design: nothing reduced is used to make it.
    auto const g = draw_configurations<S>(draw, group, 4);
    auto const f = relative_motions_right(g);
    auto const l = solved_for(
        draw_reduced_lagrangian<S>(draw, group), f,
        [&](auto const& k, int i) {
          return column(discrete_euler_lagrange(lifted(k), g[i - 1], g[i], g[i + 1]));
        },
        [&](int i, int a) { return from_left(basis_velocity<S>(group, a), f[i]); });
    auto const scale = momenta_of(l, f);
    for (int k : {1, 2})
      claim.zero("(3.2) along the motion", model,
                 discrete_euler_lagrange(lifted(l), g[k - 1], g[k], g[k + 1]), scale);
    auto const projected = [&](int k) { return relative_motion_right(g[k], g[k + 1]); };
    for (int k : {1, 2})
      claim.zero("(3.10) along the projection", model,
                 euler_poincare_right(l, projected(k - 1), projected(k)), scale);
    // Control: the projection of the other side.
    auto const wrong = relative_motions_left(g);
    claim.refutes("projection by g1^-1 g0", model, reduced_residual_right(l, wrong), momenta_of(l, wrong));

    // Control: a motion of a Lagrangian that is not invariant, and the restriction of that Lagrangian.
    auto const other = with_motion(draw_pair_polynomial<S>(draw, group), g[0], g[1], g[2]);
    auto const restricted = [&](auto const& h) { return other(h, like(h, identity<S>(group))); };
    claim.refutes(
        "no invariance", model, euler_poincare_right(restricted, f[0], f[1]),
        size_of(right_differential(restricted, f[1])) + size_of(left_differential(restricted, f[0])));
  });
}

STATEMENT(
    claim_3_2_reconstruction_of_dep,
    "a motion of the reduced equations lifts to motions of the full ones, one for each first configuration") {
  claim.holds("The first configuration is free: one reduced motion has a lift through every $g_0$.");
  over_groups(groups_for_sequences<S>(), claim, [&](auto const& group, auto const& model) {
    auto const f = draw_configurations<S>(draw, group, 3);
    auto const l = with_motions_right(draw_reduced_lagrangian<S>(draw, group), f);
    auto const scale = momenta_of(l, f);
    for (int lift = 0; lift < 2; ++lift) {
      GroupElements<S> g{draw.template element<S>(group)};
      for (auto const& step : f) g.push_back(reconstruct_right(g.back(), step));
      // Condition: each configuration carries the rounding of the products before it, magnified by the second
      // derivatives of l.
      for (int k : {1, 2})
        claim.zero("(3.2) along each lift", model,
                   discrete_euler_lagrange(lifted(l), g[k - 1], g[k], g[k + 1]), scale, 10);
      // Controls: relative motions taken in the wrong order; a sequence that does not satisfy (3.10).
      // (On the Heisenberg group a motion with little momentum at the centre does not care for order.)
      auto const back = configurations_right(g[0], GroupElements<S>{f[2], f[1], f[0]});
      if (model != "Heisenberg")
        claim.refutes("relative motions in the wrong order", model,
                      reduced_residual_right(l, relative_motions_right(back)), momenta_of(l, f));
      auto const elsewhere = several([&] {
        return column(discrete_euler_lagrange(lifted(l), g[0], g[1],
                                              reconstruct_right(g[1], draw.template element<S>(group))));
      });
      claim.refutes("relative motions that (3.10) does not give", model, elsewhere, momenta_of(l, f));
    }
  });
}

STATEMENT(eq_3_14, "reconstruction map, right-invariant case") {
  claim.holds();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw_configurations<S>(draw, group, 5);
    auto const f = relative_motions_right(g);
    GroupElements<S> by_f, other_side, late, right;
    // Carry pairs along, four steps, from the first pair alone.
    auto g0 = g[0], g1 = reconstruct_right(g[0], f[0]);
    for (int k = 1; k < 4; ++k) {
      auto const next0 = reconstruct_right(g0, f[k - 1]), next1 = reconstruct_right(g1, f[k]);
      claim.equal("first of the pair", model, next0, g[k]);
      claim.equal("second of the pair", model, next1, g[k + 1]);
      by_f.push_back(f[k] * g1), other_side.push_back(g1 * inverse(f[k])),
          late.push_back(reconstruct_right(g1, f[k - 1])), right.push_back(g[k + 1]);
      g0 = next0, g1 = next1;
    }
    claim.differs("f instead of its inverse", model, stacked<S>(by_f), stacked<S>(right));
    claim.differs("f^-1 on the other side", model, stacked<S>(other_side), stacked<S>(right));
    claim.differs("the relative motion of the step before", model, stacked<S>(late), stacked<S>(right));
  });
}

STATEMENT(eq_3_15, "reconstruction map, left-invariant case") {
  claim.holds();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw_configurations<S>(draw, group, 5);
    auto const f = relative_motions_left(g);
    GroupElements<S> by_f, other_side, late, right;
    auto g0 = g[0], g1 = reconstruct_left(g[0], f[0]);
    for (int k = 1; k < 4; ++k) {
      auto const next0 = reconstruct_left(g0, f[k - 1]), next1 = reconstruct_left(g1, f[k]);
      claim.equal("first of the pair", model, next0, g[k]);
      claim.equal("second of the pair", model, next1, g[k + 1]);
      by_f.push_back(g1 * f[k]), other_side.push_back(inverse(f[k]) * g1),
          late.push_back(reconstruct_left(g1, f[k - 1])), right.push_back(g[k + 1]);
      g0 = next0, g1 = next1;
    }
    claim.differs("f instead of its inverse", model, stacked<S>(by_f), stacked<S>(right));
    claim.differs("f^-1 on the other side", model, stacked<S>(other_side), stacked<S>(right));
    claim.differs("the relative motion of the step before", model, stacked<S>(late), stacked<S>(right));
  });
}
