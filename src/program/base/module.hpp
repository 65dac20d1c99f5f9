// Modules: parts of the program that bring large libraries along, loaded when they are first asked for.
//
// To link HDF5, NetCDF and OpenBLAS would add more to every start of the command than all the rest of it
// takes, and most runs have no use for them. So what calls them is compiled into modules of its own
// (src/program/loaded), linked with them in the usual way, which lie beside the program.
#pragma once

namespace actio::scene {

/// A function of a module, by the name that it has in C.
/// @param module  "actio_hdf5"
/// @throws FileError  where the module, or a library that it needs, cannot be loaded
void* function_of_module(char const* module, char const* name);

/// The same as a pointer to a function of this type.
template <class Function>
Function* of_module(char const* module, char const* name) {
  return reinterpret_cast<Function*>(function_of_module(module, name));
}

}  // namespace actio::scene
