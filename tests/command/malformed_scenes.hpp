// Scenes with one fault each, planted where it is known.
#pragma once

#include <random>
#include <string>
#include <vector>

namespace command {

/// A scene with a fault.
struct Malformed {
  std::string fault;              ///< what was planted, for the report
  std::string text;               ///< the file
  std::vector<std::string> set;   ///< overrides; where there are any, the fault is in the last
  unsigned line = 0, column = 0;  ///< of the fault; zero: not one place
  std::string says = {};          ///< what the complaint must contain
};

/// A good scene, to plant faults in.
class GoodScene {
 public:
  GoodScene(std::string name, std::string const& text);

  std::string name;

  bool has(std::string const& key) const { return line_of(key) > 0; }
  /// Whether the method goes to any time at once, and takes any step.
  bool is_exact() const { return text().find("order = \"exact\"") != std::string::npos; }
  std::string text() const;
  /// Another value for a key; the fault begins `offset` characters into it.
  Malformed with(std::string const& key, std::string const& value, std::string const& says = "",
                 unsigned offset = 0) const;
  /// The same from the command line.
  Malformed overridden(std::string const& path, std::string const& value, std::string const& says = "",
                       unsigned offset = 0) const;
  /// Without a key, which is missed at its section.
  Malformed without(std::string const& key) const;
  /// Without a section, which is missed at the last line.
  Malformed without_section(std::string const& section, std::string const& says) const;
  /// A line more at the end of a section; the fault begins at this column, or anywhere in the line.
  Malformed with_line(std::string const& section, std::string const& line, unsigned column,
                      std::string const& says = "") const;
  /// The line of a key as it is said to be here.
  Malformed with_line_instead(std::string const& key, std::string const& line, unsigned column,
                              std::string const& says = "") const;
  /// A byte that TOML does not know, somewhere in a line that says something.
  Malformed with_byte(char byte, std::mt19937& random) const;

 private:
  std::size_t line_of(std::string const& key) const;  // from 1; 0: there is none
  std::size_t section_of(std::size_t line) const;     // the line of the header above
  static std::string joined(std::vector<std::string> const& lines);

  std::vector<std::string> lines_;  // without comments
};

/// Faults of every kind, in each of these scenes.
std::vector<Malformed> malformed_scenes(std::vector<GoodScene> const& scenes, unsigned seed);

}  // namespace command
