// What can be read off a body in motion.
#pragma once

#include "actio/media_on_meshes/body_motion.hpp"

namespace actio::media {

/// What can be read off a body in motion: \ref MediumOnMesh.
template <int d>
class MeasuredBody : protected BodyMotion<d> {
 public:
  using Place = std::array<double, d>;  ///< a point, or a vector
  using Tensor = Matrix<double, d, d>;  ///< a deformation gradient, or a stress

  /// The masses of the nodes.
  std::vector<double> const& masses() const { return steps_of_.forces.body.masses; }
  /// Places of the nodes, length.
  std::vector<Place> places() const { return points(state_.x); }
  /// Velocities of the nodes, length/time.
  std::vector<Place> velocities() const { return points(state_.v); }
  /// Kinetic and stored energy, and that of loads, now.
  BodyEnergies energies() const {
    BodyEnergies e{0, steps_of_.forces.stored(state_.x, state_.x_rest), steps_of_.forces.of_loads(state_.x)};
    for (std::size_t k = 0; k < state_.v.size(); ++k)
      e.kinetic += 0.5 * masses()[k / d] * state_.v[k] * state_.v[k];
    return e;
  }
  /// The energy that viscosity has taken since the start: energies and this together are constant up to the
  /// square of the step, where energies are without viscosity.
  double dissipated() const { return state_.dissipated; }
  /// Linear momentum, mass x length/time: kept to rounding where nothing is held and no load acts.
  Place momentum() const { return state_.template momentum<d>(masses()); }
  /// Angular momentum about the origin of space, \f$\sum m\,x\times v\f$, mass x area/time: kept to rounding
  /// where momentum is, and by the outside pressure. In the plane the third component; on a line none.
  std::array<double, 3> angular_momentum() const { return state_.template angular_momentum<d>(masses()); }
  /// For each cell the least det F at its points.
  std::vector<double> jacobians() const {
    std::vector<double> out(number_of_cells(), HUGE_VAL);
    steps_of_.forces.each_point(state_.x, [&](int cell, int, CellPoint<d> const&, Tensor const& F) {
      out[cell] = std::min(out[cell], small_determinant(F));
    });
    return out;
  }
  /// For each cell the mean of Cauchy's stress \f$PF^T/J\f$ over its points, pressure unit.
  std::vector<Tensor> cauchy_stresses() const {
    std::vector<Tensor> out(number_of_cells(), Tensor::Zero());
    double const share = 1.0 / steps_of_.forces.body.points_per_cell;
    steps_of_.forces.each_displacement(
        state_.x, state_.x_rest, [&](int cell, int, CellPoint<d> const& point, Tensor const& H) {
          Tensor const P = steps_of_.forces.law().stress_beyond(H), F = beyond_identity(H);
          out[cell] += P * F.transpose() * (share * point.weight / point.volume / small_determinant(F));
        });
    return out;
  }
  /// For each cell minus the mean of the diagonal of Cauchy's stress.
  std::vector<double> pressures() const {
    std::vector<double> out;
    for (Tensor const& stress : cauchy_stresses()) {
      double trace = 0;
      for (int a = 0; a < d; ++a) trace += stress(a, a);
      out.push_back(-trace / d);
    }
    return out;
  }
  /// For each cell what it has stored, per reference volume.
  std::vector<double> energy_densities() const {
    std::vector<double> out(number_of_cells(), 0), volume(number_of_cells(), 0);
    steps_of_.forces.each_displacement(
        state_.x, state_.x_rest, [&](int cell, int, CellPoint<d> const& point, Tensor const& H) {
          out[cell] += point.weight * steps_of_.forces.law().energy_beyond(H), volume[cell] += point.volume;
        });
    for (std::size_t k = 0; k < out.size(); ++k) out[k] /= volume[k];
    return out;
  }
  /// The longest time step for which small motions about the state now are stable, with the explicit step and
  /// without viscosity: two over the largest frequency, which comes from below, so that the step comes from
  /// above, within a per cent. With order 4 no substep is longer than 0.66 of the step, and the step may be
  /// longer by that.
  double largest_step_of_waves() const {
    double longest = 0;
    for (double const one : this->fractions_) longest = std::max(longest, std::abs(one));
    return 2 / steps_of_.largest_frequency(state_.x) / longest;
  }
  /// The longest that viscosity allows in one part now, HUGE_VAL without it.
  double largest_step_of_viscosity() const {
    if (!steps_of_.viscosity) return HUGE_VAL;
    auto const& forces = steps_of_.forces;
    return steps_of_.viscosity->limit(forces.body, forces.law(), state_.x, state_.v).step;
  }
  /// The lesser of the two.
  double largest_step() const { return std::min(largest_step_of_waves(), largest_step_of_viscosity()); }

 protected:
  using BodyMotion<d>::BodyMotion, BodyMotion<d>::steps_of_, BodyMotion<d>::state_;

 private:
  std::size_t number_of_cells() const { return static_cast<std::size_t>(steps_of_.forces.body.cells()); }
  std::vector<Place> points(std::vector<double> const& in) const {
    std::vector<Place> out(in.size() / d);
    for (std::size_t k = 0; k < in.size(); ++k) out[k / d][k % d] = in[k];
    return out;
  }
};

}  // namespace actio::media
