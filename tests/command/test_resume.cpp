#include <boost/test/unit_test.hpp>

#include <fstream>

#include "long_scenes.hpp"
#include "process.hpp"

using command::apophis, command::contents, command::long_scenes, command::steps;

namespace {

/// Every file of a folder with its bytes and the time of its last change.
std::map<std::string, std::pair<std::string, std::filesystem::file_time_type>> all_of(
    std::string const& folder) {
  std::map<std::string, std::pair<std::string, std::filesystem::file_time_type>> out;
  for (auto const& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      out[entry.path().string()] = {contents(entry.path().string()), entry.last_write_time()};
  return out;
}

/// A run that was interrupted about in the middle.
struct Interrupted {
  command::Folder folder;
  std::string const scene = folder.write("long.toml", apophis(steps)), out = folder / "long";
  Interrupted() {
    command::Process process({"run", scene, "--quiet"});
    BOOST_REQUIRE(command::appears(out + "/checkpoint"));
    command::sleep_for(0.2);
    process.send(SIGINT);
    auto const outcome = process.wait();
    BOOST_REQUIRE_MESSAGE(outcome.status == 130, outcome.err);
  }
  void change(std::string const& name, std::string const& text) const {
    std::ofstream(out + "/" + name, std::ios::binary) << text;
  }
  command::Outcome resume() const { return command::actio({"resume", out}); }
};

bool says(command::Outcome const& outcome, std::string const& text) {
  return outcome.err.find(text) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(resume)

BOOST_AUTO_TEST_CASE(a_run_that_is_killed_again_and_again_equals_an_unbroken_one_bit_for_bit) {
  unsigned const seed = command::seed();
  std::mt19937 random(seed);
  for (auto const& [name, text] : long_scenes()) {
    command::Folder const folder;
    std::string const scene = folder.write("scene.toml", text), unbroken = folder / "unbroken",
                      broken = folder / "broken";
    auto const began = std::chrono::steady_clock::now();
    auto const whole =
        command::actio({"run", scene, "--out", unbroken, "--quiet"}, "ACTIO_CHECKPOINT_SECONDS=0.03");
    BOOST_REQUIRE_MESSAGE(whole.status == 0, whole.err);
    double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    auto const killed = command::run_with_kills(scene, broken, 5, seconds, random);
    BOOST_TEST_MESSAGE(name << ": " << killed.in_the_middle << " of 5 kills met a run of " << seconds
                            << " s; ACTIO_SEED=" << seed);
    BOOST_TEST(killed.status == 0, killed.err);
    BOOST_TEST(killed.in_the_middle >= 1, "no kill met the run; ACTIO_SEED=" << seed);
    BOOST_TEST((contents(unbroken + "/series.csv") == contents(broken + "/series.csv")),
               name << ": the tables differ; ACTIO_SEED=" << seed);
    BOOST_TEST(command::summary_without_times(unbroken) == command::summary_without_times(broken));
  }
}

BOOST_AUTO_TEST_CASE(a_finished_run_is_said_to_be_finished_and_not_touched) {
  command::Folder const folder;
  command::actio({"run", folder.write("apophis.toml", apophis())});
  auto const before = all_of(folder / "apophis");
  auto const outcome = command::actio({"resume", folder / "apophis/"});
  BOOST_TEST(outcome.status == 0, outcome.err);
  BOOST_TEST(outcome.out ==
             folder / "apophis" + ": the run is finished, with 101 rows to t = 25; nothing is left to do\n");
  BOOST_TEST((all_of(folder / "apophis") == before));
}

BOOST_AUTO_TEST_CASE(what_is_no_folder_of_a_run_is_wrong_use) {
  command::Folder const folder;
  auto const missing = command::actio({"resume", folder / "nowhere"}),
             file = command::actio({"resume", folder.write("file", "")});
  std::filesystem::create_directory(folder / "empty");
  auto const empty = command::actio({"resume", folder / "empty"});
  BOOST_TEST(missing.status == 2);
  BOOST_TEST(missing.err == folder / "nowhere" + ": there is no such folder\n");
  BOOST_TEST(file.status == 2);
  BOOST_TEST(empty.status == 2);
  BOOST_TEST(empty.err == folder / "empty" + ": there is no run in this folder: scene.toml is missing\n");
  BOOST_TEST(std::filesystem::is_empty(folder / "empty"));
}

BOOST_AUTO_TEST_CASE(a_run_that_was_killed_before_its_first_checkpoint_starts_anew_and_says_so) {
  command::Folder const folder;
  command::actio({"run", folder.write("apophis.toml", apophis())});
  std::string const whole = contents(folder / "apophis/series.csv");
  for (char const* name : {"checkpoint", "summary.json"}) std::filesystem::remove(folder / "apophis/" + name);
  std::ofstream(folder / "apophis/series.csv") << "t,bo";
  auto const outcome = command::actio({"resume", folder / "apophis"});
  BOOST_TEST(outcome.status == 0);
  BOOST_TEST(outcome.err ==
             folder / "apophis" + ": there is no checkpoint yet; the run starts anew from its scene.toml\n");
  BOOST_TEST((contents(folder / "apophis/series.csv") == whole));
}

BOOST_AUTO_TEST_CASE(a_damaged_checkpoint_is_refused_wherever_it_is_damaged) {
  Interrupted const run;
  std::string const sound = contents(run.out + "/checkpoint"), table = contents(run.out + "/series.csv");
  unsigned const seed = command::seed();
  std::mt19937 random(seed);
  for (int k = 0; k < 12; ++k) {
    std::string damaged = sound;
    std::size_t const at = random() % sound.size();
    if (k % 3 == 0)
      damaged.resize(at);
    else
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << random() % 8));
    run.change("checkpoint", damaged);
    auto const outcome = run.resume();
    BOOST_TEST(outcome.status == 4, "byte " << at << ", ACTIO_SEED=" << seed);
    BOOST_TEST(says(outcome, run.out + "/checkpoint: "), outcome.err);
  }
  BOOST_TEST((contents(run.out + "/series.csv") == table));
}

BOOST_AUTO_TEST_CASE(a_scene_that_was_changed_since_is_refused) {
  Interrupted const run;
  std::string scene = contents(run.out + "/scene.toml");
  scene.replace(scene.find("0.0649"), 6, "0.0648");
  run.change("scene.toml", scene);
  auto const outcome = run.resume();
  BOOST_TEST(outcome.status == 4);
  BOOST_TEST(says(outcome, "scene.toml beside it was changed since"), outcome.err);
  run.change("scene.toml", scene + "\n[nonsense]\n");
  BOOST_TEST(run.resume().status == 2);
}

BOOST_AUTO_TEST_CASE(a_table_that_was_cut_or_is_missing_is_refused_and_not_filled_up) {
  Interrupted const run;
  std::string const table = contents(run.out + "/series.csv"), cut = table.substr(0, table.size() - 7);
  run.change("series.csv", cut);
  auto outcome = run.resume();
  BOOST_TEST(outcome.status == 4);
  BOOST_TEST(says(outcome, std::to_string(cut.size()) + " bytes, where the checkpoint needs " +
                               std::to_string(table.size())),
             outcome.err);
  BOOST_TEST((contents(run.out + "/series.csv") == cut));
  std::filesystem::remove(run.out + "/series.csv");
  outcome = run.resume();
  BOOST_TEST(outcome.status == 4);
  BOOST_TEST(says(outcome, run.out + "/series.csv: "), outcome.err);
  BOOST_TEST(!std::filesystem::exists(run.out + "/series.csv"));
  run.change("series.csv", table);
  BOOST_TEST(run.resume().status == 0);
}

BOOST_AUTO_TEST_CASE(no_two_processes_run_in_one_folder) {
  command::Folder const folder;
  std::string const scene = folder.write("long.toml", apophis(steps)), out = folder / "long";
  command::Process process({"run", scene, "--quiet"});
  BOOST_REQUIRE(command::appears(out + "/checkpoint"));
  for (auto const& arguments :
       std::vector<std::vector<std::string>>{{"resume", out}, {"run", scene, "--force"}}) {
    auto const second = command::actio(arguments);
    BOOST_TEST(second.status == 4);
    BOOST_TEST(second.err == out + ": another process of actio runs in this folder\n");
  }
  process.send(SIGINT);
  BOOST_TEST(process.wait().status == 130);
}

BOOST_AUTO_TEST_SUITE_END()
