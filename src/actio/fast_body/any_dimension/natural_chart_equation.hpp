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

#include <limits>
#include <numbers>

#include "actio/fast_body/any_dimension/one_parameter_subgroup.hpp"
#include "actio/fast_body/any_dimension/skew_spectrum.hpp"
#include "actio/rigid_body/inertia.hpp"

namespace actio::detail {

/// The equation for one body, in a unit in which moments and momenta are near 1.
class NaturalChartEquation {
 public:
  /// @param moments  of the planes in the order of the coordinates, and the unit that they are to be divided
  ///                 by
  NaturalChartEquation(Inertia<Eigen::Dynamic> const& inertia, double unit, MatrixAlgebra const& algebra)
      : algebra_(algebra),
        subgroup_(algebra),
        moments_(algebra.size()),
        inverse_(algebra.size()),
        error_(algebra.size()),
        room_(algebra.size()),
        change_(algebra.size()) {
    over_planes(algebra.shape().n, [&](int a, int i, int j) {
      double const moment = inertia.moments[a] / unit;
      least_ = std::min(least_, moment);
      for (auto const at : {full_entry(algebra.shape(), i, j), full_entry(algebra.shape(), j, i)})
        moments_.data()[at] = moment, inverse_.data()[at] = 1 / moment;
    });
  }

  OneParameterSubgroup& subgroup() { return subgroup_; }
  /// How many sweeps the last solution took.
  int sweeps() const { return sweeps_; }
  /// By how much the last two sweeps made the change smaller.
  double contraction() const { return contraction_; }

  /// Iterates from a guess until the change is below the rounding of Z.
  /// @param contraction  of sweeps, known from a step nearby; 1 where it is not
  /// @param slowest      the largest ratio of changes that counts as contraction
  /// @return whether they contract
  bool by_sweeps(double const* p, double* z, double contraction, double slowest) {
    double before = HUGE_VAL;
    contraction_ = contraction;
    // What the rounding of the mean makes of a change.
    double const noise = 64 * rounding * algebra_.norm(p) / least_;
    for (sweeps_ = 1; sweeps_ <= most_sweeps; ++sweeps_) {
      if (!(algebra_.norm(z) < too_large)) return false;
      algebra_.add(1, change(p, z), z);
      double const change = algebra_.norm(change_.data()), size = algebra_.norm(z);
      bool const seen = before < HUGE_VAL;
      if (seen && change > noise) contraction_ = change / before;
      // From one step to the next contraction changes, but not by a factor of 4.
      double const factor = seen ? std::min(1.0, change / before) : std::min(1.0, 4 * contraction);
      if (factor * change <= rounding / 4 * size) return true;
      if (change > slowest * before) return change <= noise;
      before = change;
    }
    return false;
  }

  /// The first guess of all: \f$J^{-1}P\f$.
  void guess(double const* p, double* z) const {
    std::copy(p, p + algebra_.size(), z);
    algebra_.multiply_entries(inverse_.data(), z);
  }

  /// What a sweep adds to Z: zero at the solution, and there alone.
  double const* change(double const* p, double const* z) {
    double* const change = change_.data();
    subgroup_.mean(z, p, error_.data());
    std::copy(z, z + algebra_.size(), room_.data());
    algebra_.multiply_entries(moments_.data(), room_.data());
    algebra_.add(-1, room_.data(), error_.data());
    std::copy(error_.data(), error_.data() + algebra_.size(), change);
    for (double const factor : {1.0 / 2, 1.0 / 6}) {
      // R, [Z,R]/2, [Z,[Z,R]]/12.
      algebra_.times_transposed(z, error_.data(), room_.data());
      algebra_.subtract_transposed(room_.data());
      algebra_.scale(-factor, room_.data());
      algebra_.add(1, room_.data(), change);
      std::swap(error_, room_);
    }
    algebra_.multiply_entries(inverse_.data(), change);
    return change;
  }
  /// Whether all angles of a rotation are less than pi, where the chart ends.
  bool in_chart(double const* z) {
    if (algebra_.norm(z) / std::numbers::sqrt2 < std::numbers::pi ||
        subgroup_.angle_bound(z) < std::numbers::pi)
      return true;
    int const n = algebra_.shape().n;
    Eigen::MatrixXd matrix(n, n);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) matrix(i, j) = z[full_entry(algebra_.shape(), i, j)];
    return skew_spectrum(matrix).maxCoeff() < std::numbers::pi;
  }
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

}  // namespace actio::detail
