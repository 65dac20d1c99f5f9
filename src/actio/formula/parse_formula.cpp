#include "actio/formula/parse_formula.hpp"

namespace actio {

namespace detail {

FormulaParser::FormulaParser(std::string_view text, std::vector<std::string> const& names,
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

ReadFormula FormulaParser::run() {
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

Tape FormulaParser::value_of_all() {
  bool defined = false;
  for (; text_.next().kind == Token::Kind::name && text_.followed_by('='); defined = true) definition();
  if (defined && text_.next().kind == Token::Kind::end)
    unexpected("the value behind the definitions, as in 'a = 2; a*x'");
  Entry const value = sum();
  if (text_.is_sign(';')) unexpected("one formula; a definition is written 'a = 2;'");
  if (text_.next().kind != Token::Kind::end) unexpected("an operator");
  return builder_.tape(std::span(&value, 1));
}

std::string_view FormulaParser::checked(std::string_view text) {
  if (text.size() > longest)
    throw FormulaError(longest, "a formula has at most " + std::to_string(longest) +
                                    " characters, this one has " + std::to_string(text.size()));
  return text;
}

void FormulaParser::definition() {
  Token const name = text_.take();
  names_.require_free(name.text, name.position);
  text_.take();
  Entry const value = sum();
  if (!text_.take_sign(';'))
    unexpected("an operator, or ';' behind the definition of '" + shown(name.text) + "'");
  names_.add(name.text, value);
  defined_.emplace_back(name.text, name.position);
}

FormulaParser::Entry FormulaParser::sum() {
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

FormulaParser::Entry FormulaParser::product() {
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

FormulaParser::Entry FormulaParser::signed_power() {
  bool minus = false;
  while (text_.is_sign('+') || text_.is_sign('-')) minus ^= text_.take().text[0] == '-';
  Entry const value = raised();
  return minus ? builder_.negate(value) : value;
}

FormulaParser::Entry FormulaParser::raised() {
  Entry const base = atom();
  std::size_t const at = text_.next().position;
  if (!text_.take_sign('^')) return base;
  Deeper const deeper(*this, at);
  Entry const exponent = signed_power();
  return finite(at, builder_.power(base, exponent));
}

FormulaParser::Entry FormulaParser::atom() {
  Token const token = text_.next();
  if (token.kind == Token::Kind::number) return number(text_.take());
  if (token.kind == Token::Kind::name) return name(text_.take());
  if (!text_.is_sign('(')) unexpected("a number, a name or '('");
  return bracket();
}

FormulaParser::Entry FormulaParser::bracket() {
  Token const open = text_.take();
  Deeper const deeper(*this, open.position);
  Entry const value = sum();
  close(open);
  return value;
}

FormulaParser::Entry FormulaParser::name(Token const& token) {
  if (token.text == "pi") return builder_.pi();
  if (auto const function = function_called(token.text)) return call(*function, token);
  auto const entry = names_.use(token.text);
  if (!entry) names_.refuse(token, text_.is_sign('('));
  if (text_.is_sign('('))
    unexpected("an operator behind '" + shown(token.text) + "', which is a number and no function");
  return *entry;
}

FormulaParser::Entry FormulaParser::call(Operation function, Token const& token) {
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

FormulaParser::Entry FormulaParser::finite(std::size_t at, Entry e) const {
  if (!builder_.is_constant(e) || std::isfinite(builder_.value(e))) return e;
  fail(at, std::isnan(builder_.value(e))
               ? "this constant does not exist: a function is taken outside of its domain"
               : "this constant is infinite, or larger than a double");
}

FormulaParser::Deeper::Deeper(FormulaParser& parser, std::size_t at) : depth(parser.depth_) {
  if (depth >= deepest) fail(at, "at most " + std::to_string(deepest) + " brackets and powers may be open");
  ++depth;
}

}  // namespace detail

}  // namespace actio
