// The groups with names as data: bases in the order and with the signs of the library's types, and how far a
// matrix is from each group.
#pragma once

#include "actio/any_group/matrix_algebra.hpp"
#include "actio/groups/affine_line.hpp"
#include "actio/groups/linear_groups.hpp"
#include "actio/groups/motions.hpp"
#include "actio/groups/rotations_of_any_size.hpp"
#include "actio/groups/special_linear.hpp"
#include "actio/groups/symplectic_groups.hpp"
#include "actio/groups/unipotent_groups.hpp"
#include "actio/groups/unitary_groups.hpp"

namespace actio::detail {

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

/// \f$\mathbb R^n\f$ as the matrices ((1, x), (0, 1)).
inline GroupOfMatrices translation_matrices(std::string const& name, int n) {
  GroupOfMatrices made{name, {}, [n](Eigen::MatrixXd const& g) {
                         Eigen::MatrixXd rest = g - Eigen::MatrixXd::Identity(n + 1, n + 1);
                         rest.col(n).head(n).setZero();
                         return row_norm(rest);
                       }};
  for (int i = 0; i < n; ++i) made.basis.push_back(elementary_matrix(n + 1, i, n));
  return made;
}

/// GL(n): the entries row by row.
inline GroupOfMatrices general_linear_matrices(std::string const& name, int n) {
  GroupOfMatrices made{name, {}, [](Eigen::MatrixXd const& g) {
                         return distance_from_positive(determinant_by_elimination(Matrix<double>(g)));
                       }};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) made.basis.push_back(elementary_matrix(n, i, j));
  return made;
}

/// SU(2) with the coordinates of unit quaternions, whose bracket is the cross product: half the basis of
/// SU(n).
inline GroupOfMatrices unit_quaternion_matrices(std::string const& name) {
  GroupOfMatrices made = group_of_type(name, SU<>(2));
  for (auto& e : made.basis) e /= 2;
  return made;
}

/// \f$G\times H\f$, as block diagonal matrices: coordinates of G, then of H.
inline GroupOfMatrices product_matrices(GroupOfMatrices const& g, GroupOfMatrices const& h) {
  int const n = g.size(), m = h.size();
  GroupOfMatrices made{
      g.name + " x " + h.name, {}, [=](Eigen::MatrixXd const& a) {
        return std::max({g.distance(a.topLeftCorner(n, n)), h.distance(a.bottomRightCorner(m, m)),
                         row_norm(a.topRightCorner(n, m)), row_norm(a.bottomLeftCorner(m, n))});
      }};
  auto const block = [&](auto const& e, int first) {
    made.basis.push_back(Eigen::MatrixXd::Zero(n + m, n + m));
    made.basis.back().block(first, first, e.rows(), e.cols()) = e;
  };
  for (auto const& e : g.basis) block(e, 0);
  for (auto const& e : h.basis) block(e, n);
  return made;
}

/// \f$G\ltimes\mathbb R^n\f$ as the matrices ((A, x), (0, 1)): coordinates of G, then the translation.
inline GroupOfMatrices semidirect_matrices(GroupOfMatrices const& g, std::string const& space) {
  int const n = g.size();
  std::string const first = g.name.find(' ') == std::string::npos ? g.name : "(" + g.name + ")";
  GroupOfMatrices made{first + " |x " + space, {}, [=](Eigen::MatrixXd const& a) {
                         return std::max({g.distance(a.topLeftCorner(n, n)),
                                          row_norm(a.bottomLeftCorner(1, n)), std::abs(a(n, n) - 1)});
                       }};
  for (auto const& e : g.basis) {
    made.basis.push_back(Eigen::MatrixXd::Zero(n + 1, n + 1));
    made.basis.back().topLeftCorner(n, n) = e;
  }
  for (int i = 0; i < n; ++i) made.basis.push_back(elementary_matrix(n + 1, i, n));
  return made;
}

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
inline std::vector<GroupFamily> const& group_families() {
  constexpr int any = largest_dimension_of_algebra;
  using Name = std::string const&;
  static std::vector<GroupFamily> const families{
      {"R", '^', 1, any, 1, [](double n) { return n; }, translation_matrices},
      {"SO", '(', 2, any, 1, [](double n) { return n * (n - 1) / 2; },
       [](Name name, int n) { return group_of_type(name, SO<Dynamic>{n}); }},
      {"SE", '(', 2, 3, 1, [](double n) { return n * (n + 1) / 2; },
       [](Name name, int n) { return n == 2 ? group_of_type(name, SE<2>{}) : group_of_type(name, SE<3>{}); }},
      {"GL", '(', 1, any, 1, [](double n) { return n * n; }, general_linear_matrices},
      {"SL", '(', 2, any, 1, [](double n) { return n * n - 1; },
       [](Name name, int n) { return group_of_type(name, SL<>(n)); }},
      {"U", '(', 1, any, 1, [](double n) { return n * n; },
       [](Name name, int n) { return group_of_type(name, U<>(n)); }},
      {"SU", '(', 2, any, 1, [](double n) { return n * n - 1; },
       [](Name name, int n) {
         return n == 2 ? unit_quaternion_matrices(name) : group_of_type(name, SU<>(n));
       }},
      {"Sp", '(', 2, any, 2, [](double n) { return n * (n + 1) / 2; },
       [](Name name, int n) { return group_of_type(name, Sp<>(n)); }},
      {"Aff", '(', 1, 1, 1, [](double) { return 2.0; },
       [](Name name, int) { return group_of_type(name, Aff1{}); }},
      {"Heisenberg", 0, 0, 0, 1, [](double) { return 3.0; },
       [](Name name, int) { return group_of_type(name, Heisenberg{}); }},
  };
  return families;
}

}  // namespace actio::detail
