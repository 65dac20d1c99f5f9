// Motions of rods that are known exactly, in the continuum and as the scheme of src/actio/rods has them.
//
// A helix that turns. With an angle f = c s + a t about the axis, er, et, ez along the radius, the circle and
// the axis, and axes of the section that lean by psi from the circle,
//
//     x = r er + p s ez,      d1 = cos(psi) et + sin(psi) ez,      d2 = -er,      d3 = d1 x d2,
//
// all sections have the strains Gamma = R^T (r c et + p ez) and kappa = c R^T ez, and turn by a R^T ez.
// Forces and moments balance along the radius where
//
//     c N_t = rho A a^2 r,        c M_t - (c r N_z - p N_t) = a L_t
//
// for N = R C_N (Gamma - Gamma0), M = R C_M kappa and L = a R J R^T ez: the first condition is linear in r
// and p, the second one quadratic. Of a rod that is straight at rest.
//
// In steps. Cayley's map bends elements about half their angles, so that their strains are those of the
// continuum with (2/D) tan(c D/2) in place of c; what a section's momenta change by in a step is that of the
// continuum with (2/h) sin(a h/2) in place of a. All terms of both conditions change in this way and in no
// other. So a discrete helix has the radius and the pitch of a helix with these numbers: orders 2 in D and h.
#pragma once

#include <cmath>

#include "actio/rods/rod.hpp"
#include "actio/rods/step_limit.hpp"

namespace actio::rods {

/// A helix that turns about its axis, the third one of space.
struct RotatingHelix {
  double turn,  ///< c, angle about the axis by length of the rod
      lean,     ///< \f$\psi\f$
      rate,     ///< a, angle about the axis by time
      radius,   ///< r, length
      pitch;    ///< p, along the axis by length of the rod

  /// In the continuum, the one that is next to the rod without forces. In steps with `c` and `a` replaced.
  /// @param c,a  that the balance is for
  static RotatingHelix balanced(RodSection const& section, double turn, double lean, double rate, double c,
                                double a) {
    double const cs = std::cos(lean), sn = std::sin(lean);
    auto const &C = section.stretching, &B = section.bending, &J = section.inertia;
    // N_t = u + v r + w p, and rho A a^2 r = c N_t gives r = r0 + r1 p.
    double const u = -C[0] * cs, v = c * (C[0] * cs * cs + C[2] * sn * sn), w = (C[0] - C[2]) * sn * cs,
                 rest = section.mass * a * a / c - v, r0 = u / rest, r1 = w / rest;
    double const t0 = u + v * r0, t1 = w + v * r1;
    // N_z = -C0 sn + (C0 - C2) sn cs c r + (C0 sn^2 + C2 cs^2) p.
    double const z0 = -C[0] * sn + w * c * r0, z1 = C[0] * sn * sn + C[2] * cs * cs + w * c * r1;
    double const moments = (c * c * (B[0] - B[2]) - a * a * (J[0] - J[2])) * sn * cs;
    // moments = c (r0 + r1 p)(z0 + z1 p) - p (t0 + t1 p)
    double const q2 = c * r1 * z1 - t1, q1 = c * (r0 * z1 + r1 * z0) - t0, q0 = c * r0 * z0 - moments;
    double const root = std::sqrt(q1 * q1 - 4 * q2 * q0);
    double const one = -2 * q0 / (q1 + std::copysign(root, q1)), two = q0 / q2 / one;
    // Without forces p = sin(psi).
    double const p = std::abs(one - sn) < std::abs(two - sn) ? one : two;
    return {turn, lean, rate, r0 + r1 * p, p};
  }
  /// In the continuum.
  static RotatingHelix of(RodSection const& section, double turn, double lean, double rate) {
    return balanced(section, turn, lean, rate, turn, rate);
  }
  /// In steps h, with elements of length D.
  static RotatingHelix in_steps(RodSection const& section, double turn, double lean, double rate, double D,
                                double h) {
    return balanced(section, turn, lean, rate, 2 / D * std::tan(turn * D / 2),
                    2 / h * std::sin(rate * h / 2));
  }

  /// The section at a length from the start, at a time.
  Placement at(double s, double t) const {
    double const angle = turn * s + rate * t;
    // At the angle zero: a quarter turn about the axis of the helix, and psi about that of the section.
    Four<double> const quarter{std::sqrt(0.5), 0, 0, std::sqrt(0.5)},
        leaning{std::cos(lean / 2), 0, -std::sin(lean / 2), 0},
        along{std::cos(angle / 2), 0, 0, std::sin(angle / 2)};
    return {{radius * std::cos(angle), radius * std::sin(angle), pitch * s},
            bodies::compose(bodies::compose(along, quarter), leaning)};
  }
  /// How a rod begins that is to move like this in steps h. Its first step has half a kick, so that its
  /// velocities are means of those before and after.
  /// @param sections  at distances D
  /// @param closed    whether the last one is followed by the first one
  RodStart start(int sections, double D, double h, bool closed = false) const {
    RodStart out;
    out.shape.closed = closed;
    double const mean = std::sin(rate * h) / h;
    for (int k = 0; k < sections; ++k) {
      auto const [place, attitude] = at(k * D, 0);
      out.shape.places.push_back(place), out.shape.attitudes.push_back(attitude);
      out.velocity.push_back({-mean * place[1], mean * place[0], 0});
      out.angular_velocity.push_back({mean * std::sin(lean), 0, mean * std::cos(lean)});
    }
    return out;
  }
  /// Ends that are moved along.
  /// @param length  of the rod
  RodLoads moved_ends(double length) const {
    RodLoads out;
    out.start.held = out.end.held = RodEnd::Held::clamped;
    out.start.motion = [*this](double t) { return at(0, t); };
    out.end.motion = [*this, length](double t) { return at(length, t); };
    return out;
  }
  /// How far a rod is from it: the largest component of places and attitudes.
  double distance(RodFrame const& frame, double D, double t) const {
    double out = 0;
    for (std::size_t k = 0; k < frame.places.size(); ++k) {
      auto const [place, attitude] = at(static_cast<double>(k) * D, t);
      double sign = 0;
      for (std::size_t i = 0; i < 4; ++i) sign += attitude[i] * frame.attitudes[k][i];
      for (std::size_t i = 0; i < 3; ++i) out = std::max(out, std::abs(place[i] - frame.places[k][i]));
      for (std::size_t i = 0; i < 4; ++i)
        out = std::max(out, std::abs(std::copysign(attitude[i], attitude[i] * sign) - frame.attitudes[k][i]));
    }
    return out;
  }
};

/// The radius of a ring that spins about its axis, like a helix without pitch.
/// @param at_rest  its radius at rest, r0
/// @param rate     a, angle by time; in steps (2/h) sin(a h/2)
/// @return  \f$r_0/(1-\rho A\,a^2r_0^2/EA)\f$, for any number of elements
inline double spinning_radius(RodSection const& section, double at_rest, double rate) {
  return at_rest / (1 - section.mass * rate * rate * at_rest * at_rest / section.stretching[0]);
}

/// A small wave of shear and bending in the plane of the first two axes, along a straight rod whose ends are
/// pinned. Displacements are A sin(k s) cos(w t), turns of sections B cos(k s) cos(w t).
struct PinnedWave {
  RodSection section;  ///< of the rod
  double length;       ///< of the rod
  int elements,        ///< of it
      mode;            ///< half waves along it
  bool upper;          ///< whether it is of the faster branch

  double element() const { return length / elements; }    ///< D
  double number() const { return M_PI * mode / length; }  ///< k
  /// \f$\Omega^2\f$ by the formula in steps.
  double squared() const { return RodWaves{section, element()}.bending(3, number())[upper ? 1 : 0]; }
  /// w, in steps h.
  double frequency(double h) const { return 2 / h * std::asin(std::sqrt(squared()) * h / 2); }
  /// w of Timoshenko's beam.
  double of_beam() const {
    double const k = number(), a = section.stretching[1] * k * k / section.mass,
                 b = (section.bending[2] * k * k + section.stretching[1]) / section.inertia[2],
                 d = section.stretching[1] * section.bending[2] * k * k * k * k / section.mass /
                     section.inertia[2],
                 sum = (a + b) / 2 + std::sqrt((a + b) * (a + b) / 4 - d);
    return std::sqrt(upper ? sum : d / sum);
  }
  /// B/A.
  double turns() const {
    double const K = 2 / element() * std::sin(number() * element() / 2), GA = section.stretching[1];
    return (GA * K * K - section.mass * squared()) / (GA * K * std::cos(number() * element() / 2));
  }
  /// How a rod along the first axis begins.
  RodStart start(double amplitude) const {
    RodStart out;
    for (int a = 0; a <= elements; ++a) {
      double const s = element() * a, turn = amplitude * turns() * std::cos(number() * s) / 2;
      // In the last node the sine is not zero, but rounding.
      double const across = a == elements ? 0 : amplitude * std::sin(number() * s);
      out.shape.places.push_back({s, across, 0});
      out.shape.attitudes.push_back({std::cos(turn), 0, 0, std::sin(turn)});
    }
    return out;
  }
  /// Ends that are pinned.
  static RodLoads ends() {
    RodLoads out;
    out.start.held = out.end.held = RodEnd::Held::pinned;
    return out;
  }
  /// How far a rod is from the wave, relative to its amplitude.
  double distance(RodFrame const& frame, double amplitude, double phase) const {
    double out = 0;
    for (std::size_t a = 0; a < frame.places.size(); ++a) {
      double const s = element() * static_cast<double>(a), B = turns(), c = std::cos(phase);
      out = std::max({out, std::abs(frame.places[a][1] / amplitude - std::sin(number() * s) * c),
                      std::abs(2 * frame.attitudes[a][3] / amplitude - B * std::cos(number() * s) * c) /
                          std::max(1.0, std::abs(B))});
    }
    return out;
  }
};

}  // namespace actio::rods
