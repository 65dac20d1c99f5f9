#include <Eigen/Core>

#include "python/registry.hpp"

#include "program/catalogue/bodies.hpp"
#include "program/catalogue/groups.hpp"

namespace actio::python {

namespace py = pybind11;

namespace {

py::list numbers(Eigen::Vector3d const& v) {
  py::list out;
  for (int i = 0; i < 3; ++i) out.append(v[i]);
  return out;
}
py::list rows(Eigen::Matrix3d const& m) {
  py::list out;
  for (int i = 0; i < 3; ++i) out.append(numbers(m.row(i).transpose()));
  return out;
}

}  // namespace

py::list bodies() {
  py::list out;
  for (auto const& body : scene::library_bodies()) {
    py::dict one;
    one["name"] = body.name, one["title"] = body.title;
    one["moments"] = numbers(body.principal.inertia.moments), one["unit"] = body.unit;
    one["axes"] = rows(body.principal.axes), one["spin"] = numbers(body.spin.coordinates),
    one["time"] = body.time;
    one["source"] = body.source, one["derived"] = body.derived;
    out.append(one);
  }
  return out;
}

py::list groups() {
  py::list out;
  for (auto const& group : scene::library_groups()) {
    py::dict one;
    one["name"] = group.name, one["dimension"] = group.dimension, one["meaning"] = group.meaning;
    one["coordinates"] = group.coordinates, one["type"] = group.type, one["header"] = group.header;
    one["statement"] = group.statement, one["components"] = scene::components_of(group);
    out.append(one);
  }
  return out;
}

}  // namespace actio::python
