#include "program/medium_output/snapshots.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "program/base/number_table.hpp"
#include "program/base/whole_file.hpp"
#include "program/medium_output/frames.hpp"
#include "program/medium_output/grid.hpp"
#include "program/medium_output/grid_series.hpp"
#include "program/medium_output/playing.hpp"
#include "program/medium_output/vtu_file.hpp"
#include "program/output/series_reader.hpp"
#include "program/registry/units.hpp"
#include "program/run/checkpoint.hpp"

namespace actio::scene {
namespace {

template <int d>
class MediumSnapshots : public SnapshotWriter {
 public:
  using Place = std::array<double, d>;
  MediumSnapshots(SceneFile const& scene, SnapshotRequest const& request, MediumView<d> const& medium)
      : scene_(scene),
        asked_(fields_named<d>(request.columns, medium.motion->cells().dimension())),
        vtu_(request.in("vtu")),
        hdf5_(request.in("hdf5")),
        medium_(medium) {}

  std::vector<std::string> files(long number) const override {
    std::vector<std::string> out{snapshot_file(number, ".csv")};
    if (medium_.motion->has_multipliers()) out.push_back(snapshot_file(number, cells_file));
    return out;
  }
  std::vector<std::string> files_in(std::string const& format, long taken) const override {
    if (format == "vtu") return grid_series_files(taken);
    return format == "hdf5" ? std::vector<std::string>{frames_file} : std::vector<std::string>{};
  }
  double bytes_of_one() const override {
    auto const& cells = medium_.motion->cells();
    double const nodes = static_cast<double>(cells.nodes()), all = static_cast<double>(cells.cells()),
                 fields = static_cast<double>(field_size(asked_));
    // A number of a table has about 19 characters; zlib leaves of doubles that differ about all, and of what
    // counts corners little.
    return nodes * (3 * d + fields) * 19 + (medium_.motion->has_multipliers() ? 19 * all : 0) +
           (vtu_ ? 8 * (nodes * 9 + all * fields) : 0) + (hdf5_ ? 8 * nodes * (2 * d + fields) : 0);
  }

  void make(std::string const& format, std::string const& folder, std::span<double const> times,
            bool durable) const override {
    if (format == "hdf5")
      write_frames(
          folder + "/" + frames_file, frame_texts(scene_),
          MediumFrames<d>::constants(medium_.motion->cells()), arrays(), read_units(scene_).time, times,
          [&](long k) { return numbers(folder, k, all); }, durable);
    if (format == "vtu")
      write_grid_series(
          folder, times,
          [&](std::string const& path, long k) {
            write_grid(path, read(folder, k), times[static_cast<std::size_t>(k)], durable);
          },
          durable);
  }
  void write(std::string const& folder, long number, double, bool durable) override {
    // Velocities first: they take more room while they are made.
    auto const v = medium_.motion->velocities();
    auto const x = medium_.motion->places();
    auto const multipliers = medium_.motion->multipliers();
    if (medium_.motion->has_multipliers())
      write_cells(folder + "/" + snapshot_file(number, cells_file), multipliers, durable);
    auto const fields = mean_fields(medium_, x, multipliers, asked_, true);
    write_table(folder + "/" + snapshot_file(number, ".csv"), x, v, fields, durable);
  }

  std::vector<SnapshotArray> coordinates() const override {
    std::vector<SnapshotArray> out;
    for (auto& constant : MediumFrames<d>::constants(medium_.motion->cells()))
      out.push_back(std::move(constant.array)), out.back().numbers = constant.numbers();
    return out;
  }
  std::vector<SnapshotArray> fields() const override {
    auto const v = medium_.motion->velocities();
    auto const x = medium_.motion->places();
    auto const means = mean_fields(medium_, x, medium_.motion->multipliers(), asked_, true);
    auto out = arrays();
    std::size_t const size = field_size(asked_);
    for (std::size_t k = 0; k < x.size(); ++k) {
      out[0].numbers.insert(out[0].numbers.end(), x[k].begin(), x[k].end());
      out[1].numbers.insert(out[1].numbers.end(), v[k].begin(), v[k].end());
      for (std::size_t i = 2, at = k * size; i < out.size(); ++i)
        for (std::size_t n = std::max<std::size_t>(1, out[i].names.size()); n > 0; --n)
          out[i].numbers.push_back(means[at++]);
    }
    return out;
  }
  std::vector<SnapshotArray> fields_in(std::string const& folder, long number) const override {
    auto out = arrays();
    auto found = numbers(folder, number, all);
    for (std::size_t k = 0; k < out.size(); ++k) out[k].numbers = std::move(found[k]);
    return out;
  }

  std::shared_ptr<PlayedMedium const> played(std::string const& folder,
                                             std::span<double const> times) const override {
    return play_medium<d>(medium_, times,
                          [&](std::size_t number) { return read(folder, static_cast<long>(number)); });
  }

 private:
  /// The fields, without their numbers.
  std::vector<SnapshotArray> arrays() const {
    return MediumFrames<d>::fields(medium_.motion->cells(), asked_, read_units(scene_));
  }
  /// Those of a snapshot that was written.
  /// @param first  so many of them
  typename MediumFrames<d>::Numbers numbers(std::string const& folder, long number, std::size_t first) const {
    auto fields = arrays();
    fields.resize(std::min(first, fields.size()));
    return MediumFrames<d>::read(folder + "/" + snapshot_file(number, ".csv"), medium_columns(asked_),
                                 fields);
  }
  MediumFrame<d> read(std::string const& folder, long number) const {
    auto const found = numbers(folder, number, 2);
    auto const points = [](std::vector<double> const& in_a_row) {
      std::vector<Place> out(in_a_row.size() / d);
      for (std::size_t k = 0; k < in_a_row.size(); ++k) out[k / d][k % d] = in_a_row[k];
      return out;
    };
    return {points(found[0]), points(found[1]), cells_in(folder, number)};
  }

  /// What cells have in a snapshot that was written.
  /// @throws FileError  where they are not as many
  std::vector<double> cells_in(std::string const& folder, long number) const {
    std::vector<double> out;
    if (!medium_.motion->has_multipliers()) return out;
    std::string const path = folder + "/" + snapshot_file(number, cells_file);
    auto const reader = read_csv_series(path, {"pressure"});
    for (std::vector<double> row(1); reader->next(row);) out.push_back(row[0]);
    if (std::size_t const cells = medium_.motion->cells().cells(); out.size() != cells)
      throw FileError(fmt::format("{}: has {} cells, where the scene has {}", path, out.size(), cells));
    return out;
  }

  static constexpr std::size_t all = ~std::size_t{0};
  static constexpr char const* cells_file = ".cells.csv";

  /// The pressure of each cell that its volume takes.
  static void write_cells(std::string const& path, std::vector<double> const& multipliers, bool durable) {
    NumberTable out("pressure");
    for (double const one : multipliers) out.add(one), out.end_row();
    write_whole_file(path, out.text(), durable);
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
  void write_grid(std::string const& path, MediumFrame<d> const& frame, double time, bool durable) const {
    auto const &x = frame.places, &v = frame.velocities;
    auto const& cells = medium_.motion->cells();
    GridPoints<d> points(cells);
    VtuFile file(path, time, points.size(), cells.cells());
    file.point_data("reference", at_points(points, true, [&](auto k) { return cells.reference(k); }), 3);
    file.point_data("velocity", at_points(points, false, [&](auto k) { return v[k]; }), 3);
    auto const size = field_size(asked_);
    auto const fields = mean_fields(medium_, x, frame.multipliers, asked_, false);
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
  bool vtu_, hdf5_;
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

SnapshotKind medium_snapshots(bool fluid, bool keeps_volumes) {
  SnapshotKind out{"the reference coordinates X Y Z of the nodes, their positions x y z and velocities u v w",
                   {},
                   {{"vtu",
                     "grids for ParaView in snapshots/000000.vtu, ... with the fields in each cell, and "
                     "snapshots/series.pvd, which lists them with their times"}},
                   "all of them in one file snapshots/frames.h5, with time, position, velocity and what was "
                   "asked for of each frame and node, and reference and cells"};
  for (auto const& field : medium_fields<3>())
    if (!(fluid && field.of_solids)) out.columns.push_back({field.name, field.meaning});
  if (keeps_volumes)
    out.always +=
        ", and snapshots/000000.cells.csv, ... the pressure in each cell by which it keeps its volume";
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
