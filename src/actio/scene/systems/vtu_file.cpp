#include "actio/scene/systems/vtu_file.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <new>

namespace actio::scene {
namespace {

static_assert(std::endian::native == std::endian::little);

void append(std::string& out, std::uint64_t number) {
  out.append(reinterpret_cast<char const*>(&number), sizeof number);
}

/// Blocks as VTK has them: how many, their size, that of the last one if it is shorter, their sizes when
/// compressed, and the blocks.
std::string compressed(std::string_view bytes) {
  constexpr std::size_t block = 1 << 20;
  std::size_t const count = (bytes.size() + block - 1) / block;
  std::string out, body;
  append(out, count), append(out, block), append(out, bytes.size() % block);
  std::vector<unsigned char> room(compressBound(block));
  for (std::size_t k = 0; k < count; ++k) {
    std::string_view const one = bytes.substr(k * block, block);
    uLongf size = room.size();
    if (::compress2(room.data(), &size, reinterpret_cast<Bytef const*>(one.data()), one.size(), 1) != Z_OK)
      throw std::bad_alloc();
    append(out, size);
    body.append(reinterpret_cast<char const*>(room.data()), size);
  }
  return out + body;
}

template <class T>
std::string_view bytes_of(std::vector<T> const& values) {
  return {reinterpret_cast<char const*>(values.data()), values.size() * sizeof(T)};
}

}  // namespace

VtuFile::VtuFile(double time, std::size_t points, std::size_t cells)
    : time_(time), points_count_(points), cells_count_(cells) {}

std::string VtuFile::array(std::string const& type, std::string const& name, int components,
                           std::string_view bytes, std::vector<std::string> const& names) {
  std::string more = components > 1 ? fmt::format(" NumberOfComponents=\"{}\"", components) : "";
  for (std::size_t k = 0; k < names.size(); ++k) more += fmt::format(" ComponentName{}=\"{}\"", k, names[k]);
  std::string const head =
      fmt::format("        <DataArray type=\"{}\" Name=\"{}\"{} format=\"appended\" offset=\"{}\"/>\n", type,
                  name, more, appended_.size());
  appended_ += compressed(bytes);
  return head;
}
void VtuFile::point_data(std::string const& name, std::vector<double> const& values, int components) {
  point_data_ += array("Float64", name, components, bytes_of(values));
}
void VtuFile::cell_data(std::string const& name, std::vector<double> const& values,
                        std::vector<std::string> const& components) {
  int const count = std::max(1, static_cast<int>(components.size()));
  cell_data_ += array("Float64", name, count, bytes_of(values), components);
}
void VtuFile::points(std::vector<double> const& places) {
  points_ = array("Float64", "Points", 3, bytes_of(places));
}
void VtuFile::cells(std::vector<std::int64_t> const& corners, int each, unsigned char type) {
  std::vector<std::int64_t> offsets(cells_count_);
  for (std::size_t k = 0; k < offsets.size(); ++k) offsets[k] = static_cast<std::int64_t>(k + 1) * each;
  std::vector<unsigned char> const types(cells_count_, type);
  cells_ = array("Int64", "connectivity", 1, bytes_of(corners)) +
           array("Int64", "offsets", 1, bytes_of(offsets)) + array("UInt8", "types", 1, bytes_of(types));
}
std::string VtuFile::text() const {
  std::string out = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n"
      "  <UnstructuredGrid>\n"
      "    <FieldData>\n"
      "      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{:.17g}</DataArray>\n"
      "    </FieldData>\n"
      "    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
      time_, points_count_, cells_count_);
  auto const part = [&out](char const* name, std::string const& arrays) {
    out += fmt::format("      <{0}>\n{1}      </{0}>\n", name, arrays);
  };
  part("PointData", point_data_), part("CellData", cell_data_), part("Points", points_),
      part("Cells", cells_);
  out += "    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n   _";
  out += appended_;
  return out + "\n  </AppendedData>\n</VTKFile>\n";
}

std::string pvd_beginning() {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
         "byte_order=\"LittleEndian\">\n"
         "  <Collection>\n";
}
std::string pvd_entry(double time, std::string const& file) {
  return fmt::format("    <DataSet timestep=\"{:.17g}\" group=\"\" part=\"0\" file=\"{}\"/>\n", time, file);
}
std::string pvd_end() { return "  </Collection>\n</VTKFile>\n"; }

}  // namespace actio::scene
