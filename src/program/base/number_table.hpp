// A table of numbers as comma-separated values, put together in memory.
#pragma once

#include <charconv>
#include <string>
#include <utility>

namespace actio::scene {

/// Rows of numbers with 17 significant digits.
class NumberTable {
 public:
  /// @param heading  the names of the columns, with commas between
  explicit NumberTable(std::string heading) : text_(std::move(heading)) { text_ += '\n'; }
  /// One number more in this row; zero has no sign.
  void add(double x) {
    constexpr std::size_t longest = 25;
    std::size_t const before = text_.size();
    text_.resize(before + longest);
    char* const at = text_.data() + before;
    text_.resize(static_cast<std::size_t>(
        std::to_chars(at, at + longest, x == 0 ? 0 : x, std::chars_format::general, 17).ptr - text_.data()));
    text_ += ',';
  }
  /// The next number begins a row.
  void end_row() { text_.back() = '\n'; }
  /// Room for so many numbers.
  void reserve(std::size_t numbers) { text_.reserve(26 * numbers); }
  /// The whole table, or what was added to it after \ref clear.
  std::string const& text() const { return text_; }
  /// What is in the text has been written: the next row begins a new one.
  void clear() { text_.clear(); }

 private:
  std::string text_;
};

}  // namespace actio::scene
