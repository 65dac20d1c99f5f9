// The viscosity of von Neumann and Richtmyer: it spreads a shock over a few cells, and says what it takes.
//
// Where a cell is compressed, \f$\dot J < 0\f$, a pressure is added at its corners,
//
//     q = (rho/J) (quadratic (l r)^2 + linear l c r), r = -dJ/dt / J,
//
// with the speed of sound c and the shortest extent l of the corner in space. It is a force of the discrete
// Lagrange-d'Alembert principle: in each half kick of a step it does the work g.(v0 + v1)/2 h/2, by which the
// kinetic energy decreases up to rounding, whatever velocity the force was computed from. The sum of
// these works is what was dissipated. Energy plus that obeys the balance of the scheme without viscosity: it
// is constant up to the square of the step. The pressure is a part of Cauchy's stress, and turns nothing:
// momenta are conserved.
#pragma once

#include "actio/media_on_meshes/body_quadrature.hpp"
#include "actio/media_on_meshes/body_start.hpp"
#include "actio/parallel/shared_nodes.hpp"

namespace actio::media {

/// A step that is longer than small motions take to be damped: measured its length, bound that time.
struct ViscosityNeedsShorterSteps : OutsideDomain {
  int cell;  ///< in which they are
  /// @param which, step, longest  as above
  ViscosityNeedsShorterSteps(int which, double step, double longest);
};

/// The longest step that viscosity allows, and where.
struct ViscousLimit {
  double step = HUGE_VAL;  ///< time
  int cell = -1;           ///< which; -1: none is compressed
};

/// The viscosity of a body on a mesh.
template <int d>
class ViscousForces {
 public:
  using Gradient = Matrix<double, d, d>;  ///< a deformation gradient, or its rate

  /// @param shared  of a part of a body: its nodes; null: all of the body is here
  /// @throws OutsideDomain, NotFinite  where a coefficient is negative or no number
  ViscousForces(ArtificialViscosity const& given, BodyQuadrature<d> const& body,
                SharedNodes const* shared = nullptr)
      : given_(given) {
    for (double const one : {given.linear, given.quadratic}) {
      if (!is_finite(one)) throw NotFinite("medium: viscosity");
      if (!(one >= 0)) throw OutsideDomain("medium: viscosity", "a coefficient is not negative", one, 0);
    }
    std::vector<double> volumes(body.masses.size(), 0);
    each_share(body, [&](std::size_t, std::size_t node, double share) { volumes[node] += share; });
    if (shared) shared->complete(volumes);
    // The mean density around a node stands for that of the points beside it.
    masses_.assign(body.points.size(), 0);
    each_share(body, [&](std::size_t point, std::size_t node, double share) {
      masses_[point] += share * body.masses[node] / volumes[node];
    });
  }

  /// The forces at places x and velocities v of the nodes.
  /// @return the longest step that is stable with them, near which small motions are damped within a step
  ViscousLimit forces(BodyQuadrature<d> const& body, StoredEnergy<d> const& law, std::vector<double> const& x,
                      std::vector<double> const& v, std::vector<double>& f) const {
    f.assign(x.size(), 0);
    ViscousLimit limit;
    CellCorners<d> at, rate;
    for (int cell = 0; cell < body.cells(); ++cell) {
      body.gather(x, cell, at), body.gather(v, cell, rate, false);
      CellCorners<d> on;
      for (int p = 0; p < body.points_per_cell; ++p) {
        auto const here = compressed(body, law, at, rate, cell, p);
        if (here.pressure == 0) continue;
        if (here.longest_step < limit.step) limit = {here.longest_step, cell};
        auto const& point = body.at(cell, p);
        body.add_forces(here.cofactor * (-here.pressure * point.volume), p, point, on);
      }
      body.scatter(on, cell, f);
    }
    return limit;
  }
  /// The longest step about places x and velocities v, as if every cell were compressed a little at least.
  ViscousLimit limit(BodyQuadrature<d> const& body, StoredEnergy<d> const& law, std::vector<double> const& x,
                     std::vector<double> const& v) const {
    ViscousLimit limit;
    CellCorners<d> at, rate;
    for (int cell = 0; cell < body.cells(); ++cell) {
      body.gather(x, cell, at), body.gather(v, cell, rate, false);
      for (int p = 0; p < body.points_per_cell; ++p) {
        double const step = compressed(body, law, at, rate, cell, p).longest_step;
        if (step < limit.step) limit = {step, cell};
      }
    }
    return limit;
  }
  /// What these forces take from the kinetic energy in a kick of length h between two velocities.
  static double taken(std::vector<double> const& f, double h, std::vector<double> const& before,
                      std::vector<double> const& after) {
    double sum = 0;
    for (std::size_t k = 0; k < f.size(); ++k) sum -= f[k] * (before[k] + after[k]);
    return 0.5 * h * sum;
  }
  /// Memory, bytes.
  std::size_t bytes() const { return masses_.capacity() * sizeof(double); }

 private:
  ArtificialViscosity given_;
  std::vector<double> masses_;  // of the points

  struct Compressed {
    Gradient cofactor;
    double pressure, longest_step;
  };

  /// `visit(point, node, volume)` for the nodes beside each point, with the volume that these share.
  template <class Visit>
  static void each_share(BodyQuadrature<d> const& body, Visit const& visit) {
    for (std::size_t point = 0; point < body.points.size(); ++point) {
      std::size_t const cell = point / static_cast<std::size_t>(body.points_per_cell);
      int const *nodes = body.nodes.data() + cell * static_cast<std::size_t>(body.corners),
                own = static_cast<int>(point % static_cast<std::size_t>(body.points_per_cell));
      for (int b = 0; b < body.corners; ++b)
        if (body.points_per_cell == 1 || b == own)
          visit(point, static_cast<std::size_t>(nodes[b]),
                body.points[point].volume / (body.points_per_cell == 1 ? body.corners : 1));
    }
  }
  /// The square of the speed of sound along a dilation: \f$J^2U''\f$ of a fluid.
  static double sound_squared(StoredEnergy<d> const& law, Gradient const& F, double weight_over_mass) {
    Gradient const P = law.stress(F), rate = law.stress_rate(F, F);
    double sum = 0;
    for (int k = 0; k < d * d; ++k) sum += (rate.data()[k] - (d - 1) * P.data()[k]) * F.data()[k];
    return std::max(0.0, sum / (d * d) * weight_over_mass);
  }
  /// The shortest extent of a corner in space: its volume over the largest of its faces.
  static double extent(Gradient const& edges) {
    Gradient const faces = cofactors(edges);
    double largest = 0;
    for (int k = 0; k < d; ++k) {
      double square = 0;
      for (int i = 0; i < d; ++i) square += faces(i, k) * faces(i, k);
      largest = std::max(largest, square);
    }
    return small_determinant(edges) / std::sqrt(largest);
  }
  Compressed compressed(BodyQuadrature<d> const& body, StoredEnergy<d> const& law, CellCorners<d> const& at,
                        CellCorners<d> const& rates, int cell, int p) const {
    auto const& point = body.at(cell, p);
    Gradient const F = body.gradient(at, p, point), change = body.gradient(rates, p, point);
    Compressed out{cofactors(F), 0, 0};
    double const J = small_determinant(F);
    double rate = 0;
    for (int k = 0; k < d * d; ++k) rate -= out.cofactor.data()[k] * change.data()[k] / J;
    rate = std::max(rate, 0.0);
    double const mass = masses_[std::size_t(cell) * body.points_per_cell + p],
                 length = extent(body.edges(at.at, p)),
                 sound = given_.linear > 0 ? std::sqrt(sound_squared(law, F, point.weight / mass)) : 0,
                 fast = given_.linear * sound + given_.quadratic * length * rate;
    out.pressure = mass / (point.volume * J) * fast * length * rate;
    // A motion that sets neighbours against each other is damped at the rate 4 nu/l^2, with nu the slope of
    // q over that of r; a step is stable up to two over that.
    out.longest_step = length / (2 * (fast + given_.quadratic * length * rate));
    return out;
  }
};

}  // namespace actio::media
