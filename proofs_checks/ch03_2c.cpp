// Section 3.2, third part: body and spatial momenta in time and in steps. Compiled once per scalar.
//
// Degrees: as in ch03_2a.cpp; an inverted matrix of second derivatives, of up to 6 rows with entries of degree below 60, brings it below 2000. The bounds say so.
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/variational/euler_lagrange.hpp"
#include "sequences.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// A Lagrangian on TG with one of three symmetries, in one type: it is differentiated three times, and each type would be compiled on its own.
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
  claim.degree(100);
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
                  }), S(1));
    if (!has_invariant_metric(model)) claim.differs("Ad_g m_c", model, Vector<S>(Ad_matrix(g) * m_c.components), spatial);
  });
}

STATEMENT(claim_3_2_body_momentum_constant, "a right-invariant system keeps its body momentum") {
  claim.holds("First Euler theorem: right-invariant systems keep m_c, left-invariant ones m_s.");
  claim.degree(1000);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    using Side = typename SymmetricLagrangian<S>::Side;
    // Rates of the two momenta along a motion of the Euler-Lagrange equations.
    auto const rates = [&](Side side) {
      SymmetricLagrangian<S> const lagrangian{draw_state_polynomial<S>(draw, group), side};
      State<SpannedGroup, S> const v{draw.template element<S>(group), draw.template velocity<S>(group)};
      auto const moving = moved(v, lagrange_vector_field(lagrangian, v));
      auto const spatial = legendre(lagrangian, moving);
      return std::pair(rate(Ad_star(moving.place, spatial)), rate(spatial));
    };
    auto const right = [&] { return rates(Side::right); };
    auto const left = [&] { return rates(Side::left); };
    // Size of the terms: a momentum times a velocity, each of order 1; the algebra of SO(4) or GL(2) sums a few of them. Condition: the acceleration solves a system.
    claim.zero("right-invariant: d m_c/dt", model, right().first, S(1), 100);
    claim.zero("left-invariant: d m_s/dt", model, left().second, S(1), 100);
    claim.refutes("right-invariant: d m_s/dt", model, several([&] { return right().second; }), S(1));
    claim.refutes("left-invariant: d m_c/dt", model, several([&] { return left().first; }), S(1));
    claim.refutes("no invariance: d m_c/dt", model, several([&] { return rates(Side::none).first; }), S(1));
  });
}

STATEMENT(eq_3_16, "spatial momentum of a right-invariant system in time") {
  claim.holds("mu_0 is the constant body momentum, which is mu(0) only where g(0) = 1.");
  claim.degree(1000);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    SymmetricLagrangian<S> const lagrangian{draw_state_polynomial<S>(draw, group), SymmetricLagrangian<S>::Side::right};
    State<SpannedGroup, S> const v{draw.template element<S>(group), draw.template velocity<S>(group)};
    auto const moving = moved(v, lagrange_vector_field(lagrangian, v));
    auto const mu = legendre(lagrangian, v);
    auto const mu0 = coadjoint(v.place, mu);
    auto const g = moving.place;
    // Both sides have the same value at this instant, by the relation of body and spatial momentum, and the same rate: hence they agree at all times.
    claim.equal("value", model, Ad_star(inverse(v.place), mu0), mu);
    auto const actual = rate(legendre(lagrangian, moving));
    // Condition: the acceleration solves a system.
    claim.zero("rate", model, Vector<S>(rate(Ad_star(inverse(g), over<Dual<S>>(mu0))) - actual), S(1), 100);
    claim.zero("rate, by the Lie-Poisson equation", model, Vector<S>(actual + column(ad_star(v.velocity, mu))), S(1), 100);
    // Controls: the inverse lost; mu(0) for mu_0 although the motion does not begin at 1.
    claim.differs("Ad*_g instead of its inverse", model, rate(Ad_star(g, over<Dual<S>>(mu0))), actual);
    claim.differs("mu(0) for mu_0, g(0) not 1", model, Ad_star(inverse(v.place), mu), mu);
  });
}

STATEMENT(claim_3_2_dlp_chain, "the chain of equalities that leads to the update") {
  claim.corrected(R"(\mu_{k+1} = \mathrm{Ad}^*_{g_{k+1}}\mu_0 = \mathrm{Ad}^*_{(f_{kk+1}^{-1}g_k)^{-1}}\mu_0 = \mathrm{Ad}^*_{f_{kk+1}}\mathrm{Ad}^*_{g_k}\mu_0 = \mathrm{Ad}^*_{f_{kk+1}}\mu_k)",
                  R"(\mu_{k+1} = \mathrm{Ad}^*_{g_{k+1}^{-1}}\mu_0 = \mathrm{Ad}^*_{(f_{kk+1}^{-1}g_k)^{-1}}\mu_0 = \mathrm{Ad}^*_{f_{kk+1}}\mathrm{Ad}^*_{g_k^{-1}}\mu_0 = \mathrm{Ad}^*_{f_{kk+1}}\mu_k)",
                  "Two inverses are missing, at g_{k+1} and at g_k, where (3.16) is used; the second and the last expression are right.");
  claim.maybe_scan();
  claim.degree(200);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const g0 = draw.template element<S>(group), f = draw.template element<S>(group);
    auto const g1 = places_right(g0, Places<S>{f})[1];
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
    claim.refutes("third, as printed", model, gaps([&](auto const& mu) { return Ad_star(f, Ad_star(g0, mu)); }), S(1));
  });
}
