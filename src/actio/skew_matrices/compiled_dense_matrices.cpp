// Eigenvalues and products of whole matrices, compiled once.
// In a unit of its own
#include <Eigen/Core>

#include "actio/skew_matrices/dense_matrices.hpp"

namespace actio::sphere {

template Eigen::VectorXd hermitian_values(ComplexMatrix<> const&);
template Eigen::VectorXd hermitian_values(Eigen::MatrixXd const&);
template Eigensystem<ComplexMatrix<>> hermitian_eigensystem(ComplexMatrix<> const&);
template Eigensystem<Eigen::MatrixXd> hermitian_eigensystem(Eigen::MatrixXd const&);
template Eigen::VectorXd tridiagonal_values<Eigen::MatrixXd>(Eigen::VectorXd const&, Eigen::VectorXd const&);
template Eigensystem<Eigen::MatrixXd> tridiagonal_eigensystem(Eigen::VectorXd const&, Eigen::VectorXd const&);
template Eigen::VectorXd regular_solution(Eigen::MatrixXd const&, Eigen::VectorXd const&, double);
template ComplexMatrix<> product_of(ComplexMatrix<> const&, ComplexMatrix<> const&);
template Eigen::MatrixXd product_of(Eigen::MatrixXd const&, Eigen::MatrixXd const&);

}  // namespace actio::sphere
