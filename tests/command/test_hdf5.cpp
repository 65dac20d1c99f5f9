// series.h5 is opened by ordinary readers: while the run goes on, after it was killed, on a full disk; and a
// damaged one is refused.
#include <boost/test/unit_test.hpp>

#include <hdf5.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <cstring>
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

/// What `h5ls` and the library make of a file: rows of each data set; an exception where one of them refuses
/// it.
command::Hdf5Table read_plainly(std::string const& path) {
  if (command::shell("h5ls -r '" + path + "' && h5dump -H '" + path + "'").status != 0)
    throw std::runtime_error(path + ": h5ls or h5dump cannot open it");
  return command::read_hdf5(path, true);
}
/// The same while the file is written: a reader that meets a write in its midst is told of a wrong checksum,
/// and looks again.
command::Hdf5Table read_while_it_is_written(std::string const& path, int& again) {
  for (int left = 20;; --left, ++again) try {
      return read_plainly(path);
    } catch (std::runtime_error const&) {
      if (left == 0) throw;
    }
}
/// Whether the rows are the first ones of a whole table.
bool begins(command::Table const& whole, command::Table const& part) {
  return part.columns == whole.columns && part.rows.size() <= whole.rows.size() &&
         std::equal(part.rows.begin(), part.rows.end(), whole.rows.begin());
}

/// The place of the chunk of a data set that has a row.
std::uint64_t place_of_chunk(std::string const& path, char const* name, hsize_t row) {
  hid_t const file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT),
              set = H5Dopen2(file, name, H5P_DEFAULT);
  hsize_t at[2] = {row, 0}, size = 0;
  haddr_t place = 0;
  unsigned without = 0;
  hid_t const how = H5Dget_create_plist(set);
  hsize_t chunk[2] = {1, 1};
  H5Pget_chunk(how, 2, chunk);
  at[0] -= at[0] % chunk[0];
  H5Dget_chunk_info_by_coord(set, at, &without, &place, &size);
  H5Pclose(how), H5Dclose(set), H5Fclose(file);
  return place;
}
/// How many chunks of a data set are said to have no checksum.
int chunks_without_checksum(std::string const& path, char const* name) {
  hid_t const file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT),
              set = H5Dopen2(file, name, H5P_DEFAULT), space = H5Dget_space(set);
  hsize_t chunks = 0, at[2], size = 0;
  H5Dget_num_chunks(set, space, &chunks);
  int count = chunks == 0 ? -1 : 0;
  for (hsize_t k = 0; k < chunks; ++k) {
    haddr_t place = 0;
    unsigned without = 1;
    H5Dget_chunk_info(set, space, k, at, &without, &place, &size);
    count += without != 0;
  }
  H5Sclose(space), H5Dclose(set), H5Fclose(file);
  return count;
}
void flip_a_bit(std::string const& path, std::uint64_t at) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekg(static_cast<std::streamoff>(at));
  char const byte = static_cast<char>(file.get() ^ 4);
  file.seekp(static_cast<std::streamoff>(at));
  file.put(byte);
}

/// A run of about a second and what it leaves when nothing disturbs it.
struct Undisturbed {
  Folder folder;
  std::string const scene = folder.write("scene.toml", apophis(scene_of("80000.0"))),
                    whole = folder / "whole", out = folder / "out";
  command::Table table;
  Undisturbed() {
    BOOST_REQUIRE(command::actio({"run", scene, "--out", whole, "--quiet"}).status == 0);
    table = read_plainly(whole + "/series.h5");
    BOOST_REQUIRE(table.rows.size() == 320001u);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(hdf5)

BOOST_AUTO_TEST_CASE(an_ordinary_reader_opens_it_while_the_run_goes_on_and_after_each_kill) {
  Undisturbed const run;
  std::mt19937 random(command::seed());
  std::uniform_real_distribution<double> instant(0.01, 0.12);
  int looks = 0, kills = 0, again = 0;
  std::size_t seen = 0;
  for (bool done = false; !done && kills < 12; ++kills) {
    bool const begun = std::filesystem::exists(run.out + "/scene.toml");
    command::Process process(begun ? std::vector<std::string>{"resume", run.out, "--quiet"}
                                   : std::vector<std::string>{"run", run.scene, "--out", run.out, "--quiet"});
    // Every other one is killed when the table is there, however slow the machine is at the moment.
    for (int waits = 0; kills % 2 && waits < 2000 && !std::filesystem::exists(run.out + "/series.h5");
         ++waits)
      command::sleep_for(0.005);
    command::sleep_for(instant(random));
    if (std::filesystem::exists(run.out + "/series.h5")) {
      BOOST_TEST(begins(run.table, read_while_it_is_written(run.out + "/series.h5", again)));
      ++looks;
    }
    process.send(SIGKILL);
    done = process.wait().status == 0;
    if (!std::filesystem::exists(run.out + "/series.h5")) continue;
    auto const left = read_plainly(run.out + "/series.h5");
    BOOST_TEST(begins(run.table, left));
    seen = std::max(seen, left.rows.size());
  }
  BOOST_TEST_MESSAGE("series.h5 while it is written: " << looks << " looks, " << again << " of them again");
  BOOST_TEST(looks >= 1);
  BOOST_TEST(seen > 1000u);
  BOOST_TEST(command::actio({"resume", run.out, "--quiet"}).status == 0);
  BOOST_TEST((read_plainly(run.out + "/series.h5").rows == run.table.rows));
  BOOST_TEST(std::filesystem::file_size(run.out + "/series.h5") <
             std::filesystem::file_size(run.whole + "/series.h5") + (1 << 20));
  for (char const* name : {"t", "attitude", "energy"})
    for (auto const& folder : {run.out, run.whole})
      BOOST_TEST(chunks_without_checksum(folder + "/series.h5", name) == 0, name);
}

BOOST_AUTO_TEST_CASE(it_is_closed_before_the_summary_says_that_the_run_is_finished) {
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

BOOST_AUTO_TEST_CASE(on_a_full_disk_it_is_readable_up_to_the_last_rows_and_goes_on_when_there_is_room) {
  Undisturbed const run;
  std::mt19937 random(command::seed());
  std::size_t before = 0;
  for (int round = 0; round < 6; ++round) {
    std::string const blocks = std::to_string(2000 + 3500 * round + static_cast<int>(random() % 3000));
    bool const begun = std::filesystem::exists(run.out + "/checkpoint");
    auto const outcome =
        command::actio(begun ? std::vector<std::string>{"resume", run.out, "--quiet"}
                             : std::vector<std::string>{"run", run.scene, "--out", run.out, "--quiet"},
                       "export ACTIO_CHECKPOINT_SECONDS=0.02; ulimit -f " + blocks + ";");
    BOOST_TEST(outcome.status == 4, blocks << ": " << outcome.err);
    BOOST_TEST(outcome.err == run.out + "/series.h5: cannot be written: File too large\n");
    auto const left = read_plainly(run.out + "/series.h5");
    BOOST_TEST(begins(run.table, left));
    BOOST_TEST(left.rows.size() > before);
    before = left.rows.size() / 2;
  }
  BOOST_TEST(command::actio({"resume", run.out, "--quiet"}).status == 0);
  BOOST_TEST((read_plainly(run.out + "/series.h5").rows == run.table.rows));
}

BOOST_AUTO_TEST_CASE(a_bit_that_was_turned_is_an_error_of_the_reader_and_of_resume_with_its_place) {
  Folder const folder;
  std::string const scene = folder.write("scene.toml", apophis(scene_of("2e6"))), out = folder / "out",
                    file = out + "/series.h5";
  command::Process process({"run", scene, "--out", out, "--quiet"});
  BOOST_REQUIRE(command::appears(out + "/checkpoint"));
  command::sleep_for(0.3);
  process.send(SIGKILL);
  process.wait();
  std::size_t const rows = read_plainly(file).rows.size();
  BOOST_REQUIRE(rows > 8192u);
  std::string const sound = contents(file), checkpoint = contents(out + "/checkpoint");
  // In a chunk that is full, and in the one that was growing: the first rows of that are in the checkpoint.
  std::uint64_t remembered = 0;
  std::memcpy(&remembered, checkpoint.data() + checkpoint.size() - 8 - 8 - 3 * 4, 8);
  BOOST_REQUIRE((remembered > 4096 && remembered <= rows));
  for (char const* name : {"t", "attitude", "energy"})
    for (std::uint64_t const row : {std::uint64_t{3000}, remembered - 1}) {
      std::ofstream(file, std::ios::binary) << sound;
      std::uint64_t const place = place_of_chunk(file, name, row);
      flip_a_bit(file, place + 5);
      if (row == 3000) BOOST_CHECK_THROW(command::read_hdf5(file, true), std::runtime_error);
      BOOST_TEST(chunks_without_checksum(file, name) <= 1);
      auto const outcome = command::actio({"resume", out, "--quiet"});
      BOOST_TEST(outcome.status == 4, name << ", row " << row);
      BOOST_TEST(outcome.err.find(file + ": is damaged: rows ") == 0u, outcome.err);
      BOOST_TEST(outcome.err.find(std::string(" of '") + name + "'") != std::string::npos, outcome.err);
      BOOST_TEST(outcome.err.find("put a copy of the file in its place, or run its scene.toml anew") !=
                     std::string::npos,
                 outcome.err);
      BOOST_TEST(contents(out + "/checkpoint") == checkpoint);
    }
  std::ofstream(file, std::ios::binary) << sound;
  BOOST_TEST(command::actio({"resume", out, "--quiet"}, "timeout --preserve-status -s INT 0.3").status ==
             130);
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
