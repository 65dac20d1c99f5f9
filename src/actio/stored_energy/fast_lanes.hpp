// Four doubles in the lanes of one SIMD register, and what the optimised implementation of media needs of
// them.
//
// The vectors are those of the compiler (GNU extension): a Quad is one register of AVX2, or two of SSE2. A
// kernel is a function object whose call is always inlined, and so is all that it calls; `run_with` compiles
// it three times: for the plain machine, for AVX2 with fused multiplication, and for AVX-512, of which twice
// as many registers of the same four lanes are used. A cell in space has more numbers than sixteen registers
// hold, and with thirty-two a step of it takes five sixths of the time. Arguments go by reference: by value
// the three would not agree on where they are. And what is stored is aligned by hand: a plain compiler aligns
// vectors to sixteen bytes alone.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace actio::media {

/// For which registers a kernel of the optimised implementation is compiled.
enum class Registers {
  plain,  ///< those of the machine that the compiler was told, on x86-64 two lanes
  avx2,   ///< sixteen of four lanes, and fused multiplication
  avx512  ///< thirty-two of these
};

/// Those that this machine has, the best last.
std::vector<Registers> usable_registers();
/// The best that this machine has.
inline Registers best_registers() {
  static Registers const best = usable_registers().back();
  return best;
}
/// Their name, for people.
inline std::string name_of(Registers registers) {
  return registers == Registers::plain ? "baseline" : registers == Registers::avx2 ? "AVX2" : "AVX-512";
}

namespace detail {

/// Four doubles.
struct Quad {
  using Vector [[gnu::vector_size(32)]] = double;      ///< what the compiler calls them
  using Bits [[gnu::vector_size(32)]] = std::int64_t;  ///< the same registers as integers, and truth by lanes
  alignas(32) Vector lane;                             ///< the numbers

  Quad() = default;
  // Written out, or the compiler copies records of them by halves and through memory.
  [[gnu::always_inline]] Quad(Quad const& x) : lane(x.lane) {}
  [[gnu::always_inline]] Quad& operator=(Quad const& x) {
    lane = x.lane;
    return *this;
  }
  /// The same number in all lanes.
  [[gnu::always_inline]] Quad(double x) : lane(x - Vector{}) {}
  /// These numbers.
  [[gnu::always_inline]] explicit Quad(Vector const& x) : lane(x) {}
  /// The numbers that have these bits.
  [[gnu::always_inline]] explicit Quad(Bits const& x) : lane(reinterpret_cast<Vector>(x)) {}

  [[gnu::always_inline]] friend Quad operator+(Quad const& x, Quad const& y) { return Quad(x.lane + y.lane); }
  [[gnu::always_inline]] friend Quad operator-(Quad const& x, Quad const& y) { return Quad(x.lane - y.lane); }
  [[gnu::always_inline]] friend Quad operator*(Quad const& x, Quad const& y) { return Quad(x.lane * y.lane); }
  [[gnu::always_inline]] friend Quad operator/(Quad const& x, Quad const& y) { return Quad(x.lane / y.lane); }
  [[gnu::always_inline]] friend Quad operator-(Quad const& x) { return Quad(-x.lane); }
};

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

#if defined(__x86_64__) && defined(__GNUC__)
template <class Kernel>
[[gnu::target("avx2,fma")]] void run_with_avx2(Kernel& kernel) { kernel(); }
template <class Kernel>
[[gnu::target("avx2,fma,avx512f,avx512vl,avx512dq,avx512bw")]] void run_with_avx512(Kernel& kernel) {
  kernel();
}
#else
template <class Kernel>
void run_with_avx2(Kernel& kernel) { kernel(); }
template <class Kernel>
void run_with_avx512(Kernel& kernel) { kernel(); }
#endif
template <class Kernel>
void run_with_plain(Kernel& kernel) { kernel(); }

/// Runs a kernel, compiled for these registers. Its call operator must be always_inline.
template <class Kernel>
void run_with(Registers registers, Kernel& kernel) {
  if (registers == Registers::avx512)
    run_with_avx512(kernel);
  else if (registers == Registers::avx2)
    run_with_avx2(kernel);
  else
    run_with_plain(kernel);
}

}  // namespace detail
}  // namespace actio::media
