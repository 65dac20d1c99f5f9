// snapshots/fields.nc, as a file that nobody else looks at: what readers see is renamed into its place.
#include <fmt/format.h>

#include <numbers>

#include "program/output/netcdf_library.hpp"
#include "program/systems/sphere/snapshots.hpp"

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

using Attributes = std::vector<std::pair<char const*, std::string>>;

/// The word that the conventions have for a unit of time; empty where they have none.
std::string word_for_unit(std::string const& unit) {
  for (auto const& [name, word] :
       {std::pair("s", "seconds"), {"min", "minutes"}, {"h", "hours"}, {"d", "days"}})
    if (unit == name) return word;
  return "";
}

/// Times have dates where their unit is known. Otherwise they are numbers without `units`, as the conventions
/// allow for what has no dimension, and no time axis in their sense: any unit there would be a wrong one, and
/// readers complain of "1".
Attributes attributes_of_time(std::string const& unit) {
  if (std::string const word = word_for_unit(unit); !word.empty())
    return {{"standard_name", "time"},
            {"units", word + " since 2000-01-01 00:00:00"},
            {"calendar", "standard"},
            {"axis", "T"}};
  return {{"long_name", unit.empty() ? "time in units of the scene" : "time in " + unit}};
}

/// What changes with the time has the unit 1/time.
Attributes attributes_of_rate(std::string const& long_name, std::string const& unit) {
  if (!word_for_unit(unit).empty()) return {{"long_name", long_name}, {"units", unit + "-1"}};
  return {{"long_name", unit.empty() ? long_name : long_name + ", in 1/" + unit}};
}

constexpr double degree = std::numbers::pi / 180;

/// Parallels and meridians, defined and to be filled.
class Places {
 public:
  Places(File const& file, sphere::SphereGrid const& grid)
      : file_(file),
        grid_(grid),
        lat_(file.dimension(file.root(), "lat", static_cast<std::size_t>(grid.latitudes()))),
        lon_(file.dimension(file.root(), "lon", static_cast<std::size_t>(grid.longitudes))),
        at_lat_(file.define(file.root(), "lat", NC_DOUBLE, {lat_}, {},
                            {{"standard_name", "latitude"}, {"units", "degrees_north"}, {"axis", "Y"}})),
        at_lon_(file.define(file.root(), "lon", NC_DOUBLE, {lon_}, {},
                            {{"standard_name", "longitude"}, {"units", "degrees_east"}, {"axis", "X"}})) {}

  /// A field over them, for each time.
  void define_field(int time, char const* name, Attributes const& attributes) const {
    file_.define(file_.root(), name, NC_DOUBLE, {time, lat_, lon_},
                 {1, static_cast<std::size_t>(grid_.latitudes()), static_cast<std::size_t>(grid_.longitudes)},
                 attributes);
  }
  void fill() const {
    std::vector<double> latitudes, longitudes;
    for (int j = 0; j < grid_.latitudes(); ++j) latitudes.push_back(grid_.latitude(j) / degree);
    for (int k = 0; k < grid_.longitudes; ++k) longitudes.push_back(360.0 * k / grid_.longitudes);
    file_.put(file_.root(), at_lat_, latitudes), file_.put(file_.root(), at_lon_, longitudes);
  }

 private:
  File const& file_;
  sphere::SphereGrid const& grid_;
  int lat_, lon_, at_lat_, at_lon_;
};

/// The group of the coefficients, defined and to be filled.
class Coefficients {
 public:
  Coefficients(File const& file, int degrees, int time, std::string const& unit)
      : file_(file), group_(file.define_group("spectral")) {
    for (int l = 1; l < degrees; ++l)
      for (int m = 0; m <= l; ++m) l_.push_back(l), m_.push_back(m);
    int const coefficient = file.dimension(group_, "coefficient", l_.size());
    at_l_ =
        file.define(group_, "degree", NC_INT, {coefficient}, {}, {{"long_name", "degree l"}, {"units", "1"}});
    at_m_ =
        file.define(group_, "order", NC_INT, {coefficient}, {}, {{"long_name", "order m"}, {"units", "1"}});
    for (auto const& [name, part] :
         {std::pair("vorticity_real", "real"), {"vorticity_imaginary", "imaginary"}})
      file.define(
          group_, name, NC_DOUBLE, {time, coefficient}, {1, l_.size()},
          attributes_of_rate(std::string(part) + " part of the coefficient of the orthonormal complex "
                                                 "harmonic with the Condon-Shortley phase; that of order "
                                                 "-m is (-1)^m times the conjugate",
                             unit));
  }
  void fill() const { file_.put(group_, at_l_, l_), file_.put(group_, at_m_, m_); }

 private:
  File const& file_;
  int group_, at_l_ = 0, at_m_ = 0;
  std::vector<int> l_, m_;
};

}  // namespace

void FieldsFile::create(std::string const& path, sphere::SphereGrid const& grid, int degrees) const {
  File file(path);
  file.create();
  int const root = file.root(), time = file.dimension(root, "time", NC_UNLIMITED);
  bool const layer = hamiltonian.layer();
  file.tell(root, NC_GLOBAL, "Conventions", "CF-1.10");
  file.tell(root, NC_GLOBAL, "title", title);
  file.tell(root, NC_GLOBAL, "source", "actio " ACTIO_VERSION ", vorticity_sphere");
  file.tell(root, NC_GLOBAL, "comment",
            "Ideal fluid on the unit sphere: lengths are in radii. The fields are the symbol of " +
                std::string(symbol == sphere::Symbol::berezin ? "Berezin" : "Weyl") +
                " of matrices; the harmonics in the group spectral are those of the matrices.");
  file.define(root, "time", NC_DOUBLE, {time}, {}, attributes_of_time(time_unit));
  Places const places(file, grid);
  std::string const vorticity = layer ? "potential vorticity" : "vorticity";
  for (auto const& [name, meaning] :
       {std::pair<char const*, std::string>("vorticity", vorticity + " relative to the sphere"),
        {"streamfunction",
         "stream function, whose Laplacian is the vorticity" +
             (layer ? fmt::format(": the potential one and {} times the stream function", hamiltonian.gamma)
                    : "")},
        {"u", "velocity towards the east"},
        {"v", "velocity towards the north"}})
    places.define_field(time, name, attributes_of_rate(meaning, time_unit));
  Coefficients const coefficients(file, degrees, time, time_unit);
  file.end_definitions();
  places.fill(), coefficients.fill();
  file.close();
}

void FieldsFile::add(std::string const& path, long number, double time, sphere::FlowFields const& fields,
                     sphere::SphereHarmonics const& harmonics) const {
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
