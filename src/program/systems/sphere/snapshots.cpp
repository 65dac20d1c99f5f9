#include "program/systems/sphere/snapshots.hpp"

#include <algorithm>
#include <cmath>

#include "program/base/number_table.hpp"
#include "program/registry/units.hpp"
#include "program/run/checkpoint.hpp"
#include "program/systems/sphere/input.hpp"

namespace actio::scene {
namespace {

/// A field that snapshots hold.
struct SphereField {
  std::string name;
  std::string meaning;
  sphere::GridField SphereFields::*values;
};
/// Those that can be asked for.
std::vector<SphereField> const& asked_fields() {
  static std::vector<SphereField> const all{
      {"streamfunction", "with the mean zero", &sphere::FlowFields::streamfunction},
      {"curl",
       "that of the velocity, the Laplacian of the stream function: the vorticity, but for a layer and for "
       "averaged flow",
       &SphereFields::curl},
      {"u", "the velocity towards the east", &sphere::FlowFields::east},
      {"v", "towards the north", &sphere::FlowFields::north}};
  return all;
}

std::string table_of_harmonics(sphere::SphereHarmonics const& f) {
  NumberTable table("l,m,re,im");
  for (int l = 1; l < f.degrees(); ++l)
    for (int m = 0; m <= l; ++m) {
      table.add(l), table.add(m), table.add(f(l, m).real()), table.add(m == 0 ? 0 : f(l, m).imag());
      table.end_row();
    }
  return table.text();
}

std::string table_of_fields(sphere::SphereGrid const& grid, std::vector<SphereField> const& asked,
                            SphereFields const& fields) {
  std::string heading = "longitude,latitude";
  for (auto const& field : asked) heading += "," + field.name;
  NumberTable table(heading);
  for (int j = 0; j < grid.latitudes(); ++j)
    for (int k = 0; k < grid.longitudes; ++k) {
      table.add(grid.longitude(k)), table.add(grid.latitude(j));
      for (auto const& field : asked) table.add((fields.*field.values)(j, k));
      table.end_row();
    }
  return table.text();
}

class VorticitySnapshots : public SnapshotWriter {
 public:
  VorticitySnapshots(SnapshotRequest const& request, int n, VorticityMotion const& motion,
                     FieldsFile const& file)
      : asked_{{"vorticity", "relative to the sphere", &sphere::FlowFields::vorticity}},
        netcdf_(request.in("netcdf")),
        csv_(!netcdf_ || request.in("csv")),
        n_(n),
        motion_(motion),
        file_(file),
        grid_(sphere::SphereGrid::gauss(n, 2 * n)) {
    for (auto const& name : request.columns)
      for (auto const& field : asked_fields())
        if (field.name == name) asked_.push_back(field);
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
    double const n = n_, rows = n * (n + 1) / 2 - 1, places = 2 * n * n;
    // A number with 17 digits, its sign, point and comma has 20 characters, some have an exponent.
    constexpr double number = 21;
    double const whole = 1 + std::ceil(std::log10(n + 1));
    double bytes = rows * (2 * whole + 2 * number);
    if (csv_) bytes += places * (2 + static_cast<double>(asked_.size())) * number;
    if (netcdf_) bytes += sizeof(double) * (1 + 4 * places + 2 * rows);
    return bytes;
  }

  void make(std::string const& format, std::string const& folder, std::span<double const> times,
            bool durable) const override {
    if (format != "netcdf") return;
    auto const frame = [&](long number) {
      auto const f = read_harmonics_file(folder + "/" + snapshot_file(number, ".harmonics.csv"), n_);
      return FieldsFile::Frame{all_fields(sphere::symbol_of(f, file_.symbol)), f};
    };
    file_.make(folder + "/" + fields_file, grid_, n_, times, frame, durable);
  }

  std::vector<SnapshotArray> coordinates() const override {
    std::vector<double> longitude, latitude, degree, order;
    for (int k = 0; k < grid_.longitudes; ++k) longitude.push_back(grid_.longitude(k));
    for (int j = 0; j < grid_.latitudes(); ++j) latitude.push_back(grid_.latitude(j));
    for (int l = 1; l < n_; ++l)
      for (int m = 0; m <= l; ++m) degree.push_back(l), order.push_back(m);
    std::size_t const meridians = longitude.size(), parallels = latitude.size(), all = degree.size();
    return {{"latitude", "of the parallels, radians", {"latitude"}, {parallels}, std::move(latitude)},
            {"longitude", "of the meridians, radians", {"longitude"}, {meridians}, std::move(longitude)},
            {"l", "the degree", {"coefficient"}, {all}, std::move(degree), {}, "", true},
            {"m", "the order", {"coefficient"}, {all}, std::move(order), {}, "", true}};
  }
  std::vector<SnapshotArray> fields() const override { return arrays_of(harmonics_now()); }
  std::vector<SnapshotArray> fields_in(std::string const& folder, long number) const override {
    return arrays_of(read_harmonics_file(folder + "/" + snapshot_file(number, ".harmonics.csv"), n_));
  }

  void write(std::string const& folder, long number, double, bool durable) override {
    sphere::SphereHarmonics const f = harmonics_now();
    write_whole_file(folder + "/" + snapshot_file(number, ".harmonics.csv"), table_of_harmonics(f), durable);
    if (!csv_) return;
    SphereFields const fields = needed_fields(sphere::symbol_of(f, file_.symbol));
    write_whole_file(folder + "/" + snapshot_file(number, ".csv"), table_of_fields(grid_, asked_, fields),
                     durable);
  }

 private:
  static constexpr char const* fields_file = "snapshots/fields.nc";

  sphere::SphereHarmonics harmonics_now() const {
    sphere::SphereHarmonics f = sphere::harmonics_of(motion_.vorticity_at_output());
    f(0, 0) = 0;  // rounding: the trace of the matrix is zero
    return f;
  }
  std::vector<SnapshotArray> arrays_of(sphere::SphereHarmonics const& f) const {
    SphereFields const fields = needed_fields(sphere::symbol_of(f, file_.symbol));
    std::vector<SnapshotArray> out;
    for (auto const& field : asked_) {
      SnapshotArray& one = out.emplace_back();
      one.name = field.name, one.meaning = field.meaning, one.axes = {"latitude", "longitude"};
      sphere::GridField const& values = fields.*field.values;
      one.shape = {static_cast<std::size_t>(values.rows()), static_cast<std::size_t>(values.cols())};
      one.numbers.assign(values.data(), values.data() + values.size());
    }
    for (bool const real : {true, false}) {
      SnapshotArray& part = out.emplace_back();
      part.name = real ? "harmonics_re" : "harmonics_im", part.axes = {"coefficient"};
      part.meaning = std::string(real ? "real" : "imaginary") + " part of the coefficients of the matrix";
      for (int l = 1; l < f.degrees(); ++l)
        for (int m = 0; m <= l; ++m)
          part.numbers.push_back(real ? f(l, m).real() : m == 0 ? 0 : f(l, m).imag());
      part.shape = {part.numbers.size()};
    }
    return out;
  }

  bool asks(sphere::GridField SphereFields::*values) const {
    return std::ranges::find(asked_, values, &SphereField::values) != asked_.end();
  }
  /// The velocity belongs to the Laplacian of the stream function, which is the vorticity of Euler's fluid.
  SphereFields all_fields(sphere::SphereHarmonics const& vorticity) const {
    SphereFields out{sphere::flow_on(grid_, file_.hamiltonian.laplacian_of_psi(vorticity)), {}};
    out.curl = out.vorticity;
    if (!file_.hamiltonian.euler()) out.vorticity = sphere::values_on(grid_, vorticity);
    return out;
  }
  /// Those that no file holds stay empty.
  SphereFields needed_fields(sphere::SphereHarmonics const& f) const {
    if (netcdf_ || asks(&sphere::FlowFields::east) || asks(&sphere::FlowFields::north)) return all_fields(f);
    std::vector<sphere::SphereHarmonics> functions{f};
    std::vector<sphere::GridField SphereFields::*> places{&sphere::FlowFields::vorticity};
    auto const add = [&](auto place, auto const& function) {
      if (asks(place)) functions.push_back(function()), places.push_back(place);
    };
    auto const curl = [&] { return file_.hamiltonian.laplacian_of_psi(f); };
    add(&sphere::FlowFields::streamfunction, [&] { return sphere::stream_function(curl()); });
    add(&SphereFields::curl, curl);
    auto values = sphere::values_on(grid_, functions);
    SphereFields out;
    for (std::size_t k = 0; k < places.size(); ++k) out.*places[k] = std::move(values[k]);
    return out;
  }

  std::vector<SphereField> asked_;
  bool netcdf_, csv_;
  int n_;
  VorticityMotion const& motion_;
  FieldsFile file_;
  sphere::SphereGrid grid_;
};

}  // namespace

SnapshotKind vorticity_snapshots() {
  std::vector<SnapshotKind::Column> columns;
  for (auto const& field : asked_fields()) columns.push_back({field.name, field.meaning});
  return {"longitude, latitude and vorticity",
          columns,
          {{"netcdf",
            "all of them in one file snapshots/fields.nc, NetCDF-4 after CF-1.10, with vorticity, stream "
            "function and velocity, and the coefficients of the matrix in the group spectral"}}};
}

std::unique_ptr<SnapshotWriter> write_vorticity(Request const& request, int n,
                                                SphereHamiltonian const& hamiltonian,
                                                VorticityMotion const& motion) {
  auto const& key = symbol_keys.symbol;
  if (!request.snapshots) return key.find(request.file), nullptr;
  std::string const symbol = key.read(request.file);
  FieldsFile const file{request.file.section("scene").text("title"), read_units(request.file).time,
                        symbol == "weyl" ? sphere::Symbol::weyl : sphere::Symbol::berezin, hamiltonian};
  return std::make_unique<VorticitySnapshots>(*request.snapshots, n, motion, file);
}

}  // namespace actio::scene
