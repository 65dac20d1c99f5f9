// Section 8.1: the extended bundle, its canonical forms, the constraint and its multiplier.
#include "incompressible_models.hpp"

#include "actio/jets/cartan.hpp"
#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// \f$d^nx_\mu\f$ on n vectors: the volume form of space-time with d_mu in its first slot.
template <int n, class S, int D>
S face_form(int mu, Tangents<S, D, n> const& V) {
  Matrix<S, n + 1, n + 1> dx = Matrix<S, n + 1, n + 1>::Zero();
  dx(mu, 0) = S(1);
  dx.template rightCols<n>() = V.template topRows<n + 1>();
  return determinant(dx);
}
/// The columns of V but one.
template <class S, int D, int k>
Tangents<S, D, k - 1> without(Tangents<S, D, k> const& V, int left_out) {
  Tangents<S, D, k - 1> others;
  for (int c = 0, to = 0; c < k; ++c)
    if (c != left_out) others.col(to++) = V.col(c);
  return others;
}
/// \f$\alpha\wedge d^nx_\mu\f$ for the one-form that reads one coordinate.
template <int n, class S, int D>
S one_and_face(int coordinate, int mu, Tangents<S, D, n + 1> const& V) {
  S sum(0);
  for (int c = 0; c <= n; ++c) {
    S const term = V(coordinate, c) * face_form<n>(mu, without(V, c));
    sum += c % 2 == 0 ? term : S(-term);
  }
  return sum;
}
/// \f$\alpha\wedge\beta\wedge d^nx_\mu\f$ for two of them.
template <int n, class S, int D>
S two_and_face(int first, int second, int mu, Tangents<S, D, n + 2> const& V) {
  S sum(0);
  for (int c = 0; c < n + 2; ++c) {
    S const term = V(first, c) * one_and_face<n>(second, mu, without(V, c));
    sum += c % 2 == 0 ? term : S(-term);
  }
  return sum;
}
/// Where p_a^mu stands among the coordinates of the dual jet bundle over (n, N).
constexpr int momentum_index(int n, int N, int a, int mu) { return n + 2 + N + N * mu + a; }

/// A random body in a chart x = chi(x'), and the second metric, mass and motion as this chart has them.
template <class S, int n>
struct Chart {
  std::array<Cubic<S, n>, n> added;
  template <class V>
  auto operator()(V const& x) const {
    Matrix<ScalarOf<V>, n, 1> y;
    for (int i = 0; i < n; ++i) y[i] = x[i] + added[i](x);
    return y;
  }
};

/// (t, x') -> (t, x).
template <class S, int n>
struct ChartOfSpaceTime {
  Chart<S, n> chi;
  template <class V>
  auto operator()(V const& x) const {
    Matrix<ScalarOf<V>, n, 1> const particle = x.template tail<n>();
    Matrix<ScalarOf<V>, n + 1, 1> y;
    y << x[0], chi(particle);
    return y;
  }
};

/// The volume form of a metric.
template <class Metric>
struct VolumeForm {
  Metric metric;
  template <class T, int n>
  T operator()(Matrix<T, n, 1> const& at, Tangents<T, n, n> const& V) const {
    return volume<T>(metric(at)) * determinant(V);
  }
};
/// A motion at one time, a map from the body to space.
template <class S, class Phi>
struct AtTime {
  S time;
  Phi phi;
  template <class V>
  auto operator()(V const& at) const {
    Matrix<ScalarOf<V>, V::RowsAtCompileTime + 1, 1> event;
    event << ScalarOf<V>(time), at;
    return phi(event);
  }
};
/// A metric in another chart.
template <class Metric, class Map>
struct PulledBack {
  Metric metric;
  Map chi;
  template <class T, int n>
  Matrix<T, n, n> operator()(Matrix<T, n, 1> const& x) const {
    Tangents<T, n, n> const one = Tangents<T, n, n>::Identity();
    return pulled_back(metric(chi(x)), Matrix<T, n, n>(pushed(chi, x, one)));
  }
};

}  // namespace

STATEMENT(claim_8_1_extended_canonical_forms, "canonical forms with the multiplier among the fields") {
  claim.holds();
  // Coordinates and tangent vectors are drawn themselves: a product of n + 2 of them and one momentum.
  {
    auto const at_dimensions = [&]<int n, int N>() {
      constexpr int M = N + 1, D = DualJet<S, n, M>::dimension;
      std::string const model = Dimensions<n, N>::name() + " and a multiplier";
      Matrix<S, D, 1> const at = draw.vector<S, Matrix<S, D, 1>>(D);
      auto const z = dual_jet_at<n, M>(at);
      auto const V = draw_tangents<S, D, n + 1>(draw);
      Matrix<S, n + 1, n + 1> const dx = V.template topRows<n + 1>();
      S places(0), multiplier(0);
      for (int mu = 0; mu <= n; ++mu) {
        for (int a = 0; a < N; ++a) places += z.p(a, mu) * one_and_face<n>(n + 1 + a, mu, V);
        multiplier += z.p(N, mu) * one_and_face<n>(n + 1 + N, mu, V);
      }
      S const theta = canonical_form<n, M>()(at, V), volume_part = z.Pi * determinant(dx);
      claim.equal("the canonical form", model, theta, S(places + multiplier + volume_part));
      claim.differs("without the multiplier's part", model, theta, S(places + volume_part));

      auto const W = draw_tangents<S, D, n + 2>(draw);
      S omega(0), wedge_of_Pi(0);
      for (int mu = 0; mu <= n; ++mu)
        for (int a = 0; a < M; ++a) omega += two_and_face<n>(n + 1 + a, momentum_index(n, M, a, mu), mu, W);
      for (int c = 0; c < n + 2; ++c) {
        Matrix<S, n + 1, n + 1> const rest = without(W, c).template topRows<n + 1>();
        S const term = W(n + 1 + M, c) * determinant(rest);
        wedge_of_Pi += c % 2 == 0 ? term : S(-term);
      }
      S const two_form = canonical_two_form<n, M>()(at, W);
      claim.equal("minus its differential", model, two_form, S(omega - wedge_of_Pi));
      claim.differs("the affine part with the other sign", model, two_form, S(omega + wedge_of_Pi));
    };
    at_dimensions.template operator()<1, 1>();
    at_dimensions.template operator()<2, 2>();
  }
}

STATEMENT(claim_8_1_primary_constraint, "what the primary constraint is") {
  claim.corrected("\\mathfrak C\\ \\text{corresponds to the incompressibility constraint}",
                  "\\mathfrak C = \\{\\pi^\\mu = 0\\}",
                  "The primary constraint is $\\pi^\\mu = 0$: every jet is sent there, whatever its volume. "
                  "$J = 1$ comes later, as the field equation of $\\lambda$.");
  {
    over_points(Plane{}, [&]<class D>(D, std::string const& model) {
      constexpr int n = D::n;
      auto const density = incompressible(draw_medium<S, n>(draw));
      auto const j = draw_extended_jet<S, n>(draw, draw_section<S, n, n>(draw), density.constraint.G);
      auto const z = legendre(density, static_cast<Jet<S, n, n + 1> const&>(j));
      claim.zero("momenta of the multiplier in the image", model, z.p.row(n).eval(), size_of(z.p));
      claim.refutes("J = 1 in the image", model,
                    density.constraint(deformation(static_cast<Jet<S, n, n + 1> const&>(j)))[0], S(1));
      claim.equal("the field equation of the multiplier", model, euler_lagrange(density, j)[n],
                  density.constraint(deformation(static_cast<Jet<S, n, n + 1> const&>(j)))[0]);
    });
    // The form on the primary constraint manifold vanishes along the direction of lambda; off it, it does
    // not.
    constexpr int n = 2, M = 3, D = DualJet<S, n, M>::dimension;
    Matrix<S, D, 1> at = draw.vector<S, Matrix<S, D, 1>>(D);
    auto V = draw_tangents<S, D, n + 2>(draw);
    V.col(0).setZero();
    V(n + 1 + 2, 0) = S(1);
    claim.refutes("d/dlambda in the form before it is restricted", "n = 2",
                  S(canonical_two_form<n, M>()(at, V)), S(1));
    for (int mu = 0; mu <= n; ++mu)
      at[momentum_index(n, M, 2, mu)] = S(0), V.row(momentum_index(n, M, 2, mu)).setZero();
    claim.zero("d/dlambda is in the kernel of the restricted form", "n = 2",
               S(canonical_two_form<n, M>()(at, V)), S(1));
  }
}

STATEMENT(eq_8_1, "the constraint on the volume") {
  claim.convention(
      "The determinant is that of the spatial block $v^a{}_j$, with as many dimensions of space as of the "
      "body, in charts of one orientation.");
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    VolumeConstraint<AnyMetric<S, n>, AnyMetric<S, n>> const constraint{draw_metric<S, n>(draw),
                                                                        draw_metric<S, n>(draw)};
    auto const phi = draw_section<S, n, n>(draw);
    Event<S, n> const x = draw_event<S, n>(draw);
    Matrix<S, n, 1> const particle = x.template tail<n>();
    // The volume forms of body and space, and the second pulled back by the motion at this time.
    AtTime<S, AnySection<S, n, n>> const at_time{x[0], phi};
    auto const V = draw_tangents<S, n, n>(draw);
    S const pulled = pull_back(at_time, VolumeForm<AnyMetric<S, n>>{constraint.g})(particle, V),
            own = VolumeForm<AnyMetric<S, n>>{constraint.G}(particle, V);
    auto const j = first_jet(phi, x);
    S const Phi = constraint(j)[0];
    claim.equal("volume pulled back, minus volume", model, S(pulled - own), S(Phi * own));
    claim.differs("the determinant alone", model, Phi, S(determinant(j.gradient()) - S(1)));
    claim.differs("both metrics at the particle", model, Phi,
                  S(jacobian(constraint.G(particle), constraint.g(particle), j.gradient()) - S(1)));

    VolumeConstraint<AnyMetric<S, n>, AnyMetric<S, n>> const curved{draw_unimodular_metric<S, n>(draw),
                                                                    draw_unimodular_metric<S, n>(draw)};
    claim.zero("shears between curved metrics of volume 1", model,
               curved(first_jet(draw_shears<S, n>(draw), x))[0], S(1));
  });
}

STATEMENT(eq_8_2, "the multiplier as a density and its sign") {
  claim.convention(
      "The sign goes with $L + \\lambda\\Phi$ of (8.3): then $P$ is positive in compression. With $h - "
      "\\langle\\lambda, \\Psi\\rangle$ of chapter 7 it would be $-\\sqrt{\\det G}\\,P$.");
  // A section of a chart of degree 6 has degree 6 * 7, where fields of motions have 6.
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    VolumeConstraint<AnyMetric<S, n>, AnyMetric<S, n>> const constraint{draw_metric<S, n>(draw),
                                                                        draw_metric<S, n>(draw)};
    auto const phi = draw_section<S, n, n>(draw);
    auto const P = draw_cubic<S, n + 1>(draw);
    ChartOfSpaceTime<S, n> chi{};
    for (auto& c : chi.chi.added) c = draw_cubic<S, n>(draw, ratio<S>(1, 5));
    // The body in another chart: the metric pulled back, the motion and the pressure composed.
    PulledBack<AnyMetric<S, n>, Chart<S, n>> const G{constraint.G, chi.chi};
    auto const moved = [&](auto const& x) { return phi(chi(x)); };
    auto const pressure = [&](auto const& x) { return P(chi(x)); };
    Event<S, n> const x = draw_event<S, n>(draw);
    Matrix<S, n, 1> const particle = x.template tail<n>();
    Matrix<S, n, n> const one = Matrix<S, n, n>::Identity();
    S const stretch = determinant(pushed(chi.chi, particle, Tangents<S, n, n>(one)));
    draw_positive(stretch);
    auto const here = first_jet(with_pressure(moved, pressure, G), x);
    auto const there = first_jet(with_pressure(phi, P, constraint.G), chi(x));
    VolumeConstraint<PulledBack<AnyMetric<S, n>, Chart<S, n>>, AnyMetric<S, n>> const in_chart{G,
                                                                                               constraint.g};
    S const pairing_here = here.y[n] * in_chart(deformation(here))[0],
            pairing_there = there.y[n] * constraint(deformation(there))[0];
    claim.equal("multiplier times constraint in another chart", model, pairing_here,
                S(pairing_there * stretch));
    claim.differs("the multiplier as a function", model, S(there.y[n] * in_chart(deformation(here))[0]),
                  S(pairing_there * stretch));

    // The stress of a barotropic fluid with the pressure P_W enters the momenta as the multiplier does.
    auto const fluid = draw_barotropic<S, n>(draw);
    auto const held = incompressible(fluid);
    auto const j = deformation(there);
    S const P_W = material_pressure(fluid, j);
    Jet<S, n, n + 1> still = there;
    still.y[n] = volume<S>(fluid.G(j.particle())) * P_W;
    auto const by_energy = momenta(fluid, j);
    auto const by_both = momenta(held, still);
    claim.equal("the same pressure by energy and by multiplier", model,
                (by_both.template topRows<n>() - by_energy).template rightCols<n>().eval(),
                by_energy.template rightCols<n>().eval());
    still.y[n] = -still.y[n];
    claim.differs("the multiplier with the other sign", model,
                  (momenta(held, still).template topRows<n>() - by_energy).template rightCols<n>().eval(),
                  by_energy.template rightCols<n>().eval());
  });
}
