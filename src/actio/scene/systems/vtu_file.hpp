// Unstructured grids for ParaView and VTK: .vtu files with appended raw data, compressed by zlib, and the
// .pvd file that lists them with their times.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace actio::scene {

/// One .vtu file, put together in memory.
class VtuFile {
 public:
  /// @param time  of the grid, `TimeValue`
  VtuFile(double time, std::size_t points, std::size_t cells);

  /// Numbers at each point; those of a place have three components.
  void point_data(std::string const& name, std::vector<double> const& values, int components);
  /// Numbers in each cell.
  /// @param components  names of them, as many as there are numbers in each; none: one number without a name
  void cell_data(std::string const& name, std::vector<double> const& values,
                 std::vector<std::string> const& components = {});
  /// Places of the points, three numbers each.
  void points(std::vector<double> const& places);
  /// The cells.
  /// @param corners  of all of them, one after the other
  /// @param each     how many a cell has
  /// @param type     that VTK has for them
  void cells(std::vector<std::int64_t> const& corners, int each, unsigned char type);
  /// The whole file.
  std::string text() const;

 private:
  std::string array(std::string const& type, std::string const& name, int components, std::string_view bytes,
                    std::vector<std::string> const& names = {});

  double time_;
  std::size_t points_count_, cells_count_;
  std::string point_data_, cell_data_, points_, cells_, appended_;
};

/// The text of a .pvd file before its data sets, one of these, and what comes behind.
std::string pvd_beginning();
std::string pvd_entry(double time, std::string const& file);  ///< \copydoc pvd_beginning
std::string pvd_end();                                        ///< \copydoc pvd_beginning

}  // namespace actio::scene
