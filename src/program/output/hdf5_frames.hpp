// Frames of a field in one HDF5 file: data sets that grow by a frame at a time, and others that belong to all
// of them.
//
// The file can be read at any instant, as the table of a run can (series.hpp): a frame is in it before the
// data sets tell of it, and `time` grows last. Each frame has chunks of its own, compressed without loss,
// with a checksum. Between two frames the file is closed, and holds whole frames only.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "program/base/error.hpp"

namespace actio::scene {

/// Frames in the file at a path.
class Hdf5Frames {
 public:
  /// A data set.
  struct Field {
    std::string name;                          ///< in the file
    std::string meaning;                       ///< in a few words
    std::vector<std::size_t> shape;            ///< of one frame
    std::vector<std::string> components = {};  ///< names along the last axis, where they have some
    std::string unit = {};                     ///< empty: none is told
  };
  /// One that is the same for all frames: numbers, or counts.
  struct Constant {
    /// its shape is that of the whole
    Field field;
    /// makes them when they are written, row by row
    std::function<std::variant<std::vector<double>, std::vector<std::int64_t>>()> values;
    std::vector<std::pair<std::string, std::string>> attributes = {};  ///< besides the meaning
  };

  /// Of these fields, besides `time`.
  Hdf5Frames(std::string path, std::vector<Field> fields);

  /// These, and `time`, which is the last.
  std::vector<Field> const& fields() const { return fields_; }

  /// A file without frames, in place of one that is there.
  /// @param texts  attributes of the file
  /// @throws FileError  where it cannot be written; so do all that follow
  void create(std::vector<std::pair<std::string, std::string>> const& texts,
              std::vector<Constant> const& constants, std::string const& time_unit) const;
  /// Keeps so many frames of a file that is there; the others are written again.
  /// @throws FileError  where it has other data sets or fewer frames
  void cut(std::size_t frames) const;
  /// Adds a frame.
  /// @param frame    how many there are before it
  /// @param numbers  of the field with a number, which are read before those of the next are asked for
  /// @param durable  whether it is on the disk afterwards
  void add(std::size_t frame, double time, std::function<std::span<double const>(std::size_t)> const& numbers,
           bool durable) const;
  /// The numbers of a field at a frame.
  std::vector<double> read(std::string const& field, std::size_t frame) const;

 private:
  std::string path_;
  std::vector<Field> fields_;  // and `time`, which is the last
};

}  // namespace actio::scene
