// What the processes of a run have in common before they begin.
#pragma once

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "actio/numbers/registers.hpp"
#include "program/base/progress.hpp"
#include "program/base/ranks.hpp"
#include "program/document/input_files.hpp"

namespace actio::app {

/// What one of them is, and where.
struct RankKind {
  std::uint64_t program = 0;  ///< fingerprint of its executable; 0 where that cannot be read
  std::uint64_t host = 0;     ///< of the name of its machine
  cpu_set_t cores{};          ///< on which it may run
  Registers registers = best_registers();
  bool known = true;  ///< whether those that its environment names are any

  /// This one. The environment variable ACTIO_REGISTERS says that it is to use no better registers than
  /// those: baseline, AVX2 or AVX-512.
  static RankKind own() {
    RankKind out;
    std::ifstream file("/proc/self/exe", std::ios::binary);
    if (file) out.program = scene::fingerprint_of(std::string{std::istreambuf_iterator<char>(file), {}});
    char name[256] = "";
    ::gethostname(name, sizeof name - 1);
    out.host = scene::fingerprint_of(name);
    ::sched_getaffinity(0, sizeof out.cores, &out.cores);
    if (char const* const said = std::getenv("ACTIO_REGISTERS")) {
      out.known = false;
      for (Registers const one : {Registers::plain, Registers::avx2, Registers::avx512})
        if (name_of(one) == said) out.known = true, out.registers = std::min(out.registers, one);
    }
    return out;
  }
  /// Whether both have the same cores.
  bool beside(RankKind const& other) const { return host == other.host && CPU_EQUAL(&cores, &other.cores); }
};

/// Before a run: all ranks use the registers of the least of them, and each as many threads as are its part
/// of the cores. Rank 0 tells what its user does not expect.
/// @return whether all are one program that can run; otherwise rank 0 has told why not
inline bool agree_on_run(Ranks& ranks) {
  std::vector<RankKind> const all = all_of(ranks, RankKind::own());
  auto const tell = [&](std::string const& line) {
    if (ranks.rank() == 0) scene::say(stderr, "actio-mpi: " + line + "\n");
  };
  auto const number = [&](auto const& one) { return std::to_string(&one - all.data()); };
  for (auto const& one : all)
    if (one.program != all[0].program)
      return tell("the program of rank " + number(one) +
                  " is not that of rank 0, and would round differently; all ranks need the same file"),
             false;
  for (auto const& one : all)
    if (!one.known)
      return tell("rank " + number(one) + ": ACTIO_REGISTERS must be baseline, AVX2 or AVX-512"), false;
  auto const& least = *std::ranges::min_element(all, {}, &RankKind::registers);
  if (least.registers < all[0].registers)
    tell("all ranks use registers of the kind " + name_of(least.registers) + ", since rank " + number(least) +
         " has no better ones; rank 0 has " + name_of(all[0].registers));
  use_at_most(least.registers);
  auto const& own = all[static_cast<std::size_t>(ranks.rank())];
  auto const beside = std::ranges::count_if(all, [&](auto const& one) { return own.beside(one); });
  int const cores = std::max(1, CPU_COUNT(&own.cores) ? CPU_COUNT(&own.cores) : scene::cores_of_this_rank());
  scene::cores_of_this_rank() = std::max(1, cores / static_cast<int>(beside));
  bool const crowded = beside > cores;
  if (ranks.any(crowded))
    tell((crowded ? std::to_string(beside) + " ranks share " + std::to_string(cores) + " cores"
                  : std::string("another machine has more ranks than cores")) +
         ", and wait for each other: as many ranks as cores are faster");
  return true;
}

}  // namespace actio::app
