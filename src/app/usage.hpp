// How the command is used: its help, and what it says to a line that it cannot take.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace actio::app {

/// Help, written the same way for the command and for each of its parts.
class Help : public CLI::Formatter {
 public:
  std::string make_help(CLI::App const* app, std::string name, CLI::AppFormatMode mode) const override;
};

/// What is wrong with the line, in one line, with what would be right; `command` is the whole command, parsed
/// as far as it went.
std::string usage_error(CLI::App const& command, CLI::ParseError const& error);

}  // namespace actio::app
