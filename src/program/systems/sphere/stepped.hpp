// A flow on the sphere by one kind of step: the motion that a scene runs.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "actio/quantized_sphere/sphere_invariants.hpp"
#include "program/systems/sphere/stepped_matrix.hpp"
#include "program/systems/sphere/steps.hpp"

namespace actio::scene {

/// A flow in steps, each of one substep or of several.
/// @tparam Step    `VorticityStep<Stream>` or `FastVorticityStep<Stream>`
/// @tparam Stream  that of the Hamiltonian of the flow
template <class Step, class Stream>
class SteppedVorticity : public SteppedMatrix<Step, VorticityMotion> {
 public:
  /// From the start of the flow.
  SteppedVorticity(std::shared_ptr<SphereFlow const> const& flow, SphereScheme const& scheme, double step)
      : SteppedMatrix<Step, VorticityMotion>(
            flow->first_state(), scheme, step,
            [flow, scheme](double length) { return substeps(*flow, scheme, length); }),
        flow_(flow) {}

  sphere::SkewHermitian<> vorticity_at_output() const override {
    sphere::TurningFrame const& frame = flow_->frame;
    double const t = time(), back = flow_->turning_back();
    if (flow_->apart.is_there()) {
      auto const& apart = flow_->apart;
      sphere::SkewHermitian<> w = about_pole(frame.rate * t, state());
      if (apart.upright.angle() != 0) w = tilt()(-apart.upright.angle(), w);
      w = about_pole(-back * t, w);
      add_function(w, Eigen::AngleAxisd(-back * t, Eigen::Vector3d::UnitZ()) * apart.relative);
      return w;
    }
    sphere::SkewHermitian<> w;
    if (frame.axis[0] == 0 && frame.axis[1] == 0) {
      w = about_pole((frame.rate * frame.axis[2] - back) * t, state());
    } else {
      if (!about_axis_) about_axis_.emplace(flow_->sphere, frame.axis);
      w = about_pole(-back * t, (*about_axis_)(frame.rate * t, state()));
    }
    add_function(w, -2 * flow_->rotation * Eigen::Vector3d::UnitZ());
    return w;
  }
  sphere::SkewHermitian<> vorticity_but_for_rotation() const override {
    sphere::SkewHermitian<> w = state();
    if (flow_->apart.is_there())
      add_function(w, into_frame() * (flow_->apart.upright * flow_->apart.relative));
    else if (flow_->rotation != 0)
      add_function(w, into_frame() * (-2 * flow_->rotation * Eigen::Vector3d::UnitZ()));
    return w;
  }
  sphere::SkewHermitian<> absolute_vorticity() const override {
    sphere::SkewHermitian<> w = state();
    add_function(w, flow_->apart.background.vorticity * Eigen::Vector3d::UnitZ());
    return w;
  }
  Eigen::Vector3d angular_momentum() const override {
    Eigen::Vector3d const of_state = into_frame().inverse() * sphere::sphere_momentum(state());
    if (!flow_->apart.is_there()) return of_state;
    // The integral of the square of a coordinate is 4 pi/3.
    return flow_->apart.upright.inverse() * of_state +
           4 * M_PI / 3 * (flow_->apart.relative + 2 * flow_->rotation * Eigen::Vector3d::UnitZ());
  }

 private:
  using SteppedMatrix<Step, VorticityMotion>::time, SteppedMatrix<Step, VorticityMotion>::state;

  static std::vector<Step> substeps(SphereFlow const& flow, SphereScheme const& scheme, double step) {
    std::vector<Step> out;
    out.reserve(scheme.fractions.size());
    for (double const fraction : scheme.fractions) {
      auto const& stream = flow.stream.template as<Stream>();
      if constexpr (requires(Step one) { one.half_change(); })
        out.emplace_back(stream, scheme.conserved, fraction * step, flow.frame, flow.products,
                         flow.apart.background);
      else
        out.emplace_back(stream, scheme.conserved, fraction * step, flow.frame, flow.products);
    }
    return out;
  }
  sphere::SkewHermitian<> about_pole(double angle, sphere::SkewHermitian<> const& w) const {
    return sphere::Turning(flow_->sphere, Eigen::Vector3d::UnitZ())(angle, w);
  }
  /// Adds \f$r\cdot x\f$.
  void add_function(sphere::SkewHermitian<>& w, Eigen::Vector3d const& r) const {
    sphere::add_spin(flow_->sphere, flow_->sphere.hbar() * r, w);
  }
  /// From axes that do not turn to those of the frame.
  Eigen::AngleAxisd into_frame() const { return {-flow_->frame.rate * time(), flow_->frame.axis}; }
  /// About the axis about which the axis of the frame was put upright.
  sphere::Turning const& tilt() const {
    if (!about_axis_) about_axis_.emplace(flow_->sphere, flow_->apart.upright.axis());
    return *about_axis_;
  }

  std::shared_ptr<SphereFlow const> flow_;
  mutable std::optional<sphere::Turning> about_axis_;
};

}  // namespace actio::scene
