// snapshots/fields.nc: closed after each snapshot, so that what is in it can be read at any time.
#include <numbers>

#include "actio/scene/netcdf_library.hpp"
#include "actio/scene/systems/vorticity_snapshots.hpp"

namespace actio::scene {
namespace {

/// A file in NetCDF that is open. What goes wrong is thrown.
class File {
 public:
  explicit File(std::string const& path) : path_(path), nc_(netcdf::library(session_)) {}
  ~File() {
    if (open_) nc_.nc_close(id_);
  }
  File(File const&) = delete;
  File& operator=(File const&) = delete;

  void create() { checked(nc_.nc_create(path_.c_str(), NC_NETCDF4 | NC_CLOBBER, &id_)), open_ = true; }
  void open() { checked(nc_.nc_open(path_.c_str(), NC_WRITE, &id_)), open_ = true; }
  void close() { open_ = false, checked(nc_.nc_close(id_)); }

  int root() const { return id_; }
  int define_group(char const* name) const {
    int group = 0;
    checked(nc_.nc_def_grp(id_, name, &group));
    return group;
  }
  int group(char const* name) const {
    int group = 0;
    checked(nc_.nc_inq_ncid(id_, name, &group));
    return group;
  }
  int dimension(int group, char const* name, std::size_t size) const {
    int dimension = 0;
    checked(nc_.nc_def_dim(group, name, size, &dimension));
    return dimension;
  }
  /// Of numbers of a type, with its attributes in pairs; those of one time are together.
  int define(int group, char const* name, nc_type type, std::vector<int> const& dimensions,
             std::vector<std::size_t> const& together,
             std::vector<std::pair<char const*, std::string>> const& attributes) const {
    int variable = 0;
    checked(
        nc_.nc_def_var(group, name, type, static_cast<int>(dimensions.size()), dimensions.data(), &variable));
    if (!together.empty()) checked(nc_.nc_def_var_chunking(group, variable, NC_CHUNKED, together.data()));
    for (auto const& [key, text] : attributes) tell(group, variable, key, text);
    return variable;
  }
  void tell(int group, int variable, char const* key, std::string const& text) const {
    checked(nc_.nc_put_att_text(group, variable, key, text.size(), text.c_str()));
  }
  void end_definitions() const { checked(nc_.nc_enddef(id_)); }
  void put(int group, int variable, std::vector<double> const& numbers) const {
    checked(nc_.nc_put_var_double(group, variable, numbers.data()));
  }
  void put(int group, int variable, std::vector<int> const& numbers) const {
    checked(nc_.nc_put_var_int(group, variable, numbers.data()));
  }
  /// What belongs to one time.
  void put(int group, char const* name, long time, std::vector<std::size_t> extent,
           double const* numbers) const {
    int variable = 0;
    checked(nc_.nc_inq_varid(group, name, &variable));
    extent.insert(extent.begin(), 1);
    std::vector<std::size_t> start(extent.size(), 0);
    start[0] = static_cast<std::size_t>(time);
    checked(nc_.nc_put_vara_double(group, variable, start.data(), extent.data(), numbers));
  }

 private:
  void checked(int status) const { nc_.checked(status, path_, "cannot be written"); }

  std::string path_;
  hdf5::Session session_;
  netcdf::Library const& nc_;
  int id_ = -1;
  bool open_ = false;
};

/// `days since ...`, where the unit is one of time as the conventions have it.
std::string units_of_time(std::string const& unit) {
  for (auto const& [name, word] :
       {std::pair("s", "seconds"), {"min", "minutes"}, {"h", "hours"}, {"d", "days"}})
    if (unit == name) return std::string(word) + " since 2000-01-01 00:00:00";
  return unit.empty() ? "1" : unit;
}
/// `s-1`
std::string per_time(std::string const& unit) { return unit.empty() ? "1" : unit + "-1"; }

constexpr double degree = std::numbers::pi / 180;

}  // namespace

void FieldsFile::create(std::string const& path, SphereGrid const& grid, int degrees) const {
  File file(path);
  file.create();
  int const root = file.root();
  auto const rows = static_cast<std::size_t>(grid.latitudes()),
             columns = static_cast<std::size_t>(grid.longitudes);
  int const time = file.dimension(root, "time", NC_UNLIMITED), lat = file.dimension(root, "lat", rows),
            lon = file.dimension(root, "lon", columns);
  file.tell(root, NC_GLOBAL, "Conventions", "CF-1.10");
  file.tell(root, NC_GLOBAL, "title", title);
  file.tell(root, NC_GLOBAL, "source", "actio " ACTIO_VERSION ", vorticity_sphere");
  file.tell(root, NC_GLOBAL, "comment",
            "Ideal fluid on the unit sphere: lengths are in radii. The fields are the symbol of " +
                std::string(symbol == Symbol::berezin ? "Berezin" : "Weyl") +
                " of matrices; the harmonics in the group spectral are those of the matrices.");
  std::string const units = units_of_time(time_unit), rate = per_time(time_unit);
  file.define(
      root, "time", NC_DOUBLE, {time}, {},
      units.find(" since ") == std::string::npos
          ? std::vector<std::pair<char const*, std::string>>{{"long_name", "time"},
                                                             {"units", units},
                                                             {"axis", "T"}}
          : std::vector<std::pair<char const*, std::string>>{
                {"standard_name", "time"}, {"units", units}, {"calendar", "standard"}, {"axis", "T"}});
  int const at_lat = file.define(root, "lat", NC_DOUBLE, {lat}, {},
                                 {{"standard_name", "latitude"}, {"units", "degrees_north"}, {"axis", "Y"}}),
            at_lon = file.define(root, "lon", NC_DOUBLE, {lon}, {},
                                 {{"standard_name", "longitude"}, {"units", "degrees_east"}, {"axis", "X"}});
  std::vector<int> const place{time, lat, lon};
  std::vector<std::size_t> const field{1, rows, columns};
  file.define(root, "vorticity", NC_DOUBLE, place, field,
              {{"long_name", "vorticity relative to the sphere"}, {"units", rate}});
  file.define(root, "streamfunction", NC_DOUBLE, place, field,
              {{"long_name", "stream function, whose Laplacian is the vorticity"}, {"units", rate}});
  file.define(root, "u", NC_DOUBLE, place, field,
              {{"long_name", "velocity towards the east"}, {"units", rate}});
  file.define(root, "v", NC_DOUBLE, place, field,
              {{"long_name", "velocity towards the north"}, {"units", rate}});

  int const spectral = file.define_group("spectral");
  std::vector<int> l, m;
  for (int i = 1; i < degrees; ++i)
    for (int j = 0; j <= i; ++j) l.push_back(i), m.push_back(j);
  int const coefficient = file.dimension(spectral, "coefficient", l.size());
  int const at_l = file.define(spectral, "degree", NC_INT, {coefficient}, {},
                               {{"long_name", "degree l"}, {"units", "1"}}),
            at_m = file.define(spectral, "order", NC_INT, {coefficient}, {},
                               {{"long_name", "order m"}, {"units", "1"}});
  for (auto const& [name, part] : {std::pair("vorticity_real", "real"), {"vorticity_imaginary", "imaginary"}})
    file.define(
        spectral, name, NC_DOUBLE, {time, coefficient}, {1, l.size()},
        {{"long_name", std::string(part) +
                           " part of the coefficient of the orthonormal complex harmonic with "
                           "the Condon-Shortley phase; that of order -m is (-1)^m times the conjugate"},
         {"units", rate}});
  file.end_definitions();
  std::vector<double> latitudes, longitudes;
  for (int j = 0; j < grid.latitudes(); ++j) latitudes.push_back(grid.latitude(j) / degree);
  for (int k = 0; k < grid.longitudes; ++k) longitudes.push_back(360.0 * k / grid.longitudes);
  file.put(root, at_lat, latitudes), file.put(root, at_lon, longitudes);
  file.put(spectral, at_l, l), file.put(spectral, at_m, m);
  file.close();
}

void FieldsFile::add(std::string const& path, long number, double time, FlowFields const& fields,
                     SphereHarmonics const& harmonics) const {
  File file(path);
  file.open();
  std::vector<std::size_t> const extent{static_cast<std::size_t>(fields.vorticity.rows()),
                                        static_cast<std::size_t>(fields.vorticity.cols())};
  for (auto const& [name, field] : {std::pair("vorticity", &fields.vorticity),
                                    {"streamfunction", &fields.streamfunction},
                                    {"u", &fields.east},
                                    {"v", &fields.north}})
    file.put(file.root(), name, number, extent, field->data());
  std::vector<double> real, imaginary;
  for (int l = 1; l < harmonics.degrees(); ++l)
    for (int m = 0; m <= l; ++m)
      real.push_back(harmonics(l, m).real()), imaginary.push_back(m == 0 ? 0 : harmonics(l, m).imag());
  int const spectral = file.group("spectral");
  file.put(spectral, "vorticity_real", number, {real.size()}, real.data());
  file.put(spectral, "vorticity_imaginary", number, {imaginary.size()}, imaginary.data());
  file.put(file.root(), "time", number, {}, &time);
  file.close();
}

}  // namespace actio::scene
