// Steps of two bodies as a kernel: the state in the axes of the bodies, drifts and kicks. TwoBodies is the
// class for users.
#pragma once

#include <vector>

#include "actio/two_bodies/nearest_approach.hpp"
#include "actio/two_bodies/pair_method.hpp"
#include "actio/two_bodies/rotor_drift.hpp"
#include "actio/two_bodies/second_order_force.hpp"

namespace actio::bodies {

/// A vector as a sum of very many changes, with the rounding error of the sum so far (Kahan).
template <class T, std::size_t N>
struct Summed {
  std::array<T, N> value{};  ///< the sum, rounded
  std::array<T, N> rest{};   ///< what is to be added to it
  /// Adds a small change.
  [[gnu::always_inline]] void add(std::array<T, N> const& change) {
    for (std::size_t i = 0; i < N; ++i) {
      T const y = change[i] + rest[i], next = value[i] + y;
      rest[i] = y - (next - value[i]);
      value[i] = next;
    }
  }
};

/// Two bodies between steps. The momenta of the bodies are pure numbers, p = hM/(2I) with a unit I of inertia
/// for each.
template <class T>
struct PairState {
  Summed<T, 3> position;    ///< of the second from the first, in space
  Summed<T, 3> momentum;    ///< reduced mass times velocity
  Summed<T, 3> body_1;      ///< p of the first body, in its axes
  Summed<T, 3> body_2;      ///< p of the second body, in its axes
  Summed<T, 4> attitude_1;  ///< unit quaternion, first body to space
  Summed<T, 4> attitude_2;  ///< unit quaternion, second body to space
};

/// A drift and the kick after it, by their parts of a step.
/// @tparam C  double, or a pack of pairs of bodies
template <class C>
struct PairStage {
  double time;               ///< by which drift and time go on
  double kick;               ///< time of the kick
  InverseMoments<C> body_1;  ///< inverse moments of the first body times the part of the step
  InverseMoments<C> body_2;  ///< inverse moments of the second body times the part of the step
};

/// What all stages share.
/// @tparam C  double, or a pack of pairs of bodies
template <class C>
struct PairSetting {
  C reduced_mass;  ///< \f$m_1m_2/(m_1+m_2)\f$
  C mu;            ///< \f$G(m_1+m_2)\f$
  C strength;      ///< \f$Gm_1m_2\f$
  C unit_1;        ///< a torque times a time times this is a change of p of the first body
  C unit_2;        ///< the same of the second body
  C radii;         ///< both radii added up
};

namespace detail {

/// \f$|q|\to1\f$ without a root, for it is nearly so.
template <class T>
[[gnu::always_inline]] inline void tidy(Summed<T, 4>& q) {
  T square{};
  for (int i = 0; i < 4; ++i) square += q.value[i] * (q.value[i] + 2.0 * q.rest[i]);
  T const longer = 0.5 - 0.5 * square;
  q.add({longer * q.value[0], longer * q.value[1], longer * q.value[2], longer * q.value[3]});
}
template <class T>
[[gnu::always_inline]] inline void turn(Summed<T, 3>& p, Summed<T, 4>& q, RotorMotion<T> const& motion) {
  q.add(compose(q.value, motion.turn));
  p.add(motion.change);
}

template <class T, class Force>
struct PairSteps {
  PairSetting<Base<T>> const& setting;
  bool kepler;         ///< whether drifts follow Kepler's orbits
  bool moser_veselov;  ///< whether bodies turn by the scheme of Moser and Veselov
  std::vector<PairStage<Base<T>>> const&
      stages;  ///< of a step, and one more: the last drift with the first of the next
  double first_kick, last_kick;
  Force const& force;
  double h, start;
  long from, count;
  PairState<T> state;
  int terms_1, terms_2;
  /// of the least distance in all drifts so far; of dual numbers it is not followed
  Base<T> nearest_square = std::numeric_limits<double>::infinity();

  [[gnu::always_inline]] void kick(double part, double time, PairState<T>& at) const {
    auto const k = force(at.position.value, at.attitude_1.value, at.attitude_2.value, time);
    Three<T> push = k.force;
    if (!kepler) {
      T const pull = -setting.strength * (k.inverse * k.inverse * k.inverse);
      for (int i = 0; i < 3; ++i) push[i] += pull * at.position.value[i];
    }
    auto const c1 = part * setting.unit_1, c2 = part * setting.unit_2;
    at.momentum.add({part * push[0], part * push[1], part * push[2]});
    at.body_1.add({c1 * k.torque_1[0], c1 * k.torque_1[1], c1 * k.torque_1[2]});
    at.body_2.add({c2 * k.torque_2[0], c2 * k.torque_2[1], c2 * k.torque_2[2]});
  }
  /// Follows the least distance through a drift.
  /// @param x,v   position and velocity at its start
  /// @param at    the state at its end
  /// @param time  that it takes
  /// @param least the square of the least distance
  [[gnu::always_inline]] void follow_distance(Three<double> const& x, Three<double> const& v,
                                              PairState<double> const& at, double time, double& least) const {
    follow_distance(x, v, at.position.value, at.momentum.value, time, setting.mu, least);
  }
  [[gnu::always_inline]] void follow_distance(Three<double> const& x, Three<double> const& v,
                                              Three<double> const& y, Three<double> const& w, double time,
                                              double mu, double& least) const {
    least = std::min(least, dot(y, y));
    if (may_pass_the_nearest(x, v, y, w, time, kepler, mu)) [[unlikely]]
      least = std::min(least, kepler ? square_in_pericentre(x, v, y, w, time, mu) : square_at_foot(x, v));
  }
  /// The same in lanes, where one of them may come within the radii: outside of them no body is faster than
  /// on the way down to them.
  template <int n>
  [[gnu::always_inline]] void follow_distance(Three<Pack<n>> const& x, Three<Pack<n>> const& v,
                                              PairState<Pack<n>> const& at, double time,
                                              Pack<n>& least) const {
    Pack<n> const R = setting.radii, fastest = dot(v, v) + 2.0 * setting.mu / R;
    if (2.0 * (R * R + time * time * fastest) < dot(x, x)) [[likely]]
      return;
    for (int k = 0; k < n; ++k) {
      double nearest = in_lane<double>(least, k);
      follow_distance(in_lane<Three<double>>(x, k), in_lane<Three<double>>(v, k),
                      in_lane<Three<double>>(at.position.value, k),
                      in_lane<Three<double>>(at.momentum.value, k), time, in_lane<double>(setting.mu, k),
                      nearest);
      set_lane(least, k, nearest);
    }
  }
  [[gnu::always_inline]] void drift(PairStage<Base<T>> const& stage, PairState<T>& at, int& terms_of_1,
                                    int& terms_of_2, Base<T>& least) const {
    T const inverse = T{} + 1.0 / setting.reduced_mass;
    Three<T> const& P = at.momentum.value;
    Three<T> const v{inverse * P[0], inverse * P[1], inverse * P[2]}, x = at.position.value;
    if (kepler) {
      auto const d = kepler_drift<T>(x, v, T{} + setting.mu, T{} + stage.time);
      auto const m = setting.reduced_mass;
      at.position.add(d.position);
      at.momentum.add({m * d.velocity[0], m * d.velocity[1], m * d.velocity[2]});
    } else {
      at.position.add({stage.time * v[0], stage.time * v[1], stage.time * v[2]});
    }
    if constexpr (!is_dual<T>) follow_distance(x, v, at, stage.time, least);
    if constexpr (!is_pack<Base<T>>)
      if (moser_veselov) [[unlikely]] {
        turn(at.body_1, at.attitude_1, moser_veselov_rotor<T>(stage.body_1, at.body_1.value));
        turn(at.body_2, at.attitude_2, moser_veselov_rotor<T>(stage.body_2, at.body_2.value));
        return;
      }
    turn(at.body_1, at.attitude_1, exact_rotor<T>(stage.body_1, at.body_1.value, terms_of_1));
    turn(at.body_2, at.attitude_2, exact_rotor<T>(stage.body_2, at.body_2.value, terms_of_2));
  }

  [[gnu::always_inline]] void operator()() {
    PairState<T> at = state;
    int t1 = terms_1, t2 = terms_2;
    Base<T> least = nearest_square;
    int const size = static_cast<int>(stages.size()) - 1;
    bool const drift_first = first_kick == 0;
    for (long n = 0; n < count; ++n) {
      double reached = start + double(from + n) * h;
      bool const last = n + 1 == count;
      // Before the first step its kick, without a drift.
      for (int k = n == 0 && !drift_first ? -1 : 0; k < size; ++k) {
        bool const end = k + 1 == size, joined = end && !last;
        double part = first_kick;
        if (k >= 0) {
          if (!drift_first || k > 0 || n == 0)
            drift(drift_first && joined ? stages[size] : stages[k], at, t1, t2, least);
          reached = end ? start + double(from + n + 1) * h : reached + stages[k].time;
          part = !end ? stages[k].kick : joined && !drift_first ? first_kick + last_kick : last_kick;
        }
        if (part != 0) kick(part, reached, at);
      }
      if ((from + n) % 64 == 63) tidy(at.attitude_1), tidy(at.attitude_2);
    }
    state = at, terms_1 = t1, terms_2 = t2, nearest_square = least;
  }
};

}  // namespace detail
}  // namespace actio::bodies
