#include <Eigen/Core>

#include "python/moments.hpp"

#include "actio/two_bodies/obj_file.hpp"

namespace actio::python {

namespace py = pybind11;

py::array_t<double> moments(std::string const& text, int order, double density, double length_unit) {
  std::vector<std::array<double, 4>> rows;
  {
    py::gil_scoped_release const release;
    auto const surface = bodies::parse_obj(text, length_unit);
    auto const of = bodies::polyhedron_moments<double>(surface, density, order);
    bodies::over_exponents(0, order, [&](int i, int j, int l) {
      rows.push_back({double(i), double(j), double(l), of(i, j, l)});
    });
  }
  py::array_t<double> out({py::ssize_t(rows.size()), py::ssize_t(4)});
  std::copy_n(rows.front().data(), 4 * rows.size(), out.mutable_data());
  return out;
}

}  // namespace actio::python
