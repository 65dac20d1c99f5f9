#include "actio/formula/parse_formula.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace actio {

namespace detail {

FormulaParser::FormulaParser(std::string_view text, std::vector<std::string> const& names,
                             std::map<std::string, double> const& constants, FormulaUse use,
                             FormulaDefinitions const& definitions)
    : use_(use),
      builder_(static_cast<int>(names.size())),
      text_(checked(text, use), use.derivatives),
      names_(use.derivatives),
      definitions_(definitions) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    names_.require_free(names[i], 0);
    names_.add(names[i], static_cast<Entry>(i));
  }
  for (auto const& [name, value] : constants) {
    names_.require_free(name, 0);
    if (!std::isfinite(value)) throw FormulaError(0, "the constant '" + name + "' is no finite number");
    names_.add(name, decimal_constant(builder_, value));
  }
  for (auto const& [name, its_text] : definitions) {
    names_.require_free(name, 0);
    names_.offer(name);
  }
  define_names_in(text);
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
    FormulaError error(text_.next().position, too_many_instructions.what());
    if (!open_.empty()) error.within = open_.back();
    throw error;
  }
}

Tape FormulaParser::value_of_all() {
  while (text_.is_definition()) definition();
  if (!defined_.empty() && text_.next().kind == Token::Kind::end)
    unexpected("the value behind the definitions, as in 'a = 2; a*x'");
  Entry const result = value();
  if (text_.is_sign(";")) unexpected("one formula; a definition is written 'a = 2;'");
  if (text_.next().kind != Token::Kind::end) unexpected("an operator");
  return builder_.tape(std::span(&result, 1));
}

void FormulaParser::define_names_in(std::string_view text) {
  if (definitions_.empty()) return;
  for (FormulaText parts(text, use_.derivatives); parts.next().kind != Token::Kind::end; parts.take()) {
    Token const& token = parts.next();
    auto const found = definitions_.find(token.text);
    if (token.kind != Token::Kind::name || found == definitions_.end()) continue;
    auto const& [name, its_text] = *found;
    if (std::ranges::find(open_, name) != open_.end()) {
      std::string round;
      for (auto const& each : open_) round += each + ", ";
      fail(token.position, "a definition cannot use itself; here each uses the next: " + round + name);
    }
    if (!names_.has(name)) define(name, its_text);
  }
}

void FormulaParser::define(std::string const& name, std::string const& text) {
  open_.push_back(name);
  try {
    if (auto const most = static_cast<std::size_t>(use_.deepest); open_.size() > most)
      fail(0, "at most " + std::to_string(most) + " definitions may each use the next");
    define_names_in(checked(text, use_));
    FormulaText const around = std::exchange(text_, FormulaText(text, use_.derivatives));
    if (text_.is_definition()) unexpected("one formula; what it uses has a name beside it");
    Entry const defined = value();
    if (text_.next().kind != Token::Kind::end) unexpected("an operator, or the end");
    text_ = around;
    names_.add(name, defined);
  } catch (FormulaError& error) {
    if (error.within.empty()) error.within = name;
    throw;
  }
  open_.pop_back();
}

std::string_view FormulaParser::checked(std::string_view text, FormulaUse use) {
  if (text.size() > use.longest)
    fail(use.longest, "a formula has at most " + std::to_string(use.longest) + " characters, this one has " +
                          std::to_string(text.size()));
  return text;
}

void FormulaParser::unexpected(std::string const& expected) const {
  fail(text_.next().position, "found " + text_.found() + ", expected " + expected +
                                  (text_.is_sign("=") && !use_.derivatives ? "; 'is equal to' is ==" : ""));
}

void FormulaParser::definition() {
  Token const name = text_.take();
  names_.require_free(name.text, name.position);
  text_.take();
  Entry const defined = value();
  if (!text_.take_sign(";"))
    unexpected("an operator, or ';' behind the definition of '" + shown(name.text) + "'");
  names_.add(name.text, defined);
  defined_.emplace_back(name.text, name.position);
}

FormulaParser::Entry FormulaParser::value() {
  std::vector<std::pair<Entry, Entry>> cases;
  Entry last = joined(0);
  while (text_.is_sign("?")) {
    Deeper const deeper(*this, text_.take().position);
    cases.emplace_back(last, value());
    if (!text_.take_sign(":")) unexpected("an operator, or ':' and what holds otherwise");
    last = joined(0);
  }
  for (; !cases.empty(); cases.pop_back()) {
    auto const [holds, then] = cases.back();
    last =
        record(Operation::add, record(Operation::where, holds, then), record(Operation::unless, holds, last));
  }
  return last;
}

namespace {

/// A sign between two operands; those of a higher level bind closer.
struct Joint {
  int level;
  std::string_view sign;
  Operation operation;
  bool turned_round = false;  ///< the second operand comes first
};
constexpr int comparison = 2;  ///< the level of signs of which one expression has one
constexpr Joint joints[] = {
    {0, "||", Operation::either},  {1, "&&", Operation::both},      {2, "<", Operation::less},
    {2, "<=", Operation::at_most}, {2, ">", Operation::less, true}, {2, ">=", Operation::at_most, true},
    {2, "==", Operation::equal},   {2, "!=", Operation::unequal},   {3, "+", Operation::add},
    {3, "-", Operation::subtract}, {4, "*", Operation::multiply},   {4, "/", Operation::divide}};

}  // namespace

FormulaParser::Entry FormulaParser::joined(int level) {
  if (level > joints[std::size(joints) - 1].level) return signed_power();
  Entry left = joined(level + 1);
  for (bool first = true;; first = false) {
    auto const joint = std::ranges::find_if(
        joints, [&](Joint const& j) { return j.level == level && text_.is_sign(j.sign); });
    if (joint == std::end(joints)) return left;
    std::size_t const at = text_.take().position;
    // (0 < X) < 1 would compare 0 or 1 with 1.
    if (level == comparison && !first)
      fail(at,
           "a second comparison in a row; a range is written 0 < x && x < 1, and the truth of one is "
           "compared in brackets");
    Entry right = joined(level + 1);
    if (joint->operation == Operation::divide && builder_.is_constant(right) && builder_.value(right) == 0)
      fail(at, "the divisor is zero");
    if (joint->turned_round) std::swap(left, right);
    left = finite(at, record(joint->operation, left, right));
  }
}

FormulaParser::Entry FormulaParser::signed_power() {
  std::string signs;
  while (text_.is_sign("+") || text_.is_sign("-") || text_.is_sign("!")) signs += text_.take().text;
  Entry result = raised();
  for (; !signs.empty(); signs.pop_back()) {
    if (signs.back() == '-') result = record(Operation::negate, result, result);
    if (signs.back() == '!') result = record(Operation::equal, result, builder_.number(0));
  }
  return result;
}

FormulaParser::Entry FormulaParser::raised() {
  Entry const base = atom();
  std::size_t const at = text_.next().position;
  if (!text_.take_sign("^")) return base;
  Deeper const deeper(*this, at);
  return finite(at, record(Operation::power, base, signed_power()));
}

FormulaParser::Entry FormulaParser::atom() {
  Token const token = text_.next();
  if (text_.is_sign("(")) return bracket();
  if (token.kind != Token::Kind::number && token.kind != Token::Kind::name)
    unexpected("a number, a name or '('");
  text_.take();
  return token.kind == Token::Kind::name ? name(token) : decimal_constant(builder_, token.text, token.value);
}

FormulaParser::Entry FormulaParser::bracket() {
  Token const open = text_.take();
  Deeper const deeper(*this, open.position);
  Entry const inside = value();
  close(open);
  return inside;
}

FormulaParser::Entry FormulaParser::name(Token const& token) {
  if (token.text == "pi") return builder_.pi();
  if (auto const function = names_.function(token)) return call(*function, token);
  auto const entry = names_.use(token.text);
  if (!entry) names_.refuse(token, text_.is_sign("("));
  if (text_.is_sign("("))
    unexpected("an operator behind '" + shown(token.text) + "', which is a number and no function");
  return *entry;
}

FormulaParser::Entry FormulaParser::call(Operation function, Token const& token) {
  std::string const name(token.text);
  if (!text_.is_sign("(")) unexpected("'(' behind the function " + name);
  Token const open = text_.take();
  Deeper const deeper(*this, open.position);
  Entry result = value();
  if (of_one_argument(function)) {
    if (text_.is_sign(",")) unexpected("')', for " + name + " is a function of one number");
    close(open);
    return finite(token.position, record(function, result, result));
  }
  bool const of_any_number = !is_smooth(function);
  if (!of_any_number && !text_.is_sign(",")) unexpected("',' before the second number of " + name);
  for (bool more = true; more && text_.take_sign(","); more = of_any_number)
    result = finite(token.position, record(function, result, value()));
  close(open);
  return result;
}

FormulaParser::Entry FormulaParser::finite(std::size_t at, Entry e) const {
  if (!builder_.is_constant(e) || std::isfinite(builder_.value(e))) return e;
  fail(at, std::isnan(builder_.value(e))
               ? "this constant does not exist: a function is taken outside of its domain"
               : "this constant is infinite, or larger than a double");
}

FormulaParser::Deeper::Deeper(FormulaParser& parser, std::size_t at) : depth(parser.depth_) {
  if (int const most = parser.use_.deepest; depth >= most)
    fail(at, "at most " + std::to_string(most) + " brackets, powers and cases may be open");
  ++depth;
}

}  // namespace detail

}  // namespace actio
