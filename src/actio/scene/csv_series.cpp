// Comma-separated values with 17 significant digits: what is read back is the number that was written.
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>

#include "actio/scene/series.hpp"

namespace actio::scene {
namespace {

class CsvSeries : public Series {
 public:
  CsvSeries(std::string const& path, std::vector<std::string> const& columns, bool resume) : path_(path) {
    file_ = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | (resume ? 0 : O_CREAT | O_TRUNC), 0666);
    if (file_ < 0) fail("cannot be opened");
    if (resume) return;
    for (auto const& name : columns) buffer_ += (buffer_.empty() ? "" : ",") + name;
    buffer_ += '\n';
    flush();
  }
  ~CsvSeries() override {
    if (file_ >= 0) ::close(file_);
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
    std::size_t done = 0;
    while (done < buffer_.size()) {
      ssize_t const n = ::write(file_, buffer_.data() + done, buffer_.size() - done);
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) {
        int const error = errno;
        // The part of a row that the disk still took is cut off again.
        std::size_t const whole = buffer_.rfind('\n', done ? done - 1 : 0);
        size_ += static_cast<off_t>(done == 0 || whole == std::string::npos ? 0 : whole + 1);
        buffer_.clear();
        [[maybe_unused]] int const cut = ::ftruncate(file_, size_);
        errno = error;
        fail("cannot be written");
      }
      done += static_cast<std::size_t>(n);
    }
    size_ += static_cast<off_t>(buffer_.size());
    buffer_.clear();
  }
  void sync() override {
    flush();
    if (::fdatasync(file_) != 0 && errno != EINVAL) fail("cannot be written");
  }
  void remember(Memory& memory) override {
    memory(size_);
    if (!memory.reading()) return;
    off_t const found = ::lseek(file_, 0, SEEK_END);
    if (size_ < 0 || found < size_) throw FileError(path_ + ": has " + std::to_string(found) + " bytes, where the checkpoint needs " + std::to_string(size_) + "; it was cut since");
    if (::ftruncate(file_, size_) != 0) fail("cannot be cut back");
  }

 private:
  [[noreturn]] void fail(std::string const& what) { throw FileError(path_ + ": " + what + ": " + std::strerror(errno)); }

  std::string path_, buffer_;
  int file_ = -1;
  off_t size_ = 0;  // of what was written
};

}  // namespace

std::unique_ptr<Series> csv_series(std::string const& path, std::vector<std::string> const& columns, bool resume) { return std::make_unique<CsvSeries>(path, columns, resume); }

}  // namespace actio::scene
