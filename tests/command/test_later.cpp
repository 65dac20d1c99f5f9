// What is asked of a run that is there: its pictures, and a later end.
#include <boost/test/unit_test.hpp>

#include <fstream>

#include "process.hpp"

namespace {

using command::actio, command::apophis, command::contents, command::Folder;

bool holds(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }

/// Replaces the line `key = ...` of the scene in a folder.
void edit(std::string const& folder, std::string const& key, std::string const& value) {
  std::string text = contents(folder + "/scene.toml");
  std::size_t const at = text.find("\n" + key + " = ") + 1;
  text.replace(at, text.find('\n', at) - at, key + " = " + value);
  std::ofstream(folder + "/scene.toml", std::ios::binary) << text;
}
std::map<std::string, std::string> names_and_contents(std::string const& folder) {
  std::map<std::string, std::string> out;
  for (auto const& entry : std::filesystem::directory_iterator(folder))
    out[entry.path().filename().string()] = contents(entry.path().string());
  return out;
}

std::map<std::string, std::string> const steps{
    {"order", "4"}, {"step", "0.25"}, {"until", "50000.0"}, {"every", "0.5"}};
std::map<std::string, std::string> const many{{"until", "1e7"}};

/// A run that was interrupted on its way.
struct Interrupted {
  Folder folder;
  std::string const out = folder / "out";
  explicit Interrupted(std::map<std::string, std::string> const& changes, int signal = SIGINT) {
    command::Process process({"run", folder.write("scene.toml", apophis(changes)), "--out", out, "--quiet"});
    BOOST_REQUIRE(command::appears(out + "/checkpoint"));
    command::sleep_for(0.15);
    process.send(signal);
    process.wait();
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(later)

BOOST_AUTO_TEST_CASE(the_pictures_of_a_finished_run_are_those_that_it_would_have_drawn) {
  Folder const folder;
  std::string const scene = folder.write("apophis.toml", apophis()), with = folder / "with",
                    without = folder / "my run";
  BOOST_REQUIRE(actio({"run", scene, "--plots", "--out", with}).status == 0);
  BOOST_REQUIRE(actio({"run", scene, "--out", without}).status == 0);
  std::string const toml = contents(without + "/scene.toml");
  auto const outcome = actio({"plot", without + "/"});
  BOOST_TEST(outcome.status == 0, outcome.err);
  BOOST_TEST(holds(outcome.out, without + "/plots: "));
  BOOST_TEST(holds(outcome.out, " pictures and index.html\n"));
  auto drawn = names_and_contents(without + "/plots"), asked = names_and_contents(with + "/plots");
  drawn.erase("index.html"), asked.erase("index.html");  // in which are the seconds
  BOOST_TEST(asked.size() >= 3u);
  BOOST_TEST((drawn == asked));
  BOOST_TEST(std::filesystem::exists(without + "/plots/index.html"));
  BOOST_TEST(contents(without + "/scene.toml") == toml);
  BOOST_TEST(actio({"resume", without}).out ==
             without + ": the run is finished, with 101 rows to t = 25; nothing is left to do\n");
}

BOOST_AUTO_TEST_CASE(a_run_that_goes_on_and_one_that_was_killed_are_drawn_as_far_as_they_are) {
  Folder const folder;
  std::string const out = folder / "my run";
  command::Process process(
      {"run", folder.write("scene.toml", apophis({{"until", "1e7"}})), "--out", out, "--quiet"});
  BOOST_REQUIRE(command::appears(out + "/checkpoint"));
  command::sleep_for(0.1);
  auto const meanwhile = actio({"plot", out});
  BOOST_TEST(meanwhile.status == 0, meanwhile.err);
  BOOST_TEST(holds(meanwhile.out, "; of the rows so far, for the run goes on\n"), meanwhile.out);
  process.send(SIGKILL);
  BOOST_TEST(process.wait().status == 128 + SIGKILL);
  auto const afterwards = actio({"plot", out});
  BOOST_TEST(afterwards.status == 0, afterwards.err);
  BOOST_TEST(
      holds(afterwards.out, "for the run is not finished: actio resume '" + out + "' goes on with it\n"),
      afterwards.out);
  BOOST_TEST(holds(contents(out + "/plots/body_momentum.svg"), "</svg>"));
  BOOST_TEST(holds(contents(out + "/plots/index.html"), "</html>"));
}

BOOST_AUTO_TEST_CASE(a_folder_without_a_run_has_nothing_to_draw) {
  Folder const folder;
  std::filesystem::create_directory(folder / "empty");
  for (auto const& [name, what] :
       std::map<std::string, std::string>{{"empty", "there is no run in this folder: scene.toml is missing"},
                                          {"nowhere", "there is no such folder"}}) {
    auto const outcome = actio({"plot", folder / name});
    BOOST_TEST(outcome.status == 2);
    BOOST_TEST(outcome.err == folder / name + ": " + what + "\n");
  }
  BOOST_TEST(std::filesystem::is_empty(folder / "empty"));
}

BOOST_AUTO_TEST_CASE(resume_draws_the_pictures_that_are_missing_and_no_others) {
  Folder const folder;
  std::string const out = folder / "out";
  BOOST_REQUIRE(actio({"run", folder.write("scene.toml", apophis()), "--out", out}).status == 0);
  std::string const toml = contents(out + "/scene.toml");
  BOOST_TEST(holds(actio({"resume", out, "--plots"}).out, "its pictures were missing and are drawn"));
  BOOST_TEST(contents(out + "/scene.toml") == toml);
  BOOST_TEST(holds(actio({"resume", out, "--plots"}).out, "nothing is left to do"));
  // Killed while they were drawn: the page comes last.
  edit(out, "plots", "true");
  std::filesystem::remove(out + "/plots/index.html");
  BOOST_TEST(holds(actio({"resume", out}).out, "its pictures were missing and are drawn"));
  BOOST_TEST(std::filesystem::exists(out + "/plots/index.html"));
  BOOST_TEST(holds(actio({"resume", out}).out, "nothing is left to do"));
  // Those of an earlier part of the run do not count.
  std::filesystem::last_write_time(
      out + "/plots/index.html",
      std::filesystem::last_write_time(out + "/summary.json") - std::chrono::seconds(9));
  BOOST_TEST(holds(actio({"resume", out}).out, "its pictures were missing and are drawn"));
}

BOOST_AUTO_TEST_CASE(a_changed_title_does_not_keep_a_run_from_going_on_and_a_changed_number_does) {
  Interrupted const run({{"order", "4"}, {"step", "0.25"}, {"until", "500000.0"}, {"every", "0.5"}});
  edit(run.out, "title", "\"A better name\"");
  edit(run.out, "plots", "true");
  auto const outcome = actio({"resume", run.out});
  BOOST_TEST(outcome.status == 0, outcome.err);
  BOOST_TEST(holds(contents(run.out + "/summary.json"), "A better name"));
  BOOST_TEST(std::filesystem::exists(run.out + "/plots/index.html"));
  edit(run.out, "step", "0.125");
  BOOST_TEST(actio({"resume", run.out}).status == 4);
}

BOOST_AUTO_TEST_CASE(a_run_to_a_later_time_equals_an_unbroken_one_byte_for_byte) {
  for (auto const& [changes, until] : std::vector<std::pair<std::map<std::string, std::string>, std::string>>{
           {steps, "60000"},
           {{{"formats", "[\"csv\", \"hdf5\"]"}}, "33.3"},
           {{{"order", "2"}, {"until", "25.0"}, {"every", "0.5"}}, "1000.25"}}) {
    Folder const folder;
    std::string const scene = folder.write("scene.toml", apophis(changes)), out = folder / "out",
                      unbroken = folder / "unbroken";
    BOOST_REQUIRE(actio({"run", scene, "--out", out}).status == 0);
    auto const outcome = actio({"resume", out, "--until", until});
    BOOST_TEST(outcome.status == 0, outcome.err);
    BOOST_TEST(holds(outcome.out, "to t = " + until), outcome.out);
    BOOST_TEST(holds(contents(out + "/scene.toml"), "\nuntil = " + until));
    BOOST_REQUIRE(actio({"run", out + "/scene.toml", "--out", unbroken}).status == 0);
    for (char const* const table : {"/series.csv", "/series.h5"})
      BOOST_TEST((contents(out + table) == contents(unbroken + table)), until << table);
    BOOST_TEST((contents(out + "/scene.toml") == contents(unbroken + "/scene.toml")));
    BOOST_TEST(command::summary_without_times(out) == command::summary_without_times(unbroken));
  }
}

BOOST_AUTO_TEST_CASE(an_interrupted_run_can_be_given_a_later_end_and_killed_again) {
  for (int const signal : {SIGINT, SIGKILL}) {
    Interrupted const run(steps, signal);
    for (char const* const until : {"60000", "70000"}) {
      command::Process process({"resume", run.out, "--until", until, "--quiet"});
      command::sleep_for(0.1);
      process.send(SIGKILL);
      process.wait();
    }
    // Wherever the kills came, the scene and the checkpoint belong together.
    BOOST_TEST(actio({"resume", run.out}).status == 0);
    if (!holds(contents(run.out + "/scene.toml"), "\nuntil = 70000"))
      BOOST_TEST(actio({"resume", run.out, "--until", "70000"}).status == 0);
    std::string const unbroken = run.folder / "unbroken";
    BOOST_REQUIRE(actio({"run", run.out + "/scene.toml", "--out", unbroken}).status == 0);
    BOOST_TEST((contents(run.out + "/series.csv") == contents(unbroken + "/series.csv")));
  }
}

BOOST_AUTO_TEST_CASE(an_end_that_cannot_be_is_refused_with_its_reason_and_changes_nothing) {
  struct Case {
    std::string times, until, says;
  };
  for (auto const& c : std::vector<Case>{
           {"until = 25\nevery = 0.25", "25",
            "--until 25: the run goes to t = 25 already; a later time is expected"},
           {"until = 25\nevery = 0.25", "-1",
            "--until -1: the run goes to t = 25 already; a later time is expected"},
           {"until = 25\nevery = 0.25", "soon", "--until soon: a time is expected, for example --until 500"},
           {"until = 25\nevery = 0.25", "inf", "--until inf: a time is expected, for example --until 500"},
           {"until = 25\nevery = 0.25", "30.1", "t = 30.1 is 120.4 steps of 0.25"},
           {"until = 25\nevery = 0.25", "", "--until: a name is expected, found ''"},
           {"at = [1, 2, 5]", "9",
            "--until 9: the rows are at the times that [run] at lists, the last at t = 5"},
           {"until = 25\nevery = 0.75", "30",
            "--until 30: the run has a row at t = 25 already, which a run to t = 30 has not"},
           {"until = 25", "30",
            "--until 30: the run has a row at t = 25 already, which a run to t = 30 has not"}}) {
    Folder const folder;
    std::string text = apophis({{"order", "2"}, {"until", ""}, {"every", ""}});
    text.replace(text.find("[run]"), 5, "[run]\n" + c.times);
    std::string const out = folder / "out";
    BOOST_REQUIRE(actio({"run", folder.write("scene.toml", text), "--out", out}).status == 0);
    auto const before = names_and_contents(out);
    auto const outcome = actio({"resume", out, "--until", c.until});
    BOOST_TEST(outcome.status == 2);
    BOOST_TEST(holds(outcome.err, c.says), outcome.err);
    BOOST_TEST((names_and_contents(out) == before), c.until);
  }
}

BOOST_AUTO_TEST_CASE(an_end_that_was_changed_by_hand_is_taken_where_it_can_be) {
  Folder const folder;
  std::string const out = folder / "out";
  BOOST_REQUIRE(actio({"run", folder.write("scene.toml", apophis()), "--out", out}).status == 0);
  edit(out, "until", "30.0");
  auto const outcome = actio({"resume", out});
  BOOST_TEST(outcome.status == 0, outcome.err);
  BOOST_TEST(command::read_csv(out + "/series.csv").rows.size() == 121u);
  edit(out, "until", "10.0");
  auto const refused = actio({"resume", out});
  BOOST_TEST(refused.status == 2);
  BOOST_TEST(holds(refused.err, "the run has a row at t = 30 already, which a run to t = 10 has not"),
             refused.err);
}

BOOST_AUTO_TEST_CASE(a_folder_is_named_as_a_shell_takes_it) {
  Folder const folder;
  for (std::string const name : {"my run", "it's", "a;b", "-n", "tab\there"}) {
    std::string const scene = folder.write("scene.toml", apophis(many));
    folder.write("name", name);
    std::string const for_a_moment =
        "cd '" + folder / "" + "' && ACTIO_CHECKPOINT_SECONDS=0.05 timeout --preserve-status -s INT 0.4 ";
    auto const outcome = command::shell(for_a_moment + "$ACTIO run scene.toml --quiet --out=\"$(cat name)\"");
    BOOST_TEST(outcome.status == 130, outcome.err);
    std::size_t const at = outcome.err.find("; actio "), end = outcome.err.find(" goes on from there");
    BOOST_REQUIRE((at != std::string::npos && end != std::string::npos));
    // What is said is done.
    folder.write("said.sh", "\"$1\" " + outcome.err.substr(at + 8, end - at - 8) + " --until 1\n");
    auto const said = command::shell("cd '" + folder / "" + "' && bash said.sh $ACTIO");
    BOOST_TEST(said.err == "--until 1: the run goes to t = 10000000 already; a later time is expected\n",
               name);
  }
}

BOOST_AUTO_TEST_SUITE_END()
