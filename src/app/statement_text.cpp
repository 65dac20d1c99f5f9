#include "app/statement_text.hpp"

#include <regex>
#include <sstream>
#include <string_view>

#include "app/text.hpp"
#include "program/base/embedded.hpp"
#include "program/catalogue/statements.hpp"

namespace actio::app {
namespace {

/// A paragraph of Markdown on one line, without what a page alone can show.
std::string plain_words(std::string text) {
  static std::regex const reference(R"re(\\ref ([a-z0-9_]+)(?: "([^"]*)")?)re"),
      command(R"(\\(?:figure|cite|tag|verdict)(?:\{[^}]*\}| [\w-]+))"), space(R"(\s+)");
  for (std::smatch match; std::regex_search(text, match, reference);) {
    scene::Statement const* const known = scene::find_statement(match[1].str());
    std::string const name = match[2].matched ? match[2].str()
                             : known          ? scene::name_in_thesis(*known)
                                              : match[1].str();
    text = match.prefix().str() + name + match.suffix().str();
  }
  static std::regex const emphasis(R"re((^|[ (])\*([A-Za-z][^*]*[A-Za-z0-9)])\*(?=[ ,.;:)]|$))re");
  text = std::regex_replace(std::regex_replace(text, command, "..."), space, " ");
  text = std::regex_replace(text, emphasis, "$1$2");
  std::size_t const begin = text.find_first_not_of(' ');
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

/// Text with formulas between \f$ and \f$ or \f[ and \f] as paragraphs.
std::vector<std::string> paragraphs_of(std::string const& text) {
  std::vector<std::string> out;
  std::string running;
  auto const end = [&] {
    if (std::string words = plain_words(running); !words.empty()) out.push_back(std::move(words));
    running.clear();
  };
  for (std::size_t at = 0; at < text.size();) {
    bool const display = text.compare(at, 3, "\\f[") == 0, inside = text.compare(at, 3, "\\f$") == 0;
    if (!display && !inside) {
      if (text.compare(at, 2, "\n\n") == 0) end();
      running += text[at++];
      continue;
    }
    std::size_t const close = std::min(text.find(display ? "\\f]" : "\\f$", at + 3), text.size());
    static std::regex const tag(R"(\\tag\{[^}]*\})"), space(R"(\s+)");
    std::string const tex =
        std::regex_replace(std::regex_replace(text.substr(at + 3, close - at - 3), tag, ""), space, " ");
    if (display) end();
    running +=
        tex.find("\\begin{CD}") == std::string::npos ? plain_formula(tex) : "(The diagram is in the book.)";
    if (display) end();
    at = close + 3;
  }
  end();
  return out;
}

}  // namespace

StatementText statement_text(std::string const& id) {
  std::string_view const chapters = scene::embedded::chapters_md;
  std::size_t const begin = chapters.find("\n\\statement{" + id + ",");
  if (begin == std::string_view::npos) return {};
  std::size_t const line = chapters.find('\n', begin + 1), end = chapters.find("\n\\endstatement", line);
  if (line == std::string_view::npos || end == std::string_view::npos) return {};
  std::size_t const title = begin + std::string_view("\n\\statement{").size() + id.size() + 1;
  StatementText out{plain_words(std::string(chapters.substr(title, chapters.rfind('}', line) - title))), {}};
  // Lines that stand for code, pictures and the like are of the page alone.
  std::istringstream lines{std::string(chapters.substr(line + 1, end - line - 1))};
  std::string text;
  static std::regex const item(R"(\s*(?:\d+\.|-) .*)");
  for (std::string one; std::getline(lines, one);)
    // Each item of a list is a paragraph.
    if (std::regex_match(one, item))
      text += "\n" + one + "\n";
    else if (!one.starts_with('\\') || one.starts_with("\\f") || one.starts_with("\\ref"))
      text += one + "\n";
    else
      text += "\n";
  out.paragraphs = paragraphs_of(text);
  return out;
}

}  // namespace actio::app
