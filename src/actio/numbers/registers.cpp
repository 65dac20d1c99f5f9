#include "actio/numbers/registers.hpp"

#include <algorithm>

namespace actio {
namespace {
Registers& best() {
  static Registers registers = usable_registers().back();
  return registers;
}
}  // namespace

std::vector<Registers> usable_registers() {
  std::vector<Registers> all{Registers::plain};
#if defined(__x86_64__) && defined(__GNUC__)
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) return all;
  all.push_back(Registers::avx2);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw"))
    all.push_back(Registers::avx512);
#endif
  return all;
}

Registers best_registers() { return best(); }
void use_at_most(Registers most) { best() = std::min(best(), most); }

}  // namespace actio
