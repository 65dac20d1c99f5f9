// Section 7.0: constraints without derivatives in time, and which principle gives the equations.
#include "statement.hpp"

#include "actio/constraints/augmented.hpp"
#include "actio/constraints/constrained_equations.hpp"
#include "actio/constraints/multiplier_theorem.hpp"
#include "actio/jets/action.hpp"
#include "fields.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// The constraint \f$w = F(x, u, \partial u)\f$ on fields (u, w) over a string, n = 1, N = 2, with a
/// quadratic F that depends on the derivative in time only where it is asked to.
template <class S>
struct SpatialConstraint {
  static constexpr int components = 1;
  Matrix<S, 3, 1> a, b;
  S in_time;  ///< how F depends on the derivative in time

  /// F at a point, for a value and the derivatives of u.
  template <class T>
  T F(T const& u, T const& u_t, T const& u_s) const {
    return u * T(a[0]) + u_s * T(a[1]) + u * u * T(b[0]) + u * u_s * T(b[1]) + u_s * u_s * T(b[2]) +
           u_t * T(in_time) + T(a[2]);
  }
  template <class T>
  Matrix<T, 1, 1> operator()(Jet<T, 1, 2> const& j) const {
    return Matrix<T, 1, 1>(j.y[1] - F(j.y[0], j.v(0, 0), j.v(0, 1)));
  }
};

/// A section that satisfies the constraint: u is any, and w is what it must be.
template <class S, class U>
struct Satisfying {
  SpatialConstraint<S> Phi;
  U u;
  template <class V>
  auto operator()(V const& x) const {
    using T = ScalarOf<V>;
    // The derivatives of u at points over any scalar, by one more infinitesimal.
    auto const j = first_jet(u, x);
    return Matrix<T, 2, 1>(j.y[0], Phi.F(j.y[0], j.v(0, 0), j.v(0, 1)));
  }
};

/// u + step times w, where w vanishes with its derivatives on the sides of the unit box.
template <class S, class T>
struct MovedField {
  Cubic<S, 2> u;
  T step;
  template <class V>
  auto operator()(V const& x) const {
    using R = ScalarOf<V>;
    R bump(1);
    for (int mu = 0; mu < 2; ++mu) bump *= x[mu] * (R(1) - x[mu]);
    return Matrix<R, 1, 1>(u.constant + u.a[0] * x[0] + u.a[1] * x[1] + u.b[0] * x[0] * x[1] +
                           bump * bump * R(step));
  }
};

/// A density of the second degree on (u, w) over a string.
template <class S>
struct QuadraticDensity {
  Matrix<S, 8, 1> a, b;
  template <class T>
  T operator()(Jet<T, 1, 2> const& j) const {
    auto const c = coordinates(j);
    T first(0), second(0);
    for (int i = 0; i < 8; ++i) first += c[i] * T(a[i]), second += c[i] * T(b[i]);
    return first * second + first;
  }
};

/// Three principles for one motion, integrated over the unit box.
template <class S>
struct Principles {
  S restricted;    ///< derivative of the action along sections that satisfy the constraint
  S multiplier;    ///< pairing of the equations with multiplier, which hold in w, with the variation of u
  S virtual_work;  ///< work of the free equations on displacements that satisfy the constraint at each time
};
template <class S>
Principles<S> principles(QuadraticDensity<S> const& L, SpatialConstraint<S> const& Phi,
                         Cubic<S, 2> const& u) {
  Box<S, 1> const box{Event<S, 1>::Zero(), Event<S, 1>::Ones()};
  MovedField<S, S> const field{u, S(0)}, bump{Cubic<S, 2>{S(0), Event<S, 1>::Zero(), Event<S, 1>::Zero(),
                                                          Event<S, 1>::Zero(), Event<S, 1>::Zero()},
                                              S(1)};
  Satisfying<S, MovedField<S, S>> const phi{Phi, field};
  Dual<S> step(0);
  step.part[0] = S(1);
  Satisfying<S, MovedField<S, Dual<S>>> const moved{Phi, {u, step}};
  // The multiplier that makes the equation in w hold: as the constraint is w - F, it is -E_w.
  auto const lambda = [&](auto const& x) {
    return Matrix<ScalarOf<decltype(x)>, 1, 1>(-euler_lagrange(L, phi, x)[1]);
  };
  // Places of degree 4 in each coordinate, quadratic, times a bump of degree 4.
  int const degree = 14;
  Principles<S> p;
  p.restricted = integral(
      [&](Event<S, 1> const& x) {
    return S(L(first_jet(moved, Event<Dual<S>, 1>(x.template cast<Dual<S>>()))).part[0]);
      },
      box.low, box.high, degree);
  p.multiplier = integral(
      [&](Event<S, 1> const& x) {
    auto const j = second_jet(phi, x);
    Matrix<S, 2, 1> const E = euler_lagrange(L, j) + reaction(Phi, j, first_jet(lambda, x));
    return S(E[0] * bump(x)[0]);
      },
      box.low, box.high, degree);
  p.virtual_work = integral(
      [&](Event<S, 1> const& x) {
    Matrix<S, 2, 1> const E = euler_lagrange(L, phi, x);
    // At a fixed time: the linearised constraint, without the derivative in time.
    auto const j = first_jet(field, x), w = first_jet(bump, x);
    Dual<S> value(j.y[0]), slope(j.v(0, 1));
    value.part[0] = w.y[0], slope.part[0] = w.v(0, 1);
    return S(E[0] * w.y[0] + E[1] * Phi.F(value, Dual<S>(j.v(0, 0)), slope).part[0]);
      },
      box.low, box.high, degree);
  return p;
}

/// The motion of a free particle under dz = y dx by virtual work: accelerations from position and velocity,
/// with the reaction along (-y, 0, 1).
template <class S>
Matrix<S, 3, 1> virtual_work_acceleration(S const& y, Matrix<S, 2, 1> const& velocity) {
  // z'' = y' x' + y x'' with x'' = -y mu, z'' = mu.
  S const mu = velocity[0] * velocity[1] / (S(1) + y * y);
  return {-y * mu, S(0), mu};
}

}  // namespace

STATEMENT(claim_7_0_spatial_constraints,
          "constraints with spatial derivatives only, and restriction of the principle") {
  claim.convention(
      "Where the constrained sections are a submanifold, the boundary conditions included. Then Hamilton's "
      "principle on them, the multiplier and virtual work give the same equations; with "
      "derivatives in time the first two still agree, and virtual work does not.");
  std::string const name = "(u, w) on a string, w = F(u, u_s)", timed = "w = F(u, u_s, u_t)";
  {
    QuadraticDensity<S> const L{draw.vector<S, Matrix<S, 8, 1>>(8), draw.vector<S, Matrix<S, 8, 1>>(8)};
    auto const u = draw_cubic<S, 2>(draw);
    SpatialConstraint<S> Phi{draw.vector<S, Matrix<S, 3, 1>>(3), draw.vector<S, Matrix<S, 3, 1>>(3), S(0)};
    // Terms of size one in the integrand, which cancel in part.
    double const condition = 100;
    auto const in_space = principles(L, Phi, u);
    claim.zero("action on constrained sections, and equations with multiplier", name,
               S(in_space.restricted - in_space.multiplier), in_space.restricted, condition);
    claim.zero("action on constrained sections, and virtual work", name,
               S(in_space.restricted - in_space.virtual_work), in_space.restricted, condition);
    Phi.in_time = S(1);
    auto const in_time = principles(L, Phi, u);
    claim.zero("action on constrained sections, and equations with multiplier", timed,
               S(in_time.restricted - in_time.multiplier), in_time.restricted, condition);
    claim.refutes("action on constrained sections, and virtual work", timed,
                  S(in_time.restricted - in_time.virtual_work), in_time.restricted);
  }

  // A particle under dz = y dx, a constraint on velocities. Along the motion by virtual work the equations
  // with multiplier are x'' = (lambda y)', y'' = -lambda x', z'' = -lambda'. As y'' = 0 the second leaves
  // lambda = 0, and the third a z'' that is not zero.
  S const y = draw.number<S>() + S(2);
  Matrix<S, 2, 1> const velocity = draw.vector<S, Matrix<S, 2, 1>>(2) + Matrix<S, 2, 1>(S(2), S(2));
  auto const acceleration = virtual_work_acceleration(y, velocity);
  claim.zero("the constraint along the motion by virtual work", "particle under dz = y dx",
             S(acceleration[2] - velocity[1] * velocity[0] - y * acceleration[0]), S(1), 10);
  claim.refutes("the third of those equations, without a multiplier", "particle under dz = y dx",
                acceleration[2], S(1));

  // Zeros that are no submanifold: q^2 = 0 has the zeros of q = 0 and no reaction.
  auto const square = constrained<1>([]<class T>(Matrix<T, 1, 1> const& q) { return q[0]; },
                                     []<class T>(Matrix<T, 1, 1> const& q) { return (q * q[0]).eval(); });
  Matrix<S, 1, 1> const origin = Matrix<S, 1, 1>::Zero();
  claim.template refuses<NotRegular>("a multiplier for the constraint q^2 = 0", "line",
                                     [&] { square.multiplier(origin); });
}
