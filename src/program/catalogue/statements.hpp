// The statements of the thesis, by their ids, which the program carries with it: proofs_checks/registry.tsv,
// and which of them have a check.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace actio::scene {

/// A statement of the thesis.
struct Statement {
  std::string id;       ///< `thm_3_2_1`
  std::string kind;     ///< `theorem`
  std::string chapter;  ///< `3`
  std::string subject;  ///< what it is about, in a few words
  bool checked;         ///< whether the sources have a check of it
};

/// All of them, in the order of the registry.
std::vector<Statement> const& statements();
/// The one of that id; null where there is none.
Statement const* find_statement(std::string_view id);
/// What the thesis calls it: `(3.10)`, `Theorem 3.2.1`; its id where it has no number there.
std::string name_in_thesis(Statement const& statement);
/// Those that a reader of the thesis means: `thm_3_2_1`, `Theorem 3.2.1`, `thm 3.2.1`, `(3.10)`,
/// `equation 3.10`, `3.10`; of `3.2.1` alone whatever has that number.
std::vector<Statement const*> find_statements(std::string_view name);

}  // namespace actio::scene
