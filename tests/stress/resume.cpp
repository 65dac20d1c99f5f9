// Runs that are killed at fifty random instants, and resumed each time: what they leave equals what an
// unbroken run leaves, bit for bit.
//
// ACTIO_SEED repeats the instants of another time.
//
// A table in HDF5 is whole at any instant, while the run goes on, after each kill and after a disk was full;
// its rows are the first ones of the unbroken run, who has it open keeps what there was, and at the end it is
// the same file.
#include <cstdio>
#include <fstream>

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

/// Of these every third start finds a disk that is soon full.
Case const storms[] = {
    {"HDF5, exact, many rows",
     {{"until", "200000.0"}, {"quantities", "[\"attitude\", \"energy\"]"}, {"formats", "[\"hdf5\"]"}},
     60},
    {"HDF5, order 2, few rows",
     {{"order", "2"},
      {"step", "0.25"},
      {"until", "30000000.0"},
      {"every", "10000.0"},
      {"formats", "[\"hdf5\"]"}},
     40},
};

/// What readers saw of the files of a run, beside those of the unbroken one.
class Readers {
 public:
  Readers(std::string const& out, std::string const& unbroken)
      : table_(out + "/series.h5"),
        rows_(out + "/series.csv"),
        whole_(command::read_hdf5(unbroken + "/series.h5")),
        whole_rows_(command::contents(unbroken + "/series.csv")) {}

  /// An ordinary reader opens the table; the rows are the first ones.
  void look(char const* when) {
    if (!whole_rows_.starts_with(command::contents(rows_))) complain(when, "series.csv has other rows");
    if (!std::filesystem::exists(table_)) return;
    if (!held_.is_open()) held_.open(table_, std::ios::binary), first_ = command::contents(table_);
    ++looks;
    try {
      auto const part = command::read_hdf5(table_);
      on_the_way += part.rows.size() < whole_.rows.size();
      if (part.rows.size() > whole_.rows.size() ||
          !std::equal(part.rows.begin(), part.rows.end(), whole_.rows.begin()))
        complain(when, "series.h5 has other rows");
    } catch (std::exception const& error) {
      complain(when, error.what());
    }
  }
  /// The reader that has opened the first table and stays finds what was there then.
  void leave() {
    std::string const found{std::istreambuf_iterator<char>(held_), {}};
    if (first_.empty() || found != first_) complain("of a reader that stayed", "series.h5 was changed");
  }
  int looks = 0, on_the_way = 0, refused = 0;

 private:
  void complain(char const* when, std::string const& what) {
    ++refused, std::printf("%s: %s\n", when, what.c_str());
  }
  std::string table_, rows_;
  command::Table whole_;
  std::string whole_rows_, first_;
  std::ifstream held_;
};

/// Kills a run until it is done, and fills its disk; reads its files while it goes on, and after each end.
bool readable(Case const& c, std::mt19937& random) {
  command::Folder const folder;
  std::string const scene = folder.write("scene.toml", command::apophis(c.changes)),
                    unbroken = folder / "unbroken", broken = folder / "broken";
  auto const resumed = [&] { return command::Process({"resume", broken, "--quiet"}).wait().status; };
  auto const began = std::chrono::steady_clock::now();
  bool well = command::Process({"run", scene, "--out", unbroken, "--quiet"}).wait().status == 0;
  double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  Readers readers(broken, unbroken);
  auto const size = [](std::string const& file) {
    std::error_code none;
    auto const bytes = std::filesystem::file_size(file, none);
    return none ? 0.0 : static_cast<double>(bytes);
  };
  double const share = size(unbroken + "/series.csv") / c.kills;
  std::uniform_real_distribution<double> instant(0, std::min(0.5, 2 * seconds / c.kills)), more(0, 2 * share);
  int met = 0, full = 0, others = 0;
  bool done = false;
  for (int k = 0; k < c.kills; ++k) {
    bool const begun = !done && std::filesystem::exists(broken + "/scene.toml"), fills = k % 3 == 2;
    auto const disk = static_cast<rlim_t>(size(broken + "/series.csv") + more(random));
    command::Process process(
        begun ? std::vector<std::string>{"resume", broken, "--quiet"}
              : std::vector<std::string>{"run", scene, "--out", broken, "--quiet", "--force"},
        fills ? disk : RLIM_INFINITY);
    command::sleep_for(instant(random));
    readers.look("while it goes on");
    command::sleep_for(instant(random));
    if (!fills) process.send(SIGKILL);
    int const status = process.wait().status;
    done = status == 0;  // then it begins anew
    met += status == 128 + SIGKILL, full += status == 4;
    others += status != 128 + SIGKILL && status != 4 && status != 0;
    readers.look("after it ended");
  }
  well = well && resumed() == 0;
  readers.leave();
  bool const same = command::contents(broken + "/series.h5") == command::contents(unbroken + "/series.h5") &&
                    command::contents(broken + "/series.csv") == command::contents(unbroken + "/series.csv");
  std::printf(
      "%-42s %5.1f s unbroken, %2d of %2d met by a kill, %2d by a full disk, %d looks, %d of them on "
      "the way, %d refused: %s\n",
      c.name, seconds, met, c.kills, full, readers.looks, readers.on_the_way, readers.refused,
      others                    ? "ANOTHER STATUS THAN 0, 4 OR THAT OF A KILL"
      : !well || !same          ? "THE FILES DIFFER"
      : met < 3 || full < 3     ? "TOO FEW KILLS OR FULL DISKS MET IT"
      : readers.on_the_way == 0 ? "NO TABLE WAS SEEN ON THE WAY"
                                : "bit for bit");
  std::fflush(stdout);
  return well && same && others == 0 && readers.refused == 0 && met >= 3 && full >= 3 &&
         readers.on_the_way > 0;
}

}  // namespace

int main() {
  unsigned const seed = command::seed();
  std::printf("ACTIO_SEED=%u\n", seed);
  std::mt19937 random(seed);
  bool well = true;
  for (Case const& c : cases) well = same(c, random) && well;
  ::setenv("ACTIO_CHECKPOINT_SECONDS", "0.001", 1);  // files are made anew thirty checkpoints apart
  for (Case const& c : storms) well = readable(c, random) && well;
  return well ? 0 : 1;
}
