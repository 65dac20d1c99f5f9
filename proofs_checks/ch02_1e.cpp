// Scalars: rational, double (long: dec50, dec100)
// Section 2.1, at a point: where the Euler-Lagrange map lives, and Noether's theorem. Compiled once per scalar.
//
// Every identity is one between derivatives at a random point, so it is exact over the rationals on every group. Degrees: an element is a product of at most four
// quotients of polynomials of degree 4, its second rates have degree below 50, a Lagrangian is cubic in rates and quadratic in entries, the inverse of a Hessian of 6 rows
// multiplies the degree by six.
#include "actio/variational/curves.hpp"
#include "actio/variational/euler_lagrange.hpp"
#include "actio/variational/momentum_map.hpp"
#include "charts.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

constexpr int degree_bound = 1500;
/// Solving with a fibre Hessian magnifies rounding by its condition, about 30 for these Lagrangians.
constexpr double hessian_condition = 30;

}  // namespace

STATEMENT(claim_2_1_second_order_set, "where the Euler-Lagrange map lives") {
  claim.corrected(R"(\ddot G \equiv \Bigl\{\frac{d^2 g}{dt^2}(0) \Bigm| q \text{ a } C^2 \text{ curve in } G\Bigr\} \text{ of } TG)",
                  R"(\ddot G \equiv \Bigl\{\frac{d^2 g}{dt^2}(0) \Bigm| g \text{ a } C^2 \text{ curve in } G\Bigr\} \subset T(TG))",
                  "Second derivatives are tangent vectors of TG, so the set lies in T(TG): those w with T(projection) w = base point of w. "
                  "As printed it would lie in TG; the curve is g, not q.");
  claim.degree(degree_bound);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_state_polynomial<S>(draw, group);
    auto const curve = draw_curve<S>(draw, group);
    S const t = ratio<S>(1, 3);
    auto const state = tangent(curve, t);
    auto const second = second_tangent(curve, t);

    // The second derivative of a curve is a tangent vector of TG whose place part is the velocity of its base point.
    claim.equal("second derivatives are second order", model, second.place, state.velocity);
    // The map sees no more of the curve: change it at third order.
    auto const bend = draw.template velocity<S>(group);
    auto const third = [&](auto const& s) {
      using T = std::decay_t<decltype(s)>;
      T const x = s - T(t);
      return retract((x * x * x) * over<T>(bend)) * curve(s);
    };
    auto const map = euler_lagrange(L, state, second.velocity);
    claim.equal("the same for curves that agree to second order", model,
                euler_lagrange(L, tangent(third, t), second_tangent(third, t).velocity), map);
    // Control: curves with the same point of TG, different at second order. A map on a subset of TG could not tell them apart.
    auto const first = [&](auto const& s) {
      using T = std::decay_t<decltype(s)>;
      T const x = s - T(t);
      return retract((x * x) * over<T>(bend)) * curve(s);
    };
    claim.equal("a curve with the same tangent", model, tangent(first, t).velocity, state.velocity);
    claim.differs("has another value of D_EL: the set is not in TG", model,
                  euler_lagrange(L, tangent(first, t), second_tangent(first, t).velocity), map);
    auto const other = draw.template velocity<S>(group);
    claim.differs("a tangent vector of TG that is not second order", model, other, state.velocity);
  });
}

namespace {

/// \f$\langle W, g^{-1}\hat\zeta g\rangle\f$ added to a left-invariant Lagrangian: invariant from the left under exp(t zeta) alone, as gravity is under turns about the vertical.
template <class S>
struct Upright {
  AlgebraPolynomial<S> kinetic;
  Matrix<S> weight;
  Velocity<SpannedGroup, S> zeta;
  template <class T>
  T operator()(State<SpannedGroup, T> const& v) const {
    auto const body = body_velocity(v);
    return kinetic(body) - contract(weight, v.place.group.hat(Ad(inverse(v.place), over<T>(zeta)).coordinates));
  }
};

}  // namespace

STATEMENT(claim_2_1_noether_momentum, "momentum conserved because of a symmetry") {
  claim.holds();
  claim.degree(degree_bound);
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const kinetic = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const v = draw_state<S>(draw, group);
    auto const zeta = draw.template velocity<S>(group), other = draw.template velocity<S>(group);
    auto const w = draw_change<S>(draw, group);
    auto const rate_of_momentum = [&](auto const& L, auto const& generator) {
      return noether_momentum(L, moved(v, lagrange_vector_field(L, v)), generator).part[0];
    };
    auto const law = [&](std::string const& what, auto const& L, auto const& generator) {
      auto const lifted = lifted_generator(v, generator);
      S const J = noether_momentum(L, v, generator);
      // The symmetry leaves L as it is; J is its lift contracted with theta_L; J generates it; J stays.
      claim.zero(what + ": the Lagrangian is invariant", model, L(moved(v, lifted)).part[0], size_of(J));
      claim.equal(what + ": J = lift contracted with theta_L", model, lagrange_one_form(L, v, lifted), J);
      claim.equal(what + ": lift contracted with omega_L is dJ", model, lagrange_two_form(L, v, lifted, w),
                  noether_momentum(L, moved(v, w), generator).part[0]);
      claim.zero(what + ": J is constant", model, rate_of_momentum(L, generator), size_of(J), hessian_condition);
    };
    auto const left = left_invariant(kinetic);
    auto const right = right_invariant(kinetic);
    Upright<S> const upright{kinetic, draw_matrix<S>(draw, group.matrix_size(), group.matrix_size()), zeta};
    law("multiplication from the left", left, left_translation(zeta));
    law("multiplication from the right", right, right_translation(zeta));
    law("a one-parameter group", upright, left_translation(zeta));

    // Controls: the wrong side; a direction that is no symmetry; J without the turn of the frame.
    auto const scale_of = [&](auto const& L, auto const& generator) { return size_of(noether_momentum(L, v, generator)); };
    claim.refutes("right translation of a left-invariant Lagrangian", model, rate_of_momentum(left, right_translation(zeta)),
                  scale_of(left, right_translation(zeta)));
    claim.refutes("left translation of a right-invariant Lagrangian", model, rate_of_momentum(right, left_translation(zeta)),
                  scale_of(right, left_translation(zeta)));
    claim.refutes("another direction than the symmetry's", model, rate_of_momentum(upright, left_translation(other)),
                  scale_of(upright, left_translation(other)));
  });
}
