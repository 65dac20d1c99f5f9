#include "actio/scene/systems/vorticity_motion.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "actio/scene/systems/vorticity_products.hpp"
#include "actio/scene/systems/vorticity_steps.hpp"
#include "actio/vorticity/sphere_invariants.hpp"

namespace actio::scene {
namespace {

/// A fraction of a step has a scheme of its own at each of its places, which guesses from what was found
/// there in the steps before: these are evenly spaced, as the guess needs it.
template <class Step>
std::vector<Step> substeps(SphereFlow const& flow, SphereScheme const& scheme, double step) {
  std::vector<Step> out;
  out.reserve(scheme.fractions.size());
  for (double const fraction : scheme.fractions)
    out.emplace_back(flow.laplacian, scheme.conserved, fraction * step, flow.frame, flow.products);
  return out;
}

/// \f$2\Omega\,x\cdot p\f$ with a direction p in the place of the pole.
void subtract_rotation(SkewHermitian<>& w, QuantizedSphere const& sphere, double rotation,
                       Eigen::Vector3d const& pole) {
  add_spin(sphere, -2 * rotation * sphere.hbar() * pole, w);
}

/// Half of a skew-Hermitian matrix says the whole of it.
void remember_matrix(CheckpointStream& stream, SkewHermitian<>& w, int n) {
  Eigen::MatrixXd half(n, n);
  if (!stream.reading()) {
    half = w.real.triangularView<Eigen::StrictlyUpper>();
    half.triangularView<Eigen::Lower>() = w.imaginary;
  }
  std::span<double> numbers(half.data(), static_cast<std::size_t>(half.size()));
  stream(numbers);
  if (!stream.reading()) return;
  w = SkewHermitian<>(n);
  w.imaginary.triangularView<Eigen::Lower>() = half;
  w.real.triangularView<Eigen::StrictlyLower>() = -half.transpose();
  mirror_lower(w);
}

/// What a step in double precision guesses from.
void remember_step(CheckpointStream& stream, VorticityStep<>::Past& past, Conserved conserved, int n) {
  remember_matrix(stream, past.increment, n);
  if (conserved != Conserved::lie_poisson) remember_matrix(stream, past.half_change, n);
  std::span<double> factors(past.factors.data(), 4);
  stream(factors);
}
/// What a step in mixed precision guesses from.
void remember_step(CheckpointStream& stream, FastVorticityStep<>::Past& past, Conserved, int n) {
  remember_matrix(stream, past.displacement, n);
  std::span<double> factors(past.factors.data(), 4);
  stream(factors);
  stream(past.radius), stream(past.age);
}

template <class Step>
class SteppedVorticity : public VorticityMotion {
 public:
  SteppedVorticity(std::shared_ptr<SphereFlow const> flow, SphereScheme scheme, double step)
      : flow_(std::move(flow)),
        scheme_(std::move(scheme)),
        step_(step),
        steps_(substeps<Step>(*flow_, scheme_, step)),
        w_(flow_->start) {}

  void advance(long count) override {
    ahead_.reset();
    for (long k = 0; k < count; ++k) {
      make_step(steps_, w_, step_);
      ++made_;
    }
  }
  void look_ahead(double time) override {
    ahead_.reset();
    if (time == 0) return;
    auto shorter = substeps<Step>(*flow_, scheme_, time);
    SkewHermitian<> w = w_;
    make_step(shorter, w, time);
    ahead_.emplace(std::move(w)), beyond_ = time;
  }
  void remember(CheckpointStream& stream) override {
    auto const n = flow_->sphere.n;
    stream(made_);
    remember_matrix(stream, w_, n);
    // Numbers of the start: those of another file in its place are not continued.
    double mark = flow_->start.imaginary.sum() + flow_->start.real.cwiseAbs().sum();
    double const own = mark;
    stream(mark);
    if (!(mark == own))
      throw FileError(
          "the run began from other numbers; the file that they were read from was changed since");
    for (auto& step : steps_) {
      std::deque<typename Step::Past> past = step.past();
      auto size = static_cast<long>(past.size());
      stream(size);
      if (stream.reading()) past.resize(static_cast<std::size_t>(std::clamp(size, 0L, 64L)));
      for (auto& one : past) remember_step(stream, one, scheme_.conserved, n);
      if (stream.reading()) step.go_on_from(std::move(past));
    }
  }

  SkewHermitian<> vorticity_at_output() const override {
    TurningFrame const& frame = flow_->frame;
    double const t = time();
    SkewHermitian<> w;
    if (frame.axis[0] == 0 && frame.axis[1] == 0) {
      w = about_pole((frame.rate * frame.axis[2] - flow_->rotation) * t, absolute_vorticity());
    } else {
      if (!about_axis_) about_axis_.emplace(flow_->sphere, frame.axis);
      w = about_pole(-flow_->rotation * t, (*about_axis_)(frame.rate * t, absolute_vorticity()));
    }
    subtract_rotation(w, flow_->sphere, flow_->rotation, Eigen::Vector3d::UnitZ());
    return w;
  }
  SkewHermitian<> vorticity_but_for_rotation() const override {
    SkewHermitian<> w = absolute_vorticity();
    if (flow_->rotation != 0)
      subtract_rotation(
          w, flow_->sphere, flow_->rotation,
          Eigen::AngleAxisd(-flow_->frame.rate * time(), flow_->frame.axis) * Eigen::Vector3d::UnitZ());
    return w;
  }
  SkewHermitian<> const& absolute_vorticity() const override { return ahead_ ? *ahead_ : w_; }
  Eigen::Vector3d angular_momentum() const override {
    return Eigen::AngleAxisd(flow_->frame.rate * time(), flow_->frame.axis) *
           sphere_momentum(absolute_vorticity());
  }

 private:
  /// The steps are counted, and times are multiplied.
  double time() const { return static_cast<double>(made_) * step_ + (ahead_ ? beyond_ : 0); }
  SkewHermitian<> about_pole(double angle, SkewHermitian<> const& w) const {
    return Turning(flow_->sphere, Eigen::Vector3d::UnitZ())(angle, w);
  }

  /// Where a substep cannot be made, the vorticity is as it was.
  void make_step(std::vector<Step>& steps, SkewHermitian<>& w, double length) const {
    if (steps.size() == 1) {
      steps.front().advance(w);
      return;
    }
    SkewHermitian<> const before = w;
    try {
      for (auto& step : steps) step.advance(w);
    } catch (NotContracting const& error) {
      w = before;
      throw NotContracting(length, std::copysign(error.largest / scheme_.longest(), length));
    }
  }

  std::shared_ptr<SphereFlow const> flow_;
  SphereScheme scheme_;
  double step_;
  std::vector<Step> steps_;
  SkewHermitian<> w_;
  long made_ = 0;
  std::optional<SkewHermitian<>> ahead_;
  double beyond_ = 0;
  mutable std::optional<Turning> about_axis_;
};

}  // namespace

StateDistance VorticityMotion::distance(Motion const& other) const {
  auto const& w = absolute_vorticity();
  return {0, norm(w - dynamic_cast<VorticityMotion const&>(other).absolute_vorticity()), norm(w)};
}

SphereFlow::SphereFlow(double rotation_of_sphere, SkewHermitian<> const& relative,
                       std::vector<std::string>& remarks)
    : sphere(static_cast<int>(relative.size())),
      laplacian(sphere.n),
      rotation(rotation_of_sphere),
      start(relative + planetary_vorticity(sphere, rotation_of_sphere)),
      frame(calmest_frame(sphere, laplacian, start)),
      products(products_of_flow(start, remarks)) {}

double SphereFlow::fastest_turning() const {
  SkewHermitian<> p = laplacian.solve(start);
  add_spin(sphere, frame.rate * sphere.hbar() * frame.axis, p);
  return FastVorticityStep<>::spectral_radius(p) / sphere.hbar();
}

double SphereScheme::longest() const {
  double longest = 0;
  for (double const fraction : fractions) longest = std::max(longest, std::abs(fraction));
  return longest;
}

std::unique_ptr<VorticityMotion> stepped_vorticity(std::shared_ptr<SphereFlow const> flow,
                                                   SphereScheme const& scheme, double step) {
  if (scheme.to_rounding)
    return std::make_unique<SteppedVorticity<VorticityStep<>>>(std::move(flow), scheme, step);
  return std::make_unique<SteppedVorticity<FastVorticityStep<>>>(std::move(flow), scheme, step);
}

double longest_vorticity_step(std::shared_ptr<SphereFlow const> const& flow, SphereScheme const& scheme,
                              double step) {
  double h = step;
  for (int k = 0; k < 40; ++k) try {
      stepped_vorticity(flow, scheme, h)->advance(8);
      return h;
    } catch (NotContracting const& error) {
      h = error.largest > 0 ? std::min(0.8 * h, error.largest) : 0.5 * h;
    }
  return 0;
}

}  // namespace actio::scene
