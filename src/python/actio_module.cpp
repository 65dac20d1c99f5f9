// The compiled part of the package actio of Python: scenes are run, and their numbers are handed over without
// a copy. What a user sees is written in Python, in the folder actio beside this file, which checks every
// argument before it comes here.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <new>
#include <stdexcept>

#include "program/registry/registry_json.hpp"
#include "python/algebras.hpp"
#include "python/memory_run.hpp"
#include "python/moments.hpp"
#include "python/registry.hpp"
#include "python/run_watch.hpp"

namespace py = pybind11;
using namespace actio;
using python::MemoryRun;

namespace {

py::dict in_python(MemoryRun::Group const& group) {
  auto const& q = group.group.quantity;
  py::dict out;
  out["name"] = q.name, out["kind"] = kind_name(q.kind), out["unit"] = group.unit, out["meaning"] = q.meaning;
  out["formula"] = q.formula, out["statement"] = q.statement, out["needs"] = q.needs;
  out["conserved"] = q.conserved;
  out["columns"] = group.group.columns, out["shape"] = py::tuple(py::cast(group.group.shape()));
  return out;
}

/// The rows as an array that owns them.
py::array rows(std::vector<double>&& numbers, std::size_t columns) {
  auto held = std::make_unique<std::vector<double>>(std::move(numbers));
  double const* const first = held->data();
  std::size_t const count = held->size() / columns;
  py::capsule const owner(held.get(), [](void* at) { delete static_cast<std::vector<double>*>(at); });
  held.release();
  return py::array_t<double>({count, columns}, first, owner);
}

/// An array that owns its numbers, read-only.
py::array in_python(scene::SnapshotArray&& array, std::size_t snapshots) {
  std::vector<std::size_t> shape = array.shape;
  if (snapshots > 0) shape.insert(shape.begin(), snapshots);
  auto held = std::make_unique<std::vector<double>>(std::move(array.numbers));
  double const* const first = held->data();
  py::capsule const owner(held.get(), [](void* at) { delete static_cast<std::vector<double>*>(at); });
  held.release();
  return py::array_t<double>(shape, first, owner);
}
/// Times; then name, axes, array, meaning, unit, names along the last axis of each field and coordinate.
py::object in_python(python::MemorySnapshots&& snapshots) {
  auto const listed = [](std::vector<scene::SnapshotArray>& arrays, std::size_t count) {
    py::list out;
    for (auto& one : arrays) {
      py::dict about;
      about["name"] = one.name, about["axes"] = one.axes, about["meaning"] = one.meaning;
      about["unit"] = one.unit, about["names"] = one.names, about["counts"] = one.counts;
      about["numbers"] = in_python(std::move(one), count);
      out.append(about);
    }
    return out;
  };
  std::size_t const count = snapshots.times.size();
  py::dict out;
  out["t"] = py::array_t<double>(static_cast<py::ssize_t>(count), snapshots.times.data());
  out["fields"] = listed(snapshots.fields, count), out["coordinates"] = listed(snapshots.coordinates, 0);
  return out;
}

/// Table, what belongs to it, how the run ended, and what Python raised meanwhile.
py::tuple handed_over(MemoryRun&& run, py::object raised) {
  py::dict about;
  py::list quantities;
  for (auto const& group : run.groups) quantities.append(in_python(group));
  about["columns"] = run.columns, about["quantities"] = quantities, about["time_unit"] = run.time_unit;
  about["summary"] = run.summary, about["scene"] = run.scene;
  py::dict inputs;
  for (auto const& file : run.inputs)
    inputs[py::bytes(file.path)] = py::make_tuple(file.bytes, file.fingerprint);
  about["inputs"] = inputs, about["with_snapshots"] = run.with_snapshots;
  about["snapshots"] = in_python(std::move(run.snapshots));
  std::size_t const columns = run.columns.size();
  int const ending = static_cast<int>(run.report.ending);
  return py::make_tuple(rows(std::move(run.table), columns), about, ending, run.report.message,
                        std::move(raised));
}

/// The exception that waits in this thread, with its traceback; None where there is none.
py::object waiting() {
  if (!PyErr_Occurred()) return py::none();
  py::error_already_set const error;
  if (error.trace()) PyException_SetTraceback(error.value().ptr(), error.trace().ptr());
  return error.value();
}

using Changes = std::vector<std::pair<std::string, bool>>;

py::tuple run(std::string const& source, bool is_text, std::string const& name, Changes const& changes,
              py::object const& told) {
  std::vector<python::Change> list;
  for (auto const& [text, drop] : changes) list.push_back({text, drop});
  python::RunWatch watch(told);
  MemoryRun out;
  {
    py::gil_scoped_release const release;
    auto file = is_text ? scene::SceneFile::parse(source, name) : scene::SceneFile::read(source);
    try {
      out = python::run_in_memory(std::move(file), list, watch.functions());
    } catch (scene::Stopped const& stopped) {
      py::gil_scoped_acquire const hold;
      if (PyErr_Occurred()) throw py::error_already_set();
      throw scene::NumericsError(stopped.what());
    }
  }
  return handed_over(std::move(out), waiting());
}

py::tuple load(std::string const& folder) {
  MemoryRun out;
  {
    py::gil_scoped_release const release;
    out = python::load_run(folder);
  }
  return handed_over(std::move(out), py::none());
}

py::object snapshots(std::string const& folder) {
  python::MemorySnapshots out;
  {
    py::gil_scoped_release const release;
    out = python::load_snapshots(folder);
  }
  return in_python(std::move(out));
}

void save(std::string const& scene, py::array_t<double, py::array::c_style> const& table,
          std::string const& summary, std::string const& folder, bool pictures) {
  std::span<double const> const numbers(table.data(), static_cast<std::size_t>(table.size()));
  py::gil_scoped_release const release;
  python::save_run(scene, numbers, summary, folder, pictures);
}

/// What the standard library throws where memory ends, in words.
void translate_lack_of_memory(std::exception_ptr thrown) {
  static char const* const words = "the memory that is available does not suffice";
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (std::bad_alloc const&) {
    PyErr_SetString(PyExc_MemoryError, words);
  } catch (std::length_error const&) {
    PyErr_SetString(PyExc_MemoryError, words);
  }
}

}  // namespace

PYBIND11_MODULE(_actio, m) {
  m.doc() = "The compiled part of the package actio.";
  py::register_exception_translator(&translate_lack_of_memory);
  // Later ones are asked first.
  auto const error = py::register_exception<Error>(m, "Error");
  py::register_exception<scene::SceneError>(m, "SceneError", error);
  py::register_exception<scene::NumericsError>(m, "NumericsError", error);
  py::register_exception<scene::FileError>(m, "FileError", error);

  m.attr("version") = ACTIO_VERSION;
  m.def("run", &run);
  m.def("load", &load);
  m.def("snapshots", &snapshots);
  m.def("save", &save);
  m.def("systems", [] { return py::module_::import("json").attr("loads")(scene::registry_json()); });
  m.def("bodies", &python::bodies);
  m.def("groups", &python::groups);
  m.def("named_algebra", &python::named_algebra);
  m.def("spanned_algebra", &python::spanned_algebra);
  m.def("moments", &python::moments);
}
