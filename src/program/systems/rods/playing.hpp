// A rod as the page of a run plays it: a tube with a stripe, coloured by how the rod is bent, twisted and
// stretched, and by its speed.
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "actio/rods/rod_section.hpp"
#include "actio/rods/rod_shape.hpp"
#include "program/pictures/played_medium.hpp"

namespace actio::scene {

/// What of a rod stays.
struct DrawnRod {
  rods::RodSection section;  ///< of it
  rods::RodShape rest;       ///< the shape without stresses
  double length;             ///< at rest
};
/// A rod at one time.
struct RodPosture {
  std::vector<rods::Three<double>> places;      ///< of the sections, length
  std::vector<rods::Four<double>> attitudes;    ///< of the sections, unit quaternions
  std::vector<rods::Three<double>> velocities;  ///< of the sections, length/time
};

/// The tube over time. Its radius is that of a disc with the moments of the section, but no less than a 250th
/// and no more than a 40th of the length.
/// @param times  of the snapshots
/// @param read   one of them
/// @return null where there is none
std::shared_ptr<PlayedMedium const> play_rod(DrawnRod const& rod, std::span<double const> times,
                                             std::function<RodPosture(std::size_t)> const& read);

}  // namespace actio::scene
