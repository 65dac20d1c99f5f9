// The equation of a step of the natural-chart scheme on SO(n): which rotation with constant velocity has the
// momentum P at its beginning (thesis, section 5.1).
//
// With Z = h zeta the momentum of the step is M0 = chi(ad*_Z) J zeta (momentum_of in
// rigid_body/natural_chart_scheme.hpp), chi(x) = x/(e^x - 1). What chi divides by is a mean: J zeta is the
// mean of the momentum while the body turns from its attitude before the step to that after it. So
//
//     J Z = Q(Z),      Q(Z) = mean over s in [0,1] of e^{-sZ} P e^{sZ},      P = h M0,
//
// which has no pole where chi has one. A sweep divides the error R = Q - J Z again by what the mean has
// multiplied it with, to second order,
//
//     Z <- Z + J^{-1} (R + [Z,R]/2 + [Z,[Z,R]]/12),
//
// so that an iteration maps an error to J^{-1}[Lambda, .] of it times Z, however the moments differ. Long
// steps of small bodies are solved by Newton along a growing step, from rest: what is found is the solution
// that grows out of the identity, until the derivative has no inverse or an angle is half a turn, where the
// chart ends. For large n a step is taken where sweeps contract.
#pragma once

#include <Eigen/Core>

#include <limits>
#include <numbers>

#include "actio/fast_body/any_dimension/one_parameter_subgroup.hpp"
#include "actio/fast_body/any_dimension/skew_spectrum.hpp"
#include "actio/rigid_body/inertia.hpp"

namespace actio::bodies::detail {

/// The equation for one body, in a unit in which moments and momenta are near 1.
class NaturalChartEquation {
 public:
  /// @param moments  of the planes in the order of the coordinates, and the unit that they are to be divided
  ///                 by
  NaturalChartEquation(Inertia<Eigen::Dynamic> const& inertia, double unit, MatrixAlgebra const& algebra);

  OneParameterSubgroup& subgroup() { return subgroup_; }
  /// How many sweeps the last solution took.
  int sweeps() const { return sweeps_; }
  /// By how much the last two sweeps made the change smaller.
  double contraction() const { return contraction_; }

  /// Iterates from a guess until the change is below the rounding of Z.
  /// @param contraction  of sweeps, known from a step nearby; 1 where it is not
  /// @param slowest      the largest ratio of changes that counts as contraction
  /// @return whether they contract
  bool by_sweeps(double const* p, double* z, double contraction, double slowest);

  /// The first guess of all: \f$J^{-1}P\f$.
  void guess(double const* p, double* z) const {
    std::copy(p, p + algebra_.size(), z);
    algebra_.multiply_entries(inverse_.data(), z);
  }

  /// What a sweep adds to Z: zero at the solution, and there alone.
  double const* change(double const* p, double const* z);
  /// Whether all angles of a rotation are less than pi, where the chart ends.
  bool in_chart(double const* z);
  MatrixAlgebra const& algebra() const { return algebra_; }

 private:
  static constexpr double rounding = std::numeric_limits<double>::epsilon();
  static constexpr int most_sweeps = 200;
  static constexpr double too_large = 1e3;  // half a turn in each of hundreds of planes is less

  MatrixAlgebra algebra_;
  OneParameterSubgroup subgroup_;
  Zeros moments_, inverse_, error_, room_, change_;
  double least_ = HUGE_VAL, contraction_ = 1;
  int sweeps_ = 0;
};

}  // namespace actio::bodies::detail
