// The reader of scenes, fed for ten minutes with what a fuzzer makes of scenes, good and bad
// (tests/fuzz/scene_reader.cpp says what must hold of every input).
//
// ACTIO_FUZZ_SECONDS is another time, ACTIO_FUZZ_SEED another seed. What it finds is kept in the folder that
// it names.
#include <sys/wait.h>

#include <cstdio>

#include "book/program.hpp"

namespace {

/// The number after a word, where a line has it.
double number_after(std::string const& line, std::string const& word, double otherwise) {
  auto const at = line.find(word);
  return at == std::string::npos ? otherwise : std::stod(line.substr(at + word.size()));
}

}  // namespace

int main(int argc, char** argv) {
  book::Program program(argc, argv, "the reader of scenes is fed with anything, and answers");
  auto const folder = std::filesystem::absolute(argv[0]).parent_path().parent_path() / "fuzz";
  std::string const command = "bash '" ACTIO_DATA "/../tests/fuzz/fuzz.sh' '" + folder.string() + "' 2>&1";
  std::FILE* const said = ::popen(command.c_str(), "r");
  if (!said) return 1;
  double executions = 0, places = 0;
  std::string line;
  for (int c = 0; (c = std::fgetc(said)) != EOF;) {
    if (c != '\n') {
      line += static_cast<char>(c);
      continue;
    }
    executions = number_after(line, "number_of_executed_units:", executions);
    places = number_after(line, "cov: ", places);
    program.say(line);
    line.clear();
  }
  int const status = ::pclose(said);
  program.figure("executions", executions, "inputs that were fed");
  program.figure("places", places, "places of the program that they reached");
  program.claim(executions > 1000, "more than a thousand inputs were fed");
  program.claim(WIFEXITED(status) && WEXITSTATUS(status) == 0,
                "nothing was found; what is, is in " + (folder / "found").string());
  program.headline(book::number(executions, 3) + " inputs were fed", executions);
  return program.finish();
}
