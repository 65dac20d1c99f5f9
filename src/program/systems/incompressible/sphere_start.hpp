// The velocity with which the fluid on the sphere starts: formulas of its components, or a stream function.
#pragma once

#include <array>

#include "actio/formula/tape.hpp"
#include "program/document/file.hpp"

namespace actio::scene {

/// A velocity by its place x, y, z on the unit sphere. One thread at a time evaluates it.
class SphereStart {
 public:
  /// `velocity`, three formulas, or `stream`, one formula \f$\psi\f$ with the velocity
  /// \f$x\times\nabla\psi\f$, of [initial].
  /// @throws SceneError  where there are both or neither, or no formulas, pointing into the text; a stream
  ///                     function is smooth
  explicit SphereStart(SceneFile const& file);

  /// The velocity, length/time; exact derivatives of a stream function.
  /// @throws SceneError  where it is a NaN or infinite, with the place
  std::array<double, 3> operator()(std::array<double, 3> const& x) const;
  /// The key that it is written at.
  std::string const& key() const { return key_; }

 private:
  SceneTable initial_;
  std::string key_;
  Tape tape_;  // three components, or the value and the gradient
  bool stream_;
};

/// The records of its keys.
std::vector<struct Parameter> sphere_start_records();

}  // namespace actio::scene
