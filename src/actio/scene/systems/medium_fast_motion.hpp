// The motion of a medium on the fast road, for one kind of medium.
#pragma once

#include <span>
#include <thread>

#include "actio/multisymplectic/fast_medium_2d.hpp"
#include "actio/scene/systems/medium_fast_road.hpp"
#include "actio/scene/systems/medium_laws.hpp"

namespace actio::scene {

/// A medium on a box in the plane.
template <class Medium>
class FastMotion final : public MediumMotion<2> {
 public:
  /// From the start.
  FastMotion(Medium const& medium, FastBox2d const& box, double density, double step, MediumStart& start)
      : cells_(box),
        density_(density),
        medium_(medium, box, step, density, at(start.placement), at(start.velocity), options(box)) {}

  void advance(long count) override { medium_.step(count); }
  void remember(CheckpointStream& stream) override {
    auto state = medium_.state();
    std::span<Place> places(state.places), velocities(state.velocities);
    stream(state.steps, places, velocities);
    if (stream.reading()) medium_.go_on_from(state);
  }
  long steps() const override { return medium_.steps(); }
  MediumCells<2> const& cells() const override { return cells_; }
  std::vector<Place> places() const override { return medium_.places(); }
  std::vector<Place> velocities() const override { return medium_.velocities(); }
  double mass(std::size_t node) const override {
    FastBox2d const& box = cells_.box();
    auto const n = static_cast<std::size_t>(box.nodes(0));
    return density_ * box.measure() * box.share(0, static_cast<int>(node % n)) *
           box.share(1, static_cast<int>(node / n));
  }
  BodyEnergies energies() const override {
    auto const [kinetic, stored] = medium_.energies();
    return {kinetic, stored, 0};
  }

 private:
  static auto at(PlaceFormula& formula) {
    return [&formula](Place const& X) {
      Place out;
      formula(X, out.data());
      return out;
    };
  }
  /// Whatever the number of threads, bits are the same: a large body takes those that there are.
  static FastOptions options(FastBox2d const& box) {
    FastOptions out;
    if (box.count() > 100000)
      out.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    return out;
  }

  BoxCells cells_;
  double density_;
  FastMedium2d<Medium> medium_;
};

/// A medium of the fast road with its box.
template <class Medium>
class FastRoadOf final : public FastRoad {
 public:
  /// Of this density.
  FastRoadOf(Medium const& medium, FastBox2d const& box, double density)
      : medium_(medium), box_(box), density_(density) {}
  double longest_step(std::vector<std::array<double, 2>> const& x) const override {
    std::vector<actio::detail::Plane<double>> places;
    places.reserve(x.size());
    for (auto const& p : x) places.push_back({p[0], p[1]});
    auto const cell = actio::detail::cell_on(medium_, box_.spacing);
    // Of a large box the window around its stiffest part, which is three per cent above at most.
    if (box_.count() > 20000) return 0.98 * actio::detail::bound_of_stable_steps(box_, cell, places);
    return 2 / actio::detail::largest_frequency(box_, cell, places);
  }
  std::unique_ptr<MediumMotion<2>> motion(double step, std::shared_ptr<MediumStart> start) const override {
    return std::make_unique<FastMotion<Medium>>(medium_, box_, density_, step, *start);
  }

 private:
  Medium medium_;
  FastBox2d box_;
  double density_;
};
/// Deduces the medium.
template <class Medium>
std::unique_ptr<FastRoad> fast_road_of(Medium const& medium, FastBox2d const& box, double density) {
  return std::make_unique<FastRoadOf<Medium>>(medium, box, density);
}

}  // namespace actio::scene
