// Code that is compiled three times: for the plain machine, for AVX2 with fused multiplication, and for
// AVX-512; and run where the machine can.
//
// Kernels are function objects whose call is always inlined, and so is all that they call. Arguments go by
// reference: by value the three would not agree on where they are.
#pragma once

#include <string>
#include <vector>

namespace actio {

/// For which registers a kernel is compiled.
enum class Registers {
  plain,  ///< those of the machine that the compiler was told, on x86-64 two lanes
  avx2,   ///< sixteen of four lanes, and fused multiplication
  avx512  ///< thirty-two, of up to eight lanes
};

/// Those that this machine has, the best last.
std::vector<Registers> usable_registers();
/// The best that this machine has, of those that \ref use_at_most has left.
Registers best_registers();
/// From now on none that are better. Machines that share a run use what the least of them has, since others
/// round differently. Not while others ask for the best.
void use_at_most(Registers most);
/// Their name, for people.
inline std::string name_of(Registers registers) {
  return registers == Registers::plain ? "baseline" : registers == Registers::avx2 ? "AVX2" : "AVX-512";
}

namespace detail {
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
}  // namespace detail

/// Runs a kernel, compiled for these registers. Its call operator must be always_inline.
template <class Kernel>
void run_with(Registers registers, Kernel& kernel) {
  if (registers == Registers::avx512)
    detail::run_with_avx512(kernel);
  else if (registers == Registers::avx2)
    detail::run_with_avx2(kernel);
  else
    detail::run_with_plain(kernel);
}

}  // namespace actio
