// Steps of the state of a rod: what a rod does, without its clock.
#pragma once

#include "actio/numbers/registers.hpp"
#include "actio/rods/rod_arrays.hpp"
#include "actio/rods/rod_ends.hpp"
#include "actio/rods/stretch_matrix.hpp"

namespace actio::rods {

/// How a rod is computed.
struct RodOptions {
  double step;                             ///< h, time
  bool unshearable = false;                ///< whether stretch and shear stay at those at rest
  int threads = 1;                         ///< that share the sections; no bit depends on it
  Registers registers = best_registers();  ///< for which the sweeps are compiled
};

/// What steps the states of one rod.
class RodSteps {
 public:
  /// @param state  of the rod, for its size
  RodSteps(RodConstants constants, RodLoads loads, RodOptions const& options, RodState const& state);

  /// Steps of one length. The first kick is of the mean of this and of `state.step_before`.
  /// @param time  of the state
  /// @return      whether they were made; if not, the state has no meaning
  bool advance(RodState& state, double step, long count, double time);
  /// Why a step from a state is none, for who reads it.
  std::string failure(RodState const& state, double step, double time);
  /// How far elements are from their strain at rest, relative to their length: the largest component.
  double stretched(RodState const& state) const;

  RodConstants const& constants() const { return constants_; }  ///< what does not change
  RodLoads const& loads() const { return loads_; }              ///< what acts from outside
  RodOptions const& options() const { return options_; }        ///< how it is computed
  RodForces const& forces() const { return forces_; }  ///< of elements in the last step that was tried

 private:
  bool advance_free(RodState& state, double step, long count, double time);
  bool advance_unshearable(RodState& state, double step, double time);
  /// What acts on the start, or on the end, joins the forces there.
  void add_load(RodState const& state, bool last, double time);
  /// Forces of the last element of a ring act on its first section.
  void close();
  /// Impulses by gravity and loads, over a kick.
  Impulse impulse_of_loads(RodState const& state, double kick, double time) const;
  /// Puts an end that is held where it is to be.
  /// @return  the impulse of what holds it
  Impulse hold(bool last, RodState const& from, double kick, double step, double time, RodState& to) const;

  RodConstants constants_;
  RodLoads loads_;
  RodOptions options_;
  RodState trial_;
  RodForces forces_;
  Rows<3> excess_;
  StretchMatrix stretches_;
};

}  // namespace actio::rods
