// A free rigid body in three dimensions, moved exactly: to any time at once.
//
//     FreeBody body(inertia_from_moments(0.6, 0.8, 1), momentum, attitude);
//     auto later = body.at(1000);                               // one evaluation, whatever the time
//
// Momentum and attitude are kept by direction and unit quaternion, in axes that are relabelled so that the middle moment of inertia belongs to the second.
// No body needs a tolerance: spheres, symmetric bodies, rods, plates and turns about any axis are on the same road, and next to their limits nothing is lost.
#pragma once

#include <string>

#include "actio/foundations/groups/unit_quaternions.hpp"
#include "actio/free_body/exact_flight.hpp"
#include "actio/rigid_body/inertia.hpp"
#include "actio/rigid_body/largest_step.hpp"
#include "actio/free_body/modified_inertia.hpp"
#include "actio/free_body/symmetric_body.hpp"

namespace actio {

/// Momentum and attitude of a body at one time.
struct FreeState {
  Momentum<SO<3>, double> body_momentum;  ///< energy x time
  Element<SU2, double> attitude;          ///< unit quaternion, body to space

  /// The momentum in space, constant along a free motion.
  Momentum<SO<3>, double> spatial_momentum() const { return {SO<3>{}, SU2::Ad<double>(attitude.value, body_momentum.components)}; }
};

/// A body that turns freely, from a given start.
class FreeBody {
 public:
  /// @param inertia   of the body
  /// @param momentum  body momentum at the start, energy x time
  /// @param attitude  at the start, body to space
  /// @throws NotFinite, OutsideDomain  where a number is none, or the quaternion not near unit length
  FreeBody(Inertia<3> const& inertia, Momentum<SO<3>, double> const& momentum, Element<SU2, double> const& attitude = identity<double>(SU2{}))
      : inertia_(inertia) {
    using std::sqrt;
    if (!is_finite(momentum.components)) throw NotFinite("free body: body momentum");
    if (!is_finite(attitude.value)) throw NotFinite("free body: attitude");
    Eigen::Vector3d const& I = inertia.moments;
    if (!is_finite(I)) throw NotFinite("free body: moments of inertia");
    // The second axis gets the middle moment: one of the three ways to count cyclically does it.
    while (!between(I[first_ % 3], I[(first_ + 1) % 3], I[(first_ + 2) % 3])) ++first_;
    // Moments in units of a power of two near the largest: no product of them leaves the range of the numbers, and nothing is rounded. A rounded difference of
    // two moments that are nearly equal would be another body.
    int exponent = 0;
    std::frexp(magnitude(I), &exponent);
    unit_ = std::ldexp(1.0, exponent);
    amount_ = momentum.components.stableNorm();
    Eigen::Vector3d const direction = amount_ > 0 ? Eigen::Vector3d(momentum.components / amount_).normalized() : Eigen::Vector3d::UnitX();
    Element<SU2, double> const unit = restore(attitude);
    start_ = relabelled(direction, unit.value);
    Three<double> const moments{I[first_ % 3] / unit_, I[(first_ + 1) % 3] / unit_, I[(first_ + 2) % 3] / unit_};
    symmetry_ = axis_of_symmetry(moments);
    moments_ = InverseMoments<double>(moments);
    rate_ = amount_ / unit_;
    if (!is_finite(rate_)) throw NotFinite("free body: momentum over inertia");
  }

  Inertia<3> const& inertia() const { return inertia_; }
  /// \f$|M|\f$, energy x time.
  double amount() const { return amount_; }

  /// The state at time t, before or after the start: one exact step of that length; for bodies with two equal moments sines and cosines.
  /// Accuracy: a few epsilon times the angle turned.
  FreeState at(double t) const {
    if (symmetry_ >= 0) return state(symmetric_motion(moments_, symmetry_, start_, 2 * half(t)));
    BodyPlace<double> place = start_;
    HalfTurn<double>(flight(t)).leap(place);
    return state(place);
  }

  /// The exact flight over a time t.
  /// @throws NotFinite  where t is no number, or the angle overflows
  Flight<double> flight(double t) const { return exact_flight<double>(moments_, start_.direction, half(t)); }

  /// The flight of the Moser-Veselov scheme, `order` 2, or of the same scheme with modified moments of inertia, 4, 6, 8, ...
  /// @throws OutsideDomain  where the order is odd or not positive
  /// @throws StepTooLong    where there is no solution, with the largest step that would do
  Flight<double> moser_veselov_flight(double h, int order) const {
    if (order < 2 || order % 2 != 0 || order > 40) throw OutsideDomain("free body", "the order of the scheme must be 2, 4, ... 40", order, order < 2 ? 2 : 40);
    double const t = half(h);
    auto const modified = order == 2 ? ModifiedInertia<double>{1, 0} : modified_inertia<double>(moments_, start_.direction, t, order);
    bool found = false;
    Flight<double> const flight = actio::moser_veselov_flight<double>(half_step(moments_, modified, t), start_.direction, found);
    if (!found) throw StepTooLong("Moser-Veselov of order " + std::to_string(order), std::abs(h), longest_step(h, order));
    return flight;
  }

  /// \f$L\sqrt{s_1}\f$, 1/time: between once and the root of twice the frequency of Jacobi's functions. No small change of the place grows faster.
  double pace() const { return std::sqrt(Orbit<double>(moments_, start_.direction).s1) * rate_; }
  /// Whether the orbit passes the middle axis closely: \f$k'^2\f$ about 1/100, or less.
  bool near_separatrix() const {
    Orbit<double> const orbit(moments_, start_.direction);
    return 100 * std::abs(moments_.d13 * orbit.beside) < orbit.s1;
  }

  /// Where the body starts, in the axes that the steps use.
  BodyPlace<double> const& start() const { return start_; }
  /// The inverse moments in the axes that the steps use, in units of a power of two near that of the largest moment.
  InverseMoments<double> const& inverse_moments() const { return moments_; }

  /// The state of a place that the steps have reached.
  FreeState state(BodyPlace<double> const& place) const {
    Eigen::Vector3d direction;
    Element<SU2, double> attitude{SU2{}, {place.attitude[0], 0, 0, 0}};
    for (int i = 0; i < 3; ++i) {
      direction[(i + first_) % 3] = place.direction[i];
      attitude.value[1 + (i + first_) % 3] = place.attitude[1 + i];
    }
    attitude.value.normalize();
    return {{SO<3>{}, amount_ * direction}, attitude};
  }

 private:
  static bool between(double a, double b, double c) { return (a <= b && b <= c) || (a >= b && b >= c); }
  /// The same cyclic exchange for the axes of the body and those of space: the quaternion keeps its scalar part.
  BodyPlace<double> relabelled(Eigen::Vector3d const& u, Eigen::Vector4d const& q) const {
    BodyPlace<double> place;
    place.attitude[0] = q[0];
    for (int i = 0; i < 3; ++i) place.direction[i] = u[(i + first_) % 3], place.attitude[1 + i] = q[1 + (i + first_) % 3];
    return place;
  }
  double half(double t) const {
    double const angle = t / 2 * rate_;
    if (!is_finite(angle)) throw NotFinite("free body: time, or time times momentum over inertia");
    return angle;
  }
  /// Of the scheme of this order: order 2 has a closed form, where no Lambda_i is negative; beyond that by bisection.
  double longest_step(double h, int order) const {
    if (order == 2 && !(inertia_.lambda.minCoeff() < 0)) return largest_step(inertia_, Momentum<SO<3>, double>{SO<3>{}, state(start_).body_momentum.components});
    double low = 0, high = std::abs(h);
    for (int i = 0; i < 60 && high - low > 1e-12 * high; ++i) {
      double const middle = (low + high) / 2, t = half(middle);
      auto const modified = modified_inertia<double>(moments_, start_.direction, t, order);
      bool found = false;
      actio::moser_veselov_flight<double>(half_step(moments_, modified, t), start_.direction, found);
      (found ? low : high) = middle;
    }
    return low;
  }

  Inertia<3> inertia_;
  int first_ = 0, symmetry_;
  double unit_, amount_, rate_;
  BodyPlace<double> start_;
  InverseMoments<double> moments_;
};

}  // namespace actio
