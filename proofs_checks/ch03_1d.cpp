// Section 3.1: discrete Noether. Compiled once per scalar.
//
// Degrees. Motions are made by design: the coefficients of the added terms come from a linear system with up to 12 rows (SE(3) in the last check), whose entries have degree 30 at most, so
// with denominators cleared a Lagrangian has degree 500 at most. The tangent of the flow solves a system of up to 6 rows of such entries: degree 4000 with what it acts on.
#include "actio/variational/momentum_map.hpp"
#include "pairs.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

inline constexpr auto on_the_right = [](auto const& zeta) { return right_translation(zeta); };
inline constexpr auto on_the_left = [](auto const& zeta) { return left_translation(zeta); };

/// Right- and left-invariant Lagrangians of which `g` is a motion, each with the translations that it does not see and with those on the other side.
template <class S, class Visit>
void over_sides(Draw& draw, Places<S> const& g, std::string const& model, Visit const& visit) {
  visit(draw_right_invariant_with_motion<S>(draw, g), on_the_right, on_the_left, model + ", right-invariant");
  visit(draw_left_invariant_with_motion<S>(draw, g), on_the_left, on_the_right, model + ", left-invariant");
}
/// The generator of the diagonal action at a pair.
template <class S, class Generator>
Change<S> at_pair(Generator const& generator, Place<S> const& g0, Place<S> const& g1) {
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
  claim.holds("For an invariant Lagrangian along a motion of two pairs, as (3.6) with N = 2.");
  claim.degree(4000);
  over_groups(groups_for_motions<S>(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw_places<S>(draw, group, 3, ratio<S>(1, 2));
    over_sides(draw, g, model, [&](auto const& L, auto const& own, auto const& other, std::string const& side) {
      // The action does not change along the symmetry.
      auto const along = [&](auto const& generator) { return rate(g, {generator(g[0]), generator(g[1]), generator(g[2])}, [&](auto const& q) { return discrete_action(L, q); }); };
      auto const first = [&](auto const& side_of) { return over_basis<S>(group, [&](auto const& zeta) { return discrete_one_form_minus(L, g[0], g[1], at_pair(side_of(zeta), g[0], g[1])); }); };
      auto const last = [&](auto const& side_of) { return over_basis<S>(group, [&](auto const& zeta) { return discrete_one_form_plus(L, g[1], g[2], at_pair(side_of(zeta), g[1], g[2])); }); };
      claim.zero("the contraction of the symmetry with dS", side, over_basis<S>(group, [&](auto const& zeta) { return along(own(zeta)); }), size_of(first(own)));
      // The flow is equivariant: its tangent takes the generator at a pair to the generator at the next.
      auto const generator = own(draw.template velocity<S>(group));
      auto const carried = discrete_flow_tangent(L, g[0], g[1], g[2], at_pair(generator, g[0], g[1]));
      claim.equal("the tangent of the flow takes generator to generator", side, carried.second, generator(g[2]), flow_condition<S>(L, g[1], g[2]));
      claim.equal("(3.7)", side, first(own), Vector<S>(-last(own)));
      // Controls: no minus sign, a symmetry of the other side.
      claim.differs("without the minus sign", side, first(own), last(own));
      claim.differs("translations on the side that the Lagrangian sees", side, first(other), Vector<S>(-last(other)));
    });
  });
}

STATEMENT(claim_3_1_momentum_forms, "at one and the same pair the symmetry's contractions are opposite") {
  claim.holds("Off shell: no equation of motion is needed, only invariance.");
  claim.degree(400);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw_places<S>(draw, group, 2);
    auto const minus = [&](auto const& L, auto const& side_of) { return over_basis<S>(group, [&](auto const& zeta) { return discrete_one_form_minus(L, g[0], g[1], at_pair(side_of(zeta), g[0], g[1])); }); };
    auto const plus = [&](auto const& L, auto const& side_of) { return over_basis<S>(group, [&](auto const& zeta) { return discrete_one_form_plus(L, g[0], g[1], at_pair(side_of(zeta), g[0], g[1])); }); };
    auto const l = draw_group_polynomial<S>(draw, group);
    auto const right = lift_right(l);
    auto const left = lift_left(l);
    claim.equal("right-invariant", model, minus(right, on_the_right), Vector<S>(-plus(right, on_the_right)));
    claim.equal("left-invariant", model, minus(left, on_the_left), Vector<S>(-plus(left, on_the_left)));
    // Controls: translations of the other side, a Lagrangian that is invariant under nothing.
    claim.differs("right-invariant, translated on the left", model, minus(right, on_the_left), Vector<S>(-plus(right, on_the_left)));
    auto const general = draw_pair_polynomial<S>(draw, group);
    claim.differs("no symmetry", model, minus(general, on_the_right), Vector<S>(-plus(general, on_the_right)));
  });
}

STATEMENT(eq_3_8, "the discrete momentum is the same after every step") {
  claim.holds();
  claim.degree(4000);
  over_groups(groups_for_motions<S>(), claim, [&](auto const& group, auto const& model) {
    // Three pairs: two would not see a momentum of the wrong pair.
    auto const g = draw_places<S>(draw, group, 4, ratio<S>(1, 2));
    over_sides(draw, g, model, [&](auto const& L, auto const& own, auto const& other, std::string const& side) {
      auto const J = [&](int k, auto const& side_of) { return over_basis<S>(group, [&](auto const& zeta) { return discrete_momentum(L, g[k], g[k + 1], side_of(zeta)); }); };
      auto const minus = over_basis<S>(group, [&](auto const& zeta) { return discrete_one_form_minus(L, g[1], g[2], at_pair(own(zeta), g[1], g[2])); });
      claim.equal("J is theta+ contracted with the generator", side, J(0, own), over_basis<S>(group, [&](auto const& zeta) { return discrete_one_form_plus(L, g[0], g[1], at_pair(own(zeta), g[0], g[1])); }));
      claim.equal("after one step", side, J(1, own), J(0, own));
      claim.equal("after two steps", side, J(2, own), J(0, own));
      claim.equal("as minus theta-, at the next pair", side, Vector<S>(-minus), J(0, own));
      // Controls: theta- with the sign of theta+, the momentum of the other side, places that are no motion.
      claim.differs("theta- in place of theta+", side, minus, J(0, own));
      claim.differs("momentum of translations on the other side", side, J(1, other), J(0, other));
      claim.differs("a last place that is no motion", side, over_basis<S>(group, [&](auto const& zeta) { return discrete_momentum(L, g[1], g[3], own(zeta)); }), J(0, own));
    });
  });

  // Through the solver: eight steps of a system with a right-invariant Lagrangian that is not even.
  if constexpr (Real<S>)
    over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
      auto const L = discretize_at_the_place(right_invariant(draw_regular_algebra_polynomial<S>(draw, group)), ratio<S>(1, 64));
      Places<S> g = {draw.template element<S>(group)};
      g.push_back(retract(draw.template velocity<S>(group, ratio<S>(1, 256))) * g[0]);
      for (int k = 1; k <= 8; ++k) g.push_back(step_euler_lagrange(L, g[k - 1], g[k]).value);
      auto const J = [&](int k) { return over_basis<S>(group, [&](auto const& zeta) { return discrete_momentum(L, g[k], g[k + 1], right_translation(zeta)); }); };
      // Each of eight steps may leave 16 roundings of a derivative that is 64 times a momentum.
      claim.equal("eight steps of the solver", model, J(8), J(0), 8 * 8);
    });
}

STATEMENT(rem_3_1_3, "a symmetry group smaller than G keeps its own momentum and no other") {
  claim.holds("The remark sets this case aside for the rest of the chapter; Noether's theorem of this section covers it. Instance: K the one-parameter group that fixes a vector, acting on G from the right.");
  claim.degree(4000);
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    // The first basis matrix kills the last vector of the standard basis in each of these groups, save SO(3), where it kills the first.
    int const fixed = group.name() == "SO(3)" ? 0 : group.matrix_size() - 1;
    auto const g = draw_places<S>(draw, group, 4, ratio<S>(1, 2));
    // A right-invariant Lagrangian plus a potential that sees only where the fixed vector goes.
    auto const heights = draw_vector<S>(draw, group.matrix_size());
    auto const with_potential = [&](auto const& l) {
      return [lift = lift_right(l), heights, fixed](auto const& g0, auto const& g1) {
        using T = typename std::decay_t<decltype(g0)>::Scalar;
        T height(0);
        for (Eigen::Index i = 0; i < heights.size(); ++i) height += g1.value(i, fixed) * T(heights[i]);
        return lift(g0, g1) - height * height;
      };
    };
    auto const L = with_potential(with_motion_along(draw_group_polynomial<S>(draw, group), g, draw, with_potential));
    auto const J = [&](auto const& zeta, int k) { return discrete_momentum(L, g[k], g[k + 1], right_translation(zeta)); };

    auto const inside = basis_velocity<S>(group, 0), outside = basis_velocity<S>(group, group.dimension() - 1);
    auto const terms = size_of(D2(L, g[0], g[1]));
    claim.zero("the vector is fixed by K", model, Vector<S>(group.hat(inside.coordinates).col(fixed)), S(1));
    claim.zero("momentum of K, first step", model, S(J(inside, 1) - J(inside, 0)), terms);
    claim.zero("momentum of K, second step", model, S(J(inside, 2) - J(inside, 0)), terms);
    // Control: a direction outside K, a symmetry of the first part of the Lagrangian alone.
    claim.refutes("momentum of a direction outside K", model, Vector<S>{{J(outside, 1) - J(outside, 0), J(outside, 2) - J(outside, 0)}}, terms);
  });
}
