// The natural-chart scheme on SO(n), n at run time (thesis, section 5.1).
//
// The same scheme as in rigid_body/natural_chart_scheme.hpp, whose reduced discrete Lagrangian is l(f) = <J
// log f, log f>/2h: there by the generic implementation, for a fixed n and any scalar, here by products of
// matrices (natural_chart_equation.hpp). A step finds the turn Z = h zeta with the momentum M0 at its
// beginning; with f = exp(-Z) the momentum after it is f M0 f^T, and the attitude g0 f^T. f is orthogonal to
// the rounding of f - 1, whatever is left in Z: so the spectrum of the momentum is conserved to rounding.
//
//   FastNaturalChart scheme(inertia, h);
//   auto body = scheme.release(attitude, momentum);
//   for (...) scheme.step_with_attitude(body);         // or scheme.step(body): momentum alone
#pragma once

#include <Eigen/Core>

#include "actio/fast_body/any_dimension/charted_body.hpp"
#include "actio/fast_body/any_dimension/matrix_conditions.hpp"
#include "actio/fast_body/any_dimension/relative_motion_sweeps.hpp"
#include "actio/fast_body/any_dimension/step_continuation.hpp"

namespace actio::bodies {

/// The natural-chart scheme for one body in n dimensions and one step. One object serves many bodies, one
/// after the other.
class FastNaturalChart {
 public:
  using Group = SO<Eigen::Dynamic>;         ///< n at run time
  using Rotation = Element<Group, double>;  ///< of the attitude, and of the relative motion
  using BodyMomentum = Momentum<Group, double>;

  /// @param inertia  of the body
  /// @param step     h, time; negative steps go back in time
  /// @param machine  for which the copy of the code is taken that runs
  /// @throws NotFinite, OutsideDomain  where the step is no number, or zero
  FastNaturalChart(Inertia<Eigen::Dynamic> inertia, double step, Machine machine = best_machine());

  Inertia<Eigen::Dynamic> const& inertia() const { return inertia_; }
  double step() const { return step_; }

  /// A body that is let go with attitude g and body momentum `pi`.
  /// @throws NotFinite, OutsideDomain  where an entry is no number, a size is not n, or g is no rotation
  ChartedBody release(Rotation const& g, BodyMomentum const& pi) const;
  /// The same with the attitude 1.
  ChartedBody release(BodyMomentum const& pi) const { return release(identity<double>(inertia_.group), pi); }

  /// One step of the momentum alone; the attitude is not updated. \implements{eq_5_4}
  /// Accuracy: Z to its rounding where sweeps contract, and as well as the equation determines it elsewhere;
  /// the momentum is transported by f to the rounding of f - 1.
  /// @throws StepTooLong  where the branch of solutions that begins at rest ends before this step, or n is
  ///                      large and the solver ends there, with the largest step that would do; the body is
  ///                      as it was
  void step(ChartedBody& body) { advance(body, false); }
  /// One step of momentum and attitude, \f$g_1 = g_0f^{-1}\f$. Throws what \ref step throws.
  void step_with_attitude(ChartedBody& body) { advance(body, true); }

  /// The relative motion \f$f = g_1^Tg_0\f$ of the last step of a body under this scheme; the identity before
  /// the first.
  Rotation last_relative_motion(ChartedBody& body);

 private:
  static constexpr int largest_for_newton = 16;  ///< 120 unknowns

  /// The ratio of changes that still counts as contraction: where a sweep is a tenth of a second, a hundred
  /// of them are too many.
  double slowest() const { return inertia_.group.n <= 128 ? 0.9 : 0.5; }
  /// How often the part of a step between one that is taken and one that is not is halved.
  int halvings() const { return inertia_.group.n <= 128 ? 5 : 3; }

  static double checked(double step) {
    if (!is_finite(step)) throw NotFinite("natural chart: step");
    if (step == 0) throw OutsideDomain("natural chart", "the step must differ from zero", 0, 0);
    return step;
  }
  /// A power of two near the largest moment: dividing by it rounds nothing.
  static double unit(Inertia<Eigen::Dynamic> const& inertia) {
    int exponent = 0;
    std::frexp(magnitude(inertia.moments), &exponent);
    return std::ldexp(1.0, exponent);
  }

  void advance(ChartedBody& body, bool with_attitude);

  /// Z from P.
  void solve(ChartedBody& body);
  /// Where n is large and the guess was none.
  void by_sweeps_from_rest();
  /// Whether a part of the step is taken by sweeps from the first guess.
  bool takes(double part);

  /// The extrapolation of the past rotation vectors, or the first guess of all.
  void guess(ChartedBody& body);

  /// \f$M_1 = fM_0f^T = M_0 + eM_0 + M_0e^T + eM_0e^T\f$.
  void transport_momentum(ChartedBody& body);

  /// The rotation vector of this step becomes the latest of the past.
  void remember(ChartedBody& body);
  /// The shortest that would have made of the past twice what the best would have missed of the latest turn.
  void choose_extrapolation(ChartedBody& body);

  Inertia<Eigen::Dynamic> inertia_;
  double step_, unit_;
  detail::MatrixAlgebra algebra_;
  detail::NaturalChartEquation equation_;
  detail::Zeros p_, z_, e_, room_, product_;  // h M0 in the unit, Z, f - 1, and room to work in
};

}  // namespace actio::bodies
