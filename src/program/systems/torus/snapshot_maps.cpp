// Maps of the snapshots of a run on the torus.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "book/png.hpp"
#include "book/sphere_map.hpp"
#include "book/svg.hpp"
#include "program/registry/scene.hpp"
#include "program/registry/units.hpp"
#include "program/systems/torus/input.hpp"
#include "program/systems/torus/snapshots.hpp"

namespace actio::scene {
namespace {

constexpr long most_flat_maps = 6, most_flat_pictures = 100;

/// Snapshots as values on a grid.
struct FlatMaps {
  std::vector<double> times;
  std::vector<torus::GridValues> fields;
  double largest = 0;  // modulus, the strongest colour
  long of = 0;         // so many snapshots are there
};

/// Of no more than so many snapshots, from the first to the last that is there; on at least so many points
/// that a cubic between them shows no grid.
FlatMaps flat_maps_of(Scene const& scene, std::string const& folder, long most) {
  FlatMaps maps;
  if (!scene.snapshots) return maps;
  std::error_code none;
  auto const file = [&folder](long number) { return folder + "/" + snapshot_file(number, ".harmonics.csv"); };
  while (maps.of < scene.snapshots->rows() && std::filesystem::exists(file(maps.of), none)) ++maps.of;
  int const n = torus_keys.N.read(scene.file), points = std::max(n, 128);
  long const count = std::min(maps.of, most);
  for (long k = 0; k < count; ++k) {
    long const number = count == 1 ? 0 : (k * (maps.of - 1) + (count - 1) / 2) / (count - 1);
    maps.times.push_back(scene.snapshots->time(number));
    maps.fields.push_back(torus::values_on_grid(read_torus_harmonics_file(file(number), n), points));
    maps.largest = std::max(maps.largest, maps.fields.back().cwiseAbs().maxCoeff());
  }
  return maps;
}
/// Row by row from the least y on.
std::vector<double> rows_of(torus::GridValues const& field) {
  torus::GridValues const turned = field.transpose();
  return {turned.data(), turned.data() + turned.size()};
}

}  // namespace

std::string torus_maps_json(Scene const& scene, std::string const& folder) {
  FlatMaps const maps = flat_maps_of(scene, folder, most_flat_pictures);
  if (maps.times.size() < 2) return "null";
  std::string times, pictures;
  double const scale = maps.largest > 0 ? 127 / maps.largest : 0;
  for (std::size_t k = 0; k < maps.times.size(); ++k) {
    auto const side = static_cast<int>(maps.fields[k].rows());
    std::vector<unsigned char> cells;
    for (double const value : rows_of(maps.fields[k]))
      cells.push_back(static_cast<unsigned char>(127 + std::lround(scale * value)));
    times += fmt::format("{}{}", k ? "," : "", maps.times[k]);
    pictures += fmt::format("{}\"{}\"", k ? ",\n" : "", book::base64(book::grey_png(side, side, cells)));
  }
  return fmt::format("{{\"flat\":true,\"times\":[{}],\"largest\":{},\"of\":{},\"pictures\":[{}]}}", times,
                     maps.largest, maps.of, pictures);
}

std::string torus_map(Scene const& scene, std::string const& folder, double width) {
  FlatMaps const maps = flat_maps_of(scene, folder, most_flat_maps);
  if (maps.times.empty()) return "";
  // Up to three maps beside one another, each with its time above it; the scale of colours below.
  std::size_t const beside = std::min<std::size_t>(maps.times.size(), maps.times.size() == 4 ? 2 : 3);
  double const gap = 16,
               side = std::min(
                   360.0, (width - (static_cast<double>(beside) + 1) * gap) / static_cast<double>(beside)),
               line = side + 34;
  std::string const unit = time_unit(scene);
  std::string elements;
  for (std::size_t k = 0; k < maps.times.size(); ++k) {
    double const x = gap + static_cast<double>(k % beside) * (side + gap),
                 y = static_cast<double>(k / beside) * line;
    elements += book::svg::label({x, y + 14},
                                 fmt::format("t = {:.6g}", maps.times[k]) + (unit.empty() ? "" : " " + unit));
    elements += book::flat_map({x, y + 20}, side, rows_of(maps.fields[k]), maps.largest);
  }
  double const below = std::ceil(static_cast<double>(maps.times.size()) / static_cast<double>(beside)) * line;
  elements += book::colour_bar({width / 2 - 130, below}, 260, maps.largest, "vorticity");
  return book::svg::picture(width, below + 34, elements);
}

}  // namespace actio::scene
