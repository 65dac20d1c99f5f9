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

#include <Eigen/Core>

#include <memory>
#include <vector>

#include "actio/fast_body/space/body_lanes.hpp"
#include "actio/fast_body/space/free_body.hpp"

namespace actio::bodies {

/// A body of a batch that cannot be stepped: which one, and why.
struct BodyRefused : Error {
  std::size_t index;  ///< of the body in the batch
  /// @param which  index of the body
  BodyRefused(std::size_t which, std::string const& why)
      : Error("body " + std::to_string(which) + ": " + why), index(which) {}
};

namespace detail {
/// The unit quaternion of the rotation with the columns u, w, u x w.
Eigen::Vector4d frame_quaternion(Three<double> const& u, Three<double> const& w);
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
  explicit BodyBatch(double h, Machine machine = best_machine());
  /// @param inertias  of the bodies
  /// @param momenta    body momenta at the start, as many; energy x time
  /// @param attitudes  unit quaternions, body to space, as many
  /// @throws OutsideDomain  where the lists are not of one length
  BodyBatch(std::vector<Inertia<3>> const& inertias, std::vector<Momentum<SO<3>, double>> const& momenta,
            std::vector<Element<SU2, double>> const& attitudes, double h, Machine machine = best_machine());

  /// One more body, at its start now. @return its index
  /// @throws BodyRefused  where it cannot be stepped, with the index that it would have had; the batch is as
  ///   before
  std::size_t add(Inertia<3> const& inertia, Momentum<SO<3>, double> const& momentum,
                  Element<SU2, double> const& attitude = identity<double>(SU2{}));

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
  Element<SU2, double> attitude(std::size_t i) const;

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
  Eigen::Vector4d frame(std::size_t i) const;
  Cold const& cold(std::size_t i) const;
  void require_attitudes() const {
    if (!attitudes_)
      throw OutsideDomain("batch", "step_momentum has left the attitudes behind; attitudes that are known", 0,
                          1);
  }

  /// A lane that stands still.
  void leave_out();
  void put(FreeBody const& body, StepParameters<double> const& parameters);

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

}  // namespace actio::bodies
