// The times of rows, and the steps to them, as the contract of scenes has them.
#include <cmath>
#include <random>

#include <fmt/format.h>
#include <boost/test/unit_test.hpp>

#include "caught.hpp"
#include "program/document/schedule.hpp"

using namespace actio::scene;
using actio::testing::message_of;

namespace {

constexpr unsigned seed = 1971;

Schedule schedule_of(std::string const& run) {
  return Schedule(SceneFile::parse("[run]\n" + run, "f").section("run"));
}

/// What is said where rows are refused; empty where they are taken.
std::string complaint(std::string const& run, double step) {
  SceneFile const file = SceneFile::parse(fmt::format("[method]\nstep = {}\n[run]\n{}", step, run), "f");
  return message_of([&] {
    Schedule const schedule(file.section("run"));
    StepsToRows(schedule, step, file.section("method"));
  });
}

/// A number of a plain kind, or of any.
double any_positive(std::mt19937& random) {
  switch (random() % 4) {
    case 0:
      return static_cast<double>(1 + random() % 100) / 8;
    case 1:
      return static_cast<double>(1 + random() % 1000) / 1000;
    case 2:
      return std::exp(std::uniform_real_distribution<double>(-20, 5)(random));
    default:
      return std::uniform_real_distribution<double>(0.01, 10)(random);
  }
}
bool is_multiple(double t, double h) {
  return std::abs(t / h - std::round(t / h)) <= 1e-9 * std::max(1.0, t / h);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(schedule)

BOOST_AUTO_TEST_CASE(rows_are_the_multiples_of_every_and_until) {
  BOOST_TEST_MESSAGE("seed " << seed);
  std::mt19937 random(seed);
  long beside = 0, among = 0;
  for (int k = 0; k < 5000; ++k) {
    double const every = any_positive(random);
    double const until = random() % 2 ? every * static_cast<double>(1 + random() % 1000)
                                      : every * std::uniform_real_distribution<double>(0.01, 1000)(random);
    Schedule const s = schedule_of(fmt::format("until = {}\nevery = {}\n", until, every));
    BOOST_REQUIRE_EQUAL(s.time(0), 0);
    bool const last_is_until = !is_multiple(until, every);
    (last_is_until ? beside : among) += 1;
    for (long row = 1; row + (last_is_until ? 1 : 0) < s.rows(); ++row)
      BOOST_REQUIRE_SMALL(s.time(row) / (static_cast<double>(row) * every) - 1, 2.3e-16);
    if (last_is_until)
      BOOST_REQUIRE_EQUAL(s.time(s.rows() - 1), until);
    else
      BOOST_REQUIRE_SMALL(s.time(s.rows() - 1) - until, 1e-9 * until);
    for (long row = 1; row < s.rows(); ++row) BOOST_REQUIRE_LT(s.time(row - 1), s.time(row));
  }
  BOOST_TEST(beside > 500);
  BOOST_TEST(among > 500);
}

BOOST_AUTO_TEST_CASE(with_at_rows_are_those_alone_and_with_neither_the_first_and_the_last) {
  Schedule const listed = schedule_of("at = [0.5, 0.75, 3]\n"), bare = schedule_of("until = 7\n"),
                 within = schedule_of("at = [0.5]\nuntil = 2\n"),
                 start = schedule_of("at = [0]\nuntil = 2\n");
  BOOST_TEST(listed.rows() == 3);
  BOOST_TEST(listed.time(1) == 0.75);
  BOOST_TEST(listed.until() == 3);
  BOOST_TEST(bare.rows() == 2);
  BOOST_TEST((bare.time(0) == 0 && bare.time(1) == 7));
  BOOST_TEST(within.rows() == 1);
  BOOST_TEST(start.time(0) == 0);
}

BOOST_AUTO_TEST_CASE(rows_far_apart_or_near_are_counted_without_a_table_of_them) {
  BOOST_TEST(schedule_of("until = 1e15\nevery = 1\n").rows() == 1000000000000001);
  BOOST_TEST(schedule_of("until = 1e-300\nevery = 1e-310\n").rows() == 10000000001);
  BOOST_TEST(schedule_of("until = 1e308\nevery = 1e308\n").rows() == 2);
  BOOST_TEST(schedule_of("until = 1\nevery = 1e308\n").rows() == 2);
  BOOST_TEST(schedule_of("until = 5e-324\n").rows() == 2);
}

BOOST_AUTO_TEST_CASE(rows_at_multiples_of_the_step_are_met_by_as_many_steps) {
  std::mt19937 random(seed);
  for (int k = 0; k < 5000; ++k) {
    double const step = any_positive(random);
    long const per_row = 1 + static_cast<long>(random() % 50), rows = 1 + static_cast<long>(random() % 200);
    double const every = static_cast<double>(per_row) * step;
    SceneFile const file = SceneFile::parse(
        fmt::format("[run]\nevery = {}\nuntil = {}\n", every, static_cast<double>(rows) * every), "f");
    Schedule const s(file.section("run"));
    StepsToRows const steps(s, step, file.section("method"));
    for (long row = 0; row < s.rows(); ++row) BOOST_REQUIRE_EQUAL(steps(row), row * per_row);
  }
}

BOOST_AUTO_TEST_CASE(the_step_that_is_named_would_do_and_none_is_nearer) {
  BOOST_TEST_MESSAGE("seed " << seed);
  std::mt19937 random(seed);
  long named = 0;
  for (int k = 0; k < 5000; ++k) {
    // Rows at multiples of some step, and another step asked for.
    double const unit = any_positive(random), step = any_positive(random) * unit;
    std::string run;
    if (random() % 2) {
      auto const every = 1 + random() % 30;
      run = fmt::format("every = {}\nuntil = {}\n", static_cast<double>(every) * unit,
                        static_cast<double>(every + random() % 100) * unit);
    } else {
      double t = static_cast<double>(random() % 3);
      std::string list;
      for (auto n = 1 + random() % 6; n > 0; --n)
        t += static_cast<double>(1 + random() % 30),
            list += fmt::format("{}{}", list.empty() ? "" : ", ", t * unit);
      run = "at = [" + list + "]\n";
    }
    std::string const said = complaint(run, step);
    if (said.empty()) continue;
    BOOST_REQUIRE_MESSAGE(said.starts_with("f:2:8: step: "), said);
    std::string const before = "the nearest step that would do is ";
    auto const at = said.find(before);
    BOOST_REQUIRE_MESSAGE(at != std::string::npos, run << " by " << step << ": " << said);
    ++named;
    double const nearest = std::stod(said.substr(at + before.size()));
    BOOST_REQUIRE_MESSAGE(complaint(run, nearest).empty(),
                          run << " by " << nearest << ": " << complaint(run, nearest));
    // A divisor of what divides all rows; the ones next to it are farther away, or the same.
    double const divisor = schedule_of(run).common_divisor(), count = std::round(divisor / nearest);
    for (double const other : {count - 1, count + 1})
      if (other >= 1)
        BOOST_REQUIRE_LE(std::abs(nearest - step), std::abs(divisor / other - step) * (1 + 1e-9));
  }
  BOOST_TEST(named > 1000);
}

BOOST_AUTO_TEST_CASE(times_that_no_step_divides_are_refused_in_so_many_words) {
  BOOST_TEST(complaint("at = [1, 3.14159265358979]\n", 0.1).find("have no divisor in common") !=
             std::string::npos);
  BOOST_TEST(complaint("until = 1\n", 1e-30).find("2^53") != std::string::npos);
  BOOST_TEST(complaint("until = 1\n", 5e-324).find("2^53") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_step_off_by_a_part_in_ten_to_the_ninth_is_taken_and_by_more_refused) {
  BOOST_TEST(complaint("until = 1000\n", 1 + 0.5e-9).empty());
  BOOST_TEST(!complaint("until = 1000\n", 1 + 1.5e-9).empty());
  BOOST_TEST(complaint("until = 0.5\n", 0.5 * (1 + 0.5e-9)).empty());
  BOOST_TEST(!complaint("until = 0.5\n", 1).empty());
  BOOST_TEST(!complaint("until = 1e-12\n", 1).empty());  // no step at all is no way to get there
}

BOOST_AUTO_TEST_CASE(wrong_times_are_pointed_at) {
  auto const said = [](std::string const& run) { return message_of([&] { schedule_of(run); }); };
  BOOST_TEST(said("until = 0\n").starts_with("f:2:9: until: a number > 0"));
  BOOST_TEST(said("until = 1\nevery = -1\n").starts_with("f:3:9: every: a number > 0"));
  BOOST_TEST(said("at = [0]\n").starts_with("f:2:"));
  BOOST_TEST(said("at = [0, 1, 1]\n").starts_with("f:2:13: at: each time is later"));
  BOOST_TEST(said("at = [0, 2]\nuntil = 1\n").starts_with("f:2:10: at: times from 0 to until = 1"));
  BOOST_TEST(said("at = [0, 2]\nevery = 1\n").starts_with("f:2:6: at and every exclude each other"));
  BOOST_TEST(said("every = 1\n").starts_with("f:1:1: [run] needs 'until'"));
  BOOST_TEST(said("until = 1\nevery = 1e-17\n").starts_with("f:3:9: every: at most 2^53"));
}

BOOST_AUTO_TEST_SUITE_END()
