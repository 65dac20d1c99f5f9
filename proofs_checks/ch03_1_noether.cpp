// Section 3.1, third part: symmetries of the discrete action, discrete Noether.

#include "actio/variational/momentum_map.hpp"

#include "models/pairs.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// Translations on the right: their generators, and what they do to a configuration.
struct OnTheRight {
  template <class S>
  auto operator()(Velocity<SpannedGroup, S> const& zeta) const { return right_translation(zeta); }
  template <class S>
  GroupElement<S> moved(GroupElement<S> const& g, GroupElement<S> const& k) const { return g * k; }
};
/// Translations on the left.
struct OnTheLeft {
  template <class S>
  auto operator()(Velocity<SpannedGroup, S> const& zeta) const { return left_translation(zeta); }
  template <class S>
  GroupElement<S> moved(GroupElement<S> const& g, GroupElement<S> const& k) const { return k * g; }
};
inline constexpr OnTheRight on_the_right;
inline constexpr OnTheLeft on_the_left;
/// A sequence, each configuration moved by the same element.
template <class Side, class S>
GroupElements<S> moved(Side const& side, GroupElements<S> const& g, GroupElement<S> const& k) {
  GroupElements<S> all;
  for (auto const& one : g) all.push_back(side.moved(one, k));
  return all;
}
/// The left sides of (3.2) at every configuration of a sequence between its ends, one after the other.
template <class Lagrangian, class S>
Vector<S> equations_along(Lagrangian const& L, GroupElements<S> const& g) {
  std::vector<Momentum<SpannedGroup, S>> all;
  for (std::size_t k = 1; k + 1 < g.size(); ++k)
    all.push_back(discrete_euler_lagrange(L, g[k - 1], g[k], g[k + 1]));
  return in_one_column(all);
}

/// Right- and left-invariant Lagrangians of which `g` is a motion, each with the translations under which it
/// is invariant and with those on the other side.
template <class S, class Visit>
void over_sides(Draw& draw, GroupElements<S> const& g, std::string const& model, Visit const& visit) {
  visit(draw_right_invariant_with_motion<S>(draw, g), on_the_right, on_the_left, model + ", right-invariant");
  visit(draw_left_invariant_with_motion<S>(draw, g), on_the_left, on_the_right, model + ", left-invariant");
}
/// The generator of the diagonal action at a pair.
template <class S, class Generator>
Change<S> at_pair(Generator const& generator, GroupElement<S> const& g0, GroupElement<S> const& g1) {
  return {generator(g0), generator(g1)};
}
/// A number for each basis vector of the algebra.
template <class S, class Value>
Vector<S> over_basis(SpannedGroup const& group, Value const& value) {
  Vector<S> all(group.dimension());
  for (int a = 0; a < group.dimension(); ++a) all[a] = value(basis_velocity<S>(group, a));
  return all;
}

}  // namespace

STATEMENT(eq_3_7, "a symmetry contracted with the two one-forms at either end of a motion") {
  claim.holds(
      "For an invariant Lagrangian along a motion of two pairs, as (3.6) with $N = 2$; that the flow is "
      "equivariant, which the step to (3.7) uses, at finite elements and in its tangent.");
  over_groups(groups_for_motions<S>(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw_points<S>(draw, group, 3, ratio<S>(1, 2));
    over_sides(
        draw, g, model, [&](auto const& L, auto const& own, auto const& other, std::string const& side) {
          // The action does not change along the symmetry.
          auto const along = [&](auto const& generator) {
            return rate(g, {generator(g[0]), generator(g[1]), generator(g[2])},
                        [&](auto const& q) { return discrete_action(L, q); });
          };
          auto const first = [&](auto const& side_of) {
            return over_basis<S>(group, [&](auto const& zeta) {
              return discrete_one_form_minus(L, g[0], g[1], at_pair(side_of(zeta), g[0], g[1]));
            });
          };
          auto const last = [&](auto const& side_of) {
            return over_basis<S>(group, [&](auto const& zeta) {
              return discrete_one_form_plus(L, g[1], g[2], at_pair(side_of(zeta), g[1], g[2]));
            });
          };
          claim.zero("the contraction of the symmetry with dS", side,
                     over_basis<S>(group, [&](auto const& zeta) { return along(own(zeta)); }),
                     size_of(first(own)));
          // The flow is equivariant: its tangent takes the generator at a pair to the generator at the next.
          auto const generator = own(draw.template velocity<S>(group));
          auto const carried = discrete_flow_tangent(L, g[0], g[1], g[2], at_pair(generator, g[0], g[1]));
          claim.equal("the tangent of the flow takes generator to generator", side, carried.second,
                      generator(g[2]), flow_condition<S>(L, g[1], g[2]));
          // So it is at a finite element: the translated configurations are a motion.
          auto const k = draw.template element<S>(group, S(1));
          auto const terms = size_of(D2(L, g[0], g[1]));
          claim.zero("the flow takes translated pairs to translated pairs", side,
                     equations_along(L, moved(own, g, k)), terms, 100);  // k is far from 1: its Ad magnifies
          claim.refutes("pairs translated on the other side", side, equations_along(L, moved(other, g, k)),
                        terms);
          claim.equal("(3.7)", side, first(own), Vector<S>(-last(own)));
          // Controls: no minus sign, a symmetry of the other side.
          claim.differs("without the minus sign", side, first(own), last(own));
          claim.differs("translations under which the Lagrangian is not invariant", side, first(other),
                        Vector<S>(-last(other)));
        });
  });
}

STATEMENT(claim_3_1_momentum_forms, "at one and the same pair the symmetry's contractions are opposite") {
  claim.holds("Off shell: no equation of motion is needed, only invariance.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw_points<S>(draw, group, 2);
    auto const minus = [&](auto const& L, auto const& side_of) {
      return over_basis<S>(group, [&](auto const& zeta) {
        return discrete_one_form_minus(L, g[0], g[1], at_pair(side_of(zeta), g[0], g[1]));
      });
    };
    auto const plus = [&](auto const& L, auto const& side_of) {
      return over_basis<S>(group, [&](auto const& zeta) {
        return discrete_one_form_plus(L, g[0], g[1], at_pair(side_of(zeta), g[0], g[1]));
      });
    };
    auto const l = draw_group_polynomial<S>(draw, group);
    auto const right = lift_right(l);
    auto const left = lift_left(l);
    claim.equal("right-invariant", model, minus(right, on_the_right), Vector<S>(-plus(right, on_the_right)));
    claim.equal("left-invariant", model, minus(left, on_the_left), Vector<S>(-plus(left, on_the_left)));
    // Controls: translations of the other side, a Lagrangian that is invariant under nothing.
    claim.differs("right-invariant, translated on the left", model, minus(right, on_the_left),
                  Vector<S>(-plus(right, on_the_left)));
    auto const general = draw_pair_polynomial<S>(draw, group);
    claim.differs("no symmetry", model, minus(general, on_the_right),
                  Vector<S>(-plus(general, on_the_right)));
  });
}

STATEMENT(eq_3_8, "the discrete momentum is the same after every step") {
  claim.holds();
  over_groups(groups_for_motions<S>(), claim, [&](auto const& group, auto const& model) {
    // Three pairs: with two a momentum of the wrong pair would pass.
    auto const g = draw_points<S>(draw, group, 4, ratio<S>(1, 2));
    over_sides(
        draw, g, model, [&](auto const& L, auto const& own, auto const& other, std::string const& side) {
          auto const J = [&](int k, auto const& side_of) {
            return over_basis<S>(
                group, [&](auto const& zeta) { return discrete_momentum(L, g[k], g[k + 1], side_of(zeta)); });
          };
          auto const minus = over_basis<S>(group, [&](auto const& zeta) {
            return discrete_one_form_minus(L, g[1], g[2], at_pair(own(zeta), g[1], g[2]));
          });
          claim.equal("J is theta+ contracted with the generator", side, J(0, own),
                      over_basis<S>(group, [&](auto const& zeta) {
                        return discrete_one_form_plus(L, g[0], g[1], at_pair(own(zeta), g[0], g[1]));
                      }));
          claim.equal("after one step", side, J(1, own), J(0, own));
          claim.equal("after two steps", side, J(2, own), J(0, own));
          claim.equal("as minus theta-, at the next pair", side, Vector<S>(-minus), J(0, own));
          // Controls: theta- with the sign of theta+, the momentum of the other side, configurations that are
          // no motion.
          claim.differs("theta- in place of theta+", side, minus, J(0, own));
          claim.differs("momentum of translations on the other side", side, J(1, other), J(0, other));
          claim.differs(
              "a last configuration that is no motion", side,
              over_basis<S>(group,
                            [&](auto const& zeta) { return discrete_momentum(L, g[1], g[3], own(zeta)); }),
              J(0, own));
        });
  });

  // Through the solver: eight steps of a system with a right-invariant Lagrangian that is not even.
  if (!exact_arithmetic<S>())
    over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
      auto const L = discretize_at_the_configuration(
          right_invariant(draw_regular_algebra_polynomial<S>(draw, group)), ratio<S>(1, 64));
      GroupElements<S> g = {draw.template element<S>(group)};
      g.push_back(retract(draw.template velocity<S>(group, ratio<S>(1, 256))) * g[0]);
      for (int k = 1; k <= 8; ++k) g.push_back(step_euler_lagrange(L, g[k - 1], g[k]).value);
      auto const J = [&](int k) {
        return over_basis<S>(group, [&](auto const& zeta) {
          return discrete_momentum(L, g[k], g[k + 1], right_translation(zeta));
        });
      };
      // Each of eight steps may leave 16 roundings of a derivative that is 64 times a momentum.
      claim.equal("eight steps of the solver", model, J(8), J(0), 8 * 8);
    });
}

namespace {

/// A vector of the standard basis that the first basis matrix kills, in each of the few groups.
int fixed_vector(SpannedGroup const& group) { return group.name() == "SO(3)" ? 0 : group.matrix_size() - 1; }
/// Invariant under conjugation of both configurations, and under no translation.
inline constexpr auto class_lagrangian = [](auto const& g0, auto const& g1) {
  auto const trace = g1.value.trace();
  return (g0 * inverse(g1)).value.trace() + g0.value.trace() * trace * trace;
};

}  // namespace

STATEMENT(rem_3_1_3, "a symmetry group smaller than $G$ conserves its own momentum and no other") {
  claim.holds(
      "The remark sets this case aside for the rest of the chapter; Noether's theorem of "
      "this section covers it. Instance: $K$ is the one-parameter group that fixes a "
      "vector, acting on $G$ from the right.");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    int const fixed = fixed_vector(group);
    auto const g = draw_points<S>(draw, group, 4, ratio<S>(1, 2));
    // A right-invariant Lagrangian plus a potential that depends only on the image of the fixed vector.
    auto const with_potential = lift_with_height(draw_vector<S>(draw, group.matrix_size()), fixed);
    auto const L =
        with_potential(with_motion_along(draw_group_polynomial<S>(draw, group), g, draw, with_potential));
    auto const J = [&](auto const& zeta, int k) {
      return discrete_momentum(L, g[k], g[k + 1], right_translation(zeta));
    };

    auto const inside = basis_velocity<S>(group, 0),
               outside = basis_velocity<S>(group, group.dimension() - 1);
    auto const terms = size_of(D2(L, g[0], g[1]));
    claim.zero("the vector is fixed by K", model, Vector<S>(group.hat(inside.coordinates).col(fixed)), S(1));
    claim.zero("momentum of K, first step", model, S(J(inside, 1) - J(inside, 0)), terms);
    claim.zero("momentum of K, second step", model, S(J(inside, 2) - J(inside, 0)), terms);
    // Control: a direction outside K, a symmetry of the first part of the Lagrangian alone.
    claim.refutes("momentum of a direction outside K", model,
                  Vector<S>{{J(outside, 1) - J(outside, 0), J(outside, 2) - J(outside, 0)}}, terms);
  });
}

STATEMENT(claim_3_1_symmetry_of_discrete_flow, "a symmetry takes discrete motions to discrete motions") {
  claim.holds(
      "At finite elements: the action is invariant, (3.2) at a moved sequence is (3.2) at the sequence "
      "itself, moved, so that critical points go to critical points and no others do, and the flow is "
      "equivariant. For translations on either side, for a subgroup of them, and for conjugation.");
  // Sequences of four configurations, no motions: for each symmetry, how it moves a covector at the identity.
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw_points<S>(draw, group, 4, ratio<S>(1, 2));
    auto const k = draw.template element<S>(group, S(1)), none = identity<S>(group);
    auto const covariant = [&](auto const& L, auto const& move, auto const& turn, std::string const& side) {
      GroupElements<S> there, halfway, unequal;
      for (std::size_t i = 0; i < g.size(); ++i) {
        there.push_back(move(g[i], k)), halfway.push_back(i < 2 ? g[i] : there[i]);
        unequal.push_back(move(g[i], i % 2 == 0 ? k : k * k));
      }
      auto const here = equations_along(L, g);
      int const d = group.dimension();
      Matrix<S> const turning = Ad_matrix(turn).transpose();
      Vector<S> expected(2 * d);
      for (int i = 0; i < 2; ++i) expected.segment(i * d, d) = turning * here.segment(i * d, d);
      auto const terms = S(S(1) + size_of(L(g[0], g[1])) + size_of(D2(L, g[0], g[1])));
      auto const large = S(terms * S(1 + magnitude(turning)));
      // Condition: k is of size 1, and its inverse is taken; the terms are those before it magnifies them.
      claim.zero("the action is invariant", side, S(discrete_action(L, there) - discrete_action(L, g)), large,
                 100);
      claim.zero("(3.2) moves with the sequence", side, Vector<S>(equations_along(L, there) - expected),
                 large, 100);
      // Controls: half of the configurations moved; each second one by the square of k.
      claim.refutes("the later configurations moved alone", side,
                    Vector<S>(equations_along(L, halfway) - expected), terms);
      claim.refutes("the configurations moved by different elements", side,
                    Vector<S>(equations_along(L, unequal) - expected), terms);
    };
    auto const l = draw_group_polynomial<S>(draw, group);
    auto const right = [](auto const& x, auto const& y) { return x * y; };
    auto const left = [](auto const& x, auto const& y) { return y * x; };
    auto const conjugation = [](auto const& x, auto const& y) { return y * x * inverse(y); };
    covariant(lift_right(l), right, none, model + ", right-invariant");
    covariant(lift_left(l), left, inverse(k), model + ", left-invariant");
    // (On the other groups of triangular matrices, and SE(2), traces see a commutative quotient alone.)
    if (model != "Heisenberg" && model != "Aff(1)" && model != "SE(2)")
      covariant(class_lagrangian, conjugation, inverse(k), model + ", invariant under conjugation");
  });
  // A motion of three steps stays one; under a subgroup, the symmetry of a Lagrangian with a potential.
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw_points<S>(draw, group, 4, ratio<S>(1, 2));
    auto const with_potential =
        lift_with_height(draw_vector<S>(draw, group.matrix_size()), fixed_vector(group));
    auto const L =
        with_potential(with_motion_along(draw_group_polynomial<S>(draw, group), g, draw, with_potential));
    S const t = draw.template number<S>();
    auto const inside = retract(t * basis_velocity<S>(group, 0)),
               outside = draw.template element<S>(group, S(1));
    auto const terms = size_of(D2(L, g[0], g[1]));
    // Condition: the motion was made by solving for the coefficients of the Lagrangian.
    claim.zero("a motion", model, equations_along(L, g), terms, 100);
    claim.zero("a motion, moved by an element of K", model,
               equations_along(L, moved(on_the_right, g, inside)), terms, 100);
    claim.refutes("moved by an element outside K", model, equations_along(L, moved(on_the_right, g, outside)),
                  terms);
  });
  // The flow itself, by its solver, four steps from a pair and from the pair moved.
  if (!exact_arithmetic<S>())
    over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
      auto const L = discretize_at_the_configuration(
          right_invariant(draw_regular_algebra_polynomial<S>(draw, group)), ratio<S>(1, 64));
      auto const k = draw.template element<S>(group);
      GroupElements<S> g = {draw.template element<S>(group)};
      g.push_back(retract(draw.template velocity<S>(group, ratio<S>(1, 256))) * g[0]);
      auto there = moved(on_the_right, g, k), on_the_other_side = moved(on_the_left, g, k);
      for (int i = 1; i <= 4; ++i)
        for (auto* q : {&g, &there, &on_the_other_side})
          q->push_back(step_euler_lagrange(L, (*q)[q->size() - 2], q->back()).value);
      // Each of four steps may leave 16 roundings of a configuration, and the steps add them up.
      claim.equal("F(g0 k, g1 k) = F(g0, g1) k, four steps of the solver", model, there.back().value,
                  (g.back() * k).value, 64);
      claim.differs("F(k g0, k g1) = k F(g0, g1), of a right-invariant Lagrangian", model,
                    on_the_other_side.back().value, (k * g.back()).value, 1e-5);
    });
}
