#include "actio/fast_body/machine.hpp"

namespace actio::bodies {

Machine best_machine() {
#if ACTIO_AVX2
  static bool const able = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (able) return Machine::avx2;
#endif
  return Machine::plain;
}

}  // namespace actio::bodies
