// A rigid body under a torque: kicks, and exact free flights in between.
//
//     TorquedBody body(inertia, momentum, attitude, gravity_gradient(inertia, 3 * mu / (r * r * r), towards), 0.1);
//     body.step(1000);
//
// After each kick the body is on another orbit, so a flight is set up anew each time: by the power series of short_step.hpp as long as it is short,
// by elliptic functions otherwise. Free motion is exact whatever the step; the order is that of the kicks.
#pragma once

#include <type_traits>
#include <utility>

#include "actio/fast_body/space/gravity_gradient.hpp"
#include "actio/fast_body/space/kick_flight.hpp"
#include "actio/fast_body/space/short_step.hpp"

namespace actio {
namespace detail {

/// A body between kicks, in the axes that the flights use: p = hM/(2I), I the unit of inertia, and the attitude.
struct TorquedPlace {
  Three<double> p;
  Four<double> q;
};

/// Which body it is, in numbers without dimension; and from its axes to those of the flights and back.
class TorquedFrame {
 public:
  /// @throws UnphysicalInertia, NotFinite, OutsideDomain  where there is no such body, or no such step
  TorquedFrame(PrincipalInertia const& inertia, double h) : h_(h), frame_(inertia), body_(frame_.moments()) {
    if (!is_finite(h)) throw NotFinite("torqued body: step");
    if (h == 0) throw OutsideDomain("torqued body", "the step must differ from zero", 0, 0);
    inertia_from_moments(inertia.inertia.moments);  // which refuses what is none
  }

  InverseMoments<double> const& body() const { return body_; }
  MiddleAxisFrame const& axes() const { return frame_; }
  double step() const { return h_; }
  /// What the torque is multiplied with for a kick of a whole step.
  double kick() const { return h_ / frame_.unit() * (h_ / 2); }
  /// @throws NotFinite, OutsideDomain  where a number is none, or the quaternion not near unit length
  TorquedPlace enter(Momentum<SO<3>, double> const& momentum, Element<SU2, double> const& attitude) const {
    if (!is_finite(momentum.components)) throw NotFinite("torqued body: body momentum");
    if (!is_finite(attitude.value)) throw NotFinite("torqued body: attitude");
    TorquedPlace const place{frame_.enter(Eigen::Vector3d(momentum.components / frame_.unit() * (h_ / 2))), frame_.enter(restore(attitude).value)};
    if (!is_finite(dot(place.p, place.p))) throw NotFinite("torqued body: step times momentum over inertia");
    return place;
  }
  FreeState leave(TorquedPlace const& place) const {
    return {{SO<3>{}, frame_.leave(place.p) / (h_ / 2) * frame_.unit()}, {SU2{}, frame_.leave(place.q).normalized()}};
  }

 private:
  double h_;
  MiddleAxisFrame frame_;
  InverseMoments<double> body_;
};

/// The same inverse moments, times c.
template <class T>
[[gnu::always_inline]] inline InverseMoments<T> scaled(InverseMoments<T> const& body, T const& c) {
  InverseMoments<T> part;
  part.J = {body.J[0] * c, body.J[1] * c, body.J[2] * c};
  part.d12 = body.d12 * c, part.d23 = body.d23 * c, part.d13 = body.d13 * c;
  return part;
}

/// A flight over the part c of a step, of any length.
/// @throws NotFinite  where the momentum is no number
[[gnu::noinline, gnu::cold]] inline TorquedPlace long_step(InverseMoments<double> const& body, double c, TorquedPlace place) {
  double const size = std::max({std::abs(place.p[0]), std::abs(place.p[1]), std::abs(place.p[2])});
  if (!std::isfinite(size) || !std::isfinite(dot(place.p, place.p))) throw NotFinite("torqued body: momentum, in the course of the motion");
  if (size == 0) return place;
  Three<double> u{place.p[0] / size, place.p[1] / size, place.p[2] / size};
  double const length = std::sqrt(dot(u, u));
  for (double& x : u) x /= length;
  BodyPlace<double> moved{u, place.q};
  HalfTurn<double>(exact_flight<double>(body, u, c * (size * length))).step(moved);
  place.q = moved.attitude;
  for (int i = 0; i < 3; ++i) place.p[i] = size * length * moved.direction[i];
  return place;
}

/// A flight over the part c of a step; `terms` is 5 or 8, what the last one did with.
[[gnu::always_inline]] inline TorquedPlace fly(InverseMoments<double> const& body, InverseMoments<double> const& part, double c, TorquedPlace const& place,
                                               int& terms) {
  if (terms == 5) {
    TorquedPlace next = place;
    if (all_within<5>(short_step(StepTable<5, double>::get(), part, next.p, next.q))) [[likely]]
      return next;
  }
  TorquedPlace next = place;
  auto const reach = short_step(StepTable<8, double>::get(), part, next.p, next.q);
  terms = reach.turn <= short_reach<5> / 2 && reach.twist <= short_twist<5> / 2 ? 5 : 8;
  if (all_within<8>(reach)) return next;
  return long_step(body, c, place);
}

/// \f$|q|\to1\f$ without a root, for it is nearly so.
template <class T>
[[gnu::always_inline]] inline void tidy(Four<T>& q) {
  T const shorter = 1.5 - 0.5 * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (int i = 0; i < 4; ++i) q[i] = q[i] * shorter;
}

/// A torque in the axes in which the body is moved, by way of the frame of the body at each call.
template <class Torque>
struct TorqueOfFrame {
  Torque torque;
  MiddleAxisFrame frame;
  [[gnu::always_inline]] Three<double> operator()(Four<double> const& q, double time) const {
    if (frame.axes().turned()) [[unlikely]] return by_way_of_frame(q, time);
    int const back = 3 - frame.first();
    Four<double> const outside{q[0], q[1 + back % 3], q[1 + (back + 1) % 3], q[1 + (back + 2) % 3]};
    return frame.counted(torque(outside, time));
  }

 private:
  [[gnu::noinline]] Three<double> by_way_of_frame(Four<double> const& q, double time) const {
    Eigen::Vector4d const outside = frame.leave(q);
    Three<double> const t = torque(Four<double>{outside[0], outside[1], outside[2], outside[3]}, time);
    return frame.enter(Eigen::Vector3d(t[0], t[1], t[2]));
  }
};
template <class Torque>
auto in_axes_of(MiddleAxisFrame const& frame, Torque const& torque) {
  if constexpr (requires { torque.in(frame); })
    return torque.in(frame);
  else
    return TorqueOfFrame<Torque>{torque, frame};
}

/// Steps of one body under a torque.
template <class Torque>
struct TorquedSteps {
  InverseMoments<double> const& body;
  std::vector<InverseMoments<double>> const& parts;
  KickFlight const& method;
  Torque const& torque;
  double h, kick;
  long from, count;
  TorquedPlace place;
  int terms;

  [[gnu::always_inline]] void kick_by(double part, double time, TorquedPlace& at) const {
    Three<double> const t = torque(at.q, time);
    double const c = part * kick;
    at.p = {at.p[0] + c * t[0], at.p[1] + c * t[1], at.p[2] + c * t[2]};
  }
  [[gnu::always_inline]] void operator()() {
    TorquedPlace at = place;
    int order_of_series = terms;
    std::size_t const stages = parts.size();
    double const joined = method.kicks.front() + method.kicks.back();
    kick_by(method.kicks.front(), static_cast<double>(from) * h, at);
    for (long n = 0; n < count; ++n) {
      double reached = 0;
      for (std::size_t k = 0; k < stages; ++k) {
        at = fly(body, parts[k], method.flights[k], at, order_of_series);
        reached += method.flights[k];
        bool const last = k + 1 == stages;
        double const time = last ? static_cast<double>(from + n + 1) * h : (static_cast<double>(from + n) + reached) * h;
        kick_by(last && n + 1 < count ? joined : method.kicks[k + 1], time, at);
      }
      if ((from + n) % 64 == 63) tidy(at.q);
    }
    place = at, terms = order_of_series;
  }
};

}  // namespace detail

/// A body under a torque.
///
/// @tparam Torque  (Four<double> const& attitude, double time) -> Three<double>: the torque on the body in its own axes, energy,
///                 from the unit quaternion (scalar first) that takes the body to space
template <class Torque>
class TorquedBody {
 public:
  /// @param inertia   of the body, by principal moments or in a frame of any choice; momentum and attitude are of the same frame
  /// @param momentum  body momentum at the start, energy x time
  /// @param attitude  at the start
  /// @param h         step, time, not zero; negative steps go back in time
  /// @param method    order 2 or 4: \ref strang_splitting, \ref blanes_moan_splitting
  /// @param start     time at the start
  /// @throws UnphysicalInertia, NotFinite, OutsideDomain  where a number is none, no body has such moments, or the quaternion is not near unit length
  TorquedBody(PrincipalInertia const& inertia, Momentum<SO<3>, double> const& momentum, Element<SU2, double> const& attitude, Torque const& torque, double h,
              KickFlight method = strang_splitting(), double start = 0, Machine machine = best_machine())
      : frame_(inertia, h), torque_(detail::in_axes_of(frame_.axes(), torque)), method_(std::move(method)), start_(start), machine_(machine),
        place_(frame_.enter(momentum, attitude)) {
    if (!is_finite(start)) throw NotFinite("torqued body: time at the start");
    if (method_.flights.empty() || method_.kicks.size() != method_.flights.size() + 1)
      throw OutsideDomain("torqued body", "one kick more than flights is needed; kicks", static_cast<double>(method_.kicks.size()),
                          static_cast<double>(method_.flights.size() + 1));
    for (double const c : method_.flights) parts_.push_back(detail::scaled(frame_.body(), c));
  }

  /// So many steps.
  /// @throws NotFinite      where the torque or the momentum is no number any more; the body is where it was then
  /// @throws OutsideDomain  where count is negative
  void step(long count = 1) {
    if (count < 0) throw OutsideDomain("torqued body", "the number of steps must not be negative", static_cast<double>(count), 0);
    if (count == 0) return;
    auto const shifted = [this](Four<double> const& q, double time) __attribute__((always_inline)) { return torque_(q, start_ + time); };
    detail::TorquedSteps<decltype(shifted)> steps{frame_.body(), parts_, method_, shifted, frame_.step(), frame_.kick(), steps_, count, place_, terms_};
    run_on(machine_, steps);
    if (!std::isfinite(dot(steps.place.p, steps.place.p))) throw NotFinite("torqued body: torque");
    place_ = steps.place, terms_ = steps.terms, steps_ += count;
  }

  /// Saves, or restores, what the next step depends on besides body, torque, step and method: `memory(numbers...)` takes each of them by reference.
  template <class Memory>
  void remember(Memory& memory) {
    memory(place_, terms_, steps_);
  }

  /// Momentum and attitude now.
  FreeState state() const { return frame_.leave(place_); }
  /// The time reached.
  double time() const { return start_ + static_cast<double>(steps_) * frame_.step(); }
  /// h, time.
  double step_length() const { return frame_.step(); }
  /// How kicks and flights make up a step.
  KickFlight const& method() const { return method_; }

 private:
  using TorqueInAxes = decltype(detail::in_axes_of(std::declval<MiddleAxisFrame const&>(), std::declval<Torque const&>()));

  detail::TorquedFrame frame_;
  TorqueInAxes torque_;
  KickFlight method_;
  double start_;
  Machine machine_;
  detail::TorquedPlace place_;
  std::vector<InverseMoments<double>> parts_;
  int terms_ = 5;
  long steps_ = 0;
};

}  // namespace actio
