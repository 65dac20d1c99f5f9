// The free body by power series in the time, component by component: the reference solution that judges it.
// Nothing of the library's bodies is in it.
#pragma once

#include <array>
#include <cmath>
#include <vector>

namespace actio::testing {

/// Body momentum and attitude (unit quaternion, scalar first, body to space).
template <class S>
struct FreePath {
  std::array<S, 3> momentum;
  std::array<S, 4> attitude;
};

/// \f$\dot M_1 = (1/I_3-1/I_2)M_2M_3\f$ and so on, \f$\dot q = \tfrac12q\,(0,\omega)\f$,
/// \f$\omega_i = M_i/I_i\f$: series in the time, until the remainder is below 10^-digits.
template <class S>
class FreeBodyWitness {
 public:
  FreeBodyWitness(std::array<double, 3> const& moments, int digits)
      : digits_(digits), terms_(static_cast<int>(1.15 * digits) + 2) {
    for (int i = 0; i < 3; ++i) I_[i] = S(moments[i]);
    for (auto& c : m_) c.resize(terms_ + 1);
    for (auto& c : w_) c.resize(terms_ + 1);
    for (auto& c : q_) c.resize(terms_ + 1);
  }

  /// How many expansions the last motion took.
  int expansions() const { return expansions_; }

  FreePath<S> after(FreePath<S> path, S const& duration) {
    expansions_ = 0;
    for (S reached(0); reached != duration; ++expansions_) {
      expand(path, duration < S(0));
      S const left = duration < S(0) ? S(reached - duration) : S(duration - reached), wanted = left * rate_;
      double const most = step(path);
      bool const last = !(S(most) < wanted);
      S const tau = last ? wanted : S(most);
      for (int i = 0; i < 3; ++i) path.momentum[i] = sum(m_[i], tau) * size_;
      for (int i = 0; i < 4; ++i) path.attitude[i] = sum(q_[i], tau);
      reached = last ? duration : duration < S(0) ? S(reached - tau / rate_) : S(reached + tau / rate_);
    }
    return path;
  }

 private:
  static S size(S const& x) { return x < S(0) ? S(-x) : x; }

  /// The series from here, in units in which the largest component of the momentum and that of the angular
  /// velocity are 1.
  void expand(FreePath<S> const& path, bool back) {
    size_ = S(0), rate_ = S(0);
    for (int i = 0; i < 3; ++i) {
      if (size(path.momentum[i]) > size_) size_ = size(path.momentum[i]);
      if (size(path.momentum[i]) / I_[i] > rate_) rate_ = size(path.momentum[i]) / I_[i];
    }
    if (!(size_ > S(0))) size_ = rate_ = S(1);
    S const unit = back ? S(-size_ / rate_) : S(size_ / rate_);
    for (int i = 0; i < 3; ++i) m_[i][0] = path.momentum[i] / size_;
    for (int i = 0; i < 4; ++i) q_[i][0] = path.attitude[i];
    for (int k = 0; k < terms_; ++k) {
      for (int i = 0; i < 3; ++i) {
        int const j = (i + 1) % 3, l = (i + 2) % 3;
        w_[i][k] = m_[i][k] * (unit / I_[i]);
        S c(0);
        for (int a = 0; a <= k; ++a) c += m_[j][a] * m_[l][k - a];
        m_[i][k + 1] = c * (unit * (I_[j] - I_[l]) / (I_[j] * I_[l])) / S(k + 1);
      }
      S d[4] = {S(0), S(0), S(0), S(0)};
      for (int a = 0; a <= k; ++a) {
        S const &x = w_[0][k - a], &y = w_[1][k - a], &z = w_[2][k - a];
        d[0] -= q_[1][a] * x + q_[2][a] * y + q_[3][a] * z;
        d[1] += q_[0][a] * x + q_[2][a] * z - q_[3][a] * y;
        d[2] += q_[0][a] * y + q_[3][a] * x - q_[1][a] * z;
        d[3] += q_[0][a] * z + q_[1][a] * y - q_[2][a] * x;
      }
      for (int i = 0; i < 4; ++i) q_[i][k + 1] = d[i] / S(2 * (k + 1));
    }
  }
  /// The time within which the last two terms stay below what is allowed.
  double step(FreePath<S> const&) const {
    double least = 1e300;
    for (int k = terms_ - 1; k <= terms_; ++k) {
      double largest = 0;
      for (auto const& c : m_) largest = std::max(largest, static_cast<double>(size(c[k])));
      for (auto const& c : q_) largest = std::max(largest, static_cast<double>(size(c[k])));
      if (largest > 0) least = std::min(least, std::exp((-digits_ * std::log(10.0) - std::log(largest)) / k));
    }
    return least;
  }
  S sum(std::vector<S> const& c, S const& t) const {
    S s = c[terms_];
    for (int k = terms_; k-- > 0;) s = s * t + c[k];
    return s;
  }

  std::array<S, 3> I_;
  int digits_, terms_, expansions_ = 0;
  S size_, rate_;
  std::array<std::vector<S>, 3> m_, w_;
  std::array<std::vector<S>, 4> q_;
};

}  // namespace actio::testing
