// The bodies of the catalogue, which the program carries with it.
#pragma once

#include <string>
#include <vector>

#include "actio/rigid_body/inertia.hpp"

namespace actio::scene {

/// A body of the catalogue, as scenes and `actio show` need it.
struct LibraryBody {
  std::string name,           ///< as scenes write it
      title,                  ///< for people
      source,                 ///< where its numbers are from
      derived;                ///< what was computed from the numbers of the source, and how
  std::string time;           ///< unit of time of `spin`
  std::string unit;           ///< of the moments: "kg m^2" or "ratio"
  Inertia<3> inertia;         ///< along the principal axes
  Eigen::Matrix3d axes;       ///< principal axes as columns, in the frame of the catalogue
  Eigen::Vector3d spin;       ///< body velocity at the start, in the frame of the catalogue; rad/time
};

/// All of them, in the order of their names.
std::vector<LibraryBody> const& library_bodies();
/// Their names.
std::vector<std::string> names_of_bodies();
/// The one of that name; null where there is none.
LibraryBody const* find_body(std::string const& name);

}  // namespace actio::scene
