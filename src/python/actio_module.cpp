// The module actio of Python: scenes are run, and their numbers are NumPy arrays.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "python/in_toml.hpp"
#include "python/memory_run.hpp"

namespace py = pybind11;
using namespace actio;
using python::MemoryRun;

namespace {

/// Looks for Ctrl-C ten times a second; whether Python has an exception waiting.
class SignalWatch {
 public:
  bool operator()() {
    auto const now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(100)) return false;
    last_ = now;
    py::gil_scoped_acquire const hold;
    return PyErr_CheckSignals() != 0;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

MemoryRun run(std::optional<py::object> const& scene, std::optional<std::string> const& text, std::optional<py::dict> const& set) {
  if (scene.has_value() == text.has_value()) throw py::type_error("run: either the path of a scene or text=... is needed");
  auto const overrides = set ? python::overrides(*set) : std::vector<std::string>{};
  std::string const path = scene ? std::string(py::str(*scene)) : "text";
  MemoryRun out;
  {
    py::gil_scoped_release const release;
    auto file = text ? scene::SceneFile::parse(*text, path, overrides) : scene::SceneFile::read(path, overrides);
    out = python::run_in_memory(std::move(file), SignalWatch());
  }
  if (PyErr_Occurred()) throw py::error_already_set();
  return out;
}

/// Columns of the table as an array that looks into it and keeps the run alive.
py::array view(py::object const& self, std::size_t first, std::vector<py::ssize_t> const& shape) {
  auto const& run = self.cast<MemoryRun const&>();
  std::vector<py::ssize_t> whole{static_cast<py::ssize_t>(run.rows())}, strides{static_cast<py::ssize_t>(run.columns.size() * sizeof(double))};
  py::ssize_t stride = sizeof(double);
  for (auto it = shape.rbegin(); it != shape.rend(); ++it) strides.insert(strides.begin() + 1, std::exchange(stride, stride * *it));
  whole.insert(whole.end(), shape.begin(), shape.end());
  py::array out(py::dtype::of<double>(), whole, strides, run.table.data() + first, self);
  out.attr("flags").attr("writeable") = false;
  return out;
}

/// A quantity, each in its shape, or a single column.
py::array item(py::object const& self, std::string const& name) {
  auto const& run = self.cast<MemoryRun const&>();
  std::size_t first = 1;
  for (auto const& group : run.groups) {
    auto const shape = group.shape();
    if (group.quantity.name == name) return view(self, first, {shape.begin(), shape.end()});
    first += group.columns.size();
  }
  auto const column = std::find(run.columns.begin(), run.columns.end(), name);
  if (column == run.columns.end()) throw py::key_error(name);
  return view(self, static_cast<std::size_t>(column - run.columns.begin()), {});
}

std::vector<std::string> quantities(MemoryRun const& run) {
  std::vector<std::string> out;
  for (auto const& group : run.groups) out.push_back(group.quantity.name);
  return out;
}

}  // namespace

PYBIND11_MODULE(actio, m) {
  m.doc() = "Mechanics on Lie groups, step by step, from one action principle.";
  // Later ones are asked first.
  auto const error = py::register_exception<Error>(m, "Error");
  py::register_exception<scene::SceneError>(m, "SceneError", error).doc() = "The scene is wrong; the message names place, what was found and what is allowed.";
  py::register_exception<scene::NumericsError>(m, "NumericsError", error).doc() = "The numerics failed: a step too long, no convergence.";
  py::register_exception<scene::FileError>(m, "FileError", error).doc() = "A file could not be read.";

  py::class_<MemoryRun>(m, "Run", "A run, held in memory as one table of doubles. Arrays look into it, without a copy, and keep it alive; they cannot be written to.")
      .def_property_readonly("t", [](py::object const& self) { return item(self, "t"); }, "The times of the rows.")
      .def_property_readonly("table", [](py::object const& self) { return view(self, 0, {static_cast<py::ssize_t>(self.cast<MemoryRun const&>().columns.size())}); }, "All columns, the time first.")
      .def_readonly("columns", &MemoryRun::columns, "Names of the columns of the table.")
      .def_property_readonly("quantities", &quantities, "Names of the quantities.")
      .def_property_readonly("summary", [](MemoryRun const& run) { return py::module_::import("json").attr("loads")(run.summary); }, "What summary.json holds, as a dictionary.")
      .def_readonly("scene", &MemoryRun::scene, "The scene with every default written out, in TOML.")
      .def("__getitem__", &item, "A quantity, with one row per instant and the shape of the quantity; or a column.")
      .def("keys", &quantities)
      .def("__iter__", [](MemoryRun const& run) { return py::iter(py::cast(quantities(run))); })
      .def("__len__", &MemoryRun::rows, "The number of rows.")
      .def("__repr__", [](MemoryRun const& run) { return "<actio.Run: " + std::to_string(run.rows()) + " rows of " + std::to_string(run.columns.size()) + " columns>"; });

  m.def("run", &run, py::arg("scene") = py::none(), py::kw_only(), py::arg("text") = py::none(), py::arg("set") = py::none(),
        "Runs a scene and returns its Run.\n\n"
        "scene: the path of a scene, in TOML; or text: the scene itself.\n"
        "set: keys to override, for example {\"method.order\": 4, \"system.body\": \"apophis\"}.\n\n"
        "No file is written. The whole table is held in memory: 8 bytes for each number, rows times columns. What is larger is run by the command `actio run`, which\n"
        "writes as it goes. Other threads go on meanwhile; Ctrl-C ends the run with KeyboardInterrupt.\n\n"
        "Raises SceneError, NumericsError or FileError, all of them Error, with the message that the command would give.");
}
