#include "program/registry/keys.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "actio/numbers/nearest_name.hpp"
#include "program/base/printable.hpp"
#include "program/registry/common_keys.hpp"

namespace actio::scene {
namespace {

/// The sections, in the order of a scene.
std::vector<std::string> const sections{"scene", "system", "initial", "method", "run", "output"};

std::string section_of(std::string const& key) { return key.substr(0, key.find('.')); }
std::string table_of(std::string const& key) { return key.substr(0, key.rfind('.')); }
std::string name_of(std::string const& key) { return key.substr(key.rfind('.') + 1); }

bool is_same(Parameter const& a, Parameter const& b) {
  return a.key == b.key && a.expects == b.expects && a.fallback == b.fallback && a.meaning == b.meaning &&
         a.unit == b.unit && a.allowed == b.allowed;
}

bool is_one_of(std::string const& word, std::vector<std::string> const& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// `two_bodies, heavy_top and rigid_body_n`: those among whose names the word is.
template <class Names>
std::string systems_with(std::string const& word, Names names) {
  std::vector<std::string> found;
  for (auto const& system : systems())
    if (is_one_of(word, names(system))) found.push_back(system.name);
  std::string out;
  for (std::size_t k = 0; k < found.size(); ++k)
    out += (k == 0 ? "" : k + 1 < found.size() ? ", " : " and ") + found[k];
  return out;
}

/// What there is to say of a key that the table of this system does not have: which system has it; nothing
/// where none has.
std::string of_others(System const& system, std::string const& table, std::string const& key) {
  auto const names = [&table](System const& other) { return keys_in(keys_of(other), table); };
  std::string const others = systems_with(key, names);
  return others.empty() ? ""
                        : fmt::format("; it is a key of {}, and {} takes {}", others, system.name,
                                      listed(names(system)));
}

/// `kind` of system.kind: the text, not what a number or a list would be refused with.
template <class Names>
void refuse_of_others(Place const& place, std::string const& word, std::string const& what,
                      System const& system, Names names) {
  if (is_one_of(word, names(system))) return;
  std::string const others = systems_with(word, names);
  if (!others.empty())
    throw SceneError(place, fmt::format("unknown {0} '{1}': it is a {0} of {2}, and {3} has {4}", what,
                                        shown(word), others, system.name, listed(names(system))));
}

/// Whether nothing stands in the way of reading a table: `scene.units` has no value that is none.
bool is_absent_or_table(SceneFile const& file, std::string const& table) {
  if (table.find('.') == std::string::npos) return true;
  std::string const parent = table_of(table), name = name_of(table);
  if (!is_absent_or_table(file, parent)) return false;
  SceneTable const above = file.section(parent);
  return !above.has(name) || above.is_table(name);
}

/// That a key which is always a table is one; where it is not, its example is told.
void require_table(SceneFile const& file, Parameter const& key) {
  std::string const name = name_of(key.key);
  SceneTable const table = file.section(table_of(key.key));
  // One without an example has a reader that tells one.
  if (!key.expects.starts_with("a table") || key.example == "{}" || !table.has(name) || table.is_table(name))
    return;
  table.fail(name, fmt::format("{0}: a table is expected, for example {0} = {1}, found {2}", name,
                               key.example, table.found(name)));
}

}  // namespace

std::vector<Parameter> keys_of(System const& system) {
  std::vector<Parameter> all = common_keys(system);
  for (auto const& own : system.parameters) {
    auto const there =
        std::find_if(all.begin(), all.end(), [&own](Parameter const& key) { return key.key == own.key; });
    if (there == all.end())
      all.push_back(own);
    else
      *there = own;
  }
  auto const rank = [](Parameter const& key) {
    return std::find(sections.begin(), sections.end(), section_of(key.key)) - sections.begin();
  };
  std::stable_sort(all.begin(), all.end(),
                   [&rank](Parameter const& a, Parameter const& b) { return rank(a) < rank(b); });
  return all;
}

std::vector<std::string> keys_in(std::vector<Parameter> const& keys, std::string const& table) {
  std::vector<std::string> out;
  for (auto const& key : keys)
    if (table_of(key.key) == table) out.push_back(name_of(key.key));
  return out;
}

std::vector<std::string> tables_of(std::vector<Parameter> const& keys) {
  std::vector<std::string> out;
  for (auto const& key : keys)
    if (std::string const table = table_of(key.key); std::find(out.begin(), out.end(), table) == out.end())
      out.push_back(table);
  return out;
}

std::vector<KeyOfSystems> all_keys() {
  std::vector<KeyOfSystems> out;
  for (auto const& system : systems())
    for (auto const& key : keys_of(system)) {
      auto const there = std::find_if(out.begin(), out.end(), [&key](KeyOfSystems const& known) {
        return is_same(known.parameter, key);
      });
      if (there != out.end())
        there->of.push_back(&system);
      else
        out.push_back({key, {&system}});
    }
  // Those of one name stand together, sections in the order of a scene.
  std::vector<std::string> names;
  for (auto const& section : sections)
    for (auto const& known : out)
      if (section_of(known.parameter.key) == section &&
          std::find(names.begin(), names.end(), known.parameter.key) == names.end())
        names.push_back(known.parameter.key);
  auto const rank = [&names](KeyOfSystems const& known) {
    return std::find(names.begin(), names.end(), known.parameter.key) - names.begin();
  };
  std::stable_sort(out.begin(), out.end(),
                   [&rank](auto const& a, auto const& b) { return rank(a) < rank(b); });
  return out;
}

void allow_keys(SceneFile const& file, System const& system) {
  auto const keys = keys_of(system);
  auto const tables = tables_of(keys);
  for (auto const& key : keys) require_table(file, key);
  for (auto const& table : tables) {
    // One that may be a table is judged by its reader where it is none: initial.attitude, a list of numbers.
    if (!is_absent_or_table(file, table)) continue;
    // The key that leads to a table within is allowed by its own record.
    file.section(table).allow(keys_in(keys, table),
                              [&](std::string const& key) { return of_others(system, table, key); });
  }
}

void refuse_words_of_other_systems(SceneFile const& file, System const& system) {
  SceneTable const method = file.section("method"), output = file.section("output");
  if (method.is_text("name"))
    refuse_of_others(method.place("name"), method.text("name"), "method", system,
                     [](System const& other) { return names_of(other.methods); });
  if (!output.has("quantities")) return;
  auto const quantities = output.texts("quantities");
  for (std::size_t i = 0; i < quantities.size(); ++i)
    refuse_of_others(output.place("quantities", i), quantities[i], "quantity", system,
                     [](System const& other) { return names_of(other.quantities); });
}

}  // namespace actio::scene
