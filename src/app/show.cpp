// actio show: all that is known of a name. A name that several things have, or several systems, is told for
// each.
#include <Eigen/Core>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>

#include "actio/numbers/nearest_name.hpp"
#include "app/catalogue.hpp"
#include "app/commands.hpp"
#include "app/ledger.hpp"
#include "app/statement_text.hpp"
#include "app/text.hpp"
#include "program/base/printable.hpp"
#include "program/catalogue/bodies.hpp"
#include "program/catalogue/groups.hpp"
#include "program/catalogue/materials.hpp"
#include "program/catalogue/statements.hpp"
#include "program/document/scenes.hpp"
#include "program/registry/conservation.hpp"
#include "program/registry/keys.hpp"
#include "program/registry/units.hpp"

namespace actio::app {

using namespace scene;

namespace {

constexpr std::size_t line_width = 100;

/// One thing: a heading, then what is told of it by name.
class Account {
 public:
  Account(std::string const& name, std::string const& what) : out_(heading(name) + ", " + what + "\n") {}
  /// A line `name  text`; none where there is no text.
  void tell(std::string const& name, std::string const& text) {
    if (!text.empty()) out_ += fmt::format("  {:<{}}{}\n", name, label, wrapped(text, line_width, label + 2));
  }
  void table(std::string const& title, std::vector<std::vector<std::string>> const& rows) {
    if (!rows.empty()) out_ += "  " + title + "\n" + aligned(rows, "    ");
  }
  /// Lines to paste into a scene.
  void scene(std::string const& text) { out_ += "\n" + text; }
  std::string const& text() const { return out_; }

 private:
  static constexpr std::size_t label = 14;
  std::string out_;
};

std::string in_toml(Eigen::Vector3d const& v) { return fmt::format("[{}, {}, {}]", v[0], v[1], v[2]); }

std::string about(Body const& body) {
  Account account(body.name, "a body: " + body.title);
  account.tell("moments",
               in_toml(body.principal.inertia.moments) +
                   (body.unit == "ratio" ? ", of which only the ratios are known" : " " + body.unit));
  if (!body.principal.axes.isIdentity(0)) {
    account.tell("axes",
                 "of these moments, in the frame of the catalogue, which is that of a scene with this body:");
    for (int k = 0; k < 3; ++k) account.tell("", in_toml(body.principal.axes.col(k)));
  }
  account.tell("unit of time", body.time);
  account.tell("spin", in_toml(body.spin.coordinates) + " rad/" + body.time);
  Units const units = units_of(body);
  account.tell("units", fmt::format("of a scene with this body: angular velocity {}, momentum {}, energy {}",
                                    units.in("1/time"), units.in("energy x time"), units.in("energy")));
  account.tell("source", body.source);
  account.tell("derived", body.derived);
  account.tell("new scene", fmt::format("actio new rigid_body --body {0} --out {0}.toml", body.name));
  if (find_scene(body.name))
    account.tell("its scene", fmt::format("actio run {}, which comes with actio", body.name));
  account.scene(fmt::format(
      "[system]\nkind = \"rigid_body\"\nbody = \"{}\"\n[initial]\nangular_velocity = {}   # rad/{}\n",
      body.name, in_toml(body.spin.coordinates), body.time));
  return account.text();
}

std::string orders_of(Method const& method) { return "order " + listed(method.orders); }

/// Whether a system tells of it; keys that every system has alike are listed elsewhere.
bool is_of_system(Parameter const& key) {
  return key.key.starts_with("system.") || key.key.starts_with("initial.") || key.key.starts_with("method.");
}

std::string where_left_out(Parameter const& key) {
  bool const as_it_is = key.fallback.starts_with("needed") || key.fallback.starts_with("or ");
  return (as_it_is ? "" : "otherwise ") + key.fallback;
}

std::string about(KeyOfSystems const& entry) {
  Parameter const& key = entry.parameter;
  std::vector<std::string> systems;
  for (auto const* const system : entry.of) systems.push_back(system->name);
  Account account(key.key, names_of(entry.of) == "all" ? "a key of every scene"
                                                       : "a key of scenes of " + listed(systems));
  account.tell("meaning", key.meaning);
  account.tell("expects", key.expects);
  account.tell("left out", key.fallback);
  account.tell("unit", key.unit);
  account.tell("allowed", listed(key.allowed));
  std::size_t const dot = key.key.rfind('.');
  account.tell("example",
               fmt::format("[{}] {} = {}", key.key.substr(0, dot), key.key.substr(dot + 1), key.example));
  return account.text();
}

/// The keys of a section: `show run`.
std::string about_section(std::string const& section) {
  Account account(section, "a section of a scene");
  std::vector<std::vector<std::string>> rows;
  for (auto const& entry : all_keys())
    if (entry.parameter.key.starts_with(section + "."))
      rows.push_back({entry.parameter.key, names_of(entry.of), entry.parameter.meaning});
  if (rows.empty()) return "";
  account.table("keys", rows);
  return account.text();
}

/// The keys of that name, or with that name at their end.
std::vector<std::string> about_keys(std::string const& name) {
  std::vector<std::string> accounts;
  for (auto const& entry : all_keys())
    if (entry.parameter.key == name || entry.parameter.key.ends_with("." + name))
      accounts.push_back(about(entry));
  return accounts;
}

bool has_word(std::string const& text, std::string const& word) {
  auto const letter = [&text](std::size_t at) {
    return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) || text[at] == '_');
  };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    if ((at == 0 || !letter(at - 1)) && !letter(at + word.size())) return true;
  return false;
}
/// The key of the table that holds an entry: system.mesh of system.mesh.cells. An entry that the record of
/// the table does not name is one of it where the entries have names of one's own.
std::vector<std::string> about_table_of(std::string const& name) {
  std::vector<std::string> accounts;
  std::size_t const section = name.find('.'), dot = name.find('.', section + 1);
  if (section == std::string::npos || dot == std::string::npos) return accounts;
  std::string const table = name.substr(0, dot),
                    entry = name.substr(dot + 1, name.find('.', dot + 1) - dot - 1);
  for (auto const& one : all_keys())
    if (one.parameter.key == table && one.parameter.expects.starts_with("a table") &&
        (has_word(one.parameter.expects, "by") || has_word(one.parameter.meaning, entry)))
      accounts.push_back(about(one));
  return accounts;
}

std::string about(NamedScene const& carried) {
  Account account(carried.name, "a scene that comes with actio: " + carried.title);
  account.tell("system", carried.system);
  account.tell("run", "actio run " + carried.name);
  account.tell("copy", fmt::format("actio new {0} --out {0}.toml", carried.name));
  return account.text();
}

std::string about(NamedMaterial const& material) {
  std::string const system = material.fluid ? "barotropic_fluid" : "elastic_body";
  Account account(material.name, "a material of " + system);
  account.tell("meaning", material.meaning);
  account.tell("formula", plain_formula(material.formula));
  std::vector<std::vector<std::string>> constants;
  std::string example;
  for (auto const& constant : material.constants) {
    constants.push_back({constant.name, constant.unit, constant.meaning});
    example += constant.name + " = " + constant.example + "\n";
  }
  account.table("constants", constants);
  account.scene("[system]\nkind = \"" + system + "\"\n[system.material]\nname = \"" + material.name + "\"\n" +
                example);
  return account.text();
}

std::string about(System const& system) {
  Account account(system.name, "a system: " + system.title);
  account.tell("meaning", system.meaning);
  account.tell("statement", statement_in_words(system.statement));
  std::vector<std::vector<std::string>> parameters, methods, quantities;
  for (auto const& key : keys_of(system))
    if (is_of_system(key))
      parameters.push_back({key.key, key.expects, where_left_out(key), key.unit, key.meaning});
  for (auto const& m : system.methods) methods.push_back({m.name, orders_of(m), m.meaning});
  for (auto const& q : system.quantities) quantities.push_back({q.name, q.unit, q.meaning});
  account.table("parameters", parameters);
  account.tell("",
               "Every scene also has run.*, output.* and scene.*: actio list keys, actio show run.every.");
  account.table("methods", methods);
  account.table("quantities", quantities);
  if (!system.example.empty()) account.scene(system.example);
  return account.text();
}

std::string about(MethodOf const& entry) {
  Account account(entry.method->name, "a method for " + entry.system->name);
  account.tell("meaning", entry.method->meaning);
  account.tell("orders", listed(entry.method->orders));
  account.tell("statement", statement_in_words(entry.method->statement));
  return account.text();
}

std::string columns_of(Quantity const& quantity) {
  using Kind = Quantity::Kind;
  switch (quantity.kind) {
    case Kind::matrix:
      return fmt::format("{0}_11 {0}_12 ... row by row", quantity.name);
    case Kind::skew:
      return fmt::format("{0}_12 {0}_13 ... {0}_23 ..., the upper triangle row by row", quantity.name);
    case Kind::list:
      return fmt::format("{}_k for each of its numbers k", quantity.name);
    default:
      break;
  }
  std::string out;
  for (auto const& end : column_ends(quantity.kind)) out += (out.empty() ? "" : " ") + quantity.name + end;
  return out;
}

/// Where the motion keeps a quantity, so that a run has its drift.
std::string where_conserved(QuantityOf const& entry) {
  auto const* const law = find_law(entry.system->name, entry.quantity->name);
  if (!law) return "no";
  std::string unless;
  for (auto const feature : law->unless)
    unless += (unless.empty() ? ", but not where " : "; or ") + std::string(in_words(feature));
  return "yes, and its drift is in summary.json" + unless;
}

std::string about(QuantityOf const& entry) {
  Quantity const& q = *entry.quantity;
  Account account(q.name, "a quantity of " + entry.system->name);
  account.tell("meaning", q.meaning);
  account.tell("formula", plain_formula(q.formula));
  account.tell("unit", q.unit);
  account.tell("columns", columns_of(q));
  account.tell("needs", q.needs.empty() ? "the state alone" : listed(q.needs));
  account.tell("conserved", where_conserved(entry));
  account.tell("statement", statement_in_words(q.statement));
  return account.text();
}

/// The components of a velocity and its matrix, where the group is named with its numbers.
void tell_velocity(Account& account, std::optional<NamedGroup> const& named) {
  if (!named) return;
  account.tell("components", fmt::format("of {}: {}", named->name, fmt::join(named->components, " ")));
  for (auto const& row : named->velocity)
    account.tell(&row == &named->velocity.front() ? "velocity" : "", row);
}

std::string about(LibraryGroup const& group, std::optional<NamedGroup> const& named) {
  Account account(group.name, "a group");
  account.tell("meaning", group.meaning);
  account.tell("dimension", group.dimension);
  account.tell("coordinates", group.coordinates);
  if (named)
    tell_velocity(account, named);
  else
    account.tell("components", components_of(group));
  account.tell("type", group.type);
  account.tell("header", group.header);
  account.tell("statement", statement_in_words(group.statement));
  return account.text();
}

/// A product of groups, which scenes can name.
std::string about_product(NamedGroup const& product) {
  Account account(product.name, "a group of scenes");
  account.tell("dimension", std::to_string(product.components.size()));
  tell_velocity(account, product);
  return account.text();
}

std::string about(Statement const& statement) {
  Account account(statement.id, "a statement of the thesis");
  account.tell("subject", statement.subject);
  StatementText const told = statement_text(statement.id);
  account.tell("in the book", told.title);
  for (auto const& paragraph : told.paragraphs)
    account.tell(&paragraph == &told.paragraphs.front() ? "text" : "", paragraph);
  account.tell("kind", name_in_thesis(statement) == statement.id
                           ? statement.kind
                           : statement.kind + ", " + name_in_thesis(statement));
  account.tell("chapter", statement.chapter);
  auto const verdict = verdict_of(statement.id);
  account.tell("check", statement.checked
                            ? "actio check " + statement.id + (verdict ? "" : " finds its verdict")
                            : "none yet");
  if (verdict) account.tell("verdict", verdict->word);
  account.tell("book", page_of(statement));
  return account.text() +
         (verdict ? verdict_in_words(verdict->printed, verdict->corrected, verdict->note, verdict->left)
                  : "");
}

}  // namespace

int show(std::string const& name) {
  std::vector<std::string> accounts;
  if (auto const* const body = find_body(name)) accounts.push_back(about(*body));
  if (auto const* const material = find_material(name)) accounts.push_back(about(*material));
  if (auto const* const system = find_system(name)) accounts.push_back(about(*system));
  for (auto const& entry : all_methods())
    if (entry.method->name == name) accounts.push_back(about(entry));
  for (auto const& entry : all_quantities())
    if (entry.quantity->name == name) accounts.push_back(about(entry));
  if (accounts.empty())
    for (auto const* const group : find_groups(name)) accounts.push_back(about(*group, named_group(name)));
  if (accounts.empty())
    if (auto const product = named_group(name)) accounts.push_back(about_product(*product));
  for (auto& account : about_keys(name)) accounts.push_back(std::move(account));
  if (auto const* const carried = find_scene(name); carried && !find_body(name))
    accounts.push_back(about(*carried));
  if (accounts.empty())
    if (auto account = about_section(name); !account.empty()) accounts.push_back(std::move(account));
  if (accounts.empty()) accounts = about_table_of(name);
  for (auto const* const statement : find_statements(name)) accounts.push_back(about(*statement));
  if (accounts.empty())
    throw SceneError(
        {"actio show"},
        fmt::format(
            "unknown name '{}'{} (actio list systems|groups|methods|quantities|bodies|materials|keys|scenes)",
            shown(name), did_you_mean(name, all_names())));
  for (std::size_t i = 0; i < accounts.size(); ++i) fmt::print("{}{}", i ? "\n" : "", accounts[i]);
  return 0;
}

}  // namespace actio::app
