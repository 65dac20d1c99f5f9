// Two rigid bodies that attract each other, stepped.
//
//     TwoBodies pair(ellipsoid_body(m1, {400, 395, 340}, 4), ellipsoid_body(m2, {85, 73, 63}, 4), start,
//                    {.order = 4, .step = 1200});
//     pair.step(100);
//
// The state is that of T*(SE(3) x SE(3)) with the barycentre at rest: the position of the second body from
// the first, their relative momentum, both attitudes, both body momenta. Sums are compensated, so that the
// momentum of the whole is constant to rounding over very many steps.
#pragma once

#include <optional>
#include <variant>

#include "actio/fast_body/space/free_body.hpp"
#include "actio/two_bodies/fourth_order_force.hpp"
#include "actio/two_bodies/pair_tangent.hpp"
#include "actio/two_bodies/third_body.hpp"
#include "actio/two_bodies/tides.hpp"

namespace actio::bodies {

/// Two bodies at one time. Axes of a body are those of the frame in which it was given.
struct TwoBodyState {
  Eigen::Vector3d
      position;  ///< from the centre of mass of the first body to that of the second, in space; length
  Eigen::Vector3d momentum;  ///< reduced mass times velocity, in space; mass x length/time
  FreeState first;           ///< body momentum and attitude of the first body
  FreeState second;          ///< body momentum and attitude of the second body
};

/// What is asked of a motion of two bodies.
struct TwoBodyOptions {
  int order = 2;                           ///< N of the mutual potential
  double step = 0;                         ///< time, not zero; negative steps go back in time
  PairMethod method = kepler_splitting();  ///< how steps are made
  double G = 6.67430e-11;                  ///< constant of gravitation, m^3/(kg s^2), CODATA 2018
  double start = 0;                        ///< time at the start
  std::optional<ThirdBody> third{};        ///< which moves as it would without the extent of the two
  std::optional<std::array<Tide, 2>>
      tides{};  ///< on the first and on the second body: half a kick before and
                ///< after each step, of order 2
};

namespace detail {
struct SideBySide;
}

/// Two rigid bodies under their mutual gravity.
class TwoBodies {
 public:
  /// @throws NotFinite, OutsideDomain where a number is none, the step zero, the order negative or above that
  ///         of the moments, a quaternion not near unit length, or the bodies so near to each other that the
  ///         series of the potential need not converge: the sum of their radii over the distance is 1 or more
  TwoBodies(ExtendedBody first, ExtendedBody second, TwoBodyState const& start, TwoBodyOptions options);

  /// So many steps.
  /// @throws OutsideDomain  where the count is negative, or on the way the bodies come too near to each
  ///                        other; the state is the one before then. The way is that of the drifts, from end
  ///                        to end: no step is so long that a passage between its ends is missed
  /// @throws NotFinite, NotConverged  where the motion has no numbers any more
  void step(long count = 1);
  /// The state now.
  TwoBodyState state() const;
  /// The time reached.
  double time() const { return options_.start + static_cast<double>(steps_) * options_.step; }

  /// The first body.
  ExtendedBody const& first() const { return first_; }
  /// The second body.
  ExtendedBody const& second() const { return second_; }
  /// What was asked of the motion.
  TwoBodyOptions const& options() const { return options_; }
  /// \f$m_1m_2/(m_1+m_2)\f$.
  double reduced_mass() const { return setting_.reduced_mass; }

  /// Kinetic and potential energy; a third body is not in it.
  double energy() const;
  /// V, to the order of the motion.
  double potential() const;
  /// The angular momentum about the barycentre, in space: \f$X\times P+R_1M_1+R_2M_2\f$.
  Eigen::Vector3d angular_momentum() const;
  /// The sum of the radii over the distance: the terms of the potential beyond its order are
  /// powers of it.
  double nearness() const;

  /// How the state after so many steps from now changes with the state now, by dual numbers; the pair stays
  /// where it is. The six parts of a tangent vector are those of position, momentum, and of each body its
  /// turn \f$q\to q\,e^{\theta/2}\f$ and its momentum, both in the axes of the body.
  /// @throws OutsideDomain  where there are tides
  /// Accuracy: that of the steps; the map is symplectic to rounding.
  Eigen::Matrix<double, 18, 18> tangent_map(long count) const;
  /// What the parts of a tangent vector are measured in, so that all count alike: length, momentum and rate
  /// of the orbit as it is now, radians, and the largest moment of inertia times that rate.
  PairTangent tangent_units() const;
  /// \f$\frac1t\log|\delta(t)|/|\delta(0)|\f$ of one tangent vector over so many steps from now, 1/time, in
  /// these units: it falls as log(t)/t where the motion is regular, and tends to the largest Lyapunov
  /// exponent where it is chaotic.
  /// @param every  steps after which the vector is made as long as one again
  double lyapunov_exponent(long count, long every = 16) const;

  /// Saves, or restores, what the next step depends on besides bodies and options.
  template <class Memory>
  void remember(Memory& memory) {
    memory(state_, terms_1_, terms_2_, steps_);
  }

 private:
  friend struct detail::SideBySide;
  using Force =
      std::variant<SecondOrderForce<>, FourthOrderForce<true>, FourthOrderForce<false>, AnyOrderForce<>>;

  void require_apart(char const* when, double nearest = HUGE_VAL) const;
  Kick<double> interaction() const;
  double take(long count);  // the least distance on the way
  PairState<Dual<double>> moved(PairState<Dual<double>> const& from, long first, long count) const;
  /// The kernel of so many steps from a state, the first of which begins after so many others.
  template <class T, class F>
  detail::PairSteps<T, F> kernel(F const& force, long first, long count, PairState<T> const& state,
                                 int terms_1, int terms_2) const {
    auto const& method = options_.method;
    auto const& kicks = method.splitting.kicks;
    double const h = options_.step;
    return {setting_,
            method.kepler,
            method.rotor == Rotor::moser_veselov,
            stages_,
            kicks.front() * h,
            kicks.back() * h,
            force,
            h,
            options_.start,
            first,
            count,
            state,
            terms_1,
            terms_2};
  }

  ExtendedBody first_, second_;
  TwoBodyOptions options_;
  PairSetting<double> setting_;
  Force force_;
  std::vector<PairStage<double>> stages_;
  std::optional<ThirdBodyForce> third_;
  std::optional<Tides> tides_;
  PairState<double> state_;
  int terms_1_ = 5, terms_2_ = 5;
  long steps_ = 0;
};

/// The state of given velocities.
/// @param velocity  of the second body from the first, in space
/// @param attitude_1,attitude_2  unit quaternions, bodies to space
/// @param omega_1,omega_2  angular velocities, each in the axes of its body
TwoBodyState state_of_velocities(ExtendedBody const& first, ExtendedBody const& second,
                                 Eigen::Vector3d const& position, Eigen::Vector3d const& velocity,
                                 Element<SU2, double> const& attitude_1, Eigen::Vector3d const& omega_1,
                                 Element<SU2, double> const& attitude_2, Eigen::Vector3d const& omega_2);

}  // namespace actio::bodies
