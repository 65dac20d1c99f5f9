// Steps of a body on a mesh: the explicit one that keeps the multisymplectic form, and the implicit one that
// keeps energy. Both are self-adjoint, so that substeps in a palindrome make a step of order 4.
#pragma once

#include <random>

#include "actio/multisymplectic/body_forces.hpp"

namespace actio {

/// Places and velocities of all nodes, component by component, with what rounding has taken from them.
///
/// A sum of many small steps forgets what lies below the last place; here that is carried along (Kahan), so
/// that momenta walk by the rounding of forces and not of places.
struct BodyState {
  std::vector<double> x;       ///< places, length
  std::vector<double> v;       ///< velocities, length/time
  std::vector<double> x_rest;  ///< what is to be added to x
  std::vector<double> v_rest;  ///< what is to be added to v
};

namespace detail {
/// x + rest += y, x the nearest number.
inline void add_with_rest(double& x, double& rest, double y) {
  double const more = y + rest, sum = x + more, back = sum - x;
  rest = (x - (sum - back)) + (more - back);
  x = sum;
}
}  // namespace detail

/// The steps of a body.
template <int d>
class BodySteps {
 public:
  /// @param mesh, law, density, loads  as for \ref BodyForces
  BodySteps(BodyMesh const& mesh, typename BodyForces<d>::Law law,
            typename BodyForces<d>::Density const& density, BodySides<d> const& sides,
            BodyLoads<d> const& loads)
      : forces(mesh, std::move(law), density, loads), held(mesh, sides) {}

  BodyForces<d> forces;  ///< inside of the body and on it
  HeldNodes<d> held;     ///< what its sides do

  /// v += h/2 a(x), x += h v, v += h/2 a(x): the discrete Euler-Lagrange field equations of the slab.
  /// @param f  forces at the start, and then at the end
  /// @param t  the time at the end
  /// @return the least Jacobian at the end; where it is not positive the state is none
  LeastJacobian explicit_step(BodyState& s, std::vector<double>& f, double h, double t) const {
    kick(s, f, h / 2);
    for (std::size_t k = 0; k < s.x.size(); ++k) detail::add_with_rest(s.x[k], s.x_rest[k], h * s.v[k]);
    put_moved(s, t);
    LeastJacobian const least = forces.forces(s.x, t, f);
    if (!(least.jacobian > 0)) return least;
    kick(s, f, h / 2);
    if (held.any_moved()) held.put_velocities(s.v, t);
    return least;
  }

  /// v1 = v0 + h a(x0, x1), x1 = x0 + h (v0 + v1)/2 with discrete forces: energy, momentum and angular
  /// momentum are kept, the multisymplectic form is not.
  ///
  /// Solved by iteration of the equation itself, and where that is slow by Newton's with conjugate gradients.
  /// @param t0, t1  times at the start and at the end
  /// @return the least Jacobian at the end; where it is not positive there is no such step
  /// @throws NotConverged  where the iteration does not reach rounding
  LeastJacobian implicit_step(BodyState& s, double h, double t0, double t1) const {
    std::size_t const n = s.x.size();
    std::vector<double> y(n), f(n), r(n), good = s.x, delta;
    for (std::size_t k = 0; k < n; ++k) y[k] = s.x[k] + h * s.v[k];
    held.put_places(y, t1);
    std::vector<double> history;
    double const eps = std::numeric_limits<double>::epsilon();
    bool newton = false;
    double last = HUGE_VAL;
    for (int round = 0; round < 200; ++round) {
      LeastJacobian const least = discrete_forces_from(s.x, y, good, 0.5 * (t0 + t1), f);
      if (!(least.jacobian > 0)) return least;
      accelerate(f);
      auto const [size, scale] = residual(s, y, f, h, t1, r);
      if (!is_finite(size)) throw NotFinite("medium on a mesh: step that keeps energy");
      // To where rounding lets it fall no further: what is left then has no direction of its own.
      if (size <= eps / 4 * scale || (size > 0.3 * last && size < 1e3 * eps * scale)) {
        finish(s, y, f, h, t1);
        return least;
      }
      history.push_back(size);
      if (size > last && newton) {
        for (double& one : delta) one *= 0.5;
      } else {
        bool const worse = size > last;
        newton = newton || size > 0.3 * last;
        if (!worse) good = y, delta = r, last = size;
        if (newton) correct(s.x, good, h, delta);
      }
      for (std::size_t k = 0; k < n; ++k) y[k] = good[k] + delta[k];
    }
    throw NotConverged("medium on a mesh: step that keeps energy", history, 1e3 * eps);
  }

  /// The largest frequency of small motions about places x, per time: the root of the largest eigenvalue of
  /// \f$M^{-1}K\f$, by powers of it.
  ///
  /// Accuracy: from below, within a per cent; the iteration ends when a round changes it by less than 1e-6 of
  /// itself, or after 400 rounds. Cost: a round is about two forces on all nodes.
  double largest_frequency(std::vector<double> const& x) const {
    std::vector<double> u(x.size()), next;
    std::minstd_rand random(1);
    for (double& one : u) one = static_cast<double>(random()) / std::minstd_rand::max() - 0.5;
    held.restrict_to_allowed(u);
    double frequency = 0;
    for (int round = 0; round < 400; ++round) {
      double norm = 0;
      for (double const one : u) norm += one * one;
      if (!(norm > 0) || !is_finite(norm)) break;
      for (double& one : u) one /= std::sqrt(norm);
      forces.stiffness(x, u, next);
      accelerate(next);
      double square = 0;
      for (double const one : next) square += one * one;
      u.swap(next);
      double const before = frequency;
      frequency = std::sqrt(std::sqrt(square));
      if (round > 60 && std::abs(frequency - before) <= 1e-6 * frequency) break;
    }
    return frequency;
  }

 private:
  std::vector<double> const& masses() const { return forces.body.masses; }
  /// Forces become accelerations, of those that sides leave.
  void accelerate(std::vector<double>& f) const {
    for (std::size_t k = 0; k < f.size(); ++k) f[k] /= masses()[k / d];
    held.restrict_to_allowed(f);
  }
  void kick(BodyState& s, std::vector<double> const& f, double h) const {
    std::vector<double> a = f;
    accelerate(a);
    for (std::size_t k = 0; k < a.size(); ++k) detail::add_with_rest(s.v[k], s.v_rest[k], h * a[k]);
  }
  void put_moved(BodyState& s, double t) const {
    if (!held.any_moved()) return;
    held.put_places(s.x, t);
    held.for_moved([&](int node) {
      for (int a = 0; a < d; ++a) s.x_rest[std::size_t(d) * node + a] = 0;
    });
  }
  /// Discrete forces to y, or where that is inside out to places nearer to the good ones.
  LeastJacobian discrete_forces_from(std::vector<double> const& x, std::vector<double>& y,
                                     std::vector<double> const& good, double t,
                                     std::vector<double>& f) const {
    LeastJacobian least;
    for (int halving = 0; halving < 20; ++halving) {
      least = forces.discrete_forces(x, y, t, f);
      if (least.jacobian > 0) break;
      for (std::size_t k = 0; k < y.size(); ++k) y[k] = 0.5 * (y[k] + good[k]);
    }
    return least;
  }
  /// What the equation of the step has at y and what y is, both with the largest modulus.
  std::pair<double, double> residual(BodyState const& s, std::vector<double> const& y,
                                     std::vector<double> const& a, double h, double t,
                                     std::vector<double>& r) const {
    for (std::size_t k = 0; k < y.size(); ++k) {
      double const v = s.v[k] + (s.v_rest[k] + h * a[k]);
      r[k] = s.x[k] + (s.x_rest[k] + h / 2 * (s.v[k] + v));
    }
    held.put_places(r, t);
    double size = 0, scale = 0;
    for (std::size_t k = 0; k < y.size(); ++k) {
      r[k] -= y[k];
      size = std::max(size, std::abs(r[k])), scale = std::max(scale, std::abs(y[k]));
      if (!is_finite(r[k])) size = r[k];
      if (!is_finite(size)) break;
    }
    return {size, scale};
  }
  /// The state at the end, given the accelerations. Its places are those at which the stresses were taken, to
  /// the last bit, and what the equation has beyond them is their rest: so what a solution is off by does
  /// work once and not in every step.
  void finish(BodyState& s, std::vector<double> const& y, std::vector<double> const& a, double h,
              double t) const {
    for (std::size_t k = 0; k < a.size(); ++k) {
      double const before = s.v[k];
      detail::add_with_rest(s.v[k], s.v_rest[k], h * a[k]);
      s.x_rest[k] += h / 2 * (before + s.v[k]) - (y[k] - s.x[k]);
      s.x[k] = y[k];
    }
    put_moved(s, t);
    if (held.any_moved()) held.put_velocities(s.v, t);
  }
  /// r becomes the solution of \f$(M+\tfrac{h^2}4K)\,\delta = Mr\f$, with K in the middle of the step, by
  /// conjugate gradients to a thousandth; where the matrix is not positive, what they have by then.
  void correct(std::vector<double> const& x, std::vector<double> const& y, double h,
               std::vector<double>& r) const {
    std::size_t const n = r.size();
    std::vector<double> middle(n), delta(n, 0), rest = r, p = r, q;
    for (std::size_t k = 0; k < n; ++k) middle[k] = 0.5 * (x[k] + y[k]);
    auto const product = [&](std::vector<double> const& a, std::vector<double> const& b) {
      double sum = 0;
      for (std::size_t k = 0; k < n; ++k) sum += masses()[k / d] * a[k] * b[k];
      return sum;
    };
    double square = product(rest, rest);
    double const enough = 1e-6 * square;
    for (int round = 0; round < 300 && square > enough; ++round) {
      forces.stiffness(middle, p, q);
      accelerate(q);
      for (std::size_t k = 0; k < n; ++k) q[k] = p[k] + h * h / 4 * q[k];
      double const bend = product(p, q);
      if (!(bend > 0)) break;
      double const step = square / bend;
      for (std::size_t k = 0; k < n; ++k) delta[k] += step * p[k], rest[k] -= step * q[k];
      double const before = square;
      square = product(rest, rest);
      for (std::size_t k = 0; k < n; ++k) p[k] = rest[k] + square / before * p[k];
    }
    if (product(delta, delta) > 0) r = delta;
  }
};

}  // namespace actio
