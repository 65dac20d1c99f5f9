// The times of the rows: every, at, neither; multiples of the step.
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

#include "command.hpp"

namespace {

using command::actio;
using command::Folder;
using command::Table;

bool has(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }

std::string scene(std::string const& run, std::string const& method) {
  return "[system]\nkind = \"rigid_body\"\ninertia = [1, 2, 3]\n[initial]\nangular_velocity = [0.5, 1, "
         "-0.25]\n[method]\n" +
         method + "\n[run]\n" + run + "\n[output]\nquantities = [\"attitude\", \"body_momentum\"]\n";
}
std::string const exact = "order = \"exact\"";

Table series_of(std::string const& run, std::string const& method = exact) {
  Folder const folder;
  auto const outcome = actio({"run", folder.write("scene.toml", scene(run, method))});
  BOOST_TEST_REQUIRE(outcome.status == 0, run << ", " << method << ": " << outcome.err);
  return command::read_csv(folder / "scene/series.csv");
}
std::string complaint(std::string const& run, std::string const& method = exact) {
  Folder const folder;
  std::string const path = folder.write("scene.toml", scene(run, method));
  auto const outcome = actio({"run", path});
  BOOST_TEST(outcome.status == 2, run << ", " << method << ": " << outcome.err);
  BOOST_TEST(!std::filesystem::exists(folder / "scene"));
  return outcome.err.substr(std::min(path.size(), outcome.err.size()));
}

using Times = std::vector<double>;

}  // namespace

BOOST_AUTO_TEST_SUITE(times)

BOOST_AUTO_TEST_CASE(rows_are_at_multiples_of_every_multiplied_and_never_accumulated) {
  Times const t = series_of("until = 100\nevery = 0.1")["t"];
  BOOST_TEST(t.size() == 1001u);
  for (std::size_t k = 0; k < t.size(); ++k) BOOST_TEST(t[k] == static_cast<double>(k) * 0.1);
}

BOOST_AUTO_TEST_CASE(the_end_is_the_last_row_where_it_is_no_multiple) {
  BOOST_TEST(series_of("until = 1\nevery = 0.3")["t"] == (Times{0, 0.3, 2 * 0.3, 3 * 0.3, 1}),
             boost::test_tools::per_element());
  BOOST_TEST(series_of("until = 1\nevery = 0.9999")["t"] == (Times{0, 0.9999, 1}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_end_is_there_once_where_rounding_hides_that_it_is_a_multiple) {
  for (auto const& [until, every, rows] :
       std::vector<std::tuple<std::string, std::string, std::size_t>>{{"0.3", "0.1", 4},
                                                                      {"0.7", "0.1", 8},
                                                                      {"1", "0.1", 11},
                                                                      {"2.3", "0.23", 11},
                                                                      {"1e9", "1e8", 11},
                                                                      {"1.1e-6", "1e-7", 12}}) {
    Times const t = series_of("until = " + until + "\nevery = " + every)["t"];
    BOOST_TEST(t.size() == rows, until);
    // One rounding of the product.
    BOOST_TEST(
        std::abs(t.back() - std::stod(until)) <= std::numeric_limits<double>::epsilon() * std::stod(until),
        until);
  }
}

BOOST_AUTO_TEST_CASE(an_interval_beyond_the_end_leaves_the_first_row_and_the_last) {
  for (std::string const every : {"1.5", "3", "1e6", "1e12", "1e300"})
    BOOST_TEST(series_of("until = 1\nevery = " + every)["t"] == (Times{0, 1}),
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(with_neither_every_nor_at_rows_are_the_first_and_the_last) {
  BOOST_TEST(series_of("until = 0.7")["t"] == (Times{0, 0.7}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(with_at_rows_are_exactly_those) {
  BOOST_TEST(series_of("until = 2\nat = [0.1, 0.5, 1.25]")["t"] == (Times{0.1, 0.5, 1.25}),
             boost::test_tools::per_element());
  BOOST_TEST(series_of("at = [0, 0.1]")["t"] == (Times{0, 0.1}), boost::test_tools::per_element());
  BOOST_TEST(series_of("until = 2\nat = [0]")["t"] == (Times{0}), boost::test_tools::per_element());
  BOOST_TEST(series_of("until = 2\nat = [0]", "order = 2")["t"] == (Times{0}),
             boost::test_tools::per_element());
  BOOST_TEST(series_of("until = 2\nat = [0.5, 2]", "order = 2\nstep = 0.25")["t"] == (Times{0.5, 2}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(times_that_are_wrong_are_pointed_at) {
  BOOST_TEST(has(complaint("until = 2\nat = [0.5, 0.5]"),
                 ":10:12: at: each time is later than the one before; found 0.5 after 0.5"));
  BOOST_TEST(has(complaint("until = 2\nat = [0.5, 3]"),
                 ":10:12: at: times from 0 to until = 2 are expected, found 3"));
  BOOST_TEST(has(complaint("at = [-1, 3]"), ":9:7: at: times from 0 on are expected, found -1"));
  BOOST_TEST(has(complaint("until = 2\nevery = 1\nat = [1]"), "at and every exclude each other"));
  BOOST_TEST(has(complaint("until = 2\nat = []"), "at least one time"));
  BOOST_TEST(has(complaint("at = [0]"), "needs 'until'"));
  BOOST_TEST(has(complaint("every = 1"), "[run] needs 'until'"));
  for (std::string const wrong :
       {"until = 0", "until = -1", "until = inf", "until = nan", "until = \"long\"", "until = 1\nevery = 0",
        "until = 1\nevery = -0.1", "until = 1e300\nevery = 1e-300"})
    BOOST_TEST(complaint(wrong).starts_with(":"), wrong);
}

BOOST_AUTO_TEST_CASE(rows_of_an_exact_method_do_not_depend_on_which_others_are_asked) {
  auto const all = series_of("until = 7\nevery = 0.125"), some = series_of("at = [0.375, 1.5, 6.875]"),
             one = series_of("until = 7\nat = [1.5]");
  BOOST_TEST(some.rows[0] == all.rows[3], boost::test_tools::per_element());
  BOOST_TEST(some.rows[1] == all.rows[12], boost::test_tools::per_element());
  BOOST_TEST(some.rows[2] == all.rows[55], boost::test_tools::per_element());
  BOOST_TEST(one.rows[0] == all.rows[12], boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(an_exact_method_meets_its_rows_whatever_the_step) {
  auto const without = series_of("until = 1\nevery = 0.1");
  for (std::string const step : {"0.3", "7", "1e-9"})
    BOOST_TEST(series_of("until = 1\nevery = 0.1", exact + "\nstep = " + step).rows == without.rows, step);
}

BOOST_AUTO_TEST_CASE(rows_of_a_method_with_steps_are_those_of_all_its_steps) {
  auto const all = series_of("until = 6\nevery = 0.125", "order = 2\nstep = 0.125"),
             some = series_of("at = [0.375, 6]", "order = 2\nstep = 0.125");
  BOOST_TEST(some.rows[0] == all.rows[3], boost::test_tools::per_element());
  BOOST_TEST(some.rows[1] == all.rows[48], boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_step_that_divides_up_to_a_billionth_is_taken_and_one_farther_off_is_not) {
  BOOST_TEST(series_of("until = 1\nevery = 0.1", "order = 2\nstep = 0.1").rows.size() == 11u);
  BOOST_TEST(series_of("until = 1", "order = 2\nstep = 0.3333333333").rows.size() == 2u);
  BOOST_TEST(
      has(complaint("until = 1", "order = 2\nstep = 0.33333333"), "step: rows are at multiples of the step"));
}

BOOST_AUTO_TEST_CASE(a_step_that_meets_no_row_is_refused_with_one_that_would_do_and_that_is_taken) {
  struct Try {
    std::string run, step;
  };
  for (auto const& [run, step] : std::vector<Try>{{"until = 1\nevery = 0.1", "0.03"},
                                                  {"until = 1\nevery = 0.1", "0.25"},
                                                  {"until = 1\nevery = 0.3", "0.07"},
                                                  {"until = 0.7\nevery = 0.1", "0.04"},
                                                  {"until = 1", "0.3"},
                                                  {"until = 1\nevery = 0.333333333333", "0.3"},
                                                  {"at = [0.1, 0.25, 0.3]", "0.1"},
                                                  {"at = [0.123, 1.1, 2]", "0.01"},
                                                  {"until = 2\nat = [0.75]", "0.2"},
                                                  {"until = 273.75\nevery = 0.25", "0.2"},
                                                  {"until = 3e-7\nevery = 1e-7", "3e-8"}}) {
    std::string const said = complaint(run, "order = 2\nstep = " + step);
    BOOST_TEST(said.starts_with(":8:8: step: rows are at multiples of the step, and t = "), said);
    for (std::string const before : {"the nearest step that would do is ", "the nearest shorter one "}) {
      std::size_t const at = said.find(before);
      if (at == std::string::npos) {
        BOOST_TEST(before == "the nearest shorter one ", said);
        continue;
      }
      std::string const named =
          said.substr(at + before.size(), said.find_first_of(",\n", at) - at - before.size());
      BOOST_TEST(series_of(run, "order = 2\nstep = " + named).rows.size() >= 1u, named);
    }
  }
}

BOOST_AUTO_TEST_CASE(times_without_a_common_divisor_have_no_step_and_that_is_said) {
  BOOST_TEST(has(complaint("at = [1, 1.4142135623730951]", "order = 2\nstep = 0.01"),
                 "the times of the rows have no divisor in common"));
}

BOOST_AUTO_TEST_CASE(the_step_by_default_meets_the_rows) {
  for (std::string const run : {"until = 1\nevery = 0.3", "at = [0.123, 0.5]", "until = 100\nevery = 33.3",
                                "until = 1\nevery = 5", "until = 1e-3"})
    BOOST_TEST(series_of(run, "order = 2").rows.size() >= 2u, run);
}

BOOST_AUTO_TEST_SUITE_END()
