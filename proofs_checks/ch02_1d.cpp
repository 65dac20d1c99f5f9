// Scalars: rational, double (long: dec50, dec100)
// Section 2.1, at a point: the theorem on the variation of the action, and that its map and its form are the only ones. Compiled once per scalar.
//
// Every identity is one between derivatives at a random point, so it is exact over the rationals on every group. Degrees: an element is a product of at most five
// quotients of polynomials of degree 4, its third rates have degree below 60, a Lagrangian is cubic in rates and quadratic in entries,
// eliminating among 18 variations multiplies the degree by eighteen.
#include "actio/variational/curves.hpp"
#include "actio/variational/euler_lagrange.hpp"
#include "actio/variational/lagrange_forms.hpp"
#include "charts.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

constexpr int degree_bound = 2500;
/// \f$(\xi_0)_+^{k+1}\f$ for k = 2, on one side of its seam: a Lagrangian with two continuous derivatives and no more.
template <class S>
struct SideOfSeam {
  bool positive;
  template <class T>
  T operator()(State<SpannedGroup, T> const& v) const {
    T const x = v.velocity.coordinates[0];
    return positive ? x * x * x : T(0) * x;
  }
};

}  // namespace

STATEMENT(thm_2_1_1, "the Euler-Lagrange map and the Lagrange one-form from the variation of the action") {
  claim.convention(
      "With the second-order set inside TTG rather than TG, and the lifted variation taken at t rather than at 0: "
      "claim_2_1_second_order_set, claim_2_1_lifted_variation.");
  claim.degree(degree_bound);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_state_polynomial<S>(draw, group);
    auto const curve = draw_curve<S>(draw, group);
    auto const family = draw_family<S>(draw, group, curve);
    S const t = ratio<S>(1, 3);

    // (2.6) for all intervals is its derivative at the upper end, for all t: the rate of the boundary term and the Euler-Lagrange term.
    S const variation = L(varied_tangent(family, t)).part[0];
    Dual<S> time(t);
    time.part[0] = S(1);
    S const boundary_rate = lagrange_one_form(L, tangent(curve, time), lifted_variation(family, time)).part[0];
    auto const state = tangent(curve, t);
    auto const acceleration = second_tangent(curve, t).velocity;
    S const inside = pair(euler_lagrange(L, state, acceleration), lifted_variation(family, t).place);
    claim.equal("(2.6), differentiated by its upper end", model, variation, S(inside + boundary_rate));
    // Controls: the sign of the map; the one-form of another Lagrangian.
    claim.differs("D_EL with the other sign", model, variation, S(boundary_rate - inside));
    claim.differs("boundary term left out", model, variation, inside);
  });

  // A C^k Lagrangian has a C^{k-2} map and a C^{k-1} form, and no better: k = 2 at the seam of x_+^3, where the two sides agree to that order.
  auto const group = spanned("Aff(1)", Aff1{});
  auto v = draw_state<S>(draw, group);
  v.velocity.coordinates[0] = S(0);
  StateChange<SpannedGroup, S> const across{draw.template velocity<S>(group), basis_velocity<S>(group, 0)};
  StateChange<SpannedGroup, Dual<S>> const again{over<Dual<S>>(across.place), over<Dual<S>>(across.velocity)};
  auto const acceleration = draw.template velocity<S>(group);
  SideOfSeam<S> const above{true}, below{false};
  auto const map_jump = euler_lagrange(above, v, acceleration) - euler_lagrange(below, v, acceleration);
  auto const form_jump = rate(legendre(above, moved(v, across))) - rate(legendre(below, moved(v, across)));
  auto const map_slope = euler_lagrange(above, moved(v, across), over<Dual<S>>(acceleration)) -
                         euler_lagrange(below, moved(v, across), over<Dual<S>>(acceleration));
  claim.zero("L of class C^2: D_EL is continuous", "seam of x^3", map_jump, S(1));
  claim.zero("L of class C^2: theta_L has one derivative", "seam of x^3", form_jump, S(1));
  claim.refutes("D_EL has a derivative", "seam of x^3", map_slope, size_of(acceleration));
  claim.refutes("theta_L has two derivatives", "seam of x^3",
                rate(rate(legendre(above, moved(moved(v, across), again)))) - rate(rate(legendre(below, moved(moved(v, across), again)))),
                S(1));
}

STATEMENT(claim_2_1_el_map_and_form_unique, "there is one Euler-Lagrange map and one Lagrange one-form") {
  claim.holds("The action determines both; the equations of motion alone do not determine the form.");
  claim.degree(degree_bound);
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_state_polynomial<S>(draw, group);
    auto const curve = draw_curve<S>(draw, group);
    int const n = group.dimension();
    S const t = ratio<S>(1, 3);
    Dual<S> time(t);
    time.part[0] = S(1);

    // Suppose d/de L = <D, theta> + d/dt <alpha, theta> + d/dt <beta, theta'> for all variations. The right side is linear in (theta, theta', theta''); as many
    // variations as there are unknown coefficients determine them.
    Matrix<S> rows(3 * n, 3 * n);
    Vector<S> response(3 * n);
    for (int i = 0; i < 3 * n; ++i) {
      auto const family = draw_family<S>(draw, group, curve);
      auto const theta = [&](auto const& s) { return lifted_variation(family, s).place; };
      auto const theta_rate = [&](auto const& s) {
        using T = std::decay_t<decltype(s)>;
        Dual<T> moving_time(s);
        moving_time.part[0] = T(1);
        return rate(theta(moving_time));
      };
      rows.row(i) << theta(t).coordinates.transpose(), theta_rate(t).coordinates.transpose(),
          rate(theta_rate(time)).coordinates.transpose();
      response[i] = L(varied_tangent(family, t)).part[0];
    }
    // A system of random rows of up to 18 unknowns loses a few digits.
    double const condition = 1e4;
    Vector<S> const found = solve_linear(rows, response, "variations must be independent");

    // beta = 0; alpha is the one-form of the library; what is left at theta is D + alpha'.
    auto const state = tangent(curve, t);
    auto const mu = legendre(L, state), mu_rate = rate(legendre(L, tangent(curve, time)));
    auto const map = euler_lagrange(L, state, second_tangent(curve, t).velocity);
    claim.zero("the form does not see changes of the velocity", model, Vector<S>(found.tail(n)), size_of(mu), condition);
    claim.equal("the only form is theta_L", model, Vector<S>(found.segment(n, n)), mu.components, condition);
    claim.equal("the only map is D_EL L", model, Vector<S>(found.head(n) - mu_rate.components), map.components, condition);

    // Control: L + d/dt f has the same map and another form, so that the map of the one with the form of the other do not add up.
    Matrix<S> const weights = draw_matrix<S>(draw, group.matrix_size(), group.matrix_size());
    auto const gauged = [&](auto const& v) {
      using T = typename std::decay_t<decltype(v)>::Scalar;
      Matrix<T> const g = v.place.value, g_rate = group.hat(v.velocity.coordinates) * g;
      return L(v) + contract(weights, g) * contract(weights, g_rate);
    };
    claim.equal("a total derivative does not change the map", model, euler_lagrange(gauged, state, second_tangent(curve, t).velocity), map);
    claim.differs("but it changes the form", model, legendre(gauged, state), mu);
    claim.refutes("map without the rate of the form", model, Vector<S>(found.head(n) - map.components), size_of(map));
  });
}
