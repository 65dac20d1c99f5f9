// A rod as its steps hold it: every component in a row of its own, so that neighbouring sections go through
// the same operations side by side.
//
// Rows are longer than the rod, by a multiple of the largest number of lanes. Sections beyond the end are
// those at its end once more, or the first one of a ring: an element there is not bent, and weighs nothing.
// Forces of elements have room for one before the first: what acts on the ends from outside is written there
// and behind the last one, as if elements went on.
#pragma once

#include <algorithm>
#include <vector>

#include "actio/rods/rod_element.hpp"

namespace actio::rods {

/// Components of vectors, each in a row.
template <std::size_t n>
using Rows = std::array<std::vector<double>, n>;

/// The most lanes that sweeps have.
inline constexpr std::size_t most_lanes = 8;
/// Where the force of the first element is in its row; that of the place before acts on the start.
inline constexpr std::size_t first_element = most_lanes;

/// How many numbers a row has for so many sections.
inline std::size_t row_size(std::size_t sections) { return (sections / most_lanes + 2) * most_lanes; }

/// Rows of zeros.
template <std::size_t n>
Rows<n> zero_rows(std::size_t size) {
  Rows<n> out;
  out.fill(std::vector<double>(size));
  return out;
}
/// One vector.
template <std::size_t n>
std::array<double, n> vector_at(Rows<n> const& rows, std::size_t k) {
  std::array<double, n> out;
  for (std::size_t i = 0; i < n; ++i) out[i] = rows[i][k];
  return out;
}
/// Puts one vector there.
template <std::size_t n>
void put_vector(Rows<n>& rows, std::size_t k, std::array<double, n> const& v) {
  for (std::size_t i = 0; i < n; ++i) rows[i][k] = v[i];
}

/// Linear and angular momentum in space, or what they have changed by.
struct Impulse {
  Three<double> linear{};   ///< mass x length/time
  Three<double> angular{};  ///< about the origin, mass x length^2/time

  /// Adds a linear impulse at a place.
  void add(Three<double> const& at, Three<double> const& kick) {
    linear = bodies::plus(linear, kick), angular = bodies::plus(angular, cross(at, kick));
  }
};

/// What a step changes: all that the next one depends on.
struct RodState {
  std::size_t sections = 0;  ///< without those beyond the end
  bool closed = false;       ///< whether it is a ring
  Rows<3> x,                 ///< places, length
      v,                     ///< velocities over the last step, length/time
      M;                     ///< angular momenta at the end of the last step, in the axes of the sections
  Rows<4> q;                 ///< attitudes
  Rows<3> N;                 ///< contact forces of the last step, where they are multipliers
  double step_before = 0;    ///< length of the last step, time; 0 at the start
  Impulse impulse;           ///< that came from outside since the start

  /// Brings the sections beyond the end up to date.
  void extend() {
    std::size_t const from = closed ? 0 : sections - 1;
    for (auto* const rows : {&x[0], &x[1], &x[2], &q[0], &q[1], &q[2], &q[3]})
      std::fill(rows->begin() + static_cast<std::ptrdiff_t>(sections), rows->end(), (*rows)[from]);
  }
};

/// What does not change.
struct RodConstants {
  RodSection section;                  ///< of every element and section
  std::size_t elements = 0;            ///< how many
  std::vector<double> share,           ///< length of the rod that a section stands for
      inverse_share;                   ///< of that; zero beyond the end, and at a clamped end
  std::vector<double> inverse_length;  ///< of elements; 1 beyond the end
  Rows<3> Gamma;                       ///< stretch and shears of elements at rest
  Rows<3> kappa;                       ///< twist and bends of elements at rest, 1/length
  Three<double> acceleration{};        ///< by gravity; length/time^2
};

/// What elements exert on sections: \ref ElementForce, the force in space.
struct RodForces {
  Rows<3> f;       ///< on the section before, in space; of element k at `first_element + k`, as the others
  Rows<3> first;   ///< moments on the section before, in its axes
  Rows<3> second;  ///< moments of which the section after feels the opposite, in its axes
};

}  // namespace actio::rods
