#include "program/medium_output/frames.hpp"

#include "program/medium_output/grid.hpp"
#include "program/output/series_reader.hpp"

namespace actio::scene {
namespace {

char const* shape_name(media::BodyMesh::Shape shape) {
  static constexpr char const* names[] = {"line", "triangle", "quadrilateral", "tetrahedron", "hexahedron"};
  return names[static_cast<int>(shape)];
}

/// `visit(cell, corner)` for the corners of all cells, counted as VTK counts them.
template <int d, class Visit>
void for_corners(MediumCells<d> const& cells, Visit const& visit) {
  auto const corners = static_cast<std::size_t>(media::corner_count(cells.shape()));
  for (std::size_t c = 0; c < cells.cells(); ++c) {
    auto const cell = cells.cell(c);
    for (std::size_t k = 0; k < corners; ++k) visit(cell, vtk_corner(cells.shape(), k));
  }
}

/// A data set, of frames where they grow.
ArraySet set_of(SnapshotArray const& array, bool frames) {
  constexpr std::size_t most = 1 << 18;  // numbers of a chunk
  ArraySet out{array.name, {}};
  if (frames) out.axes.push_back({"frame", 0}), out.chunk.push_back(1);
  std::size_t size = 1;
  for (std::size_t const n : array.shape) out.axes.push_back({"", n}), out.chunk.push_back(n), size *= n;
  std::size_t const chunks = (size + most - 1) / most;
  if (std::size_t& longest = out.chunk[frames && !array.shape.empty()]; chunks > 1)
    longest = (longest + chunks - 1) / chunks;
  out.counts = array.counts, out.compressed = size > 1;
  out.attributes = {{"meaning", {array.meaning}}, {"unit", {array.unit}}};
  if (!array.names.empty()) out.attributes.push_back({"components", array.names, true});
  return out;
}

}  // namespace

std::vector<ArrayAttribute> frame_texts(SceneFile const& scene) {
  return {{"title", {scene.section("scene").text("title")}},
          {"system", {scene.section("system").text("kind")}},
          {"actio_version", {ACTIO_VERSION}},
          {"scene", {scene.written()}}};
}

void write_frames(std::string const& path, std::vector<ArrayAttribute> const& texts,
                  std::vector<FrameConstant> const& constants, std::vector<SnapshotArray> const& fields,
                  std::string const& time_unit, std::span<double const> times,
                  std::function<FrameNumbers(long)> const& frame, bool durable) {
  std::vector<ArraySet> sets;
  for (auto const& one : constants) {
    ArraySet& set = sets.emplace_back(set_of(one.array, false));
    set.attributes.insert(set.attributes.end(), one.more.begin(), one.more.end());
  }
  for (auto const& field : fields) sets.push_back(set_of(field, true));
  SnapshotArray time;
  time.name = "time", time.meaning = "of each frame", time.unit = time_unit;
  sets.push_back(set_of(time, true));
  ArrayFile file(ArrayFile::Format::hdf5, path, texts, sets);
  std::size_t set = 0;
  for (auto const& one : constants) file.put(set++, 0, one.numbers());
  for (std::size_t k = 0; k < times.size(); ++k) {
    FrameNumbers const numbers = frame(static_cast<long>(k));
    for (std::size_t i = 0; i < fields.size(); ++i) file.put(set + i, k, numbers[i]);
    file.put(set + fields.size(), k, times.subspan(k, 1));
  }
  file.name(durable);
}

template <int d>
std::vector<SnapshotArray> MediumFrames<d>::fields(MediumCells<d> const& cells, MediumFields<d> const& asked,
                                                   Units const& units) {
  std::size_t const nodes = cells.nodes();
  std::vector<SnapshotArray> fields;
  auto const add = [&](std::string const& name, std::string const& meaning, std::string const& unit) {
    SnapshotArray& one = fields.emplace_back();
    one.name = name, one.meaning = meaning, one.unit = units.in(unit);
    one.axes = {"node"}, one.shape = {nodes};
    return std::ref(one);
  };
  for (auto const& [name, unit] : {std::pair("position", "length"), {"velocity", "length/time"}}) {
    SnapshotArray& one = add(name, "of the nodes", unit);
    one.axes.emplace_back("axis"), one.shape.push_back(d);
  }
  for (auto const& field : asked) {
    SnapshotArray& one = add(field.name, "means around the nodes: " + field.meaning, field.unit);
    if (field.components.empty()) continue;
    one.names = field.components;
    one.axes.emplace_back("component"), one.shape.push_back(one.names.size());
  }
  return fields;
}

template <int d>
std::vector<FrameConstant> MediumFrames<d>::constants(MediumCells<d> const& cells) {
  auto const corners = static_cast<std::size_t>(media::corner_count(cells.shape()));
  std::vector<double> periods;
  for (int a = 0; a < d; ++a) periods.push_back(cells.period(a));
  std::vector<FrameConstant> out;
  auto const add = [&out](SnapshotArray array, std::function<std::vector<double>()> numbers) {
    out.push_back({std::move(array), std::move(numbers)});
  };
  add({"reference",
       "the positions X of the nodes in the reference space",
       {"node", "axis"},
       {cells.nodes(), d}},
      [&cells] {
        std::vector<double> reference;
        reference.reserve(d * cells.nodes());
        for (std::size_t k = 0; k < cells.nodes(); ++k)
          for (double const X : cells.reference(k)) reference.push_back(X);
        return reference;
      });
  add({"cells",
       "the nodes at the corners, counted as VTK counts them",
       {"cell", "corner"},
       {cells.cells(), corners}},
      [&cells, corners] {
        std::vector<double> nodes;
        nodes.reserve(corners * cells.cells());
        for_corners(cells, [&](auto const& cell, std::size_t b) { nodes.push_back(cell.nodes[b]); });
        return nodes;
      });
  out.back().array.counts = true, out.back().more = {{"shape", {shape_name(cells.shape())}}};
  if (periods == std::vector<double>(d, 0.0)) return out;
  add({"periods", "of the box, zero where it has none", {"axis"}, {d}}, [periods] { return periods; });
  add({"beyond",
       "by how many periods a corner lies beyond the position of its node",
       {"cell", "corner", "axis"},
       {cells.cells(), corners, d}},
      [&cells, corners] {
        std::vector<double> beyond;
        beyond.reserve(d * corners * cells.cells());
        for_corners(cells, [&](auto const& cell, std::size_t b) {
          for (int a = 0; a < d; ++a) beyond.push_back(cell.wraps[b] >> a & 1);
        });
        return beyond;
      });
  out.back().array.counts = true;
  return out;
}

template <int d>
typename MediumFrames<d>::Numbers MediumFrames<d>::read(std::string const& table,
                                                        std::vector<std::string> const& columns,
                                                        std::vector<SnapshotArray> const& fields) {
  auto const reader = read_csv_series(table, columns);
  Numbers out(fields.size());
  std::vector<std::size_t> wide;
  for (std::size_t k = 0; k < fields.size(); ++k) {
    wide.push_back(fields[k].shape.size() > 1 ? fields[k].shape[1] : 1);
    out[k].reserve(fields[k].shape[0] * wide[k]);
  }
  for (std::vector<double> row(columns.size()); reader->next(row);) {
    auto at = row.begin() + d;  // behind the reference
    for (std::size_t k = 0; k < fields.size(); ++k, at += static_cast<long>(wide[k - 1]))
      out[k].insert(out[k].end(), at, at + static_cast<long>(wide[k]));
  }
  if (std::size_t const nodes = out[0].size() / d; nodes != fields[0].shape[0])
    throw FileError(table + ": has " + std::to_string(nodes) + " nodes, where the scene has " +
                    std::to_string(fields[0].shape[0]));
  return out;
}

/// Along a line.
template struct MediumFrames<1>;
/// In the plane.
template struct MediumFrames<2>;
/// In space.
template struct MediumFrames<3>;

}  // namespace actio::scene
