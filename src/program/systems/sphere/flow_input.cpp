#include "program/systems/sphere/flow_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

#include "actio/numbers/nearest_name.hpp"
#include "program/base/byte_order_mark.hpp"

namespace actio::scene {
namespace {

/// Four numbers with commas between them.
bool parse_row(std::string_view line, double (&row)[4]) {
  for (int k = 0; k < 4; ++k) {
    while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
    auto const [end, error] = std::from_chars(line.data(), line.data() + line.size(), row[k]);
    if (error != std::errc() || !std::isfinite(row[k])) return false;
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
    if (k == 3) return line.empty();
    if (line.empty() || line.front() != ',') return false;
    line.remove_prefix(1);
  }
  return false;
}

/// The state that a scene names, by `state` or by the table of its parameters; empty where it names none.
std::string state_of(SceneTable& initial, std::vector<std::string> const& names,
                     Key<std::string> const& state) {
  std::vector<std::string> tables;
  for (auto const& key : initial.keys())
    if (std::ranges::count(names, key) > 0) tables.push_back(key);
  if (tables.size() > 1)
    initial.fail(tables[1], fmt::format("[initial] has '{}' and '{}'; one of them says how the flow begins",
                                        tables[0], tables[1]));
  if (!initial.has("state")) return tables.empty() ? "" : tables[0];
  std::string const name = state.read(initial);
  if (!tables.empty() && tables[0] != name)
    initial.fail(tables[0], fmt::format("[initial.{}] holds parameters of another state than state = \"{}\"",
                                        tables[0], name));
  return name;
}

}  // namespace

FlowSource read_flow_source(SceneTable& initial, std::string const& other, std::string const& in_words,
                            std::vector<std::string> const& names, Key<std::string> const& state) {
  std::string const named = state_of(initial, names, state);
  std::vector<std::string> given;
  for (auto const& key : {other, std::string("file")})
    if (initial.has(key)) given.push_back(key);
  if (!named.empty()) given.push_back(initial.has("state") ? "state" : named);
  if (given.empty())
    throw SceneError(initial.place(),
                     fmt::format("[initial] needs {}; or 'state', one of {}", in_words, listed(names)));
  if (given.size() > 1)
    initial.fail(given[1], fmt::format("[initial] has '{}' and '{}'; one of them says how the flow begins",
                                       given[0], given[1]));
  return {given[0], named};
}

int read_coefficients(std::string const& text, std::string const& path, std::string const& heading,
                      std::function<std::string(double const (&row)[4], int line)> const& take) {
  std::istringstream in(text);
  skip_byte_order_mark(in);
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    Place const here{path, static_cast<unsigned>(number), 1};
    if (number == 1) {
      if (line != heading)
        throw SceneError(here,
                         fmt::format("the heading {} is expected, found '{}'", heading, shown(line, 40)));
      continue;
    }
    if (line.empty() && in.peek() == std::istringstream::traits_type::eof()) break;
    double row[4];
    if (!parse_row(line, row))
      throw SceneError(here,
                       fmt::format("four numbers {} are expected, found '{}'", heading, shown(line, 60)));
    if (std::string const wrong = take(row, number); !wrong.empty()) throw SceneError(here, wrong);
  }
  if (number == 0)
    throw SceneError({path}, fmt::format("the heading {} is expected, the file is empty", heading));
  return number;
}

std::string text_of_file(std::string const& path) {
  std::ifstream in(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open() || in.bad()) throw FileError(path + ": cannot be read");
  return text;
}

}  // namespace actio::scene
