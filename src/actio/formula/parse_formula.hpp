// Formulas as texts: "e = c*v2^2; (w^2 + v1^2 + e)/2" with the value behind definitions.
//
// Numbers, names, `pi`; + - * / ^ (to the right, before a sign: -2^2 = -4), brackets; sin cos tan asin acos
// atan atan2 sinh cosh tanh asinh acosh atanh exp log log2 log10 sqrt cbrt hypot. `log` is the natural one,
// angles are in radians. A formula is smooth: what has kinks or jumps is refused. Decimal numbers are exact.
#pragma once

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "actio/formula/decimal_constant.hpp"
#include "actio/formula/formula_names.hpp"
#include "actio/formula/formula_text.hpp"
#include "actio/formula/tape_builder.hpp"

namespace actio {

/// A formula that was read.
struct ReadFormula {
  Tape value;                               ///< behind the definitions
  std::set<std::string, std::less<>> used;  ///< names of inputs, constants and definitions that occur in it
  /// the definitions whose names occur nowhere, and the bytes of the text where these stand
  std::vector<std::pair<std::string, std::size_t>> unused = {};
};

namespace detail {
/// Reads a formula by recursive descent and records it.
class FormulaParser {
 public:
  using Entry = TapeBuilder::Entry;
  static constexpr std::size_t longest = 200000;  ///< characters
  static constexpr int deepest = 200;             ///< brackets in brackets

  FormulaParser(std::string_view text, std::vector<std::string> const& names,
                std::map<std::string, double> const& constants);

  /// All of it.
  ReadFormula run();

 private:
  Tape value_of_all();
  static std::string_view checked(std::string_view text);
  [[noreturn]] static void fail(std::size_t position, std::string const& what) {
    throw FormulaError(position, what);
  }
  [[noreturn]] void unexpected(std::string const& expected) const {
    fail(text_.next().position, "found " + text_.found() + ", expected " + expected);
  }

  // ---- The grammar.

  /// `name = sum ;`
  void definition();

  Entry sum();

  Entry product();
  Entry divided(std::size_t at, Entry value, Entry by) {
    if (builder_.is_constant(by) && builder_.value(by) == 0) fail(at, "the divisor is zero");
    return finite(at, builder_.divide(value, by));
  }

  Entry signed_power();

  Entry raised();

  Entry atom();

  Entry bracket();
  void close(Token const& open) {
    if (text_.take_sign(')')) return;
    if (text_.next().kind == Token::Kind::end) fail(open.position, "this bracket is not closed");
    unexpected("an operator or ')'");
  }

  Entry number(Token const& token) { return decimal_constant(builder_, token.text, token.value); }

  Entry name(Token const& token);

  Entry call(Operation function, Token const& token);

  /// A constant must be a finite number.
  Entry finite(std::size_t at, Entry e) const;

  /// One bracket or power further in.
  struct Deeper {
    int& depth;
    Deeper(FormulaParser& parser, std::size_t at);
    ~Deeper() { --depth; }
    Deeper(Deeper const&) = delete;
    Deeper& operator=(Deeper const&) = delete;
  };

  TapeBuilder builder_;
  FormulaText text_;
  FormulaNames names_;
  std::vector<std::pair<std::string, std::size_t>> defined_;
  int depth_ = 0;
};
}  // namespace detail

/// The formula that a text writes.
///
///     Tape const l = parse_formula("(w^2 + v1^2 + c*v2^2)/2", {"w", "v1", "v2"}, {{"c", 6}});
///
/// @param text       definitions `name = formula;` and then the value; at most 200000 characters, at most 200
///                   brackets in brackets
/// @param names      what the inputs 0, 1, ... are called
/// @param constants  numbers with names; each is taken as the shortest decimal number that reads as it
/// @throws FormulaError  where the text is none, with the place; of the names, the place is 0
inline Tape parse_formula(std::string_view text, std::vector<std::string> const& names,
                          std::map<std::string, double> const& constants = {}) {
  return detail::FormulaParser(text, names, constants).run().value;
}
/// The same, with the names that it uses.
inline ReadFormula read_formula(std::string_view text, std::vector<std::string> const& names,
                                std::map<std::string, double> const& constants = {}) {
  return detail::FormulaParser(text, names, constants).run();
}

}  // namespace actio
