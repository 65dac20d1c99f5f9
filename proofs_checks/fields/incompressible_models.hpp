// Models of chapter 8: media with a pressure that solve nothing, motions that preserve volume exactly, and
// metrics that they preserve it for.
//
// Compositions of shears are polynomial and have polynomial inverses, and preserve dw^1 ... dw^n. Body and
// space have coordinates of their own, w = chi(y) with a determinant that varies; a metric whose volume is
// that of dw, and which is curved otherwise, has a determinant that varies with it. So J = 1 where neither
// metric nor motion is simple, and det g and det G change along the motion, each in its way.
#pragma once

#include "fields/fields.hpp"

#include "actio/incompressible/ideal_fluid.hpp"
#include "actio/incompressible/two_pressures.hpp"
#include "actio/jets/field_equations.hpp"

namespace actio::checks {

/// Other coordinates w of a space: a shear of the last coordinate, then a stretch of the first by the square
/// of q, linear in the others. The determinant is \f$q^2\f$, and the inverse needs no root.
template <class S, int n>
struct Chart {
  Matrix<S, n, 1> bend;     ///< of the first n - 1 coordinates: the last is moved by the square of this form
  Matrix<S, n, 1> stretch;  ///< of the last n - 1: q = 1 + this form

  template <class V>
  static auto form(Matrix<S, n, 1> const& c, V const& y) {
    ScalarOf<V> sum(0);
    for (int i = 0; i < n; ++i) sum += y[i] * ScalarOf<V>(c[i]);
    return sum;
  }
  template <class V>
  auto sheared(V const& y) const {
    auto u = y.eval();
    auto const moved = form(bend, u);
    u[n - 1] += moved * moved;
    return u;
  }
  /// q, of which the determinant is the square.
  template <class V>
  auto root(V const& y) const { return ScalarOf<V>(form(stretch, sheared(y)) + 1); }
  template <class V>
  auto operator()(V const& y) const {
    auto u = sheared(y);
    auto const q = ScalarOf<V>(form(stretch, u) + 1);
    u[0] *= q * q;
    return u;
  }
  template <class V>
  auto inverse(V const& w) const {
    auto u = w.eval();
    auto const q = ScalarOf<V>(form(stretch, u) + 1);
    u[0] /= q * q;
    auto const moved = form(bend, u);
    u[n - 1] -= moved * moved;
    return u;
  }
};
template <class S, int n>
Chart<S, n> draw_chart(Draw& draw) {
  Chart<S, n> chart{draw.vector<S, Matrix<S, n, 1>>(n) * ratio<S>(1, 2),
                    draw.vector<S, Matrix<S, n, 1>>(n) * ratio<S>(1, 3)};
  chart.bend[n - 1] = chart.stretch[0] = S(0);
  return chart;
}

/// A metric whose volume is that of a chart, times that of another metric, which is 1 for a frame with ones.
template <class S, int n>
struct MetricOfVolume {
  AnyMetric<S, n> other;
  Chart<S, n> chart;
  template <class V>
  auto frame(V const& y) const {
    auto A = other.frame(y);
    auto const q = chart.root(y);
    A.col(0) *= q * q;
    return A;
  }
  template <class V>
  auto operator()(V const& y) const {
    auto const A = frame(y);
    return (A.transpose() * A).eval();
  }
};
/// A metric A^T A with A upper triangular and ones on the diagonal: its volume is 1 everywhere.
template <class S, int n>
AnyMetric<S, n> draw_triangular_metric(Draw& draw) {
  auto g = draw_metric<S, n>(draw);
  for (int i = 0; i < n; ++i)
    for (int k = 0; k <= i; ++k) {
      g.constant(i, k) = S(i == k ? 1 : 0);
      for (auto& slope : g.slope) slope(i, k) = S(0);
      g.bend(i, k) = S(0);
    }
  return g;
}
/// A metric with the volume of its chart, neither constant nor flat: its frame is upper triangular with ones
/// but for the first.
template <class S, int n>
MetricOfVolume<S, n> draw_metric_of_volume(Draw& draw) {
  auto const g = draw_triangular_metric<S, n>(draw);
  return {g, draw_chart<S, n>(draw)};
}
/// A metric of any volume, of the same type.
template <class S, int n>
MetricOfVolume<S, n> draw_any_metric(Draw& draw) {
  auto const g = draw_metric<S, n>(draw);
  return {g, draw_chart<S, n>(draw)};
}
/// The metric of the same type that is the same everywhere.
template <class S, int n>
MetricOfVolume<S, n> constant_metric(MetricOfVolume<S, n> g) {
  for (auto& slope : g.other.slope) slope.setZero();
  g.other.bend.setZero(), g.chart.bend.setZero(), g.chart.stretch.setZero();
  return g;
}
/// A chart of the body as one of space-time: from (t, x') to (t, x).
template <class S, int n>
struct ChartOfSpaceTime {
  Chart<S, n> chi;
  template <class V>
  auto operator()(V const& x) const {
    auto y = x.eval();
    y.template tail<n>() = chi(x.template tail<n>().eval());
    return y;
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

/// A density of mass 1 everywhere, of the same type as one that varies.
template <class S, int n>
AnyMass<S, n> unit_mass() {
  using V = Matrix<S, n, 1>;
  V const zero = V::Zero();
  return {Cubic<S, n>{S(-1), zero, zero, zero, zero}};
}
/// A stored energy that is the same everywhere, of the same type as one that is not.
template <class S, int n>
AnyEnergy<S, n, n> constant_energy(S const& value) {
  using V = Matrix<S, AnyEnergy<S, n, n>::arguments, 1>;
  V const zero = V::Zero();
  return {Cubic<S, AnyEnergy<S, n, n>::arguments>{value, zero, zero, zero, zero}};
}

template <class S, int n>
using Medium = Continuum<MetricOfVolume<S, n>, MetricOfVolume<S, n>, AnyMass<S, n>, AnyEnergy<S, n, n>>;
template <class S, int n>
using Fluid =
    Continuum<MetricOfVolume<S, n>, MetricOfVolume<S, n>, AnyMass<S, n>, Barotropic<AnyFluidLaw<S>>>;

/// A medium of the most general kind: metrics of body and space, mass and energy all vary.
template <class S, int n>
Medium<S, n> draw_medium(Draw& draw) {
  auto const G = draw_any_metric<S, n>(draw), g = draw_any_metric<S, n>(draw);
  auto const rho = draw_mass<S, n>(draw);
  return {G, g, rho, draw_energy<S, n, n>(draw)};
}
/// An ideal homogeneous fluid: mass 1, a stored energy that is the same everywhere.
template <class S, int n>
Medium<S, n> ideal_fluid(MetricOfVolume<S, n> const& G, MetricOfVolume<S, n> const& g,
                         S const& energy = ratio<S>(2, 7)) {
  return {G, g, unit_mass<S, n>(), constant_energy<S, n>(energy)};
}
template <class S, int n>
Fluid<S, n> draw_barotropic(Draw& draw) {
  auto const G = draw_any_metric<S, n>(draw), g = draw_any_metric<S, n>(draw);
  auto const rho = draw_mass<S, n>(draw);
  return {G, g, rho, draw_fluid<S>(draw)};
}

/// n shears one after the other, in the coordinates of a chart of the body and of one of space: each adds to
/// one coordinate time times a quadratic polynomial in time and the others. The volume of the charts is
/// preserved, and with one chart the motion begins at the identity.
template <class S, int n>
struct Shears {
  Chart<S, n> body, space;
  std::array<Cubic<S, n + 1>, n> added;

  template <class V>
  auto operator()(V const& x) const {
    auto moved = x.eval();
    moved.template tail<n>() = body(x.template tail<n>().eval());
    for (int a = 0; a < n; ++a) moved[a + 1] += added[a](moved) * moved[0];
    return space.inverse(moved.template tail<n>().eval());
  }
  /// The particle that is at a point of space: from (t, y) to (t, x).
  template <class V>
  auto particle(V const& y) const {
    auto moved = y.eval();
    moved.template tail<n>() = space(y.template tail<n>().eval());
    for (int a = n - 1; a >= 0; --a) moved[a + 1] -= added[a](moved) * moved[0];
    moved.template tail<n>() = body.inverse(moved.template tail<n>().eval());
    return moved;
  }
};
/// A motion that preserves the volumes of two charts.
template <class S, int n>
Shears<S, n> draw_shears(Draw& draw, Chart<S, n> const& body, Chart<S, n> const& space) {
  Shears<S, n> phi{body, space, {}};
  for (int a = 0; a < n; ++a) {
    phi.added[a] = draw_cubic<S, n + 1>(draw, ratio<S>(3, 4));
    // What a coordinate is moved by does not depend on it.
    for (auto* vector : {&phi.added[a].a, &phi.added[a].b, &phi.added[a].d}) (*vector)[a + 1] = S(0);
    phi.added[a].e.setZero();
    // Numbers grow with the degree to the power of n.
    if (n > 2 && numbers_grow()) phi.added[a].b.setZero();
  }
  return phi;
}
/// The same shears of the coordinates themselves: they preserve the volume of coordinates, not that of the
/// metrics.
template <class S, int n>
Shears<S, n> of_coordinates(Shears<S, n> phi) {
  for (auto* chart : {&phi.body, &phi.space}) chart->bend.setZero(), chart->stretch.setZero();
  return phi;
}

/// A function of time and place at one time: of a motion the map from the body to space, of a field of
/// velocities the field.
template <class S, class Function>
struct AtTime {
  S time;
  Function f;
  template <class V>
  auto operator()(V const& x) const {
    Matrix<ScalarOf<V>, V::RowsAtCompileTime + 1, 1> event;
    event << ScalarOf<V>(time), x;
    return f(event);
  }
};
template <class S, class Function>
AtTime(S, Function) -> AtTime<S, Function>;
/// The point (t, y) at which a jet is.
template <class S, int n>
Event<S, n> event_in_space(Jet<S, n, n> const& j) {
  Event<S, n> at;
  at << j.x[0], j.y;
  return at;
}
/// The velocity \f$u = \dot\phi\circ\phi_t^{-1}\f$ in space of a motion with an inverse.
template <class Phi>
struct VelocityInSpace {
  Phi phi;
  template <class V>
  auto operator()(V const& y) const { return first_jet(phi, phi.particle(y)).velocity(); }
};
template <class Phi>
VelocityInSpace(Phi) -> VelocityInSpace<Phi>;

/// A field or function of time and space at the position of a particle: from (t, x) to its value at (t,
/// phi(t, x)).
template <class Field, class Phi>
struct CarriedBy {
  Field field;
  Phi phi;
  template <class V>
  auto operator()(V const& x) const {
    auto const place = phi(x).eval();
    Matrix<ScalarOf<V>, V::RowsAtCompileTime, 1> at;
    at << x[0], place;
    return field(at);
  }
};
template <class Field, class Phi>
CarriedBy(Field, Phi) -> CarriedBy<Field, Phi>;

/// A field \f$u^a = \frac{1}{\sqrt{\det g}}\,\partial_b\psi^{ab}\f$ with antisymmetric \f$\psi\f$, functions
/// of time and place: its divergence vanishes everywhere.
template <class S, int n, class Metric, class Stream = Cubic<S, n + 1>>
struct SolenoidalField {
  Metric g;
  std::array<Stream, n*(n - 1) / 2> psi;
  template <class V>
  auto operator()(V const& y) const {
    using T = ScalarOf<V>;
    Matrix<T, n, 1> u = Matrix<T, n, 1>::Zero();
    for (int a = 0, k = 0; a < n; ++a)
      for (int b = 0; b < a; ++b, ++k) {
        auto const slope = derivative(psi[k], Matrix<T, n + 1, 1>(y)).gradient();
        u[a] += slope[b + 1];
        u[b] -= slope[a + 1];
      }
    Matrix<T, n, 1> const place = y.template tail<n>();
    return (u / volume<T>(g(place))).eval();
  }
};
template <class S, int n, class Metric>
SolenoidalField<S, n, Metric> draw_solenoidal(Draw& draw, Metric const& g) {
  SolenoidalField<S, n, Metric> u{g, {}};
  for (auto& psi : u.psi) psi = draw_cubic<S, n + 1>(draw);
  return u;
}

/// The second jet at a random event of a deformation with a random pressure.
template <class S, int n, class Phi, class BodyMetric>
SecondJet<S, n, n + 1> draw_extended_jet(Draw& draw, Phi const& phi, BodyMetric const& G) {
  auto const P = draw_cubic<S, n + 1>(draw);
  return second_jet(with_pressure(phi, P, G), draw_event<S, n>(draw));
}

/// The Euler-Lagrange derivative by the motion, over \f$-\sqrt{\det G}\f$: what equations of motion per unit
/// of volume leave.
template <class L, class S, int n, int M>
Matrix<S, n, 1> per_volume(L const& density, SecondJet<S, n, M> const& j) {
  Matrix<S, M, 1> const E = euler_lagrange(density, j);
  return -E.template head<n>() / volume<S>(density.constraint.G(j.particle()));
}

}  // namespace actio::checks
