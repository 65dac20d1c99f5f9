#include "program/systems/sphere/flow_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "book/png.hpp"
#include "book/sphere_map.hpp"
#include "book/svg.hpp"
#include "program/registry/units.hpp"

namespace actio::scene {
namespace {

/// Snapshots as values on a grid.
struct Shown {
  std::vector<double> times;
  std::vector<FlowMaps::Values> fields;
  double largest = 0;  // modulus, the strongest colour
  long of = 0;         // so many snapshots are there
};

/// Of no more than so many snapshots, from the first to the last that is there.
Shown shown_of(FlowMaps const& maps, Scene const& scene, std::string const& folder, long most) {
  Shown shown;
  if (!scene.snapshots) return shown;
  std::error_code none;
  auto const file = [&folder](long number) { return folder + "/" + snapshot_file(number, ".harmonics.csv"); };
  while (shown.of < scene.snapshots->rows() && std::filesystem::exists(file(shown.of), none)) ++shown.of;
  long const count = std::min(shown.of, most);
  for (long k = 0; k < count; ++k) {
    long const number = count == 1 ? 0 : (k * (shown.of - 1) + (count - 1) / 2) / (count - 1);
    shown.times.push_back(scene.snapshots->time(number));
    for (double const value : shown.fields.emplace_back(maps.values(file(number))).values)
      shown.largest = std::max(shown.largest, std::abs(value));
  }
  return shown;
}
/// Shades of grey, of which 127 is zero.
std::string as_grey(FlowMaps::Values const& field, double largest) {
  double const scale = largest > 0 ? 127 / largest : 0;
  std::vector<unsigned char> cells;
  for (double const value : field.values)
    cells.push_back(static_cast<unsigned char>(127 + std::lround(scale * value)));
  return book::grey_png(field.columns, field.rows, cells);
}

}  // namespace

std::string FlowMaps::json(Scene const& scene, std::string const& folder) const {
  Shown const shown = shown_of(*this, scene, folder, 100);
  if (shown.times.size() < 2) return "null";
  std::string times, pictures;
  for (std::size_t k = 0; k < shown.times.size(); ++k) {
    times += fmt::format("{}{}", k ? "," : "", shown.times[k]);
    pictures +=
        fmt::format("{}\"{}\"", k ? ",\n" : "", book::base64(as_grey(shown.fields[k], shown.largest)));
  }
  return fmt::format("{{{}\"times\":[{}],\"largest\":{},\"of\":{},\"pictures\":[{}]}}",
                     flat ? "\"flat\":true," : "", times, shown.largest, shown.of, pictures);
}

std::string FlowMaps::picture(Scene const& scene, std::string const& folder, double width) const {
  Shown const shown = shown_of(*this, scene, folder, 6);
  std::size_t const count = shown.times.size();
  if (count == 0) return "";
  // Up to two spheres, or three squares, beside one another.
  std::size_t const beside = std::min<std::size_t>(count, flat && count != 4 ? 3 : 2);
  auto const across = static_cast<double>(beside);
  double const gap = 16, room = (width - (across + 1) * gap) / across,
               map = flat ? std::min(360.0, room) : room, height = flat ? map : map / 2, line = height + 34;
  std::string const unit = time_unit(scene);
  std::string elements;
  for (std::size_t k = 0; k < count; ++k) {
    auto const& [rows, columns, field] = shown.fields[k];
    double const x = gap + static_cast<double>(k % beside) * (map + gap),
                 y = static_cast<double>(k / beside) * line;
    elements += book::svg::label(
        {x, y + 14}, fmt::format("t = {:.6g}", shown.times[k]) + (unit.empty() ? "" : " " + unit));
    elements += flat ? book::flat_map({x, y + 20}, map, field, shown.largest)
                     : book::whole_sphere({x + map / 2, y + 20 + height / 2}, map,
                                          book::SphereField(rows, columns, field), shown.largest);
  }
  double const below = std::ceil(static_cast<double>(count) / across) * line;
  elements += book::colour_bar({width / 2 - 130, below}, 260, shown.largest, "vorticity");
  return book::svg::picture(width, below + 34, elements);
}

}  // namespace actio::scene
