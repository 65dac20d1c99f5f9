#include "actio/scene/systems/medium_snapshots.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include "actio/scene/checkpoint.hpp"
#include "actio/scene/number_table.hpp"
#include "actio/scene/systems/vtu_file.hpp"

namespace actio::scene {
namespace {

std::vector<std::string> stress_names(int d) {
  std::vector<std::string> out;
  for (int a = 0; a < d; ++a)
    for (int b = a; b < d; ++b) out.push_back(std::string("stress_") + "xyz"[a] + "xyz"[b]);
  return out;
}

/// The numbers that VTK has for cells.
unsigned char vtk_type(BodyMesh::Shape shape) {
  static constexpr unsigned char types[] = {3, 5, 9, 10, 12};
  return types[static_cast<int>(shape)];
}
/// The corner of a cell that VTK counts as number k: around the faces of box-like ones.
std::size_t vtk_corner(BodyMesh::Shape shape, std::size_t k) {
  bool const boxlike = shape == BodyMesh::Shape::quadrilateral || shape == BodyMesh::Shape::hexahedron;
  return boxlike ? k ^ (k >> 1 & 1) : k;
}

template <int d>
class MediumSnapshots : public SnapshotWriter {
 public:
  using Place = std::array<double, d>;
  MediumSnapshots(SnapshotRequest const& request, MediumView<d> const& medium)
      : asked_(request.columns), vtu_(request.in("vtu")), csv_(!vtu_ || request.in("csv")), medium_(medium) {}

  std::vector<std::string> files(long number) const override {
    std::vector<std::string> out;
    if (csv_) out.push_back(snapshot_file(number, ".csv"));
    if (vtu_) out.push_back(snapshot_file(number, ".vtu"));
    return out;
  }
  std::vector<std::string> shared_files() const override {
    return vtu_ ? std::vector<std::string>{series_file} : std::vector<std::string>{};
  }
  double bytes_of_one() const override {
    auto const& cells = medium_.motion->cells();
    double const nodes = static_cast<double>(cells.nodes()), all = static_cast<double>(cells.cells()),
                 fields = field_size<d>(asked_);
    // A number of a table has about 19 characters; zlib leaves of doubles that differ about all, and of what
    // counts corners little.
    return (csv_ ? nodes * (3 * d + fields) * 19 : 0) + (vtu_ ? 8 * (nodes * 9 + all * fields) : 0);
  }

  /// The list of grids is made anew: it may have been cut short.
  void begin(std::string const& folder, std::span<double const> taken) override {
    if (!vtu_) return;
    std::string text = pvd_beginning();
    for (std::size_t k = 0; k < taken.size(); ++k)
      text += pvd_entry(taken[k], file_in_series(static_cast<long>(k)));
    write_whole_file(folder + "/" + series_file, text + pvd_end(), false);
  }
  void write(std::string const& folder, long number, double time, bool durable) override {
    auto const x = medium_.motion->places(), v = medium_.motion->velocities();
    if (csv_) write_whole_file(folder + "/" + snapshot_file(number, ".csv"), table(x, v), durable);
    if (!vtu_) return;
    write_whole_file(folder + "/" + snapshot_file(number, ".vtu"), grid(x, v, time), durable);
    add_to_series(folder + "/" + series_file, pvd_entry(time, file_in_series(number)));
  }

 private:
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

  std::string table(std::vector<Place> const& x, std::vector<Place> const& v) const {
    std::string heading;
    for (char const* const names : {"XYZ", "xyz", "uvw"})
      for (int a = 0; a < d; ++a) heading += std::string(heading.empty() ? "" : ",") + names[a];
    for (auto const& name : asked_)
      if (name != "stress")
        heading += "," + name;
      else
        for (auto const& one : stress_names(d)) heading += "," + one;
    NumberTable out(heading);
    auto const fields = mean_fields(medium_, x, asked_, true);
    auto const size = static_cast<std::size_t>(field_size<d>(asked_));
    out.reserve(x.size() * (3 * d + size));
    for (std::size_t k = 0; k < x.size(); ++k) {
      for (double const one : medium_.motion->cells().reference(k)) out.add(one);
      for (double const one : x[k]) out.add(one);
      for (double const one : v[k]) out.add(one);
      for (std::size_t i = 0; i < size; ++i) out.add(fields[k * size + i]);
      out.end_row();
    }
    return out.text();
  }

  /// Points of the grid: the nodes, and beyond the seams of a periodic box once more those that cells need.
  struct GridPoints {
    std::vector<std::pair<std::size_t, unsigned char>> of;  ///< nodes, with bits of the periods beyond
    std::vector<std::int64_t> corners;
  };
  GridPoints grid_points() const {
    auto const& cells = medium_.motion->cells();
    GridPoints out;
    for (std::size_t k = 0; k < cells.nodes(); ++k) out.of.push_back({k, 0});
    std::map<std::pair<int, unsigned char>, std::int64_t> beyond;
    int const corners = corner_count(cells.shape());
    out.corners.reserve(cells.cells() * static_cast<std::size_t>(corners));
    for (std::size_t c = 0; c < cells.cells(); ++c) {
      auto const cell = cells.cell(c);
      for (std::size_t k = 0; k < static_cast<std::size_t>(corners); ++k) {
        std::size_t const b = vtk_corner(cells.shape(), k);
        int const node = cell.nodes[b];
        unsigned char const wrap = cell.wraps[b];
        if (wrap == 0) {
          out.corners.push_back(node);
          continue;
        }
        auto const [at, is_new] = beyond.try_emplace({node, wrap}, static_cast<std::int64_t>(out.of.size()));
        if (is_new) out.of.push_back({static_cast<std::size_t>(node), wrap});
        out.corners.push_back(at->second);
      }
    }
    return out;
  }
  /// Vectors at the points of the grid, with three components.
  /// @param shift  whether they are places, which lie periods beyond
  template <class At>
  std::vector<double> at_points(GridPoints const& points, bool shift, At const& at) const {
    std::vector<double> out(3 * points.of.size(), 0);
    for (std::size_t k = 0; k < points.of.size(); ++k) {
      auto const [node, wrap] = points.of[k];
      Place const p = at(node);
      for (std::size_t a = 0; a < d; ++a)
        out[3 * k + a] =
            p[a] + (shift && wrap >> a & 1 ? medium_.motion->cells().period(static_cast<int>(a)) : 0);
    }
    return out;
  }
  std::string grid(std::vector<Place> const& x, std::vector<Place> const& v, double time) const {
    auto const& cells = medium_.motion->cells();
    GridPoints const points = grid_points();
    VtuFile file(time, points.of.size(), cells.cells());
    file.point_data("reference", at_points(points, true, [&](auto k) { return cells.reference(k); }), 3);
    file.point_data("velocity", at_points(points, false, [&](auto k) { return v[k]; }), 3);
    auto const size = static_cast<std::size_t>(field_size<d>(asked_));
    auto const fields = mean_fields(medium_, x, asked_, false);
    std::size_t first = 0;
    for (auto const& name : asked_) {
      std::size_t const wide = name == "stress" ? d * (d + 1) / 2 : 1;
      std::vector<double> one;
      one.reserve(cells.cells() * wide);
      for (std::size_t c = 0; c < cells.cells(); ++c)
        for (std::size_t i = 0; i < wide; ++i) one.push_back(fields[c * size + first + i]);
      file.cell_data(name, one, static_cast<int>(wide));
      first += wide;
    }
    file.points(at_points(points, true, [&](auto k) { return x[k]; }));
    file.cells(points.corners, corner_count(cells.shape()), vtk_type(cells.shape()));
    return file.text();
  }

  std::vector<std::string> asked_;
  bool vtu_, csv_;
  MediumView<d> medium_;
};

}  // namespace

SnapshotKind medium_snapshots(bool fluid) {
  SnapshotKind out{"the reference coordinates X Y Z of the nodes, their places x y z and velocities u v w",
                   {{"jacobian", "J, the volume over that of the reference"},
                    {"pressure", "minus a d-th of the trace of Cauchy's stress"},
                    {"density", "mass per volume in space"},
                    {"energy_density", "stored energy per reference volume"}},
                   {{"vtu",
                     "grids for ParaView in snapshots/000000.vtu, ... with the fields in each cell, and "
                     "snapshots/series.pvd, which lists them with their times"}}};
  if (!fluid)
    out.columns.push_back({"stress", "Cauchy's, its components xx, xy, yy or xx, xy, xz, yy, yz, zz"});
  return out;
}

template <int d>
std::unique_ptr<SnapshotWriter> write_medium(Request const& request, MediumView<d> const& medium) {
  if (!request.snapshots) return nullptr;
  return std::make_unique<MediumSnapshots<d>>(*request.snapshots, medium);
}
/// Along a line.
template std::unique_ptr<SnapshotWriter> write_medium(Request const&, MediumView<1> const&);
/// In the plane.
template std::unique_ptr<SnapshotWriter> write_medium(Request const&, MediumView<2> const&);
/// In space.
template std::unique_ptr<SnapshotWriter> write_medium(Request const&, MediumView<3> const&);

}  // namespace actio::scene
