// Section 5.3, first part: Casimirs on the dual of the rotation algebra and on the group.
//
// Momenta are those of the scaled Lagrangian Tr(f Lambda): h times the physical ones. SO(4) and SO(5) have
// two Casimirs, and what the thesis says of SO(3) is tried on them too.

#include "actio/reduction/discrete_poisson.hpp"
#include "actio/rigid_body/algebra_poisson.hpp"
#include "actio/rigid_body/casimirs.hpp"
#include "actio/variational/coadjoint_orbit.hpp"
#include "actio/variational/lie_poisson.hpp"

#include "models/body_flow.hpp"
#include "models/enclosures.hpp"
#include "models/generalized_bodies.hpp"
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
      for (int j = 0; j < n; ++j)
        value[0] += f.value(i, j) * f.value(j, i) * T(S(lambda(i, i) * lambda(j, j)));
    return value;
  };
}

}  // namespace

STATEMENT(claim_5_3_dual_casimir, "trace Casimir on the dual algebra and its expression in R^3") {
  claim.corrected(R"(C_{\mathfrak{so}(3)^*}(y) = \|y\|^2)",
                  R"(C_{\mathfrak{so}(3)^*}(y) = \mathrm{Tr}()"
                  R"(\mu^2) = -2\|y\|^2)",
                  "Either is a Casimir, but they are not the same function: the square of a skew matrix "
                  "has no positive trace. Spheres and area form are right; the Kirillov-Kostant form is "
                  "the area form over the radius.");
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
    claim.zero("bracket of Tr mu^2 with all coordinates", model, Matrix<S>(differentials(trace, mu) * tensor),
               S(1));
    claim.zero("the same for every Casimir of the library", model,
               Matrix<S>(differentials(all_casimirs, mu) * tensor), S(1));
    claim.equal("all of them constant on coadjoint orbits", model,
                casimirs(Ad_star(draw_turn<S>(draw, n), mu)), casimirs(mu));
    if (n > 3) {
      // Newton's identity for the fourth power; on SO(4) the second Casimir is the Pfaffian, and its square
      // is the coefficient.
      auto const m = as_matrix(mu);
      Vector<S> const c = casimirs(mu);
      S const fourth = n == 4 ? S(c[1] * c[1]) : c[1];
      claim.equal("Tr mu^4 by the two Casimirs", model, S((m * m * m * m).trace()),
                  S(S(2) * c[0] * c[0] - S(4) * fourth));
      claim.differs("Tr mu^4 by the first alone", model, S((m * m * m * m).trace()), S(S(2) * c[0] * c[0]));
    }
    // There is no other: the bracket has as many directions less.
    if (exact_arithmetic<S>()) {
      claim.fact("rank of the bracket: dimension less floor(n/2)", model,
                 exact_rank(tensor) == group.dimension() - casimir_count(n));
      claim.fact("the Casimirs are independent", model,
                 exact_rank(differentials(all_casimirs, mu)) == casimir_count(n));
    }
    Matrix<S> other = Matrix<S>::Zero(1, group.dimension());
    other(0, 0) = mu.components[0];
    claim.refutes("the square of one component", model, Matrix<S>(other * tensor), S(1));
  });
  // In R^3: the form of the orbit against the area form y.(v x w)/|y|, without the root.
  {
    Turns const group{3};
    auto const mu = draw.template momentum<S>(group);
    auto const v = ad_star(draw_turning<S>(draw, group.n), mu),
               w = ad_star(draw_turning<S>(draw, group.n), mu);
    S const area = mu.components.dot(Vector<S>(cross(v.components, w.components))),
            square = mu.components.dot(mu.components);
    S const form = kirillov_kostant_plus(mu, v, w);
    claim.zero("tangent to the sphere", "SO(3)", S(mu.components.dot(v.components)), S(1));
    // The generators of v and w solve a system with entries of mu.
    claim.zero("Kirillov-Kostant form = area form / |y|", "SO(3)", S(form * square - area), S(1), 10);
    claim.refutes("equal to the area form, radius left out", "SO(3)", S(form * form * square - area * area),
                  S(form * form * square));
  }
}

STATEMENT(claim_5_3_group_legendre, "Legendre map of the trace Lagrangian on $\\SO(3)$") {
  claim.corrected(
      R"(F\ell(f) = L_f^*\,d\ell(f) = \mathrm{skew}(f\Lambda) = f\Lambda - \Lambda f^T)",
      R"(F\ell(f) = L_f^*\,d\ell(f) = \mathrm{skew}(f^T\Lambda) = f^T\Lambda - \Lambda f)",
      "The printed matrix is the other translation, $-R_f^*d\\ell(f)$: its negative is the momentum at the "
      "other end of the step. The pull-back of a Casimir is the same for both. Matrices are paired by "
      "$\\frac12\\mathrm{Tr}(A^TB)$, so that the skew part stands without its one half.");
  over_bodies(claim, [&](int n, auto const& model) {
    auto const lambda = draw_inertia<S>(draw, n);
    auto const f = draw_turn<S>(draw, n);
    TraceLagrangian<S> const l{lambda};
    Matrix<S> const left = as_matrix(left_differential(l, f)), right = as_matrix(right_differential(l, f));
    Matrix<S> const printed = f.value * lambda - lambda * f.value.transpose();
    claim.equal("L*_f dl = f^T Lambda - Lambda f", model,
                Matrix<S>(f.value.transpose() * lambda - lambda * f.value), left);
    claim.equal("the printed matrix is -R*_f dl", model, printed, Matrix<S>(-right));
    claim.equal("the two lie on one coadjoint orbit", model, casimirs(as_momentum(printed)),
                casimirs(as_momentum(Matrix<S>(-left))));
    claim.differs("L*_f dl as printed", model, printed, left);
    claim.differs("L*_f dl as printed, paired with the other sign", model, Matrix<S>(-printed), left);
    claim.differs("skew part with its one half", model, Matrix<S>(left / S(2)), left);
  });
}

STATEMENT(eq_5_10, "Casimir function on the rotation group") {
  claim.convention(
      "Up to constant and sign it is the pull-back of $\\|y\\|^2$, in any dimension; from "
      "$\\mathrm{Tr}(\\mu^2)$, the other form that the thesis gives the Casimir, there is a factor 2 as "
      "well. On $\\SO(4)$ and $\\SO(5)$ it is one of two; the other is the pull-back of the Pfaffian, or "
      "of the coefficient of fourth degree.");
  over_bodies(claim, [&](int n, auto const& model) {
    auto const lambda = draw_inertia<S>(draw, n);
    auto const f = draw_turn<S>(draw, n);
    TraceLagrangian<S> const l{lambda};
    S const squares = (lambda * lambda).trace(), c = trace_casimir(lambda, f);
    claim.equal("Tr(f Lambda f Lambda) written out", model, printed_casimir(lambda)(f)[0], c);
    // The pull-back of |y|^2 is, up to constant and sign, (5.10); by either Legendre map.
    claim.zero("pull-back of |y|^2 at the beginning of the step", model,
               S(casimirs_before(l, f)[0] - (squares - c)), squares);
    claim.zero("pull-back of |y|^2 at its end", model, S(casimirs_after(l, f)[0] - (squares - c)), squares);
    S const trace = trace_of_square(left_differential(l, f));
    claim.zero("pull-back of Tr mu^2: a factor 2, and no change of sign", model,
               S(trace - S(2) * (c - squares)), squares);
    claim.zero("every Casimir, by both Legendre maps", model,
               Vector<S>(casimirs_before(l, f) - casimirs_after(l, f)), S(1));
    // A function on the group that every motion conserves.
    auto const motion = draw_motion<S>(draw, n);
    auto const casimir = [&](int k) { return trace_casimir(motion.lambda, motion.f[k]); };
    claim.zero("conserved by a motion", model, gap(casimir(1), casimir(0)), S(1), designed);
    claim.zero("conserved by a motion, second step", model, gap(casimir(2), casimir(0)), S(1), designed);
    // Controls: neighbours of the formula.
    S const ff = (f.value * f.value * lambda * lambda).trace();
    claim.refutes("Tr(f f Lambda Lambda) in its place", model, S(casimirs_before(l, f)[0] - (squares - ff)),
                  squares);
    claim.refutes("pull-back of Tr mu^2, up to constant and sign only", model, S(trace - (squares - c)),
                  squares);
    claim.differs("Tr(f) is not conserved", model, S(motion.f[1].value.trace()),
                  S(motion.f[0].value.trace()));
  });
}

STATEMENT(claim_5_3_pullback_value, "pull-back of the dual Casimir to the group") {
  claim.same_slip_as("eq_5_10");
  claim.convention(
      "The Casimir pulled back is $\\|y\\|^2$: then the constant is $\\mathrm{Tr}\\Lambda^2$ and the "
      "sign minus. From $\\mathrm{Tr}(\\mu^2)$ it is the constant $-2\\mathrm{Tr}\\Lambda^2$ and a "
      "factor 2, with no change of sign.");
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
    claim.refutes("Tr mu^2 = C(f) - Tr Lambda^2, no factor", model, S(trace(printed) - (c - squares)),
                  squares);
    claim.refutes("Tr mu^2 = Tr Lambda^2 - C(f), a sign only", model, S(trace(printed) - (squares - c)),
                  squares);
    claim.refutes("|y|^2 = Tr Lambda^2 + C(f)", model, S(norm(printed) - (squares + c)), squares);
  });
}

STATEMENT(claim_5_3_casimir_property, "bracket of the group Casimir with other functions on the group") {
  claim.holds(
      "For the bracket (3.13) of the reduced Moser-Veselov Lagrangian, where that is regular, in any "
      "dimension. On $\\SO(4)$ and $\\SO(5)$ a second function has the property.");
  over_bodies(claim, [&](int n, auto const& model) {
    auto const lambda = draw_inertia<S>(draw, n);
    auto const f = draw_turn<S>(draw, n, ratio<S>(1, 4));
    TraceLagrangian<S> const l{lambda};
    Matrix<S> const bivector = reduced_bivector_left(l, f);
    // Rounding is magnified by the inverse of the second derivatives: largest entry of the bivector, times
    // that of what it inverts, times the terms of a product.
    double const condition = to_double(S(size_of(bivector) * magnitude(lambda))) * 2 * bivector.rows();
    Base<S> const scale = size_of(bivector);
    Matrix<S> const printed = right_differentials(printed_casimir(lambda), f);
    Matrix<S> const all = right_differentials([&](auto const& at) { return casimirs_before(l, at); }, f);
    claim.zero("Tr(f Lambda f Lambda) with every function", model, Matrix<S>(printed * bivector), S(scale),
               condition);
    claim.zero("all Casimirs pulled back, with every function", model, Matrix<S>(all * bivector), S(scale),
               condition);
    // The bracket of the group is that of the dual, pulled back.
    Matrix<S> const map = left_second_differential(l, f);
    Matrix<S> const carried = map * bivector * map.transpose(),
                    dual = lie_poisson_tensor_plus(momentum_before_left(l, f));
    claim.zero("the Legendre map carries it to the minus bracket", model, Matrix<S>(carried + dual), S(scale),
               condition);
    if (exact_arithmetic<S>()) {
      claim.fact("no others: rank of the bracket", model,
                 exact_rank(bivector) == f.group.dimension() - casimir_count(n));
      claim.fact("they are independent", model, exact_rank(all) == casimir_count(n));
    }
    // Controls.
    claim.refutes("Tr(f Lambda)", model,
                  Matrix<S>(right_differential(l, f).components.transpose() * bivector), S(scale));
    claim.refutes("(5.10) of another body", model,
                  Matrix<S>(right_differentials(printed_casimir(draw_inertia<S>(draw, n)), f) * bivector),
                  S(scale));
  });
}

// ----
// Section 5.3, second part: what the discrete motion conserves on the group, and the Poisson structure on the
// rotation algebra.
//
// Velocities and momenta in the coordinates of so(n), where J is the diagonal matrix of the moments of the
// planes.

namespace {

/// Two relative motions in SO(3), and a body that has them as a motion of \ref ChartLagrangian: the equations
/// are linear in the inertia, whose products are solved for.
template <class S>
struct ChartMotion {
  ChartLagrangian<S> l;
  Turn<S> first, second;
  /// \f$\Lambda\f$ of the same body: \f$\tfrac12\mathrm{Tr}A - A\f$.
  Matrix<S> lambda() const {
    S const half = l.a.trace() / S(2);
    return Matrix<S>(Matrix<S>::Identity(3, 3) * half - l.a);
  }
};
template <class S>
ChartMotion<S> draw_chart_motion(Draw& draw) {
  ChartMotion<S> motion{{Matrix<S>::Zero(3, 3)}, draw_turn<S>(draw, 3), draw_turn<S>(draw, 3)};
  for (int i = 0; i < 3; ++i) motion.l.a(i, i) = ratio<S>(i + 3, 4);
  auto const left = [&](Matrix<S> const& a) {
    ChartLagrangian<S> const l{a};
    return Vector<S>(left_differential(l, motion.second).components -
                     right_differential(l, motion.first).components);
  };
  Vector<S> const right = left(motion.l.a);
  Matrix<S> columns(3, 3);
  for (int k = 0; k < 3; ++k) {
    Matrix<S> one = Matrix<S>::Zero(3, 3);
    one(k, (k + 1) % 3) = one((k + 1) % 3, k) = S(1);
    columns.col(k) = left(one);
  }
  Vector<S> const products = solve_linear(columns, right, "draw_chart_motion");
  for (int k = 0; k < 3; ++k) motion.l.a(k, (k + 1) % 3) = motion.l.a((k + 1) % 3, k) = -products[k];
  return motion;
}
/// \f$\langle\mu, J^{-1}\mu\rangle\f$, twice the energy of a momentum.
template <class S>
S twice_energy(Vector<S> const& moments, Vector<S> const& mu) { return mu.dot(mu.cwiseQuotient(moments)); }

/// A component of the intersection of a sphere of momenta with an energy ellipsoid. It surrounds the axis e
/// of the least or the greatest moment: \f$M_o = A_o\cos\varphi\f$, \f$M_m = A_m\sin\varphi\f$ about it, and
/// \f$M_e^2 = B_o\cos^2\varphi + B_m\sin^2\varphi\f$.
template <class S>
struct Component {
  S a, b;                ///< \f$1/I_o - 1/I_e\f$ and \f$1/I_m - 1/I_e\f$, of one sign
  S square_o, square_m;  ///< \f$A_o^2\f$, \f$A_m^2\f$: the energy above that of the axis, over a, b
  S own_o, own_m;        ///< \f$B_o\f$, \f$B_m\f$: the square of the momentum, less these

  /// @param squares  of the components of one momentum on it
  Component(Vector<S> const& moments, Vector<S> const& squares, int e) {
    int const o = (e + 1) % 3, m = (e + 2) % 3;
    a = S(1) / moments[o] - S(1) / moments[e], b = S(1) / moments[m] - S(1) / moments[e];
    S const ratio = b / a;
    square_o = squares[o] + ratio * squares[m], square_m = squares[o] / ratio + squares[m];
    own_o = squares[e] + (S(1) - ratio) * squares[m], own_m = squares[e] + (S(1) - S(1) / ratio) * squares[o];
  }
  /// \f$|M\times J^{-1}M|^2\f$, the square of the speed of the flow, where \f$\sin^2\varphi = w\f$.
  S speed_squared(S const& w) const {
    S const rest = S(1) - w, other = square_o * rest, middle = square_m * w, own = own_o * rest + own_m * w;
    return other * middle * (a - b) * (a - b) + own * (middle * b * b + other * a * a);
  }
  /// \f$\oint d\varphi/\dot\varphi\f$ with \f$\dot\varphi^2 = abM_e^2\f$, by the arithmetic-geometric mean.
  S period() const {
    using std::sqrt;
    S x = sqrt(own_o), y = sqrt(own_m);
    for (int k = 0; k < 12; ++k) {
      S const mean = (x + y) / S(2);
      y = sqrt(S(x * y)), x = mean;
    }
    return two_pi() / (sqrt(S(a * b)) * x);
  }
  /// Of small circles about the axis.
  S period_at_the_axis() const {
    using std::sqrt;
    return two_pi() / sqrt(S(a * b * (own_o + square_o)));
  }
  static S two_pi() {
    using std::asin;
    return S(12) * asin(S(S(1) / S(2)));
  }
};
/// One orbit fills a component: it stands still nowhere, and comes back after the time of the integral.
template <class S>
void fills_its_component(Claim<S>& claim, Draw& draw) {
  // Bodies and energies in a box: moments near (5/2, 2, 3/2), momenta about the axis e with M_e = 1.
  auto const stands_still_nowhere = [](int e, Number const& spread, Number const& farthest) {
    Vector<Number> box(6);
    for (int i = 0; i < 3; ++i) {
      Number const middle = Number(5 - i) / Number(2);
      box[i] = Number::between(middle - spread, middle + spread);
    }
    // The squares of the other two components, over the largest.
    box[3] = box[4] = Number::between(Number(1) / Number(4), Number(1)),
    box[5] = Number::between(Number(0), Number(1));
    auto const speed = [&](Vector<Number> const& x) {
      Vector<Number> squares(3);
      squares[e] = Number(1), squares[(e + 1) % 3] = farthest * x[3], squares[(e + 2) % 3] = farthest * x[4];
      return Component<Number>(Vector<Number>(x.head(3)), squares, e).speed_squared(x[5]);
    };
    return positive_on(speed, box, 1024);
  };
  for (int const e : {0, 2}) {
    std::string const model = e == 0 ? "SO(3), about the greatest moment" : "SO(3), about the least moment";
    claim.encloses("the flow stands still nowhere on a component, bodies and energies in a box", model,
                   [&] { return stands_still_nowhere(e, Number(1) / Number(50), Number(1) / Number(10)); });
    claim.refutes_enclosure("the same up to the curves through the middle axis", model, [&] {
      return stands_still_nowhere(e, Number(0), e == 0 ? Number(3) / Number(5) : Number(5) / Number(3));
    });
    if (exact_arithmetic<S>() || !claim.first()) continue;
    Vector<S> const moments = moments_of(draw_inertia<S>(draw, 3));
    Vector<S> start = draw_turning<S>(draw, 3, ratio<S>(1, 4)).coordinates;
    start[e] = S(1);
    Component<S> const component(moments, Vector<S>(start.cwiseProduct(start)), e);
    BodyFlow<S> const flow(Turns{3}, Matrix<S>(moments.asDiagonal()));
    auto const half_a_period = [&](Vector<S> const& from) {
      return flow({from, Matrix<S>(0, 0)}, component.period() / S(2), 40).momentum;
    };
    Vector<S> const half = half_a_period(start), whole = half_a_period(half);
    Vector<S> opposite = -start;
    opposite[e] = start[e];
    // Condition: forty pieces of a series, twice, whose roundings add up.
    claim.equal("after half a period on the other side of the axis", model, half, opposite, 10);
    claim.equal("after a period where it was", model, whole, start, 10);
    claim.differs("half a period later where it was", model, half, start);
    claim.differs("the period of small circles", model, component.period_at_the_axis(), component.period());
  }
}

}  // namespace

STATEMENT(claim_5_3_invariant_manifolds,
          "level sets of the group Casimir and the reduced discrete dynamics") {
  claim.convention(
      "For the Moser-Veselov discretisation of (5.1): another discretisation has a bracket of its own "
      "on the group, and its own invariant manifolds. On $\\SO(4)$ and $\\SO(5)$ the leaves are the "
      "common level sets of two functions.");
  over_bodies(claim, [&](int n, auto const& model) {
    auto const motion = draw_motion<S>(draw, n);
    TraceLagrangian<S> const l{motion.lambda};
    for (int k = 1; k < motion.last(); ++k) {
      claim.zero("a motion stays on a level set of Tr(f Lambda f Lambda)", model,
                 gap(trace_casimir(motion.lambda, motion.f[k]), trace_casimir(motion.lambda, motion.f[0])),
                 S(1), designed);
      // The second Casimir is a sum of squares of products of two momenta, or such a product.
      claim.zero("and of every other Casimir", model,
                 Vector<S>(casimirs_before(l, motion.f[k]) - casimirs_before(l, motion.f[0])), S(1),
                 designed);
    }
    claim.differs("of Tr(f)", model, S(motion.f[1].value.trace()), S(motion.f[0].value.trace()));
    claim.differs("another relative motion", model, trace_casimir(motion.lambda, draw_turn<S>(draw, n)),
                  trace_casimir(motion.lambda, motion.f[0]));
  });
  {
    auto const chart = draw_chart_motion<S>(draw);
    auto const at_first = casimirs_before(chart.l, chart.first)[0],
               at_second = casimirs_before(chart.l, chart.second)[0];
    // Condition: three equations for the body, and the differential of a chart.
    claim.equal("another discretisation: its own Casimir", "SO(3), Cayley's chart", at_second, at_first, 100);
    claim.differs("another discretisation: (5.10)", "SO(3), Cayley's chart",
                  trace_casimir(chart.lambda(), chart.second), trace_casimir(chart.lambda(), chart.first),
                  1e-5);
  }
}

STATEMENT(claim_5_3_algebra_legendre, "Legendre map from the rotation algebra to its dual") {
  claim.corrected(
      R"(\mu = \frac{\partial l}{\partial\xi} = \mathcal J(\xi))",
      R"(\mu = \frac{\partial l}{\partial\xi} = \tfrac12\mathcal J(\xi))",
      "By the pairing of (5.1), $\\mathrm{Tr}(A^TB)$. By half of that, the product of coordinates, "
      "$\\mathcal J(\\xi)$ is right here and the $\\tfrac14$ of (5.1) is not.");
  claim.same_slip_as("eq_5_2");
  over_bodies(claim, [&](int n, auto const& model) {
    Turns const group{n};
    auto const lambda = draw_inertia<S>(draw, n);
    auto const xi = draw_turning<S>(draw, group.n);
    // (5.1) with traces: l = Tr(xi^T J xi)/4.
    auto const energy = [&](auto const& v) {
      using T = typename std::decay_t<decltype(v)>::Scalar;
      Matrix<T> const x = group.hat(v.coordinates), big = lambda.template cast<T>();
      Matrix<T> const j = big * x + x * big;
      T sum(0);
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) sum += x(a, b) * j(a, b);
      return T(sum / Base<T>(4));
    };
    Matrix<S> const x = group.hat(xi.coordinates), j = lambda * x + x * lambda;
    auto const derivative = gradient(energy, xi);
    claim.equal("dl/dxi = Lambda xi + xi Lambda", model, as_matrix(derivative), j);
    claim.equal("the library's", model, algebra_legendre(moments_of(lambda), xi), derivative);
    // In the pairing of traces the derivative of l along eta is Tr(D^T eta): D is half of J xi.
    auto const eta = draw_turning<S>(draw, group.n);
    S const along = pair(derivative, eta);
    claim.zero("paired by Tr(A^T B) it is J xi / 2", model,
               S((j.transpose() * group.hat(eta.coordinates)).trace() / S(2) - along), S(1));
    claim.refutes("J xi in that pairing, as printed", model,
                  S((j.transpose() * group.hat(eta.coordinates)).trace() - along), S(1));
    claim.differs("Lambda xi", model, as_matrix(derivative), Matrix<S>(lambda * x));
  });
}

STATEMENT(claim_5_3_algebra_casimir, "Casimir on the rotation algebra through an induced metric") {
  claim.corrected(
      R"(C(\xi) = \langle J\xi, J\xi\rangle \text{ in the metric on the dual induced by } J)",
      R"(C(\xi) = \langle J\xi, J\xi\rangle \text{ in the metric on the dual that } \mathrm{Ad}^* \text{ )"
      R"(keeps, } -\tfrac12\mathrm{Tr}(\mu^2))",
      "In the metric that $J$ induces on the dual the right side is $\\langle J\\xi, J^{-1}J\\xi\\rangle$, "
      "twice the energy: conserved by the motion of the body, but no Casimir unless the moments are equal. "
      "The formula in coordinates that follows has the right metric.");
  over_bodies(claim, [&](int n, auto const& model) {
    Turns const group{n};
    Vector<S> const moments = moments_of(draw_inertia<S>(draw, n));
    auto const xi = draw_turning<S>(draw, group.n);
    Vector<S> const mu = moments.cwiseProduct(xi.coordinates);
    Matrix<S> const tensor = algebra_poisson_tensor(moments, xi);
    // Differentials of the two functions, by hand.
    Vector<S> const right = S(2) * moments.cwiseProduct(mu), printed = S(2) * mu;
    claim.equal("the library's is the pull-back of -Tr(mu^2)/2", model, algebra_casimir(moments, xi),
                S(-(as_matrix(momentum(group, mu)) * as_matrix(momentum(group, mu))).trace() / S(2)));
    claim.zero("bracket of the invariant square with every function", model, Vector<S>(tensor * right), S(1));
    // With the metric of J: the flow of the energy, which does not stand still.
    claim.equal("the function of the printed metric generates the motion of the body", model,
                Vector<S>(tensor * printed / S(2)), body_acceleration(moments, xi).coordinates);
    claim.refutes("bracket of the square in the metric of J", model, Vector<S>(tensor * printed), S(1));
    Vector<S> const sphere = Vector<S>::Constant(moments.size(), moments[0]);
    claim.zero("equal moments: the printed metric too", model,
               Vector<S>(algebra_poisson_tensor(sphere, xi) * xi.coordinates), S(1));
  });
}

STATEMENT(claim_5_3_algebra_casimir_coordinates, "Casimir on the rotation algebra in R^3 coordinates") {
  claim.holds("$J(x)$ has the components $I_ix_i$; as a trace it is $-\\frac12\\mathrm{Tr}((J\\xi)^2)$.");
  {
    Turns const group{3};
    auto const lambda = draw_inertia<S>(draw, 3);
    Vector<S> const moments = moments_of(lambda);
    auto const xi = draw_turning<S>(draw, group.n);
    auto const& x = xi.coordinates;
    S sum(0), once(0);
    for (int i = 0; i < 3; ++i) {
      S const inertia = lambda.trace() - lambda(i, i);
      sum += inertia * inertia * x[i] * x[i], once += inertia * x[i] * x[i];
    }
    Matrix<S> const hat = group.hat(x), j = lambda * hat + hat * lambda;
    S const trace = (j * j).trace();
    claim.equal("the sum of (I_i x_i)^2", "SO(3)", algebra_casimir(moments, xi), sum);
    claim.equal("-Tr((Lambda xi + xi Lambda)^2)/2", "SO(3)", S(-trace / S(2)), sum);
    claim.differs("Tr((J xi)^2) itself", "SO(3)", trace, sum);
    claim.differs("the sum of I_i x_i^2", "SO(3)", once, sum);
  }
}

STATEMENT(claim_5_3_algebra_leaves, "shape of the symplectic leaves in the rotation algebra") {
  claim.convention(
      "On $\\so(3)$, for a body whose three moments are not equal. For equal moments the leaves are the "
      "adjoint orbits; on $\\so(n)$, $n > 3$, they have fewer dimensions than an ellipsoid.");
  over_bodies(claim, [&](int n, auto const& model) {
    Turns const group{n};
    Vector<S> const moments = moments_of(draw_inertia<S>(draw, n));
    auto const xi = draw_turning<S>(draw, group.n);
    auto const g = draw_turn<S>(draw, n);
    // The leaf through xi: coadjoint motion of J xi, brought back.
    auto const mu = Ad_star(g, algebra_legendre(moments, xi));
    BodyVelocity<S> const moved{group, mu.components.cwiseQuotient(moments)};
    claim.equal("the leaf lies on the ellipsoid of J^2", model, algebra_casimir(moments, moved),
                algebra_casimir(moments, xi));
    // The adjoint orbit lies on a sphere, and leaves the ellipsoid.
    auto const turned_velocity = Ad(g, xi);
    claim.equal("the adjoint orbit lies on a sphere", model, turned_velocity.coordinates.squaredNorm(),
                xi.coordinates.squaredNorm());
    claim.differs("the adjoint orbit lies on the ellipsoid", model, algebra_casimir(moments, turned_velocity),
                  algebra_casimir(moments, xi));
    claim.differs("the leaf lies on the sphere", model, moved.coordinates.squaredNorm(),
                  xi.coordinates.squaredNorm());
    Vector<S> const equal = Vector<S>::Constant(moments.size(), moments[0]);
    claim.equal("equal moments: adjoint orbits", model, algebra_casimir(equal, turned_velocity),
                algebra_casimir(equal, xi));
    if (exact_arithmetic<S>()) {
      int const rank = exact_rank(algebra_poisson_tensor(moments, xi));
      claim.fact("dimension of the leaf: that of so(n) less floor(n/2)", model,
                 rank == group.dimension() - n / 2);
      claim.fact("an ellipsoid for n = 3 only", model, (rank == group.dimension() - 1) == (n == 3));
    }
  });
}

STATEMENT(claim_5_3_dynamic_orbits, "dynamic orbits as intersections of two families of surfaces") {
  claim.convention(
      "On $\\so(3)$, away from the three axes and from the two curves through the middle one: by Euler's "
      "equations the flow stands still on the axes alone (in balls, with a bound on its speed, for moments "
      "near 5/2, 2, 3/2 and momenta near the first and the last axis), so one orbit fills a component of "
      "the intersection, once in a period that an elliptic integral gives. The discrete motion of Moser "
      "and Veselov stays on the same intersections, that of a chart does not.");
  {
    Turns const group{3};
    Vector<S> const moments = moments_of(draw_inertia<S>(draw, 3));
    auto const xi = draw_turning<S>(draw, group.n);
    auto const rate = body_acceleration(moments, xi);
    Vector<S> const once = moments.cwiseProduct(xi.coordinates), twice = moments.cwiseProduct(once);
    // Euler's equations by components, not through ad*.
    Vector<S> euler(3);
    for (int i = 0; i < 3; ++i) {
      int const j = (i + 1) % 3, k = (i + 2) % 3;
      euler[i] = (moments[j] - moments[k]) * xi.coordinates[j] * xi.coordinates[k] / moments[i];
    }
    claim.zero("Euler's equations", "SO(3)", Vector<S>(rate.coordinates - euler), S(1));
    claim.zero("tangent to the ellipsoid of J^2", "SO(3)", S(twice.dot(euler)), S(1));
    claim.zero("tangent to the energy ellipsoid", "SO(3)", S(once.dot(euler)), S(1));
    claim.zero("along the intersection, with the speed of the flow", "SO(3)",
               Vector<S>(along_both_ellipsoids(moments, xi).coordinates - euler), S(1));
    // The two surfaces cross wherever the body does not turn steadily, so there the intersection is a curve.
    claim.refutes("the differentials are parallel", "SO(3)", Vector<S>(cross(twice, once)), S(1));
    // Where no component is below a quarter and no two moments nearer than a quarter this is above 1e-5.
    claim.refutes("tangent to the sphere of velocities", "SO(3)", S(xi.coordinates.dot(euler)), S(1), 1e-5);
  }
  fills_its_component(claim, draw);
  // The discrete motion: a step turns the momentum before it into the one after it.
  over_bodies(claim, [&](int n, auto const& model) {
    auto const lambda = draw_inertia<S>(draw, n);
    Vector<S> const moments = moments_of(lambda);
    auto const f = draw_turn<S>(draw, n);
    auto const start = as_momentum(before(lambda, f)).components,
               end = as_momentum(after(lambda, f)).components;
    claim.equal("a step of Moser and Veselov: ellipsoid of J^2", model, Vector<S>(end).squaredNorm(),
                Vector<S>(start).squaredNorm());
    claim.equal("a step of Moser and Veselov: energy ellipsoid", model, twice_energy<S>(moments, end),
                twice_energy<S>(moments, start));
    ChartLagrangian<S> const chart{Matrix<S>(moments.asDiagonal())};
    Vector<S> const chart_start = left_differential(chart, f).components,
                    chart_end = right_differential(chart, f).components;
    claim.equal("a step in Cayley's chart: ellipsoid of J^2", model, chart_end.squaredNorm(),
                chart_start.squaredNorm(), 10);
    claim.differs("a step in Cayley's chart: energy ellipsoid", model, twice_energy<S>(moments, chart_end),
                  twice_energy<S>(moments, chart_start), 1e-5);
    // The velocity as a difference (5.5) is not J^-1 of the momentum, and its energy is another.
    auto const difference = [&](Matrix<S> const& xi) {
      return Vector<S>(moments.cwiseProduct(as_momentum(xi).components));
    };
    S const of_difference =
        twice_energy<S>(moments, difference(Matrix<S>(Matrix<S>::Identity(n, n) - f.value)));
    claim.differs("the velocity (5.5) in place of J^-1 M: energy ellipsoid", model, of_difference,
                  twice_energy<S>(moments, start), 1e-5);
  });
}
