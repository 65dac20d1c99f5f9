#include <Eigen/Core>

#include "actio/any_group/step_iteration.hpp"

namespace actio::systems {

void StepIteration::set_derivative(Eigen::MatrixXd const& derivative, Eigen::MatrixXd const& inverse_of_it,
                                   Eigen::VectorXd const& units) {
  auto const n = derivative.rows();
  using Rows = Eigen::Map<Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>;
  Rows(moduli.data(), n, n) = derivative.cwiseAbs();
  Rows(inverse.data(), n, n) = inverse_of_it;
  for (Eigen::Index i = 0; i < n; ++i) weights_[static_cast<std::size_t>(i)] = 1 / (units[i] * units[i]);
}

void StepIteration::find_update() {
  auto const d = unknowns.size();
  for (std::size_t i = 0; i < d; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < d; ++j) sum -= inverse[i * d + j] * residual[j];
    update_[i] = sum;
  }
}

}  // namespace actio::systems
