#include "program/output/array_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "program/base/error.hpp"
#include "program/base/module.hpp"

namespace actio::scene {
namespace {

/// The libraries are used by one thread at a time.
std::mutex& use() {
  static std::mutex mutex;
  return mutex;
}
[[noreturn]] void fail() { throw std::runtime_error(std::strerror(errno)); }

}  // namespace

ArrayFile::ArrayFile(Format format, std::string path, std::vector<ArrayAttribute> const& attributes,
                     std::vector<ArraySet> const& sets)
    : lock_(use()), path_(std::move(path)), part_(path_ + ".part") {
  for (auto const& set : sets) widths_.push_back(set.width());
  auto* const make = of_module<MakeArrayWriter>(format == Format::hdf5 ? "actio_hdf5" : "actio_netcdf",
                                                "actio_array_writer");
  ::unlink(part_.c_str());  // it might be a link
  guarded([&] { writer_.reset(make(part_, attributes, sets)); });
}
ArrayFile::~ArrayFile() {
  if (part_.empty()) return;
  // A library may keep open what it could not write: that takes no room.
  [[maybe_unused]] int const cut = ::truncate(part_.c_str(), 0);
  ::unlink(part_.c_str());
}

void ArrayFile::put(std::size_t set, std::size_t first, std::span<double const> numbers) {
  guarded([&] { writer_->put(set, first, numbers.size() / widths_[set], numbers.data()); });
}
void ArrayFile::name(bool durable) {
  guarded([&] {
    writer_->close();
    int const file = durable ? ::open(part_.c_str(), O_RDONLY | O_CLOEXEC) : -1;
    if (durable && (file < 0 || (::fsync(file) != 0 && errno != EINVAL))) fail();
    if (file >= 0) ::close(file);
    if (std::rename(part_.c_str(), path_.c_str()) != 0) fail();
    part_.clear();
  });
}

template <class Act>
void ArrayFile::guarded(Act const& act) const {
  try {
    act();
  } catch (std::runtime_error const& error) {
    throw FileError(path_ + ": cannot be written: " + error.what());
  }
}

}  // namespace actio::scene
