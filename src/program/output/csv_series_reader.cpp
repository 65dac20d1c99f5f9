// Comma-separated values, read in pieces of a megabyte.
#include <fmt/format.h>

#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "program/output/series_reader.hpp"

namespace actio::scene {
namespace {

class CsvSeriesReader : public SeriesReader {
 public:
  CsvSeriesReader(std::string const& path, std::vector<std::string> const& columns)
      : path_(path), file_(path, std::ios::binary), buffer_(1 << 20, '\0') {
    std::error_code none;
    size_ = static_cast<double>(std::filesystem::file_size(path, none));
    std::string_view line;
    if (!file_ || none || !next_line(line)) throw FileError(path + ": cannot be read");
    if (line != fmt::format("{}", fmt::join(columns, ",")))
      throw FileError(path + ": the columns are not those of the scene");
  }

  bool next(std::span<double> row) override {
    std::string_view line;
    if (!next_line(line)) return false;
    ++line_number_;
    char const *at = line.data(), *const end = at + line.size();
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0 && (at == end || *at++ != ',')) fail("fewer numbers than columns");
      auto const read = std::from_chars(at, end, row[i]);
      if (read.ec != std::errc{}) fail("a number is expected");
      at = read.ptr;
    }
    if (at != end) fail("more numbers than columns");
    return true;
  }
  double fraction() const override { return size_ > 0 ? read_ / size_ : 1; }

 private:
  /// The next whole line, without its end; what follows the last end of a line is no row.
  bool next_line(std::string_view& line) {
    for (;;) {
      if (void const* const end = std::memchr(buffer_.data() + begin_, '\n', end_ - begin_)) {
        line = {buffer_.data() + begin_,
                static_cast<std::size_t>(static_cast<char const*>(end) - buffer_.data()) - begin_};
        begin_ += line.size() + 1, read_ += static_cast<double>(line.size()) + 1;
        return true;
      }
      if (!fill()) return false;
    }
  }
  bool fill() {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_, begin_ = 0;
    if (end_ == buffer_.size()) buffer_.resize(2 * end_);  // a line longer than all of it
    file_.read(buffer_.data() + end_, static_cast<std::streamsize>(buffer_.size() - end_));
    if (file_.bad()) throw FileError(path_ + ": cannot be read");
    end_ += static_cast<std::size_t>(file_.gcount());
    return file_.gcount() > 0;
  }
  [[noreturn]] void fail(std::string const& what) const {
    throw FileError(fmt::format("{}:{}: {}", path_, line_number_, what));
  }

  std::string path_;
  std::ifstream file_;
  std::string buffer_;
  std::size_t begin_ = 0, end_ = 0;
  long line_number_ = 1;
  double size_ = 0, read_ = 0;
};

}  // namespace

std::unique_ptr<SeriesReader> read_series(std::string const& folder, std::vector<ColumnGroup> const& groups) {
  std::vector<std::string> columns{"t"};
  for (auto const& group : groups) columns.insert(columns.end(), group.columns.begin(), group.columns.end());
  return read_csv_series(folder + "/series.csv", columns);
}
std::unique_ptr<SeriesReader> read_csv_series(std::string const& path,
                                              std::vector<std::string> const& columns) {
  return std::make_unique<CsvSeriesReader>(path, columns);
}

}  // namespace actio::scene
