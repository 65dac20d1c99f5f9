// HDF5 as the series uses it: loaded when a scene first asks for it, used by one thread at a time, errors as
// exceptions, handles that close themselves.
//
//     Session const h5;
//     Handle const file(h5.checked(h5->H5Fopen(...), path, "cannot be opened"), h5->H5Fclose);
//
// The library brings forty others along. To link it would add ten milliseconds to every start of the command,
// of which most have no use for it.
#pragma once

#include <hdf5.h>

#include <mutex>
#include <string>
#include <utility>

// Constants of HDF5 call it, through these two, before they give their value. It is open when they are used.
/// \cond
#undef H5OPEN
#undef H5CHECK
#define H5OPEN
#define H5CHECK
/// \endcond

namespace actio::scene::hdf5 {

/// The functions of HDF5 that the series calls: `of` is put round each name.
#define ACTIO_HDF5_FUNCTIONS(of)                                                                          \
  of(H5open) of(H5dont_atexit) of(H5Eget_auto2) of(H5Eset_auto2) of(H5Ewalk2) of(H5Acreate2) of(H5Aclose) \
      of(H5Awrite) of(H5Dcreate2) of(H5Dopen2) of(H5Dclose) of(H5Dget_space) of(H5Dget_create_plist)      \
          of(H5Dset_extent) of(H5Dwrite) of(H5Dread) of(H5Dread_chunk) of(H5Dget_chunk_storage_size)      \
              of(H5Dwrite_chunk) of(H5FDregister) of(H5Fcreate) of(H5Fopen) of(H5Fclose) of(H5Fflush)     \
                  of(H5Fget_vfd_handle) of(H5Pcreate) of(H5Pclose) of(H5Pset_chunk) of(H5Pget_chunk)      \
                      of(H5Pset_chunk_cache) of(H5Pset_deflate) of(H5Pset_driver) of(H5Pset_fill_time)    \
                          of(H5Pset_file_locking) of(H5Pset_fletcher32) of(H5Pset_libver_bounds)          \
                              of(H5Pset_obj_track_times) of(H5Pset_shuffle) of(H5Screate)                 \
                                  of(H5Screate_simple) of(H5Sclose) of(H5Sget_simple_extent_dims)         \
                                      of(H5Sget_simple_extent_ndims) of(H5Sselect_hyperslab) of(H5Tcopy)  \
                                          of(H5Tclose) of(H5Tset_cset) of(H5Tset_size)
/// Its classes of properties and types of numbers, which are variables in it: `of` is put round each name.
#define ACTIO_HDF5_VARIABLES(of)                                                            \
  of(H5P_CLS_FILE_ACCESS_ID_g) of(H5P_CLS_FILE_CREATE_ID_g) of(H5P_CLS_DATASET_CREATE_ID_g) \
      of(H5P_CLS_DATASET_ACCESS_ID_g) of(H5T_C_S1_g) of(H5T_NATIVE_DOUBLE_g) of(H5T_NATIVE_INT64_g)

/// The library, loaded.
struct Library {
  /// @throws FileError  where it is not on this machine
  Library();
/// \cond
#define ACTIO_HDF5_FUNCTION(name) decltype(&::name) name;
#define ACTIO_HDF5_VARIABLE(name) hid_t name##_value;
  ACTIO_HDF5_FUNCTIONS(ACTIO_HDF5_FUNCTION)
  ACTIO_HDF5_VARIABLES(ACTIO_HDF5_VARIABLE)
#undef ACTIO_HDF5_FUNCTION
#undef ACTIO_HDF5_VARIABLE
  /// \endcond
};

/// While it lives the calling thread alone uses the library, which prints no errors of its own.
class Session {
 public:
  /// @throws FileError  where the library cannot be loaded
  Session();
  ~Session();
  Session(Session const&) = delete;
  Session& operator=(Session const&) = delete;

  /// The functions of the library.
  Library const* operator->() const { return &library_; }
  /// What an operation returned, where it went well.
  /// @throws FileError  otherwise: the path, what was tried, and the innermost message of the library
  hid_t checked(hid_t result, std::string const& path, char const* what) const;

 private:
  std::unique_lock<std::mutex> lock_;
  Library const& library_;
  H5E_auto2_t print_ = nullptr;
  void* print_to_ = nullptr;
};

/// That rows of a data set, up to the one before `end`, are not what was written, and what to do.
std::string damage(std::string const& path, std::string const& name, std::size_t begin, std::size_t end);

/// Something of the library that is closed at the end.
class Handle {
 public:
  /// The function of the library that closes it.
  using Close = herr_t (*)(hid_t);

  Handle() = default;
  /// @param id  negative: nothing to close
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  /// Takes over what the other one would close.
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  /// Exchanges the two: the other one closes what this one had.
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_), std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() { close(); }

  /// Its number in the library; negative where there is nothing to close.
  operator hid_t() const { return id_; }
  /// @return negative where the library could not
  herr_t close() { return id_ < 0 ? 0 : close_(std::exchange(id_, -1)); }
  /// Leaves it open for good.
  void abandon() { id_ = -1; }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

}  // namespace actio::scene::hdf5
