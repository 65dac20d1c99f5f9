// The groups with names as data: bases in the order and with the signs of the library's types, and how far a
// matrix is from each group.
#pragma once

#include <Eigen/Core>

#include "actio/any_group/matrix_algebra.hpp"
#include "actio/groups/affine_line.hpp"
#include "actio/groups/linear_groups.hpp"
#include "actio/groups/motions.hpp"
#include "actio/groups/rotations_of_any_size.hpp"
#include "actio/groups/special_linear.hpp"
#include "actio/groups/symplectic_groups.hpp"
#include "actio/groups/unipotent_groups.hpp"
#include "actio/groups/unitary_groups.hpp"

namespace actio::systems::detail {

/// A group before its structure constants are found.
struct GroupOfMatrices {
  std::string name;                                                    ///< `SO(3)`
  std::vector<Eigen::MatrixXd> basis;                                  ///< of its algebra
  std::function<double(Eigen::MatrixXd const&)> distance;              ///< of a matrix from the group
  int size() const { return static_cast<int>(basis.front().rows()); }  ///< rows of a matrix
};

/// How far the determinant is from the positive numbers: nothing, or at least 1.
inline double distance_from_positive(double determinant) { return determinant > 0 ? 0 : 1 - determinant; }

/// How far the library moves a matrix to bring it on the group; where it refuses, what it has measured. At
/// least 1 where the determinant is not positive, as it is on all groups that are connected.
template <MatrixGroup G>
double distance_from(G const& group, Eigen::MatrixXd const& g) {
  Storage<G, double> const a = g;
  if (double const outside = distance_from_positive(determinant_by_elimination(a)); outside > 0)
    return outside;
  try {
    return row_norm(Storage<G, double>(primitive::restore(group, a) - a));
  } catch (OutsideDomain const& e) {
    return e.measured;
  }
}

/// A group of the library.
template <MatrixGroup G>
GroupOfMatrices group_of_type(std::string const& name, G const& group) {
  GroupOfMatrices made{name, {}, [group](Eigen::MatrixXd const& g) { return distance_from(group, g); }};
  for (int a = 0; a < group.dimension(); ++a) {
    Coordinates<G, double> unit = Coordinates<G, double>::Zero(group.dimension());
    unit[a] = 1;
    made.basis.push_back(group.hat(unit));
  }
  return made;
}

/// \f$E_{ij}\f$ of n rows.
inline Eigen::MatrixXd elementary_matrix(int n, int i, int j) {
  Eigen::MatrixXd e = Eigen::MatrixXd::Zero(n, n);
  e(i, j) = 1;
  return e;
}

/// SU(2) with the coordinates of unit quaternions, whose bracket is the cross product: half the basis of
/// SU(n).
inline GroupOfMatrices unit_quaternion_matrices(std::string const& name) {
  GroupOfMatrices made = group_of_type(name, SU<>(2));
  for (auto& e : made.basis) e /= 2;
  return made;
}

/// \f$G\times H\f$, as block diagonal matrices: coordinates of G, then of H.
GroupOfMatrices product_matrices(GroupOfMatrices const& g, GroupOfMatrices const& h);

/// \f$G\ltimes\mathbb R^n\f$ as the matrices ((A, x), (0, 1)): coordinates of G, then the translation.
GroupOfMatrices semidirect_matrices(GroupOfMatrices const& g, std::string const& space);

/// A family of groups, one for each number in its name, or a group alone.
struct GroupFamily {
  std::string stem;  ///< `SO` of SO(n), `R` of R^n
  char open;         ///< before the number: a bracket, a hat, or zero where the name has no number
  int least, most;   ///< numbers
  int divisor;       ///< of the number
  double (*dimension)(double n);
  GroupOfMatrices (*make)(std::string const& name, int n);

  /// `SO(n)`, `R^n`, `Aff(1)`.
  std::string name_with(std::string const& number) const {
    return open == '(' ? stem + "(" + number + ")" : open == '^' ? stem + "^" + number : stem;
  }
  /// `SO(n)`, `Aff(1)`.
  std::string pattern() const {
    return name_with(least == most ? std::to_string(least) : divisor == 2 ? "2n" : "n");
  }
};

/// All of them. R^n, SO(n) and so on end where the dimension becomes too large.
std::vector<GroupFamily> const& group_families();

}  // namespace actio::systems::detail
