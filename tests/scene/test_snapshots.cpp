// When snapshots are taken, and that a run that was cut short leaves the same ones.
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <filesystem>
#include <map>

#include "program/base/own_files.hpp"
#include "program/run/checkpoint.hpp"
#include "program/run/run.hpp"
#include "readable_folder.hpp"
#include "refusal.hpp"
#include "refused.hpp"

using namespace actio::scene;

namespace {

using Folder = ReadableFolder;

/// Counts its steps, and how far it looks ahead.
struct Counter : Motion {
  long steps = 0;
  double ahead = 0;
  void advance(long count) override { steps += count, ahead = 0; }
  void look_ahead(double time) override { ahead = time; }
  void remember(CheckpointStream& stream) override { stream(steps); }
  double time(double step) const { return static_cast<double>(steps) * step + ahead; }
};

/// Writes the time of the motion and that of the call; in another format, one file with all of them.
struct Writer : SnapshotWriter {
  Counter const& counter;
  double step;
  std::map<long, long>* written;
  Writer(Counter const& c, double h, std::map<long, long>* w) : counter(c), step(h), written(w) {}
  std::vector<std::string> files(long number) const override { return {snapshot_file(number, ".csv")}; }
  std::vector<std::string> files_in(std::string const& format, long) const override {
    return format == "netcdf" ? std::vector<std::string>{"snapshots/all"} : std::vector<std::string>{};
  }
  std::string line(double time) const { return std::to_string(time) + "\n"; }
  void make(std::string const& format, std::string const& folder, std::span<double const> times,
            bool durable) const override {
    std::string all;
    for (double const t : times) all += line(t);
    if (format == "netcdf") write_whole_file(folder + "/snapshots/all", all, durable);
  }
  void write(std::string const& folder, long number, double time, bool durable) override {
    BOOST_TEST(std::abs(counter.time(step) - time) <= 1e-12);
    write_whole_file(folder + "/" + snapshot_file(number, ".csv"), line(time), durable);
    if (written) ++(*written)[number];
  }
  std::vector<SnapshotArray> coordinates() const override { return {}; }
  std::vector<SnapshotArray> fields() const override { return {}; }
  std::vector<SnapshotArray> fields_in(std::string const&, long) const override { return {}; }
};

std::string const beginning =
    "[system]\nkind = \"vorticity_sphere\"\nN = 3\n[initial]\nharmonics = [[1, 0, 0.5, 0]]\n[method]\n"
    "step = 0.25\n";

std::string text_of(std::string const& run, std::string const& output) {
  return beginning + "[run]\n" + run + "\n[output]\nquantities = [\"energy\"]\n" + output + "\n";
}

/// The same scene with a counter in the place of its motion.
Scene counting(std::string const& run, std::string const& output, std::map<long, long>* written = nullptr) {
  Scene scene = Scene::read(SceneFile::parse(text_of(run, output), "snaps.toml"));
  Simulation simulation({{"count", Quantity::Kind::scalar, "", "", ""}});
  auto motion = std::make_unique<Counter>();
  simulation.quantities.conserve([](auto const&) { return true; });
  simulation.quantities.define("count", {""},
                               [m = motion.get()](auto, double* value) { *value = m->time(0.25); });
  simulation.quantities.ask({"count"});
  simulation.step = 0.25, simulation.steps_at_once = 7;
  simulation.snapshots = std::make_unique<Writer>(*motion, 0.25, written);
  simulation.motion = std::move(motion);
  scene.simulation = std::move(simulation);
  return scene;
}

RunReport run(
    Scene scene, Folder const& folder, bool resume, std::function<bool()> stop = [] { return false; }) {
  return run_scene(scene, folder.path, resume,
                   {.quiet = true, .checkpoint_interval = 1e6, .stop = std::move(stop)});
}

/// Of all files of the run but what tells the time of day.
std::map<std::string, std::string> files_in(Folder const& folder) {
  std::map<std::string, std::string> out;
  for (auto const& entry : std::filesystem::recursive_directory_iterator(folder.path))
    if (std::string const name = std::filesystem::relative(entry.path(), folder.path).string();
        entry.is_regular_file() && name != "checkpoint" && name != "summary.json")
      out[name] = folder(name);
  return out;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(snapshots)

BOOST_AUTO_TEST_CASE(they_are_at_their_times_beside_the_rows) {
  struct Case {
    std::string run, output, times;
    long rows;
  };
  for (Case const& c : {
           Case{"until = 2\nevery = 1", "snapshots = []\nsnapshot_every = 0.75", "0,0\n1,0.75\n2,1.5\n3,2\n",
                3},
           Case{"until = 2\nevery = 0.25", "snapshots = []", "0,0\n1,2\n", 9},
           Case{"until = 5\nat = [1, 1.5]", "snapshots = []\nsnapshot_at = [0.5, 1.5, 4]",
                "0,0.5\n1,1.5\n2,4\n", 2},
           Case{"until = 1\nevery = 1\nbetween_steps = true", "snapshots = []\nsnapshot_at = [0.1, 0.2, 0.9]",
                "0,0.10000000000000001\n1,0.20000000000000001\n2,0.90000000000000002\n", 2},
       }) {
    Folder const folder;
    RunReport const report = run(counting(c.run, c.output), folder, false);
    BOOST_TEST((report.ending == Ending::done), report.message);
    BOOST_TEST(report.rows == c.rows);
    BOOST_TEST(folder("snapshots/times.csv") == "snapshot,t\n" + c.times);
    BOOST_TEST(report.snapshots == std::count(c.times.begin(), c.times.end(), '\n'));
    // The list of the run's own files has them all, so that --force removes them and the folder.
    OwnFiles(folder.path).remove();
    BOOST_TEST(!std::filesystem::exists(folder.path + "/snapshots"));
  }
}

BOOST_AUTO_TEST_CASE(a_run_that_was_cut_short_leaves_the_same_and_takes_none_twice) {
  std::string const times = "until = 12\nat = [1, 2, 3.5]",
                    output = "formats = [\"netcdf\"]\nsnapshots = []\nsnapshot_every = 0.75";
  Folder const whole;
  BOOST_REQUIRE((run(counting(times, output), whole, false).ending == Ending::done));
  auto const expected = files_in(whole);
  BOOST_REQUIRE(expected.size() > 17);
  int cut = 0;
  for (int at = 1; at < 40; at += 3) {
    Folder const folder;
    std::map<long, long> written;
    int asked = 0;
    auto const soon = [&] { return ++asked > at; };
    RunReport const report = run(counting(times, output, &written), folder, false, soon);
    if (report.ending == Ending::done) break;
    ++cut;
    // What came after its checkpoint is there in part, as after a kill.
    write_whole_file(folder.path + "/" + snapshot_file(report.snapshots, ".csv"), "half of it", false);
    write_whole_file(folder.path + "/snapshots/all", "broken", false);
    std::filesystem::copy_file(folder.path + "/snapshots/times.csv", folder.path + "/copy");
    write_whole_file(folder.path + "/snapshots/times.csv", folder("copy") + "17,1", false);
    std::filesystem::remove(folder.path + "/copy");
    RunReport const end = run(counting(times, output, &written), folder, true);
    BOOST_TEST((end.ending == Ending::done), end.message);
    BOOST_TEST(end.snapshots == 17);
    BOOST_TEST((files_in(folder) == expected));
    for (auto const& [number, count] : written) BOOST_TEST(count == 1);
    BOOST_REQUIRE(end.last_row.size() == 2u);
    BOOST_TEST(end.last_row[0] == 3.5);
  }
  BOOST_TEST(cut >= 6);  // in places before the last row and after it
}

BOOST_AUTO_TEST_CASE(a_run_without_snapshots_has_no_folder_of_them) {
  Folder const folder;
  BOOST_TEST((run(counting("until = 2", ""), folder, false).ending == Ending::done));
  BOOST_TEST(!std::filesystem::exists(folder.path + "/snapshots"));
}

BOOST_AUTO_TEST_CASE(the_default_step_meets_them) {
  Scene const scene = Scene::read(
      SceneFile::parse("[system]\nkind = \"vorticity_sphere\"\nN = 3\n[initial]\n"
                       "harmonics = [[1, 0, 0.5, 0], [2, 1, 0.2, 0]]\n[run]\nuntil = 2\n[output]\n"
                       "quantities = [\"energy\"]\nsnapshots = []\nsnapshot_every = 0.3\n",
                       "snaps.toml"));
  double const ratio = 0.1 / scene.simulation.step;  // what divides 0.3 and 2
  BOOST_TEST(std::abs(ratio - std::round(ratio)) <= 1e-9 * ratio);
}

BOOST_AUTO_TEST_CASE(what_is_wrong_with_them_is_told) {
  auto const tells = [](std::string const& run, std::string const& output, std::string const& what) {
    check_said(refusal(text_of(run, output), "snaps.toml"), what);
  };
  tells("until = 2", "snapshot_every = 1", "snapshots, the list of what they hold, is needed");
  tells("until = 2", "snapshots = []\nsnapshot_every = 1\nsnapshot_at = [1]", "exclude each other");
  tells("until = 2", "snapshots = []\nsnapshot_at = [1, 3]",
        "times from 0 to until = 2 are expected, found 3");
  tells("until = 2", "snapshots = []\nsnapshot_at = [1, 1]", "later than the one before");
  tells("until = 2", "snapshots = []\nsnapshot_every = 0.3",
        "rows and snapshots are at multiples of the step");
  tells("until = 2", "snapshots = []\nsnapshot_every = 1e-6", "at most 1000000 snapshots");
  tells("until = 2", "snapshots = [\"vorticty\"]", "unknown column 'vorticty'");
  tells("until = 2", "formats = [\"csv\", \"netcdf\"]", "netcdf is for snapshots");
  tells("until = 2", "snapshots = []\nsymbol = \"husimi\"", "unknown symbol 'husimi'");
  BOOST_TEST(refusal(text_of("until = 2", "snapshots = []\nsnapshot_every = 0.5"), "snaps.toml") == "");
  // A system that has none.
  std::string const body =
      "[system]\nkind = \"rigid_body\"\nbody = \"apophis\"\n[run]\nuntil = 1\n[output]\n"
      "quantities = [\"energy\"]\nsnapshots = []\n";
  CHECK_REFUSED(Scene::read(SceneFile::parse(body, "body.toml")), SceneError);
}

BOOST_AUTO_TEST_SUITE_END()
