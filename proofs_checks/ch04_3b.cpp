// Section 4.3, second part: symplectic forms on the corners of the square, and the two constructions of a Poisson structure on the group. Compiled once per scalar.
//
// Physical momenta, mu = -D_1 L = -R* l', so that the Legendre map pulls the canonical form with {q, p} = 1 back to omega_L of (3.5).
// A tangent vector of T*G at (g, mu) is (theta, delta mu), all carried to the identity on the right. Degrees: as in ch03_2b.cpp.
#include "actio/groupoid/poisson_on_group.hpp"
#include "actio/reduction/discrete_poisson.hpp"
#include "sequences.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

template <class S>
using Change = PairChange<SpannedGroup, S>;
/// A tangent vector of T*G.
template <class S>
struct Lift {
  Velocity<SpannedGroup, S> place;
  Momentum<SpannedGroup, S> momentum;
};
/// The canonical form: minus the differential of <mu, theta>, with d theta(u, v) = [theta_u, theta_v] for theta = dg g^-1.
template <class S>
S canonical_form(Momentum<SpannedGroup, S> const& mu, Lift<S> const& u, Lift<S> const& v) {
  return pair(v.momentum, u.place) - pair(u.momentum, v.place) - pair(mu, bracket(u.place, v.place));
}
/// The image of a tangent vector of pairs under (g0, g1) -> (g0, -D_1 L).
template <class S, class L>
Lift<S> pushed(L const& lagrangian, Place<S> const& g0, Place<S> const& g1, Change<S> const& w) {
  auto const moved = D1(lagrangian, varied(g0, from_left(w.first, g0)), varied(g1, from_left(w.second, g1)));
  return {w.first, momentum(g0.group, Vector<S>(-rate(moved)))};
}
/// The lift of the leaf vector of eta to pairs that keeps the body momentum: g0 moves along eta, g1 so that f moves along the leaf.
template <class S, class L>
Change<S> kept(L const& l, Place<S> const& f, Velocity<SpannedGroup, S> const& eta) {
  return {eta, Ad(inverse(f), eta - leaf_vector(l, f, eta))};
}
/// A point of the leaves, with everything that the checks need.
template <class S>
struct Corner {
  MotionPolynomial<S> l;
  Place<S> g0, g1, f;
  Momentum<SpannedGroup, S> mu;
  Velocity<SpannedGroup, S> eta, zeta, u, v;
  double condition;  // l'' is inverted to find leaf vectors
};
template <class S>
Corner<S> draw_corner(Draw& draw, SpannedGroup const& group) {
  auto const l = draw_reduced_lagrangian<S>(draw, group);
  auto const g = draw_places<S>(draw, group, 2);
  auto const f = relative_motions_right(g).front();
  auto const eta = draw.template velocity<S>(group), zeta = draw.template velocity<S>(group);
  Matrix<S> const a = right_second_differential(l, f);
  double const condition = to_double(row_norm(a) * row_norm(inverse_matrix(a)));
  return {l, g[0], g[1], f, -right_differential(l, f), eta, zeta, leaf_vector(l, f, eta), leaf_vector(l, f, zeta), condition};
}
/// The form of the leaf on the corner's two vectors: that of the orbit, <mu, [eta, zeta]>, since the momentum moves by -ad*.
template <class S>
S orbit_value(Corner<S> const& c) {
  return pair(c.mu, bracket(c.eta, c.zeta));
}
template <class S>
S scale_of(Corner<S> const& c) {
  return S(size_of(c.mu) * size_of(c.eta) * size_of(c.zeta) * Base<S>(c.f.group.dimension()));
}

}  // namespace

STATEMENT(claim_4_3_tangent_square, "the tangent maps of the square commute") {
  claim.holds();
  claim.degree(800);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const c = draw_corner<S>(draw, group);
    Change<S> const w{draw.template velocity<S>(group), draw.template velocity<S>(group)};
    Vector<S> const across = -(right_second_differential(c.l, c.f) * relative_variation_right(c.f, w.first, w.second).coordinates);
    Vector<S> const down = pushed(lifted(c.l), c.g0, c.g1, w).momentum.components;
    claim.zero("down and across, across and down", model, Vector<S>(across - down), S(magnitude(right_second_differential(c.l, c.f)) * (size_of(w.first) + size_of(w.second) * magnitude(Ad_matrix(c.f)))), 10);
    Vector<S> const other = -(right_second_differential(c.l, c.f) * (w.first - w.second).coordinates);
    claim.differs("the later place not carried by Ad", model, other, down);
  });
}

STATEMENT(eq_4_9, "symplectic forms under the Legendre maps and the projections") {
  claim.corrected(R"(\omega_\mu = (\pi^{-1})^*\omega_{\mathrm{can}},\quad \pi^{-1} = R^*_{g^{-1}}:\mathfrak g^*\to T_g^*G)",
                  R"(\omega_\mu = \sigma^*\omega_{\mathrm{can}},\quad \sigma(\mu') = (g', \mu')\ \text{with}\ \mathrm{Ad}^*_{g'}\mu' = \mathrm{Ad}^*_g\mu)",
                  "A fibre of T*G is Lagrangian: pulled back to it the canonical form is zero. The lift must keep the momentum of the symmetry, the body momentum; then g moves with mu.");
  claim.degree(2000);
  over_groups(groups_for_squares<S>(), claim, [&](auto const& group, auto const& model) {
    auto const c = draw_corner<S>(draw, group);
    // Along the top: any two tangent vectors.
    Change<S> const a{draw.template velocity<S>(group), draw.template velocity<S>(group)}, b{draw.template velocity<S>(group), draw.template velocity<S>(group)};
    auto const A = pushed(lifted(c.l), c.g0, c.g1, a), B = pushed(lifted(c.l), c.g0, c.g1, b);
    S const size = size_of(A.momentum) * size_of(b.first) + size_of(B.momentum) * size_of(a.first) + size_of(c.mu);
    claim.zero("the Legendre map above pulls the canonical form back to omega_L", model, S(canonical_form(c.mu, A, B) - discrete_two_form(lifted(c.l), c.g0, c.g1, a, b)), S(size * Base<S>(group.dimension())), 30);
    // Up the right side: vectors of the orbit, lifted with the body momentum kept, and lifted within the fibre.
    auto const w = [&](auto const& eta) { return -ad_star(eta, c.mu); };
    Lift<S> const up_eta{c.eta, w(c.eta)}, up_zeta{c.zeta, w(c.zeta)};
    claim.zero("the lift that keeps the body momentum", model, S(canonical_form(c.mu, up_eta, up_zeta) - orbit_value(c)), scale_of(c), 10);
    auto const still = velocity(group, Vector<S>(Vector<S>::Zero(group.dimension())));
    auto const fibre = several([&] {
      auto const x = draw.template velocity<S>(group), y = draw.template velocity<S>(group);
      return S(canonical_form(c.mu, Lift<S>{still, w(x)}, Lift<S>{still, w(y)}) - pair(c.mu, bracket(x, y)));
    });
    claim.refutes("as printed, within the fibre", model, fibre, size_of(c.mu));
    // Along the bottom: the leaf vectors go to vectors of the orbit.
    claim.zero("the Legendre map below takes leaf vectors to the orbit", model, Vector<S>(-(right_second_differential(c.l, c.f) * c.u.coordinates) - w(c.eta).components),
               S(magnitude(right_second_differential(c.l, c.f)) * size_of(c.u) + size_of(w(c.eta))), c.condition);
  });
}

STATEMENT(eq_4_10, "the symplectic form of a leaf in the group") {
  claim.holds("A leaf is where the Legendre map meets a coadjoint orbit; the form is closed because that of the orbit is, and it is not degenerate.");
  claim.degree(2000);
  over_groups(groups_for_squares<S>(), claim, [&](auto const& group, auto const& model) {
    auto const c = draw_corner<S>(draw, group);
    // Condition: the vectors come from an inverse of l'', and their generators from another elimination.
    claim.zero("omega_f(u, v) = omega_mu(TFl u, TFl v)", model, S(leaf_form(c.l, c.f, c.u, c.v) - orbit_value(c)), scale_of(c), c.condition);
    // It belongs to the bracket: omega_f(X_a, v) = da(v) for the Hamiltonian vector field X_a = P da and v along the leaf.
    Matrix<S> const p = reduced_bivector_right(c.l, c.f);
    auto const a = draw_reduced_lagrangian<S>(draw, group);
    Vector<S> const da = right_differential(a, c.f).components, field = p * da;
    claim.zero("the field of a function, put into the form, gives its differential along the leaf", model, S(leaf_form(c.l, c.f, velocity(group, field), c.v) - da.dot(c.v.coordinates)),
               S(magnitude(da) * size_of(c.v) * Base<S>(group.dimension()) + scale_of(c)), c.condition);
    claim.refutes("with the sign of the other identification", model, several([&] {
                    Vector<S> const db = right_differential(draw_reduced_lagrangian<S>(draw, group), c.f).components;
                    return S(leaf_form(c.l, c.f, velocity(group, Vector<S>(p * db)), c.v) + db.dot(c.v.coordinates));
                  }), S(size_of(c.v)), 1e-4);
    if (model != "Aff(1)")
      claim.template refuses<OutsideDomain>("a vector that leaves the leaf", model, [&] { leaf_form(c.l, c.f, draw.template velocity<S>(group), c.v); });
  });
}

STATEMENT(eq_4_11, "the form of a leaf through the unreduced forms") {
  claim.corrected(R"(\omega_f(u,v) = \omega_{\mathrm{can}}\bigl(T\pi^{-1}TF\ell\,u,\ T\pi^{-1}TF\ell\,v\bigr),\quad T\pi^{-1} = TR^*_{g^{-1}})",
                  R"(\omega_f(u,v) = \omega_{\mathrm{can}}\bigl(T\sigma\,TF\ell\,u,\ T\sigma\,TF\ell\,v\bigr) = \omega_{\mathbb L}\bigl(TF\mathbb L^{-1}T\sigma\,TF\ell\,u,\ TF\mathbb L^{-1}T\sigma\,TF\ell\,v\bigr))",
                  "With the lift that keeps the body momentum, as in (4.9). Lifted within a fibre, as printed, both sides on the right are zero.");
  claim.degree(2000);
  over_groups(groups_for_squares<S>(), claim, [&](auto const& group, auto const& model) {
    auto const c = draw_corner<S>(draw, group);
    auto const U = kept(c.l, c.f, c.eta), V = kept(c.l, c.f, c.zeta);
    S const magnified = scale_of(c) + S(magnitude(right_second_differential(c.l, c.f)) * (size_of(c.u) * size_of(c.zeta) + size_of(c.v) * size_of(c.eta)));
    claim.zero("through the canonical form", model, S(canonical_form(c.mu, pushed(lifted(c.l), c.g0, c.g1, U), pushed(lifted(c.l), c.g0, c.g1, V)) - orbit_value(c)), magnified, c.condition);
    claim.zero("through omega_L", model, S(discrete_two_form(lifted(c.l), c.g0, c.g1, U, V) - orbit_value(c)), magnified, c.condition);
    // As printed: g0 held, g1 such that f moves along the leaf.
    auto const within_the_fibre = [&](auto const& eta) {
      Change<S> const w{velocity(group, Vector<S>(Vector<S>::Zero(group.dimension()))), Ad(inverse(c.f), -leaf_vector(c.l, c.f, eta))};
      return w;
    };
    auto const gap = several([&] {
      auto const x = draw.template velocity<S>(group), y = draw.template velocity<S>(group);
      return S(discrete_two_form(lifted(c.l), c.g0, c.g1, within_the_fibre(x), within_the_fibre(y)) - pair(c.mu, bracket(x, y)));
    });
    claim.refutes("as printed, within the fibre", model, gap, size_of(c.mu));
  });
}

STATEMENT(claim_4_3_reduced_form_lifts, "the form of a leaf on the images of invariant fields is omega_L on the fields") {
  claim.corrected(R"(\omega_f(u,v) = \omega_{\mathbb L}(U,V)\quad\text{for } G\text{-invariant } U, V \text{ with } u = T\pi_d U,\ v = T\pi_d V)",
                  R"(\omega_f(u,v) = \omega_{\mathbb L}(U,V)\quad\text{for such } U, V \text{ tangent to a level of the momentum map of the symmetry})",
                  "Invariant lifts of one vector differ by generators of the symmetry, and $\\omega_{\\mathbb L}$ sees these: it is the differential of the momentum map on them. Tangent to its level they do no harm.");
  claim.degree(2000);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const c = draw_corner<S>(draw, group);
    auto const U = kept(c.l, c.f, c.eta), V = kept(c.l, c.f, c.zeta);
    S const magnified = scale_of(c) + S(magnitude(right_second_differential(c.l, c.f)) * (size_of(c.u) * size_of(c.zeta) + size_of(c.v) * size_of(c.eta)));
    claim.zero("tangent to the level", model, S(discrete_two_form(lifted(c.l), c.g0, c.g1, U, V) - orbit_value(c)), magnified, c.condition);
    // The level: the body momentum Ad*_{g0} mu does not move along U.
    auto const moved_g0 = varied(c.g0, from_left(U.first, c.g0));
    auto const body = Ad_star(moved_g0, -D1(lifted(c.l), moved_g0, varied(c.g1, from_left(U.second, c.g1))));
    claim.zero("the lift keeps the body momentum", model, rate(body), S(magnitude(Ad_matrix(c.g0)) * size_of(c.mu) * (size_of(U.first) + size_of(U.second)) + magnified), c.condition);
    // As printed: any invariant lifts. Invariant is what moves both places by R(theta_0, theta_1); add generators of right multiplication.
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
  claim.convention("With the momentum for which the Legendre map pulls the canonical form back to $\\omega_{\\mathbb L}$: with that of (3.5) and $\\{q, p\\} = 1$ it is $-D_1\\mathbb L$ above and $-R_f^*\\ell'$ below. With the $+D_1\\mathbb L$ of (4.7) the one is minus the other.");
  claim.degree(3000);
  over_groups(groups_for_squares<S>(), claim, [&](auto const& group, auto const& model) {
    auto const c = draw_corner<S>(draw, group);
    Matrix<S> const reduced = reduced_bivector_right(c.l, c.f), back = inverse_matrix(Matrix<S>(-right_second_differential(c.l, c.f)));
    Matrix<S> const pulled = back * lie_poisson_tensor_plus(c.mu) * back.transpose();
    S const scale = magnitude(back) * size_of(c.mu) * magnitude(back) * S(Base<S>(group.dimension())) + magnitude(reduced);
    claim.zero("right-invariant: the plus bracket", model, Matrix<S>(reduced - pulled), scale, c.condition);
    claim.zero("along +R*l': minus the reduced bracket", model, Matrix<S>(reduced + Matrix<S>(legendre_bivector_right(c.l, c.f))), scale, c.condition);
    claim.refutes("along +R*l', the reduced bracket itself", model, Matrix<S>(reduced - Matrix<S>(legendre_bivector_right(c.l, c.f))), scale, 1e-5);
    // Left-invariant: the minus bracket of the body momentum -L* l'.
    Matrix<S> const left = left_second_differential(c.l, c.f), back_left = inverse_matrix(left), reduced_left = reduced_bivector_left(c.l, c.f);
    Matrix<S> const pulled_left = -(back_left * lie_poisson_tensor_plus(-left_differential(c.l, c.f)) * back_left.transpose());
    double const condition_left = to_double(row_norm(left) * row_norm(back_left));
    claim.zero("left-invariant: the minus bracket", model, Matrix<S>(reduced_left - pulled_left), S(magnitude(back_left) * magnitude(left) * magnitude(back_left) + magnitude(reduced_left)), condition_left);
    // Leaf by leaf: bracket and form are inverse to each other along the leaf.
    Vector<S> const image = reduced * right_differential(draw_reduced_lagrangian<S>(draw, group), c.f).components;
    claim.fact("the leaves are as large as the orbits", model, matrix_rank(reduced) == matrix_rank(Matrix<S>(lie_poisson_tensor_plus(c.mu))));
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
