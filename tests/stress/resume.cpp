// Runs that are killed at fifty random instants, and resumed each time: what they leave equals what an unbroken run leaves, bit for bit.
//
// ACTIO_SEED repeats the instants of another time.
#include <cstdio>

#include "../command/process.hpp"

namespace {

struct Case {
  char const* name;
  std::map<std::string, std::string> changes;
  int kills;
};

/// Each takes some seconds, so that most kills meet it.
Case const cases[] = {
    {"rigid_body, order 2", {{"order", "2"}, {"step", "0.25"}, {"until", "30000000.0"}, {"every", "1000.0"}}, 15},
    {"rigid_body, order 2, rows far apart", {{"order", "2"}, {"step", "0.25"}, {"until", "30000000.0"}, {"every", "7777777.0"}}, 10},
    {"rigid_body, order 6, a row at each step", {{"order", "6"}, {"step", "0.25"}, {"until", "250000.0"}}, 10},
    {"rigid_body, exact", {{"until", "200000.0"}, {"quantities", "[\"attitude\", \"spatial_momentum\", \"energy\"]"}}, 15},
};

/// Whether the killed run left what the unbroken one did.
bool same(Case const& c, std::mt19937& random) {
  command::Folder const folder;
  std::string const scene = folder.write("scene.toml", command::apophis(c.changes)), unbroken = folder / "unbroken", broken = folder / "broken";
  auto const began = std::chrono::steady_clock::now();
  auto const whole = command::Process({"run", scene, "--out", unbroken, "--quiet"}).wait();
  double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  auto const killed = command::run_with_kills(scene, broken, c.kills, seconds, random);
  bool const ended = whole.status == 0 && killed.status == 0, met = killed.in_the_middle > c.kills / 3;
  bool const table = command::contents(unbroken + "/series.csv") == command::contents(broken + "/series.csv");
  bool const summary = command::summary_without_times(unbroken) == command::summary_without_times(broken);
  std::printf("%-42s %5.1f s unbroken, %2d of %2d kills met the run: %s\n", c.name, seconds, killed.in_the_middle, c.kills,
              !ended ? (whole.err + killed.err).c_str() : !met ? "TOO FEW KILLS MET IT" : !table ? "THE TABLES DIFFER" : !summary ? "THE SUMMARIES DIFFER" : "bit for bit");
  std::fflush(stdout);
  return ended && met && table && summary;
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
