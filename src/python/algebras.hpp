// Lie algebras of groups of matrices, for Python.
#pragma once

#include <pybind11/numpy.h>

#include <string>

namespace actio::python {

/// The algebra of a group by its name: a dictionary with the name as the library writes it, `components` of a
/// velocity, and `basis`, an array of dimension by n by n.
/// @throws Error  where no group has that name
pybind11::dict named_algebra(std::string const& name);

/// The same of a basis, an array of dimension by n by n; its name is empty.
/// @throws Error  where the matrices are not independent, or a commutator leaves their span
pybind11::dict spanned_algebra(pybind11::array_t<double, pybind11::array::c_style> const& basis);

}  // namespace actio::python
