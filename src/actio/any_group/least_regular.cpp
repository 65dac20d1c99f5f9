#include <Eigen/Core>

#include "actio/any_group/least_regular.hpp"

namespace actio::systems {

LeastRegular::LeastRegular(Eigen::MatrixXd const& m) {
  Eigen::VectorXd const units = units_of(m);
  auto const [values, vectors] = symmetric_eigen(units.asDiagonal() * m * units.asDiagonal());
  Eigen::Index at = 0;
  smallest = values.cwiseAbs().minCoeff(&at);
  largest = values.cwiseAbs().maxCoeff();
  direction = (units.asDiagonal() * vectors.col(at)).stableNormalized();
}

}  // namespace actio::systems
