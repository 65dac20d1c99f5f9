#include "program/systems/bodies/torque_input.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

#include "actio/fast_body/space/principal_axes.hpp"

namespace actio::scene {
namespace {

constexpr char const *torque = "system.torque", *gradient = "system.torque.gravity_gradient",
                     *uniform = "system.torque.uniform_gravity", *potential = "system.torque.potential";
LeftOut without(std::string const& one, std::string const& other) { return {"or " + one + " or " + other}; }

struct GradientKeys : KeyTable {
  Pattern<Eigen::Vector3d> const components = vector.called("three components, not all zero");
  Key<double> strength = key(
      "strength", positive.in("1/time^2"), LeftOut{"the square of " + name() + ".rate"},
      "mu/r^3, the constant of gravitation times the mass of the centre by the cube of its distance.", "0.2");
  Key<Eigen::Vector3d> direction =
      key("direction", components, needed, "To the centre, in space; with rate it is that at the start.",
          "[1, 0, 0]");
  Key<double> rate = key(
      "rate", number.called("a number, not zero").in("1/time"),
      LeftOut{"none, and the direction stands still"},
      "At which the direction turns about the normal, as on a circular orbit, where its square is mu/r^3.",
      "0.5");
  Key<Eigen::Vector3d> normal =
      key("normal", components, LeftOut{"needed where " + name() + ".rate is given"},
          "Of the orbit, in space, at right angles to the direction, which turns about it "
          "counter-clockwise as seen from its tip.",
          "[0, 0, 1]");
} const gradient_keys{
    {gradient, without(uniform, potential),
     "The gradient of the gravity of a centre that is far away against the size of the body: its "
     "potential is 3/2 mu/r^3 times the moment of inertia about the direction to the centre.",
     "{ strength = 0.2, direction = [1, 0, 0] }", "a table with strength or rate, and direction"}};

struct UniformKeys : KeyTable {
  Pattern<Eigen::Vector3d> const some = vector.called("three numbers, not all zero");
  Key<double> mass = key("mass", positive.in("mass"), needed, "The mass.", "1");
  Key<Eigen::Vector3d> lever =
      key("lever", some.in("length"), needed,
          "From the fixed point to the centre of mass, in the frame of the body.", "[0, 0, 0.5]");
  Key<Eigen::Vector3d> acceleration =
      key("acceleration", some.in("length/time^2"), needed, "Of gravity, in space.", "[0, 0, -9.81]");
} const uniform_keys{
    {uniform, without(gradient, potential),
     "The weight of a body that is held at a point, about which the inertia is that of the scene; a "
     "heavy_top computes it from that about the centre of mass. A magnet in a field is under such a "
     "torque, too, its moment the mass times the lever.",
     "{ mass = 1, lever = [0, 0, 0.5], acceleration = [0, 0, -9.81] }",
     "a table with mass, lever and acceleration"}};

KeyTable const torque_table{
    torque, LeftOut{"none, and the body is free"},
    "A torque on the body: of a potential, one of three, and of formulas for what has none, such as friction "
    "or a thruster.",
    "{ gravity_gradient = { rate = 0.5, direction = [1, 0, 0], normal = [0, 0, 1] } }",
    "a table with gravity_gradient, uniform_gravity or potential, or body, or one of them and body"};
struct PotentialKeys : KeyTable {
  Key<std::string> formula = key(
      "potential", text.called("a formula, as a text"), without(gradient, uniform),
      "The potential energy, in the entries r11, r12, ..., r33 of the rotation matrix that takes the body "
      "to space, row by row, and the time t; names of your own may be defined before it: \"k = 2; "
      "-k*r33\". The torque is its exact derivative.",
      "\"-2*r33 + 0.1*r11^2*cos(t)\"");
} const potential_keys{{torque}};

/// A vector that says a direction.
Eigen::Vector3d direction(SceneTable const& table, Key<Eigen::Vector3d> const& key) {
  Eigen::Vector3d const given = key.read(table);
  if (!(magnitude(given) > 0)) key.fail(table, "a direction is expected, found one of length 0");
  return given.stableNormalized().normalized();
}

/// An arm or an acceleration, without which there would be no torque.
Eigen::Vector3d not_zero(SceneTable const& table, Key<Eigen::Vector3d> const& key) {
  Eigen::Vector3d const given = key.read(table);
  if (!(magnitude(given) > 0))
    key.fail(table, "it is zero, so that there is no torque; leave system.torque out");
  return given;
}

std::string listed_components(Eigen::Vector3d const& v) {
  return fmt::format("[{}, {}, {}]", v[0], v[1], v[2]);
}

/// That the direction to the centre stays in the plane of the orbit.
void check_right_angle(SceneTable const& gradient, Eigen::Vector3d const& towards,
                       Eigen::Vector3d const& normal) {
  double const cosine = towards.dot(normal);
  if (std::abs(cosine) <= 1e-9) return;
  Eigen::Vector3d const in_plane = towards - cosine * normal;
  gradient_keys.direction.fail(
      gradient, fmt::format("the direction to the centre and the normal of the orbit are {} degrees "
                            "apart, and must be 90 to 1e-9 radians{}",
                            std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi,
                            in_plane.norm() > 1e-6 ? "; in the plane of the orbit it is " +
                                                         listed_components(in_plane.normalized())
                                                   : ""));
}

}  // namespace

SceneTorque::SceneTorque(SceneTable const& torque, PrincipalInertia const& inertia)
    : table_(torque), inertia_(inertia) {
  std::vector<std::string> given;
  for (char const* key : {"gravity_gradient", "uniform_gravity", "potential"})
    if (torque.has(key)) given.emplace_back(key);
  auto const& own = formula_torque_keys;
  for (AnyKey const& key : {own.parameters, own.definitions, own.inputs})
    if (key.given(torque) && !own.body.given(torque))
      key.fail(torque, "they are given to system.torque.body, which is missing");
  if (given.empty() && !own.body.given(torque))
    throw SceneError(
        torque.place(),
        "[system.torque] needs one of 'gravity_gradient', 'uniform_gravity', 'potential' and 'body'");
  if (own.body.given(torque)) formulas_.emplace(torque);
  if (given.empty()) return;
  if (given.size() > 1)
    torque.fail(given[1],
                fmt::format("{} and {} exclude each other: a body has one potential; a sum of several is "
                            "written as one formula",
                            given[0], given[1]));
  try {
    if (given[0] == "gravity_gradient")
      read_gradient(torque.inside(given[0]));
    else if (given[0] == "uniform_gravity")
      read_uniform(torque.inside(given[0]));
    else
      read_formula(torque);
  } catch (SceneError const&) {
    throw;
  } catch (Error const& error) {
    torque.fail(given[0], given[0] + ": " + error.what());
  }
}

void SceneTorque::read_gradient(SceneTable const& table) {
  auto const& keys = gradient_keys;
  bool const turns = keys.rate.given(table), strong = keys.strength.given(table);
  if (!turns && keys.normal.given(table))
    keys.normal.fail(table, "the direction to the centre turns about it at 'rate', which is missing");
  if (turns && !keys.normal.given(table))
    keys.rate.fail(table, "the direction to the centre turns about 'normal', which is missing");
  double const rate = keys.rate.find(table).value_or(0);
  if (turns && rate == 0)
    keys.rate.fail(table, "it is zero; without 'rate' and 'normal' the direction stands still");
  if (!turns && !strong)
    throw SceneError(table.place(),
                     "[system.torque.gravity_gradient] needs 'strength', which is mu/r^3, or the 'rate' of "
                     "a circular orbit, whose square it is");
  if (!strong && (!is_finite(rate * rate) || !(rate * rate > 0)))
    keys.rate.fail(table, "its square, which is mu/r^3, is beyond all numbers; 'strength' would say it");
  double const strength = keys.strength.read_or(table, rate * rate);
  if (!is_finite(3 * strength * magnitude(inertia_.tensor())))
    keys.strength.fail(table, "the number is too large: the torque is beyond 1e308");
  Eigen::Vector3d const towards = direction(table, keys.direction);
  symmetric_ = !turns, axis_ = towards;
  if (!turns) {
    of_potential_ = bodies::gravity_gradient(inertia_.inertia, 3 * strength, towards);
    return;
  }
  rate_ = rate, axis_ = direction(table, keys.normal);
  check_right_angle(table, towards, axis_);
  bodies::GravityGradient orbit = bodies::gravity_gradient_in_orbit(inertia_.inertia, rate, towards, axis_);
  orbit.strength = 3 * strength;
  of_potential_ = orbit;
}

void SceneTorque::read_uniform(SceneTable const& uniform) {
  double const mass = uniform_keys.mass.read(uniform);
  Eigen::Vector3d const lever = not_zero(uniform, uniform_keys.lever),
                        pull = not_zero(uniform, uniform_keys.acceleration),
                        weight = mass * pull.stableNorm() * lever;
  if (!is_finite(weight) || !is_finite(weight.squaredNorm()))
    throw SceneError(uniform.place(),
                     "[system.torque.uniform_gravity]: the numbers are too large: mass times lever "
                     "times acceleration is beyond 1e154");
  of_potential_ = actio::bodies::uniform_gravity(weight, pull);
  axis_ = -pull.stableNormalized().normalized(), symmetric_ = true;
}

void SceneTorque::read_formula(SceneTable const& torque) {
  FormulaPotential potential(potential_keys.formula.read(torque), torque.text_place("potential"));
  place_ = torque.place("potential");
  formula_in_time_ = potential.uses_time();
  if (int const axis = potential.axis(); axis >= 0) axis_ = Eigen::Vector3d::Unit(axis), symmetric_ = true;
  of_potential_ = bodies::PotentialTorque<FormulaPotential>(std::move(potential));
}

AnyTorque SceneTorque::torque() const {
  if (formulas_) return formulas_->with(of_potential_);
  return std::visit([](auto const& torque) -> AnyTorque { return torque; }, *of_potential_);
}

double SceneTorque::potential(Eigen::Vector4d const& attitude, double time) const {
  if (!of_potential_) return 0;
  if (auto const* const gradient = std::get_if<bodies::GravityGradient>(&*of_potential_))
    // Its moments are those along the principal axes.
    return gradient->potential({SU2{}, bodies::PrincipalAxes(inertia_.axes).enter(attitude)}, time);
  if (auto const* const gravity = std::get_if<bodies::UniformGravity>(&*of_potential_))
    return gravity->potential({SU2{}, attitude});
  return std::get<bodies::PotentialTorque<FormulaPotential>>(*of_potential_)
      .potential({SU2{}, attitude}, time);
}

std::optional<SceneTorque> read_torque(SceneTable const& system, PrincipalInertia const& inertia) {
  if (!system.has("torque")) return std::nullopt;
  return SceneTorque(system.inside("torque"), inertia);
}

std::vector<Parameter> torque_parameters() {
  return records_of({torque_table, gradient_keys, uniform_keys, potential_keys, formula_torque_keys});
}

}  // namespace actio::scene
