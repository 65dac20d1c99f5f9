#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "program/run/run.hpp"
#include "readable_folder.hpp"
#include "refused.hpp"

using namespace actio::scene;

namespace {

using Folder = ReadableFolder;

/// Something that counts its steps, and stumbles at one of them.
struct Counter : Motion {
  enum class Stumble { never, throws, tells_nothing };
  long steps = 0, at;
  Stumble how;
  std::vector<long>* pieces;
  Counter(Stumble how_, long at_, std::vector<long>* pieces_) : at(at_), how(how_), pieces(pieces_) {}
  void advance(long count) override {
    if (pieces) pieces->push_back(count);
    for (; count > 0; --count) {
      if (how == Stumble::throws && steps == at) throw actio::NotFinite("counter");
      ++steps;
    }
  }
  void remember(CheckpointStream& stream) override { stream(steps); }
};

/// Twenty thousand steps of the counter, a row every 250.
Scene counting(Counter::Stumble how = Counter::Stumble::never, long at = 0,
               std::vector<long>* pieces = nullptr) {
  Scene scene = Scene::read(
      SceneFile::parse("[system]\nkind = \"rigid_body\"\nbody = \"apophis\"\n[initial]\n"
                       "angular_velocity = [0.1, 0, 0.2]\n[method]\norder = 2\nstep = 0.25\n[run]\n"
                       "until = 5000\nevery = 62.5\n[output]\nquantities = [\"energy\"]\n",
                       "counting.toml"));
  Simulation simulation({{"count", Quantity::Kind::scalar, "", "", ""}});
  auto motion = std::make_unique<Counter>(how, at, pieces);
  simulation.quantities.conserve([](auto const&) { return true; });
  simulation.quantities.define("count", {""}, [m = motion.get()](auto, double* value) {
    *value = m->how == Counter::Stumble::tells_nothing && m->steps >= m->at
                 ? std::numeric_limits<double>::quiet_NaN()
                 : static_cast<double>(m->steps);
  });
  simulation.quantities.ask({"count"});
  simulation.step = 0.25, simulation.steps_at_once = 100;
  simulation.motion = std::move(motion);
  scene.simulation = std::move(simulation);
  return scene;
}

RunReport run(
    Scene scene, Folder const& folder, bool resume, std::function<bool()> stop = [] { return false; }) {
  return run_scene(scene, folder.path, resume,
                   {.quiet = true, .checkpoint_interval = 0.01, .stop = std::move(stop)});
}

long rows_of(std::string const& table) { return std::count(table.begin(), table.end(), '\n') - 1; }

std::string unbroken_table() {
  Folder const folder;
  BOOST_REQUIRE((run(counting(), folder, false).ending == Ending::done));
  return folder("series.csv");
}

}  // namespace

BOOST_AUTO_TEST_SUITE(runs)

BOOST_AUTO_TEST_CASE(a_run_that_is_stopped_after_any_piece_goes_on_to_the_same_table_and_the_same_counts) {
  std::string const whole = unbroken_table();
  for (int const often : {5, 40, 233}) {
    Folder const folder;
    int processes = 0;
    RunReport report;
    do {
      int left = often;
      report = run(counting(), folder, processes > 0, [&] { return left-- == 0; });
      BOOST_REQUIRE((report.ending == Ending::done || report.ending == Ending::interrupted));
      BOOST_REQUIRE(whole.starts_with(folder("series.csv")));
      BOOST_REQUIRE(rows_of(folder("series.csv")) == report.rows);
    } while (report.ending != Ending::done && ++processes < 200);
    BOOST_TEST((folder("series.csv") == whole), processes << " processes");
    BOOST_TEST(report.steps == 20000);
    BOOST_TEST(report.rows == 81);
    BOOST_TEST(report.summary.find("\"count\": 81") != std::string::npos, report.summary);
    BOOST_TEST(run_is_finished(counting(), folder.path));
  }
}

BOOST_AUTO_TEST_CASE(the_pieces_of_steps_are_those_of_an_unbroken_run) {
  // The digits of a method may depend on them.
  std::vector<long> whole, joined;
  Folder const one, other;
  run(counting(Counter::Stumble::never, 0, &whole), one, false);
  for (bool resume = false;; resume = true) {
    int left = 17;
    if (run(counting(Counter::Stumble::never, 0, &joined), other, resume, [&] {
          return left-- == 0;
        }).ending == Ending::done)
      break;
  }
  BOOST_TEST((whole == joined));
  for (long const piece : whole) BOOST_REQUIRE(piece <= 100);
}

BOOST_AUTO_TEST_CASE(numerics_that_fail_leave_every_row_before_and_a_checkpoint_that_is_valid) {
  std::string const whole = unbroken_table();
  for (long const at : {0L, 249L, 250L, 12345L, 19999L}) {
    Folder const folder;
    for (int part = 0; part < 3; ++part) {
      RunReport const report = run(counting(Counter::Stumble::throws, at), folder, part > 0);
      BOOST_TEST((report.ending == Ending::numerics_failed));
      BOOST_TEST(report.message.starts_with("counting.toml:8:8: after t = "), report.message);
      BOOST_TEST(rows_of(folder("series.csv")) == at / 250 + 1);
      BOOST_TEST(whole.starts_with(folder("series.csv")));
      BOOST_TEST(folder("summary.json").find("\"status\": \"failed\"") != std::string::npos);
      BOOST_TEST(!run_is_finished(counting(), folder.path));
    }
    BOOST_TEST((run(counting(), folder, true).ending == Ending::done));
    BOOST_TEST((folder("series.csv") == whole), "failed at step " << at);
  }
}

BOOST_AUTO_TEST_CASE(what_is_no_number_gets_into_no_row) {
  Folder const folder;
  RunReport const report = run(counting(Counter::Stumble::tells_nothing, 600), folder, false);
  BOOST_TEST((report.ending == Ending::numerics_failed));
  BOOST_TEST(report.message ==
             "counting.toml:8:8: count is nan at t = 187.5, where a finite number is needed");
  BOOST_TEST(rows_of(folder("series.csv")) == 3);
}

BOOST_AUTO_TEST_CASE(a_motion_that_can_take_no_step_tells_its_start_alone) {
  Folder const folder;
  Scene scene = counting();
  scene.simulation.failure = "the step is too long";
  RunReport const report = run(std::move(scene), folder, false);
  BOOST_TEST((report.ending == Ending::numerics_failed));
  BOOST_TEST(report.message == "the step is too long");
  BOOST_TEST(folder("series.csv") == "t,count\n0,0\n");
}

BOOST_AUTO_TEST_CASE(the_drift_is_measured_from_the_start_where_no_row_is_there) {
  Folder const folder;
  Scene scene = Scene::read(SceneFile::parse(
      "[system]\nkind = \"heavy_top\"\nmass = 1\ninertia = [0.6, 0.8, 1]\ncentre_of_mass = [0, 0, 0.5]\n"
      "gravity = [0, 0, -9.81]\n[initial]\nangular_velocity = [0.1, 2, 5]\n[method]\norder = 2\n"
      "step = 0.01\n[run]\nat = [1.0]\n[output]\nquantities = [\"energy\"]\n",
      "one.toml"));
  RunReport const report = run(std::move(scene), folder, false);
  BOOST_TEST(report.rows == 1);
  BOOST_TEST(report.drift.at(0).relative > 0);
}

BOOST_AUTO_TEST_CASE(the_seconds_between_checkpoints_are_a_number_that_is_not_negative) {
  ::setenv("ACTIO_CHECKPOINT_SECONDS", "0.5", 1);
  BOOST_TEST(checkpoint_interval() == 0.5);
  for (char const* text : {"", "soon", "1s", "-1", "nan"}) {
    ::setenv("ACTIO_CHECKPOINT_SECONDS", text, 1);
    CHECK_REFUSED(checkpoint_interval(), SceneError);
  }
  ::unsetenv("ACTIO_CHECKPOINT_SECONDS");
  BOOST_TEST(checkpoint_interval() == RunOptions{}.checkpoint_interval);
}

BOOST_AUTO_TEST_SUITE_END()
