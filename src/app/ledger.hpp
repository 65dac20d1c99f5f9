// What is known of a statement of the thesis beside the registry: the ledger and the book of a build, where
// they are beside the command.
#pragma once

#include <optional>
#include <string>

#include "program/catalogue/statements.hpp"

namespace actio::app {

/// What the checks found.
struct Verdict {
  std::string word,  ///< `holds`, `corrected`, `scope`, `convention`
      printed,       ///< in the thesis, in TeX, where it was corrected
      corrected,     ///< what holds instead, in TeX
      note,          ///< why, or where it holds
      left;          ///< what of the statement the check does not show
};

/// Of the ledger, report/statements.json beside the folder of the command; none where there is no ledger, or
/// it does not have the statement.
std::optional<Verdict> verdict_of(std::string const& id);

/// Where the book has the statement: the file of its chapter beside the folder of the command, with the place
/// in it; only the name of the page where no book is there.
std::string page_of(scene::Statement const& statement);

/// Lines that tell what was corrected, and why; in plain letters, indented.
std::string verdict_in_words(std::string const& printed, std::string const& corrected,
                             std::string const& note, std::string const& left = {});

}  // namespace actio::app
