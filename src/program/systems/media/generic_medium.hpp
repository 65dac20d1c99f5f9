// Media on any mesh, with loads: the generic implementation.
#pragma once

#include "program/medium_output/motion.hpp"
#include "program/systems/media/loads.hpp"
#include "program/systems/media/material.hpp"

namespace actio::scene {

/// A start by formulas, as the library takes it; it holds them.
template <int d>
media::BodyStart<d> start_of(std::shared_ptr<MediumStart> const& start) {
  using Place = std::array<double, d>;
  return {[start](Place const& X) {
            double rho = 0;
            start->density(X, &rho);
            return rho;
          },
          [start](Place const& X) {
            Place out;
            start->placement(X, out.data());
            return out;
          },
          [start](Place const& X) {
            Place out;
            start->velocity(X, out.data());
            return out;
          }};
}

/// The motion of a medium on a mesh.
template <int d>
class MotionOnMesh : public MediumMotion<d> {
 public:
  /// The longest step for which small motions about the state now are stable, from above within a per cent.
  virtual double longest_step() const = 0;
  /// The longest that viscosity allows now, without which longer ones are made in parts; HUGE_VAL: any.
  virtual double longest_in_one_part() const = 0;
  /// From the start with steps of this length.
  /// @param longest  what \ref longest_step is at the start
  virtual void begin(double step, double longest) = 0;
};

/// What the generic implementation steps.
template <int d>
struct GenericMedium {
  media::BodyMesh mesh;                              ///< of the body; the motion takes it
  Material material;                                 ///< of the body
  std::shared_ptr<MediumStart> start;                ///< how it begins
  MediumLoads<d> loads;                              ///< what acts on it
  int order = 2;                                     ///< of the steps: 2 or 4
  media::Conserve conserve = media::Conserve::form;  ///< what they keep
  media::ArtificialViscosity viscosity = {};         ///< what spreads shocks
  std::string scene = {};                            ///< as a text, for the other ranks

  /// How it is stepped; a step has its length later.
  media::BodyStepping stepping() const { return {1, order, conserve, viscosity}; }
  /// The motion, which has no step before it is begun with one.
  std::unique_ptr<MotionOnMesh<d>> motion();
  /// The part of it on this rank, which is not the first.
  std::unique_ptr<RankPart> part() const;
};

}  // namespace actio::scene
