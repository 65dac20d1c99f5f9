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

#include <atomic>

#include "actio/fast_body/any_dimension/anderson.hpp"
#include "actio/fast_body/any_dimension/fixed_point_step.hpp"
#include "actio/fast_body/any_dimension/largest_step_n.hpp"
#include "actio/fast_body/any_dimension/matrix_conditions.hpp"
#include "actio/rigid_body/moser_veselov.hpp"

namespace actio {

/// The Moser-Veselov scheme for one body in n dimensions and one step. One object serves many bodies, and
/// threads.
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
                   Machine machine = best_machine())
      : inertia_(std::move(inertia)),
        step_(step),
        shape_(inertia_.group.n),
        lambda_(4 * static_cast<std::size_t>(shape_.blocks())),
        inverse_(detail::half_size(shape_)) {
    if (!is_finite(step)) throw NotFinite("Moser-Veselov: step");
    if (step == 0) throw OutsideDomain("Moser-Veselov", "the step must differ from zero", 0, 0);
    rule_ = {sweeps, 0, inertia_.lambda.minCoeff() < 0};
    for (int j = 0; j < shape_.n; ++j) lambda_.data()[j] = inertia_.lambda[j] / step;
    for (int j = 0; j < shape_.n; ++j)
      for (int i = 0; i < j; ++i) set_plane(j, i);
    carry_out_ = detail::choose_step(shape_.n, machine);
  }

  Inertia<Eigen::Dynamic> const& inertia() const { return inertia_; }
  double step() const { return step_; }

  /// A body that is let go with attitude g and body momentum `pi`.
  /// @throws NotFinite, OutsideDomain  where an entry is no number, a size is not n, or g is no rotation
  RotatingBody release(Rotation const& g, BodyMomentum const& pi) const {
    detail::require_rotation(g.value, shape_.n, "Moser-Veselov: attitude");
    if (pi.components.size() != inertia_.moments.size())
      throw OutsideDomain(
          "Moser-Veselov", "a momentum with a component for each moment of inertia is needed; components",
          static_cast<double>(pi.components.size()), static_cast<double>(inertia_.moments.size()));
    if (!is_finite(pi.components)) throw NotFinite("Moser-Veselov: body momentum");
    RotatingBody body(shape_.n);
    body.set_attitude(g.value);
    body.set_momentum(inertia_.group.hat(pi.components));
    return body;
  }
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
  Rotation last_relative_motion(RotatingBody const& body) const {
    Rotation f = identity<double>(inertia_.group);
    if (body.past_ == 0) return f;
    double const *const square = body.past(0), *const momentum = body.half(RotatingBody::momentum_);
    for (int j = 0; j < shape_.n; ++j)
      for (int i = j; i < shape_.n; ++i) {
        std::ptrdiff_t const at = detail::half_entry(shape_, i, j);
        double const half = square[at] / 2, slope = lambda_.data()[j] - lambda_.data()[i];
        double const turn = inverse_.data()[at] * (momentum[at] - slope * half);
        f.value(i, j) -= half + turn;
        if (i != j) f.value(j, i) -= half - turn;
      }
    return f;
  }

  /// The largest step for which a motion with body momentum `pi` exists. Infinite at rest. For n in the
  /// hundreds it takes seconds.
  double longest_step(BodyMomentum const& pi) const {
    return shape_.n <= 48 ? largest_step(inertia_, pi) : largest_step_n(inertia_, pi);
  }

 private:
  static constexpr int largest_for_newton = 24;  ///< 276 unknowns

  /// The plane (i, j), i > j.
  void set_plane(int i, int j) {
    double const sum = lambda_.data()[i] + lambda_.data()[j], inverse = 1 / sum;
    if (!is_finite(sum) || !is_finite(inverse) || !(std::abs(sum) >= std::numeric_limits<double>::min()))
      throw NotFinite("Moser-Veselov: inertia over step");
    inverse_.data()[detail::half_entry(shape_, i, j)] = inverse;
    if (i / 4 == j / 4) inverse_.data()[detail::half_entry(shape_, j, i)] = inverse;
    double const a = inertia_.lambda[i] / (inertia_.lambda[i] + inertia_.lambda[j]), b = 1 - a;
    rule_.spread = std::max(rule_.spread, a * a + b * b);
  }

  void advance(RotatingBody& body, bool with_attitude) const {
    using detail::Stage;
    if (body.size() != shape_.n)
      throw OutsideDomain("Moser-Veselov",
                          "a body in as many dimensions as there are Lambda is needed; dimensions",
                          body.size(), shape_.n);
    detail::FixedPointStep const s{body, {lambda_.data(), inverse_.data()}, rule_};
    if (body.scheme_ == RotatingBody::next_scheme) body.scheme_ = id_;
    if (body.scheme_ != id_) carry_out_(s, Stage::prepare, shape_.n), body.scheme_ = id_;
    if (carry_out_(s, with_attitude ? Stage::step_with_attitude : Stage::step, shape_.n)) return;
    body.scheme_ = 0;  // should this fail too, the body is as it was and the next step begins anew
    if (!body.solved_ || !on_branch_of_identity(s)) {
      if (shape_.n <= largest_for_newton)
        by_newton(s);
      else
        by_mixing(s);
    }
    carry_out_(s, with_attitude ? Stage::finish_with_attitude : Stage::finish, shape_.n);
    body.scheme_ = id_;
  }

  /// The square of a long step, from the general solver, which follows the solution from the identity.
  void by_newton(detail::FixedPointStep const& s) const {
    auto f = MoserVeselov<Eigen::Dynamic>(inertia_, step_).relative_motion(s.body.momentum()).value;
    for (int j = 0; j < shape_.n; ++j)
      for (int i = 0; i < shape_.n; ++i)
        s.motion()[detail::full_entry(shape_, i, j)] = f.value(i, j) - (i == j);
    carry_out_(s, detail::Stage::square, shape_.n);
    s.body.sweeps_ = 1;
  }

  /// The same for large n: the fixed point from G = 0, with Anderson's acceleration.
  void by_mixing(detail::FixedPointStep const& s) const {
    std::vector<double> x(s.body.half_size_, 0.0), residual(x.size());
    std::vector<double> seen;
    Anderson anderson(8);
    constexpr int most = 400;
    double before = HUGE_VAL;
    for (s.body.sweeps_ = 1; s.body.sweeps_ <= most; ++s.body.sweeps_) {
      std::copy(x.begin(), x.end(), s.guess());
      detail::relative_motion(shape_, s.inertia, s.guess(), s.momentum(), s.motion());
      carry_out_(s, detail::Stage::square, shape_.n);
      detail::Defect const d = detail::defect(shape_, s.square(), s.guess());
      s.body.defect_ = d.change, seen.push_back(s.body.defect());
      if (!(d.square < 1e30)) break;
      if (s.body.sweeps_ == 40) refuse_beyond(s.body);
      if (rule_.at_rounding(d, HUGE_VAL, d.change > before / 4 ? 16 : 1)) {
        if (on_branch_of_identity(s)) return;
        break;
      }
      before = d.change;
      for (std::size_t k = 0; k < x.size(); ++k) residual[k] = s.square()[k] - x[k];
      anderson.mix(x, residual);
    }
    refuse_beyond(s.body);
    throw NotConverged("Moser-Veselov", seen, std::numeric_limits<double>::epsilon());
  }

  /// @throws StepTooLong  where the step has no solution for this momentum
  void refuse_beyond(RotatingBody const& body) const {
    if (rule_.any_negative) return;
    double const longest = longest_step(body.momentum());
    if (std::abs(step_) > longest) throw StepTooLong("Moser-Veselov", std::abs(step_), longest);
  }

  /// Whether any two eigenvalues of \f$f^T\Lambda\f$ have a sum with positive real part, f = 1 + e.
  bool on_branch_of_identity(detail::FixedPointStep const& s) const {
    auto const f = [&](int i, int j) { return s.motion()[detail::full_entry(shape_, i, j)] + (i == j); };
    Eigen::MatrixXd x(shape_.n, shape_.n);
    if (!rule_.any_negative) {
      // A positive definite symmetric part of f settles it, and is cheaper.
      for (int j = 0; j < shape_.n; ++j)
        for (int i = 0; i < shape_.n; ++i) x(i, j) = f(i, j) + f(j, i);
      if (detail::positive_definite(x)) return true;
    }
    double const unit = magnitude(inertia_.lambda);
    for (int j = 0; j < shape_.n; ++j)
      for (int i = 0; i < shape_.n; ++i) x(i, j) = f(j, i) * (inertia_.lambda[j] / unit);
    Eigen::VectorXd const real = real_parts_of_eigenvalues(x);
    return real[0] + real[1] > -1e-7;
  }

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

}  // namespace actio
