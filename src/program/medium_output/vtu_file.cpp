#include "program/medium_output/vtu_file.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <new>
#include <stdexcept>
#include <type_traits>

namespace actio::scene {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::size_t block = 1 << 20;         // bytes of an array that are compressed together
constexpr std::size_t room_of_head = 1 << 12;  // bytes before the arrays, whose offsets are in them

template <class T>
std::string_view bytes_of(std::vector<T> const& values) {
  return {reinterpret_cast<char const*>(values.data()), values.size() * sizeof(T)};
}
template <class T>
char const* vtk_name() { return std::is_same_v<T, double> ? "Float64" : sizeof(T) == 8 ? "Int64" : "UInt8"; }

}  // namespace

VtuFile::VtuFile(std::string const& path, double time, std::size_t points, std::size_t cells)
    : file_(path), time_(time), points_count_(points), cells_count_(cells) {
  file_.write(std::string(room_of_head, ' '));
}

/// Blocks as VTK has them: how many, their size, that of the last one if it is shorter, their sizes when
/// compressed, and the blocks.
template <class T>
std::string VtuFile::array(std::string const& name, int components, std::size_t count,
                           Numbers<T> const& values, std::vector<std::string> const& names) {
  std::string more = components > 1 ? fmt::format(" NumberOfComponents=\"{}\"", components) : "";
  for (std::size_t k = 0; k < names.size(); ++k) more += fmt::format(" ComponentName{}=\"{}\"", k, names[k]);
  std::size_t const begin = file_.size(), each = block / sizeof(T), blocks = (count + each - 1) / each;
  std::vector<std::uint64_t> sizes{blocks, block, count * sizeof(T) % block};
  sizes.resize(3 + blocks);
  file_.write(bytes_of(sizes));
  std::vector<unsigned char> packed(compressBound(block));
  std::vector<T> some;
  for (std::size_t k = 0; k < blocks; ++k) {
    some.resize(std::min(each, count - k * each));
    for (std::size_t i = 0; i < some.size(); ++i) some[i] = values(k * each + i);
    std::string_view const bytes = bytes_of(some);
    uLongf size = packed.size();
    if (::compress2(packed.data(), &size, reinterpret_cast<Bytef const*>(bytes.data()), bytes.size(), 1) !=
        Z_OK)
      throw std::bad_alloc();
    file_.write({reinterpret_cast<char const*>(packed.data()), size});
    sizes[3 + k] = size;
  }
  file_.write_at(begin, bytes_of(sizes));
  return fmt::format("        <DataArray type=\"{}\" Name=\"{}\"{} format=\"appended\" offset=\"{}\"/>\n",
                     vtk_name<T>(), name, more, begin - room_of_head);
}
void VtuFile::point_data(std::string const& name, Numbers<double> const& values, int components) {
  point_data_ += array(name, components, static_cast<std::size_t>(components) * points_count_, values);
}
void VtuFile::cell_data(std::string const& name, Numbers<double> const& values,
                        std::vector<std::string> const& components) {
  std::size_t const count = std::max<std::size_t>(1, components.size());
  cell_data_ += array(name, static_cast<int>(count), count * cells_count_, values, components);
}
void VtuFile::points(Numbers<double> const& places) {
  points_ = array("Points", 3, 3 * points_count_, places);
}
void VtuFile::cells(Numbers<std::int64_t> const& corners, int each, unsigned char type) {
  cells_ = array("connectivity", 1, static_cast<std::size_t>(each) * cells_count_, corners);
  cells_ += array<std::int64_t>("offsets", 1, cells_count_,
                                [each](std::size_t k) { return static_cast<std::int64_t>(k + 1) * each; });
  cells_ += array<unsigned char>("types", 1, cells_count_, [type](std::size_t) { return type; });
}
std::string VtuFile::head() const {
  std::string out = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n  <UnstructuredGrid>\n"
      "    <FieldData>\n"
      "      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{:.17g}</DataArray>\n    </FieldData>\n"
      "    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
      time_, points_count_, cells_count_);
  auto const part = [&out](char const* name, std::string const& arrays) {
    out += fmt::format("      <{0}>\n{1}      </{0}>\n", name, arrays);
  };
  part("PointData", point_data_), part("CellData", cell_data_), part("Points", points_),
      part("Cells", cells_);
  return out + "    </Piece>\n  </UnstructuredGrid>\n";
}
void VtuFile::end(bool durable) {
  std::string const text = head(), mark = "  <AppendedData encoding=\"raw\">\n   _";
  if (text.size() + mark.size() > room_of_head)
    throw std::length_error("the arrays of a grid are too many for its head");
  // Blanks between, so that arrays begin where room was left for the head.
  file_.write_at(0, text + std::string(room_of_head - text.size() - mark.size(), ' ') + mark);
  file_.write("\n  </AppendedData>\n</VTKFile>\n").name(durable);
}

std::string pvd_beginning() {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
         "byte_order=\"LittleEndian\">\n  <Collection>\n";
}
std::string pvd_entry(double time, std::string const& file) {
  return fmt::format("    <DataSet timestep=\"{:.17g}\" group=\"\" part=\"0\" file=\"{}\"/>\n", time, file);
}
std::string pvd_end() { return "  </Collection>\n</VTKFile>\n"; }

}  // namespace actio::scene
