#include "program/output/hdf5_library.hpp"

#include <dlfcn.h>

#include <algorithm>

#include "program/base/error.hpp"

namespace actio::scene::hdf5 {
namespace {

/// A function or a variable of a library.
void* found(void* library, char const* name) {
  void* const at = ::dlsym(library, name);
  if (!at)
    throw FileError(std::string(ACTIO_HDF5_LIBRARY) + ": is another version of HDF5: it has no " + name);
  return at;
}

std::mutex& use() {
  static std::mutex mutex;
  return mutex;
}
Library const& loaded() {
  static Library const library;
  return library;
}

/// The innermost message of the last error: of the system where it has one.
std::string message(Library const& library) {
  std::string text;
  library.H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_UPWARD,
      [](unsigned n, H5E_error2_t const* error, void* out) -> herr_t {
        if (n == 0 && error->desc) *static_cast<std::string*>(out) = error->desc;
        return 0;
      },
      &text);
  constexpr std::string_view before = "error message = '";
  if (auto const at = text.find(before); at != std::string::npos) {
    text.erase(0, at + before.size());
    text.erase(std::min(text.find('\''), text.size()));
  }
  return text.empty() ? "HDF5 does not say why" : text;
}

}  // namespace

Library::Library() {
  // A program that is linked with HDF5 has it already, and variables of its own copy.
  bool const linked = ::dlsym(RTLD_DEFAULT, "H5open");
  void* const library = linked ? RTLD_DEFAULT : ::dlopen(ACTIO_HDF5_LIBRARY, RTLD_LAZY | RTLD_LOCAL);
  if (!linked && !library) throw FileError(std::string("HDF5 cannot be loaded: ") + ::dlerror());
#define ACTIO_HDF5_FUNCTION(name) name = reinterpret_cast<decltype(name)>(found(library, #name));
#define ACTIO_HDF5_VARIABLE(name) name##_value = *static_cast<hid_t const*>(found(library, #name));
  ACTIO_HDF5_FUNCTIONS(ACTIO_HDF5_FUNCTION)
  // At the end of the process the library would try once more to write what a full disk has refused, and end
  // in a crash. It is not asked to: a series closes its file itself.
  H5dont_atexit();
  H5open();  // which gives the variables their values
  ACTIO_HDF5_VARIABLES(ACTIO_HDF5_VARIABLE)
#undef ACTIO_HDF5_FUNCTION
#undef ACTIO_HDF5_VARIABLE
}

Session::Session() : lock_(use()), library_(loaded()) {
  library_.H5Eget_auto2(H5E_DEFAULT, &print_, &print_to_);
  library_.H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}
Session::~Session() { library_.H5Eset_auto2(H5E_DEFAULT, print_, print_to_); }

hid_t Session::checked(hid_t result, std::string const& path, char const* what) const {
  if (result < 0) throw FileError(path + ": " + what + ": " + message(library_));
  return result;
}

std::string damage(std::string const& path, std::string const& name, std::size_t begin, std::size_t end) {
  return path + ": is damaged: rows " + std::to_string(begin) + " to " + std::to_string(end - 1) + " of '" +
         name +
         "' are not what was written (their checksum differs); put a copy of the file in its "
         "place, or run its scene.toml anew";
}

}  // namespace actio::scene::hdf5
