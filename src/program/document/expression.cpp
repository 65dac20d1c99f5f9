#include "program/document/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

#include "actio/formula/formula_names.hpp"
#include "actio/numbers/nearest_name.hpp"

namespace actio::scene {
namespace {

constexpr std::size_t longest = 2000;
constexpr int deepest = 50;

struct OneArgument {
  char const* name;
  double (*function)(double);
};
struct TwoArguments {
  char const* name;
  double (*function)(double, double);
};

double sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }
double least(double const* x, int n) { return *std::min_element(x, x + n); }
double most(double const* x, int n) { return *std::max_element(x, x + n); }

constexpr OneArgument one_argument[] = {
    {"sin", [](double x) { return std::sin(x); }},     {"cos", [](double x) { return std::cos(x); }},
    {"tan", [](double x) { return std::tan(x); }},     {"asin", [](double x) { return std::asin(x); }},
    {"acos", [](double x) { return std::acos(x); }},   {"atan", [](double x) { return std::atan(x); }},
    {"sinh", [](double x) { return std::sinh(x); }},   {"cosh", [](double x) { return std::cosh(x); }},
    {"tanh", [](double x) { return std::tanh(x); }},   {"asinh", [](double x) { return std::asinh(x); }},
    {"acosh", [](double x) { return std::acosh(x); }}, {"atanh", [](double x) { return std::atanh(x); }},
    {"exp", [](double x) { return std::exp(x); }},     {"log", [](double x) { return std::log(x); }},
    {"log2", [](double x) { return std::log2(x); }},   {"log10", [](double x) { return std::log10(x); }},
    {"sqrt", [](double x) { return std::sqrt(x); }},   {"cbrt", [](double x) { return std::cbrt(x); }},
    {"abs", [](double x) { return std::abs(x); }},     {"sign", sign},
    {"floor", [](double x) { return std::floor(x); }}, {"ceil", [](double x) { return std::ceil(x); }},
    {"round", [](double x) { return std::round(x); }},
};
constexpr TwoArguments two_arguments[] = {
    {"atan2", [](double y, double x) { return std::atan2(y, x); }},
    {"hypot", [](double x, double y) { return std::hypot(x, y); }},
};

std::vector<std::string> known_names(std::vector<std::string> const& variables) {
  std::vector<std::string> names = variables;
  names.emplace_back("pi");
  for (auto const& f : one_argument) names.emplace_back(f.name);
  for (auto const& f : two_arguments) names.emplace_back(f.name);
  names.emplace_back("min"), names.emplace_back("max");
  return names;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Walks through a formula once and refuses what is no part of one, at its place; how the parts fit together
/// is left to the parser.
class Inspection {
 public:
  Inspection(std::string const& text, std::vector<std::string> const& variables, TextPlace const& place)
      : text_(text), known_(known_names(variables)), place_(place) {}

  void run() {
    if (text_.find_first_not_of(' ') == std::string::npos)
      fail_at(0, "a formula is expected, for example \"1\"");
    if (text_.size() > longest)
      fail_at(longest,
              fmt::format("a formula has at most {} characters, this one has {}", longest, text_.size()));
    while (at_ < text_.size()) {
      char const c = text_[at_];
      if (is_digit(c) || c == '.')
        number();
      else if (is_letter(c))
        name();
      else
        sign();
    }
    if (!open_.empty()) fail_at(open_.back(), "this bracket is not closed");
  }

 private:
  char at(std::size_t i) const { return i < text_.size() ? text_[i] : '\0'; }

  void number() {
    double value = 0;
    char const* const begin = text_.data() + at_;
    auto const [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (end == begin) fail_at(at_, "a digit is expected beside '.'");
    std::string const digits(begin, end);
    if (error == std::errc::result_out_of_range)
      fail_at(at_, fmt::format("the number {} is too large or too small", shown(digits)));
    if (begin[0] == '.' || digits.back() == '.')
      fail_at(at_, fmt::format("a digit is expected on both sides of the point in {}", shown(digits)));
    std::size_t const behind = at_ + digits.size();
    if (is_letter(at(behind)) || is_digit(at(behind)) || at(behind) == '.')
      fail_at(behind, fmt::format("an operator is expected after {}", shown(digits)));
    at_ = behind;
  }

  void name() {
    std::size_t end = at_;
    while (is_letter(at(end)) || is_digit(at(end))) ++end;
    std::string const word = text_.substr(at_, end - at_);
    if (std::find(known_.begin(), known_.end(), word) == known_.end())
      fail_at(at_, fmt::format("unknown name '{}'{} (known: {})", shown(word),
                               actio::detail::meant_name(word, known_), listed(known_)));
    at_ = end;
  }

  void sign() {
    static constexpr std::array<std::string_view, 6> pairs{"==", "!=", "<=", ">=", "&&", "||"};
    std::string_view const rest = std::string_view(text_).substr(at_);
    auto const pair =
        std::find_if(pairs.begin(), pairs.end(), [&](std::string_view p) { return rest.starts_with(p); });
    char const c = text_[at_];
    if (pair == pairs.end() && std::string_view("+-*/^()<>,?: ").find(c) == std::string_view::npos) refuse();
    if (c == '(') open_.push_back(at_);
    if (open_.size() > deepest) fail_at(at_, fmt::format("at most {} brackets may be open", deepest));
    if (c == ')') {
      if (open_.empty()) fail_at(at_, "this bracket was not opened");
      open_.pop_back();
    }
    if (c == ',' && open_.empty())
      fail_at(at_, "one formula is expected; a comma stands between the arguments of a function");
    at_ += pair == pairs.end() ? 1 : 2;
  }
  [[noreturn]] void refuse() const {
    if (text_[at_] == '=') fail_at(at_, "nothing is assigned in a formula; 'is equal to' is ==");
    std::size_t end = at_ + 1;
    while ((at(end) & 0xC0) == 0x80) ++end;
    fail_at(at_, fmt::format("'{}' is no part of a formula", printable(text_.substr(at_, end - at_))));
  }

  [[noreturn]] void fail_at(std::size_t offset, std::string const& what) const {
    place_.fail(text_, offset, what);
  }

  std::string const& text_;
  std::vector<std::string> known_;
  TextPlace const& place_;
  std::size_t at_ = 0;
  std::vector<std::size_t> open_;
};

}  // namespace

/// The parser looks at the variables where they are.
struct Expression::Parser {
  mu::Parser mu;               ///< of the library
  std::vector<double> values;  ///< of the variables, in their order

  /// @throws mu::ParserError  where it is no formula
  Parser(std::string const& text, std::vector<std::string> const& variables) : values(variables.size(), 0.0) {
    mu.ClearConst(), mu.ClearFun();
    mu.DefineConst("pi", std::numbers::pi);
    for (auto const& f : one_argument) mu.DefineFun(f.name, f.function);
    for (auto const& f : two_arguments) mu.DefineFun(f.name, f.function);
    mu.DefineFun("min", least), mu.DefineFun("max", most);
    for (std::size_t i = 0; i < variables.size(); ++i) mu.DefineVar(variables[i], &values[i]);
    mu.SetExpr(text);
    mu.Eval();
  }
};

Expression::Expression(std::string text, std::vector<std::string> variables, TextPlace place)
    : text_(std::move(text)), variables_(std::move(variables)), place_(std::move(place)) {
  Inspection(text_, variables_, place_).run();
  try {
    parser_ = std::make_unique<Parser>(text_, variables_);
  } catch (mu::ParserError const& error) {
    auto const at = std::clamp<long>(error.GetPos(), 0, static_cast<long>(text_.size()));
    place_.fail(text_, static_cast<std::size_t>(at), "the formula does not fit together: " + error.GetMsg());
  }
}
Expression::Expression(Expression const& other) : Expression(other.text_, other.variables_, other.place_) {}
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression other) noexcept {
  std::swap(text_, other.text_), std::swap(variables_, other.variables_), std::swap(place_, other.place_),
      std::swap(parser_, other.parser_);
  return *this;
}
Expression::~Expression() = default;

double Expression::operator()(std::span<double const> point) {
  std::copy_n(point.begin(), parser_->values.size(), parser_->values.begin());
  double const value = parser_->mu.Eval();
  if (std::isfinite(value)) return value;
  std::string where;
  for (std::size_t i = 0; i < variables_.size(); ++i)
    where += fmt::format("{}{} = {}", i ? ", " : "", variables_[i], point[i]);
  place_.fail(text_, 0,
              fmt::format("a finite value is expected, found {}{}{}",
                          value != value ? std::abs(value) : value, where.empty() ? "" : " at ", where));
}

bool Expression::uses(std::string const& variable) const {
  auto const& used = parser_->mu.GetUsedVar();
  return used.find(variable) != used.end();
}

}  // namespace actio::scene
