// Section 3.2, third part: body and spatial momenta in time and in steps, the coadjoint action, the
// discrete Lie-Poisson algorithm.

#include "actio/linear_algebra/rank.hpp"
#include "actio/reduction/discrete_forms.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/variational/coadjoint_orbit.hpp"
#include "actio/variational/euler_lagrange.hpp"
#include "actio/variational/lie_poisson.hpp"

#include "models/sequences.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

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
      "Two inverses are missing, at $g_{k+1}$ and at $g_k$, where (3.16) is used; the second and "
      "the last expression are right.");
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
// Section 3.2: the coadjoint action, the discrete Lie-Poisson algorithm.

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
  claim.same_slip_as("claim_2_2_coadjoint_orbits");
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
    // The form that the bracket induces on its leaf is that of the orbit. Condition: ad* mu is inverted.
    claim.equal("the form of the orbit and the plus bracket", model,
                kirillov_kostant_plus(mu, lie_poisson_rate_right(a, mu), lie_poisson_rate_right(b, mu)),
                lie_poisson_bracket_plus(a, b, mu), 100);
    claim.equal("the form of the orbit and the minus bracket", model,
                kirillov_kostant_minus(mu, lie_poisson_rate_left(a, mu), lie_poisson_rate_left(b, mu)),
                lie_poisson_bracket_minus(a, b, mu), 100);
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
      "In both readings: along a fixed sequence of $f$, and with $f$ solved from $\\mu$, where "
      "the proof needs the discrete Euler-Poincaré equations and not the orbits alone. The "
      "minus bracket is preserved as well.");
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
                  "The definition of $\\Pi_k$ is right and contradicts the update as printed, "
                  "(3.18), which lacks an inverse.");
  claim.maybe_scan();
  claim.same_slip_as("eq_3_18");
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
  claim.corrected(R"(\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1k}}\cdot\Pi_k)",
                  R"(\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1k}^{-1}}\cdot\Pi_k)",
                  "The inverse is missing: $f_{k+1,k}$ is $g_{k+1}^{-1}g_k$, and $\\Pi_k$ is "
                  "$\\Ad^*$ of $g_k$, not of its inverse.");
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
  claim.holds(
      "One element of the group joins the momenta; functions that are constant on orbits stay, and so does "
      "the dimension of the orbit. On Aff(1), which has no such function, the half-planes $\\mu_2 > 0$ and "
      "$\\mu_2 < 0$ and each point of $\\mu_2 = 0$ are the orbits.");
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

    // The orbit's tangent space goes to that at the image: so the dimensions agree.
    auto const tangents = [](Covector<S> const& at) { return lie_poisson_tensor_plus(at); };
    Matrix<S> const step = Ad_matrix(f[0] * f[1] * f[2]).transpose();
    claim.zero("tangent spaces of the orbit", model,
               Matrix<S>(step * tangents(start) * step.transpose() - tangents(mu)),
               magnitude(step) * magnitude(tangents(start)) * magnitude(step) + magnitude(tangents(mu)), 10);
    claim.fact("orbits of one dimension", model, matrix_rank(tangents(start)) == matrix_rank(tangents(mu)));

    auto const invariants = casimirs(start);
    if (model == "Aff(1)") {
      // The second component is multiplied by the stretching of f, which is positive; the first moves unless
      // the second is zero.
      S const stretching = (f[0] * f[1] * f[2]).value(0, 0);
      claim.zero("half-planes: mu_2 is multiplied by a positive number", model,
                 S(mu.components[1] - stretching * start.components[1]), scale, 10);
      if (ordered_arithmetic<S>()) claim.fact("which is positive", model, S(0) < stretching);
      auto const line = [&](GroupElement<S> const& by, S const& second) {
        auto const at = momentum(group, Vector<S>{{start.components[0], second}});
        return lie_poisson_update_right(by, at) - at;
      };
      claim.zero("points of the line mu_2 = 0 stay", model, line(f[0], S(0)), size_of(start), 10);
      claim.refutes("other points stay", model, line(f[0], draw.template number<S>()), size_of(start));
      // Control: a reflection of the line is no element of the group. It exchanges the half-planes.
      Matrix<S> reflection = f[0].value;
      reflection(0, 0) = -reflection(0, 0);
      auto const reflected = lie_poisson_update_right(GroupElement<S>{group, reflection}, start);
      claim.differs("carried by a reflection", model, reflected.components[1],
                    S(f[0].value(0, 0) * start.components[1]));
    }
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
