// Section 3.1: the discrete Lagrange forms on G x G. Compiled once per scalar.
//
// Degrees. An element is a Cayley transform: entries of degree 4 at most over one denominator of degree 4. A Lagrangian on pairs is cubic in the
// entries with coefficients of degree 4 at most, so of degree 30 at most with denominators cleared; so are its derivatives.
#include "pairs.hpp"
#include "actio/variational/legendre.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// The two one-forms as functions of (g0, g1, change), for \ref exterior_derivative.
template <class Lagrangian>
auto minus_form(Lagrangian const& L) {
  return [&L](auto const& g0, auto const& g1, auto const& w) { return discrete_one_form_minus(L, g0, g1, w); };
}
template <class Lagrangian>
auto plus_form(Lagrangian const& L) {
  return [&L](auto const& g0, auto const& g1, auto const& w) { return discrete_one_form_plus(L, g0, g1, w); };
}

}  // namespace

STATEMENT(eq_3_4, "the two one-forms add up to the differential of the Lagrangian") {
  claim.holds();
  claim.degree(200);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_pair_polynomial<S>(draw, group);
    auto const g = draw_places<S>(draw, group, 2);
    auto const w = draw_changes<S>(draw, group);
    auto const dL = on_each(w, [&](auto const& u) { return rate(g, {u.first, u.second}, [&](auto const& q) { return L(q[0], q[1]); }); });
    auto const minus = on_each(w, [&](auto const& u) { return discrete_one_form_minus(L, g[0], g[1], u); });
    auto const plus = on_each(w, [&](auto const& u) { return discrete_one_form_plus(L, g[0], g[1], u); });
    claim.equal("theta- plus theta+ is dL", model, Vector<S>(minus + plus), dL);
    // Each lives in its own slot.
    auto const still = rest<S>(group);
    claim.equal("theta- is dL with the second place at rest", model, minus, on_each(w, [&](auto const& u) { return rate(g, {u.first, still}, [&](auto const& q) { return L(q[0], q[1]); }); }));
    claim.equal("theta+ is dL with the first place at rest", model, plus, on_each(w, [&](auto const& u) { return rate(g, {still, u.second}, [&](auto const& q) { return L(q[0], q[1]); }); }));
    // Controls: the sign of the momentum in theta-, the slots exchanged.
    claim.differs("theta+ minus theta-", model, Vector<S>(plus - minus), dL);
    claim.differs("slots exchanged", model, on_each(w, [&](auto const& u) { return S(pair(D1(L, g[0], g[1]), u.second) + pair(D2(L, g[0], g[1]), u.first)); }), dL);
  });
}

STATEMENT(claim_3_1_exterior_derivative_sum, "the exterior derivatives of the two one-forms cancel") {
  claim.holds();
  claim.degree(400);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_pair_polynomial<S>(draw, group);
    auto const g = draw_places<S>(draw, group, 2);
    auto const w = draw_changes<S>(draw, group);
    auto const d_minus = on_pairs(w, [&](auto const& a, auto const& b) { return exterior_derivative(minus_form(L), g[0], g[1], a, b); });
    auto const d_plus = on_pairs(w, [&](auto const& a, auto const& b) { return exterior_derivative(plus_form(L), g[0], g[1], a, b); });
    claim.zero("d theta- plus d theta+", model, Vector<S>(d_minus + d_plus), size_of(d_minus));
    // Controls: with equal signs they do not cancel, and the one-forms themselves are no negatives of each other.
    claim.refutes("d theta- minus d theta+", model, Vector<S>(d_minus - d_plus), size_of(d_minus));
    claim.differs("theta- against minus theta+", model, on_each(w, [&](auto const& u) { return discrete_one_form_minus(L, g[0], g[1], u); }),
                  on_each(w, [&](auto const& u) { return S(-discrete_one_form_plus(L, g[0], g[1], u)); }));
  });
}

STATEMENT(eq_3_5, "the discrete Lagrange two-form in coordinates") {
  claim.corrected(R"(d\theta^-_{\mathbb L}=\frac{\partial^2\mathbb L}{\partial g_k^i\,\partial g_{k+1}^j}\,dg_k^i\wedge dg_{k+1}^j)",
                  R"(d\theta^-_{\mathbb L}=\frac{\partial^2\mathbb L}{\partial g_k^i\,\partial g_{k+1}^j}\,dg_{k+1}^j\wedge dg_k^i)",
                  "The printed right side is -d theta- = d theta+ everywhere: the slip is in the definition, for with omega = d theta+ the coordinates, the chain for "
                  "symplecticity and the pull-back of -d theta_0 all hold as printed. The library keeps omega = d theta-, which is dq ^ dp, as is omega_L = -d theta_L of chapter 2.");
  claim.degree(400);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_pair_polynomial<S>(draw, group);
    auto const g = draw_places<S>(draw, group, 2);
    auto const w = draw_changes<S>(draw, group);
    // Coordinates x -> exp(x) g_k, y -> exp(y) g_{k+1}: the mixed second derivative of L along x and y, on dx^i ^ dy^j.
    auto const mixed = [&](auto const& x, auto const& y) { return L(nudged(over<Dual<S>>(g[0]), over<Dual<S>>(x)), over<Dual<Dual<S>>>(nudged(g[1], y))).part[0].part[0]; };
    auto const printed = on_pairs(w, [&](auto const& a, auto const& b) { return S(mixed(a.first, b.second) - mixed(b.first, a.second)); });

    auto const d_minus = on_pairs(w, [&](auto const& a, auto const& b) { return exterior_derivative(minus_form(L), g[0], g[1], a, b); });
    auto const d_plus = on_pairs(w, [&](auto const& a, auto const& b) { return exterior_derivative(plus_form(L), g[0], g[1], a, b); });
    auto const omega = on_pairs(w, [&](auto const& a, auto const& b) { return discrete_two_form(L, g[0], g[1], a, b); });
    claim.equal("d theta- with the later place first in the wedge", model, d_minus, Vector<S>(-printed));
    claim.equal("the library's two-form is d theta-", model, omega, d_minus);
    claim.equal("the library's two-form is -d theta+", model, omega, Vector<S>(-d_plus));
    claim.equal("the printed coordinates are those of d theta+", model, printed, d_plus);
    claim.differs("d theta- with the wedge as printed", model, printed, d_minus);
  });
}

STATEMENT(claim_3_1_pullback_canonical, "the two-form is the pull-back of the canonical one by the discrete Legendre transformation") {
  claim.convention("With the printed Legendre transformation (g_k, D_1 L) and omega = d theta- the canonical form is +d theta_0. With chapter 2's sign, -d theta_0, it takes the physical momentum, (g_k, -D_1 L).");
  claim.degree(400);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_pair_polynomial<S>(draw, group);
    auto const g = draw_places<S>(draw, group, 2);
    auto const w = draw_changes<S>(draw, group);
    // The form -d theta_0 on T*G at (g, mu), momenta carried to the identity on the right, pulled back by (g0, g1) -> (g0 or g1, momentum).
    using Covector = Momentum<SpannedGroup, S>;
    auto const pulled_back = [&](auto const& momentum, auto const& place) {
      auto const mu = momentum(g[0], g[1]);
      auto const change = [&](Change<S> const& u) { return Covector{group, rates(momentum(nudged(g[0], u.first), nudged(g[1], u.second)))}; };
      return on_pairs(w, [&](auto const& a, auto const& b) { return S(pair(change(b), place(a)) - pair(change(a), place(b)) - pair(mu, bracket(place(a), place(b)))); });
    };
    auto const first = [](Change<S> const& u) { return u.first; };
    auto const second = [](Change<S> const& u) { return u.second; };
    auto const omega = on_pairs(w, [&](auto const& a, auto const& b) { return discrete_two_form(L, g[0], g[1], a, b); });
    auto const printed = pulled_back([&](auto const& g0, auto const& g1) { return D1(L, g0, g1); }, first);
    claim.equal("d theta_0 by (g_k, D_1 L)", model, Vector<S>(-printed), omega);
    claim.equal("-d theta_0 by (g_k, -D_1 L)", model, pulled_back([&](auto const& g0, auto const& g1) { return legendre_source(L, g0, g1); }, first), omega);
    claim.equal("-d theta_0 by (g_{k+1}, D_2 L)", model, pulled_back([&](auto const& g0, auto const& g1) { return legendre_target(L, g0, g1); }, second), omega);
    // The one-form comes back as well: theta_0 by (g_k, D_1 L) is theta-.
    claim.equal("theta_0 by (g_k, D_1 L) is theta-", model, on_each(w, [&](auto const& u) { return pair(-legendre_source(L, g[0], g[1]), u.first); }), on_each(w, [&](auto const& u) { return discrete_one_form_minus(L, g[0], g[1], u); }));
    claim.differs("-d theta_0 by (g_k, D_1 L)", model, printed, omega);
  });
}

namespace {

/// \f$L(g_0, g_1) = \mathrm{tr}(g_0g_1^{-1})\f$, which on SO(3) depends on the angle between the two places alone.
inline constexpr auto trace_lagrangian = [](auto const& g0, auto const& g1) { return (g0 * inverse(g1)).value.trace(); };
/// \f$-\tfrac12|g_1 - g_0|^2\f$, entry by entry.
inline constexpr auto squared_distance = [](auto const& g0, auto const& g1) {
  auto const d = (g1.value - g0.value).eval();
  typename std::decay_t<decltype(g0)>::Scalar sum(0);
  for (Eigen::Index i = 0; i < d.rows(); ++i)
    for (Eigen::Index j = 0; j < d.cols(); ++j) sum -= d(i, j) * d(i, j) / 2;
  return sum;
};
template <class S>
S determinant(Matrix<S> const& m) {
  // Expand along the first row: for the few small matrices here.
  if (m.rows() == 1) return m(0, 0);
  S sum(0);
  for (Eigen::Index j = 0; j < m.cols(); ++j) {
    Matrix<S> minor(m.rows() - 1, m.cols() - 1);
    for (Eigen::Index i = 1; i < m.rows(); ++i)
      for (Eigen::Index k = 0, c = 0; k < m.cols(); ++k)
        if (k != j) minor(i - 1, c++) = m(i, k);
    S const term = m(0, j) * determinant(minor);
    if (j % 2 == 0) sum += term;
    else sum -= term;
  }
  return sum;
}

}  // namespace

STATEMENT(rem_3_1_2, "near the diagonal a regular Lagrangian gives a nondegenerate form, far from it perhaps not") {
  claim.convention("Where the Lagrangian is regular near the diagonal, as one that comes from a regular Lagrangian on TG with a short step is. The form itself is defined everywhere; "
                   "it must degenerate somewhere if G is compact (an exact form on a closed manifold), and need not elsewhere. Instances: tr(g_0 g_1^-1) on SO(3) degenerates at quarter turns, the squared distance on the Heisenberg group nowhere.");
  claim.degree(2000);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    // On the diagonal h D2 D1 L is minus the fibre Hessian, plus h times a remainder that is affine in h: the potential's second derivative comes with h.
    auto const lagrangian = draw_state_polynomial<S>(draw, group);
    auto const g = draw.template element<S>(group);
    State<SpannedGroup, S> const at_rest{g, rest<S>(group)};
    Matrix<S> const hessian = fibre_hessian(lagrangian, at_rest);
    auto const remainder = [&](S const& h) { return Matrix<S>((h * mixed_derivative(discretize_at_the_place(lagrangian, h), g, g) + hessian) / h); };
    claim.equal("on the diagonal h D2 D1 L tends to minus the fibre Hessian", model, Matrix<S>(remainder(ratio<S>(1, 2)) + remainder(ratio<S>(1, 6))), Matrix<S>(remainder(ratio<S>(1, 3)) * S(2)));
    // So for a short step it has an inverse, as the Hessian (positive definite here) has.
    Matrix<S> const m = mixed_derivative(discretize_at_the_place(lagrangian, ratio<S>(1, 1000)), g, g), one = Matrix<S>::Identity(m.rows(), m.cols());
    claim.equal("nondegenerate on the diagonal for a short step", model, Matrix<S>(m * inverse_matrix(m)), one);
    // Controls: the Hessian with the other sign; a Lagrangian that couples its places in no way.
    claim.differs("on the diagonal h D2 D1 L tends to the fibre Hessian", model, Matrix<S>(m / S(1000)), hessian);
    auto const apart = [](auto const& g0, auto const& g1) { return g0.value(0, 0) + g1.value(0, 1) * g1.value(0, 0); };
    claim.template refuses<Singular>("a Lagrangian that is not regular", model, [&] { inverse_matrix(Matrix<S>(mixed_derivative(apart, g, g)), "D2 D1 L"); });
  });

  // Away from the diagonal on SO(3): the determinant is 4 cos(phi) (1 + cos(phi)), zero at a quarter turn.
  SpannedGroup const so3 = all_groups()[0];
  for (int point = 0; point < (is_exact<S> ? exact_points : 2); ++point) {
    auto const g0 = draw.template element<S>(so3, S(1)), g1 = draw.template element<S>(so3, S(1));
    S const cosine = (trace_lagrangian(g0, g1) - S(1)) / S(2);
    S const det = determinant<S>(mixed_derivative(trace_lagrangian, g0, g1)), expected = S(4) * cosine * (S(1) + cosine);
    // The form's determinant is the square of this one: build it from the two-form on the basis.
    Matrix<S> form(6, 6);
    auto const basis = [&](int a) { return Change<S>{a < 3 ? basis_velocity<S>(so3, a) : rest<S>(so3), a < 3 ? rest<S>(so3) : basis_velocity<S>(so3, a - 3)}; };
    for (int a = 0; a < 6; ++a)
      for (int b = 0; b < 6; ++b) form(a, b) = discrete_two_form(trace_lagrangian, g0, g1, basis(a), basis(b));
    claim.zero("determinant of D2 D1 L against the angle", "SO(3)", S(det - expected), S(8));
    claim.zero("determinant of the form is its square", "SO(3)", S(determinant(form) - det * det), S(64));
    claim.refutes("determinant at a random pair", "SO(3)", det, S(8));

    // At a quarter turn the axis is a null direction of the form, and the flow is refused.
    Matrix<S> quarter(3, 3);
    quarter << S(0), S(-1), S(0), S(1), S(0), S(0), S(0), S(0), S(1);
    Place<S> const turned = Place<S>{so3, quarter} * g0;
    auto const axis = basis_velocity<S>(so3, 2);
    auto const any = draw_changes<S>(draw, so3)[0];
    claim.zero("a null vector at a quarter turn", "SO(3)", discrete_two_form(trace_lagrangian, g0, turned, {axis, axis}, any), S(2));
    claim.refutes("the same vector at a random pair", "SO(3)", discrete_two_form(trace_lagrangian, g0, g1, {axis, rest<S>(so3)}, {rest<S>(so3), axis}), S(2));
    auto const here = identity<S>(so3);
    claim.template refuses<Singular>("the flow into a quarter turn", "SO(3)", [&] { discrete_flow_tangent(trace_lagrangian, here, here, Place<S>{so3, quarter}, any); });
  }
  // Nowhere degenerate: the squared distance on the Heisenberg group, at places far apart.
  SpannedGroup const heisenberg = all_groups().back();
  for (int point = 0; point < (is_exact<S> ? exact_points : 2); ++point) {
    auto const g0 = draw.template element<S>(heisenberg, S(50)), g1 = draw.template element<S>(heisenberg, S(50));
    // Terms reach the fourth power of the distance.
    claim.equal("determinant 1 at places far apart", "Heisenberg", determinant<S>(mixed_derivative(squared_distance, g0, g1)), S(1), 1e7);
  }
}
