#include <Eigen/Core>

#include "actio/any_group/group_families.hpp"

namespace actio::systems {

namespace detail {
namespace {

/// \f$\mathbb R^n\f$ as the matrices ((1, x), (0, 1)).
GroupOfMatrices translation_matrices(std::string const& name, int n) {
  GroupOfMatrices made{name, {}, [n](Eigen::MatrixXd const& g) {
                         Eigen::MatrixXd rest = g - Eigen::MatrixXd::Identity(n + 1, n + 1);
                         rest.col(n).head(n).setZero();
                         return row_norm(rest);
                       }};
  for (int i = 0; i < n; ++i) made.basis.push_back(elementary_matrix(n + 1, i, n));
  return made;
}

/// GL(n): the entries row by row.
GroupOfMatrices general_linear_matrices(std::string const& name, int n) {
  GroupOfMatrices made{name, {}, [](Eigen::MatrixXd const& g) {
                         return distance_from_positive(determinant_by_elimination(Matrix<double>(g)));
                       }};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) made.basis.push_back(elementary_matrix(n, i, j));
  return made;
}

}  // namespace

GroupOfMatrices product_matrices(GroupOfMatrices const& g, GroupOfMatrices const& h) {
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

GroupOfMatrices semidirect_matrices(GroupOfMatrices const& g, std::string const& space) {
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

std::vector<GroupFamily> const& group_families() {
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

}  // namespace detail

}  // namespace actio::systems
