// The text of a formula, taken apart into numbers, names and signs.
#pragma once

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "actio/formula/formula_error.hpp"

namespace actio::detail {

/// A part of a formula.
struct Token {
  enum class Kind { number, name, sign, end };
  Kind kind = Kind::end;
  std::string_view text;     ///< as it is written
  std::size_t position = 0;  ///< where it begins
  double value = 0;          ///< of a number, the double nearest to it
};

/// Whether a name can begin with a character.
constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
/// Whether it is a decimal digit.
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
/// Whether a text can be the name of a number.
constexpr bool is_name(std::string_view text) {
  if (text.empty() || !is_letter(text[0])) return false;
  for (char c : text)
    if (!is_letter(c) && !is_digit(c)) return false;
  return true;
}

/// A piece of a text for a message: in one line, and short.
std::string shown(std::string_view text);

/// A character of more than one byte, or the byte where the text is no UTF-8.
std::string shown_character(std::string_view text, std::size_t at);

/// Reads a formula part by part.
class FormulaText {
 public:
  /// @param smooth  whether comparisons and cases are refused
  FormulaText(std::string_view text, bool smooth) : text_(text), smooth_(smooth) { advance(); }

  /// The part that comes next.
  Token const& next() const { return next_; }
  /// Whether it is this sign.
  bool is_sign(std::string_view sign) const { return next_.kind == Token::Kind::sign && next_.text == sign; }
  /// Takes the next part.
  Token take() {
    Token const taken = next_;
    advance();
    return taken;
  }
  /// Takes the next part where it is this sign.
  bool take_sign(std::string_view sign) {
    if (!is_sign(sign)) return false;
    advance();
    return true;
  }
  /// The next part, for a message.
  std::string found() const {
    return next_.kind == Token::Kind::end ? "the end" : "'" + shown(next_.text) + "'";
  }
  /// Whether the next part is a name and is defined here: '=' follows.
  bool is_definition() const {
    std::size_t i = at_;
    while (is_space(at(i))) ++i;
    return next_.kind == Token::Kind::name && at(i) == '=' && at(i + 1) != '=';
  }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
  char at(std::size_t i) const { return i < text_.size() ? text_[i] : '\0'; }

  void advance();

  void name() {
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    next_.kind = Token::Kind::name;
  }

  void number();

  void sign();

  [[noreturn]] void refuse() const;

  std::string_view text_;
  bool smooth_;
  std::size_t at_ = 0;
  Token next_;
};

}  // namespace actio::detail
