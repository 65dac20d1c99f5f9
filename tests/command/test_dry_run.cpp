// actio run --dry-run: the plan, and that it is only a plan.
#include <boost/test/unit_test.hpp>

#include <sstream>

#include "command.hpp"

namespace {

using command::actio;
using command::apophis;

/// What stands after a label of the plan; empty where there is none.
std::string told(std::string const& plan, std::string const& label) {
  std::istringstream lines(plan);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(label + " ")) return line.substr(line.find_first_not_of(' ', label.size()));
  return "";
}
std::string plan_of(std::map<std::string, std::string> const& changes,
                    std::vector<std::string> const& more = {}) {
  command::Folder const folder;
  std::vector<std::string> arguments{"run", folder.write("apophis.toml", apophis(changes)), "--dry-run"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  auto const outcome = actio(arguments);
  BOOST_TEST(outcome.status == 0, outcome.err);
  return outcome.out;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(dry_run)

BOOST_AUTO_TEST_CASE(nothing_is_written) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", apophis());
  for (auto const& more : {std::vector<std::string>{}, {"--out", folder / "results"}, {"--plots"}}) {
    std::vector<std::string> arguments{"run", scene, "--dry-run"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    BOOST_TEST(actio(arguments).status == 0);
  }
  BOOST_TEST(std::distance(std::filesystem::directory_iterator(folder / ""), {}) == 1);
  BOOST_TEST(command::contents(scene) == apophis());
}

BOOST_AUTO_TEST_CASE(the_plan_says_what_is_computed_what_is_needed_for_it_and_what_is_skipped) {
  std::string const plan = plan_of({{"quantities", "[\"energy\"]"}});
  BOOST_TEST(told(plan, "computed") == "energy");
  BOOST_TEST(told(plan, "needed") == "body_momentum, angular_velocity (for what is computed; in no column)");
  BOOST_TEST(told(plan, "skipped") == "attitude, spatial_momentum, casimir, axial_momentum, jacobi_integral");
}

BOOST_AUTO_TEST_CASE(where_everything_is_asked_for_nothing_is_skipped) {
  BOOST_TEST(told(plan_of({{"quantities",
                            "[\"attitude\", \"angular_velocity\", \"body_momentum\", "
                            "\"spatial_momentum\", \"energy\", \"casimir\", "
                            "\"axial_momentum\", \"jacobi_integral\"]"}}),
                  "skipped") == "nothing");
}

BOOST_AUTO_TEST_CASE(the_plan_tells_the_shortcuts) {
  std::string const momentum_only = "momentum only: no attitude is reconstructed";
  BOOST_TEST(plan_of({{"quantities", "[\"energy\"]"}}).find(momentum_only) != std::string::npos);
  BOOST_TEST(plan_of({{"quantities", "[\"attitude\"]"}}).find(momentum_only) == std::string::npos);
  BOOST_TEST(plan_of({{"body", ""}, {"kind", "\"rigid_body\"\ninertia = [1, 1, 2]"}})
                 .find("axisymmetric body: closed form") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_plan_tells_rows_steps_method_and_files) {
  std::string const plan = plan_of({{"order", "2"}});
  BOOST_TEST(told(plan, "rows") == "101 rows, at t = 0, 0.25, ..., 25");
  BOOST_TEST(told(plan, "steps") == "100 steps of 0.25");
  BOOST_TEST(told(plan, "method") == "moser_veselov, order 2");
  BOOST_TEST(told(plan, "files").starts_with("series.csv (101 rows of 5 columns, about "));
  BOOST_TEST(told(plan_of({}), "steps") == "none: each row is evaluated at its time");
}

BOOST_AUTO_TEST_CASE(the_rows_that_the_plan_counts_are_those_of_the_run) {
  for (std::string const times :
       {"until = 25\nevery = 0.7", "until = 25", "until = 25\nevery = 100", "at = [0, 1, 5]"}) {
    command::Folder const folder;
    std::string text = apophis({{"until", ""}, {"every", ""}});
    text.replace(text.find("[run]"), 5, "[run]\n" + times);
    std::string const scene = folder.write("apophis.toml", text);
    auto const plan = actio({"run", scene, "--dry-run"}), run = actio({"run", scene});
    BOOST_TEST(run.status == 0, run.err);
    auto const table = command::read_csv(folder / "apophis/series.csv");
    BOOST_TEST(told(plan.out, "rows").starts_with(std::to_string(table.rows.size()) + " row"), plan.out);
  }
}

BOOST_AUTO_TEST_CASE(defaults_are_told) {
  std::string const plan = plan_of({{"name", ""}, {"order", ""}, {"step", ""}});
  BOOST_TEST(told(plan, "method") == "moser_veselov, order \"exact\"");
}

BOOST_AUTO_TEST_CASE(what_was_done_to_the_input_is_told) {
  BOOST_TEST(told(plan_of({{"attitude", "[1.0000000005, 0, 0, 0]"}}), "remark")
                 .starts_with("attitude: off unit length"));
}

BOOST_AUTO_TEST_CASE(a_folder_that_is_not_empty_is_told) {
  command::Folder const folder;
  folder.write("note.txt", "mine");
  command::Folder const scenes;
  std::string const scene = scenes.write("apophis.toml", apophis());
  BOOST_TEST(actio({"run", scene, "--dry-run", "--out", folder / ""}).out.find("the folder is not empty") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_scene_that_is_wrong_is_refused_as_in_a_run_before_any_file_is_made) {
  for (auto const& changes :
       std::vector<std::map<std::string, std::string>>{{{"quantities", "[\"enrgy\"]"}},
                                                       {{"order", "2"}, {"step", "0.1"}},
                                                       {{"order", "3"}},
                                                       {{"body", "\"apofis\""}},
                                                       {{"attitude", "[1, 1, 0, 0]"}}}) {
    command::Folder const folder;
    std::string const scene = folder.write("apophis.toml", apophis(changes));
    auto const plan = actio({"run", scene, "--dry-run"}), run = actio({"run", scene});
    BOOST_TEST(plan.status == 2);
    BOOST_TEST(plan.out == "");
    BOOST_TEST(plan.err == run.err);
    BOOST_TEST(run.status == 2);
    BOOST_TEST(!std::filesystem::exists(folder / "apophis"));
  }
}

BOOST_AUTO_TEST_CASE(a_step_too_long_for_the_method_is_status_3_and_the_step_that_is_named_would_do) {
  command::Folder const folder;
  std::string const scene =
      folder.write("apophis.toml", apophis({{"order", "2"}, {"step", "12.5"}, {"every", "12.5"}}));
  auto const outcome = actio({"run", scene, "--dry-run"});
  BOOST_TEST(outcome.status == 3, outcome.err);
  std::string const before = "the largest that meets the rows is ";
  std::size_t const at = outcome.err.find(before);
  BOOST_TEST_REQUIRE(at != std::string::npos, outcome.err);
  auto const again =
      actio({"run", scene, "--set",
             "method.step=" +
                 outcome.err.substr(at + before.size(), outcome.err.find('\n', at) - at - before.size())});
  BOOST_TEST(again.status == 0, again.err);
}

BOOST_AUTO_TEST_SUITE_END()
