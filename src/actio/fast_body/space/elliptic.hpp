// Jacobi's elliptic functions and an integral of the third kind, from the complementary modulus.
//
// Near the separatrix of a rigid body 1 - k^2 is tiny and all that matters, so it is the argument here. Means
// of Gauss for the functions, duplication after Carlson for the integral \cite carlson_1995; both double or
// better their digits in each round.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "actio/numbers/scalar.hpp"

namespace actio::bodies {

/// Elliptic functions of one modulus.
template <Real S>
class JacobiFunctions {
 public:
  /// @param complement  \f$k'^2 = 1-k^2\f$, from 0 to 1
  explicit JacobiFunctions(S const& complement) {
    using std::sqrt;
    S a(1), b = sqrt(complement);
    degenerate_ = complement == S(0);
    if (degenerate_) return;
    S const enough = sqrt(epsilon<S>()) / S(8);
    for (rounds_ = 0; rounds_ + 1 < most; ++rounds_) {
      mean_[rounds_] = a, other_[rounds_] = b;
      S const next = (a + b) / S(2);
      bool const met = a - b <= enough * a;
      b = sqrt(S(a * b));
      a = next;
      if (met) {
        ++rounds_;
        break;
      }
    }
    limit_ = a, conjugate_ = sqrt(complement);
  }

  /// The real quarter period K; infinite for k = 1.
  S quarter_period() const {
    return degenerate_ ? std::numeric_limits<S>::infinity() : S(pi() / (S(2) * limit_));
  }

  /// sn, cn, dn.
  struct Values {
    S sn;  ///< sine amplitude
    S cn;  ///< cosine amplitude
    S dn;  ///< delta amplitude
  };
  /// @param u  between -K and K, where all digits are to be right
  Values at(S const& u) const {
    using std::cosh, std::tanh;
    if (degenerate_) {
      S const sech = S(1) / S(cosh(u));
      return {tanh(u), sech, sech};
    }
    // Beyond half the quarter period from its end: there cn is as small as k', and is to have its digits all
    // the same.
    if (S const size = magnitude(u), quarter = quarter_period(); S(2) * size > quarter) {
      auto const [sn, cn, dn] = below_half(S(quarter - size));
      return {u < S(0) ? S(-cn / dn) : S(cn / dn), conjugate_ * sn / dn, conjugate_ / dn};
    }
    return below_half(u);
  }

  /// \f$\pi\f$, to all digits of S.
  static S pi() {
    using std::atan;
    return S(4) * S(atan(S(1)));
  }

 private:
  /// The values at u up to half the quarter period, and a little beyond.
  Values below_half(S const& u) const {
    using std::cos, std::sin, std::sqrt;
    S const sine = sin(S(limit_ * u)), cosine = cos(S(limit_ * u));
    if (sine == S(0)) return {S(0), S(1), S(1)};
    // Down again through the means, carrying c = a cn/sn.
    S c = limit_ * cosine / sine, d(1);
    for (int n = rounds_; n-- > 0;) {
      S const ratio = c * c / mean_after(n);
      c *= d;
      d = (other_[n] + ratio) / (mean_[n] + ratio);
    }
    S const length = S(1) / S(sqrt(S(c * c + S(1))));
    S const sn = sine < S(0) ? S(-length) : length;
    return {sn, c * sn, d};
  }

  /// The mean that came of the n-th pair.
  S mean_after(int n) const { return n + 1 < rounds_ ? mean_[n + 1] : limit_; }

  static constexpr int most = 16;
  std::array<S, most> mean_, other_;
  S limit_{1}, conjugate_{1};
  int rounds_ = 0;
  bool degenerate_ = false;
};

}  // namespace actio::bodies
