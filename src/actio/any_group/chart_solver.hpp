// The velocity of a step of the natural chart from the momentum at its start, step after step.
//
// The equation P_0(v) = P of one step differs little from that of the step before. The inverse of its
// derivative is reused and improved by Broyden's formula, and the first guess is extrapolated from the last
// velocities, by the polynomial that would have been best for the one before. Where that fails Newton's
// iteration begins at the Legendre velocity.
#pragma once

#include <Eigen/Core>

#include <array>

#include "actio/any_group/broyden_update.hpp"
#include "actio/any_group/chart_step.hpp"
#include "actio/any_group/eigenvalues_of.hpp"
#include "actio/any_group/legendre_velocity.hpp"

namespace actio::systems {

/// Momentum and carried vectors of a system at one time.
struct ReducedPoint {
  std::vector<double> momentum,  ///< of the body (left-invariant) or in space (right-invariant)
      vectors;                   ///< one after the other
  double time = 0;               ///< when, for a force that depends on it
};

/// The force on a system at a point with a velocity, with the inputs of that time.
std::vector<double> force_at(ReducedSystem const& system, std::vector<double> const& v,
                             ReducedPoint const& at);

/// Solves for steps of one length. For one thread at a time; what it has found out is part of the state of a
/// run, since the digits depend on it.
class ChartSolver {
 public:
  /// Of a system that outlives it.
  /// @param h  step, time; of either sign
  ChartSolver(ReducedSystem const& system, double h);

  double length() const { return h_; }  ///< of a step
  /// The last step, with the forces at its ends.
  ChartStep<double> const& last() const { return step_; }
  std::vector<double> const& velocity() const { return v_; }  ///< of the last step
  /// How often momenta were evaluated, one batch of derivatives counting as one.
  long evaluations() const { return evaluations_; }

  /// Takes a step: sets the point to that at its end.
  /// @throws NotConverged, Singular, NotFinite  where there is no such step near by; the point is as it was
  /// @throws OutsideDomain  where the step would turn by half a turn or more, beyond the chart
  void operator()(ReducedPoint& point);

  /// The inverse of the derivative of the momentum at the start in the velocity, at the last solution.
  Eigen::MatrixXd exact_inverse(ReducedPoint const& start) {
    differentiate(start);
    auto const d = static_cast<Eigen::Index>(v_.size());
    return Eigen::Map<Eigen::Matrix<double, -1, -1, Eigen::RowMajor> const>(inverse_.data(), d, d);
  }

  /// Where the first step looks for its velocity.
  void begin_at(std::vector<double> velocity) { v_ = std::move(velocity), past_ = 0, known_ = false; }
  /// Saves, or restores, all that the next step depends on.
  template <class Stream>
  void remember(Stream& stream) {
    stream(past_, points_, steps_, known_, evaluations_, v_, weights_, inverse_, moduli_);
    for (auto& old : history_) {
      old.resize(v_.size());
      stream(old);
    }
  }

 private:
  static constexpr int longest_ = 8;
  static constexpr double tolerance_ = 16 * 0x1p-52;

  /// No eigenvalue of \f$h\,\mathrm{ad}_v\f$ has an imaginary part of pi or more. Its trace tells where that
  /// is beyond question.
  void require_in_chart() const;

  /// What the polynomial through so many velocities, the first of them `from` steps ago, says of the next
  /// one.
  void extrapolate(int points, int from, std::vector<double>& out) const;
  void predict() {
    if (past_ > 0) extrapolate(points_, 0, v_);
  }
  void remember_velocity();
  /// The number of points that would have been best for the last velocity.
  void choose_points();

  /// The residual at the velocity, and its size: in each component relative to what it is the sum of. The
  /// parts of ad* p are among these: for two equal moments they cancel, and so do their derivatives.
  /// Infinite outside of the chart. It is minus the momentum equation of (3.10) or (3.11), by structure
  /// constants.
  double evaluate(ReducedPoint const& start);

  /// @return false where it does not get there
  bool chord(ReducedPoint const& start);
  /// The step of Newton's iteration with the inverse that there is.
  void find_update();
  void move(double fraction) {
    for (std::size_t i = 0; i < v_.size(); ++i) v_[i] += fraction * update_[i];
  }

  /// The inverse of the derivative at the velocity; the residual is left alone.
  bool differentiate(ReducedPoint const& start);

  /// Newton's iteration from the Legendre velocity, each update halved until the residual falls.
  void newton(ReducedPoint const& start);
  [[noreturn]] void fail(std::vector<double> const& sizes) const;

  ReducedSystem const& system_;
  double h_;
  ChartStep<double> step_;
  ChartStep<Moved<double>> moved_;
  LegendreVelocity legendre_;
  std::vector<double> inverse_, moduli_;  // of the derivative; row by row
  std::vector<double> weights_, v_, residual_, update_, last_;
  std::array<std::vector<double>, longest_> history_;
  int past_ = 0, points_ = 1;
  long steps_ = 0;
  bool known_ = false;
  long evaluations_ = 0;
  double regular_ = 1;
};

}  // namespace actio::systems
