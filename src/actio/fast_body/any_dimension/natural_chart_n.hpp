// The natural-chart scheme on SO(n), n at run time (thesis, section 5.1).
//
// The same scheme as in rigid_body/natural_chart_scheme.hpp, whose reduced discrete Lagrangian is l(f) = <J
// log f, log f>/2h: there by the general road, for a fixed n and any scalar, here by products of matrices
// (natural_chart_equation.hpp). A step finds the turn Z = h zeta with the momentum M0 at its beginning; with
// f = exp(-Z) the momentum after it is f M0 f^T, and the attitude g0 f^T. f is orthogonal to the rounding of
// f - 1, whatever is left in Z: so the spectrum of the momentum is conserved to rounding.
//
//   FastNaturalChart scheme(inertia, h);
//   auto body = scheme.release(attitude, momentum);
//   for (...) scheme.step_with_attitude(body);         // or scheme.step(body): momentum alone
#pragma once

#include "actio/fast_body/any_dimension/charted_body.hpp"
#include "actio/fast_body/any_dimension/matrix_conditions.hpp"
#include "actio/fast_body/any_dimension/relative_motion_sweeps.hpp"
#include "actio/fast_body/any_dimension/step_continuation.hpp"

namespace actio {

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
  FastNaturalChart(Inertia<Eigen::Dynamic> inertia, double step, Machine machine = best_machine())
      : inertia_(std::move(inertia)),
        step_(checked(step)),
        unit_(unit(inertia_)),
        algebra_(inertia_.group.n, machine),
        equation_(inertia_, unit_, algebra_),
        p_(algebra_.size()),
        z_(algebra_.size()),
        e_(algebra_.size()),
        room_(algebra_.size()),
        product_(algebra_.size()) {}

  Inertia<Eigen::Dynamic> const& inertia() const { return inertia_; }
  double step() const { return step_; }

  /// A body that is let go with attitude g and body momentum `pi`.
  /// @throws NotFinite, OutsideDomain  where an entry is no number, a size is not n, or g is no rotation
  ChartedBody release(Rotation const& g, BodyMomentum const& pi) const {
    detail::require_rotation(g.value, inertia_.group.n, "natural chart: attitude");
    if (pi.components.size() != inertia_.moments.size())
      throw OutsideDomain(
          "natural chart", "a momentum with a component for each moment of inertia is needed; components",
          static_cast<double>(pi.components.size()), static_cast<double>(inertia_.moments.size()));
    if (!is_finite(pi.components)) throw NotFinite("natural chart: body momentum");
    ChartedBody body(inertia_.group.n);
    body.set(ChartedBody::attitude_, g.value);
    body.set(ChartedBody::momentum_, inertia_.group.hat(pi.components));
    return body;
  }
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
  Rotation last_relative_motion(ChartedBody& body) {
    Rotation f = identity<double>(inertia_.group);
    if (body.past_ == 0) return f;
    equation_.subgroup().relative_motion(body.past(0), e_.data());
    for (int j = 0; j < body.size(); ++j)
      for (int i = 0; i < body.size(); ++i)
        f.value(i, j) += e_.data()[detail::full_entry(algebra_.shape(), i, j)];
    return f;
  }

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

  void advance(ChartedBody& body, bool with_attitude) {
    if (body.size() != inertia_.group.n)
      throw OutsideDomain("natural chart",
                          "a body in as many dimensions as there are Lambda is needed; dimensions",
                          body.size(), inertia_.group.n);
    if (body.step_ != step_) body.past_ = 0, body.contraction_ = 1, body.step_ = step_;
    std::copy(body.array(ChartedBody::momentum_), body.array(ChartedBody::momentum_rest_), p_.data());
    algebra_.scale(1 / unit_, p_.data()), algebra_.scale(step_, p_.data());
    if (!is_finite(algebra_.norm(p_.data())))
      throw NotFinite("natural chart: step times body momentum over inertia");
    solve(body);
    equation_.subgroup().relative_motion(z_.data(), e_.data());
    transport_momentum(body);
    if (with_attitude) {
      double* const attitude = body.array(ChartedBody::attitude_);
      algebra_.times_transposed(attitude, e_.data(), product_.data());
      detail::turn(algebra_.shape(), attitude, body.array(ChartedBody::attitude_rest_), product_.data());
    }
    remember(body);
  }

  /// Z from P.
  void solve(ChartedBody& body) {
    guess(body);
    if (equation_.by_sweeps(p_.data(), z_.data(), body.contraction_, slowest()) &&
        equation_.in_chart(z_.data())) {
      body.contraction_ = equation_.contraction(), body.sweeps_ = equation_.sweeps();
      return;
    }
    body.contraction_ = 1, body.sweeps_ = 0;
    if (inertia_.group.n <= largest_for_newton) {
      double const reached = detail::StepContinuation(equation_, p_.data()).follow(z_.data());
      if (reached < 1)
        throw StepTooLong("natural chart", std::abs(step_), std::abs(step_) * reached * (1 - 1e-6));
    } else {
      by_sweeps_from_rest();
    }
  }
  /// Where n is large and the guess was none.
  void by_sweeps_from_rest() {
    if (takes(1)) return;
    // Between a part that is taken and one that is not.
    equation_.guess(p_.data(), z_.data());
    double taken = 0, refused = std::min(1.0, 0.5 / algebra_.norm(z_.data()));
    while (refused < 1 && takes(refused)) taken = refused, refused = std::min(1.0, 2 * refused);
    for (int k = 0; k < halvings(); ++k) {
      double const middle = (taken + refused) / 2;
      (takes(middle) ? taken : refused) = middle;
    }
    // A little less, where rounding cannot decide.
    throw StepTooLong("natural chart", std::abs(step_), std::abs(step_) * taken * 0.98);
  }
  /// Whether a part of the step is taken by sweeps from the first guess.
  bool takes(double part) {
    std::copy(p_.data(), p_.data() + algebra_.size(), room_.data());
    algebra_.scale(part, room_.data());
    equation_.guess(room_.data(), z_.data());
    return equation_.by_sweeps(room_.data(), z_.data(), 1, slowest()) && equation_.in_chart(z_.data());
  }

  /// The extrapolation of the past rotation vectors, or the first guess of all.
  void guess(ChartedBody& body) {
    if (body.past_ == 0) return equation_.guess(p_.data(), z_.data());
    detail::Weights const& w = detail::all_extrapolations()[body.continuation_];
    std::fill(z_.data(), z_.data() + algebra_.size(), 0.0);
    for (int k = 0; k < w.length; ++k)
      algebra_.add(w.weight[static_cast<std::size_t>(k)], body.past(k), z_.data());
  }

  /// \f$M_1 = fM_0f^T = M_0 + eM_0 + M_0e^T + eM_0e^T\f$.
  void transport_momentum(ChartedBody& body) {
    double *const m = body.array(ChartedBody::momentum_), *const e = e_.data(), *const em = room_.data(),
                  *const eme = product_.data();
    // -e M0, and -e M0 e^T.
    algebra_.times_transposed(e, m, em);
    algebra_.times_transposed(em, e, eme);
    algebra_.subtract_transposed(em), algebra_.make_skew(eme);
    algebra_.add(1, eme, em), algebra_.scale(-1, em);
    detail::turn(algebra_.shape(), m, body.array(ChartedBody::momentum_rest_), em);
  }

  /// The rotation vector of this step becomes the latest of the past.
  void remember(ChartedBody& body) {
    body.latest_ = body.latest_ == 0 ? ChartedBody::longest - 1 : body.latest_ - 1;
    std::copy(z_.data(), z_.data() + algebra_.size(), body.past(0));
    ++body.steps_;
    bool const growing = body.past_ < ChartedBody::longest;
    if (growing) ++body.past_;
    if (growing || body.steps_ % 256 == 0) choose_extrapolation(body);
  }
  /// The shortest that would have made of the past twice what the best would have missed of the latest turn.
  void choose_extrapolation(ChartedBody& body) {
    std::vector<double> missed;
    double best = HUGE_VAL;
    for (detail::Weights const& w : detail::all_extrapolations()) {
      if (w.length >= body.past_) break;
      std::copy(body.past(0), body.past(0) + algebra_.size(), room_.data());
      for (int k = 0; k < w.length; ++k)
        algebra_.add(-w.weight[static_cast<std::size_t>(k)], body.past(k + 1), room_.data());
      missed.push_back(algebra_.norm(room_.data()));
      best = std::min(best, missed.back());
    }
    body.continuation_ = 0;
    while (body.continuation_ < missed.size() && missed[body.continuation_] > 2 * best) ++body.continuation_;
    if (missed.empty()) body.continuation_ = 0;
  }

  Inertia<Eigen::Dynamic> inertia_;
  double step_, unit_;
  detail::MatrixAlgebra algebra_;
  detail::NaturalChartEquation equation_;
  detail::Zeros p_, z_, e_, room_, product_;  // h M0 in the unit, Z, f - 1, and room to work in
};

}  // namespace actio
