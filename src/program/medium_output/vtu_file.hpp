// Unstructured grids for ParaView and VTK: .vtu files with appended raw data, compressed by zlib, and the
// .pvd file that lists them with their times.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "program/base/whole_file.hpp"

namespace actio::scene {

/// One .vtu file, written as its arrays are given: a block of one of them at a time is in memory.
class VtuFile {
 public:
  /// A number by its place in an array.
  template <class T>
  using Numbers = std::function<T(std::size_t)>;

  /// @param path  of the file, which has its name when \ref end is called
  /// @param time  of the grid, `TimeValue`
  /// @throws FileError  where it cannot be written; so do all that follow
  VtuFile(std::string const& path, double time, std::size_t points, std::size_t cells);

  /// Numbers at each point; those of a place have three components.
  void point_data(std::string const& name, Numbers<double> const& values, int components);
  /// Numbers in each cell.
  /// @param components  names of them, as many as there are numbers in each; none: one number without a name
  void cell_data(std::string const& name, Numbers<double> const& values,
                 std::vector<std::string> const& components = {});
  /// Places of the points, three numbers each.
  void points(Numbers<double> const& places);
  /// The cells.
  /// @param corners  of all of them, one after the other
  /// @param each     how many a cell has
  /// @param type     that VTK has for them
  void cells(Numbers<std::int64_t> const& corners, int each, unsigned char type);
  /// All arrays were given: the file has its name.
  /// @param durable  whether it is on the disk afterwards
  void end(bool durable);

 private:
  template <class T>
  std::string array(std::string const& name, int components, std::size_t count, Numbers<T> const& values,
                    std::vector<std::string> const& names = {});
  std::string head() const;

  WholeFile file_;
  double time_;
  std::size_t points_count_, cells_count_;
  std::string point_data_, cell_data_, points_, cells_;
};

/// The text of a .pvd file before its data sets, one of these, and what comes behind.
std::string pvd_beginning();
std::string pvd_entry(double time, std::string const& file);  ///< \copydoc pvd_beginning
std::string pvd_end();                                        ///< \copydoc pvd_beginning

}  // namespace actio::scene
