// A free rigid body in three dimensions, moved exactly: to any time at once.
//
//     FreeBody body(inertia_from_moments(0.6, 0.8, 1), momentum, attitude);
//     auto later = body.at(1000);                               // one evaluation, whatever the time
//
// Inertia, momentum and attitude are those of any frame of the body: one rotation leads to its principal
// axes, counted so that the middle moment of inertia belongs to the second. There momentum and attitude are
// kept by direction and unit quaternion. No body needs a tolerance: spheres, symmetric bodies, rods, plates
// and turns about any axis are no cases of their own, and next to their limits nothing is lost.
#pragma once

#include <Eigen/Core>

#include <string>

#include "actio/fast_body/space/exact_flow.hpp"
#include "actio/fast_body/space/middle_axis_frame.hpp"
#include "actio/fast_body/space/modified_inertia.hpp"
#include "actio/fast_body/space/symmetric_body.hpp"
#include "actio/groups/unit_quaternions.hpp"
#include "actio/rigid_body/largest_step.hpp"
#include "actio/rigid_body/principal_inertia.hpp"

namespace actio::bodies {

/// Momentum and attitude of a body at one time.
struct FreeState {
  Momentum<SO<3>, double> body_momentum;  ///< energy x time
  Element<SU2, double> attitude;          ///< unit quaternion, body to space

  /// The momentum in space, constant along a free motion.
  Momentum<SO<3>, double> spatial_momentum() const {
    return {SO<3>{}, SU2::Ad<double>(attitude.value, body_momentum.components)};
  }
};

/// A rigid body without a torque, from a given start: its exact motion, at any time by one evaluation.
/// In steps of one length it is \ref FreeSteps, under a torque \ref TorquedBody; the theory is \ref ch05a.
///
/// \snippet bodies.cpp free_body
class FreeBody {
 public:
  /// @param inertia   of the body, by principal moments or in a frame of any choice; momentum and attitude
  ///                  are of the same frame
  /// @param momentum  body momentum at the start, energy x time
  /// @param attitude  at the start, body to space
  /// @throws NotFinite, OutsideDomain where a number is none, the quaternion not near unit length, or the
  ///         principal axes no rotation
  FreeBody(PrincipalInertia const& inertia, Momentum<SO<3>, double> const& momentum,
           Element<SU2, double> const& attitude = identity<double>(SU2{}));

  /// In the frame of the body.
  PrincipalInertia const& inertia() const { return inertia_; }
  /// Whether two moments are equal to rounding, so that the motion has a closed form in sines and cosines.
  bool is_symmetric() const { return symmetry_ >= 0; }
  /// Whether all three are.
  bool is_sphere() const {
    auto const& I = frame_.moments();
    return is_symmetric() && axis_of_symmetry({I[2], I[1], I[0]}) == symmetry_;
  }
  /// \f$|M|\f$, energy x time.
  double magnitude() const { return magnitude_; }

  /// The state at time t, before or after the start: one exact step of that length; for bodies with two equal
  /// moments sines and cosines. The quaternion is the one that the given one becomes as time goes on, its
  /// sign too. Accuracy: a few epsilon times the angle turned.
  FreeState at(double t) const { return state(frame_state_at(t)); }
  /// The momentum alone, to the same bits: nothing of the attitude is computed.
  Momentum<SO<3>, double> body_momentum_at(double t) const;
  /// The same, in the axes that the steps use.
  FrameState<double> frame_state_at(double t) const;

  /// The parameters of the exact flow over a time t.
  /// @throws NotFinite  where t is no number, or the angle overflows
  StepParameters<double> step_parameters(double t) const {
    return exact_flow<double>(moments_, start_.direction, half(t));
  }

  /// The parameters of a step of the Moser-Veselov scheme, `order` 2, or of the same scheme with modified
  /// moments of inertia, 4, 6, 8, ...
  ///
  /// \snippet bodies.cpp moser_veselov_parameters
  /// @throws OutsideDomain  where the order is odd or not positive
  /// @throws StepTooLong    where there is no solution, with the largest step that would do
  StepParameters<double> moser_veselov_parameters(double h, int order) const;

  /// \f$L\sqrt{s_1}\f$, 1/time: between once and the root of twice the frequency of Jacobi's functions. No
  /// perturbation grows faster.
  double pace() const { return std::sqrt(Orbit<double>(moments_, start_.direction).s1) * rate_; }
  /// Whether the orbit passes the middle axis closely: \f$k'^2\f$ about 1/100, or less.
  bool near_separatrix() const {
    Orbit<double> const orbit(moments_, start_.direction);
    return 100 * std::abs(moments_.d13 * orbit.beside) < orbit.s1;
  }

  /// Where the body starts, in the axes that the steps use.
  FrameState<double> const& start() const { return start_; }
  /// The inverse moments in the axes that the steps use, in units of a power of two near that of the largest
  /// moment.
  InverseMoments<double> const& inverse_moments() const { return moments_; }

  /// The momentum and attitude of a state in the axes of the steps.
  FreeState state(FrameState<double> const& state) const {
    return {momentum_along(state.direction), {SU2{}, frame_.leave(state.attitude).normalized()}};
  }
  /// The body momentum with such a direction.
  Momentum<SO<3>, double> momentum_along(Three<double> const& direction) const {
    return {SO<3>{}, magnitude_ * frame_.leave(direction)};
  }

 private:
  double half(double t) const {
    double const angle = t / 2 * rate_;
    if (!is_finite(angle)) throw NotFinite("free body: time, or time times momentum over inertia");
    return angle;
  }
  /// The longest step up to h of the scheme of this order. Order 2 has a closed form, where no Lambda_i is
  /// negative; beyond that the first step that has no solution is looked for upwards, and then between it and
  /// the last that had one.
  double longest_step(double h, int order) const;

  PrincipalInertia inertia_;
  MiddleAxisFrame frame_;
  int symmetry_;
  double magnitude_, rate_;
  FrameState<double> start_;
  InverseMoments<double> moments_;
};

}  // namespace actio::bodies
