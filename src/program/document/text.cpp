// The text of a scene, read as TOML.
#include <fmt/format.h>

#include "program/document/document.hpp"

namespace actio::scene::detail {
namespace {

// a.b.c...: each is a table in a table, and the stack is spent on taking them down
constexpr int most_names = 32;

/// Looks for bytes of another encoding, for names that are joined by too many dots, and for texts in three
/// quotes that never end.
class Scan {
 public:
  Scan(std::string_view text, std::string const& name) : text_(text), name_(name) {}

  void run() {
    if (std::size_t const valid = length_in_utf8(text_); valid < text_.size())
      throw SceneError(place(mark_at(valid)), fmt::format("UTF-8 is expected, found the byte 0x{:02x}",
                                                          static_cast<unsigned char>(text_[valid])));
    while (at_ < text_.size()) {
      char const c = text_[at_];
      if (c == '#')
        skip_to_end_of_line();
      else if (c == '"' || c == '\'')
        skip_text(c);
      else
        take(c);
    }
  }

 private:
  void take(char c) {
    if (c == '.' && ++dots_ >= most_names)
      throw SceneError(place(mark_), fmt::format("at most {} names may be joined by dots", most_names));
    if (c == '\n' || c == ',' || c == '=' || c == '[' || c == '{') dots_ = 0;
    step();
  }
  void step() {
    if (text_[at_] == '\n') ++mark_.line, mark_.start_of_line = at_ + 1;
    ++at_;
  }
  void skip_to_end_of_line() {
    while (at_ < text_.size() && text_[at_] != '\n') step();
  }
  void skip_text(char quote) {
    std::string const three(3, quote);
    if (!text_.substr(at_).starts_with(three)) {
      for (step(); at_ < text_.size() && text_[at_] != quote && text_[at_] != '\n'; step())
        if (quote == '"' && text_[at_] == '\\' && at_ + 1 < text_.size() && text_[at_ + 1] != '\n') step();
      if (at_ < text_.size() && text_[at_] == quote) step();
      return;
    }
    Mark const began = mark_;
    for (at_ += 3; !text_.substr(at_).starts_with(three); step()) {
      if (quote == '"' && at_ < text_.size() && text_[at_] == '\\') step();
      if (at_ >= text_.size()) throw SceneError(place(began), "this text in three quotes never ends");
    }
    // Up to two quotes may stand before the three that end it.
    for (at_ += 3; at_ < text_.size() && text_[at_] == quote;) ++at_;
  }

  struct Mark {
    std::size_t at = 0, start_of_line = 0;
    unsigned line = 1;
  };
  Mark mark_at(std::size_t at) const {
    Mark mark;
    for (; mark.at < at; ++mark.at)
      if (text_[mark.at] == '\n') ++mark.line, mark.start_of_line = mark.at + 1;
    return mark;
  }
  Place place(Mark const& mark) const {
    unsigned column = 1;
    for (char const c : text_.substr(mark.start_of_line, mark.at - mark.start_of_line))
      column += (c & 0xC0) != 0x80;
    return {name_, mark.line, column};
  }

  std::string_view text_;
  std::string const& name_;
  Mark mark_;
  std::size_t& at_ = mark_.at;
  int dots_ = 0;
};

/// The bytes that the first so many characters take.
std::size_t bytes_of(std::string_view text, unsigned characters) {
  std::size_t bytes = 0;
  for (; bytes < text.size() && characters > 0; ++bytes)
    if (bytes + 1 == text.size() || (text[bytes + 1] & 0xC0) != 0x80) --characters;
  return bytes;
}

/// Where the reader of TOML stopped; where that is behind a number that it complains of, where the number
/// begins.
Place failure_place(toml::parse_error const& error, std::string_view text, std::string const& name) {
  Place place = place_of(error.source(), name);
  std::string_view const what = error.description();
  std::size_t const open = what.find('\''), close = what.rfind('\'');
  if (place.line == 0 || open == close) return place;
  std::string_view const word = what.substr(open + 1, close - open - 1);
  if (word.size() < 2 || word.find_first_not_of("+-.0123456789_abcdefABCDEFxo") != std::string_view::npos)
    return place;
  for (unsigned line = 1; line < place.line; ++line) text.remove_prefix(text.find('\n') + 1);
  if (text.substr(0, bytes_of(text, place.column - 1)).ends_with(word))
    place.column -= static_cast<unsigned>(word.size());
  return place;
}

}  // namespace

toml::table parse_toml(std::string_view text, std::string const& name) {
  if (text.size() > largest_text)
    throw SceneError({name}, fmt::format("a scene has at most {} bytes", largest_text));
  Scan(text, name).run();
  try {
    return toml::parse(text, std::string_view(name));
  } catch (toml::parse_error const& error) {
    throw SceneError(failure_place(error, text, name), shown(error.description(), 300));
  }
}

}  // namespace actio::scene::detail
