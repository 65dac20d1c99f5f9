// Sweeps, driven through the command.
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "process.hpp"

BOOST_AUTO_TEST_SUITE(sweep)

namespace {

namespace fs = std::filesystem;
using Row = std::vector<std::string>;

/// A table whose cells may be texts or empty; commas between quotes do not part cells.
std::vector<Row> read_table(std::string const& path) {
  std::vector<Row> out;
  std::istringstream lines(command::contents(path));
  for (std::string line; std::getline(lines, line);) {
    out.emplace_back(1);
    bool quoted = false;
    for (char const c : line) {
      if (c == '"')
        quoted = !quoted;
      else if (c == ',' && !quoted)
        out.back().emplace_back();
      else
        out.back().back() += c;
    }
  }
  return out;
}
std::string cell(std::vector<Row> const& table, std::size_t member, std::string const& column) {
  auto const found = std::find(table.at(0).begin(), table[0].end(), column);
  if (found == table[0].end()) throw std::runtime_error("no column " + column);
  return table.at(member + 1).at(static_cast<std::size_t>(found - table[0].begin()));
}
/// The same without the one column that tells of the clock.
std::vector<Row> timeless(std::vector<Row> table) {
  auto const at = std::find(table.at(0).begin(), table[0].end(), "wall_seconds") - table[0].begin();
  for (Row& row : table) row.erase(row.begin() + at);
  return table;
}
void check_same_table(std::vector<Row> const& a, std::vector<Row> const& b) {
  BOOST_TEST_REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) BOOST_TEST(a[i] == b[i], boost::test_tools::per_element());
}

std::string const series = "series.csv", scene_copy = "scene.toml";

}  // namespace

BOOST_AUTO_TEST_CASE(every_combination_is_the_run_that_it_would_be_alone) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis({{"order", "2"}}));
  auto const outcome =
      command::actio({"sweep", scene, "--over", "method.step=0.125,0.25", "--over", "run.until=5.0,10.0,15.0",
                      "--set", "scene.title=swept", "--out", folder / "sweep", "--quiet"});
  BOOST_TEST(outcome.status == 0, outcome.err);
  BOOST_TEST(outcome.err == "");
  std::vector<std::string> const steps{"0.125", "0.25"}, ends{"5.0", "10.0", "15.0"};
  auto const table = read_table(folder / "sweep/sweep.csv");
  BOOST_TEST(table.size() == 7u);
  for (std::size_t member = 0; member < 6; ++member) {
    std::string const step = steps[member / 3], end = ends[member % 3],
                      name = "sweep/00000" + std::to_string(member) + "/";
    BOOST_TEST(cell(table, member, "member") == std::to_string(member));
    BOOST_TEST(cell(table, member, "method.step") == step);
    BOOST_TEST(cell(table, member, "run.until") == end);
    std::string const alone = "alone" + std::to_string(member) + "/";
    command::actio({"run", scene, "--set", "scene.title=swept", "--set", "method.step=" + step, "--set",
                    "run.until=" + end, "--out", folder / alone, "--quiet"});
    BOOST_TEST(!command::contents(folder / (alone + series)).empty());
    for (auto const& file : {series, scene_copy})
      BOOST_TEST(command::contents(folder / (name + file)) == command::contents(folder / (alone + file)));
  }
}

BOOST_AUTO_TEST_CASE(the_table_holds_status_steps_drift_and_the_last_row_of_each_member) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis({{"order", "2"}}));
  auto const outcome = command::actio({"sweep", scene, "--over", "method.step=0.125,0.25", "--quiet"});
  BOOST_TEST(outcome.status == 0, outcome.err);
  auto const table = read_table(folder / "apophis/sweep.csv");
  std::string const text = command::contents(folder / "apophis/sweep.csv");
  BOOST_TEST(text.substr(0, text.find('\n')) ==
             "member,method.step,status,steps,wall_seconds,drift_energy,error_momentum,last_t,"
             "last_body_momentum_x,last_body_momentum_y,last_body_momentum_z,last_energy,message");
  for (std::size_t member = 0; member < 2; ++member) {
    BOOST_TEST(cell(table, member, "status") == "0");
    BOOST_TEST(cell(table, member, "steps") == (member == 0 ? "200" : "100"));
    std::string const name = "apophis/00000" + std::to_string(member);
    auto const rows = command::read_csv(folder / (name + "/series.csv"));
    for (std::string const column : {"t", "body_momentum_x", "body_momentum_y", "body_momentum_z", "energy"})
      BOOST_TEST(std::stod(cell(table, member, "last_" + column)) == rows[column].back());
    // The drift over the rows, as anybody would work it out from them.
    auto const energy = rows["energy"];
    double drift = 0;
    for (double const e : energy) drift = std::max(drift, std::abs(e - energy[0]) / energy[0]);
    BOOST_TEST(std::stod(cell(table, member, "drift_energy")) == drift);
  }
}

BOOST_AUTO_TEST_CASE(the_number_of_jobs_changes_no_digit) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis());
  for (std::string const jobs : {"1", "3"}) {
    auto const outcome =
        command::actio({"sweep", scene, "--over", "scene.seed=1,2,3", "--over", "method.order=2,4,\"exact\"",
                        "--jobs", jobs, "--out", folder / jobs, "--quiet"});
    BOOST_TEST(outcome.status == 0, outcome.err);
  }
  check_same_table(timeless(read_table(folder / "1/sweep.csv")),
                   timeless(read_table(folder / "3/sweep.csv")));
  int compared = 0;
  for (auto const& entry : fs::directory_iterator(folder / "1")) {
    if (!entry.is_directory()) continue;
    std::string const other = folder / ("3/" + entry.path().filename().string() + "/");
    for (auto const& file : {series, scene_copy})
      BOOST_TEST(command::contents((entry.path() / file).string()) == command::contents(other + file));
    ++compared;
  }
  BOOST_TEST(compared == 9);
}

BOOST_AUTO_TEST_CASE(a_failed_member_is_named_and_the_others_are_kept) {
  command::Folder const folder;
  std::string const scene =
      folder.write("apophis.toml", command::apophis({{"order", "2"}, {"every", "25.0"}}));
  // In order; no number; a step in which the body turns too far for the scheme; not met by the rows.
  auto const outcome = command::actio(
      {"sweep", scene, "--over", "method.step=0.25,fast,25.0,0.3,0.125", "--out", folder / "sweep"});
  auto const table = read_table(folder / "sweep/sweep.csv");
  Row const expected{"0", "2", "3", "2", "0"};
  for (std::size_t member = 0; member < 5; ++member) {
    BOOST_TEST(cell(table, member, "status") == expected[member]);
    bool const done = expected[member] == "0";
    for (std::string const column : {"steps", "wall_seconds", "drift_energy", "last_t", "last_energy"})
      BOOST_TEST(cell(table, member, column).empty() == !done);
    std::string const name =
        "00000" + std::to_string(member) + " (method.step=" + cell(table, member, "method.step") + "): ";
    BOOST_TEST((outcome.err.find(name) == std::string::npos) == done, outcome.err);
    std::string const message = cell(table, member, "message");
    BOOST_TEST(message.empty() == done);
    if (!done) BOOST_TEST(outcome.err.find(name + message + "\n") != std::string::npos, message);
  }
  BOOST_TEST(outcome.status == 3);
  BOOST_TEST(outcome.err.find("000001 (method.step=fast): ") != std::string::npos);
  BOOST_TEST(outcome.err.find("a number is expected, found 'fast'") != std::string::npos, outcome.err);
  std::string const closing =
      folder / "sweep" + ": 5 members, 2 done, 3 failed (2 with status 2, 1 with status 3), in ";
  BOOST_TEST(outcome.out.starts_with(closing), outcome.out);
  BOOST_TEST(outcome.out.ends_with(" s; table " + folder / "sweep/sweep.csv" + "\n"), outcome.out);
}

BOOST_AUTO_TEST_CASE(a_member_that_cannot_write_takes_no_other_with_it) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis());
  // The shell counts in pieces of 512 bytes: the table of the first member is longer, all that the second
  // leaves is shorter.
  auto const outcome = command::actio(
      {"sweep", scene, "--over", "run.every=0.25,12.5", "--out", folder / "sweep"}, "ulimit -f 8;");
  auto const table = read_table(folder / "sweep/sweep.csv");
  BOOST_TEST(cell(table, 0, "status") != "0");
  BOOST_TEST(outcome.status == std::stoi(cell(table, 0, "status")));
  BOOST_TEST(outcome.err.find("000000 (run.every=0.25): ") != std::string::npos, outcome.err);
  BOOST_TEST(cell(table, 1, "status") == "0");
  BOOST_TEST(cell(table, 1, "last_t") == "25");
}

BOOST_AUTO_TEST_CASE(a_sweep_without_a_member_in_order_leaves_nothing) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis());
  auto const status_of = [&](std::string const& over, std::string const& says) {
    auto const outcome = command::actio({"sweep", scene, "--over", over, "--out", folder / "sweep"});
    BOOST_TEST(outcome.err.find(says) != std::string::npos, outcome.err);
    BOOST_TEST(!fs::exists(folder / "sweep"));
    return outcome.status;
  };
  BOOST_TEST(status_of("method.stp=0.125,0.25", "'stp'; did you mean 'step'?") == 2);
  BOOST_TEST(status_of("system.body=apophi,apofis", "did you mean 'apophis'?") == 2);
  BOOST_TEST(status_of("method.step", "KEY=a,b,c is expected") == 2);
  BOOST_TEST(status_of("method.step=0.1,,0.2", "value 2 of 'method.step' is empty") == 2);
  auto const twice = command::actio({"sweep", scene, "--over", "method.step=1", "--over", "method.step=2"});
  BOOST_TEST(twice.status == 2);
  BOOST_TEST(twice.err.find("'method.step' is swept twice") != std::string::npos, twice.err);
  auto const nowhere = command::actio({"sweep", folder / "apofis.toml", "--over", "method.step=1,2"});
  BOOST_TEST(nowhere.status == 2);
  BOOST_TEST(nowhere.err.starts_with(folder / "apofis.toml" + ": there is no such file"), nowhere.err);
  BOOST_TEST(std::count(nowhere.err.begin(), nowhere.err.end(), '\n') == 1);
}

BOOST_AUTO_TEST_CASE(a_folder_with_something_in_it_is_refused_unless_it_is_to_be_replaced) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis());
  auto const sweep = [&](std::string const& over, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"sweep", scene, "--over", over, "--quiet"});
    return command::actio(more);
  };
  BOOST_TEST(sweep("scene.seed=1,2,3").status == 0);
  std::string const before = command::contents(folder / "apophis/sweep.csv");
  auto const refused = sweep("scene.seed=4,5");
  BOOST_TEST(refused.status == 2);
  BOOST_TEST(refused.err.find(
                 "the folder is not empty; --force replaces the sweep in it, actio resume goes on with it") !=
                 std::string::npos,
             refused.err);
  BOOST_TEST(command::contents(folder / "apophis/sweep.csv") == before);
  BOOST_TEST(sweep("scene.seed=4,5", {"--force"}).status == 0);
  BOOST_TEST(read_table(folder / "apophis/sweep.csv").size() == 3u);
  BOOST_TEST(!fs::exists(folder / "apophis/000002"));
}

BOOST_AUTO_TEST_CASE(an_interrupted_sweep_keeps_what_is_done) {
  command::Folder const folder;
  // Rows at the start and at the end alone: the second and the third member would take days.
  std::string const scene = folder.write("apophis.toml", command::apophis({{"order", "2"}, {"every", ""}}));
  auto const outcome = command::actio({"sweep", scene, "--over", "run.until=25.0,2.5e13,2.5e14", "--jobs",
                                       "2", "--out", folder / "sweep", "--quiet"},
                                      "timeout --preserve-status -s INT 2");
  BOOST_TEST(outcome.status == 130);
  BOOST_TEST(outcome.err ==
             "interrupted: 1 of 3 members are done; actio resume " + folder / "sweep" + " goes on\n");
  auto const table = read_table(folder / "sweep/sweep.csv");
  BOOST_TEST(cell(table, 0, "status") == "0");
  BOOST_TEST(cell(table, 0, "last_t") == "25");
  for (std::size_t member : {1, 2}) {
    BOOST_TEST(cell(table, member, "status") == "130");
    BOOST_TEST(cell(table, member, "last_t") == "");
    BOOST_TEST(
        command::read_csv(folder / ("sweep/00000" + std::to_string(member) + "/series.csv")).rows.size() ==
        1u);
  }
}

BOOST_AUTO_TEST_CASE(members_draw_the_pictures_that_their_scene_asks_for) {
  command::Folder const folder;
  auto const outcome = command::actio({"sweep", folder.write("apophis.toml", command::apophis()), "--over",
                                       "output.plots=true,false", "--out", folder / "sweep", "--quiet"});
  BOOST_TEST(outcome.status == 0, outcome.err);
  BOOST_TEST(!command::contents(folder / "sweep/000000/plots/energy.svg").empty());
  BOOST_TEST(!fs::exists(folder / "sweep/000001/plots"));
}

BOOST_AUTO_TEST_CASE(values_with_commas_are_quoted_in_the_table) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis());
  auto const outcome =
      command::actio({"sweep", scene, "--over", "initial.angular_velocity=[0.1,0.2,0.3],[0.3,0.2,0.1]",
                      "--over", "scene.title=\"a, b\"", "--out", folder / "sweep", "--quiet"});
  BOOST_TEST(outcome.status == 0, outcome.err);
  std::string const table = command::contents(folder / "sweep/sweep.csv");
  BOOST_TEST(table.find("\n0,\"[0.1,0.2,0.3]\",\"\"\"a, b\"\"\",0,") != std::string::npos, table);
  BOOST_TEST(table.find("\n1,\"[0.3,0.2,0.1]\",\"\"\"a, b\"\"\",0,") != std::string::npos, table);
}

BOOST_AUTO_TEST_CASE(a_killed_or_interrupted_sweep_goes_on_to_the_table_of_an_unbroken_one) {
  command::Folder const folder;
  // Members of some tenths of a second, with one that is refused and one whose step is too long.
  std::string const scene = folder.write(
      "apophis.toml", command::apophis({{"order", "2"}, {"until", "4500000.0"}, {"every", "50000.0"}}));
  std::vector<std::string> const over{
      "--over", "method.step=0.25,fast,0.125,25000.0,0.5", "--over", "scene.seed=1,2", "--jobs", "2"};
  auto const started = [&](std::string const& out) {
    std::vector<std::string> arguments{"sweep", scene, "--out", out};
    arguments.insert(arguments.end(), over.begin(), over.end());
    return arguments;
  };
  BOOST_TEST(command::actio(started(folder / "whole")).status == 3);
  std::string const out = folder / "broken";
  auto const cut_short = [&](int signal, double seconds) {
    command::Process sweep(fs::exists(out) ? std::vector<std::string>{"resume", out, "--jobs", "2"}
                                           : started(out));
    BOOST_TEST(command::appears(out + "/sweep.toml"));
    command::sleep_for(seconds);
    sweep.send(signal);
    auto const outcome = sweep.wait();
    BOOST_TEST(outcome.status == (signal == SIGINT ? 130 : 128 + SIGKILL), outcome.err);
    return outcome.err;
  };
  cut_short(SIGKILL, 0.15);
  // An interrupt may come before the command listens, and ends it without a word.
  std::string said;
  for (double seconds = 0.1; said.empty() && seconds < 0.5; seconds += 0.1) said = cut_short(SIGINT, seconds);
  BOOST_TEST(said.find("members are done; actio resume " + out + " goes on\n") != std::string::npos, said);
  cut_short(SIGKILL, 0.1);
  auto const last = command::actio({"resume", out});
  BOOST_TEST(last.status == 3, last.err);
  check_same_table(timeless(read_table(folder / "whole/sweep.csv")),
                   timeless(read_table(out + "/sweep.csv")));
  for (std::string const member : {"000000", "000005", "000009"})
    BOOST_TEST(command::contents(out + "/" + member + "/series.csv") ==
               command::contents(folder / ("whole/" + member + "/series.csv")));
  // Once more there is nothing to do, and a table that was lost is written again.
  std::string const table = command::contents(out + "/sweep.csv");
  fs::remove(out + "/sweep.csv");
  auto const again = command::actio({"resume", out});
  BOOST_TEST(again.out == out + ": the sweep is finished, with 10 members; nothing is left to do\n");
  BOOST_TEST(command::contents(out + "/sweep.csv") == table);
}

BOOST_AUTO_TEST_CASE(no_two_sweeps_run_in_one_folder) {
  command::Folder const folder;
  std::string const scene =
                        folder.write("apophis.toml",
                                     command::apophis({{"order", "2"}, {"until", "2.5e13"}, {"every", ""}})),
                    out = folder / "sweep";
  command::Process first({"sweep", scene, "--over", "scene.seed=1,2", "--out", out});
  BOOST_TEST(command::appears(out + "/000000/scene.toml"));
  for (auto const& arguments : std::vector<std::vector<std::string>>{
           {"sweep", scene, "--over", "scene.seed=3,4", "--out", out},
           {"sweep", scene, "--over", "scene.seed=3,4", "--out", out, "--force"},
           {"resume", out}}) {
    auto const second = command::actio(arguments);
    BOOST_TEST(second.status == 4);
    BOOST_TEST(second.err == out + ": another process of actio runs in this folder\n");
  }
  first.send(SIGINT);
  BOOST_TEST(first.wait().status == 130);
}

BOOST_AUTO_TEST_CASE(ranges_lists_of_numbers_items_of_lists_and_files_give_the_values) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis()),
                    values = folder.write("ends.txt", "\xEF\xBB\xBF# ends\n5\n\n10.0, 15\n");
  auto const swept = [&](std::string const& over, std::string const& column) {
    auto const outcome =
        command::actio({"sweep", scene, "--over", over, "--out", folder / "sweep", "--force", "--quiet"});
    BOOST_TEST(outcome.status == 0, outcome.err);
    auto const table = read_table(folder / "sweep/sweep.csv");
    std::string out;
    for (std::size_t member = 0; member + 1 < table.size(); ++member)
      out += (member ? " " : "") + cell(table, member, column);
    return out;
  };
  BOOST_TEST(swept("run.until=2.5:10:2.5", "last_t") == "2.5 5 7.5 10");
  BOOST_TEST(swept("initial.angular_velocity[1]=0.1:0.5:0.1", "initial.angular_velocity[1]") ==
             "0.1 0.2 0.3 0.4 0.5");
  BOOST_TEST(swept("scene.seed=7:1:-3", "scene.seed") == "7 4 1");
  BOOST_TEST(swept("run.until=linspace(5, 10, 3)", "last_t") == "5 7.5 10");
  BOOST_TEST(swept("initial.angular_velocity[0]=geomspace(0.001, 1, 4)", "initial.angular_velocity[0]") ==
             "0.001 0.01 0.1 1.0");
  BOOST_TEST(swept("initial.angular_velocity[0]=logspace(-2, 0, 3),7:8:1", "initial.angular_velocity[0]") ==
             "0.01 0.1 1.0 7 8");
  BOOST_TEST(swept("run.until=@" + values, "last_t") == "5 10 15");
  // The item is that of the scene: the first momentum is the moment of inertia times it.
  std::string const first = command::contents(folder / "sweep/000000/scene.toml");
  swept("initial.angular_velocity[2]=0.5", "status");
  BOOST_TEST(command::contents(folder / "sweep/000000/scene.toml").find(", 0.5]") != std::string::npos);
  BOOST_TEST(first.find(", 0.5]") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(values_that_cannot_be_are_refused_with_what_would_do) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis());
  auto const refused = [&](std::vector<std::string> arguments, std::string const& says) {
    arguments.insert(arguments.begin(), {"sweep", scene, "--out", folder / "sweep"});
    auto const outcome = command::actio(arguments);
    BOOST_TEST(outcome.status == 2, outcome.out);
    BOOST_TEST(outcome.err.find(says) != std::string::npos, outcome.err);
    BOOST_TEST(!fs::exists(folder / "sweep"));
  };
  refused({"--over", "run.until=1:5:0"}, "steps of 0 do not lead from 1 to 5");
  refused({"--over", "run.until=1:5:-1"}, "steps of -1 do not lead from 1 to 5");
  refused({"--over", "run.until=0:1:1e-9"}, "a key has at most 1000000 values");
  refused({"--over", "run.until=a:b:c"}, "START:STOP:STEP is expected");
  refused({"--over", "run.until=linspace(1,2)"}, "linspace(FIRST, LAST, HOW_MANY) is expected");
  refused({"--over", "run.until=geomspace(0,2,3)"}, "two numbers of one sign");
  refused({"--over", "run.until=@" + folder / "nowhere"}, "there is no file");
  refused({"--over", "run.until=@" + folder.write("none", "# none\n")}, "there is no value in the file");
  refused({"--over", "initial.angular_velocity[3]=1,2"},
          "the list has 3 items, counted from 0; there is no item 3");
  refused({"--over", "run.until[0]=1,2"}, "a list is expected there, found 25");
  refused({"--over", "initial.angular_velocity[0]=1,2", "--over", "initial.angular_velocity=[1,2,3]"},
          "is swept twice");
  refused({"--over", "run.until=1,2", "--set", "run . until=3"},
          "--set run . until=3: 'run.until' is swept, so that to set it would be without effect");
  refused({"--over", "run.until=1,2", "--unset", "system.inertia"},
          "--unset system.inertia: the scene has no key 'system.inertia' that could be taken out");
}

BOOST_AUTO_TEST_CASE(a_key_that_is_unset_makes_room_for_another) {
  command::Folder const folder;
  std::string const scene =
      folder.write("body.toml",
                   "[system]\nkind = \"rigid_body\"\ninertia = [0.6, 0.8, 1.0]\n[initial]\n"
                   "angular_velocity = [1, 2, 3]\n[run]\nuntil = 1\n[output]\nquantities = [\"energy\"]\n");
  BOOST_TEST(command::actio({"sweep", scene, "--over", "system.body=apophis,t_handle"}).status == 2);
  auto const outcome = command::actio(
      {"sweep", scene, "--over", "system.body=apophis,t_handle", "--unset", "system.inertia", "--quiet"});
  BOOST_TEST(outcome.status == 0, outcome.err);
  BOOST_TEST(command::actio({"run", scene, "--unset", "system.inertia", "--set", "system.body=apophis",
                             "--out", folder / "run"})
                 .status == 0);
  BOOST_TEST(command::contents(folder / "run/series.csv") ==
             command::contents(folder / "body/000000/series.csv"));
}

BOOST_AUTO_TEST_CASE(many_complaints_are_told_by_the_first_few_and_quiet_tells_none) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis({{"order", "2"}}));
  std::vector<std::string> arguments{
      "sweep", scene, "--over", "method.step=0.25,fast", "--over", "scene.seed=1:500:1", "--force"};
  auto const told = command::actio(arguments);
  BOOST_TEST(told.status == 2);
  BOOST_TEST(std::count(told.err.begin(), told.err.end(), '\n') <= 12, told.err);
  BOOST_TEST(told.err.ends_with("... and 497 more; " + folder / "apophis/sweep.csv" + " has each message\n"),
             told.err);
  auto const table = read_table(folder / "apophis/sweep.csv");
  for (std::size_t member : {500, 777, 999})
    BOOST_TEST(cell(table, member, "message").find("a number is expected, found 'fast'") !=
               std::string::npos);
  arguments.push_back("--quiet");
  auto const quiet = command::actio(arguments);
  BOOST_TEST(quiet.status == 2);
  BOOST_TEST(quiet.err + quiet.out == "");
}

BOOST_AUTO_TEST_CASE(a_dry_run_tells_members_rows_bytes_and_refusals_and_writes_nothing) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis({{"order", "2"}}));
  auto const outcome = command::actio(
      {"sweep", scene, "--over", "method.step=0.25,0.3", "--over", "run.until=5:25:5", "--dry-run"});
  BOOST_TEST(outcome.status == 2);
  for (std::string const says :
       {"members     10\n", "method.step = 0.25, 0.3\n", "run.until = 5, 10, 15, 20, 25\n",
        "rows        21 to 101 in each\n", "kB in all\n", "refused     5 of 10:\n",
        "000005 (method.step=0.3, run.until=5): ", "Nothing was run.\n"})
    BOOST_TEST(outcome.out.find(says) != std::string::npos, outcome.out);
  BOOST_TEST(!fs::exists(folder / "apophis"));
  BOOST_TEST(command::actio({"sweep", scene, "--over", "run.until=5,10", "--dry-run"}).status == 0);
  BOOST_TEST(!fs::exists(folder / "apophis"));
}

BOOST_AUTO_TEST_CASE(plots_draws_pictures_of_each_member) {
  command::Folder const folder;
  auto const outcome = command::actio({"sweep", folder.write("apophis.toml", command::apophis()), "--over",
                                       "run.until=5,10", "--plots", "--quiet"});
  BOOST_TEST(outcome.status == 0, outcome.err);
  for (std::string const member : {"000000", "000001"})
    BOOST_TEST(fs::exists(folder / ("apophis/" + member + "/plots/index.html")));
}

BOOST_AUTO_TEST_CASE(a_member_of_little_work_costs_little) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis({{"order", "2"}}));
  auto const alone = command::cost({"run", scene, "--out", folder / "alone", "--quiet"}),
             all = command::cost({"sweep", scene, "--over", "scene.seed=1:500:1", "--jobs", "2", "--quiet"});
  BOOST_TEST_REQUIRE(alone.status == 0);
  BOOST_TEST_REQUIRE(all.status == 0);
  BOOST_TEST_MESSAGE("500 members of a sweep touch " << all.pages << " pages of memory in " << all.work
                                                     << " s, and a run alone " << alone.pages << " in "
                                                     << alone.work << " s");
  // The processes that run the members start once; a process for each would touch hundreds of times as many.
  BOOST_TEST(all.pages < 10 * alone.pages);
}

BOOST_AUTO_TEST_CASE(reading_many_scenes_shows_how_far_it_is) {
  command::Folder const folder;
  std::string const scene =
      folder.write("apophis.toml", command::apophis({{"order", "2"}, {"step", "fast"}}));
  auto const outcome = command::actio({"sweep", scene, "--over", "scene.seed=1:50000:1", "--jobs", "1"});
  BOOST_TEST(outcome.status == 2);
  BOOST_TEST(outcome.err.find(" of 50000 scenes are read   ") != std::string::npos, outcome.err);
  BOOST_TEST(outcome.err.find(" left\n") != std::string::npos, outcome.err);
}

BOOST_AUTO_TEST_SUITE_END()
