// Scenes of media for the tests of the command.
#pragma once

#include <boost/test/unit_test.hpp>

#include <stdexcept>

#include "command.hpp"

namespace command {

/// A scene of a medium: parts of it, changed one by one.
struct Medium {
  std::string kind = "barotropic_fluid",
              mesh =
                  "shape = \"box\", lower = [0, 0], upper = [1, 0.25], cells = "
                  "[32, 8], periodic = [true, true]",
              material = "name = \"polytropic_gas\", K = 1, gamma = 3", system = "", initial = "",
              method = "", until = "0.2", every = "0.1", quantities = "\"energy\"", output = "";
  std::string text() const {
    return "[system]\nkind = \"" + kind + "\"\nmesh = { " + mesh + " }\nmaterial = { " + material + " }\n" +
           system + "\n[initial]\n" + initial + "\n[method]\n" + method + "\n[run]\nuntil = " + until + "\n" +
           (every.empty() ? "" : "every = " + every + "\n") + "[output]\nquantities = [" + quantities +
           "]\n" + output + "\n";
  }
};

/// Runs it into `out` of the folder and reads its table.
inline Table run_in(Folder const& folder, Medium const& scene) {
  auto const outcome =
      actio({"run", folder.write("medium.toml", scene.text()), "--out", folder / "out", "--force"});
  if (outcome.status != 0) throw std::runtime_error(outcome.err);
  return read_csv(folder / "out/series.csv");
}
/// What is told of a run of it beforehand.
inline std::string plan_of(Medium const& scene) {
  Folder const folder;
  auto const outcome = actio({"run", folder.write("medium.toml", scene.text()), "--dry-run"});
  BOOST_TEST(outcome.status == 0, outcome.err);
  return outcome.out;
}
/// That it ends like this.
inline void check_ends(Medium const& scene, int status, std::string const& says, bool dry = true) {
  Folder const folder;
  std::vector<std::string> arguments{"run", folder.write("medium.toml", scene.text())};
  if (dry) arguments.emplace_back("--dry-run");
  auto const outcome = actio(arguments);
  BOOST_TEST(outcome.status == status, says << "\n" << outcome.err << outcome.out);
  BOOST_TEST(outcome.err.find(says) != std::string::npos,
             "expected '" << says << "', found '" << outcome.err << "'");
}

}  // namespace command
