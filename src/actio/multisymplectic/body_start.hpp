// A body at the start, how its time is stepped, and what it has: energies, and cells that must not turn
// inside out.
#pragma once

#include <functional>

#include "actio/multisymplectic/body_mesh.hpp"

namespace actio {

/// A cell of a body that would turn inside out: the state is that before the step which would do it.
struct BodyCellInverts : OutsideDomain {
  int cell;             ///< which
  long step;            ///< the number of the step that would do it, from 1; 0 at the start
  double time_step;     ///< its length
  double would_do;      ///< a step from there that turns nothing inside out; 0 where none was found
  double largest_step;  ///< the longest step for which small motions about the state before are stable
  /// @param which, jacobian, step_number, dt, less, largest  as above; J at the worst point of the cell
  BodyCellInverts(int which, double jacobian, long step_number, double dt, double less, double largest)
      : OutsideDomain(where(which, step_number, dt, less, largest),
                      "the Jacobian at its corners must be positive", jacobian, 0),
        cell(which),
        step(step_number),
        time_step(dt),
        would_do(less),
        largest_step(largest) {}

 private:
  static std::string where(int which, long step_number, double dt, double less, double largest) {
    std::string const cell = "cell " + std::to_string(which);
    if (step_number == 0) return "medium: " + cell + " is inside out at the start";
    return "medium: step " + std::to_string(step_number) + " of length " + show(dt) + " would turn " + cell +
           " inside out (" +
           (less > 0 ? "a step of " + show(less) + " would not" : "and so would any shorter one") +
           "; the longest stable step before it is " + show(largest) + ")";
  }
};

/// What a step keeps beside momenta.
enum class Conserve {
  form,   ///< the multisymplectic form: explicit; the energy oscillates
  energy  ///< energy: implicit, by a discrete gradient; the form is given up
};

/// The coefficients of von Neumann and Richtmyer's viscosity (artificial_viscosity.hpp); without it both are
/// 0.
struct ArtificialViscosity {
  double linear = 0;  ///< of the speed of sound; about 1/2 damps what follows a shock
  /// of the jump of the velocity over a cell; about 2 spreads a shock over three cells
  double quadratic = 0;
  /// Whether there is one.
  bool any() const { return linear != 0 || quadratic != 0; }
};

/// How time is stepped.
struct BodyStepping {
  double step;                         ///< length of a step
  int order = 2;                       ///< 2, or 4 by five substeps (Suzuki)
  Conserve conserve = Conserve::form;  ///< what it keeps
  ArtificialViscosity viscosity = {};  ///< with order 2 and `form` alone
};

/// A body at the start.
template <int d>
struct BodyStart {
  using Place = std::array<double, d>;  ///< a point of the body, of space, or a velocity
  /// Mass per reference volume at X.
  std::function<double(Place const&)> density = [](Place const&) { return 1.0; };
  /// \f$X\mapsto\phi(X)\f$, length. In a periodic box \f$\phi(X)-X\f$ is periodic.
  std::function<Place(Place const&)> placement = [](Place const& X) { return X; };
  /// \f$X\mapsto\dot\phi(X)\f$, length/time.
  std::function<Place(Place const&)> velocity = [](Place const&) { return Place{}; };
};

/// Energies of a body.
struct BodyEnergies {
  double kinetic;  ///< \f$\tfrac12\sum m|v|^2\f$
  double stored;   ///< of the medium
  double loads;    ///< potentials, dead loads, outside pressure times volume
  /// All of them. With `conserve = form` it oscillates with the square of the step; it is kept where no side
  /// is moved and no pressure follows.
  double total() const { return kinetic + stored + loads; }
};

}  // namespace actio
