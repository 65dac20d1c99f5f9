// The velocity of a step of the natural chart from the momentum at its start, step after step.
//
// The equation P_0(v) = P of one step differs little from that of the step before. The inverse of its
// derivative is reused and improved by Broyden's formula, and the first guess is extrapolated from the last
// velocities, by the polynomial that would have been best for the one before. Where that fails Newton's
// iteration begins at the Legendre velocity.
#pragma once

#include <array>

#include "actio/any_group/broyden_update.hpp"
#include "actio/any_group/chart_step.hpp"
#include "actio/any_group/eigenvalues_of.hpp"
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
        inverse_(static_cast<std::size_t>(system.dimension() * system.dimension())),
        moduli_(inverse_),
        weights_(static_cast<std::size_t>(system.dimension())),
        v_(weights_),
        residual_(weights_),
        update_(weights_),
        last_(weights_) {}

  double length() const { return h_; }                        ///< of a step
  std::vector<double> const& velocity() const { return v_; }  ///< of the last step
  /// How often momenta were evaluated, one batch of derivatives counting as one.
  long evaluations() const { return evaluations_; }

  /// Takes a step: sets the point to that at its end.
  /// @throws NotConverged, Singular, NotFinite  where there is no such step near by; the point is as it was
  /// @throws OutsideDomain  where the step would turn by half a turn or more, beyond the chart
  void operator()(ReducedPoint& point) {
    predict();
    if (!(past_ > 0 && chord(point))) newton(point);
    require_in_chart();
    remember_velocity();
    // What the last residual leaves of the momentum goes with the step as the momentum does.
    step_.transport(residual_);
    for (std::size_t i = 0; i < v_.size(); ++i) point.momentum[i] = step_.after[i] - residual_[i];
    point.vectors = step_.vectors;
  }

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
  void require_in_chart() const {
    if (system_.chart == Chart::cayley || !(step_.square_of_ad() > std::numbers::pi * std::numbers::pi))
      return;
    Vector<double> const v = Eigen::Map<Eigen::VectorXd const>(v_.data(), static_cast<Index>(v_.size()));
    Eigen::MatrixXd const ad = system_.algebra.ad(Vector<double>(v * h_));
    double const turn = eigenvalues_of(ad).imag().cwiseAbs().maxCoeff();
    if (!(turn < std::numbers::pi))
      throw OutsideDomain("natural chart", "a step must turn by less than half a turn; radians", turn,
                          std::numbers::pi);
  }

  /// What the polynomial through so many velocities, the first of them `from` steps ago, says of the next
  /// one.
  void extrapolate(int points, int from, std::vector<double>& out) const {
    std::fill(out.begin(), out.end(), 0.0);
    double weight = points;  // binomial coefficients with changing signs
    for (int k = 0; k < points; ++k) {
      auto const& old = history_[static_cast<std::size_t>(from + k)];
      for (std::size_t i = 0; i < out.size(); ++i) out[i] += weight * old[i];
      weight *= -static_cast<double>(points - k - 1) / (k + 2);
    }
  }
  void predict() {
    if (past_ > 0) extrapolate(points_, 0, v_);
  }
  void remember_velocity() {
    std::rotate(history_.begin(), history_.end() - 1, history_.end());
    history_[0] = v_;
    bool const growing = past_ < longest_;
    past_ = std::min(past_ + 1, longest_);
    if (growing || ++steps_ % 64 == 0) choose_points();
  }
  /// The number of points that would have been best for the last velocity.
  void choose_points() {
    std::vector<double> guess(v_.size());
    double best = HUGE_VAL;
    for (int points = 1; points < past_; ++points) {
      extrapolate(points, 1, guess);
      double missed = 0;
      for (std::size_t i = 0; i < guess.size(); ++i) missed = std::max(missed, std::abs(guess[i] - v_[i]));
      if (missed < best) best = missed, points_ = points;
    }
    points_ = std::clamp(points_, 1, past_);
  }

  /// The residual at the velocity, and its size: in each component relative to what it is the sum of.
  /// Infinite outside of the chart. It is minus the momentum equation of (3.10) or (3.11), by structure
  /// constants.
  double evaluate(ReducedPoint const& start) {
    ++evaluations_;
    if (!step_(h_, v_, start.vectors)) return HUGE_VAL;
    auto const d = v_.size();
    double largest = 0;
    for (std::size_t i = 0; i < d; ++i) {
      double const r = residual_[i] = step_.before[i] - start.momentum[i];
      if (!(r - r == 0)) return HUGE_VAL;
      double scale = std::abs(start.momentum[i]) + std::abs(step_.before[i]);
      for (std::size_t j = 0; j < d; ++j) scale += moduli_[i * d + j] * std::abs(v_[j]);
      if (r != 0) largest = std::max(largest, std::abs(r) / scale);
    }
    return largest;
  }

  /// @return false where it does not get there
  bool chord(ReducedPoint const& start) {
    bool fresh = !known_;
    if (fresh && !differentiate(start)) return false;
    known_ = true;
    double before = HUGE_VAL;
    for (int iteration = 0; iteration < 20; ++iteration) {
      double const size = evaluate(start);
      if (!(size < HUGE_VAL)) return false;
      bool const done = size <= tolerance_ || (size <= 64 * tolerance_ && size > before / 2);
      find_update();
      if (!done && size > before / 8) {
        if (fresh && size > before / 2) return false;
        if (!differentiate(start)) return false;
        fresh = true;
        find_update();
      } else if (iteration > 0 && !done) {
        fresh = false;
        broyden_update(inverse_, last_, weights_, update_);
      }
      move(1);
      if (done) return true;
      std::swap(last_, update_);
      before = size;
    }
    return false;
  }
  /// The step of Newton's iteration with the inverse that there is.
  void find_update() {
    auto const d = v_.size();
    for (std::size_t i = 0; i < d; ++i) {
      double sum = 0;
      for (std::size_t j = 0; j < d; ++j) sum -= inverse_[i * d + j] * residual_[j];
      update_[i] = sum;
    }
  }
  void move(double fraction) {
    for (std::size_t i = 0; i < v_.size(); ++i) v_[i] += fraction * update_[i];
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
    using Rows = Eigen::Map<Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>;
    Rows(moduli_.data(), d, d) = derivative.cwiseAbs();
    Eigen::VectorXd const units = units_of(derivative);
    for (int i = 0; i < d; ++i) weights_[static_cast<std::size_t>(i)] = 1 / (units[i] * units[i]);
    InverseInUnits const inverse(derivative, units);
    regular_ = inverse.condition;
    Rows(inverse_.data(), d, d) = inverse.matrix;
    return regular_ > 0x1p-50;
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
      find_update();
      std::vector<double> const from = v_;
      for (double fraction = 1; fraction > 1e-6; fraction /= 2) {
        v_ = from;
        move(fraction);
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
  std::vector<double> inverse_, moduli_;  // of the derivative; row by row
  std::vector<double> weights_, v_, residual_, update_, last_;
  std::array<std::vector<double>, longest_> history_;
  int past_ = 0, points_ = 1;
  long steps_ = 0;
  bool known_ = false;
  long evaluations_ = 0;
  double regular_ = 1;
};

}  // namespace actio
