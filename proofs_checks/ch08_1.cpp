// Section 8.1: the extended bundle, its canonical forms, the constraint and its multiplier.
#include <bit>

#include "fields/incompressible_models.hpp"

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

/// The volume form of a metric.
template <class Metric>
struct VolumeForm {
  Metric metric;
  template <class T, int n>
  T operator()(Matrix<T, n, 1> const& at, Tangents<T, n, n> const& V) const {
    return volume<T>(metric(at)) * determinant(V);
  }
};
/// Any (n+1)-form at a point of E, by its values on coordinate vectors: one for each subset of n + 1 of them,
/// a bit for each coordinate.
template <class S>
using FormAtAPoint = std::vector<std::pair<unsigned, S>>;
/// With values 0 wherever two or more vectors are vertical, unless `any`: the elements of Z are those.
template <int n, int M, class S>
FormAtAPoint<S> draw_form(Draw& draw, bool any) {
  FormAtAPoint<S> z;
  for (unsigned set = 0; set < 1U << (n + 1 + M); ++set)
    if (std::popcount(set) == n + 1 && (any || std::popcount(set >> (n + 1)) < 2))
      z.emplace_back(set, draw.number<S>());
  return z;
}
template <class S, int D, int k>
S value_of(FormAtAPoint<S> const& z, Tangents<S, D, k> const& V) {
  S sum(0);
  for (auto const& [set, value] : z) {
    Matrix<S, k, k> rows;
    for (int row = 0, to = 0; row < D; ++row)
      if (set >> row & 1U) rows.row(to++) = V.row(row);
    sum += value * determinant(rows);
  }
  return sum;
}
/// The coordinates of such a form, by its values on d/dx^0, ..., d/dx^n, one of which is replaced by the
/// vertical vector of the momentum.
template <int n, int M, class S>
Matrix<S, DualJet<S, n, M>::dimension, 1> coordinates_of(FormAtAPoint<S> const& z,
                                                         Matrix<S, n + 1 + M, 1> const& point) {
  using V = Tangents<S, n + 1 + M, n + 1>;
  Matrix<S, DualJet<S, n, M>::dimension, 1> at;
  V const horizontal = V::Identity();
  at.template head<n + 1 + M>() = point;
  at[n + 1 + M] = value_of(z, horizontal);
  for (int mu = 0; mu <= n; ++mu)
    for (int a = 0; a < M; ++a) {
      V replaced = horizontal;
      replaced.col(mu).setZero();
      replaced(n + 1 + a, mu) = S(1);
      at[momentum_index(n, M, a, mu)] = value_of(z, replaced);
    }
  return at;
}

}  // namespace

STATEMENT(claim_8_1_extended_canonical_forms, "canonical forms with the multiplier among the fields") {
  claim.corrected(
      "d^nx_\\mu = \\partial_\\mu\\,d^{n+1}x", "d^nx_\\mu = \\partial_\\mu\\lrcorner\\,d^{n+1}x",
      "The hook is not printed here either. The canonical form is compared with what an element z of Z, "
      "any form that vanishes on two vertical vectors, is on vectors projected to E. Its coordinates are "
      "its values on coordinate vectors, so they are unique.");
  claim.maybe_scan();
  claim.same_slip_as("claim_6_1_contracted_volume");
  auto const at_dimensions = [&]<int n, int N>() {
    constexpr int M = N + 1, D = DualJet<S, n, M>::dimension, E = n + 1 + M;
    std::string const model = Dimensions<n, N>::name() + " and a multiplier";
    Matrix<S, E, 1> const point = draw.vector<S, Matrix<S, E, 1>>(E);
    auto const form = draw_form<n, M, S>(draw, false), any = draw_form<n, M, S>(draw, true);
    Matrix<S, D, 1> const at = coordinates_of<n, M>(form, point);
    auto const z = dual_jet_at<n, M>(at);
    auto const V = draw_tangents<S, D, n + 1>(draw);
    // T pi: the coordinates of Z are x, y and lambda, then Pi and the momenta.
    Tangents<S, E, n + 1> const below = V.template topRows<E>();
    Matrix<S, n + 1, n + 1> const dx = V.template topRows<n + 1>();
    S places(0), multiplier(0);
    for (int mu = 0; mu <= n; ++mu) {
      for (int a = 0; a < N; ++a) places += z.p(a, mu) * one_and_face<n>(n + 1 + a, mu, V);
      multiplier += z.p(N, mu) * one_and_face<n>(n + 1 + N, mu, V);
    }
    S const theta = canonical_form<n, M>()(at, V), volume_part = z.Pi * determinant(dx);
    claim.equal("the canonical form is z on projected vectors", model, theta, value_of(form, below));
    claim.equal("the canonical form in coordinates", model, theta, S(places + multiplier + volume_part));
    claim.differs("without the multiplier's part", model, theta, S(places + volume_part));
    claim.differs("printed: the derivative of the volume form along x^mu, which is zero, for d^nx_mu", model,
                  theta, volume_part);
    claim.differs("a form that does not vanish on two vertical vectors", model, value_of(any, below),
                  S(canonical_form<n, M>()(coordinates_of<n, M>(any, point), V)));

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
  at_dimensions.template operator()<3, 3>();
}

STATEMENT(claim_8_1_primary_constraint, "what the primary constraint is") {
  claim.convention(
      "In the sense of section 8.2, which sets it to $\\mathfrak C = \\{\\pi^\\mu = 0\\}$: it belongs to "
      "the multiplier of the constraint. Every jet is sent there, whatever its volume; $J = 1$ is no "
      "relation of $\\mathfrak C$, but comes later, as the field equation of $\\lambda$.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const density = incompressible(draw_medium<S, n>(draw));
    auto const j = draw_extended_jet<S, n>(draw, draw_section<S, n, n>(draw), density.constraint.G);
    auto const z = legendre(density, static_cast<Jet<S, n, n + 1> const&>(j));
    claim.zero("momenta of the multiplier in the image", model, z.p.row(n).eval(), size_of(z.p));
    claim.refutes("J = 1 in the image", model,
                  density.constraint(deformation(static_cast<Jet<S, n, n + 1> const&>(j)))[0], S(1));
    claim.equal("the field equation of the multiplier", model, euler_lagrange(density, j)[n],
                density.constraint(deformation(static_cast<Jet<S, n, n + 1> const&>(j)))[0]);
  });
}

STATEMENT(claim_8_1_degenerate_form, "the form on the primary constraint manifold is degenerate") {
  claim.holds("$\\partial/\\partial\\lambda$ is in its kernel. Before it is restricted it is not.");
  over_dimensions(PlaneAndSpace{}, [&]<class Dims>(Dims, std::string const& model) {
    constexpr int n = Dims::n, M = n + 1, D = DualJet<S, n, M>::dimension;
    Matrix<S, D, 1> at = draw.vector<S, Matrix<S, D, 1>>(D);
    auto V = draw_tangents<S, D, n + 2>(draw);
    V.col(0).setZero();
    V(n + 1 + n, 0) = S(1);
    claim.refutes("d/dlambda in the form before it is restricted", model,
                  S(canonical_two_form<n, M>()(at, V)), S(1));
    for (int mu = 0; mu <= n; ++mu)
      at[momentum_index(n, M, n, mu)] = S(0), V.row(momentum_index(n, M, n, mu)).setZero();
    claim.zero("d/dlambda is in the kernel of the restricted form", model,
               S(canonical_two_form<n, M>()(at, V)), S(1));
  });
}

STATEMENT(claim_8_1_volume_preserving_placement,
          "the velocity has no divergence where the placement preserves volume") {
  claim.holds(
      "At each instant and in any metrics: along a motion the volume $J$ has the rate "
      "$J\\,\\mathrm{div}\\,u$, so that it is constant where the divergence vanishes, and the other way "
      "round. $J = 1$ needs a placement that preserves volume at one instant.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const body = draw_metric_of_volume<S, n>(draw), space = draw_metric_of_volume<S, n>(draw);
    auto const any = draw_any_metric<S, n>(draw);
    auto const phi = draw_shears<S, n>(draw, body.chart, space.chart);
    VelocityInSpace const u{phi};
    auto const j = second_jet(phi, draw_event<S, n>(draw));
    Event<S, n> const at = event_in_space(j);
    auto const volume_of = [&](auto const& G, auto const& g) {
      VolumeConstraint const held{G, g};
      return std::pair{held.volume_ratio(static_cast<Jet<S, n, n> const&>(j)),
                       held.volume_ratio(along(j, 0)).part[0]};
    };
    auto const [J, rate] = volume_of(any, any);
    claim.equal("any motion: the rate of the volume is the divergence times the volume", model, rate,
                S(J * divergence(any, u, at)), 10);
    claim.differs("the divergence in coordinates", model, rate, S(J * first_jet(u, at).gradient().trace()));
    auto const [one, none] = volume_of(body, space);
    claim.equal("the placement preserves volume", model, one, S(1), 10);
    claim.zero("its rate", model, none, S(1), 10);
    claim.zero("the divergence of the velocity", model, divergence(space, u, at),
               size_of(velocity_gradient(space, u, at).slope), 10);
    claim.refutes("the divergence in another metric of space", model, divergence(any, u, at),
                  size_of(velocity_gradient(any, u, at).slope));
  });
}

STATEMENT(eq_8_1, "the constraint on the volume") {
  claim.convention(
      "The determinant is that of the spatial block $v^a{}_j$, with as many dimensions of space as of the "
      "body, in charts of one orientation.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    using Metric = MetricOfVolume<S, n>;
    VolumeConstraint<Metric, Metric> const constraint{draw_any_metric<S, n>(draw),
                                                      draw_any_metric<S, n>(draw)};
    auto const phi = draw_section<S, n, n>(draw);
    Event<S, n> const x = draw_event<S, n>(draw);
    Matrix<S, n, 1> const particle = x.template tail<n>();
    // The volume forms of body and space, and the second pulled back by the motion at this time.
    AtTime<S, AnySection<S, n, n>> const at_time{x[0], phi};
    auto const V = draw_tangents<S, n, n>(draw);
    S const pulled = pull_back(at_time, VolumeForm<Metric>{constraint.g})(particle, V),
            own = VolumeForm<Metric>{constraint.G}(particle, V);
    auto const j = first_jet(phi, x);
    S const Phi = constraint(j)[0];
    claim.equal("volume pulled back, minus volume", model, S(pulled - own), S(Phi * own));
    claim.differs("the determinant alone", model, Phi, S(determinant(j.gradient()) - S(1)));
    claim.differs("both metrics at the particle", model, Phi,
                  S(jacobian(constraint.G(particle), constraint.g(particle), j.gradient()) - S(1)));
    claim.differs("the quotient of the metrics turned round", model, Phi,
                  S(jacobian(constraint.g(j.y), constraint.G(particle), j.gradient()) - S(1)));

    VolumeConstraint<Metric, Metric> const curved{draw_metric_of_volume<S, n>(draw),
                                                  draw_metric_of_volume<S, n>(draw)};
    auto const held = draw_shears<S, n>(draw, curved.G.chart, curved.g.chart);
    claim.zero("motions between metrics whose determinants vary", model, curved(first_jet(held, x))[0], S(1));
    claim.refutes("motions that keep the volume of coordinates", model,
                  curved(first_jet(of_coordinates(held), x))[0], S(1));
  });
}

STATEMENT(eq_8_2, "the multiplier as a density and its sign") {
  claim.convention(
      "The sign goes with $L + \\lambda\\Phi$ of (8.3): then $P$ is positive in compression. With $h - "
      "\\langle\\lambda, \\Psi\\rangle$ of chapter 7 it would be $-\\sqrt{\\det G}\\,P$.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    using Metric = MetricOfVolume<S, n>;
    VolumeConstraint<Metric, Metric> const constraint{draw_any_metric<S, n>(draw),
                                                      draw_any_metric<S, n>(draw)};
    auto const phi = draw_section<S, n, n>(draw);
    auto const P = draw_cubic<S, n + 1>(draw);
    // The body in another chart: the metric pulled back, the motion and the pressure composed.
    ChartOfSpaceTime<S, n> const chi{draw_chart<S, n>(draw)};
    PulledBack<Metric, Chart<S, n>> const G{constraint.G, chi.chi};
    auto const moved = [&](auto const& x) { return phi(chi(x)); };
    auto const pressure = [&](auto const& x) { return P(chi(x)); };
    Event<S, n> const x = draw_event<S, n>(draw);
    Matrix<S, n, 1> const particle = x.template tail<n>();
    S const root = chi.chi.root(particle), stretch = root * root;
    auto const here = first_jet(with_pressure(moved, pressure, G), x);
    auto const there = first_jet(with_pressure(phi, P, constraint.G), chi(x));
    VolumeConstraint<PulledBack<Metric, Chart<S, n>>, Metric> const in_chart{G, constraint.g};
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
