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

namespace actio::sphere {

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
  LegendreFunctions(Eigen::ArrayXd const& colatitudes, int degrees);

  int m() const { return m_; }  ///< the order
  /// Goes on to the next m.
  void next();
  /// \f$P_{lm}(\theta_j)\f$ for j from `first` on: the rows are l = m, m + 1, ..., degrees - 1; lanes beyond
  /// the last j hold what may be overwritten.
  /// @return the first row to be read: those before it, which are not set, are below \f$2^{-700}\f$
  int block(int first, Block& u) const;

 private:
  using Lanes = Eigen::Array<double, 1, lanes>;
  static constexpr int binary = 800;

  void set_coefficients();
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

}  // namespace actio::sphere
