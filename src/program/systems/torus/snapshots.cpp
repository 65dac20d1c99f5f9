#include "program/systems/torus/snapshots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "program/base/number_table.hpp"
#include "program/output/array_file.hpp"
#include "program/registry/units.hpp"
#include "program/run/checkpoint.hpp"
#include "program/systems/torus/input.hpp"

namespace actio::scene {
namespace {

/// A field that snapshots hold.
struct TorusField {
  std::string name;
  std::string meaning;
  torus::GridValues torus::FlowFields::*values;
};
std::vector<TorusField> const& torus_fields() {
  static std::vector<TorusField> const all{
      {"vorticity", "of the flow, the potential one where there is a deformation",
       &torus::FlowFields::vorticity},
      {"streamfunction", "with the mean zero; the vorticity is its Laplacian, but with a deformation",
       &torus::FlowFields::streamfunction},
      {"u", "the velocity along x, minus the derivative of the stream function along y",
       &torus::FlowFields::along_x},
      {"v", "the velocity along y", &torus::FlowFields::along_y}};
  return all;
}

class TorusSnapshots : public SnapshotWriter {
 public:
  TorusSnapshots(Request const& request, double gamma, int n, TorusMotion const& motion)
      : title_(request.file.section("scene").text("title")),
        unit_(read_units(request.file).time),
        netcdf_(request.snapshots->in("netcdf")),
        csv_(!netcdf_ || request.snapshots->in("csv")),
        gamma_(gamma),
        n_(n),
        motion_(motion) {
    for (auto const& field : torus_fields())
      if (asked_.empty() || std::ranges::count(request.snapshots->columns, field.name) > 0)
        asked_.push_back(field);
  }

  std::vector<std::string> files(long number) const override {
    std::vector<std::string> out{snapshot_file(number, ".harmonics.csv")};
    if (csv_) out.push_back(snapshot_file(number, ".csv"));
    return out;
  }
  std::vector<std::string> files_in(std::string const& format, long) const override {
    return format == "netcdf" ? std::vector<std::string>{fields_file} : std::vector<std::string>{};
  }
  double bytes_of_one() const override {
    constexpr double number = 21;
    double const points = static_cast<double>(n_) * n_, whole = 2 + std::ceil(std::log10(n_));
    return points / 2 * (2 * whole + 2 * number) +
           (csv_ ? points * (2 + static_cast<double>(asked_.size())) * number : 0) +
           (netcdf_ ? sizeof(double) * 5 * points : 0);
  }

  void write(std::string const& folder, long number, double, bool durable) override {
    torus::TorusHarmonics const f = now();
    write_whole_file(folder + "/" + snapshot_file(number, ".harmonics.csv"), table_of_torus_harmonics(f),
                     durable);
    if (!csv_) return;
    torus::FlowFields const fields = torus::flow_on_grid(f, gamma_, n_);
    std::string heading = "x,y";
    for (auto const& field : asked_) heading += "," + field.name;
    NumberTable table(heading);
    for (int k = 0; k < n_; ++k)
      for (int j = 0; j < n_; ++j) {
        table.add(place(j)), table.add(place(k));
        for (auto const& field : asked_) table.add((fields.*field.values)(k, j));
        table.end_row();
      }
    write_whole_file(folder + "/" + snapshot_file(number, ".csv"), table.text(), durable);
  }
  std::vector<SnapshotArray> coordinates() const override {
    auto const along = static_cast<std::size_t>(n_);
    return {{"x", "of the columns, lengths", {"x"}, {along}, places()},
            {"y", "of the rows, lengths", {"y"}, {along}, places()}};
  }
  std::vector<SnapshotArray> fields() const override { return arrays_of(now()); }
  std::vector<SnapshotArray> fields_in(std::string const& folder, long number) const override {
    return arrays_of(written(folder, number));
  }
  void make(std::string const& format, std::string const& folder, std::span<double const> times,
            bool durable) const override;

 private:
  static constexpr char const* fields_file = "snapshots/fields.nc";

  double place(int k) const { return 2 * M_PI * k / n_; }
  std::vector<double> places() const {
    std::vector<double> out;
    for (int k = 0; k < n_; ++k) out.push_back(place(k));
    return out;
  }
  torus::TorusHarmonics now() const {
    torus::TorusHarmonics f = torus::harmonics_of(motion_.vorticity());
    f.set(0, 0, 0);  // rounding: the trace of the matrix is zero
    return f;
  }
  torus::TorusHarmonics written(std::string const& folder, long number) const {
    return read_torus_harmonics_file(folder + "/" + snapshot_file(number, ".harmonics.csv"), n_);
  }
  /// Row by row from the least y on.
  static std::vector<double> row_by_row(torus::GridValues const& values) {
    torus::GridValues const turned = values.transpose();
    return {turned.data(), turned.data() + turned.size()};
  }
  std::vector<SnapshotArray> arrays_of(torus::TorusHarmonics const& f) const {
    torus::FlowFields const fields = torus::flow_on_grid(f, gamma_, n_);
    std::vector<SnapshotArray> out;
    for (auto const& field : asked_) {
      SnapshotArray& one = out.emplace_back();
      one.name = field.name, one.meaning = field.meaning, one.axes = {"y", "x"};
      one.shape = {static_cast<std::size_t>(n_), static_cast<std::size_t>(n_)};
      one.numbers = row_by_row(fields.*field.values);
    }
    return out;
  }

  std::string title_, unit_;
  std::vector<TorusField> asked_;
  bool netcdf_, csv_;
  double gamma_;
  int n_;
  TorusMotion const& motion_;
};

void TorusSnapshots::make(std::string const& format, std::string const& folder, std::span<double const> times,
                          bool durable) const {
  if (format != "netcdf") return;
  auto const along = static_cast<std::size_t>(n_);
  ArraySet::Axis const time{"time"}, y{"y", along}, x{"x", along};
  auto const named = [](std::string const& words) {
    return std::vector<ArrayAttribute>{{"long_name", {words}}};
  };
  std::vector<ArraySet> sets{{"time",
                              {time},
                              {},
                              false,
                              false,
                              named(unit_.empty() ? "time in units of the scene" : "time in " + unit_)},
                             {"y", {y}, {}, false, false, named("y, from 0 to 2 pi")},
                             {"x", {x}, {}, false, false, named("x, from 0 to 2 pi")}};
  sets[1].attributes.push_back({"axis", {"Y"}}), sets[2].attributes.push_back({"axis", {"X"}});
  for (auto const& field : torus_fields()) {
    ArraySet& set = sets.emplace_back(ArraySet{field.name, {time, y, x}, {1, along, along}});
    set.attributes = named(field.meaning);
  }
  ArrayFile file(ArrayFile::Format::netcdf, folder + "/" + fields_file,
                 {{"Conventions", {"CF-1.10"}},
                  {"title", {title_}},
                  {"source", {"actio " ACTIO_VERSION ", vorticity_torus"}},
                  {"comment", {"Ideal fluid on the flat torus, whose sides have the length 2 pi."}}},
                 sets);
  file.put(1, 0, places()), file.put(2, 0, places());
  for (std::size_t k = 0; k < times.size(); ++k) {
    torus::FlowFields const fields = torus::flow_on_grid(written(folder, static_cast<long>(k)), gamma_, n_);
    std::size_t at = 3;
    for (auto const& field : torus_fields()) file.put(at++, k, row_by_row(fields.*field.values));
    file.put(0, k, times.subspan(k, 1));
  }
  file.name(durable);
}

}  // namespace

SnapshotKind torus_snapshots() {
  std::vector<SnapshotKind::Column> columns;
  for (auto const& field : torus_fields())
    if (field.name != "vorticity") columns.push_back({field.name, field.meaning});
  return {"x, y and vorticity on N by N points",
          columns,
          {{"netcdf",
            "all of them in one file snapshots/fields.nc, NetCDF-4 after CF-1.10, with vorticity, stream "
            "function and velocity"}}};
}

std::unique_ptr<SnapshotWriter> write_torus(Request const& request, double gamma, int n,
                                            TorusMotion const& motion) {
  if (!request.snapshots) return nullptr;
  return std::make_unique<TorusSnapshots>(request, gamma, n, motion);
}

}  // namespace actio::scene
