#include "program/medium_output/playing.hpp"

#include <cmath>

#include "program/medium_output/grid.hpp"
#include "program/registry/units.hpp"

namespace actio::scene {
namespace {

/// The cells as they are drawn: those of a line are a band.
template <int d>
DrawnMesh drawn_mesh(MediumCells<d> const& cells) {
  GridPoints<d> grid(cells);
  std::vector<PlayedMedium::Point> points;
  std::vector<int> nodes;
  for (std::size_t k = 0; k < grid.size(); ++k) {
    auto const [node, wrap] = grid[k];
    PlayedMedium::Point point{};
    auto const X = cells.reference(node);
    for (std::size_t a = 0; a < d; ++a)
      point[a] = X[a] + (wrap >> a & 1 ? cells.period(static_cast<int>(a)) : 0);
    points.push_back(point), nodes.push_back(static_cast<int>(node));
  }
  std::vector<std::int64_t> at_corners(grid.corners());
  for (std::size_t k = 0; k < at_corners.size(); ++k) at_corners[k] = grid.corner(k);
  if (d > 1) {
    DrawnMesh out = DrawnMesh::of(cells.dimension(), std::move(points), std::move(nodes), at_corners,
                                  static_cast<std::size_t>(media::corner_count(cells.shape())));
    out.dimension = d;
    return out;
  }
  auto const [first, last] = std::minmax_element(points.begin(), points.end(),
                                                 [](auto const& a, auto const& b) { return a[0] < b[0]; });
  double const height = 0.08 * ((*last)[0] - (*first)[0]);
  auto const above = static_cast<std::int64_t>(points.size());
  for (std::size_t k = 0; k < static_cast<std::size_t>(above); ++k) {
    points.push_back({points[k][0], height, 0});
    nodes.push_back(nodes[k] + static_cast<int>(cells.nodes()));
  }
  std::vector<std::int64_t> corners;
  for (std::size_t k = 0; k < at_corners.size(); k += 2) {
    std::int64_t const a = at_corners[k], b = at_corners[k + 1];
    corners.insert(corners.end(), {a, b, b + above, a + above});
  }
  return DrawnMesh::of(2, std::move(points), std::move(nodes), corners, 4);
}

/// The fields that colours show, those of cells first: the numbers.
template <int d>
MediumFields<d> shown_fields() {
  MediumFields<d> out;
  for (auto const& field : medium_fields<d>())
    if (field.components.empty()) out.push_back(field);
  return out;
}

/// One frame more.
template <int d>
void add_frame(PlayedMedium& played, MediumView<d> const& medium, DrawnMesh const& mesh,
               MediumFrame<d> const& frame) {
  MediumCells<d> const& cells = medium.motion->cells();
  auto& places = played.places.emplace_back();
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    // A point is as far from its node as in the reference space: periods beyond, or above a line.
    std::size_t const node = static_cast<std::size_t>(mesh.nodes[k]) % cells.nodes();
    PlayedMedium::Point place = mesh.points[k];
    auto const X = cells.reference(node);
    for (std::size_t a = 0; a < d; ++a) place[a] += frame.places[node][a] - X[a];
    places.push_back(place);
  }
  auto const shown = shown_fields<d>();
  auto const fields = mean_fields(medium, frame.places, frame.multipliers, shown, false);
  std::size_t const size = shown.size();
  for (std::size_t i = 0; i < size; ++i) {
    auto& values = played.fields[i].values.emplace_back();
    for (auto const& face : mesh.faces) {
      double const value = fields[face.cell * size + i];
      values.push_back(std::isfinite(value) ? value : 0);
    }
  }
  auto& speeds = played.fields[size].values.emplace_back();
  int const corners = media::corner_count(cells.shape());
  for (auto const& face : mesh.faces) {
    auto const cell = cells.cell(face.cell);
    double sum = 0;
    for (std::size_t a = 0; a < d; ++a) {
      double mean = 0;
      for (std::size_t b = 0; b < static_cast<std::size_t>(corners); ++b)
        mean += frame.velocities[static_cast<std::size_t>(cell.nodes[b])][a] / corners;
      sum += mean * mean;
    }
    speeds.push_back(std::sqrt(sum));
  }
}

}  // namespace

template <int d>
std::shared_ptr<PlayedMedium const> play_medium(MediumView<d> const& medium, std::span<double const> times,
                                                std::function<MediumFrame<d>(std::size_t)> const& read) {
  if (times.empty()) return nullptr;
  auto played = std::make_shared<PlayedMedium>();
  DrawnMesh mesh = drawn_mesh<d>(medium.motion->cells());
  played->dimension = d == 3 ? 3 : 2, played->snapshots = times.size(), played->cells = mesh.faces.size();
  for (auto const& field : shown_fields<d>()) played->fields.push_back({words(field.name), {}});
  played->fields.push_back({"speed", {}});
  PlayedSize const size =
      PlayedSize::of(times.size(), mesh.faces.size(), played->dimension, played->fields.size());
  mesh = mesh.coarsened(size.faces);
  for (auto const& face : mesh.faces) played->faces.push_back(face.points);
  played->outline = mesh.outline;
  for (std::size_t k = 0; k < size.frames; ++k) {
    // The first, the last, and others as evenly between them as they are.
    std::size_t const number =
        size.frames > 1 ? (k * (times.size() - 1) + (size.frames - 1) / 2) / (size.frames - 1) : 0;
    MediumFrame<d> const frame = read(number);
    played->times.push_back(times[number]);
    add_frame(*played, medium, mesh, frame);
  }
  return played;
}

/// Along a line.
template std::shared_ptr<PlayedMedium const> play_medium(
    MediumView<1> const& medium, std::span<double const> times,
    std::function<MediumFrame<1>(std::size_t)> const& read);
/// In the plane.
template std::shared_ptr<PlayedMedium const> play_medium(
    MediumView<2> const& medium, std::span<double const> times,
    std::function<MediumFrame<2>(std::size_t)> const& read);
/// In space.
template std::shared_ptr<PlayedMedium const> play_medium(
    MediumView<3> const& medium, std::span<double const> times,
    std::function<MediumFrame<3>(std::size_t)> const& read);

}  // namespace actio::scene
