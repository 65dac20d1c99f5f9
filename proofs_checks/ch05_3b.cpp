// Section 5.3, second part: what the discrete motion keeps on the group, and the Poisson structure on the rotation algebra. Compiled once per scalar.
//
// Velocities and momenta in the coordinates of so(n), where J is the diagonal matrix of the moments of the planes. Degrees: as in ch05_3a.cpp.
#include "actio/rigid_body/algebra_poisson.hpp"
#include "actio/rigid_body/casimirs.hpp"
#include "generalized_bodies.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// Two relative motions in SO(3), and a body that has them as a motion of \ref ChartLagrangian: the equations are linear in the inertia, whose products are solved for.
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
    return Vector<S>(left_differential(l, motion.second).components - right_differential(l, motion.first).components);
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
S twice_energy(Vector<S> const& moments, Vector<S> const& mu) {
  return mu.dot(mu.cwiseQuotient(moments));
}

}  // namespace

STATEMENT(claim_5_3_invariant_manifolds, "level sets of the group Casimir and the reduced discrete dynamics") {
  claim.convention("For the Moser-Veselov discretisation of (5.1): another discretisation has a bracket of its own on the group, and its own invariant manifolds. On SO(4) and SO(5) the leaves are the common level sets of two functions.");
  claim.degree(designed_degree);
  over_bodies(claim, [&](int n, auto const& model) {
    auto const motion = draw_motion<S>(draw, n);
    TraceLagrangian<S> const l{motion.lambda};
    for (int k = 1; k < motion.last(); ++k) {
      claim.zero("a motion stays on a level set of Tr(f Lambda f Lambda)", model, gap(trace_casimir(motion.lambda, motion.f[k]), trace_casimir(motion.lambda, motion.f[0])), S(1), designed);
      // The second Casimir is a sum of squares of products of two momenta, or such a product.
      claim.zero("and of every other Casimir", model, Vector<S>(casimirs_before(l, motion.f[k]) - casimirs_before(l, motion.f[0])), S(1), designed);
    }
    claim.differs("of Tr(f)", model, S(motion.f[1].value.trace()), S(motion.f[0].value.trace()));
    claim.differs("another relative motion", model, trace_casimir(motion.lambda, draw_turn<S>(draw, n)), trace_casimir(motion.lambda, motion.f[0]));
  });
  for (int point = 0; point < (is_exact<S> ? exact_points : 2); ++point) {
    auto const chart = draw_chart_motion<S>(draw);
    auto const at_first = casimirs_before(chart.l, chart.first)[0], at_second = casimirs_before(chart.l, chart.second)[0];
    // Condition: three equations for the body, and the differential of a chart.
    claim.equal("another discretisation: its own Casimir", "SO(3), Cayley's chart", at_second, at_first, 100);
    claim.differs("another discretisation: (5.10)", "SO(3), Cayley's chart", trace_casimir(chart.lambda(), chart.second), trace_casimir(chart.lambda(), chart.first), 1e-5);
  }
}

STATEMENT(claim_5_3_algebra_legendre, "Legendre map from the rotation algebra to its dual") {
  claim.convention("Momenta are paired with velocities by $\\frac12\\mathrm{Tr}(A^TB)$, the product of coordinates. With the pairing $\\mathrm{Tr}(A^TB)$ in which (5.1) is printed the derivative is $\\frac12J\\xi$.");
  claim.degree(100);
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
    claim.zero("paired by Tr(A^T B) it is J xi / 2", model, S((j.transpose() * group.hat(eta.coordinates)).trace() / S(2) - along), S(1));
    claim.refutes("J xi in that pairing", model, S((j.transpose() * group.hat(eta.coordinates)).trace() - along), S(1));
    claim.differs("Lambda xi", model, as_matrix(derivative), Matrix<S>(lambda * x));
  });
}

STATEMENT(claim_5_3_algebra_casimir, "Casimir on the rotation algebra through an induced metric") {
  claim.corrected(R"(C(\xi) = \langle J\xi, J\xi\rangle \text{ in the metric on the dual induced by } J)", R"(C(\xi) = \langle J\xi, J\xi\rangle \text{ in the metric on the dual that } \mathrm{Ad}^* \text{ keeps, } -\tfrac12\mathrm{Tr}(\mu^2))",
                  "In the metric that J induces on the dual the right side is $\\langle J\\xi, J^{-1}J\\xi\\rangle$, twice the energy: kept by the motion of the body, but no Casimir unless the moments are equal. The formula in coordinates that follows has the right metric.");
  claim.degree(100);
  over_bodies(claim, [&](int n, auto const& model) {
    Turns const group{n};
    Vector<S> const moments = moments_of(draw_inertia<S>(draw, n));
    auto const xi = draw_turning<S>(draw, group.n);
    Vector<S> const mu = moments.cwiseProduct(xi.coordinates);
    Matrix<S> const tensor = algebra_poisson_tensor(moments, xi);
    // Differentials of the two functions, by hand.
    Vector<S> const right = S(2) * moments.cwiseProduct(mu), printed = S(2) * mu;
    claim.equal("the library's is the pull-back of -Tr(mu^2)/2", model, algebra_casimir(moments, xi), S(-(as_matrix(momentum(group, mu)) * as_matrix(momentum(group, mu))).trace() / S(2)));
    claim.zero("bracket of the invariant square with every function", model, Vector<S>(tensor * right), S(1));
    // With the metric of J: the flow of the energy, which does not stand still.
    claim.equal("the function of the printed metric generates the motion of the body", model, Vector<S>(tensor * printed / S(2)), body_acceleration(moments, xi).coordinates);
    claim.refutes("bracket of the square in the metric of J", model, Vector<S>(tensor * printed), S(1));
    Vector<S> const sphere = Vector<S>::Constant(moments.size(), moments[0]);
    claim.zero("equal moments: the printed metric too", model, Vector<S>(algebra_poisson_tensor(sphere, xi) * xi.coordinates), S(1));
  });
}

STATEMENT(claim_5_3_algebra_casimir_coordinates, "Casimir on the rotation algebra in R^3 coordinates") {
  claim.holds("$J(x)$ has the components $I_ix_i$; as a trace it is $-\\frac12\\mathrm{Tr}((J\\xi)^2)$.");
  claim.degree(100);
  for (int point = 0; point < (is_exact<S> ? exact_points : 2); ++point) {
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
  claim.convention("On $\\so(3)$, for a body whose three moments are not equal. For equal moments the leaves are the adjoint orbits; on $\\so(n)$, $n > 3$, they have fewer dimensions than an ellipsoid.");
  claim.degree(100);
  over_bodies(claim, [&](int n, auto const& model) {
    Turns const group{n};
    Vector<S> const moments = moments_of(draw_inertia<S>(draw, n));
    auto const xi = draw_turning<S>(draw, group.n);
    auto const g = draw_turn<S>(draw, n);
    // The leaf through xi: coadjoint motion of J xi, brought back.
    auto const mu = Ad_star(g, algebra_legendre(moments, xi));
    BodyVelocity<S> const moved{group, mu.components.cwiseQuotient(moments)};
    claim.equal("the leaf lies on the ellipsoid of J^2", model, algebra_casimir(moments, moved), algebra_casimir(moments, xi));
    // The adjoint orbit lies on a sphere, and leaves the ellipsoid.
    auto const turned_velocity = Ad(g, xi);
    claim.equal("the adjoint orbit lies on a sphere", model, turned_velocity.coordinates.squaredNorm(), xi.coordinates.squaredNorm());
    claim.differs("the adjoint orbit lies on the ellipsoid", model, algebra_casimir(moments, turned_velocity), algebra_casimir(moments, xi));
    claim.differs("the leaf lies on the sphere", model, moved.coordinates.squaredNorm(), xi.coordinates.squaredNorm());
    Vector<S> const equal = Vector<S>::Constant(moments.size(), moments[0]);
    claim.equal("equal moments: adjoint orbits", model, algebra_casimir(equal, turned_velocity), algebra_casimir(equal, xi));
    if constexpr (is_exact<S>) {
      int const rank = exact_rank(algebra_poisson_tensor(moments, xi));
      claim.fact("dimension of the leaf: that of so(n) less floor(n/2)", model, rank == group.dimension() - n / 2);
      claim.fact("an ellipsoid for n = 3 only", model, (rank == group.dimension() - 1) == (n == 3));
    }
  });
}

STATEMENT(claim_5_3_dynamic_orbits, "dynamic orbits as intersections of two families of surfaces") {
  claim.convention("On $\\so(3)$, away from the three axes and from the two curves through the middle one: there a component of the intersection is one orbit. The discrete motion of Moser and Veselov stays on the same intersections, that of a chart does not.");
  claim.degree(designed_degree);
  for (int point = 0; point < (is_exact<S> ? exact_points : 2); ++point) {
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
    claim.zero("along the intersection, with the speed of the flow", "SO(3)", Vector<S>(along_both_ellipsoids(moments, xi).coordinates - euler), S(1));
    // The two surfaces cross wherever the body does not turn steadily, so there the intersection is a curve.
    claim.refutes("the differentials are parallel", "SO(3)", Vector<S>(cross(twice, once)), S(1));
    // Where no component is below a quarter and no two moments nearer than a quarter this is above 1e-5.
    claim.refutes("tangent to the sphere of velocities", "SO(3)", S(xi.coordinates.dot(euler)), S(1), 1e-5);
  }
  // The discrete motion: a step turns the momentum before it into the one after it.
  over_bodies(claim, [&](int n, auto const& model) {
    auto const lambda = draw_inertia<S>(draw, n);
    Vector<S> const moments = moments_of(lambda);
    auto const f = draw_turn<S>(draw, n);
    auto const start = as_momentum(before(lambda, f)).components, end = as_momentum(after(lambda, f)).components;
    claim.equal("a step of Moser and Veselov: ellipsoid of J^2", model, Vector<S>(end).squaredNorm(), Vector<S>(start).squaredNorm());
    claim.equal("a step of Moser and Veselov: energy ellipsoid", model, twice_energy<S>(moments, end), twice_energy<S>(moments, start));
    ChartLagrangian<S> const chart{Matrix<S>(moments.asDiagonal())};
    Vector<S> const chart_start = left_differential(chart, f).components, chart_end = right_differential(chart, f).components;
    claim.equal("a step in Cayley's chart: ellipsoid of J^2", model, chart_end.squaredNorm(), chart_start.squaredNorm(), 10);
    claim.differs("a step in Cayley's chart: energy ellipsoid", model, twice_energy<S>(moments, chart_end), twice_energy<S>(moments, chart_start), 1e-5);
    // The velocity as a difference (5.5) is not J^-1 of the momentum, and its energy is another.
    auto const difference = [&](Matrix<S> const& xi) { return Vector<S>(moments.cwiseProduct(as_momentum(xi).components)); };
    S const of_difference = twice_energy<S>(moments, difference(Matrix<S>(Matrix<S>::Identity(n, n) - f.value)));
    claim.differs("the velocity (5.5) in place of J^-1 M: energy ellipsoid", model, of_difference, twice_energy<S>(moments, start), 1e-5);
  });
}
