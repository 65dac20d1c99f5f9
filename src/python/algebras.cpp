#include <Eigen/Core>

#include "python/algebras.hpp"

#include <pybind11/stl.h>

#include "actio/any_group/named_algebra.hpp"

namespace actio::python {

namespace py = pybind11;

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

py::dict in_python(systems::MatrixAlgebra const& algebra) {
  py::array_t<double> basis({algebra.dimension, algebra.size, algebra.size});
  for (int a = 0; a < algebra.dimension; ++a)
    Eigen::Map<RowMajor>(basis.mutable_data(a, 0, 0), algebra.size, algebra.size) =
        algebra.basis[static_cast<std::size_t>(a)];
  py::dict out;
  out["name"] = algebra.name, out["components"] = algebra.components, out["basis"] = basis;
  return out;
}

}  // namespace

py::dict named_algebra(std::string const& name) { return in_python(actio::systems::named_algebra(name)); }

py::dict spanned_algebra(py::array_t<double, py::array::c_style> const& basis) {
  std::vector<Eigen::MatrixXd> matrices;
  for (py::ssize_t a = 0; a < basis.shape(0); ++a)
    matrices.emplace_back(Eigen::Map<RowMajor const>(basis.data(a, 0, 0), basis.shape(1), basis.shape(2)));
  return in_python(actio::systems::spanned_algebra(std::move(matrices)));
}

}  // namespace actio::python
