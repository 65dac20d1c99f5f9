// Laws of the volume that materials of scenes are made of, for lanes of the optimised implementation as well.
#pragma once

#include <cmath>

#include "actio/stored_energy/fast_cell_2d.hpp"
#include "actio/stored_energy/small_strains.hpp"

namespace actio::scene {

/// The law of a gas that may be held together by an inner pressure, Tait's:
/// \f$U = \frac K{\gamma-1}J^{1-\gamma}+BJ\f$, \f$U' = B-KJ^{-\gamma}\f$; with B it is zero at J = 1.
struct GasLaw {
  static constexpr bool in_lanes = true;  ///< slopes come four at a time
  double K;                               ///< pressure over density at J = 1, B aside
  double gamma;                           ///< exponent, above 1
  double B;                               ///< inner pressure over density; 0 of a gas

  /// U, speed squared.
  template <class T>
  T energy(T const& J) const {
    using std::exp, std::log;
    return (K / (gamma - 1)) * exp((1 - gamma) * log(J)) + B * J - (B == 0 ? 0 : K / (gamma - 1) + B);
  }
  /// \f$U'\f$, speed squared.
  template <class T>
  [[gnu::always_inline]] T slope(T const& J) const {
    using std::exp, std::log;
    return B - K * exp(-gamma * log(J));
  }
  /// \f$U'\f$ at four corners.
  template <class T>
  [[gnu::always_inline]] void slopes(T const (&J)[4], T (&out)[4]) const {
    if constexpr (std::same_as<T, actio::media::detail::Quad>) {
      media::PolytropicGas{K, gamma}.slopes(J, out);
      for (int k = 0; k < 4; ++k) out[k] = out[k] + T(B);
    } else {
      for (int k = 0; k < 4; ++k) out[k] = slope(J[k]);
    }
  }
  /// U from \f$\log J\f$, without loss where that is small and U is zero at J = 1.
  double energy_beyond(double log) const {
    if (B == 0) return K / (gamma - 1) * std::exp((1 - gamma) * log);
    return K / (gamma - 1) * media::exponential_beyond_line((1 - gamma) * log) +
           B * media::exponential_beyond_line(log) + (B - K) * log;
  }
  /// \f$U'\f$, likewise.
  double slope_beyond(double log) const { return (B - K) - K * std::expm1(-gamma * log); }
  /// The law whose slope at a J is `weight` times \f$U'(J/unit)\f$.
  GasLaw scaled(double unit, double weight) const {
    return {weight * K * std::pow(unit, gamma), gamma, weight * B};
  }
};

}  // namespace actio::scene
