// One step of the natural chart (3.25) in the algebra, written out for structure constants.
//
// Over a step of length h the group moves by exp(h v). With A = h ad_v the momenta at its two ends are
//
//     P_0 = chi(A)^T p + (h/2) J(a_0),    P_1 = chi(-A)^T p - (h/2) J(a_1),    chi(A) = A/(e^A - 1),
//
// where p is the mean of dl/dv at both ends, a_1 = exp(-h v) a_0, and the action of the step is
// h (l(v, a_0) + l(v, a_1))/2. Without carried vectors this is (3.26), and chi(-A) = chi(A) + A makes
// P_1 = P_0 + h ad*_v p. No exponential of a matrix and no logarithm is taken, and brackets are sums over the
// structure constants that are not zero. tests/any_group hold it to the general road.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "actio/any_group/reduced_system.hpp"

namespace actio {

namespace detail {
/// \f$B_{2k}/(2k)! = 2(-1)^{k+1}\zeta(2k)/(2\pi)^{2k}\f$: the even part of \f$x/(e^x - 1)\f$ is
/// \f$1 + \sum_k B_{2k}x^{2k}/(2k)!\f$.
inline std::array<double, 65> const& coefficients_of_chi() {
  static auto const all = [] {
    std::array<double, 65> beta{1, 1.0 / 12, -1.0 / 720, 1.0 / 30240, -1.0 / 1209600, 1.0 / 47900160};
    for (int k = 6; k < 65; ++k) {
      double zeta = 0;
      for (int n = 12; n >= 1; --n) zeta += std::pow(n, -2 * k);
      beta[static_cast<std::size_t>(k)] = (k % 2 ? 2 : -2) * zeta * std::pow(2 * std::numbers::pi, -2 * k);
    }
    return beta;
  }();
  return all;
}

/// The largest modulus among a number and its rates.
inline double largest_part(double x) { return std::abs(x); }
/// The largest modulus among a number and its rates.
template <int N>
double largest_part(Dual<double, N> const& x) {
  double largest = std::abs(x.value);
  for (double const part : x.part) largest = std::max(largest, std::abs(part));
  return largest;
}
/// The largest modulus in a list.
template <class S>
double largest_part(std::vector<S> const& list) {
  double largest = 0;
  for (S const& x : list) largest = std::max(largest, largest_part(x));
  return largest;
}
}  // namespace detail

/// A step of the natural chart at one scalar, `double` or dual numbers over it, with its work space.
template <class S>
class ChartStep {
 public:
  /// Of a system that outlives it.
  explicit ChartStep(ReducedSystem const& system)
      : before(n(system.dimension())),
        after(before),
        vectors(n(system.carried())),
        system_(system),
        inputs_(n(system.lagrangian.inputs)),
        slopes_(inputs_.size() + 1),
        p_(before),
        term_(before),
        half_(before),
        moved_(n(system.length())) {}

  std::vector<S> before,  ///< the momentum at the start; energy x time
      after,              ///< at the end
      vectors;            ///< at the end

  /// The momenta at both ends, and the vectors at the end, of a step with this velocity.
  /// @param h  step, time
  /// @param v  velocity, 1/time
  /// @param a  vectors at the start
  /// @return   false where the step leaves the chart: the turn is beyond the reach of the series of chi
  bool operator()(S const& h, std::vector<S> const& v, std::vector<S> const& a) {
    auto const d = v.size();
    slopes_at(v, a);
    for (std::size_t i = 0; i < d; ++i) p_[i] = slopes_[1 + i];
    if (!a.empty()) {
      push(h / S(2), a, before);
      for (std::size_t k = 0; k < a.size(); k += moved_.size()) carry(h, v, &a[k], &vectors[k]);
      slopes_at(v, vectors);
      for (std::size_t i = 0; i < d; ++i) p_[i] = (p_[i] + slopes_[1 + i]) / S(2);
      push(h / S(-2), vectors, after);
    }
    return add_chi(h, v, a.empty());
  }

  /// \f$h\,\mathrm{ad}^*_v\,\mu\f$, with the sign of the side.
  void add_ad_star(S const& h, std::vector<S> const& v, std::vector<S> const& mu, std::vector<S>& sum) const {
    S const signed_h = h * S(system_.sign());
    for (auto const& c : system_.algebra.constants)
      sum[n(c.b)] += v[n(c.a)] * mu[n(c.c)] * signed_h * S(c.value);
  }

 private:
  static std::size_t n(int i) { return static_cast<std::size_t>(i); }

  void slopes_at(std::vector<S> const& v, std::vector<S> const& a) {
    std::copy(v.begin(), v.end(), inputs_.begin());
    std::copy(a.begin(), a.end(), inputs_.begin() + static_cast<std::ptrdiff_t>(v.size()));
    system_.slopes(inputs_.data(), slopes_.data(), work_);
  }

  /// Sets `sum` to \f$h J\f$, \f$J_c = \partial l/\partial a\cdot(e_ca)\f$ at the slopes last taken.
  void push(S const& h, std::vector<S> const& a, std::vector<S>& sum) {
    std::fill(sum.begin(), sum.end(), S(0));
    auto const d = sum.size(), m = moved_.size();
    S const signed_h = h * S(system_.sign());
    for (auto const& e : system_.algebra.entries)
      for (std::size_t k = 0; k < a.size(); k += m)
        sum[n(e.direction)] += slopes_[1 + d + k + n(e.row)] * a[k + n(e.column)] * signed_h * S(e.value);
  }

  /// \f$e^{-hv}a\f$ of one vector, by its series; with the sign of the side.
  void carry(S const& h, std::vector<S> const& v, S const* a, S* out) {
    auto const m = moved_.size();
    S const signed_h = h * S(-system_.sign());
    std::vector<S>& term = moved_;
    std::copy(a, a + m, term.begin()), std::copy(a, a + m, out);
    double const size = detail::largest_part(term);
    next_.resize(m);
    for (int k = 1; k < 200; ++k) {
      std::fill(next_.begin(), next_.end(), S(0));
      for (auto const& e : system_.algebra.entries)
        next_[n(e.row)] += v[n(e.direction)] * term[n(e.column)] * S(e.value);
      for (std::size_t i = 0; i < m; ++i) {
        term[i] = next_[i] * signed_h / S(k);
        out[i] += term[i];
      }
      if (!(detail::largest_part(term) > negligible_ * size)) return;
    }
  }

  /// Adds \f$\chi(A)^Tp\f$ to `before` and \f$\chi(-A)^Tp\f$ to `after`: the even part of chi, and half of
  /// A p on either side.
  bool add_chi(S const& h, std::vector<S> const& v, bool alone) {
    auto const d = v.size();
    std::fill(half_.begin(), half_.end(), S(0));
    add_ad_star(h / S(2), v, p_, half_);
    if (alone)
      for (std::size_t i = 0; i < d; ++i) before[i] = p_[i] - half_[i], after[i] = p_[i] + half_[i];
    else
      for (std::size_t i = 0; i < d; ++i) before[i] += p_[i] - half_[i], after[i] += p_[i] + half_[i];
    double const size = detail::largest_part(p_);
    auto const& beta = detail::coefficients_of_chi();
    // half_ holds the odd power of A with a factor of 1/2.
    for (std::size_t k = 1; k < beta.size(); ++k) {
      std::fill(term_.begin(), term_.end(), S(0));
      add_ad_star(h * S(2), v, half_, term_);
      double const largest = detail::largest_part(term_) * std::abs(beta[k]);
      for (std::size_t i = 0; i < d; ++i) {
        S const part = term_[i] * S(beta[k]);
        before[i] += part, after[i] += part;
      }
      if (!(largest > negligible_ * size)) return largest == largest;
      std::fill(half_.begin(), half_.end(), S(0));
      add_ad_star(h / S(2), v, term_, half_);
    }
    return false;
  }

  static constexpr double negligible_ = 0x1p-55;
  ReducedSystem const& system_;
  std::vector<S> inputs_, slopes_, work_, p_, term_, half_, moved_, next_;
};

}  // namespace actio
