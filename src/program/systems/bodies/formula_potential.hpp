// A potential of a body in space that a scene writes as a formula in its attitude and in time.
//
//     potential = "k = 2.5; -k*r33 + 0.1*r11^2*cos(2*t)"
//
// r11 ... r33 are the entries of the rotation matrix that takes the body to space, so that r13, r23, r33 are
// the components in space of the third axis of the body, and r31, r32, r33 those in the body of the third
// axis of space; t is the time.
#pragma once

#include <Eigen/Core>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "actio/fast_body/space/potential_torque.hpp"
#include "program/base/error.hpp"
#include "program/registry/change_in_time.hpp"

namespace actio::scene {

/// The potential, with its exact derivatives. One thread at a time evaluates it; a copy is another one.
class FormulaPotential {
 public:
  /// @param text   of the formula
  /// @param place  where it stands
  /// @throws SceneError  where it is no formula, pointing into the text
  FormulaPotential(std::string const& text, TextPlace const& place);

  /// V, energy, and its derivatives by the entries of the rotation.
  double operator()(bodies::NineEntries const& rotation, double time, bodies::NineEntries& slope) const;
  /// The second derivative along turns in the body, a symmetric matrix: of \f$V(R\exp\hat\eta)\f$ at
  /// \f$\eta = 0\f$, energy.
  Eigen::Matrix3d curvature(bodies::NineEntries const& rotation, double time) const;
  /// How fast it changes from t = 0 on, the attitude being fixed.
  /// @param enough  a second derivative by the time that does not matter, energy/time^2
  ChangeInTime change(bodies::NineEntries const& rotation, double until, double enough) const;
  /// How many operations a value with its first derivatives takes.
  std::size_t operations_of_slope() const;
  std::size_t operations_of_curvature() const;  ///< the same with the second ones
  /// Whether the time occurs in it.
  bool uses_time() const { return uses_[9]; }
  /// The axis of space, 0, 1 or 2, turns about which do not change it, since no other row of the rotation
  /// occurs in it; -1 where there is none.
  int axis() const;

 private:
  struct Tapes;  // of the formula and its derivatives
  std::shared_ptr<Tapes const> tapes_;
  std::array<bool, 10> uses_{};  // of r11, r12, ..., r33, t
  mutable std::vector<double> work_;
};

}  // namespace actio::scene
