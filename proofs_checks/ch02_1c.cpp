// Scalars: rational, double (long: dec50, dec100)
// Section 2.1, at a point: the Euler-Lagrange equations, charts, regularity, the Lagrange vector field. Compiled once per scalar.
//
// Every identity is one between derivatives at a random point, so it is exact over the rationals on every group. Degrees: an element is a product of at most three
// quotients of polynomials of degree 4, its second rates have degree below 40, a Lagrangian is cubic in rates and quadratic in entries, an inverse of a Hessian of 6 rows
// multiplies the degree by six.
#include "actio/variational/curves.hpp"
#include "actio/variational/euler_lagrange.hpp"
#include "actio/variational/lagrange_forms.hpp"
#include "charts.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

constexpr int degree_bound = 1500;
/// Solving with a fibre Hessian magnifies rounding by its condition, about 30 for these Lagrangians.
constexpr double hessian_condition = 30;

/// Coordinates of a second-order jet of a curve.
template <class S>
struct Jet {
  Vector<S> q, v, a;
};
template <class S>
Jet<S> draw_jet(Draw& draw, int n) {
  auto const q = draw_vector<S>(draw, n), v = draw_vector<S>(draw, n);
  return {q * ratio<S>(1, 2), v * S(2), draw_vector<S>(draw, n)};
}

}  // namespace

STATEMENT(eq_2_4, "Euler-Lagrange equations in coordinates, and without") {
  claim.holds();
  claim.degree(degree_bound);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_state_polynomial<S>(draw, group);
    auto const chart = chart_right(draw.template element<S>(group));
    auto const [q, v, a] = draw_jet<S>(draw, group.dimension());
    auto const state = state_in(chart, q, v);
    auto const acceleration = acceleration_in(chart, q, v, a);
    Matrix<S> const back = frame(chart, q).transpose();

    // The covector of the library, read in the chart, is dL/dq - d/dt dL/dq'.
    Vector<S> const coordinates = euler_lagrange_in_coordinates(in_coordinates(L, chart), q, v, a);
    auto const intrinsic = euler_lagrange(L, state, acceleration);
    claim.equal("D_EL L in a chart is (2.4)", model, Vector<S>(back * intrinsic.components), coordinates);
    // Controls: the turning of the frame left out, or counted with the other sign.
    auto const turning = ad_star(state.velocity, legendre(L, state));
    claim.differs("without ad*", model, Vector<S>(back * (intrinsic + turning).components), coordinates);
    claim.differs("+ ad* instead of - ad*", model, Vector<S>(back * (intrinsic + S(2) * turning).components), coordinates);
  });
}

STATEMENT(claim_2_1_regular_second_order_ode, "regular Lagrangians have second-order equations") {
  claim.holds("Where the matrix has an inverse; the acceleration is then a function of the state.");
  claim.degree(degree_bound);
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_state_polynomial<S>(draw, group);
    auto const chart = chart_right(draw.template element<S>(group));
    auto const [q, v, a] = draw_jet<S>(draw, group.dimension());
    auto const state = state_in(chart, q, v);
    int const n = group.dimension();

    // The fibre Hessian is d2L/dq'dq' read in the chart, and symmetric.
    auto const f = in_coordinates(L, chart);
    Matrix<S> in_chart(n, n), const_frame = frame(chart, q), hessian = fibre_hessian(L, state);
    for (int i = 0; i < n; ++i)
      in_chart.col(i) = rates(momenta(f, moving(q, Vector<S>(Vector<S>::Zero(n))), moving(v, Vector<S>(Vector<S>::Unit(n, i)))));
    claim.equal("fibre Hessian = d2L/dq'dq'", model, Matrix<S>(const_frame.transpose() * hessian * const_frame), in_chart);
    claim.equal("symmetric", model, hessian, Matrix<S>(hessian.transpose()));
    // The equation is affine in the acceleration, with this matrix in front, so it has one solution.
    auto const acceleration = lagrange_acceleration(L, state);
    auto const other = acceleration_in(chart, q, v, a);
    claim.zero("the equation solved for the acceleration", model, euler_lagrange(L, state, acceleration),
               size_of(euler_lagrange(L, state, other)), hessian_condition);
    claim.equal("any other acceleration misses by the Hessian", model, euler_lagrange(L, state, other).components,
                Vector<S>(hessian * (acceleration - other).coordinates), hessian_condition);
    // Controls: another acceleration; a Lagrangian blind to one direction of the velocity.
    claim.refutes("another acceleration", model, euler_lagrange(L, state, other), size_of(ad_star(state.velocity, legendre(L, state))));
    auto singular = L;
    singular.kinetic.c.setZero();
    singular.kinetic.a.row(0).setZero(), singular.kinetic.a.col(0).setZero();
    claim.template refuses<Singular>("a Lagrangian that is not regular", model, [&] { lagrange_acceleration(singular, state); });
  });
}

STATEMENT(claim_2_1_action_chart_independent, "action and equations in two charts") {
  claim.holds("The left side of (2.4) is a covector; the second derivatives in it are those of one curve in both charts.");
  claim.degree(degree_bound);
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_state_polynomial<S>(draw, group);
    auto const h = draw.template element<S>(group), k = draw.template element<S>(group);
    auto const first = chart_right(h), second = chart_left(k);
    auto const [q, v, small] = draw_jet<S>(draw, group.dimension());
    // Turning fast and speeding up slowly, so that what charts do to accelerations counts.
    Vector<S> const a = small * ratio<S>(1, 4);
    int const n = group.dimension();

    // The change of charts r(q), and the curve in the second one.
    auto const change = [&](auto const& x) {
      using T = typename std::decay_t<decltype(x)>::Scalar;
      return Vector<T>(coordinates_left(k)(first(x)));
    };
    auto const carried = change(moving(moving(q, v), moving(v, a)));
    Vector<S> const r = values(values(carried)), r1 = rates(values(carried)), r2 = rates(rates(carried));
    Matrix<S> jacobian(n, n);
    for (int i = 0; i < n; ++i) jacobian.col(i) = rates(change(moving(q, Vector<S>(Vector<S>::Unit(n, i)))));

    auto const L1 = in_coordinates(L, first), L2 = in_coordinates(L, second);
    // Two charts and an inverse Cayley transform between them: a few digits' worth of elimination.
    claim.equal("the integrand of (2.1)", model, L1(q, v), L2(r, r1), hessian_condition);
    Vector<S> const e1 = euler_lagrange_in_coordinates(L1, q, v, a), e2 = euler_lagrange_in_coordinates(L2, r, r1, r2);
    claim.equal("(2.4) is a covector", model, e1, Vector<S>(jacobian.transpose() * e2), hessian_condition);
    // Controls: carried like a vector; the second derivative carried as if it were a vector.
    claim.differs("carried like a vector", model, e1, Vector<S>(inverse_matrix(jacobian) * e2));
    Vector<S> const none = Vector<S>::Zero(n), as_vector = jacobian * a;
    auto const with = [&](Vector<S> const& second_rate) { return euler_lagrange_in_coordinates(L2, r, r1, second_rate); };
    claim.refutes("acceleration carried like a vector", model, Vector<S>(e1 - jacobian.transpose() * with(as_vector)),
                  size_of(Vector<S>(with(as_vector) - with(none))));
  });
}

STATEMENT(claim_2_1_lagrange_vector_field, "the Lagrange vector field of a regular Lagrangian") {
  claim.holds();
  claim.degree(degree_bound);
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_state_polynomial<S>(draw, group);
    auto const chart = chart_right(draw.template element<S>(group));
    int const n = group.dimension();
    auto const [q, v, a] = draw_jet<S>(draw, n);
    auto const state = state_in(chart, q, v);
    auto const f = in_coordinates(L, chart);

    // omega_L is dq ^ d(dL/dq'), written in the chart.
    auto const in_chart = [&](Vector<S> const& dq, Vector<S> const& dv) {
      auto const moved_state = state_in(chart, moving(q, dq), moving(v, dv));
      return change_of(moved_state);
    };
    Vector<S> const dq1 = draw_vector<S>(draw, n), dv1 = draw_vector<S>(draw, n), dq2 = draw_vector<S>(draw, n),
                    dv2 = draw_vector<S>(draw, n);
    auto const w1 = in_chart(dq1, dv1), w2 = in_chart(dq2, dv2);
    auto const dp = [&](Vector<S> const& dq, Vector<S> const& dv) { return rates(momenta(f, moving(q, dq), moving(v, dv))); };
    claim.equal("theta_L = (dL/dq') dq", model, lagrange_one_form(L, state, w1), S(momenta(f, q, v).dot(dq1)));
    claim.equal("omega_L = dq ^ dp", model, lagrange_two_form(L, state, w1, w2), S(dq1.dot(dp(dq2, dv2)) - dq2.dot(dp(dq1, dv1))));

    // X_E contracted with omega_L is dE; the matrix of omega_L has an inverse, so no other field does it.
    auto const X = lagrange_vector_field(L, state);
    auto const dE = [&](auto const& w) { return energy(L, moved(state, w)).part[0]; };
    claim.equal("X_E contracted with omega_L is dE", model, lagrange_two_form(L, state, X, w1), dE(w1), hessian_condition);
    if (n <= 3) {
      Matrix<S> omega(2 * n, 2 * n);
      Vector<S> slope(2 * n);
      auto const unit = [&](int i) {
        return StateChange<SpannedGroup, S>{{group, i < n ? Vector<S>(Vector<S>::Unit(n, i)) : Vector<S>(Vector<S>::Zero(n))},
                                            {group, i < n ? Vector<S>(Vector<S>::Zero(n)) : Vector<S>(Vector<S>::Unit(n, i - n))}};
      };
      for (int i = 0; i < 2 * n; ++i) {
        slope[i] = dE(unit(i));
        for (int j = 0; j < 2 * n; ++j) omega(i, j) = lagrange_two_form(L, state, unit(j), unit(i));
      }
      Vector<S> x(2 * n);
      x << X.place.coordinates, X.velocity.coordinates;
      claim.equal("the only solution of X contracted with omega_L = dE", model, solve_linear(omega, slope), x, hessian_condition);
    }
    // Its integral curves solve (2.4), read in the chart: find q'' with this xi'.
    Matrix<S> const columns = frame(chart, q);
    Vector<S> const none = Vector<S>::Zero(n);
    Vector<S> const second = solve_linear(columns, Vector<S>((X.velocity - acceleration_in(chart, q, v, none)).coordinates));
    claim.zero("integral curves solve (2.4)", model, euler_lagrange_in_coordinates(f, q, v, second),
               size_of(euler_lagrange_in_coordinates(f, q, v, none)), hessian_condition);

    // Controls: the other sign of omega_L; a field that is not second order; no field where L is not regular.
    claim.differs("omega_L = + d theta_L", model, S(-lagrange_two_form(L, state, X, w1)), dE(w1));
    claim.differs("acceleration left out", model, lagrange_two_form(L, state, {X.place, S(0) * X.velocity}, w1), dE(w1));
    auto singular = L;
    singular.kinetic.c.setZero();
    singular.kinetic.a.row(0).setZero(), singular.kinetic.a.col(0).setZero();
    claim.template refuses<Singular>("a Lagrangian that is not regular", model, [&] { lagrange_vector_field(singular, state); });
  });
}
