// The matrix by which contact forces change the stretches of a rod: what multipliers of Gamma = Gamma0 are
// solved with.
//
// With the force of the elements given by N instead of the stretch, a step is found by correcting N until the
// placement after it obeys the constraint (chapter 7: the constraint is on the values of the field, and its
// multiplier joins the Lagrangian). By a kick of length k and a step of length h the stretches change by
// -S dN, S = k h A W A^T, with the differential A of the stretches by places and attitudes and the inverse W
// of masses and moments of inertia. An element has sections in common with those beside it, so that S is
// symmetric and tridiagonal in blocks of three rows: it is factored once a step, and used as it is while N is
// corrected.
#pragma once

#include "actio/numbers/registers.hpp"
#include "actio/rods/rod_arrays.hpp"

namespace actio::rods {

/// Three rows of three numbers.
template <class T>
using Block = std::array<Three<T>, 3>;

/// The matrix S of a rod, factored.
class StretchMatrix {
 public:
  StretchMatrix() = default;
  /// Of a rod.
  /// @param held_places  whether the places of the first and the last section are given
  StretchMatrix(RodConstants const& rod, std::array<bool, 2> const& held_places);

  /// Of the rod where it is now.
  /// @param factor  k h, time^2
  /// @return        whether it is positive definite
  bool factor(Registers registers, RodConstants const& rod, RodState const& state, double factor);
  /// \f$N \mathrel{+}= S^{-1}\,r\f$.
  /// @param r  of elements, length; changed
  void correct(Rows<3>& r, Rows<3>& N) const;

 private:
  std::vector<double> over_mass_;       // 1/(share times mass), zero where a place is held
  Rows<6> diagonal_;                    // of S: 00, 01, 02, 11, 12, 22
  Rows<9> below_;                       // of S: rows of the element after, columns of this one
  std::vector<Block<double>> inverse_,  // of the pivots
      lower_;                           // of the factors: block below times inverse pivot
};

}  // namespace actio::rods
