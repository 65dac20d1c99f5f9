// A benchmark: a program of the book that measures times, at full length or, with `--short`, within a few
// seconds.
//
// A short run has fewer rounds and shorter intervals, so that it can end the first build; its report says
// that it was short, and the book marks its figures. It measures whatever the full run measures, but for what
// cannot be short.
#pragma once

#include <cstring>

#include "book/machine.hpp"

namespace benchmark {

/// What `main` was given, without the word `--short`.
struct Words {
  bool is_short = false;    ///< whether it was there
  std::vector<char*> rest;  ///< the others, the name of the program first

  /// Takes the word out of the arguments of `main`.
  Words(int argc, char** argv) {
    for (int i = 0; i < argc; ++i)
      if (i && !std::strcmp(argv[i], "--short"))
        is_short = true;
      else
        rest.push_back(argv[i]);
  }
};

/// A benchmark as its reader meets it. Its report names the machine, and says whether the run was short.
class Benchmark : public book::Program {
 public:
  /// @param shows  one line: what is measured
  Benchmark(int argc, char** argv, std::string shows) : Benchmark(Words(argc, argv), std::move(shows)) {}

  /// Whether this run has to end within a few seconds.
  bool is_short() const { return short_; }
  /// The first of two lengths in a full run, the second in a short one.
  template <class Length>
  Length length(Length full, Length in_short) const { return short_ ? in_short : full; }
  /// How many rounds the contestants have: at most eleven in a short run, of which a tenth are the two best.
  int rounds(int full) const { return short_ ? std::min(full, 11) : full; }

  /// A claim about a measured time. In a short run it is shown, and a time beyond it is no failure.
  void claim_of_time(bool holds, std::string const& what) {
    short_ ? judge(holds, what) : claim(holds, what);
  }

 private:
  Benchmark(Words words, std::string shows)
      : Program(static_cast<int>(words.rest.size()), words.rest.data(), std::move(shows)),
        short_(words.is_short) {
    property("short", short_ ? "true" : "false");
    book::report_machine(*this);
  }

  bool short_;
};

}  // namespace benchmark
