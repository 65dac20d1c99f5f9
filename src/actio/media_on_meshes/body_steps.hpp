// Steps of a body on a mesh: the explicit one that keeps the multisymplectic form, and the implicit one that
// conserves energy. Both are self-adjoint, so that substeps in a palindrome make a step of order 4.
#pragma once

#include <optional>
#include <random>

#include "actio/media_on_meshes/artificial_viscosity.hpp"
#include "actio/media_on_meshes/body_forces.hpp"
#include "actio/media_on_meshes/body_state.hpp"
#include "actio/multisymplectic/largest_frequency.hpp"

namespace actio::media {

/// A step of a body that fails on a rank, and so on all. The whole body on rank 0 says why.
struct FailsOnARank : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The largest frequency of small motions about places x, per time: from below, within half a per cent
/// (`detail::largest_frequency`). Cost: about forty forces on all nodes.
template <int d>
double largest_frequency_of(BodyForces<d> const& forces, HeldNodes<d> const& held,
                            std::vector<double> const& x) {
  std::vector<double> start(x.size());
  std::minstd_rand random(1);
  for (double& one : start) one = static_cast<double>(random()) / std::minstd_rand::max() - 0.5;
  held.restrict_to_allowed(start);
  auto const& masses = forces.body.masses;
  return detail::largest_frequency([&](std::size_t k) { return masses[k / d]; }, std::move(start),
                                   [&](std::vector<double> const& u, std::vector<double>& out) {
                                     forces.stiffness(x, u, out);
                                     for (std::size_t k = 0; k < out.size(); ++k) out[k] /= masses[k / d];
                                     held.restrict_to_allowed(out);
                                   });
}

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
  /// of the explicit step; none: there is none
  std::optional<ViscousForces<d>> viscosity = {};
  SharedNodes const* shared = nullptr;  ///< of a part of a body: its nodes; null: all of the body is here

  /// v += h/2 a(x), x += h v, v += h/2 a(x): the discrete Euler-Lagrange field equations of the slab.
  /// @param f  forces at the start, and then at the end
  /// @param t  the time at the end
  /// @return the least Jacobian at the end; where it is not positive the state is none
  /// @throws FailsOnARank  on all ranks, of a part of a body, where anything fails on one of them
  LeastJacobian explicit_step(BodyState& s, std::vector<double>& f, double h, double t) const {
    kick(s, f, h / 2);
    for (std::size_t k = 0; k < s.x.size(); ++k) detail::add_with_rest(s.x[k], s.x_rest[k], h * s.v[k]);
    LeastJacobian const least = on_all_ranks([&] {
      put_moved(s, t);
      return forces.forces(s.x, t, f, s.x_rest);
    });
    if (!(least.jacobian > 0)) return least;
    if (shared) shared->complete(f);
    if (viscosity) resist(s, f, h);
    kick(s, f, h / 2);
    if (held.any_moved())
      on_all_ranks([&] {
        held.put_velocities(s.v, t);
        return least;
      });
    return least;
  }

  /// v1 = v0 + h a(x0, x1), x1 = x0 + h (v0 + v1)/2 with discrete forces: energy, momentum and angular
  /// momentum are kept, the multisymplectic form is not.
  ///
  /// Solved by iteration of the equation itself, and where that is slow by Newton's with conjugate gradients.
  /// @param t0, t1  times at the start and at the end
  /// @return the least Jacobian at the end; where it is not positive there is no such step
  /// @throws NotConverged  where the iteration does not reach rounding: how far places are off, round by
  ///   round, and what was to be reached, lengths; the last is none where forces are none
  LeastJacobian implicit_step(BodyState& s, double h, double t0, double t1) const {
    std::size_t const n = s.x.size();
    std::vector<double> way(n), f(n), r(n), good(n, 0.0), delta;
    double const guessed = guess(s, h, t0, t1, way, f);
    std::vector<double> history;
    double const rounding = std::numeric_limits<double>::epsilon() * extent(s.x);
    bool newton = false;
    double last = HUGE_VAL;
    for (int round = 0; round < 200; ++round) {
      LeastJacobian const least = discrete_forces_along(s, way, good, 0.5 * (t0 + t1), f);
      if (!(least.jacobian > 0)) return least;
      accelerate(f);
      double const size = residual(s, way, f, h, t1, r);
      if (!is_finite(size)) {
        history.push_back(size);
        break;
      }
      // Until rounding lets it fall no further: a larger residual has a direction, and its work adds up.
      if (size == 0 || (size > 0.3 * last && size <= 4 * rounding) ||
          (size >= last && size < 1e3 * rounding)) {
        finish(s, f, h, t1);
        return least;
      }
      history.push_back(size);
      // Beyond the explicit steps' limit a guess by one of these may lead away.
      if (round == 0 && size > 0.5 * guessed) {
        straight_way(s, h, t1, way);
        continue;
      }
      if (size > last && newton) {
        for (double& one : delta) one *= 0.5;
      } else {
        bool const worse = size > last;
        newton = newton || size > 0.3 * last;
        if (!worse) good = way, delta = r, last = size;
        if (newton) correct(s.x, good, h, delta);
      }
      for (std::size_t k = 0; k < n; ++k) way[k] = good[k] + delta[k];
    }
    throw NotConverged("medium: a step that conserves energy", history, 1e3 * rounding);
  }

  /// \copydoc largest_frequency_of
  double largest_frequency(std::vector<double> const& x) const {
    return largest_frequency_of(forces, held, x);
  }

 private:
  std::vector<double> const& masses() const { return forces.body.masses; }
  /// Forces become accelerations, of those that sides leave.
  void accelerate(std::vector<double>& f) const {
    for (std::size_t k = 0; k < f.size(); ++k) f[k] /= masses()[k / d];
    held.restrict_to_allowed(f);
  }
  void kick(BodyState& s, std::vector<double> const& f, double h) const {
    std::vector<double> a = f, before;
    if (viscosity) {
      before = s.v;
      for (std::size_t k = 0; k < a.size(); ++k) a[k] += s.viscous[k];
    }
    accelerate(a);
    for (std::size_t k = 0; k < a.size(); ++k) detail::add_with_rest(s.v[k], s.v_rest[k], h * a[k]);
    if (viscosity) s.dissipated += taken(s.viscous, h, before, s.v);
  }
  /// The forces of viscosity at the end of a step, for the velocity there: by those for the velocity in the
  /// middle it is known up to the square of the step.
  void resist(BodyState& s, std::vector<double> const& f, double h) const {
    viscous_forces(s, s.v);
    std::vector<double> v = f;
    for (std::size_t k = 0; k < v.size(); ++k) v[k] += s.viscous[k];
    accelerate(v);
    for (std::size_t k = 0; k < v.size(); ++k) v[k] = s.v[k] + h / 2 * v[k];
    auto const limit = viscous_forces(s, v);
    if (h > limit.step) throw ViscosityNeedsShorterSteps(limit.cell, h, limit.step);
  }
  /// Those at velocities v.
  /// @return the longest step, of all ranks
  ViscousLimit viscous_forces(BodyState& s, std::vector<double> const& v) const {
    auto limit = viscosity->forces(forces.body, forces.law(), s.x, v, s.viscous);
    if (shared) shared->complete(s.viscous), limit.step = -shared->ranks().most(-limit.step);
    return limit;
  }
  /// What viscosity takes in a kick, on rank 0: a sum over all nodes in their order.
  double taken(std::vector<double> const& viscous, double h, std::vector<double> const& before,
               std::vector<double> const& after) const {
    if (!shared) return viscosity->taken(viscous, h, before, after);
    std::vector<double> all[3];
    for (int k = 0; auto const* part : {&viscous, &before, &after}) shared->gather(*part, all[k++]);
    return viscosity->taken(all[0], h, all[1], all[2]);
  }
  /// Does this work, whose result is the least Jacobian, on all ranks that have a part of the body.
  template <class Work>
  LeastJacobian on_all_ranks(Work const& work) const {
    if (!shared) return work();
    LeastJacobian least{-1, -1};
    try {
      least = work();
    } catch (std::exception const&) {
    }
    if (shared->ranks().any(!(least.jacobian > 0))) throw FailsOnARank("a step of a part of a body");
    return least;
  }
  void put_moved(BodyState& s, double t) const {
    if (!held.any_moved()) return;
    held.put_places(s.x, t);
    held.for_moved([&](int node) {
      for (int a = 0; a < d; ++a) s.x_rest[std::size_t(d) * node + a] = 0;
    });
  }
  /// The way \f$hv\f$.
  void straight_way(BodyState const& s, double h, double t1, std::vector<double>& way) const {
    for (std::size_t k = 0; k < way.size(); ++k) way[k] = h * s.v[k];
    put_moved_ways(s, way, t1);
  }
  /// A way to begin with: \f$hv+\tfrac{h^2}2a\f$ with the acceleration half of the way to \f$hv\f$, off
  /// by the fourth power of h, for the price of an explicit step.
  /// @return the largest modulus of \f$\tfrac{h^2}2a\f$
  double guess(BodyState const& s, double h, double t0, double t1, std::vector<double>& way,
               std::vector<double>& room) const {
    straight_way(s, h, t1, way);
    std::vector<double> middle = s.x;
    for (std::size_t k = 0; k < way.size(); ++k) middle[k] += 0.5 * way[k];
    if (!(forces.forces(middle, 0.5 * (t0 + t1), room, s.x_rest).jacobian > 0)) return 0;
    accelerate(room);
    double most = 0;
    for (std::size_t k = 0; k < way.size(); ++k) {
      double const more = h * h / 2 * room[k];
      if (!is_finite(more)) continue;
      way[k] += more, most = std::max(most, std::abs(more));
    }
    put_moved_ways(s, way, t1);
    return most;
  }
  /// The way of moved sides, from where they are.
  void put_moved_ways(BodyState const& s, std::vector<double>& way, double t) const {
    if (!held.any_moved()) return;
    std::vector<double> there = s.x;
    held.put_places(there, t);
    held.for_moved([&](int node) {
      for (int a = 0; a < d; ++a) {
        std::size_t const k = std::size_t(d) * node + a;
        way[k] = there[k] - s.x[k];
      }
    });
  }
  /// The size of a body, along the longest of its directions.
  static double extent(std::vector<double> const& x) {
    double most = 0;
    for (std::size_t k = 0; k < x.size(); ++k) most = std::max(most, std::abs(x[k] - x[k % d]));
    return most;
  }
  /// Discrete forces along a way, or where its end is inside out along one nearer to the good one.
  LeastJacobian discrete_forces_along(BodyState const& s, std::vector<double>& way,
                                      std::vector<double> const& good, double t,
                                      std::vector<double>& f) const {
    LeastJacobian least;
    for (int halving = 0; halving < 20; ++halving) {
      least = forces.discrete_forces(s.x, s.x_rest, way, t, f);
      if (least.jacobian > 0) break;
      for (std::size_t k = 0; k < way.size(); ++k) way[k] = 0.5 * (way[k] + good[k]);
    }
    return least;
  }
  /// What the way of a step with these accelerations, \f$hv_0+\tfrac{h^2}2a\f$, has beyond the one at which
  /// they were taken: r, and its largest modulus.
  double residual(BodyState const& s, std::vector<double> const& way, std::vector<double> const& a, double h,
                  double t, std::vector<double>& r) const {
    for (std::size_t k = 0; k < way.size(); ++k) r[k] = h * (s.v[k] + (s.v_rest[k] + h / 2 * a[k]));
    put_moved_ways(s, r, t);
    double size = 0;
    for (std::size_t k = 0; k < way.size(); ++k) {
      r[k] -= way[k];
      if (!is_finite(r[k])) return r[k];
      size = std::max(size, std::abs(r[k]));
    }
    return size;
  }
  /// The state at the end, given the accelerations.
  void finish(BodyState& s, std::vector<double> const& a, double h, double t) const {
    for (std::size_t k = 0; k < a.size(); ++k) {
      detail::add_with_rest(s.x[k], s.x_rest[k], h * (s.v[k] + (s.v_rest[k] + h / 2 * a[k])));
      detail::add_with_rest(s.v[k], s.v_rest[k], h * a[k]);
    }
    put_moved(s, t);
    if (held.any_moved()) held.put_velocities(s.v, t);
  }
  /// r becomes the solution of \f$(M+\tfrac{h^2}4K)\,\delta = Mr\f$, with K in the middle of the step, by
  /// conjugate gradients to a thousandth; where the matrix is not positive, what they have by then.
  void correct(std::vector<double> const& x, std::vector<double> const& way, double h,
               std::vector<double>& r) const {
    std::size_t const n = r.size();
    std::vector<double> middle(n), delta(n, 0), rest = r, p = r, q;
    for (std::size_t k = 0; k < n; ++k) middle[k] = x[k] + 0.5 * way[k];
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

}  // namespace actio::media
