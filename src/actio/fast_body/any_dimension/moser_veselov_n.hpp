// The Moser-Veselov scheme on SO(n) at the cost of one square of a matrix a step, and one product for the
// attitude (thesis, section 5.2).
//
// The same scheme as in rigid_body/moser_veselov.hpp, which solves it by Newton in n(n-1)/2 unknowns. Here
// the unknown is the square of f - 1, and its equation is a fixed point (relative_motion_sweeps.hpp). For
// short steps the polynomial through the last few squares leaves so little to be done that one square settles
// a step; for longer ones sweeps continue until the defect is at rounding (stopping_rule.hpp). Where they do
// not contract, the general solver takes over, or for large n an accelerated iteration; where there is no
// solution, the step is refused.
//
//   FastMoserVeselov const scheme(inertia, h);
//   auto body = scheme.release(attitude, momentum);
//   for (...) scheme.step_with_attitude(body);         // or scheme.step(body): momentum alone
#pragma once

#include <Eigen/Core>

#include <atomic>

#include "actio/fast_body/any_dimension/anderson.hpp"
#include "actio/fast_body/any_dimension/fixed_point_step.hpp"
#include "actio/fast_body/any_dimension/largest_step_n.hpp"
#include "actio/fast_body/any_dimension/matrix_conditions.hpp"
#include "actio/rigid_body/moser_veselov.hpp"

namespace actio::bodies {

/// The Moser-Veselov scheme for one body in n dimensions and one step. One object serves many bodies, and
/// threads.
///
/// \snippet bodies.cpp moser_veselov_n
class FastMoserVeselov {
 public:
  using Group = SO<Eigen::Dynamic>;         ///< n at run time
  using Rotation = Element<Group, double>;  ///< of the attitude, and of the relative motion
  using BodyMomentum = Momentum<Group, double>;

  /// @param inertia  of the body
  /// @param step     h, time; negative steps go back in time
  /// @param sweeps   whether to stop at rounding, or beyond it for long runs
  /// @param machine  for which the copy of the code is taken that runs
  /// @throws NotFinite, OutsideDomain where the step is no number, or zero, or so far from the unit of
  ///   \f$\Lambda\f$ that \f$\Lambda/h\f$ is no number
  FastMoserVeselov(Inertia<Eigen::Dynamic> inertia, double step, Sweeps sweeps = Sweeps::to_rounding,
                   Machine machine = best_machine());

  Inertia<Eigen::Dynamic> const& inertia() const { return inertia_; }
  double step() const { return step_; }

  /// A body that is let go with attitude g and body momentum `pi`.
  /// @throws NotFinite, OutsideDomain  where an entry is no number, a size is not n, or g is no rotation
  RotatingBody release(Rotation const& g, BodyMomentum const& pi) const;
  /// The same with the attitude 1.
  RotatingBody release(BodyMomentum const& pi) const { return release(identity<double>(inertia_.group), pi); }

  /// One step of the momentum alone; the attitude is not updated.
  /// Accuracy: the relative motion is a rotation to \f$\epsilon|f-1|\f$ in the norm of Frobenius, and the
  /// momentum is transported by it to the rounding of the square.
  /// @throws StepTooLong   where there is no solution, with the largest step that would do; the body is as it
  ///                       was
  /// @throws NotConverged  where there is one that could not be found; the body is as it was
  void step(RotatingBody& body) const { advance(body, false); }
  /// One step of momentum and attitude, \f$g_1 = g_0f^{-1}\f$. Throws what \ref step throws.
  void step_with_attitude(RotatingBody& body) const { advance(body, true); }

  /// The relative motion \f$f = g_1^Tg_0\f$ of the last step of a body under this scheme, from its square and
  /// the momentum; the identity before the first.
  Rotation last_relative_motion(RotatingBody const& body) const;

  /// The largest step for which a motion with body momentum `pi` exists. Infinite at rest. For n in the
  /// hundreds it takes seconds.
  double longest_step(BodyMomentum const& pi) const {
    return shape_.n <= 48 ? largest_step(inertia_, pi) : largest_step_n(inertia_, pi);
  }

 private:
  static constexpr int largest_for_newton = 24;  ///< 276 unknowns

  /// The plane (i, j), i > j.
  void set_plane(int i, int j);

  void advance(RotatingBody& body, bool with_attitude) const;

  /// The square of a long step, from the general solver, which follows the solution from the identity.
  void by_newton(detail::FixedPointStep const& s) const;

  /// The same for large n: the fixed point from G = 0, with Anderson's acceleration.
  void by_mixing(detail::FixedPointStep const& s) const;

  /// @throws StepTooLong  where the step has no solution for this momentum
  void refuse_beyond(RotatingBody const& body) const {
    if (rule_.any_negative) return;
    double const longest = longest_step(body.momentum());
    if (std::abs(step_) > longest) throw StepTooLong("Moser-Veselov", std::abs(step_), longest);
  }

  /// Whether any two eigenvalues of \f$f^T\Lambda\f$ have a sum with positive real part, f = 1 + e.
  bool on_branch_of_identity(detail::FixedPointStep const& s) const;

  static unsigned long next_id() {
    static std::atomic<unsigned long> count{0};
    return ++count;
  }

  Inertia<Eigen::Dynamic> inertia_;
  double step_;
  detail::Blocked<0> shape_;
  detail::Zeros lambda_, inverse_;  // Lambda/h and h/(Lambda_i + Lambda_j)
  detail::StoppingRule rule_{};
  bool (*carry_out_)(detail::FixedPointStep const&, detail::Stage, int);
  unsigned long id_ = next_id();
};

}  // namespace actio::bodies
