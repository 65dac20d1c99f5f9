// Files that the program carries with it, so that it runs from anywhere. Their contents are put in by the build.
#pragma once

#include <string_view>

namespace actio::scene::embedded {

extern std::string_view const bodies_toml;         ///< data/bodies.toml
extern std::string_view const registry_tsv;        ///< proofs_checks/registry.tsv
extern std::string_view const checked_statements;  ///< ids of those that have a check, one a line

}  // namespace actio::scene::embedded
