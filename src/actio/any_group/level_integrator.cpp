#include <Eigen/Core>

#include "actio/any_group/level_integrator.hpp"

#include "actio/any_group/chart_integrator.hpp"
#include "actio/reduction/level_flow.hpp"
#include "actio/reduction/stage_velocities.hpp"

namespace actio::systems {
namespace detail {
namespace {

using Column = Matrix<double, Dynamic, 1>;

Column column(std::vector<double> const& list) {
  Column out(static_cast<Index>(list.size()));
  std::copy(list.begin(), list.end(), out.data());
  return out;
}

actio::detail::Commutators<double> commutators_of(MatrixAlgebra const& algebra, Index size) {
  std::vector<actio::detail::Commutators<double>::Constant> out;
  for (auto const& c : algebra.constants)
    if (c.a < c.b) out.push_back({c.a, c.b, c.c, c.value});
  return {size, std::move(out)};
}
/// On all vectors, one below the other.
actio::detail::VectorAction<double> action_of(ReducedSystem const& system, Index size) {
  std::vector<actio::detail::VectorAction<double>::Entry> out;
  for (int first = 0; first < system.carried(); first += system.length())
    for (auto const& e : system.algebra.entries)
      out.push_back({e.direction, first + e.row, first + e.column, e.value});
  return {size, std::move(out)};
}

/// Numbers in a row, written down or read back.
class Numbers {
 public:
  explicit Numbers(std::vector<double>& all, bool reading) : all_(all), reading_(reading) {}
  template <class... T>
  void operator()(T&... values) { (one(values), ...); }

 private:
  void one(std::span<double> values) {
    for (double& x : values) one(x);
  }
  template <class T>
  void one(T& x) {
    if (reading_)
      x = static_cast<T>(all_[at_++]);
    else
      all_.push_back(static_cast<double>(x));
  }
  std::vector<double>& all_;
  bool reading_;
  std::size_t at_ = 0;
};

/// On one side, in columns of N numbers of a momentum and M of the vectors, or of any number; those that a
/// system does not need are zero.
template <int side, int N, int M>
class SizedLevelStep : public LevelStep {
  using V = Matrix<double, N, 1>;
  using U = Matrix<double, M, 1>;
  using G = SpanOfMatrices;

  static Index size_in(int fixed, std::size_t needed) {
    return fixed == Dynamic ? static_cast<Index>(needed) : fixed;
  }

 public:
  SizedLevelStep(std::shared_ptr<ReducedSystem const> const& system, ReducedPoint const& start,
                 std::vector<double> const& velocity)
      : lagrangian_{system},
        whole_(V::Zero(size_in(N, start.momentum.size()))),
        carried_(U::Zero(size_in(M, start.vectors.size()))),
        momentum_(column(start.momentum)),
        vectors_(column(start.vectors)),
        from_{G(std::shared_ptr<MatrixAlgebra const>(system, &system->algebra)), column(velocity)},
        velocities_(from_),
        flow_(commutators_of(system->algebra, whole_.size()), action_of(*system, carried_.size()), whole_,
              carried_) {
    for (std::size_t i = 0; i < start.vectors.size(); ++i)
      constant_slopes_ &= system->slopes.is_constant(static_cast<int>(1 + start.momentum.size() + i));
  }

  std::unique_ptr<LevelStep> copy() const override { return std::make_unique<SizedLevelStep>(*this); }

  int advance(double h, ReducedPoint& point, std::vector<double>& velocity,
              std::vector<double>& turn) override {
    std::size_t const n = point.momentum.size(), m = point.vectors.size();
    std::copy_n(point.momentum.data(), n, whole_.data());
    std::copy_n(point.vectors.data(), m, carried_.data());
    std::copy_n(velocity.data(), n, from_.coordinates.data());
    V eta = V::Zero(whole_.size());
    int slopes = 0;
    HeldTape const held{*lagrangian_.system, vectors_};
    auto const velocity_of = [&](int stage, V const& mu, U const& a, V& out, U& push) {
      std::copy_n(mu.data(), n, momentum_.data());
      std::copy_n(a.data(), m, vectors_.data());
      if (!velocities_.find(held, momentum_, flow_.checks(stage))) return false;
      auto const& xi = velocities_.velocity().coordinates;
      std::copy_n(xi.data(), n, out.data());
      if (m == 0 || (constant_slopes_ && slopes > 0)) return true;
      auto const& slope = held.values(lagrangian_.system->slopes, xi);
      for (std::size_t i = 0; i < m; ++i) push.data()[i] = -slope[1 + n + i];
      ++slopes;
      return true;
    };
    for (int tried = 0; tried < 2; ++tried) {
      std::copy_n(point.vectors.data(), m, vectors_.data());
      velocities_.begin(held, from_);
      if (flow_(whole_, carried_, h, velocity_of, eta)) break;
    }
    flow_.push(carried_, whole_), flow_.transport(eta, whole_, carried_);
    if (!is_finite(whole_) || !is_finite(carried_)) throw NotFinite("momentum level: momentum after a step");
    turn.assign(eta.data(), eta.data() + n);
    std::copy_n(whole_.data(), n, point.momentum.data());
    std::copy_n(carried_.data(), m, point.vectors.data());
    std::copy_n(velocities_.velocity().coordinates.data(), n, velocity.data());
    return velocities_.take_gradients() + slopes;
  }

  std::vector<double> memory() override {
    std::vector<double> all;
    Numbers stream(all, false);
    velocities_.remember(stream);
    return all;
  }
  void recall(std::vector<double> memory) override {
    Numbers stream(memory, true);
    velocities_.remember(stream);
  }

 private:
  TapeLagrangian lagrangian_;
  V whole_;    // momentum
  U carried_;  // vectors
  Column momentum_, vectors_;
  Velocity<G, double> from_;
  actio::detail::StageVelocities<G, double> velocities_;
  actio::detail::LevelFlow<side, double, V, U> flow_;
  bool constant_slopes_ = true;  // in the vectors, by the formula
};

template <int side>
std::unique_ptr<LevelStep> level_step(std::shared_ptr<ReducedSystem const> const& system,
                                      ReducedPoint const& start, std::vector<double> const& velocity) {
  auto const of = [&]<int N, int M>(std::integer_sequence<int, N, M>) -> std::unique_ptr<LevelStep> {
    return std::make_unique<SizedLevelStep<side, N, M>>(system, start, velocity);
  };
  auto const n = start.momentum.size(), m = start.vectors.size();
  if (n <= 3 && 0 < m && m <= 3) return of(std::integer_sequence<int, 3, 3>());
  if (n <= 3) return of(std::integer_sequence<int, 3, Dynamic>());
  if (n <= 6) return of(std::integer_sequence<int, 6, Dynamic>());
  if (n <= 8) return of(std::integer_sequence<int, 8, Dynamic>());
  return of(std::integer_sequence<int, Dynamic, Dynamic>());
}

}  // namespace
}  // namespace detail

namespace {

/// Refuses what leads the momentum away from its level, but for damping along the free motion.
std::shared_ptr<ReducedSystem const> on_a_level(std::shared_ptr<ReducedSystem const> system) {
  bool const damped = system->dissipation && (system->dissipation->kind != Dissipation::Kind::conformal ||
                                              !damps_along_free_motion(*system));
  if (system->force || damped)
    throw OutsideDomain("momentum level",
                        "there must be no force, and no friction but damping along the free motion; others",
                        int(system->force.has_value()) + int(damped), 0);
  return system;
}

}  // namespace

LevelIntegrator::LevelIntegrator(std::shared_ptr<ReducedSystem const> system, double h, ReducedPoint start,
                                 std::vector<double> const& velocity)
    : system_(on_a_level(std::move(system))),
      length_(system_->dissipation ? system_->dissipation->free_time(h) : h),
      decay_(system_->dissipation ? std::exp(-system_->dissipation->rate * h) : 1),
      level_(system_->side == Side::left ? detail::level_step<-1>(system_, start, velocity)
                                         : detail::level_step<1>(system_, start, velocity)),
      point_(std::move(start)),
      velocity_(velocity) {}

LevelIntegrator::LevelIntegrator(LevelIntegrator const& other)
    : system_(other.system_),
      length_(other.length_),
      decay_(other.decay_),
      level_(other.level_->copy()),
      point_(other.point_),
      velocity_(other.velocity_),
      turn_(other.turn_),
      configuration_(other.configuration_),
      evaluations_(other.evaluations_) {}

void LevelIntegrator::step() {
  evaluations_ += level_->advance(length_, point_, velocity_, turn_);
  if (decay_ != 1) {
    for (double& p : point_.momentum) p *= decay_;
    for (double& v : velocity_) v *= decay_;
  }
  if (configuration_.size() == 0) return;
  if (system_->side == Side::right) return apply_exponential(system_->algebra, 1, turn_, configuration_);
  Eigen::MatrixXd by = Eigen::MatrixXd::Identity(configuration_.rows(), configuration_.cols());
  apply_exponential(system_->algebra, 1, turn_, by);
  configuration_ = configuration_ * by;
}

}  // namespace actio::systems
