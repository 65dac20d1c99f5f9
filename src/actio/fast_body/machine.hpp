// Code that is compiled twice, for the plain machine and for AVX2 with fused multiplication, and run where
// the machine can.
//
// Kernels are function objects whose call is always inlined.
#pragma once

#include <string>

#if (defined(__x86_64__) || defined(__i386__)) && defined(__GNUC__)
#define ACTIO_AVX2 1
#define ACTIO_FOR_AVX2 [[gnu::target("avx2,fma")]]
#else
/// 1 where the compiler can be asked for AVX2 instructions in a single function.
#define ACTIO_AVX2 0
/// Before a function: it may use AVX2 and fused multiplication.
#define ACTIO_FOR_AVX2
#endif

namespace actio::bodies {

/// For which machine a kernel is compiled.
enum class Machine {
  plain,  ///< whatever the compiler was told, on x86-64 two lanes
  avx2    ///< four lanes and fused multiplication
};

/// The best that this machine can do.
Machine best_machine();
/// Its name, for people.
inline std::string name_of(Machine machine) { return machine == Machine::avx2 ? "AVX2" : "baseline"; }

namespace detail {
template <class Kernel>
ACTIO_FOR_AVX2 void run_avx2(Kernel& kernel) { kernel(); }
}  // namespace detail

/// Runs a kernel, compiled for this machine. Its call operator must be always_inline.
template <class Kernel>
void run_on_best_machine(Kernel& kernel) {
  if (ACTIO_AVX2 && best_machine() == Machine::avx2)
    detail::run_avx2(kernel);
  else
    kernel();
}

}  // namespace actio::bodies
