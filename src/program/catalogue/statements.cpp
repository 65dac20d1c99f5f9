#include "program/catalogue/statements.hpp"

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>

#include "program/base/embedded.hpp"

namespace actio::scene {
namespace {

std::vector<std::string> pieces(std::string_view text, char at) {
  std::vector<std::string> out(1);
  for (char const c : text)
    if (c == at)
      out.emplace_back();
    else
      out.back() += c;
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

std::string name_in_thesis(Statement const& statement) {
  std::size_t const at = statement.id.find('_');
  std::string number = statement.id.substr(at + 1);
  if (at == std::string::npos || number.find_first_not_of("0123456789_") != std::string::npos)
    return statement.id;
  std::replace(number.begin(), number.end(), '_', '.');
  std::string kind = statement.kind;
  kind[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(kind[0])));
  return statement.kind == "equation" ? "(" + number + ")" : kind + " " + number;
}

std::vector<Statement const*> find_statements(std::string_view name) {
  if (Statement const* const exact = find_statement(name)) return {exact};
  constexpr std::size_t longest =
      64;  // no name is longer, and the expression below needs some stack for each letter
  if (name.size() > longest) return {};
  std::string text(name);
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  static std::regex const form(R"(\s*([a-z]*)\.?\s*\(?\s*(\d+(?:\.\d+)+)\s*\)?\s*)");
  std::smatch match;
  if (!std::regex_match(text, match, form)) return {};
  std::string number = "_" + match[2].str();
  std::replace(number.begin(), number.end(), '.', '_');
  std::string const word = match[1];
  std::vector<Statement const*> out;
  for (auto const& statement : statements()) {
    std::string const prefix = statement.id.substr(0, statement.id.find('_'));
    // "theorem", "theorems", "thm", "eqs": what the kind, or the beginning of the id, begins or is.
    bool const meant = word.empty() || word == prefix || word == prefix + "s" ||
                       (word.size() >= 3 && (statement.kind + "s").starts_with(word));
    if (meant && statement.id == prefix + number) out.push_back(&statement);
  }
  return out;
}

}  // namespace actio::scene
