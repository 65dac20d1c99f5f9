// A body in motion: its state with the forces in it, those before the last step, and steps of any length.
#pragma once

#include "actio/media_on_meshes/body_steps.hpp"

namespace actio::media {

/// A body, or a part of it, in motion: what \ref MediumOnMesh and its parts on several ranks have in common.
template <int d>
class BodyMotion {
 protected:
  /// A body without a state.
  BodyMotion(BodySteps<d> steps, BodyStepping const& stepping)
      : steps_of_(std::move(steps)), fractions_(stepping.substeps()), conserve_(stepping.conserve) {}

  BodySteps<d> steps_of_;            ///< of it
  BodyState state_;                  ///< now
  BodyState kept_;                   ///< before the last step
  std::vector<double> forces_;       ///< in the state now
  std::vector<double> kept_forces_;  ///< in that before
  std::vector<double> fractions_;    ///< of a step that its substeps are
  Conserve conserve_;                ///< what they keep

  /// Back to the state before the last step.
  void put_back() { state_ = kept_, forces_ = kept_forces_; }
  /// From the state now, which is kept, a step, or where viscosity needs shorter ones so many equal parts of
  /// it that each is half as long as that allows. It allows less as a shock forms.
  /// @throws ViscosityNeedsShorterSteps  where more than a thousand parts would be needed
  LeastJacobian in_parts(double h, double start, double end) {
    kept_ = state_, kept_forces_ = forces_;
    for (double parts = 1;;) try {
        LeastJacobian least;
        for (double k = 1; k <= parts && least.jacobian > 0; ++k)
          least = attempt(h / parts, start + (k - 1) / parts * h, k == parts ? end : start + k / parts * h);
        return least;
      } catch (ViscosityNeedsShorterSteps const& error) {
        parts = std::max(2 * parts, std::ceil(2 * h / error.bound));
        if (!(parts <= 1000)) throw;
        put_back();
      }
  }
  /// A step of some length from one time to another, by substeps; what it leaves is no state where a Jacobian
  /// is not positive.
  LeastJacobian attempt(double h, double start, double end) {
    double reached = 0;
    LeastJacobian least;
    for (std::size_t k = 0; k < fractions_.size(); ++k) {
      double const from = start + reached * h;
      reached += fractions_[k];
      double const to = k + 1 == fractions_.size() ? end : start + reached * h;
      least = conserve_ == Conserve::form ? steps_of_.explicit_step(state_, forces_, fractions_[k] * h, to)
                                          : steps_of_.implicit_step(state_, fractions_[k] * h, from, to);
      if (!(least.jacobian > 0)) break;
    }
    return least;
  }
};

}  // namespace actio::media
