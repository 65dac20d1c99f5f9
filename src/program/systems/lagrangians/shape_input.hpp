// Shape variables of a Lagrangian of one's own: [system.shape], coordinates beside the group, such as the
// angle of a wheel or the stretch of a spring.
//
// They are a carried vector of the group R^m x G: a = (x0 + x, 1 or -1, 0, ...) in the rows of R^m moves with
// x and with nothing else. So every part of the library takes them as it takes carried vectors.
#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "actio/any_group/reduced_system.hpp"
#include "program/document/key.hpp"

namespace actio::scene {

/// The key of the table.
struct ShapeKeys : KeyTable {
  AnyKey shape =
      key("shape", "a table by names of one's own", LeftOut{"none"},
          "Shape variables, with their values at the start, beside the group, which is then a named "
          "one: angle = 0.3 is a coordinate `angle` in the Lagrangian and in the force, and its rate "
          "`angle_rate` is a component of the velocity, before those of the group.",
          "{ angle = 0.3 }");
};
inline ShapeKeys const shape_keys{{"system"}};  ///< its key

/// Shape variables of a scene.
struct ShapeVariables {
  std::vector<std::string> names;  ///< in the order of the scene
  std::vector<double> start;       ///< their values at the start

  /// The group, with R^m before it, and with names of the components of the velocity.
  /// @param group  its name
  systems::MatrixAlgebra beside(std::string const& group) const;
  /// The carried vector that they are.
  Eigen::VectorXd carried(systems::MatrixAlgebra const& algebra, systems::Side side) const;
  /// Names of its components: theirs, and others for those that are constant.
  std::vector<std::string> components(systems::MatrixAlgebra const& algebra) const;
};

/// Those of a scene; empty where it has none.
/// @throws SceneError  where a name is none that a formula can have
ShapeVariables read_shape(SceneTable const& system);

}  // namespace actio::scene
