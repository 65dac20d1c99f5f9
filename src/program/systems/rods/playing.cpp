#include "program/systems/rods/playing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace actio::scene {
namespace {

constexpr int sides = 10, of_cap = (sides - 2) / 2;  // faces around an element, and over an end
char const* const names[] = {"bend", "twist", "stretch", "speed"};

/// The sections at which the tube is drawn.
std::vector<std::size_t> drawn_sections(rods::RodShape const& rest, std::size_t most_faces) {
  std::size_t const elements = rest.elements(),
                    parts = std::clamp<std::size_t>(most_faces / sides - 1, 1, elements);
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k <= parts; ++k) out.push_back(k * elements / parts % rest.sections());
  return out;
}

/// One frame more.
void add_frame(PlayedMedium& played, DrawnRod const& rod,
               std::vector<rods::ElementAtRest<double>> const& at_rest, double radius,
               std::vector<std::size_t> const& drawn, RodPosture const& posture) {
  auto& places = played.places.emplace_back();
  for (std::size_t const k : drawn)
    for (int side = 0; side < sides; ++side) {
      double const angle = 2 * std::numbers::pi * side / sides;
      places.push_back(
          rods::plus_times(posture.places[k], radius,
                           rods::turned(posture.attitudes[k], {0, std::cos(angle), std::sin(angle)})));
    }
  rods::RodShape const shape{posture.places, posture.attitudes, rod.rest.closed};
  std::vector<double>* values[4];
  for (std::size_t i = 0; i < 4; ++i) values[i] = &played.fields[i].values.emplace_back();
  for (std::size_t k = 0; k + 1 < drawn.size(); ++k) {
    std::size_t const element = drawn[k];
    auto const [Gamma, kappa] = rods::element_strain(shape.element(element), at_rest[element]);
    auto const& v = posture.velocities[element];
    double const here[] = {std::hypot(kappa[1], kappa[2]), kappa[0], Gamma[0], std::hypot(v[0], v[1], v[2])};
    for (std::size_t i = 0; i < 4; ++i)
      values[i]->insert(values[i]->end(), sides, std::isfinite(here[i]) ? here[i] : 0);
  }
  if (rod.rest.closed) return;
  for (auto* const one : values) {
    double const first = one->front(), last = one->back();
    one->insert(one->end(), of_cap, first), one->insert(one->end(), of_cap, last);
  }
}

}  // namespace

std::shared_ptr<PlayedMedium const> play_rod(DrawnRod const& rod, std::span<double const> times,
                                             std::function<RodPosture(std::size_t)> const& read) {
  if (times.empty()) return nullptr;
  auto played = std::make_shared<PlayedMedium>();
  played->dimension = 3, played->snapshots = times.size();
  for (char const* const name : names) played->fields.push_back({name, {}});
  played->cells = rod.rest.elements() * sides;
  PlayedSize const size = PlayedSize::of(times.size(), played->cells, 3, played->fields.size());
  auto const drawn = drawn_sections(rod.rest, size.faces);
  for (int k = 0; k + 1 < static_cast<int>(drawn.size()); ++k)
    for (int side = 0; side < sides; ++side) {
      int const here = k * sides, next = side + 1 < sides ? side + 1 : 0;
      played->faces.push_back({here + side, here + next, here + sides + next, here + sides + side});
      if (side == 0) played->outline.push_back({here, here + sides});
    }
  if (!rod.rest.closed)
    for (int const at : {0, static_cast<int>(drawn.size() - 1) * sides})
      for (int k = 1; k + 2 < sides; k += 2) {
        std::array<int, 4> face{at, at + k, at + k + 1, at + k + 2};
        if (at == 0) std::reverse(face.begin(), face.end());
        played->faces.push_back(face);
      }
  auto const at_rest = rods::elements_at_rest(rod.rest);
  auto const& [along, across, other] = rod.section.inertia;
  double const radius = std::clamp(2 * std::sqrt(std::min(across, other) / rod.section.mass),
                                   rod.length / 250, rod.length / 40);
  for (std::size_t k = 0; k < size.frames; ++k) {
    // The first, the last, and others as evenly between them as they are.
    std::size_t const number =
        size.frames > 1 ? (k * (times.size() - 1) + (size.frames - 1) / 2) / (size.frames - 1) : 0;
    played->times.push_back(times[number]);
    add_frame(*played, rod, at_rest, radius, drawn, read(number));
  }
  return played;
}

}  // namespace actio::scene
