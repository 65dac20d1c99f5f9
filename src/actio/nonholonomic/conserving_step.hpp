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

#include "actio/linear_algebra/linear.hpp"
#include "actio/nonholonomic/velocity_constraints.hpp"

namespace actio::systems {

/// The equations of one such step at one scalar, with their work space.
template <class S>
class ConservingStep {
 public:
  /// Of a system and constraints that outlive it.
  ConservingStep(ReducedSystem const& system, VelocityConstraints const& constraints)
      : constraint(constraints),
        change(static_cast<std::size_t>(system.dimension())),
        momentum(change),
        vectors(static_cast<std::size_t>(system.carried())),
        halfway(vectors),
        system_(system),
        inputs_(static_cast<std::size_t>(system.lagrangian.inputs)),
        slopes_(inputs_.size() + 1) {}

  ConstraintValues<S> constraint;  ///< in the middle: values and rows
  std::vector<S> change,           ///< of the momentum over the step, without reactions; energy x time
      momentum,                    ///< \f$Mv\f$
      vectors,                     ///< at the end
      halfway;                     ///< their mean with those at the start
  double work_terms = 0;           ///< the size of what the correction of the force is a difference of

  /// @param h  step, time
  /// @param t  time at the start
  /// @param v  velocity of the step
  /// @param a  vectors at the start
  void operator()(S const& h, S const& t, std::vector<S> const& v, std::vector<S> const& a) {
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
    for (auto const& c : system_.algebra.constants)
      change[n(c.b)] += signed_h * v[n(c.a)] * momentum[n(c.c)] * S(c.value);
    correct(S(rise(a) - power), twice_kinetic);
  }

 private:
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
    potentials_ = std::abs(to_double(base_value(high))) + std::abs(to_double(base_value(low)));
    return high - low;
  }
  /// Takes what the force misses of the work off along the momentum.
  void correct(S const& missing, S const& twice_kinetic) {
    work_terms = 0;
    if (base_value(twice_kinetic) == 0) return;
    S const factor = missing / twice_kinetic;
    work_terms = potentials_ / std::abs(to_double(base_value(twice_kinetic)));
    for (std::size_t i = 0; i < change.size(); ++i) change[i] -= factor * momentum[i];
  }

  ReducedSystem const& system_;
  std::vector<S> inputs_, slopes_, work_, still_;
  double potentials_ = 0;
};

}  // namespace actio::systems
