#include <sstream>
#include <stdexcept>

#include "malformed_scenes.hpp"

namespace command {
namespace {

std::string key_in(std::string const& line) { return line.substr(0, line.find_first_of(" =")); }
bool is_header(std::string const& line) { return line.starts_with('['); }

}  // namespace

GoodScene::GoodScene(std::string scene, std::string const& text) : name(std::move(scene)) {
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    line = line.substr(0, line.find('#'));
    line.erase(line.find_last_not_of(' ') + 1);
    lines_.push_back(line);
  }
}

std::string GoodScene::joined(std::vector<std::string> const& lines) {
  std::string out;
  for (auto const& line : lines) out += line + "\n";
  return out;
}
std::string GoodScene::text() const { return joined(lines_); }

std::size_t GoodScene::line_of(std::string const& key) const {
  for (std::size_t i = 0; i < lines_.size(); ++i)
    if (is_header(lines_[i]) ? lines_[i] == key : key_in(lines_[i]) == key) return i + 1;
  return 0;
}
std::size_t GoodScene::section_of(std::size_t line) const {
  while (line > 0 && !is_header(lines_[line - 1])) --line;
  return line;
}

Malformed GoodScene::with(std::string const& key, std::string const& value, std::string const& says,
                          unsigned offset) const {
  return with_line_instead(key, key + " = " + value, static_cast<unsigned>(key.size()) + 4 + offset, says);
}
Malformed GoodScene::overridden(std::string const& path, std::string const& value, std::string const& says,
                                unsigned offset) const {
  std::string const argument = path + "=" + value;
  return {name + ", --set " + argument.substr(0, 60),      text(), {argument}, 1,
          static_cast<unsigned>(path.size()) + 2 + offset, says};
}
Malformed GoodScene::without(std::string const& key) const {
  auto lines = lines_;
  std::size_t const line = line_of(key);
  if (line == 0) throw std::logic_error(name + " has no " + key);
  lines.erase(lines.begin() + static_cast<long>(line) - 1);
  return {name + ", without " + key, joined(lines), {}, static_cast<unsigned>(section_of(line)), 1, key};
}
Malformed GoodScene::without_section(std::string const& section, std::string const& says) const {
  auto lines = lines_;
  std::size_t const begin = line_of("[" + section + "]");
  if (begin == 0) throw std::logic_error(name + " has no [" + section + "]");
  std::size_t end = begin;
  while (end < lines.size() && !is_header(lines[end])) ++end;
  lines.erase(lines.begin() + static_cast<long>(begin) - 1, lines.begin() + static_cast<long>(end));
  return {
      name + ", without [" + section + "]", joined(lines), {}, static_cast<unsigned>(lines.size()), 1, says};
}
Malformed GoodScene::with_line(std::string const& section, std::string const& line, unsigned column,
                               std::string const& says) const {
  auto lines = lines_;
  std::size_t const header = line_of("[" + section + "]");
  if (header == 0) throw std::logic_error(name + " has no [" + section + "]");
  lines.insert(lines.begin() + static_cast<long>(header), line);
  return {name + ", in [" + section + "]: " + line.substr(0, 60),
          joined(lines),
          {},
          static_cast<unsigned>(header) + 1,
          column,
          says};
}
Malformed GoodScene::with_line_instead(std::string const& key, std::string const& line, unsigned column,
                                       std::string const& says) const {
  auto lines = lines_;
  std::size_t const at = line_of(key);
  if (at == 0) throw std::logic_error(name + " has no " + key);
  lines[at - 1] = line;
  return {name + ", " + line.substr(0, 60), joined(lines), {}, static_cast<unsigned>(at), column, says};
}
Malformed GoodScene::with_byte(char byte, std::mt19937& random) const {
  auto lines = lines_;
  std::size_t line = 0;
  do line = random() % lines.size();
  while (lines[line].empty());
  std::size_t const at = random() % (lines[line].size() + 1);
  lines[line].insert(at, 1, byte);
  return {name + ", byte " + std::to_string(static_cast<unsigned char>(byte)) + " in line " +
              std::to_string(line + 1),
          joined(lines),
          {},
          static_cast<unsigned>(line) + 1,
          byte == '\xff' ? static_cast<unsigned>(at) + 1 : 0};
}

}  // namespace command
