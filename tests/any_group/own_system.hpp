// A system told at run time, for tests.
#pragma once

#include <map>

#include "actio/any_group/chart_map.hpp"
#include "actio/any_group/named_algebra.hpp"
#include "actio/formula/parse_formula.hpp"

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

/// The point with a velocity and a vector.
inline systems::ReducedPoint point_at(systems::ReducedSystem const& system, std::vector<double> const& v,
                                      std::vector<double> const& a = {}) {
  return {systems::LegendreVelocity(system).momentum(v, a), a};
}

}  // namespace actio
