// Tides with a constant lag \cite murray_dermott_1999 on two bodies. Each of them raises a bulge on the
// other, which is carried ahead by the spin and turned back by gravity.
//
// With gamma_i the part across r of the rate at which body i turns against the orbit, omega_i - r x v/r^2,
// the torque on body i is along -gamma_i, of the size
//
//     (3/2) k_2 (3/(4 pi rho_i))^2 G m1^2 m2^2 sin(2 eps) / (R_i r^6),
//
// and proportional to gamma_i where that is smaller than the size times sqrt(6/(pi G rho_i))/I_3: a bulge
// does not jump where the spin passes the orbit. On the orbit acts r x (G_1 + G_2)/r^2, so that the momentum
// of the whole stays.
#pragma once

#include "actio/two_bodies/pair_steps.hpp"

namespace actio::bodies {

/// What the tide on a body depends on.
struct Tide {
  double love = 0;       ///< Love's number k_2
  double lag = 0;        ///< angle by which the bulge is ahead, rad
  double reference = 1;  ///< reference radius, length
  double density = 1;    ///< mass/length^3
};
/// The tides of both bodies as a kick that depends on velocities.
class Tides {
 public:
  /// @throws OutsideDomain  where a density or a reference radius is not positive, or a Love number negative
  Tides(Tide const& first, Tide const& second, ExtendedBody const& one, ExtendedBody const& two, double G);

  /// Half a step by the explicit midpoint rule, of order 2: only momenta change.
  void kick(PairState<double>& state, PairSetting<double> const& setting, double time) const;

 private:
  struct Rates {
    Three<double> force, torque_1, torque_2;
  };
  Rates rates(PairState<double> const& state, PairSetting<double> const& setting) const;

  Three<double> inertia_1_, inertia_2_;
  double size_1_, size_2_;  ///< of the torques, times r^6
  double slow_1_, slow_2_;  ///< rate over torque below which they are proportional
};

}  // namespace actio::bodies
