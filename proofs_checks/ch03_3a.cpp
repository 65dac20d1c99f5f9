// Section 3.3, first part: natural charts, the discrete Lagrangian they define, distances. Compiled once per scalar.
//
// Over the rationals the groups are unipotent, so exp, log and iex are polynomials and residuals are exactly zero (chart_models.hpp).
#include "chart_models.hpp"
#include "actio/variational/euler_poincare.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// The span of symmetric forms B with B([x,y],z) + B(y,[x,z]) = 0, from the structure constants. These are whole numbers of modulus 2 at most: an entry below 1/1000 is zero.
template <class S>
std::vector<Matrix<S>> invariant_forms(SpannedGroup const& group) {
  int const d = group.dimension(), unknowns = d * (d + 1) / 2;
  auto const index = [d](int i, int j) { return i <= j ? i * d - i * (i - 1) / 2 + j - i : j * d - j * (j - 1) / 2 + i - j; };
  std::vector<Vector<S>> rows;  // in echelon form
  std::vector<int> pivots;
  for (int x = 0; x < d; ++x)
    for (int y = 0; y < d; ++y)
      for (int z = y; z < d; ++z) {
        Vector<S> row = Vector<S>::Zero(unknowns);
        auto const e = [&](int a) { return basis_velocity<S>(group, a); };
        auto const xy = bracket(e(x), e(y)).coordinates, xz = bracket(e(x), e(z)).coordinates;
        for (int k = 0; k < d; ++k) row[index(k, z)] += xy[k], row[index(y, k)] += xz[k];
        // Eliminate what is known, then keep what is new.
        for (std::size_t r = 0; r < rows.size(); ++r) row -= rows[r] * S(row[pivots[r]]);
        int p = 0;
        while (p < unknowns && !(magnitude(row[p]) > ratio<S>(1, 1000))) ++p;
        if (p == unknowns) continue;
        row /= S(row[p]);
        for (auto& known : rows) known -= row * S(known[p]);
        rows.push_back(row), pivots.push_back(p);
      }
  std::vector<Matrix<S>> forms;
  for (int f = 0; f < unknowns; ++f) {
    if (std::find(pivots.begin(), pivots.end(), f) != pivots.end()) continue;
    Vector<S> solution = Vector<S>::Zero(unknowns);
    solution[f] = S(1);
    for (std::size_t r = 0; r < rows.size(); ++r) solution[pivots[r]] = -rows[r][f];
    Matrix<S> form(d, d);
    for (int i = 0; i < d; ++i)
      for (int j = 0; j < d; ++j) form(i, j) = solution[index(i, j)];
    forms.push_back(form);
  }
  return forms;
}
/// The determinant by elimination, 0 where no pivot is left.
template <class S>
S determinant(Matrix<S> m) {
  S product(1);
  for (Eigen::Index k = 0; k < m.rows(); ++k) {
    Eigen::Index p = k;
    for (Eigen::Index i = k; i < m.rows(); ++i)
      if (magnitude(m(i, k)) > magnitude(m(p, k))) p = i;
    if (m(p, k) == S(0)) return S(0);
    if (p != k) m.row(p).swap(m.row(k)), product = -product;
    product *= m(k, k);
    for (Eigen::Index i = k + 1; i < m.rows(); ++i) m.row(i) -= m.row(k) * S(m(i, k) / m(k, k));
  }
  return product;
}
template <class S>
S generic_determinant(Draw& draw, SpannedGroup const& group) {
  Matrix<S> sum = Matrix<S>::Zero(group.dimension(), group.dimension());
  for (auto const& form : invariant_forms<S>(group)) sum += form * S(S(1) + draw.number<S>() / S(4));
  return determinant(sum);
}

/// \f$|\xi|^2\f$ of the metric whose basis is orthonormal.
struct SquareNorm {
  template <class T>
  T operator()(Velocity<SpannedGroup, T> const& xi) const {
    T sum(0);
    for (Eigen::Index i = 0; i < xi.coordinates.size(); ++i) sum += xi.coordinates[i] * xi.coordinates[i];
    return sum;
  }
};
/// \f$\cosh\f$ of the distance in Aff(1) with that metric, translated on the right: inverted, it is the hyperbolic plane of points (shift, stretch).
template <class S>
S cosh_distance(Place<S> const& g1, Place<S> const& g2) {
  auto const p = inverse(g1).value, q = inverse(g2).value;
  S const dx = p(0, 1) - q(0, 1), dy = p(0, 0) - q(0, 0);
  return S(1) + (dx * dx + dy * dy) / (S(2) * p(0, 0) * q(0, 0));
}
/// A geodesic of it, at unit speed in log u: a half circle of centre c and radius r, inverted back.
template <class T, class S>
Place<T> half_circle(SpannedGroup const& aff1, S const& c, S const& r, T const& u) {
  T const w = u * u + T(1);
  Matrix<T> k = Matrix<T>::Identity(2, 2);
  k(0, 0) = T(2) * u * T(r) / w, k(0, 1) = T(c) + T(r) * (u * u - T(1)) / w;
  return inverse(Place<T>{aff1, k});
}
/// \f$\cos\f$ of the angle between two rotations of space.
template <class S>
S cos_angle(Place<S> const& g1, Place<S> const& g2) {
  auto const f = (g1 * inverse(g2)).value;
  return (f(0, 0) + f(1, 1) + f(2, 2) - S(1)) / S(2);
}
/// A rotation with tan(angle/2) = t about an axis with rational length.
template <class S>
Place<S> rotation_by_half_tangent(SpannedGroup const& so3, S const& t) {
  Vector<S> axis(3);
  axis << S(2), S(-1), S(2);
  return retract(Algebra<S>{so3, Vector<S>(axis * (S(2) * t / S(3)))});
}

}  // namespace

STATEMENT(eq_3_19, "chart at a group element from the exponential map") {
  claim.holds();
  claim.degree(chart_degree);
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw.template element<S>(group), k = draw_near(draw, g), h = draw.template element<S>(group);
    auto const v = draw.template velocity<S>(group, ratio<S>(1, 4));
    // A chart and its inverse, the base point at the origin, the charts carried along by right translation.
    claim.equal("exp(psi_g(k)) g = k", model, exp(natural_chart_right(g, k)) * g, k);
    claim.equal("psi_g(exp(v) g) = v", model, natural_chart_right(g, exp(v) * g), v);
    claim.equal("psi_gh(kh) = psi_g(k)", model, natural_chart_right(g * h, k * h), natural_chart_right(g, k));
    claim.equal("left chart: g exp(phi_g(k)) = k", model, g * exp(natural_chart_left(g, k)), k);
    // Control: the chart of the other side.
    claim.differs("chart by left translation in place of it", model, exp(natural_chart_left(g, k)) * g, k);
  });
  if constexpr (Real<S>) {
    // The chart ends where exp stops being one to one: half a turn.
    SO<3> const group;
    auto const g = draw.template element<S>(group), half_turn = Element<SO<3>, S>{group, Eigen::Matrix<S, 3, 3>(Eigen::Matrix<S, 3, 1>(S(-1), S(-1), S(1)).asDiagonal())};
    claim.template refuses<OutsideDomain>("half a turn away, outside the chart", "SO(3)", [&] { natural_chart_right(g, half_turn * g); });
  }
}

STATEMENT(eq_3_20, "discrete Lagrangian from averages and differences in a chart") {
  claim.convention("The push-forward is taken at the averaged point $\\eta$, which print leaves open. The discrete Lagrangian of the library is $h$ times the printed one: an action.");
  claim.degree(chart_degree);
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const lagrangian = draw_state_polynomial<S>(draw, group);
    auto const g1 = draw.template element<S>(group), g2 = draw_near(draw, g1);
    S const h = step_length<S>();
    auto const base = beside_right(draw_small<S>(draw, group));
    auto const g = base(g1, g2);

    // Average and subtract in the chart, push forward by dual numbers.
    auto const first = natural_chart_right(g, g1), second = natural_chart_right(g, g2);
    auto const average = ratio<S>(1, 2) * (first + second), difference = (second - first) / h;
    claim.equal("the library's is h times (3.20)", model, discretize_right(lagrangian, h, base)(g1, g2), h * lagrangian(push_forward(g, average, difference)));
    // Control: pushed forward at the centre of the chart, where the differential of exp is the identity.
    claim.differs("push-forward at the centre of the chart: the velocity that L is given", model, push_forward(g, average, difference).velocity, difference);
  });
  if constexpr (std::same_as<S, double>) {
    // It approximates the Lagrangian at the middle of any smooth curve to order 2, whatever the base point.
    for (auto const& group : order_groups()) {
      auto const lagrangian = draw_state_polynomial<S>(draw, group);
      auto const curve = draw_curve<S>(draw, group);
      auto const at_end = at_second;
      auto const beside = staying_at(draw_near(draw, curve.g0));
      std::vector<double> errors_end, errors_beside, errors_unpushed;
      for (double h : halving_steps()) {
        auto const g1 = curve(S(0)), g2 = curve(h);
        S const exact = lagrangian(state_of(curve(moving(S(h / 2)))));
        errors_end.push_back(std::abs(discretize_right(lagrangian, h, at_end)(g1, g2) / h - exact));
        errors_beside.push_back(std::abs(discretize_right(lagrangian, h, beside)(g1, g2) / h - exact));
        auto const g = beside(g1, g2);
        auto const m = chart_midpoint_right(g, g1, g2, h);
        errors_unpushed.push_back(std::abs(lagrangian(State<SpannedGroup, S>{exp(m.eta) * g, m.zeta}) - exact));
      }
      claim.order("midpoint value, chart at the later place", group.name(), halving_steps(), errors_end, 2);
      claim.order("midpoint value, chart at a fixed place beside the curve", group.name(), halving_steps(), errors_beside, 2);
      claim.refutes_order("push-forward left out", group.name(), halving_steps(), errors_unpushed, 2);
    }
  }
}

STATEMENT(claim_3_3_quadratic_lie_algebra, "assumption of a regular quadratic Lie algebra") {
  claim.holds("The assumption is never used: the construction, its invariance and its reduction hold on Aff(1), SE(2), the Heisenberg group and others, whose algebras carry no invariant nondegenerate form. (That of SE(3) does.)");
  // Invariant forms are linear in the coefficients that are drawn, their determinant of degree 6 at most; the discrete Lagrangians as everywhere in this section.
  claim.degree(chart_degree);
  std::vector<SpannedGroup> without = {spanned("Heisenberg", Heisenberg{}), unitriangular(4)};
  if constexpr (Real<S>) without.push_back(spanned("Aff(1)", Aff1{})), without.push_back(spanned("SE(2)", SE<2>{}));
  over_groups(without, claim, [&](auto const& group, auto const& model) {
    claim.zero("every invariant form is degenerate: determinant of a generic one", model, generic_determinant<S>(draw, group), S(1));
    auto const l = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const g1 = draw.template element<S>(group), g2 = draw_near(draw, g1), k = draw.template element<S>(group);
    auto const base = beside_right(draw_small<S>(draw, group));
    S const h = step_length<S>();
    auto const discrete = discretize_right(right_invariant(l), h, base);
    auto const scale = size_of_terms(l, fibre_element_right(chart_midpoint_right(base(g1, g2), g1, g2, h)));
    claim.zero("L(g1 k, g2 k) = L(g1, g2) all the same", model, S(discrete(g1 * k, g2 * k) - discrete(g1, g2)), scale);
    claim.zero("L(g1, g2) = l(g1 g2^-1) all the same", model, S(lift_right(natural_chart_lagrangian_right(l, h, base))(g1, g2) - discrete(g1, g2)), scale);
  });
  if constexpr (is_exact<S>)
    for (auto const& group : {spanned("Aff(1)", Aff1{}), spanned("SE(2)", SE<2>{})})
      claim.zero("every invariant form is degenerate: determinant of a generic one", group.name(), generic_determinant<S>(draw, group), S(1));
  // Control: the criterion can tell. Semisimple algebras have such a form, gl(2) too, and se(3) pairs rotations with translations.
  over_groups({spanned("SO(3)", SO<3>{}), spanned("SE(3)", SE<3>{}), spanned("SL(2)", SL2{}), spanned("GL(2)", GL<2>{})}, claim,
              [&](auto const& group, auto const& model) { claim.refutes("determinant of a generic invariant form where there is one", model, generic_determinant<S>(draw, group), S(1)); });
}

STATEMENT(claim_3_3_riemannian_distance, "Riemannian distance through the connecting geodesic") {
  claim.corrected(R"(\mathrm{dist}(g_1,g_2) = \int_0^1\langle\dot\gamma,\dot\gamma\rangle\,dt)", R"(\mathrm{dist}(g_1,g_2) = \int_0^1\langle\dot\gamma,\dot\gamma\rangle^{1/2}\,dt)",
                  "Without the root the integral is the square of the distance: on the pieces of one geodesic it does not add up, and the triangle inequality fails. The geodesic is a shortest one.");
  claim.maybe_scan();
  // A half circle and its two derivatives are quotients of degree 12 at most in u, r, c and the rate; their inverses and products raise that to 60 at most.
  claim.degree(60);
  auto const aff1 = spanned("Aff(1)", Aff1{});
  auto const kinetic = [](auto const& xi) { return SquareNorm{}(xi) / 2; };
  over_groups({aff1}, claim, [&](auto const& group, auto const& model) {
    S const c = draw.template number<S>(), r = S(2) + draw.template number<S>(), u = S(2) + draw.template number<S>();
    auto const rate_a = (S(2) + draw.template number<S>()) / S(4), rate_b = (S(2) + draw.template number<S>()) / S(4);
    // Two legs of one geodesic, each run through in unit time; log u goes at a constant rate.
    auto const square_speed = [&](S const& rate, S const& at) {
      using D = Dual<S>;
      D position(at), speed(S(rate * at));
      position.part[0] = rate * at, speed.part[0] = rate * rate * at;
      Dual<D> nested(position);
      nested.part[0] = speed;
      auto const xi = state_of(half_circle(group, c, r, nested)).velocity;
      Algebra<S> const velocity{group, Vector<S>(value_part<S>(xi.coordinates))}, acceleration{group, Vector<S>(rate_part<S>(xi.coordinates))};
      claim.zero("a half circle is a geodesic of the right-invariant metric", model, euler_poincare_right(kinetic, velocity, acceleration), size_of(velocity) * size_of(velocity));
      return SquareNorm{}(velocity);
    };
    S const square_a = square_speed(rate_a, u), square_b = square_speed(rate_b, u), square = square_speed(rate_a + rate_b, u);
    claim.equal("its speed is the same everywhere", model, square_speed(rate_a, u * (S(1) + rate_b)), square_a);
    // The speeds are the roots of these: lengths of the legs add up to that of the whole.
    claim.equal("square of the sum of the lengths of two legs is that of the whole", model, square_a + square_b + S(2) * rate_a * rate_b, square);
    claim.equal("length of a leg, squared", model, square_a, rate_a * rate_a);
    // Control: without the root they do not.
    claim.differs("without the root the two legs fall short of the whole", model, square_a + square_b, square);
    if constexpr (Real<S>) {
      using std::exp, std::log, std::sqrt;
      S const cosh = cosh_distance(half_circle(group, c, r, u), half_circle(group, c, r, S(u * exp(rate_a))));
      // The distance from its closed form.
      S const distance = log(S(cosh + sqrt(S(cosh * cosh - 1))));
      claim.equal("integral of the root is the hyperbolic distance", model, S(sqrt(square_a)), distance);
      claim.differs("integral without the root is not", model, square_a, distance);
    }
  });
  // On every group: a geodesic of a right-invariant metric keeps its speed, so that the printed integral over [0, 1] is the square of the length.
  claim.degree(100);
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto metric = draw_algebra_polynomial<S>(draw, group.dimension());
    metric.b.setZero(), metric.kappa = S(0);
    auto const xi = draw.template velocity<S>(group);
    auto const mu = gradient(metric, xi);
    claim.zero("a geodesic keeps its speed", model, pair(mu, euler_poincare_acceleration_right(metric, xi)), size_of(ad_star(xi, mu)) * size_of(xi));
  });
}

STATEMENT(claim_3_3_chart_diameter, "diameters of the chart domain and of its translates") {
  claim.holds("Right translation is an isometry of a metric translated on the right; it is not one of a metric translated on the left.");
  claim.degree(100);  // four places of Aff(1), each a quotient of degree 2, in a distance of degree 4 of their products
  auto const aff1 = spanned("Aff(1)", Aff1{});
  over_groups({aff1}, claim, [&](auto const& group, auto const& model) {
    auto const g = draw.template element<S>(group);
    std::vector<Place<S>> domain;
    for (int i = 0; i < 4; ++i) domain.push_back(draw.template element<S>(group));
    auto const diameter = [&](auto const& move) {
      S largest(1);
      for (auto const& a : domain)
        for (auto const& b : domain) largest = std::max(largest, S(cosh_distance(move(a), move(b))));
      return largest;
    };
    S const plain = diameter([](auto const& a) { return a; });
    claim.equal("cosh of the diameter of four places and of their right translates", model, diameter([&](auto const& a) { return a * g; }), plain);
    claim.differs("of their left translates", model, diameter([&](auto const& a) { return g * a; }), plain);
  });
  // On every group: right translation leaves the speed of every curve as it is.
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw.template element<S>(group, S(1)), h = draw.template element<S>(group);
    auto const v = draw.template velocity<S>(group);
    auto const curve = moving_along(v) * over<Dual<S>>(h);
    SquareNorm const norm;
    claim.equal("speed of a curve and of its right translate", model, norm(state_of(curve * over<Dual<S>>(g)).velocity), norm(v));
    if (model != "SO(3)") claim.differs("and of its left translate", model, norm(state_of(over<Dual<S>>(g) * curve).velocity), norm(v));
  });
}

STATEMENT(claim_3_3_chart_condition, "condition on two group elements for the discrete Lagrangian to be defined") {
  claim.corrected(R"(\mathrm{dist}(g_1,g_2) < \mathrm{diam}(U))", R"(\mathrm{dist}(g_i, g) < r,\ i = 1, 2,\quad\text{where } U \text{ contains the ball of radius } r \text{ about } e)",
                  "Two places nearer to each other than the diameter of $U$ may be further from the base point than $U$ reaches: with the base point at either end the radius counts, half the diameter of a ball. The printed bound is enough where the base point is half-way.");
  // U: the rotations by less than a right angle. Its radius is pi/2 and its diameter pi: rotations by nearly +- a right angle are nearly half a turn apart.
  auto const so3 = spanned("SO(3)", SO<3>{});
  S const one(1);
  for (int point = 0; point < exact_points; ++point) {
    auto const g2 = draw.template element<S>(so3, S(2)), g = draw.template element<S>(so3, S(2));
    S const inside = (S(1) + draw.template number<S>()) / S(2), outside = ratio<S>(11, 8) + draw.template number<S>() / S(4);
    claim.fact("dist(g1, g2) < r puts g1 into the chart at g2", "SO(3), U of radius pi/2", cos_angle(Place<S>(rotation_by_half_tangent(so3, inside) * g2), g2) > S(0));
    auto const e = identity<S>(so3);
    auto const nearly = rotation_by_half_tangent(so3, ratio<S>(99, 100));
    claim.fact("the diameter of U is more than 178 degrees", "SO(3), U of radius pi/2", cos_angle(nearly, e) > S(0) && cos_angle(nearly, inverse(nearly)) < -ratio<S>(999, 1000));
    // Half-way, the printed bound does: g1 = s g, g2 = s^-1 g with s by less than a right angle.
    auto const s = rotation_by_half_tangent(so3, inside);
    claim.fact("dist(g1, g2) < diam(U) is enough at the place half-way", "SO(3), U of radius pi/2", cos_angle(s * g, g) > S(0) && cos_angle(inverse(s) * g, g) > S(0));
    // Control: nearer than the diameter, 97 to 117 degrees apart, and outside of the chart at g2: by how much the angle's cosine lies below that of U's edge.
    auto const g1 = rotation_by_half_tangent(so3, outside) * g2;
    claim.fact("the control's places are nearer than the diameter", "SO(3), U of radius pi/2", cos_angle(g1, g2) > -ratio<S>(999, 1000));
    S const excess = S(0) > cos_angle(g1, g2) ? S(-cos_angle(g1, g2)) : S(0);
    claim.refutes("dist(g1, g2) < diam(U), base point at g2: outside by", "SO(3), U of radius pi/2", excess, one);
  }
  if constexpr (Real<S>) {
    // With all of the chart of SE(3): up to half a turn every place is met, however far away it is, so that U has no finite diameter.
    SE<3> const se3;
    auto const far = [&](S const& angle, S const& distance) {
      Coordinates<SE<3>, S> v = Coordinates<SE<3>, S>::Zero();
      v[0] = angle, v[4] = distance;
      return exp(Velocity<SE<3>, S>{se3, v});
    };
    using std::acos;
    S const pi = acos(S(-1));
    auto const g = draw.template element<S>(se3);
    for (auto [fraction, distance] : {std::pair{1, 1L}, {90, 1000L}, {99, 1000000L}}) {
      auto const k = far(pi * S(fraction) / S(100), S(distance)) * g;
      claim.equal("less than half a turn from the base point: in the chart", "SE(3)", exp(natural_chart_right(g, k)) * g, k);
    }
    claim.template refuses<OutsideDomain>("half a turn away: at a finite distance, below the infinite diameter of U", "SE(3)", [&] { natural_chart_right(g, far(pi, S(1)) * g); });
    // SL(2): the chart has no finite diameter either, and whole regions outside of it.
    Eigen::Matrix<S, 2, 2> hyperbolic;
    hyperbolic << S(-2), S(0), S(0), ratio<S>(-1, 2);
    claim.template refuses<OutsideDomain>("no logarithm: at a finite distance, below the infinite diameter of U", "SL(2)", [&] { log(Element<SL2, S>{{}, hyperbolic}); });
  }
}
