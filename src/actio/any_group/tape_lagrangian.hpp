// A Lagrangian given as a formula, as a callable on velocities: what the generic implementation takes.
#pragma once

#include <memory>

#include "actio/any_group/reduced_system.hpp"
#include "actio/groups/group.hpp"

namespace actio::systems {

/// l(v) of a system without carried vectors, at every scalar. A copy has its own work space for each call.
struct TapeLagrangian {
  std::shared_ptr<ReducedSystem const> system;  ///< whose Lagrangian it is

  /// Energy, at a velocity of a group with the coordinates of the system.
  template <Group G, Scalar S>
  S operator()(Velocity<G, S> const& v) const {
    thread_local std::vector<S> work;
    S value(0);
    std::vector<S> inputs(v.coordinates.data(), v.coordinates.data() + v.coordinates.size());
    system->lagrangian(inputs.data(), &value, work);
    return value;
  }
};

}  // namespace actio::systems
