// Chapter 10: what Part II says of other models. Rods and shells with directors.
#include "fields/fields.hpp"

#include "actio/constraints/constrained_equations.hpp"
#include "actio/constraints/directors.hpp"
#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// How many vectors an energy depends on, and how many scalar products they have.
template <int n>
inline constexpr int vectors = 2 * n + 1;
template <int n>
inline constexpr int products = vectors<n> * (vectors<n> + 1) / 2;

/// An energy that is invariant under rotations of space: a cubic in the point of the body and all scalar
/// products. Twisted, it depends on a fixed direction as well.
template <class S, int n>
struct StrainEnergy {
  Cubic<S, n + products<n>> w;

  template <class T>
  Matrix<T, n + products<n>, 1> arguments(Matrix<T, n, 1> const& x,
                                          Matrix<T, vectors<n>, vectors<n>> const& products_of) const {
    Matrix<T, n + products<n>, 1> all;
    int k = 0;
    for (int i = 0; i < n; ++i) all[k++] = x[i];
    for (int i = 0; i < vectors<n>; ++i)
      for (int j = 0; j <= i; ++j) all[k++] = products_of(i, j);
    return all;
  }
  template <class T>
  T operator()(Matrix<T, n, 1> const& x, Matrix<T, vectors<n>, vectors<n>> const& products_of) const {
    return w(arguments(x, products_of));
  }

  /// The derivatives of W in the vectors by the chain rule, written out: column i is the sum over j of
  /// (1 + delta_ij) W_ij times vector j.
  template <class T>
  Matrix<T, 3, vectors<n>> forces(Matrix<T, n, 1> const& x, Matrix<T, 3, vectors<n>> const& frame) const {
    auto const at = arguments(x, Matrix<T, vectors<n>, vectors<n>>(frame.transpose() * frame));
    T b(0), d(0), e(0);
    for (int i = 0; i < at.size(); ++i)
      b += at[i] * T(w.b[i]), d += at[i] * T(w.d[i]), e += at[i] * T(w.e[i]);
    Matrix<T, 3, vectors<n>> f = Matrix<T, 3, vectors<n>>::Zero();
    for (int i = 0, k = n; i < vectors<n>; ++i)
      for (int j = 0; j <= i; ++j, ++k) {
        T const rate = T(w.a[k]) + d * T(w.b[k]) + b * T(w.d[k]) + e * e * T(S(w.e[k] * S(3)));
        for (int c = 0; c < 3; ++c) {
          f(c, i) += rate * frame(c, j);
          f(c, j) += rate * frame(c, i);
        }
      }
    return f;
  }
};

/// What balances in a body with a director, at one jet: momenta per volume of the body, and the forces and
/// torques that pass from part to part along each coordinate.
template <class T, int n>
struct Balance {
  Matrix<T, 3, 1> momentum, moment;
  Matrix<T, 3, n> force, torque;
};

/// The unit director gives no force, the normal director a shear force along itself for each coordinate.
template <class T, int n>
Matrix<T, 3, n> reaction_forces(UnitDirector const&, Jet<T, n, 6> const&, Matrix<T, 1, 1> const&) {
  return Matrix<T, 3, n>::Zero();
}
template <class T, int n>
Matrix<T, 3, n> reaction_forces(NormalDirector<n> const&, Jet<T, n, 6> const& j,
                                Matrix<T, n + 1, 1> const& lambda) {
  Matrix<T, 3, n> f;
  for (int i = 0; i < n; ++i)
    for (int c = 0; c < 3; ++c) f(c, i) = -lambda[i] * j.y[3 + c];
  return f;
}

/// Momentum and moment of momentum, force and torque, as a mechanic writes them down: nothing here knows of a
/// Lagrangian.
template <class S, class T, int n, class Phi>
Balance<T, n> balance(DirectedBody<S, StrainEnergy<S, n>> const& body, Phi const& constraint,
                      Jet<T, n, 6> const& j, Matrix<T, Phi::components, 1> const& lambda) {
  using V = Matrix<T, 3, 1>;
  V const r = j.y.template head<3>(), d = j.y.template tail<3>();
  V const momentum = j.v.col(0).template head<3>() * T(body.rho),
          spin = j.v.col(0).template tail<3>() * T(body.iota);
  auto const frame = director_frame(j);
  auto const stress = body.W.forces(j.particle(), frame);
  auto const reactions = reaction_forces(constraint, j, lambda);
  Balance<T, n> b;
  b.momentum = momentum;
  b.moment = cross(r, momentum) + cross(d, spin);
  for (int i = 0; i < n; ++i) {
    V const force = stress.col(i) + reactions.col(i), couple = stress.col(n + 1 + i);
    b.force.col(i) = force;
    b.torque.col(i) = cross(r, force) + cross(d, couple);
  }
  return b;
}

/// What the balances leave along a section: \f$\partial_t\f$(momentum) - \f$\partial_i\f$(force), and the
/// same for the moments.
template <class S, int n, class Phi>
std::pair<Matrix<S, 3, 1>, Matrix<S, 3, 1>> imbalance(DirectedBody<S, StrainEnergy<S, n>> const& body,
                                                      Phi const& constraint, SecondJet<S, n, 6> const& j,
                                                      Jet<S, n, Phi::components> const& lambda) {
  Matrix<S, 3, 1> momentum, moment;
  for (int mu = 0; mu <= n; ++mu) {
    Matrix<Dual<S>, Phi::components, 1> moved = lambda.y.template cast<Dual<S>>();
    for (int i = 0; i < Phi::components; ++i) moved[i].part[0] = lambda.v(i, mu);
    auto const b = balance<S, Dual<S>, n>(body, constraint, along(j, mu), moved);
    for (int c = 0; c < 3; ++c) {
      if (mu == 0)
        momentum[c] = b.momentum[c].part[0], moment[c] = b.moment[c].part[0];
      else
        momentum[c] -= b.force(c, mu - 1).part[0], moment[c] -= b.torque(c, mu - 1).part[0];
    }
  }
  return {momentum, moment};
}

/// k cubics over space-time.
template <class S, int n, int k>
struct Cubics {
  std::array<Cubic<S, n + 1>, k> c;
  template <class V>
  auto operator()(V const& x) const {
    Matrix<ScalarOf<V>, k, 1> y;
    for (int i = 0; i < k; ++i) y[i] = c[i](x);
    return y;
  }
};

}  // namespace

STATEMENT(claim_10_0_rods_and_shells, "rod and shell models within the constrained formalism") {
  claim.holds(
      "For a rod with a director of unit length and a shell whose director is the unit normal, and "
      "any strain energy that does not depend on where space is turned to: the field equations of "
      "the extended bundle are the balance of momentum and, the multiplier of the length dropping "
      "out, that of moment of momentum.");
  // A cubic in scalar products of cubics, differentiated twice, and a product with places.
  auto const model = [&]<int n, class Phi>(std::integral_constant<int, n>, Phi const& constraint,
                                           std::string const& name) {
    constexpr int k = Phi::components;
    DirectedBody<S, StrainEnergy<S, n>> const body{draw.number<S>() + S(2),
                                                   draw.number<S>() + S(2),
                                                   {draw_cubic<S, n + products<n>>(draw, ratio<S>(1, 8))}};
    auto const phi = draw_section<S, n, 6>(draw);
    Cubics<S, n, k> lambda;
    for (auto& c : lambda.c) c = draw_cubic<S, n + 1>(draw);
    // One jet of the extended bundle, and its parts.
    auto extended = second_jet(ExtendedSection<AnySection<S, n, 6>, Cubics<S, n, k>>{phi, lambda},
                               draw_event<S, n>(draw));
    SecondJet<S, n, 6> j{configuration<6>(extended), {}};
    for (int mu = 0; mu <= n; ++mu) j.w[mu] = extended.w[mu].template topRows<6>();
    auto const [momentum, moment] = imbalance(body, constraint, j, multiplier_part<k>(extended));
    // r x E_r + d x E_d.
    auto const moment_of = [&](Matrix<S, 6, 1> const& E) {
      using V = Matrix<S, 3, 1>;
      return V(cross(V(j.y.template head<3>()), V(E.template head<3>())) +
               cross(V(j.y.template tail<3>()), V(E.template tail<3>())));
    };
    AugmentedDensity<DirectedBody<S, StrainEnergy<S, n>>, Phi> const augmented{body, constraint};
    Matrix<S, 6 + k, 1> const all = -euler_lagrange(augmented, extended);
    Matrix<S, 6, 1> const E = all.template head<6>();
    claim.equal("field equations of the place, and balance of momentum", name,
                Matrix<S, 3, 1>(E.template head<3>()), momentum);
    claim.equal("their moment, and balance of moment of momentum", name, moment_of(E), moment);
    claim.equal("field equations of the multipliers, and the constraint", name,
                Matrix<S, k, 1>(-all.template tail<k>()), constraint(configuration<6>(extended)));
    extended.y.template tail<k>().setZero();
    extended.v.template bottomRows<k>().setZero();
    Matrix<S, 6, 1> const free = -euler_lagrange(augmented, extended).template head<6>();
    claim.differs("field equations of the director without its reaction", name,
                  Matrix<S, 3, 1>(free.template tail<3>()), Matrix<S, 3, 1>(E.template tail<3>()));
    // An energy with the square of the first component of the director prefers a direction of space.
    Matrix<S, 6, 1> preferred = E;
    preferred[3] += j.y[3] * S(2);
    claim.differs("moment of momentum with an energy that prefers a direction of space", name,
                  moment_of(preferred), moment);
  };
  {
    model(std::integral_constant<int, 1>{}, UnitDirector{}, "rod with a unit director");
    model(std::integral_constant<int, 2>{}, NormalDirector<2>{}, "shell with a normal director");
  }
}
