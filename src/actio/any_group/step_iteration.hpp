// The equation of a step, solved with the inverse that is left from the last step.
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <utility>
#include <vector>

#include "actio/any_group/broyden_update.hpp"

namespace actio::systems {

/// Newton's iteration for equations that differ little from step to step. The inverse of the derivative is
/// reused and improved by Broyden's formula, and found anew where the residual does not fall by a factor 8.
///
/// `evaluate()` sets the residual at the unknowns and returns its size, infinite where there is none;
/// `differentiate()` hands the derivative to \ref set_derivative, and returns false where it has no inverse.
class StepIteration {
 public:
  static constexpr double tolerance = 16 * 0x1p-52;  ///< of the size of the residual

  /// For so many unknowns.
  explicit StepIteration(std::size_t unknowns)
      : unknowns(unknowns),
        residual(unknowns),
        moduli(unknowns * unknowns),
        inverse(moduli),
        weights_(unknowns),
        update_(unknowns),
        last_(unknowns) {}

  std::vector<double> unknowns,  ///< of the step
      residual,                  ///< of its equation
      moduli,                    ///< of the derivative, row by row
      inverse;                   ///< of the derivative, row by row

  /// The inverse, and the weights of the unknowns in Broyden's formula.
  /// @param units  of the unknowns
  void set_derivative(Eigen::MatrixXd const& derivative, Eigen::MatrixXd const& inverse_of_it,
                      Eigen::VectorXd const& units);
  /// An unknown, in its unit of the last derivative.
  double in_units(std::size_t i) const { return std::abs(unknowns[i]) * std::sqrt(weights_[i]); }
  double unit(std::size_t i) const { return 1 / std::sqrt(weights_[i]); }  ///< of an unknown
  /// Forgets the inverse.
  void forget() { known_ = false; }

  /// From the unknowns on.
  /// @return false where it does not get there
  template <class Evaluate, class Differentiate>
  bool chord(Evaluate const& evaluate, Differentiate const& differentiate);

  /// Newton's iteration with an exact inverse at each point, each update halved until the residual falls.
  /// @param sizes  of the residuals, which are added to it
  /// @return false where it does not get there
  template <class Evaluate, class Differentiate>
  bool newton(Evaluate const& evaluate, Differentiate const& differentiate, std::vector<double>& sizes);

  /// Saves, or restores, all that the next step depends on.
  template <class Stream>
  void store(Stream& stream) {
    stream(known_, unknowns, weights_, inverse, moduli);
  }

 private:
  void find_update();
  void move(double fraction) {
    for (std::size_t i = 0; i < unknowns.size(); ++i) unknowns[i] += fraction * update_[i];
  }

  std::vector<double> weights_, update_, last_;
  bool known_ = false;
};

template <class Evaluate, class Differentiate>
bool StepIteration::chord(Evaluate const& evaluate, Differentiate const& differentiate) {
  bool fresh = !known_;
  if (fresh && !differentiate()) return false;
  known_ = true;
  double before = HUGE_VAL;
  for (int iteration = 0; iteration < 20; ++iteration) {
    double const size = evaluate();
    if (!(size < HUGE_VAL)) return false;
    bool const done = size <= tolerance || (size <= 64 * tolerance && size > before / 2);
    find_update();
    if (!done && size > before / 8) {
      if (fresh && size > before / 2) return false;
      if (!differentiate()) return false;
      fresh = true;
      find_update();
    } else if (iteration > 0 && !done) {
      fresh = false;
      broyden_update(inverse, last_, weights_, update_);
    }
    move(1);
    if (done) return true;
    std::swap(last_, update_);
    before = size;
  }
  return false;
}

template <class Evaluate, class Differentiate>
bool StepIteration::newton(Evaluate const& evaluate, Differentiate const& differentiate,
                           std::vector<double>& sizes) {
  if (!differentiate()) return false;
  double size = evaluate();
  for (int iteration = 0; iteration < 60 && size < HUGE_VAL; ++iteration) {
    sizes.push_back(size);
    double const before = size;
    bool const done = size <= tolerance;
    if (!done && !differentiate()) return false;
    find_update();
    std::vector<double> const from = unknowns;
    for (double fraction = 1; fraction > 1e-6; fraction /= 2) {
      unknowns = from;
      move(fraction);
      if (done) break;
      size = evaluate();
      if (size < before) break;
    }
    if (done || (size <= 64 * tolerance && size > before / 2)) return known_ = true;
    if (!(size < before)) return false;
  }
  return false;
}

}  // namespace actio::systems
