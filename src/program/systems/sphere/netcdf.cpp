// snapshots/fields.nc: what is in it.
#include <fmt/format.h>

#include <numbers>

#include "program/output/array_file.hpp"
#include "program/systems/sphere/snapshots.hpp"

namespace actio::scene {
namespace {

using Attributes = std::vector<ArrayAttribute>;

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
    return {{"standard_name", {"time"}},
            {"units", {word + " since 2000-01-01 00:00:00"}},
            {"calendar", {"standard"}},
            {"axis", {"T"}}};
  return {{"long_name", {unit.empty() ? "time in units of the scene" : "time in " + unit}}};
}

/// What changes with the time has the unit 1/time.
Attributes attributes_of_rate(std::string const& long_name, std::string const& unit) {
  if (!word_for_unit(unit).empty()) return {{"long_name", {long_name}}, {"units", {unit + "-1"}}};
  return {{"long_name", {unit.empty() ? long_name : long_name + ", in 1/" + unit}}};
}

/// The data sets: the time, what all times have in common, and what belongs to each.
std::vector<ArraySet> sets_of(FieldsFile const& file, sphere::SphereGrid const& grid,
                              std::size_t coefficients) {
  auto const parallels = static_cast<std::size_t>(grid.latitudes()),
             meridians = static_cast<std::size_t>(grid.longitudes);
  ArraySet::Axis const time{"time"}, lat{"lat", parallels}, lon{"lon", meridians},
      coefficient{"coefficient", coefficients};
  std::vector<ArraySet> out{
      {"time", {time}, {}, false, false, attributes_of_time(file.time_unit)},
      {"lat",
       {lat},
       {},
       false,
       false,
       {{"standard_name", {"latitude"}}, {"units", {"degrees_north"}}, {"axis", {"Y"}}}},
      {"lon",
       {lon},
       {},
       false,
       false,
       {{"standard_name", {"longitude"}}, {"units", {"degrees_east"}}, {"axis", {"X"}}}},
      {"spectral/degree", {coefficient}, {}, true, false, {{"long_name", {"degree l"}}, {"units", {"1"}}}},
      {"spectral/order", {coefficient}, {}, true, false, {{"long_name", {"order m"}}, {"units", {"1"}}}}};
  bool const layer = file.hamiltonian.layer(), averaged = file.hamiltonian.averaged();
  auto const add = [&](std::string const& name, std::vector<ArraySet::Axis> axes,
                       std::string const& meaning) {
    ArraySet& set = out.emplace_back(ArraySet{name, std::move(axes)});
    for (auto const& axis : set.axes) set.chunk.push_back(std::max<std::size_t>(1, axis.length));
    set.attributes = attributes_of_rate(meaning, file.time_unit);
  };
  add("vorticity", {time, lat, lon},
      std::string(layer      ? "potential vorticity"
                  : averaged ? "vorticity that is carried, the curl of the momentum,"
                             : "vorticity") +
          " relative to the sphere");
  add("streamfunction", {time, lat, lon},
      layer ? fmt::format("stream function, whose Laplacian is the potential vorticity and {} times the "
                          "stream function",
                          file.hamiltonian.gamma)
            : "stream function, whose Laplacian is the " + std::string(averaged ? "curl" : "vorticity"));
  add("u", {time, lat, lon}, "velocity towards the east");
  add("v", {time, lat, lon}, "velocity towards the north");
  if (!file.hamiltonian.euler())
    add("curl", {time, lat, lon},
        averaged ? fmt::format("curl of the velocity, which is averaged over {} radii of the sphere",
                               file.hamiltonian.length)
                 : "curl of the velocity");
  for (std::string const part : {"real", "imaginary"})
    add("spectral/vorticity_" + part, {time, coefficient},
        part +
            " part of the coefficient of the orthonormal complex harmonic with the Condon-Shortley phase; "
            "that of order -m is (-1)^m times the conjugate");
  return out;
}

}  // namespace

void FieldsFile::make(std::string const& path, sphere::SphereGrid const& grid, int degrees,
                      std::span<double const> times, std::function<Frame(long)> const& frame,
                      bool durable) const {
  std::vector<double> latitudes, longitudes, l_of, m_of;
  for (int j = 0; j < grid.latitudes(); ++j) latitudes.push_back(grid.latitude(j) / (std::numbers::pi / 180));
  for (int k = 0; k < grid.longitudes; ++k) longitudes.push_back(360.0 * k / grid.longitudes);
  for (int l = 1; l < degrees; ++l)
    for (int m = 0; m <= l; ++m) l_of.push_back(l), m_of.push_back(m);
  ArrayFile file(ArrayFile::Format::netcdf, path,
                 {{"Conventions", {"CF-1.10"}},
                  {"title", {title}},
                  {"source", {"actio " ACTIO_VERSION ", vorticity_sphere"}},
                  {"comment",
                   {"Ideal fluid on the unit sphere: lengths are in radii. The fields are the symbol of " +
                    std::string(symbol == sphere::Symbol::berezin ? "Berezin" : "Weyl") +
                    " of matrices; the harmonics in the group spectral are those of the matrices."}}},
                 sets_of(*this, grid, l_of.size()));
  std::size_t set = 1;
  for (auto const* numbers : {&latitudes, &longitudes, &l_of, &m_of}) file.put(set++, 0, *numbers);
  for (std::size_t k = 0; k < times.size(); ++k) {
    Frame const now = frame(static_cast<long>(k));
    std::size_t at = set;
    std::vector<sphere::GridField const*> fields{&now.fields.vorticity, &now.fields.streamfunction,
                                                 &now.fields.east, &now.fields.north};
    if (!hamiltonian.euler()) fields.push_back(&now.fields.curl);
    for (auto const* field : fields)
      file.put(at++, k, {field->data(), static_cast<std::size_t>(field->size())});
    std::vector<double> real, imaginary;
    for (int l = 1; l < degrees; ++l)
      for (int m = 0; m <= l; ++m)
        real.push_back(now.harmonics(l, m).real()),
            imaginary.push_back(m == 0 ? 0 : now.harmonics(l, m).imag());
    file.put(at++, k, real), file.put(at, k, imaginary), file.put(0, k, times.subspan(k, 1));
  }
  file.name(durable);
}

}  // namespace actio::scene
