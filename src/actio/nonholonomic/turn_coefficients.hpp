// The coefficients of a step of a rigid body that turns by less than a radian, as power series.
#pragma once

#include <array>
#include <cmath>

#include "actio/any_group/chart_step.hpp"
#include "actio/nonholonomic/rolling_body.hpp"

namespace actio {

namespace detail {

/// The coefficients of a step that turns by \f$\theta\f$, as functions of \f$s = \theta^2 < 1\f$.
template <class S>
struct TurnCoefficients {
  S sine,      ///< \f$\sin(\theta/2)/(\theta/2)\f$
      cosine,  ///< \f$(1 - \cos(\theta/2))/(\theta/2)^2\f$
      third,   ///< \f$(1 - \mathrm{sine})/(\theta/2)^2\f$
      chi,     ///< of \f$\hat x^2\f$ in \f$\chi(\hat x)\f$
      slope;   ///< twice its derivative by s

  explicit TurnCoefficients(S const& s) {
    S const q = s / S(-4);
    sine = S(sines_.back()), cosine = S(cosines_.back());
    for (std::size_t k = sines_.size() - 1; k-- > 0;) {
      third = sine;
      sine = sine * q + S(sines_[k]), cosine = cosine * q + S(cosines_[k]);
    }
    // Terms fall by s/(4 pi^2).
    auto const& beta = systems::detail::coefficients_of_chi();
    std::size_t k = base_value(s) < 1.0 / 64 ? 5 : 12;
    chi = S(std::abs(beta[k])), slope = S(0);
    while (--k > 0) slope = slope * s + chi, chi = chi * s + S(std::abs(beta[k]));
    slope = S(2) * slope;
  }

  /// A vector of space, seen from the body, half a step later: \f$e^{-\hat x/2}u\f$.
  /// @param half  \f$x/2\f$
  Triad<S> turned(Triad<S> const& half, Triad<S> const& u) const {
    Triad<S> const once = cross(half, u);
    return u - sine * once + cosine * cross(half, once);
  }
  /// \f$\int_0^1e^{\tau\hat x}d\tau\,y\f$: how far a body goes, seen from it at the start.
  Triad<S> moved(Triad<S> const& half, Triad<S> const& y) const {
    Triad<S> const once = cross(half, y), first = y + cosine * once + third * cross(half, once);
    return S(0.5) * (first + turned(S(-1) * half, first));
  }

 private:
  static constexpr std::array<double, 8> sines_{
      1, 1.0 / 6, 1.0 / 120, 1.0 / 5040, 1.0 / 362880, 1.0 / 39916800, 1.0 / 6227020800, 1.0 / 1307674368000},
      cosines_{1.0 / 2,       1.0 / 24,        1.0 / 720,         1.0 / 40320,
               1.0 / 3628800, 1.0 / 479001600, 1.0 / 87178291200, 1.0 / 20922789888000};
};

}  // namespace detail

}  // namespace actio
