// Four doubles in the lanes of one SIMD register, and what the optimised implementation of media needs of
// them.
//
// A Quad is one register of AVX2, or two of SSE2; AVX-512 has twice as many registers of the same four
// lanes. A cell in space has more numbers than sixteen registers hold, and with thirty-two a step of it takes
// five sixths of the time. What is stored is aligned by hand: a plain compiler aligns vectors to sixteen
// bytes alone.
#pragma once

#include "actio/numbers/pack.hpp"
#include "actio/numbers/registers.hpp"

namespace actio::media {

using actio::best_registers;
using actio::name_of;
using actio::Registers;
using actio::usable_registers;

namespace detail {

using actio::run_with;

/// Four doubles.
using Quad = Pack<4>;

/// x where the mask is true, else y, lane by lane.
[[gnu::always_inline]] inline Quad chosen(Quad::Bits const& mask, Quad const& x, Quad const& y) {
  return Quad(mask ? x.lane : y.lane);
}
/// Each number one lane further; the last one comes first.
[[gnu::always_inline]] inline Quad turned_up(Quad const& x) {
  return Quad(__builtin_shufflevector(x.lane, x.lane, 3, 0, 1, 2));
}
/// Each number one lane back; the first one comes last.
[[gnu::always_inline]] inline Quad turned_down(Quad const& x) {
  return Quad(__builtin_shufflevector(x.lane, x.lane, 1, 2, 3, 0));
}
/// Sets the sign bits in `seen` that are set in any of four registers.
[[gnu::always_inline]] inline void note_signs(Quad::Bits& seen, Quad const (&d)[4]) {
  seen |= (reinterpret_cast<Quad::Bits>(d[0].lane) | reinterpret_cast<Quad::Bits>(d[1].lane)) |
          (reinterpret_cast<Quad::Bits>(d[2].lane) | reinterpret_cast<Quad::Bits>(d[3].lane));
}
/// Whether any lane of a mask is true.
[[gnu::always_inline]] inline bool any(Quad::Bits const& mask) {
  return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
}
/// Whether the sign bit is set in any lane.
[[gnu::always_inline]] inline bool any_sign(Quad::Bits const& bits) {
  return (bits[0] | bits[1] | bits[2] | bits[3]) < 0;
}

}  // namespace detail
}  // namespace actio::media
