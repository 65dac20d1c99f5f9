// Section 4.3, first part: the square of Legendre maps and quotient maps. Compiled once per scalar.
//
// A function of pairs sees only g0 g1^-1, found by elimination (sequences.hpp: lifted). Differentials are taken along matrices, with no translation of the library.
// Degrees: the models are cubic in places of degree below 12, products and inverses of up to three of them. The bounds say so.
#include "actio/groupoid/group_as_groupoid.hpp"
#include "actio/groupoid/lagrange_equations.hpp"
#include "actio/groupoid/opposite_groupoid.hpp"
#include "actio/reduction/discrete_forms.hpp"
#include "sequences.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// The covector theta -> value(theta) on the algebra.
template <class S, class Value>
Momentum<SpannedGroup, S> covector(SpannedGroup const& group, Value const& value) {
  Momentum<SpannedGroup, S> mu{group, Vector<S>(group.dimension())};
  for (int a = 0; a < group.dimension(); ++a) mu.components[a] = value(basis_velocity<S>(group, a));
  return mu;
}
/// p = dL/dg0 as a form on matrices.
template <class S, class L>
S first_slope(L const& lagrangian, Place<S> const& g0, Place<S> const& g1, Matrix<S> const& change) {
  return lagrangian(varied(g0, change), over<Dual<S>>(g1)).part[0];
}

}  // namespace

STATEMENT(thm_4_3_1, "the Legendre maps commute with the quotient maps") {
  claim.holds("With the momentum $D_1\\mathbb L$ of (4.7) above and $R_f^*\\ell'$ below; physical momenta have the other sign in both. Regularity is not needed for the square, only for the maps in it to be local diffeomorphisms.");
  claim.degree(600);
  over_groups(groups_for_squares<S>(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw_places<S>(draw, group, 3);
    auto const f = relative_motions_right(Places<S>{g[0], g[1]}).front(), f_left = relative_motions_left(Places<S>{g[0], g[1]}).front();
    // Right-invariant: along the top, then down; down, then along the bottom.
    auto const above = covector<S>(group, [&](auto const& e) { return first_slope(lifted(l), g[0], g[1], from_left(e, g[0])); });
    auto const below = covector<S>(group, [&](auto const& e) { return slope(l, f, from_left(e, f)); });
    claim.equal("right-invariant", model, above, below, 10);
    claim.equal("the library: along the top", model, D1(lifted(l), g[0], g[1]), above);
    claim.equal("the library: along the bottom", model, right_differential(l, f), below);
    // Left-invariant: the quotient of T*G is translation on the left.
    auto const above_left = covector<S>(group, [&](auto const& e) { return first_slope(lifted_left(l), g[0], g[1], from_right(g[0], e)); });
    claim.equal("left-invariant", model, above_left, covector<S>(group, [&](auto const& e) { return slope(l, f_left, from_right(f_left, e)); }), 10);
    // Controls: translation on the other side; a Lagrangian that is not invariant, whose momentum depends on the pair above a relative motion.
    claim.differs("the quotient of T*G on the other side", model, covector<S>(group, [&](auto const& e) { return first_slope(lifted(l), g[0], g[1], from_right(g[0], e)); }), below);
    auto const any = draw_pair_polynomial<S>(draw, group);
    claim.differs("no invariance", model, D1(any, g[0] * g[2], g[1] * g[2]), D1(any, g[0], g[1]));
  });
}

STATEMENT(eq_4_6, "the commuting square of Legendre and quotient maps") {
  claim.holds("For both Legendre maps, that of the momentum before the step and that of the momentum after it.");
  claim.degree(600);
  over_groups(groups_for_squares<S>(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw_places<S>(draw, group, 2);
    auto const f = relative_motions_right(g).front();
    claim.equal("before the step: D_1 above, R* below", model, D1(lifted(l), g[0], g[1]), right_differential(l, f), 10);
    claim.equal("after the step: D_2 above, -L* below", model, D2(lifted(l), g[0], g[1]), -left_differential(l, f), 10);
    claim.differs("D_2 above, R* below", model, D2(lifted(l), g[0], g[1]), right_differential(l, f));
    // Both maps along the square are local diffeomorphisms together: their second derivatives differ by Ad. Condition: places are inverted.
    Matrix<S> const above = mixed_derivative(lifted(l), g[0], g[1]), below = right_second_differential(l, f);
    claim.zero("D_2 D_1 L = -(R* l')' Ad_f", model, Matrix<S>(above + below * Ad_matrix(f)), S(magnitude(below) * magnitude(Ad_matrix(f))), 10);
    claim.refutes("without Ad", model, Matrix<S>(above + below), S(magnitude(above) + magnitude(below)));
  });
}

STATEMENT(eq_4_7, "the square in coordinates") {
  claim.holds();
  claim.degree(600);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw_places<S>(draw, group, 2);
    auto const quotient = g[0] * inverse(g[1]);
    claim.equal("f, translated back by the later place", model, quotient * g[1], g[0]);
    // p is a form on matrices at g0; mu is p after translation by g0 on the right; and that is what f sees.
    auto const p = [&](Matrix<S> const& change) { return first_slope(lifted(l), g[0], g[1], change); };
    auto const mu = covector<S>(group, [&](auto const& e) { return p(from_left(e, g[0])); });
    claim.equal("mu from p, and from f", model, mu, right_differential(l, quotient), 10);
    claim.differs("f from the places in the other order", model, mu, right_differential(l, g[1] * inverse(g[0])));
    claim.differs("p translated on the left", model, covector<S>(group, [&](auto const& e) { return p(from_right(g[0], e)); }), mu);
  });
}

STATEMENT(eq_4_8, "the spatial momentum along the square, by the chain rule") {
  claim.corrected(R"(R_{g_k}^*\Bigl(R_{g_{k+1}}^*\frac{\partial\ell}{\partial f}\Bigr) = R_f^*\frac{\partial\ell}{\partial f})",
                  R"(R_{g_k}^*\Bigl(R_{g_{k+1}^{-1}}^*\frac{\partial\ell}{\partial f}\Bigr) = R_f^*\frac{\partial\ell}{\partial f})",
                  "The inverse is missing in the term between; the sentence after the equation has it. Both ends are right, and the quotient map in the first term is that of pairs.");
  claim.maybe_scan();
  claim.degree(600);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw_places<S>(draw, group, 2);
    auto const f = relative_motions_right(g).front();
    Matrix<S> const back = inverse(g[1]).value;
    auto const between = [&](Matrix<S> const& translation) {
      return covector<S>(group, [&](auto const& e) { return slope(l, f, Matrix<S>(from_left(e, g[0]) * translation)); });
    };
    auto const mu = covector<S>(group, [&](auto const& e) { return first_slope(lifted(l), g[0], g[1], from_left(e, g[0])); });
    claim.equal("the term between", model, between(back), mu, 10);
    claim.equal("the last term", model, covector<S>(group, [&](auto const& e) { return slope(l, f, from_left(e, f)); }), mu, 10);
    claim.differs("as printed", model, between(g[1].value), mu);
  });
}

STATEMENT(claim_4_3_legendre_map_value, "the Legendre map of a right-invariant system is f -> R*_f l'(f)") {
  claim.holds("It is the groupoid's Legendre map at the source of an arrow. That of a left-invariant system, $L_f^*\\ell'(f)$, is the same map of the opposite groupoid.");
  claim.degree(600);
  over_groups(groups_for_squares<S>(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const f = draw.template element<S>(group);
    using Alone = GroupAsGroupoid<SpannedGroup>;
    auto const right = covector<S>(group, [&](auto const& e) { return slope(l, f, from_left(e, f)); });
    auto const left = covector<S>(group, [&](auto const& e) { return slope(l, f, from_right(f, e)); });
    auto const at_source = [&](auto const& gamma) { return momentum(group, Vector<S>(legendre_at_source(gamma, l, f).components)); };
    auto const at_target = [&](auto const& gamma) { return momentum(group, Vector<S>(legendre_at_target(gamma, l, f).components)); };
    claim.equal("right: at the source, on the group", model, at_source(Alone{group}), right);
    claim.equal("left: at the source, on the opposite group", model, at_source(Opposite<Alone>{{group}}), left);
    claim.equal("at the target, on the group", model, at_target(Alone{group}), left);
    claim.equal("at the target, on the opposite group", model, at_target(Opposite<Alone>{{group}}), right);
    if (model != "Heisenberg") claim.differs("right and left taken for each other", model, at_target(Alone{group}), right);
  });
}
