#include <Eigen/Core>

#include "actio/any_group/level_integrator.hpp"

#include "actio/any_group/chart_integrator.hpp"

namespace actio::systems {
namespace {

Matrix<double, Dynamic, 1> column(std::vector<double> const& list) {
  Matrix<double, Dynamic, 1> out(static_cast<Index>(list.size()));
  std::copy(list.begin(), list.end(), out.data());
  return out;
}
std::vector<double> list_of(Matrix<double, Dynamic, 1> const& column) {
  return {column.data(), column.data() + column.size()};
}

}  // namespace

LevelIntegrator::LevelIntegrator(std::shared_ptr<ReducedSystem const> const& system, double h,
                                 ReducedPoint start, std::vector<double> const& velocity)
    : system_(system),
      group_(std::shared_ptr<MatrixAlgebra const>(system, &system->algebra)),
      length_(h),
      level_(Level<-1>(TapeLagrangian{system}, {})),
      point_(std::move(start)),
      velocity_(velocity) {
  if (system->side == Side::right) level_ = Level<1>(TapeLagrangian{system}, {});
}

LevelIntegrator::State LevelIntegrator::state() const {
  return {{group_, column(point_.momentum)}, column(point_.vectors), {group_, column(velocity_)}};
}

void LevelIntegrator::step() {
  State now = state();
  int evaluations = 0;
  auto const moved =
      std::visit([&](auto const& level) { return level.advance(now, length_, evaluations); }, level_);
  std::vector<double> const turn = list_of(moved.coordinates);
  if (configuration_.size() && system_->side == Side::left) {
    Eigen::MatrixXd by = Eigen::MatrixXd::Identity(configuration_.rows(), configuration_.cols());
    apply_exponential(system_->algebra, 1, turn, by);
    configuration_ = configuration_ * by;
  } else if (configuration_.size()) {
    apply_exponential(system_->algebra, 1, turn, configuration_);
  }
  point_ = {list_of(now.momentum.components), list_of(now.vector)};
  velocity_ = list_of(now.velocity.coordinates);
  evaluations_ += evaluations;
}

}  // namespace actio::systems
