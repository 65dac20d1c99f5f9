#include "python/in_toml.hpp"

namespace actio::python {

namespace py = pybind11;

namespace {

std::string quoted(std::string const& text) {
  std::string out = "\"";
  for (char const c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (c == '\n') out += "\\n";
    else out += c;
  }
  return out + '"';
}

std::string list(py::handle items) {
  std::string out;
  for (py::handle const item : items) out += (out.empty() ? "" : ", ") + in_toml(item);
  return "[" + out + "]";
}

}  // namespace

std::string in_toml(py::handle value) {
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
  if (py::isinstance<py::int_>(value)) return std::to_string(value.cast<long long>());
  if (py::isinstance<py::float_>(value)) return py::repr(py::float_(value.cast<double>()));
  if (py::isinstance<py::str>(value)) return quoted(value.cast<std::string>());
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) return list(value);
  if (py::hasattr(value, "tolist")) return in_toml(value.attr("tolist")());
  if (py::hasattr(value, "__fspath__")) return quoted(py::str(value.attr("__fspath__")()));
  throw py::type_error("a scene holds numbers, texts, truths and lists of them, not " + std::string(py::str(py::type::of(value))));
}

std::vector<std::string> overrides(py::dict const& set) {
  std::vector<std::string> out;
  for (auto const& [key, value] : set) out.push_back(std::string(py::str(key)) + "=" + in_toml(value));
  return out;
}

}  // namespace actio::python
