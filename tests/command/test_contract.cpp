// What is promised of a scene file and of a run of it, promise by promise, on the free rigid body.
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

#include "command.hpp"

namespace {

using command::actio;
using command::apophis;
using command::Folder;
using command::Table;

using Changes = std::map<std::string, std::string>;

bool has(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }

/// The table that a scene leaves.
Table series_of(std::string const& text, std::vector<std::string> const& more = {}) {
  Folder const folder;
  std::vector<std::string> arguments{"run", folder.write("scene.toml", text), "--out", folder / "out"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  auto const outcome = actio(arguments);
  BOOST_TEST_REQUIRE(outcome.status == 0, outcome.err);
  return command::read_csv(folder / "out/series.csv");
}

/// What a scene that is wrong is told: without the name of the file, after `:line:column: `.
std::string complaint(std::string const& text, int status = 2) {
  Folder const folder;
  std::string const scene = folder.write("scene.toml", text);
  auto const outcome = actio({"run", scene});
  BOOST_TEST(outcome.status == status, outcome.err);
  BOOST_TEST(outcome.err.starts_with(scene + ":"), outcome.err);
  BOOST_TEST(!std::filesystem::exists(folder / "scene"));
  return outcome.err.starts_with(scene) ? outcome.err.substr(scene.size()) : outcome.err;
}

bool bitwise_equal(Table const& a, Table const& b) { return a.columns == b.columns && a.rows == b.rows; }

std::string const minimal =
    "[system]\nkind = \"rigid_body\"\ninertia = [1, 2, 3]\n[initial]\nangular_velocity = [0.5, 1, -0.25]\n"
    "[run]\nuntil = 2\n[output]\nquantities = [\"body_momentum\", \"attitude\"]\n";
std::string with(std::string text, std::string const& part, std::string const& other) {
  return text.replace(text.find(part), part.size(), other);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(contract)

BOOST_AUTO_TEST_CASE(an_initial_angular_velocity_sets_the_momentum_to_its_image_under_the_inertia) {
  auto const table = series_of(minimal);
  BOOST_TEST(table["body_momentum_x"][0] == 0.5);
  BOOST_TEST(table["body_momentum_y"][0] == 2.0);
  BOOST_TEST(table["body_momentum_z"][0] == -0.75);
  BOOST_TEST(bitwise_equal(table, series_of(with(minimal, "angular_velocity = [0.5, 1, -0.25]",
                                                 "angular_momentum = [0.5, 2, -0.75]"))));
}

BOOST_AUTO_TEST_CASE(velocity_and_momentum_exclude_each_other_and_one_is_needed) {
  BOOST_TEST(
      has(complaint(with(minimal, "[run]", "angular_momentum = [1, 1, 1]\n[run]")), "exclude each other"));
  BOOST_TEST(has(complaint(with(minimal, "angular_velocity = [0.5, 1, -0.25]", "")),
                 "[initial] needs 'angular_velocity' or 'angular_momentum'"));
}

BOOST_AUTO_TEST_CASE(the_attitude_is_the_identity_where_it_is_left_out) {
  auto const table = series_of(minimal);
  BOOST_TEST(table["attitude_w"][0] == 1.0);
  BOOST_TEST(table["attitude_x"][0] == 0.0);
  BOOST_TEST(bitwise_equal(table, series_of(with(minimal, "[run]", "attitude = [1, 0, 0, 0]\n[run]"))));
}

BOOST_AUTO_TEST_CASE(a_quaternion_that_is_not_normalised_is_refused_with_the_value_to_paste) {
  std::string const said = complaint(apophis({{"attitude", "[1, 1, 0, 0]"}})), before = "normalised it is ";
  BOOST_TEST(said.starts_with(":9:12: attitude: a unit quaternion is expected; its length is 1.414"), said);
  std::size_t const at = said.find(before);
  BOOST_TEST_REQUIRE(at != std::string::npos, said);
  std::string const value = said.substr(at + before.size(), said.find(']', at) + 1 - at - before.size());
  BOOST_TEST(series_of(apophis({{"attitude", value}})).rows.size() == 101u);
}

BOOST_AUTO_TEST_CASE(a_quaternion_off_by_less_than_a_billionth_is_normalised_and_that_is_said) {
  Folder const folder;
  auto const outcome =
      actio({"run", folder.write("scene.toml", apophis({{"attitude", "[1.0000000009, 0, 0, 0]"},
                                                        {"quantities", "[\"attitude\"]"}}))});
  BOOST_TEST(outcome.status == 0);
  BOOST_TEST(has(outcome.err, "normalised"));
  BOOST_TEST(command::read_csv(folder / "scene/series.csv")["attitude_w"][0] == 1.0);
}

BOOST_AUTO_TEST_CASE(an_inertia_is_three_moments_or_a_symmetric_matrix) {
  // The same body, its principal axes turned by a quarter: x is y and y is -x.
  auto const principal = series_of(minimal),
             full = series_of(with(minimal, "[1, 2, 3]", "[[1, 0, 0], [0, 2, 0], [0, 0, 3]]"));
  // both are some roundings from the flow
  for (std::size_t i = 1; i < principal.columns.size(); ++i)
    BOOST_TEST(std::abs(principal.rows[1][i] - full.rows[1][i]) <=
               64 * std::numeric_limits<double>::epsilon());
  BOOST_TEST(has(complaint(with(minimal, "[1, 2, 3]", "[[1, 0.5, 0], [0, 2, 0], [0, 0, 3]]")), "inertia"));
}

BOOST_AUTO_TEST_CASE(a_body_that_breaks_the_triangle_inequality_is_refused_with_the_excess_and_its_bound) {
  std::string const said = complaint(with(minimal, "[1, 2, 3]", "[1, 2, 3.5]"));
  BOOST_TEST(said.starts_with(":3:11: "), said);
  BOOST_TEST(has(said, "triangle inequality"), said);
  BOOST_TEST(has(said, "measured 0.142857"), said);  // (3.5 - (1 + 2)) / 3.5
  BOOST_TEST(has(said, "bound "), said);
}

BOOST_AUTO_TEST_CASE(body_and_inertia_exclude_each_other) {
  BOOST_TEST(has(complaint(apophis({{"body", "\"apophis\"\ninertia = [1, 2, 3]"}})), "exclude each other"));
}

BOOST_AUTO_TEST_CASE(unknown_keys_are_refused_in_every_section_with_the_nearest_known_one) {
  struct Mistake {
    std::string key, line, meant;
  };
  for (auto const& [key, line, meant] :
       std::vector<Mistake>{{"title", "titel = \"x\"", "title"},
                            {"body", "bdy = \"apophis\"", "body"},
                            {"attitude", "atitude = [1, 0, 0, 0]", "attitude"},
                            {"order", "oder = 2", "order"},
                            {"until", "untill = 3", "until"},
                            {"formats", "format = [\"csv\"]", "formats"}}) {
    std::string const before = apophis({{key, ""}}), whole = apophis();
    // In the place of the line that it is a slip of.
    std::size_t const at = whole.find("\n" + key + " = ") + 1;
    std::string const text = whole.substr(0, at) + line + whole.substr(whole.find('\n', at));
    std::string const said = complaint(text);
    BOOST_TEST(has(said, ":1: unknown key of ["), said);
    BOOST_TEST(has(said, "'" + line.substr(0, line.find(' ')) + "'; did you mean '" + meant + "'?"), said);
  }
  BOOST_TEST(has(complaint(with(apophis(), "[method]", "[methods]")),
                 "unknown section 'methods'; did you mean 'method'?"));
}

BOOST_AUTO_TEST_CASE(names_that_are_unknown_are_pointed_at_with_the_nearest_known_one) {
  BOOST_TEST(complaint(apophis({{"kind", "\"rigid_bdy\""}})) ==
             ":5:8: unknown system 'rigid_bdy'; did you mean 'rigid_body'? (actio list systems)\n");
  BOOST_TEST(complaint(apophis({{"body", "\"apofis\""}})) ==
             ":6:8: unknown body 'apofis'; did you mean 'apophis'? (actio list bodies)\n");
  BOOST_TEST(complaint(apophis({{"name", "\"moser_veselof\""}})) ==
             ":13:8: unknown method 'moser_veselof'; did you mean 'moser_veselov'? (actio list methods)\n");
  BOOST_TEST(
      has(complaint(apophis({{"formats", "[\"cvs\"]"}})), "unknown format 'cvs'; did you mean 'csv'?"));
}

BOOST_AUTO_TEST_CASE(the_orders_of_the_scheme_of_moser_and_veselov_are_2_4_6_8_10_and_exact) {
  for (std::string const order : {"2", "4", "6", "8", "10", "\"exact\""})
    BOOST_TEST(series_of(apophis({{"order", order}})).rows.size() == 101u, order);
  for (std::string const order : {"3", "12", "0", "-2", "\"precise\"", "2.0", "[2]", "\"2\""})
    BOOST_TEST(has(complaint(apophis({{"order", order}})), "order"), order);
}

BOOST_AUTO_TEST_CASE(nothing_is_computed_that_was_not_asked_for) {
  Folder const folder;
  BOOST_TEST(
      actio({"run", folder.write("scene.toml", apophis({{"quantities", "[\"body_momentum\"]"}}))}).status ==
      0);
  BOOST_TEST(command::read_csv(folder / "scene/series.csv").columns ==
                 (std::vector<std::string>{"t", "body_momentum_x", "body_momentum_y", "body_momentum_z"}),
             boost::test_tools::per_element());
  std::string const summary = command::contents(folder / "scene/summary.json");
  for (auto const& name : {"attitude", "angular_velocity", "spatial_momentum", "energy", "casimir"})
    BOOST_TEST(has(summary, std::string("\"") + name + "\": 0"), name);
}

BOOST_AUTO_TEST_CASE(columns_are_in_the_order_of_the_request) {
  BOOST_TEST(
      series_of(apophis({{"quantities", "[\"energy\", \"attitude\"]"}})).columns ==
          (std::vector<std::string>{"t", "energy", "attitude_w", "attitude_x", "attitude_y", "attitude_z"}),
      boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_method_may_be_left_out_and_the_default_is_written_back) {
  Folder const folder;
  BOOST_TEST(actio({"run", folder.write("scene.toml", minimal)}).status == 0);
  std::string const copy = command::contents(folder / "scene/scene.toml");
  for (auto const& line :
       {"[scene]\n", "title = \"scene\"\n", "seed = 1\n", "name = \"moser_veselov\"\n", "order = \"exact\"\n",
        "step = ", "attitude = [1.0, 0.0, 0.0, 0.0]\n", "formats = [\"csv\"]\n", "plots = false\n"})
    BOOST_TEST(has(copy, line), line);
}

BOOST_AUTO_TEST_CASE(the_copy_of_a_scene_runs_again_and_leaves_the_same) {
  for (std::string const& text :
       {minimal, apophis(), apophis({{"order", "2"}}),
        apophis({{"order", "2"}, {"step", ""}, {"every", "0.3"}}),
        apophis({{"every", ""}, {"until", "at = [0.5, 1, 7.25]"}}).replace(0, 0, "")}) {
    Folder const folder;
    std::string scene = text;
    if (std::size_t const at = scene.find("until = at"); at != std::string::npos) scene.erase(at, 8);
    BOOST_TEST(actio({"run", folder.write("scene.toml", scene), "--out", folder / "one"}).status == 0);
    std::filesystem::copy_file(folder / "one/scene.toml", folder / "again.toml");
    auto const again = actio({"run", folder / "again.toml", "--out", folder / "two"});
    BOOST_TEST(again.status == 0, again.err);
    BOOST_TEST(command::contents(folder / "one/series.csv") == command::contents(folder / "two/series.csv"));
    BOOST_TEST(command::contents(folder / "one/scene.toml") == command::contents(folder / "two/scene.toml"));
  }
}

BOOST_AUTO_TEST_CASE(overrides_are_in_the_copy_of_the_scene) {
  Folder const folder;
  BOOST_TEST(actio({"run", folder.write("scene.toml", minimal), "--set", "run.until=3", "--set",
                    "system.inertia=[2, 3, 4]"})
                 .status == 0);
  std::string const copy = command::contents(folder / "scene/scene.toml");
  BOOST_TEST(has(copy, "until = 3\n"));
  BOOST_TEST(has(copy, "inertia = [2, 3, 4]\n"));
}

BOOST_AUTO_TEST_CASE(an_override_takes_a_toml_value_or_a_bare_word) {
  std::string const bodies = apophis({{"quantities", "[\"angular_velocity\"]"}});
  auto const word = series_of(bodies, {"--set", "system.body=toutatis"}),
             text = series_of(bodies, {"--set", "system.body=\"toutatis\""}),
             file = series_of(with(bodies, "\"apophis\"", "\"toutatis\""));
  BOOST_TEST(bitwise_equal(word, text));
  BOOST_TEST(bitwise_equal(word, file));
  BOOST_TEST(!bitwise_equal(word, series_of(bodies)));
  BOOST_TEST(
      series_of(bodies, {"--set", "run.every=5", "--set", "output.quantities=[\"energy\", \"casimir\"]"})
          .columns.size() == 3u);
  BOOST_TEST(series_of(bodies, {"--set", "run.every = 5"}).rows.size() == 6u);
}

BOOST_AUTO_TEST_CASE(errors_of_an_override_point_at_the_argument) {
  Folder const folder;
  std::string const scene = folder.write("scene.toml", apophis());
  struct Wrong {
    std::string argument, said;
  };
  for (auto const& [argument, said] :
       std::vector<Wrong>{{"system.body=apofis",
                           ":1:13: unknown body 'apofis'; did you mean 'apophis'? (actio list bodies)\n"},
                          {"method.step=-1", ":1:13: step: a number > 0 is expected, found -1\n"},
                          {"method.stp=1", ":1:8: unknown key of [method] 'stp'; did you mean 'step'?"},
                          {"output.quantities=[\"energy\", \"enrgy\"]", ":1:30: unknown quantity 'enrgy'"},
                          {"run.until=[1", ":1:"},
                          {"method.step=nan", "finite"}}) {
    auto const outcome = actio({"run", scene, "--set", argument});
    BOOST_TEST(outcome.status == 2);
    BOOST_TEST(outcome.err.starts_with("--set " + argument + ":1:"), outcome.err);
    BOOST_TEST(has(outcome.err, said), outcome.err);
  }
}

BOOST_AUTO_TEST_CASE(a_run_is_left_beside_the_scene_under_its_name) {
  Folder const folder;
  BOOST_TEST(actio({"run", folder.write("two words.toml", minimal)}).status == 0);
  for (auto const& name : {"series.csv", "summary.json", "scene.toml"})
    BOOST_TEST(std::filesystem::exists(folder / "two words/" + name), name);
}

BOOST_AUTO_TEST_CASE(a_folder_that_is_not_empty_is_refused_unless_it_is_forced) {
  Folder const folder;
  std::string const scene = folder.write("scene.toml", minimal);
  BOOST_TEST(actio({"run", scene}).status == 0);
  std::string const before = command::contents(folder / "scene/series.csv");
  auto const refused = actio({"run", scene, "--set", "run.until=9"});
  BOOST_TEST(refused.status == 2);
  BOOST_TEST(has(refused.err, "--force"));
  BOOST_TEST(command::contents(folder / "scene/series.csv") == before);
  BOOST_TEST(actio({"run", scene, "--set", "run.until=9", "--force"}).status == 0);
  BOOST_TEST(command::read_csv(folder / "scene/series.csv")["t"].back() == 9.0);
  std::filesystem::create_directory(folder / "empty");
  BOOST_TEST(actio({"run", scene, "--out", folder / "empty"}).status == 0);
}

BOOST_AUTO_TEST_CASE(a_place_that_cannot_hold_a_folder_is_no_fault_of_the_numerics) {
  Folder const folder;
  std::string const scene = folder.write("scene.toml", minimal);
  BOOST_TEST(actio({"run", scene, "--out", scene + "/below"}).status == 4);
}

BOOST_AUTO_TEST_CASE(a_scene_that_is_not_there_or_is_no_toml_is_status_2) {
  Folder const folder;
  folder.write("apophis.toml", minimal);
  auto const outcome = actio({"run", folder / "apofis.toml"});
  BOOST_TEST(outcome.status == 2);
  BOOST_TEST(has(outcome.err, "did you mean 'apophis.toml'?"), outcome.err);
  BOOST_TEST(actio({"run", folder / ""}).status == 2);
  BOOST_TEST(complaint("[system\nkind = 1\n").starts_with(":1:8: "));
}

BOOST_AUTO_TEST_SUITE_END()
