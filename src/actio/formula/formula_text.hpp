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
inline std::string shown(std::string_view text) {
  constexpr std::size_t most = 40;
  std::string out;
  for (char c : text.substr(0, most)) {
    auto const byte = static_cast<unsigned char>(c);
    constexpr char const* hexadecimal = "0123456789ABCDEF";
    if (byte < 0x20 || byte == 0x7F)
      out += {'\\', 'x', hexadecimal[byte / 16], hexadecimal[byte % 16]};
    else
      out += c;
  }
  return text.size() > most ? out + "..." : out;
}

/// A character of more than one byte, or the byte where the text is no UTF-8.
inline std::string shown_character(std::string_view text, std::size_t at) {
  auto const first = static_cast<unsigned char>(text[at]);
  if (first < 0x80) return "'" + shown(text.substr(at, 1)) + "'";
  std::size_t const length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  bool whole = first >= 0xC2 && first < 0xF5 && at + length <= text.size();
  for (std::size_t i = 1; whole && i < length; ++i)
    whole = (static_cast<unsigned char>(text[at + i]) & 0xC0) == 0x80;
  if (whole) return "'" + std::string(text.substr(at, length)) + "'";
  return "the byte " + std::to_string(first);
}

/// Reads a formula part by part.
class FormulaText {
 public:
  explicit FormulaText(std::string_view text) : text_(text) { advance(); }

  /// The part that comes next.
  Token const& next() const { return next_; }
  /// Whether it is this sign.
  bool is_sign(char c) const { return next_.kind == Token::Kind::sign && next_.text[0] == c; }
  /// Takes the next part.
  Token take() {
    Token const taken = next_;
    advance();
    return taken;
  }
  /// Takes the next part where it is this sign.
  bool take_sign(char c) {
    if (!is_sign(c)) return false;
    advance();
    return true;
  }
  /// The next part, for a message.
  std::string found() const {
    return next_.kind == Token::Kind::end ? "the end" : "'" + shown(next_.text) + "'";
  }
  /// Whether the character behind the next part, spaces aside, is this one.
  bool followed_by(char c) const {
    std::size_t i = at_;
    while (i < text_.size() && is_space(text_[i])) ++i;
    return i < text_.size() && text_[i] == c;
  }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
  char at(std::size_t i) const { return i < text_.size() ? text_[i] : '\0'; }

  void advance() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
    std::size_t const begin = at_;
    next_ = {Token::Kind::end, {}, begin, 0};
    if (begin == text_.size()) return;
    char const c = text_[begin];
    if (is_digit(c) || c == '.')
      number();
    else if (is_letter(c))
      name();
    else
      sign();
    next_.text = text_.substr(begin, at_ - begin);
  }

  void name() {
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    next_.kind = Token::Kind::name;
  }

  void number() {
    std::size_t const begin = at_;
    auto const digits = [&] {
      std::size_t const from = at_;
      while (is_digit(at(at_))) ++at_;
      return at_ > from;
    };
    bool const before = digits();
    bool const point = at(at_) == '.';
    if (point) ++at_;
    bool const behind = point && digits();
    if (point && !(before && behind))
      throw FormulaError(begin, "found '" + shown(text_.substr(begin, at_ - begin)) +
                                    "', expected a digit on both sides of the point");
    std::size_t const sign = at(at_ + 1) == '+' || at(at_ + 1) == '-' ? 1 : 0;
    if ((at(at_) == 'e' || at(at_) == 'E') && is_digit(at(at_ + 1 + sign))) {
      at_ += 1 + sign;
      digits();
    }
    next_.kind = Token::Kind::number;
    auto const text = text_.substr(begin, at_ - begin);
    auto const error = std::from_chars(text.data(), text.data() + text.size(), next_.value).ec;
    if (error != std::errc())
      throw FormulaError(begin, "the number " + shown(text) + " is too large or too small for a double");
    if (is_letter(at(at_)) || at(at_) == '.')
      throw FormulaError(at_, "found '" + shown(text_.substr(at_, 1)) + "' behind the number " + shown(text) +
                                  ", expected an operator; a product is written 2*x");
  }

  void sign() {
    constexpr std::string_view known = "+-*/^(),;=";
    char const c = text_[at_];
    if (known.find(c) == std::string_view::npos || text_.substr(at_, 2) == "==" ||
        text_.substr(at_, 2) == "**")
      refuse(c);
    next_.kind = Token::Kind::sign;
    ++at_;
  }

  [[noreturn]] void refuse(char c) const {
    std::string const found = text_.substr(at_, 2) == "==" ? "'=='" : shown_character(text_, at_);
    if (std::string_view("<>!&|?:=").find(c) != std::string_view::npos)
      throw FormulaError(at_, "found " + found + ", but a Lagrangian is smooth: no comparisons and no cases");
    if (c == '*') throw FormulaError(at_, "found '**', expected '^' for a power");
    if (std::string_view("[]{}").find(c) != std::string_view::npos)
      throw FormulaError(at_, "found " + found + ", expected a round bracket");
    if (static_cast<unsigned char>(c) >= 0x80)
      throw FormulaError(at_, found + " is no part of a formula; names consist of a-z, A-Z, 0-9 and _");
    throw FormulaError(at_, found + " is no part of a formula");
  }

  std::string_view text_;
  std::size_t at_ = 0;
  Token next_;
};

}  // namespace actio::detail
