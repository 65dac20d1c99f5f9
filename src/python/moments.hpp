// Moments of mass of a body, for Python.
#pragma once

#include <pybind11/numpy.h>

#include <string>

namespace actio::python {

/// Those of the homogeneous body within a closed surface, about the origin of its file.
/// @param text         in the format .obj
/// @param order        the largest i + j + l
/// @param density      mass/length^3
/// @param length_unit  what a length of 1 in the text is
/// @return  rows i, j, l, moment, by increasing order
/// @throws Error  where the text has no meaning, or the surface is not closed or inside out
pybind11::array_t<double> moments(std::string const& text, int order, double density, double length_unit);

}  // namespace actio::python
