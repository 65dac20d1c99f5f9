// A step with constraints that conserves the energy, for kinetic energies with a constant matrix.
//
// With l = v.Mv/2 - V(a), the velocity v of the step and the multipliers solve
//
//     2 (M v - mu_0) = h (ad*_v M v - J) + A(a_m, t_m)^T lambda,      c(v, a_m, t_m) = 0,
//
// a_m the mean of the vectors at both ends, a_1 = (1 + hv/2)^-1 (1 - hv/2) a_0, mu_1 = 2 M v - mu_0, and
//
//     J = J(a_m) + ((V(a_1) - V(a_0))/h - v.J(a_m)) M v/(v.Mv)
//
// the force of the potential with the component along the motion that does the work exactly. Then the energy
// mu.M^-1 mu/2 + V(a) changes by the work lambda.b of the constraints alone, which is zero where they are
// linear. The step is self-adjoint, of order 2. Not the momenta at the nodes but their means obey the
// constraints.
#pragma once

#include <cmath>

#include "actio/any_group/chart_solver.hpp"
#include "actio/linear_algebra/linear.hpp"
#include "actio/nonholonomic/velocity_constraints.hpp"

namespace actio::systems {

/// Refuses what such steps cannot take.
/// @throws OutsideDomain  where the chart is not Cayley's, where there is a force or friction, or where the
///                        Lagrangian is not \f$\tfrac12v\cdot Mv - V(a)\f$ with a constant M, as it is
///                        written
void require_constant_metric(ReducedSystem const& system);

/// The equations of one such step at one scalar, with their work space.
template <class S>
class ConservingStep {
 public:
  static constexpr char const* name = "steps that conserve the energy";  ///< in messages
  static constexpr double share = 0.5;  ///< of the reactions, which comes before the middle
  /// Refuses systems that it cannot take. @throws OutsideDomain
  static void require(ReducedSystem const& system) { require_constant_metric(system); }

  /// Of a system and constraints that outlive it.
  ConservingStep(ReducedSystem const& system, VelocityConstraints const& constraints)
      : constraint(constraints),
        change(static_cast<std::size_t>(system.dimension())),
        momentum(change),
        vectors(static_cast<std::size_t>(system.carried())),
        halfway(vectors),
        before_(change),
        system_(system),
        inputs_(static_cast<std::size_t>(system.lagrangian.inputs)),
        slopes_(inputs_.size() + 1),
        sizes_(change.size()) {}

  ConstraintValues<S> constraint;  ///< in the middle: values and rows
  std::vector<S> change,           ///< of the momentum over the step, without reactions; energy x time
      momentum,                    ///< \f$Mv\f$
      vectors,                     ///< at the end
      halfway;                     ///< their mean with those at the start
  double work_terms = 0;           ///< the size of what the correction of the force is a difference of

  /// What the vectors at the start say, whatever the velocity: nothing.
  void begin(std::vector<S> const&, S const&) {}

  /// @param h  step, time
  /// @param t  time at the start
  /// @param v  velocity of the step
  /// @param a  vectors at the start
  /// @return   true: Cayley's chart reaches everywhere
  bool operator()(S const& h, S const& t, std::vector<S> const& v, std::vector<S> const& a) {
    auto const d = v.size();
    S const signed_h = h * S(system_.sign());
    carry(signed_h, v, a);
    constraint.set_values(v, halfway, t + h / S(2));
    constraint.set_rows(halfway, t + h / S(2));
    slopes_at(v, halfway);
    std::copy_n(slopes_.begin() + 1, d, momentum.begin());
    std::fill(change.begin(), change.end(), S(0));
    S power(0), twice_kinetic(0);
    for (auto const& e : system_.algebra.entries)
      for (std::size_t k = 0; k < a.size(); k += length())
        change[n(e.direction)] -=
            signed_h * slopes_[1 + d + k + n(e.row)] * halfway[k + n(e.column)] * S(e.value);
    for (std::size_t i = 0; i < d; ++i) power -= v[i] * change[i], twice_kinetic += v[i] * momentum[i];
    for (std::size_t i = 0; i < d; ++i) sizes_[i] = modulus(change[i]);
    for (auto const& c : system_.algebra.constants) {
      S const part = signed_h * v[n(c.a)] * momentum[n(c.c)] * S(c.value);
      change[n(c.b)] += part, sizes_[n(c.b)] += modulus(part);
    }
    correct(S(rise(a) - power), twice_kinetic);
    for (std::size_t i = 0; i < d; ++i) before_[i] = momentum[i] - change[i] / S(2);
    return true;
  }

  /// The momentum at the start with the share of the reactions.
  std::vector<S> const& before() const { return before_; }
  std::vector<S> const& vectors_at_end() const { return vectors; }  ///< that are carried
  /// The size of what a component of it is a sum of.
  double size(std::size_t i) const { return (1 + work_terms / 2) * std::abs(momentum[i]) + sizes_[i] / 2; }
  /// Takes the point to the end of the step: of the two ways to the momentum there, that on which the last
  /// residual does next to no work.
  /// @param x  velocity and multipliers
  void finish(double, std::vector<double> const& x, std::vector<double> const&, ReducedPoint& point) const {
    for (std::size_t i = 0; i < change.size(); ++i) {
      double sum = change[i];
      for (std::size_t k = 0; k < constraint.values.size(); ++k)
        sum += constraint.rows[k * change.size() + i] * x[change.size() + k];
      point.momentum[i] += sum;
    }
    point.vectors = vectors;
  }

 private:
  static double modulus(S const& x) { return std::abs(to_double(base_value(x))); }
  static std::size_t n(int i) { return static_cast<std::size_t>(i); }
  std::size_t length() const { return n(system_.length()); }

  void slopes_at(std::vector<S> const& v, std::vector<S> const& a) {
    std::copy(v.begin(), v.end(), inputs_.begin());
    std::copy(a.begin(), a.end(), inputs_.begin() + static_cast<std::ptrdiff_t>(v.size()));
    system_.slopes(inputs_.data(), slopes_.data(), work_);
  }
  /// Mean and end of the vectors: (1 + hv/2) times the mean is the vector at the start.
  void carry(S const& signed_h, std::vector<S> const& v, std::vector<S> const& a) {
    if (a.empty()) return;
    Index const rows = system_.length(), columns = static_cast<Index>(a.size()) / rows;
    Matrix<S> left = Matrix<S>::Identity(rows, rows), right(rows, columns);
    for (auto const& e : system_.algebra.entries)
      left(e.row, e.column) += signed_h * v[n(e.direction)] * S(e.value) / S(2);
    for (std::size_t i = 0; i < a.size(); ++i)
      right(static_cast<Index>(i) % rows, static_cast<Index>(i) / rows) = a[i];
    auto const mean = solve_linear(left, right, "Cayley's chart");
    for (std::size_t i = 0; i < a.size(); ++i) {
      halfway[i] = mean(static_cast<Index>(i) % rows, static_cast<Index>(i) / rows);
      vectors[i] = S(2) * halfway[i] - a[i];
    }
  }
  /// \f$V(a_1) - V(a_0)\f$.
  S rise(std::vector<S> const& a) {
    if (a.empty()) return S(0);
    still_.assign(change.size(), S(0));
    S low, high;
    auto const potential = [&](std::vector<S> const& at, S& out) {
      std::copy(still_.begin(), still_.end(), inputs_.begin());
      std::copy(at.begin(), at.end(), inputs_.begin() + static_cast<std::ptrdiff_t>(still_.size()));
      system_.lagrangian(inputs_.data(), &out, work_);
    };
    potential(a, high), potential(vectors, low);
    potentials_ = modulus(high) + modulus(low);
    return high - low;
  }
  /// Takes what the force misses of the work off along the momentum.
  void correct(S const& missing, S const& twice_kinetic) {
    work_terms = 0;
    if (base_value(twice_kinetic) == 0) return;
    S const factor = missing / twice_kinetic;
    work_terms = potentials_ / modulus(twice_kinetic);
    for (std::size_t i = 0; i < change.size(); ++i) change[i] -= factor * momentum[i];
  }

  std::vector<S> before_;
  ReducedSystem const& system_;
  std::vector<S> inputs_, slopes_, work_, still_;
  std::vector<double> sizes_;  // of what the change is a sum of
  double potentials_ = 0;
};

}  // namespace actio::systems
