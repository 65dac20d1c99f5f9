// Many bodies under the torque of gravity, several at once: the steps of torqued_body.hpp in the lanes of
// SIMD registers.
//
// A lane whose drift is too long for the series of its neighbours is computed by itself, and put back.
#pragma once

#include <algorithm>
#include <memory>
#include <tuple>
#include <vector>

#include "actio/fast_body/space/body_batch.hpp"
#include "actio/fast_body/space/torqued_body.hpp"

namespace actio::bodies {
namespace detail {

/// Four bodies under gravity.
struct TorquedLanes {
  using Lanes = Pack<4>;
  Three<Lanes> p;
  Four<Lanes> q;
  InverseMoments<Lanes> body;
  Three<Lanes> coefficients;  ///< of the torque, times what a kick multiplies it with
  Three<Lanes> towards, ahead;
  Lanes rate;           ///< times the step
  Lanes cosine, sine;   ///< of the angle that the direction has gone round by
  bool orbits = false;  ///< whether a rate differs from zero
};

/// One lane of a bundle.
template <std::size_t n>
std::array<double, n> lane_of(std::array<Pack<4>, n> const& x, int l) {
  std::array<double, n> y;
  for (std::size_t i = 0; i < n; ++i) y[i] = x[i][l];
  return y;
}
template <std::size_t n>
void set_lane(std::array<Pack<4>, n>& x, int l, std::array<double, n> const& y) {
  for (std::size_t i = 0; i < n; ++i) x[i].set(l, y[i]);
}

/// The drift of each lane by itself. A momentum that is no number any more stays: its body is refused after
/// the run.
[[gnu::noinline, gnu::cold]] void drift_apart(TorquedLanes const& c, double part, Three<Pack<4>>& p,
                                              Four<Pack<4>>& q);

/// Steps of four bodies.
template <bool orbits>
struct TorquedLaneSteps {
  using Lanes = Pack<4>;
  TorquedLanes& lanes;
  Splitting const& method;
  long from, count;

  /// The angle at the beginning, from the number of steps: what is multiplied up from there has no time to go
  /// astray.
  void place_direction(double steps) {
    for (int l = 0; l < 4; ++l) {
      lanes.cosine.set(l, std::cos(lanes.rate[l] * steps));
      lanes.sine.set(l, std::sin(lanes.rate[l] * steps));
    }
  }
  /// Turned on by so many steps.
  [[gnu::always_inline]] static void turn(Lanes& cosine, Lanes& sine, Lanes const& c, Lanes const& s) {
    Lanes const next = cosine * c - sine * s;
    sine = sine * c + cosine * s;
    cosine = next;
  }
  [[gnu::always_inline]] void kick(double part, Lanes const& cosine, Lanes const& sine, Three<Lanes>& p,
                                   Four<Lanes> const& q) const {
    auto const& [to, ahead] = std::tie(lanes.towards, lanes.ahead);
    Three<Lanes> t;
    if constexpr (orbits)
      t = GravityGradient::of_direction<Lanes>(
          lanes.coefficients, q,
          {cosine * to[0] + sine * ahead[0], cosine * to[1] + sine * ahead[1],
           cosine * to[2] + sine * ahead[2]});
    else
      t = GravityGradient::of_direction<Lanes>(lanes.coefficients, q, to);
    p = {p[0] + part * t[0], p[1] + part * t[1], p[2] + part * t[2]};
  }
  [[gnu::always_inline]] void operator()() {
    long const between = 64;
    for (long done = 0; done < count; done += between) {
      if constexpr (orbits) place_direction(static_cast<double>(from + done));
      run(std::min(between, count - done), done == 0, done + between >= count);
    }
  }
  /// Steps in a row. A kick between two rows is given by the first of them.
  [[gnu::always_inline]] void run(long steps, bool first, bool last) {
    std::size_t const stages = method.drifts.size();
    double const joined = method.kicks.front() + method.kicks.back();
    auto const& table = StepTable<5, Lanes>::get();
    Three<Lanes> p = lanes.p;
    Four<Lanes> q = lanes.q;
    Lanes cosine = lanes.cosine, sine = lanes.sine;
    if (first) kick(method.kicks.front(), cosine, sine, p, q);
    for (long n = 1; n <= steps; ++n)
      for (std::size_t k = 0; k < stages; ++k) {
        Three<Lanes> next_p = p;
        Four<Lanes> next_q = q;
        bool const short_enough = all_within<5>(short_step(table, parts[k], next_p, next_q));
        if (short_enough) [[likely]] {
          p = next_p, q = next_q;
        } else {
          // In copies, so that the others need not be in memory.
          Three<Lanes> apart_p = p;
          Four<Lanes> apart_q = q;
          drift_apart(lanes, method.drifts[k], apart_p, apart_q);
          p = apart_p, q = apart_q;
        }
        if constexpr (orbits) turn(cosine, sine, rotation[2 * k], rotation[2 * k + 1]);
        kick(k + 1 < stages || (last && n == steps) ? method.kicks[k + 1] : joined, cosine, sine, p, q);
      }
    tidy(q);
    lanes.p = p, lanes.q = q, lanes.cosine = cosine, lanes.sine = sine;
  }

  std::vector<InverseMoments<Lanes>> const& parts;  ///< of the drifts
  /// cosine and sine of what the direction turns by in each of them
  std::vector<Lanes> rotation{};
};

}  // namespace detail

/// Bodies under the torque of gravity, in steps of one length.
///
/// A body that cannot be stepped has an index of its own: its entry stays empty, it is in \ref refused, and
/// asking for its state throws. So does one whose momentum becomes too large for a number, from then on.
class TorquedBatch {
 public:
  /// An empty batch.
  /// @param h       step, time, not zero; negative steps go back in time
  /// @param method  as of \ref TorquedBody
  /// @throws NotFinite, OutsideDomain  where h is no number, or zero
  explicit TorquedBatch(double h, Splitting method = strang_splitting(), Machine machine = best_machine());
  /// @throws OutsideDomain  where the lists are not of one length
  TorquedBatch(std::vector<Inertia<3>> const& inertias, std::vector<Momentum<SO<3>, double>> const& momenta,
               std::vector<Element<SU2, double>> const& attitudes,
               std::vector<GravityGradient> const& torques, double h, Splitting method = strang_splitting(),
               Machine machine = best_machine());

  /// One more body, from now on. @return its index
  /// @throws BodyRefused  where it cannot be stepped, with the index that it would have had; the batch is as
  ///   before
  std::size_t add(Inertia<3> const& inertia, Momentum<SO<3>, double> const& momentum,
                  Element<SU2, double> const& attitude, GravityGradient const& torque);

  std::size_t size() const { return frames_.size(); }
  /// The bodies that were refused at the start, or in the course of the motion.
  std::vector<BodyRefused> const& refused() const { return refused_; }
  /// h, time.
  double step_length() const { return h_; }
  /// The time reached.
  double time() const { return static_cast<double>(steps_) * h_; }

  /// So many steps.
  /// @throws OutsideDomain  where count is negative
  void step(long count = 1);
  /// Momentum and attitude.
  /// @throws BodyRefused, OutsideDomain  where there is no such body
  FreeState state(std::size_t i) const;

 private:
  using Lanes = Pack<4>;

  /// A sphere at rest, without a torque.
  void empty(std::size_t i);
  void leave_out();
  void put(detail::TorquedFrame const& frame, detail::TorquedState const& state,
           GravityGradient const& torque, Three<double> const& coefficients);
  template <bool orbits>
  void run(detail::TorquedLanes& lanes, long count) {
    parts_.resize(method_.drifts.size());
    for (std::size_t k = 0; k < parts_.size(); ++k)
      parts_[k] = detail::scaled<Lanes>(lanes.body, method_.drifts[k]);
    detail::TorquedLaneSteps<orbits> steps{lanes, method_, steps_, count, parts_};
    if constexpr (orbits)
      for (double const part : method_.drifts) {
        Lanes c, s;
        for (int l = 0; l < 4; ++l)
          c.set(l, std::cos(part * lanes.rate[l])), s.set(l, std::sin(part * lanes.rate[l]));
        steps.rotation.push_back(c), steps.rotation.push_back(s);
      }
    run_on(machine_, steps);
  }

  double h_;
  Splitting method_;
  Machine machine_;
  std::vector<detail::TorquedLanes> lanes_;
  std::vector<std::shared_ptr<detail::TorquedFrame const>> frames_;
  std::vector<BodyRefused> refused_;
  std::vector<InverseMoments<Lanes>> parts_;  ///< for the four bodies at work
  long steps_ = 0;
};

}  // namespace actio::bodies
