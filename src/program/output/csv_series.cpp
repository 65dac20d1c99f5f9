// Comma-separated values with 17 significant digits: what is read back is the number that was written.
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>

#include "program/base/whole_file.hpp"
#include "program/output/series.hpp"

namespace actio::scene {
namespace {

class CsvSeries : public Series {
 public:
  CsvSeries(std::string const& path, std::vector<std::string> const& columns, bool resume) : path_(path) {
    if (resume) require_there(path);
    file_ = ::open(path.c_str(),
                   O_WRONLY | O_APPEND | O_CLOEXEC | (resume ? 0 : O_CREAT | O_TRUNC | O_NOFOLLOW), 0666);
    if (file_ < 0) fail("cannot be opened", errno);
    if (resume) return;  // `remember` tells how much of it counts
    for (auto const& name : columns) buffer_ += (buffer_.empty() ? "" : ",") + name;
    buffer_ += '\n';
    flush();
  }
  ~CsvSeries() override {
    try {
      if (failure_.empty()) flush();
    } catch (FileError const&) {
    }
    ::close(file_);
  }

  void add(std::span<double const> row) override {
    constexpr std::size_t longest = 25;  // sign, 17 digits, point, exponent, comma
    std::size_t const before = buffer_.size();
    buffer_.resize(before + longest * row.size());
    char* at = buffer_.data() + before;
    for (double const x : row) {
      at = std::to_chars(at, at + longest, x, std::chars_format::general, 17).ptr;
      *at++ = ',';
    }
    at[-1] = '\n';
    buffer_.resize(static_cast<std::size_t>(at - buffer_.data()));
    if (buffer_.size() > 1 << 16) flush();
  }

  void flush() override {
    rethrow();
    std::size_t done = 0;
    while (done < buffer_.size()) {
      ssize_t const n = ::write(file_, buffer_.data() + done, buffer_.size() - done);
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) give_up(done, errno);
      done += static_cast<std::size_t>(n);
    }
    size_ += static_cast<off_t>(buffer_.size());
    buffer_.clear();
    if (!has_its_name(file_, path_)) {
      failure_ = lost_its_name(path_);
      throw FileError(failure_);
    }
  }
  void sync() override {
    flush();
    if (::fdatasync(file_) != 0 && errno != EINVAL) fail("cannot be written", errno);
  }
  void remember(CheckpointStream& stream) override {
    rethrow();
    stream(size_);
    if (!stream.reading()) return;
    off_t const found = ::lseek(file_, 0, SEEK_END);
    if (size_ < 0 || found < size_)
      fail("has " + std::to_string(found) + " bytes, where the checkpoint needs " + std::to_string(size_) +
               "; it was cut since",
           0);
    if (::ftruncate(file_, size_) != 0) fail("cannot be cut back", errno);
  }

 private:
  /// Keeps the rows that the disk took whole, and cuts off the part of a row after them.
  [[noreturn]] void give_up(std::size_t done, int error) {
    std::size_t const whole = done == 0 ? std::string::npos : buffer_.rfind('\n', done - 1);
    size_ += static_cast<off_t>(whole == std::string::npos ? 0 : whole + 1);
    buffer_.clear();
    [[maybe_unused]] int const cut = ::ftruncate(file_, size_);
    fail("cannot be written", error);
  }
  [[noreturn]] void fail(std::string const& what, int error) {
    failure_ = path_ + ": " + what + (error == 0 ? "" : std::string(": ") + std::strerror(error));
    throw FileError(failure_);
  }
  void rethrow() const {
    if (!failure_.empty()) throw FileError(failure_);
  }

  std::string path_, buffer_, failure_;
  int file_ = -1;
  off_t size_ = 0;  // of what was written
};

}  // namespace

std::unique_ptr<Series> csv_series(std::string const& path, std::vector<std::string> const& columns,
                                   bool resume) {
  return std::make_unique<CsvSeries>(path, columns, resume);
}

}  // namespace actio::scene
