// Section 3.3: distances, how far a chart reaches, and the steps that it allows.

#include "actio/variational/euler_poincare.hpp"

#include "models/chart_models.hpp"
#include "models/enclosures.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// \f$|\xi|^2\f$ of the metric whose basis is orthonormal.
struct SquareNorm {
  template <class T>
  T operator()(Velocity<SpannedGroup, T> const& xi) const {
    T sum(0);
    for (Index i = 0; i < xi.coordinates.size(); ++i) sum += xi.coordinates[i] * xi.coordinates[i];
    return sum;
  }
};
/// \f$\cosh\f$ of the distance in Aff(1) with that metric, translated on the right: inverted, it is the
/// hyperbolic plane of points (shift, stretch).
template <class S>
S cosh_distance(GroupElement<S> const& g1, GroupElement<S> const& g2) {
  auto const p = inverse(g1).value, q = inverse(g2).value;
  S const dx = p(0, 1) - q(0, 1), dy = p(0, 0) - q(0, 0);
  return S(1) + (dx * dx + dy * dy) / (S(2) * p(0, 0) * q(0, 0));
}
/// A geodesic of it, at unit speed in log u: a half circle of centre c and radius r, inverted back.
template <class T, class S>
GroupElement<T> half_circle(SpannedGroup const& aff1, S const& c, S const& r, T const& u) {
  T const w = u * u + T(1);
  Matrix<T> k = Matrix<T>::Identity(2, 2);
  k(0, 0) = T(2) * u * T(r) / w, k(0, 1) = T(c) + T(r) * (u * u - T(1)) / w;
  return inverse(GroupElement<T>{aff1, k});
}
/// \f$\cos\f$ of the angle between two rotations of space.
template <class S>
S cos_angle(GroupElement<S> const& g1, GroupElement<S> const& g2) {
  auto const f = (g1 * inverse(g2)).value;
  return (f(0, 0) + f(1, 1) + f(2, 2) - S(1)) / S(2);
}
/// A rotation with tan(angle/2) = t about an axis with rational length.
template <class S>
GroupElement<S> rotation_by_half_tangent(SpannedGroup const& so3, S const& t) {
  Vector<S> axis(3);
  axis << S(2), S(-1), S(2);
  return retract(Algebra<S>{so3, Vector<S>(axis * (S(2) * t / S(3)))});
}

}  // namespace

STATEMENT(claim_3_3_riemannian_distance, "Riemannian distance through the connecting geodesic") {
  claim.corrected(
      R"(\mathrm{dist}(g_1,g_2) = \int_0^1\langle\dot\gamma,\dot\gamma\rangle\,dt)",
      R"(\mathrm{dist}(g_1,g_2) = \int_0^1\langle\dot\gamma,\dot\gamma\rangle^{1/2}\,dt)",
      "Without the root the integral is the square of the distance: on the pieces of one geodesic it does "
      "not add up, and the triangle inequality fails. The geodesic is a shortest one.");
  claim.maybe_scan();
  // A half circle and its two derivatives are quotients of degree 12 at most in u, r, c and the rate; their
  // inverses and products raise that to 60 at most.
  auto const aff1 = spanned("Aff(1)", Aff1{});
  auto const kinetic = [](auto const& xi) { return SquareNorm{}(xi) / 2; };
  over_groups({aff1}, claim, [&](auto const& group, auto const& model) {
    S const c = draw.template number<S>(), r = S(2) + draw.template number<S>(),
            u = S(2) + draw.template number<S>();
    auto const rate_a = (S(2) + draw.template number<S>()) / S(4),
               rate_b = (S(2) + draw.template number<S>()) / S(4);
    // Two legs of one geodesic, each run through in unit time; log u goes at a constant rate.
    auto const square_speed = [&](S const& rate, S const& at) {
      using D = Dual<S>;
      D position(at), speed(S(rate * at));
      position.part[0] = rate * at, speed.part[0] = rate * rate * at;
      Dual<D> nested(position);
      nested.part[0] = speed;
      auto const xi = state_of(half_circle(group, c, r, nested)).velocity;
      Algebra<S> const velocity{group, Vector<S>(value_part<S>(xi.coordinates))},
          acceleration{group, Vector<S>(rate_part<S>(xi.coordinates))};
      claim.zero("a half circle is a geodesic of the right-invariant metric", model,
                 euler_poincare_right(kinetic, velocity, acceleration),
                 size_of(velocity) * size_of(velocity));
      return SquareNorm{}(velocity);
    };
    S const square_a = square_speed(rate_a, u), square_b = square_speed(rate_b, u),
            square = square_speed(rate_a + rate_b, u);
    claim.equal("its speed is the same everywhere", model, square_speed(rate_a, u * (S(1) + rate_b)),
                square_a);
    // The speeds are the roots of these: lengths of the legs add up to that of the whole.
    claim.equal("square of the sum of the lengths of two legs is that of the whole", model,
                square_a + square_b + S(2) * rate_a * rate_b, square);
    claim.equal("length of a leg, squared", model, square_a, rate_a * rate_a);
    // Control: without the root they do not.
    claim.differs("without the root the two legs fall short of the whole", model, square_a + square_b,
                  square);
    if (!exact_arithmetic<S>()) {
      using std::exp, std::log, std::sqrt;
      S const cosh = cosh_distance(half_circle(group, c, r, u), half_circle(group, c, r, S(u * exp(rate_a))));
      // The distance from its closed form.
      S const distance = log(S(cosh + sqrt(S(cosh * cosh - 1))));
      claim.equal("integral of the root is the hyperbolic distance", model, S(sqrt(square_a)), distance);
      claim.differs("integral without the root is not", model, square_a, distance);
    }
  });
  // On every group: a geodesic of a right-invariant metric has constant speed, so that the printed integral
  // over [0, 1] is the square of the length.
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto metric = draw_algebra_polynomial<S>(draw, group.dimension());
    metric.b.setZero(), metric.kappa = S(0);
    auto const xi = draw.template velocity<S>(group);
    auto const mu = gradient(metric, xi);
    claim.zero("a geodesic has constant speed", model,
               pair(mu, euler_poincare_acceleration_right(metric, xi)),
               size_of(ad_star(xi, mu)) * size_of(xi));
  });
}

STATEMENT(claim_3_3_chart_diameter, "diameters of the chart domain and of its translates") {
  claim.holds(
      "Right translation is an isometry of a metric translated on the right; it is not one of a "
      "metric translated on the left.");
  auto const aff1 = spanned("Aff(1)", Aff1{});
  // Of any two configurations: so of all that a set holds.
  over_groups({aff1}, claim, [&](auto const& group, auto const& model) {
    auto const g = draw.template element<S>(group), a = draw.template element<S>(group),
               b = draw.template element<S>(group);
    S const plain = cosh_distance(a, b);
    claim.equal("cosh of the distance of any two and of their right translates", model,
                cosh_distance(GroupElement<S>(a * g), GroupElement<S>(b * g)), plain);
    claim.differs("of their left translates", model,
                  cosh_distance(GroupElement<S>(g * a), GroupElement<S>(g * b)), plain);
  });
  // Where lengths can be compared.
  if (ordered_arithmetic<S>())
    over_groups({aff1}, claim, [&](auto const& group, auto const& model) {
      auto const g = draw.template element<S>(group);
      std::vector<GroupElement<S>> domain;
      for (int i = 0; i < 4; ++i) domain.push_back(draw.template element<S>(group));
      auto const diameter = [&](auto const& move) {
        S largest(1);
        for (auto const& a : domain)
          for (auto const& b : domain) largest = std::max(largest, S(cosh_distance(move(a), move(b))));
        return largest;
      };
      S const plain = diameter([](auto const& a) { return a; });
      claim.equal("cosh of the diameter of four configurations and of their right translates", model,
                  diameter([&](auto const& a) { return a * g; }), plain);
      claim.differs("of their left translates", model, diameter([&](auto const& a) { return g * a; }), plain);
    });
  // On every group, with any metric: right translation leaves the product of any two tangent vectors at a
  // configuration as it is, so lengths of all curves, and distances.
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw.template element<S>(group, S(1)), h = draw.template element<S>(group);
    auto const v = draw.template velocity<S>(group), w = draw.template velocity<S>(group);
    Matrix<S> const metric = draw_algebra_polynomial<S>(draw, group.dimension()).a;
    auto const product = [&](auto const& move) {
      auto const first = state_of(move(moving_along(v) * over<Dual<S>>(h))).velocity,
                 second = state_of(move(moving_along(w) * over<Dual<S>>(h))).velocity;
      return S(first.coordinates.dot(metric * second.coordinates));
    };
    auto const to_right = [&](auto const& x) { return x * over<Dual<S>>(g); };
    auto const to_left = [&](auto const& x) { return over<Dual<S>>(g) * x; };
    S const plain = v.coordinates.dot(metric * w.coordinates),
            scale = magnitude(v.coordinates) * magnitude(metric) * magnitude(w.coordinates);
    // Condition: a configuration is inverted.
    claim.zero("product of two tangent vectors and of their right translates", model,
               S(product(to_right) - plain), scale, 10);
    claim.refutes("and of their left translates", model, S(product(to_left) - plain), scale);
  });
}

STATEMENT(claim_3_3_chart_condition,
          "condition on two group elements for the discrete Lagrangian to be defined") {
  claim.corrected(R"(\mathrm{dist}(g_1,g_2) < \mathrm{diam}(U))",
                  R"(\mathrm{dist}(g_i, g) < r,\ i = 1, 2,)"
                  R"(\quad\text{where } U \text{ contains the ball of radius } r \text{ about } e)",
                  "Two configurations nearer to each other than the diameter of $U$ may be further from "
                  "the base point than $U$ reaches: with the base point at either end the radius counts, "
                  "half the diameter of a ball. For a ball the printed bound is enough where the base "
                  "point is half-way along a shortest geodesic.");
  // U: the rotations by less than a right angle. Its radius is pi/2 and its diameter pi: rotations by
  // nearly +- a right angle are nearly half a turn apart.
  auto const so3 = spanned("SO(3)", SO<3>{});
  S const one(1);
  if (ordered_arithmetic<S>()) {
    auto const g2 = draw.template element<S>(so3, S(2)), g = draw.template element<S>(so3, S(2));
    S const inside = (S(1) + draw.template number<S>()) / S(2),
            outside = ratio<S>(11, 8) + draw.template number<S>() / S(4);
    claim.fact("dist(g1, g2) < r puts g1 into the chart at g2", "SO(3), U of radius pi/2",
               cos_angle(GroupElement<S>(rotation_by_half_tangent(so3, inside) * g2), g2) > S(0));
    auto const e = identity<S>(so3);
    auto const nearly = rotation_by_half_tangent(so3, ratio<S>(99, 100));
    claim.fact("the diameter of U is more than 178 degrees", "SO(3), U of radius pi/2",
               cos_angle(nearly, e) > S(0) && cos_angle(nearly, inverse(nearly)) < -ratio<S>(999, 1000));
    // Half-way, the printed bound does: g1 = s g, g2 = s^-1 g with s by less than a right angle.
    auto const s = rotation_by_half_tangent(so3, inside);
    claim.fact("dist(g1, g2) < diam(U) is enough at the configuration half-way", "SO(3), U of radius pi/2",
               cos_angle(s * g, g) > S(0) && cos_angle(inverse(s) * g, g) > S(0));
    // Control: nearer than the diameter, 97 to 117 degrees apart, and outside of the chart at g2: by how much
    // the angle's cosine lies below that of U's edge.
    auto const g1 = rotation_by_half_tangent(so3, outside) * g2;
    claim.fact("the control's configurations are nearer than the diameter", "SO(3), U of radius pi/2",
               cos_angle(g1, g2) > -ratio<S>(999, 1000));
    S const excess = S(0) > cos_angle(g1, g2) ? S(-cos_angle(g1, g2)) : S(0);
    claim.refutes("dist(g1, g2) < diam(U), base point at g2: outside by", "SO(3), U of radius pi/2", excess,
                  one);
  }
  if (ordered_arithmetic<S>()) {
    // Aff(1) with its metric, U a ball. Places at u, u r and u r^2 of one geodesic, in units of log 3, the
    // radius of U: log r is between log 2 and log 3, so that the ends are nearer than the diameter of U.
    auto const aff1 = spanned("Aff(1)", Aff1{});
    std::string const model = "Aff(1), U a ball";
    S const c = draw.template number<S>(), radius = S(2) + draw.template number<S>(),
            u = S(2) + draw.template number<S>(), r = ratio<S>(5, 2) + draw.template number<S>() / S(2);
    auto const cosh_of_log = [](S const& x) { return S((x + S(1) / x) / S(2)); };
    auto const g2 = half_circle(aff1, c, radius, u), middle = half_circle(aff1, c, radius, S(u * r)),
               g1 = half_circle(aff1, c, radius, S(u * r * r)),
               end = half_circle(aff1, c, radius, S(u * S(9)));
    claim.equal("dist(g1, g2) along the geodesic", model, cosh_distance(g1, g2), cosh_of_log(S(r * r)), 10);
    claim.equal("the diameter of U: two radii, reached on a geodesic", model, cosh_distance(end, g2),
                cosh_of_log(S(9)), 10);
    claim.fact("dist(g1, g2) < diam(U)", model, cosh_distance(g1, g2) < cosh_of_log(S(9)));
    claim.fact(
        "the configuration half-way along the geodesic is in reach of both", model,
        cosh_distance(g1, middle) < cosh_of_log(S(3)) && cosh_distance(g2, middle) < cosh_of_log(S(3)));
    S const beyond = cosh_distance(g1, g2) - cosh_of_log(S(3));
    claim.refutes("dist(g1, g2) < diam(U), base point at g2: outside by", model,
                  S(beyond > S(0) ? beyond : S(0)), cosh_of_log(S(9)));
  }
  if (!exact_arithmetic<S>()) {
    // With all of the chart of SE(3): up to half a turn every configuration is met, however far away it is,
    // so that U has no finite diameter.
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
      claim.equal("less than half a turn from the base point: in the chart", "SE(3)",
                  exp(natural_chart_right(g, k)) * g, k);
    }
    claim.template refuses<OutsideDomain>(
        "half a turn away: at a finite distance, below the infinite diameter of U", "SE(3)",
        [&] { natural_chart_right(g, far(pi, S(1)) * g); });
    // SL(2): the chart has no finite diameter either, and whole regions outside of it.
    Matrix<S, 2, 2> hyperbolic;
    hyperbolic << S(-2), S(0), S(0), ratio<S>(-1, 2);
    claim.template refuses<OutsideDomain>(
        "no logarithm: at a finite distance, below the infinite diameter of U", "SL(2)", [&] {
          log(Element<SL2, S>{{}, hyperbolic});
        });
  }
}

STATEMENT(claim_3_3_distance_restricts_step, "the domain of the chart restricts the time step") {
  claim.holds(
      "A motion whose speed is at most $v$ stays within $v\\,\\Delta t$ of where a step began, so $\\Delta "
      "t < r/v$ with the radius $r$ of the chart is enough. The bound depends on the motion: what is short "
      "enough for one is too long for one twice as fast.");
  auto const so3 = spanned("SO(3)", SO<3>{});
  {
    // Rotations about one axis at a constant rate: the distance grows with the time.
    S const t = draw.template number<S>() / S(2);
    auto const g = draw.template element<S>(so3);
    auto const step = rotation_by_half_tangent(so3, t);
    S const cosine = (S(1) - t * t) / (S(1) + t * t);
    claim.equal("cosine of the distance after one step", "SO(3)", cos_angle(GroupElement<S>(step * g), g),
                cosine);
    claim.equal("and after two, at the same speed", "SO(3)", cos_angle(GroupElement<S>(step * step * g), g),
                S(S(2) * cosine * cosine - S(1)));
    claim.differs("as if the distance did not depend on the step", "SO(3)",
                  cos_angle(GroupElement<S>(step * step * g), g), cosine);
  }
  // A motion on Aff(1), x = 2t/3 - t^2/5, y = 1 + t/4 in the half plane of shifts and stretches, for all
  // steps up to 1: its squared speed is below 3/5, and cosh of the distance below 1 + (3/5) h^2/2, less than
  // cosh(v h).
  auto const x = [](auto const& t) { return Number(2) / 3 - t / 5; };
  auto const squared_speed = [](Number const& t) {
    Number const u = Number(2) / 3 - t * 2 / 5, w = Number(1) / 4, y = Number(1) + t / 4;
    return Number((u * u + w * w) / (y * y));
  };
  claim.encloses("the squared speed is below 3/5", "Aff(1), steps up to 1", [&] {
    return positive_along([&](Number const& t) { return Number(Number(3) / 5 - squared_speed(t)); },
                          Number(0), Number(1));
  });
  claim.encloses("the distance is less than v h", "Aff(1), steps up to 1", [&] {
    return positive_along(
        [&](Number const& h) {
          Number const a = x(h), b = Number(1) / 4;
          return Number(Number(3) / 5 - (a * a + b * b) / (Number(1) + h / 4));
        },
        Number(0), Number(1));
  });
  claim.refutes_enclosure("the same bound for a motion twice as fast", "Aff(1), steps up to 1", [&] {
    return positive_along(
        [&](Number const& h) {
          Number const a = x(Number(h * 2)) * 2, b = Number(1) / 2;
          return Number(Number(3) / 5 - (a * a + b * b) / (Number(1) + h / 2));
        },
        Number(0), Number(1));
  });
  claim.encloses("v h < 3.1: less than half a turn, in the chart", "SO(3), every such step", [&] {
    using std::cos;
    return positive_along([](Number const& angle) { return Number(Number(1) + cos(angle)); }, Number(0),
                          Number(31) / 10);
  });
  claim.refutes_enclosure("v h < 3.2", "SO(3), every such step", [&] {
    using std::cos;
    return positive_along([](Number const& angle) { return Number(Number(1) + cos(angle)); }, Number(0),
                          Number(32) / 10);
  });
  if (exact_arithmetic<S>()) return;
  // The chart itself: at 3/5 of half a turn it gives the velocity, at 6/5, twice as fast, another one.
  using std::acos;
  Vector<S> axis(3);
  axis << S(2), S(-1), S(2);
  auto const g = draw.template element<S>(so3);
  Algebra<S> const v{so3, Vector<S>(axis * S(acos(S(-1)) / S(5)))};  // |v| = 3/5 of half a turn
  auto const zeta = [&](S const& h) {
    return chart_midpoint_right(g, g, GroupElement<S>(exp(h * v) * g), h).zeta;
  };
  claim.equal("a step of 1: the velocity", "SO(3)", zeta(S(1)), v);
  claim.differs("a step of 2: another velocity", "SO(3)", zeta(S(2)), v);
}
