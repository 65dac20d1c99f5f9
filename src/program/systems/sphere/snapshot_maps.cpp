#include "program/systems/sphere/snapshot_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "actio/sphere_fields/sphere_transform.hpp"
#include "actio/sphere_fields/symbols.hpp"
#include "book/png.hpp"
#include "book/sphere_map.hpp"
#include "book/svg.hpp"
#include "program/registry/units.hpp"
#include "program/systems/sphere/input.hpp"
#include "program/systems/sphere/snapshots.hpp"

namespace actio::scene {
namespace {

constexpr int most_maps = 6, most_pictures = 100;

/// Snapshots as values on a grid of equal angles.
struct Maps {
  std::vector<double> times;
  std::vector<sphere::GridField> fields;
  double largest = 0;  // modulus, the strongest colour
  long of = 0;         // so many snapshots are there
};

/// Parallels that tell a field of the degrees below n, with a quarter to spare; less of a large one, whose
/// finest scales are filaments narrower than a pixel.
int rows_for(int n) { return std::clamp(5 * n / 4, 90, 256) / 2 * 2; }

/// Of no more than so many snapshots, from the first to the last that is there.
Maps maps_of(Scene const& scene, std::string const& folder, long most) {
  Maps maps;
  if (!scene.snapshots) return maps;
  std::error_code none;
  auto const file = [&folder](long number) { return folder + "/" + snapshot_file(number, ".harmonics.csv"); };
  while (maps.of < scene.snapshots->rows() && std::filesystem::exists(file(maps.of), none)) ++maps.of;
  if (maps.of == 0) return maps;
  int const n = sphere_keys.N.read(scene.file), rows = rows_for(n);
  sphere::Symbol const symbol =
      symbol_keys.symbol.find(scene.file) == "weyl" ? sphere::Symbol::weyl : sphere::Symbol::berezin;
  sphere::SphereGrid const grid = sphere::SphereGrid::uniform(rows, 2 * rows);
  long const count = std::min(maps.of, most);
  for (long k = 0; k < count; ++k) {
    long const number = count == 1 ? 0 : (k * (maps.of - 1) + (count - 1) / 2) / (count - 1);
    maps.times.push_back(scene.snapshots->time(number));
    maps.fields.push_back(
        sphere::values_on(grid, sphere::symbol_of(read_harmonics_file(file(number), n), symbol)));
    maps.largest = std::max(maps.largest, maps.fields.back().cwiseAbs().maxCoeff());
  }
  return maps;
}
/// Shades of grey, of which 127 is zero.
std::string as_grey(sphere::GridField const& field, double largest) {
  double const scale = largest > 0 ? 127 / largest : 0;
  std::vector<unsigned char> cells;
  for (Eigen::Index i = 0; i < field.rows(); ++i)
    for (Eigen::Index j = 0; j < field.cols(); ++j)
      cells.push_back(static_cast<unsigned char>(127 + std::lround(scale * field(i, j))));
  return book::grey_png(static_cast<int>(field.cols()), static_cast<int>(field.rows()), cells);
}
book::SphereField smooth(sphere::GridField const& field) {
  return {static_cast<int>(field.rows()), static_cast<int>(field.cols()),
          std::vector<double>(field.data(), field.data() + field.size())};
}

}  // namespace

std::string vorticity_maps_json(Scene const& scene, std::string const& folder) {
  Maps const maps = maps_of(scene, folder, most_pictures);
  if (maps.times.size() < 2) return "null";
  std::string times, pictures;
  for (std::size_t k = 0; k < maps.times.size(); ++k) {
    times += fmt::format("{}{}", k ? "," : "", maps.times[k]);
    pictures += fmt::format("{}\"{}\"", k ? ",\n" : "", book::base64(as_grey(maps.fields[k], maps.largest)));
  }
  return fmt::format("{{\"times\":[{}],\"largest\":{},\"of\":{},\"pictures\":[{}]}}", times, maps.largest,
                     maps.of, pictures);
}

std::string vorticity_map(Scene const& scene, std::string const& folder, double width) {
  Maps const maps = maps_of(scene, folder, most_maps);
  if (maps.times.empty()) return "";
  // Two maps beside one another, each with its time above it; the scale of colours below.
  bool const two = maps.times.size() > 1;
  double const gap = 16, map = two ? (width - 3 * gap) / 2 : width - 2 * gap, height = map / 2,
               line = height + 34;
  std::string const unit = time_unit(scene);
  std::string elements;
  for (std::size_t k = 0; k < maps.times.size(); ++k) {
    double const x = gap + static_cast<double>(k % 2) * (map + gap), y = static_cast<double>(k / 2) * line;
    elements += book::svg::label({x, y + 14},
                                 fmt::format("t = {:.6g}", maps.times[k]) + (unit.empty() ? "" : " " + unit));
    elements +=
        book::whole_sphere({x + map / 2, y + 20 + height / 2}, map, smooth(maps.fields[k]), maps.largest);
  }
  double const below = std::ceil(static_cast<double>(maps.times.size()) / 2) * line;
  elements += book::colour_bar({width / 2 - 130, below}, 260, maps.largest, "vorticity");
  return book::svg::picture(width, below + 34, elements);
}

}  // namespace actio::scene
