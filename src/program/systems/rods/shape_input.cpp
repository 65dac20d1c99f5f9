#include "program/systems/rods/shape_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "program/systems/refused_at.hpp"
#include "program/systems/rods/curve_by_length.hpp"

namespace actio::scene {
namespace {

using Vector = rods::Three<double>;

struct RodKeys : KeyTable {
  AnyKey curve = key("curve", "three texts, each a formula in s",
                     LeftOut{"or system.rod.length or system.rod.origin or system.rod.axis or "
                             "system.rod.curvature"},
                     "The curve along which the rod lies at rest, for s from 0 to 1; smooth. Sections are at "
                     "equal distances along it, and their axes turn about it no more than they must.",
                     "[\"cos(2*pi*s)\", \"sin(2*pi*s)\", \"s/2\"]");
  Key<double> length = key("length", positive.in("length"), LeftOut{"or system.rod.curve"},
                           "The length of the rod at rest; with curve it is that of the curve.", "1");
  Key<int> elements = key("elements", whole("a whole number from 2 to 1000000", 2, 1000000), 32,
                          "How many elements it has, each between two sections.", "32");
  Key<std::string> constraint = key(
      "constraint",
      Pattern<std::string>{"\"none\" or \"unshearable\"", one_of("constraint", {"none", "unshearable"}).read},
      "none",
      "What the rod cannot do: with \"unshearable\" it neither stretches nor shears, as a slender rod "
      "nearly does, and steps may be as much longer as it is slender.",
      "\"unshearable\"");
  Key<Eigen::Vector3d> origin = key("origin", vector.in("length"), LeftOut{"or system.rod.curve; [0, 0, 0]"},
                                    "Where its start is; not with curve.", "[0, 0, 0]");
  Key<Eigen::Vector3d> axis =
      key("axis", vector.called("three components, not all zero"), LeftOut{"or system.rod.curve; [1, 0, 0]"},
          "The direction of its start; not with curve.", "[1, 0, 0]");
  Key<Eigen::Vector3d> across =
      key("across", vector.called("three components, not all zero"),
          LeftOut{"[0, 1, 0], or the next axis of space that is farther from the rod"},
          "A direction that the second axis of the first section is near.", "[0, 1, 0]");
  Key<bool> closed = key("closed", truth, false,
                         "Whether the curve ends where it begins, so that the rod is a ring.", "false");
  AnyKey curvature =
      key("curvature", "three texts, each a formula in s", LeftOut{"or system.rod.curve; none"},
          "Twist and bends about the second and the third axis, by length, that the rod has at rest at the "
          "distance s from its start.",
          "[\"0\", \"0\", \"1\"]");
  AnyKey section = key(
      "section", "a table with radius, young, poisson and density; or with EA, GA, EI, GJ, rA and rI", needed,
      "The cross-section, in axes of which the first points along the rod and the others across it. Of a "
      "disc of a solid: radius, Young's modulus, Poisson's ratio, mass per volume, and shear, the part of "
      "the area that resists shear, 1 where it is left out. Of any: what resists stretch, EA, shear, GA and "
      "GA3, bending about the second axis and the third, EI and EI3, and twist, GJ; the mass per length, rA; "
      "the moments of inertia per length, rI, rI3 and, about the first axis, rJ. GA3, EI3 and rI3 are as GA, "
      "EI and rI where they are left out, and rJ is rI + rI3. An unshearable rod has no EA and GA.",
      "{ radius = 0.02, young = 1e6, poisson = 0.5, density = 1100 }");
} const rod_keys{
    {"system.rod", needed,
     "The rod. Its shape at rest: length, or curve; origin, axis and across; curvature, or closed. What it "
     "is: section, elements and constraint.",
     "{ length = 1, elements = 32, section = { radius = 0.01, young = 1e6, poisson = 0.5, "
     "density = 1100 } }"}};

struct StartShapeKeys : KeyTable {
  AnyKey curve =
      key("curve", "three texts, each a formula in s",
          LeftOut{"or initial.origin or initial.axis or initial.curvature or initial.stretch; at rest"},
          "The curve along which the rod lies at the start, as system.rod.curve; what its "
          "elements are longer than at rest they are stretched by.",
          "[\"s\", \"0.1*s^2\", \"0\"]");
  AnyKey curvature = key(
      "curvature", "three texts, each a formula in s", LeftOut{"or initial.curve; that at rest"},
      "Twist and bends at the start at the distance s along the rod, by length.", "[\"0\", \"0\", \"0.5\"]");
  AnyKey stretch =
      key("stretch", "three texts, each a formula in s", LeftOut{"or initial.curve; that at rest"},
          "Gamma at the start at the distance s along the rod: the first number is its length "
          "over that at rest, the others are shears.",
          "[\"1.1\", \"0\", \"0\"]");
  Key<Eigen::Vector3d> origin = key("origin", vector.in("length"), LeftOut{"or initial.curve; that at rest"},
                                    "Where the start of the rod is at the start.", "[0, 0, 0]");
  Key<Eigen::Vector3d> axis =
      key("axis", vector.called("three components, not all zero"), LeftOut{"or initial.curve; that at rest"},
          "The direction of its start.", "[0, 0, 1]");
  Key<Eigen::Vector3d> across = key(
      "across", vector.called("three components, not all zero"), LeftOut{"or initial.curve; that at rest"},
      "A direction that the second axis of the first section is near.", "[0, 1, 0]");
} const start_keys{{"initial"}};

Vector three(Eigen::Vector3d const& v) { return {v[0], v[1], v[2]}; }

/// What a key holds; this, written back, where it is left out.
Eigen::Vector3d vector_at(SceneTable table, Key<Eigen::Vector3d> const& key,
                          Eigen::Vector3d const& otherwise) {
  if (!key.given(table)) table.set(key.name(), std::vector<double>{otherwise[0], otherwise[1], otherwise[2]});
  return key.read(table);
}
Eigen::Vector3d direction(SceneTable const& table, Key<Eigen::Vector3d> const& key,
                          Eigen::Vector3d const& otherwise) {
  Eigen::Vector3d const given = vector_at(table, key, otherwise);
  if (!(given.stableNorm() > 0)) key.fail(table, "a direction is expected, found one of length 0");
  return given.stableNormalized();
}
/// The axis of space that is farthest from a direction, the second one before the third and the first.
Eigen::Vector3d farthest_axis(Eigen::Vector3d const& from) {
  int best = 1;
  for (int const a : {2, 0})
    if (std::abs(from[a]) < std::abs(from[best]) - 1e-9) best = a;
  return Eigen::Vector3d::Unit(best);
}

/// Sections along the curve at a key.
std::pair<rods::RodShape, double> along_curve(SceneTable const& table, RodFormulas const& curve, int elements,
                                              bool closed, Key<Eigen::Vector3d> const& across_key) {
  CurveByLength const by_length(curve, elements);
  double const length = by_length.length();
  if (!(length > 0 && std::isfinite(length)))
    table.fail("curve", fmt::format("curve: its length is {}, and must be a number > 0", length));
  double const zero = 0, one = 1;
  auto const first = curve({&zero, 1}), last = curve({&one, 1});
  if (double const gap = std::hypot(last[0] - first[0], last[1] - first[1], last[2] - first[2]);
      closed && !(gap <= 1e-9 * length))
    table.fail("curve", fmt::format("curve: closed = true, and its end is {:.6g} away from its start, bound "
                                    "{:.3g}, 1e-9 of its length",
                                    gap, 1e-9 * length));
  auto const tangent = curve.slope(0);
  Eigen::Vector3d const across =
      direction(table, across_key, farthest_axis(Eigen::Vector3d(tangent.data()).normalized()));
  auto shape = refused_at(table, "curve", [&] {
    return rods::RodShape::along(
        [&](double part) {
          double const s = by_length.at(part);
          return std::pair(curve({&s, 1}), curve.slope(s));
        },
        elements, three(across), closed);
  });
  return {std::move(shape), length};
}

/// A straight rod.
rods::RodShape straight(SceneTable const& table, Eigen::Vector3d const& origin, Eigen::Vector3d const& axis,
                        Eigen::Vector3d const& across, double length, int elements) {
  return refused_at(table, "across", [&] {
    return rods::RodShape::along(
        [&](double part) { return std::pair(three(origin + part * length * axis), three(axis)); }, elements,
        three(across), false);
  });
}

rods::RodShape::Strain by_distance(RodFormulas const& formulas) {
  return [&formulas](double s) { return formulas({&s, 1}); };
}

void remark_on_turns(rods::RodShape const& shape, std::string const& key, std::vector<std::string>& remarks) {
  double largest = 0;
  for (std::size_t k = 0; k < shape.elements(); ++k) {
    auto const w = shape.element(k).w;
    largest = std::max(largest, 2 * std::atan(std::hypot(w[0], w[1], w[2]) / 2));
  }
  double const degrees = largest * 180 / std::numbers::pi;
  if (degrees > 60)
    remarks.push_back(
        fmt::format("{}: an element turns by {:.3g} degrees; beyond 60 the shape of a rod is "
                    "coarse, and beyond 90 it is refused",
                    key, degrees));
}

}  // namespace

std::vector<Parameter> rod_shape_parameters() { return records_of({rod_keys, start_keys}); }

bool read_unshearable(SceneFile const& file) { return rod_keys.constraint.read(file) == "unshearable"; }

SceneRodShape read_rest_shape(SceneFile const& file, SharedNames& shared, std::vector<std::string>& remarks) {
  SceneTable const rod = file.section("system.rod");
  int const elements = rod_keys.elements.read(rod);
  bool const closed = rod_keys.closed.read(rod);
  SceneRodShape out;
  if (rod_keys.curve.given(rod)) {
    for (AnyKey const& key :
         std::initializer_list<AnyKey>{rod_keys.length, rod_keys.origin, rod_keys.axis, rod_keys.curvature})
      if (key.given(rod)) key.fail(rod, "curve says it");
    RodFormulas const curve(rod, "curve", {"s"}, shared, 3, true);
    std::tie(out.shape, out.length) = along_curve(rod, curve, elements, closed, rod_keys.across);
  } else {
    if (closed)
      rod_keys.closed.fail(rod, "a ring is written as a curve that ends where it begins; curve is missing");
    if (!rod_keys.length.given(rod))
      throw SceneError(rod.place(), "[system.rod] needs length, or curve, whose length it is");
    out.length = rod_keys.length.read(rod);
    Eigen::Vector3d const origin = vector_at(rod, rod_keys.origin, Eigen::Vector3d::Zero()),
                          axis = direction(rod, rod_keys.axis, Eigen::Vector3d::UnitX()),
                          across = direction(rod, rod_keys.across, farthest_axis(axis));
    out.shape = straight(rod, origin, axis, across, out.length, elements);
    if (rod_keys.curvature.given(rod)) {
      RodFormulas const curvature(rod, "curvature", {"s"}, shared);
      auto const first = out.shape.attitudes.front();
      out.shape = refused_at(rod, "curvature", [&] {
        return rods::RodShape::of_strains(out.length, elements, three(origin), first, by_distance(curvature));
      });
    }
  }
  remark_on_turns(out.shape, rod_keys.curve.given(rod) ? "system.rod.curve" : "system.rod.curvature",
                  remarks);
  for (std::size_t k = 0; k < out.shape.sections(); ++k)
    out.distances.push_back(out.length * static_cast<double>(k) / elements);
  return out;
}

rods::RodShape read_start_shape(SceneFile const& file, SceneRodShape const& rest, SharedNames& shared,
                                std::vector<std::string>& remarks) {
  SceneTable const initial = file.section("initial");
  bool const closed = rest.shape.closed;
  auto const elements = static_cast<int>(rest.shape.elements());
  auto const given = [&initial](auto const& key) { return key.given(initial); };
  if (given(start_keys.curve)) {
    for (AnyKey const& key : std::initializer_list<AnyKey>{start_keys.origin, start_keys.axis,
                                                           start_keys.curvature, start_keys.stretch})
      if (given(key)) key.fail(initial, "curve says it");
    RodFormulas const curve(initial, "curve", {"s"}, shared, 3, true);
    auto shape = along_curve(initial, curve, elements, closed, start_keys.across).first;
    remark_on_turns(shape, "initial.curve", remarks);
    return shape;
  }
  if (std::ranges::none_of(
          std::initializer_list<AnyKey>{start_keys.origin, start_keys.axis, start_keys.across,
                                        start_keys.curvature, start_keys.stretch},
          given))
    return rest.shape;
  if (closed)
    for (AnyKey const& key : std::initializer_list<AnyKey>{
             start_keys.origin, start_keys.axis, start_keys.across, start_keys.curvature, start_keys.stretch})
      if (given(key)) key.fail(initial, "a ring starts along initial.curve, or as it is at rest");
  auto q = rest.shape.attitudes.front();
  Eigen::Vector3d const origin =
      start_keys.origin.find(initial).value_or(Eigen::Vector3d(rest.shape.places.front().data()));
  if (given(start_keys.axis) || given(start_keys.across)) {
    Eigen::Vector3d const along(rods::turned(q, Vector{1, 0, 0}).data()),
        axis = direction(initial, start_keys.axis, along),
        across = direction(initial, start_keys.across, farthest_axis(axis));
    q = straight(initial, origin, axis, across, rest.length, 2).attitudes.front();
  }
  auto const at_rest =
      refused_at(file.section("system.rod"), "curve", [&] { return rods::elements_at_rest(rest.shape); });
  std::optional<RodFormulas> curvature, stretch;
  if (given(start_keys.curvature))
    curvature.emplace(initial, "curvature", std::vector<std::string>{"s"}, shared);
  if (given(start_keys.stretch)) stretch.emplace(initial, "stretch", std::vector<std::string>{"s"}, shared);
  // Elements are as long as at rest, and not quite equal along a curve.
  double const D = rest.length / elements;
  auto const strain = [&](std::optional<RodFormulas> const& formula, bool turns) {
    return [&, turns](double s) {
      auto const& element = at_rest[std::min(static_cast<std::size_t>(s / D), at_rest.size() - 1)];
      Vector const own = turns ? element.kappa : element.Gamma;
      return rods::times(1 / (D * element.inverse_length), formula ? (*formula)({&s, 1}) : own);
    };
  };
  auto shape = refused_at(initial, curvature ? "curvature" : "stretch", [&] {
    return rods::RodShape::of_strains(rest.length, elements, three(origin), q, strain(curvature, true),
                                      strain(stretch, false));
  });
  remark_on_turns(shape, "initial.curvature", remarks);
  return shape;
}

}  // namespace actio::scene
