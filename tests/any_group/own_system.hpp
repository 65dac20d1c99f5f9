// A system told at run time, for tests.
#pragma once

#include <map>

#include "actio/any_group/chart_map.hpp"
#include "actio/any_group/momentum_across.hpp"
#include "actio/any_group/named_algebra.hpp"
#include "actio/formula/parse_formula.hpp"
#include "actio/formula/tape_derivatives.hpp"

namespace actio {

/// A system told by texts. With one carried vector `a` where there is any.
inline std::shared_ptr<systems::ReducedSystem const> own_system(
    char const* group, systems::Side side, char const* lagrangian, bool carried = false,
    std::map<std::string, double> const& parameters = {}) {
  systems::MatrixAlgebra algebra = systems::named_algebra(group);
  auto names = algebra.components;
  for (int i = 1; carried && i <= algebra.size; ++i) names.push_back("a" + std::to_string(i));
  Tape l = parse_formula(lagrangian, names, parameters);
  return std::make_shared<systems::ReducedSystem const>(std::move(algebra), side, carried ? 1 : 0,
                                                        std::move(l));
}

/// The same system with a force: a formula for each component, in the velocity, the vector `a`, the momenta
/// `p_w1` and so on, the time t, and held inputs by their names.
/// @param across  one in components of the other side, of the same; none where it is empty
inline std::shared_ptr<systems::ReducedSystem const> with_force(
    std::shared_ptr<systems::ReducedSystem const> const& of, std::vector<std::string> const& components,
    std::vector<std::pair<std::string, systems::HeldInput>> const& inputs = {},
    std::vector<std::string> const& across = {}) {
  auto names = of->algebra.components;
  for (int i = 1; i <= of->carried(); ++i) names.push_back("a" + std::to_string(i));
  for (auto const& name : of->algebra.components) names.push_back("p_" + name);
  names.push_back("t");
  systems::GeneralizedForce force;
  for (auto const& [name, input] : inputs) names.push_back(name), force.held.push_back(input);
  auto const read = [&names](std::vector<std::string> const& texts) {
    std::vector<Tape> tapes;
    for (auto const& text : texts)
      tapes.push_back(read_formula(text, names, {}, {.derivatives = false}).value);
    return joined(tapes);
  };
  force.components = read(components);
  if (!across.empty()) force.across = read(across);
  auto out = std::make_shared<systems::ReducedSystem>(*of);
  out->force = std::move(force);
  return out;
}

/// The point with a velocity and a vector.
inline systems::ReducedPoint point_at(systems::ReducedSystem const& system, std::vector<double> const& v,
                                      std::vector<double> const& a = {}) {
  return {systems::LegendreVelocity(system).momentum(v, a), a};
}
/// The same at a configuration, for a force in components of the other side.
inline systems::ReducedPoint point_at(systems::ReducedSystem const& system, std::vector<double> const& v,
                                      std::vector<double> const& a, Eigen::MatrixXd const& g) {
  auto point = point_at(system, v, a);
  point.frame = systems::frame_at(system.algebra, system.side, g, g.inverse());
  return point;
}

}  // namespace actio
