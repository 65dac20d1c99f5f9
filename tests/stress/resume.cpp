// Runs that are killed at fifty random instants, and resumed each time: what they leave equals what an
// unbroken run leaves, bit for bit.
//
// ACTIO_SEED repeats the instants of another time.
//
// A table in HDF5 is whole at any instant, while the run goes on and after each kill; its rows are the first
// ones of the unbroken run, and at the end it is the same file.
#include <cstdio>

#include "../command/hdf5_table.hpp"
#include "../command/process.hpp"

namespace {

struct Case {
  char const* name;
  std::map<std::string, std::string> changes;
  int kills;
};

/// Each takes some seconds, so that most kills meet it.
Case const cases[] = {
    {"rigid_body, order 2",
     {{"order", "2"}, {"step", "0.25"}, {"until", "30000000.0"}, {"every", "1000.0"}},
     15},
    {"rigid_body, order 2, rows far apart",
     {{"order", "2"}, {"step", "0.25"}, {"until", "30000000.0"}, {"every", "7777777.0"}},
     10},
    {"rigid_body, order 6, a row at each step",
     {{"order", "6"}, {"step", "0.25"}, {"until", "250000.0"}},
     10},
    {"rigid_body, exact",
     {{"until", "200000.0"}, {"quantities", "[\"attitude\", \"spatial_momentum\", \"energy\"]"}},
     15},
};

/// Whether the killed run left what the unbroken one did.
bool same(Case const& c, std::mt19937& random) {
  command::Folder const folder;
  std::string const scene = folder.write("scene.toml", command::apophis(c.changes)),
                    unbroken = folder / "unbroken", broken = folder / "broken";
  auto const began = std::chrono::steady_clock::now();
  auto const whole = command::Process({"run", scene, "--out", unbroken, "--quiet"}).wait();
  double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  auto const killed = command::run_with_kills(scene, broken, c.kills, seconds, random);
  bool const ended = whole.status == 0 && killed.status == 0, met = killed.in_the_middle > c.kills / 3;
  bool const table = command::contents(unbroken + "/series.csv") == command::contents(broken + "/series.csv");
  bool const summary = command::summary_without_times(unbroken) == command::summary_without_times(broken);
  std::printf("%-42s %5.1f s unbroken, %2d of %2d kills met the run: %s\n", c.name, seconds,
              killed.in_the_middle, c.kills,
              !ended     ? (whole.err + killed.err).c_str()
              : !met     ? "TOO FEW KILLS MET IT"
              : !table   ? "THE TABLES DIFFER"
              : !summary ? "THE SUMMARIES DIFFER"
                         : "bit for bit");
  std::fflush(stdout);
  return ended && met && table && summary;
}

/// What an ordinary reader makes of a table: nothing is wrong, or what.
std::string wrong(std::string const& path, command::Table const& whole) try {
  auto const part = command::read_hdf5(path);
  bool const begins = part.rows.size() <= whole.rows.size() &&
                      std::equal(part.rows.begin(), part.rows.end(), whole.rows.begin());
  return begins ? "" : "its rows are not the first ones";
} catch (std::exception const& error) {
  return error.what();
}

struct Hdf5Case {
  char const* name;
  std::map<std::string, std::string> changes;
  int kills;
};
Hdf5Case const hdf5_cases[] = {
    {"HDF5, exact, many rows",
     {{"until", "200000.0"}, {"quantities", "[\"attitude\", \"energy\"]"}, {"formats", "[\"hdf5\"]"}},
     100},
    {"HDF5, order 2, few rows",
     {{"order", "2"},
      {"step", "0.25"},
      {"until", "30000000.0"},
      {"every", "10000.0"},
      {"formats", "[\"hdf5\"]"}},
     50},
};

/// Kills a run until it is done; reads its table while it goes on, and after each kill.
bool readable(Hdf5Case const& c, std::mt19937& random) {
  command::Folder const folder;
  std::string const scene = folder.write("scene.toml", command::apophis(c.changes)),
                    unbroken = folder / "unbroken", broken = folder / "broken", table = broken + "/series.h5";
  auto const began = std::chrono::steady_clock::now();
  bool well = command::Process({"run", scene, "--out", unbroken, "--quiet"}).wait().status == 0;
  double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  auto const whole = command::read_hdf5(unbroken + "/series.h5");
  std::uniform_real_distribution<double> instant(0, std::min(0.5, 3 * seconds / c.kills));
  int met = 0, looks = 0, refused = 0;
  auto const look = [&](char const* when) {
    if (!std::filesystem::exists(table)) return;
    ++looks;
    if (std::string const what = wrong(table, whole); !what.empty())
      ++refused, std::printf("%s: %s\n", when, what.c_str());
  };
  for (int k = 0; k < c.kills; ++k) {
    bool const begun = std::filesystem::exists(broken + "/scene.toml");
    command::Process process(begun ? std::vector<std::string>{"resume", broken, "--quiet"}
                                   : std::vector<std::string>{"run", scene, "--out", broken, "--quiet"});
    command::sleep_for(instant(random));
    look("while it goes on");
    command::sleep_for(instant(random));
    process.send(SIGKILL);
    if (process.wait().status == 128 + SIGKILL) ++met;
    look("after a kill");
  }
  well = well && command::Process({"resume", broken, "--quiet"}).wait().status == 0 &&
         command::contents(table) == command::contents(unbroken + "/series.h5");
  std::printf("%-42s %5.1f s unbroken, %2d of %2d kills met the run, %d looks, %d refused: %s\n", c.name,
              seconds, met, c.kills, looks, refused, well ? "bit for bit" : "THE TABLES DIFFER");
  std::fflush(stdout);
  return well && refused == 0 && met > 2;
}

}  // namespace

int main() {
  unsigned const seed = command::seed();
  std::printf("ACTIO_SEED=%u\n", seed);
  std::mt19937 random(seed);
  bool well = true;
  for (Case const& c : cases) well = same(c, random) && well;
  ::setenv("ACTIO_CHECKPOINT_SECONDS", "0.001", 1);  // files are made anew thirty checkpoints apart
  for (Hdf5Case const& c : hdf5_cases) well = readable(c, random) && well;
  return well ? 0 : 1;
}
