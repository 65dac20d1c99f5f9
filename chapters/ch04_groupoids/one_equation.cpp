// One equation, four systems: the Lagrange equations on a groupoid, as one template.
//
// What is shown. A pendulum that swings in all directions and a top under gravity, each solved twice by the
// same function `step_lagrange`: on pairs of configurations, which is discrete Euler-Lagrange, and on the
// groupoid that its symmetry leaves: pairs of heights with a turn between them, rotations with the vertical
// in the body frame. The two roads agree to rounding; the second does not use the attitude, and its equations
// are fewer or simpler. Read first. The section "Mechanics on a groupoid" of chapter 4.
//
//   theta, phi angle from the downward vertical, azimuth R, gamma attitude of the top, the vertical in its
//   body
//   h            step, s; every Lagrangian is an action, J s
#include "actio/groupoid/action_groupoid.hpp"
#include "actio/groupoid/gauge_groupoid.hpp"
#include "actio/groupoid/lagrange_equations.hpp"
#include "actio/groupoid/pair_groupoid.hpp"
#include "actio/groups/rotations.hpp"
#include "actio/groups/unipotent_groups.hpp"
#include "book/program.hpp"
#include "book/sphere.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;
double const h = 0.02, gravity = 9.81;

// The pendulum, 1 kg on 1 m: the chord between two configurations, and the mean of two heights. Only the turn
// between the azimuths counts.
template <class S>
S pendulum(S const& theta0, S const& theta1, S const& cos_turn) {
  using std::cos, std::sin;
  S const chord = S(2) - (sin(theta0) * sin(theta1) * cos_turn + cos(theta0) * cos(theta1)) * S(2);
  return chord / S(2 * h) + (cos(theta0) + cos(theta1)) * S(h * gravity / 2);
}
// The top: the trace Lagrangian of its turning, and the mean height of a weight on its third axis.
template <class S, class Turn, class V>
S top(Turn const& turn, V const& gamma0, V const& gamma1) {
  Vector3d const lambda(0.9, 0.9, 0.1);
  S sum(0);
  for (int i = 0; i < 3; ++i) sum += (S(1) - turn(i, i)) * S(lambda[i]);
  return sum / S(h) - (gamma0[2] + gamma1[2]) * S(h * gravity / 2);
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "a spherical pendulum and a top, each on two groupoids, by one equation");
  int const steps = 1500;

  // 1. The pendulum on pairs of (theta, phi), and on the gauge groupoid (theta0, theta1, turn).
  PairGroupoid<Translations<2>> const all_pairs;
  GaugeGroupoid<SO<2>> const heights{{}, 1};
  auto const on_pairs = [](auto const& g) {
    using std::cos;
    return pendulum(g.first.value[0], g.second.value[0], cos(g.second.value[1] - g.first.value[1]));
  };
  auto const on_heights = [](auto const& g) { return pendulum(g.from[0], g.to[0], g.element.value(0, 0)); };
  using TwoAngles = Element<Translations<2>, double>;
  Arrow<PairGroupoid<Translations<2>>, double> pair{TwoAngles{{}, {1.2, 0.0}}, TwoAngles{{}, {1.2, 0.035}}};
  auto const turn = [](double angle) { return exp(velocity(SO<2>{}, Matrix<double, 1, 1>(angle))); };
  Arrow<GaugeGroupoid<SO<2>>, double> arrow{Vector<double>::Constant(1, 1.2),
                                            Vector<double>::Constant(1, 1.2), turn(0.035)};
  double apart = 0, azimuth = 0, momentum_kept = 0;
  double const spin = legendre_at_target(heights, on_heights, arrow).components[1];
  std::vector<Vector3d> path;
  for (int k = 0; k < steps; ++k) {
    pair = step_lagrange(all_pairs, on_pairs, pair,
                         {pair.second, pair.second * inverse(pair.first) * pair.second})
               .value;
    arrow =
        step_lagrange(heights, on_heights, arrow, {arrow.to, 2 * arrow.to - arrow.from, arrow.element}).value;
    azimuth += log(arrow.element).coordinates[0];
    double const theta = arrow.to[0];
    path.push_back(
        {std::sin(theta) * std::cos(azimuth), std::sin(theta) * std::sin(azimuth), -std::cos(theta)});
    apart = std::max(
        apart, std::abs(theta - pair.second.value[0]) + std::abs(azimuth + 0.035 - pair.second.value[1]));
    momentum_kept = std::max(
        momentum_kept, std::abs(legendre_at_target(heights, on_heights, arrow).components[1] / spin - 1));
  }
  program.picture(
      "pendulum", book::Sphere(20, 25).curve(path, "weight of the pendulum", {.colour = 1}).svg(),
      "The spherical pendulum, put together from the arrows of a groupoid that has heights and turns only.");

  // 2. The top on pairs of attitudes, and on the action groupoid (turn, gamma).
  PairGroupoid<SO<3>> const attitudes;
  ActionGroupoid<SO<3>> const with_vertical;
  // the vertical in the body
  auto const seen = [](auto const& r) { return r.value.row(2).transpose().eval(); };
  auto const on_attitudes = [&](auto const& g) {
    using S = typename std::decay_t<decltype(g)>::Scalar;
    return top<S>((inverse(g.first) * g.second).value, seen(g.first), seen(g.second));
  };
  auto const on_turns = [&](auto const& g) {
    using S = typename std::decay_t<decltype(g)>::Scalar;
    return top<S>(g.element.value, g.vector, Matrix<S, Dynamic, 1>(g.element.value.transpose() * g.vector));
  };
  auto const tilted = exp(velocity(SO<3>{}, Vector3d(0.6, 0, 0))),
             first = exp(velocity(SO<3>{}, Vector3d(0, 0, 18 * h)));
  Arrow<PairGroupoid<SO<3>>, double> configurations{tilted, tilted * first};
  Arrow<ActionGroupoid<SO<3>>, double> turning{first, seen(tilted)};
  double top_apart = 0, vertical_kept = 0;
  auto const vertical = [&] {
    return legendre_at_target(with_vertical, on_turns, turning)
        .components.dot(with_vertical.target(turning).value);
  };
  double const start = vertical();
  std::vector<Vector3d> axis;
  for (int k = 0; k < steps; ++k) {
    configurations =
        step_lagrange(attitudes, on_attitudes, configurations,
                      {configurations.second,
                       configurations.second * inverse(configurations.first) * configurations.second})
            .value;
    turning = step_lagrange(with_vertical, on_turns, turning,
                            {turning.element, with_vertical.target(turning).value})
                  .value;
    turning.element = restore(turning.element), configurations.second = restore(configurations.second);
    axis.push_back(configurations.second.value.col(2));
    top_apart =
        std::max(top_apart, (seen(configurations.second) - with_vertical.target(turning).value).norm());
    vertical_kept = std::max(vertical_kept, std::abs(vertical() / start - 1));
  }
  program.picture("top", book::Sphere(20, 25).curve(axis, "axis of the top", {.colour = 2}).svg(),
                  "The axis of the top; its groupoid has rotations, and the vertical in the body frame.");

  // 3. What must be so: two roads with rounding errors of their own, a thousand steps long; a momentum that
  // each step conserves.
  program.table(
      "groupoids", {"system", "groupoid", "base", "fibre", "apart from pairs", "momentum conserved to"},
      {{"pendulum", "heights and turns", "1", "2", book::number(apart, 2), book::number(momentum_kept, 2)},
       {"top", "turns and the vertical", "3", "3", book::number(top_apart, 2),
        book::number(vertical_kept, 2)}},
      "Two systems on the groupoids that their symmetry leaves; dimensions of base and fibre.");
  double const rounding = 0x1p-52 * steps;
  program.claim(book::measured(apart) < 1000 * rounding, "the pendulum goes the same way on both groupoids");
  program.claim(book::measured(top_apart) < 1000 * rounding, "and the top");
  program.claim(book::measured(momentum_kept) < 20 * rounding,
                "the pendulum conserves its vertical momentum to rounding");
  program.claim(book::measured(vertical_kept) < 20 * rounding, "and so does the top");
  program.figure("apart", std::max(apart, top_apart), "distance of the two roads");
  program.figure("kept", std::max(momentum_kept, vertical_kept), "change of the vertical momentum, relative");
  program.headline(
      "two systems on two groupoids each, apart by " + book::number(std::max(apart, top_apart), 2),
      std::max(apart, top_apart));
  return program.finish();
}
