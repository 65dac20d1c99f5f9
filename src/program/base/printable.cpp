#include "program/base/printable.hpp"

#include <cctype>

#include <fmt/format.h>

namespace actio::scene {
namespace {

/// One character: its code point, and how many bytes it takes. A byte that begins none stands for itself and
/// has no code point.
struct Character {
  char32_t code;
  std::size_t bytes;
  bool valid;
};

Character character_at(std::string_view text, std::size_t at) {
  auto const byte = [&](std::size_t i) { return static_cast<unsigned char>(text[at + i]); };
  unsigned const first = byte(0);
  std::size_t const bytes = first < 0x80                    ? 1
                            : first >= 0xC2 && first < 0xE0 ? 2
                            : first >= 0xE0 && first < 0xF0 ? 3
                            : first >= 0xF0 && first < 0xF5 ? 4
                                                            : 0;
  if (bytes == 0 || at + bytes > text.size()) return {first, 1, false};
  char32_t code = bytes == 1 ? first : first & (0x7Fu >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {first, 1, false};
    code = code << 6 | (byte(i) & 0x3F);
  }
  constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < least[bytes] || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return {first, 1, false};
  return {code, bytes, true};
}

/// Controls, separators of lines and paragraphs, marks that turn the direction of writing or show nothing at
/// all.
bool is_harmless(char32_t c) {
  return !(c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0xAD || c == 0x61C || (c >= 0x200B && c <= 0x200F) ||
           (c >= 0x2028 && c <= 0x202E) || (c >= 0x2060 && c <= 0x206F) || c == 0xFEFF ||
           (c >= 0xFFF9 && c <= 0xFFFB) || (c >= 0xE0000 && c <= 0xE007F) || (c & 0xFFFE) == 0xFFFE);
}

}  // namespace

std::string shown(std::string_view text, std::size_t longest) {
  std::string out;
  for (std::size_t at = 0, count = 0; at < text.size(); ++count) {
    if (count == longest) return out + "...";
    auto const [code, bytes, valid] = character_at(text, at);
    if (!valid)
      out += fmt::format("\\x{:02x}", static_cast<unsigned>(code));
    else if (is_harmless(code))
      out += text.substr(at, bytes);
    else if (code > 0xFFFF)
      out += fmt::format("\\U{:08x}", static_cast<unsigned>(code));
    else
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(code));
    at += bytes;
  }
  return out;
}

std::size_t length_in_utf8(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    Character const c = character_at(text, at);
    if (!c.valid) break;
    at += c.bytes;
  }
  return at;
}

std::string printable(std::string_view text) { return shown(text, text.size()); }

std::string in_shell(std::string const& word) {
  bool plain = !word.empty();
  for (unsigned char const c : word)
    plain = plain && (std::isalnum(c) || c >= 0x80 ||
                      std::string_view("_-./,:=+@%").find(static_cast<char>(c)) != std::string_view::npos);
  if (plain) return word;
  std::string out = "'";
  for (char const c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace actio::scene
