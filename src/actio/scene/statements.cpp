#include "actio/scene/statements.hpp"

#include <set>

#include "actio/scene/embedded.hpp"

namespace actio::scene {
namespace {

std::vector<std::string> pieces(std::string_view text, char at) {
  std::vector<std::string> out(1);
  for (char const c : text)
    if (c == at) out.emplace_back();
    else out.back() += c;
  return out;
}

std::vector<Statement> parse_registry() {
  auto const names = pieces(embedded::checked_statements, '\n');
  std::set<std::string> const checked(names.begin(), names.end());
  std::vector<Statement> out;
  for (auto const& line : pieces(embedded::registry_tsv, '\n')) {
    auto const cells = pieces(line, '\t');  // id, kind, chapter, section, subject
    if (cells.size() < 5 || line.starts_with('#') || cells[0] == "id") continue;
    out.push_back({cells[0], cells[1], cells[2], cells[4], checked.count(cells[0]) > 0});
  }
  return out;
}

}  // namespace

std::vector<Statement> const& statements() {
  static std::vector<Statement> const all = parse_registry();
  return all;
}

Statement const* find_statement(std::string_view id) {
  for (auto const& statement : statements())
    if (statement.id == id) return &statement;
  return nullptr;
}

}  // namespace actio::scene
