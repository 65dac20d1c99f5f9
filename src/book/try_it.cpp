// Snippets are run one after the other; what each prints is shown and kept.
#include "book/try_it.hpp"

namespace book {

int run_tries(int argc, char** argv, char const* shows) {
  Program program(argc, argv, shows);
  for (auto const& snippet : tries()) {
    std::ostringstream said;
    auto* const terminal = std::cout.rdbuf(said.rdbuf());
    std::string error;
    try {
      snippet.run();
    } catch (std::exception const& e) {
      error = e.what();
    }
    std::cout.rdbuf(terminal);
    program.say("-- ", snippet.name);
    std::cout << said.str();
    program.snippet(snippet.name, said.str());
    program.claim(error.empty() && !said.str().empty(),
                  std::string(snippet.name) +
                      (error.empty() ? " runs and prints something" : " does not fail with: " + error));
  }
  program.headline(text(tries().size(), " snippets run"), static_cast<double>(tries().size()));
  return program.finish();
}

}  // namespace book
