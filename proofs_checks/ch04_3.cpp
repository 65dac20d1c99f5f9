// Section 4.3, first part: the square of Legendre maps and quotient maps.
//
// The functions of pairs depend on g0 g1^-1 only, found by elimination (sequences.hpp: lifted). Differentials
// are taken along matrices, with no translation of the library.

#include "actio/groupoid/group_as_groupoid.hpp"
#include "actio/groupoid/lagrange_equations.hpp"
#include "actio/groupoid/opposite_groupoid.hpp"
#include "actio/groupoid/poisson_on_group.hpp"
#include "actio/reduction/discrete_forms.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/reduction/discrete_poisson.hpp"
#include "actio/reduction/relative_motion.hpp"

#include "models/chart_models.hpp"
#include "models/limits.hpp"
#include "models/sequences.hpp"
#include "models/top_in_any_group.hpp"
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
S first_slope(L const& lagrangian, GroupElement<S> const& g0, GroupElement<S> const& g1,
              Matrix<S> const& change) {
  return lagrangian(varied(g0, change), over<Dual<S>>(g1)).part[0];
}

}  // namespace

STATEMENT(thm_4_3_1, "the Legendre maps commute with the quotient maps") {
  claim.holds(
      "With the momentum $D_1\\mathbb L$ of (4.7) above and $R_f^*\\ell'$ below; physical momenta "
      "have the other sign in both. Regularity is not needed for the square, only for the maps in "
      "it to be local diffeomorphisms.");
  over_groups(groups_for_squares<S>(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw_configurations<S>(draw, group, 3);
    auto const f = relative_motions_right(GroupElements<S>{g[0], g[1]}).front(),
               f_left = relative_motions_left(GroupElements<S>{g[0], g[1]}).front();
    // Right-invariant: along the top, then down; down, then along the bottom.
    auto const above = covector<S>(
        group, [&](auto const& e) { return first_slope(lifted(l), g[0], g[1], from_left(e, g[0])); });
    auto const below = covector<S>(group, [&](auto const& e) { return slope(l, f, from_left(e, f)); });
    claim.equal("right-invariant", model, above, below, 10);
    claim.equal("the library: along the top", model, D1(lifted(l), g[0], g[1]), above);
    claim.equal("the library: along the bottom", model, right_differential(l, f), below);
    // Left-invariant: the quotient of T*G is translation on the left.
    auto const above_left = covector<S>(
        group, [&](auto const& e) { return first_slope(lifted_left(l), g[0], g[1], from_right(g[0], e)); });
    claim.equal("left-invariant", model, above_left,
                covector<S>(group, [&](auto const& e) { return slope(l, f_left, from_right(f_left, e)); }),
                10);
    // Controls: translation on the other side; a Lagrangian that is not invariant, whose momentum depends on
    // the pair above a relative motion.
    claim.differs(
        "the quotient of T*G on the other side", model,
        covector<S>(group,
                    [&](auto const& e) { return first_slope(lifted(l), g[0], g[1], from_right(g[0], e)); }),
        below);
    auto const any = draw_pair_polynomial<S>(draw, group);
    claim.differs("no invariance", model, D1(any, g[0] * g[2], g[1] * g[2]), D1(any, g[0], g[1]));
  });
}

STATEMENT(eq_4_6, "the commuting square of Legendre and quotient maps") {
  claim.holds(
      "For both Legendre maps, that of the momentum before the step and that of the momentum after it.");
  over_groups(groups_for_squares<S>(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw_configurations<S>(draw, group, 2);
    auto const f = relative_motions_right(g).front();
    claim.equal("before the step: D_1 above, R* below", model, D1(lifted(l), g[0], g[1]),
                right_differential(l, f), 10);
    claim.equal("after the step: D_2 above, -L* below", model, D2(lifted(l), g[0], g[1]),
                -left_differential(l, f), 10);
    claim.differs("D_2 above, R* below", model, D2(lifted(l), g[0], g[1]), right_differential(l, f));
    // Both maps along the square are local diffeomorphisms together: their second derivatives differ by Ad.
    // Condition: configurations are inverted.
    Matrix<S> const above = mixed_derivative(lifted(l), g[0], g[1]), below = right_second_differential(l, f);
    claim.zero("D_2 D_1 L = -(R* l')' Ad_f", model, Matrix<S>(above + below * Ad_matrix(f)),
               S(magnitude(below) * magnitude(Ad_matrix(f))), 10);
    claim.refutes("without Ad", model, Matrix<S>(above + below), S(magnitude(above) + magnitude(below)));
  });
}

STATEMENT(eq_4_7, "the square in coordinates") {
  claim.holds(
      "As a square: with $p_k = \\partial\\mathbb L/\\partial g_k$ above and the same sign below. The "
      "physical momenta are minus these.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw_configurations<S>(draw, group, 2);
    auto const quotient = g[0] * inverse(g[1]);
    claim.equal("f, translated back by the later configuration", model, quotient * g[1], g[0]);
    // p is a form on matrices at g0; mu is p after translation by g0 on the right; and that is paired with
    // the change of f.
    auto const p = [&](Matrix<S> const& change) { return first_slope(lifted(l), g[0], g[1], change); };
    auto const mu = covector<S>(group, [&](auto const& e) { return p(from_left(e, g[0])); });
    claim.equal("mu from p, and from f", model, mu, right_differential(l, quotient), 10);
    claim.differs("f from the configurations in the other order", model, mu,
                  right_differential(l, g[1] * inverse(g[0])));
    claim.differs("p translated on the left", model,
                  covector<S>(group, [&](auto const& e) { return p(from_right(g[0], e)); }), mu);
  });
}

STATEMENT(eq_4_8, "the spatial momentum along the square, by the chain rule") {
  claim.corrected(R"(R_{g_k}^*\Bigl(R_{g_{k+1}}^*\frac{\partial\ell}{\partial f}\Bigr) = R_f^*\frac{)"
                  R"(\partial\ell}{\partial f})",
                  R"(R_{g_k}^*\Bigl(R_{g_{k+1}^{-1}}^*\frac{\partial\ell}{\partial f}\Bigr) = R_f^*\frac{)"
                  R"(\partial\ell}{\partial f})",
                  "The inverse is missing in the term between; the sentence after the equation has it. "
                  "Both ends are right, and the quotient map in the first term is that of pairs.");
  claim.maybe_scan();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw_configurations<S>(draw, group, 2);
    auto const f = relative_motions_right(g).front();
    Matrix<S> const back = inverse(g[1]).value;
    auto const between = [&](Matrix<S> const& translation) {
      return covector<S>(
          group, [&](auto const& e) { return slope(l, f, Matrix<S>(from_left(e, g[0]) * translation)); });
    };
    auto const mu = covector<S>(
        group, [&](auto const& e) { return first_slope(lifted(l), g[0], g[1], from_left(e, g[0])); });
    claim.equal("the term between", model, between(back), mu, 10);
    claim.equal("the last term", model,
                covector<S>(group, [&](auto const& e) { return slope(l, f, from_left(e, f)); }), mu, 10);
    claim.differs("as printed", model, between(g[1].value), mu);
  });
}

STATEMENT(claim_4_3_legendre_map_value, "the Legendre map of a right-invariant system is f -> R*_f l'(f)") {
  claim.holds(
      "As (4.7) and (4.8), with $p_k = \\partial\\mathbb L/\\partial g_k$: the groupoid's "
      "Legendre map at the source of an arrow. With $\\ell$ an action the physical momentum at "
      "the start of the step is minus its value. That of a left-invariant system, "
      "$L_f^*\\ell'(f)$, is the same map of the opposite groupoid.");
  over_groups(groups_for_squares<S>(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw_configurations<S>(draw, group, 2);
    auto const f = relative_motions_right(g).front();
    using Alone = GroupAsGroupoid<SpannedGroup>;
    auto const right = covector<S>(group, [&](auto const& e) { return slope(l, f, from_left(e, f)); });
    auto const left = covector<S>(group, [&](auto const& e) { return slope(l, f, from_right(f, e)); });
    // p_k, the slope of the discrete Lagrangian in its first argument, translated by g_k. Condition: a
    // configuration is inverted.
    auto const translated = covector<S>(
        group, [&](auto const& e) { return first_slope(lifted(l), g[0], g[1], from_left(e, g[0])); });
    claim.equal("R*_f l'(f) is p_k, translated", model, right, translated, 10);
    claim.equal("-R*_f l'(f) is the physical momentum at the start of the step", model,
                momentum_before_right(l, f), -translated, 10);
    claim.differs("R*_f l'(f) taken for the physical momentum", model, right, momentum_before_right(l, f));
    auto const at_source = [&](auto const& gamma) {
      return momentum(group, Vector<S>(legendre_at_source(gamma, l, f).components));
    };
    auto const at_target = [&](auto const& gamma) {
      return momentum(group, Vector<S>(legendre_at_target(gamma, l, f).components));
    };
    claim.equal("right: at the source, on the group", model, at_source(Alone{group}), right);
    claim.equal("left: at the source, on the opposite group", model, at_source(Opposite<Alone>{{group}}),
                left);
    claim.equal("at the target, on the group", model, at_target(Alone{group}), left);
    claim.equal("at the target, on the opposite group", model, at_target(Opposite<Alone>{{group}}), right);
    if (model != "Heisenberg")
      claim.differs("right and left taken for each other", model, at_target(Alone{group}), right);
  });
}

// ----
// Section 4.3, second part: symplectic forms on the corners of the square, and the two constructions of a
// Poisson structure on the group.
//
// Physical momenta, mu = -D_1 L = -R* l', so that the Legendre map pulls the canonical form with {q, p} = 1
// back to omega_L of (3.5). A tangent vector of T*G at (g, mu) is (theta, delta mu), all translated to the
// identity on the right.

namespace {

template <class S>
using Change = PairChange<SpannedGroup, S>;
/// A tangent vector of T*G.
template <class S>
struct Lift {
  Velocity<SpannedGroup, S> configuration;
  Momentum<SpannedGroup, S> momentum;
};
/// The canonical form: minus the differential of <mu, theta>, with d theta(u, v) = [theta_u, theta_v] for
/// theta = dg g^-1.
template <class S>
S canonical_form(Momentum<SpannedGroup, S> const& mu, Lift<S> const& u, Lift<S> const& v) {
  return pair(v.momentum, u.configuration) - pair(u.momentum, v.configuration) -
         pair(mu, bracket(u.configuration, v.configuration));
}
/// The image of a tangent vector of pairs under (g0, g1) -> (g0, -D_1 L).
template <class S, class L>
Lift<S> pushed(L const& lagrangian, GroupElement<S> const& g0, GroupElement<S> const& g1,
               Change<S> const& w) {
  auto const moved = D1(lagrangian, varied(g0, from_left(w.first, g0)), varied(g1, from_left(w.second, g1)));
  return {w.first, momentum(g0.group, Vector<S>(-rate(moved)))};
}
/// The lift of the leaf vector of eta to pairs that preserves the body momentum: g0 moves by eta, g1 so that
/// f moves in the leaf.
template <class S, class L>
Change<S> level_lift(L const& l, GroupElement<S> const& f, Velocity<SpannedGroup, S> const& eta) {
  return {eta, Ad(inverse(f), eta - leaf_vector(l, f, eta))};
}
/// A point of the leaves, with everything that the checks need.
template <class S>
struct Corner {
  MotionPolynomial<S> l;
  GroupElement<S> g0, g1, f;
  Momentum<SpannedGroup, S> mu;  // that of the body where the system is left-invariant
  Velocity<SpannedGroup, S> eta, zeta, u, v;
  double condition;  // l'' is inverted to find leaf vectors
};
template <class S>
Corner<S> draw_corner(Draw& draw, SpannedGroup const& group) {
  auto const l = draw_reduced_lagrangian<S>(draw, group);
  auto const g = draw_configurations<S>(draw, group, 2);
  auto const f = relative_motions_right(g).front();
  auto const eta = draw.template velocity<S>(group), zeta = draw.template velocity<S>(group);
  Matrix<S> const a = right_second_differential(l, f);
  double const condition = to_double(row_norm(a) * row_norm(inverse_matrix(a)));
  return {l,
          g[0],
          g[1],
          f,
          -right_differential(l, f),
          eta,
          zeta,
          leaf_vector(l, f, eta),
          leaf_vector(l, f, zeta),
          condition};
}
/// The form of the leaf on the corner's two vectors: that of the orbit, <mu, [eta, zeta]>, since the momentum
/// moves by -ad*.
template <class S>
S orbit_value(Corner<S> const& c) { return pair(c.mu, bracket(c.eta, c.zeta)); }
template <class S>
S scale_of(Corner<S> const& c) {
  return S(size_of(c.mu) * size_of(c.eta) * size_of(c.zeta) * Base<S>(c.f.group.dimension()));
}

}  // namespace

STATEMENT(claim_4_3_tangent_square, "the tangent maps of the square commute") {
  claim.holds();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const c = draw_corner<S>(draw, group);
    Change<S> const w{draw.template velocity<S>(group), draw.template velocity<S>(group)};
    Vector<S> const across =
        -(right_second_differential(c.l, c.f) * relative_variation_right(c.f, w.first, w.second).coordinates);
    Vector<S> const down = pushed(lifted(c.l), c.g0, c.g1, w).momentum.components;
    claim.zero("down and across, across and down", model, Vector<S>(across - down),
               S(magnitude(right_second_differential(c.l, c.f)) *
                 (size_of(w.first) + size_of(w.second) * magnitude(Ad_matrix(c.f)))),
               10);
    Vector<S> const other = -(right_second_differential(c.l, c.f) * (w.first - w.second).coordinates);
    claim.differs("the later configuration not carried by Ad", model, other, down);
  });
}

STATEMENT(eq_4_9, "symplectic forms under the Legendre maps and the projections") {
  claim.corrected(
      R"(\omega_\mu = (\pi^{-1})^*\omega_{\mathrm{can}},\quad \pi^{-1} = R^*_{g^{-1}}:\mathfrak )"
      R"(g^*\to T_g^*G)",
      R"(\omega_\mu = \sigma^*\omega_{\mathrm{can}},\quad \sigma(\mu') = (g', \mu')\ )"
      R"(\text{with}\ \mathrm{Ad}^*_{g'}\mu' = \mathrm{Ad}^*_g\mu)",
      "A fibre of $T^*G$ is Lagrangian: pulled back to it the canonical form is zero. The lift must "
      "preserve the momentum of the symmetry, the body momentum; then $g$ moves with $\\mu$. The row above "
      "holds with $\\omega_{\\mathbb L}$ of (3.5) put right, as in Theorem 4.3.2: $d\\theta^+$ with the "
      "printed $F\\mathbb L$, or the library's $d\\theta^-$ with $(g_k, -D_1\\mathbb L)$.");
  over_groups(groups_for_squares<S>(), claim, [&](auto const& group, auto const& model) {
    auto const c = draw_corner<S>(draw, group);
    // Along the top: any two tangent vectors.
    Change<S> const a{draw.template velocity<S>(group), draw.template velocity<S>(group)},
        b{draw.template velocity<S>(group), draw.template velocity<S>(group)};
    auto const A = pushed(lifted(c.l), c.g0, c.g1, a), B = pushed(lifted(c.l), c.g0, c.g1, b);
    S const size =
        size_of(A.momentum) * size_of(b.first) + size_of(B.momentum) * size_of(a.first) + size_of(c.mu);
    claim.zero("the Legendre map above pulls the canonical form back to omega_L", model,
               S(canonical_form(c.mu, A, B) - discrete_two_form(lifted(c.l), c.g0, c.g1, a, b)),
               S(size * Base<S>(group.dimension())), 30);
    auto const as_printed = [](Lift<S> const& w) { return Lift<S>{w.configuration, -w.momentum}; };
    S const by_printed_map = canonical_form(-c.mu, as_printed(A), as_printed(B)),
            form = discrete_two_form(lifted(c.l), c.g0, c.g1, a, b);
    claim.zero("by the printed +D_1 L to d theta+, the printed coordinates of (3.5)", model,
               S(by_printed_map + form), S(size * Base<S>(group.dimension())), 30);
    claim.refutes("by the printed +D_1 L to d theta-", model, S(by_printed_map - form),
                  S(size * Base<S>(group.dimension())));
    // Up the right side: vectors of the orbit, lifted with constant body momentum, and lifted within the
    // fibre.
    auto const w = [&](auto const& eta) { return -ad_star(eta, c.mu); };
    Lift<S> const up_eta{c.eta, w(c.eta)}, up_zeta{c.zeta, w(c.zeta)};
    claim.zero("the lift that preserves the body momentum", model,
               S(canonical_form(c.mu, up_eta, up_zeta) - orbit_value(c)), scale_of(c), 10);
    auto const still = velocity(group, Vector<S>(Vector<S>::Zero(group.dimension())));
    auto const fibre = several([&] {
      auto const x = draw.template velocity<S>(group), y = draw.template velocity<S>(group);
      return S(canonical_form(c.mu, Lift<S>{still, w(x)}, Lift<S>{still, w(y)}) - pair(c.mu, bracket(x, y)));
    });
    claim.refutes("as printed, within the fibre", model, fibre, size_of(c.mu));
    // Along the bottom: the leaf vectors go to vectors of the orbit.
    claim.zero("the Legendre map below takes leaf vectors to the orbit", model,
               Vector<S>(-(right_second_differential(c.l, c.f) * c.u.coordinates) - w(c.eta).components),
               S(magnitude(right_second_differential(c.l, c.f)) * size_of(c.u) + size_of(w(c.eta))),
               c.condition);
  });
}

STATEMENT(eq_4_10, "the symplectic form of a leaf in the group") {
  claim.convention(
      "With (3.5) put right, as in Theorem 4.3.2: along the printed $+R_f^*\\ell'$ it is the form of "
      "$\\omega = d\\theta^+$, along the physical momentum $-R_f^*\\ell'$ that of the library's "
      "$d\\theta^-$. The leaves are the components of the preimages of coadjoint orbits; the form is not "
      "degenerate, and goes with the bracket by reduction.");
  claim.same_slip_as("eq_3_5");
  over_groups(groups_for_squares<S>(), claim, [&](auto const& group, auto const& model) {
    auto const c = draw_corner<S>(draw, group);
    // Condition: the vectors come from an inverse of l'', and their generators from another elimination.
    claim.zero("omega_f(u, v) = omega_mu(TFl u, TFl v)", model,
               S(leaf_form(c.l, c.f, c.u, c.v) - orbit_value(c)), scale_of(c), c.condition);
    auto const image = [&](auto const& w) {
      return momentum(group, Vector<S>(right_second_differential(c.l, c.f) * w.coordinates));
    };
    claim.zero(
        "along +R*l': minus this form", model,
        S(kirillov_kostant_plus(right_differential(c.l, c.f), image(c.u), image(c.v)) + orbit_value(c)),
        scale_of(c), c.condition);
    // It belongs to the bracket: omega_f(X_a, v) = da(v) for the Hamiltonian vector field X_a = P da and v
    // along the leaf.
    Matrix<S> const p = reduced_bivector_right(c.l, c.f);
    auto const a = draw_reduced_lagrangian<S>(draw, group);
    Vector<S> const da = right_differential(a, c.f).components, field = p * da;
    claim.zero("the field of a function, put into the form, gives its differential along the leaf", model,
               S(leaf_form(c.l, c.f, velocity(group, field), c.v) - da.dot(c.v.coordinates)),
               S(magnitude(da) * size_of(c.v) * Base<S>(group.dimension()) + scale_of(c)), c.condition);
    claim.refutes(
        "with the sign of the other identification", model, several([&] {
          Vector<S> const db = right_differential(draw_reduced_lagrangian<S>(draw, group), c.f).components;
          return S(leaf_form(c.l, c.f, velocity(group, Vector<S>(p * db)), c.v) + db.dot(c.v.coordinates));
        }),
        S(size_of(c.v)));
    if (model != "Aff(1)")
      claim.template refuses<OutsideDomain>("a vector that leaves the leaf", model, [&] {
        leaf_form(c.l, c.f, draw.template velocity<S>(group), c.v);
      });
  });
}

STATEMENT(eq_4_11, "the form of a leaf through the unreduced forms") {
  claim.corrected(
      R"(\omega_f(u,v) = \omega_{\mathrm{can}}\bigl(T\pi^{-1}TF\ell\,u,\ T\pi^{-1}TF\ell\,v)"
      R"(\bigr),\quad T\pi^{-1} = TR^*_{g^{-1}})",
      R"(\omega_f(u,v) = \omega_{\mathrm{can}}\bigl(T\sigma\,TF\ell\,u,\ T\sigma\,TF\ell\,v)"
      R"(\bigr) = \omega_{\mathbb L}\bigl(TF\mathbb L^{-1}T\sigma\,TF\ell\,u,\ TF\mathbb )"
      R"(L^{-1}T\sigma\,TF\ell\,v\bigr))",
      "With the lift that preserves the body momentum, as in (4.9). Lifted within a fibre, as "
      "printed, both sides on the right are zero. Here $F\\ell = -R_f^*\\ell'$ and $F\\mathbb L = "
      "(g_k, -D_1\\mathbb L)$, with the library's $\\omega_{\\mathbb L}$; the printed ones go with "
      "(3.5) put right as $d\\theta^+$.");
  claim.same_slip_as("eq_4_9");
  over_groups(groups_for_squares<S>(), claim, [&](auto const& group, auto const& model) {
    auto const c = draw_corner<S>(draw, group);
    auto const U = level_lift(c.l, c.f, c.eta), V = level_lift(c.l, c.f, c.zeta);
    S const magnified = scale_of(c) + S(magnitude(right_second_differential(c.l, c.f)) *
                                        (size_of(c.u) * size_of(c.zeta) + size_of(c.v) * size_of(c.eta)));
    claim.zero(
        "through the canonical form", model,
        S(canonical_form(c.mu, pushed(lifted(c.l), c.g0, c.g1, U), pushed(lifted(c.l), c.g0, c.g1, V)) -
          orbit_value(c)),
        magnified, c.condition);
    claim.zero("through omega_L", model, S(discrete_two_form(lifted(c.l), c.g0, c.g1, U, V) - orbit_value(c)),
               magnified, c.condition);
    // As printed: g0 held, g1 such that f moves in the leaf.
    auto const within_the_fibre = [&](auto const& eta) {
      Change<S> const w{velocity(group, Vector<S>(Vector<S>::Zero(group.dimension()))),
                        Ad(inverse(c.f), -leaf_vector(c.l, c.f, eta))};
      return w;
    };
    auto const gap = several([&] {
      auto const x = draw.template velocity<S>(group), y = draw.template velocity<S>(group);
      return S(discrete_two_form(lifted(c.l), c.g0, c.g1, within_the_fibre(x), within_the_fibre(y)) -
               pair(c.mu, bracket(x, y)));
    });
    claim.refutes("as printed, within the fibre", model, gap, size_of(c.mu));
  });
}

STATEMENT(claim_4_3_reduced_form_lifts,
          "the form of a leaf on the images of invariant fields is omega_L on the fields") {
  claim.corrected(R"(\omega_f(u,v) = \omega_{\mathbb L}(U,V)\quad\text{for } G\text{-invariant } U, V )"
                  R"(\text{ with } u = T\pi_d U,\ v = T\pi_d V)",
                  R"(\omega_f(u,v) = \omega_{\mathbb L}(U,V)\quad\text{for such } U, V \text{ tangent to a )"
                  R"(level of the momentum map of the symmetry})",
                  "Invariant lifts of one vector differ by generators of the symmetry, and "
                  "$\\omega_{\\mathbb L}$ contracted with a generator is the differential of its momentum, "
                  "which vanishes on tangent vectors of a level only.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const c = draw_corner<S>(draw, group);
    auto const U = level_lift(c.l, c.f, c.eta), V = level_lift(c.l, c.f, c.zeta);
    S const magnified = scale_of(c) + S(magnitude(right_second_differential(c.l, c.f)) *
                                        (size_of(c.u) * size_of(c.zeta) + size_of(c.v) * size_of(c.eta)));
    claim.zero("tangent to the level", model,
               S(discrete_two_form(lifted(c.l), c.g0, c.g1, U, V) - orbit_value(c)), magnified, c.condition);
    // The level: the body momentum Ad*_{g0} mu is constant along U.
    auto const moved_g0 = varied(c.g0, from_left(U.first, c.g0));
    auto const body = Ad_star(moved_g0, -D1(lifted(c.l), moved_g0, varied(c.g1, from_left(U.second, c.g1))));
    claim.zero(
        "the lift preserves the body momentum", model, rate(body),
        S(magnitude(Ad_matrix(c.g0)) * size_of(c.mu) * (size_of(U.first) + size_of(U.second)) + magnified),
        c.condition);
    // As printed: any invariant lifts. Invariant is what moves both configurations by R(theta_0, theta_1);
    // add generators of right multiplication.
    auto const gap = several([&] {
      auto const by = draw.template velocity<S>(group);
      Change<S> const W{U.first + Ad(c.g0, by), U.second + Ad(c.g1, by)};
      auto const other = V.first + draw.template velocity<S>(group);
      Change<S> const same_image{other, Ad(inverse(c.f), other - c.v)};
      return S(discrete_two_form(lifted(c.l), c.g0, c.g1, W, same_image) - orbit_value(c));
    });
    claim.refutes("as printed, any lifts", model, gap, scale_of(c));
  });
}

STATEMENT(thm_4_3_2, "the bracket by discrete reduction is the bracket by pull-back along the Legendre map") {
  claim.convention(
      "With (3.5) put right. For $\\omega_{\\mathbb L} = d\\theta^+_{\\mathbb L}$, its printed "
      "coordinates, the theorem holds along the printed $R_f^*\\ell'$; for the library's "
      "$d\\theta^-_{\\mathbb L}$, along the physical momentum $-R_f^*\\ell'$. One form with the "
      "other map gives minus the bracket.");
  claim.same_slip_as("eq_3_5");
  over_groups(groups_for_squares<S>(), claim, [&](auto const& group, auto const& model) {
    auto const c = draw_corner<S>(draw, group);
    Matrix<S> const reduced = reduced_bivector_right(c.l, c.f),
                    back = inverse_matrix(Matrix<S>(-right_second_differential(c.l, c.f)));
    Matrix<S> const pulled = back * lie_poisson_tensor_plus(c.mu) * back.transpose();
    S const scale = magnitude(back) * size_of(c.mu) * magnitude(back) * S(Base<S>(group.dimension())) +
                    magnitude(reduced);
    claim.zero("right-invariant: the plus bracket", model, Matrix<S>(reduced - pulled), scale, c.condition);
    Matrix<S> const printed = legendre_bivector_right(c.l, c.f);
    // The bracket of d theta+ is minus that of d theta-.
    claim.zero("along the printed +R*l': the bracket by reduction of d theta+", model,
               Matrix<S>(printed - Matrix<S>(-reduced)), scale, c.condition);
    claim.differs("along the printed +R*l', by reduction of d theta-", model, printed, reduced);
    // Left-invariant: the minus bracket of the body momentum -L* l'.
    Matrix<S> const left = left_second_differential(c.l, c.f), back_left = inverse_matrix(left),
                    reduced_left = reduced_bivector_left(c.l, c.f);
    Matrix<S> const pulled_left =
        -(back_left * lie_poisson_tensor_plus(-left_differential(c.l, c.f)) * back_left.transpose());
    double const condition_left = to_double(row_norm(left) * row_norm(back_left));
    claim.zero("left-invariant: the minus bracket", model, Matrix<S>(reduced_left - pulled_left),
               S(magnitude(back_left) * magnitude(left) * magnitude(back_left) + magnitude(reduced_left)),
               condition_left);
    // Leaf by leaf: bracket and form are inverse to each other along the leaf.
    Vector<S> const image =
        reduced * right_differential(draw_reduced_lagrangian<S>(draw, group), c.f).components;
    claim.fact("the leaves are as large as the orbits", model,
               matrix_rank(reduced) == matrix_rank(Matrix<S>(lie_poisson_tensor_plus(c.mu))));
    claim.fact("the fields of functions are tangent to the leaf", model, [&] {
      try {
        leaf_form(c.l, c.f, velocity(group, image), c.v);
        return true;
      } catch (OutsideDomain const&) {
        return false;
      }
    }());
  });
}

// ----
// Section 4.3, third part: motions along the square: reconstruction, invariant leaves, and steps of different
// lengths.
//
// Orders are fitted in double, against power series of equations written out by hand (top_in_any_group.hpp).

namespace {

/// Three relative motions, configurations that have them, and a reduced Lagrangian of which they are a
/// motion.
template <class S>
struct Motion {
  GroupElements<S> f, g;
  MotionPolynomial<S> l;
};
template <class S>
Motion<S> draw_motion(Draw& draw, SpannedGroup const& group) {
  auto const f = draw_configurations<S>(draw, group, 3);
  return {f, configurations_right(draw.template element<S>(group), f),
          with_motions_right(draw_reduced_lagrangian<S>(draw, group), f)};
}
/// The Casimirs of the dual that are known in closed form: |mu|^2 for rotations; |p|^2 and <turn, p> for
/// motions of space; for GL(2) traces of powers of the matrix of mu.
template <class S>
Vector<S> casimirs(Momentum<SpannedGroup, S> const& mu) {
  auto const& c = mu.components;
  if (mu.group.name() == "SO(3)") return Vector<S>::Constant(1, c.dot(c));
  if (mu.group.name() == "SE(3)")
    return (Vector<S>(2) << c.tail(3).dot(c.tail(3)), c.head(3).dot(c.tail(3))).finished();
  if (mu.group.name() == "GL(2)") return (Vector<S>(2) << c[0] + c[3], c[0] * c[3] - c[1] * c[2]).finished();
  return Vector<S>(0);
}
/// Steps of the fits.
Refinement const few_steps{0.5, {16, 24, 32, 48, 64, 96}};
/// Momentum with the sign of a Lagrangian on the algebra, at a state of a top.
template <class S>
Momentum<SpannedGroup, S> momentum_of(TopInAnyGroup<S> const& top, State<SpannedGroup, S> const& at) {
  return momentum(top.group, Vector<S>(top.a * at.velocity.coordinates + top.b));
}

}  // namespace

STATEMENT(cor_4_3_1,
          "the discrete Lie-Poisson motion, reconstructed, is the image of the discrete Euler-Lagrange "
          "motion and approximates the Hamiltonian flow") {
  claim.corrected(
      R"(F\mathbb L:\ (g_k, g_{k+1})\mapsto(g_k, D_1\mathbb L(g_k, g_{k+1})))",
      R"(F\mathbb L:\ (g_k, g_{k+1})\mapsto(g_k, -D_1\mathbb L(g_k, g_{k+1})),\quad \mathbb L\text{ an )"
      R"(action})",
      "The image approximates the flow only with the minus, and with $h$ times the Lagrangian of the "
      "thesis. As printed an even Lagrangian runs backwards in time, any other follows the flow in neither "
      "direction. Configurations come by (3.14): the momenta alone do not tell them. The order is that of "
      "the discrete Lagrangian, here 2.");
  claim.same_slip_as("claim_3_2_legendre_limit");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_motion<S>(draw, group);
    for (int k = 0; k < 2; ++k)
      claim.zero("the configurations are a discrete Euler-Lagrange motion", model,
                 discrete_euler_lagrange(lifted(m.l), m.g[k], m.g[k + 1], m.g[k + 2]), momenta_of(m.l, m.f),
                 10);
    // Carry the first momentum along, and compare it with the Legendre map of the configurations.
    auto const first = momentum_before_right(m.l, m.f[0]);
    auto mu = first;
    for (int k = 0; k < 3; ++k) {
      // Condition: the momentum has been carried k times.
      auto const slope_above = D1(lifted(m.l), m.g[k], m.g[k + 1]);
      claim.equal("momenta", model, mu, -slope_above, 30);
      claim.differs("+D_1 L, as printed", model, mu, slope_above);
      mu = coadjoint(m.f[k], mu);
    }
    claim.differs("the momentum carried the other way", model, coadjoint(inverse(m.f[0]), first),
                  -D1(lifted(m.l), m.g[1], m.g[2]));
  });
  if (claim.fits_orders())
    for (auto const& group : limit_groups()) {
      auto const any = draw_top_without_weight<S>(draw, group);
      auto even = any;
      even.b.setZero();
      State<SpannedGroup, S> const v{draw.template element<S>(group), draw.template velocity<S>(group)};
      // From the momentum of a state: F L = sign D_1 L / divisor is solved for the relative motion, and the
      // image compared with the flow.
      struct Reading {
        double sign = -1, direction = 1;
        bool divided = false, forwards = true;
      };
      auto const errors = [&](TopInAnyGroup<S> const& top, Reading const& reading) {
        auto const exact = top.flow(v, S(reading.direction * few_steps.duration)).first;
        return few_steps.errors_of([&](int n, double h) {
          auto const l = natural_chart_lagrangian_right(reduced(top), h);
          auto configuration = v.configuration;
          auto mu = momentum_of(top, v);
          S const factor = S(-reading.sign * (reading.divided ? h : 1));
          auto f =
              exp(S(-h) * velocity(group, Vector<S>(top.inverse_a * ((factor * mu).components - top.b))));
          for (int k = 0; k < n; ++k) {
            f = relative_motion_from_momentum_right(l, factor * mu, f).value;
            mu = lie_poisson_update_right(f, mu);
            configuration = reconstruct_right(configuration, reading.forwards ? f : inverse(f));
          }
          return std::max(magnitude((configuration.value - exact.configuration.value).eval()),
                          size_of(mu - momentum_of(top, exact)));
        });
      };
      auto const steps = few_steps.step_lengths();
      claim.order("configuration and momentum against the Hamiltonian flow", group.name(), steps,
                  errors(any, {}), 2);
      claim.order("even l, +D_1 L as printed: against the flow backwards in time", group.name(), steps,
                  errors(even, {.sign = 1, .direction = -1}), 2);
      claim.refutes_order("even l, +D_1 L as printed", group.name(), steps, errors(even, {.sign = 1}), 2);
      claim.refutes_order("any l, +D_1 L as printed", group.name(), steps, errors(any, {.sign = 1}), 2);
      claim.refutes_order("any l, +D_1 L as printed: backwards in time", group.name(), steps,
                          errors(any, {.sign = 1, .direction = -1}), 2);
      claim.refutes_order("-D_1 of the Lagrangian in place of the action", group.name(), steps,
                          errors(any, {.divided = true}), 2);
      claim.refutes_order("reconstructed with f in place of its inverse", group.name(), steps,
                          errors(any, {.forwards = false}), 2);
    }
}

STATEMENT(claim_4_3_reconstruction_image,
          "momenta lifted along the quotient map against the image of the unreduced motion") {
  claim.convention(
      "The preimage of a momentum under the quotient map is a whole orbit of the symmetry. The lift is the "
      "image of the unreduced motion when the configurations come by (3.14), and then all momenta of the "
      "symmetry are conserved. Both Legendre maps have one sign, whichever it is.");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_motion<S>(draw, group);
    auto const c = draw.template element<S>(group);
    // The covector of T*G at a configuration that goes to mu under the quotient map, on all tangent vectors
    // g e_a; and that of the unreduced motion, its slope along the same matrices.
    auto const lifted_up = [&](GroupElement<S> const& g, Momentum<SpannedGroup, S> const& mu) {
      return covector<S>(group, [&](auto const& e) {
        Matrix<S> const spatial = from_right(g, e) * inverse(g).value;
        return S(pair(mu, velocity(group, group.vee(spatial))));
      });
    };
    auto const unreduced = [&](GroupElement<S> const& g0, GroupElement<S> const& g1) {
      return covector<S>(
          group, [&](auto const& e) { return S(-first_slope(lifted(m.l), g0, g1, from_right(g0, e))); });
    };
    // The momentum is carried, never read off from the relative motion of the step. Condition: it has been
    // carried k times, and configurations are inverted.
    auto mu = momentum_before_right(m.l, m.f[0]);
    auto g = m.g[0];
    auto const first = lifted_up(g, mu);
    for (int k = 0; k < 3; ++k) {
      auto const next = reconstruct_right(g, m.f[k]);
      auto const image = unreduced(g, next);
      claim.equal("the lift is the image of the unreduced motion, on matrices", model, lifted_up(g, mu),
                  image, 100);
      claim.equal("and through any other preimage", model, lifted_up(g * c, mu), unreduced(g * c, next * c),
                  100);
      claim.equal("configurations", model, g, m.g[k], 30);
      claim.equal("momentum of the symmetry along the lift", model, image, first, 100);
      claim.differs("the signs of the two Legendre maps different", model, -lifted_up(g, mu), image);
      if (k > 0)
        claim.differs("the momentum left as it was at the start", model,
                      lifted_up(g, momentum_before_right(m.l, m.f[0])), image);
      mu = coadjoint(m.f[k], mu), g = next;
    }
    // Controls: another configuration over the same momentum is on no motion with the first; the other side.
    auto const mu1 = momentum_before_right(m.l, m.f[1]);
    claim.differs("another configuration over the same momentum", model, lifted_up(m.g[1] * c, mu1), first);
    claim.differs("reconstructed with f in place of its inverse", model, lifted_up(m.f[0] * m.g[0], mu1),
                  first);
  });
}

STATEMENT(
    claim_4_3_invariant_leaves,
    "the reduced motion stays on the symplectic leaves of the group, which correspond to coadjoint orbits") {
  claim.convention(
      "Locally, as the structure is. A motion stays in the preimage of one coadjoint orbit under $F\\ell$, "
      "whose components are the leaves, and the tangent map of a step takes the tangent spaces of leaves "
      "to those of leaves. Where a preimage has several components, which of them a step leads to is "
      "decided by which of its solutions is taken.");
  claim.leaves(
      "That a step stays on the component on which it begins, for the solution near the last motion: shown "
      "are the preimage of the orbit and the tangent spaces.");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_motion<S>(draw, group);
    auto const other = draw_reduced_lagrangian<S>(draw, group);
    for (int k = 0; k < 2; ++k) {
      auto const mu = momentum_before_right(m.l, m.f[k]), next = momentum_before_right(m.l, m.f[k + 1]);
      claim.equal("the Legendre map takes the motion into one orbit", model, next, coadjoint(m.f[k], mu), 10);
      if (casimirs(mu).size() > 0) {
        auto const size = magnitude(casimirs(mu)) + size_of(mu) * size_of(mu);
        claim.zero("Casimirs, pulled back to the group", model, Vector<S>(casimirs(next) - casimirs(mu)),
                   S(size), 100);
        claim.refutes("Casimirs, pulled back along the Legendre map of another function", model,
                      Vector<S>(casimirs(momentum_before_right(other, m.f[k + 1])) -
                                casimirs(momentum_before_right(other, m.f[k]))),
                      S(size));
      }
      // The tangent of a step takes vectors of the leaf to vectors of the leaf: the generator moves with the
      // later configuration. Condition: l'' is inverted.
      auto const eta = draw.template velocity<S>(group);
      auto const u = leaf_vector(m.l, m.f[k], eta);
      auto const carried = Ad(inverse(m.f[k]), eta - u);
      Matrix<S> const t = euler_poincare_tangent_right(m.l, m.f[k], m.f[k + 1]),
                      a = right_second_differential(m.l, m.f[k + 1]);
      auto const after = leaf_vector(m.l, m.f[k + 1], carried);
      double const condition = to_double(row_norm(a) * row_norm(inverse_matrix(a)));
      claim.zero("the tangent of a step preserves the leaves", model,
                 Vector<S>(t * u.coordinates - after.coordinates),
                 S(magnitude(t) * size_of(u) + size_of(after)), condition);
      claim.refutes("with the generator left as it was", model,
                    Vector<S>(t * u.coordinates - leaf_vector(m.l, m.f[k + 1], eta).coordinates),
                    S(size_of(after)));
    }
    // The leaf's tangent space is the image of the bracket: A P = Pi_+ A^-T.
    Matrix<S> const a = right_second_differential(m.l, m.f[0]), p = legendre_bivector_right(m.l, m.f[0]),
                    pi = lie_poisson_tensor_plus(right_differential(m.l, m.f[0]));
    claim.fact("the image of the bracket is mapped onto the tangent space of the orbit", model, [&] {
      Matrix<S> both(a.rows(), 2 * a.cols());
      both << Matrix<S>(a * p), pi;
      return matrix_rank(both) == matrix_rank(pi) && matrix_rank(p) == matrix_rank(pi);
    }());
  });
}

STATEMENT(claim_4_3_time_step_legendre,
          "with a Lagrangian divided by the step, the Legendre map must be multiplied by it") {
  claim.corrected(R"((g_k, g_{k+1})\mapsto(g_k, \Delta t\cdot D_1\mathbb L(g_k, g_{k+1})))",
                  R"((g_k, g_{k+1})\mapsto(g_k, -\Delta t\cdot D_1\mathbb L(g_k, g_{k+1})))",
                  "The factor is right, and the minus of the physical momentum is missing. For a discrete "
                  "Lagrangian that is an action there is nothing to multiply, and steps may differ.");
  claim.same_slip_as("claim_3_2_legendre_limit");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    // A constant step: the motions are the same, brackets and forms are multiplied by constants.
    auto const m = draw_motion<S>(draw, group);
    S const h = ratio<S>(1, 7);
    auto const average = [&](auto const& f) { return decltype(m.l(f))(m.l(f) / h); };
    claim.zero("the same motion", model, euler_poincare_right(average, m.f[0], m.f[1]),
               S(momenta_of(m.l, m.f) / Base<S>(h)), 10);
    Matrix<S> const p = reduced_bivector_right(m.l, m.f[0]), q = reduced_bivector_right(average, m.f[0]),
                    a = right_second_differential(m.l, m.f[0]);
    double const condition = to_double(row_norm(a) * row_norm(inverse_matrix(a)));
    claim.equal("the bracket is multiplied by h", model, q, Matrix<S>(p * h), condition);
    // The momentum of the step, by the unreduced action on matrices.
    auto const physical = covector<S>(group, [&](auto const& e) {
      return S(-first_slope(lifted(m.l), m.g[0], m.g[1], from_left(e, m.g[0])));
    });
    auto const slope_of_average = right_differential(average, m.f[0]);
    claim.equal("-h D_1 of the average is the momentum of the step", model, S(-h) * slope_of_average,
                physical, 10);
    claim.differs("+h D_1, as printed", model, h * slope_of_average, physical);
    claim.differs("-D_1 of the average", model, -slope_of_average, physical);
    // Steps of different lengths: the momentum handed over is that of the action.
    S const longer = ratio<S>(2, 7);
    auto const handed = [&](S const& first, S const& second) {
      return first * left_differential(average, m.f[0]) - second * right_differential(average, m.f[1]);
    };
    claim.zero("steps h and h: the momentum at the end of one is that at the start of the next", model,
               handed(h, h), momenta_of(m.l, m.f), 10);
    claim.refutes("steps h and 2h, the same average", model, handed(h, longer), momenta_of(m.l, m.f));
  });
  if (claim.fits_orders())
    for (auto const& group : limit_groups()) {
      auto const top = draw_top_without_weight<S>(draw, group);
      State<SpannedGroup, S> const v{draw.template element<S>(group), draw.template velocity<S>(group)};
      auto const exact = momentum_of(top, top.flow(v, S(by_halves.duration)).first);
      // Steps of 2/3 and 4/3 of the mean in turn. Averages l_h/h: with the factor -h the momentum is matched,
      // without it -R*l'/h, as printed +h R*l'/h.
      enum class Map { right, without_factor, printed };
      auto const errors = [&](Map map) {
        return few_steps.errors_of([&](int n, double h) {
          S const sign(map == Map::printed ? -1 : 1);
          auto mu = sign * momentum_of(top, v);
          auto const xi = velocity(group, Vector<S>(top.inverse_a * (mu.components - top.b)));
          GroupElement<S> f = identity<S>(group);
          double before = 0;
          for (int k = 0; k < n; ++k) {
            double const step = k % 2 == 0 ? 2 * h / 3 : 4 * h / 3;
            auto const l = natural_chart_lagrangian_right(reduced(top), step);
            // D_2 of one average matches D_1 of the other
            if (map == Map::without_factor && k > 0) mu = S(step / before) * mu;
            f = relative_motion_from_momentum_right(l, mu, k == 0 ? exp(S(-step) * xi) : f).value;
            mu = lie_poisson_update_right(f, mu);
            before = step;
          }
          return size_of(sign * mu - exact);
        });
      };
      auto const steps = few_steps.step_lengths();
      claim.order("steps of two lengths in turn, with the factor -h", group.name(), steps, errors(Map::right),
                  2);
      claim.refutes_order("without the factor", group.name(), steps, errors(Map::without_factor), 2);
      claim.refutes_order("with the factor +h, as printed", group.name(), steps, errors(Map::printed), 2);
    }
}

// ----
// Section 4.3, fourth part: the same for left-invariant systems.
//
// The quotient of T*G is translation on the left, the spatial momentum is the one that is conserved, and the
// bracket the minus one. All tangent vectors are translated to the identity on the left: theta = g^-1 dg.

namespace {

/// The lift of a leaf vector u = df f^-1 of a left-invariant system: g0 moves by eta, g1 so that f moves by
/// u. To the identity on the right, as the discrete form has them.
template <class S>
Change<S> left_lift(Corner<S> const& c, Velocity<SpannedGroup, S> const& eta,
                    Velocity<SpannedGroup, S> const& u) {
  return {Ad(c.g0, eta), Ad(c.g1, Ad(c.f, eta) - u)};
}
/// The same of a left-invariant system: f moves so that the body momentum Pi = -L* l' moves by ad*_eta Pi.
template <class S>
Corner<S> draw_left_corner(Draw& draw, SpannedGroup const& group) {
  auto const l = draw_reduced_lagrangian<S>(draw, group);
  auto const g = draw_configurations<S>(draw, group, 2);
  auto const f = relative_motions_left(g).front();
  auto const pi = -left_differential(l, f);
  auto const eta = draw.template velocity<S>(group), zeta = draw.template velocity<S>(group);
  Matrix<S> const b = left_second_differential(l, f), back = inverse_matrix(b);
  auto const leaf = [&](Velocity<SpannedGroup, S> const& by) {
    return velocity(group, Vector<S>(-(back * ad_star(by, pi).components)));
  };
  double const condition = to_double(row_norm(b) * row_norm(back));
  return {l, g[0], g[1], f, pi, eta, zeta, leaf(eta), leaf(zeta), condition};
}

}  // namespace

STATEMENT(claim_4_3_left_forms, "the theorems of the section for left-invariant systems") {
  claim.convention(
      "The page prints no formula for them. They are analogous with (3.5), the sign of the physical "
      "momentum and the lift of (4.9) put right; here the lift keeps the spatial momentum. The bracket is "
      "the minus one, and the order of the factors in (3.14) and (3.17) changes as in (3.15) and (3.18).");
  claim.same_slip_as("eq_4_9");
  over_groups(groups_for_squares<S>(), claim, [&](auto const& group, auto const& model) {
    auto const c = draw_left_corner<S>(draw, group);
    auto const two_form = [&](Change<S> const& a, Change<S> const& b) {
      return discrete_two_form(lifted_left(c.l), c.g0, c.g1, a, b);
    };
    auto const U = left_lift(c, c.eta, c.u), V = left_lift(c, c.zeta, c.v);
    S const orbit = -orbit_value(c);
    S const scale = scale_of(c) + S(magnitude(left_second_differential(c.l, c.f)) *
                                    (size_of(c.u) * size_of(c.zeta) + size_of(c.v) * size_of(c.eta)));
    // (4.10), (4.11): omega_L on the lifts is the form of the orbit, -<Pi, [eta, zeta]>.
    claim.zero("(4.11), left: omega_L on the lifts is the form of the orbit", model,
               S(two_form(U, V) - orbit), scale, c.condition);
    claim.refutes("with the sign of a right-invariant system", model, several([&] {
                    auto const d = draw_left_corner<S>(draw, group);
                    return S(discrete_two_form(lifted_left(d.l), d.g0, d.g1, left_lift(d, d.eta, d.u),
                                               left_lift(d, d.zeta, d.v)) -
                             orbit_value(d));
                  }),
                  scale);
    // The lift keeps the spatial momentum. Condition: l'' is inverted.
    auto const moved_g0 = varied(c.g0, from_left(U.first, c.g0)),
               moved_g1 = varied(c.g1, from_left(U.second, c.g1));
    claim.zero("the lift keeps the spatial momentum", model, rate(D1(lifted_left(c.l), moved_g0, moved_g1)),
               S(magnitude(Ad_matrix(inverse(c.g0))) * size_of(c.mu)) + scale, c.condition);
    // The lift of (4.9) as printed: within the fibre, g0 held.
    auto const still = velocity(group, Vector<S>(Vector<S>::Zero(group.dimension())));
    if (model != "Aff(1)" || !exact_arithmetic<S>())
      claim.refutes("with the lift of (4.9) as printed, within the fibre", model,
                    S(two_form(left_lift(c, still, c.u), left_lift(c, still, c.v)) - orbit), scale_of(c));
    // Theorem 4.3.2: the bracket, by reduction and by pull-back of the minus bracket along -L* l'.
    Matrix<S> const reduced_bracket = reduced_bivector_left(c.l, c.f), b = left_second_differential(c.l, c.f),
                    back = inverse_matrix(b);
    auto const pulled_back = [&](Momentum<SpannedGroup, S> const& at) {
      return Matrix<S>(-(back * lie_poisson_tensor_plus(at) * back.transpose()));
    };
    S const size = magnitude(back) * size_of(c.mu) * magnitude(back) * S(Base<S>(group.dimension()));
    claim.zero("Theorem 4.3.2, left: the minus bracket", model,
               Matrix<S>(reduced_bracket - pulled_back(c.mu)), size, c.condition);
    claim.differs("along +L* l', by reduction of d theta-", model, pulled_back(-c.mu), reduced_bracket);
    // Bracket and form belong together: omega_f(P da, u) = da(u), where P da moves Pi by -B P da.
    Vector<S> const da = left_differential(draw_reduced_lagrangian<S>(draw, group), c.f).components;
    S const through = c.eta.coordinates.dot(b * (reduced_bracket * da));
    claim.zero("(4.10), left: the field of a function, put into the form, gives its differential", model,
               S(through - da.dot(c.u.coordinates)),
               S(magnitude(b) * magnitude(reduced_bracket) * magnitude(da) * size_of(c.eta) +
                 magnitude(da) * size_of(c.u)),
               c.condition);
    claim.refutes("with the bracket of the other sign", model, S(through + da.dot(c.u.coordinates)),
                  S(magnitude(da) * size_of(c.u)));
  });
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    // Corollary 4.3.1 and (4.6): lifts of the carried momenta, covectors at g_k on all e_a g_k.
    auto const f = draw_configurations<S>(draw, group, 3);
    auto const l = with_motions_left(draw_reduced_lagrangian<S>(draw, group), f);
    auto const g = configurations_left(draw.template element<S>(group), f);
    auto pi = momentum_before_left(l, f[0]);
    for (int k = 0; k < 3; ++k) {
      auto const image = covector<S>(group, [&](auto const& e) {
        return S(-first_slope(lifted_left(l), g[k], g[k + 1], from_left(e, g[k])));
      });
      // Condition: the momentum has been carried k times.
      claim.equal("Corollary 4.3.1, left: the lift is the image of the unreduced motion", model,
                  coadjoint(inverse(g[k]), pi), image, 100);
      claim.differs("carried to the other side", model, coadjoint(g[k], pi), image);
      pi = lie_poisson_update_left(f[k], pi);
    }
  });
  if (claim.fits_orders())
    for (auto const& group : limit_groups()) {
      auto const mirror = draw_top_without_weight<S>(draw, group);
      // A left-invariant motion: the inverse of the configuration moves by the right-invariant system with
      // the opposite linear term.
      auto left = mirror;
      left.b = -mirror.b;
      State<SpannedGroup, S> const v{draw.template element<S>(group), draw.template velocity<S>(group)};
      auto const errors = [&](double sign, double direction) {
        auto const end = mirror.flow(v, S(direction * few_steps.duration)).first;
        auto const momentum_at = [&](State<SpannedGroup, S> const& at) {
          return momentum_of(left, State<SpannedGroup, S>{at.configuration, -at.velocity});
        };
        return few_steps.errors_of([&](int n, double h) {
          auto const l = natural_chart_lagrangian_left(reduced(left), h);
          auto configuration = inverse(v.configuration);
          auto pi = momentum_at(v);
          auto f =
              exp(S(-h) * velocity(group, Vector<S>(left.inverse_a * (S(-sign) * pi.components - left.b))));
          for (int k = 0; k < n; ++k) {
            f = relative_motion_from_momentum_left(l, S(-sign) * pi, f).value;
            pi = lie_poisson_update_left(f, pi), configuration = reconstruct_left(configuration, f);
          }
          return std::max(magnitude((configuration.value - inverse(end.configuration).value).eval()),
                          size_of(pi - momentum_at(end)));
        });
      };
      auto const steps = few_steps.step_lengths();
      claim.order("Corollary 4.3.1, left: against the Hamiltonian flow", group.name(), steps, errors(-1, 1),
                  2);
      claim.refutes_order("with +D_1 L", group.name(), steps, errors(1, 1), 2);
      claim.refutes_order("with +D_1 L, backwards in time", group.name(), steps, errors(1, -1), 2);
    }
}
