#include <Eigen/Core>

#include "program/systems/lagrangians/shape_input.hpp"

#include <fmt/format.h>

#include "actio/any_group/named_algebra.hpp"
#include "program/systems/formula.hpp"

namespace actio::scene {

systems::MatrixAlgebra ShapeVariables::beside(std::string const& group) const {
  auto const own = systems::named_algebra(group).components;
  systems::MatrixAlgebra algebra = systems::named_algebra(fmt::format("R^{} x ({})", names.size(), group));
  algebra.components.clear();
  for (auto const& name : names) algebra.components.push_back(name + "_rate");
  algebra.components.insert(algebra.components.end(), own.begin(), own.end());
  return algebra;
}

Eigen::VectorXd ShapeVariables::carried(systems::MatrixAlgebra const& algebra, systems::Side side) const {
  auto const m = static_cast<Eigen::Index>(start.size());
  Eigen::VectorXd out = Eigen::VectorXd::Zero(algebra.size);
  out.head(m) = Eigen::Map<Eigen::VectorXd const>(start.data(), m);
  out[m] = side == systems::Side::left ? -1 : 1;
  return out;
}

std::vector<std::string> ShapeVariables::components(systems::MatrixAlgebra const& algebra) const {
  auto out = names;
  for (int k = static_cast<int>(names.size()) + 1; k <= algebra.size; ++k)
    out.push_back(fmt::format("shape__{}", k));
  return out;
}

ShapeVariables read_shape(SceneTable const& system) {
  ShapeVariables out;
  if (!shape_keys.shape.given(system)) return out;
  if (system.has("algebra"))
    shape_keys.shape.fail(system, "it goes with a named group, system.group; the scene has system.algebra");
  SceneTable const table = shape_keys.shape.table(system);
  out.names = table.keys();
  for (auto const& name : out.names) {
    require_formula_name(table, name, {}, "");
    out.start.push_back(table.number(name));
  }
  if (out.names.empty()) shape_keys.shape.fail(system, "at least one variable is expected, found none");
  if (out.names.size() > 16)
    shape_keys.shape.fail(system,
                          fmt::format("at most 16 variables are expected, found {}", out.names.size()));
  return out;
}

}  // namespace actio::scene
