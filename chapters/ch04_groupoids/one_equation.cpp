// One equation, four systems: the Lagrange equations on a groupoid, as one template.
//
// What is shown. A pendulum that swings in all directions and a top under gravity, each solved twice by the
// same function `step_lagrange`: on pairs of configurations, which is discrete Euler-Lagrange, and on the
// groupoid that its symmetry leaves: pairs of heights with a turn between them, rotations with the vertical
// in the body frame. The two ways agree to rounding; the second does not use the attitude, and its equations
// are fewer or simpler. Read first. Section 4.1, "Dynamics on groupoids and algebroids".
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
int const steps = 1500;

// The result for a system on two groupoids: how far the two ways come apart, how well the momentum about
// the vertical is conserved, and the path on the sphere.
struct TwoWays {
  double apart = 0, conserved = 0;
  std::vector<Vector3d> path = {};
};

// 1. The pendulum, 1 kg on 1 m: the chord between two configurations, and the mean of two heights. Only the
//    turn between the azimuths counts. The top: the trace Lagrangian of its turning, and the mean height of a
//    weight on its third axis.
template <class S>
S pendulum(S const& theta0, S const& theta1, S const& cos_turn) {
  using std::cos, std::sin;
  S const chord = S(2) - (sin(theta0) * sin(theta1) * cos_turn + cos(theta0) * cos(theta1)) * S(2);
  return chord / S(2 * h) + (cos(theta0) + cos(theta1)) * S(h * gravity / 2);
}
template <class S, class Turn, class V>
S top(Turn const& turn, V const& gamma0, V const& gamma1) {
  Vector3d const lambda(0.9, 0.9, 0.1);
  S sum(0);
  for (int i = 0; i < 3; ++i) sum += (S(1) - turn(i, i)) * S(lambda[i]);
  return sum / S(h) - (gamma0[2] + gamma1[2]) * S(h * gravity / 2);
}

// 2. The pendulum on pairs of (theta, phi), and on the gauge groupoid (theta0, theta1, turn).
TwoWays swing_the_pendulum() {
  PairGroupoid<Translations<2>> const all_pairs;
  GaugeGroupoid<SO<2>> const heights{{}, 1};
  auto const on_pairs = [](auto const& g) {
    using std::cos;
    return pendulum(g.first.value[0], g.second.value[0], cos(g.second.value[1] - g.first.value[1]));
  };
  auto const on_heights = [](auto const& g) { return pendulum(g.from[0], g.to[0], g.element.value(0, 0)); };

  double const start = 1.2, turn = 0.035;
  PairArrow<Translations<2>, double> pair{{{}, {start, 0.0}}, {{}, {start, turn}}};
  GaugeArrow<SO<2>, double> arrow{Vector<double>::Constant(1, start), Vector<double>::Constant(1, start),
                                  exp(velocity(SO<2>{}, Matrix<double, 1, 1>(turn)))};
  auto const momentum = [&] { return legendre_at_target(heights, on_heights, arrow).components[1]; };
  double const spin = momentum();
  double azimuth = turn;
  TwoWays found;
  for (int k = 0; k < steps; ++k) {
    auto const same_again = pair.second * inverse(pair.first) * pair.second;
    pair = step_lagrange(all_pairs, on_pairs, pair, {pair.second, same_again}).value;
    arrow =
        step_lagrange(heights, on_heights, arrow, {arrow.to, 2 * arrow.to - arrow.from, arrow.element}).value;
    azimuth += log(arrow.element).coordinates[0];
    double const theta = arrow.to[0], phi = azimuth - turn;
    double const across = std::sin(theta);
    found.path.push_back({across * std::cos(phi), across * std::sin(phi), -std::cos(theta)});
    found.apart = std::max(found.apart,
                           std::abs(theta - pair.second.value[0]) + std::abs(azimuth - pair.second.value[1]));
    found.conserved = std::max(found.conserved, std::abs(momentum() / spin - 1));
  }
  return found;
}

// 3. The top on pairs of attitudes, and on the action groupoid (turn, gamma).
TwoWays spin_the_top() {
  PairGroupoid<SO<3>> const attitudes;
  ActionGroupoid<SO<3>> const with_vertical;
  auto const in_the_body = [](auto const& r) { return r.value.row(2).transpose().eval(); };  // the vertical
  auto const on_attitudes = [&](auto const& g) {
    using S = typename std::decay_t<decltype(g)>::Scalar;
    return top<S>((inverse(g.first) * g.second).value, in_the_body(g.first), in_the_body(g.second));
  };
  auto const on_turns = [&](auto const& g) {
    using S = typename std::decay_t<decltype(g)>::Scalar;
    return top<S>(g.element.value, g.vector, Matrix<S, Dynamic, 1>(g.element.value.transpose() * g.vector));
  };

  auto const tilted = exp(velocity(SO<3>{}, Vector3d(0.6, 0, 0))),
             first = exp(velocity(SO<3>{}, Vector3d(0, 0, 18 * h)));
  PairArrow<SO<3>, double> pair{tilted, tilted * first};
  ActionArrow<SO<3>, double> arrow{first, in_the_body(tilted)};
  auto const momentum = [&] {
    return legendre_at_target(with_vertical, on_turns, arrow)
        .components.dot(with_vertical.target(arrow).value);
  };
  double const start = momentum();
  TwoWays found;
  for (int k = 0; k < steps; ++k) {
    auto const same_again = pair.second * inverse(pair.first) * pair.second;
    pair = step_lagrange(attitudes, on_attitudes, pair, {pair.second, same_again}).value;
    arrow = step_lagrange(with_vertical, on_turns, arrow, {arrow.element, with_vertical.target(arrow).value})
                .value;
    arrow.element = restore(arrow.element), pair.second = restore(pair.second);
    found.path.push_back(pair.second.value.col(2));
    found.apart =
        std::max(found.apart, (in_the_body(pair.second) - with_vertical.target(arrow).value).norm());
    found.conserved = std::max(found.conserved, std::abs(momentum() / start - 1));
  }
  return found;
}

// 4. What must be so: two ways with rounding errors of their own, more than a thousand steps long; a momentum
//    that each step conserves.
void compare(book::Program& program, TwoWays const& pendulum, TwoWays const& top) {
  program.table("groupoids",
                {"system", "groupoid", "base", "fibre", "apart from pairs", "momentum conserved to"},
                {{"pendulum", "heights and turns", "1", "2", book::number(pendulum.apart, 2),
                  book::number(pendulum.conserved, 2)},
                 {"top", "turns and the vertical", "3", "3", book::number(top.apart, 2),
                  book::number(top.conserved, 2)}},
                "Two systems on the groupoids that their symmetry leaves; dimensions of base and fibre.");
  double const rounding = 0x1p-52 * steps, apart = std::max(pendulum.apart, top.apart);
  using book::measured;
  program.claim(measured(pendulum.apart) < 1000 * rounding,
                "the pendulum goes the same way on both groupoids");
  program.claim(measured(top.apart) < 1000 * rounding, "and so does the top");
  program.claim(measured(pendulum.conserved) < 20 * rounding,
                "the pendulum conserves its momentum about the vertical");
  program.claim(measured(top.conserved) < 20 * rounding, "and so does the top");
  program.figure("apart", apart, "distance of the two ways");
  program.figure("kept", std::max(pendulum.conserved, top.conserved),
                 "change of the vertical momentum, relative");
  program.headline("two systems on two groupoids each, apart by " + book::number(apart, 2), apart);
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "a spherical pendulum and a top, each on two groupoids, by one equation");
  TwoWays const pendulum = swing_the_pendulum(), top = spin_the_top();
  program.picture(
      "pendulum", book::Sphere(20, 25).curve(pendulum.path, "weight of the pendulum", {.colour = 1}).svg(),
      "The spherical pendulum, put together from the arrows of a groupoid that has heights and turns only.");
  program.picture("top", book::Sphere(20, 25).curve(top.path, "axis of the top", {.colour = 2}).svg(),
                  "The axis of the top; its groupoid has rotations, and the vertical in the body frame.");
  compare(program, pendulum, top);
  return program.finish();
}
