// Files of arrays for other programs, HDF5 and NetCDF, made whole by their own libraries.
//
//     ArrayFile file(ArrayFile::Format::hdf5, "run/series.h5", {{"title", {"Apophis"}}}, sets);
//     file.put(0, 0, times);
//     file.name(true);
//
// A file is written under another name, and has its own when all of it is there, in place of one that has it:
// no reader meets its writer, nothing leaves half of one, and who has the former one open goes on reading it.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace actio::scene {

/// A text beside the numbers, or a list of them.
struct ArrayAttribute {
  std::string name;                ///< of the attribute
  std::vector<std::string> texts;  ///< one, where it is no list
  bool list = false;               ///< whether it is one, also where it has one text
};

/// A data set.
struct ArraySet {
  /// A direction along which numbers lie.
  struct Axis {
    std::string name;        ///< which NetCDF tells
    std::size_t length = 0;  ///< zero: it grows, and is the first
  };
  std::string name;                     ///< with its group, where it has one: "spectral/degree"
  std::vector<Axis> axes;               ///< the last one fastest
  std::vector<std::size_t> chunk = {};  ///< what lies together in the file; empty: all, or as it likes
  bool counts = false;                  ///< whether they are whole numbers
  bool compressed = false;              ///< without loss
  std::vector<ArrayAttribute> attributes = {};  ///< those that are empty are left out

  /// Numbers that have one place along the first axis.
  std::size_t width() const {
    std::size_t out = 1;
    for (std::size_t k = 1; k < axes.size(); ++k) out *= axes[k].length;
    return out;
  }
};

/// What a module writes such a file with. What goes wrong is a std::runtime_error that says why.
class ArrayWriter {
 public:
  virtual ~ArrayWriter() = default;
  /// Numbers of a data set, from a place along its first axis on.
  virtual void put(std::size_t set, std::size_t first, std::size_t count, double const* numbers) = 0;
  /// Nothing is written any more.
  virtual void close() = 0;
};
/// How a module makes one.
using MakeArrayWriter = ArrayWriter*(std::string const& path, std::vector<ArrayAttribute> const& attributes,
                                     std::vector<ArraySet> const& sets);

/// One file. While it lives no other thread writes one.
class ArrayFile {
 public:
  /// By which library.
  enum class Format {
    hdf5,   ///< every chunk has a checksum (Fletcher32)
    netcdf  ///< NetCDF-4
  };

  /// @throws FileError  where it cannot be written; so do all that follow
  ArrayFile(Format format, std::string path, std::vector<ArrayAttribute> const& attributes,
            std::vector<ArraySet> const& sets);
  /// Without a name it is gone again.
  ~ArrayFile();
  ArrayFile(ArrayFile const&) = delete;
  ArrayFile& operator=(ArrayFile const&) = delete;

  /// Numbers of a data set, from a place along its first axis on.
  void put(std::size_t set, std::size_t first, std::span<double const> numbers);
  /// Gives it its name; nothing is written any more.
  /// @param durable  whether it is on the disk afterwards
  void name(bool durable);

 private:
  template <class Act>
  void guarded(Act const& act) const;

  std::unique_lock<std::mutex> lock_;
  std::string path_, part_;
  std::vector<std::size_t> widths_;
  std::unique_ptr<ArrayWriter> writer_;
};

}  // namespace actio::scene
