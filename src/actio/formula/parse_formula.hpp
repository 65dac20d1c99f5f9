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
                std::map<std::string, double> const& constants)
      : builder_(static_cast<int>(names.size())), text_(checked(text)) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      names_.require_free(names[i], 0);
      names_.add(names[i], static_cast<Entry>(i));
    }
    for (auto const& [name, value] : constants) {
      names_.require_free(name, 0);
      if (!std::isfinite(value)) throw FormulaError(0, "the constant '" + name + "' is no finite number");
      names_.add(name, decimal_constant(builder_, value));
    }
  }

  /// All of it.
  ReadFormula run() {
    try {
      ReadFormula out{value_of_all(), names_.used()};
      for (auto const& [name, position] : defined_)
        if (!out.used.contains(name)) out.unused.emplace_back(name, position);
      return out;
    } catch (FormulaError const&) {
      throw;
    } catch (Error const& too_many_instructions) {
      fail(text_.next().position, too_many_instructions.what());
    }
  }

 private:
  Tape value_of_all() {
    bool defined = false;
    for (; text_.next().kind == Token::Kind::name && text_.followed_by('='); defined = true) definition();
    if (defined && text_.next().kind == Token::Kind::end)
      unexpected("the value behind the definitions, as in 'a = 2; a*x'");
    Entry const value = sum();
    if (text_.is_sign(';')) unexpected("one formula; a definition is written 'a = 2;'");
    if (text_.next().kind != Token::Kind::end) unexpected("an operator");
    return builder_.tape(std::span(&value, 1));
  }
  static std::string_view checked(std::string_view text) {
    if (text.size() > longest)
      throw FormulaError(longest, "a formula has at most " + std::to_string(longest) +
                                      " characters, this one has " + std::to_string(text.size()));
    return text;
  }
  [[noreturn]] static void fail(std::size_t position, std::string const& what) {
    throw FormulaError(position, what);
  }
  [[noreturn]] void unexpected(std::string const& expected) const {
    fail(text_.next().position, "found " + text_.found() + ", expected " + expected);
  }

  // ---- The grammar.

  /// `name = sum ;`
  void definition() {
    Token const name = text_.take();
    names_.require_free(name.text, name.position);
    text_.take();
    Entry const value = sum();
    if (!text_.take_sign(';'))
      unexpected("an operator, or ';' behind the definition of '" + shown(name.text) + "'");
    names_.add(name.text, value);
    defined_.emplace_back(name.text, name.position);
  }

  Entry sum() {
    Entry value = product();
    for (;;) {
      std::size_t const at = text_.next().position;
      if (text_.take_sign('+'))
        value = finite(at, builder_.add(value, product()));
      else if (text_.take_sign('-'))
        value = finite(at, builder_.subtract(value, product()));
      else
        return value;
    }
  }

  Entry product() {
    Entry value = signed_power();
    for (;;) {
      std::size_t const at = text_.next().position;
      if (text_.take_sign('*'))
        value = finite(at, builder_.multiply(value, signed_power()));
      else if (text_.take_sign('/'))
        value = divided(at, value, signed_power());
      else
        return value;
    }
  }
  Entry divided(std::size_t at, Entry value, Entry by) {
    if (builder_.is_constant(by) && builder_.value(by) == 0) fail(at, "the divisor is zero");
    return finite(at, builder_.divide(value, by));
  }

  Entry signed_power() {
    bool minus = false;
    while (text_.is_sign('+') || text_.is_sign('-')) minus ^= text_.take().text[0] == '-';
    Entry const value = raised();
    return minus ? builder_.negate(value) : value;
  }

  Entry raised() {
    Entry const base = atom();
    std::size_t const at = text_.next().position;
    if (!text_.take_sign('^')) return base;
    Deeper const deeper(*this, at);
    Entry const exponent = signed_power();
    return finite(at, builder_.power(base, exponent));
  }

  Entry atom() {
    Token const token = text_.next();
    if (token.kind == Token::Kind::number) return number(text_.take());
    if (token.kind == Token::Kind::name) return name(text_.take());
    if (!text_.is_sign('(')) unexpected("a number, a name or '('");
    return bracket();
  }

  Entry bracket() {
    Token const open = text_.take();
    Deeper const deeper(*this, open.position);
    Entry const value = sum();
    close(open);
    return value;
  }
  void close(Token const& open) {
    if (text_.take_sign(')')) return;
    if (text_.next().kind == Token::Kind::end) fail(open.position, "this bracket is not closed");
    unexpected("an operator or ')'");
  }

  Entry number(Token const& token) { return decimal_constant(builder_, token.text, token.value); }

  Entry name(Token const& token) {
    if (token.text == "pi") return builder_.pi();
    if (auto const function = function_called(token.text)) return call(*function, token);
    auto const entry = names_.use(token.text);
    if (!entry) names_.refuse(token, text_.is_sign('('));
    if (text_.is_sign('('))
      unexpected("an operator behind '" + shown(token.text) + "', which is a number and no function");
    return *entry;
  }

  Entry call(Operation function, Token const& token) {
    std::string const name(token.text);
    if (!text_.is_sign('(')) unexpected("'(' behind the function " + name);
    Token const open = text_.take();
    Deeper const deeper(*this, open.position);
    Entry const x = sum();
    if (of_one_argument(function)) {
      if (text_.is_sign(',')) unexpected("')', for " + name + " is a function of one number");
      close(open);
      return finite(token.position, builder_.apply(function, x));
    }
    if (!text_.take_sign(',')) unexpected("',' before the second number of " + name);
    Entry const y = sum();
    close(open);
    return finite(token.position, builder_.apply(function, x, y));
  }

  /// A constant must be a finite number.
  Entry finite(std::size_t at, Entry e) const {
    if (!builder_.is_constant(e) || std::isfinite(builder_.value(e))) return e;
    fail(at, std::isnan(builder_.value(e))
                 ? "this constant does not exist: a function is taken outside of its domain"
                 : "this constant is infinite, or larger than a double");
  }

  /// One bracket or power further in.
  struct Deeper {
    int& depth;
    Deeper(FormulaParser& parser, std::size_t at) : depth(parser.depth_) {
      if (depth >= deepest)
        fail(at, "at most " + std::to_string(deepest) + " brackets and powers may be open");
      ++depth;
    }
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
