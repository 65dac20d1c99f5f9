#include "app/ledger.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/child.hpp"
#include "app/text.hpp"

namespace actio::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t ledger_width = 100;

std::string ledger_line(std::string const& label, std::string const& text) {
  constexpr std::size_t column = 16;
  return text.empty() ? ""
                      : fmt::format("  {:<{}}{}\n", label, column - 2, wrapped(text, ledger_width, column));
}

/// A note, whose formulas stand between dollar signs.
std::string plain_note(std::string const& note) {
  std::string out;
  for (std::size_t at = 0; at < note.size();) {
    std::size_t const open = note.find('$', at),
                      close = open == std::string::npos ? open : note.find('$', open + 1);
    out += note.substr(at, close == std::string::npos ? close : open - at);
    if (close == std::string::npos) break;
    out += plain_formula(note.substr(open + 1, close - open - 1));
    at = close + 1;
  }
  return out;
}

/// The record of a statement as a ledger of its own, cut from the ledger as `ledger merge` lays it out: the
/// whole has ten megabytes. The whole, where it is laid out in another way.
std::string record_of(std::string const& id, std::string const& ledger) {
  std::size_t const name = ledger.find("\n  \"id\": \"" + id + "\"");
  if (name == std::string::npos) return ledger;
  std::size_t const begin = ledger.rfind("\n {", name), end = ledger.find("\n }", name);
  if (begin == std::string::npos || end == std::string::npos) return ledger;
  return "[" + ledger.substr(begin, end - begin) + "}]";
}

/// `build` of `build/bin/actio`.
fs::path build_of_this_program() { return folder_of_this_program().parent_path(); }

}  // namespace

std::optional<Verdict> verdict_of(std::string const& id) {
  std::ifstream in(build_of_this_program() / "report" / "statements.json");
  std::string const text{std::istreambuf_iterator<char>(in), {}};
  auto const ledger = nlohmann::json::parse(record_of(id, text), nullptr, false);
  if (ledger.is_discarded()) return std::nullopt;
  auto const& records = ledger.is_object() && ledger.contains("statements") ? ledger["statements"] : ledger;
  if (!records.is_array()) return std::nullopt;
  for (auto const& record : records)
    if (record.is_object() && record.value("id", "") == id && record.value("verdict", "") != "")
      return Verdict{record.value("verdict", ""), record.value("printed", ""), record.value("corrected", ""),
                     record.value("note", ""), record.value("left", "")};
  return std::nullopt;
}

std::string page_of(scene::Statement const& statement) {
  for (std::string const& page :
       {fmt::format("ch{:0>2}.html", statement.chapter), std::string("ledger.html")}) {
    fs::path const file = build_of_this_program() / "book" / page;
    std::ifstream in(file, std::ios::binary);
    std::string const text{std::istreambuf_iterator<char>(in), {}};
    if (text.find("id=\"" + statement.id + "\"") != std::string::npos)
      return file.string() + "#" + statement.id;
  }
  return fmt::format("ch{:0>2}.html#{} of the book, which ./run writes", statement.chapter, statement.id);
}

std::string verdict_in_words(std::string const& printed, std::string const& corrected,
                             std::string const& note, std::string const& left) {
  return ledger_line("printed", plain_formula(printed)) + ledger_line("corrected", plain_formula(corrected)) +
         ledger_line("note", plain_note(note)) + ledger_line("not shown", plain_note(left));
}

}  // namespace actio::app
