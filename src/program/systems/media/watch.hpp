// Whether the steps of a medium are still stable while it moves: the longest stable step is that of the
// state, and falls where cells are squeezed, sheared or stretched.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "program/medium_output/motion.hpp"
#include "program/systems/media/method.hpp"

namespace actio::scene {

/// Looks at the deformation every few steps, and finds the longest stable step anew, which costs as much as
/// some forty steps, where cells are deformed further than they were when it was found last. Where the step
/// is far below its bound, and deformations hardly change against that from look to look, looks become rarer.
/// It changes no step.
template <int d>
class StepWatch {
 public:
  /// @param step  of time
  /// @param most  steps from look to look; sixteen times as many where deformations hardly change
  /// @param fluid whether the medium is one: nothing holds its cells against shear
  /// @param on    false: steps are stable whatever their length, and nothing is looked at
  StepWatch(double step, long most, bool fluid, bool on = true)
      : step_(step), most_(most), fluid_(fluid), on_(on) {}

  /// Steps of this length begin at the start.
  /// @param longest  the longest stable step there, which has been found already
  void begin(double step, MediumMotion<d> const& motion, double longest) {
    step_ = step;
    if (on_) found(strains(motion), longest);
  }

  /// How many steps may be made before the next look.
  long next() const { return on_ ? std::max(1L, due_ - since_) : std::numeric_limits<long>::max(); }
  /// So many steps were made.
  /// @param limit  a callable without arguments: the longest stable step now
  /// @throws Error  where the step is longer, with both, the time and the cell that is deformed most
  template <class Limit>
  void made(long count, MediumMotion<d>& motion, double time, Limit const& limit) {
    if (!on_ || (since_ += count) < due_) return;
    since_ = 0, unsought_ += due_;
    media::Strains const now = strains(motion);
    double const rate = std::sqrt(now.rate);
    // A longer time is waited while the change since the last look is a small part of what is left to the
    // bound: if it went on, twice as fast each time, it would be seen before.
    double const change =
        std::max(std::abs(std::log(now.squeeze / last_[0])), std::abs(std::log(now.stretch / last_[1])));
    last_[0] = now.squeeze, last_[1] = now.stretch;
    span_ = change < margin_ / 64 ? std::min(2 * span_, 16 * most_) : most_;
    // A quarter of the strain that would halve a cell, at the rate of now.
    due_ = static_cast<long>(std::clamp(0.25 / (rate * step_), 1.0, static_cast<double>(span_)));
    if (!(now.squeeze > squeeze_ * (1 + slack_) || now.stretch > stretch_ * (1 + slack_)) && unsought_ < 4096)
      return;
    double const longest = limit();
    found(now, longest);
    if (step_ <= safe_part * longest) return;
    Deformation const worst = deformation(motion);
    double const shorter = step_that_goes_on(motion, longest / 2);
    throw Error("medium: the step " + show(step_) + " is no longer stable at t = " + show(time) +
                ": the longest stable step has fallen to " + show(longest) +
                ", of which nine tenths are safe, and most deformed is " + motion.cells().name(worst.cell) +
                " with the Jacobian " + show(worst.jacobian) +
                (shorter > 0 ? "; a step of " + show(shorter) + " would go on from there" : "") +
                "; the state is that at t = " + show(time) +
                (fluid_ ? ": a fluid resists no shear, and cells that are sheared for long tangle" : ""));
  }
  /// The state is another one.
  void begin_anew() { *this = StepWatch(step_, most_, fluid_, on_); }

 private:
  struct Deformation {
    media::Strains strains;
    std::size_t cell = 0;  // with the largest squeeze
    double jacobian = 1;   // of it
  };
  static media::Strains strains(MediumMotion<d> const& motion) {
    auto const found = motion.strains();
    return found ? *found : deformation(motion).strains;
  }
  /// This step or, where it cannot be made, half of it and so on; 0: none can.
  static double step_that_goes_on(MediumMotion<d>& motion, double step) {
    for (int k = 0; k < 20; ++k, step /= 2) try {
        motion.look_ahead(step), motion.look_ahead(0);
        return step;
      } catch (Error const&) {
      }
    return 0;
  }
  /// The longest stable step is that of this deformation.
  void found(media::Strains const& now, double longest) {
    squeeze_ = std::max(squeeze_, now.squeeze), stretch_ = std::max(stretch_, now.stretch), unsought_ = 0;
    last_[0] = now.squeeze, last_[1] = now.stretch;
    margin_ = std::log(longest / step_), slack_ = std::clamp(margin_ / 5, 0.002, 0.5);
  }
  static double square(Matrix<double, d, d> const& A) {
    double sum = 0;
    for (int k = 0; k < d * d; ++k) sum += A.data()[k] * A.data()[k];
    return sum;
  }
  static Matrix<double, d, d> inverse(Matrix<double, d, d> const& A) {
    return media::cofactors(A).transpose() * (1 / media::small_determinant(A));
  }
  static Deformation deformation(MediumMotion<d> const& motion) {
    MediumCells<d> const& cells = motion.cells();
    // Velocities first: they take more room while they are made.
    auto const v = motion.velocities();
    auto const x = motion.places();
    Deformation out;
    std::array<double, d> at[8], from[8], rate[8];
    for (std::size_t c = 0; c < cells.cells(); ++c) {
      auto const cell = cells.cell(c);
      cells.gather(cell, x, at), cells.gather_reference(cell, from);
      for (int b = 0; b < media::corner_count(cells.shape()); ++b)
        rate[b] = v[static_cast<std::size_t>(cell.nodes[static_cast<std::size_t>(b)])];
      auto const correction = cells.correction(from);
      Matrix<double, d, d> const more = cells.common(correction, at);
      for (int p = 0; p < cells.points(); ++p) {
        Matrix<double, d, d> const back = inverse(cells.edges(from, p)), F = cells.edges(at, p) * back + more;
        double const J = media::small_determinant(F), squeeze = square(media::cofactors(F)) / (J * J);
        if (squeeze > out.strains.squeeze) out.strains.squeeze = squeeze, out.cell = c, out.jacobian = J;
        out.strains.stretch = std::max(out.strains.stretch, square(F));
        if (p > 0) continue;
        Matrix<double, d, d> const L =
            (cells.edges(rate, p) * back + cells.common(correction, rate)) * inverse(F);
        out.strains.rate = std::max(out.strains.rate, 0.25 * square(L + L.transpose()));
      }
    }
    return out;
  }

  double step_;
  long most_;
  bool fluid_, on_;
  long span_ = most_, due_ = 1, since_ = 0, unsought_ = 0;
  double squeeze_ = 0, stretch_ = 0;  // the largest for which the longest stable step was found
  double slack_ = 0, margin_ = 0;     // by how much they may grow, and the logarithm of what the step may
  double last_[2] = {0, 0};           // squeeze and stretch of the last look
};

}  // namespace actio::scene
