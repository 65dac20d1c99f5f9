// The normalised Legendre functions P_lm, found for one order m after the other and not stored.
//
// With t = 1 - cos(theta)
//
//   P_{l+1} = rho_l P_l + D_l,   D_l = alpha_l D_{l-1} - beta_l t P_l,
//   rho_l = sqrt((2l + 3)(l - m + 1)/((2l + 1)(l + m + 1))),
//   alpha_l = rho_l (l + m)/(l - m + 1),   beta_l = rho_l (2l + 1)/(l - m + 1),
//
// is the recurrence in l, in the differences of neighbours. The usual one takes cos(theta), in which the
// neighbourhood of a pole has few digits: at the degree 2048 it is wrong by 1e-9 there, this one by 1e-13
// anywhere. It starts at P_mm, a multiple of sin^m(theta), far below the least double near the poles: a
// number is stored together with how often it was divided by 2^-800.
//
// Parallels are the lanes of a block.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace actio {

/// The normalised Legendre functions \f$P_{lm}(\theta)\f$, \f$Y_{lm} = P_{lm}e^{im\varphi}\f$, for one m
/// after the other.
class LegendreFunctions {
 public:
  /// The most parallels of a block.
  static constexpr int lanes = 32;
  /// One row for each degree, one column for each latitude.
  using Block = Eigen::Matrix<double, Eigen::Dynamic, lanes, Eigen::RowMajor>;

  /// For m = 0.
  /// @param colatitudes  in [0, pi]
  LegendreFunctions(Eigen::ArrayXd const& colatitudes, int degrees)
      : degrees_(degrees),
        t_(colatitudes.size()),
        sine_(colatitudes.size()),
        first_(colatitudes.size()),
        exponent_(colatitudes.size(), 0) {
    for (Eigen::Index j = 0; j < colatitudes.size(); ++j) {
      auto const at = static_cast<std::size_t>(j);
      double const half = std::sin(colatitudes[j] / 2);
      t_[j] = 2 * half * half;
      sine_[at] = std::sin(static_cast<long double>(colatitudes[j]));
      first_[at] = 1 / std::sqrt(4 * std::numbers::pi_v<long double>);
    }
    set_coefficients();
  }

  int m() const { return m_; }  ///< the order
  /// Goes on to the next m.
  void next() {
    ++m_;
    for (std::size_t j = 0; j < first_.size(); ++j) {
      int by = 0;
      first_[j] = std::frexp(-first_[j] * sine_[j] * std::sqrt((2 * m_ + 1.0L) / (2.0L * m_)), &by);
      exponent_[j] += by;
    }
    set_coefficients();
  }
  /// \f$P_{lm}(\theta_j)\f$ for j from `first` on: the rows are l = m, m + 1, ..., degrees - 1; lanes beyond
  /// the last j hold what may be overwritten.
  /// @return the first row to be read: those before it, which are not set, are below \f$2^{-700}\f$
  int block(int first, Block& u) const {
    int const size = degrees_ - m_;
    if (u.rows() < size) u.resize(size, lanes);
    Lanes t, p, small;
    for (int i = 0; i < lanes; ++i) {
      auto const at = std::min<std::size_t>(first + i, first_.size() - 1);
      int const times = exponent_[at] < 0 ? -exponent_[at] / binary : 0;
      t[i] = t_[static_cast<Eigen::Index>(at)], small[i] = times;
      p[i] = static_cast<double>(std::ldexp(first_[at], exponent_[at] + binary * times));
    }
    Lanes d = p;
    int r = 0, from = 0;
    // As long as a lane is small, only the others are written.
    for (; r < size && (small > 0).any(); ++r) {
      u.row(r) = (small > 0).select(Lanes::Zero(), p);
      if ((small > 0).all()) from = r + 1;
      advance(r, t, p, d);
      if (r % 4 == 3) lift(p, d, small);
    }
    for (; r < size; ++r) {
      u.row(r) = p;
      advance(r, t, p, d);
    }
    return from;
  }

 private:
  using Lanes = Eigen::Array<double, 1, lanes>;
  static constexpr int binary = 800;

  void set_coefficients() {
    auto const size = static_cast<std::size_t>(std::max(0, degrees_ - m_));
    rho_.resize(size), alpha_.resize(size), beta_.resize(size);
    for (std::size_t r = 0; r < size; ++r) {
      double const l = m_ + static_cast<double>(r), above = static_cast<double>(r) + 1;
      rho_[r] = std::sqrt((2 * l + 3) * above / ((2 * l + 1) * (l + m_ + 1)));
      alpha_[r] = rho_[r] * (l + m_) / above, beta_[r] = rho_[r] * (2 * l + 1) / above;
    }
  }
  void advance(int r, Lanes const& t, Lanes& p, Lanes& d) const {
    auto const at = static_cast<std::size_t>(r);
    d = alpha_[at] * d - beta_[at] * t * p;
    p = rho_[at] * p + d;
  }
  /// Lanes that have grown to 1 are large enough to be stored with one division less.
  static void lift(Lanes& p, Lanes& d, Lanes& small) {
    double const unit = std::ldexp(1.0, -binary);
    for (int i = 0; i < lanes; ++i)
      if (small[i] > 0 && std::abs(p[i]) >= 1) p[i] *= unit, d[i] *= unit, --small[i];
  }

  int degrees_, m_ = 0;
  Eigen::ArrayXd t_;
  std::vector<long double> sine_, first_;  ///< P_mm is first x 2^exponent
  std::vector<int> exponent_;
  std::vector<double> rho_, alpha_, beta_;  ///< at l - m
};

}  // namespace actio
