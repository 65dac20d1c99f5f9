#include "program/systems/sphere/snapshot_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "actio/sphere_fields/sphere_transform.hpp"
#include "actio/sphere_fields/symbols.hpp"
#include "book/plot.hpp"
#include "book/png.hpp"
#include "book/svg.hpp"
#include "program/registry/units.hpp"
#include "program/systems/sphere/input.hpp"
#include "program/systems/sphere/snapshots.hpp"

namespace actio::scene {
namespace {

constexpr int most_maps = 6, most_pictures = 100;

/// From blue for the most negative over nearly white to red; the middle of the palette is zero.
std::vector<book::Colour> palette() {
  constexpr double blue[] = {24, 80, 150}, none[] = {244, 244, 240}, red[] = {176, 48, 24};
  std::vector<book::Colour> out;
  for (int i = -127; i <= 127; ++i) {
    double const part = std::pow(std::abs(i) / 127.0, 0.75);
    book::Colour colour;
    for (std::size_t k = 0; k < 3; ++k)
      colour[k] =
          static_cast<unsigned char>(std::lround(none[k] + part * ((i < 0 ? blue : red)[k] - none[k])));
    out.push_back(colour);
  }
  return out;
}
std::string image(double x, double y, double width, double height, std::string const& png) {
  return fmt::format(
      "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
      "href=\"data:image/png;base64,{}\"/>\n",
      x, y, width, height, book::base64(png));
}
/// Snapshots as pictures of coloured cells.
struct Maps {
  std::vector<double> times;
  std::vector<std::string> pictures;  // PNG
  double largest = 0;                 // modulus, the strongest colour
  long of = 0;                        // so many snapshots are there
};

/// Of no more than so many snapshots, from the first to the last that is there.
Maps maps_of(Scene const& scene, std::string const& folder, long most, int rows) {
  Maps maps;
  if (!scene.snapshots) return maps;
  std::error_code none;
  auto const file = [&folder](long number) { return folder + "/" + snapshot_file(number, ".harmonics.csv"); };
  while (maps.of < scene.snapshots->rows() && std::filesystem::exists(file(maps.of), none)) ++maps.of;
  if (maps.of == 0) return maps;
  int const n = sphere_keys.N.read(scene.file), columns = 2 * rows;
  sphere::Symbol const symbol =
      symbol_keys.symbol.find(scene.file) == "weyl" ? sphere::Symbol::weyl : sphere::Symbol::berezin;
  sphere::SphereGrid const grid = sphere::SphereGrid::uniform(rows, columns);
  std::vector<sphere::GridField> fields;
  long const count = std::min(maps.of, most);
  for (long k = 0; k < count; ++k) {
    long const number = count == 1 ? 0 : (k * (maps.of - 1) + (count - 1) / 2) / (count - 1);
    maps.times.push_back(scene.snapshots->time(number));
    fields.push_back(
        sphere::values_on(grid, sphere::symbol_of(read_harmonics_file(file(number), n), symbol)));
    maps.largest = std::max(maps.largest, fields.back().cwiseAbs().maxCoeff());
  }
  double const scale = maps.largest > 0 ? 127 / maps.largest : 0;
  for (auto const& field : fields) {
    std::vector<unsigned char> cells;
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < columns; ++j)
        cells.push_back(static_cast<unsigned char>(127 + std::lround(scale * field(i, j))));
    maps.pictures.push_back(book::png(columns, rows, cells, palette()));
  }
  return maps;
}

}  // namespace

std::string vorticity_maps_json(Scene const& scene, std::string const& folder) {
  Maps const maps = maps_of(scene, folder, most_pictures, 90);
  if (maps.times.size() < 2) return "null";
  std::string times, pictures;
  for (std::size_t k = 0; k < maps.times.size(); ++k) {
    times += fmt::format("{}{}", k ? "," : "", maps.times[k]);
    pictures += fmt::format("{}\"{}\"", k ? ",\n" : "", book::base64(maps.pictures[k]));
  }
  return fmt::format("{{\"times\":[{}],\"largest\":{},\"of\":{},\"pictures\":[{}]}}", times, maps.largest,
                     maps.of, pictures);
}

std::string vorticity_map(Scene const& scene, std::string const& folder, double width) {
  Maps const maps = maps_of(scene, folder, most_maps, 120);
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
    elements += image(x, y + 20, map, height, maps.pictures[k]);
  }
  double const below = std::ceil(static_cast<double>(maps.times.size()) / 2) * line;
  std::vector<unsigned char> scale;
  for (int i = 0; i < 255; ++i) scale.push_back(static_cast<unsigned char>(i));
  double const left = width / 2 - 130;
  elements += image(left, below, 260, 10, book::png(255, 1, scale, palette()));
  elements += book::svg::label({left, below + 24}, book::number(-maps.largest, 3), "middle");
  elements += book::svg::label({left + 130, below + 24}, "vorticity", "middle");
  elements += book::svg::label({left + 260, below + 24}, book::number(maps.largest, 3), "middle");
  return book::svg::picture(width, below + 34, elements);
}

}  // namespace actio::scene
