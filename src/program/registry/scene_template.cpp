#include "program/registry/scene_template.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "actio/numbers/nearest_name.hpp"
#include "program/registry/keys.hpp"

namespace actio::scene {
namespace {

using Values =
    std::map<std::string, std::string>;  // of a scene, as they are written, by their keys with sections

/// The values of an example, which has a line for each.
Values values_in(std::string const& example) {
  Values out;
  std::istringstream lines(example);
  std::string section;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('['))
      section = line.substr(1, line.find(']') - 1);
    else if (std::size_t const equals = line.find(" = "); equals != std::string::npos)
      out[section + "." + line.substr(0, equals)] = line.substr(equals + 3);
  }
  return out;
}

/// The nearest of 1, 2, 5, 10, ... that is not less.
double round_up(double x) {
  int const power = static_cast<int>(std::floor(std::log10(x)));
  for (int const digit : {1, 2, 5, 10})
    if (double const round = std::stod(fmt::format("{}e{}", digit, power)); round >= x * (1 - 1e-12))
      return round;
  return x;
}

void let_go(Values& values, Body const& body) {
  values.erase("system.inertia");
  values["system.body"] = "\"" + body.name + "\"";
  values["initial.angular_velocity"] = fmt::format("[{}, {}, {}]", body.spin.coordinates[0],
                                                   body.spin.coordinates[1], body.spin.coordinates[2]);
  double const until = round_up(6 * 2 * M_PI / body.spin.coordinates.norm());
  values["run.until"] = fmt::format("{}", until);
  values["run.every"] = fmt::format("{}", round_up(until / 500));
  values["scene.title"] = "\"" + body.title + "\"";
}

/// Comment lines.
std::string comment(std::string const& text) {
  constexpr std::size_t width = 100;
  std::string out, line = "#";
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (line.size() + 1 + word.size() > width) out += line + "\n", line = "#";
    line += " " + word;
  }
  return out + line + "\n";
}

/// What a key may hold, its unit, and what stands where it is left out.
std::string held(Parameter const& key, Body const* body) {
  std::string out = "[" + key.expects;
  if (!key.allowed.empty()) out += ": " + listed(key.allowed);
  if (!key.unit.empty()) out += "; unit " + (body && key.unit == "time" ? body->time : key.unit);
  if (key.fallback.starts_with("or "))
    out += "; " + key.fallback;
  else if (!key.fallback.starts_with("needed"))
    out += "; where left out: " + key.fallback;
  return out + "]";
}

}  // namespace

std::string scene_template(System const& system, Body const* body) {
  auto const keys = keys_of(system);
  Values values = values_in(system.example);
  values.emplace("scene.title", "\"" + system.title + "\"");
  if (body) {
    auto const names = keys_in(keys, "system");
    if (std::find(names.begin(), names.end(), "body") == names.end())
      throw SceneError({"actio new"}, system.name + " takes no body of the library");
    let_go(values, *body);
  }
  std::string out = comment(system.meaning +
                            " Keys that are not needed are comments: without their # they count."),
              section;
  for (auto const& key : keys) {
    std::size_t const dot = key.key.find('.');
    if (key.key.find('.', dot + 1) != std::string::npos)
      continue;  // of a table within, told with the key that holds it
    out += "\n";
    if (key.key.substr(0, dot) != section) section = key.key.substr(0, dot), out += "[" + section + "]\n";
    auto const value = values.find(key.key);
    std::string const name = key.key.substr(dot + 1);
    out += comment(key.meaning) + comment(held(key, body)) +
           (value != values.end() ? name + " = " + value->second : "# " + name + " = " + key.example) + "\n";
  }
  return out;
}

}  // namespace actio::scene
