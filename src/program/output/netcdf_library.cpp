#include "program/output/netcdf_library.hpp"

#include <dlfcn.h>

#include "program/base/error.hpp"

namespace actio::scene::netcdf {

Library::Library() {
  void* const opened = ::dlopen(ACTIO_NETCDF_LIBRARY, RTLD_LAZY | RTLD_LOCAL);
  if (!opened) throw FileError(std::string("NetCDF cannot be loaded: ") + ::dlerror());
#define ACTIO_NETCDF_FUNCTION(name)              \
  if (void* const at = ::dlsym(opened, #name))   \
    name = reinterpret_cast<decltype(name)>(at); \
  else                                           \
    throw FileError(std::string(ACTIO_NETCDF_LIBRARY) + ": is another version of NetCDF: it has no " #name);
  ACTIO_NETCDF_FUNCTIONS(ACTIO_NETCDF_FUNCTION)
#undef ACTIO_NETCDF_FUNCTION
}

void Library::checked(int status, std::string const& path, char const* what) const {
  if (status != NC_NOERR) throw FileError(path + ": " + what + ": " + nc_strerror(status));
}

Library const& library(hdf5::Session const&) {
  static Library const loaded;
  return loaded;
}

}  // namespace actio::scene::netcdf
