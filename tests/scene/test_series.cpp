// Tables on disk: written by a thread of their own, cut back, or left by a writer that was killed; and a
// table in HDF5 that is made of one.
#include <boost/test/unit_test.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <bit>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

#include "hdf5_table.hpp"
#include "program/output/hdf5_series.hpp"
#include "refused.hpp"

using namespace actio::scene;
using command::Folder;

namespace {

Quantity quantity(std::string const& name, Quantity::Kind kind) {
  return {name, kind, "What it is.", "x", "1"};
}
ColumnGroup group(std::string const& name, Quantity::Kind kind, int n = 3) {
  ColumnGroup out{quantity(name, kind), {}};
  for (auto const& end : column_ends(kind, n)) out.columns.push_back(name + end);
  return out;
}
/// A time, a number, and a matrix.
SeriesHead head() {
  return {"title",
          "system",
          "[scene]\n",
          {group("energy", Quantity::Kind::scalar), group("place", Quantity::Kind::matrix)},
          1000000};
}
constexpr std::size_t columns = 11;

/// Row k: numbers with all their digits.
std::vector<double> row(long k) {
  std::vector<double> out(columns);
  for (std::size_t i = 0; i < columns; ++i)
    out[i] = static_cast<double>(k) / (static_cast<double>(i) + 3) - 1e-3 * static_cast<double>(i);
  return out;
}
void add_rows(Series& series, long from, long to) {
  for (long k = from; k < to; ++k) series.add(row(k));
}

/// The rows of a table that are whole.
std::vector<std::vector<double>> rows_in(std::string const& folder) {
  return command::read_csv(folder + "/series.csv").rows;
}
bool are_first_rows(std::vector<std::vector<double>> const& rows) {
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (rows[k] != row(static_cast<long>(k))) return false;
  }
  return true;
}

/// Counts rows, slowly, and fails when it is told to.
struct SlowSeries : Series {
  long *rows, fails_at;
  SlowSeries(long* count, long at) : rows(count), fails_at(at) {}
  void add(std::span<double const> row) override {
    if (*rows == fails_at) throw FileError("the disk is full");
    BOOST_REQUIRE(row[0] == static_cast<double>(*rows));
    ++*rows;
    if (*rows % 1000 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  void flush() override {}
  void sync() override {}
  void remember(CheckpointStream& stream) override { stream(*rows); }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(series)

BOOST_AUTO_TEST_CASE(columns_are_named_by_their_kind) {
  using Kind = Quantity::Kind;
  using Names = std::vector<std::string>;
  BOOST_TEST(column_ends(Kind::scalar) == Names{""}, boost::test_tools::per_element());
  BOOST_TEST(column_ends(Kind::vector) == (Names{"_x", "_y", "_z"}), boost::test_tools::per_element());
  BOOST_TEST(column_ends(Kind::quaternion) == (Names{"_w", "_x", "_y", "_z"}),
             boost::test_tools::per_element());
  BOOST_TEST(column_ends(Kind::matrix, 2) == (Names{"_11", "_12", "_21", "_22"}),
             boost::test_tools::per_element());
  BOOST_TEST(column_ends(Kind::skew, 4) == (Names{"_12", "_13", "_14", "_23", "_24", "_34"}),
             boost::test_tools::per_element());
  BOOST_TEST(numbered(2, 12, 5) == (Names{"_2", "_7", "_12"}), boost::test_tools::per_element());
  BOOST_CHECK_THROW(column_ends(Kind::list), std::logic_error);
}

BOOST_AUTO_TEST_CASE(an_index_of_two_digits_is_set_apart_from_the_other) {
  auto const ten = column_ends(Quantity::Kind::matrix, 10);
  BOOST_TEST(ten.front() == "_11");
  BOOST_TEST(ten[9] == "_1_10");
  BOOST_TEST(ten[90] == "_10_1");
  BOOST_TEST(ten.back() == "_10_10");
  BOOST_TEST(column_ends(Quantity::Kind::skew, 12).back() == "_11_12");
}

BOOST_AUTO_TEST_CASE(a_value_has_the_shape_of_its_kind) {
  using Kind = Quantity::Kind;
  using Shape = std::vector<std::size_t>;
  BOOST_TEST(group("a", Kind::scalar).shape().empty());
  BOOST_TEST(group("a", Kind::quaternion).shape() == Shape{4}, boost::test_tools::per_element());
  BOOST_TEST(group("a", Kind::skew, 5).shape() == Shape{10}, boost::test_tools::per_element());
  BOOST_TEST(group("a", Kind::matrix, 12).shape() == (Shape{12, 12}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(every_number_reads_back_as_it_was) {
  std::mt19937_64 random(7);
  std::vector<double> numbers{0.0,
                              -0.0,
                              5e-324,
                              -2.2250738585072014e-308,
                              1.7976931348623157e308,
                              0.1,
                              1e16,
                              1e17,
                              123456789012345678.0,
                              1e-5,
                              9.9999999999999995e-5};
  while (numbers.size() < 20000)
    if (double const x = std::bit_cast<double>(random()); std::isfinite(x)) numbers.push_back(x);
  Folder const folder;
  SeriesHead const times{"", "", "", {}, 0};
  {
    auto const series = open_series(folder / "", times, false);
    for (double const x : numbers) series->add(std::span(&x, 1));
  }
  make_hdf5_series(folder / "", times, false);
  for (auto const& rows : {rows_in(folder / ""), command::read_hdf5(folder / "series.h5").rows}) {
    BOOST_TEST(rows.size() == numbers.size());
    bool same = true;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      same = same && std::bit_cast<std::uint64_t>(rows[i][0]) == std::bit_cast<std::uint64_t>(numbers[i]);
    BOOST_TEST(same);
  }
}

BOOST_AUTO_TEST_CASE(a_table_in_hdf5_takes_the_place_of_the_former_one_and_nothing_is_left_where_it_cannot) {
  Folder const folder;
  auto const series = open_series(folder / "", head(), false);
  for (long const rows : {0L, 20000L}) {  // none, and more than a chunk has
    add_rows(*series, 0, rows), series->flush();
    std::vector<double> seen;
    make_hdf5_series(folder / "", head(), true, [&](double done) { seen.push_back(done); });
    auto const table = command::read_hdf5(folder / "series.h5");
    BOOST_TEST(table.rows.size() == static_cast<std::size_t>(rows));
    BOOST_TEST(table.columns.size() == columns);
    if (rows == 0) continue;
    BOOST_TEST(table["t"] == command::read_csv(folder / "series.csv")["t"], boost::test_tools::per_element());
    BOOST_TEST(seen.size() > 1u);
    BOOST_TEST(seen.back() == 1);
  }
  std::string const before = command::contents(folder / "series.h5");
  std::ofstream(folder / "series.csv", std::ios::app) << "1,2,no number\n";
  CHECK_REFUSED(make_hdf5_series(folder / "", head(), false), FileError);
  BOOST_TEST((command::contents(folder / "series.h5") == before));
  BOOST_TEST(!std::filesystem::exists(folder / "series.h5.part"));
  std::filesystem::remove(folder / "series.csv");
  CHECK_REFUSED(make_hdf5_series(folder / "", head(), false), FileError);
  CHECK_REFUSED(make_hdf5_series(folder / "none", head(), false), FileError);
}

BOOST_AUTO_TEST_CASE(a_table_is_cut_back_to_what_it_remembers_and_goes_on) {
  Folder const folder;
  CheckpointStream stream;
  {
    auto const series = open_series(folder / "", head(), false);
    add_rows(*series, 0, 1234);
    series->sync();
    series->remember(stream);
    add_rows(*series, 1234, 9000);
  }
  BOOST_TEST(rows_in(folder / "").size() == 9000u);
  {
    auto const series = open_series(folder / "", head(), true);
    CheckpointStream back(stream.bytes());
    series->remember(back);
    series->flush();
    BOOST_TEST(rows_in(folder / "").size() == 1234u);
    add_rows(*series, 1234, 5000);
  }
  auto const rows = rows_in(folder / "");
  BOOST_TEST(rows.size() == 5000u);
  BOOST_TEST(are_first_rows(rows));
}

BOOST_AUTO_TEST_CASE(a_table_that_lost_rows_since_is_refused) {
  Folder const folder;
  CheckpointStream stream, few;
  for (auto [to, into] : {std::pair{500L, &stream}, std::pair{100L, &few}}) {
    auto const series = open_series(folder / "", head(), false);
    add_rows(*series, 0, to);
    series->sync();
    series->remember(*into);
  }
  auto const series = open_series(folder / "", head(), true);
  CheckpointStream back(stream.bytes());
  BOOST_CHECK_EXCEPTION(series->remember(back), FileError, [](FileError const& error) {
    return std::string(error.what()).ends_with("; it was cut since");
  });
}

BOOST_AUTO_TEST_CASE(a_device_without_room_is_said_and_every_later_call_says_so_again) {
  auto const full = [](FileError const& error) {
    return std::string(error.what()).ends_with("No space left on device");
  };
  BOOST_CHECK_EXCEPTION(csv_series("/dev/full", {"t"}, false), FileError, full);
  // Nothing is written through a link.
  Folder const folder;
  std::filesystem::create_symlink("elsewhere", folder / "series.csv");
  CHECK_REFUSED(open_series(folder / "", head(), false), FileError);
  BOOST_TEST(!std::filesystem::exists(folder / "elsewhere"));
  // A file that was there when the disk filled up.
  std::unique_ptr<Series> const series = in_background(csv_series("/dev/full", {"t"}, true));
  add_rows(*series, 0, 10);
  CHECK_REFUSED(series->flush(), FileError);
  CHECK_REFUSED(series->sync(), FileError);
  CheckpointStream stream;
  CHECK_REFUSED(series->remember(stream), FileError);
}

BOOST_AUTO_TEST_CASE(a_file_that_is_no_table_is_refused) {
  Folder const folder;
  std::filesystem::create_directory(folder / "series.csv");
  CHECK_REFUSED(csv_series(folder / "series.csv", {"t"}, false), FileError);
  CHECK_REFUSED(csv_series(folder / "none/series.csv", {"t"}, false), FileError);
  CHECK_REFUSED(csv_series(folder / "absent.csv", {"t"}, true), FileError);
}

BOOST_AUTO_TEST_CASE(rows_wait_for_a_slow_writer_in_bounded_memory_and_in_their_order) {
  long written = 0, most_ahead = 0;
  {
    auto const series = in_background(std::make_unique<SlowSeries>(&written, -1));
    std::vector<double> row(8);
    for (long k = 0; k < 100000; ++k) {
      row[0] = static_cast<double>(k);
      series->add(row);
      if (k % 5000 == 4999) {
        series->flush();
        BOOST_TEST(written == k + 1);
      }
    }
    series->flush();
    for (long k = 100000; k < 120000; ++k) {
      row[0] = static_cast<double>(k);
      series->add(row);
      most_ahead = std::max(most_ahead, k + 1 - *const_cast<long const volatile*>(&written));
    }
  }
  BOOST_TEST(written == 120000);
  // Blocks of 4096 numbers: four wait, one is being filled.
  BOOST_TEST(most_ahead <= 5 * 4096 / 8 + 1);
}

BOOST_AUTO_TEST_CASE(an_error_of_the_writer_comes_out_of_what_is_called_next) {
  long written = 0;
  auto const series = in_background(std::make_unique<SlowSeries>(&written, 100));
  double t = 0;
  for (; t < 150; ++t) series->add(std::span(&t, 1));
  CHECK_REFUSED(series->flush(), FileError);
  BOOST_TEST(written == 100);
  CHECK_REFUSED(series->sync(), FileError);
  auto const add_many = [&] {
    for (long k = 0; k < 100000; ++k) series->add(std::span(&t, 1));
  };
  CHECK_REFUSED(add_many(), FileError);
}

BOOST_AUTO_TEST_CASE(what_a_killed_writer_leaves_is_a_beginning_and_can_be_gone_on_with) {
  std::mt19937 random(3);
  for (int round = 0; round < 12; ++round) {
    Folder const folder;
    // The child says what it remembers, as a run does in its checkpoint.
    int remembered[2];
    BOOST_REQUIRE(::pipe(remembered) == 0);
    pid_t const child = ::fork();
    if (child == 0) {
      auto const series = open_series(folder / "", head(), false);
      for (long k = 0;; k += 700) {
        add_rows(*series, k, k + 700);
        if (k % 2100 == 0) series->flush();
        if (k % 9100 == 0) {
          CheckpointStream stream;
          series->sync();
          series->remember(stream);
          if (::write(remembered[1], stream.bytes().data(), stream.bytes().size()) < 0) ::_exit(1);
        }
      }
    }
    ::close(remembered[1]);
    constexpr ssize_t size = 8;
    char next[size];
    BOOST_REQUIRE(::read(remembered[0], next, size) == size);
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 30000));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    std::string last(next, size);
    while (::read(remembered[0], next, size) == size) last.assign(next, size);
    ::close(remembered[0]);
    std::size_t kept = 0;
    {
      auto const series = open_series(folder / "", head(), true);
      CheckpointStream stream(last);
      series->remember(stream);
      kept = rows_in(folder / "").size();
      add_rows(*series, static_cast<long>(kept), static_cast<long>(kept) + 5000);
    }
    auto const rows = rows_in(folder / "");
    BOOST_TEST(rows.size() == kept + 5000);
    BOOST_TEST(are_first_rows(rows));
  }
}

BOOST_AUTO_TEST_SUITE_END()
