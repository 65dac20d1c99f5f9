// Lines to try: snippets of a chapter that a reader can paste. Each is compiled and run by the build, and the
// book shows it with what it printed.
//
//   #include "actio/numbers/print.hpp"
//   TRY_IT(relative_motion) {
//     auto const f = relative_motion_right(g0, g1);
//     print("f", f);
//   }
//   TRY_IT_MAIN("the lines to try of chapter 3")
#pragma once

#include <exception>
#include <vector>

#include "book/program.hpp"

namespace book {

/// One snippet: its name, and what runs it.
struct TryIt {
  char const* name;  ///< under which a page shows it
  void (*run)();     ///< the lines
};

/// The snippets of the program, in the order of its text.
inline std::vector<TryIt>& tries() {
  static std::vector<TryIt> all;
  return all;
}
/// Runs all snippets and reports what each printed; an exception that leaves one fails the program.
/// @return  what `main` returns
int run_tries(int argc, char** argv, char const* shows);

}  // namespace book

/// A snippet by the name under which a page shows it.
#define TRY_IT(name)                                                                          \
  static void try_##name();                                                                   \
  static bool const registered_##name = (book::tries().push_back({#name, try_##name}), true); \
  static void try_##name()

/// The program: what it shows, in a line.
#define TRY_IT_MAIN(shows) \
  int main(int argc, char** argv) { return book::run_tries(argc, argv, shows); }
