// Friction that keeps a part of the structure: damping in proportion to the momentum, and friction that turns
// the momentum on its coadjoint orbit.
//
// Damping multiplies the bracket and every Casimir by a power of the decay. Of a Lagrangian that is quadratic
// in the velocity, without vectors, the damped motion runs along the free one: over the time h the free
// motion goes on by (1 - e^-ch)/c, and the momentum decays by e^-ch. Friction on the orbit (Bloch,
// Krishnaprasad, Marsden and Ratiu) conserves every Casimir, and takes energy at the rate of the square of
// ad*_v p.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace actio::systems {

struct ReducedSystem;

/// Friction of a system.
struct Dissipation {
  /// How the momentum changes by it.
  enum class Kind {
    conformal,  ///< at the rate \f$-c\,p\f$
    orbit  ///< at the rate \f$\mathrm{ad}^*_\theta\,p\f$ with \f$\theta = c\,(\mathrm{ad}^*_vp)^\sharp\f$
  };
  Kind kind;    ///< of the friction
  double rate;  ///< c: 1/time (conformal); 1/energy, in units of the metric (orbit)
  /// \f$p\mapsto p^\sharp\f$, the inverse of the matrix of a metric on the algebra; of friction on the orbit
  Eigen::MatrixXd sharp = {};

  /// \f$(1 - e^{-ch})/c\f$: how far the free motion goes over a time h.
  double free_time(double h) const;
};

/// Whether the damped motion of a system runs along its free motion: no carried vectors, and a Lagrangian
/// that is a quadratic form of the velocity.
bool damps_along_free_motion(ReducedSystem const& system);

/// Moves a momentum by the friction on its orbit alone, for a time h of either sign:
/// \f$p_1 = \mathrm{Ad}^*_{e^{h\theta}}\,p_0\f$ with \f$\theta\f$ in the middle of the turn. Symmetric, of
/// order 2; it conserves Casimirs to rounding, and for \f$h>0\f$ the energy of a quadratic Lagrangian falls.
/// @param near  a velocity near that of the momentum, after which it is that of the middle
/// @throws NotConverged  where the friction turns too far in a step
void turn_by_friction(ReducedSystem const& system, double h, std::vector<double>& p,
                      std::vector<double>& near);

}  // namespace actio::systems
