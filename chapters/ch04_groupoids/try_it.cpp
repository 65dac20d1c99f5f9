// The lines to try of chapters 4 and 4A.
#include "book/try_it.hpp"
#include "actio/groupoid/gauge_groupoid.hpp"
#include "actio/groupoid/generating_series.hpp"
#include "actio/groupoid/group_as_groupoid.hpp"
#include "actio/groupoid/hamilton_jacobi.hpp"
#include "actio/groupoid/lagrange_equations.hpp"
#include "actio/groupoid/pair_groupoid.hpp"
#include "actio/groupoid/poisson_on_group.hpp"
#include "actio/groups/unipotent_groups.hpp"
#include "actio/instruments/leaf_defect.hpp"
#include "actio/instruments/poisson_defect.hpp"
#include "actio/numbers/print.hpp"
#include "actio/reduction/composition.hpp"
#include "actio/reduction/discrete_poisson.hpp"
#include "actio/reduction/galerkin.hpp"
#include "actio/reduction/natural_chart.hpp"
#include "running_examples.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;

TRY_IT(lamp_on_arrows) {
  auto const action = []<class S>(S const& theta0, S const& theta1, S const& cos_turn) {
    using std::cos, std::sin;
    S const rise = S(1) - cos(theta0) * cos(theta1) - sin(theta0) * sin(theta1) * cos_turn;
    return S(rise / S(0.1) + (cos(theta0) + cos(theta1)) * S(0.05));
  };
  auto const on_pairs = [&](auto const& a) {
    using std::cos;
    return action(a.first.value[0], a.second.value[0], cos(a.second.value[1] - a.first.value[1]));
  };
  auto const on_arrows = [&](auto const& a) { return action(a.from[0], a.to[0], a.element.value(0, 0)); };
  auto const at = [](double theta, double phi) { return Element<Translations<2>, double>{{}, {theta, phi}}; };
  auto const arrow = [](double theta0, double theta1, double turn) {
    return GaugeArrow<SO<2>, double>{Vector<double>::Constant(1, theta0), Vector<double>::Constant(1, theta1),
                                     exp(velocity(SO<2>{}, Matrix<double, 1, 1>(turn)))};
  };
  PairArrow<Translations<2>, double> const first{at(0.9, 2.0), at(0.8, 2.1)},
      second{first.second, at(0.8, 2.3)};
  print("pairs of positions", lagrange_equations(PairGroupoid<Translations<2>>{}, on_pairs, first, second));
  print("heights and turns ", lagrange_equations(GaugeGroupoid<SO<2>>{{}, 1}, on_arrows, arrow(0.9, 0.8, 0.1),
                                                 arrow(0.8, 0.8, 0.2)));
}

TRY_IT(one_equation_on_two_groupoids) {
  auto const l = natural_chart_lagrangian_right(ball_in_field(), 0.1);
  auto const on_pairs = [&](auto const& arrow) { return l(arrow.first * inverse(arrow.second)); };
  auto const g = [](double x, double y, double z) { return exp(velocity(SO<3>{}, Vector3d(x, y, z))); };
  PairArrow<SO<3>, double> const first{g(0, 0, 0), g(0.1, -0.3, 0.2)},
      second{first.second, g(0.4, -0.2, 0.1)};
  auto const f01 = first.first * inverse(first.second), f12 = second.first * inverse(second.second);
  print("(4.1.1) on pairs    ", lagrange_equations(PairGroupoid<SO<3>>{}, on_pairs, first, second));
  print("(4.1.1) on the group", lagrange_equations(GroupAsGroupoid<SO<3>>{}, l, f01, f12));
  print("(3.10)              ", euler_poincare_right(l, f01, f12));
}

TRY_IT(exact_action_of_the_ball) {
  Vector3d const larmor = ball_field / ball_inertia;
  auto const action = [&]<class S>(Element<SO<3>, S> const& f, S const& t) {
    auto const frame = exp(velocity(SO<3>{}, Vector<S, 3>(t * larmor[0], t * larmor[1], t * larmor[2])));
    auto const turn = log(frame * inverse(f)).coordinates;
    return S((turn.dot(turn) / t - t * larmor.squaredNorm()) * (ball_inertia / 2));
  };
  auto const energy = [](auto const& mu) {
    auto const spin = (mu.components - ball_field).eval();
    return spin.dot(spin) / (2 * ball_inertia);
  };
  auto const f = exp(velocity(SO<3>{}, Vector3d(-0.3, 0.2, -0.4)));
  auto const later = [&](auto const& k, auto const& t) { return action(k, decltype(t + t)(t + 0.1)); };
  auto const twice = [&](auto const& k, auto const& t) { return action(k, t) * 2.0; };
  print("(4.1), action at t      ", hamilton_jacobi_right(action, energy, f, 0.5));
  print("(4.1), action at t + 0.1", hamilton_jacobi_right(later, energy, f, 0.5));
  print("(4.1), twice the action ", hamilton_jacobi_right(twice, energy, f, 0.5));
  auto const mu = momentum(SO<3>{}, Vector3d(2e-4, 1e-4, 5e-4));
  print("a step of 1 s by (4.2), (4.3)", hamilton_jacobi_step_right(at_time(action, 1.0), mu, f).final);
  print("the precession               ", Ad_star(exp(velocity(SO<3>{}, larmor)), mu));
}

TRY_IT(one_bracket_two_ways) {
  auto const l = natural_chart_lagrangian_right(ball_in_field(), 0.1);
  auto const f = exp(velocity(SO<3>{}, Vector3d(-0.3, 0.2, -0.4)));
  auto const unit = 1 / ball_inertia;
  print("by reduction, (3.13)", reduced_bivector_right(l, f) / unit);
  print("pulled back along +R*l'", legendre_bivector_right(l, f) / unit);
}

TRY_IT(orbit_kept_bracket_lost) {
  auto const lie_euler = []<class S>(S const& h, Momentum<SO<3>, S> const& Pi) {
    auto const Omega = velocity(Pi.group, Vector<S, 3>(Pi.components.cwiseQuotient(book_inertia.cast<S>())));
    return Ad_star(exp(h * Omega), Pi);
  };
  auto const one_step = [&]<class S>(Momentum<SO<3>, S> const& Pi) { return lie_euler(S(0.02), Pi); };
  auto const Pi = momentum(SO<3>{}, Vector3d(0.01, 0.03, 0.02));
  print("leaf defect   ", leaf_defect(LiePoissonMinus{}, lie_euler, 0.02, Pi));
  print("Poisson defect", poisson_defect(LiePoissonMinus{}, one_step, Pi));
}

TRY_IT(conditions_of_composition) {
  print("one step       ", composition_conditions(std::vector<double>{1}));
  print("triple jump    ", composition_conditions(triple_jump<double>()));
  print("Suzuki, five   ", composition_conditions(suzuki<double>()));
  print("Kahan-Li, nine ", composition_conditions(kahan_li<double>()));
}

TRY_IT(series_and_action) {
  Vector3d const larmor = ball_field / ball_inertia;
  Matrix<double, 3, 3> const inertia = ball_inertia * Matrix<double, 3, 3>::Identity();
  auto const series = generating_series(QuadraticLagrangian<SO<3>, double>(SO<3>{}, inertia, ball_field), 4);
  auto const w = velocity(SO<3>{}, Vector3d(1.0, 0.5, -0.3));
  for (double t : {0.4, 0.2, 0.1}) {
    auto const turn = log(exp(t * velocity(SO<3>{}, larmor)) * exp(t * w)).coordinates;
    double const action = (turn.squaredNorm() / t - t * larmor.squaredNorm()) * (ball_inertia / 2);
    print("the series less the action, over t^7", (series(exp(-t * w), t) - action) / std::pow(t, 7));
  }
}

TRY_IT(galerkin_and_gauss) {
  double const root = std::sqrt(3.0) / 6, a[2][2] = {{0.25, 0.25 - root}, {0.25 + root, 0.25}};
  Vector3d const inertia(1.0, 1.7, 2.4), wheel(0.3, -0.2, 0.5);
  auto const l = [&]<class S>(Velocity<SO<3>, S> const& xi) {
    S sum(0);
    for (int i = 0; i < 3; ++i)
      sum += xi.coordinates[i] * (xi.coordinates[i] * (inertia[i] / 2) + S(wheel[i]));
    return sum;
  };
  auto const minus_ad = [](auto const& eta) { return (-ad_matrix(velocity(SO<3>{}, eta))).eval(); };
  auto const start = momentum_state(l, velocity(SO<3>{}, Vector3d(0.9, 0.4, -0.7)));
  Vector3d const p = start.momentum.components;
  auto const gauss_step = [&](double h) {
    Vector3d rate[2] = {{0, 0, 0}, {0, 0, 0}}, force[2] = {{0, 0, 0}, {0, 0, 0}};  // of eta and of q
    for (int round = 0; round < 100; ++round)
      for (int i = 0; i < 2; ++i) {
        Vector3d const eta = h * (a[i][0] * rate[0] + a[i][1] * rate[1]);
        Vector3d const q = p + h * (a[i][0] * force[0] + a[i][1] * force[1]);
        Matrix<double, 3, 3> const back = chi(minus_ad(eta));  // the inverse of iex
        rate[i] = back * Vector3d((back.transpose() * q - wheel).cwiseQuotient(inertia));
        auto const in_the_chart = [&]<class S>(Vector<S, 3> const& x) {
          return l(velocity(SO<3>{}, Vector<S, 3>(iex(minus_ad(x)) * rate[i].template cast<S>())));
        };
        force[i] = derivative(in_the_chart, eta).gradient();
      }
    Vector3d const end = h / 2 * (rate[0] + rate[1]), q = p + h / 2 * (force[0] + force[1]);
    return Vector3d(chi(minus_ad(end)).transpose() * q);
  };
  for (double h : {0.4, 0.2, 0.1}) {
    auto const galerkin =
        take_steps(galerkin_step_left<double>(l, 2), start, std::vector{h}).momentum.components;
    Vector3d const gauss = gauss_step(h);
    print("Galerkin less Gauss, over h^5", (galerkin - gauss).norm() / std::pow(h, 5));
    print("  change of |Pi|, Galerkin   ", galerkin.norm() - p.norm());
    print("  change of |Pi|, Gauss      ", gauss.norm() - p.norm());
  }
}

TRY_IT_MAIN("the lines to try of chapters 4 and 4A")
