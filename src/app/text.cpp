#include "app/text.hpp"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>

namespace actio::app {
namespace {

/// Letters that are seen: bytes that continue a letter of UTF-8 do not count.
std::size_t letters(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

}  // namespace

std::string aligned(std::vector<std::vector<std::string>> const& rows, std::string const& indent) {
  std::vector<std::size_t> widths;
  for (auto const& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], letters(row[i]));
  }
  std::string out;
  for (auto const& row : rows) {
    std::string line = indent;
    for (std::size_t i = 0; i < row.size(); ++i)
      line += row[i] + std::string(i + 1 < row.size() ? widths[i] - letters(row[i]) + 2 : 0, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + "\n";
  }
  return out;
}

std::string wrapped(std::string const& text, std::size_t width, std::size_t indent) {
  std::string out;
  std::size_t line = indent, at = 0;
  while (at < text.size()) {
    std::size_t const end = std::min(text.find(' ', at), text.size());
    std::string const word = text.substr(at, end - at);
    if (line > indent && line + 1 + letters(word) > width)
      out += "\n" + std::string(indent, ' '), line = indent;
    else if (!out.empty())
      out += ' ', ++line;
    out += word, line += letters(word);
    at = end + 1;
  }
  return out;
}

std::string in_shell(std::string const& name) {
  auto const plain = [](unsigned char c) {
    return c >= 0x80 || std::isalnum(c) ||
           std::string_view("_./+,:=@%-").find(static_cast<char>(c)) != std::string_view::npos;
  };
  auto const control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  std::string const safe = name.starts_with('-') ? "./" + name : name;
  if (!safe.empty() && std::all_of(safe.begin(), safe.end(), plain)) return safe;
  bool const escaped = std::any_of(safe.begin(), safe.end(), control);
  std::string out = escaped ? "$'" : "'";
  for (char const c : safe) {
    auto const byte = static_cast<unsigned char>(c);
    if (control(byte))
      out += {'\\', static_cast<char>('0' + byte / 64), static_cast<char>('0' + byte / 8 % 8),
              static_cast<char>('0' + byte % 8)};
    else if (c == '\'')
      out += escaped ? "\\'" : "'\\''";
    else if (c == '\\' && escaped)
      out += "\\\\";
    else
      out += c;
  }
  return out + "'";
}

std::string heading(std::string const& text, std::FILE* stream) {
  char const* const no_color = std::getenv("NO_COLOR");
  bool const plain = (no_color && *no_color) || !::isatty(::fileno(stream));
  return plain ? text : "\x1b[1m" + text + "\x1b[0m";
}

namespace {

/// Reads a formula from left to right.
class Formula {
 public:
  explicit Formula(std::string_view tex) : tex_(tex) {}

  /// Up to the closing brace, or to the end.
  std::string read() {
    while (at_ < tex_.size() && tex_[at_] != '}') one();
    if (at_ < tex_.size()) ++at_;
    return out_;
  }

 private:
  void one() {
    char const c = tex_[at_];
    if (c == '\\')
      command();
    else if (c == '^' || c == '_')
      ++at_, script(c);
    else if (c == '{')
      out_ += argument();
    else if (c == '~')
      space(), ++at_;
    else
      put(std::string(1, c)), ++at_;
  }

  void command() {
    std::size_t end = ++at_;
    while (end < tex_.size() && std::isalpha(static_cast<unsigned char>(tex_[end]))) ++end;
    if (end == at_) {  // \, \; \! \{ \\ and the like
      char const c = tex_[at_++];
      if (c == '{' || c == '}' || c == '|')
        put(c == '|' ? "|" : std::string(1, c));
      else if (c != '!')
        space();
      return;
    }
    std::string const name(tex_.substr(at_, end - at_));
    at_ = end;
    while (at_ < tex_.size() && tex_[at_] == ' ') ++at_;
    named(name);
    // TeX leaves out the space after a command; before a sign it is easier to read with it.
    if (at_ > end && at_ < tex_.size() && std::string_view("=+-<>").find(tex_[at_]) != std::string_view::npos)
      space();
  }

  void named(std::string const& name) {
    static std::map<std::string, std::string> const signs{
        {"langle", "<"},      {"rangle", ">"},       {"cdot", "."},        {"times", " x "},
        {"le", " <= "},       {"ge", " >= "},        {"lVert", "|"},       {"rVert", "|"},
        {"lvert", "|"},       {"rvert", "|"},        {"to", " -> "},       {"top", "T"},
        {"quad", "  "},       {"qquad", "   "},      {"dots", "..."},      {"ldots", "..."},
        {"cdots", "..."},     {"infty", "infinity"}, {"lfloor", "floor("}, {"rfloor", ")"},
        {"left", ""},         {"right", ""},         {"bigl", ""},         {"bigr", ""},
        {"operatorname", ""}, {"mathrm", ""},        {"mathbb", ""},       {"mathcal", ""},
        {"mathfrak", ""},     {"mathsf", ""},        {"Bigl", ""},         {"Bigr", ""},
        {"displaystyle", ""}, {"hatmap", "hat "},    {"pm", " +- "},       {"ne", " != "},
        {"neq", " != "},      {"in", " in "},        {"subset", " in "},   {"equiv", " = "},
        {"ddt", "d/dt "},     {"int", "integral "},  {"adstar", "ad^*"},   {"Adstar", "Ad^*"},
        {"text", ""},         {"mathbf", ""},        {"hat", "hat "},      {"dot", "d/dt "},
        {"dotproduct", "."}};
    if (name == "frac" || name == "tfrac" || name == "dfrac") {
      std::string const above = argument(), below = argument();
      put(enclosed(above) + "/" + enclosed(below));
      apart_ = true;
    } else if (auto const sign = signs.find(name); sign != signs.end()) {
      put(sign->second);
    } else {
      if (!out_.empty() && std::isalnum(static_cast<unsigned char>(out_.back()))) space();
      put(name), apart_ = true;  // \omega, \sum: its name, kept apart from a letter that follows
    }
  }

  void script(char sign) {
    std::string const inside = argument();
    out_ += sign + enclosed(inside);
    apart_ = true;
  }

  /// In braces, or one command or letter.
  std::string argument() {
    while (at_ < tex_.size() && tex_[at_] == ' ') ++at_;
    if (at_ >= tex_.size()) return "";
    if (tex_[at_] == '{') {
      Formula inner(tex_.substr(at_ + 1));
      std::string const text = inner.read();
      at_ += 1 + inner.at_;
      return text;
    }
    std::size_t end = at_ + 1;
    if (tex_[at_] == '\\')
      while (end < tex_.size() && std::isalpha(static_cast<unsigned char>(tex_[end]))) ++end;
    std::string const text = Formula(tex_.substr(at_, end - at_)).read();
    at_ = end;
    return text;
  }
  /// In brackets where it is more than a name or a number.
  static std::string enclosed(std::string const& text) {
    std::size_t const sign = !text.empty() && text.front() == '-' ? 1 : 0;
    bool const simple = std::all_of(text.begin() + static_cast<long>(sign), text.end(),
                                    [](unsigned char c) { return std::isalnum(c) || c == '.'; }) ||
                        text == "*";
    return simple ? text : "(" + text + ")";
  }

  void space() {
    if (!out_.empty() && out_.back() != ' ') out_ += ' ';
    apart_ = false;
  }
  void put(std::string text) {
    if (text.empty()) return;
    if (apart_ && (std::isalnum(static_cast<unsigned char>(text.front())) || text.front() == '<' ||
                   text.front() == '|'))
      space();
    if (text.front() == ' ' && !out_.empty() && out_.back() == ' ') text.erase(0, 1);
    out_ += text, apart_ = false;
  }

  std::string_view tex_;
  std::size_t at_ = 0;
  std::string out_;
  bool apart_ = false;  // a letter that follows belongs to another name
};

}  // namespace

std::string plain_formula(std::string_view tex) {
  std::string out = Formula(tex).read();
  out.erase(out.find_last_not_of(' ') + 1);
  return out;
}

}  // namespace actio::app
