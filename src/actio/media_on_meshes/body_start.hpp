// A body at the start, how its time is stepped, and what it has: energies, and cells that must not turn
// inside out.
#pragma once

#include <cmath>
#include <functional>

#include "actio/meshes/body_mesh.hpp"

namespace actio::media {

/// A cell of a body that would turn inside out: the state is that before the step which would do it.
struct BodyCellInverts : OutsideDomain {
  int cell;             ///< which
  long step;            ///< the number of the step that would do it, from 1; 0 at the start
  double time_step;     ///< its length
  double would_do;      ///< a step from there that turns nothing inside out; 0 where none was found
  double largest_step;  ///< the longest step for which small motions about the state before are stable
  /// What was tried, and what is known of it.
  struct Step {
    long number = 0;     ///< from 1; 0: the start
    double length = 0;   ///< of it
    double before = 0;   ///< the least Jacobian of the cell before it
    double shorter = 0;  ///< \ref would_do
    double longest = 0;  ///< \ref largest_step
  };
  /// @param name      of the cell, for messages: `BodyMesh::cell_name`
  /// @param jacobian  at the worst point of the cell
  BodyCellInverts(int which, std::string const& name, double jacobian, Step const& tried);

 private:
  static std::string where(std::string const& name, Step const& tried);
};

/// A step that conserves energy whose equations were not solved: the state is that before the step.
struct BodyStepUnsolved : Error {
  double residual;  ///< by how much places are off, length; no finite number where forces are none
  double bound;     ///< what it had to come under
  int cell;         ///< the one with the least Jacobian in the state before
  double jacobian;  ///< of it
  double would_do;  ///< a step from there that is solved; 0 where none was found
  /// What was tried, a `BodyCellInverts::Step`, with the least Jacobian of all before it.
  /// @param rounds  of the iteration
  /// @param which, name  of the cell with the least Jacobian before
  BodyStepUnsolved(std::size_t rounds, double off, double allowed, int which, std::string const& name,
                   BodyCellInverts::Step const& tried);
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

  /// The substeps as fractions of a step: one, or for order 4 five in a palindrome.
  std::vector<double> substeps() const {
    if (order == 2) return {1};
    double const outer = 1 / (4 - std::cbrt(4.0));
    return {outer, outer, 1 - 4 * outer, outer, outer};
  }
  /// @throws OutsideDomain, NotFinite  where there is no such step
  void examine() const;
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

}  // namespace actio::media
