// Formulas as texts: "e = c*v2^2; (w^2 + v1^2 + e)/2" with the value behind definitions.
//
// Numbers, names, `pi`; + - * / ^ (to the right, before a sign: -2^2 = -4), brackets; sin cos tan asin acos
// atan atan2 sinh cosh tanh asinh acosh atanh exp log log2 log10 sqrt cbrt hypot. `log` is the natural one,
// angles are in radians. A formula is smooth: what has kinks or jumps is refused. Decimal numbers are exact.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "actio/formula/decimal_constant.hpp"
#include "actio/formula/formula_text.hpp"
#include "actio/formula/tape_builder.hpp"
#include "actio/numbers/nearest_name.hpp"

namespace actio {

namespace detail {
/// Reads a formula by recursive descent and records it.
class FormulaParser {
 public:
  using Entry = TapeBuilder::Entry;
  static constexpr std::size_t longest = 20000;  ///< characters
  static constexpr int deepest = 200;            ///< brackets in brackets

  FormulaParser(std::string_view text, std::vector<std::string> const& names,
                std::map<std::string, double> const& constants)
      : whole_(checked(text)), builder_(static_cast<int>(names.size())), text_(whole_) {
    for (std::size_t i = 0; i < names.size(); ++i) introduce(names[i], static_cast<Entry>(i));
    for (auto const& [name, value] : constants) {
      if (!std::isfinite(value))
        throw FormulaError(0, "the constant " + shown(name) + " is no finite number");
      introduce(name, decimal_constant(builder_, value));
    }
  }

  /// The tape of the value.
  Tape run() {
    try {
      return value_of_all();
    } catch (FormulaError const&) {
      throw;
    } catch (Error const& too_many_instructions) {
      fail(text_.next().position, too_many_instructions.what());
    }
  }

 private:
  Tape value_of_all() {
    Entry value = definition_or_value();
    while (text_.take_sign(';')) value = definition_or_value();
    if (defined_)
      fail(text_.next().position, "the value is expected behind the definitions, as in 'a = 2; a*x'");
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
    fail(text_.next().position, expected + " is expected, found " + text_.found());
  }

  // ---- Names.

  static Operation const* function_called(std::string_view name) {
    static constexpr auto all = [] {
      std::array<Operation, operations> list{};
      for (int i = 0; i < operations; ++i) list[static_cast<std::size_t>(i)] = static_cast<Operation>(i);
      return list;
    }();
    for (Operation const& o : all)
      if ((of_one_argument(o) || of_two_arguments(o)) && name_of(o) == name) return &o;
    return nullptr;
  }
  void introduce(std::string const& name, Entry entry) {
    if (!is_name(name))
      fail(0, "'" + shown(name) +
                  "' is no name for a number; names are a letter or _ and then letters, digits and _");
    if (name == "pi" || function_called(name))
      fail(0, "the name '" + name + "' has a meaning of its own in formulas; choose another one");
    if (!known_.emplace(name, entry).second) fail(0, "the name '" + shown(name) + "' is given twice");
  }
  /// Says why a name is refused.
  [[noreturn]] void unknown(Token const& name) const {
    static constexpr std::string_view with_kinks[] = {"abs",  "sign",  "min",  "max", "floor",
                                                      "ceil", "round", "fabs", "mod"};
    if (std::find(std::begin(with_kinks), std::end(with_kinks), name.text) != std::end(with_kinks))
      fail(name.position, "'" + std::string(name.text) +
                              "' has kinks or jumps, and a Lagrangian is smooth; |x| is smooth as sqrt(x^2 + "
                              "e^2) with a small e");
    std::vector<std::string> all;
    for (auto const& [known, entry] : known_) all.push_back(known);
    all.emplace_back("pi");
    for (int i = 0; i < operations; ++i)
      if (auto const o = static_cast<Operation>(i); of_one_argument(o) || of_two_arguments(o))
        all.emplace_back(name_of(o));
    fail(name.position, "unknown name '" + shown(name.text) + "'" +
                            did_you_mean(std::string(name.text), all) + " (known: " + listed(all) + ")");
  }

  // ---- The grammar.

  /// `name = sum` or `sum`.
  Entry definition_or_value() {
    auto const& next = text_.next();
    defined_ = next.kind == Token::Kind::name && text_.followed_by('=');
    if (!defined_) return sum();
    Token const name = text_.take();
    if (known_.contains(name.text))
      fail(name.position, "'" + shown(name.text) + "' has a value already; define another name");
    if (name.text == "pi" || function_called(name.text))
      fail(name.position,
           "'" + shown(name.text) + "' has a meaning of its own in formulas; define another name");
    text_.take();
    Entry const value = sum();
    if (!text_.is_sign(';')) {
      if (text_.next().kind == Token::Kind::end)
        fail(text_.next().position,
             "';' and the value are expected behind the definition of '" + shown(name.text) + "'");
      unexpected("an operator or ';'");
    }
    known_.emplace(name.text, value);
    return value;
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

  Entry number(Token const& token) {
    // The digits without the point, and the power of ten.
    std::string digits;
    long power = 0;
    bool behind = false;
    for (std::size_t i = 0; i < token.text.size(); ++i) {
      char const c = token.text[i];
      if (c == 'e' || c == 'E') {
        long exponent = 0;
        std::size_t const from = i + (token.text[i + 1] == '+' ? 2 : 1);
        std::from_chars(token.text.data() + from, token.text.data() + token.text.size(), exponent);
        power += exponent;
        break;
      }
      if (c == '.') {
        behind = true;
        continue;
      }
      digits += c;
      power -= behind;
    }
    if (token.value == 0) return builder_.number(0);
    return decimal_constant(builder_, digits, power, token.value);
  }

  Entry name(Token const& token) {
    auto const known = known_.find(token.text);
    if (known != known_.end()) {
      if (text_.is_sign('('))
        fail(text_.next().position,
             "an operator is expected behind '" + shown(token.text) + "', which is a number and no function");
      return known->second;
    }
    if (token.text == "pi") return builder_.pi();
    Operation const* const function = function_called(token.text);
    if (!function) unknown(token);
    return call(*function, token);
  }

  Entry call(Operation function, Token const& token) {
    if (!text_.is_sign('(')) unexpected("'(' behind the function " + std::string(token.text));
    Token const open = text_.take();
    Deeper const deeper(*this, open.position);
    Entry const x = sum();
    if (of_one_argument(function)) {
      if (text_.is_sign(','))
        fail(text_.next().position, std::string(token.text) + " is a function of one number, found a second");
      close(open);
      return finite(token.position, builder_.apply(function, x));
    }
    if (!text_.take_sign(',')) unexpected("',' and a second number for " + std::string(token.text));
    Entry const y = sum();
    close(open);
    return finite(token.position, builder_.apply(function, x, y));
  }

  /// A constant must be a finite number.
  Entry finite(std::size_t at, Entry e) const {
    if (builder_.is_constant(e) && !std::isfinite(builder_.value(e)))
      fail(at, "this part of the formula is constant, and its value is " + show(builder_.value(e)) +
                   "; a finite number is needed");
    return e;
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

  std::string_view whole_;
  TapeBuilder builder_;
  FormulaText text_;
  std::map<std::string, Entry, std::less<>> known_;
  bool defined_ = false;
  int depth_ = 0;
};
}  // namespace detail

/// The formula that a text writes.
///
///     Tape const l = parse_formula("(w^2 + v1^2 + c*v2^2)/2", {"w", "v1", "v2"}, {{"c", 6}});
///
/// @param text       definitions `name = formula;` and then the value; at most 20000 characters, at most 200
///                   brackets in brackets
/// @param names      what the inputs 0, 1, ... are called
/// @param constants  numbers with names; each is taken as the shortest decimal number that reads as it
/// @throws FormulaError  where the text is none, with the place; of the names, the place is 0
inline Tape parse_formula(std::string_view text, std::vector<std::string> const& names,
                          std::map<std::string, double> const& constants = {}) {
  return detail::FormulaParser(text, names, constants).run();
}

}  // namespace actio
