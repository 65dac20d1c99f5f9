#include "program/output/hdf5_frames.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "program/base/whole_file.hpp"
#include "program/output/hdf5_attributes.hpp"
#include "program/output/hdf5_file.hpp"

namespace actio::scene {
namespace {

using hdf5::Handle, hdf5::Session;

std::size_t size_of(std::vector<std::size_t> const& shape) {
  std::size_t size = 1;
  for (std::size_t const n : shape) size *= n;
  return size;
}

/// The file and its data sets, open. After an error they are left as they are, since the library does not
/// close a file that it could not write.
class OpenFrames {
 public:
  explicit OpenFrames(std::string const& path) : path_(path) {}
  ~OpenFrames() {
    for (auto& set : sets_) set.abandon();
    file_.abandon();
  }
  OpenFrames(OpenFrames const&) = delete;
  OpenFrames& operator=(OpenFrames const&) = delete;

  Session const& library() const { return h5_; }
  hid_t file() const { return file_; }
  void create(std::string const& path) {
    Handle const how(h5_->H5Pcreate(h5_->H5P_CLS_FILE_CREATE_ID_g_value), h5_->H5Pclose);
    h5_->H5Pset_obj_track_times(how, false);  // equal runs leave equal bytes
    Handle const access = hdf5::access_to_growing_file(h5_);
    file_ = Handle(checked(h5_->H5Fcreate(path.c_str(), H5F_ACC_TRUNC, how, access), "cannot be opened"),
                   h5_->H5Fclose);
  }
  void open(unsigned flags) {
    Handle const access = hdf5::access_to_growing_file(h5_);
    file_ = Handle(checked(h5_->H5Fopen(path_.c_str(), flags, access), "cannot be opened"), h5_->H5Fclose);
  }
  hid_t open(Hdf5Frames::Field const& field) {
    Handle const how(h5_->H5Pcreate(h5_->H5P_CLS_DATASET_ACCESS_ID_g_value), h5_->H5Pclose);
    h5_->H5Pset_chunk_cache(how, 0, 0, 1);
    return keep(h5_->H5Dopen2(file_, field.name.c_str(), how), "cannot be opened");
  }
  /// Closes it together with the file.
  hid_t keep(hid_t set, char const* what) {
    sets_.emplace_back(checked(set, what), h5_->H5Dclose);
    return sets_.back();
  }
  /// Frames that a data set has, if its shape is that of the field.
  hsize_t frames_of(hid_t set, Hdf5Frames::Field const& field) const {
    Handle const space(checked(h5_->H5Dget_space(set), "cannot be read"), h5_->H5Sclose);
    std::vector<hsize_t> extent(1 + field.shape.size());
    if (h5_->H5Sget_simple_extent_ndims(space) != static_cast<int>(extent.size()) ||
        h5_->H5Sget_simple_extent_dims(space, extent.data(), nullptr) < 0 ||
        !std::equal(field.shape.begin(), field.shape.end(), extent.begin() + 1))
      throw FileError(path_ + ": the shape of '" + field.name + "' is not that of the scene");
    return extent[0];
  }
  void flush() const { checked(h5_->H5Fflush(file_, H5F_SCOPE_LOCAL), "cannot be written"); }
  void sync() const {
    void* at = nullptr;
    checked(h5_->H5Fget_vfd_handle(file_, H5P_DEFAULT, &at), "cannot be written");
    if (::fdatasync(*static_cast<int*>(at)) != 0 && errno != EINVAL)
      throw FileError(path_ + ": cannot be written: " + std::strerror(errno));
  }
  void close() {
    for (auto& set : sets_) checked(set.close(), "cannot be written");
    checked(file_.close(), "cannot be written");
  }
  hid_t checked(hid_t result, char const* what) const {
    try {
      return h5_.checked(result, path_, what);
    } catch (FileError const&) {
      std::string const system = hdf5::driver_failure();
      if (system.empty()) throw;
      throw FileError(path_ + ": " + what + ": " + system);
    }
  }

 private:
  std::string path_;
  Session h5_;
  Handle file_;
  std::vector<Handle> sets_;
};

/// The extent of a chunk, and of a data set, which begins with one frame where it has frames.
std::vector<hsize_t> extent_of(Hdf5Frames::Field const& field, bool frames, bool of_chunk) {
  constexpr std::size_t most = 1 << 18;  // numbers of a chunk
  std::vector<hsize_t> out;
  if (frames) out.push_back(of_chunk ? 1 : 0);
  out.insert(out.end(), field.shape.begin(), field.shape.end());
  std::size_t const chunks = (size_of(field.shape) + most - 1) / most;
  if (of_chunk && chunks > 1) {
    hsize_t& longest = out[frames ? 1 : 0];
    longest = (longest + chunks - 1) / chunks;
  }
  return out;
}

hid_t make(OpenFrames& open, std::string const& path, Hdf5Frames::Field const& field, bool frames,
           hid_t type) {
  Session const& h5 = open.library();
  auto const extent = extent_of(field, frames, false), chunk = extent_of(field, frames, true);
  auto most = extent;
  if (frames) most[0] = H5S_UNLIMITED;
  int const rank = static_cast<int>(extent.size());
  Handle const space(h5->H5Screate_simple(rank, extent.data(), most.data()), h5->H5Sclose);
  Handle const how(h5->H5Pcreate(h5->H5P_CLS_DATASET_CREATE_ID_g_value), h5->H5Pclose);
  open.checked(h5->H5Pset_chunk(how, rank, chunk.data()), "cannot be written");
  // The bytes of doubles that are alike stand side by side, and shrink.
  if (size_of(field.shape) > 1) {
    open.checked(h5->H5Pset_shuffle(how), "cannot be written");
    open.checked(h5->H5Pset_deflate(how, 1), "cannot be written");
  }
  open.checked(h5->H5Pset_fletcher32(how), "cannot be written");
  h5->H5Pset_obj_track_times(how, false);
  hid_t const made =
      open.keep(h5->H5Dcreate2(open.file(), field.name.c_str(), type, space, H5P_DEFAULT, how, H5P_DEFAULT),
                "cannot be written");
  hdf5::attach(h5, path, made, "meaning", field.meaning);
  hdf5::attach(h5, path, made, "unit", field.unit);
  if (!field.components.empty()) hdf5::attach(h5, path, made, "components", field.components);
  return made;
}

}  // namespace

Hdf5Frames::Hdf5Frames(std::string path, std::vector<Field> fields)
    : path_(std::move(path)), fields_(std::move(fields)) {
  fields_.push_back({"time", "of each frame", {}});
}

void Hdf5Frames::create(std::vector<std::pair<std::string, std::string>> const& texts,
                        std::vector<Constant> const& constants, std::string const& time_unit) const {
  // Under another name: before it can be read by anybody it does not have its own.
  std::string const part = path_ + ".part";
  struct stat there;
  if (::lstat(path_.c_str(), &there) == 0 && !S_ISREG(there.st_mode))
    throw FileError(path_ + ": cannot be opened: it is no ordinary file");
  ::unlink(part.c_str());
  OpenFrames open(path_);
  Session const& h5 = open.library();
  open.create(part);
  for (auto const& [name, text] : texts) hdf5::attach(h5, path_, open.file(), name.c_str(), text);
  for (auto const& [field, made_when_written, attributes] : constants) {
    auto const values = made_when_written();
    bool const counts = values.index() == 1;
    hid_t const type = counts ? h5->H5T_NATIVE_INT64_g_value : h5->H5T_NATIVE_DOUBLE_g_value;
    hid_t const set = make(open, path_, field, false, type);
    for (auto const& [name, text] : attributes) hdf5::attach(h5, path_, set, name.c_str(), text);
    void const* const from = std::visit([](auto const& all) -> void const* { return all.data(); }, values);
    open.checked(h5->H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, from), "cannot be written");
  }
  for (auto const& field : fields_) {
    hid_t const set = make(open, path_, field, true, h5->H5T_NATIVE_DOUBLE_g_value);
    if (&field == &fields_.back()) hdf5::attach(h5, path_, set, "unit", time_unit);
  }
  open.close();
  if (std::rename(part.c_str(), path_.c_str()) != 0)
    throw FileError(path_ + ": cannot be opened: " + std::strerror(errno));
}

void Hdf5Frames::cut(std::size_t frames) const {
  require_there(path_);
  // Heads of data sets alone are written: the chunks of other frames stay, and are written over.
  hdf5::HeadsOnly const heads_only;
  OpenFrames open(path_);
  open.open(H5F_ACC_RDWR);
  for (auto const& field : fields_) {
    hid_t const set = open.open(field);
    hsize_t const there = open.frames_of(set, field);
    if (there < frames)
      throw FileError(path_ + ": has " + std::to_string(there) + " frames, where the checkpoint needs " +
                      std::to_string(frames) + "; it was cut since");
    auto extent = extent_of(field, true, false);
    extent[0] = frames;
    if (there != frames)
      open.checked(open.library()->H5Dset_extent(set, extent.data()), "cannot be cut back");
  }
  open.close();
}

void Hdf5Frames::add(std::size_t frame, double time,
                     std::function<std::span<double const>(std::size_t)> const& numbers, bool durable) const {
  OpenFrames open(path_);
  Session const& h5 = open.library();
  open.open(H5F_ACC_RDWR | H5F_ACC_SWMR_WRITE);
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    hid_t const set = open.open(fields_[k]);
    auto first = extent_of(fields_[k], true, false), size = first;
    first.assign(first.size(), 0), first[0] = frame;
    size[0] = frame + 1;
    if (open.frames_of(set, fields_[k]) != frame)
      throw FileError(path_ + ": has other frames than those of this run; another program has written it");
    bool const is_time = k + 1 == fields_.size();
    if (is_time) open.flush();  // all that belongs to the frame is there before it counts
    open.checked(h5->H5Dset_extent(set, size.data()), "cannot be written");
    size[0] = 1;
    Handle const space(open.checked(h5->H5Dget_space(set), "cannot be written"), h5->H5Sclose);
    Handle const memory(h5->H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr),
                        h5->H5Sclose);
    h5->H5Sselect_hyperslab(space, H5S_SELECT_SET, first.data(), nullptr, size.data(), nullptr);
    open.checked(h5->H5Dwrite(set, h5->H5T_NATIVE_DOUBLE_g_value, memory, space, H5P_DEFAULT,
                              is_time ? &time : numbers(k).data()),
                 "cannot be written");
  }
  open.flush();
  if (durable) open.sync();
  open.close();
}

std::vector<double> Hdf5Frames::read(std::string const& name, std::size_t frame) const {
  auto const field =
      std::find_if(fields_.begin(), fields_.end(), [&](auto const& f) { return f.name == name; });
  OpenFrames open(path_);
  Session const& h5 = open.library();
  open.open(H5F_ACC_RDONLY | H5F_ACC_SWMR_READ);  // it may be written meanwhile
  hid_t const set = open.open(*field);
  open.frames_of(set, *field);
  auto size = extent_of(*field, true, true);
  std::copy(field->shape.begin(), field->shape.end(), size.begin() + 1);
  std::vector<hsize_t> first(size.size(), 0);
  first[0] = frame;
  Handle const space(open.checked(h5->H5Dget_space(set), "cannot be read"), h5->H5Sclose);
  Handle const memory(h5->H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr),
                      h5->H5Sclose);
  h5->H5Sselect_hyperslab(space, H5S_SELECT_SET, first.data(), nullptr, size.data(), nullptr);
  std::vector<double> out(size_of(field->shape));
  bool const read =
      h5->H5Dread(set, h5->H5T_NATIVE_DOUBLE_g_value, memory, space, H5P_DEFAULT, out.data()) >= 0;
  open.close();
  if (!read) throw FileError(hdf5::damage(path_, name, frame, frame + 1));
  return out;
}

}  // namespace actio::scene
