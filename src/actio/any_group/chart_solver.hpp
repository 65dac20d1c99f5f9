// The velocity of a step of the natural chart from the momentum at its start, step after step.
//
// The equation P_0(v) = P of one step differs little from that of the step before. The inverse of its
// derivative is reused and improved by Broyden's formula, and the first guess is extrapolated from the last
// five velocities. Where that fails Newton's iteration begins at the Legendre velocity.
#pragma once

#include <array>
#include <span>

#include "actio/any_group/chart_step.hpp"
#include "actio/any_group/legendre_velocity.hpp"

namespace actio {

/// Momentum and carried vectors of a system at one time.
struct ReducedPoint {
  std::vector<double> momentum,  ///< of the body (left-invariant) or in space (right-invariant)
      vectors;                   ///< one after the other
};

/// Solves for steps of one length. For one thread at a time; what it has found out is part of the state of a
/// run, since the digits depend on it.
class ChartSolver {
 public:
  /// Of a system that outlives it.
  /// @param h  step, time; of either sign
  ChartSolver(ReducedSystem const& system, double h)
      : system_(system),
        h_(h),
        step_(system),
        moved_(system),
        legendre_(system),
        inverse_(Eigen::MatrixXd::Zero(system.dimension(), system.dimension())),
        per_row_(static_cast<std::size_t>(system.dimension())),
        v_(per_row_),
        residual_(system.dimension()) {}

  double length() const { return h_; }                          ///< of a step
  std::vector<double> const& velocity() const { return v_; }    ///< of the last step
  /// How often momenta were evaluated, one batch of derivatives counting as one.
  long evaluations() const { return evaluations_; }

  /// Takes a step: sets the point to that at its end.
  /// @throws NotConverged, Singular, NotFinite  where there is no such step near by; the point is as it was
  void operator()(ReducedPoint& point) {
    predict();
    if (!(past_ > 0 && chord(point))) newton(point);
    remember_velocity();
    // The last update of the velocity changes both ends alike, to first order.
    for (std::size_t i = 0; i < v_.size(); ++i)
      point.momentum[i] += step_.after[i] - step_.before[i];
    point.vectors = step_.vectors;
  }

  /// The inverse of the derivative of the momentum at the start in the velocity, at the last solution.
  Eigen::MatrixXd exact_inverse(ReducedPoint const& start) {
    differentiate(start);
    return inverse_;
  }

  /// Where the first step looks for its velocity.
  void begin_at(std::vector<double> velocity) { v_ = std::move(velocity), past_ = 0, known_ = false; }
  /// Saves, or restores, all that the next step depends on.
  template <class Stream>
  void remember(Stream& stream) {
    stream(past_, known_, evaluations_, v_, per_row_);
    for (auto& old : history_) {
      old.resize(v_.size());
      stream(old);
    }
    std::span<double> inverse(inverse_.data(), static_cast<std::size_t>(inverse_.size()));
    stream(inverse);
  }

 private:
  static constexpr int longest_ = 5;
  static constexpr double tolerance_ = 16 * 0x1p-52;

  /// The polynomial through the last velocities, one step on.
  void predict() {
    static constexpr double weights[longest_][longest_] = {
        {1}, {2, -1}, {3, -3, 1}, {4, -6, 4, -1}, {5, -10, 10, -5, 1}};
    if (past_ == 0) return;
    std::fill(v_.begin(), v_.end(), 0.0);
    for (int k = 0; k < past_; ++k)
      for (std::size_t i = 0; i < v_.size(); ++i)
        v_[i] += weights[past_ - 1][k] * history_[static_cast<std::size_t>(k)][i];
  }
  void remember_velocity() {
    std::rotate(history_.begin(), history_.end() - 1, history_.end());
    history_[0] = v_;
    past_ = std::min(past_ + 1, longest_);
  }

  /// The residual at the velocity, and its size; infinite outside of the chart.
  double evaluate(ReducedPoint const& start) {
    ++evaluations_;
    if (!step_(h_, v_, start.vectors)) return HUGE_VAL;
    double largest = 0;
    for (std::size_t i = 0; i < v_.size(); ++i) {
      double const r = step_.before[i] - start.momentum[i];
      residual_[static_cast<Eigen::Index>(i)] = r;
      largest = std::max(largest, std::abs(r) * per_row_[i]);
      if (!(r - r == 0)) return HUGE_VAL;
    }
    return largest;
  }

  /// @return false where it does not get there
  bool chord(ReducedPoint const& start) {
    bool fresh = !known_;
    if (fresh && !differentiate(start)) return false;
    known_ = true;
    double before = HUGE_VAL;
    Eigen::VectorXd last;
    for (int iteration = 0; iteration < 20; ++iteration) {
      double const size = evaluate(start);
      if (!(size < HUGE_VAL)) return false;
      bool const done = size <= tolerance_ || (size <= 64 * tolerance_ && size > before / 2);
      Eigen::VectorXd update = -(inverse_ * residual_);
      if (!done && size > before / 8) {
        if (fresh && size > before / 2) return false;
        if (!differentiate(start)) return false;
        fresh = true;
        update = -(inverse_ * residual_);
      } else if (iteration > 0 && !done) {
        fresh = false;
        improve(last, update);
      }
      move(update);
      if (done) return true;
      last = update;
      before = size;
    }
    return false;
  }
  /// Broyden's formula on the inverse, as in chord_iteration.hpp; turns an update into that of the new one.
  void improve(Eigen::VectorXd const& s, Eigen::VectorXd& next) {
    double const square = s.squaredNorm(), rest = square - s.dot(next);
    if (!(rest > square / 2)) return;
    Eigen::RowVectorXd const along = s.transpose() * inverse_ / rest;
    inverse_.noalias() += next * along;
    next *= square / rest;
  }
  void move(Eigen::VectorXd const& update) {
    for (std::size_t i = 0; i < v_.size(); ++i) v_[i] += update[static_cast<Eigen::Index>(i)];
  }

  /// The inverse of the derivative at the velocity; the residual is left alone.
  bool differentiate(ReducedPoint const& start) {
    int const d = system_.dimension();
    Eigen::MatrixXd derivative(d, d);
    std::vector<Moved<double>> v(v_.begin(), v_.end()), a(start.vectors.begin(), start.vectors.end());
    for (int first = 0; first < d; first += batch) {
      auto const each = [&](auto const& visit) {
        for (int k = 0; k < batch && first + k < d; ++k) visit(k, static_cast<std::size_t>(first + k));
      };
      each([&](int k, std::size_t i) { v[i].part[static_cast<std::size_t>(k)] = 1; });
      ++evaluations_;
      if (!moved_(Moved<double>(h_), v, a)) return false;
      each([&](int k, std::size_t i) {
        v[i].part[static_cast<std::size_t>(k)] = 0;
        for (int r = 0; r < d; ++r)
          derivative(r, static_cast<Eigen::Index>(i)) =
              moved_.before[static_cast<std::size_t>(r)].part[static_cast<std::size_t>(k)];
      });
    }
    for (int i = 0; i < d; ++i)
      per_row_[static_cast<std::size_t>(i)] = 1 / derivative.row(i).cwiseAbs().sum();
    auto const lu = derivative.partialPivLu();
    regular_ = lu.rcond();
    inverse_ = lu.inverse();
    return inverse_.allFinite() && regular_ > 0x1p-50;
  }

  /// Newton's iteration from the Legendre velocity, each update halved until the residual falls.
  void newton(ReducedPoint const& start) {
    known_ = false;
    v_ = past_ > 0 ? history_[0] : v_;
    legendre_.solve(start.momentum, start.vectors, v_);
    std::vector<double> sizes;
    if (!differentiate(start)) fail(sizes);
    double size = evaluate(start);
    for (int iteration = 0; iteration < 60 && size < HUGE_VAL; ++iteration) {
      sizes.push_back(size);
      double const before = size;
      bool const done = size <= tolerance_;
      if (!done && !differentiate(start)) break;
      Eigen::VectorXd const update = -(inverse_ * residual_);
      std::vector<double> const from = v_;
      for (double fraction = 1; fraction > 1e-6; fraction /= 2) {
        v_ = from;
        move(fraction * update);
        if (done) break;
        size = evaluate(start);
        if (size < before) break;
      }
      if (done || (size <= 64 * tolerance_ && size > before / 2)) return void(known_ = true);
      if (!(size < before)) break;
    }
    fail(sizes);
  }
  [[noreturn]] void fail(std::vector<double> const& sizes) const {
    if (regular_ <= 0x1p-50)
      throw Singular("natural chart", "the Lagrangian must be regular for this step; condition", regular_,
                     0x1p-50);
    throw NotConverged("natural chart", sizes, tolerance_);
  }

  ReducedSystem const& system_;
  double h_;
  ChartStep<double> step_;
  ChartStep<Moved<double>> moved_;
  LegendreVelocity legendre_;
  Eigen::MatrixXd inverse_;
  std::vector<double> per_row_, v_;
  std::array<std::vector<double>, longest_> history_;
  Eigen::VectorXd residual_;
  int past_ = 0;
  bool known_ = false;
  long evaluations_ = 0;
  double regular_ = 1;
};

}  // namespace actio
