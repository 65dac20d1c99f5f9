// Runs that go on with steps of another length.
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <regex>

#include "long_scenes.hpp"
#include "process.hpp"

BOOST_AUTO_TEST_SUITE(change_of_step)

namespace {

using namespace command;
namespace fs = std::filesystem;

bool has(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }
/// The number that a key of the scene has.
double number(std::string const& scene, std::string const& key) {
  std::smatch found;
  if (!std::regex_search(scene, found, std::regex("(^|\n)" + key + " = ([-+.0-9e]+)")))
    throw std::runtime_error("no " + key);
  return std::stod(found[2]);
}
/// The same scene with rows at its start and its end alone: it is interrupted between two rows.
std::string without_rows(std::string const& scene) {
  return std::regex_replace(scene, std::regex("\nevery = [^\n]*"), "");
}
/// With all digits.
std::string text_of(double x) {
  std::ostringstream out;
  out.precision(17);
  out << x;
  return out.str();
}

/// Interrupted on its way.
void interrupt(std::string const& scene, std::string const& out) {
  Process run({"run", scene, "--out", out, "--quiet"});
  BOOST_REQUIRE(appears(out + "/checkpoint"));
  sleep_for(0.05);
  run.send(SIGINT);
  auto const ended = run.wait();
  BOOST_REQUIRE_MESSAGE(ended.status == 130, ended.err);
}

}  // namespace

// The error of the joined run is about that of the coarser of both steps, and what they differ by is about
// that. Where the time did not go on as it should, loads, torques and frames that depend on it would tell,
// and so would a state that is that of another time by a part of a step.
BOOST_AUTO_TEST_CASE(a_run_goes_on_with_another_step_to_the_end_that_it_would_have_had) {
  int told = 0;
  for (auto const& [name, rows] : long_scenes()) {
    if (name == std::string("rigid_body, exact")) continue;
    BOOST_TEST_CONTEXT(name) {
      Folder const folder;
      // The state is at no multiple of it: a shorter step leads there.
      std::string const text = without_rows(rows);
      double const step = number(text, "step"), until = number(text, "until");
      std::string const other = text_of(until / std::round(1.0731 * until / step)),
                        scene = folder.write("scene.toml", text), out = folder / "joined";
      interrupt(scene, out);
      std::string const before = contents(out + "/series.csv");
      auto const first = actio({"run", scene, "--out", folder / "before", "--quiet"}),
                 second = actio(
                     {"run", scene, "--out", folder / "after", "--quiet", "--set", "method.step=" + other});
      BOOST_REQUIRE_MESSAGE(first.status == 0 && second.status == 0, first.err + second.err);
      auto const joined = actio({"resume", out, "--step", other});
      BOOST_REQUIRE_MESSAGE(joined.status == 0, joined.err);
      BOOST_TEST(has(joined.err, "step: from t = "), joined.err);
      BOOST_TEST(contents(out + "/series.csv").starts_with(before));
      std::string const summary = contents(out + "/summary.json"), copy = contents(out + "/scene.toml");
      BOOST_TEST(has(summary, "\"step_changes\""), summary);
      BOOST_TEST(has(summary, "not estimated: the step was changed at t = "), summary);
      BOOST_TEST(copy.starts_with("# from t = "), copy);
      Table const a = read_csv(folder / "before/series.csv"), b = read_csv(folder / "after/series.csv"),
                  c = read_csv(out + "/series.csv");
      BOOST_REQUIRE(c.rows.size() == b.rows.size());
      double apart = 0, off = 0, size = 0;
      for (std::size_t i = 0; i < c.columns.size(); ++i) {
        if (c.columns[i] == "iterations") continue;  // a count, of the last step
        apart = std::max(apart, std::abs(a.rows[1][i] - b.rows[1][i]));
        off = std::max(off, std::abs(c.rows[1][i] - b.rows[1][i]));
        size = std::max(size, std::abs(b.rows[1][i]) * (i > 0));
      }
      BOOST_TEST_MESSAGE(name << ": the runs are " << apart << " apart, the joined one " << off);
      // Where they have nothing to do with one another any more there is nothing to say. Chaotic ones may be
      // apart by somewhat more.
      if (apart > 0.01 * size) continue;
      ++told;
      // Waves that have steepened to the size of cells are such ones.
      if (!has(name, "periodic box")) BOOST_TEST(off <= 10 * apart + 1e-10 * size);
    }
  }
  BOOST_TEST(told >= 10);
}

BOOST_AUTO_TEST_CASE(killed_after_the_change_it_goes_on_bit_for_bit) {
  unsigned const seed = command::seed();
  std::mt19937 random(seed);
  for (auto const& [name, text] : long_scenes()) {
    if (name == std::string("rigid_body, exact")) continue;
    BOOST_TEST_CONTEXT(name << ", ACTIO_SEED=" << seed) {
      Folder const folder;
      double const step = number(text, "step"), every = number(text, "every");
      std::string const other = text_of(every / (std::round(every / step) + 5)),
                        scene = folder.write("scene.toml", text), out = folder / "whole",
                        broken = folder / "broken";
      interrupt(scene, out);
      fs::copy(out, broken, fs::copy_options::recursive);
      BOOST_REQUIRE(actio({"resume", out, "--step", other, "--quiet"}).status == 0);
      {
        Process killed({"resume", broken, "--step", other, "--quiet"});
        sleep_for(std::uniform_real_distribution<>(0, 0.4)(random));
        killed.send(SIGKILL);
      }
      // Where it was killed before the change nothing has changed.
      bool const changed = has(contents(broken + "/scene.toml"), "# from t = ");
      auto resumed = changed ? actio({"resume", broken, "--quiet"})
                             : actio({"resume", broken, "--step", other, "--quiet"});
      // Between the checkpoint and the name of the scene: that is put right, and says so.
      if (has(resumed.err, "have that length already")) resumed = actio({"resume", broken, "--quiet"});
      BOOST_TEST(resumed.status == 0, resumed.err);
      BOOST_TEST((contents(out + "/series.csv") == contents(broken + "/series.csv")));
      BOOST_TEST(summary_without_times(out) == summary_without_times(broken));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_step_that_cannot_be_is_refused_and_changes_nothing) {
  Folder const folder;
  std::string const scene = folder.write("long.toml", apophis(steps)), out = folder / "long";
  interrupt(scene, out);
  std::string const copy = contents(out + "/scene.toml"), checkpoint = contents(out + "/checkpoint");
  for (auto const& [step, status, says] : std::vector<std::tuple<std::string, int, std::string>>{
           {"0.3", 2, "the nearest step that would do is"},
           {"0.25", 2, "the steps of this run have that length already"},
           {"-1", 2, "a number > 0 is expected"},
           {"short", 2, "--step short: a time is expected, for example --step 500"},
           {"50", 3, "the largest step that would do is 4.3"}}) {
    auto const refused = actio({"resume", out, "--step", step});
    BOOST_TEST(refused.status == status, step << ": " << refused.err);
    BOOST_TEST(has(refused.err, says), refused.err);
    BOOST_TEST((contents(out + "/scene.toml") == copy && contents(out + "/checkpoint") == checkpoint));
  }
  BOOST_TEST(actio({"resume", out}).status == 0);
  auto const finished = actio({"resume", out, "--step", "0.125"});
  BOOST_TEST(finished.status == 0);
  BOOST_TEST(has(finished.out, "the run is finished"), finished.out);
  BOOST_TEST(actio({"resume", out, "--until", "6000500", "--step", "0.125"}).status == 0);
  // Methods without steps.
  std::string const exact = folder.write("exact.toml", apophis({{"until", "1e7"}}));
  interrupt(exact, folder / "exact");
  auto const refused = actio({"resume", folder / "exact", "--step", "0.5"});
  BOOST_TEST(refused.status == 2);
  BOOST_TEST(refused.err ==
             "--step 0.5: the method of this run goes to any time at once, and has no steps\n");
}

// A row between two steps is reached from the step before it, which is another one after the change.
BOOST_AUTO_TEST_CASE(rows_between_steps_stay_where_they_are) {
  Folder const folder;
  auto scene = steps;
  scene["step"] = "0.7", scene["until"] = "6000000.3", scene["every"] = "5000.0";
  std::string text = apophis(scene);
  text.insert(text.find("\nevery") + 1, "between_steps = true\n");
  std::string const file = folder.write("long.toml", text);
  interrupt(file, folder / "joined");
  auto const joined = actio({"resume", folder / "joined", "--step", "0.45"});
  BOOST_TEST(joined.status == 0, joined.err);
  BOOST_REQUIRE(actio({"run", file, "--out", folder / "whole", "--quiet"}).status == 0);
  Table const a = read_csv(folder / "whole/series.csv"), b = read_csv(folder / "joined/series.csv");
  BOOST_TEST(a["t"] == b["t"], boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
