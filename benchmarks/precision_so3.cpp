// Work and precision on SO(3): a free body as a Lagrangian of one's own, beside GSL, odeint, Runge-Kutta and
// Munthe-Kaas' methods on Euler's equations.
#include "actio/groups/rotations.hpp"
#include "actio/reduction/composition.hpp"
#include "actio/reduction/galerkin.hpp"
#include "actio/reduction/momentum_level.hpp"
#include "own_precision.hpp"

using namespace actio;

constexpr double inertia[3] = {0.6, 0.8, 1};

/// Momentum and quaternion.
auto const equations = [](auto const& y, auto& out) {
  using S = std::decay_t<decltype(y[0] + y[0])>;
  S const w[3] = {y[0] / S(inertia[0]), y[1] / S(inertia[1]), y[2] / S(inertia[2])},
          half[3] = {w[0] / 2, w[1] / 2, w[2] / 2};
  for (int i = 0; i < 3; ++i) out[i] = y[(i + 1) % 3] * w[(i + 2) % 3] - y[(i + 2) % 3] * w[(i + 1) % 3];
  benchmark::write_turning(&y[3], half, &out[3]);
};
auto const shown = [](auto const& y) {
  std::array<std::decay_t<decltype(y[0] + y[0])>, 12> out;
  std::copy_n(&y[0], 3, out.begin());
  benchmark::write_rotation(&y[3], out.begin() + 3);
  return out;
};
/// The same by rotations.
struct Turning {
  using Seven = peers::Numbers<double, 7>;
  static peers::Three velocity(Seven const& y) {
    return {y[0] / inertia[0], y[1] / inertia[1], y[2] / inertia[2]};
  }
  static peers::Three bracket(peers::Three const& a, peers::Three const& b) { return peers::cross(a, b); }
  static Seven act(peers::Three const& eta, Seven const& y) {
    Seven out;
    peers::Turn const turn(eta.data());
    std::ranges::copy(turn.back({y[0], y[1], y[2]}), out.begin());
    turn.after(&y[3], &out[3]);
    return out;
  }
};
auto const energy = [](auto const& xi) {
  auto const& v = xi.coordinates;
  return (v[0] * v[0] * inertia[0] + v[1] * v[1] * inertia[1] + v[2] * v[2] * inertia[2]) / 2;
};

int main(int argc, char** argv) {
  benchmark::Benchmark program(
      argc, argv,
      "work and precision on SO(3): a Lagrangian of one's own beside codes for differential equations");
  benchmark::System<7, 12, decltype(equations), decltype(shown), Turning> system{
      equations, shown, {}, {1.08, -0.8, 0.7, 1, 0, 0, 0}};
  auto const start = momentum_state(energy, velocity(SO<3>{}, Vector<double, 3>(1.8, -1, 0.7)));
  auto const way = [&](std::string const& name, auto const& step, double first) {
    return benchmark::own_way(
        system, name,
        [step, start](double h) {
          return [step, h, state = start, g = identity<double>(SO<3>{})](bool) mutable {
            auto const done = step(state, h);
            state = done.state, g = reconstruct_left(g, done.relative_motion);
            std::array<double, 12> out;
            for (int i = 0; i < 3; ++i) out[i] = state.momentum.components[i];
            for (int i = 0; i < 9; ++i) out[3 + i] = g.value(i / 3, i % 3);
            return out;
          };
        },
        first, 1.4);
  };
  auto const chart = natural_chart_step_left(energy);
  return benchmark::compare(
      program, system,
      {way("momentum level, order 8", momentum_level_step_left<double>(energy), 4),
       way("natural chart, order 2", chart, 16),
       way("natural chart composed, order 6", ComposedLeft(chart, kahan_li<double>()), 2),
       way("Galerkin, order 4", galerkin_step_left<double>(energy, 2), 8),
       way("Galerkin, order 8", galerkin_step_left<double>(energy, 4), 4),
       way("Galerkin, order 12", galerkin_step_left<double>(energy, 6), 3)});
}
