// Work and precision on SE(3): a body in still water (Kirchhoff) as a Lagrangian of one's own, beside GSL,
// odeint, Runge-Kutta and Munthe-Kaas' methods on its equations.
#include "actio/groups/motions.hpp"
#include "actio/reduction/composition.hpp"
#include "actio/reduction/galerkin.hpp"
#include "actio/reduction/momentum_level.hpp"
#include "own_precision.hpp"

using namespace actio;

constexpr double inertia[6] = {0.6, 0.8, 1, 1, 1.5, 2};

/// Angular and linear momentum, quaternion and place.
auto const equations = [](auto const& y, auto& out) {
  using S = std::decay_t<decltype(y[0] + y[0])>;
  S w[6];
  for (int i = 0; i < 6; ++i) w[i] = y[i] / S(inertia[i]);
  S const half[3] = {w[0] / 2, w[1] / 2, w[2] / 2};
  for (int i = 0; i < 3; ++i) {
    int const j = (i + 1) % 3, k = (i + 2) % 3;
    out[i] = y[j] * w[k] - y[k] * w[j] + y[3 + j] * w[3 + k] - y[3 + k] * w[3 + j];
    out[3 + i] = y[3 + j] * w[k] - y[3 + k] * w[j];
  }
  benchmark::write_turning(&y[6], half, &out[6]);
  S turn[9];
  benchmark::write_rotation(&y[6], turn);
  for (int i = 0; i < 3; ++i)
    out[10 + i] = turn[3 * i] * w[3] + turn[3 * i + 1] * w[4] + turn[3 * i + 2] * w[5];
};
auto const shown = [](auto const& y) {
  std::array<std::decay_t<decltype(y[0] + y[0])>, 18> out;
  std::copy_n(&y[0], 6, out.begin());
  benchmark::write_rotation(&y[6], out.begin() + 6);
  std::copy_n(&y[10], 3, out.begin() + 15);
  return out;
};
/// The same by rigid motions.
struct Moving {
  using State = peers::Numbers<double, 13>;
  static std::array<double, 6> velocity(State const& y) {
    std::array<double, 6> out;
    for (int i = 0; i < 6; ++i) out[i] = y[i] / inertia[i];
    return out;
  }
  static std::array<double, 6> bracket(std::array<double, 6> const& a, std::array<double, 6> const& b) {
    return peers::bracket_of_motions(a, b);
  }
  static State act(std::array<double, 6> const& eta, State const& y) {
    State out;
    peers::Turn const turn(eta.data());
    auto const shift = peers::move_momenta(turn, eta, y, out);
    turn.after(&y[6], &out[6]);
    double rotation[9];
    benchmark::write_rotation(&y[6], rotation);
    for (int i = 0; i < 3; ++i)
      out[10 + i] = y[10 + i] + rotation[3 * i] * shift[0] + rotation[3 * i + 1] * shift[1] +
                    rotation[3 * i + 2] * shift[2];
    return out;
  }
};
auto const energy = [](auto const& xi) {
  auto sum = xi.coordinates[0] * xi.coordinates[0] * inertia[0];
  for (int i = 1; i < 6; ++i) sum += xi.coordinates[i] * xi.coordinates[i] * inertia[i];
  return sum / 2;
};

int main(int argc, char** argv) {
  benchmark::Benchmark program(
      argc, argv,
      "work and precision on SE(3): a Lagrangian of one's own beside codes for differential equations");
  Matrix<double, 6, 1> const xi{1.8, -1, 0.7, 0.4, 0.2, -0.3};
  benchmark::System<13, 18, decltype(equations), decltype(shown), Moving> system{
      equations, shown, {}, {0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0}};
  for (int i = 0; i < 6; ++i) system.start[i] = inertia[i] * xi[i];
  auto const start = momentum_state(energy, velocity(SE<3>{}, xi));
  auto const way = [&](std::string const& name, auto const& step, double first) {
    return benchmark::own_way(
        system, name,
        [step, start](double h) {
          return [step, h, state = start, g = identity<double>(SE<3>{})](bool) mutable {
            auto const done = step(state, h);
            state = done.state, g = reconstruct_left(g, done.relative_motion);
            std::array<double, 18> out;
            for (int i = 0; i < 6; ++i) out[i] = state.momentum.components[i];
            for (int i = 0; i < 9; ++i) out[6 + i] = g.value(i / 3, i % 3);
            for (int i = 0; i < 3; ++i) out[15 + i] = g.value(i, 3);
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
       way("Galerkin, order 8", galerkin_step_left<double>(energy, 4), 4)});
}
