// JSON, written: just what a report needs. Numbers keep every digit, and what is not a number is `null`.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace book::json {

/// A text as a JSON string, quotes included.
inline std::string quote(std::string_view text) {
  std::string out = "\"";
  for (unsigned char const c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += static_cast<char>(c);
    } else if (c == '\n') {
      out += "\\n";
    } else if (c < 0x20) {
      char code[8];
      std::snprintf(code, sizeof code, "\\u%04x", c);
      out += code;
    } else {
      out += static_cast<char>(c);
    }
  }
  return out + '"';
}

/// A number in its shortest form that reads back as the same number.
inline std::string number(double x) {
  if (!std::isfinite(x)) return "null";
  char digits[32];
  auto const end = std::to_chars(digits, digits + sizeof digits, x).ptr;
  return {digits, end};
}

/// Items that are JSON already, as an array.
inline std::string array(std::vector<std::string> const& items) {
  std::string out = "[";
  for (auto const& item : items) out += (out.size() > 1 ? ", " : "") + item;
  return out + "]";
}

/// Texts as an array of strings.
inline std::string strings(std::vector<std::string> const& texts) {
  std::vector<std::string> quoted;
  for (auto const& text : texts) quoted.push_back(quote(text));
  return array(quoted);
}

/// Writes a file whole or not at all: a reader never meets half of it.
/// @throws std::runtime_error  with the path, where the folder cannot be made or the file not be written
inline void write_file(std::filesystem::path const& path, std::string_view content) {
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
  auto unfinished = path;
  unfinished += ".part";
  std::ofstream out(unfinished, std::ios::binary);
  out << content;
  out.close();
  if (!out) throw std::runtime_error("cannot write " + unfinished.string());
  std::filesystem::rename(unfinished, path);
}

}  // namespace book::json
