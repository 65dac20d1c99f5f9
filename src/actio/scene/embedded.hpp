// Files that the program carries with it, so that it runs from anywhere. Their contents are put in by the build.
#pragma once

#include <string_view>

namespace actio::scene::embedded {

extern std::string_view const bodies_toml;         ///< data/bodies.toml
extern std::string_view const registry_tsv;        ///< proofs_checks/registry.tsv
extern std::string_view const checked_statements;  ///< ids of those that have a check, one a line

// The page that plays a run: data/viewer/viewer.html, .css, and the parts of its script.
extern std::string_view const viewer_html, viewer_css;
extern std::string_view const viewer_algebra, viewer_stage, viewer_shapes, viewer_motion, viewer_space, viewer_momentum_sphere, viewer_curves, viewer_player, viewer_page;

}  // namespace actio::scene::embedded
