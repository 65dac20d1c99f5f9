// Plans, processes and tables of sweeps.
#include <boost/test/unit_test.hpp>

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <set>

#include "program/sweep/crew.hpp"
#include "program/sweep/table.hpp"
#include "refused.hpp"

using namespace actio::scene;

BOOST_AUTO_TEST_SUITE(sweep)

namespace {

MemberResult result_of(long member, int status = 0) {
  MemberResult out;
  out.member = member, out.status = status, out.message = status == 0 ? "" : "tells\nnothing", out.steps = 7,
  out.seconds = 0.5;
  out.drift = {{"energy", 1e-16}}, out.error = {{"momentum", 0.25}}, out.columns = {"t", "energy"},
  out.last_row = {1, 0.1 + 0.2};
  return out;
}

/// Hands members to a crew until all are done.
std::vector<MemberResult> all_of(SweepCrew& crew, long members) {
  std::vector<MemberResult> out;
  for (long next = 0; next < members || crew.busy();) {
    while (next < members && crew.idle()) crew.start(MemberTask::run, next++);
    for (auto& result : crew.finished(100)) out.push_back(std::move(result));
  }
  std::sort(out.begin(), out.end(), [](auto const& a, auto const& b) { return a.member < b.member; });
  return out;
}

}  // namespace

BOOST_AUTO_TEST_CASE(members_are_all_combinations_the_last_key_fastest) {
  SweepPlan const plan("a.toml", {"x=1,2", "y = a, [3,4], \"b,c\"", "z=7"}, {}, "out");
  BOOST_TEST(plan.size() == 6);
  std::set<std::vector<std::string>> seen;
  for (long member = 0; member < plan.size(); ++member) seen.insert(plan.values(member));
  BOOST_TEST(seen.size() == 6u);
  BOOST_TEST(plan.values(4) == (std::vector<std::string>{"2", "[3,4]", "7"}),
             boost::test_tools::per_element());
  BOOST_TEST(plan.values(5) == (std::vector<std::string>{"2", "\"b,c\"", "7"}),
             boost::test_tools::per_element());
  BOOST_TEST(plan.folder(5) == "out/000005");
}

BOOST_AUTO_TEST_CASE(more_members_than_have_names_are_refused) {
  std::string thousand = "x=1";
  for (int k = 2; k <= 1000; ++k) thousand += "," + std::to_string(k);
  std::string other = thousand;
  other[0] = 'y';
  BOOST_TEST(SweepPlan("a.toml", {thousand, other}, {}, "out").size() == 1000000);
  CHECK_REFUSED(SweepPlan("a.toml", {thousand, other, "z=1,2"}, {}, "out"), SceneError);
}

BOOST_AUTO_TEST_CASE(a_result_is_the_same_behind_the_wall_of_its_process) {
  auto const sent = result_of(12, 3), came = MemberResult::unpacked(sent.packed());
  BOOST_TEST(came.packed() == sent.packed());
  BOOST_TEST(came.member == 12);
  BOOST_TEST(came.message == sent.message);
  BOOST_TEST(came.drift.at(0).name == "energy");
  BOOST_TEST(came.last_row == sent.last_row, boost::test_tools::per_element());
  BOOST_CHECK_THROW(MemberResult::unpacked(sent.packed().substr(0, 40)), std::exception);
}

BOOST_AUTO_TEST_CASE(members_run_in_as_many_other_processes_as_there_are_places) {
  pid_t const here = ::getpid();
  SweepCrew crew(
      [&](MemberTask, long member) {
        auto out = result_of(member);
        out.steps = ::getpid();
        return out;
      },
      3);
  std::set<long> processes;
  for (auto const& result : all_of(crew, 10)) processes.insert(result.steps);
  BOOST_TEST(processes.size() <= 3u);
  BOOST_TEST(processes.size() >= 1u);
  BOOST_TEST(!processes.contains(here));
}

BOOST_AUTO_TEST_CASE(a_member_that_crashes_or_is_killed_takes_no_other_with_it) {
  SweepCrew crew(
      [](MemberTask, long member) {
        if (member == 1) std::raise(SIGKILL);
        if (member == 2) std::signal(SIGABRT, SIG_DFL), std::abort();
        if (member == 3) ::_exit(5);
        return result_of(member);
      },
      2);
  auto const results = all_of(crew, 6);
  BOOST_TEST_REQUIRE(results.size() == 6u);
  std::vector<int> status;
  for (auto const& result : results) status.push_back(result.status);
  BOOST_TEST(status == (std::vector<int>{0, 128 + SIGKILL, 128 + SIGABRT, 3, 0, 0}),
             boost::test_tools::per_element());
  BOOST_TEST(results[1].message == "signal 9 ended it: Killed");
}

BOOST_AUTO_TEST_CASE(a_worker_that_could_not_write_is_replaced) {
  SweepCrew crew(
      [](MemberTask, long member) {
        auto out = result_of(member, member == 0 ? 4 : 0);
        out.steps = ::getpid();
        return out;
      },
      1);
  auto const results = all_of(crew, 3);
  BOOST_TEST_REQUIRE(results.size() == 3u);
  BOOST_TEST(results[0].steps != results[1].steps);
  BOOST_TEST(results[1].steps == results[2].steps);
}

BOOST_AUTO_TEST_CASE(a_long_result_comes_whole) {
  SweepCrew crew(
      [](MemberTask, long member) {
        auto out = result_of(member);
        out.last_row.assign(200000, 0.1);
        return out;
      },
      2);
  for (auto const& result : all_of(crew, 6)) BOOST_TEST(result.last_row.size() == 200000u);
}

BOOST_AUTO_TEST_CASE(a_crew_whose_foremen_are_killed_says_so) {
  SweepCrew crew(
      [](MemberTask, long) -> MemberResult {
        ::kill(::getppid(), SIGKILL);
        while (!SweepCrew::told_to_stop()) ::usleep(1000);
        ::_exit(0);  // without a result
      },
      1);
  auto const results = all_of(crew, 1);
  BOOST_TEST_REQUIRE(results.size() == 1u);
  BOOST_TEST(results[0].status == 128 + SIGKILL);
  BOOST_TEST(crew.gone());
}

BOOST_AUTO_TEST_CASE(a_table_has_the_columns_of_all_members_and_empty_cells_for_those_that_failed) {
  SweepPlan const plan("a.toml", {"x=1,2,\"a,b\""}, {}, "out");
  auto other = result_of(2);
  other.drift = {{"casimir", 0.0}}, other.columns = {"t", "casimir"}, other.last_row = {2, 5};
  BOOST_TEST(sweep_table(plan, {result_of(0), result_of(1, 3), other}) ==
             "member,x,status,steps,wall_seconds,drift_energy,drift_casimir,error_momentum,last_t,last_"
             "energy,last_casimir,message\n"
             "0,1,0,7,0.5,9.9999999999999998e-17,,0.25,1,0.30000000000000004,,\n"
             "1,2,3,,,,,,,,,\"tells\nnothing\"\n"
             "2,\"\"\"a,b\"\"\",0,7,0.5,,0,0.25,2,,5,\n");
}

BOOST_AUTO_TEST_SUITE_END()
