// What a run leaves: its table, while it goes on and when the disk is full, and that in HDF5.
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <regex>
#include <thread>

#include "hdf5_table.hpp"

using command::apophis, command::Folder;

namespace {

std::string const both = "[\"csv\", \"hdf5\"]";

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// Whether each column of `part` holds the first numbers of the same column of `whole`, to the last bit.
bool begins(command::Table const& whole, command::Table const& part) {
  if (part.rows.size() > whole.rows.size()) return false;
  for (auto const& column : part.columns) {
    auto const a = whole[column], b = part[column];
    if (!std::equal(b.begin(), b.end(), a.begin(), same_bits)) return false;
  }
  return true;
}

/// A run of many rows, in steps.
std::string many_rows(long rows, std::string const& formats) {
  return apophis({{"order", "2"},
                  {"step", "0.25"},
                  {"until", std::to_string(rows / 4)},
                  {"every", "0.25"},
                  {"formats", formats}});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(output)

BOOST_AUTO_TEST_CASE(the_time_comes_first_and_then_the_quantities_in_the_order_of_the_scene) {
  Folder const folder;
  auto const outcome = command::actio(
      {"run",
       folder.write("apophis.toml",
                    apophis({{"quantities", "[\"energy\", \"attitude\", \"angular_velocity\"]"}})),
       "--quiet"});
  BOOST_TEST(outcome.status == 0, outcome.err);
  std::string const text = command::contents(folder / "apophis/series.csv");
  BOOST_TEST(text.substr(0, text.find('\n')) ==
             "t,energy,attitude_w,attitude_x,attitude_y,attitude_z,angular_velocity_x,angular_velocity_y,"
             "angular_velocity_z");
}

BOOST_AUTO_TEST_CASE(numbers_are_written_with_17_significant_digits) {
  Folder const folder;
  command::actio({"run", folder.write("apophis.toml", apophis()), "--quiet"});
  std::string const text = command::contents(folder / "apophis/series.csv");
  long numbers = 0;
  std::regex const number("[-0-9][^,\n]*");
  for (std::sregex_iterator at(text.begin(), text.end(), number), end; at != end; ++at, ++numbers) {
    char expected[40];
    std::snprintf(expected, sizeof expected, "%.17g", std::strtod(at->str().c_str(), nullptr));
    BOOST_TEST(at->str() == expected);
  }
  BOOST_TEST(numbers == 101 * 5);
}

BOOST_AUTO_TEST_CASE(both_formats_hold_the_same_numbers_bit_for_bit) {
  Folder const folder;
  auto const outcome =
      command::actio({"run", folder.write("apophis.toml", many_rows(20000, both)), "--quiet"});
  BOOST_TEST(outcome.status == 0, outcome.err);
  auto const csv = command::read_csv(folder / "apophis/series.csv");
  auto const hdf5 = command::read_hdf5(folder / "apophis/series.h5");
  BOOST_TEST(csv.rows.size() == 20001u);
  BOOST_TEST(hdf5.rows.size() == csv.rows.size());
  BOOST_TEST(hdf5.columns.size() == csv.columns.size());
  BOOST_TEST(begins(csv, hdf5));
}

BOOST_AUTO_TEST_CASE(an_hdf5_file_has_a_data_set_for_each_quantity_and_tells_what_it_is) {
  Folder const folder;
  std::string const title = "\"Apophis, \\u00fcber Jahre\"";
  auto const outcome = command::actio(
      {"run", folder.write("apophis.toml", apophis({{"formats", "[\"hdf5\"]"}, {"title", title}})),
       "--quiet"});
  BOOST_TEST(outcome.status == 0, outcome.err);
  BOOST_TEST(std::filesystem::exists(folder / "apophis/series.csv"));
  auto const table = command::read_hdf5(folder / "apophis/series.h5");
  using Extent = std::vector<unsigned long long>;
  BOOST_TEST(table.extents.at("t") == (Extent{101}), boost::test_tools::per_element());
  BOOST_TEST(table.extents.at("energy") == (Extent{101}), boost::test_tools::per_element());
  BOOST_TEST(table.extents.at("body_momentum") == (Extent{101, 3}), boost::test_tools::per_element());
  auto const& momentum = table.attributes.at("body_momentum");
  BOOST_TEST(momentum.at("columns") == "body_momentum_x,body_momentum_y,body_momentum_z");
  BOOST_TEST(momentum.at("formula") == "M");
  BOOST_TEST(momentum.at("unit") == "ratio/h");
  BOOST_TEST(momentum.at("meaning").size() > 10u);
  BOOST_TEST(momentum.at("statement").size() > 0u);
  BOOST_TEST(table.attributes.at("t").at("unit") == "h");
  auto const& file = table.attributes.at("");
  BOOST_TEST(file.at("title") == "Apophis, \u00fcber Jahre");
  BOOST_TEST(file.at("system") == "rigid_body");
  BOOST_TEST(file.at("scene") == command::contents(folder / "apophis/scene.toml"));
  BOOST_TEST(std::regex_match(file.at("actio_version"), std::regex("[0-9]+\\.[0-9]+\\.[0-9]+")));
}

BOOST_AUTO_TEST_CASE(rows_can_be_watched_while_the_run_goes_on) {
  Folder const folder;
  // A row takes about a millisecond, so that no buffer is full before the run is stopped.
  std::string const scene = folder.write(
      "apophis.toml",
      apophis({{"order", "2"}, {"step", "0.25"}, {"until", "1e9"}, {"every", "25000"}, {"formats", both}}));
  command::Outcome outcome;
  std::thread run([&] {
    outcome = command::actio({"run", scene, "--quiet"}, "timeout --preserve-status -s INT 3");
  });
  std::size_t csv = 0;
  for (int look = 0; look < 100 && csv < 2; ++look) {
    std::this_thread::sleep_for(std::chrono::milliseconds(25));
    std::string const text = command::contents(folder / "apophis/series.csv");
    csv = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }
  BOOST_TEST(csv >= 2u);
  // A table in HDF5 is made of the rows so far, whenever one likes.
  auto const meanwhile = command::actio({"export", folder / "apophis", "--formats", "hdf5"});
  BOOST_TEST(meanwhile.status == 0, meanwhile.err);
  BOOST_TEST(meanwhile.out == folder / "apophis/series.h5 is made\n");
  std::size_t const hdf5 = command::read_hdf5(folder / "apophis/series.h5").rows.size();
  BOOST_TEST(hdf5 >= csv - 1);
  run.join();
  BOOST_TEST(outcome.status == 130);
  auto const all = command::read_csv(folder / "apophis/series.csv");
  BOOST_TEST(all.rows.size() > hdf5);
  BOOST_TEST(command::read_hdf5(folder / "apophis/series.h5").rows.size() == all.rows.size());
}

BOOST_AUTO_TEST_CASE(the_memory_of_a_run_does_not_grow_with_its_rows) {
  for (std::string const format : {"[\"csv\"]", "[\"hdf5\"]"}) {
    auto const peak = [&](long rows) {
      Folder const folder;
      auto const outcome = command::actio(
          {"run", folder.write("apophis.toml", many_rows(rows, format)), "--quiet"}, "/usr/bin/time -f %M");
      BOOST_TEST(outcome.status == 0, outcome.err);
      return std::stod(outcome.err) / 1024;
    };
    double const few = peak(20000), many = peak(1000000);
    BOOST_TEST_MESSAGE(format << ": peak memory " << few << " MB for 2e4 rows, " << many
                              << " MB for 1e6 rows of five numbers, which are 38 MB");
    // Blocks that wait for the writer and a chunk of each data set may still fill up; a tenth of the rows may
    // not.
    BOOST_TEST(many <= few + 4);
  }
}

BOOST_AUTO_TEST_CASE(a_full_disk_is_said_and_leaves_the_rows_before_it_whole) {
  Folder const folder;
  std::string const scene = folder.write("apophis.toml", many_rows(400000, both));
  BOOST_TEST(command::actio({"run", scene, "--quiet", "--out", folder / "whole"}).status == 0);
  auto const whole = command::read_csv(folder / "whole/series.csv");
  std::string const out = folder / "out";
  auto const outcome = command::actio({"run", scene, "--quiet", "--out", out}, "ulimit -f 4000;");
  BOOST_TEST(outcome.status == 4);
  BOOST_TEST(outcome.err == out + "/series.csv: cannot be written: File too large\n");
  BOOST_TEST(begins(whole, command::read_csv(out + "/series.csv")));
  // What fitted into the 512-byte blocks of the shell is there, up to a row, which takes at most 25 bytes a
  // number.
  BOOST_TEST(static_cast<double>(std::filesystem::file_size(out + "/series.csv")) >= 4000.0 * 512 - 5 * 25);
}

BOOST_AUTO_TEST_SUITE_END()
