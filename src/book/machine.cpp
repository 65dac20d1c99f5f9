// What a system tells of its machine.
#include "book/machine.hpp"

#include <fstream>

namespace book {

std::string processor_name() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name")) {
      auto const at = line.find_first_not_of(" \t", line.find(':') + 1);
      if (at != std::string::npos) return line.substr(at);
    }
  return "unknown";
}

std::string vector_instructions() {
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f")) return "AVX-512";
  if (__builtin_cpu_supports("avx2")) return __builtin_cpu_supports("fma") ? "AVX2 with FMA" : "AVX2";
  return __builtin_cpu_supports("avx") ? "AVX" : "SSE2";
#else
  return "unknown";
#endif
}

std::string date_of(std::time_t time) {
  std::tm parts{};
  gmtime_r(&time, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &parts);
  return text;
}

void report_machine(Program& program, Machine const& m) {
  std::time_t const now = std::time(nullptr);
  std::string const date = date_of(now) + " UTC";
  program.table("machine", {"", "measured on"},
                {{"processor", m.processor + ", " + std::to_string(m.cores) + " cores"},
                 {"vector instructions", m.vectors},
                 {"compiler", m.compiler},
                 {"flags", m.flags},
                 {"run", date}});
  program.figure("processor", m.cores, m.processor, "processor");
  program.figure("date", static_cast<double>(now), date, "run");
}

}  // namespace book
