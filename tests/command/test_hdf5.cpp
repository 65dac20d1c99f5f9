// series.h5 is whole at any instant: while the run goes on, after it was killed, on a full disk; who has it
// open goes on reading what there was; and a damaged one is refused by readers and made again.
#include <boost/test/unit_test.hpp>

#include <hdf5.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <fstream>
#include <map>

#include "hdf5_table.hpp"
#include "process.hpp"

namespace {

using command::apophis, command::contents, command::Folder;

std::map<std::string, std::string> scene_of(std::string const& until) {
  return {{"until", until},
          {"every", "0.25"},
          {"quantities", "[\"attitude\", \"energy\"]"},
          {"formats", "[\"hdf5\"]"}};
}

/// What `h5ls` and the library make of a file; an exception where one of them refuses it.
command::Hdf5Table read_plainly(std::string const& path) {
  if (command::shell("h5ls -r '" + path + "' && h5dump -H '" + path + "'").status != 0)
    throw std::runtime_error(path + ": h5ls or h5dump cannot open it");
  return command::read_hdf5(path);
}
/// Whether the rows are the first ones of a whole table.
bool begins(command::Table const& whole, command::Table const& part) {
  return part.columns == whole.columns && part.rows.size() <= whole.rows.size() &&
         std::equal(part.rows.begin(), part.rows.end(), whole.rows.begin());
}
std::size_t rows_of(hid_t set) {
  hid_t const space = H5Dget_space(set);
  hssize_t const rows = H5Sget_simple_extent_npoints(space);
  H5Sclose(space);
  return static_cast<std::size_t>(rows);
}

/// A run of about a second and what it leaves when nothing disturbs it.
struct Undisturbed {
  Folder folder;
  std::string const scene = folder.write("scene.toml", apophis(scene_of("80000.0"))),
                    whole = folder / "whole", out = folder / "out", file = out + "/series.h5";
  command::Table table;
  Undisturbed() {
    BOOST_REQUIRE(command::actio({"run", scene, "--out", whole, "--quiet"}).status == 0);
    table = read_plainly(whole + "/series.h5");
    BOOST_REQUIRE(table.rows.size() == 320001u);
  }
};
/// Runs have a checkpoint every so many seconds, and make their files anew thirty of them apart.
struct OftenMade {
  OftenMade() { ::setenv("ACTIO_CHECKPOINT_SECONDS", "0.001", 1); }
  ~OftenMade() { ::unsetenv("ACTIO_CHECKPOINT_SECONDS"); }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(hdf5)

BOOST_AUTO_TEST_CASE(an_ordinary_reader_opens_it_while_the_run_goes_on_and_after_each_kill) {
  Undisturbed const run;
  OftenMade const often;
  std::mt19937 random(command::seed());
  std::uniform_real_distribution<double> instant(0.01, 0.12);
  int looks = 0, kills = 0;
  std::size_t seen = 0;
  for (bool done = false; !done && kills < 12; ++kills) {
    bool const begun = std::filesystem::exists(run.out + "/scene.toml");
    command::Process process(begun ? std::vector<std::string>{"resume", run.out, "--quiet"}
                                   : std::vector<std::string>{"run", run.scene, "--out", run.out, "--quiet"});
    // Every other one is killed when the table is there, however slow the machine is at the moment.
    for (int waits = 0; kills % 2 && waits < 2000 && !std::filesystem::exists(run.file); ++waits)
      command::sleep_for(0.005);
    command::sleep_for(instant(random));
    if (std::filesystem::exists(run.file)) {
      BOOST_TEST(begins(run.table, read_plainly(run.file)));
      ++looks;
    }
    process.send(SIGKILL);
    done = process.wait().status == 0;
    if (!std::filesystem::exists(run.file)) continue;
    auto const left = read_plainly(run.file);
    BOOST_TEST(begins(run.table, left));
    BOOST_TEST(left.rows.size() >= seen);
    seen = left.rows.size();
  }
  BOOST_TEST_MESSAGE("series.h5 while the run goes on: " << looks << " looks");
  BOOST_TEST(looks >= 1);
  BOOST_TEST(seen > 1000u);
  BOOST_TEST(command::actio({"resume", run.out, "--quiet"}).status == 0);
  BOOST_TEST((contents(run.file) == contents(run.whole + "/series.h5")));
  BOOST_TEST((contents(run.out + "/series.csv") == contents(run.whole + "/series.csv")));
}

BOOST_AUTO_TEST_CASE(who_has_it_open_goes_on_reading_what_there_was) {
  Folder const folder;
  std::string const out = folder / "out", file = out + "/series.h5";
  OftenMade const often;
  command::Process process(
      {"run", folder.write("scene.toml", apophis(scene_of("1e7"))), "--out", out, "--quiet"});
  BOOST_REQUIRE(command::appears(file));
  hid_t const held = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT),
              set = H5Dopen2(held, "t", H5P_DEFAULT);
  std::vector<double> times(rows_of(set));
  BOOST_REQUIRE(times.size() > 0u);
  for (int k = 0; k < 3; ++k)
    BOOST_TEST(command::actio({"export", out, "--quiet"}).status == 0);  // beside the run that makes it, too
  auto const now = command::read_hdf5(file);
  BOOST_TEST(now.rows.size() > times.size());
  BOOST_TEST(rows_of(set) == times.size());
  BOOST_TEST(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, times.data()) >= 0);
  H5Dclose(set), H5Fclose(held);
  auto const all = now["t"];
  BOOST_TEST(std::equal(times.begin(), times.end(), all.begin()));
  process.send(SIGINT);
  BOOST_TEST(process.wait().status == 130);
  BOOST_TEST((command::read_hdf5(file)["t"] == command::read_csv(out + "/series.csv")["t"]));
}

BOOST_AUTO_TEST_CASE(it_is_made_before_the_summary_says_that_the_run_is_finished) {
  Folder folder;
  std::string const scene = folder.write("scene.toml", apophis(scene_of("100.0"))), out = folder / "out";
  std::filesystem::create_directory(out);
  int const events = ::inotify_init1(IN_NONBLOCK);
  BOOST_REQUIRE(events >= 0);
  BOOST_REQUIRE(::inotify_add_watch(events, out.c_str(), IN_MODIFY | IN_CLOSE_WRITE | IN_MOVED_TO) >= 0);
  BOOST_REQUIRE(command::actio({"run", scene, "--out", out, "--quiet"}).status == 0);
  // The names of the files in the order in which something happened to them.
  std::vector<std::string> names;
  alignas(inotify_event) char buffer[1 << 16];
  for (ssize_t got; (got = ::read(events, buffer, sizeof buffer)) > 0;)
    for (char const* at = buffer; at < buffer + got;) {
      auto const* const event = reinterpret_cast<inotify_event const*>(at);
      names.emplace_back(event->name);
      at += sizeof *event + event->len;
    }
  ::close(events);
  auto const summary = std::find(names.begin(), names.end(), "summary.json");
  BOOST_REQUIRE((summary != names.end()));
  BOOST_TEST((std::find(names.begin(), summary, "series.h5") != summary));
  BOOST_TEST((std::find(summary, names.end(), "series.h5") == names.end()));
}

BOOST_AUTO_TEST_CASE(a_full_disk_takes_no_more_than_what_was_not_yet_written) {
  Undisturbed const run;
  OftenMade const often;
  std::mt19937 random(command::seed());
  for (int round = 0; round < 6; ++round) {
    std::string const blocks = std::to_string(4000 + 8000 * round + static_cast<int>(random() % 6000));
    bool const begun = std::filesystem::exists(run.out + "/checkpoint");
    auto const outcome =
        command::actio(begun ? std::vector<std::string>{"resume", run.out, "--quiet"}
                             : std::vector<std::string>{"run", run.scene, "--out", run.out, "--quiet"},
                       "ulimit -f " + blocks + ";");
    BOOST_TEST(outcome.status == 4, blocks << ": " << outcome.err);
    BOOST_TEST(outcome.err == run.out + "/series.csv: cannot be written: File too large\n");
    if (std::filesystem::exists(run.file)) BOOST_TEST(begins(run.table, read_plainly(run.file)));
  }
  BOOST_TEST(command::actio({"resume", run.out, "--quiet"}).status == 0);
  BOOST_TEST((contents(run.file) == contents(run.whole + "/series.h5")));
}

BOOST_AUTO_TEST_CASE(where_it_cannot_be_made_nothing_is_lost_and_resume_makes_it) {
  Folder const folder;
  // Of so few rows it is the largest of the files.
  std::string const scene =
                        folder.write("scene.toml", apophis({{"until", "8.0"}, {"formats", "[\"hdf5\"]"}})),
                    whole = folder / "whole", out = folder / "out";
  BOOST_REQUIRE(command::actio({"run", scene, "--out", whole, "--quiet"}).status == 0);
  std::uintmax_t others = 0, its = std::filesystem::file_size(whole + "/series.h5");
  for (auto const& entry : std::filesystem::directory_iterator(whole))
    if (entry.path().filename() != "series.h5") others = std::max(others, entry.file_size());
  BOOST_REQUIRE(others + 2048 < its);
  auto const outcome = command::actio({"run", scene, "--out", out, "--quiet"},
                                      "ulimit -f " + std::to_string((others + 1024) / 512) + ";");
  BOOST_TEST(outcome.status == 4);
  BOOST_TEST(outcome.err == out + "/series.h5: cannot be written: File too large\n");
  for (char const* const name : {"/series.h5", "/series.h5.part"})
    BOOST_TEST(!std::filesystem::exists(out + name), name);
  BOOST_TEST((contents(out + "/series.csv") == contents(whole + "/series.csv")));
  BOOST_TEST(command::actio({"resume", out, "--quiet"}).status == 0);
  BOOST_TEST((contents(out + "/series.h5") == contents(whole + "/series.h5")));
  // Of a run that is finished as well.
  std::filesystem::remove(out + "/series.h5");
  auto const again = command::actio({"resume", out});
  BOOST_TEST(again.err == out + "/series.h5 was missing, and is made again\n");
  BOOST_TEST((contents(out + "/series.h5") == contents(whole + "/series.h5")));
}

BOOST_AUTO_TEST_CASE(a_bit_that_was_turned_is_an_error_of_the_reader_and_gone_when_it_is_made_again) {
  Folder const folder;
  std::string const out = folder / "out", file = out + "/series.h5";
  BOOST_REQUIRE(
      command::actio({"run", folder.write("scene.toml", apophis(scene_of("4000"))), "--out", out}).status ==
      0);
  std::string const sound = contents(file);
  for (char const* name : {"t", "attitude", "energy"}) {
    hid_t const opened = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT),
                set = H5Dopen2(opened, name, H5P_DEFAULT), space = H5Dget_space(set);
    hsize_t chunks = 0, at[2], size = 0;
    H5Dget_num_chunks(set, space, &chunks);
    std::vector<haddr_t> places(chunks);
    for (hsize_t k = 0; k < chunks; ++k) {
      unsigned without = 1;
      H5Dget_chunk_info(set, space, k, at, &without, &places[k], &size);
      BOOST_TEST(without == 0u);  // every one has its checksum
    }
    H5Sclose(space), H5Dclose(set), H5Fclose(opened);
    BOOST_TEST(chunks > 1u);
    for (haddr_t const place : {places.front(), places.back()}) {
      std::string damaged = sound;
      damaged[place + 5] ^= 4;
      std::ofstream(file, std::ios::binary) << damaged;
      BOOST_CHECK_THROW(command::read_hdf5(file), std::runtime_error);
    }
  }
  BOOST_TEST(command::actio({"export", out}).status == 0);
  BOOST_TEST((contents(file) == sound));
}

BOOST_AUTO_TEST_CASE(equal_runs_leave_equal_bytes) {
  Folder const folder;
  std::string const scene = folder.write("scene.toml", apophis({{"formats", "[\"hdf5\"]"}}));
  BOOST_TEST(command::actio({"run", scene, "--out", folder / "one", "--quiet"}).status == 0);
  command::sleep_for(1.1);  // a time stamp would differ
  BOOST_TEST(command::actio({"run", scene, "--out", folder / "two", "--quiet"}).status == 0);
  BOOST_TEST((contents(folder / "one/series.h5") == contents(folder / "two/series.h5")));
  BOOST_TEST(contents(folder / "one/series.h5").size() > 1000u);
}

BOOST_AUTO_TEST_SUITE_END()
