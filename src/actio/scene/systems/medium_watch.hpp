// Whether the steps of a medium are still stable while it moves: the longest stable step is that of the
// state, and falls where cells are squeezed, sheared or stretched.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "actio/scene/systems/medium_motion.hpp"

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
    step_ = step, first_ = longest;
    if (on_) found(deformation(motion), longest);
  }

  /// How many steps may be made before the next look.
  long next() const { return on_ ? std::max(1L, due_ - since_) : std::numeric_limits<long>::max(); }
  /// So many steps were made.
  /// @param limit  a callable without arguments: the longest stable step now
  /// @throws Error  where the step is longer, with both, the time and the cell that is deformed most
  template <class Limit>
  void made(long count, MediumMotion<d> const& motion, double time, Limit const& limit) {
    if (!on_ || (since_ += count) < due_) return;
    since_ = 0, unsought_ += due_;
    Deformation const now = deformation(motion);
    // A longer time is waited while the change since the last look is a small part of what is left to the
    // bound: if it went on, twice as fast each time, it would be seen before.
    double const change =
        std::max(std::abs(std::log(now.squeeze / last_[0])), std::abs(std::log(now.stretch / last_[1])));
    last_[0] = now.squeeze, last_[1] = now.stretch;
    span_ = change < margin_ / 64 ? std::min(2 * span_, 16 * most_) : most_;
    // A quarter of the strain that would halve a cell, at the rate of now.
    due_ = static_cast<long>(std::clamp(0.25 / (now.rate * step_), 1.0, static_cast<double>(span_)));
    if (!(now.squeeze > squeeze_ * (1 + slack_) || now.stretch > stretch_ * (1 + slack_)) && unsought_ < 4096)
      return;
    double const longest = limit();
    found(now, longest);
    // Near the bound waves of the size of a cell grow by what is not linear in them, unless they are as small
    // as a start has them that is stepped there from the beginning.
    if (first_ == 0) first_ = longest;
    if (step_ <= (step_ > 0.9 * first_ ? 1 : 0.9) * longest) return;
    throw Error("medium: the step " + show(step_) + " is no longer stable at t = " + show(time) +
                ": the longest stable step has fallen to " + show(longest) +
                ", of which nine tenths are safe, and most deformed is " + motion.cells().name(now.cell) +
                " with the Jacobian " + show(now.jacobian) + "; a step of " + show(longest / 2) +
                " would go on from there; the state is that at t = " + show(time) +
                (fluid_ ? ": a fluid resists no shear, and cells that are sheared for long tangle" : ""));
  }
  /// The state is another one.
  void begin_anew() {
    double const first = first_;
    *this = StepWatch(step_, most_, fluid_, on_), first_ = first;
  }

 private:
  struct Deformation {
    double squeeze = 0;    // the largest square of the inverse of F
    double stretch = 0;    // the largest square of F
    double rate = 0;       // the fastest strain, per time
    std::size_t cell = 0;  // with the largest squeeze
    double jacobian = 1;   // of it
  };
  /// The longest stable step is that of this deformation.
  void found(Deformation const& now, double longest) {
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
    return cofactors(A).transpose() * (1 / small_determinant(A));
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
      for (int b = 0; b < corner_count(cells.shape()); ++b)
        rate[b] = v[static_cast<std::size_t>(cell.nodes[static_cast<std::size_t>(b)])];
      auto const correction = cells.correction(from);
      Matrix<double, d, d> const more = cells.common(correction, at);
      for (int p = 0; p < cells.points(); ++p) {
        Matrix<double, d, d> const back = inverse(cells.edges(from, p)), F = cells.edges(at, p) * back + more;
        double const J = small_determinant(F), squeeze = square(cofactors(F)) / (J * J);
        if (squeeze > out.squeeze) out.squeeze = squeeze, out.cell = c, out.jacobian = J;
        out.stretch = std::max(out.stretch, square(F));
        if (p > 0) continue;
        Matrix<double, d, d> const L =
            (cells.edges(rate, p) * back + cells.common(correction, rate)) * inverse(F);
        out.rate = std::max(out.rate, 0.25 * square(L + L.transpose()));
      }
    }
    out.rate = std::sqrt(out.rate);
    return out;
  }

  double step_;
  long most_;
  bool fluid_, on_;
  long span_ = most_, due_ = 1, since_ = 0, unsought_ = 0;
  double squeeze_ = 0, stretch_ = 0;  // the largest for which the longest stable step was found
  double slack_ = 0, margin_ = 0;     // by how much they may grow, and the logarithm of what the step may
  double last_[2] = {0, 0};           // squeeze and stretch of the last look
  double first_ = 0;                  // the longest stable step at the start
};

}  // namespace actio::scene
