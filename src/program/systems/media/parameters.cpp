// The records of the keys of [system] and [initial] of a medium.
#include "program/systems/media/input.hpp"
#include "program/systems/media/material.hpp"

namespace actio::scene {
namespace {

std::string tables_of_materials(bool fluid) {
  std::string out;
  for (auto const& material : library_materials()) {
    if (material.fluid != fluid) continue;
    std::string constants;
    for (auto const& constant : material.constants)
      constants += (constants.empty() ? "" : ", ") + constant.name;
    out += (out.empty() ? "" : "; ") + material.name + " with " + constants;
  }
  return out;
}

std::vector<Parameter> of_system(bool fluid) {
  return {
      {"system.mesh", "a table", "needed",
       "The body in its reference space, and its cells. shape = \"box\" with lower, upper, cells and "
       "periodic, each with as many entries as the body has dimensions, one to three; \"disc\" and "
       "\"ball\" with radius and cells = [across, along], from the core outwards and along an edge of the "
       "core; \"annulus\" and \"shell\" with inner, outer and cells = [across, around], for a shell along "
       "a quarter of a great circle; \"file\" with file, the path of a mesh of Gmsh beside the scene: "
       "versions 2.0 to 2.2, 4.0 and 4.1, cells of first order and of one kind.",
       "", "{ shape = \"box\", lower = [0, 0], upper = [1, 1], cells = [8, 8] }"},
      {"system.material", "a table", "needed",
       "The name of a material of the library with its constants, per reference "
       "volume (actio list materials): " +
           tables_of_materials(fluid) + ".",
       "",
       fluid ? "{ name = \"polytropic_gas\", K = 1, gamma = 1.4 }"
             : "{ name = \"neo_hookean\", mu = 1, kappa = 2 }"},
      {"system.density", "a text, a formula in X, Y, Z, or a positive real", "1",
       "The mass per reference volume.", "", "\"1\""},
      {"system.metric",
       "a text",
       "\"euclidean\"",
       "The metric of the space that the body moves in: euclidean. The spaces "
       "of curved metrics are not there.",
       "",
       "\"euclidean\"",
       {"euclidean"}},
      {"system.boundary", "a table of texts by sides", "every side is free",
       "What each side of the body does, by its name: left and right of a box, where X is least and "
       "greatest, bottom and top, where Y is, front and back, where Z is, as far as it is not periodic; "
       "inner and outer of round bodies; those of a file, and its groups inside of the body. free: no "
       "force acts on it; fixed: its nodes keep the velocity that they have at the start, mostly none; "
       "sliding: they keep the component of it across the side.",
       "", "{}"},
  };
}

std::vector<Parameter> of_start() {
  return {
      {"initial.placement", "a list of texts, a formula in X, Y, Z for each dimension", "[\"X\", \"Y\"]",
       "Where the point X of the body is at the start. Its Jacobian is positive; in a periodic box what it "
       "differs from X by is periodic.",
       "", "[\"X + 0.01*sin(2*pi*X)\", \"Y\"]"},
      {"initial.velocity", "a list of texts, a formula in X, Y, Z for each dimension", "[\"0\", \"0\"]",
       "The velocity of the point X of the body at the start.", "", "[\"0\", \"0.1*cos(2*pi*X)\"]"},
  };
}

}  // namespace

std::vector<Parameter> medium_parameters(bool fluid) { return records_of({of_system(fluid), of_start()}); }

}  // namespace actio::scene
