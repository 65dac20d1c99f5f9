// actio show: all that is known of a name. A name that several things have, or several systems, is told for each.
#include <fmt/format.h>

#include <algorithm>

#include "actio/scene/bodies.hpp"
#include "actio/scene/groups.hpp"
#include "actio/scene/nearest_name.hpp"
#include "actio/scene/printable.hpp"
#include "actio/scene/statements.hpp"
#include "app/catalogue.hpp"
#include "app/commands.hpp"
#include "app/text.hpp"

namespace actio::app {

using namespace scene;

namespace {

constexpr std::size_t width = 100;

/// One thing: a heading, then what is told of it by name.
class Account {
 public:
  Account(std::string const& name, std::string const& what) : out_(heading(name) + ", " + what + "\n") {}
  /// A line `name  text`; none where there is no text.
  void tell(std::string const& name, std::string const& text) {
    if (!text.empty()) out_ += fmt::format("  {:<{}}{}\n", name, label, wrapped(text, width, label + 2));
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

std::string about(LibraryBody const& body) {
  Account account(body.name, "a body: " + body.title);
  account.tell("moments", in_toml(body.inertia.moments) + (body.unit == "ratio" ? ", of which only the ratios are known" : " " + body.unit));
  if (!body.axes.isIdentity(0)) {
    account.tell("axes", "of these moments, in the frame of the catalogue, which is that of a scene with this body:");
    for (int k = 0; k < 3; ++k) account.tell("", in_toml(body.axes.col(k)));
  }
  account.tell("unit of time", body.time);
  account.tell("spin", in_toml(body.spin) + " rad/" + body.time);
  account.tell("source", body.source);
  account.tell("derived", body.derived);
  account.scene(fmt::format("[system]\nkind = \"rigid_body\"\nbody = \"{}\"\n[initial]\nangular_velocity = {}   # rad/{}\n", body.name, in_toml(body.spin), body.time));
  return account.text();
}

std::string orders_of(Method const& method) { return "order " + listed(method.orders); }

std::string about(System const& system) {
  Account account(system.name, "a system: " + system.title);
  account.tell("meaning", system.meaning);
  account.tell("statement", statement_in_words(system.statement));
  std::vector<std::vector<std::string>> parameters, methods, quantities;
  for (auto const& p : system.parameters) {
    bool const as_it_is = p.fallback.empty() || p.fallback == "needed" || p.fallback.starts_with("or ");
    std::string const fallback = (as_it_is ? "" : "otherwise ") + p.fallback;
    parameters.push_back({p.key, p.expects, fallback, p.meaning});
  }
  for (auto const& m : system.methods) methods.push_back({m.name, orders_of(m), m.meaning});
  for (auto const& q : system.quantities) quantities.push_back({q.name, q.unit, q.meaning});
  account.table("parameters", parameters);
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
    case Kind::matrix: return fmt::format("{0}_11 {0}_12 ... row by row", quantity.name);
    case Kind::skew: return fmt::format("{0}_12 {0}_13 ... {0}_23 ..., the upper triangle row by row", quantity.name);
    case Kind::list: return fmt::format("{}_k for each of its numbers k", quantity.name);
    default: break;
  }
  std::string out;
  for (auto const& end : column_ends(quantity.kind)) out += (out.empty() ? "" : " ") + quantity.name + end;
  return out;
}

std::string about(QuantityOf const& entry) {
  Quantity const& q = *entry.quantity;
  Account account(q.name, "a quantity of " + entry.system->name);
  account.tell("meaning", q.meaning);
  account.tell("formula", plain_formula(q.formula));
  account.tell("unit", q.unit);
  account.tell("columns", columns_of(q));
  account.tell("needs", q.needs.empty() ? "the state alone" : listed(q.needs));
  account.tell("conserved", q.conserved ? "yes: the motion keeps it, and its drift is in summary.json" : "no");
  account.tell("statement", statement_in_words(q.statement));
  return account.text();
}

std::string about(LibraryGroup const& group) {
  Account account(group.name, "a group");
  account.tell("meaning", group.meaning);
  account.tell("dimension", group.dimension);
  account.tell("coordinates", group.coordinates);
  account.tell("type", group.type);
  account.tell("header", group.header);
  account.tell("statement", statement_in_words(group.statement));
  return account.text();
}

std::string about(Statement const& statement) {
  Account account(statement.id, "a statement of the thesis");
  account.tell("subject", statement.subject);
  account.tell("kind", statement.kind);
  account.tell("chapter", statement.chapter);
  account.tell("check", statement.checked ? "actio check " + statement.id : "none yet");
  return account.text();
}

}  // namespace

int show(std::string const& name) {
  std::vector<std::string> accounts;
  if (auto const* const body = find_body(name)) accounts.push_back(about(*body));
  if (auto const* const system = find_system(name)) accounts.push_back(about(*system));
  for (auto const& entry : all_methods())
    if (entry.method->name == name) accounts.push_back(about(entry));
  for (auto const& entry : all_quantities())
    if (entry.quantity->name == name) accounts.push_back(about(entry));
  if (accounts.empty())
    for (auto const* const group : find_groups(name)) accounts.push_back(about(*group));
  if (auto const* const statement = find_statement(name)) accounts.push_back(about(*statement));
  if (accounts.empty()) throw SceneError({"actio show"}, fmt::format("unknown name '{}'{} (actio list systems|groups|methods|quantities|bodies|materials)", shown(name), did_you_mean(name, all_names())));
  for (std::size_t i = 0; i < accounts.size(); ++i) fmt::print("{}{}", i ? "\n" : "", accounts[i]);
  return 0;
}

}  // namespace actio::app
