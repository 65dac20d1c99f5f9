// Scalars: rational, double (long: dec50, dec100)
// Section 2.2: Euler-Poincare reduction. Compiled once per scalar.
//
// Degrees: an element is a product of at most five quotients of polynomials of degree 4, its second rates have degree below 60, a reduced Lagrangian is cubic.
#include "actio/variational/action.hpp"
#include "actio/variational/euler_lagrange.hpp"
#include "actio/variational/euler_poincare.hpp"
#include "charts.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

constexpr int degree_bound = 1000;
/// Solving with a Hessian magnifies rounding by its condition, about 30 for these Lagrangians.
constexpr double hessian_condition = 30;

/// A polynomial of second degree in t with values in the algebra, times (t - a)(t - b) where `fixed`.
template <class S>
auto draw_path(Draw& draw, SpannedGroup const& group, S const& a, S const& b, bool fixed) {
  auto const x = draw.velocity<S>(group), y = draw.velocity<S>(group), z = draw.velocity<S>(group);
  return [=](auto const& t) {
    using T = std::decay_t<decltype(t)>;
    T const ends = fixed ? T((t - T(a)) * (t - T(b))) : T(1);
    return ends * (over<T>(x) + t * (over<T>(y) + t * over<T>(z)));
  };
}
/// l(xi + epsilon delta), its part along epsilon.
template <class S, class F>
S change_along(F const& l, Velocity<SpannedGroup, S> const& xi, Velocity<SpannedGroup, S> const& delta) {
  Velocity<SpannedGroup, Dual<S>> moving_xi{xi.group, moving(xi.coordinates, delta.coordinates)};
  return l(moving_xi).part[0];
}

}  // namespace

STATEMENT(thm_2_2_1, "Euler-Poincare reduction: four conditions on a curve") {
  claim.convention(
      "With variations eta' - ad_xi eta in condition iv, its first expression; the second one, eta' + [xi, eta], has the wrong sign "
      "(claim_2_2_reduced_variation_bracket).");
  claim.degree(degree_bound);
  // A cubic reduced Lagrangian along a path of degree 2, varied by one of degree 6.
  Quadrature<S> const rule(14);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const L = right_invariant(l);

    // i and iii: (2.4) in a chart is the reduced equation, off shell, so one vanishes where the other does (the frame has an inverse).
    auto const chart = chart_right(draw.template element<S>(group));
    Vector<S> const q = draw_vector<S>(draw, group.dimension()) * ratio<S>(1, 2), v = draw_vector<S>(draw, group.dimension()),
                    a = draw_vector<S>(draw, group.dimension());
    auto const xi = state_in(chart, q, v).velocity, xi_rate = acceleration_in(chart, q, v, a);
    Matrix<S> const columns = frame(chart, q);
    Vector<S> const full = euler_lagrange_in_coordinates(in_coordinates(L, chart), q, v, a);
    claim.equal("i and iii: (2.4) = - frame^T (d/dt dl/dxi + ad* dl/dxi)", model, full,
                Vector<S>(-columns.transpose() * euler_poincare_right(l, xi, xi_rate).components));

    // ii and iv: every variation of g gives xi the variation eta' - ad_xi eta, so the actions vary alike.
    auto const curve = draw_curve<S>(draw, group);
    auto const family = draw_family<S>(draw, group, curve);
    S const t = ratio<S>(1, 3);
    auto const eta = [&](auto const& s) { return lifted_variation(family, s).place; };
    auto const velocity = tangent(curve, t).velocity;
    S const varied = L(varied_tangent(family, t)).part[0];
    claim.equal("ii and iv: the integrands vary alike", model, varied,
                change_along<S>(l, velocity, reduced_variation_right(velocity, eta(t), rate_along(eta, t))));

    // iii and iv: integrate by parts along a path in the algebra, eta zero at the ends.
    S const from = ratio<S>(-1, 2), to = ratio<S>(1, 2);
    auto const path = draw_path<S>(draw, group, from, to, false), test = draw_path<S>(draw, group, from, to, true);
    auto const delta_with = [&](S const& sign, S const& s) { return rate_along(test, s) - sign * bracket(path(s), test(s)); };
    auto const reduced = [&](S const& sign) {
      return rule([&](S const& s) { return change_along<S>(l, path(s), delta_with(sign, s)); }, from, to);
    };
    S const against = rule([&](S const& s) { return pair(euler_poincare_right(l, path(s), rate_along(path, s)), test(s)); }, from, to);
    claim.equal("iii and iv: integrated by parts", model, reduced(S(1)), S(-against), 10);

    // Controls: the sign printed second in iv; the equation of left-invariant systems.
    claim.differs("variations eta' + [xi, eta]", model, reduced(S(-1)), S(-against));
    claim.differs("the equation with - ad*", model, full, Vector<S>(-columns.transpose() * euler_poincare_left(l, xi, xi_rate).components));
    claim.differs("a left-invariant Lagrangian", model, euler_lagrange_in_coordinates(in_coordinates(left_invariant(l), chart), q, v, a),
                  full);
  });
}

STATEMENT(claim_2_2_euler_poincare_equations, "the Euler-Poincare equations are the Euler-Lagrange equations of an invariant Lagrangian") {
  claim.holds(
      "For right-invariant Lagrangians; the paragraph before the theorem speaks of left-invariant ones, for which ad* has the other sign "
      "and xi = g^-1 g' (also confirmed).");
  claim.degree(degree_bound);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const v = draw_state<S>(draw, group);

    // Right: the acceleration of the full system is that of the reduced one.
    auto const full = lagrange_acceleration(right_invariant(l), v), reduced = euler_poincare_acceleration_right(l, v.velocity);
    claim.equal("right-invariant: xi' of the reduced and of the full equations", model, full, reduced, hessian_condition);
    claim.zero("it solves d/dt dl/dxi + ad* dl/dxi = 0", model, euler_poincare_right(l, v.velocity, full),
               size_of(ad_star(v.velocity, gradient(l, v.velocity))), hessian_condition);
    // The rate of the momentum written out: minus the commutator with the velocity, transposed, on matrices.
    auto const rate_by_hand = [&](Velocity<SpannedGroup, S> const& xi) {
      auto const mu = gradient(l, xi);
      Vector<S> rate_of_mu(group.dimension());
      Matrix<S> const x = group.hat(xi.coordinates);
      for (int a = 0; a < group.dimension(); ++a) {
        Matrix<S> const e = group.hat(basis_velocity<S>(group, a).coordinates);
        rate_of_mu[a] = -mu.components.dot(group.vee(Matrix<S>(x * e - e * x)));
      }
      return rate_of_mu;
    };
    Vector<S> const momentum_rate = Matrix<S>(hessian(l, v.velocity)) * full.coordinates;
    claim.equal("rate of dl/dxi = - ad* dl/dxi, by commutators", model, momentum_rate, rate_by_hand(v.velocity), hessian_condition);
    // Left: xi = g^-1 g', whose rate is that of the full system carried to the body, Ad commuting with its own velocity.
    auto const body = body_velocity(v);
    auto const body_rate = Ad(inverse(v.place), lagrange_acceleration(left_invariant(l), v));
    claim.equal("left-invariant: the same with the other sign", model, body_rate, euler_poincare_acceleration_left(l, body),
                10 * hessian_condition);

    // Controls: sides exchanged; ad in place of its dual.
    claim.differs("+ ad* for a right-invariant Lagrangian", model, Vector<S>(-rate_by_hand(v.velocity)), momentum_rate);
    claim.differs("the star lost", model, Vector<S>(-ad_matrix(v.velocity) * gradient(l, v.velocity).components), momentum_rate);
  });
}
