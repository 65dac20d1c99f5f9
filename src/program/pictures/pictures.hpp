// Pictures of a run: plots/*.svg, each of which stands alone, and plots/index.html, a page that plays the
// motion.
#pragma once

#include "program/pictures/overview.hpp"

namespace actio::scene {

/// Draws the pictures of the run that is in a folder, in place of those that are there: a curve of each
/// quantity, the drift of each conserved one, the way of the momentum of a body over its sphere, and the
/// page. Memory does not grow with the number of rows.
/// @param quiet  nothing on standard error, even where it takes long
/// @throws FileError  where the rows cannot be read or the pictures not be written
void draw_pictures(Scene const& scene, std::string const& folder, bool quiet = false);

/// A curve of a quantity over time, its components together.
std::string quantity_picture(Scene const& scene, Overview::Drawn const& drawn);
/// The relative drift of a conserved quantity over time, logarithmically.
std::string drift_picture(Scene const& scene, Overview::Drifting const& drifting);
/// The momentum in the frame of the body, on the sphere of its length.
std::string polhode_picture(Scene const& scene, Overview const& overview);
/// The page: curves, the body in motion, and the summary of the run; it needs nothing beside itself.
/// @param maps_json    of its snapshots on a sphere (System::maps)
/// @param medium_json  of those of a medium (played_medium.hpp)
std::string viewer_page(Scene const& scene, Overview const& overview, std::string const& summary_json,
                        std::string const& maps_json = "null", std::string const& medium_json = "null");

}  // namespace actio::scene
