// Generalised-alpha of Chung and Hulbert (1993) for rods, in the form of Arnold and Bruls (2007) for Lie
// groups: what programs for flexible bodies use most.
//
// With mean velocities u over steps, relative to the section, and auxiliary accelerations a,
//
//     q_{n+1} = q_n exp(h u),                    u = v_n + (1/2 - beta) h a_n + beta h a_{n+1},
//     v_{n+1} = v_n + (1 - gamma) h a_n + gamma h a_{n+1},
//     (1 - alpha_m) a_{n+1} + alpha_m a_n = (1 - alpha_f) v'_{n+1} + alpha_f v'_n,
//
// where q_{n+1}, v_{n+1} and v'_{n+1} obey the equations of motion. The amplification of the fastest waves is
// rho: alpha_m = (2 rho - 1)/(rho + 1), alpha_f = rho/(rho + 1). The group is that of places and turns side
// by side, R^3 x SO(3) for a section.
#pragma once

#include "witness/rod_motion.hpp"

namespace actio::rods {

/// The method for one rod and one step.
class GeneralisedAlpha {
 public:
  /// @param rho   amplification of the fastest waves, a number in [0, 1]
  /// @param step  h, time
  GeneralisedAlpha(SemiDiscreteRod rod, RodMotion start, double rho, double step)
      : rod_(std::move(rod)),
        now_(std::move(start)),
        step_(step),
        alpha_m_((2 * rho - 1) / (rho + 1)),
        alpha_f_(rho / (rho + 1)),
        gamma_(0.5 + alpha_f_ - alpha_m_),
        beta_((gamma_ + 0.5) * (gamma_ + 0.5) / 4) {
    rate_ = rod_.forces(now_.shape, 0);
    for (std::size_t k = 0; k < rate_.size(); ++k) {
      Six const m = rod_.masses(k);
      rate_[k] = (rate_[k] - whirl(now_.velocity[k], m)).cwiseQuotient(m);
    }
    if (rod_.clamped) rate_.front().setZero();
    auxiliary_ = rate_;
    move_.reserve(rate_.size());
    for (auto const& v : now_.velocity) move_.push_back(step * v);
    move_before_ = move_;
  }

  /// One step.
  /// @throws NotConverged  where Newton's method has no solution for it: the corrections, relative to the
  ///                       first one
  void step() {
    std::size_t const sections = rate_.size();
    double const h = step_, to_rate = (1 - alpha_m_) / (h * h * beta_ * (1 - alpha_f_)),
                 to_velocity = gamma_ / (h * beta_);
    RodMotion next = now_;
    std::vector<Six> rate(sections), move = move_, before = auxiliary_;
    for (std::size_t k = 0; k < sections; ++k) {
      // The first guess: sections move on evenly faster. What follows for velocities and accelerations.
      move[k] += move_[k] - move_before_[k];
      Six const next_auxiliary =
          ((move[k] - h * now_.velocity[k]) / (h * h) - (0.5 - beta_) * before[k]) / beta_;
      next.velocity[k] += h * ((1 - gamma_) * before[k] + gamma_ * next_auxiliary);
      rate[k] =
          ((1 - alpha_m_) * next_auxiliary + alpha_m_ * before[k] - alpha_f_ * rate_[k]) / (1 - alpha_f_);
    }
    std::vector<double> sizes;
    do {
      next.shape = now_.shape;
      SemiDiscreteRod::move(next.shape, move);
      BlockTridiagonal matrix(sections);
      auto right = rod_.forces(next.shape, time() + h, &matrix);
      for (std::size_t k = 0; k < sections; ++k) {
        Six const m = rod_.masses(k), &v = next.velocity[k];
        right[k] -= m.cwiseProduct(rate[k]) + whirl(v, m);
        // A change of h u turns the section by T times that.
        auto const turn = differential(move[k].tail<3>());
        matrix.diagonal[k].rightCols<3>() *= turn;
        if (k > 0) matrix.above[k - 1].rightCols<3>() *= turn;
        if (k + 1 < sections) matrix.below[k].rightCols<3>() *= turn;
        matrix.diagonal[k].diagonal() += to_rate * m;
        Eigen::Vector3d const J = m.tail<3>(), w = v.tail<3>(), L = J.cwiseProduct(w);
        matrix.diagonal[k].bottomRightCorner<3, 3>() +=
            to_velocity * (product_with(w) * Eigen::Matrix3d(J.asDiagonal()) - product_with(L));
      }
      rod_.hold(matrix, right);
      auto const by = matrix.solve(right);
      double size = 0;
      for (std::size_t k = 0; k < sections; ++k) {
        move[k] += by[k], next.velocity[k] += to_velocity * by[k], rate[k] += to_rate * by[k];
        size = std::max(size, by[k].cwiseAbs().maxCoeff());
      }
      sizes.push_back(size), ++solves_;
      if (!(size < 1e3) || sizes.size() > 20)
        throw NotConverged("generalised-alpha: step of a rod", sizes, tolerance);
    } while (sizes.back() > tolerance);
    next.shape = now_.shape;
    SemiDiscreteRod::move(next.shape, move);
    for (std::size_t k = 0; k < sections; ++k)
      auxiliary_[k] =
          ((1 - alpha_f_) * rate[k] + alpha_f_ * rate_[k] - alpha_m_ * before[k]) / (1 - alpha_m_);
    now_ = std::move(next), rate_ = std::move(rate), move_before_ = std::exchange(move_, std::move(move)),
    ++steps_;
  }
  RodMotion const& now() const { return now_; }                        ///< after the last step
  SemiDiscreteRod const& rod() const { return rod_; }                  ///< the rod
  double time() const { return static_cast<double>(steps_) * step_; }  ///< of the last step
  long solves() const { return solves_; }                              ///< systems of linear equations so far
  /// Largest correction, in units of length and angle, after which a step is solved: the next one would be
  /// its square.
  static constexpr double tolerance = 1e-7;

 private:
  /// \f$\omega\times J\omega\f$.
  static Six whirl(Six const& v, Six const& m) {
    Six out = Six::Zero();
    Eigen::Vector3d const w = v.tail<3>(), L = m.tail<3>().cwiseProduct(w);
    out.tail<3>() = w.cross(L);
    return out;
  }
  /// \f$\exp(\psi+\delta) = \exp(\psi)\exp(T\delta)\f$ to first order.
  static Eigen::Matrix3d differential(Eigen::Vector3d const& psi) {
    double const angle = psi.norm(), s = angle * angle,
                 one = angle > 1e-3 ? (1 - std::cos(angle)) / s : 0.5 - s / 24,
                 two = angle > 1e-2 ? (angle - std::sin(angle)) / (s * angle) : 1.0 / 6 - s / 120;
    Eigen::Matrix3d const by = product_with(psi);
    return Eigen::Matrix3d::Identity() - one * by + two * by * by;
  }

  SemiDiscreteRod rod_;
  RodMotion now_;
  double step_, alpha_m_, alpha_f_, gamma_, beta_;
  std::vector<Six> rate_, auxiliary_, move_, move_before_;
  long steps_ = 0, solves_ = 0;
};

}  // namespace actio::rods
