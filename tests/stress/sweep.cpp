// Sweeps whose processes are killed at random instants, and resumed each time: the table equals that of an
// unbroken sweep, seconds aside, and so do all series.
//
// ACTIO_SEED repeats the instants of another time.
#include <cstdio>
#include <sstream>

#include "../command/process.hpp"

namespace {

/// The table without the column that tells of the clock. No cell of it has a comma.
std::string timeless(std::string const& path) {
  std::istringstream lines(command::contents(path));
  std::string out;
  for (std::string line; std::getline(lines, line); out += '\n') {
    std::istringstream cells(line);
    int column = 0;
    for (std::string cell; std::getline(cells, cell, ','); ++column)
      if (column != 4) out += cell + ",";
  }
  return out;
}

struct Case {
  char const* name;
  std::string until, every, seeds, jobs;
  int kills;
};
Case const cases[] = {
    {"many members of little work", "25.0", "0.25", "1:3000:1", "2", 12},
    {"members of some seconds", "6000000.0", "500000.0", "1:6:1", "2", 15},
    {"members of some tenths of a second, three at a time", "600000.0", "50000.0", "1:40:1", "3", 15},
};

bool same(Case const& c, std::mt19937& random) {
  command::Folder const folder;
  std::string const scene = folder.write(
                        "scene.toml",
                        command::apophis(
                            {{"order", "2"}, {"step", "0.25"}, {"until", c.until}, {"every", c.every}})),
                    unbroken = folder / "unbroken", broken = folder / "broken";
  auto const started = [&](std::string const& out) {
    return std::vector<std::string>{"sweep", scene, "--over", "scene.seed=" + c.seeds, "--jobs", c.jobs,
                                    "--out", out,   "--quiet"};
  };
  auto const began = std::chrono::steady_clock::now();
  auto const whole = command::Process(started(unbroken)).wait();
  double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  std::uniform_real_distribution<double> instant(0, 1.5 * seconds / c.kills);
  int met = 0, last = 0;
  std::string err;
  for (int k = 0; k <= c.kills; ++k) {
    bool const begun = std::filesystem::exists(broken + "/sweep.toml");
    auto arguments = started(broken);
    if (!begun) arguments.push_back("--force");
    command::Process process(begun ? std::vector<std::string>{"resume", broken, "--jobs", c.jobs, "--quiet"}
                                   : arguments);
    if (k < c.kills) command::sleep_for(instant(random)), process.send(SIGKILL);
    auto const outcome = process.wait();
    met += outcome.status == 128 + SIGKILL, last = outcome.status, err = outcome.err;
  }
  bool const table = timeless(unbroken + "/sweep.csv") == timeless(broken + "/sweep.csv");
  bool series = true;
  for (auto const& entry : std::filesystem::directory_iterator(unbroken))
    if (entry.is_directory())
      series =
          series && command::contents((entry.path() / "series.csv").string()) ==
                        command::contents(broken + "/" + entry.path().filename().string() + "/series.csv");
  bool const ended = whole.status == 0 && last == 0;
  std::printf("%-52s %5.1f s unbroken, %2d of %2d kills met the sweep: %s\n", c.name, seconds, met, c.kills,
              !ended              ? (whole.err + err).c_str()
              : met < c.kills / 3 ? "TOO FEW KILLS MET IT"
              : !table            ? "THE TABLES DIFFER"
              : !series           ? "THE SERIES DIFFER"
                                  : "the same");
  std::fflush(stdout);
  return ended && met >= c.kills / 3 && table && series;
}

}  // namespace

int main() {
  unsigned const seed = command::seed();
  std::printf("ACTIO_SEED=%u\n", seed);
  std::mt19937 random(seed);
  bool well = true;
  for (Case const& c : cases) well = same(c, random) && well;
  return well ? 0 : 1;
}
