// Section 6.2: acceleration and Christoffel symbols, constant metrics, the covariant divergence, Piola's
// identity; stresses, fluids and solids. The second source of the section: a compiler wants 2 GB for all of
// it.

#include "fields/fields.hpp"
#include "fields/media.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// A metric in other coordinates z with y = chart(z).
template <class Metric, class Chart>
struct MetricInChart {
  Metric g;
  Chart chart;
  template <class T, int n>
  actio::Matrix<T, n, n> operator()(actio::Matrix<T, n, 1> const& z) const {
    return pulled_back(g(chart(z).eval()),
                       pushed(chart, z, Tangents<T, n, n>(Tangents<T, n, n>::Identity())));
  }
};

/// A chart of space near the identity.
template <class S, int n>
struct AnyChart {
  std::array<Cubic<S, n>, n> added;
  template <class V>
  auto operator()(V const& z) const {
    actio::Matrix<ScalarOf<V>, n, 1> y;
    for (int a = 0; a < n; ++a) y[a] = z[a] + added[a](z);
    return y;
  }
};

/// The acceleration with the symbols contracted as printed, for one value of the index that is left over.
template <class Medium, class S, int n, int N>
actio::Matrix<S, N, 1> printed_acceleration(Medium const& medium, SecondJet<S, n, N> const& j, int a) {
  auto const gamma = christoffel(medium.g, j.y);
  actio::Matrix<S, N, 1> sum = j.acceleration();
  for (int b = 0; b < N; ++b)
    for (int c = 0; c < N; ++c) sum[b] += gamma[a](b, c) * j.velocity()[b] * j.velocity()[c];
  return sum;
}

/// The symmetric symbols \f$\gamma^c_{ab}\f$ under which a metric with these derivatives is parallel, by
/// solving the \f$n^2(n+1)/2\f$ conditions for as many unknowns.
template <class S, int n, class Rates>
std::array<actio::Matrix<S, n, n>, n> parallel_symbols(actio::Matrix<S, n, n> const& g, Rates const& rates) {
  constexpr int pairs = n * (n + 1) / 2, size = n * pairs;
  auto const index = [](int c, int a, int b) {
    return c * pairs + (a > b ? a * (a + 1) / 2 + b : b * (b + 1) / 2 + a);
  };
  actio::Matrix<S, size, size> conditions = actio::Matrix<S, size, size>::Zero();
  actio::Matrix<S, size, 1> right;
  for (int c = 0; c < n; ++c)
    for (int a = 0; a < n; ++a)
      for (int b = 0; b <= a; ++b) {
        int const row = index(c, a, b);
        right[row] = rates[c](a, b);
        for (int d = 0; d < n; ++d) {
          conditions(row, index(d, a, c)) += g(d, b);
          conditions(row, index(d, b, c)) += g(a, d);
        }
      }
  actio::Matrix<S, size, 1> const symbols = solve_linear(conditions, right, "parallel_symbols");
  std::array<actio::Matrix<S, n, n>, n> gamma;
  for (int c = 0; c < n; ++c)
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) gamma[c](a, b) = symbols[index(c, a, b)];
  return gamma;
}

}  // namespace

STATEMENT(claim_6_2_material_acceleration, "the material acceleration in coordinates") {
  claim.corrected(R"(\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b \equiv \frac{\partial\dot\phi^b}{\partial t} + )"
                  R"(\gamma^a_{bc}\,\dot\phi^b\dot\phi^c)",
                  R"(\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b \equiv \frac{\partial\dot\phi^b}{\partial t} + )"
                  R"(\gamma^b_{ac}\,\dot\phi^a\dot\phi^c)",
                  "The free index $b$ of the left side is summed on the right, where $a$ is left over: the "
                  "names of $a$ and $b$ are exchanged in the last term.");
  // A metric of degree 4 and its inverse, a section of degree 3, a chart of degree 3.
  over_points(claim, BodiesInSpace{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    auto const dust = draw_medium<S, n, N>(draw, Kind::dust);
    auto const j = draw_second_jet<S, n, N>(draw);
    auto const E = (euler_lagrange(dust, j) / body_volume(dust, j)).eval();
    claim.equal("the field equations of dust", model, (-inertial_force(dust, j)).eval(), E);
    for (int a = 0; a < N; ++a)
      claim.differs("as printed, a given the value " + std::to_string(a + 1), model, raised(dust.g(j.y), E),
                    (printed_acceleration(dust, j, a) * -S(dust.rho(j.particle()))).eval());
  });
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    AnyChart<S, n> chart;
    for (auto& c : chart.added) c = draw_cubic<S, n>(draw, ratio<S>(1, 5));
    auto const g = draw_metric<S, n>(draw);
    auto const phi = draw_section<S, n, n>(draw);
    auto const x = draw_event<S, n>(draw);
    auto const j = second_jet(phi, x), k = second_jet([&](auto const& at) { return chart(phi(at)); }, x);
    auto const carried = pushed(chart, j.y,
                                Tangents<S, n, 1>(material_acceleration(
                                    MetricInChart<AnyMetric<S, n>, AnyChart<S, n>>{g, chart}, j)));
    claim.equal("a vector: the same in other coordinates", model, carried, material_acceleration(g, k));
    claim.differs("the second derivatives alone", model,
                  pushed(chart, j.y, Tangents<S, n, 1>(j.acceleration())), k.acceleration());
  });
}

STATEMENT(claim_6_2_christoffel, "the Christoffel symbols of the field metric") {
  claim.holds(
      "The symmetric symbols under which the metric is parallel. That fixes them: solved "
      "for, all $n^2(n+1)/2$ come out.");
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const g = draw_metric<S, n>(draw);
    actio::Matrix<S, n, 1> const y = draw.vector<S, actio::Matrix<S, n, 1>>(n) * ratio<S>(1, 2);
    auto const gamma = christoffel(g, y);
    auto const rates = metric_derivatives(g, y);
    actio::Matrix<S, n, n> const here = g(y);
    S parallel(0), flipped(0), skew(0), size(0);
    auto const grow = [](S& largest, S const& x) {
      if (magnitude(x) > largest) largest = magnitude(x);
    };
    actio::Matrix<S, n, n> const inverse = inverse_matrix(here);
    for (int c = 0; c < n; ++c)
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) {
          S residual = rates[c](a, b), broken = rates[c](a, b);
          for (int d = 0; d < n; ++d) {
            // The sign of the last of the three derivatives, changed.
            auto const other = [&](int e, int f) {
              S sum = gamma[d](e, f);
              for (int h = 0; h < n; ++h) sum += inverse(d, h) * rates[h](e, f);
              return sum;
            };
            residual -= here(d, b) * gamma[d](a, c) + here(a, d) * gamma[d](b, c);
            broken -= here(d, b) * other(a, c) + here(a, d) * other(b, c);
          }
          grow(parallel, residual), grow(flipped, broken), grow(size, rates[c](a, b)),
              grow(skew, S(gamma[c](a, b) - gamma[c](b, a)));
        }
    claim.zero("the covariant derivative of g", model, parallel, size);
    claim.zero("symmetric in the lower indices", model, skew, size, n);
    claim.refutes("the last sign changed", model, flipped, size);
    // Elimination among up to 18 unknowns, each step as well conditioned as the metric.
    auto const solved = parallel_symbols(here, rates);
    for (int c = 0; c < n; ++c) {
      claim.equal("the only such symbols", model, gamma[c], solved[c], 100);
      claim.differs("of the transposed condition", model, gamma[c], parallel_symbols(inverse, rates)[c]);
    }
  });
}

STATEMENT(eq_6_15, "the equation of motion with constant metrics") {
  claim.holds(
      "In coordinates in which $g$ and $G$ are constant; the mass density, which may "
      "vary, stays inside the derivative.");
  // An energy of degree 3 in metrics of degree 4 and a section of degree 3.
  over_points(claim, BodiesInSpace{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    auto const curved = draw_medium<S, n, N>(draw, Kind::any), flat = flattened<S, n, N>(curved);
    auto const j = draw_second_jet<S, n, N>(draw);
    auto const left = [&](AnyContinuum<S, n, N> const& medium) {
      return (lowered(medium.g(j.y), j.acceleration()) * S(medium.rho(j.particle()))).eval();
    };
    auto const right = [&](AnyContinuum<S, n, N> const& medium) {
      return two_point_rates([&](auto const& jet) { return first_piola_kirchhoff_stress(medium, jet); }, j)
          .divergence;
    };
    auto const E = [&](AnyContinuum<S, n, N> const& medium) {
      return (euler_lagrange(medium, j) / body_volume(medium, j)).eval();
    };
    claim.equal("(6.15) and the field equations", model, (right(flat) - left(flat)).eval(), E(flat));
    auto const outside = two_point_rates([&](auto const& jet) { return partial_F(flat, jet); }, j).divergence;
    claim.differs("the mass density outside the derivative", model,
                  (outside * S(flat.rho(j.particle())) - left(flat)).eval(), E(flat));
    claim.differs("the acceleration with its index up", model,
                  (right(flat) - j.acceleration() * S(flat.rho(j.particle()))).eval(), E(flat));
    claim.differs("metrics that are not constant", model, (right(curved) - left(curved)).eval(), E(curved));
  });
}

STATEMENT(claim_6_2_covariant_divergence, "the covariant divergence of a two-point tensor") {
  claim.corrected(R"(\frac{\partial\mathcal P_a{}^i}{\partial x^i} + \mathcal P_a{}^j\,\Gamma^k_{jk} - )"
                  R"(\mathcal P_b{}^i\,\gamma^b_{ac}\,F_j{}^c)",
                  R"(\frac{\partial\mathcal P_a{}^i}{\partial x^i} + \mathcal P_a{}^j\,\Gamma^k_{jk} - )"
                  R"(\mathcal P_b{}^j\,\gamma^b_{ac}\,F^c{}_j)",
                  "In the last term $i$ and $j$ are left over; they are one index, summed. The divergence "
                  "is fixed by Leibniz' rule with vector fields of space.");
  claim.maybe_scan();
  over_points(claim, BodiesInSpace{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    using Column = actio::Matrix<S, N, 1>;
    using OfBody = actio::Matrix<S, n, 1>;
    auto const medium = draw_medium<S, n, N>(draw, Kind::any);
    auto const j = draw_second_jet<S, n, N>(draw);
    auto const T = [&](auto const& jet) { return first_piola_kirchhoff_stress(medium, jet); };
    AnyChart<S, N> field;
    for (auto& c : field.added) c = draw_cubic<S, N>(draw);
    auto const [value, derivative] = two_point_rates(T, j);
    Column const DIV = two_point_divergence(medium.G, medium.g, j, T);

    // The vector T w of the body, whose divergence is that of its metric.
    auto const weighted = [&]<class R>(Jet<R, n, N> const& jet) {
      return actio::Matrix<R, 1, n>((field(jet.y).transpose() * T(jet)) *
                                    volume<R>(medium.G(jet.particle())));
    };
    S left(0);
    for (int i = 0; i < n; ++i) left += weighted(along(j, i + 1))(0, i).part[0];
    left /= body_volume(medium, j);
    auto const Gamma = christoffel(medium.G, j.particle());
    auto const gamma = christoffel(medium.g, j.y);
    Column const w = field(j.y);
    S turned(0);  // T_a^i times the covariant derivative of w along F_i
    actio::Matrix<S, N, n> const rate = pushed(field, j.y, Tangents<S, N, n>(j.gradient()));
    for (int i = 0; i < n; ++i)
      turned +=
          value.col(i).dot(Column(rate.col(i) + connection(medium.g, j.y, w, Column(j.gradient().col(i)))));
    claim.equal("Leibniz' rule", model, left, S(DIV.dot(w) + turned));

    Column on_space = Column::Zero(), free = Column::Zero(), on_body = Column::Zero();
    Column const sums = value * OfBody::Ones(), velocities = j.gradient() * OfBody::Ones();
    for (int a = 0; a < N; ++a) {
      for (int b = 0; b < N; ++b)
        for (int c = 0; c < N; ++c) {
          on_space[a] += gamma[b](a, c) * value.row(b).dot(j.gradient().row(c));
          free[a] += gamma[b](a, c) * sums[b] * velocities[c];
        }
      for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k) on_body[a] += value(a, i) * Gamma[k](i, k);
    }
    claim.equal("term by term", model, DIV, Column(derivative + on_body - on_space));
    // Of a rod there is one index i, and the printed form is right.
    if (n > 1)
      claim.differs("as printed, i and j summed one by one", model, left,
                    S((derivative + on_body - free).dot(w) + turned));
    claim.differs("the last sign changed", model, left, S((derivative + on_body + on_space).dot(w) + turned));
    claim.differs("without the symbols of the body", model, left, S((derivative - on_space).dot(w) + turned));
  });
}

STATEMENT(claim_6_2_cancelling_terms, "the terms from the determinant and from the inverse gradient cancel") {
  claim.holds(
      "Piola's identity. Each of the two terms alone is not zero; the section must be "
      "one: mixed derivatives commute.");
  // Determinant and inverse of a gradient of degree 2 in the body, n = 3.
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    using Column = actio::Matrix<S, n, 1>;
    auto const G = draw_metric<S, n>(draw), g = draw_metric<S, n>(draw);
    auto const j = draw_second_jet<S, n>(draw);
    // Up to the common factor P sqrt(det g) / sqrt(det G).
    auto const terms = [&](SecondJet<S, n, n> const& at) {
      Column one = Column::Zero(), two = Column::Zero();
      for (int k = 0; k < n; ++k) {
        actio::Matrix<Dual<S>, n, n> const F = along(at, k + 1).gradient(), inverse = inverse_matrix(F);
        Dual<S> const det = determinant(F);
        for (int a = 0; a < n; ++a) {
          one[a] += det.part[0] * inverse(k, a).value;
          two[a] += det.value * inverse(k, a).part[0];
        }
      }
      return std::pair{one, two};
    };
    auto const [one, two] = terms(j);
    claim.equal("(I) and (II)", model, one, (-two).eval());
    claim.refutes("(I) alone", model, one, S(1));
    claim.zero("the covariant divergence of J / F", model, piola_identity(G, g, j), S(1));
    auto broken = j;
    broken.w[1](0, 2) += S(1);
    auto const [first, second] = terms(broken);
    claim.differs("gradients that are of no section", model, first, (-second).eval());
  });
}

// ----
// Section 6.2: the first Piola-Kirchhoff stress, and elasticity.

STATEMENT(eq_6_19, "the first Piola-Kirchhoff stress from the stored energy") {
  claim.corrected(R"(\mathcal P_a{}^i(\phi,x) = \rho(x)\,\frac{\partial W}{\partial v_i^{a_i}}(j^1\phi(x)))",
                  R"(\mathcal P_a{}^i(\phi,x) = \rho(x)\,\frac{\partial W}{\partial v^a{}_i}(j^1\phi(x)))",
                  "The index $i$ is set twice in the denominator; it is one index, and not summed.");
  claim.maybe_scan();
  claim.same_slip_as("claim_6_2_barotropic_momenta");
  // An energy of degree 3 in metrics of degree 4 and a section of degree 3.
  over_points(claim, BodiesInSpace{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    using T = Dual<S, n>;
    auto const medium = draw_medium<S, n, N>(draw, Kind::any);
    Jet<S, n, N> const j = draw_jet<S, n, N>(draw);
    auto const H = draw_tangents<S, N, n>(draw);
    // The energy per volume of the body on the way from F along H.
    auto moved = j.template cast<T>();
    for (int a = 0; a < N; ++a)
      for (int i = 0; i < n; ++i) moved.v(a, i + 1).part[0] = H(a, i);
    actio::Matrix<T, n, 1> const x = moved.particle();
    S const rate = medium.W(x, medium.G(x), medium.g(moved.y), moved.gradient()).part[0];
    actio::Matrix<S, N, n> const stress = first_piola_kirchhoff_stress(medium, j);
    S const power = stress.cwiseProduct(H).sum();
    claim.equal("the power of the stress", model, power, S(rate * medium.rho(j.particle())));
    claim.differs("without the mass density", model, power, rate);
    // Both signs of i read as a sum: the same covector for every direction of the body.
    actio::Matrix<S, N, 1> const summed = stress * actio::Matrix<S, n, 1>::Ones();
    if (n > 1)
      claim.differs("as printed, summed over i", model, S(summed.dot(H * actio::Matrix<S, n, 1>::Ones())),
                    S(rate * medium.rho(j.particle())));
  });
}

STATEMENT(claim_6_2_piola_momenta, "the stress and the spatial momenta") {
  claim.holds();
  over_points(claim, BodiesInSpace{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    auto const medium = draw_medium<S, n, N>(draw, Kind::any);
    Jet<S, n, N> const j = draw_jet<S, n, N>(draw);
    actio::Matrix<S, N, n> const p = momenta(medium, j).template rightCols<n>(),
                                 stress = first_piola_kirchhoff_stress(medium, j);
    claim.equal("minus the momenta over the volume", model, stress, (p / -body_volume(medium, j)).eval());
    claim.differs("the other sign", model, stress, (p / body_volume(medium, j)).eval());
    claim.differs("without the volume", model, stress, (-p).eval());
    // By the determinant in place of its root.
    S const volume = body_volume(medium, j);
    claim.differs("the volume squared", model, stress, (p / S(-volume * volume)).eval());
  });
}

STATEMENT(claim_6_2_piola_transform, "Piola's transformation") {
  claim.convention(
      "$W$ depends on $F$ and $g$ through the Green tensor alone (on $x$ and $G$ as it likes); the index "
      "is lowered with $g$, and $F$ has an inverse. The solid has no symmetry.");
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const solid = draw_medium<S, n>(draw, Kind::solid);
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    auto const at = point_of_medium(solid, j);
    auto const sigma = cauchy_stress(solid, j), stress = first_piola_kirchhoff_stress(solid, j);
    auto const transformed = piola_transformation(at.G, at.g, at.F, sigma);
    claim.equal("P and J sigma / F", model, stress, transformed);
    claim.differs("the inverse of F transposed", model, stress, (at.g * sigma * at.inverse * at.J).eval());
    claim.differs("without J", model, stress, (transformed / at.J).eval());
    auto const any = draw_medium<S, n>(draw, Kind::any);
    auto const there = point_of_medium(any, j);
    claim.differs("W not of the Green tensor", model, first_piola_kirchhoff_stress(any, j),
                  piola_transformation(there.G, there.g, there.F, cauchy_stress(any, j)));
  });
}

STATEMENT(claim_6_2_stress_symmetry, "the Cauchy stress is symmetric") {
  claim.convention(
      "With the symmetric derivative in $g$ it is so by definition. The balance of moment of momentum, "
      "that the Piola-Kirchhoff stress times $F$ is symmetric, needs a $W$ of the Green tensor, of a "
      "solid without symmetry as well.");
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    using T = Dual<S, n>;
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    auto const any = draw_medium<S, n>(draw, Kind::any);
    auto const solid = draw_medium<S, n>(draw, Kind::solid);
    auto const sigma = cauchy_stress(any, j);
    // P_a^i F^b_i with its first index raised.
    auto const moment = [&](auto const& medium) {
      return raised(medium.g(j.y), actio::Matrix<S, n, n>(first_piola_kirchhoff_stress(medium, j) *
                                                          j.gradient().transpose()));
    };
    claim.equal("P times F, a W of the Green tensor", model, moment(solid), moment(solid).transpose().eval());
    claim.differs("P times F, any W", model, moment(any), moment(any).transpose().eval());
    // Entries of g changed one at a time: what W makes of a matrix that is not symmetric.
    actio::Matrix<S, n, n> alone;
    for (int a = 0; a < n; ++a) {
      actio::Matrix<T, n, n> g = any.g(j.y).template cast<T>();
      for (int b = 0; b < n; ++b) g(a, b).part[b] = S(1);
      auto const moved = j.template cast<T>();
      T const energy = any.W(moved.particle(), any.G(moved.particle()), g, moved.gradient());
      for (int b = 0; b < n; ++b) alone(a, b) = energy.part[b];
    }
    // The rate of W along every symmetric change of g gives the stress, which has as many components.
    S const factor = any.rho(j.particle()) / point_of_medium(any, j).J;
    claim.equal("for any W: the slope along symmetric changes of g", model, sigma,
                (factor * (alone + alone.transpose())).eval());
    claim.differs("for any W: the slopes along its entries", model, sigma, (factor * S(2) * alone).eval());
    claim.differs("entries of g one at a time", model, alone, alone.transpose().eval());
  });
}

STATEMENT(eq_6_21, "the covariant equation of motion of elasticity") {
  claim.convention(
      "The left side is a vector and the right a covector: one index is raised with $g$. $W$ is a "
      "function of the Green tensor, the point of the body and $G$, without symmetry; bodies of fewer "
      "dimensions than their space as well.");
  over_points(claim, BodiesInSpace{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    auto const j = draw_second_jet<S, n, N>(draw);
    auto const E = [&](auto const& medium) {
      return raised(medium.g(j.y),
                    actio::Matrix<S, N, 1>(euler_lagrange(medium, j) / body_volume(medium, j)));
    };
    auto const solid = draw_medium<S, n, N>(draw, Kind::solid);
    claim.equal("(6.21) and the field equations", model, (-solid_equation(solid, j)).eval(), E(solid));
    auto const any = draw_medium<S, n, N>(draw, Kind::any);
    claim.differs("W not of the Green tensor", model, (-solid_equation(any, j)).eval(), E(any));
    actio::Matrix<S, N, 1> const unraised =
        material_acceleration(solid.g, j) * S(solid.rho(j.particle())) - stress_divergence(solid, j);
    claim.differs("a vector and a covector", model, (-unraised).eval(), E(solid));
    if constexpr (n == N) {
      // What (6.20) has more than (6.21).
      Jet<S, n, n> const& first = j;
      auto const excess = [&](auto const& medium) {
        auto const at = point_of_medium(medium, first);
        return std::pair{
            actio::Matrix<S, n, n>(first_piola_kirchhoff_stress(medium, first) * at.F.transpose()),
            actio::Matrix<S, n, n>(at.g * cauchy_stress(medium, first) * at.J)};
      };
      auto const [left, right] = excess(solid);
      claim.equal("the last term of (6.20) cancels", model, left, right);
      auto const [other, cauchy] = excess(any);
      claim.differs("and does not for any W", model, other, cauchy);
    }
  });
}

STATEMENT(claim_6_2_euclidean_elasticity, "elasticity in a Euclidean space") {
  claim.convention(
      "In coordinates in which $g$ and $G$ are constant; the first index of the stress is raised with $g$. "
      "The solid has no symmetry, and may have fewer dimensions than its space.");
  over_points(claim, BodiesInSpace{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    auto const j = draw_second_jet<S, n, N>(draw);
    // Both sides of the equation, their difference, and what it should be.
    auto const residual = [&](auto const& medium) {
      auto const raised_stress = [&]<class T>(Jet<T, n, N> const& jet) {
        return raised(medium.g(jet.y), actio::Matrix<T, N, n>(first_piola_kirchhoff_stress(medium, jet)));
      };
      return (two_point_rates(raised_stress, j).divergence - j.acceleration() * S(medium.rho(j.particle())))
          .eval();
    };
    auto const E = [&](auto const& medium) {
      return raised(medium.g(j.y),
                    actio::Matrix<S, N, 1>(euler_lagrange(medium, j) / body_volume(medium, j)));
    };
    auto const curved = draw_medium<S, n, N>(draw, Kind::solid), flat = flattened<S, n, N>(curved);
    claim.equal("with constant metrics", model, residual(flat), E(flat));
    claim.differs("with others", model, residual(curved), E(curved));
    auto const lower = [&](auto const& jet) { return first_piola_kirchhoff_stress(flat, jet); };
    claim.differs(
        "the stress with its index down", model,
        (two_point_rates(lower, j).divergence - j.acceleration() * S(flat.rho(j.particle()))).eval(),
        E(flat));
  });
}

// ----
// Section 6.2: momenta, pressure, stress and metric force of a barotropic fluid.

namespace {

/// \f$g^{bc}\,\partial g_{bc}/\partial y^a\f$.
template <class Metric, class S, int n>
actio::Matrix<S, n, 1> logarithmic_slopes(Metric const& g, actio::Matrix<S, n, 1> const& y) {
  auto const rates = metric_derivatives(g, y);
  actio::Matrix<S, n, n> const inverse = inverse_matrix(as_matrix<S>(g(y)));
  actio::Matrix<S, n, 1> slope;
  for (int a = 0; a < n; ++a) slope[a] = inverse.cwiseProduct(rates[a]).sum();
  return slope;
}

}  // namespace

STATEMENT(claim_6_2_barotropic_momenta, "the spatial momenta of a barotropic fluid") {
  claim.corrected(R"(p_a{}^i = -\rho\,\frac{\partial W}{\partial v^{a_i}}\sqrt{\det[G]})",
                  R"(p_a{}^i = -\rho\,\frac{\partial W}{\partial v^a{}_i}\sqrt{\det[G]})",
                  "In both denominators $i$ is set as an index of $a$; it is one of $v$.");
  claim.maybe_scan();
  // A law of degree 3 in a Jacobian of degree 8 over another.
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const fluid = draw_medium<S, n>(draw, Kind::fluid);
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    auto const at = point_of_medium(fluid, j);
    actio::Matrix<S, n, n> const p = momenta(fluid, j).template rightCols<n>();
    Dual<S> J = at.J;
    J.part[0] = S(1);
    S const factor = -at.rho * fluid.W.w(J).part[0] * at.J * body_volume(fluid, j);
    claim.equal("by the chain rule", model, p, (at.inverse.transpose() * factor).eval());
    claim.differs("the inverse transposed", model, p, (at.inverse * factor).eval());
    claim.differs("the other sign", model, p, (at.inverse.transpose() * -factor).eval());
    // With i an index of a, a derivative has no direction of the body: the same number for each.
    actio::Matrix<S, n, 1> const summed = p * actio::Matrix<S, n, 1>::Ones();
    claim.differs("as printed, one derivative for all i", model, p,
                  (summed * actio::Matrix<S, 1, n>::Ones()).eval());
  });
}

STATEMENT(eq_6_16, "the material pressure from the stored energy") {
  claim.holds(
      "With the density of space $\\rho/J$ it is the pressure of thermodynamics, the square of that "
      "density times the derivative of $W$ in it.");
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const fluid = draw_medium<S, n>(draw, Kind::fluid);
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    auto const at = point_of_medium(fluid, j);
    Dual<S> density = at.rho / at.J;
    density.part[0] = S(1);
    S const slope = fluid.W.w(Dual<S>(at.rho) / density).part[0], P = material_pressure(fluid, j);
    claim.equal("the pressure of thermodynamics", model, P, S(density.value * density.value * slope));
    claim.differs("with the density of the body", model, P, S(at.rho * at.rho * slope));
    claim.differs("the other sign", model, P, S(-density.value * density.value * slope));
  });
}

STATEMENT(claim_6_2_barotropic_stress, "the Cauchy stress of a barotropic fluid") {
  claim.holds("With the symmetric derivative in $g$, of which $J$ has half of $J$ times the inverse of $g$.");
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const fluid = draw_medium<S, n>(draw, Kind::fluid);
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    auto const at = point_of_medium(fluid, j);
    S const P = material_pressure(fluid, j);
    auto const sigma = cauchy_stress(fluid, j);
    actio::Matrix<S, n, n> const up = inverse_matrix(at.g) * P;
    claim.equal("minus the pressure times the metric", model, sigma, (-up).eval());
    if (n != 2) claim.differs("2/n of the pressure", model, sigma, (up * ratio<S>(-2, n)).eval());
    claim.differs("plus the pressure", model, sigma, up);
    claim.differs("a factor J left over", model, sigma, (up * -at.J).eval());
    claim.differs("lower indices", model, sigma, (at.g * -P).eval());
  });
}

STATEMENT(claim_6_2_metric_force, "the force of the metric on a barotropic fluid") {
  claim.holds();
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const fluid = draw_medium<S, n>(draw, Kind::fluid);
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    auto const at = point_of_medium(fluid, j);
    auto const force = metric_force(fluid, j);
    actio::Matrix<S, n, 1> const right =
        logarithmic_slopes(fluid.g, j.y) * S(material_pressure(fluid, j) * at.J / S(2));
    claim.equal("by the pressure", model, force, right);
    claim.differs("the other sign", model, force, (-right).eval());
    if (n != 2) claim.differs("1/n in place of the half", model, force, (right * ratio<S>(2, n)).eval());
    claim.differs("without the half", model, force, (right * S(2)).eval());
    auto other = fluid;
    other.g = draw_metric<S, n>(draw);
    claim.differs("with the symbols of another metric", model, force, metric_force(other, j));
  });
}

STATEMENT(claim_6_2_barotropic_spatial_form,
          "the barotropic equation with spatial density and spatial pressure") {
  claim.holds(
      "Motions of a fluid have an inverse; the spatial density is $\\rho/J$ taken at the particle, "
      "and the gradient is that of $g$.");
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    using T = Dual<S, n>;
    using Column = actio::Matrix<S, n, 1>;
    auto const fluid = draw_medium<S, n>(draw, Kind::fluid);
    auto const phi = draw_section<S, n, n>(draw);
    auto const x = draw_event<S, n>(draw);
    auto const j = second_jet(phi, x);
    auto const at = point_of_medium(fluid, j);
    // The particles at the points y + e_a, to first order, at the same time; and the pressure of them, as a
    // function on space.
    Event<T, n> particles = x.template cast<T>();
    for (int i = 0; i < n; ++i)
      for (int a = 0; a < n; ++a) particles[i + 1].part[a] = at.inverse(i, a);
    auto const jets = first_jet(phi, particles);
    actio::Matrix<S, n, n> moved;
    for (int b = 0; b < n; ++b)
      for (int a = 0; a < n; ++a) moved(b, a) = jets.y[b].part[a];
    claim.equal("those are the particles there", model, moved,
                actio::Matrix<S, n, n>(actio::Matrix<S, n, n>::Identity()), n);
    T const p = material_pressure(fluid, jets);
    Column slope;
    for (int a = 0; a < n; ++a) slope[a] = p.part[a];

    Column const gradient = raised(at.g, slope), wrong = raised(at.G, slope);
    Column const A = material_acceleration(fluid.g, j),
                 E = raised(at.g, Column(euler_lagrange(fluid, j) / body_volume(fluid, j)));
    S const density = at.rho / at.J;
    claim.equal("the field equations over rho", model, (E / -at.rho).eval(), (A + gradient / density).eval());
    claim.differs("the pressure pushing the other way", model, (E / -at.rho).eval(),
                  (A - gradient / density).eval());
    claim.differs("the density of the body", model, (E / -at.rho).eval(), (A + gradient / at.rho).eval());
    claim.differs("the gradient of the other metric", model, (E / -at.rho).eval(),
                  (A + wrong / density).eval());
  });
}

// ----
// Section 6.2: the expansion of the left side of the barotropic equation, step by step.

namespace {

/// The three lines of (6.17) and their pieces, without the inertia that all of them begin with.
template <class S, int n>
struct Expansion {
  using Column = actio::Matrix<S, n, 1>;
  Column first;     ///< the weighted divergence
  Column pressure;  ///< slopes of P, carried to space
  Column volume;    ///< slopes of the volume of space along the section
  Column printed;   ///< slopes of det g in its place
  Column metric;    ///< half of P J g^bc dg_bc/dy^a

  template <class Fluid>
  Expansion(Fluid const& fluid, SecondJet<S, n, n> const& j) {
    auto const at = point_of_medium(fluid, static_cast<Jet<S, n, n> const&>(j));
    S const P = material_pressure(fluid, static_cast<Jet<S, n, n> const&>(j));
    actio::Matrix<S, n, n> const areas = area_transformation(at.G, at.g, at.F);
    auto const momentum = [&]<class T>(Jet<T, n, n> const& jet) {
      auto const here = fluid.G(jet.particle());
      T const factor = -material_pressure(fluid, jet) * actio::volume<T>(here);
      return (area_transformation(here, fluid.g(jet.y), jet.gradient()) * factor).eval();
    };
    first = two_point_rates(momentum, j).divergence / -body_volume(fluid, j);
    pressure = areas * pressure_slopes(fluid, j);
    Column of_root, of_square;
    for (int k = 0; k < n; ++k) {
      Dual<S> const square = determinant(fluid.g(along(j, k + 1).y));
      of_root[k] = square_root(square).part[0], of_square[k] = square.part[0];
    }
    actio::Matrix<S, n, n> const bare =
        at.inverse.transpose() * S(P * determinant(at.F) / body_volume(fluid, j));
    volume = bare * of_root;
    printed = bare * of_square;
    auto const rates = metric_derivatives(fluid.g, j.y);
    actio::Matrix<S, n, n> const up = inverse_matrix(at.g);
    for (int a = 0; a < n; ++a) metric[a] = P * at.J * up.cwiseProduct(rates[a]).sum() / S(2);
  }
};

}  // namespace

STATEMENT(eq_6_17, "the left side for a barotropic fluid, in three lines") {
  claim.corrected(
      R"(\frac{P\det\bigl(\frac{\partial\phi}{\partial x}\bigr)}{\sqrt{\det[G]}}\Bigl(\bigl()"
      R"(\tfrac{\partial\phi}{\partial x}\bigr)^{-1}\Bigr)^k_a\frac{\partial\det[g]}{\partial x^k})",
      R"(\frac{P\det\bigl(\frac{\partial\phi}{\partial x}\bigr)}{\sqrt{\det[G]}}\Bigl(\bigl()"
      R"(\tfrac{\partial\phi}{\partial x}\bigr)^{-1}\Bigr)^k_a\frac{\partial\sqrt{\det[g]}}{)"
      R"(\partial x^k})",
      "The last term of the middle line lacks the root over $\\det g$. The "
      "first and the last line are right.");
  claim.maybe_scan();
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const fluid = draw_medium<S, n>(draw, Kind::fluid);
    auto const j = draw_second_jet<S, n>(draw);
    Expansion<S, n> const lines(fluid, j);
    claim.equal("first and middle line", model, lines.first, (lines.pressure + lines.volume).eval());
    claim.equal("middle and last line", model, lines.volume, lines.metric);
    if (n != 2)
      claim.differs("the last line with 1/n", model, lines.volume, (lines.metric * ratio<S>(2, n)).eval());
    claim.differs("the middle line as printed", model, lines.first, (lines.pressure + lines.printed).eval());
  });
}

STATEMENT(claim_6_2_barotropic_expansion_end, "the first and the last expression of the expansion") {
  claim.holds();
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const fluid = draw_medium<S, n>(draw, Kind::fluid);
    auto const j = draw_second_jet<S, n>(draw);
    Expansion<S, n> const lines(fluid, j);
    auto const first = (inertial_force(fluid, j) + lines.first).eval();
    auto const last = [&](S const& factor) {
      return (inertial_force(fluid, j) + lines.pressure + lines.metric * factor).eval();
    };
    claim.equal("left side of (6.13)", model, first, last(S(1)));
    claim.equal("and with the right side", model, actio::Matrix<S, n, 1>(first - metric_force(fluid, j)),
                medium_equation(fluid, j));
    if (n != 2) claim.differs("1/n in place of the half", model, first, last(ratio<S>(2, n)));
    claim.differs("without the half", model, first, last(S(2)));
    claim.differs("without the metric", model, first, last(S(0)));
  });
}

// ----
// Section 6.2: the field equations of a medium and the Cauchy stress; exact with any stored energy, and in
// floating point on the sphere, with real powers.

namespace {

/// A sphere in angles: \f$R^2(d\theta^2 + \sin^2\theta\,d\varphi^2)\f$.
struct Sphere {
  int radius;
  template <class T>
  actio::Matrix<T, 2, 2> operator()(actio::Matrix<T, 2, 1> const& y) const {
    using std::sin;
    T const s = sin(y[0]);
    actio::Matrix<T, 2, 2> g;
    g << T(1), T(0), T(0), s * s;
    return (g * T(radius * radius)).eval();
  }
};

/// A stored energy with a real power that depends on F and g other than through the Green tensor:
/// \f$(2 + g_{11}(F^1{}_1)^2 + g_{12}F^1{}_1 + 3g_{22}F^1{}_2)^{7/5}\f$.
struct PowerOfStrain {
  template <class BodyMetric, class T>
  T operator()(actio::Matrix<T, 2, 1> const&, BodyMetric const&, actio::Matrix<T, 2, 2> const& g,
               actio::Matrix<T, 2, 2> const& F) const {
    using std::pow;
    return pow(
        T(g(0, 0) * F(0, 0) * F(0, 0) + g(0, 1) * F(0, 0) + g(1, 1) * F(0, 1) * Base<T>(3) + Base<T>(2)),
        Base<T>(Base<T>(7) / Base<T>(5)));
  }
};

/// A section on the sphere, away from its poles: theta about 1 on body and space.
template <class S>
SecondJet<S, 2, 2> draw_jet_on_sphere(Draw& draw) {
  auto const phi = draw_section<S, 2, 2>(draw, ratio<S>(1, 10));
  auto x = draw_event<S, 2>(draw);
  auto const south = [&](auto const& at) {
    auto from = at;
    from[1] -= 1;
    auto y = phi(from);
    y[0] += 1;
    return y;
  };
  x[1] += 1;
  return second_jet(south, x);
}

/// Over the rationals any medium in space, elsewhere one on the sphere.
/// @param visit  called with a medium with a general W, a fluid, a second jet, and the name of the model
template <class S, class Visit>
void over_media(Draw& draw, Visit const& visit) {
  if (exact_arithmetic<S>()) {
    auto const any = draw_medium<S, 3>(draw, Kind::any), fluid = draw_medium<S, 3>(draw, Kind::fluid);
    visit(any, fluid, draw_second_jet<S, 3>(draw), Dimensions<3, 3>::name());
  } else {
    auto const rho = draw_mass<S, 2>(draw);
    Sphere const body{1}, space{2};
    visit(Continuum{body, space, rho, PowerOfStrain{}},
          Continuum{body, space, rho, Barotropic{Polytropic<S>{S(2), ratio<S>(7, 5)}}},
          draw_jet_on_sphere<S>(draw), "spheres of radius 1 and 2, exponent 7/5");
  }
}

/// The field equations per volume of the body, with the sign that the thesis writes them with.
template <class Medium, class S, int n, int N>
actio::Matrix<S, N, 1> field_equations(Medium const& medium, SecondJet<S, n, N> const& j) {
  return euler_lagrange(medium, j) / -body_volume(medium, j);
}

}  // namespace

namespace {

/// (6.13) for one medium at one second jet, and what it is not.
template <class S, class Medium, int n, int N>
void check_medium_equation(Claim<S>& claim, Medium const& medium, SecondJet<S, n, N> const& j,
                           std::string const& model) {
  using Column = actio::Matrix<S, N, 1>;
  Jet<S, n, N> const& first = j;
  Column const E = field_equations(medium, j), force = metric_force(medium, first);
  claim.equal("(6.13) and (6.12)", model, medium_equation(medium, j), E);
  claim.differs("the force with the other sign", model, (medium_equation(medium, j) + force * S(2)).eval(),
                E);
  auto const outside = [&](auto const& weight) {
    auto const stress = [&](auto const& jet) { return (partial_F(medium, jet) * weight(jet)).eval(); };
    return Column(inertial_force(medium, j) -
                  two_point_rates(stress, j).divergence / weight(first) * S(medium.rho(j.particle())) -
                  force);
  };
  claim.differs("the mass density outside the derivative", model,
                outside([&]<class T>(Jet<T, n, N> const& at) { return volume<T>(medium.G(at.particle())); }),
                E);
  claim.differs("without the volume of the body", model,
                outside([&]<class T>(Jet<T, n, N> const& at) { return T(medium.rho(at.particle())); }), E);
}

}  // namespace

STATEMENT(eq_6_13, "the Euler-Lagrange equation of a continuous medium") {
  claim.holds(
      "The derivative in $x$ is the total one and acts on the mass density too; that in $g$ is the "
      "symmetric one, summed over both indices. For bodies of fewer dimensions than their space as well.");
  // An energy of degree 3 in metrics of degree 4 and a section of degree 3, and inverses of metrics.
  over_points(claim, BodiesInSpace{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    auto const medium = draw_medium<S, n, N>(draw, Kind::any);
    check_medium_equation(claim, medium, draw_second_jet<S, n, N>(draw), model);
  });
  if (exact_arithmetic<S>()) return;
  over_media<S>(draw, [&]<class Medium, class Fluid, int n>(
                          Medium const& medium, Fluid const&, SecondJet<S, n, n> const& j,
                          std::string const& model) { check_medium_equation(claim, medium, j, model); });
}

STATEMENT(eq_6_14, "the Cauchy stress from the stored energy") {
  claim.convention(
      "$W$ is per unit mass, $\\rho$ the mass per volume of the body, and the derivative in $g$ the "
      "symmetric one. $J$ stays; it disappears where $\\rho/J$, the spatial density, is written.");
  over_media<S>(
      draw, [&]<class Medium, class Fluid, int n>(Medium const& medium, Fluid const& fluid,
                                                  SecondJet<S, n, n> const& j, std::string const& model) {
        using T = Dual<S, n>;
        using Matrix = actio::Matrix<S, n, n>;
        Jet<S, n, n> const& first = j;
        auto const at = point_of_medium(medium, first);
        Matrix const any = draw_tangents<S, n, n>(draw), h = any + any.transpose();
        // The energy on the way from g along h.
        auto const moved = first.template cast<T>();
        actio::Matrix<T, n, n> g = at.g.template cast<T>();
        for (int a = 0; a < n; ++a)
          for (int b = 0; b < n; ++b) g(a, b).part[0] = h(a, b);
        S const rate = medium.W(moved.particle(), medium.G(moved.particle()), g, moved.gradient()).part[0];
        Matrix const sigma = cauchy_stress(medium, first);
        S const power = sigma.cwiseProduct(h).sum();
        claim.equal("power of the stress along a metric", model, power, S(rate * S(2) * at.rho / at.J));
        claim.differs("without J", model, power, S(rate * S(2) * at.rho));
        claim.differs("without the 2", model, power, S(rate * at.rho / at.J));
        S upper(0);
        for (int a = 0; a < n; ++a)
          for (int b = a; b < n; ++b) upper += sigma(a, b) * h(a, b);
        // Off the diagonal the derivative along one pair is twice as large.
        claim.refutes("each pair of indices once", model, S(upper - power), magnitude(sigma));
        Matrix const pressure = inverse_matrix(Matrix(fluid.g(j.y))) * S(-material_pressure(fluid, first));
        claim.equal("of a fluid, the pressure", model, cauchy_stress(fluid, first), pressure);
      });
}

STATEMENT(eq_6_18, "the Euler-Lagrange equation of a barotropic fluid") {
  claim.corrected(
      R"(\rho\,g_{ab}\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b = -\frac{\partial P}{\partial x^k}\,J)"
      R"(\Bigl(\bigl(\tfrac{\partial\phi}{\partial x}\bigr)^{-1}\Bigr)^k)",
      R"(\rho\,g_{ab}\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b = -\frac{\partial P}{\partial x^k}\,J)"
      R"(\Bigl(\bigl(\tfrac{\partial\phi}{\partial x}\bigr)^{-1}\Bigr)^k_a)",
      "The inverse gradient lacks its lower index $a$. Otherwise right, with a mass density that varies.");
  claim.maybe_scan();
  over_media<S>(
      draw, [&]<class Medium, class Fluid, int n>(Medium const&, Fluid const& fluid,
                                                  SecondJet<S, n, n> const& j, std::string const& model) {
        using Column = actio::Matrix<S, n, 1>;
        Jet<S, n, n> const& first = j;
        auto const at = point_of_medium(fluid, first);
        Column const E = field_equations(fluid, j), slope = pressure_slopes(fluid, j),
                     mass = inertial_force(fluid, j);
        claim.equal("(6.18) and (6.12)", model, fluid_equation(fluid, j), E);
        claim.differs("as printed, with the only index contracted", model,
                      (mass + Column::Constant((at.inverse * slope).sum() * at.J)).eval(), E);
        claim.differs("the inverse transposed", model, (mass + at.inverse * slope * at.J).eval(), E);
        claim.differs("without J", model, (mass + at.inverse.transpose() * slope).eval(), E);
        // The pressure of a fluid of constant mass density, that at the particle.
        Fluid even = fluid;
        even.rho.added.constant = at.rho - S(2);
        for (auto* c : {&even.rho.added.a, &even.rho.added.b, &even.rho.added.d, &even.rho.added.e})
          c->setZero();
        Column const level = pressure_slopes(even, j);
        claim.differs("the mass density outside the derivative", model,
                      (mass + at.inverse.transpose() * level * at.J).eval(), E);
      });
}

STATEMENT(eq_6_20, "the equation of motion with stresses, general stored energy") {
  claim.holds("Read with the covariant divergence of its own row, claim_6_2_covariant_divergence.");
  over_media<S>(
      draw, [&]<class Medium, class Fluid, int n>(Medium const& medium, Fluid const&,
                                                  SecondJet<S, n, n> const& j, std::string const& model) {
        using Column = actio::Matrix<S, n, 1>;
        Jet<S, n, n> const& first = j;
        auto const at = point_of_medium(medium, first);
        Column const E = field_equations(medium, j),
                     balance = inertial_force(medium, j) - stress_divergence(medium, j);
        claim.equal("(6.20) and (6.12)", model, stress_equation(medium, j), E);
        claim.differs("without the symbols of space", model, balance, E);
        auto const gamma = christoffel(medium.g, j.y);
        actio::Matrix<S, n, n> const plus = first_piola_kirchhoff_stress(medium, first) * at.F.transpose() +
                                            at.g * cauchy_stress(medium, first) * at.J;
        Column added = balance;
        for (int a = 0; a < n; ++a)
          for (int b = 0; b < n; ++b)
            for (int c = 0; c < n; ++c) added[a] -= gamma[b](a, c) * plus(b, c);
        claim.differs("the Cauchy stress with the other sign", model, added, E);
      });
}

STATEMENT(claim_6_2_pressure_definition, "the stress of a fluid defines its pressure") {
  claim.holds(
      "All entries of the stress of a $W(J)$, and of a $W(J,x)$, give one number, and it is (6.16). With "
      "the symmetric derivative in $g$. The stress of a solid gives a different number for each entry.");
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    // The stress by (6.14), lowered: -P for every pair of equal indices, 0 for the others.
    auto const lowered_stress = [&](AnyContinuum<S, n> const& medium) {
      return actio::Matrix<S, n, n>(point_of_medium(medium, j).g * cauchy_stress(medium, j));
    };
    for (Kind const kind : {Kind::fluid, Kind::isentropic}) {
      auto const fluid = draw_medium<S, n>(draw, kind);
      auto const at = point_of_medium(fluid, j);
      actio::Matrix<S, n, n> const one = actio::Matrix<S, n, n>::Identity(), sigma = lowered_stress(fluid);
      Dual<S> J = at.J;
      J.part[0] = S(1);
      S const P = sigma(0, 0) * S(-1), law = -at.rho * fluid.W.law_at(j.particle())(J).part[0];
      claim.equal("one number", model, sigma, (one * S(-P)).eval());
      claim.equal("(6.16) follows", model, P, law);
      claim.differs("the trace of the stress, undivided", model, S(-sigma.trace()), law);
      claim.differs("with a factor J", model, P, S(law * at.J));
    }
    auto const sigma = lowered_stress(draw_medium<S, n>(draw, Kind::solid));
    claim.differs("of a solid", model, sigma,
                  actio::Matrix<S, n, n>(actio::Matrix<S, n, n>::Identity() * sigma(0, 0)));
  });
}

STATEMENT(claim_6_2_isentropic_media, "isentropic media with a stored energy of Jacobian and entropy") {
  claim.convention(
      "The entropy is a given function on the body, so that it is the dependence of $W$ on the "
      "point of the body that takes it up, beside that on the deformation gradient; a $W$ of the "
      "Jacobian alone does so only where the entropy is the same everywhere. The pressure is then "
      "(6.16) with the entropy of the particle.");
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    using Column = actio::Matrix<S, n, 1>;
    auto const fluid = draw_medium<S, n>(draw, Kind::isentropic);
    auto const j = draw_second_jet<S, n>(draw);
    Jet<S, n, n> const& first = j;
    auto const at = point_of_medium(fluid, first);
    Column const E = field_equations(fluid, j);
    claim.equal("(6.18), with the entropy of the particle", model, fluid_equation(fluid, j), E);
    actio::Matrix<S, n, n> const pressure = inverse_matrix(at.g) * S(-material_pressure(fluid, first));
    claim.equal("the stress is that pressure", model, cauchy_stress(fluid, first), pressure);
    // At a fixed entropy, the pressure of thermodynamics.
    Dual<S> density = at.rho / at.J;
    density.part[0] = S(1);
    S const slope = fluid.W.law_at(j.particle())(Dual<S>(at.rho) / density).part[0];
    claim.equal("the pressure of thermodynamics", model, material_pressure(fluid, first),
                S(density.value * density.value * slope));
    // A fluid with everywhere the entropy of this particle has here the same pressure, but other slopes.
    auto even = fluid;
    for (auto* c : {&even.W.entropy.a, &even.W.entropy.b, &even.W.entropy.d, &even.W.entropy.e}) c->setZero();
    even.W.entropy.constant = fluid.W.entropy(j.particle());
    claim.equal("where it is uniform, a law of the Jacobian", model, fluid_equation(even, j),
                field_equations(even, j));
    claim.differs("without the slope of the entropy", model, fluid_equation(even, j), E);
    auto none = fluid;
    none.W.kind = Kind::fluid;
    none.W.entropy = even.W.entropy, none.W.entropy.constant = S(0);
    claim.differs("a W of the Jacobian alone", model, fluid_equation(none, j), E);
  });
}
