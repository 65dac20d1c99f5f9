// A place in the text of a Gmsh file, from which numbers and words are read, written in digits or in bytes.
//
// Nothing is reserved for a count that the file announces before the rest of the file is known to be long
// enough for it, so that memory is bounded by the size of the file.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "actio/numbers/errors.hpp"

namespace actio::media {

/// A file that is no Gmsh mesh, or none that can be read: what is wrong, and in which line or byte.
struct NotAGmshFile : Error {
  std::size_t byte;  ///< where, from 0
  std::size_t line;  ///< the same as a line of text, from 1
  /// @param name    of the file
  /// @param text    all of it
  /// @param at      the byte
  /// @param binary  whether numbers are bytes; if not the message names the line
  /// @param what    what is wrong
  NotAGmshFile(std::string const& name, std::string_view text, std::size_t at, bool binary,
               std::string const& what)
      : Error(name + ", " + place(text, at, binary) + ": " + what), byte(at), line(line_of(text, at)) {}

 private:
  static std::size_t line_of(std::string_view text, std::size_t at) {
    std::size_t line = 1;
    for (char c : text.substr(0, at)) line += c == '\n';
    return line;
  }
  static std::string place(std::string_view text, std::size_t at, bool binary) {
    return binary ? "byte " + std::to_string(at) : "line " + std::to_string(line_of(text, at));
  }
};

/// Reads a Gmsh file from its beginning.
class GmshCursor {
 public:
  bool binary = false;  ///< whether numbers are bytes, as the section MeshFormat says
  /// @param text  all of the file; it must outlive the cursor
  /// @param name  of the file, for messages
  GmshCursor(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  /// The byte that is read next.
  std::size_t at() const { return at_; }
  /// The byte where the last word or number begins.
  std::size_t last() const { return last_; }
  /// How many bytes there are still.
  std::size_t left() const { return text_.size() - at_; }
  /// @throws NotAGmshFile  always, at the last word or number that was read
  [[noreturn]] void fail(std::string const& what) const { fail_at(last_, what); }
  /// @throws NotAGmshFile  always, at a byte of the file
  [[noreturn]] void fail_at(std::size_t byte, std::string const& what) const {
    throw NotAGmshFile(name_, text_, byte, binary, what);
  }

  /// Whether nothing but blanks is left.
  bool done() {
    skip_blanks();
    return left() == 0;
  }
  /// The next word: what stands up to the next blank, or to a quotation mark.
  /// @throws NotAGmshFile  where the file ends
  std::string_view word(char const* what);
  /// The rest of the line, and on to the next one.
  std::string_view line();
  /// What stands between quotation marks.
  std::string quoted();
  /// On to what follows a word; false, and nowhere, if the word does not come any more.
  bool pass(std::string const& sought);
  /// Whether the next thing is a name in quotation marks.
  bool at_quote() {
    skip_blanks();
    return left() > 0 && text_[at_] == '"';
  }
  /// A word that must come next.
  void expect(std::string_view sought) { require(word(std::string(sought).c_str()), sought); }
  /// Refuses the word that was read last, if it is another one.
  void require(std::string_view found, std::string_view sought) const {
    if (found != sought) fail(std::string(sought) + " is needed, and '" + shown(found) + "' is found");
  }

  /// A number in digits, also in a binary file.
  template <class T>
  T in_digits(char const* what) {
    auto const token = word(what);
    T value{};
    // A sign of plus is one that std::from_chars does not know.
    bool const plus = token.size() > 1 && token[0] == '+' && token[1] != '-';
    auto [end, error] = std::from_chars(token.data() + plus, token.data() + token.size(), value);
    // What is nearer to zero than all numbers is zero.
    if constexpr (std::is_floating_point_v<T>)
      if (error == std::errc::result_out_of_range && token.find_first_of("eE") != token.npos)
        error = std::errc(),
        value = token.find('-', token.find_first_of("eE")) != token.npos ? T(0) : T(HUGE_VAL);
    if (error != std::errc() || end != token.data() + token.size())
      fail(std::string(what) + " should be a number, and is '" + shown(token) + "'");
    return finite(value, what);
  }
  /// A number: in digits, or in a binary file in the bytes of T.
  template <class T>
  T number(char const* what) {
    if (!binary) return in_digits<T>(what);
    last_ = at_;
    if (left() < sizeof(T)) fail(std::string("the file ends where ") + what + " should be");
    T value;
    std::memcpy(&value, text_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return finite(value, what);
  }
  /// Refuses a count of things of which each takes so many numbers, if they cannot be in the rest of the
  /// file: a number in digits takes two bytes at least.
  /// @param bytes  what one takes in a binary file
  std::size_t checked(std::size_t count, std::size_t numbers, std::size_t bytes, char const* what) const;

 private:
  std::string_view text_;
  std::string name_;
  std::size_t at_ = 0, last_ = 0;

  static bool blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  void skip_blanks() {
    while (at_ < text_.size() && blank(text_[at_])) ++at_;
  }
  // The first letters of a word, without those that no screen shows.
  static std::string shown(std::string_view word) {
    std::string out;
    for (char c : word.substr(0, 24)) out += c >= ' ' && c <= '~' ? c : '?';
    return out;
  }
  template <class T>
  T finite(T value, char const* what) const {
    if constexpr (std::is_floating_point_v<T>)
      if (!std::isfinite(value)) fail(std::string(what) + " is no finite number");
    return value;
  }
};

}  // namespace actio::media
