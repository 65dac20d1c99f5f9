#include "program/systems/sphere/snapshots.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

#include "program/base/number_table.hpp"
#include "program/registry/units.hpp"
#include "program/run/checkpoint.hpp"
#include "program/systems/sphere/input.hpp"

namespace actio::scene {
namespace {

std::string table_of_harmonics(sphere::SphereHarmonics const& f) {
  NumberTable table("l,m,re,im");
  for (int l = 1; l < f.degrees(); ++l)
    for (int m = 0; m <= l; ++m) {
      table.add(l), table.add(m), table.add(f(l, m).real()), table.add(m == 0 ? 0 : f(l, m).imag());
      table.end_row();
    }
  return table.text();
}

std::string table_of_fields(sphere::SphereGrid const& grid, std::vector<std::string> const& names,
                            std::vector<sphere::GridField const*> const& fields) {
  std::string heading = "longitude,latitude";
  for (auto const& name : names) heading += "," + name;
  NumberTable table(heading);
  for (int j = 0; j < grid.latitudes(); ++j)
    for (int k = 0; k < grid.longitudes; ++k) {
      table.add(grid.longitude(k)), table.add(grid.latitude(j));
      for (auto const* field : fields) table.add((*field)(j, k));
      table.end_row();
    }
  return table.text();
}

class VorticitySnapshots : public SnapshotWriter {
 public:
  VorticitySnapshots(SnapshotRequest const& request, int n, VorticityMotion const& motion,
                     FieldsFile const& file)
      : names_{"vorticity"},
        netcdf_(request.in("netcdf")),
        csv_(!netcdf_ || request.in("csv")),
        n_(n),
        motion_(motion),
        file_(file),
        grid_(sphere::SphereGrid::gauss(n, 2 * n)) {
    names_.insert(names_.end(), request.columns.begin(), request.columns.end());
  }

  std::vector<std::string> files(long number) const override {
    std::vector<std::string> out{snapshot_file(number, ".harmonics.csv")};
    if (csv_) out.push_back(snapshot_file(number, ".csv"));
    return out;
  }
  std::vector<std::string> shared_files() const override {
    return netcdf_ ? std::vector<std::string>{fields_file, std::string(fields_file) + ".part"}
                   : std::vector<std::string>{};
  }

  double bytes_of_one() const override {
    double const n = n_, rows = n * (n + 1) / 2 - 1, places = 2 * n * n;
    // A number with 17 digits, its sign, point and comma has 20 characters, some have an exponent.
    constexpr double number = 21;
    double const whole = 1 + std::ceil(std::log10(n + 1));
    double bytes = rows * (2 * whole + 2 * number);
    if (csv_) bytes += places * (2 + static_cast<double>(names_.size())) * number;
    if (netcdf_) bytes += sizeof(double) * (1 + 4 * places + 2 * rows);
    return bytes;
  }

  /// The file that all share is made anew: it may have been cut short, and the harmonics hold all of it.
  void begin(std::string const& folder, std::span<double const> taken) override {
    if (!netcdf_) return;
    std::string const path = unseen(folder);
    std::filesystem::remove(path);
    file_.create(path, grid_, n_);
    for (std::size_t k = 0; k < taken.size(); ++k) {
      long const number = static_cast<long>(k);
      sphere::SphereHarmonics const f =
          read_harmonics_file(folder + "/" + snapshot_file(number, ".harmonics.csv"), n_);
      file_.add(path, number, taken[k], all_fields(sphere::symbol_of(f, file_.symbol)), f);
    }
    behind_ = true;
    flush(folder, true);
  }

  /// Readers have the file open for as long as they like, and may lock it. So nothing is written into the one
  /// that they see: a copy gets what is new, and then its name. A copy takes as long as the file is large,
  /// and is made for a twentieth of the time at most.
  void flush(std::string const& folder, bool at_once) override {
    if (!behind_ || (!at_once && Clock::now() < due_)) return;
    std::error_code error;
    std::filesystem::rename(unseen(folder), folder + "/" + fields_file, error);
    if (error) throw FileError(folder + "/" + fields_file + ": cannot be written: " + error.message());
    behind_ = false;
    due_ = Clock::now() + 20 * copying_;
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

  void write(std::string const& folder, long number, double time, bool durable) override {
    sphere::SphereHarmonics const f = harmonics_now();
    write_whole_file(folder + "/" + snapshot_file(number, ".harmonics.csv"), table_of_harmonics(f), durable);
    sphere::FlowFields const fields = needed_fields(sphere::symbol_of(f, file_.symbol));
    if (csv_) {
      std::vector<sphere::GridField const*> columns;
      for (auto const& name : names_) columns.push_back(&field_of(fields, name));
      write_whole_file(folder + "/" + snapshot_file(number, ".csv"), table_of_fields(grid_, names_, columns),
                       durable);
    }
    if (!netcdf_) return;
    copy_what_is_seen(folder);
    file_.add(unseen(folder), number, time, fields, f);
    behind_ = true;
    flush(folder, false);
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr char const* fields_file = "snapshots/fields.nc";

  /// The file that the next snapshot is added to.
  static std::string unseen(std::string const& folder) { return folder + "/" + fields_file + ".part"; }
  void copy_what_is_seen(std::string const& folder) {
    if (behind_) return;
    auto const began = Clock::now();
    std::error_code error;
    std::filesystem::remove(unseen(folder), error);
    std::filesystem::copy_file(folder + "/" + fields_file, unseen(folder), error);
    if (error) throw FileError(folder + "/" + fields_file + ": cannot be copied: " + error.message());
    copying_ = Clock::now() - began;
  }

  sphere::SphereHarmonics harmonics_now() const {
    sphere::SphereHarmonics f = sphere::harmonics_of(motion_.vorticity_at_output());
    f(0, 0) = 0;  // rounding: the trace of the matrix is zero
    return f;
  }
  static sphere::GridField const& field_of(sphere::FlowFields const& fields, std::string const& name) {
    return name == "vorticity"        ? fields.vorticity
           : name == "streamfunction" ? fields.streamfunction
           : name == "u"              ? fields.east
                                      : fields.north;
  }
  std::vector<SnapshotArray> arrays_of(sphere::SphereHarmonics const& f) const {
    sphere::FlowFields const fields = needed_fields(sphere::symbol_of(f, file_.symbol));
    std::vector<SnapshotArray> out;
    for (auto const& name : names_) {
      SnapshotArray& one = out.emplace_back();
      one.name = name, one.meaning = meaning_of(name), one.axes = {"latitude", "longitude"};
      sphere::GridField const& field = field_of(fields, name);
      one.shape = {static_cast<std::size_t>(field.rows()), static_cast<std::size_t>(field.cols())};
      one.numbers.assign(field.data(), field.data() + field.size());
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
  static std::string meaning_of(std::string const& name) {
    for (auto const& column : vorticity_snapshots().columns)
      if (column.name == name) return column.meaning;
    return "relative to the sphere";
  }

  bool asks(char const* name) const { return std::find(names_.begin(), names_.end(), name) != names_.end(); }
  /// The velocity belongs to the Laplacian of the stream function, which for a layer is not the vorticity.
  sphere::FlowFields all_fields(sphere::SphereHarmonics const& vorticity) const {
    sphere::FlowFields out = sphere::flow_on(grid_, file_.hamiltonian.laplacian_of_psi(vorticity));
    if (file_.hamiltonian.layer()) out.vorticity = sphere::values_on(grid_, vorticity);
    return out;
  }
  /// Those that no file holds stay empty.
  sphere::FlowFields needed_fields(sphere::SphereHarmonics const& f) const {
    if (netcdf_ || asks("u") || asks("v")) return all_fields(f);
    sphere::FlowFields out;
    if (asks("streamfunction")) {
      auto both =
          sphere::values_on(grid_, {f, sphere::stream_function(file_.hamiltonian.laplacian_of_psi(f))});
      out.vorticity = std::move(both[0]), out.streamfunction = std::move(both[1]);
    } else {
      out.vorticity = sphere::values_on(grid_, f);
    }
    return out;
  }

  std::vector<std::string> names_;
  bool netcdf_, csv_;
  int n_;
  VorticityMotion const& motion_;
  FieldsFile file_;
  sphere::SphereGrid grid_;
  bool behind_ = false;           // whether what is seen has fewer snapshots
  Clock::duration copying_ = {};  // what the last copy took
  Clock::time_point due_ = {};    // when the next one is due
};

}  // namespace

SnapshotKind vorticity_snapshots() {
  return {"longitude, latitude and vorticity",
          {{"streamfunction", "with the mean zero; the vorticity is its Laplacian, but for a layer"},
           {"u", "the velocity towards the east"},
           {"v", "towards the north"}},
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
