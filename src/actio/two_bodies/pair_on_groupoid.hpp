// Two bodies on the groupoid (SE(3) x SE(3))^2 / SE(3): the discrete Lagrangian of the splitting with rotors
// of Moser and Veselov, and its step, at every scalar.
//
// Nothing here is fast: it says what moser_veselov_pair of pair_method.hpp solves, in terms that the Lagrange
// equations on a groupoid, their Legendre maps and the instruments understand. A configuration is (g_1, g_2),
// the principal axes of each body at its centre of mass; a point of the base is x = g_1^-1 g_2, the second
// body in the frame of the first. A momentum of the algebroid is (M_1, p_1, M_2, p_2): of each body the
// angular momentum about its centre of mass and the linear one, in its own axes.
#pragma once

#include "actio/groupoid/diagonal_quotient.hpp"
#include "actio/groups/direct_product.hpp"
#include "actio/groups/motions.hpp"
#include "actio/instruments/implicit_map.hpp"
#include "actio/two_bodies/extended_body.hpp"
#include "actio/two_bodies/mutual_potential.hpp"

namespace actio::bodies {

/// The groupoid of two bodies in space.
using TwoPoses = DiagonalQuotient<SE<3>, 2>;
/// Position and attitude, as an element of SE(3).
template <class T>
using Pose = Element<SE<3>, T>;

/// Mechanics of two bodies on their groupoid.
class PairOnGroupoid {
 public:
  /// @param order  N of the mutual potential
  /// @param G      constant of gravitation
  /// @throws OutsideDomain  where the order is negative or above that of the moments
  PairOnGroupoid(ExtendedBody first, ExtendedBody second, int order, double G)
      : bodies_{std::move(first), std::move(second)}, order_(order), G_(G) {
    MutualPotential<double>(bodies_[0].moments, bodies_[1].moments, order, G);
  }

  /// Potential, force and torques between the bodies, in the axes of the first.
  template <class T>
  Interaction<T> interaction(Pose<T> const& x) const {
    auto const& a = x.value;
    Three<T> const r{a(0, 3), a(1, 3), a(2, 3)};
    std::array<Three<T>, 3> R;
    for (int i = 0; i < 3; ++i) R[i] = {a(i, 0), a(i, 1), a(i, 2)};
    return MutualPotential<T>(bodies_[0].moments.over<T>(), bodies_[1].moments.over<T>(), order_, T(G_))(r,
                                                                                                         R);
  }

  /// \f$m|\Delta x|^2/2h+\mathrm{tr}((1-F)J)/h\f$ of a body that moves by \f$f=(F,\Delta x)\f$ in its own
  /// axes, with \f$J=\frac12\mathrm{tr}(I)-I\f$; energy x time.
  template <class T>
  T kinetic(int body, Pose<T> const& f, double h) const {
    auto const& a = f.value;
    T sum(0);
    for (int i = 0; i < 3; ++i)
      sum += a(i, 3) * a(i, 3) * T(bodies_[body].mass() / 2) + (T(1) - a(i, i)) * T(mass_moment(body, i));
    return sum / T(h);
  }

  /// The discrete Lagrangian of steps h, on arrows of \ref TwoPoses and on pairs of configurations,
  /// \f[ L_d=\sum_i\Big[\frac{m_i|\Delta x_i|^2}{2h}+\frac{\mathrm{tr}((1-F_i)J_i)}h\Big]-\frac h2(V_0+V_1).
  ///   \f]
  auto lagrangian(double h) const {
    return [pair = *this, h]<class A>(A const& arrow) {
      using T = typename A::Scalar;
      // [pair_lagrangian]
      auto const a = on_arrows(arrow);
      auto const V_0 = pair.interaction(a.from[0]).potential, V_1 = pair.interaction(a.to[0]).potential;
      return T(pair.kinetic(0, a.motion(0), h) + pair.kinetic(1, a.motion(1), h) - (V_0 + V_1) * T(h / 2));
      // [pair_lagrangian]
    };
  }

  /// Momenta after a kick by the potential for a time.
  template <class T>
  DualPoint<TwoPoses, T> kicked(DualPoint<TwoPoses, T> p, T const& time) const {
    auto const& x = p.base.others[0].value;
    auto const k = interaction(p.base.others[0]);
    for (int i = 0; i < 3; ++i) {
      T force_2(0), torque_2(0);  // in the axes of the second body
      for (int j = 0; j < 3; ++j) force_2 += x(j, i) * k.force[j], torque_2 += x(j, i) * k.torque_2[j];
      p.components[i] += time * k.torque_1[i], p.components[3 + i] -= time * k.force[i];
      p.components[6 + i] += time * torque_2, p.components[9 + i] += time * force_2;
    }
    return p;
  }

  /// How a free body moves in a step of Moser and Veselov: \f$FJ-JF^T=h\widehat M\f$, \f$\Delta x=hp/m\f$.
  /// @param momentum  (M, p)
  /// @throws NotConverged, Singular  where the step is too long for the scheme
  template <class T>
  Pose<T> free_motion(int body, Matrix<T, 6, 1> const& momentum, T const& h) const {
    Matrix<T, 3, 1> const hM = momentum.template head<3>() * h;
    Matrix<T, 3, 1> turn;
    for (int i = 0; i < 3; ++i) turn[i] = hM[i] / T(bodies_[body].inertia[i]);
    auto const scheme = [&](auto const& F, auto const& target) {
      using U = typename std::decay_t<decltype(F)>::Scalar;
      Matrix<U, 3, 1> left;
      for (int i = 0; i < 3; ++i) {
        int const j = (i + 1) % 3, k = (i + 2) % 3;
        left[i] = F.value(k, j) * U(mass_moment(body, j)) - F.value(j, k) * U(mass_moment(body, k));
      }
      return Momentum<SO<3>, U>{{}, left} - like(F, target);
    };
    auto const F = solve_implicit(scheme, Momentum<SO<3>, T>{{}, hM}, exp(velocity(SO<3>{}, turn)));
    Matrix<T, 4, 4> f = Matrix<T, 4, 4>::Identity();
    f.template topLeftCorner<3, 3>() = F.value;
    for (int i = 0; i < 3; ++i) f(i, 3) = h / T(bodies_[body].mass()) * momentum[3 + i];
    return {{}, f};
  }
  /// How both move freely.
  template <class T>
  std::array<Pose<T>, 2> free_motions(DualPoint<TwoPoses, T> const& p, T const& h) const {
    return {free_motion<T>(0, p.components.template head<6>(), h),
            free_motion<T>(1, p.components.template tail<6>(), h)};
  }
  /// The arrow along which bodies with these momenta move freely, and the momenta at its end.
  template <class T>
  std::pair<Arrow<TwoPoses, T>, DualPoint<TwoPoses, T>> drift(DualPoint<TwoPoses, T> const& p,
                                                              T const& h) const {
    auto const f = free_motions(p, h);
    auto const arrow = TwoPoses::moving(p.base, f);
    return {arrow, {TwoPoses::target(arrow), carried(f, p.components)}};
  }
  /// \f$F_i^T\f$ applied to both momenta of each body.
  template <class T>
  static Fibre<TwoPoses, T> carried(std::array<Pose<T>, 2> const& f, Fibre<TwoPoses, T> const& p) {
    Fibre<TwoPoses, T> moved;
    for (int part = 0; part < 4; ++part)
      for (int i = 0; i < 3; ++i) {
        T sum(0);
        for (int j = 0; j < 3; ++j) sum += f[part / 2].value(j, i) * p[3 * part + j];
        moved[3 * part + i] = sum;
      }
    return moved;
  }
  /// The step: half a kick, a drift, half a kick. It solves the Lagrange equations of \ref lagrangian without
  /// an iteration on the groupoid.
  /// @param p  the momentum at the start of the arrow, `legendre_at_source`
  template <class T>
  std::pair<Arrow<TwoPoses, T>, DualPoint<TwoPoses, T>> step(DualPoint<TwoPoses, T> const& p,
                                                             T const& h) const {
    // [pair_step]
    T const half = h / T(2);
    auto const [arrow, end] = drift(kicked(p, half), h);
    return {arrow, kicked(end, half)};
    // [pair_step]
  }

 private:
  template <class T>
  static Arrow<TwoPoses, T> const& on_arrows(Arrow<TwoPoses, T> const& arrow) {
    return arrow;
  }
  template <class T>
  static Arrow<TwoPoses, T> on_arrows(PairArrow<DirectProduct<SE<3>, SE<3>>, T> const& pair) {
    auto const [g1, g2] = factors(pair.first);
    auto const [later_1, later_2] = factors(pair.second);
    return TwoPoses::reduced<T>({g1, g2}, {later_1, later_2});
  }
  double mass_moment(int body, int i) const {
    auto const& I = bodies_[body].inertia;
    return (I[0] + I[1] + I[2]) / 2 - I[i];
  }

  std::array<ExtendedBody, 2> bodies_;
  int order_;
  double G_;
};

}  // namespace actio::bodies
