// The report of a program: what is written reads back, and a claim that does not hold is not passed over.
#include <boost/test/unit_test.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "actio/numbers/print.hpp"
#include "book/program.hpp"
#include "book/try_it.hpp"

namespace {

/// A program that was called with `--report` and a fresh folder.
struct Called {
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("actio_book_" + std::to_string(std::rand()));
  std::string name = "bin/ch03_sample", option = "--report", where = folder.string();
  char* argv[3] = {name.data(), option.data(), where.data()};
  book::Program program{3, argv, "shows \"quotes\"\nand lines"};

  ~Called() { std::filesystem::remove_all(folder); }
  nlohmann::json report() const { return nlohmann::json::parse(std::ifstream(folder / "ch03_sample.json")); }
};

}  // namespace

BOOST_AUTO_TEST_CASE(the_report_reads_back) {
  Called called;
  auto& program = called.program;
  program.figure("drift", 1.0 / 3, "relative drift");
  program.figure("period", 12.5, "12.5 s", "time of a turn");
  program.table("orders", {"méthode", "order"}, {{"natural chart", "2.00"}, {"a \\ b", "4"}}, "slopes");
  program.picture("flip", "<svg/>", "A flip & a \"turn\".");
  program.claim(true, "it turns");
  program.headline("kept to 1e-15", 1e-15);
  BOOST_TEST(program.finish() == 0);

  auto const report = called.report();
  BOOST_TEST(report["chapter"] == "ch03");
  BOOST_TEST(report["program"] == "ch03_sample");
  BOOST_TEST(report["shows"] == "shows \"quotes\"\nand lines");
  BOOST_TEST(report["figures"][0]["value"].get<double>() == 1.0 / 3);
  BOOST_TEST(report["figures"][1]["text"] == "12.5 s");
  BOOST_TEST(report["tables"][0]["rows"][1][0] == "a \\ b");
  BOOST_TEST(report["pictures"][0]["file"] == "ch03_sample.flip.svg");
  BOOST_TEST(std::filesystem::exists(called.folder / "ch03_sample.flip.svg"));
  BOOST_TEST(report["headline"]["value"].get<double>() == 1e-15);
}

BOOST_AUTO_TEST_CASE(a_claim_that_does_not_hold_fails_the_program) {
  Called called;
  called.program.headline("all well", 0);
  called.program.claim(false, "two and two are five");
  BOOST_TEST(called.program.finish() == 1);
  BOOST_TEST(called.report()["claims"][0]["holds"] == false);
}

BOOST_AUTO_TEST_CASE(a_claim_shows_what_was_measured_and_its_bound) {
  Called called;
  called.program.headline("all well", 0);
  called.program.claim(book::measured(1e-15) < 1e-14 && book::measured(3) > 2, "both hold");
  called.program.claim(book::measured(3) < 2, "three is below two");
  BOOST_TEST(called.program.finish() == 1);
  auto const claims = called.report()["claims"];
  BOOST_TEST(claims[0]["holds"] == true);
  BOOST_TEST(claims[0]["measured"] == "1e-15 < 1e-14, 3 > 2");
  BOOST_TEST(claims[1]["holds"] == false);
  // What is not a number is on no side of a bound.
  BOOST_TEST(!(book::measured(std::nan("")) < 1).holds);
  BOOST_TEST(!(book::measured(std::nan("")) > 1).holds);
}

BOOST_AUTO_TEST_CASE(a_motion_has_a_value_for_every_name) {
  Called called;
  called.program.headline("all well", 0);
  called.program.motion("flip", {"t", "x"}, {{0, 1}, {0.5, 1.0 / 3}});
  BOOST_CHECK_THROW(called.program.motion("flop", {"t", "x"}, {{0, 1, 2}}), std::invalid_argument);
  BOOST_TEST(called.program.finish() == 0);
  BOOST_TEST(called.report()["motions"][0]["rows"][1][1].get<double>() == 0.33333);
}

BOOST_AUTO_TEST_CASE(a_snippet_is_kept_with_what_it_printed) {
  auto const before = book::tries();
  book::tries() = {{"one", [] { actio::print("one", 1); }}, {"silent", [] {}}};
  std::string name = "bin/ch03_try_it", option = "--report", where = Called().folder.string();
  char* argv[3] = {name.data(), option.data(), where.data()};
  // A snippet that prints nothing teaches nothing: the program fails.
  BOOST_TEST(book::run_tries(3, argv, "lines to try") == 1);
  auto const report = nlohmann::json::parse(std::ifstream(std::filesystem::path(where) / "ch03_try_it.json"));
  BOOST_TEST(report["snippets"][0]["said"] == "one: 1\n");
  BOOST_TEST(report["claims"][1]["holds"] == false);
  book::tries() = before;
  std::filesystem::remove_all(where);
}

BOOST_AUTO_TEST_CASE(a_figure_that_is_not_a_number_fails_the_program) {
  Called called;
  called.program.headline("all well", 0);
  called.program.figure("drift", std::nan(""));
  BOOST_TEST(called.program.finish() == 1);
  BOOST_TEST(called.report()["figures"][0]["value"].is_null());
}

BOOST_AUTO_TEST_CASE(a_program_without_a_headline_fails) {
  Called called;
  BOOST_TEST(called.program.finish() == 1);
}

BOOST_AUTO_TEST_CASE(an_earlier_report_does_not_outlive_a_new_start) {
  Called called;
  called.program.headline("all well", 0);
  BOOST_TEST(called.program.finish() == 0);
  book::Program again(3, called.argv, "the same");
  BOOST_TEST(!std::filesystem::exists(called.folder / "ch03_sample.json"));
}

BOOST_AUTO_TEST_CASE(numbers_read_back_to_the_last_bit) {
  for (double const x : {0.1, 1e-300, -123456.789, 2.2250738585072014e-308, 1.7976931348623157e308, 0.0})
    BOOST_TEST(std::stod(book::json::number(x)) == x);
  BOOST_TEST(book::json::number(std::numeric_limits<double>::infinity()) == "null");
}
