// Eigenvalues and products of whole matrices, which take O(N^3) operations: templates, so that a program with
// many units can have them compiled once.
#pragma once

#include <Eigen/Eigenvalues>

#include "actio/skew_matrices/skew_hermitian.hpp"

namespace actio::sphere {

/// Eigenvalues in ascending order, and a unitary matrix with an eigenvector in each column.
template <class Dense>
struct Eigensystem {
  Eigen::VectorXd values;  ///< ascending
  Dense vectors;           ///< unitary
};

/// The eigenvalues of a Hermitian matrix, of which the lower half is read.
/// @tparam Dense  `ComplexMatrix<>` or `Eigen::MatrixXd`
template <class Dense>
Eigen::VectorXd hermitian_values(Dense const& a) {
  return Eigen::SelfAdjointEigenSolver<Dense>(a, Eigen::EigenvaluesOnly).eigenvalues();
}
/// The same with the eigenvectors.
template <class Dense>
Eigensystem<Dense> hermitian_eigensystem(Dense const& a) {
  Eigen::SelfAdjointEigenSolver<Dense> const solver(a);
  return {solver.eigenvalues(), solver.eigenvectors()};
}
/// The eigenvalues of a real symmetric tridiagonal matrix.
/// @tparam Dense  `Eigen::MatrixXd`
/// @param beside  the diagonal below
template <class Dense>
Eigen::VectorXd tridiagonal_values(Eigen::VectorXd const& diagonal, Eigen::VectorXd const& beside) {
  Eigen::SelfAdjointEigenSolver<Dense> solver;
  return solver.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly).eigenvalues();
}
/// The same with the eigenvectors.
template <class Dense>
Eigensystem<Dense> tridiagonal_eigensystem(Eigen::VectorXd const& diagonal, Eigen::VectorXd const& beside) {
  Eigen::SelfAdjointEigenSolver<Dense> solver;
  solver.computeFromTridiagonal(diagonal, beside, Eigen::ComputeEigenvectors);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

/// The solution of G x = b with a Gram matrix G that may be singular: eigenvalues below the cut-off, in units
/// of the largest, are left out.
/// @tparam Dense  `Eigen::MatrixXd`; the lower half is read
template <class Dense>
Eigen::VectorXd regular_solution(Dense const& gram, Eigen::VectorXd const& b, double cutoff) {
  auto const [values, vectors] = hermitian_eigensystem(gram);
  Eigen::VectorXd part = vectors.transpose() * b;
  double const least = cutoff * values[values.size() - 1];
  for (Eigen::Index j = 0; j < part.size(); ++j) part[j] = values[j] > least ? part[j] / values[j] : 0;
  return vectors * part;
}

/// a b.
template <class Dense>
Dense product_of(Dense const& a, Dense const& b) { return a * b; }

extern template Eigen::VectorXd hermitian_values(ComplexMatrix<> const&);
extern template Eigen::VectorXd hermitian_values(Eigen::MatrixXd const&);
extern template Eigensystem<ComplexMatrix<>> hermitian_eigensystem(ComplexMatrix<> const&);
extern template Eigensystem<Eigen::MatrixXd> hermitian_eigensystem(Eigen::MatrixXd const&);
extern template Eigen::VectorXd tridiagonal_values<Eigen::MatrixXd>(Eigen::VectorXd const&,
                                                                    Eigen::VectorXd const&);
extern template Eigensystem<Eigen::MatrixXd> tridiagonal_eigensystem(Eigen::VectorXd const&,
                                                                     Eigen::VectorXd const&);
extern template Eigen::VectorXd regular_solution(Eigen::MatrixXd const&, Eigen::VectorXd const&, double);
extern template ComplexMatrix<> product_of(ComplexMatrix<> const&, ComplexMatrix<> const&);
extern template Eigen::MatrixXd product_of(Eigen::MatrixXd const&, Eigen::MatrixXd const&);

}  // namespace actio::sphere
