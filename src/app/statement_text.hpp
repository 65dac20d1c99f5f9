// The texts of statements, as the chapters of the book tell them, in plain letters for a terminal.
#pragma once

#include <string>
#include <vector>

namespace actio::app {

/// What the book says of a statement: its title there, and its paragraphs, a displayed formula being one of
/// its own. Empty where it has no box.
struct StatementText {
  std::string title;
  std::vector<std::string> paragraphs;
};
StatementText statement_text(std::string const& id);

}  // namespace actio::app
