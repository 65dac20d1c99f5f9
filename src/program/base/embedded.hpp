// Files that the program carries with it, so that it runs from anywhere. Their contents are put in by the
// build.
#pragma once

#include <span>
#include <string_view>

namespace actio::scene::embedded {

extern std::string_view const bodies_toml;         ///< data/bodies.toml
extern std::string_view const registry_tsv;        ///< proofs_checks/registry.tsv
extern std::string_view const checked_statements;  ///< ids of those that have a check, one a line

extern std::string_view const chapters_md;  ///< chapters/*/chapter.md, one after the other

/// A text with a name.
struct NamedText {
  std::string_view name,  ///< of its file, without the ending
      text;               ///< the whole of it
};
/// The files of data/scenes, in the order of their names.
std::span<NamedText const> scenes();

// The page that plays a run: data/viewer/viewer.html, .css, and the parts of its script.
extern std::string_view const viewer_html,     ///< data/viewer/viewer.html
    viewer_css;                                ///< data/viewer/viewer.css
extern std::string_view const viewer_algebra,  ///< data/viewer/algebra.js
    viewer_stage,                              ///< data/viewer/stage.js
    viewer_shapes,                             ///< data/viewer/shapes.js
    viewer_motion,                             ///< data/viewer/motion.js
    viewer_space,                              ///< data/viewer/space.js
    viewer_pair,                               ///< data/viewer/pair.js
    viewer_momentum_sphere,                    ///< data/viewer/momentum_sphere.js
    viewer_curves,                             ///< data/viewer/curves.js
    viewer_planes,                             ///< data/viewer/planes.js
    viewer_box,                                ///< data/viewer/box.js
    viewer_frame_motion,                       ///< data/viewer/frame_motion.js
    viewer_frame,                              ///< data/viewer/frame.js
    viewer_trajectory,                         ///< data/viewer/trajectory.js
    viewer_map,                                ///< data/viewer/map.js
    viewer_medium,                             ///< data/viewer/medium.js
    viewer_player,                             ///< data/viewer/player.js
    viewer_page;                               ///< data/viewer/page.js

}  // namespace actio::scene::embedded
