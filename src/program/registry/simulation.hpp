// A system that is ready to run: how it moves, and what can be told of it.
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "program/base/checkpoint_stream.hpp"
#include "program/base/error.hpp"
#include "program/registry/quantity.hpp"
#include "program/registry/snapshots.hpp"

namespace actio::scene {

/// How far two states of a system are apart.
struct StateDistance {
  double attitude = 0,      ///< the angle of the rotation from one to the other, radians; of configurations
                            ///< that are no attitudes a relative distance
      momentum = 0,         ///< the modulus of the difference of the momenta
      modulus = 0,          ///< of the first momentum
      vectors = 0,          ///< the length of the difference of all carried vectors
      vectors_modulus = 0;  ///< of those of the first state
};

/// How the state of a system moves on. One of the two is overridden: steps, or any time at once.
class Motion {
 public:
  virtual ~Motion() = default;
  /// So many steps.
  /// @throws StepTooLong, NotConverged, NotFinite  the state is then as it was at the last step that was made
  virtual void advance(long steps) { (void)steps; }
  /// To this time, whatever the time before.
  virtual void go_to(double time) { (void)time; }
  /// Until the next step, quantities are those of the state so long after the last step, which one shorter
  /// step of the same scheme reaches. The steps themselves go on from the last one. Zero: of the last step
  /// again.
  /// @param time  from zero up to the length of a step
  /// @throws what `advance` throws
  virtual void look_ahead(double time) { (void)time; }
  /// How far the state is from that of another motion of the same system, the attitude only where both
  /// reconstruct it.
  virtual StateDistance distance(Motion const& other) const {
    (void)other;
    return {};
  }
  /// One step of another length, and from then on steps of a third one.
  /// @param first  the length of the one step, at most that of a step so far; zero: there is none
  /// @param step   the length of those that follow
  /// @param made   how many of these there are since the start then: the product is the time
  /// @throws what `advance` throws
  virtual void change_step(double first, double step, long made) { (void)first, (void)step, (void)made; }
  /// Saves, or restores, all that the next step depends on. A motion that goes to any time at once has
  /// nothing to remember.
  virtual void remember(CheckpointStream& stream) { (void)stream; }
  /// Saves the state, of which `hash` in summary.json is made: two motions in the same state save the same,
  /// in any process.
  virtual void save_state(CheckpointStream& stream) { remember(stream); }
};

/// Motions beside that of the run, from which its error is estimated.
struct Companion {
  std::unique_ptr<Motion> motion;  ///< null: there is none
  /// of the run to one of the companion; 0: the companion is exact, and goes to any time at once
  long steps = 4;
  int order = 2;         ///< of the method
  bool attitude = true;  ///< whether the attitude is reconstructed
  /// in words, for the reader of the estimate; where there is no companion: why not
  std::string how;
  /// a third motion, with steps that are longer still, whose distance tells whether that of the companion is
  /// what the order says; null: nothing contradicts the companion
  std::unique_ptr<Motion> control = nullptr;
  long control_steps = 0;                 ///< of the run to one of the control: a multiple of `steps`
  std::string turn = "attitude";          ///< what `StateDistance::attitude` is the distance of
  std::string unit = " rad";              ///< of that distance
  std::string momentum = "momentum";      ///< what `StateDistance::momentum` is the distance of
  bool vectors = false;                   ///< whether vectors are carried
  std::vector<std::string> without = {};  ///< quantities that are asked for, and of which no error is told
  bool exact = false;  ///< whether the run has no error but that of rounding, and needs no companion
};

/// A system that is ready to run. Its quantities look at its motion, and were asked for.
struct Simulation {
  /// Of a system with these quantities.
  explicit Simulation(std::vector<Quantity> known) : quantities(std::move(known)) {}

  std::unique_ptr<Motion> motion;                          ///< how its state moves on
  QuantityGraph quantities;                                ///< what can be told of it
  bool exact = false;                                      ///< goes to any time at once, and has no steps
  double step = std::numeric_limits<double>::quiet_NaN();  ///< time; of a method with steps
  double work = 1;  ///< that a step takes, in a unit that all orders of the method have in common
  /// so many take a few milliseconds: how often the clock is looked at. Never a matter of the load of the
  /// machine, since the digits may depend on it
  long steps_at_once = 1 << 14;
  bool on_ranks = false;    ///< whether its state is shared among ranks, where there are several
  int shared_rows = 0;      ///< of nodes, or planes in space, that they share; 0: that is not told
  double bytes = 0;         ///< of memory that a run takes at most; 0: that is not told
  double shared_bytes = 0;  ///< of these, what ranks share
  double whole_bytes = 0;   ///< of these, what every rank has whole
  double part_bytes = 0;    ///< besides these, of which each rank has its part
  /// why it can take no step from its start, for instance since the step is too long; empty where it can
  std::string failure;
  Companion companion;                        ///< from which the error is estimated
  std::unique_ptr<SnapshotWriter> snapshots;  ///< null where the scene asks for none
  std::vector<std::string> shortcuts;         ///< what the scene allows to leave out, for the plan
  /// what was done to the input, for instance a quaternion normalised
  std::vector<std::string> remarks;
};

}  // namespace actio::scene
