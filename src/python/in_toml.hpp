// Values of Python as a scene writes them.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace actio::python {

/// `0.1`, `true`, `"a text"`, `[1, 2]`; of NumPy what has a method `tolist`.
/// @throws pybind11::type_error  where a scene has no such value
std::string in_toml(pybind11::handle value);

/// KEY=VALUE for each entry of a dictionary.
std::vector<std::string> overrides(pybind11::dict const& set);

}  // namespace actio::python
