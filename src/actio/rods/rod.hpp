// A rod in motion: the discrete field equations of chapter 10, reduced by the motions of space.
#pragma once

#include <optional>

#include "actio/numbers/errors.hpp"
#include "actio/rods/rod_shape.hpp"
#include "actio/rods/rod_steps.hpp"

namespace actio::rods {

/// A step that a rod cannot take; the state is that before it.
struct RodStepFails : Error {
  using Error::Error;
};

/// How a rod begins.
struct RodStart {
  RodShape shape;                               ///< where it is
  std::vector<Three<double>> velocity;          ///< of sections, length/time; empty: at rest
  std::vector<Three<double>> angular_velocity;  ///< of sections, in their axes, 1/time; empty: at rest
};

/// A rod at one time.
struct RodFrame {
  std::vector<Three<double>> places;           ///< of sections, length
  std::vector<Four<double>> attitudes;         ///< of sections, unit quaternions
  std::vector<Three<double>> velocities;       ///< of sections, length/time
  std::vector<Three<double>> body_momenta;     ///< angular momenta of sections, in their axes
  std::vector<ElementStrain<double>> strains;  ///< of elements, less those at rest
  std::vector<Three<double>> contact_force;    ///< of elements on the section before, in space
  std::vector<Three<double>> contact_moment;   ///< the same about the middle of the element, in space
};

/// Energies of a rod.
struct RodEnergies {
  double kinetic,  ///< of places and turns
      strain,      ///< \f$\sum_aD_a(\langle C_N\Gamma,\Gamma\rangle+\langle C_M\kappa,\kappa\rangle)/2\f$
      gravity;     ///< \f$-\sum_am_a\langle g,x_a\rangle\f$
};

/// A rod.
///
/// \snippet bodies.cpp rod
/// The scheme has order 2 in step and length of elements. It keeps linear and angular momentum to rounding
/// where nothing acts from outside; the energy oscillates with the square of the step.
class Rod {
 public:
  /// @param rest   the shape without stresses
  /// @throws OutsideDomain  where something is out of bounds, or the step is longer than
  ///                        \ref longest_rod_step
  Rod(RodSection const& section, RodShape const& rest, RodStart const& start, RodLoads const& loads,
      RodOptions const& options);

  /// So many steps on. What loads and supports throw goes on to the caller; the state is that before that
  /// step.
  /// @throws RodStepFails  where an element would turn by more than a right angle, a section turns too far in
  ///                       a step, or numbers are finite no more; the state is that before that step
  void step(long count = 1);
  /// Until the next step, what is told is told of so long after the last step. Zero: of the last step.
  void look_ahead(double time);
  /// One step of another length, if that is positive, and from then on steps of a third.
  /// @param made  how many of these there are since the start then
  void change_step(double first, double step, long made);

  double time() const { return static_cast<double>(steps_) * step_; }          ///< of the last step
  long steps() const { return steps_; }                                        ///< since the start
  RodSection const& section() const { return steps_of_.constants().section; }  ///< of it
  RodConstants const& constants() const { return steps_of_.constants(); }      ///< what does not change
  std::size_t sections() const { return state_.sections; }                     ///< how many
  std::size_t elements() const { return constants().elements; }                ///< how many
  RodFrame
  frame();  ///< as it is now: momenta between those of two steps, as a trial of the next one has them
  RodEnergies energies(RodFrame const& frame) const;        ///< of a frame of it
  Impulse momentum() const;                                 ///< at the end of the last step
  Impulse const& impulse() const { return now().impulse; }  ///< by loads, supports and gravity so far
  /// Largest component of \f$\Gamma-\Gamma_0\f$, of a rod that has multipliers.
  double constraint_residual();

  /// All that the next step depends on.
  std::vector<double> remember() const;
  void restore(std::vector<double> const& state);  ///< \copydoc remember

 private:
  RodState const& now() const { return ahead_ ? *ahead_ : state_; }
  double time_now() const { return time() + (ahead_ ? ahead_time_ : 0); }
  /// Steps of one length, or why there are none.
  void advance(RodState& state, double step, double time);

  RodState state_;
  RodSteps steps_of_;
  double step_;
  long steps_ = 0;
  std::optional<RodState> ahead_;
  double ahead_time_ = 0;
};

}  // namespace actio::rods
