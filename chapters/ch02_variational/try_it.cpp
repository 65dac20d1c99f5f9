// Lines to try of chapter 2.
#include "actio/groups/affine_line.hpp"
#include "actio/groups/rotations.hpp"
#include "actio/linear_algebra/rank.hpp"
#include "actio/numbers/print.hpp"
#include "actio/variational/action.hpp"
#include "actio/variational/coadjoint_orbit.hpp"
#include "actio/variational/euler_lagrange.hpp"
#include "actio/variational/euler_poincare.hpp"
#include "actio/variational/lie_poisson.hpp"
#include "actio/variational/momentum_map.hpp"
#include "book/try_it.hpp"
#include "running_examples.hpp"
using namespace actio;
using Vector1 = actio::Vector<double, 1>;
using Vector2 = actio::Vector<double, 2>;
using Vector3 = actio::Vector<double, 3>;

TRY_IT(pendulum) {
  auto const pendulum = [](auto const& v) {  // v is a State, at any scalar
    auto const& xi = v.velocity.coordinates[0];
    auto const cosine = v.configuration.value(0, 0);  // of the angle
    return xi * xi / 2.0 + 9.81 * cosine;
  };
  auto const g = exp(velocity(SO<2>{}, Vector1(0.5)));
  State<SO<2>, double> const v{g, velocity(SO<2>{}, Vector1(2.0))};
  print("acceleration", lagrange_acceleration(pendulum, v));
  print("-9.81 sin(0.5)", -9.81 * std::sin(0.5));
  print("regular: d2L/dxi2", fibre_hessian(pendulum, v));
  print("energy", energy(pendulum, v));
}

TRY_IT(moving_ends) {
  auto const L = right_invariant(ball_in_field());
  auto const a = velocity(SO<3>{}, Vector3(0.3, -0.2, 0.5));
  auto const b = velocity(SO<3>{}, Vector3(0.1, 0.4, -0.3));
  auto const curve = [&]<class T>(T const& t) {
    return retract(t * over<T>(a)) * retract(t * t * over<T>(b));
  };
  auto const family = [&]<class T>(T const& e, T const& t) {
    T const shift = e * t;
    return retract(shift * over<T>(b)) * curve(t);
  };
  auto const integrand = [&](double t) {
    auto const D = euler_lagrange(L, tangent(curve, t), second_tangent(curve, t).velocity);
    return pair(D, lifted_variation(family, t).configuration);
  };
  Quadrature<double> const rule(24);
  auto const end = [&](double t) {
    return lagrange_one_form(L, tangent(curve, t), lifted_variation(family, t));
  };
  double const inside = rule(integrand, 0.0, 1.0);
  print("dS", action_variation(L, family, 0.0, 1.0, rule));
  print("integral alone", inside);
  print("integral and boundary term", inside + end(1.0) - end(0.0));
}

TRY_IT(two_momenta) {
  auto const L = right_invariant(ball_in_field());
  auto const g = exp(velocity(SO<3>{}, Vector3(0.4, 0.1, -0.7)));
  State<SO<3>, double> const v{g, velocity(SO<3>{}, Vector3(2.0, 1.0, -3.0))};
  auto const later = moved(v, lagrange_vector_field(L, v));  // a dual number
  auto const zeta = velocity(SO<3>{}, Vector3(1.0, 0.0, 0.0));
  auto const rate = [&](auto const& generator) {
    auto const J = noether_momentum(L, later, generator);
    return J.part[0];
  };
  print("rate of J, turns from the right", rate(right_translation(zeta)));
  print("rate of J, turns from the left", rate(left_translation(zeta)));
}

TRY_IT(larmor) {
  auto const l = ball_in_field();
  auto const xi = velocity(SO<3>{}, Vector3(2.0, 1.0, -3.0));
  auto const mu = gradient(l, xi);
  auto const h = [](auto const& m) {
    auto const x = [&](int i) { return m.components[i] - ball_field[i]; };
    return (x(0) * x(0) + x(1) * x(1) + x(2) * x(2)) / (2 * ball_inertia);
  };
  print("mu'", lie_poisson_rate_right(h, mu));
  print("mu x gamma B / I", Vector3(mu.components.cross(ball_field) / ball_inertia));
  auto const rate = euler_poincare_acceleration_right(l, xi);
  print("Euler-Poincaré", Vector3(ball_inertia * rate.coordinates));
}

TRY_IT(stars_matter) {
  auto const g = exp(velocity(Aff1{}, Vector2(0.3, 0.8)));
  auto const mu = momentum(Aff1{}, Vector2(0.5, 2.0));
  print("on its orbit", Ad_star(inverse(g), mu));
  print("Ad without the star", Vector2(Ad_matrix(g) * mu.components));
  print("rank of the bracket", matrix_rank(lie_poisson_tensor_plus(mu)));
}
TRY_IT_MAIN("the lines to try of chapter 2")
