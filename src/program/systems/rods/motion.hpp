// How a rod of a scene moves.
#pragma once

#include "program/registry/simulation.hpp"
#include "program/systems/rods/input.hpp"

namespace actio::scene {

/// A rod in steps.
class RodMotion : public Motion {
 public:
  /// The scene with steps of this length, from its start.
  /// @throws Error  where it cannot start
  RodMotion(RodScene const& scene, double step);
  void advance(long count) override;
  void look_ahead(double time) override;
  void change_step(double first, double step, long made) override;
  void remember(CheckpointStream& stream) override;
  /// The largest angle between the attitudes of a section, and the largest distance of its places.
  StateDistance distance(Motion const& other) const override;

  /// That quantities are those of.
  rods::Rod& rod() const { return rod_; }
  /// As it is now, computed once.
  rods::RodFrame const& frame() const;
  rods::Impulse const& at_start() const { return at_start_; }  ///< momenta at the time 0

 private:
  mutable rods::Rod rod_;
  rods::Impulse at_start_;
  double length_;
  mutable std::optional<rods::RodFrame> frame_;
};

}  // namespace actio::scene
