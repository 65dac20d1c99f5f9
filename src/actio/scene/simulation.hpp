// A system that is ready to run: how it moves, and what can be told of it.
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "actio/scene/memory.hpp"
#include "actio/scene/quantity.hpp"
#include "actio/scene/scene_error.hpp"

namespace actio::scene {

/// How the state of a system moves on. One of the two is overridden: steps, or any time at once.
class Motion {
 public:
  virtual ~Motion() = default;
  /// So many steps.
  /// @throws StepTooLong, NotConverged, NotFinite  the state is then as it was at the last step that was made
  virtual void advance(long steps) { (void)steps; }
  /// To this time, whatever the time before.
  virtual void go_to(double time) { (void)time; }
  /// Saves, or restores, all that the next step depends on. A motion that goes to any time at once has nothing to remember.
  virtual void remember(Memory& memory) { (void)memory; }
};

/// A system that is ready to run. Its quantities look at its motion, and were asked for.
struct Simulation {
  /// Of a system with these quantities.
  explicit Simulation(std::vector<Quantity> known) : quantities(std::move(known)) {}

  std::unique_ptr<Motion> motion;                ///< how its state moves on
  QuantityGraph quantities;                      ///< what can be told of it
  bool exact = false;                            ///< goes to any time at once, and has no steps
  double step = std::numeric_limits<double>::quiet_NaN();  ///< time; of a method with steps
  long steps_at_once = 1 << 14;                  ///< so many take a few milliseconds: how often the clock is looked at. Never a matter of the load of the machine, since the digits may depend on it
  std::string failure;                           ///< why it can take no step from its start, for instance since the step is too long; empty where it can
  std::vector<std::string> shortcuts;            ///< what the scene allows to leave out, for the plan
  std::vector<std::string> remarks;              ///< what was done to the input, for instance a quaternion normalised
};

}  // namespace actio::scene
