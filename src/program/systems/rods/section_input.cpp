#include "program/systems/rods/section_input.hpp"

#include "program/systems/refused_at.hpp"

namespace actio::scene {
namespace {

struct SectionKeys : KeyTable {
  Key<double> radius = key("radius", positive.in("length"), LeftOut{"or EI"},
                           "The radius of a disc, with young, poisson and density.", "0.01");
  Key<double> young = key("young", positive.in("mass/(length time^2)"), LeftOut{"needed with radius"},
                          "Young's modulus E.", "1e6");
  Key<double> poisson = key("poisson", number.called("a number, more than -1 and at most 1/2").in("1"),
                            LeftOut{"needed with radius"}, "Poisson's ratio; that of rubber is 1/2.", "0.5");
  Key<double> density =
      key("density", positive.in("mass/length^3"), LeftOut{"needed with radius"}, "Mass per volume.", "1100");
  Key<double> shear =
      key("shear", positive.in("1"), 1,
          "With radius: the part of the area that resists shear, 6/7 by one theory and 0.9 by "
          "another.",
          "0.9");
  Key<double> EA = key("EA", number.called("a number > 0").in("mass length/time^2"),
                       LeftOut{"needed with EI, but for unshearable rods"}, "What resists stretch.", "1e4");
  Key<double> GA =
      key("GA", number.called("a number > 0").in("mass length/time^2"),
          LeftOut{"needed with EI, but for unshearable rods"},
          "What resists shear along the second axis, and along the third where GA3 is left out.", "1e4");
  Key<double> GA3 = key("GA3", number.called("a number > 0").in("mass length/time^2"), LeftOut{"GA"},
                        "What resists shear along the third axis.", "1e4");
  Key<double> EI =
      key("EI", positive.in("mass length^3/time^2"), LeftOut{"or radius"},
          "What resists bending about the second axis, and about the third where EI3 is left out.", "500");
  Key<double> EI3 = key("EI3", positive.in("mass length^3/time^2"), LeftOut{"EI"},
                        "What resists bending about the third axis.", "500");
  Key<double> GJ =
      key("GJ", positive.in("mass length^3/time^2"), LeftOut{"needed with EI"}, "What resists twist.", "500");
  Key<double> rA = key("rA", positive.in("mass/length"), LeftOut{"needed with EI"}, "Mass per length.", "1");
  Key<double> rI =
      key("rI", positive.in("mass length"), LeftOut{"needed with EI"},
          "The moment of inertia per length about the second axis, and about the third where rI3 "
          "is left out.",
          "10");
  Key<double> rI3 = key("rI3", positive.in("mass length"), LeftOut{"rI"},
                        "The moment of inertia per length about the third axis.", "10");
  Key<double> rJ = key("rJ", positive.in("mass length"), LeftOut{"rI + rI3, that of a flat section"},
                       "The moment of inertia per length about the first axis, along the rod.", "10");
} const keys{{"system.rod.section", needed,
              "The cross-section, in axes of which the first points along the rod: a disc of a solid, by "
              "radius, young, poisson and density; or any, by EA, GA, EI, GJ, rA and rI.",
              "{ radius = 0.01, young = 1e6, poisson = 0.5, density = 1100 }"}};

/// A stiffness against stretch or shear.
double resistance(Key<double> const& key, SceneTable const& section, std::optional<double> otherwise = {}) {
  double const value = otherwise ? key.read_or(section, *otherwise)
                                 : key.read(section, Patterns::number.called("a number > 0"));
  if (!(value > 0))
    key.fail(section, fmt::format("a number > 0 is expected, found {}; constraint = \"unshearable\" is for "
                                  "rods that neither stretch nor shear",
                                  value));
  return value;
}

}  // namespace

std::vector<Parameter> rod_section_parameters() { return keys.records(); }

rods::RodSection read_rod_section(SceneTable const& rod, bool unshearable) {
  SceneTable const section = rod.inside("section");
  bool const disc = keys.radius.given(section);
  if (disc)
    section.allow({"radius", "young", "poisson", "density", "shear"});
  else
    section.allow({"EA", "GA", "GA3", "EI", "EI3", "GJ", "rA", "rI", "rI3", "rJ"});
  if (disc)
    return refused_at(rod, "section", [&] {
      return rods::RodSection::circular(keys.radius.read(section), keys.young.read(section),
                                        keys.poisson.read(section), keys.density.read(section),
                                        keys.shear.read(section));
    });
  if (!keys.EI.given(section))
    throw SceneError(section.place(),
                     "section: a rod has one by radius, young, poisson and density, or by EA, GA, EI, GJ, rA "
                     "and rI; neither radius nor EI is there");
  rods::RodSection out{};
  double const EI = keys.EI.read(section), rI = keys.rI.read(section);
  double const EI3 = keys.EI3.read_or(section, EI), rI3 = keys.rI3.read_or(section, rI);
  out.bending = {keys.GJ.read(section), EI, EI3};
  out.mass = keys.rA.read(section);
  out.inertia = {keys.rJ.read_or(section, rI + rI3), rI, rI3};
  if (unshearable) {
    for (auto const* const key : {&keys.EA, &keys.GA, &keys.GA3})
      if (key->given(section))
        key->fail(section,
                  "a rod with constraint = \"unshearable\" neither stretches nor shears, and has no "
                  "such number");
    out.stretching = {1, 1, 1};  // which nothing uses
  } else {
    double const GA = resistance(keys.GA, section);
    out.stretching = {resistance(keys.EA, section), GA, resistance(keys.GA3, section, GA)};
  }
  refused_at(rod, "section", [&] { return out.examine(), 0; });
  return out;
}

}  // namespace actio::scene
