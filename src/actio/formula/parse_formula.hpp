// Formulas as texts: "e = c*v2^2; (w^2 + v1^2 + e)/2" with the value behind definitions.
//
// Formulas with names, `FormulaDefinitions`, stand beside it, and are read where their names occur.
//
// Numbers, names, `pi`; + - * / ^ (to the right, before a sign: -2^2 = -4), brackets; sin cos tan asin acos
// atan atan2 sinh cosh tanh asinh acosh atanh exp log log2 log10 sqrt cbrt hypot. `log` is the natural one,
// angles are in radians. Decimal numbers are exact.
//
// A formula that is differentiated is smooth: what has kinks or jumps is refused. Where only values are taken
// there are also < <= > >= == !=, which are 1 or 0, && || ! (any number but 0 holds), `a ? b : c`, and abs
// sign floor ceil round min max, the last two of any number of arguments.
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

/// What a formula is read for.
struct FormulaUse {
  bool derivatives = true;       ///< it is differentiated, so that it must be smooth, and it is simplified
  std::size_t longest = 200000;  ///< characters that it may have
  int deepest = 200;             ///< brackets, powers and cases that may be open
};
/// Formulas by their names, in the inputs, the constants and each other.
using FormulaDefinitions = std::map<std::string, std::string, std::less<>>;
/// For its values alone: each operation is carried out in double precision as it is written.
inline constexpr FormulaUse for_values{false, 2000, 50};

namespace detail {
/// Reads a formula by recursive descent and records it.
class FormulaParser {
 public:
  using Entry = TapeBuilder::Entry;

  FormulaParser(std::string_view text, std::vector<std::string> const& names,
                std::map<std::string, double> const& constants, FormulaUse use,
                FormulaDefinitions const& definitions);

  /// All of it.
  ReadFormula run();

 private:
  Tape value_of_all();
  /// Gives the named formulas that occur in a text their entries, each behind those that it uses.
  void define_names_in(std::string_view text);
  void define(std::string const& name, std::string const& text);
  static std::string_view checked(std::string_view text, FormulaUse use);
  [[noreturn]] static void fail(std::size_t position, std::string const& what) {
    throw FormulaError(position, what);
  }
  [[noreturn]] void unexpected(std::string const& expected) const;

  // ---- The grammar.

  /// `name = value ;`
  void definition();
  /// `holds ? value : ...`, the last case being what holds otherwise.
  Entry value();
  /// What signs of one level and of those that bind closer join, from the left; the next one is a power.
  Entry joined(int level);
  Entry signed_power();
  Entry raised();
  Entry atom();
  Entry bracket();
  void close(Token const& open) {
    if (text_.take_sign(")")) return;
    if (text_.next().kind == Token::Kind::end) fail(open.position, "this bracket is not closed");
    unexpected("an operator or ')'");
  }
  Entry name(Token const& token);
  Entry call(Operation function, Token const& token);

  Entry record(Operation operation, Entry a, Entry b) {
    return use_.derivatives ? builder_.record(operation, a, b) : builder_.as_written(operation, a, b);
  }
  /// A constant must be a finite number.
  Entry finite(std::size_t at, Entry e) const;

  /// One bracket, power or case further in.
  struct Deeper {
    int& depth;
    Deeper(FormulaParser& parser, std::size_t at);
    ~Deeper() { --depth; }
    Deeper(Deeper const&) = delete;
    Deeper& operator=(Deeper const&) = delete;
  };

  FormulaUse use_;
  TapeBuilder builder_;
  FormulaText text_;
  FormulaNames names_;
  std::vector<std::pair<std::string, std::size_t>> defined_;
  FormulaDefinitions const& definitions_;
  std::vector<std::string> open_;  ///< the named formulas that are being read, each used by the one before
  int depth_ = 0;
};
}  // namespace detail

/// The formula that a text writes.
///
///     Tape const l = parse_formula("(w^2 + v1^2 + c*v2^2)/2", {"w", "v1", "v2"}, {{"c", 6}});
///
/// \snippet numbers.cpp parse_formula
/// @param text       definitions `name = formula;` and then the value
/// @param names      what the inputs 0, 1, ... are called
/// @param constants  numbers with names; each is taken as the shortest decimal number that reads as it
/// @param use        whether it is differentiated, and how long it may be
/// @throws FormulaError  where the text is none, with the place; of the names, the place is 0
inline Tape parse_formula(std::string_view text, std::vector<std::string> const& names,
                          std::map<std::string, double> const& constants = {}, FormulaUse use = {}) {
  return detail::FormulaParser(text, names, constants, use, {}).run().value;
}
/// The same, with the names that it uses.
///
/// \snippet numbers.cpp read_formula
/// @param definitions  formulas with names; only those are read whose names occur
/// @throws FormulaError  where one of these is none as well, or is defined by itself
inline ReadFormula read_formula(std::string_view text, std::vector<std::string> const& names,
                                std::map<std::string, double> const& constants = {}, FormulaUse use = {},
                                FormulaDefinitions const& definitions = {}) {
  return detail::FormulaParser(text, names, constants, use, definitions).run();
}

}  // namespace actio
