#include "program/systems/rods/snapshots.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "program/base/number_table.hpp"
#include "program/medium_output/frames.hpp"
#include "program/medium_output/grid_series.hpp"
#include "program/medium_output/vtu_file.hpp"
#include "program/output/series_reader.hpp"
#include "program/registry/units.hpp"
#include "program/run/checkpoint.hpp"
#include "program/systems/rods/playing.hpp"
#include "program/systems/rods/snapshot_fields.hpp"

namespace actio::scene {
namespace {

class RodSnapshots : public SnapshotWriter {
 public:
  RodSnapshots(SceneFile const& file, SnapshotRequest const& request, RodScene const& scene,
               RodMotion const& motion)
      : file_(file),
        elements_(rod_fields(request.columns)),
        vtu_(request.in("vtu")),
        hdf5_(request.in("hdf5")),
        tube_{scene.section, scene.rest.shape, scene.rest.length},
        distances_(scene.rest.distances),
        motion_(motion) {}

  std::vector<std::string> files(long number) const override {
    std::vector<std::string> out{snapshot_file(number, ".csv")};
    if (!elements_.empty()) out.push_back(snapshot_file(number, elements_file));
    return out;
  }
  std::vector<std::string> files_in(std::string const& format, long taken) const override {
    if (format == "vtu") return grid_series_files(taken);
    return format == "hdf5" ? std::vector<std::string>{frames_file} : std::vector<std::string>{};
  }
  double bytes_of_one() const override {
    double const sections = static_cast<double>(distances_.size()),
                 more = 3 * static_cast<double>(elements_.size());
    return sections * (19 * (14 + (more > 0 ? 1 + more : 0)) + (vtu_ ? 8 * (18 + more) : 0) +
                       (hdf5_ ? 8 * (13 + more) : 0));
  }
  void write(std::string const& folder, long number, double, bool durable) override {
    auto const numbers = now();
    write_table(folder + "/" + snapshot_file(number, ".csv"), distances_, fields_of_sections(), numbers, 0,
                durable);
    if (!elements_.empty())
      write_table(folder + "/" + snapshot_file(number, elements_file), middles(), elements_, numbers,
                  fields_of_sections().size(), durable);
  }
  void make(std::string const& format, std::string const& folder, std::span<double const> times,
            bool durable) const override {
    if (format == "hdf5")
      write_frames(
          folder + "/" + frames_file, frame_texts(file_), constants(), arrays(), read_units(file_).time,
          times, [&](long k) { return numbers_in(folder, k, true); }, durable);
    if (format == "vtu")
      write_grid_series(
          folder, times,
          [&](std::string const& path, long k) {
            write_lines(path, numbers_in(folder, k, true), times[static_cast<std::size_t>(k)], durable);
          },
          durable);
  }
  std::vector<SnapshotArray> coordinates() const override {
    std::vector<SnapshotArray> out;
    for (auto& one : constants()) out.push_back(std::move(one.array)), out.back().numbers = one.numbers();
    return out;
  }
  std::vector<SnapshotArray> fields() const override { return with(now()); }
  std::vector<SnapshotArray> fields_in(std::string const& folder, long number) const override {
    return with(numbers_in(folder, number, true));
  }
  std::shared_ptr<PlayedMedium const> played(std::string const& folder,
                                             std::span<double const> times) const override {
    return play_rod(tube_, times, [&](std::size_t number) {
      auto const found = numbers_in(folder, static_cast<long>(number), false);
      RodPosture out;
      for (std::size_t k = 0; k < distances_.size(); ++k) {
        auto const at = [&](std::size_t field, std::size_t i) {
          return found[field][k * fields_of_sections()[field].components.size() + i];
        };
        out.places.push_back({at(0, 0), at(0, 1), at(0, 2)});
        out.attitudes.push_back({at(1, 0), at(1, 1), at(1, 2), at(1, 3)});
        out.velocities.push_back({at(2, 0), at(2, 1), at(2, 2)});
      }
      return out;
    });
  }

 private:
  static constexpr char const* elements_file = ".elements.csv";

  std::vector<double> middles() const {
    double const D = tube_.length / static_cast<double>(tube_.rest.elements());
    std::vector<double> out;
    for (std::size_t k = 0; k < tube_.rest.elements(); ++k) out.push_back((static_cast<double>(k) + 0.5) * D);
    return out;
  }
  /// All fields, those of sections first.
  std::vector<RodField> all() const {
    auto out = fields_of_sections();
    out.insert(out.end(), elements_.begin(), elements_.end());
    return out;
  }
  /// The fields, without their numbers.
  std::vector<SnapshotArray> arrays() const {
    auto const units = read_units(file_);
    std::vector<SnapshotArray> out;
    for (auto const& field : all()) {
      bool const sections = out.size() < fields_of_sections().size();
      SnapshotArray& one = out.emplace_back();
      one.name = field.name, one.meaning = field.meaning, one.unit = units.in(field.unit);
      one.axes = {sections ? "section" : "element", "component"};
      one.shape = {sections ? distances_.size() : tube_.rest.elements(), field.components.size()};
      one.names = field.components;
    }
    return out;
  }
  std::vector<SnapshotArray> with(FrameNumbers numbers) const {
    auto out = arrays();
    for (std::size_t k = 0; k < out.size(); ++k) out[k].numbers = std::move(numbers[k]);
    return out;
  }
  std::vector<FrameConstant> constants() const {
    auto const unit = read_units(file_).in("length");
    std::vector<FrameConstant> out;
    auto const add = [&](char const* name, char const* meaning, char const* axis,
                         std::vector<double> const& numbers) {
      SnapshotArray array;
      array.name = name, array.meaning = meaning, array.unit = unit;
      array.axes = {axis}, array.shape = {numbers.size()};
      out.push_back({std::move(array), [numbers] { return numbers; }});
    };
    add("distance", "of the sections from the start along the rod at rest", "section", distances_);
    add("middle", "of the elements, the distance from the start along the rod at rest", "element", middles());
    return out;
  }

  /// The numbers of the state now.
  FrameNumbers now() const {
    auto const& frame = motion_.frame();
    auto const& constants = motion_.rod().constants();
    FrameNumbers out;
    auto const flat = [&out](auto const& vectors, auto const& as) {
      auto& to = out.emplace_back();
      for (std::size_t k = 0; k < vectors.size(); ++k)
        for (double const one : as(vectors[k], k)) to.push_back(one);
    };
    auto const same = [](auto const& v, std::size_t) { return v; };
    flat(frame.places, same), flat(frame.attitudes, same), flat(frame.velocities, same);
    flat(frame.body_momenta, [&](auto const& M, std::size_t k) {
      auto const& J = constants.section.inertia;
      double const share = constants.share[k];
      return rods::Three<double>{M[0] / (share * J[0]), M[1] / (share * J[1]), M[2] / (share * J[2])};
    });
    for (auto const& field : elements_) {
      std::string const name = field.name;
      if (name == "stretch") flat(frame.strains, [](auto const& e, std::size_t) { return e.Gamma; });
      if (name == "curvature") flat(frame.strains, [](auto const& e, std::size_t) { return e.kappa; });
      if (name == "contact_force") flat(frame.contact_force, same);
      if (name == "contact_moment") flat(frame.contact_moment, same);
    }
    return out;
  }
  /// Those of a snapshot that was written.
  FrameNumbers numbers_in(std::string const& folder, long number, bool elements) const {
    auto out =
        read_table(folder + "/" + snapshot_file(number, ".csv"), distances_.size(), fields_of_sections());
    if (!elements || elements_.empty()) return out;
    for (auto& one :
         read_table(folder + "/" + snapshot_file(number, elements_file), tube_.rest.elements(), elements_))
      out.push_back(std::move(one));
    return out;
  }
  static std::vector<std::string> columns_of(std::vector<RodField> const& fields) {
    std::vector<std::string> out{"s"};
    for (auto const& field : fields)
      for (auto& one : field.columns()) out.push_back(std::move(one));
    return out;
  }
  static FrameNumbers read_table(std::string const& path, std::size_t rows,
                                 std::vector<RodField> const& fields) {
    auto const columns = columns_of(fields);
    auto const reader = read_csv_series(path, columns);
    FrameNumbers out(fields.size());
    std::size_t count = 0;
    for (std::vector<double> row(columns.size()); reader->next(row); ++count) {
      auto at = row.begin() + 1;
      for (std::size_t k = 0; k < fields.size(); ++k) {
        auto const wide = static_cast<long>(fields[k].components.size());
        out[k].insert(out[k].end(), at, at + wide), at += wide;
      }
    }
    if (count != rows)
      throw FileError(fmt::format("{}: has {} rows, where the rod of the scene has {}", path, count, rows));
    return out;
  }
  /// @param first  of the numbers, those of the first field
  static void write_table(std::string const& path, std::vector<double> const& distances,
                          std::vector<RodField> const& fields, FrameNumbers const& numbers, std::size_t first,
                          bool durable) {
    NumberTable out(fmt::format("{}", fmt::join(columns_of(fields), ",")));
    for (std::size_t k = 0; k < distances.size(); ++k) {
      out.add(distances[k]);
      for (std::size_t i = 0; i < fields.size(); ++i) {
        std::size_t const wide = fields[i].components.size();
        for (std::size_t n = 0; n < wide; ++n) out.add(numbers[first + i][k * wide + n]);
      }
      out.end_row();
    }
    write_whole_file(path, out.text(), durable);
  }

  /// Lines between the sections, with their axes at the points.
  void write_lines(std::string const& path, FrameNumbers const& numbers, double time, bool durable) const {
    std::size_t const sections = distances_.size(), elements = tube_.rest.elements();
    VtuFile file(path, time, sections, elements);
    file.point_data(
        "distance", [&](std::size_t k) { return distances_[k]; }, 1);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<double> d;
      for (std::size_t k = 0; k < sections; ++k) {
        double const* const q = &numbers[1][4 * k];
        rods::Three<double> unit{};
        unit[axis] = 1;
        for (double const one : rods::turned(rods::Four<double>{q[0], q[1], q[2], q[3]}, unit))
          d.push_back(one);
      }
      file.point_data(
          "d" + std::to_string(axis + 1), [&](std::size_t k) { return d[k]; }, 3);
    }
    file.point_data(
        "velocity", [&](std::size_t k) { return numbers[2][k]; }, 3);
    file.point_data(
        "angular_velocity", [&](std::size_t k) { return numbers[3][k]; }, 3);
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      auto const& values = numbers[fields_of_sections().size() + i];
      file.cell_data(
          elements_[i].name, [&](std::size_t k) { return values[k]; }, elements_[i].components);
    }
    file.points([&](std::size_t k) { return numbers[0][k]; });
    constexpr unsigned char line = 3;
    file.cells(
        [&](std::size_t k) {
          return static_cast<std::int64_t>(k % 2 == 0 ? k / 2 : tube_.rest.after(k / 2));
        },
        2, line);
    file.end(durable);
  }

  SceneFile file_;
  std::vector<RodField> elements_;
  bool vtu_, hdf5_;
  DrawnRod tube_;
  std::vector<double> distances_;
  RodMotion const& motion_;
};

}  // namespace

SnapshotKind rod_snapshots() {
  SnapshotKind out{
      "the distance s of the sections along the rod at rest, their positions x y z, attitudes qw qx "
      "qy qz, velocities u v w, and angular velocities w1 w2 w3 in their axes",
      {},
      {{"vtu",
        "lines for ParaView in snapshots/000000.vtu, ... with the axes d1, d2, d3 of the sections "
        "at the points and what was asked for in each element, and snapshots/series.pvd, which "
        "lists them with their times"}},
      "all of them in one file snapshots/frames.h5, with time, and of each frame position, attitude, "
      "velocity and angular_velocity of the sections and what was asked for of the elements"};
  for (auto const& field : fields_of_elements())
    out.columns.push_back({field.name, field.meaning + std::string(", of each element in "
                                                                   "snapshots/000000.elements.csv, ...")});
  return out;
}

std::unique_ptr<SnapshotWriter> write_rod(Request const& request, RodScene const& scene,
                                          RodMotion const& motion) {
  if (!request.snapshots) return nullptr;
  return std::make_unique<RodSnapshots>(request.file, *request.snapshots, scene, motion);
}

}  // namespace actio::scene
