// Scalars: rational, double (long: dec50, dec100)
// Section 2.2: Lie-Poisson reduction and coadjoint orbits. Compiled once per scalar.
//
// The canonical bracket and Hamilton's equations are taken in coordinates (q, p) of T*G, {q, p} = 1, and carried to the reduced ones. Degrees: an element is a quotient of polynomials of
// degree 8, the frame of a chart of degree 16 and its inverse of six times that, a Hamiltonian is cubic.
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
/// The frame of a chart is inverted: its condition is below 10 where coordinates stay below 1/2.
constexpr double frame_condition = 10;

/// The covector at chart(q) with components p, carried to the identity on the right: <mu, dg g^-1> = p.dq.
template <class Chart, class T>
Costate<SpannedGroup, T> costate_in(Chart const& chart, Vector<T> const& q, Vector<T> const& p) {
  auto const g = chart(q);
  return {g, {g.group, solve_linear(Matrix<T>(frame(chart, q).transpose()), p)}};
}
/// A function on T*G in coordinates.
template <class H, class Chart>
auto in_canonical(H const& h, Chart const& chart) {
  return [h, chart](auto const& q, auto const& p) { return h(costate_in(chart, q, p)); };
}
/// sum dF/dq dH/dp - dF/dp dH/dq.
template <class F, class H, class S>
S bracket_in_coordinates(F const& f, H const& h, Vector<S> const& q, Vector<S> const& p) {
  return slopes(f, q, p).dot(momenta(h, q, p)) - momenta(f, q, p).dot(slopes(h, q, p));
}
/// The costate of (q, p), moved along q' = dH/dp, p' = -dH/dq.
template <class H, class Chart, class S>
Costate<SpannedGroup, Dual<S>> moved_by_hamilton(H const& h, Chart const& chart, Vector<S> const& q, Vector<S> const& p) {
  auto const f = in_canonical(h, chart);
  return costate_in(chart, moving(q, momenta(f, q, p)), moving(p, Vector<S>(-slopes(f, q, p))));
}

/// A function on T*G, invariant under nothing: \f$h(\mu) + \langle U, g\rangle\,(v\cdot\mu) + \langle W, g\rangle^2\f$.
template <class S>
struct CostatePolynomial {
  AlgebraPolynomial<S> kinetic;
  Matrix<S> u, w;
  Vector<S> v;
  template <class T>
  T operator()(Costate<SpannedGroup, T> const& p) const {
    Matrix<T> const g = p.place.value;
    T along(0);
    for (Eigen::Index i = 0; i < v.size(); ++i) along += p.momentum.components[i] * T(v[i]);
    T const well = contract(w, g);
    return kinetic(p.momentum) + contract(u, g) * along + well * well;
  }
};
template <class S>
CostatePolynomial<S> draw_costate_polynomial(Draw& draw, SpannedGroup const& group) {
  int const n = group.matrix_size();
  auto const kinetic = draw_algebra_polynomial<S>(draw, group.dimension());
  auto const u = draw_matrix<S>(draw, n, n), w = draw_matrix<S>(draw, n, n);
  return {kinetic, u, w, draw_vector<S>(draw, group.dimension())};
}

/// A chart, and a point of T*G in it.
template <class S>
auto draw_canonical(Draw& draw, SpannedGroup const& group) {
  auto const chart = chart_right(draw.element<S>(group));
  Vector<S> const q = draw_vector<S>(draw, group.dimension()) * ratio<S>(1, 2), p = draw_vector<S>(draw, group.dimension());
  struct Point {
    decltype(chart_right(draw.element<S>(group))) chart;
    Vector<S> q, p;
  };
  return Point{chart, q, p};
}

}  // namespace

STATEMENT(thm_2_2_2, "the bracket that right-invariant functions give the dual algebra") {
  claim.holds("With {q, p} = +1 on T*G and the commutator in the algebra; left-invariant functions give the minus bracket.");
  claim.degree(degree_bound);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f = draw_algebra_polynomial<S>(draw, group.dimension()), h = draw_algebra_polynomial<S>(draw, group.dimension()),
               k = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const [chart, q, p] = draw_canonical<S>(draw, group);
    auto const at = costate_in(chart, q, p);

    // The canonical bracket of the lifted functions depends on lambda(p) alone, and is the plus bracket there.
    S const canonical =
        bracket_in_coordinates(in_canonical(right_invariant_function(f), chart), in_canonical(right_invariant_function(h), chart), q, p);
    S const plus = lie_poisson_bracket_plus(f, h, at.momentum);
    claim.equal("canonical bracket of right-invariant functions", model, canonical, plus, frame_condition);
    S const from_left =
        bracket_in_coordinates(in_canonical(left_invariant_function(f), chart), in_canonical(left_invariant_function(h), chart), q, p);
    claim.equal("of left-invariant functions, at the body momentum: the minus bracket", model, from_left,
                lie_poisson_bracket_minus(f, h, body_momentum(at)), frame_condition);

    // It is a Poisson structure: Leibniz and Jacobi (antisymmetry is the commutator's).
    auto const product = [&](auto const& mu) { return f(mu) * k(mu); };
    auto const mu = at.momentum;
    claim.equal("Leibniz", model, lie_poisson_bracket_plus(product, h, mu), S(f(mu) * lie_poisson_bracket_plus(k, h, mu) + k(mu) * plus));
    auto const bracket_of = [](auto const& a, auto const& b) { return [&](auto const& nu) { return lie_poisson_bracket_plus(a, b, nu); }; };
    S const cyclic[3] = {lie_poisson_bracket_plus(f, bracket_of(h, k), mu), lie_poisson_bracket_plus(h, bracket_of(k, f), mu),
                         lie_poisson_bracket_plus(k, bracket_of(f, h), mu)};
    claim.zero("Jacobi", model, S(cyclic[0] + cyclic[1] + cyclic[2]), S(size_of(cyclic[0]) + size_of(cyclic[1]) + size_of(cyclic[2])));
    // Controls: the other sign; the bracket at the body momentum.
    claim.differs("the minus bracket", model, canonical, lie_poisson_bracket_minus(f, h, mu));
    claim.differs("at the body momentum", model, canonical, lie_poisson_bracket_plus(f, h, body_momentum(at)));
  });
}

STATEMENT(thm_2_2_3, "Lie-Poisson reduction of a right-invariant Hamiltonian") {
  claim.convention(
      "With mu = mu(t) in the equation for g (printed: p(0), see claim_2_2_reconstruction_velocity) and lambda(p) = T_e^*R_g p (printed "
      "with the index g(t) in place of e, which would be a map from another fibre).");
  claim.degree(degree_bound);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const h = draw_algebra_polynomial<S>(draw, group.dimension()), f = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const H = right_invariant_function(h);
    auto const F = draw_costate_polynomial<S>(draw, group);
    auto const [chart, q, p] = draw_canonical<S>(draw, group);
    auto const along = moved_by_hamilton(H, chart, q, p);
    Momentum<SpannedGroup, S> const momentum{group, values(along.momentum.components)}, momentum_rate = rate(along.momentum);

    // i gives the equation for g, and iii; the equation for g and iii together give p', so they give i back.
    claim.equal("i: g' = T_eR_g dh/dmu", model, rate_right(along.place), gradient(h, momentum), frame_condition);
    claim.equal("i and iii: mu' = - ad* mu", model, momentum_rate, lie_poisson_rate_right(h, momentum), frame_condition);
    Vector<S> const q_rate = solve_linear(frame(chart, q), gradient(h, momentum).coordinates);
    Vector<Dual<S>> const carried =
        frame(chart, moving(q, q_rate)).transpose() * moving(momentum.components, lie_poisson_rate_right(h, momentum).components);
    claim.equal("iii and i: back to p' = - dH/dq", model, rates(carried), Vector<S>(-slopes(in_canonical(H, chart), q, p)),
                frame_condition);
    // ii and iv.
    claim.equal("ii: F' = {F, H}", model, F(along).part[0], bracket_in_coordinates(in_canonical(F, chart), in_canonical(H, chart), q, p),
                frame_condition);
    Momentum<SpannedGroup, Dual<S>> const by_iii{group, moving(momentum.components, lie_poisson_rate_right(h, momentum).components)};
    claim.equal("iii and iv: f' = {f, h}_+", model, f(by_iii).part[0], lie_poisson_bracket_plus(f, h, momentum), frame_condition);

    // Controls: the sign; the body's momentum in place of lambda; the minus bracket.
    claim.differs("mu' = + ad* mu", model, momentum_rate, lie_poisson_rate_left(h, momentum));
    claim.refutes("T_e^*L_g p in place of T_e^*R_g p", model, rate(body_momentum(along)) - momentum_rate, size_of(momentum_rate));
    claim.differs("the minus bracket", model, f(by_iii).part[0], lie_poisson_bracket_minus(f, h, momentum));
  });
}

STATEMENT(claim_2_2_reconstruction_velocity, "which momentum moves the group element") {
  claim.corrected(R"(\dot g = T_eR_g\frac{\delta h}{\delta\mu}, \quad \mu = p(0))",
                  R"(\dot g = T_eR_g\frac{\delta h}{\delta\mu}, \quad \mu = \mu(t) = \lambda(p(t)))",
                  "The momentum is that of the same instant, carried to the identity. With the momentum frozen at its initial value g "
                  "would be a one-parameter group; and p(0) is a covector at g(0), not an element of the dual algebra.");
  claim.degree(degree_bound);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const h = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const H = right_invariant_function(h);
    auto const [chart, q, p] = draw_canonical<S>(draw, group);
    auto const at = costate_in(chart, q, p);

    // Hamilton's equations move g by the momentum of this instant,
    auto const xi = rate_right(moved_by_hamilton(H, chart, q, p).place);
    claim.equal("g' g^-1 = dh/dmu at mu(t)", model, xi, gradient(h, at.momentum), frame_condition);
    // at the next instant by that of the next: the rate of the velocity is that of dh/dmu along mu'.
    auto const f = in_canonical(H, chart);
    auto const q_later = moving(q, momenta(f, q, p)), p_later = moving(p, Vector<S>(-slopes(f, q, p)));
    auto const xi_rate = rate(rate_right(costate_in(chart, moving(q_later, momenta(f, q_later, p_later)), moving(p_later, p_later)).place));
    Momentum<SpannedGroup, Dual<S>> const later{group, moving(at.momentum.components, lie_poisson_rate_right(h, at.momentum).components)};
    claim.equal("and stays so", model, xi_rate, rate(gradient(h, later)), 10 * frame_condition);
    // Controls: the momentum frozen, whose velocity has no rate; the components of p(0) taken for an element of the dual algebra.
    claim.refutes("mu frozen at its initial value", model, xi_rate, size_of(xi));
    claim.differs("components of p(0) in a chart", model, gradient(h, Momentum<SpannedGroup, S>{group, p}), xi);
  });
}

STATEMENT(claim_2_2_lie_poisson_equivalence, "Hamilton's equations, Lie-Poisson equations and brackets say the same") {
  claim.holds("Conditions iii and iv say nothing about g: the equation for g is needed to come back to i and ii.");
  claim.degree(degree_bound);
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    int const n = group.dimension();
    auto const F = draw_costate_polynomial<S>(draw, group), H = draw_costate_polynomial<S>(draw, group);
    auto const h = draw_algebra_polynomial<S>(draw, n);
    auto const invariant = right_invariant_function(h);
    auto const [chart, q, p] = draw_canonical<S>(draw, group);
    auto const at = costate_in(chart, q, p);

    // The canonical structure of the library, for functions invariant under nothing, against coordinates.
    claim.equal("canonical bracket without coordinates", model, canonical_bracket(F, H, at),
                bracket_in_coordinates(in_canonical(F, chart), in_canonical(H, chart), q, p), frame_condition);
    auto const along = moved_by_hamilton(H, chart, q, p);
    auto const field = hamiltonian_vector_field(H, at);
    claim.equal("Hamilton's equations, place", model, field.place, rate_right(along.place), frame_condition);
    claim.equal("Hamilton's equations, momentum", model, field.momentum, rate(along.momentum), frame_condition);
    claim.equal("i and ii: F' = {F, H}", model, F(moved(at, field)).part[0], canonical_bracket(F, H, at));

    // Brackets with the coordinate functions give all rates back: ii gives i, and iv gives iii.
    auto const reduced = hamiltonian_vector_field(invariant, at);
    for (int a = 0; a < n; ++a) {
      auto const component = [a](auto const& x) {
        if constexpr (requires { x.momentum; })
          return x.momentum.components[a];
        else
          return x.components[a];
      };
      S const expected = lie_poisson_rate_right(h, at.momentum).components[a];
      auto const scale = size_of(reduced.momentum);
      claim.zero("ii for the components of the momentum", model, S(canonical_bracket(component, invariant, at) - expected), scale);
      claim.zero("iv for the components of the momentum", model, S(lie_poisson_bracket_plus(component, h, at.momentum) - expected), scale);
    }
    // Controls: g moved by something else keeps iii and iv and breaks i and ii; the canonical bracket without its last term.
    auto astray = reduced;
    astray.place = draw.template velocity<S>(group);
    claim.differs("another motion of g", model, F(moved(at, astray)).part[0], canonical_bracket(F, invariant, at));
    claim.differs("the term <mu, [F, H]> left out", model,
                  S(canonical_bracket(F, H, at) - pair(at.momentum, bracket(momentum_derivative(F, at), momentum_derivative(H, at)))),
                  canonical_bracket(F, H, at));
    claim.differs("the reduced equations for a Hamiltonian that is not invariant", model, field.momentum,
                  -ad_star(field.place, at.momentum));
  });
}
