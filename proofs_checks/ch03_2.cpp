// Section 3.2, first half: quotient of pairs, discrete Euler-Poincare reduction, reconstruction.

#include "actio/reduction/discrete_euler_lagrange.hpp"
#include "actio/reduction/discrete_forms.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/reduction/discrete_poisson.hpp"
#include "actio/reduction/relative_motion.hpp"
#include "actio/variational/action.hpp"
#include "actio/variational/euler_lagrange.hpp"
#include "actio/variational/lie_poisson.hpp"

#include "chart_models.hpp"
#include "limits.hpp"
#include "sequences.hpp"
#include "statement.hpp"
#include "top_in_any_group.hpp"

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
                  "The action sum has $N+1$ configurations, the reduced sum $N$ relative motions.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    for (int steps : {3, 4}) {
      std::string const of = " (N = " + std::to_string(steps) + ")";
      auto const f = draw_configurations<S>(draw, group, steps + 1, ratio<S>(1, 2));
      GroupElements<S> const n_of_them(f.begin(), f.end() - 1);
      auto const g = configurations_right(draw.template element<S>(group), f);
      GroupElements<S> const configurations(g.begin(), g.end() - 1);
      // N relative motions and one configuration make N + 1 configurations with that action.
      S const action = discrete_action(lifted(l), configurations);
      claim.zero("N of them give the action of N + 1 configurations" + of, model,
                 S(reduced_sum(l, n_of_them) - action), momenta_of(l, f));
      auto const longer = several([&] {
        auto one_more = n_of_them;
        one_more.push_back(draw.template element<S>(group));
        return S(reduced_sum(l, one_more) - action);
      });
      claim.refutes("N + 1 of them" + of, model, longer, momenta_of(l, f));

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
      "The terms $k = 0$ of the first sum and $r = N$ of the second are absent because the ends do not "
      "vary.");
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

// ----
// Section 3.2, second part: Poisson structures on pairs and on the group.

namespace {

/// The differential of a function of pairs, (theta0, theta1).
template <class F, class S>
Vector<S> differential(F const& f, GroupElement<S> const& g0, GroupElement<S> const& g1) {
  return stacked<S>({D1(f, g0, g1), D2(f, g0, g1)});
}
/// {a, b} of two functions of pairs, as a function of pairs.
template <class L, class A, class B>
auto bracket_of_pairs(L const& lagrangian, A const& a, B const& b) {
  return [=](auto const& g0, auto const& g1) {
    return differential(a, g0, g1).dot(discrete_bivector(lagrangian, g0, g1) * differential(b, g0, g1));
  };
}
/// {a, b} of two functions on the group, as a function on the group.
template <class L, class A, class B>
auto reduced_bracket(L const& l, A const& a, B const& b) {
  return [=](auto const& f) {
    return right_differential(a, f).components.dot(reduced_bivector_right(l, f) *
                                                   right_differential(b, f).components);
  };
}
/// SO(3) and Aff(1): for third derivatives.
std::vector<SpannedGroup> const& small_groups() {
  static std::vector<SpannedGroup> const groups = {few_groups()[0], few_groups()[2]};
  return groups;
}

}  // namespace

STATEMENT(eq_3_12, "the bracket on pairs") {
  claim.holds("With the momentum $-D_1\\mathbb L$ it is the canonical bracket of $T^*G$, $\\{q, p\\} = +1$.");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    int const d = group.dimension();
    auto const lagrangian = draw_pair_polynomial<S>(draw, group);
    auto const a = draw_pair_polynomial<S>(draw, group), b = draw_pair_polynomial<S>(draw, group);
    auto const g0 = draw.template element<S>(group), g1 = draw.template element<S>(group);

    // d theta^- on right-invariant fields, X theta(Y) - Y theta(X) - theta[X, Y], whose commutator is minus
    // the one of the algebra.
    auto const theta = D1(lagrangian, g0, g1);
    Matrix<S> omega = Matrix<S>::Zero(2 * d, 2 * d), configuration(d, d);
    for (int i = 0; i < d; ++i) {
      auto const e = basis_velocity<S>(group, i);
      configuration.col(i) = rate(D1(lagrangian, varied(g0, from_left(e, g0)), over<Dual<S>>(g1)));
      omega.col(d + i).head(d) = -rate(D1(lagrangian, over<Dual<S>>(g0), varied(g1, from_left(e, g1))));
    }
    for (int i = 0; i < d; ++i)
      for (int j = 0; j < d; ++j) {
        omega(i, j) = configuration(j, i) - configuration(i, j) +
                      pair(theta, bracket(basis_velocity<S>(group, i), basis_velocity<S>(group, j)));
        omega(d + j, i) = -omega(i, d + j);
      }
    // Solve X_F from omega(X_F, .) = dF, and pair.
    auto const field = [&](auto const& f) {
      return Vector<S>(solve_linear(omega.transpose().eval(), differential(f, g0, g1)));
    };
    S const value = field(a).dot(omega * field(b));
    Matrix<S> const pi = discrete_bivector(lagrangian, g0, g1);
    auto const scale =
        magnitude(differential(a, g0, g1)) * magnitude(pi) * magnitude(differential(b, g0, g1));
    claim.zero("omega(X_F, X_H) by the definitions", model,
               S(bracket_of_pairs(lagrangian, a, b)(g0, g1) - value), scale);
    claim.zero("dF(X_H) is the same", model, S(differential(a, g0, g1).dot(field(b)) - value), scale);
    // Controls: the other order, the other sign of X_H on one side.
    Matrix<S> const explicit_pi = inverse_matrix(Matrix<S>(omega.transpose()));
    claim.differs("omega(X_H, X_F)", model, Matrix<S>(pi.transpose()), explicit_pi);

    // It is the canonical bracket: the momenta mu = -D1 L have the plus bracket, and {F(g0), mu_a} = dF e_a.
    Matrix<S> momenta(2 * d, d);
    momenta.topRows(d) = -configuration.transpose();
    for (int i = 0; i < d; ++i) momenta.row(d + i) = omega.col(d + i).head(d).transpose();
    auto const size = magnitude(momenta) * magnitude(pi) * magnitude(momenta);
    claim.zero("brackets of momenta", model,
               Matrix<S>(momenta.transpose() * pi * momenta - lie_poisson_tensor_plus(-theta)), size);
    Matrix<S> const positions = (pi * momenta).topRows(d);
    claim.zero("brackets of configurations and momenta", model,
               Matrix<S>(positions - Matrix<S>::Identity(d, d)), magnitude(pi) * magnitude(momenta));
  });
  over_groups(small_groups(), claim, [&](auto const& group, auto const& model) {
    // Jacobi's identity: three functions, third derivatives of L.
    auto const lagrangian = draw_pair_polynomial<S>(draw, group);
    auto const a = draw_pair_polynomial<S>(draw, group), b = draw_pair_polynomial<S>(draw, group),
               c = draw_pair_polynomial<S>(draw, group);
    auto const g0 = draw.template element<S>(group), g1 = draw.template element<S>(group);
    auto const form = [&](auto const& f, auto const& h) { return bracket_of_pairs(lagrangian, f, h); };
    S const first = form(a, form(b, c))(g0, g1), second = form(b, form(c, a))(g0, g1),
            third = form(c, form(a, b))(g0, g1);
    auto const sizes = magnitude(first) + magnitude(second) + magnitude(third);
    // Condition: omega is inverted twice, and differentiated.
    claim.zero("Jacobi's identity", model, S(first + second + third), sizes, 100);
    // Control: the bracket times a function phi, the inverse of a form that is not closed. By Leibniz' rule
    // the cyclic sum is phi ({a, phi}{b, c} + ...).
    auto const bent = several([&] {
      auto const phi = draw_pair_polynomial<S>(draw, group);
      auto const at = [&](auto const& f, auto const& h) { return form(f, h)(g0, g1); };
      return S((at(a, phi) * at(b, c) + at(b, phi) * at(c, a) + at(c, phi) * at(a, b)) * phi(g0, g1));
    });
    claim.refutes("a form that is not closed", model, bent, sizes, 1e-4);
    // Control: no bracket where L is not regular.
    claim.template refuses<Singular>("a Lagrangian that is not regular", model, [&] {
      discrete_bivector([&](auto const& x, auto const& y) { return a(x, x) + b(y, y); }, g0, g1);
    });
  });
}

STATEMENT(eq_3_13, "the bracket on the group") {
  claim.corrected(R"(\{f,h\}_G\circ\pi_d = \{f\circ\pi,\,h\circ\pi\}_{G\times G})",
                  R"(\{f,h\}_G\circ\pi_d = \{f\circ\pi_d,\,h\circ\pi_d\}_{G\times G})",
                  "The functions are lifted by the quotient map itself; lifted by the projection on a "
                  "configuration they would commute.");
  claim.maybe_scan();
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const a = draw_reduced_lagrangian<S>(draw, group), b = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw_configurations<S>(draw, group, 3);
    auto const f = relative_motion_right(g[0], g[1]);
    S const below = reduced_bracket(l, a, b)(f);
    Matrix<S> const tensor = reduced_bivector_right(l, f);
    auto const scale = magnitude(column(right_differential(a, f))) * magnitude(tensor) *
                       magnitude(column(right_differential(b, f)));
    // Well defined: the same at every pair over f. Condition: the configurations magnify, and a matrix is
    // inverted at each of them.
    for (auto const& carry : {g[2], inverse(g[2])})
      claim.zero("lifted by the quotient map", model,
                 S(bracket_of_pairs(lifted(l), lifted(a), lifted(b))(g[0] * carry, g[1] * carry) - below),
                 scale, 10);
    // What it is: the momentum mu = -R* l' carries it to the plus Lie-Poisson bracket.
    Matrix<S> const second = right_second_differential(l, f);
    claim.zero("the momentum is a Poisson map to the plus bracket", model,
               Matrix<S>(second * tensor * second.transpose() -
                         lie_poisson_tensor_plus(momentum_before_right(l, f))),
               magnitude(second) * magnitude(tensor) * magnitude(second));
    claim.refutes("to the minus bracket", model,
                  Matrix<S>(second * tensor * second.transpose() +
                            lie_poisson_tensor_plus(momentum_before_right(l, f))),
                  magnitude(lie_poisson_tensor_plus(momentum_before_right(l, f))));
    // Left-invariant: the body momentum, the minus bracket.
    Matrix<S> const other = reduced_bivector_left(l, f), slope_of = left_second_differential(l, f);
    claim.zero("left-invariant: to the minus bracket", model,
               Matrix<S>(slope_of * other * slope_of.transpose() +
                         lie_poisson_tensor_plus(momentum_before_left(l, f))),
               magnitude(slope_of) * magnitude(other) * magnitude(slope_of));

    // Control, as printed with the projection on the first configuration: such functions commute.
    auto const on_first = [](auto const& h) { return [h](auto const& x, auto const&) { return h(x); }; };
    auto const gap = several([&] {
      auto const other_b = draw_reduced_lagrangian<S>(draw, group);
      return S(bracket_of_pairs(lifted(l), on_first(a), on_first(other_b))(g[0], g[1]) -
               reduced_bracket(l, a, other_b)(f));
    });
    claim.refutes("lifted by the projection on a configuration", model, gap, scale);
    // Control: no invariance, no bracket below.
    auto const any = draw_pair_polynomial<S>(draw, group);
    auto const two = [&](auto const& x, auto const& y) {
      return several([&] {
        return bracket_of_pairs(any, lifted(a), lifted(draw_reduced_lagrangian<S>(draw, group)))(x, y);
      });
    };
    Draw const again = draw;
    auto const here = two(g[0], g[1]);
    draw = again;
    claim.differs("no invariance", model, two(g[0] * g[2], g[1] * g[2]), here);
  });
}

STATEMENT(thm_3_2_2, "the discrete Euler-Poincare algorithm is a Poisson map") {
  claim.holds(
      "The hypothesis on the action is always true; regularity of $\\mathbb L$ is what the bracket needs.");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f = draw_configurations<S>(draw, group, 2);
    auto const any = draw_reduced_lagrangian<S>(draw, group);
    auto const l = with_motions_right(any, f);
    claim.zero("the motion", model, euler_poincare_right(l, f[0], f[1]), momenta_of(l, f));
    auto const defect = [&](auto const& k, auto const& form) {
      Matrix<S> const t = euler_poincare_tangent_right(k, f[0], f[1]);
      return Matrix<S>(t * reduced_bivector_right(form, f[0]) * t.transpose() -
                       reduced_bivector_right(form, f[1]));
    };
    auto const size = [&](auto const& k, auto const& form) {
      Matrix<S> const t = euler_poincare_tangent_right(k, f[0], f[1]);
      return magnitude(t) * magnitude(reduced_bivector_right(form, f[0])) * magnitude(t) +
             magnitude(reduced_bivector_right(form, f[1]));
    };
    // Condition: second derivatives are inverted on both sides.
    claim.zero("Poisson defect of one step", model, defect(l, l), size(l, l), 100);
    // Controls: two relative motions that (3.10) does not join; the bracket of another Lagrangian.
    claim.refutes("off a motion", model, defect(any, any), size(any, any));
    claim.refutes("the bracket of another Lagrangian", model, defect(l, any), size(l, any));
  });
}

STATEMENT(claim_3_2_dep_preserves_bracket, "brackets of functions before and after a step") {
  claim.holds("Jacobi's identity comes down from the bracket on pairs.");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    int const d = group.dimension();
    auto const f = draw_configurations<S>(draw, group, 2);
    auto const l = with_motions_right(draw_reduced_lagrangian<S>(draw, group), f);
    auto const a = draw_reduced_lagrangian<S>(draw, group), b = draw_reduced_lagrangian<S>(draw, group);

    // The tangent of a step, from the full algorithm: move g0 alone, and project what g2 does.
    auto const g = configurations_right(identity<S>(group), f);
    Matrix<S> tangent(d, d);
    for (int i = 0; i < d; ++i) {
      PairChange<SpannedGroup, S> const w{basis_velocity<S>(group, i),
                                          velocity(group, Vector<S>(Vector<S>::Zero(d)))};
      auto const moved = discrete_flow_tangent(lifted(l), g[0], g[1], g[2], w);
      tangent.col(i) = column(relative_variation_right(f[1], moved.first, moved.second));
    }
    Matrix<S> const reduced = euler_poincare_tangent_right(l, f[0], f[1]);
    // Condition: each tangent has inverted a matrix of second derivatives.
    claim.equal("tangent of the step, from (3.10) and from (3.2)", model, reduced, tangent, 100);

    // {a o Phi, b o Phi} before, {a, b} after.
    Matrix<S> const before = reduced_bivector_right(l, f[0]);
    auto const pulled = [&](auto const& h) {
      return Vector<S>(tangent.transpose() * column(right_differential(h, f[1])));
    };
    auto const scale = magnitude(pulled(a)) * magnitude(before) * magnitude(pulled(b)) * S(Base<S>(d * d));
    claim.zero("{a o Phi, b o Phi} = {a, b} o Phi", model,
               S(pulled(a).dot(before * pulled(b)) - reduced_bracket(l, a, b)(f[1])), scale, 100);
    // Control: brackets taken at the wrong end of the step.
    auto const wrong_end = several([&] {
      auto const c = draw_reduced_lagrangian<S>(draw, group), e = draw_reduced_lagrangian<S>(draw, group);
      return S(pulled(c).dot(before * pulled(e)) - reduced_bracket(l, c, e)(f[0]));
    });
    claim.refutes("{a, b} without the step", model, wrong_end, scale, 1e-4);

    // Left-invariant systems.
    auto const k = with_motions_left(draw_reduced_lagrangian<S>(draw, group), f);
    Matrix<S> const t = euler_poincare_tangent_left(k, f[0], f[1]), p0 = reduced_bivector_left(k, f[0]),
                    p1 = reduced_bivector_left(k, f[1]);
    claim.zero("left-invariant: Poisson defect of one step", model, Matrix<S>(t * p0 * t.transpose() - p1),
               magnitude(t) * magnitude(p0) * magnitude(t) + magnitude(p1), 100);
  });
}

STATEMENT(claim_3_2_proper_action, "the diagonal action is proper") {
  claim.holds(
      "Always true of right multiplication on pairs: the hypothesis asks for nothing. The action is free, "
      "too.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw_configurations<S>(draw, group, 2);
    auto const h = draw.template element<S>(group), axis = draw.template element<S>(group);
    // Proper and free: h is a continuous function of a pair and its image, so it stays bounded where these
    // do.
    auto const found = [&](auto const& before, auto const& after) { return inverse(before) * after; };
    claim.equal("h from one configuration and its image", model, found(g[0], g[0] * h), h);
    claim.equal("h from the other configuration and its image", model, found(g[1], g[1] * h), h);
    // Control: conjugation of both configurations. Elements that commute with them do nothing, so the pair
    // and its image do not tell h.
    auto const conjugated = [&](auto const& x, auto const& by) { return by * x * inverse(by); };
    auto const square = axis * axis;
    claim.equal("conjugation: an element fixes its powers", model, conjugated(square, axis), square);
    claim.differs("conjugation: h from a configuration and its image", model,
                  found(square, conjugated(square, axis)), axis);
  });
  // Control: a free action that is not proper, (x, y) -> (h x, y/h) off the origin. The pair (1, s) and its
  // image (s, 1) stay bounded, h = s leaves the group.
  for (long s : {16L, 256L, 4096L}) {
    S const small = ratio<S>(1, s), x(1), y = small, h = small;
    claim.zero("an action that is not proper: images of bounded points are bounded", "R^x on the plane",
               S(h * x - small) + S(y / h - S(1)), S(1));
    claim.refutes("h^-1 within 8 times the points", "R^x on the plane", S(S(1) / h - 8), S(1));
  }
}

// ----
// Section 3.2, third part: body and spatial momenta in time and in steps.

namespace {

/// A Lagrangian on TG with one of three symmetries, in one type: it is differentiated three times, and each
/// type would be compiled on its own.
template <class S>
struct SymmetricLagrangian {
  enum class Side { right, left, none };
  StatePolynomial<S> any;
  Side side;
  template <class T>
  T operator()(State<SpannedGroup, T> const& v) const {
    if (side == Side::none) return any(v);
    return any.kinetic(side == Side::right ? v.velocity : body_velocity(v));
  }
};

}  // namespace

STATEMENT(claim_3_2_body_spatial_momenta, "body and spatial momentum of a covector") {
  claim.holds();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    int const n = group.matrix_size();
    auto const g = draw.template element<S>(group, S(1));
    // A covector at g as a matrix: it takes v to <M, v>. Pull it back by v = g e_a and v = e_a g.
    auto const m = draw_matrix<S>(draw, n, n);
    Vector<S> body(group.dimension()), spatial(group.dimension());
    for (int a = 0; a < group.dimension(); ++a) {
      auto const e = basis_velocity<S>(group, a);
      body[a] = contract(m, from_right(g, e)), spatial[a] = contract(m, from_left(e, g));
    }
    auto const m_c = momentum(group, body), m_s = momentum(group, spatial);
    claim.equal("m_s = Ad*_{g^-1} m_c", model, Ad_star(inverse(g), m_c), m_s);
    claim.equal("the same with the coadjoint action written out", model, coadjoint(inverse(g), m_c), m_s);
    // The library's two translations of a differential.
    auto const linear = [&](auto const& x) { return contract(m, x.value); };
    claim.equal("L*_g m", model, left_differential(linear, g), m_c);
    claim.equal("R*_g m", model, right_differential(linear, g), m_s);
    // Controls: the inverse lost; the star lost.
    claim.refutes("Ad*_g m_c", model, several([&] {
                    auto const mu = draw.template momentum<S>(group);
                    return column(Ad_star(g, mu) - Ad_star(inverse(g), mu));
                  }),
                  S(1));
    if (!has_invariant_metric(model))
      claim.differs("Ad_g m_c", model, Vector<S>(Ad_matrix(g) * m_c.components), spatial);
  });
}

STATEMENT(claim_3_2_body_momentum_constant, "a right-invariant system conserves its body momentum") {
  claim.holds("First Euler theorem: right-invariant systems conserve $m_c$, left-invariant ones $m_s$.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    using Side = typename SymmetricLagrangian<S>::Side;
    // Rates of the two momenta along a motion of the Euler-Lagrange equations.
    auto const rates = [&](Side side) {
      SymmetricLagrangian<S> const lagrangian{draw_state_polynomial<S>(draw, group), side};
      State<SpannedGroup, S> const v{draw.template element<S>(group), draw.template velocity<S>(group)};
      auto const moving = moved(v, lagrange_vector_field(lagrangian, v));
      auto const spatial = legendre(lagrangian, moving);
      return std::pair(rate(Ad_star(moving.configuration, spatial)), rate(spatial));
    };
    auto const right = [&] { return rates(Side::right); };
    auto const left = [&] { return rates(Side::left); };
    // Size of the terms: a momentum times a velocity, each of order 1; the algebra of SO(4) or GL(2) sums a
    // few of them. Condition: the acceleration solves a system.
    claim.zero("right-invariant: d m_c/dt", model, right().first, S(1), 100);
    claim.zero("left-invariant: d m_s/dt", model, left().second, S(1), 100);
    claim.refutes("right-invariant: d m_s/dt", model, several([&] { return right().second; }), S(1));
    claim.refutes("left-invariant: d m_c/dt", model, several([&] { return left().first; }), S(1));
    claim.refutes("no invariance: d m_c/dt", model, several([&] { return rates(Side::none).first; }), S(1));
  });
}

STATEMENT(eq_3_16, "spatial momentum of a right-invariant system in time") {
  claim.holds("$\\mu_0$ is the constant body momentum, which is $\\mu(0)$ only where $g(0) = 1$.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    SymmetricLagrangian<S> const lagrangian{draw_state_polynomial<S>(draw, group),
                                            SymmetricLagrangian<S>::Side::right};
    State<SpannedGroup, S> const v{draw.template element<S>(group), draw.template velocity<S>(group)};
    auto const moving = moved(v, lagrange_vector_field(lagrangian, v));
    auto const mu = legendre(lagrangian, v);
    auto const mu0 = coadjoint(v.configuration, mu);
    auto const g = moving.configuration;
    // Both sides have the same value at this instant, by the relation of body and spatial momentum, and the
    // same rate: hence they agree at all times.
    claim.equal("value", model, Ad_star(inverse(v.configuration), mu0), mu);
    auto const actual = rate(legendre(lagrangian, moving));
    // Condition: the acceleration solves a system.
    claim.zero("rate", model, Vector<S>(rate(Ad_star(inverse(g), over<Dual<S>>(mu0))) - actual), S(1), 100);
    claim.zero("rate, by the Lie-Poisson equation", model,
               Vector<S>(actual + column(ad_star(v.velocity, mu))), S(1), 100);
    // Controls: the inverse lost; mu(0) for mu_0 although the motion does not begin at 1.
    claim.differs("Ad*_g instead of its inverse", model, rate(Ad_star(g, over<Dual<S>>(mu0))), actual);
    claim.differs("mu(0) for mu_0, g(0) not 1", model, Ad_star(inverse(v.configuration), mu), mu);
  });
}

STATEMENT(claim_3_2_dlp_chain, "the chain of equalities that leads to the update") {
  claim.corrected(
      R"(\mu_{k+1} = \mathrm{Ad}^*_{g_{k+1}}\mu_0 = \mathrm{Ad}^*_{(f_{kk+1}^{-1}g_k)^{-1}})"
      R"(\mu_0 = \mathrm{Ad}^*_{f_{kk+1}}\mathrm{Ad}^*_{g_k}\mu_0 = \mathrm{Ad}^*_{f_{kk+1}}\mu_k)",
      R"(\mu_{k+1} = \mathrm{Ad}^*_{g_{k+1}^{-1}}\mu_0 = )"
      R"(\mathrm{Ad}^*_{(f_{kk+1}^{-1}g_k)^{-1}}\mu_0 = \mathrm{Ad}^*_{f_{kk+1}})"
      R"(\mathrm{Ad}^*_{g_k^{-1}}\mu_0 = \mathrm{Ad}^*_{f_{kk+1}}\mu_k)",
      "Two inverses are missing, at $g_{k+1}$ and at $g_k$, where (3.16) is used; the second and the last "
      "expression are right.");
  claim.maybe_scan();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const g0 = draw.template element<S>(group), f = draw.template element<S>(group);
    auto const g1 = configurations_right(g0, GroupElements<S>{f})[1];
    auto const mu0 = draw.template momentum<S>(group);
    // (3.16) at both ends of the step, with the coadjoint action written out.
    auto const before = coadjoint(inverse(g0), mu0), after = coadjoint(inverse(g1), mu0);
    claim.equal("first, with its inverse", model, Ad_star(inverse(g1), mu0), after);
    claim.equal("second, as printed", model, Ad_star(inverse(inverse(f) * g0), mu0), after);
    claim.equal("third, with its inverse", model, Ad_star(f, Ad_star(inverse(g0), mu0)), after);
    claim.equal("last, as printed", model, lie_poisson_update_right(f, before), after);
    // Controls: the two as printed.
    auto const gaps = [&](auto const& printed) {
      return several([&] {
        auto const mu = draw.template momentum<S>(group);
        return column(printed(mu) - coadjoint(inverse(g1), mu));
      });
    };
    claim.refutes("first, as printed", model, gaps([&](auto const& mu) { return Ad_star(g1, mu); }), S(1));
    claim.refutes("third, as printed", model,
                  gaps([&](auto const& mu) { return Ad_star(f, Ad_star(g0, mu)); }), S(1));
  });
}

// ----
// Section 3.2, fourth part: the coadjoint action, the discrete Lie-Poisson algorithm.

namespace {

template <class S>
using Covector = Momentum<SpannedGroup, S>;
/// Functions that are constant on coadjoint orbits, for the groups that have some.
template <class S>
Vector<S> casimirs(Covector<S> const& mu) {
  auto const& m = mu.components;
  auto const values = [](std::initializer_list<S> list) {
    Vector<S> v(static_cast<int>(list.size()));
    std::copy(list.begin(), list.end(), v.data());
    return v;
  };
  std::string const name = mu.group.name();
  if (name == "SO(3)" || name == "SU(2)") return values({m[0] * m[0] + m[1] * m[1] + m[2] * m[2]});
  if (name == "SO(4)") return values({Vector<S>(m).squaredNorm(), m[0] * m[5] - m[1] * m[4] + m[2] * m[3]});
  if (name == "SE(2)") return values({m[1] * m[1] + m[2] * m[2]});
  if (name == "SE(3)")
    return values({m[3] * m[3] + m[4] * m[4] + m[5] * m[5], m[0] * m[3] + m[1] * m[4] + m[2] * m[5]});
  if (name == "SL(2)") return values({m[0] * m[0] + m[1] * m[2] * 4});
  if (name == "GL(2)") return values({m[0] + m[3], m[0] * m[3] - m[1] * m[2]});
  if (name == "Heisenberg") return values({m[2]});
  return Vector<S>(0);
}
/// A map of the dual algebra: where it takes mu, and its tangent there.
template <class S>
struct MapAt {
  Covector<S> image;
  Matrix<S> tangent;
};
/// The discrete Lie-Poisson map with f solved from mu: f is drawn, mu is the momentum it starts with, and the
/// tangent follows from the equation.
template <class L, class S>
MapAt<S> lie_poisson_map(L const& l, GroupElement<S> const& f) {
  // d mu0 = -A theta and d mu1 = -B theta.
  Matrix<S> const a = right_second_differential(l, f), b = left_second_differential(l, f);
  return {lie_poisson_update_right(f, momentum_before_right(l, f)), b * inverse_matrix(a)};
}
/// The coadjoint action on mu of an element that depends on it in any way: it preserves every orbit.
template <class S>
MapAt<S> orbit_keeping_map(Matrix<S> const& k, Covector<S> const& mu) {
  auto const map = [&](auto const& at) {
    using T = std::decay_t<decltype(at.components[0])>;
    return Ad_star(retract(velocity(mu.group, Vector<T>(k.template cast<T>() * at.components))), at);
  };
  int const d = mu.group.dimension();
  Matrix<S> tangent(d, d);
  over_batches(d, [&](int first) {
    auto moved = over<Moved<S>>(mu);
    for (int a = 0; a < batch && first + a < d; ++a) moved.components[first + a].part[a] = S(1);
    store_parts(tangent, map(moved).components, first);
  });
  return {map(mu), tangent};
}
/// How far a map is from keeping the plus bracket: T Lambda T^T - Lambda at the image. The minus bracket is
/// its negative.
template <class S>
Matrix<S> poisson_defect(MapAt<S> const& map, Covector<S> const& mu) {
  return map.tangent * lie_poisson_tensor_plus(mu) * map.tangent.transpose() -
         lie_poisson_tensor_plus(map.image);
}

}  // namespace

STATEMENT(claim_3_2_coadjoint_lie_poisson,
          "the coadjoint action preserves orbits, their symplectic forms, and the Lie-Poisson brackets") {
  claim.corrected(R"(\mathcal O\subset\mathfrak g)", R"(\mathcal O\subset\mathfrak g^*)",
                  "Coadjoint orbits lie in the dual; what is said of them holds, for both signs. $\\Ad_g$ "
                  "in the algebra does not preserve the brackets.");
  claim.maybe_scan();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw.template element<S>(group);
    auto const mu = draw.template momentum<S>(group);
    auto const xi = draw.template velocity<S>(group), eta = draw.template velocity<S>(group);
    auto const image = Ad_star(inverse(g), mu);
    // Tangent vectors of the orbit go to tangent vectors of it; the forms <mu, [xi, eta]>, up to sign, go
    // along.
    claim.equal("Ad* of a tangent vector", model, Ad_star(inverse(g), ad_star(xi, mu)),
                ad_star(Ad(g, xi), image));
    claim.zero("orbit symplectic forms", model,
               S(pair(image, bracket(Ad(g, xi), Ad(g, eta))) - pair(mu, bracket(xi, eta))),
               size_of(image) * size_of(Ad(g, xi)) * size_of(Ad(g, eta)) + S(1));

    // Brackets of functions on the dual, both signs.
    auto const a = draw_algebra_polynomial<S>(draw, group.dimension()),
               b = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const after = [&](auto const& f) {
      return [&f, &g](auto const& at) { return f(Ad_star(inverse(like(at, g)), at)); };
    };
    auto const scale = S(1) + size_of(image) * size_of(gradient(a, image)) * size_of(gradient(b, image));
    claim.zero("plus bracket", model,
               S(lie_poisson_bracket_plus(after(a), after(b), mu) - lie_poisson_bracket_plus(a, b, image)),
               scale);
    claim.zero("minus bracket", model,
               S(lie_poisson_bracket_minus(after(a), after(b), mu) - lie_poisson_bracket_minus(a, b, image)),
               scale);

    // Controls: Ad_g on the components, as if orbits lay in the algebra; twice the coadjoint action.
    auto const with = [&](Matrix<S> const& m) {
      return Matrix<S>(m * lie_poisson_tensor_plus(mu) * m.transpose() -
                       lie_poisson_tensor_plus(momentum(group, Vector<S>(m * mu.components))));
    };
    Matrix<S> const ad = Ad_matrix(g), coad = Ad_matrix(inverse(g)).transpose();
    claim.zero("tensor", model, with(coad), S(1) + magnitude(coad) * magnitude(coad));
    // (Where transposition preserves the group, or a metric, Ad_g is the coadjoint action of another
    // element.)
    if (!has_invariant_metric(model) && model != "GL(2)")
      claim.refutes("Ad_g, orbits in the algebra", model, with(ad), magnitude(lie_poisson_tensor_plus(mu)));
    claim.refutes("twice the coadjoint action", model, with(coad + coad),
                  magnitude(lie_poisson_tensor_plus(mu)));
  });
}

STATEMENT(prop_3_2_1, "the discrete Lie-Poisson algorithm is a Poisson map of the dual algebra") {
  claim.holds(
      "In both readings: along a fixed sequence of $f$, and with $f$ solved from $\\mu$, where the proof "
      "needs the discrete Euler-Poincaré equations and not the orbits alone. The minus bracket is "
      "preserved as well.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const f = draw.template element<S>(group);
    auto const mu = momentum_before_right(l, f);
    auto const size = [&](MapAt<S> const& map) {
      return magnitude(map.tangent) * size_of(mu) * magnitude(map.tangent) + size_of(map.image);
    };

    // f fixed: a linear map.
    MapAt<S> const fixed{lie_poisson_update_right(f, mu), Ad_matrix(f).transpose()};
    claim.zero("f fixed", model, poisson_defect(fixed, mu), size(fixed));
    // f solved from mu: differentiate the equation. Condition: a matrix of second derivatives is inverted.
    auto const solved = lie_poisson_map(l, f);
    claim.zero("f solved from mu", model, poisson_defect(solved, mu), size(solved), 100);
    // The same in functions.
    auto const a = draw_algebra_polynomial<S>(draw, group.dimension()),
               b = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const pulled = [&](auto const& h) {
      return velocity(group, Vector<S>(solved.tangent.transpose() * gradient(h, solved.image).coordinates));
    };
    auto const scale =
        size_of(mu) * size_of(pulled(a)) * size_of(pulled(b)) +
        size_of(solved.image) * size_of(gradient(a, solved.image)) * size_of(gradient(b, solved.image));
    claim.zero("{a o Phi, b o Phi}_+ = {a, b}_+ o Phi", model,
               S(pair(mu, bracket(pulled(a), pulled(b))) - lie_poisson_bracket_plus(a, b, solved.image)),
               scale, 100);

    // Controls: an element that depends on mu in another way; the same map read backwards in momentum,
    // mu -> -Ad* mu.
    auto const others = several([&] {
      return poisson_defect(orbit_keeping_map(draw_matrix<S>(draw, group.dimension(), group.dimension()), mu),
                            mu);
    });
    claim.refutes("f another function of mu", model, others, magnitude(lie_poisson_tensor_plus(mu)));
    claim.refutes("momentum with the other sign", model,
                  poisson_defect(MapAt<S>{-fixed.image, -fixed.tangent}, mu), size(fixed));
  });
}

STATEMENT(eq_3_17, "discrete Lie-Poisson update, right-invariant case") {
  claim.holds("$\\mu_k = -R^*\\ell'(f_{k,k+1})$ is the momentum at the start of the step from $g_k$.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f = draw_configurations<S>(draw, group, 3);
    auto const l = with_motions_right(draw_reduced_lagrangian<S>(draw, group), f);
    auto const g = configurations_right(draw.template element<S>(group), f);
    // Momenta of the full motion, and what the update makes of them. Condition: configurations after three
    // steps.
    std::vector<Covector<S>> mu;
    for (int k = 0; k < 3; ++k) mu.push_back(legendre_source(lifted(l), g[k], g[k + 1]));
    auto const scale = momenta_of(l, f);
    Matrix<S> inverted(group.dimension(), 2), star_lost(group.dimension(), 2), next(group.dimension(), 2);
    for (int k = 0; k < 2; ++k) {
      claim.zero("mu_{k+1} = Ad*_f mu_k along a motion", model,
                 lie_poisson_update_right(f[k], mu[k]) - mu[k + 1], scale, 10);
      claim.zero("the momentum at the end of the step", model,
                 legendre_target(lifted(l), g[k], g[k + 1]) - coadjoint(f[k], mu[k]), scale, 10);
      claim.zero("mu_k from f alone", model, momentum_before_right(l, f[k]) - mu[k], scale, 10);
      claim.zero("Ad*_{g_k} mu_k stays", model, coadjoint(g[k + 1], mu[k + 1]) - coadjoint(g[0], mu[0]),
                 scale, 10);
      inverted.col(k) = column(Ad_star(inverse(f[k]), mu[k])),
      star_lost.col(k) = Ad_matrix(f[k]) * mu[k].components, next.col(k) = column(mu[k + 1]);
    }
    // Controls: the inverse, as with g1 g0^-1; the star lost, where it shows as the inverse does; a step that
    // is none.
    if (model != "Heisenberg") claim.differs("Ad* of the inverse", model, inverted, next);
    if (model != "Heisenberg") claim.differs("Ad instead of Ad*", model, star_lost, next);
    auto const elsewhere = several([&] {
      return column(lie_poisson_update_right(f[0], mu[0]) -
                    momentum_before_right(l, draw.template element<S>(group)));
    });
    claim.refutes("f_{12} that (3.10) does not give", model, elsewhere, scale);
  });
}

STATEMENT(rem_3_2_2, "the left-invariant algorithm and the momentum it carries") {
  claim.corrected(R"(\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1k}}\cdot\Pi_k,\quad \Pi_k := \mathrm{Ad}^*_{g_k})"
                  R"(\pi_0)",
                  R"(\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1k}^{-1}}\cdot\Pi_k,\quad \Pi_k := \mathrm{Ad}^*_{g_k})"
                  R"(\pi_0)",
                  "The definition of $\\Pi_k$ is right and contradicts the update as printed, (3.18), "
                  "which lacks an inverse.");
  claim.maybe_scan();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f = draw_configurations<S>(draw, group, 3);
    auto const l = with_motions_left(draw_reduced_lagrangian<S>(draw, group), f);
    auto const g = configurations_left(draw.template element<S>(group), f);
    auto const scale = momenta_of(l, f);
    // The spatial momentum is the constant; Ad* of the configuration makes the body momentum of it.
    // Condition: configurations after three steps.
    auto const spatial = [&](int k) { return legendre_source(lifted_left(l), g[k], g[k + 1]); };
    for (int k : {1, 2}) {
      claim.zero("m_s is constant", model, spatial(k) - spatial(0), scale, 10);
      claim.zero("Pi_k = Ad*_{g_k} pi_0", model, coadjoint(g[k], spatial(0)) - momentum_before_left(l, f[k]),
                 scale, 10);
    }
    claim.zero("legendre_target agrees", model, legendre_target(lifted_left(l), g[0], g[1]) - spatial(0),
               scale, 10);
    // The definition alone gives the update, whatever pi_0.
    auto const update = [&](auto const& element) {
      return several([&] {
        auto const constant = draw.template momentum<S>(group);
        return column(Ad_star(element, Ad_star(g[0], constant)) - Ad_star(g[1], constant));
      });
    };
    claim.zero("Ad*_{f^-1} takes Ad*_{g_k} to Ad*_{g_{k+1}}", model, update(inverse(f[0])),
               magnitude(Ad_matrix(f[0])) * magnitude(Ad_matrix(g[0])) + S(1), 10);
    claim.refutes("as printed", model, update(f[0]), S(1));
  });
}

STATEMENT(eq_3_18, "discrete Lie-Poisson update, left-invariant case") {
  claim.corrected(
      R"(\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1k}}\cdot\Pi_k)",
      R"(\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1k}^{-1}}\cdot\Pi_k)",
      "The inverse is missing: $f_{k+1,k}$ is $g_{k+1}^{-1}g_k$, and $\\Pi_k$ is $\\Ad^*$ of $g_k$, not "
      "of its inverse.");
  claim.maybe_scan();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f = draw_configurations<S>(draw, group, 3);
    auto const l = with_motions_left(draw_reduced_lagrangian<S>(draw, group), f);
    auto const g = configurations_left(draw.template element<S>(group), f);
    // Body momenta of the full motion. Condition: configurations after three steps.
    std::vector<Covector<S>> body;
    for (int k = 0; k < 3; ++k)
      body.push_back(coadjoint(g[k], legendre_source(lifted_left(l), g[k], g[k + 1])));
    auto const scale = momenta_of(l, f);
    Matrix<S> printed(group.dimension(), 2), next(group.dimension(), 2);
    for (int k = 0; k < 2; ++k) {
      claim.zero("Pi_{k+1} = Ad*_{f^-1} Pi_k along a motion", model,
                 lie_poisson_update_left(f[k], body[k]) - body[k + 1], scale, 10);
      claim.zero("Pi_k from f alone", model, momentum_before_left(l, f[k]) - body[k], scale, 10);
      printed.col(k) = column(Ad_star(f[k], body[k])), next.col(k) = column(body[k + 1]);
    }
    if (model != "Heisenberg") claim.differs("as printed", model, printed, next);
  });
}

STATEMENT(claim_3_2_dlp_orbits, "the momentum stays on its coadjoint orbit") {
  claim.holds();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f = draw_configurations<S>(draw, group, 3);
    auto const l = with_motions_right(draw_reduced_lagrangian<S>(draw, group), f);
    auto const start = momentum_before_right(l, f[0]);
    auto const scale = momenta_of(l, f);
    // Three steps; the group element that joins the ends is the product of the relative motions, so the orbit
    // is the same by definition.
    auto mu = start;
    for (auto const& step : f) mu = lie_poisson_update_right(step, mu);
    claim.zero("one element of the group joins first and last", model,
               coadjoint(f[0] * f[1] * f[2], start) - mu, scale, 10);
    claim.zero("momenta along the motion are those of the algorithm", model,
               lie_poisson_update_right(f[1], lie_poisson_update_right(f[0], start)) -
                   momentum_before_right(l, f[2]),
               scale, 10);

    auto const invariants = casimirs(start);
    if (invariants.size() == 0) return;
    auto const size = S(scale * scale + scale);
    claim.zero("functions that are constant on orbits", model, Vector<S>(casimirs(mu) - invariants), size,
               10);
    // Controls: an explicit step of the Lie-Poisson equations leaves the orbit; so does the update without
    // its star.
    auto const drift = [&](auto const& step) {
      return several([&] {
        auto const at = draw.template momentum<S>(group);
        return Vector<S>(casimirs(step(at)) - casimirs(at));
      });
    };
    if (model != "Heisenberg")
      claim.refutes("mu - ad*_xi mu", model,
                    drift([&](auto const& at) { return at - ad_star(draw.template velocity<S>(group), at); }),
                    S(1));
    if (!has_invariant_metric(model) && model != "GL(2)")
      claim.refutes("Ad instead of Ad*", model, drift([&](auto const& at) {
                      return momentum(group, Vector<S>(Ad_matrix(f[0]) * at.components));
                    }),
                    S(1));
  });
}

STATEMENT(claim_3_2_orbits_and_bracket, "a map that preserves every orbit need not preserve the bracket") {
  claim.corrected(R"(\text{preserves the coadjoint orbits and hence the Poisson structure})",
                  R"(\text{preserves the coadjoint orbits, and, since } \mu_k=-R^*_{f_{kk+1}})"
                  R"(\ell'(f_{kk+1}), \text{ the Poisson structure})",
                  "The conclusion holds for this algorithm, the inference does not: "
                  "$\\mu\\mapsto\\Ad^*_{f(\\mu)}\\mu$ preserves every orbit for any $f(\\mu)$, and the "
                  "bracket only for special ones.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    int const d = group.dimension();
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const f = draw.template element<S>(group);
    auto const mu = momentum_before_right(l, f);
    auto const size = [&](MapAt<S> const& map) {
      return magnitude(map.tangent) * size_of(mu) * magnitude(map.tangent) + size_of(map.image);
    };
    // Two maps that preserve every orbit: the algorithm, and one whose element is any function of mu.
    auto const algorithm = lie_poisson_map(l, f);
    auto const any_map = [&] {
      return orbit_keeping_map(Matrix<S>(draw_matrix<S>(draw, d, d) / (S(2) * (S(1) + S(size_of(mu))))), mu);
    };
    auto const other = any_map();
    if (auto const invariants = casimirs(mu); invariants.size() > 0) {
      auto const square =
          S(1) + S(size_of(mu) * size_of(mu)) + S(size_of(algorithm.image) * size_of(algorithm.image));
      claim.zero("the algorithm preserves orbits", model, Vector<S>(casimirs(algorithm.image) - invariants),
                 square, 10);
      claim.zero("the other map preserves orbits", model, Vector<S>(casimirs(other.image) - invariants),
                 square, 10);
    }
    claim.zero("the algorithm preserves the bracket", model, poisson_defect(algorithm, mu), size(algorithm),
               100);
    claim.refutes("other maps do not", model, several([&] { return poisson_defect(any_map(), mu); }),
                  magnitude(lie_poisson_tensor_plus(mu)));
  });
}

// ----
// Section 3.2, fifth part: what the algorithms tend to as the step goes to zero, and the integrator on the
// dual that they make.
//
// Orders are fitted in double, against power series of equations written out by hand (top_in_any_group.hpp).

STATEMENT(claim_3_2_action_sum_limit, "the discrete action sum tends to the action") {
  claim.convention(
      "For a discrete Lagrangian that is an action, energy times time. A sum of the averages that (3.20) "
      "prints has no step in it and grows with the number of steps.");
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const xi = draw.template velocity<S>(group, ratio<S>(1, 2));
    auto const g = draw_small<S>(draw, group);
    auto const later = [&](S const& t) { return exp(t * xi) * g; };
    std::vector<S> const times = {S(0), ratio<S>(1, 7), ratio<S>(1, 2), ratio<S>(6, 5)};
    S sum(0), averages(0);
    for (std::size_t k = 0; k + 1 < times.size(); ++k) {
      S const h = times[k + 1] - times[k];
      S const term = discretize_right([&](auto const& v) { return l(v.velocity); }, h, at_first)(
          later(times[k]), later(times[k + 1]));
      sum += term, averages += term / h;
    }
    claim.equal("unequal steps along a one-parameter group", model, sum, S(l(xi) * times.back()));
    claim.differs("the step left out, as printed", model, averages, S(l(xi) * times.back()));
  });
  if (claim.fits_orders())
    for (auto const& group : limit_groups()) {
      auto const lagrangian = draw_top<S>(draw, group);
      auto const curve = draw_curve<S>(draw, group);
      Quadrature<S> const rule(20);
      S exact(0);
      for (int k = 0; k < 8; ++k)
        exact += action(lagrangian, curve, S(by_halves.duration * k / 8), S(by_halves.duration * (k + 1) / 8),
                        rule);
      auto const sum = [&](int n, double h, auto const& term) {
        S total(0);
        for (int k = 0; k < n; ++k) total += term(curve(S(h * k)), curve(S(h * (k + 1))));
        return magnitude(S(total - exact));
      };
      claim.order("the sum along any curve", group.name(), by_halves.step_lengths(),
                  by_halves.errors_of(
                      [&](int n, double h) { return sum(n, h, discretize_right(lagrangian, h, at_first)); }),
                  2);
      claim.refutes_order("the velocity from the later configuration to the earlier", group.name(),
                          by_halves.step_lengths(), by_halves.errors_of([&](int n, double h) {
                            return sum(n, h, [&](auto const& g0, auto const& g1) {
                              return discretize_right(lagrangian, h, at_first)(g1, g0);
                            });
                          }),
                          2);
    }
}

STATEMENT(claim_3_2_del_limit, "the discrete Euler-Lagrange algorithm tends to the Euler-Lagrange flow") {
  claim.holds("With the order of the discrete Lagrangian, here 2.");
  if (claim.fits_orders())
    for (auto const& group : limit_groups()) {
      auto const top = draw_top<S>(draw, group);
      State<SpannedGroup, S> const v{draw.template element<S>(group), draw.template velocity<S>(group)};
      auto const exact = top.flow(v, S(by_halves.duration)).first;
      auto const momentum_at_end = momentum(group, Vector<S>(top.a * exact.velocity.coordinates + top.b));
      // The errors at the end: of the configuration, and of the momentum at the end of the last step.
      auto const run = [&](int n, double h, auto const& L) {
        auto before = v.configuration, configuration = top.flow(v, S(h)).first.configuration;
        for (int k = 1; k < n; ++k) {
          auto const next = step_euler_lagrange(L, before, configuration).value;
          before = configuration, configuration = next;
        }
        return std::pair(magnitude((configuration.value - exact.configuration.value).eval()),
                         size_of(D2(L, before, configuration) - momentum_at_end));
      };
      std::vector<double> momenta;
      auto const configurations = by_halves.errors_of([&](int n, double h) {
        auto const [of_place, of_momentum] = run(n, h, discretize_right(top, h, at_first));
        momenta.push_back(to_double(of_momentum));
        return of_place;
      });
      claim.order("the configuration", group.name(), by_halves.step_lengths(), configurations, 2);
      claim.order("the momentum", group.name(), by_halves.step_lengths(), momenta, 2);
      claim.refutes_order("the velocity from the later configuration to the earlier", group.name(),
                          by_halves.step_lengths(), by_halves.errors_of([&](int n, double h) {
                            return run(
                                       n, h,
                                       [&](auto const& g0, auto const& g1) {
          return discretize_right(top, h, at_first)(g1, g0);
                                       })
                                .first;
                          }),
                          2);
    }
}

STATEMENT(
    claim_3_2_dep_limit,
    "the discrete Euler-Poincare algorithm, reconstructed, tends to the Euler-Poincare flow, reconstructed") {
  claim.holds(
      "Read by means of reconstruction, or of the momentum: to second order. The velocity of a relative "
      "motion, taken for that at its earlier end, is right to first order only.");
  if (claim.fits_orders())
    for (auto const& group : limit_groups()) {
      auto const top = draw_top_without_weight<S>(draw, group);
      State<SpannedGroup, S> const v{draw.template element<S>(group), draw.template velocity<S>(group)};
      auto const exact = top.flow(v, S(by_halves.duration)).first;
      auto const momentum_at_end = momentum(group, Vector<S>(top.a * exact.velocity.coordinates + top.b));
      struct Error {
        S configuration, momentum, velocity;
      };
      auto const run = [&](int n, double h) -> Error {
        auto const l = natural_chart_lagrangian_right(reduced(top), h);
        auto configuration = v.configuration;
        auto f = relative_motion_right(configuration, top.flow(v, S(h)).first.configuration);
        for (int k = 0; k < n; ++k) {
          configuration = reconstruct_right(configuration, f);
          f = step_euler_poincare_right(l, f).value;
        }
        return {magnitude((configuration.value - exact.configuration.value).eval()),
                size_of(momentum_before_right(l, f) - momentum_at_end),
                size_of(-log(f) / S(h) - exact.velocity)};
      };
      std::vector<double> momenta, velocities;
      auto const configurations = by_halves.errors_of([&](int n, double h) {
        Error const error = run(n, h);
        momenta.push_back(to_double(error.momentum)), velocities.push_back(to_double(error.velocity));
        return error.configuration;
      });
      claim.order("the configuration", group.name(), by_halves.step_lengths(), configurations, 2);
      claim.order("the momentum", group.name(), by_halves.step_lengths(), momenta, 2);
      claim.refutes_order("the velocity of the relative motion", group.name(), by_halves.step_lengths(),
                          velocities, 2);
    }
}

STATEMENT(claim_3_2_lie_poisson_integrator,
          "solving the discrete Euler-Poincare equations and carrying the momentum makes a Lie-Poisson "
          "integrator") {
  claim.holds(
      "It preserves the bracket because its relative motion solves those equations; that it preserves the "
      "orbits is not enough.");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    // One step with f solved from mu0, wherever (3.10) has a solution: draw f, and mu0 is the momentum at its
    // start.
    auto const l = draw_group_polynomial<S>(draw, group);
    auto const f = draw.template element<S>(group);
    auto const mu0 = momentum_before_right(l, f);
    auto const mu1 = lie_poisson_update_right(f, mu0);
    claim.equal("the momentum at the end of the step is that at the start of the next", model,
                -left_differential(l, f), mu1);
    // Its tangent, from the equation: d mu0 = -A theta, d mu1 = -B theta. Condition: A is inverted.
    Matrix<S> const tangent =
        left_second_differential(l, f) * inverse_matrix(right_second_differential(l, f));
    auto const defect = [&](Matrix<S> const& t, Momentum<SpannedGroup, S> const& image) {
      return Matrix<S>(t * lie_poisson_tensor_plus(mu0) * t.transpose() - lie_poisson_tensor_plus(image));
    };
    claim.zero("the bracket is preserved", model, defect(tangent, mu1),
               S(magnitude(tangent) * magnitude(tangent) * size_of(mu0) + size_of(mu1)), 100);
    // Controls: the inverse element; and an explicit Euler step of mu' = -ad* mu. (On Aff(1) any such step
    // preserves the bracket: there it is the determinant of the step times mu_2.)
    claim.differs("Ad* of the inverse", model, -left_differential(l, f), Ad_star(inverse(f), mu0));
    auto const xi = draw.template velocity<S>(group);
    Matrix<S> const euler =
        Matrix<S>::Identity(group.dimension(), group.dimension()) - ad_matrix(xi).transpose();
    if (model != "Aff(1)")
      claim.refutes("an explicit Euler step", model,
                    defect(euler, momentum(group, Vector<S>(euler * mu0.components))), size_of(mu0));
  });
  if (claim.fits_orders())
    for (auto const& group : limit_groups()) {
      auto const top = draw_top_without_weight<S>(draw, group);
      State<SpannedGroup, S> const v{draw.template element<S>(group), draw.template velocity<S>(group)};
      auto const momentum_of = [&](State<SpannedGroup, S> const& at) {
        return momentum(group, Vector<S>(top.a * at.velocity.coordinates + top.b));
      };
      auto const exact = momentum_of(top.flow(v, S(by_halves.duration)).first);
      auto const run = [&](int n, double h, auto const& carry) {
        auto const l = natural_chart_lagrangian_right(reduced(top), h);
        auto mu = momentum_of(v);
        auto f = exp(S(-h) * v.velocity);
        for (int k = 0; k < n; ++k) {
          f = relative_motion_from_momentum_right(l, mu, f).value;
          mu = carry(f, mu);
        }
        return size_of(mu - exact);
      };
      claim.order("against the Lie-Poisson flow", group.name(), by_halves.step_lengths(),
                  by_halves.errors_of([&](int n, double h) {
                    return run(n, h,
                               [](auto const& f, auto const& mu) { return lie_poisson_update_right(f, mu); });
                  }),
                  2);
      claim.refutes_order("the flow, carried by Ad* of the inverse", group.name(), by_halves.step_lengths(),
                          by_halves.errors_of([&](int n, double h) {
                            return run(n, h,
                                       [](auto const& f, auto const& mu) { return Ad_star(inverse(f), mu); });
                          }),
                          2);
    }
}
