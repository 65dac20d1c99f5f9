// Scalars: rational, double (long: dec50, dec100)
// Section 2.2: the variations of the reduced velocity. Compiled once per scalar.
//
// Degrees: an element is a product of at most five quotients of polynomials of degree 4, its second rates have degree below 60.
#include "actio/variational/curves.hpp"
#include "actio/variational/euler_poincare.hpp"
#include "charts.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

constexpr int degree_bound = 1000;

}  // namespace

STATEMENT(claim_2_2_reduced_variation_ad, "variation of the reduced velocity, with ad") {
  claim.holds("With eta = dg g^-1, xi = g' g^-1 and ad_xi eta = [xi, eta], the commutator.");
  claim.degree(degree_bound);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const curve = draw_curve<S>(draw, group);
    auto const family = draw_family<S>(draw, group, curve);
    S const t = ratio<S>(1, 3);
    auto const eta = [&](auto const& s) { return lifted_variation(family, s).place; };
    auto const xi = tangent(curve, t).velocity, eta_rate = rate_along(eta, t);

    // Differentiate g' g^-1 by epsilon, on matrices.
    auto const delta = lifted_variation(family, t).velocity;
    claim.equal("delta xi = eta' - ad_xi eta", model, delta, reduced_variation_right(xi, eta(t), eta_rate));
    // Every eta comes from a variation: the one with g_epsilon = retract(epsilon eta) g.
    auto const chosen = draw.template velocity<S>(group);
    auto const constant = [&](auto const& e, auto const& s) {
      using T = std::decay_t<decltype(s)>;
      return retract(e * over<T>(chosen)) * curve(s);
    };
    claim.equal("every eta occurs", model, lifted_variation(constant, t).place, chosen);
    claim.equal("a constant eta gives - ad_xi eta", model, lifted_variation(constant, t).velocity, -ad(xi, chosen));
    // Controls: the sign of left-invariant systems; ad left out.
    claim.differs("eta' + ad_xi eta", model, delta, reduced_variation_left(xi, eta(t), eta_rate));
    claim.differs("eta' alone", model, delta, eta_rate);
  });
}

STATEMENT(claim_2_2_reduced_variation_bracket, "variation of the reduced velocity, with the bracket") {
  claim.corrected(R"(\delta\xi = \dot\eta - \mathrm{ad}_\xi\eta = \dot\eta + [\xi, \eta])",
                  R"(\delta\xi = \dot\eta - \mathrm{ad}_\xi\eta = \dot\eta - [\xi, \eta])",
                  "The thesis defines ad_xi eta = [xi, eta] (Theorem 2.2.3), so the two printed expressions differ in every group that is "
                  "not abelian. The plus sign belongs to xi = g^-1 g' and eta = g^-1 dg, the left-invariant case.");
  claim.degree(degree_bound);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const curve = draw_curve<S>(draw, group);
    auto const family = draw_family<S>(draw, group, curve);
    S const t = ratio<S>(1, 3);
    auto const commutator = [&](Velocity<SpannedGroup, S> const& x, Velocity<SpannedGroup, S> const& y) {
      Matrix<S> const a = group.hat(x.coordinates), b = group.hat(y.coordinates);
      return Velocity<SpannedGroup, S>{group, group.vee(Matrix<S>(a * b - b * a))};
    };
    auto const eta = [&](auto const& s) { return lifted_variation(family, s).place; };
    auto const xi = tangent(curve, t).velocity, delta = lifted_variation(family, t).velocity;
    claim.equal("delta xi = eta' - [xi, eta]", model, delta, rate_along(eta, t) - commutator(xi, eta(t)));

    // Seen from the body the sign is plus.
    auto const body_eta = [&](auto const& s) { return Ad(inverse(curve(s)), eta(s)); };
    auto const varied = varied_tangent(family, t);
    auto const body_xi = Ad(inverse(varied.place), varied.velocity);
    claim.equal("g^-1 g' varies by eta' + [xi, eta]", model, rate(body_xi),
                rate_along(body_eta, t) + commutator(value_of(body_xi), body_eta(t)));
    // Control: as printed.
    claim.differs("as printed, eta' + [xi, eta]", model, delta, rate_along(eta, t) + commutator(xi, eta(t)));
  });
}
