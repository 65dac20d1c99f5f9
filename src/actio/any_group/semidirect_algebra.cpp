#include <Eigen/Core>

#include "actio/any_group/semidirect_algebra.hpp"

namespace actio::systems {

MatrixAlgebra semidirect_algebra(MatrixAlgebra const& group, int vectors, int length,
                                 std::vector<std::string> const& names) {
  if (length != group.size)
    throw OutsideDomain("semidirect_algebra",
                        "carried vectors have as many components as the matrices have rows; components",
                        length, group.size);
  if (vectors < 1 || vectors * static_cast<double>(length) > 128)
    throw OutsideDomain("semidirect_algebra", "carried vectors must have from 1 to 128 components together",
                        vectors * static_cast<double>(length), vectors < 1 ? 1 : 128);
  int const n = group.size;
  std::vector<Eigen::MatrixXd> basis;
  for (auto const& e : group.basis) {
    basis.push_back(Eigen::MatrixXd::Zero(n + vectors, n + vectors));
    basis.back().topLeftCorner(n, n) = -e.transpose();
  }
  std::vector<std::string> components = group.components;
  for (int k = 0; k < vectors; ++k)
    for (int i = 0; i < n; ++i) {
      basis.push_back(Eigen::MatrixXd::Zero(n + vectors, n + vectors));
      basis.back()(i, n + k) = 1;
      auto const which = static_cast<std::size_t>(k);
      std::string const stem = which < names.size() ? names[which]
                               : vectors == 1       ? "a"
                                                    : "a" + std::to_string(k + 1) + "_";
      components.push_back(stem + std::to_string(i + 1));
    }
  MatrixAlgebra algebra = detail::algebra_of_basis(
      group.name + " with " + std::to_string(vectors) + (vectors == 1 ? " vector" : " vectors"),
      std::move(basis));
  algebra.components = std::move(components);
  return algebra;
}

}  // namespace actio::systems
