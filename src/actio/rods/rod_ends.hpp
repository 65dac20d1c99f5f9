// What happens at the ends of a rod: how they are held, and what pulls and turns them.
#pragma once

#include <functional>

#include "actio/rods/rod_element.hpp"

namespace actio::rods {

/// A section in space.
struct Placement {
  Three<double> place;    ///< length
  Four<double> attitude;  ///< unit quaternion
};

/// One end of a rod.
struct RodEnd {
  /// What of it is given.
  enum class Held {
    free,     ///< nothing
    pinned,   ///< its place
    clamped,  ///< its place and its attitude
  };
  Held held = Held::free;  ///< what of it is given
  /// where it is at a time, if it is held; null: where it is at the start
  std::function<Placement(double)> motion = nullptr;
  /// that acts on it at a time, if its place is free; null: none
  std::function<Three<double>(double)> force = nullptr;
  /// that acts on it at a time, if its attitude is free; null: none
  std::function<Three<double>(double)> moment = nullptr;
  bool force_in_body = false;   ///< whether the force is given in the axes of the section
  bool moment_in_body = false;  ///< whether the moment is given in the axes of the section
};

/// What acts on a rod from outside.
struct RodLoads {
  Three<double> gravity{};  ///< length/time^2
  RodEnd start,             ///< the first section; of a ring nothing happens there
      end;                  ///< the last section

  /// @throws OutsideDomain  where a load acts on what is given
  void examine(bool closed) const;
};

}  // namespace actio::rods
