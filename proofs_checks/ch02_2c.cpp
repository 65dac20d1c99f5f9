// Scalars: rational, double (long: dec50, dec100)
// Section 2.2: coadjoint orbits, their symplectic forms, and motion along them. Compiled once per scalar.
//
// Degrees: an element is a product of at most three quotients of polynomials of degree 4, Ad of it has degree 48; the generator of a tangent vector comes from eliminating at most six
// unknowns.
#include "actio/variational/coadjoint_orbit.hpp"
#include "actio/variational/curves.hpp"
#include "actio/variational/hamilton.hpp"
#include "actio/variational/lie_poisson.hpp"
#include "charts.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

constexpr int degree_bound = 1500;
/// Finding the generator of a tangent vector inverts ad* mu on its image, whose condition is below 100 for generic momenta of order 1.
constexpr double orbit_condition = 100;

/// Dimension of the span of some vectors.
template <class S>
int rank_of(Matrix<S> m) {
  int rank = 0;
  Base<S> const floor = Base<S>(1000) * epsilon<S>() * magnitude(m);
  for (Eigen::Index c = 0; c < m.cols() && rank < m.rows(); ++c) {
    Eigen::Index best = rank;
    for (Eigen::Index i = rank; i < m.rows(); ++i)
      if (magnitude(m(i, c)) > magnitude(m(best, c))) best = i;
    if (!(magnitude(m(best, c)) > floor)) continue;
    m.row(rank).swap(m.row(best));
    for (Eigen::Index i = rank + 1; i < m.rows(); ++i) m.row(i) -= (m.row(rank) * S(m(i, c) / m(rank, c))).eval();
    ++rank;
  }
  return rank;
}

}  // namespace

STATEMENT(claim_2_2_coadjoint_orbits, "coadjoint orbits lie in the dual algebra, and are symplectic") {
  claim.corrected(R"(\mathcal O \subset \mathfrak g)", R"(\mathcal O \subset \mathfrak g^*)",
                  "The orbit of a momentum under the coadjoint action lies in the dual of the algebra. Orbits in the algebra itself can "
                  "have odd dimension, and their tangent vectors are others.");
  claim.maybe_scan();
  claim.degree(degree_bound);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const curve = draw_curve<S>(draw, group);
    auto const mu = draw.template momentum<S>(group);
    S const t = ratio<S>(1, 3);
    Dual<S> time(t);
    time.part[0] = S(1);
    auto const here = Ad_star(inverse(curve(t)), mu);

    // The orbit through mu: its tangent vectors are ad* of velocities, whatever the curve in G.
    auto const tangent_vector = rate(Ad_star(inverse(curve(time)), over<Dual<S>>(mu)));
    claim.equal("tangent vectors are ad*", model, ad_star(orbit_generator(here, tangent_vector), here), tangent_vector, orbit_condition);
    // The form is well defined: the generators that the library finds give what any others give.
    auto const xi = draw.template velocity<S>(group), eta = draw.template velocity<S>(group), zeta = draw.template velocity<S>(group);
    auto const v = ad_star(xi, here), w = ad_star(eta, here);
    auto const form = kirillov_kostant_plus(here, v, w);
    claim.equal("the form does not depend on the generators", model, form, pair(here, bracket(xi, eta)), orbit_condition);
    claim.equal("antisymmetric", model, kirillov_kostant_plus(here, w, v), S(-form), orbit_condition);
    // Not degenerate: its rank is the dimension of the orbit, an even number.
    auto const form_matrix = lie_poisson_tensor_plus(here);
    Matrix<S> tangents(group.dimension(), group.dimension()), adjoint(group.dimension(), group.dimension());
    for (int a = 0; a < group.dimension(); ++a) {
      tangents.col(a) = ad_star(basis_velocity<S>(group, a), here).components;
      adjoint.col(a) = bracket(basis_velocity<S>(group, a), xi).coordinates;
    }
    claim.fact("rank of the form = dimension of the orbit, even", model,
               rank_of(Matrix<S>(form_matrix)) == rank_of(tangents) && rank_of(tangents) % 2 == 0);
    // Closed: the cyclic sum of rates along the fields ad*, which bracket like the algebra.
    auto const moved_momentum = [&](Velocity<SpannedGroup, S> const& x) {
      return Momentum<SpannedGroup, Dual<S>>{group, moving(here.components, ad_star(x, here).components)};
    };
    auto const rate_of_form = [&](auto const& x, auto const& y, auto const& z) {
      return pair(moved_momentum(x), bracket(over<Dual<S>>(y), over<Dual<S>>(z))).part[0];
    };
    auto const on_bracket = [&](auto const& x, auto const& y, auto const& z) {
      return kirillov_kostant_plus(here, ad_star(bracket(x, y), here), ad_star(z, here));
    };
    // Both sums vanish by the identity of Jacobi, so the sign with which the fields bracket does not matter.
    S const closed = rate_of_form(xi, eta, zeta) + rate_of_form(eta, zeta, xi) + rate_of_form(zeta, xi, eta);
    S const brackets = on_bracket(xi, eta, zeta) + on_bracket(eta, zeta, xi) + on_bracket(zeta, xi, eta);
    S const size = size_of(rate_of_form(xi, eta, zeta)) + size_of(rate_of_form(eta, zeta, xi)) + size_of(on_bracket(xi, eta, zeta));
    claim.zero("closed", model, closed, size);
    claim.zero("closed, terms with brackets", model, brackets, size, orbit_condition);

    // The form belongs to the bracket: omega_+(X_f, X_h) = {f, h}_+, which leaves no choice for it.
    auto const f = draw_algebra_polynomial<S>(draw, group.dimension()), h = draw_algebra_polynomial<S>(draw, group.dimension());
    S const plus = lie_poisson_bracket_plus(f, h, here);
    claim.equal("omega_+ of Hamiltonian fields is the plus bracket", model,
                kirillov_kostant_plus(here, lie_poisson_rate_right(f, here), lie_poisson_rate_right(h, here)), plus, orbit_condition);
    claim.equal("omega_- and the minus bracket", model,
                kirillov_kostant_minus(here, lie_poisson_rate_left(f, here), lie_poisson_rate_left(h, here)), S(-plus), orbit_condition);
    claim.differs("omega_- for the plus bracket", model,
                  kirillov_kostant_minus(here, lie_poisson_rate_right(f, here), lie_poisson_rate_right(h, here)), plus);
    // Control: orbits in the algebra, as printed. Odd dimension on Aff(1) and Heisenberg; elsewhere a tangent vector of the one is none of the other, but for the groups closed
    // under transposition.
    if (group.name() == "Aff(1)" || group.name() == "Heisenberg")
      claim.refutes("orbits in the algebra have even dimension", model, S(rank_of(adjoint) % 2), S(1));
    if (group.name() == "SE(3)" || group.name() == "SL(2)" || group.name() == "SE(2)") {
      Momentum<SpannedGroup, S> const misplaced{group, xi.coordinates}, misplaced_tangent{group, bracket(eta, xi).coordinates};
      claim.template refuses<OutsideDomain>("a tangent vector of the orbit in the algebra", model,
                                            [&] { orbit_generator(misplaced, misplaced_tangent); });
    }
  });
}

STATEMENT(claim_2_2_reduced_motion, "reduced motion along the coadjoint orbit") {
  claim.convention(
      "J is the momentum map of multiplication from the right, T_e^*L_g p, taken at p(t) rather than at g(t): for a right-invariant "
      "Hamiltonian the body momentum is constant and mu(t) is the spatial one. mu_0 is the initial value of mu only if g(0) = e. "
      "Ad^*_{g^-1} is the dual of Ad_{g^-1}.");
  claim.degree(degree_bound);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const h = draw_algebra_polynomial<S>(draw, group.dimension());
    Costate<SpannedGroup, S> const p{draw.template element<S>(group), draw.template momentum<S>(group)};
    auto const zeta = draw.template velocity<S>(group);
    auto const along = moved(p, hamiltonian_vector_field(right_invariant_function(h), p));
    auto const J = body_momentum(p);

    // J pairs p with the generator g zeta of multiplication from the right; along motions it is constant.
    Matrix<S> const generator = p.place.value * group.hat(zeta.coordinates) * inverse_matrix(p.place.value);
    claim.equal("J is the momentum map of multiplication from the right", model, pair(J, zeta),
                pair(p.momentum, Velocity<SpannedGroup, S>{group, group.vee(generator)}));
    claim.zero("J is constant along motions", model, rate(body_momentum(along)), size_of(rate(along.momentum)));
    // So mu is carried back from it by g, over whatever time.
    claim.equal("mu = Ad*_{g^-1} J", model, Ad_star(inverse(p.place), J), p.momentum);
    // The other way round: along any curve, mu(t) = Ad*_{g^-1(t)} mu_0 has the rate - ad*_xi mu of the Lie-Poisson equations with xi = g' g^-1.
    auto const curve = draw_curve<S>(draw, group);
    S const t = ratio<S>(1, 3);
    Dual<S> time(t);
    time.part[0] = S(1);
    auto const mu = Ad_star(inverse(curve(t)), J), mu_rate = rate(Ad_star(inverse(curve(time)), over<Dual<S>>(J)));
    claim.equal("the formula solves mu' = - ad*_xi mu", model, mu_rate, -ad_star(tangent(curve, t).velocity, mu));

    // Controls: no inverse; the spatial momentum taken for the constant one; the initial value of mu although g(0) is not e; a left-invariant Hamiltonian.
    claim.differs("Ad*_g", model, Ad_star(p.place, J), p.momentum);
    auto const without_inverse = rate(Ad_star(curve(time), over<Dual<S>>(J)));
    claim.differs("Ad*_g solves it too", model, without_inverse, -ad_star(tangent(curve, t).velocity, Ad_star(curve(t), J)));
    auto const g0 = curve(S(0));
    claim.differs("mu_0 = mu(0) although g(0) is not e", model, Ad_star(inverse(curve(t)), Ad_star(inverse(g0), J)), mu);
    auto const of_left = moved(p, hamiltonian_vector_field(left_invariant_function(h), p));
    claim.refutes("J of a left-invariant Hamiltonian", model, rate(body_momentum(of_left)), size_of(J));
  });
}

STATEMENT(claim_2_2_coadjoint_action_kk, "the coadjoint action preserves the Kirillov-Kostant forms") {
  claim.holds();
  claim.degree(degree_bound);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const mu = draw.template momentum<S>(group);
    auto const g = draw.template element<S>(group, S(1));
    auto const v = ad_star(draw.template velocity<S>(group), mu), w = ad_star(draw.template velocity<S>(group), mu);
    auto const act = [&](Momentum<SpannedGroup, S> const& nu) { return Ad_star(inverse(g), nu); };

    // Ad* is linear, so it carries tangent vectors as it carries momenta. The form finds its generators at the new place afresh.
    S const before = kirillov_kostant_plus(mu, v, w);
    claim.equal("omega_+ at the new place on carried vectors", model, kirillov_kostant_plus(act(mu), act(v), act(w)), before,
                orbit_condition);
    claim.equal("omega_-", model, kirillov_kostant_minus(act(mu), act(v), act(w)), S(-before), orbit_condition);
    claim.equal("carried vectors are tangent to the orbit", model, ad_star(orbit_generator(act(mu), act(v)), act(mu)), act(v),
                orbit_condition);
    claim.equal("Ad* composes in the order of the group", model, act(Ad_star(inverse(g), v)), Ad_star(inverse(g * g), v));
    // Controls: another linear map of orbits to orbits; the star lost, where the group sees it.
    auto const twice = [&](Momentum<SpannedGroup, S> const& nu) { return S(2) * nu; };
    claim.differs("multiplication by 2 instead", model, kirillov_kostant_plus(twice(mu), twice(v), twice(w)), before);
    auto const starless = [&](Momentum<SpannedGroup, S> const& nu) {
      return Momentum<SpannedGroup, S>{group, Ad_matrix(g) * nu.components};
    };
    if (group.name() == "Aff(1)")
      claim.differs("Ad_g without its star", model, kirillov_kostant_plus(starless(mu), starless(v), starless(w)), before);
    if (group.name() == "SE(3)" || group.name() == "Heisenberg" || group.name() == "SE(2)")
      claim.template refuses<OutsideDomain>("Ad_g without its star", model,
                                            [&] { kirillov_kostant_plus(starless(mu), starless(v), starless(w)); });
  });
}
