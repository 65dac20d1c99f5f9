#include "actio/formula/formula_text.hpp"

namespace actio {

namespace detail {

std::string shown(std::string_view text) {
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

std::string shown_character(std::string_view text, std::size_t at) {
  auto const first = static_cast<unsigned char>(text[at]);
  if (first < 0x80) return "'" + shown(text.substr(at, 1)) + "'";
  std::size_t const length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  bool whole = first >= 0xC2 && first < 0xF5 && at + length <= text.size();
  for (std::size_t i = 1; whole && i < length; ++i)
    whole = (static_cast<unsigned char>(text[at + i]) & 0xC0) == 0x80;
  if (whole) return "'" + std::string(text.substr(at, length)) + "'";
  return "the byte " + std::to_string(first);
}

void FormulaText::advance() {
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

void FormulaText::number() {
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

void FormulaText::sign() {
  static constexpr std::string_view of_two[] = {"==", "!=", "<=", ">=", "&&", "||"};
  bool two = false;
  for (auto const pair : of_two) two = two || text_.substr(at_, 2) == pair;
  next_.text = text_.substr(at_, two ? 2 : 1);
  if (smooth_ && (two || std::string_view("<>!?:&|").find(text_[at_]) != std::string_view::npos))
    throw FormulaError(at_,
                       "found '" + std::string(next_.text) +
                           "', but this formula is smooth, since it is differentiated: no comparisons and "
                           "no cases");
  constexpr std::string_view known = "+-*/^(),;=<>!?:";
  if ((!two && known.find(text_[at_]) == std::string_view::npos) || text_.substr(at_, 2) == "**") refuse();
  next_.kind = Token::Kind::sign;
  at_ += next_.text.size();
}

void FormulaText::refuse() const {
  std::string const found = shown_character(text_, at_);
  char const c = text_[at_];
  if (c == '*') throw FormulaError(at_, "found '**', expected '^' for a power");
  if (c == '&' || c == '|')
    throw FormulaError(at_, "found " + found + ", expected '&&' for and, '||' for or");
  if (std::string_view("[]{}").find(c) != std::string_view::npos)
    throw FormulaError(at_, "found " + found + ", expected a round bracket");
  if (static_cast<unsigned char>(c) >= 0x80)
    throw FormulaError(at_, found + " is no part of a formula; names consist of a-z, A-Z, 0-9 and _");
  throw FormulaError(at_, found + " is no part of a formula");
}

}  // namespace detail

}  // namespace actio
