// Scalars: rational (long: double)
// Section 6.2: acceleration and Christoffel symbols, constant metrics, the covariant divergence, Piola's identity.
#include "fields.hpp"

#include "media.hpp"
#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// A metric in other coordinates z with y = chart(z).
template <class Metric, class Chart>
struct MetricInChart {
  Metric g;
  Chart chart;
  template <class T, int n>
  Eigen::Matrix<T, n, n> operator()(Eigen::Matrix<T, n, 1> const& z) const {
    return pulled_back(g(chart(z).eval()), pushed(chart, z, Tangents<T, n, n>(Tangents<T, n, n>::Identity())));
  }
};

/// A chart of space near the identity.
template <class S, int n>
struct AnyChart {
  std::array<Cubic<S, n>, n> added;
  template <class V>
  auto operator()(V const& z) const {
    Eigen::Matrix<ScalarOf<V>, n, 1> y;
    for (int a = 0; a < n; ++a) y[a] = z[a] + added[a](z);
    return y;
  }
};

/// The acceleration with the symbols contracted as printed, for one value of the index that is left over.
template <class Medium, class S, int n>
Eigen::Matrix<S, n, 1> printed_acceleration(Medium const& medium, SecondJet<S, n, n> const& j, int a) {
  auto const gamma = christoffel(medium.g, j.y);
  Eigen::Matrix<S, n, 1> sum = j.acceleration();
  for (int b = 0; b < n; ++b)
    for (int c = 0; c < n; ++c) sum[b] += gamma[a](b, c) * j.velocity()[b] * j.velocity()[c];
  return sum;
}

}  // namespace

STATEMENT(claim_6_2_material_acceleration, "the material acceleration in coordinates") {
  claim.corrected(R"(\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b \equiv \frac{\partial\dot\phi^b}{\partial t} + \gamma^a_{bc}\,\dot\phi^b\dot\phi^c)",
                  R"(\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b \equiv \frac{\partial\dot\phi^b}{\partial t} + \gamma^b_{ac}\,\dot\phi^a\dot\phi^c)",
                  "The free index $b$ of the left side is summed on the right, where $a$ is left over: the names of $a$ and $b$ are exchanged in the last term.");
  // A metric of degree 4 and its inverse, a section of degree 3, a chart of degree 3.
  claim.degree(120);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const dust = draw_medium<S, n>(draw, Kind::dust);
    auto const j = draw_second_jet<S, n>(draw);
    auto const E = (euler_lagrange(dust, j) / body_volume(dust, j)).eval();
    claim.equal("the field equations of dust", model, (-inertia(dust, j)).eval(), E);
    for (int a = 0; a < n; ++a)
      claim.differs("as printed, a given the value " + std::to_string(a + 1), model, raised(dust.g(j.y), E), (printed_acceleration(dust, j, a) * -S(dust.rho(j.particle()))).eval());
  });
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    AnyChart<S, 2> chart;
    for (auto& c : chart.added) c = draw_cubic<S, 2>(draw, ratio<S>(1, 5));
    auto const g = draw_metric<S, 2>(draw);
    auto const phi = draw_section<S, 2, 2>(draw);
    auto const x = draw_event<S, 2>(draw);
    auto const j = second_jet(phi, x), k = second_jet([&](auto const& at) { return chart(phi(at)); }, x);
    auto const carried = pushed(chart, j.y, Tangents<S, 2, 1>(material_acceleration(MetricInChart<AnyMetric<S, 2>, AnyChart<S, 2>>{g, chart}, j)));
    claim.equal("a vector: the same in other coordinates", model, carried, material_acceleration(g, k));
    claim.differs("the second derivatives alone", model, pushed(chart, j.y, Tangents<S, 2, 1>(j.acceleration())), k.acceleration());
  });
}

STATEMENT(claim_6_2_christoffel, "the Christoffel symbols of the field metric") {
  claim.holds("The symmetric symbols under which the metric is parallel; that fixes them.");
  claim.degree(60);
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const g = draw_metric<S, n>(draw);
    Eigen::Matrix<S, n, 1> const y = draw.vector<S, Eigen::Matrix<S, n, 1>>(n) * ratio<S>(1, 2);
    auto const gamma = christoffel(g, y);
    auto const rates = metric_derivatives(g, y);
    Eigen::Matrix<S, n, n> const here = g(y);
    S parallel(0), flipped(0), skew(0), size(0);
    auto const grow = [](S& largest, S const& x) {
      if (magnitude(x) > largest) largest = magnitude(x);
    };
    Eigen::Matrix<S, n, n> const inverse = inverse_matrix(here);
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
          grow(parallel, residual), grow(flipped, broken), grow(size, rates[c](a, b)), grow(skew, S(gamma[c](a, b) - gamma[c](b, a)));
        }
    claim.zero("the covariant derivative of g", model, parallel, size);
    claim.zero("symmetric in the lower indices", model, skew, size, n);
    claim.refutes("the last sign changed", model, flipped, size);
  });
}

STATEMENT(eq_6_15, "the equation of motion with constant metrics") {
  claim.holds("In coordinates in which $g$ and $G$ are constant; the mass density, which may vary, stays inside the derivative.");
  // An energy of degree 3 in metrics of degree 4 and a section of degree 3.
  claim.degree(60);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const curved = draw_medium<S, n>(draw, Kind::any), flat = flattened(curved);
    auto const j = draw_second_jet<S, n>(draw);
    auto const left = [&](AnyContinuum<S, n> const& medium) { return (lowered(medium.g(j.y), j.acceleration()) * S(medium.rho(j.particle()))).eval(); };
    auto const right = [&](AnyContinuum<S, n> const& medium) { return detail::two_point_rates([&](auto const& jet) { return detail::piola_kirchhoff(medium, jet); }, j).divergence; };
    auto const E = [&](AnyContinuum<S, n> const& medium) { return (euler_lagrange(medium, j) / body_volume(medium, j)).eval(); };
    claim.equal("(6.15) and the field equations", model, (right(flat) - left(flat)).eval(), E(flat));
    auto const outside = detail::two_point_rates([&](auto const& jet) { return detail::strain_derivative(flat, jet); }, j).divergence;
    claim.differs("the mass density outside the derivative", model, (outside * S(flat.rho(j.particle())) - left(flat)).eval(), E(flat));
    claim.differs("metrics that are not constant", model, (right(curved) - left(curved)).eval(), E(curved));
  });
}

STATEMENT(claim_6_2_covariant_divergence, "the covariant divergence of a two-point tensor") {
  claim.corrected(R"(\frac{\partial\mathcal P_a{}^i}{\partial x^i} + \mathcal P_a{}^j\,\Gamma^k_{jk} - \mathcal P_b{}^i\,\gamma^b_{ac}\,F_j{}^c)",
                  R"(\frac{\partial\mathcal P_a{}^i}{\partial x^i} + \mathcal P_a{}^j\,\Gamma^k_{jk} - \mathcal P_b{}^j\,\gamma^b_{ac}\,F^c{}_j)",
                  "In the last term $i$ and $j$ are left over; they are one index, summed. The divergence is fixed by Leibniz' rule with vector fields of space.");
  claim.maybe_scan();
  claim.degree(120);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    using Column = Eigen::Matrix<S, n, 1>;
    auto const medium = draw_medium<S, n>(draw, Kind::any);
    auto const j = draw_second_jet<S, n>(draw);
    auto const T = [&](auto const& jet) { return detail::piola_kirchhoff(medium, jet); };
    AnyChart<S, n> field;
    for (auto& c : field.added) c = draw_cubic<S, n>(draw);
    auto const [value, derivative] = detail::two_point_rates(T, j);
    Column const DIV = two_point_divergence(medium.G, medium.g, j, T);

    // The vector T w of the body, whose divergence is that of its metric.
    auto const weighted = [&]<class R>(Jet<R, n, n> const& jet) {
      return Eigen::Matrix<R, 1, n>((field(jet.y).transpose() * T(jet)) * volume<R>(medium.G(jet.particle())));
    };
    S left(0);
    for (int i = 0; i < n; ++i) left += weighted(along(j, i + 1))(0, i).part[0];
    left /= body_volume(medium, j);
    auto const Gamma = christoffel(medium.G, j.particle()), gamma = christoffel(medium.g, j.y);
    Column const w = field(j.y);
    S turned(0);  // T_a^i times the covariant derivative of w along F_i
    Eigen::Matrix<S, n, n> const rate = pushed(field, j.y, Tangents<S, n, n>(j.gradient()));
    for (int i = 0; i < n; ++i) turned += value.col(i).dot(Column(rate.col(i) + connection(medium.g, j.y, w, Column(j.gradient().col(i)))));
    claim.equal("Leibniz' rule", model, left, S(DIV.dot(w) + turned));

    Column on_space = Column::Zero(), free = Column::Zero(), on_body = Column::Zero();
    Column const sums = value.rowwise().sum(), velocities = j.gradient().rowwise().sum();
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        for (int c = 0; c < n; ++c) {
          on_space[a] += gamma[b](a, c) * value.row(b).dot(j.gradient().row(c));
          free[a] += gamma[b](a, c) * sums[b] * velocities[c];
          on_body[a] += value(a, b) * Gamma[c](b, c);
        }
    claim.equal("term by term", model, DIV, Column(derivative + on_body - on_space));
    claim.differs("as printed, i and j summed one by one", model, left, S((derivative + on_body - free).dot(w) + turned));
    claim.differs("the last sign changed", model, left, S((derivative + on_body + on_space).dot(w) + turned));
    claim.differs("without the symbols of the body", model, left, S((derivative - on_space).dot(w) + turned));
  });
}

STATEMENT(claim_6_2_cancelling_terms, "the terms from the determinant and from the inverse gradient cancel") {
  claim.holds("Piola's identity. Each of the two terms alone is not zero; the section must be one: mixed derivatives commute.");
  // Determinant and inverse of a gradient of degree 2 in the body, n = 3.
  claim.degree(60);
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    using Column = Eigen::Matrix<S, n, 1>;
    auto const G = draw_metric<S, n>(draw), g = draw_metric<S, n>(draw);
    auto const j = draw_second_jet<S, n>(draw);
    // Up to the common factor P sqrt(det g) / sqrt(det G).
    auto const terms = [&](SecondJet<S, n, n> const& at) {
      Column one = Column::Zero(), two = Column::Zero();
      for (int k = 0; k < n; ++k) {
        Eigen::Matrix<Dual<S>, n, n> const F = along(at, k + 1).gradient(), inverse = inverse_matrix(F);
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
