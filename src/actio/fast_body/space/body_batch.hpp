// Many free bodies, stepped exactly, several at once.
//
//     BodyBatch batch(inertias, momenta, attitudes, 0.01);
//     for (auto const& bad : batch.refused()) std::cerr << bad.what() << '\n';   // the others are stepped
//     batch.step(1000);
//     auto const M = batch.momentum(7);
//     auto const g = batch.attitude(7);
//
// What a step does is told in body_lanes.hpp; a batch holds the lanes, and what a step does not need.
#pragma once

#include <memory>
#include <vector>

#include "actio/fast_body/space/body_lanes.hpp"
#include "actio/fast_body/space/free_body.hpp"

namespace actio {

/// A body of a batch that cannot be stepped: which one, and why.
struct BodyRefused : Error {
  std::size_t index;  ///< of the body in the batch
  /// @param which  index of the body
  BodyRefused(std::size_t which, std::string const& why)
      : Error("body " + std::to_string(which) + ": " + why), index(which) {}
};

namespace detail {
/// The unit quaternion of the rotation with the columns u, w, u x w.
inline Eigen::Vector4d frame_quaternion(Three<double> const& u, Three<double> const& w) {
  Three<double> const x{u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]};
  double const a = u[0], b = w[1], c = x[2];
  // The largest of the four first: its square is at least 1/4 of the sum.
  Eigen::Vector4d q;
  if (a + b + c > 0)
    q = {1 + a + b + c, w[2] - x[1], x[0] - u[2], u[1] - w[0]};
  else if (a >= b && a >= c)
    q = {w[2] - x[1], 1 + a - b - c, u[1] + w[0], u[2] + x[0]};
  else if (b >= c)
    q = {x[0] - u[2], u[1] + w[0], 1 - a + b - c, w[2] + x[1]};
  else
    q = {u[1] - w[0], u[2] + x[0], w[2] + x[1], 1 - a - b + c};
  return q.normalized();
}
}  // namespace detail

/// Free bodies in steps of one length, each step exact.
///
/// A body that cannot be stepped has an index of its own: its entry stays empty, it is in \ref refused, and
/// asking for its state throws.
///
/// Accuracy: each step is exact to a few roundings. Next to the separatrix a rounding grows as fast as the
/// motion leaves the middle axis, and a batch does not go back to the orbit for it as `FreeSteps` does: a
/// body that is let go within 1e-5 of that axis may be off by 1e-5 after a few turns over. The function `at`
/// of a `FreeBody` has no such trouble.
class BodyBatch {
 public:
  /// An empty batch.
  /// @param h        step, time, not zero; negative steps go back in time
  /// @param machine  what to compute with
  /// @throws NotFinite, OutsideDomain  where h is no number, or zero
  explicit BodyBatch(double h, Machine machine = best_machine()) : h_(h), machine_(machine) {
    if (!is_finite(h)) throw NotFinite("batch: step");
    if (h == 0) throw OutsideDomain("batch", "the step must differ from zero", 0, 0);
  }
  /// @param inertias  of the bodies
  /// @param momenta    body momenta at the start, as many; energy x time
  /// @param attitudes  unit quaternions, body to space, as many
  /// @throws OutsideDomain  where the lists are not of one length
  BodyBatch(std::vector<Inertia<3>> const& inertias, std::vector<Momentum<SO<3>, double>> const& momenta,
            std::vector<Element<SU2, double>> const& attitudes, double h, Machine machine = best_machine())
      : BodyBatch(h, machine) {
    if (momenta.size() != inertias.size() || attitudes.size() != inertias.size())
      throw OutsideDomain(
          "batch", "as many momenta and attitudes as bodies are needed; the length that is off",
          static_cast<double>(momenta.size() != inertias.size() ? momenta.size() : attitudes.size()),
          static_cast<double>(inertias.size()));
    for (std::size_t i = 0; i < inertias.size(); ++i) try {
        add(inertias[i], momenta[i], attitudes[i]);
      } catch (BodyRefused const& why) {
        refused_.push_back(why);
        leave_out();
      }
  }

  /// One more body, at its start now. @return its index
  /// @throws BodyRefused  where it cannot be stepped, with the index that it would have had; the batch is as
  ///   before
  std::size_t add(Inertia<3> const& inertia, Momentum<SO<3>, double> const& momentum,
                  Element<SU2, double> const& attitude = identity<double>(SU2{})) {
    try {
      inertia_from_moments(inertia.moments);
      FreeBody const body(inertia, momentum, attitude);
      put(body, body.step_parameters(h_));
    } catch (BodyRefused const&) {
      throw;
    } catch (Error const& error) {
      throw BodyRefused(size(), error.what());
    }
    return size() - 1;
  }

  /// How many bodies, refused ones included.
  std::size_t size() const { return cold_.size(); }
  /// The bodies that the constructor could not take.
  std::vector<BodyRefused> const& refused() const { return refused_; }
  /// h, time.
  double step_length() const { return h_; }
  /// How far the batch is, from its own start.
  double time() const { return static_cast<double>(steps_) * h_; }
  /// For which machine its loops run.
  Machine machine() const { return machine_; }

  /// Momenta and attitudes, so many steps on.
  /// @throws OutsideDomain  where count is negative, or after \ref step_momentum, after which the attitudes
  ///   are unknown
  void step(long count = 1) {
    require_attitudes();
    run<true>(count);
  }
  /// Momenta alone, so many steps on: nothing of the attitudes is computed, and they cannot be asked for any
  /// more.
  /// @throws OutsideDomain  where count is negative
  void step_momentum(long count = 1) {
    run<false>(count);
    if (count > 0) attitudes_ = false;
  }

  /// Body momentum, energy x time.
  /// @throws BodyRefused, OutsideDomain  where there is no such body
  Momentum<SO<3>, double> momentum(std::size_t i) const {
    return cold(i).body->state({normalized(entry(lanes_[i / 4].u, i % 4)), {1, 0, 0, 0}}).body_momentum;
  }
  /// Attitude, body to space; of the two quaternions the one with a positive scalar part.
  /// @throws BodyRefused, OutsideDomain  where there is no such body, or after \ref step_momentum
  Element<SU2, double> attitude(std::size_t i) const {
    Cold const& c = cold(i);
    require_attitudes();
    auto const n = static_cast<double>(steps_ - c.since);
    double const turned = n * c.twist, lost = std::fma(n, c.twist, -turned);
    Eigen::Vector4d const twist(std::cos(turned) - lost * std::sin(turned),
                                std::sin(turned) + lost * std::cos(turned), 0, 0);
    Eigen::Vector4d q =
        SU2::compose<double>(SU2::compose<double>(c.frame, twist), SU2::inverse<double>(frame(i)));
    if (q[0] < 0) q = -q;
    return c.body->state({normalized(entry(lanes_[i / 4].u, i % 4)), {q[0], q[1], q[2], q[3]}}).attitude;
  }

 private:
  using Lanes = Pack<4>;
  /// What a step does not need.
  struct Cold {
    std::shared_ptr<FreeBody const> body;  ///< none where it was refused
    Eigen::Vector4d frame{1, 0, 0, 0};     ///< attitude of the frame (u, w, u x w) at the start
    double twist = 0;                      ///< T
    long since = 0;                        ///< the step it came in
  };

  static Three<double> entry(Three<Lanes> const& x, std::size_t lane) {
    int const l = static_cast<int>(lane);
    return {x[0][l], x[1][l], x[2][l]};
  }
  static Three<double> normalized(Three<double> u) {
    double const length = std::sqrt(dot(u, u));
    for (double& x : u) x /= length;
    return u;
  }
  Eigen::Vector4d frame(std::size_t i) const {
    Three<double> const u = normalized(entry(lanes_[i / 4].u, i % 4));
    Three<double> w = entry(lanes_[i / 4].w, i % 4);
    double const beside = dot(u, w);
    for (int k = 0; k < 3; ++k) w[k] -= beside * u[k];
    return detail::frame_quaternion(u, normalized(w));
  }
  Cold const& cold(std::size_t i) const {
    if (i >= size())
      throw OutsideDomain("batch", "no such body; index", static_cast<double>(i),
                          static_cast<double>(size()));
    if (!cold_[i].body)
      for (auto const& why : refused_)
        if (why.index == i) throw why;
    return cold_[i];
  }
  void require_attitudes() const {
    if (!attitudes_)
      throw OutsideDomain("batch", "step_momentum has left the attitudes behind; attitudes that are known", 0,
                          1);
  }

  /// A lane that stands still.
  void leave_out() {
    std::size_t const i = size();
    if (i % 4 == 0) lanes_.emplace_back();
    detail::FreeLanes& lanes = lanes_[i / 4];
    for (int l = static_cast<int>(i % 4); l < 4; ++l)
      for (int k = 0; k < 3; ++k) {
        lanes.u[k].set(l, k == 0), lanes.w[k].set(l, k == 1);
        lanes.stretch[k].set(l, 1), lanes.shear[k].set(l, 0), lanes.delta[k].set(l, 0),
            lanes.sum[k].set(l, 0);
        lanes.product.set(l, 0), lanes.newton.set(l, 1);
      }
    cold_.push_back({nullptr, {1, 0, 0, 0}, 0, steps_});
  }
  void put(FreeBody const& body, StepParameters<double> const& parameters) {
    Three<double> const& u = body.start().direction;
    // At right angles to u: the part of the axis that is farthest from it.
    int const far = std::abs(u[0]) <= std::abs(u[1]) && std::abs(u[0]) <= std::abs(u[2]) ? 0
                    : std::abs(u[1]) <= std::abs(u[2])                                   ? 1
                                                                                         : 2;
    Three<double> w{-u[far] * u[0], -u[far] * u[1], -u[far] * u[2]};
    w[far] += 1;
    w = normalized(w);
    Three<double> const& stretch = parameters.stretch;
    Three<double> const& d = parameters.delta;
    double const product = d[0] * d[1] * d[2], newton = 1 / (1 + d[0] * d[1] + d[1] * d[2] + d[2] * d[0]);
    if (!std::isfinite(dot(stretch, stretch) + dot(parameters.gap, parameters.gap) + product + newton))
      throw NotFinite("free body: parameters of a step");
    leave_out();
    std::size_t const i = size() - 1;
    int const l = static_cast<int>(i % 4);
    detail::FreeLanes& lanes = lanes_[i / 4];
    lanes.product.set(l, product), lanes.newton.set(l, newton);
    for (int k = 0; k < 3; ++k) {
      lanes.u[k].set(l, u[k]), lanes.w[k].set(l, w[k]);
      lanes.stretch[k].set(l, stretch[k]), lanes.shear[k].set(l, parameters.gap[k]),
          lanes.delta[k].set(l, d[k]);
      lanes.sum[k].set(l, d[(k + 1) % 3] + d[(k + 2) % 3]);
      lanes.gentle = lanes.gentle && std::abs(parameters.delta[k]) <= 1;
    }
    auto const& q = body.start().attitude;
    cold_[i].body = std::make_shared<FreeBody const>(body);
    cold_[i].frame = SU2::compose<double>({q[0], q[1], q[2], q[3]}, frame(i));
    cold_[i].twist = std::atan2(parameters.sin_twist, parameters.cos_twist);
  }

  template <bool attitude>
  void run(long count) {
    if (count < 0)
      throw OutsideDomain("batch", "the number of steps must not be negative", static_cast<double>(count), 0);
    std::size_t k = 0;
    for (; k + 4 <= lanes_.size(); k += 4) run_packs<4, attitude>(k, count);
    for (; k + 2 <= lanes_.size(); k += 2) run_packs<2, attitude>(k, count);
    for (; k < lanes_.size(); ++k) run_packs<1, attitude>(k, count);
    steps_ += count;
  }
  template <int packs, bool attitude>
  void run_packs(std::size_t first, long count) {
    bool gentle = true;
    for (std::size_t k = first; k < first + packs; ++k) gentle = gentle && lanes_[k].gentle;
    if (gentle) {
      detail::LaneSteps<packs, attitude, true> steps{&lanes_[first], steps_, count};
      run_on(machine_, steps);
    } else {
      detail::LaneSteps<packs, attitude, false> steps{&lanes_[first], steps_, count};
      run_on(machine_, steps);
    }
  }

  double h_;
  Machine machine_;
  std::vector<detail::FreeLanes> lanes_;
  std::vector<Cold> cold_;
  std::vector<BodyRefused> refused_;
  long steps_ = 0;
  bool attitudes_ = true;
};

}  // namespace actio
