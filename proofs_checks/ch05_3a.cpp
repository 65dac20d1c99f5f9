// Section 5.3, first part: Casimirs on the dual of the rotation algebra and on the group. Compiled once per scalar.
//
// Momenta are those of the scaled Lagrangian Tr(f Lambda): h times the physical ones. SO(4) and SO(5) have two Casimirs, and what print says of SO(3) is tried on them too.
// Degrees: those of generalized_bodies.hpp; the inverse of a matrix of 20 second derivatives, each of degree 6, stays below as well.
#include "actio/reduction/discrete_poisson.hpp"
#include "actio/rigid_body/casimirs.hpp"
#include "actio/variational/coadjoint_orbit.hpp"
#include "actio/variational/lie_poisson.hpp"
#include "generalized_bodies.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

inline constexpr auto all_casimirs = [](auto const& mu) { return casimirs(mu); };
/// How many independent Casimirs so(n)* has.
inline int casimir_count(int n) { return n / 2; }
/// \f$\mathrm{Tr}(f\Lambda f\Lambda)\f$ written out, as a column of one: not through the library's.
template <class S>
auto printed_casimir(Matrix<S> const& lambda) {
  return [lambda](auto const& f) {
    using T = typename std::decay_t<decltype(f)>::Scalar;
    Vector<T> value = Vector<T>::Zero(1);
    int const n = static_cast<int>(lambda.rows());
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) value[0] += f.value(i, j) * f.value(j, i) * T(S(lambda(i, i) * lambda(j, j)));
    return value;
  };
}

}  // namespace

STATEMENT(claim_5_3_dual_casimir, "trace Casimir on the dual algebra and its expression in R^3") {
  claim.corrected(R"(C_{\mathfrak{so}(3)^*}(y) = \|y\|^2)", R"(C_{\mathfrak{so}(3)^*}(y) = \mathrm{Tr}(\mu^2) = -2\|y\|^2)",
                  "Either is a Casimir, but they are not the same function: the square of a skew matrix has no positive trace. Spheres and area form are right; the Kirillov-Kostant form is "
                  "the area form over the radius.");
  claim.degree(100);
  over_bodies(claim, [&](int n, auto const& model) {
    Turns const group{n};
    auto const mu = draw.template momentum<S>(group);
    S const square = mu.components.dot(mu.components);
    claim.equal("Tr mu^2 = -2 |mu|^2", model, trace_of_square(mu), S(-S(2) * square));
    claim.differs("Tr mu^2 = |y|^2, as printed", model, trace_of_square(mu), square);
    // A Casimir: its bracket with every function vanishes, and it is constant on orbits.
    auto const tensor = lie_poisson_tensor_plus(mu);
    auto const trace = [](auto const& nu) {
      Vector<typename std::decay_t<decltype(nu)>::Scalar> value(1);
      value[0] = trace_of_square(nu);
      return value;
    };
    claim.zero("bracket of Tr mu^2 with all coordinates", model, Matrix<S>(differentials(trace, mu) * tensor), S(1));
    claim.zero("the same for every Casimir of the library", model, Matrix<S>(differentials(all_casimirs, mu) * tensor), S(1));
    claim.equal("all of them constant on coadjoint orbits", model, casimirs(Ad_star(draw_turn<S>(draw, n), mu)), casimirs(mu));
    if (n > 3) {
      // Newton's identity for the fourth power; on SO(4) the second Casimir is the Pfaffian, and its square is the coefficient.
      auto const m = as_matrix(mu);
      Vector<S> const c = casimirs(mu);
      S const fourth = n == 4 ? S(c[1] * c[1]) : c[1];
      claim.equal("Tr mu^4 by the two Casimirs", model, S((m * m * m * m).trace()), S(S(2) * c[0] * c[0] - S(4) * fourth));
      claim.differs("Tr mu^4 by the first alone", model, S((m * m * m * m).trace()), S(S(2) * c[0] * c[0]));
    }
    // There is no other: the bracket has as many directions less.
    if constexpr (is_exact<S>) {
      claim.fact("rank of the bracket: dimension less floor(n/2)", model, exact_rank(tensor) == group.dimension() - casimir_count(n));
      claim.fact("the Casimirs are independent", model, exact_rank(differentials(all_casimirs, mu)) == casimir_count(n));
    }
    Matrix<S> other = Matrix<S>::Zero(1, group.dimension());
    other(0, 0) = mu.components[0];
    claim.refutes("the square of one component", model, Matrix<S>(other * tensor), S(1));
  });
  // In R^3: the form of the orbit against the area form y.(v x w)/|y|, without the root.
  for (int point = 0; point < (is_exact<S> ? exact_points : 2); ++point) {
    Turns const group{3};
    auto const mu = draw.template momentum<S>(group);
    auto const v = ad_star(draw_turning<S>(draw, group.n), mu), w = ad_star(draw_turning<S>(draw, group.n), mu);
    S const area = mu.components.dot(Vector<S>(cross(v.components, w.components))), square = mu.components.dot(mu.components);
    S const form = kirillov_kostant_plus(mu, v, w);
    claim.zero("tangent to the sphere", "SO(3)", S(mu.components.dot(v.components)), S(1));
    // The generators of v and w solve a system with entries of mu.
    claim.zero("Kirillov-Kostant form = area form / |y|", "SO(3)", S(form * square - area), S(1), 10);
    claim.refutes("equal to the area form, radius left out", "SO(3)", S(form * form * square - area * area), S(form * form * square));
  }
}

STATEMENT(claim_5_3_group_legendre, "Legendre map of the trace Lagrangian on SO(3)") {
  claim.corrected(R"(F\ell(f) = L_f^*\,d\ell(f) = \mathrm{skew}(f\Lambda) = f\Lambda - \Lambda f^T)", R"(F\ell(f) = L_f^*\,d\ell(f) = \mathrm{skew}(f^T\Lambda) = f^T\Lambda - \Lambda f)",
                  "The printed matrix is the other translation, $-R_f^*d\\ell(f)$: its negative is the momentum at the other end of the step. The pull-back of a Casimir is the same for both. Matrices are paired by $\\frac12\\mathrm{Tr}(A^TB)$, "
                  "so that the skew part stands without its one half.");
  claim.degree(100);
  over_bodies(claim, [&](int n, auto const& model) {
    auto const lambda = draw_inertia<S>(draw, n);
    auto const f = draw_turn<S>(draw, n);
    TraceLagrangian<S> const l{lambda};
    Matrix<S> const left = as_matrix(left_differential(l, f)), right = as_matrix(right_differential(l, f));
    Matrix<S> const printed = f.value * lambda - lambda * f.value.transpose();
    claim.equal("L*_f dl = f^T Lambda - Lambda f", model, Matrix<S>(f.value.transpose() * lambda - lambda * f.value), left);
    claim.equal("the printed matrix is -R*_f dl", model, printed, Matrix<S>(-right));
    claim.equal("the two lie on one coadjoint orbit", model, casimirs(as_momentum(printed)), casimirs(as_momentum(Matrix<S>(-left))));
    claim.differs("L*_f dl as printed", model, printed, left);
    claim.differs("L*_f dl as printed, paired with the other sign", model, Matrix<S>(-printed), left);
    claim.differs("skew part with its one half", model, Matrix<S>(left / S(2)), left);
  });
}

STATEMENT(eq_5_10, "Casimir function on the rotation group") {
  claim.holds("Up to constant and sign of $\\|y\\|^2$, in any dimension. On SO(4) and SO(5) it is one of two; the other is the pull-back of the Pfaffian, or of the coefficient of fourth degree.");
  claim.degree(designed_degree);
  over_bodies(claim, [&](int n, auto const& model) {
    auto const lambda = draw_inertia<S>(draw, n);
    auto const f = draw_turn<S>(draw, n);
    TraceLagrangian<S> const l{lambda};
    S const squares = (lambda * lambda).trace(), c = trace_casimir(lambda, f);
    claim.equal("Tr(f Lambda f Lambda) written out", model, printed_casimir(lambda)(f)[0], c);
    // The pull-back of |y|^2 is, up to constant and sign, (5.10); by either Legendre map.
    claim.zero("pull-back of |y|^2 at the beginning of the step", model, S(casimirs_before(l, f)[0] - (squares - c)), squares);
    claim.zero("pull-back of |y|^2 at its end", model, S(casimirs_after(l, f)[0] - (squares - c)), squares);
    claim.zero("every Casimir, by both Legendre maps", model, Vector<S>(casimirs_before(l, f) - casimirs_after(l, f)), S(1));
    // A function on the group that is kept by every motion.
    auto const motion = draw_motion<S>(draw, n);
    auto const kept = [&](int k) { return trace_casimir(motion.lambda, motion.f[k]); };
    claim.zero("kept by a motion", model, gap(kept(1), kept(0)), S(1), designed);
    claim.zero("kept by a motion, second step", model, gap(kept(2), kept(0)), S(1), designed);
    // Controls: neighbours of the formula.
    S const ff = (f.value * f.value * lambda * lambda).trace();
    claim.refutes("Tr(f f Lambda Lambda) in its place", model, S(casimirs_before(l, f)[0] - (squares - ff)), squares);
    claim.differs("Tr(f) is not kept", model, S(motion.f[1].value.trace()), S(motion.f[0].value.trace()));
  });
}

STATEMENT(claim_5_3_pullback_value, "pull-back of the dual Casimir to the group") {
  claim.convention("The Casimir pulled back is $\\|y\\|^2$: then the constant is $\\mathrm{Tr}\\Lambda^2$ and the sign minus. From $\\mathrm{Tr}(\\mu^2)$ it is the constant $-2\\mathrm{Tr}\\Lambda^2$ and a factor 2, with no change of sign.");
  claim.degree(100);
  over_bodies(claim, [&](int n, auto const& model) {
    auto const lambda = draw_inertia<S>(draw, n);
    auto const f = draw_turn<S>(draw, n);
    S const squares = (lambda * lambda).trace(), c = printed_casimir(lambda)(f)[0];
    auto const trace = [](Matrix<S> const& m) { return S((m * m).trace()); };
    auto const norm = [](Matrix<S> const& m) { return as_momentum(m).components.squaredNorm(); };
    Matrix<S> const printed = f.value * lambda - lambda * f.value.transpose();
    for (Matrix<S> const& m : {printed, before(lambda, f)}) {
      claim.zero("|y|^2 = Tr Lambda^2 - C(f)", model, S(norm(m) - (squares - c)), squares);
      claim.zero("Tr mu^2 = 2 C(f) - 2 Tr Lambda^2", model, S(trace(m) - S(2) * (c - squares)), squares);
    }
    // The constant is one: it does not depend on f, though f Lambda Lambda f^T does.
    Matrix<S> const whole = f.value * lambda * lambda * f.value.transpose();
    claim.zero("the remaining term, Tr(f Lambda Lambda f^T)", model, S(whole.trace() - squares), squares);
    // The constants of these two are right at f = 1.
    claim.refutes("Tr mu^2 = C(f) - Tr Lambda^2, no factor", model, S(trace(printed) - (c - squares)), squares);
    claim.refutes("Tr mu^2 = Tr Lambda^2 - C(f), a sign only", model, S(trace(printed) - (squares - c)), squares);
    claim.refutes("|y|^2 = Tr Lambda^2 + C(f)", model, S(norm(printed) - (squares + c)), squares);
  });
}

STATEMENT(claim_5_3_casimir_property, "bracket of the group Casimir with other functions on the group") {
  claim.holds("For the bracket (3.13) of the reduced Moser-Veselov Lagrangian, where that is regular, in any dimension. On SO(4) and SO(5) a second function has the property.");
  claim.degree(designed_degree);
  over_bodies(claim, [&](int n, auto const& model) {
    auto const lambda = draw_inertia<S>(draw, n);
    auto const f = draw_turn<S>(draw, n, ratio<S>(1, 4));
    TraceLagrangian<S> const l{lambda};
    Matrix<S> const bivector = reduced_bivector_left(l, f);
    // Rounding is magnified by the inverse of the second derivatives: largest entry of the bivector, times that of what it inverts, times the terms of a product.
    double const condition = to_double(S(size_of(bivector) * magnitude(lambda))) * 2 * bivector.rows();
    Base<S> const scale = size_of(bivector);
    Matrix<S> const printed = right_differentials(printed_casimir(lambda), f);
    Matrix<S> const all = right_differentials([&](auto const& at) { return casimirs_before(l, at); }, f);
    claim.zero("Tr(f Lambda f Lambda) with every function", model, Matrix<S>(printed * bivector), S(scale), condition);
    claim.zero("all Casimirs pulled back, with every function", model, Matrix<S>(all * bivector), S(scale), condition);
    // The bracket of the group is that of the dual, pulled back.
    Matrix<S> const map = left_second_differential(l, f);
    Matrix<S> const carried = map * bivector * map.transpose(), dual = lie_poisson_tensor_plus(momentum_before_left(l, f));
    claim.zero("the Legendre map carries it to the minus bracket", model, Matrix<S>(carried + dual), S(scale), condition);
    if constexpr (is_exact<S>) {
      claim.fact("no others: rank of the bracket", model, exact_rank(bivector) == f.group.dimension() - casimir_count(n));
      claim.fact("they are independent", model, exact_rank(all) == casimir_count(n));
    }
    // Controls.
    claim.refutes("Tr(f Lambda)", model, Matrix<S>(right_differential(l, f).components.transpose() * bivector), S(scale));
    claim.refutes("(5.10) of another body", model, Matrix<S>(right_differentials(printed_casimir(draw_inertia<S>(draw, n)), f) * bivector), S(scale));
  });
}
