// A rigid body under a torque, by splitting: kicks, and drifts, which are the exact flow of the free body, in
// between.
//
//     TorquedBody body(inertia, momentum, attitude, gravity_gradient(inertia, 3 * mu / (r * r * r), towards),
//     0.1); body.step(1000);
//
// After each kick the body is on another orbit, so a drift is set up anew each time: by the power series of
// short_step.hpp as long as it is short, by elliptic functions otherwise. Free motion is exact whatever the
// step; the order is that of the kicks. A torque may depend on the velocity (velocity_torque.hpp).
#pragma once

#include <Eigen/Core>

#include <type_traits>
#include <utility>

#include "actio/fast_body/machine.hpp"
#include "actio/fast_body/space/gravity_gradient.hpp"
#include "actio/fast_body/space/short_step.hpp"
#include "actio/fast_body/space/splitting.hpp"
#include "actio/fast_body/space/velocity_torque.hpp"

namespace actio::bodies {
namespace detail {

/// A body between kicks, in the axes that the drifts use: p = hM/(2I), I the unit of inertia, and the
/// attitude.
struct TorquedState {
  Three<double> p;
  Four<double> q;
};

/// Which body it is, in numbers without dimension; and from its axes to those of the drifts and back.
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
  TorquedState enter(Momentum<SO<3>, double> const& momentum, Element<SU2, double> const& attitude) const {
    if (!is_finite(momentum.components)) throw NotFinite("torqued body: body momentum");
    if (!is_finite(attitude.value)) throw NotFinite("torqued body: attitude");
    TorquedState const state{frame_.enter(Eigen::Vector3d(momentum.components / frame_.unit() * (h_ / 2))),
                             frame_.enter(restore(attitude).value)};
    if (!is_finite(dot(state.p, state.p))) throw NotFinite("torqued body: step times momentum over inertia");
    return state;
  }
  FreeState leave(TorquedState const& state) const {
    return {{SO<3>{}, frame_.leave(state.p) / (h_ / 2) * frame_.unit()},
            {SU2{}, frame_.leave(state.q).normalized()}};
  }

 private:
  double h_;
  MiddleAxisFrame frame_;
  InverseMoments<double> body_;
};

/// The same inverse moments, times c.
inline InverseMoments<double> scaled(InverseMoments<double> const& body, double c) {
  InverseMoments<double> part;
  part.J = {body.J[0] * c, body.J[1] * c, body.J[2] * c};
  part.d12 = body.d12 * c, part.d23 = body.d23 * c, part.d13 = body.d13 * c;
  return part;
}

/// A drift over the part c of a step, of any length.
/// @throws NotFinite  where the momentum is no number
[[gnu::noinline, gnu::cold]] inline TorquedState long_step(InverseMoments<double> const& body, double c,
                                                           TorquedState state) {
  double const size = std::max({std::abs(state.p[0]), std::abs(state.p[1]), std::abs(state.p[2])});
  if (!std::isfinite(size) || !std::isfinite(dot(state.p, state.p)))
    throw NotFinite("torqued body: momentum, in the course of the motion");
  if (size == 0) return state;
  Three<double> u{state.p[0] / size, state.p[1] / size, state.p[2] / size};
  double const length = std::sqrt(dot(u, u));
  for (double& x : u) x /= length;
  FrameState<double> moved{u, state.q};
  HalfTurn<double>(exact_flow<double>(body, u, c * (size * length))).step(moved);
  state.q = moved.attitude;
  for (int i = 0; i < 3; ++i) state.p[i] = size * length * moved.direction[i];
  return state;
}

/// A drift over the part c of a step; `terms` is 5 or 8, as many as the last one needed.
[[gnu::always_inline]] inline TorquedState drift(InverseMoments<double> const& body,
                                                 InverseMoments<double> const& part, double c,
                                                 TorquedState const& state, int& terms) {
  if (terms == 5) {
    TorquedState next = state;
    if (all_within<5>(short_step(StepTable<5>::get(), part, next.p, next.q))) [[likely]]
      return next;
  }
  TorquedState next = state;
  auto const reach = short_step(StepTable<8>::get(), part, next.p, next.q);
  terms = reach.turn <= short_reach<5> / 2 && reach.twist <= short_twist<5> / 2 ? 5 : 8;
  if (all_within<8>(reach)) return next;
  return long_step(body, c, state);
}

/// \f$|q|\to1\f$ without a root, for it is nearly so.
[[gnu::always_inline]] inline void tidy(Four<double>& q) {
  double const shorter = 1.5 - 0.5 * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (int i = 0; i < 4; ++i) q[i] = q[i] * shorter;
}

/// A torque in the axes in which the body is moved, by way of the frame of the body at each call.
template <class Torque>
struct TorqueOfFrame {
  Torque torque;
  MiddleAxisFrame frame;
  [[gnu::always_inline]] Three<double> operator()(Four<double> const& q, double time) const {
    if (frame.axes().turned()) [[unlikely]]
      return by_way_of_frame(q, time);
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
auto in_axes_of(TorquedFrame const& body, PrincipalInertia const& inertia, Torque const& torque) {
  MiddleAxisFrame const& frame = body.axes();
  if constexpr (TorqueOfVelocity<Torque>) {
    TorqueOfMomentum<Torque> out{torque, frame};
    Eigen::Matrix3d const inverse = inertia.inverse_tensor();
    for (int k = 0; k < 3; ++k) {
      Three<double> unit{0, 0, 0};
      unit[k] = 1;
      Eigen::Vector3d const w = inverse * frame.leave(unit) / (body.step() / 2) * frame.unit();
      for (int i = 0; i < 3; ++i) out.velocity_of[static_cast<std::size_t>(i)][k] = w[i];
    }
    return out;
  } else if constexpr (requires { torque.in(frame); }) {
    return torque.in(frame);
  } else {
    return TorqueOfFrame<Torque>{torque, frame};
  }
}

/// Steps of one body under a torque.
template <class Torque>
struct TorquedSteps {
  InverseMoments<double> const& body;
  std::vector<InverseMoments<double>> const& parts;
  Splitting const& method;
  Torque const& torque;
  double h, kick;
  long from, count;
  TorquedState state;
  int terms;

  /// Whether the torque depends on the velocity. Two kicks that meet belong to their own steps then.
  static constexpr bool of_velocity =
      requires(Torque const& t, Three<double> const& p) { t(Four<double>{}, 0.0, p, 0.0); };

  [[gnu::always_inline]] void kick_by(double part, double time, TorquedState& at) const {
    Three<double> const t = torque(at.q, time);
    double const c = part * kick;
    at.p = {at.p[0] + c * t[0], at.p[1] + c * t[1], at.p[2] + c * t[2]};
  }
  /// The same in the n-th step.
  [[gnu::always_inline]] void kick_in(long n, double part, double time, TorquedState& at) const {
    if constexpr (of_velocity)
      at.p = gauss_kick(
          [&](Three<double> const& p) { return torque(at.q, time, p, (static_cast<double>(n) + 0.5) * h); },
          part * kick, at.p);
    else
      kick_by(part, time, at);
  }
  [[gnu::always_inline]] void operator()() {
    TorquedState at = state;
    int order_of_series = terms;
    std::size_t const stages = parts.size();
    double const joined = method.kicks.front() + method.kicks.back();
    kick_in(from, method.kicks.front(), static_cast<double>(from) * h, at);
    for (long n = 0; n < count; ++n) {
      double reached = 0;
      for (std::size_t k = 0; k < stages; ++k) {
        at = drift(body, parts[k], method.drifts[k], at, order_of_series);
        reached += method.drifts[k];
        bool const last = k + 1 == stages;
        double const time =
            last ? static_cast<double>(from + n + 1) * h : (static_cast<double>(from + n) + reached) * h;
        bool const another = last && n + 1 < count;
        kick_in(from + n, another && !of_velocity ? joined : method.kicks[k + 1], time, at);
        if (of_velocity && another) kick_in(from + n + 1, method.kicks.front(), time, at);
      }
      if ((from + n) % 64 == 63) tidy(at.q);
    }
    state = at, terms = order_of_series;
  }
};

}  // namespace detail

/// A body under a torque.
///
/// \snippet bodies.cpp torqued_body
/// @tparam Torque  (Four<double> const& attitude, double time) -> Three<double>: the torque on the body in
///                 its own axes, energy, from the unit quaternion (scalar first) that takes the body to
///                 space; or a TorqueOfVelocity, with a splitting that is not of Runge-Kutta-Nystrom type
template <class Torque>
class TorquedBody {
 public:
  /// @param inertia   of the body, by principal moments or in a frame of any choice; momentum and attitude
  ///                  are of the same frame
  /// @param momentum  body momentum at the start, energy x time
  /// @param attitude  at the start
  /// @param h         step, time, not zero; negative steps go back in time
  /// @param method    order 2 or 4: \ref strang_splitting, \ref blanes_moan_splitting
  /// @param start     time at the start
  /// @throws UnphysicalInertia, NotFinite, OutsideDomain where a number is none, no body has such moments, or
  ///         the quaternion is not near unit length
  TorquedBody(PrincipalInertia const& inertia, Momentum<SO<3>, double> const& momentum,
              Element<SU2, double> const& attitude, Torque const& torque, double h,
              Splitting method = strang_splitting(), double start = 0)
      : frame_(inertia, h),
        torque_(detail::in_axes_of(frame_, inertia, torque)),
        method_(std::move(method)),
        start_(start),
        state_(frame_.enter(momentum, attitude)) {
    if (!is_finite(start)) throw NotFinite("torqued body: time at the start");
    if (method_.drifts.empty() || method_.kicks.size() != method_.drifts.size() + 1)
      throw OutsideDomain("torqued body", "one kick more than drifts is needed; kicks",
                          static_cast<double>(method_.kicks.size()),
                          static_cast<double>(method_.drifts.size() + 1));
    for (double const c : method_.drifts) parts_.push_back(detail::scaled(frame_.body(), c));
  }

  /// So many steps.
  /// @throws NotFinite      where the torque or the momentum is no number any more; the body is where it was
  ///                        then
  /// @throws OutsideDomain  where count is negative
  void step(long count = 1) {
    if (count < 0)
      throw OutsideDomain("torqued body", "the number of steps must not be negative",
                          static_cast<double>(count), 0);
    if (count == 0) return;
    auto const run = [&](auto const& shifted) {
      detail::TorquedSteps<std::decay_t<decltype(shifted)>> all{
          frame_.body(), parts_, method_, shifted, frame_.step(),
          frame_.kick(), steps_, count,   state_,  terms_};
      run_on_best_machine(all);
      return all;
    };
    auto const steps = [&] {
      if constexpr (TorqueOfVelocity<Torque>)
        return run([this](Four<double> const& q, double time, Three<double> const& p, double middle) {
          return torque_(q, start_ + time, p, start_ + middle);
        });
      else
        return run([this](Four<double> const& q, double time)
                       __attribute__((always_inline)) { return torque_(q, start_ + time); });
    }();
    if (!std::isfinite(dot(steps.state.p, steps.state.p))) throw NotFinite("torqued body: torque");
    state_ = steps.state, terms_ = steps.terms, steps_ += count;
  }

  /// Saves, or restores, what the next step depends on besides body, torque, step and method:
  /// `memory(numbers...)` takes each of them by reference.
  template <class Memory>
  void remember(Memory& memory) { memory(state_, terms_, steps_); }

  /// Momentum and attitude now.
  FreeState state() const { return frame_.leave(state_); }
  /// The time reached.
  double time() const { return start_ + static_cast<double>(steps_) * frame_.step(); }
  /// h, time.
  double step_length() const { return frame_.step(); }
  /// How kicks and drifts make up a step.
  Splitting const& method() const { return method_; }

 private:
  using TorqueInAxes =
      decltype(detail::in_axes_of(std::declval<detail::TorquedFrame const&>(),
                                  std::declval<PrincipalInertia const&>(), std::declval<Torque const&>()));

  detail::TorquedFrame frame_;
  TorqueInAxes torque_;
  Splitting method_;
  double start_;
  detail::TorquedState state_;
  std::vector<InverseMoments<double>> parts_;
  int terms_ = 5;
  long steps_ = 0;
};

}  // namespace actio::bodies
