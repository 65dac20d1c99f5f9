#include <Eigen/Core>

#include "program/systems/bodies/free_motion_n.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <type_traits>

#include "actio/fast_body/any_dimension/natural_chart_n.hpp"
#include "actio/reduction/composition.hpp"

namespace actio::scene {
namespace {

using Group = SO<Eigen::Dynamic>;
using Eigen::MatrixXd;

/// One scheme for each length that the substeps of a composition have, in the order of the substeps.
template <class Scheme>
class Substeps {
 public:
  /// @param make  a scheme with steps of a given length
  template <class Make>
  Substeps(std::vector<double> const& fractions, double step, Make const& make) {
    std::vector<double> lengths;
    for (double const fraction : fractions) {
      auto const known = std::ranges::find(lengths, fraction);
      which_.push_back(static_cast<std::size_t>(known - lengths.begin()));
      if (known != lengths.end()) continue;
      lengths.push_back(fraction);
      schemes_.push_back(make(fraction * step));
    }
  }
  Scheme& front() { return schemes_.front(); }
  /// A whole step. Where one of its substeps fails, the body is as it was.
  template <class Body>
  void step(Body& body, bool with_attitude) {
    if (which_.size() == 1) return substep(schemes_.front(), body, with_attitude);
    Body const before = body;
    try {
      for (std::size_t const k : which_) substep(schemes_[k], body, with_attitude);
    } catch (...) {
      body = before;
      throw;
    }
  }

 private:
  template <class Body>
  static void substep(Scheme& scheme, Body& body, bool with_attitude) {
    with_attitude ? scheme.step_with_attitude(body) : scheme.step(body);
  }
  std::vector<Scheme> schemes_;
  std::vector<std::size_t> which_;
};

/// In steps of a scheme for n at run time, or of a symmetric composition of it.
template <class Scheme>
class SteppedMotionN : public TurningBodyN {
 public:
  using Make = std::function<Substeps<Scheme>(double step)>;

  SteppedMotionN(Make make, double step, StartOfBodyN const& start, bool with_attitude)
      : make_(std::move(make)),
        steps_(make_(step)),
        body_(released(steps_.front(), start.attitude, start.momentum)),
        with_attitude_(with_attitude) {
    // Only the first step shows whether it is too long.
    auto body = body_;
    steps_.step(body, false);
  }
  void advance(long count) override {
    ahead_.reset();
    for (long k = 0; k < count; ++k) steps_.step(body_, with_attitude_);
  }
  void look_ahead(double time) override {
    ahead_.reset();
    if (time == 0) return;
    auto shorter = make_(time);
    auto body = released(shorter.front(), body_.attitude().value, momentum_of(body_));
    shorter.step(body, with_attitude_);
    ahead_.emplace(std::move(body));
  }
  void change_step(double first, double step, long) override {
    ahead_.reset();
    if (first > 0) {
      begin_anew(first);
      steps_.step(body_, with_attitude_);
    }
    begin_anew(step);
  }
  void remember(CheckpointStream& stream) override { body_.remember(stream); }
  /// What a body remembers says with which scheme in this process it was stepped.
  void save_state(CheckpointStream& stream) override {
    for (MatrixXd const& part : {momentum_of(body_), MatrixXd(body_.attitude().value)}) {
      std::vector<double> numbers(part.data(), part.data() + part.size());
      stream(numbers);
    }
  }
  MatrixXd body_momentum() const override { return momentum_of(ahead_ ? *ahead_ : body_); }
  MatrixXd attitude() const override { return (ahead_ ? *ahead_ : body_).attitude().value; }

 private:
  static auto released(Scheme const& scheme, MatrixXd const& attitude, MatrixXd const& momentum) {
    Group const group = scheme.inertia().group;
    return scheme.release({group, attitude}, {group, group.vee(momentum)});
  }
  void begin_anew(double step) {
    steps_ = make_(step);
    body_ = released(steps_.front(), body_.attitude().value, momentum_of(body_));
  }
  using Body = decltype(released(std::declval<Scheme const&>(), {}, {}));
  static MatrixXd momentum_of(Body const& body) {
    auto const pi = body.momentum();
    return pi.group.hat(pi.components);
  }

  Make make_;
  Substeps<Scheme> steps_;
  Body body_;
  std::optional<Body> ahead_;
  bool with_attitude_;
};

/// What does not move: the momentum, without an attitude, of a body all whose moments are equal; and the
/// start of a motion that can take no step.
class ConstantMomentum : public TurningBodyN {
 public:
  explicit ConstantMomentum(MatrixXd momentum, MatrixXd attitude = {})
      : momentum_(std::move(momentum)), attitude_(std::move(attitude)) {}
  MatrixXd body_momentum() const override { return momentum_; }
  MatrixXd attitude() const override { return attitude_; }

 private:
  MatrixXd momentum_, attitude_;
};

}  // namespace

std::vector<double> fractions_of(int order) {
  return order == 2 ? std::vector<double>{1} : order == 4 ? suzuki<double>() : kahan_li<double>();
}

std::unique_ptr<TurningBodyN> stepped_motion_n(StepsOfBodyN const& choice, StartOfBodyN const& start,
                                               double step, bodies::Sweeps sweeps) {
  auto const fractions = fractions_of(choice.order);
  auto const inertia = start.inertia;
  auto const stepped = [&]<class Scheme>(std::type_identity<Scheme>, auto make) {
    return std::make_unique<SteppedMotionN<Scheme>>(
        [=](double h) { return Substeps<Scheme>(fractions, h, make); }, step, start, choice.attitude);
  };
  if (choice.chart)
    return stepped(std::type_identity<bodies::FastNaturalChart>{},
                   [=](double h) { return bodies::FastNaturalChart(inertia, h); });
  return stepped(std::type_identity<bodies::FastMoserVeselov>{},
                 [=](double h) { return bodies::FastMoserVeselov(inertia, h, sweeps); });
}

std::unique_ptr<TurningBodyN> constant_motion_n(Eigen::MatrixXd momentum, Eigen::MatrixXd attitude) {
  return std::make_unique<ConstantMomentum>(std::move(momentum), std::move(attitude));
}

}  // namespace actio::scene
