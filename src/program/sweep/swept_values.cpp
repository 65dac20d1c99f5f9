#include "program/sweep/swept_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "program/base/byte_order_mark.hpp"
#include "program/document/file.hpp"

namespace actio::scene {
namespace {

std::string trimmed(std::string_view text) {
  auto const first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : std::string(text.substr(first, last - first + 1));
}

/// A number as it was written.
struct Written {
  double value = 0;
  long digits = 0;     // behind the point
  bool whole = false;  // neither point nor exponent
};

std::optional<Written> read_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Written out;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), out.value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(out.value)) return {};
  std::size_t const point = text.find('.'), exponent = std::min(text.find_first_of("eE"), text.size());
  out.whole = point == std::string_view::npos && exponent == text.size();
  if (point != std::string_view::npos) out.digits = static_cast<long>(exponent - point) - 1;
  long power = 0;
  if (exponent < text.size()) {
    std::size_t const begin = exponent + 1 + (text.substr(exponent + 1).starts_with('+') ? 1 : 0);
    std::from_chars(text.data() + begin, text.data() + text.size(), power);
  }
  out.digits = std::clamp(out.digits - power, 0L, 400L);
  return out;
}

/// A number in TOML, one with a point where it is not to be whole.
std::string in_toml(double x) {
  std::string const text = fmt::format("{}", x);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

/// Without the last digits, in which formulas show their rounding: 0.01, and not 0.009999999999999998.
double tidy(double x) { return std::stod(fmt::format("{:.15g}", x)); }

/// `0.1:0.5:0.1`; nothing where the text is no range.
std::optional<std::vector<std::string>> range(std::string const& text, Place const& place) {
  std::size_t const first = text.find(':'), second = text.find(':', first + 1);
  if (first == std::string::npos || second == std::string::npos ||
      text.find_first_of("\"'[{") != std::string::npos)
    return {};
  auto const start = read_number(trimmed(text.substr(0, first))),
             stop = read_number(trimmed(text.substr(first + 1, second - first - 1))),
             step = read_number(trimmed(text.substr(second + 1)));
  if (!start || !stop || !step)
    throw SceneError(
        place,
        fmt::format("'{}': START:STOP:STEP is expected, three numbers, for example 0.1:0.5:0.1", text));
  double const steps = (stop->value - start->value) / step->value;
  if (step->value == 0 || steps < 0)
    throw SceneError(place, fmt::format("'{}': steps of {} do not lead from {} to {}", text, step->value,
                                        start->value, stop->value));
  if (steps >= static_cast<double>(most_members))
    throw SceneError(place, fmt::format("'{}': a key has at most {} values, this one {:.0f}", text,
                                        most_members, std::round(steps) + 1));
  // The end is met within the rounding of the division.
  long const last = static_cast<long>(std::floor(steps + 1e-9 * std::max(1.0, steps)));
  int const digits = static_cast<int>(std::max(start->digits, step->digits));
  std::vector<std::string> out;
  for (long k = 0; k <= last; ++k) {
    long double const x = static_cast<long double>(start->value) +
                          static_cast<long double>(k) * static_cast<long double>(step->value);
    // With the digits that were written: 0.3, and not 0.30000000000000004.
    std::string const value = fmt::format("{:.{}f}", x, digits);
    out.push_back(start->whole && step->whole ? value : in_toml(std::stod(value)));
  }
  return out;
}

/// How values lie between two.
struct Spacing {
  std::string name;
  bool by_ratios;     ///< equal ratios, not differences
  bool of_exponents;  ///< of ten
};
std::vector<Spacing> const spacings{
    {"linspace", false, false}, {"geomspace", true, false}, {"logspace", false, true}};

/// `linspace(0, 1, 11)`; nothing where the text is no such list.
std::optional<std::vector<std::string>> spaced(std::string const& text, Place const& place) {
  std::size_t const open = text.find('(');
  std::string const name = text.substr(0, open);
  auto const spacing = std::ranges::find(spacings, name, &Spacing::name);
  if (open == std::string::npos || spacing == spacings.end()) return {};
  std::vector<std::optional<Written>> numbers;
  if (text.ends_with(')'))
    for (auto const& part : split_values(std::string_view(text).substr(open + 1, text.size() - open - 2)))
      numbers.push_back(read_number(trimmed(part)));
  bool const three = numbers.size() == 3 && numbers[0] && numbers[1] && numbers[2] && numbers[2]->whole;
  if (!three)
    throw SceneError(
        place,
        fmt::format("'{0}': {1}(FIRST, LAST, HOW_MANY) is expected, for example {1}(1, 2, 11)", text, name));
  double const a = numbers[0]->value, b = numbers[1]->value, count = numbers[2]->value;
  if (!(count >= 1) || count > static_cast<double>(most_members))
    throw SceneError(
        place, fmt::format("'{}': from 1 to {} values are allowed, found {}", text, most_members, count));
  if (spacing->by_ratios && !(a * b > 0))
    throw SceneError(place,
                     fmt::format("'{}': equal ratios need two numbers of one sign, neither of them 0", text));
  std::vector<std::string> out;
  for (long k = 0; k < static_cast<long>(count); ++k) {
    double const part = count > 1 ? static_cast<double>(k) / (count - 1) : 0;
    double x = k == 0      ? a
               : part == 1 ? b
                           : tidy(spacing->by_ratios ? a * std::pow(b / a, part) : a + (b - a) * part);
    if (spacing->of_exponents) x = tidy(std::pow(10, x));
    if (!std::isfinite(x))
      throw SceneError(place,
                       fmt::format("'{}': value {} is {}, where a finite number is needed", text, k + 1, x));
    out.push_back(in_toml(x));
  }
  return out;
}

/// The values in a file: one a line, or several with commas; empty lines and those that begin with # aside.
std::string read_values(std::string const& path, Place const& place) {
  std::error_code none;
  if (!std::filesystem::exists(path, none))
    throw SceneError(place, "there is no file '" + shown(path, 200) + "' to read values from");
  std::ifstream in(path, std::ios::binary);
  skip_byte_order_mark(in);
  std::string out;
  for (std::string line; std::getline(in, line);) {
    line = trimmed(line);
    if (line.ends_with(',')) line.pop_back();
    if (!line.empty() && line[0] != '#') out += (out.empty() ? "" : ",") + line;
    if (out.size() > std::size_t{1} << 28)
      throw SceneError(place, "the file '" + shown(path, 200) + "' is too long for a list of values");
  }
  if (!in.eof()) throw FileError(path + ": cannot be read");
  if (out.empty()) throw SceneError(place, "there is no value in the file '" + shown(path, 200) + "'");
  return out;
}

}  // namespace

SweptKey read_swept_key(std::string const& argument, Place const& place) {
  std::size_t const equals = argument.find('=');
  SweptKey out{trimmed(argument.substr(0, equals)), {}};
  if (equals == std::string::npos || out.key.empty())
    throw SceneError(place, "KEY=a,b,c is expected, for example method.step=0.1,0.2");
  std::string list = trimmed(std::string_view(argument).substr(equals + 1));
  if (list.starts_with('@')) list = read_values(trimmed(std::string_view(list).substr(1)), place);
  for (auto const& piece : split_values(list)) {
    std::string value = trimmed(piece);
    if (value.empty())
      throw SceneError(place, fmt::format("value {} of '{}' is empty", out.values.size() + 1, out.key));
    auto many = range(value, place);
    if (!many) many = spaced(value, place);
    if (many)
      out.values.insert(out.values.end(), many->begin(), many->end());
    else
      out.values.push_back(std::move(value));
    if (out.values.size() > static_cast<std::size_t>(most_members))
      throw SceneError(
          place, fmt::format("a sweep has at most {} members, and '{}' more values", most_members, out.key));
  }
  return out;
}

std::string plain_key(std::string const& key) {
  std::string out;
  std::copy_if(key.begin(), key.end(), std::back_inserter(out),
               [](char c) { return c != ' ' && c != '\t' && c != '"' && c != '\''; });
  return out;
}
bool overlap(std::string const& a, std::string const& b) {
  std::string const one = plain_key(a), other = plain_key(b);
  auto const part = [](std::string const& whole, std::string const& key) {
    return key.starts_with(whole) &&
           (key.size() == whole.size() || key[whole.size()] == '.' || key[whole.size()] == '[');
  };
  return part(one, other) || part(other, one);
}

}  // namespace actio::scene
