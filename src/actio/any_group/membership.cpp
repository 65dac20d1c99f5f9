#include <Eigen/Core>

#include "actio/any_group/membership.hpp"

namespace actio::systems {

namespace detail {
namespace {

/// How far \f$g e_a g^{-1}\f$ is from the algebra, relative to itself; the largest.
/// @throws Singular  where g has no inverse
double distance_of_moved_algebra(MatrixAlgebra const& algebra, Matrix<double> const& g) {
  Matrix<double> const back = inverse_matrix(g, "is_element");
  double distance = 0;
  for (auto const& e : algebra.basis) {
    Matrix<double> const moved = g * Matrix<double>(e) * back;
    distance = std::max(distance,
                        row_norm(Matrix<double>(algebra.hat(algebra.vee(moved)) - moved)) / row_norm(moved));
  }
  return distance;
}

/// The orthogonal projection on the vectors x with \f$e_ax = 0\f$ for all a, or \f$e_a^Tx = 0\f$.
Eigen::MatrixXd projection_on_fixed_vectors(MatrixAlgebra const& algebra, bool transposed) {
  constexpr double independent = 1e-9;
  Eigen::MatrixXd left = Eigen::MatrixXd::Identity(algebra.size, algebra.size);
  for (auto const& e : algebra.basis)
    for (int i = 0; i < algebra.size; ++i) {
      Eigen::VectorXd const row = transposed ? e.col(i) : Eigen::VectorXd(e.row(i));
      Eigen::VectorXd rest = left * row;
      if (!(rest.norm() > independent * e.norm())) continue;
      rest = left * rest.normalized();
      rest.normalize();
      left -= rest * rest.transpose();
    }
  return left;
}

/// What elements of the group have in common, as far as the algebra alone tells: volume, fixed vectors, and
/// near the identity a logarithm in the algebra.
double distance_from_common_properties(MatrixAlgebra const& algebra, Eigen::MatrixXd const& g,
                                       double determinant) {
  double distance = 0;
  bool const traceless = std::all_of(algebra.basis.begin(), algebra.basis.end(),
                                     [](auto const& e) { return std::abs(e.trace()) <= 1e-12 * e.norm(); });
  if (traceless) distance = std::abs(determinant - 1);
  for (bool const transposed : {false, true}) {
    Eigen::MatrixXd const fixed = projection_on_fixed_vectors(algebra, transposed),
                          acting = transposed ? Eigen::MatrixXd(g.transpose()) : g;
    distance = std::max(distance, row_norm(Eigen::MatrixXd(acting * fixed - fixed)));
  }
  Eigen::MatrixXd const from_identity = g - Eigen::MatrixXd::Identity(g.rows(), g.cols());
  if (row_norm(from_identity) < 0.5) {
    Matrix<double> const m = matrix_logarithm(Matrix<double>(g));
    distance = std::max(distance, row_norm(Matrix<double>(algebra.hat(algebra.vee(m)) - m)));
  }
  return distance;
}

}  // namespace
}  // namespace detail

bool is_element(MatrixAlgebra const& algebra, Eigen::MatrixXd const& g, double& distance) {
  distance = std::numeric_limits<double>::infinity();
  if (g.rows() != algebra.size || g.cols() != algebra.size || !g.allFinite()) return false;
  try {
    Matrix<double> const a = g;
    double const moved = detail::distance_of_moved_algebra(algebra, a),
                 determinant = determinant_by_elimination(a);
    double const rest = !(determinant > 0) ? 1 - determinant
                        : algebra.distance_from_group
                            ? algebra.distance_from_group(g)
                            : detail::distance_from_common_properties(algebra, g, determinant);
    if (std::isfinite(moved) && std::isfinite(rest)) distance = std::max(moved, rest);
  } catch (Error const&) {
    // Without an inverse, or beyond the range of numbers: infinitely far.
  }
  return distance <= largest_distance_from_group;
}

}  // namespace actio::systems
