// NetCDF as snapshots use it: loaded when a scene first asks for it, errors as exceptions.
//
//     hdf5::Session const session;           // the calling thread alone uses HDF5, which NetCDF writes with
//     netcdf::Library const& nc = netcdf::library(session);
//     nc.checked(nc.nc_close(file), path, "cannot be written");
//
// It brings a client of the network along with it, for which no other run has a use.
#pragma once

#include <netcdf.h>

#include <string>

#include "program/output/hdf5_library.hpp"

namespace actio::scene::netcdf {

/// The functions that are called: `of` is put round each name.
#define ACTIO_NETCDF_FUNCTIONS(of)                                                                    \
  of(nc_create) of(nc_open) of(nc_close) of(nc_enddef) of(nc_strerror) of(nc_def_grp) of(nc_inq_ncid) \
      of(nc_def_dim) of(nc_def_var) of(nc_def_var_chunking) of(nc_inq_varid) of(nc_put_att_text)      \
          of(nc_put_var_double) of(nc_put_var_int) of(nc_put_vara_double)

/// The library, loaded.
struct Library {
  /// @throws FileError  where it is not on this machine
  Library();
/// \cond
#define ACTIO_NETCDF_FUNCTION(name) decltype(&::name) name;
  ACTIO_NETCDF_FUNCTIONS(ACTIO_NETCDF_FUNCTION)
#undef ACTIO_NETCDF_FUNCTION
  /// \endcond
  /// @throws FileError  where this is an error: the path, what was tried, and what the library says
  void checked(int status, std::string const& path, char const* what) const;
};

/// The library, for who has a session of HDF5.
/// @throws FileError  where it cannot be loaded
Library const& library(hdf5::Session const& session);

}  // namespace actio::scene::netcdf
