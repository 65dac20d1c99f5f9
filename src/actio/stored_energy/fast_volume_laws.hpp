// Stored energies that know the Jacobian J alone, for the optimised implementation: U(J) per unit mass and
// its slope U'(J).
//
// A medium's pressure is -rho U'. A law is a small struct with
//
//     template <class T> T energy(T const& J) const;   // U
//     template <class T> T slope(T const& J) const;    // U'
//
// over numbers and dual numbers, and that is all that a law of one's own needs: the optimised implementation
// then evaluates its slope number by number. The laws of this file say `in_lanes`, and give the slopes at the
// four corners of a cell at once, for SIMD lanes as well. They also take the scale of a cell into their
// moduli: `scaled`.
#pragma once

#include <cmath>

#include "actio/stored_energy/fast_functions.hpp"
#include "actio/stored_energy/small_strains.hpp"

namespace actio::media {

/// A law of the Jacobian for which slopes are computed in lanes.
template <class Law>
concept InLanes = requires { requires Law::in_lanes; };

namespace detail {
/// A law whose slope in lanes has a first half that takes about as long as the rest.
template <class Law>
concept InHalves = requires(Law const& law, Fourfold const& J) { law.second_half(J, law.first_half(J)); };

/// 1/J at four corners, by one division for all four.
template <class T>
[[gnu::always_inline]] inline void reciprocals(T const (&J)[4], T (&out)[4]) {
  T const a = J[0] * J[1], b = J[2] * J[3], inverse = T(1.0) / (a * b), of_a = b * inverse,
          of_b = a * inverse;
  out[0] = of_a * J[1], out[1] = of_a * J[0], out[2] = of_b * J[3], out[3] = of_b * J[2];
}
/// The slopes of a law at four corners: those of registers in turns.
template <class Law, class T>
[[gnu::always_inline]] inline void slopes_together(Law const& law, T const (&J)[4], T (&out)[4]) {
  if constexpr (std::same_as<T, Quad>) {
    Fourfold const all = law.slope(Fourfold{{J[0], J[1], J[2], J[3]}});
    out[0] = all.quad[0], out[1] = all.quad[1], out[2] = all.quad[2], out[3] = all.quad[3];
  } else {
    for (int k = 0; k < 4; ++k) out[k] = law.slope(J[k]);
  }
}
/// The slopes of a law at the corners of `count` registers of cells, in the place of the Jacobians there.
///
/// Operations of a slope wait for one another, and a processor looks only so far ahead: the first halves of
/// all registers come before the second ones, so that those of the next register are within its sight.
template <int most, InHalves Law>
[[gnu::always_inline]] inline void slopes_in_place(Law const& law, Quad (*J)[4], int count) {
  Quad half[most][4];
  // Numbers go one by one: a copy of a whole Fourfold would go by halves of registers.
  for (int k = 0; k < count; ++k) {
    Fourfold const h = law.first_half(Fourfold{{J[k][0], J[k][1], J[k][2], J[k][3]}});
    half[k][0] = h.quad[0], half[k][1] = h.quad[1], half[k][2] = h.quad[2], half[k][3] = h.quad[3];
  }
  for (int k = 0; k < count; ++k) {
    Fourfold const q = law.second_half(Fourfold{{J[k][0], J[k][1], J[k][2], J[k][3]}},
                                       Fourfold{{half[k][0], half[k][1], half[k][2], half[k][3]}});
    J[k][0] = q.quad[0], J[k][1] = q.quad[1], J[k][2] = q.quad[2], J[k][3] = q.quad[3];
  }
}
}  // namespace detail

/// A polytropic gas with a named exponent \f$\gamma = power/root\f$, by roots:
/// \f$U = \frac{K}{\gamma-1}J^{1-\gamma}\f$, \f$U' = -KJ^{-\gamma}\f$.
///
/// `<1, 2>` has \f$\gamma = 2\f$, `<3, 5>` 5/3, `<5, 7>` 7/5, `<3, 4>` 4/3, `<2, 3>` 3/2. With `<1, 2m + 1>`
/// and \f$K = \mu\f$ it is the volume part of Blatz and Ko's solid, `PowerVolume<m>`. Accuracy of the slope
/// in lanes: (power + 2) units in the last place.
template <int root, int power>
struct PolytropicByRoots {
  static_assert(root > 0 && power > root);
  static constexpr bool in_lanes = true;                              ///< slopes come four at a time
  static constexpr double gamma = static_cast<double>(power) / root;  ///< the exponent, above 1
  double K;  ///< pressure over mass density at J = 1, speed squared; positive

  /// U, speed squared.
  template <class T>
  T energy(T const& J) const {
    return (K / (gamma - 1)) * detail::power_of<power - root>(detail::inverse_root<root>(J));
  }
  /// \f$U'\f$, speed squared.
  template <class T>
  [[gnu::always_inline]] T slope(T const& J) const {
    return -K * detail::power_of<power>(detail::inverse_root<root>(J));
  }
  /// \f$U'\f$ at four corners.
  template <class T>
  [[gnu::always_inline]] void slopes(T const (&J)[4], T (&out)[4]) const {
    if constexpr (root == 1) {
      T y[4];
      detail::reciprocals(J, y);
#pragma GCC unroll 4
      for (int k = 0; k < 4; ++k) out[k] = -K * detail::power_of<power>(y[k]);
    } else {
      detail::slopes_together(*this, J, out);
    }
  }
  /// \f$U+m\log J\f$ from \f$\log J\f$, without loss where that is small and m is K; but for the constant
  /// \f$K/(\gamma-1)\f$.
  double energy_beyond(double m, double, double log) const {
    return K / (gamma - 1) * (1 + exponential_beyond_line((1 - gamma) * log)) + (m - K) * log;
  }
  /// \f$JU'+m\f$, likewise.
  double slope_beyond(double m, double, double log) const {
    return (m - K) - K * std::expm1((1 - gamma) * log);
  }
  /// In lanes: the root after the first of two rounds.
  [[gnu::always_inline]] detail::Fourfold first_half(detail::Fourfold const& J) const
    requires(root > 1)
  {
    return detail::first_root<root>(J);
  }
  /// In lanes: \f$U'\f$ from that, speed squared.
  [[gnu::always_inline]] detail::Fourfold second_half(detail::Fourfold const& J,
                                                      detail::Fourfold const& y) const {
    return detail::second_power<root, power>(-K, J, y);
  }
  /// The law whose slope at a J is `weight` times \f$U'(J/unit)\f$.
  PolytropicByRoots scaled(double unit, double weight) const { return {weight * K * std::pow(unit, gamma)}; }
};

/// A polytropic gas with any exponent: \f$U = \frac{K}{\gamma-1}J^{1-\gamma}\f$, \f$U' = -KJ^{-\gamma}\f$.
///
/// Accuracy of the slope in lanes: \f$(4+5\gamma|\log J|)\f$ units in the last place.
struct PolytropicGas {
  static constexpr bool in_lanes = true;  ///< slopes come four at a time
  double K;                               ///< pressure over mass density at J = 1, speed squared; positive
  double gamma;                           ///< exponent, above 1: the ratio of the specific heats, 1.4 for air

  /// U, speed squared.
  template <class T>
  T energy(T const& J) const {
    using std::exp, std::log;
    return (K / (gamma - 1)) * exp((1 - gamma) * log(J));
  }
  /// \f$U'\f$, speed squared.
  template <class T>
  [[gnu::always_inline]] T slope(T const& J) const { return second_half(J, first_half(J)); }
  /// \f$U'\f$ at four corners.
  template <class T>
  [[gnu::always_inline]] void slopes(T const (&J)[4], T (&out)[4]) const {
    detail::slopes_together(*this, J, out);
  }
  /// \f$\log_2J^{-\gamma}\f$.
  template <class T>
  [[gnu::always_inline]] T first_half(T const& J) const { return -gamma * detail::log2(J); }
  /// \f$U'\f$ from that, speed squared.
  template <class T>
  [[gnu::always_inline]] T second_half(T const&, T const& log_of_power) const {
    return -K * detail::exp2(log_of_power);
  }
  /// The law whose slope at a J is `weight` times \f$U'(J/unit)\f$.
  PolytropicGas scaled(double unit, double weight) const {
    return {weight * K * std::pow(unit, gamma), gamma};
  }
};

/// The volume part of a neo-Hookean solid: \f$U = -\mu\log J+\tfrac\lambda2\log^2J\f$,
/// \f$U' = (\lambda\log J-\mu)/J\f$.
///
/// Accuracy of the slope in lanes: 8 units in the last place of \f$(\mu+\lambda|\log J|)/J\f$.
struct LogarithmicLaw {
  static constexpr bool in_lanes = true;  ///< slopes come four at a time
  double lambda;  ///< Lame's first modulus over the mass density, speed squared; zero or more
  double mu;      ///< shear modulus over the mass density, speed squared; that of its solid

  /// U, speed squared.
  template <class T>
  T energy(T const& J) const {
    using std::log;
    T const l = log(J);
    return l * (lambda / 2 * l - mu);
  }
  /// \f$U'\f$, speed squared.
  template <class T>
  [[gnu::always_inline]] T slope(T const& J) const { return second_half(J, first_half(J)); }
  /// \f$U'\f$ at four corners.
  template <class T>
  [[gnu::always_inline]] void slopes(T const (&J)[4], T (&out)[4]) const {
    detail::slopes_together(*this, J, out);
  }
  /// \f$\log_2J\f$.
  template <class T>
  [[gnu::always_inline]] T first_half(T const& J) const { return detail::log2(J); }
  /// \f$U'\f$ from that, speed squared.
  template <class T>
  [[gnu::always_inline]] T second_half(T const& J, T const& log) const {
    return (lambda * std::numbers::ln2 * log - mu) * detail::reciprocal(J);
  }
  /// \f$U+m\log J\f$ from \f$J-1\f$ and \f$\log J\f$, without loss where these are small and m is \f$\mu\f$.
  double energy_beyond(double m, double, double log) const { return (lambda / 2 * log + (m - mu)) * log; }
  /// \f$JU'+m\f$, likewise.
  double slope_beyond(double m, double, double log) const { return lambda * log + (m - mu); }
  /// The law whose slope at a J is `weight` times \f$U'(J/unit)\f$.
  LogarithmicLaw scaled(double unit, double weight) const {
    return {weight * lambda * unit, weight * unit * (mu + lambda * std::log(unit))};
  }
};

/// \f$U = \tfrac b2(J-1)^2+(b-c)J-a\log J\f$, \f$U' = bJ-a/J-c\f$: with a the shear modulus and b = c that
/// of the volume it is the part of a neo-Hookean solid that knows the volume, free of stress at rest.
///
/// Accuracy of the slope in lanes: 4 units in the last place of \f$a/J+bJ+|c|\f$.
struct ReciprocalLaw {
  static constexpr bool in_lanes = true;  ///< slopes come four at a time
  double a;  ///< of the logarithm, a modulus over the mass density, speed squared; positive
  double b;  ///< of the square, a modulus over the mass density, speed squared; positive
  double c;  ///< of J, a modulus over the mass density, speed squared

  /// U, speed squared.
  template <class T>
  T energy(T const& J) const {
    using std::log;
    return 0.5 * b * ((J - 1.0) * (J - 1.0)) + (b - c) * J - a * log(J);
  }
  /// \f$U'\f$, speed squared.
  template <class T>
  [[gnu::always_inline]] T slope(T const& J) const { return T(b) * J - T(a) / J - T(c); }
  /// \f$U'\f$ at four corners.
  template <class T>
  [[gnu::always_inline]] void slopes(T const (&J)[4], T (&out)[4]) const {
    T y[4];
    detail::reciprocals(J, y);
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) out[k] = (T(b) * J[k] - T(c)) - T(a) * y[k];
  }
  /// \f$U+m\log J\f$ from \f$j = J-1\f$ and \f$\log J\f$, without loss where these are small, m is a, and b
  /// is c.
  double energy_beyond(double m, double j, double log) const {
    return b / 2 * j * j + (b - c) * (1 + j) + (m - a) * log;
  }
  /// \f$JU'+m\f$, likewise.
  double slope_beyond(double m, double j, double) const { return (1 + j) * (b * j + (b - c)) + (m - a); }
  /// The law whose slope at a J is `weight` times \f$U'(J/unit)\f$.
  ReciprocalLaw scaled(double unit, double weight) const {
    return {weight * a * unit, weight * b / unit, weight * c};
  }
};

namespace detail {
/// A law of the reader's own, in cells of some size: number by number.
template <class Law>
struct ScaledLaw {
  Law law;
  double inverse_unit, weight;
  template <class T>
  void slopes(T const (&J)[4], T (&out)[4]) const {
    for (int k = 0; k < 4; ++k) out[k] = weight * law.slope(T(J[k] * inverse_unit));
  }
  [[gnu::always_inline]] void slopes(Quad const (&J)[4], Quad (&out)[4]) const {
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 4; ++i) {
        double const one = J[k].lane[i] * inverse_unit;
        out[k].lane[i] = weight * law.template slope<double>(one);
      }
  }
};
/// The law whose slope at a J is `weight` times \f$U'(J/unit)\f$.
template <class Law>
auto scaled(Law const& law, double unit, double weight) {
  if constexpr (InLanes<Law>)
    return law.scaled(unit, weight);
  else
    return ScaledLaw<Law>{law, 1 / unit, weight};
}
}  // namespace detail

}  // namespace actio::media
