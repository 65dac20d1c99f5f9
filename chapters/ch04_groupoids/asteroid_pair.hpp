// Two asteroids on a groupoid: the bodies, their configurations in space, the equations that a motion is put
// into, and two steps with an error in them. The program two_bodies_on_arrows shows them, and a test of the
// library judges its step by them.
//
// Masses are 4/5 and 1/5 and the constant of gravitation is 1; lengths are of the order 1, and an orbit takes
// some 6 units of time.
#pragma once

#include <Eigen/Geometry>

#include "actio/groupoid/lagrange_equations.hpp"
#include "actio/two_bodies/pair_on_groupoid.hpp"
#include "actio/two_bodies/two_bodies.hpp"

namespace asteroids {

using namespace actio;
using namespace actio::bodies;

using Both = DirectProduct<SE<3>, SE<3>>;
using Poses = std::array<Pose<double>, 2>;
using Momenta = DualPoint<TwoPoses, double>;
constexpr double h = 0.02;  // time of a step

// Each is given by its principal axes.
inline ExtendedBody large() { return ellipsoid_body(0.8, {0.40, 0.36, 0.30}, 4); }
inline ExtendedBody small() { return ellipsoid_body(0.2, {0.15, 0.24, 0.19}, 4); }
/// On the groupoid.
inline PairOnGroupoid pair_of_order(int order) { return {large(), small(), order, 1}; }
/// By the fast step of the library.
inline TwoBodies fast_pair(int order) {
  auto const attitude = [](double a, double b, double c) {
    Eigen::Vector4d const q = Eigen::Vector4d(1, a, b, c).normalized();
    return Element<SU2, double>{{}, q};
  };
  return TwoBodies(
      large(), small(),
      state_of_velocities(large(), small(), {1.3, 0.1, -0.1}, {0.05, 0.8, 0.1}, attitude(0.2, -0.1, 0.3),
                          {0.3, 0.2, 1.1}, attitude(-0.4, 0.2, 0.1), {0.2, -0.5, 0.9}),
      {.order = order, .step = h, .method = moser_veselov_pair(), .G = 1});
}
/// The principal axes of both bodies at their centres of mass, the barycentre at rest.
inline Poses poses(TwoBodies const& pair) {
  auto const state = pair.state();
  double const m1 = pair.first().mass(), m2 = pair.second().mass(), M = m1 + m2;
  auto const pose = [](FreeState const& s, ExtendedBody const& body, Eigen::Vector3d const& x) {
    auto const& q = s.attitude.value;
    Eigen::Matrix4d a = Eigen::Matrix4d::Identity();
    a.topLeftCorner<3, 3>() = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix() * body.axes;
    a.topRightCorner<3, 1>() = x;
    return Pose<double>{{}, a};
  };
  return {pose(state.first, pair.first(), -m2 / M * state.position),
          pose(state.second, pair.second(), m1 / M * state.position)};
}
/// The configurations before and after so many fast steps.
inline std::vector<Poses> fast_motion(int order, int steps) {
  auto fast = fast_pair(order);
  std::vector<Poses> g{poses(fast)};
  for (int k = 0; k < steps; ++k) fast.step(), g.push_back(poses(fast));
  return g;
}

/// The largest residuals of a motion in both sets of equations, and the largest momentum.
struct Residuals {
  double on_arrows = 0, on_pairs = 0, momentum = 0;
};
/// @param every  so many steps there is one that is put into the equations on pairs
inline Residuals put_into_equations(PairOnGroupoid const& pair, std::vector<Poses> const& g,
                                    std::size_t every = 1) {
  TwoPoses const groupoid;
  auto const L = pair.lagrangian(h);
  Residuals found;
  for (std::size_t k = 1; k + 1 < g.size(); ++k) {
    auto const before = TwoPoses::reduced<double>(g[k - 1], g[k]),
               after = TwoPoses::reduced<double>(g[k], g[k + 1]);
    found.on_arrows = std::max(found.on_arrows, lagrange_equations(groupoid, L, before, after).norm());
    found.momentum = std::max(found.momentum, legendre_at_target(groupoid, L, before).components.norm());
    if (k % every != 0) continue;
    auto const both = [&](std::size_t i) { return element_of_product(g[i][0], g[i][1]); };
    PairArrow<Both, double> const first{both(k - 1), both(k)}, second{both(k), both(k + 1)};
    found.on_pairs =
        std::max(found.on_pairs, lagrange_equations(PairGroupoid<Both>{}, L, first, second).norm());
  }
  return found;
}

/// How far a motion that is put together from arrows is from this one, step by step: its first arrow gives
/// momenta, momenta the next arrow, and the first body moves by the elements of the arrows.
inline std::vector<double> put_together(PairOnGroupoid const& pair, std::vector<Poses> const& g) {
  auto arrow = TwoPoses::reduced<double>(g[0], g[1]);
  Poses at = g[0];
  std::vector<double> off;
  for (std::size_t k = 1; k < g.size(); ++k) {
    Pose<double> const first = at[0] * arrow.element;
    at = {first, first * arrow.to[0]};
    off.push_back((at[0].value - g[k][0].value).norm() + (at[1].value - g[k][1].value).norm());
    arrow = pair.step(Momenta(legendre_at_target(TwoPoses{}, pair.lagrangian(h), arrow)), h).first;
  }
  return off;
}

// [steps_with_an_error]
// The torque on the first body comes from a series of its own, cut at a lower order than the potential.
template <class P, class T>
auto own_series(PairOnGroupoid const& pair, PairOnGroupoid const& of_lower_order, P const& p, T const& t) {
  auto const kicked = [&](P at) {
    auto const cut = of_lower_order.interaction(at.base.others[0]).torque_1,
               whole = pair.interaction(at.base.others[0]).torque_1;
    at = pair.kicked(at, T(t / T(2)));
    for (int i = 0; i < 3; ++i) at.components[i] += t / T(2) * (cut[i] - whole[i]);
    return at;
  };
  auto const [arrow, end] = pair.drift(kicked(p), t);
  return std::pair{arrow, kicked(end)};
}
// The second body is turned from the wrong side.
template <class P, class T>
auto wrong_side(PairOnGroupoid const& pair, P const& p, T const& t) {
  P const middle = pair.kicked(p, T(t / T(2)));
  auto const f = pair.free_motions(middle, t);
  auto arrow = TwoPoses::moving(p.base, f);
  arrow.to[0] = inverse(f[0]) * f[1] * p.base.others[0];
  P const end{TwoPoses::target(arrow), PairOnGroupoid::carried(f, middle.components)};
  return std::pair{arrow, pair.kicked(end, T(t / T(2)))};
}
// [steps_with_an_error]

}  // namespace asteroids
