// Contact forces of a rod that neither stretches nor shears: multipliers of Gamma = Gamma0.
//
// With the force of the elements given by N instead of the stretch, a step is found by correcting N until the
// placement after it obeys the constraint (chapter 7: the constraint is on the values of the field, and its
// multiplier joins the Lagrangian). By a kick of length k and a step of length h the stretches change by
// -S dN, S = k h A W A^T, with the differential A of the stretches by places and attitudes and the inverse W
// of masses and moments of inertia. An element has stretches in common with those beside it, so that S is
// symmetric and tridiagonal in blocks of three rows: it is factored once a step, and used as it is while N is
// corrected.
#pragma once

#include <vector>

#include "actio/rods/rod_arrays.hpp"

namespace actio::rods {

/// The matrix S of a rod, factored.
class StretchMatrix {
 public:
  /// Of the rod where it is now.
  /// @param factor        k h, time^2
  /// @param held_places   whether the places of the first and the last section are given
  /// @param held_attitudes  and their attitudes
  /// @return  whether it is positive definite
  bool factor(RodConstants const& rod, RodState const& state, double factor,
              std::array<bool, 2> const& held_places, std::array<bool, 2> const& held_attitudes);
  /// \f$N \mathrel{+}= S^{-1}\,r\f$.
  /// @param r  of elements, length; changed
  void correct(Rows<3>& r, Rows<3>& N) const;

 private:
  using Block = std::array<Three<double>, 3>;  // rows
  std::vector<Block> inverse_,                 // of the pivots
      below_;                                  // of an element and the one after: lower block times that
};

}  // namespace actio::rods
