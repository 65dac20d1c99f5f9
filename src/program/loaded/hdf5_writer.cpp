// Files in HDF5.
#include <hdf5.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "program/output/array_file.hpp"

namespace actio::scene {
namespace {

/// The innermost message of the last error: of the system where it has one.
std::string message() {
  std::string text;
  H5Ewalk2(
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
hid_t checked(hid_t result) {
  if (result < 0) throw std::runtime_error(message());
  return result;
}

/// Something of the library that is closed at the end.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close) : id_(checked(id)), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }
  void close() { checked(close_(std::exchange(id_, -1))); }

 private:
  hid_t id_;
  Close close_;
};

/// The library prints no errors of its own meanwhile.
class Quiet {
 public:
  Quiet() {
    // At the end of the process it would try once more to write what a full disk has refused, and end in a
    // crash.
    H5dont_atexit();
    H5Eget_auto2(H5E_DEFAULT, &print_, &to_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Quiet() { H5Eset_auto2(H5E_DEFAULT, print_, to_); }
  Quiet(Quiet const&) = delete;
  Quiet& operator=(Quiet const&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* to_ = nullptr;
};

Handle made(std::string const& path) {
  Handle const how(H5Pcreate(H5P_FILE_CREATE), H5Pclose), access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  checked(H5Pset_obj_track_times(how, false));  // equal runs leave equal bytes
  // Texts of any length, such as a whole scene, can stand beside the numbers.
  checked(H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110));
  return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, how, access), H5Fclose};
}

class Hdf5Writer : public ArrayWriter {
 public:
  Hdf5Writer(std::string const& path, std::vector<ArrayAttribute> const& attributes,
             std::vector<ArraySet> const& sets)
      : file_(made(path)) {
    for (auto const& one : attributes) attach(file_, one);
    for (auto const& set : sets) define(set);
  }
  void put(std::size_t set, std::size_t first, std::size_t count, double const* numbers) override {
    Set& to = sets_[set];
    std::vector<hsize_t> start(to.extent.size(), 0), size = to.extent;
    if (to.grows) {
      to.extent[0] = std::max<hsize_t>(to.extent[0], first + count);
      checked(H5Dset_extent(to.id, to.extent.data()));
      start[0] = first;
    }
    size[0] = count;
    Handle const space(H5Dget_space(to.id), H5Sclose),
        memory(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose);
    checked(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr));
    checked(H5Dwrite(to.id, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, numbers));
  }
  void close() override {
    for (auto& set : sets_) set.id.close();
    file_.close();
  }

 private:
  struct Set {
    Handle id;
    std::vector<hsize_t> extent;
    bool grows;
  };

  static void attach(hid_t object, ArrayAttribute const& attribute) {
    if (!attribute.list && attribute.texts.front().empty()) return;
    Handle const type(H5Tcopy(H5T_C_S1), H5Tclose);
    checked(H5Tset_size(type, H5T_VARIABLE)), checked(H5Tset_cset(type, H5T_CSET_UTF8));
    hsize_t const size = attribute.texts.size();
    Handle const space(attribute.list ? H5Screate_simple(1, &size, nullptr) : H5Screate(H5S_SCALAR),
                       H5Sclose),
        id(H5Acreate2(object, attribute.name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    std::vector<char const*> pointers;
    for (auto const& text : attribute.texts) pointers.push_back(text.c_str());
    checked(H5Awrite(id, type, pointers.data()));
  }
  void define(ArraySet const& set) {
    std::vector<hsize_t> extent, most;
    for (auto const& axis : set.axes)
      extent.push_back(axis.length), most.push_back(axis.length > 0 ? axis.length : H5S_UNLIMITED);
    std::vector<hsize_t> const chunk(set.chunk.begin(), set.chunk.end());
    int const rank = static_cast<int>(extent.size());
    Handle const space(H5Screate_simple(rank, extent.data(), most.data()), H5Sclose),
        how(H5Pcreate(H5P_DATASET_CREATE), H5Pclose), access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose);
    if (!chunk.empty()) checked(H5Pset_chunk(how, rank, chunk.data()));
    // The bytes of doubles that are alike stand side by side, and shrink.
    if (set.compressed) checked(H5Pset_shuffle(how)), checked(H5Pset_deflate(how, 1));
    if (!chunk.empty()) checked(H5Pset_fletcher32(how));
    checked(H5Pset_fill_time(how, H5D_FILL_TIME_NEVER));  // there is nothing but what is written
    checked(H5Pset_obj_track_times(how, false));
    checked(H5Pset_chunk_cache(access, 0, 0, 1));  // whole chunks are written
    Handle id(H5Dcreate2(file_, set.name.c_str(), set.counts ? H5T_NATIVE_INT64 : H5T_NATIVE_DOUBLE, space,
                         H5P_DEFAULT, how, access),
              H5Dclose);
    for (auto const& one : set.attributes) attach(id, one);
    bool const grows = !set.axes.empty() && set.axes.front().length == 0;
    sets_.push_back({std::move(id), std::move(extent), grows});
  }

  Quiet const quiet_;
  Handle file_;
  std::vector<Set> sets_;
};

}  // namespace
}  // namespace actio::scene

/// \copydoc actio::scene::MakeArrayWriter
extern "C" actio::scene::ArrayWriter* actio_array_writer(
    std::string const& path, std::vector<actio::scene::ArrayAttribute> const& attributes,
    std::vector<actio::scene::ArraySet> const& sets) {
  return new actio::scene::Hdf5Writer(path, attributes, sets);
}
