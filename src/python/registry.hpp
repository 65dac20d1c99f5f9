// What the library knows by name, for Python: systems, bodies, groups.
#pragma once

#include <pybind11/pybind11.h>

namespace actio::python {

/// The bodies of the catalogue, a dictionary for each.
pybind11::list bodies();
/// The groups of the library, a dictionary for each.
pybind11::list groups();

}  // namespace actio::python
