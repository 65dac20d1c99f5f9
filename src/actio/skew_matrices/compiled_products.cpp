// Products of matrices by Eigen, compiled once.
// In a unit of its own
#include <Eigen/Core>

#include "actio/skew_matrices/products.hpp"

namespace actio::sphere {

template void EigenProducts::whole(Eigen::MatrixXd const&, Eigen::MatrixXd const&, Eigen::MatrixXd&) const;
template void EigenProducts::whole(Eigen::MatrixXf const&, Eigen::MatrixXf const&, Eigen::MatrixXf&) const;
template void EigenProducts::lower(Eigen::MatrixXd const&, Eigen::MatrixXd const&, Eigen::MatrixXd&) const;
template void EigenProducts::lower(Eigen::MatrixXf const&, Eigen::MatrixXf const&, Eigen::MatrixXf&) const;
template SkewHermitian<> commutator(SkewHermitian<> const&, SkewHermitian<> const&);

}  // namespace actio::sphere
