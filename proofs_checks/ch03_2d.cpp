// Section 3.2, fourth part: the coadjoint action, the discrete Lie-Poisson algorithm. Compiled once per scalar.
//
// Degrees: as in ch03_2a.cpp; an inverted matrix of second derivatives, of up to 6 rows with entries of degree below 60, brings it below 2000. The bounds say so.
#include "actio/reduction/discrete_forms.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/variational/lie_poisson.hpp"
#include "sequences.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

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
  if (name == "SE(3)") return values({m[3] * m[3] + m[4] * m[4] + m[5] * m[5], m[0] * m[3] + m[1] * m[4] + m[2] * m[5]});
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
/// The discrete Lie-Poisson map with f solved from mu: f is drawn, mu is the momentum it takes up, and the tangent follows from the equation.
template <class L, class S>
MapAt<S> lie_poisson_map(L const& l, Place<S> const& f) {
  // d mu0 = -A theta and d mu1 = -B theta.
  Matrix<S> const a = right_second_differential(l, f), b = left_second_differential(l, f);
  return {lie_poisson_update_right(f, momentum_before_right(l, f)), b * inverse_matrix(a)};
}
/// mu carried along by an element that depends on it in any way: keeps every orbit.
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
/// How far a map is from keeping the plus bracket: T Lambda T^T - Lambda at the image. The minus bracket is its negative.
template <class S>
Matrix<S> poisson_defect(MapAt<S> const& map, Covector<S> const& mu) {
  return map.tangent * lie_poisson_tensor_plus(mu) * map.tangent.transpose() - lie_poisson_tensor_plus(map.image);
}

}  // namespace

STATEMENT(claim_3_2_coadjoint_lie_poisson, "the coadjoint action keeps orbits, their symplectic forms, and the Lie-Poisson brackets") {
  claim.corrected(R"(\mathcal O\subset\mathfrak g)", R"(\mathcal O\subset\mathfrak g^*)",
                  "Coadjoint orbits lie in the dual; what is said of them holds, for both signs. Under Ad_g in the algebra the brackets do not survive.");
  claim.maybe_scan();
  claim.degree(100);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw.template element<S>(group);
    auto const mu = draw.template momentum<S>(group);
    auto const xi = draw.template velocity<S>(group), eta = draw.template velocity<S>(group);
    auto const image = Ad_star(inverse(g), mu);
    // Tangent vectors of the orbit go to tangent vectors of it; the forms <mu, [xi, eta]>, up to sign, go along.
    claim.equal("Ad* of a tangent vector", model, Ad_star(inverse(g), ad_star(xi, mu)), ad_star(Ad(g, xi), image));
    claim.zero("orbit symplectic forms", model, S(pair(image, bracket(Ad(g, xi), Ad(g, eta))) - pair(mu, bracket(xi, eta))),
               size_of(image) * size_of(Ad(g, xi)) * size_of(Ad(g, eta)) + S(1));

    // Brackets of functions on the dual, both signs.
    auto const a = draw_algebra_polynomial<S>(draw, group.dimension()), b = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const after = [&](auto const& f) { return [&f, &g](auto const& at) { return f(Ad_star(inverse(like(at, g)), at)); }; };
    auto const scale = S(1) + size_of(image) * size_of(gradient(a, image)) * size_of(gradient(b, image));
    claim.zero("plus bracket", model, S(lie_poisson_bracket_plus(after(a), after(b), mu) - lie_poisson_bracket_plus(a, b, image)), scale);
    claim.zero("minus bracket", model, S(lie_poisson_bracket_minus(after(a), after(b), mu) - lie_poisson_bracket_minus(a, b, image)), scale);

    // Controls: Ad_g on the components, as if orbits lay in the algebra; twice the coadjoint action.
    auto const with = [&](Matrix<S> const& m) {
      return Matrix<S>(m * lie_poisson_tensor_plus(mu) * m.transpose() - lie_poisson_tensor_plus(momentum(group, Vector<S>(m * mu.components))));
    };
    Matrix<S> const ad = Ad_matrix(g), coad = Ad_matrix(inverse(g)).transpose();
    claim.zero("tensor", model, with(coad), S(1) + magnitude(coad) * magnitude(coad));
    // (Where transposition keeps the group, or a metric, Ad_g is the coadjoint action of another element.)
    if (!has_invariant_metric(model) && model != "GL(2)") claim.refutes("Ad_g, orbits in the algebra", model, with(ad), magnitude(lie_poisson_tensor_plus(mu)));
    claim.refutes("twice the coadjoint action", model, with(coad + coad), magnitude(lie_poisson_tensor_plus(mu)));
  });
}

STATEMENT(prop_3_2_1, "the discrete Lie-Poisson algorithm is a Poisson map of the dual algebra") {
  claim.holds("In both readings: along a fixed sequence of f, and with f solved from mu, where it takes the discrete Euler-Poincare equations and not the orbits alone. The minus bracket is kept as well.");
  claim.degree(2000);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const f = draw.template element<S>(group);
    auto const mu = momentum_before_right(l, f);
    auto const size = [&](MapAt<S> const& map) { return magnitude(map.tangent) * size_of(mu) * magnitude(map.tangent) + size_of(map.image); };

    // f fixed: a linear map.
    MapAt<S> const fixed{lie_poisson_update_right(f, mu), Ad_matrix(f).transpose()};
    claim.zero("f fixed", model, poisson_defect(fixed, mu), size(fixed));
    // f solved from mu: differentiate the equation. Condition: a matrix of second derivatives is inverted.
    auto const solved = lie_poisson_map(l, f);
    claim.zero("f solved from mu", model, poisson_defect(solved, mu), size(solved), 100);
    // The same in functions.
    auto const a = draw_algebra_polynomial<S>(draw, group.dimension()), b = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const pulled = [&](auto const& h) { return velocity(group, Vector<S>(solved.tangent.transpose() * gradient(h, solved.image).coordinates)); };
    auto const scale = size_of(mu) * size_of(pulled(a)) * size_of(pulled(b)) + size_of(solved.image) * size_of(gradient(a, solved.image)) * size_of(gradient(b, solved.image));
    claim.zero("{a o Phi, b o Phi}_+ = {a, b}_+ o Phi", model, S(pair(mu, bracket(pulled(a), pulled(b))) - lie_poisson_bracket_plus(a, b, solved.image)), scale, 100);

    // Controls: an element that depends on mu in another way; the same map read backwards in momentum, mu -> -Ad* mu.
    auto const others = several([&] { return poisson_defect(orbit_keeping_map(draw_matrix<S>(draw, group.dimension(), group.dimension()), mu), mu); });
    claim.refutes("f another function of mu", model, others, magnitude(lie_poisson_tensor_plus(mu)));
    claim.refutes("momentum with the other sign", model, poisson_defect(MapAt<S>{-fixed.image, -fixed.tangent}, mu), size(fixed));
  });
}

STATEMENT(eq_3_17, "discrete Lie-Poisson update, right-invariant case") {
  claim.holds("mu_k = -R* l'(f_{k,k+1}) is the momentum with which the step leaves g_k.");
  claim.degree(2000);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f = draw_places<S>(draw, group, 3);
    auto const l = with_motions_right(draw_reduced_lagrangian<S>(draw, group), f);
    auto const g = places_right(draw.template element<S>(group), f);
    // Momenta of the full motion, and what the update makes of them. Condition: places after three steps.
    std::vector<Covector<S>> mu;
    for (int k = 0; k < 3; ++k) mu.push_back(legendre_source(lifted(l), g[k], g[k + 1]));
    auto const scale = momenta_of(l, f);
    Matrix<S> inverted(group.dimension(), 2), star_lost(group.dimension(), 2), next(group.dimension(), 2);
    for (int k = 0; k < 2; ++k) {
      claim.zero("mu_{k+1} = Ad*_f mu_k along a motion", model, lie_poisson_update_right(f[k], mu[k]) - mu[k + 1], scale, 10);
      claim.zero("the momentum that the step leaves behind", model, legendre_target(lifted(l), g[k], g[k + 1]) - coadjoint(f[k], mu[k]), scale, 10);
      claim.zero("mu_k from f alone", model, momentum_before_right(l, f[k]) - mu[k], scale, 10);
      claim.zero("Ad*_{g_k} mu_k stays", model, coadjoint(g[k + 1], mu[k + 1]) - coadjoint(g[0], mu[0]), scale, 10);
      inverted.col(k) = column(Ad_star(inverse(f[k]), mu[k])), star_lost.col(k) = Ad_matrix(f[k]) * mu[k].components, next.col(k) = column(mu[k + 1]);
    }
    // Controls: the inverse, as with g1 g0^-1; the star lost, where it shows as the inverse does; a step that is none.
    if (model != "Heisenberg") claim.differs("Ad* of the inverse", model, inverted, next);
    if (model != "Heisenberg") claim.differs("Ad instead of Ad*", model, star_lost, next);
    auto const elsewhere = several([&] { return column(lie_poisson_update_right(f[0], mu[0]) - momentum_before_right(l, draw.template element<S>(group))); });
    claim.refutes("f_{12} that (3.10) does not give", model, elsewhere, scale);
  });
}

STATEMENT(rem_3_2_2, "the left-invariant algorithm and the momentum it carries") {
  claim.corrected(R"(\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1k}}\cdot\Pi_k,\quad \Pi_k := \mathrm{Ad}^*_{g_k}\pi_0)", R"(\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1k}^{-1}}\cdot\Pi_k,\quad \Pi_k := \mathrm{Ad}^*_{g_k}\pi_0)",
                  "The definition of Pi_k is right and contradicts the update as printed, (3.18), which lacks an inverse.");
  claim.maybe_scan();
  claim.degree(2000);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f = draw_places<S>(draw, group, 3);
    auto const l = with_motions_left(draw_reduced_lagrangian<S>(draw, group), f);
    auto const g = places_left(draw.template element<S>(group), f);
    auto const scale = momenta_of(l, f);
    // The spatial momentum is the constant; Ad* of the place makes the body momentum of it. Condition: places after three steps.
    auto const spatial = [&](int k) { return legendre_source(lifted_left(l), g[k], g[k + 1]); };
    for (int k : {1, 2}) {
      claim.zero("m_s is constant", model, spatial(k) - spatial(0), scale, 10);
      claim.zero("Pi_k = Ad*_{g_k} pi_0", model, coadjoint(g[k], spatial(0)) - momentum_before_left(l, f[k]), scale, 10);
    }
    claim.zero("legendre_target agrees", model, legendre_target(lifted_left(l), g[0], g[1]) - spatial(0), scale, 10);
    // The definition alone gives the update, whatever pi_0.
    auto const update = [&](auto const& element) {
      return several([&] {
        auto const constant = draw.template momentum<S>(group);
        return column(Ad_star(element, Ad_star(g[0], constant)) - Ad_star(g[1], constant));
      });
    };
    claim.zero("Ad*_{f^-1} takes Ad*_{g_k} to Ad*_{g_{k+1}}", model, update(inverse(f[0])), magnitude(Ad_matrix(f[0])) * magnitude(Ad_matrix(g[0])) + S(1), 10);
    claim.refutes("as printed", model, update(f[0]), S(1));
  });
}

STATEMENT(eq_3_18, "discrete Lie-Poisson update, left-invariant case") {
  claim.corrected(R"(\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1k}}\cdot\Pi_k)", R"(\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1k}^{-1}}\cdot\Pi_k)",
                  "The inverse is missing: f_{k+1,k} is g_{k+1}^{-1} g_k, and Pi_k is Ad* of g_k, not of its inverse.");
  claim.maybe_scan();
  claim.degree(2000);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f = draw_places<S>(draw, group, 3);
    auto const l = with_motions_left(draw_reduced_lagrangian<S>(draw, group), f);
    auto const g = places_left(draw.template element<S>(group), f);
    // Body momenta of the full motion. Condition: places after three steps.
    std::vector<Covector<S>> body;
    for (int k = 0; k < 3; ++k) body.push_back(coadjoint(g[k], legendre_source(lifted_left(l), g[k], g[k + 1])));
    auto const scale = momenta_of(l, f);
    Matrix<S> printed(group.dimension(), 2), next(group.dimension(), 2);
    for (int k = 0; k < 2; ++k) {
      claim.zero("Pi_{k+1} = Ad*_{f^-1} Pi_k along a motion", model, lie_poisson_update_left(f[k], body[k]) - body[k + 1], scale, 10);
      claim.zero("Pi_k from f alone", model, momentum_before_left(l, f[k]) - body[k], scale, 10);
      printed.col(k) = column(Ad_star(f[k], body[k])), next.col(k) = column(body[k + 1]);
    }
    if (model != "Heisenberg") claim.differs("as printed", model, printed, next);
  });
}

STATEMENT(claim_3_2_dlp_orbits, "the momentum stays on its coadjoint orbit") {
  claim.holds();
  claim.degree(2000);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f = draw_places<S>(draw, group, 3);
    auto const l = with_motions_right(draw_reduced_lagrangian<S>(draw, group), f);
    auto const start = momentum_before_right(l, f[0]);
    auto const scale = momenta_of(l, f);
    // Three steps; the group element that joins the ends is the product of the relative motions, so the orbit is the same by definition.
    auto mu = start;
    for (auto const& step : f) mu = lie_poisson_update_right(step, mu);
    claim.zero("one element of the group joins first and last", model, coadjoint(f[0] * f[1] * f[2], start) - mu, scale, 10);
    claim.zero("momenta along the motion are those of the algorithm", model, lie_poisson_update_right(f[1], lie_poisson_update_right(f[0], start)) - momentum_before_right(l, f[2]), scale, 10);

    auto const invariants = casimirs(start);
    if (invariants.size() == 0) return;
    auto const size = S(scale * scale + scale);
    claim.zero("functions that are constant on orbits", model, Vector<S>(casimirs(mu) - invariants), size, 10);
    // Controls: an explicit step of the Lie-Poisson equations leaves the orbit; so does the update without its star.
    auto const drift = [&](auto const& step) {
      return several([&] {
        auto const at = draw.template momentum<S>(group);
        return Vector<S>(casimirs(step(at)) - casimirs(at));
      });
    };
    if (model != "Heisenberg") claim.refutes("mu - ad*_xi mu", model, drift([&](auto const& at) { return at - ad_star(draw.template velocity<S>(group), at); }), S(1));
    if (!has_invariant_metric(model) && model != "GL(2)")
      claim.refutes("Ad instead of Ad*", model, drift([&](auto const& at) { return momentum(group, Vector<S>(Ad_matrix(f[0]) * at.components)); }), S(1));
  });
}

STATEMENT(claim_3_2_orbits_and_bracket, "a map that keeps every orbit need not keep the bracket") {
  claim.corrected(R"(\text{preserves the coadjoint orbits and hence the Poisson structure})",
                  R"(\text{preserves the coadjoint orbits, and, since } \mu_k=-R^*_{f_{kk+1}}\ell'(f_{kk+1}), \text{ the Poisson structure})",
                  "The conclusion holds for this algorithm, the inference does not: mu -> Ad*_{f(mu)} mu keeps every orbit for any f(mu), and the bracket only for special ones.");
  claim.degree(2000);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    int const d = group.dimension();
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const f = draw.template element<S>(group);
    auto const mu = momentum_before_right(l, f);
    auto const size = [&](MapAt<S> const& map) { return magnitude(map.tangent) * size_of(mu) * magnitude(map.tangent) + size_of(map.image); };
    // Two maps that keep every orbit: the algorithm, and one whose element is any function of mu.
    auto const algorithm = lie_poisson_map(l, f);
    auto const any_map = [&] { return orbit_keeping_map(Matrix<S>(draw_matrix<S>(draw, d, d) / (S(2) * (S(1) + S(size_of(mu))))), mu); };
    auto const other = any_map();
    if (auto const invariants = casimirs(mu); invariants.size() > 0) {
      auto const square = S(1) + S(size_of(mu) * size_of(mu)) + S(size_of(algorithm.image) * size_of(algorithm.image));
      claim.zero("the algorithm keeps orbits", model, Vector<S>(casimirs(algorithm.image) - invariants), square, 10);
      claim.zero("the other map keeps orbits", model, Vector<S>(casimirs(other.image) - invariants), square, 10);
    }
    claim.zero("the algorithm keeps the bracket", model, poisson_defect(algorithm, mu), size(algorithm), 100);
    claim.refutes("other maps do not", model, several([&] { return poisson_defect(any_map(), mu); }), magnitude(lie_poisson_tensor_plus(mu)));
  });
}
