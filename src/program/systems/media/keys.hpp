// The keys of [system] and [initial] of a medium, each an object that declares, reads and documents it.
#pragma once

#include "program/document/key.hpp"

namespace actio::scene {

/// [system] of a medium.
struct MediumKeys : KeyTable {
  bool fluid;  ///< whether they are those of a fluid
  AnyKey mesh =
      key("mesh", "a table", needed,
          "The body in its reference space, and its cells. shape = \"box\" with lower, upper, cells and "
          "periodic, each with as many entries as the body has dimensions, one to three; \"disc\" and "
          "\"ball\" with radius and cells = [across, along], from the core outwards and along an edge of the "
          "core; \"annulus\" and \"shell\" with inner, outer and cells = [across, around], for a shell along "
          "a quarter of a great circle; \"file\" with file, the path of a mesh of Gmsh beside the scene: "
          "versions 2.0 to 2.2, 4.0 and 4.1, cells of first order and of one kind.",
          "{ shape = \"box\", lower = [0, 0], upper = [1, 1], cells = [8, 8] }");
  AnyKey material =
      key("material", "a table", needed,
          "The name of a material of the library with its constants, per reference volume (actio list "
          "materials): " +
              constants_of_materials(fluid) + ".",
          fluid ? "{ name = \"polytropic_gas\", K = 1, gamma = 1.4 }"
                : "{ name = \"neo_hookean\", mu = 1, kappa = 2 }");
  Key<std::string> density =
      key("density",
          Pattern<std::string>{"a text, a formula in X, Y, Z, or a positive real", &formula_or_positive},
          LeftOut{"1"}, "The mass per reference volume.", "\"1\"");
  Key<std::string> metric =
      key("metric", Pattern<std::string>{"a text", &euclidean, {"euclidean"}}, "euclidean",
          "The metric of the space that the body moves in: euclidean. The spaces of curved metrics are not "
          "there.",
          "\"euclidean\"");
  AnyKey boundary =
      key("boundary", "a table of texts by sides", LeftOut{"every side is free"},
          "What each side of the body does, by its name: left and right of a box, where X is least and "
          "greatest, bottom and top, where Y is, front and back, where Z is, as far as it is not periodic; "
          "inner and outer of round bodies; those of a file, and its groups inside of the body. free: no "
          "force acts on it; fixed: its nodes keep the velocity that they have at the start, mostly none; "
          "sliding: they keep the component of it across the side.",
          "{}");
  AnyKey load =
      key("load", "a table", LeftOut{"no loads"},
          "What acts on the body. gravity: a potential per mass as a formula in x, y, z, whose force is "
          "minus its gradient, so that 9.81*y pulls down along y, and -9.81*y up. pressure: that of the "
          "outside; or pressure.SIDE, a number or a formula in t, on one side alone, which it follows. "
          "traction.SIDE: the force per reference area on a side, which keeps its direction. motion.SIDE: "
          "formulas in X, Y, Z and t of where that side is.",
          "{ gravity = \"0.1*y\" }");
  AnyKey obstacle =
      key("obstacle", "a table", LeftOut{"none"},
          "An obstacle as a potential per mass that rises towards its inside: potential, a formula in x, y, "
          "z.",
          "{ potential = \"exp(5*(cos(2*pi*x) + cos(2*pi*y) - 2))\" }");
  AnyKey loops = key(
      "loops", "a table by names of one's own", LeftOut{"the outermost closed row of nodes"},
      "Closed rows of nodes by names of one's own, along which the circulation is taken: the name of a "
      "side that is closed, along which the body is to the left, so that one around a hole goes clockwise; "
      "in a box in the plane { lower = [X, Y], upper = [X, Y] }, the edge of the rectangle of cells "
      "nearest to these corners, counterclockwise; in a periodic box { along = \"X\", through = [X, Y] }, "
      "the row nearest to a point that goes once around it.",
      "{ ring = { lower = [0.25, 0.25], upper = [0.5, 0.5] } }");

 private:
  static std::string constants_of_materials(bool fluid);
  static std::string euclidean(SceneTable const& system, std::string const& name);
  static std::string formula_or_positive(SceneTable system, std::string const& name);
};
inline MediumKeys const medium_keys{{"system"}, false};  ///< they are read alike of fluids and of solids

/// [initial] of a medium.
struct MediumStartKeys : KeyTable {
  AnyKey placement =
      key("placement", formulas, LeftOut{"[\"X\", \"Y\"]"},
          "Where the point X of the body is at the start. Its Jacobian is positive; in a periodic box what "
          "it differs from X by is periodic.",
          "[\"X + 0.01*sin(2*pi*X)\", \"Y\"]");
  AnyKey velocity =
      key("velocity", formulas, LeftOut{"[\"0\", \"0\"]"},
          "The velocity of the point X of the body at the start.", "[\"0\", \"0.1*cos(2*pi*X)\"]");

 private:
  static constexpr char const* formulas = "a list of texts, a formula in X, Y, Z for each dimension";
};
inline MediumStartKeys const medium_start_keys{{"initial"}};  ///< its keys

}  // namespace actio::scene
