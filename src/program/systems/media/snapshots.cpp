#include "program/systems/media/snapshots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "program/base/number_table.hpp"
#include "program/base/whole_file.hpp"
#include "program/registry/units.hpp"
#include "program/run/checkpoint.hpp"
#include "program/systems/media/frames.hpp"
#include "program/systems/media/grid.hpp"
#include "program/systems/media/playing.hpp"
#include "program/systems/media/vtu_file.hpp"

namespace actio::scene {
namespace {

template <int d>
class MediumSnapshots : public SnapshotWriter {
 public:
  using Place = std::array<double, d>;
  MediumSnapshots(SceneFile const& scene, SnapshotRequest const& request, MediumView<d> const& medium)
      : scene_(scene),
        asked_(fields_named<d>(request.columns)),
        vtu_(request.in("vtu")),
        hdf5_(request.in("hdf5")),
        csv_(request.in("csv")),
        medium_(medium) {}

  std::vector<std::string> files(long number) const override {
    std::vector<std::string> out;
    if (csv_) out.push_back(snapshot_file(number, ".csv"));
    if (vtu_) out.push_back(snapshot_file(number, ".vtu"));
    return out;
  }
  std::vector<std::string> shared_files() const override {
    std::vector<std::string> out;
    if (vtu_) out.emplace_back(series_file);
    if (hdf5_) out.insert(out.end(), {frames_file, std::string(frames_file) + ".part"});
    return out;
  }
  double bytes_of_one() const override {
    auto const& cells = medium_.motion->cells();
    double const nodes = static_cast<double>(cells.nodes()), all = static_cast<double>(cells.cells()),
                 fields = static_cast<double>(field_size(asked_));
    // A number of a table has about 19 characters; zlib leaves of doubles that differ about all, and of what
    // counts corners little.
    return (csv_ ? nodes * (3 * d + fields) * 19 : 0) + (vtu_ ? 8 * (nodes * 9 + all * fields) : 0) +
           (hdf5_ ? 8 * nodes * (2 * d + fields) : 0);
  }

  /// The list of grids is made anew: it may have been cut short, and grids removed.
  void begin(std::string const& folder, std::span<double const> taken) override {
    if (hdf5_ && taken.empty())
      frames(folder).create(attributes(), MediumFrames<d>::constants(medium_.motion->cells()),
                            read_units(scene_).time);
    else if (hdf5_)
      frames(folder).cut(taken.size());
    if (!vtu_) return;
    std::string text = pvd_beginning();
    for (std::size_t k = 0; k < taken.size(); ++k) {
      auto const number = static_cast<long>(k);
      if (std::error_code none; std::filesystem::exists(folder + "/" + snapshot_file(number, ".vtu"), none))
        text += pvd_entry(taken[k], file_in_series(number));
    }
    write_whole_file(folder + "/" + series_file, text + pvd_end(), false);
  }
  void write(std::string const& folder, long number, double time, bool durable) override {
    // Velocities first: they take more room while they are made.
    auto const v = medium_.motion->velocities();
    auto const x = medium_.motion->places();
    if (csv_ || hdf5_) {
      auto const fields = mean_fields(medium_, x, asked_, true);
      if (csv_) write_table(folder + "/" + snapshot_file(number, ".csv"), x, v, fields, durable);
      if (hdf5_)
        frames(folder).add(static_cast<std::size_t>(number), time, MediumFrames<d>::one(x, v, asked_, fields),
                           durable);
    }
    if (!vtu_) return;
    write_grid(folder + "/" + snapshot_file(number, ".vtu"), x, v, time, durable);
    add_to_series(folder + "/" + series_file, pvd_entry(time, file_in_series(number)));
  }

  std::vector<SnapshotArray> coordinates() const override {
    std::vector<SnapshotArray> out;
    for (auto const& [field, values, attributes] : MediumFrames<d>::constants(medium_.motion->cells())) {
      SnapshotArray& one = out.emplace_back(array_of(field));
      auto const numbers = values();
      std::visit([&](auto const& all) { one.numbers.assign(all.begin(), all.end()); }, numbers);
      // What counts is of the corners of cells.
      one.counts = std::holds_alternative<std::vector<std::int64_t>>(numbers);
      one.axes = one.counts              ? std::vector<std::string>{"cell", "corner", "axis"}
                 : one.shape.size() == 1 ? std::vector<std::string>{"axis"}
                                         : std::vector<std::string>{"node", "axis"};
      one.axes.resize(one.shape.size());
    }
    return out;
  }
  std::vector<SnapshotArray> fields() const override {
    return fields_of({medium_.motion->places(), medium_.motion->velocities()});
  }
  std::vector<SnapshotArray> fields_in(std::string const& folder, long number) const override {
    return fields_of(read(folder, number));
  }

  std::shared_ptr<PlayedMedium const> played(std::string const& folder,
                                             std::span<double const> times) const override {
    return play_medium<d>(medium_, times,
                          [&](std::size_t number) { return read(folder, static_cast<long>(number)); });
  }

 private:
  MediumFrame<d> read(std::string const& folder, long number) const {
    if (hdf5_) return MediumFrame<d>::in_hdf5(frames(folder), static_cast<std::size_t>(number));
    return MediumFrame<d>::in_table(folder + "/" + snapshot_file(number, ".csv"), asked_);
  }
  static SnapshotArray array_of(Hdf5Frames::Field const& field) {
    SnapshotArray out;
    out.name = field.name, out.meaning = field.meaning, out.unit = field.unit;
    out.shape = field.shape, out.names = field.components;
    return out;
  }
  /// Places and velocities determine all the others.
  std::vector<SnapshotArray> fields_of(MediumFrame<d> const& frame) const {
    auto const numbers = mean_fields(medium_, frame.places, asked_, true);
    auto const one = MediumFrames<d>::one(frame.places, frame.velocities, asked_, numbers);
    std::vector<SnapshotArray> out;
    auto const all = frames("").fields();
    for (std::size_t k = 0; k + 1 < all.size(); ++k) {
      SnapshotArray& array = out.emplace_back(array_of(all[k]));
      auto const found = one(k);
      array.numbers.assign(found.begin(), found.end());
      array.axes = {"node", array.names.empty() ? "axis" : "component"};
      array.axes.resize(array.shape.size());
    }
    return out;
  }

  static constexpr char const* series_file = "snapshots/series.pvd";
  static std::string file_in_series(long number) {
    return snapshot_file(number, ".vtu").substr(std::string("snapshots/").size());
  }
  /// In the place of the end of the list, which comes behind again.
  static void add_to_series(std::string const& path, std::string const& entry) {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(-static_cast<long>(pvd_end().size()), std::ios::end);
    file << entry << pvd_end() << std::flush;
    if (!file) throw FileError(path + ": cannot be written");
  }

  Hdf5Frames frames(std::string const& folder) const {
    return MediumFrames<d>::in(folder, medium_.motion->cells(), asked_, read_units(scene_));
  }
  std::vector<std::pair<std::string, std::string>> attributes() const {
    return {{"title", scene_.section("scene").text("title")},
            {"system", scene_.section("system").text("kind")},
            {"actio_version", ACTIO_VERSION},
            {"scene", scene_.written()}};
  }

  /// A part of the table at a time is in memory.
  /// @param fields  of each node
  void write_table(std::string const& path, std::vector<Place> const& x, std::vector<Place> const& v,
                   std::vector<double> const& fields, bool durable) const {
    constexpr std::size_t part = 1 << 20;
    WholeFile file(path);
    NumberTable out(fmt::format("{}", fmt::join(medium_columns(asked_), ",")));
    auto const size = field_size(asked_);
    for (std::size_t k = 0; k < x.size(); ++k) {
      for (double const one : medium_.motion->cells().reference(k)) out.add(one);
      for (double const one : x[k]) out.add(one);
      for (double const one : v[k]) out.add(one);
      for (std::size_t i = 0; i < size; ++i) out.add(fields[k * size + i]);
      out.end_row();
      if (out.text().size() < part && k + 1 < x.size()) continue;
      file.write(out.text());
      out.clear();
    }
    file.name(durable);
  }

  /// Vectors at the points of the grid, with three components, one number after the other.
  /// @param shift  whether they are places, which lie periods beyond
  template <class At>
  VtuFile::Numbers<double> at_points(GridPoints<d> const& points, bool shift, At const& at) const {
    return [this, &points, shift, at](std::size_t k) -> double {
      std::size_t const a = k % 3;
      if (a >= d) return 0;
      auto const [node, wrap] = points[k / 3];
      return at(node)[a] + (shift && wrap >> a & 1 ? medium_.motion->cells().period(static_cast<int>(a)) : 0);
    };
  }
  /// A component of a field, and the number that it has among them.
  struct Component {
    std::string name;
    std::size_t at;
  };
  /// Those of a stress as VTK orders them: the diagonal first, then XY, YZ, XZ.
  static std::vector<Component> stress_in_grid() {
    if (d == 1) return {{"XX", 0}};
    if (d == 2) return {{"XX", 0}, {"YY", 2}, {"XY", 1}};
    return {{"XX", 0}, {"YY", 3}, {"ZZ", 5}, {"XY", 1}, {"YZ", 4}, {"XZ", 2}};
  }
  void write_grid(std::string const& path, std::vector<Place> const& x, std::vector<Place> const& v,
                  double time, bool durable) const {
    auto const& cells = medium_.motion->cells();
    GridPoints<d> points(cells);
    VtuFile file(path, time, points.size(), cells.cells());
    file.point_data("reference", at_points(points, true, [&](auto k) { return cells.reference(k); }), 3);
    file.point_data("velocity", at_points(points, false, [&](auto k) { return v[k]; }), 3);
    auto const size = field_size(asked_);
    auto const fields = mean_fields(medium_, x, asked_, false);
    std::size_t first = 0;
    for (auto const& field : asked_) {
      auto const components = field.components.empty() ? std::vector<Component>{{"", 0}} : stress_in_grid();
      std::size_t const wide = components.size();
      std::vector<std::string> words;
      for (auto const& one : components)
        if (!one.name.empty()) words.push_back(one.name);
      file.cell_data(
          field.name,
          [&](std::size_t k) { return fields[k / wide * size + first + components[k % wide].at]; }, words);
      first += wide;
    }
    file.points(at_points(points, true, [&](auto k) { return x[k]; }));
    file.cells([&](std::size_t k) { return points.corner(k); }, media::corner_count(cells.shape()),
               vtk_type(cells.shape()));
    file.end(durable);
  }

  SceneFile scene_;
  MediumFields<d> asked_;
  bool vtu_, hdf5_, csv_;
  MediumView<d> medium_;
};

}  // namespace

template <int d>
std::vector<std::string> medium_columns(MediumFields<d> const& asked) {
  std::vector<std::string> out;
  for (char const* const names : {"XYZ", "xyz", "uvw"})
    for (int a = 0; a < d; ++a) out.emplace_back(1, names[a]);
  for (auto const& field : asked) {
    if (field.components.empty()) out.push_back(field.name);
    for (auto const& one : field.components) out.push_back(field.name + "_" + one);
  }
  return out;
}
/// Along a line.
template std::vector<std::string> medium_columns(MediumFields<1> const&);
/// In the plane.
template std::vector<std::string> medium_columns(MediumFields<2> const&);
/// In space.
template std::vector<std::string> medium_columns(MediumFields<3> const&);

SnapshotKind medium_snapshots(bool fluid) {
  SnapshotKind out{"the reference coordinates X Y Z of the nodes, their places x y z and velocities u v w",
                   {},
                   {{"vtu",
                     "grids for ParaView in snapshots/000000.vtu, ... with the fields in each cell, and "
                     "snapshots/series.pvd, which lists them with their times"}},
                   "all of them in one file snapshots/frames.h5, with time, place, velocity and what was "
                   "asked for of each frame and node, and reference and cells; tables are written beside "
                   "it where csv is among the formats"};
  for (auto const& field : medium_fields<3>())
    if (!(fluid && field.of_solids)) out.columns.push_back({field.name, field.meaning});
  return out;
}

template <int d>
std::unique_ptr<SnapshotWriter> write_medium(Request const& request, MediumView<d> const& medium) {
  if (!request.snapshots) return nullptr;
  return std::make_unique<MediumSnapshots<d>>(request.file, *request.snapshots, medium);
}
/// Along a line.
template std::unique_ptr<SnapshotWriter> write_medium(Request const&, MediumView<1> const&);
/// In the plane.
template std::unique_ptr<SnapshotWriter> write_medium(Request const&, MediumView<2> const&);
/// In space.
template std::unique_ptr<SnapshotWriter> write_medium(Request const&, MediumView<3> const&);

}  // namespace actio::scene
