#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "process.hpp"

using command::apophis, command::contents;

namespace {

/// Some tenths of a second of steps, and rows enough.
std::map<std::string, std::string> const long_run{
    {"order", "2"}, {"step", "0.25"}, {"until", "10000000.0"}, {"every", "1000.0"}};
/// Steps for minutes, and no row between the first and the last.
std::map<std::string, std::string> const without_rows{
    {"order", "2"}, {"step", "0.25"}, {"until", "2.5e9"}, {"every", ""}};

bool holds(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }
std::size_t lines_of(std::string const& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// The number that summary.json has under a name.
double in_summary(std::string const& folder, std::string const& name) {
  std::string const text = contents(folder + "/summary.json");
  std::size_t const at = text.find("\"" + name + "\": ");
  return at == std::string::npos ? -1 : std::strtod(text.c_str() + at + name.size() + 4, nullptr);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(endings)

BOOST_AUTO_TEST_CASE(an_interrupted_run_keeps_whole_rows_says_so_and_goes_on_to_the_same_end) {
  command::Folder const folder;
  std::string const scene = folder.write("long.toml", apophis(long_run)), whole = folder / "whole";
  BOOST_REQUIRE(command::actio({"run", scene, "--out", whole}).status == 0);
  for (int const signal : {SIGINT, SIGTERM, SIGHUP}) {
    std::string const out = folder / "signal_" + std::to_string(signal);
    command::Process process({"run", scene, "--out", out});
    BOOST_REQUIRE(command::appears(out + "/checkpoint"));
    command::sleep_for(0.05);
    process.send(signal);
    auto const outcome = process.wait();
    BOOST_TEST(outcome.status == 130);
    BOOST_TEST(holds(outcome.err, "actio resume " + out), outcome.err);
    std::string const table = contents(out + "/series.csv");
    BOOST_TEST((table.ends_with('\n') && contents(whole + "/series.csv").starts_with(table)));
    BOOST_TEST(table.size() < contents(whole + "/series.csv").size());
    BOOST_TEST(holds(contents(out + "/summary.json"), "\"status\": \"interrupted\""));
    BOOST_TEST(in_summary(out, "rows") + 1 == static_cast<double>(lines_of(table)));
    BOOST_TEST(command::actio({"resume", out}).status == 0);
    BOOST_TEST((contents(out + "/series.csv") == contents(whole + "/series.csv")));
    BOOST_TEST(command::summary_without_times(out) == command::summary_without_times(whole));
  }
}

BOOST_AUTO_TEST_CASE(steps_without_rows_are_interrupted_and_kept_between_rows) {
  command::Folder const folder;
  std::string const scene = folder.write("long.toml", apophis(without_rows)), out = folder / "long";
  double steps = 0, seconds = 0;
  for (int part = 0; part < 2; ++part) {
    {  // Killed after some checkpoints.
      command::Process process(part == 0 ? std::vector<std::string>{"run", scene}
                                         : std::vector<std::string>{"resume", out});
      BOOST_REQUIRE(command::appears(out + "/checkpoint"));
      command::sleep_for(0.4);
      process.send(SIGKILL);
      BOOST_TEST(process.wait().status == 128 + SIGKILL);
    }
    auto const written = std::filesystem::last_write_time(out + "/checkpoint");
    command::Process process({"resume", out});
    // It goes on, and hears an interrupt, once it has written a checkpoint of its own.
    for (int k = 0; k < 1200 && std::filesystem::last_write_time(out + "/checkpoint") == written; ++k)
      command::sleep_for(0.05);
    process.send(SIGINT);
    BOOST_TEST(process.wait().status == 130);
    // Long before the end, at 1e10 steps.
    BOOST_TEST(in_summary(out, "steps") < 5e9);
    BOOST_TEST(in_summary(out, "rows") == 1);
    BOOST_TEST(in_summary(out, "steps") > steps);
    BOOST_TEST(in_summary(out, "wall_seconds") > seconds);
    steps = in_summary(out, "steps"), seconds = in_summary(out, "wall_seconds");
  }
}

BOOST_AUTO_TEST_CASE(a_full_disk_keeps_whole_rows_and_the_run_goes_on_when_there_is_room) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", apophis()), out = folder / "apophis",
                    whole = folder / "whole";
  BOOST_REQUIRE(command::actio({"run", scene, "--out", whole}).status == 0);
  std::string const all = contents(whole + "/series.csv");
  // From too little for the copy of the scene up to the last block of the table.
  int kept = 0;
  for (std::size_t blocks = 0; blocks <= all.size() / 512; ++blocks) {
    auto const outcome =
        command::actio({"run", scene, "--force"}, "ulimit -f " + std::to_string(blocks) + ";");
    BOOST_TEST(outcome.status == 4);
    if (blocks > 0) {  // and room for the complaint, which is in a file, too
      BOOST_TEST(lines_of(outcome.err) == 1u, outcome.err);
      BOOST_TEST(holds(outcome.err, "File too large"), outcome.err);
    }
    std::string const table = contents(out + "/series.csv");
    BOOST_TEST((table.empty() || (table.ends_with('\n') && all.starts_with(table))));
    if (std::filesystem::exists(out + "/summary.json")) {
      BOOST_TEST(holds(contents(out + "/summary.json"), "\"status\": \"failed\""));
      BOOST_TEST(holds(contents(out + "/summary.json"), "File too large"));
      ++kept;
    }
    if (!std::filesystem::exists(out + "/scene.toml")) continue;
    BOOST_TEST(command::actio({"resume", out}).status == 0);
    BOOST_TEST((contents(out + "/series.csv") == all));
    BOOST_TEST(command::summary_without_times(out) == command::summary_without_times(whole));
  }
  BOOST_TEST(kept > 0);
}

BOOST_AUTO_TEST_CASE(nobody_has_to_listen) {
  command::Folder const folder;
  // A remark at the start, on standard error, and a line at the end on standard output.
  std::string const scene = folder.write("long.toml", apophis({{"attitude", "[1.0000000001, 0, 0, 0]"}}));
  auto const heard = command::actio({"run", scene, "--out", folder / "whole"});
  BOOST_REQUIRE(heard.status == 0);
  BOOST_TEST((lines_of(heard.err) == 1 && lines_of(heard.out) == 1));
  std::string const all = contents(folder / "whole/series.csv");
  for (char const* streams : {"</dev/null >/dev/full 2>/dev/full", "<&- >&- 2>&-", "2>&1 | true"}) {
    std::string const line =
        "('" ACTIO_COMMAND "' run '" + scene + "' --force; echo $? >'" + folder / "status" + "') ";
    [[maybe_unused]] int const shell = std::system((line + streams).c_str());
    BOOST_TEST(contents(folder / "status") == "0\n", streams);
    BOOST_TEST((contents(folder / "long/series.csv") == all), streams);
  }
}

BOOST_AUTO_TEST_CASE(a_folder_that_cannot_be_made_or_written_fails_with_its_name) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", apophis()), file = folder.write("file", "kept");
  auto const below = command::actio({"run", scene, "--out", file + "/out"});
  BOOST_TEST(below.status == 4);
  BOOST_TEST(below.err.starts_with(file + "/out: "), below.err);
  auto const itself = command::actio({"run", scene, "--out", file, "--force"});
  BOOST_TEST(itself.status == 2);
  BOOST_TEST(contents(file) == "kept");
  if (::geteuid() == 0) return;  // whom no permission stops
  std::filesystem::create_directory(folder / "closed");
  std::filesystem::permissions(folder / "closed",
                               std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  BOOST_TEST(command::actio({"run", scene, "--out", folder / "closed"}).status == 4);
  BOOST_TEST(command::actio({"run", scene, "--out", folder / "closed/out"}).status == 4);
}

BOOST_AUTO_TEST_CASE(a_folder_that_is_not_empty_is_refused_and_force_replaces_the_run_and_nothing_else) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", apophis()), out = folder / "apophis";
  BOOST_REQUIRE(command::actio({"run", scene}).status == 0);
  std::string const before = contents(out + "/series.csv");
  for (char const* name : {"/checkpoint.part", "/notes.txt"}) std::ofstream(out + name) << "of before";
  auto const refused = command::actio({"run", scene, "--set", "run.until=5.0"});
  BOOST_TEST(refused.status == 2);
  BOOST_TEST(refused.err.starts_with(out + ": the folder is not empty"), refused.err);
  BOOST_TEST((contents(out + "/series.csv") == before));
  BOOST_TEST(command::actio({"run", scene, "--set", "run.until=5.0", "--force"}).status == 0);
  BOOST_TEST(lines_of(contents(out + "/series.csv")) == 22u);
  BOOST_TEST(!std::filesystem::exists(out + "/checkpoint.part"));
  BOOST_TEST(contents(out + "/notes.txt") == "of before");
}

BOOST_AUTO_TEST_CASE(the_scene_that_is_read_is_not_written_over) {
  command::Folder const folder;
  std::string const text = "# my own words\n" + apophis(), scene = folder.write("scene.toml", text);
  std::string const here = std::filesystem::path(scene).parent_path().string();
  BOOST_TEST(command::actio({"run", scene, "--out", here, "--force"}).status == 2);
  BOOST_TEST(contents(scene) == text);
}

BOOST_AUTO_TEST_CASE(a_step_too_long_leaves_nothing_and_says_the_longest) {
  command::Folder const folder;
  std::string const scene = folder.write(
                        "apophis.toml",
                        apophis({{"order", "2"}, {"step", "50.0"}, {"every", "50.0"}, {"until", "100.0"}})),
                    out = folder / "apophis";
  auto const dry = command::actio({"run", scene, "--dry-run"});
  BOOST_TEST(dry.status == 3);
  BOOST_TEST(!std::filesystem::exists(out));
  auto const run = command::actio({"run", scene});
  BOOST_TEST(run.status == 3);
  BOOST_TEST(run.err.starts_with(scene + ":15:8: "), run.err);
  BOOST_TEST(holds(run.err, "the largest step that would do is 4.3"), run.err);
  BOOST_TEST(run.err == dry.err);
  BOOST_TEST(!std::filesystem::exists(out));
  // The corrected run has the folder, and what is in it is not touched by the next refusal.
  BOOST_TEST(command::actio({"run", scene, "--set", "method.step=2.5"}).status == 0);
  std::string const table = contents(out + "/series.csv");
  BOOST_TEST(command::actio({"run", scene, "--force"}).status == 3);
  BOOST_TEST(contents(out + "/series.csv") == table);
}

BOOST_AUTO_TEST_SUITE_END()
