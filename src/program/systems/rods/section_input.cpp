#include "program/systems/rods/section_input.hpp"

#include "program/systems/refused_at.hpp"

namespace actio::scene {
namespace {

/// The numbers of the table, which the record of the table tells.
struct SectionKeys : KeyTable {
  Pattern<double> const resistance = number.called("a number > 0");
  Key<double> radius = key("radius", positive, LeftOut{"or EI"}, "Of a disc.", "0.01");
  Key<double> young = key("young", positive, needed, "Young's modulus.", "1e6");
  Key<double> poisson = key("poisson", number, needed, "Poisson's ratio.", "0.5");
  Key<double> density = key("density", positive, needed, "Mass per volume.", "1100");
  Key<double> shear = key("shear", positive, 1, "Part of the area that resists shear.", "0.9");
  Key<double> EA = key("EA", resistance, needed, "Against stretch.", "1e4");
  Key<double> GA = key("GA", resistance, needed, "Against shear along the second axis.", "1e4");
  Key<double> GA3 = key("GA3", resistance, LeftOut{"GA"}, "Along the third axis.", "1e4");
  Key<double> EI = key("EI", positive, LeftOut{"or radius"}, "Against bending about the second axis.", "500");
  Key<double> EI3 = key("EI3", positive, LeftOut{"EI"}, "About the third axis.", "500");
  Key<double> GJ = key("GJ", positive, needed, "Against twist.", "500");
  Key<double> rA = key("rA", positive, needed, "Mass per length.", "1");
  Key<double> rI = key("rI", positive, needed, "Moment of inertia about the second axis.", "10");
  Key<double> rI3 = key("rI3", positive, LeftOut{"rI"}, "About the third axis.", "10");
  Key<double> rJ = key("rJ", positive, LeftOut{"rI + rI3"}, "About the first axis.", "10");
} const keys{{"system.rod.section"}};

/// A stiffness against stretch or shear.
double resistance(Key<double> const& key, SceneTable const& section, std::optional<double> otherwise = {}) {
  double const value = otherwise ? key.read_or(section, *otherwise) : key.read(section);
  if (!(value > 0))
    key.fail(section, fmt::format("a number > 0 is expected, found {}; constraint = \"unshearable\" is for "
                                  "rods that neither stretch nor shear",
                                  value));
  return value;
}

}  // namespace

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
