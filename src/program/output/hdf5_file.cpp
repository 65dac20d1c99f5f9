#include "program/output/hdf5_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>

#include "program/base/error.hpp"
#include "program/output/hdf5_checksums.hpp"
#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

namespace actio::scene::hdf5 {
namespace {

/// Why the driver failed: of the thread that has the session.
int last_error = 0;
/// Whether files that are opened now take heads of data sets only.
bool heads_only = false;
/// Where the next room for numbers is taken, zero being anywhere, and where numbers were last.
haddr_t next_numbers = 0, last_numbers = 0;

/// Writes all of it. @return false where the system refuses
bool write_all(int file, void const* from, std::size_t size, off_t at) {
  for (auto const* bytes = static_cast<char const*>(from); size > 0;) {
    ssize_t const n = ::pwrite(file, bytes, size, at);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return last_error = n < 0 ? errno : ENOSPC, false;
    bytes += n, at += n, size -= static_cast<std::size_t>(n);
  }
  return true;
}
/// Reads all of it; what is beyond the end of the file is zero.
bool read_all(int file, void* into, std::size_t size, off_t at) {
  for (auto* bytes = static_cast<char*>(into); size > 0;) {
    ssize_t const n = ::pread(file, bytes, size, at);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return last_error = errno, false;
    if (n == 0) return std::fill_n(bytes, size, '\0'), true;
    bytes += n, at += n, size -= static_cast<std::size_t>(n);
  }
  return true;
}

/// A superblock of version 3 with addresses of eight bytes, which is all that this program writes.
struct Superblock {
  static constexpr std::size_t size = 48, version = 8, marks = 11, end = 28, checksum = 44;
  unsigned char bytes[size] = {};

  bool valid() const {
    return bytes[version] == 3 && bytes[version + 1] == 8 &&
           decoded<std::uint32_t>(bytes + checksum) == metadata_checksum(std::span(bytes).first(checksum));
  }
  haddr_t end_of_file() const { return decoded<std::uint64_t>(bytes + end); }
  /// Of a closed file that ends there.
  void close_at(haddr_t at) {
    bytes[marks] = 0;
    encode<std::uint64_t>(bytes + end, at);
    encode<std::uint32_t>(bytes + checksum, metadata_checksum(std::span(bytes).first(checksum)));
  }
};

/// The true end of the file, after the end that the superblock tells.
struct Trailer {
  std::uint64_t end, complement;
  bool valid() const { return end != 0 && complement == ~end; }
};

/// A file that is open. The library knows no more of it than its first member.
struct GrowingFile {
  H5FD_t common = {};
  int file = -1;
  dev_t device = 0;
  ino_t inode = 0;
  bool changed = false, failed = false, heads_only = false;
  haddr_t used = 0;      // what the library has laid out
  haddr_t told = 0;      // the end that the superblock on the disk tells; zero before there is one
  haddr_t reserved = 0;  // up to here the disk has room
  haddr_t true_end = 0;  // of a file whose writer was killed; zero where its superblock tells it
  Superblock superblock;
  std::chrono::steady_clock::time_point then = std::chrono::steady_clock::now();
  haddr_t used_then = 0;  // when the end was told last

  bool fail() { return failed = true, false; }

  /// What a writer before has left.
  void look() {
    struct stat now;
    if (::fstat(file, &now) != 0 || !read_all(file, superblock.bytes, Superblock::size, 0) ||
        !superblock.valid())
      return;
    told = superblock.end_of_file();
    Trailer trailer = {};
    if (static_cast<haddr_t>(now.st_size) == told + sizeof trailer &&
        read_all(file, &trailer, sizeof trailer, static_cast<off_t>(told)) && trailer.valid() &&
        trailer.end <= told)
      true_end = trailer.end;
    reserved = used_then = true_end ? true_end : told;
  }

  /// An end of the file beyond what there is, before it grows.
  void begin() {
    if (told == 0 || true_end != 0) return;
    used = told, changed = true;
    if (!tell_end(used + ahead())) tell_end(used);
    true_end = used;
  }

  /// Room on the disk for all that the library has laid out, and an end of the file beyond it: what is
  /// written next may tell of any place before.
  bool make_room() {
    if (used <= reserved) return true;
    int const error =
        ::posix_fallocate(file, static_cast<off_t>(reserved), static_cast<off_t>(used - reserved));
    // Where nothing can be reserved, the writing itself tells whether there is room.
    bool const reserves = error != ENODEV && error != EINVAL && error != EOPNOTSUPP && error != ESPIPE;
    if (error != 0 && reserves) return last_error = error, fail();
    reserved = used;
    if (told == 0) return true;  // it is being made
    if (used <= told) return write_trailer() || fail();
    // As much beyond it as some seconds will take; where the system has a limit, no more than is used.
    return tell_end(used + ahead()) || tell_end(used) || fail();
  }
  /// A megabyte and, at the speed since the last time, what a reader may take to look at all of the file.
  haddr_t ahead() {
    constexpr double seconds = 10, most = 1 << 30;
    auto const now = std::chrono::steady_clock::now();
    double const passed = std::max(0.1, std::chrono::duration<double>(now - then).count());
    double const grown = used > used_then ? static_cast<double>(used - used_then) : 0;
    then = now, used_then = used;
    return (1 << 20) + static_cast<haddr_t>(std::min(most, seconds * grown / passed));
  }
  bool tell_end(haddr_t end) {
    haddr_t const before = told;
    told = end;
    if (::ftruncate(file, static_cast<off_t>(end + sizeof(Trailer))) == 0 && write_trailer() &&
        write_superblock())
      return true;
    return last_error = errno, told = before, false;
  }
  bool write_trailer() const {
    Trailer const trailer{used, ~static_cast<std::uint64_t>(used)};
    return write_all(file, &trailer, sizeof trailer, static_cast<off_t>(told));
  }
  bool write_superblock() {
    superblock.close_at(told);
    return write_all(file, superblock.bytes, Superblock::size, 0);
  }

  bool write(H5FD_mem_t type, haddr_t at, void const* from, std::size_t size) {
    if (heads_only && !(size > 4 && (std::memcmp(from, "OHDR", 4) == 0 || std::memcmp(from, "OCHK", 4) == 0)))
      return true;
    if (heads_only) return write_all(file, from, size, static_cast<off_t>(at)) || fail();
    changed = true;
    if (type == H5FD_MEM_DRAW) last_numbers = at;
    if (at == 0 && size == Superblock::size) {
      std::copy_n(static_cast<unsigned char const*>(from), size, superblock.bytes);
      true_end = 0;
      if (told == 0) told = used;
      return (make_room() && write_superblock()) || fail();
    }
    // Numbers are told of by what is written later.
    if (type != H5FD_MEM_DRAW && !make_room()) return false;
    return write_all(file, from, size, static_cast<off_t>(at)) || fail();
  }

  /// The hole at its end goes.
  bool close() {
    bool well = true;
    if (changed && !failed && told != 0) {
      told = used;
      well = write_superblock() && ::ftruncate(file, static_cast<off_t>(used)) == 0;
    }
    return ::close(file) == 0 && well;
  }
};

GrowingFile& of(H5FD_t* file) { return *reinterpret_cast<GrowingFile*>(file); }
GrowingFile const& of(H5FD_t const* file) { return *reinterpret_cast<GrowingFile const*>(file); }

H5FD_t* open(char const* path, unsigned flags, hid_t, haddr_t) {
  int const how = O_CLOEXEC | (flags & H5F_ACC_RDWR ? O_RDWR : O_RDONLY) |
                  (flags & H5F_ACC_TRUNC ? O_TRUNC : 0) | (flags & H5F_ACC_CREAT ? O_CREAT : 0) |
                  (flags & H5F_ACC_EXCL ? O_EXCL : 0);
  int const file = ::open(path, how, 0666);
  struct stat now;
  if (file < 0 || ::fstat(file, &now) != 0) return last_error = errno, nullptr;
  auto* const opened = new GrowingFile;
  opened->file = file, opened->device = now.st_dev, opened->inode = now.st_ino,
  opened->heads_only = heads_only;
  if (now.st_size > 0) opened->look();
  if (flags & H5F_ACC_RDWR && !heads_only) opened->begin();
  return &opened->common;
}
herr_t close(H5FD_t* file) {
  bool const well = of(file).close();
  delete &of(file);
  return well ? 0 : -1;
}
int compare(H5FD_t const* a, H5FD_t const* b) {
  auto const place = [](GrowingFile const& f) { return std::pair(f.device, f.inode); };
  return place(of(a)) < place(of(b)) ? -1 : place(of(b)) < place(of(a)) ? 1 : 0;
}
herr_t query(H5FD_t const*, unsigned long* features) {
  // Metadata are not collected in blocks, of which each flush would begin another: where things are does not
  // depend on the clock.
  *features = H5FD_FEAT_POSIX_COMPAT_HANDLE | H5FD_FEAT_SUPPORTS_SWMR_IO | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}
haddr_t take(H5FD_t* file, H5FD_mem_t type, hid_t, hsize_t size) {
  if (type == H5FD_MEM_DRAW && next_numbers != 0) return next_numbers;
  haddr_t const at = of(file).used;
  // The same room for a chunk of numbers of eight bytes, whether four bytes follow it or eight.
  of(file).used += type == H5FD_MEM_DRAW ? (size + 15) / 16 * 16 : size;
  return at;
}
haddr_t used(H5FD_t const* file, H5FD_mem_t) { return of(file).used; }
herr_t set_used(H5FD_t* file, H5FD_mem_t, haddr_t at) { return of(file).used = at, 0; }
haddr_t end_of(H5FD_t const* file, H5FD_mem_t) {
  struct stat now;
  return ::fstat(of(file).file, &now) == 0 ? std::max(static_cast<haddr_t>(now.st_size), of(file).used)
                                           : HADDR_UNDEF;
}
herr_t descriptor(H5FD_t* file, hid_t, void** out) { return *out = &of(file).file, 0; }
herr_t read(H5FD_t* file, H5FD_mem_t type, hid_t, haddr_t at, std::size_t size, void* into) {
  GrowingFile const& from = of(file);
  if (type == H5FD_MEM_DRAW) last_numbers = at;
  if (!read_all(from.file, into, size, static_cast<off_t>(at))) return -1;
  if (at < Superblock::size && from.true_end != 0) {
    Superblock shown = from.superblock;
    shown.close_at(from.true_end);
    std::copy_n(shown.bytes + at, std::min<std::size_t>(size, Superblock::size - at),
                static_cast<unsigned char*>(into));
  }
  return 0;
}
herr_t write(H5FD_t* file, H5FD_mem_t type, hid_t, haddr_t at, std::size_t size, void const* from) {
  return of(file).write(type, at, from, size) ? 0 : -1;
}

H5FD_class_t driver() {
  H5FD_class_t out = {};
#ifdef H5FD_CLASS_VERSION
  out.version = H5FD_CLASS_VERSION;
  out.value = static_cast<H5FD_class_value_t>(600);  // above those that the library keeps for others
#endif
  out.name = "actio";
  out.maxaddr = HADDR_MAX, out.fc_degree = H5F_CLOSE_WEAK;
  out.open = open, out.close = close, out.cmp = compare, out.query = query;
  out.alloc = take, out.get_eoa = used, out.set_eoa = set_used, out.get_eof = end_of,
  out.get_handle = descriptor;
  out.read = read, out.write = write;
  H5FD_mem_t const kinds[] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(kinds), std::end(kinds), out.fl_map);
  return out;
}

}  // namespace

void set_growing_file(Session const& h5, hid_t access) {
  static H5FD_class_t const growing = driver();
  static hid_t const id =
      h5.checked(h5->H5FDregister(&growing), "HDF5", "refuses the driver of files that grow");
  h5.checked(h5->H5Pset_driver(access, id, nullptr), "HDF5", "refuses the driver of files that grow");
}

HeadsOnly::HeadsOnly() { heads_only = true; }
HeadsOnly::~HeadsOnly() { heads_only = false; }

InPlace::InPlace(std::uint64_t place) { next_numbers = place; }
InPlace::~InPlace() { next_numbers = 0; }
std::uint64_t last_place() { return last_numbers; }

std::string driver_failure() { return last_error == 0 ? "" : std::strerror(std::exchange(last_error, 0)); }

}  // namespace actio::scene::hdf5
