// A curve by the distance along it, for sections at equal distances.
#pragma once

#include "program/systems/rods/formulas.hpp"

namespace actio::scene {

/// A curve by the distance along it.
class CurveByLength {
 public:
  /// @param curve     smooth, for a parameter from 0 to 1; it outlives this
  /// @param elements  of the rod that lies along it
  CurveByLength(RodFormulas const& curve, int elements);
  double length() const { return until_.back(); }  ///< of all of it
  /// The parameter up to which so much of the length has gone by.
  /// @param part  of the length, from 0 to 1
  double at(double part) const;

 private:
  double speed(double s) const;
  double between(double a, double b) const;

  RodFormulas const& curve_;
  std::vector<double> until_;  // the lengths up to equally distant parameters
};

}  // namespace actio::scene
