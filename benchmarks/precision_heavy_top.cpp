// Work and precision on the heavy top: Kovalevskaya's, as a Lagrangian with an advected vector, beside GSL,
// odeint, Runge-Kutta and Munthe-Kaas' methods on the equations of Euler and Poisson.
#include "actio/groups/predictor_corrector.hpp"
#include "actio/reduction/advected_momentum_level.hpp"
#include "actio/reduction/advected_steps.hpp"
#include "actio/reduction/composition.hpp"
#include "actio/rigid_body/heavy_top.hpp"
#include "own_precision.hpp"

using namespace actio;

/// A symmetric composition of steps of the generic implementation with an advected vector: each stage has a
/// derivative of its own.
class ComposedTop {
 public:
  ComposedTop(HeavyTop<double> const& top, HeavyTopState<double> const& start,
              std::vector<double> const& fractions, double h)
      : top_(top), state_(start) {
    for (double const f : fractions) stages_.push_back({f * h, {}});
  }
  HeavyTopState<double> const& step() {
    for (auto& [h, solver] : stages_) {
      auto const l = trace_lagrangian(top_, h);
      auto const f = solver.solve(advected_momentum_equation_left(l, state_.momentum, state_.vector),
                                  exp(-h * body_velocity(top_.inertia, state_.momentum)));
      state_ = {advected_lie_poisson_update_left(l, f, state_.vector, state_.momentum),
                advect_left(f, state_.vector)};
    }
    return state_;
  }

 private:
  struct Stage {
    double h;
    PredictorCorrector<SO<3>, double> solver;
  };
  HeavyTop<double> top_;
  HeavyTopState<double> state_;
  std::vector<Stage> stages_;
};

/// The equations of Euler and Poisson by rigid motions, whose momenta are that of the top and the direction
/// of gravity: the shift has the velocity of the lever.
struct Falling {
  using Six = std::array<double, 6>;
  Vector<double, 3> inertia, lever;
  Six velocity(Six const& y) const {
    return {y[0] / inertia[0], y[1] / inertia[1], y[2] / inertia[2], lever[0], lever[1], lever[2]};
  }
  static Six bracket(Six const& a, Six const& b) { return peers::bracket_of_motions(a, b); }
  static Six act(Six const& eta, Six const& y) {
    Six out;
    peers::move_momenta(peers::Turn(eta.data()), eta, y, out);
    return out;
  }
};

int main(int argc, char** argv) {
  benchmark::Benchmark program(argc, argv,
                               "work and precision on the heavy top: a Lagrangian of one's own beside "
                               "codes for differential equations");
  auto const known = kovalevskaya_top<double>();
  Vector<double, 3> const I = known.top.inertia.moments, p = known.top.lever();
  auto const start = release(known.top, identity<double>(SO<3>{}), known.spin);
  auto const rate = [I, p](auto const& y, auto& out) {
    using S = std::decay_t<decltype(y[0] + y[0])>;
    S const w[3] = {y[0] / S(I[0]), y[1] / S(I[1]), y[2] / S(I[2])};
    for (int i = 0; i < 3; ++i) {
      int const j = (i + 1) % 3, k = (i + 2) % 3;
      out[i] = y[j] * w[k] - y[k] * w[j] + y[3 + j] * S(p[k]) - y[3 + k] * S(p[j]);
      out[3 + i] = y[3 + j] * w[k] - y[3 + k] * w[j];
    }
  };
  auto const shown = [](auto const& y) { return y; };
  benchmark::System<6, 6, decltype(rate), decltype(shown), Falling> system{rate, shown, {I, p}, {}};
  for (int i = 0; i < 3; ++i)
    system.start[i] = start.momentum.components[i], system.start[3 + i] = start.vector[i];
  auto const way = [&](std::string const& name, std::vector<double> const& fractions, double first) {
    return benchmark::own_way(
        system, name,
        [&, fractions](double h) {
          return [motion = ComposedTop(known.top, start, fractions, h)](bool) mutable {
            auto const& s = motion.step();
            return std::array<double, 6>{s.momentum.components[0],
                                         s.momentum.components[1],
                                         s.momentum.components[2],
                                         s.vector[0],
                                         s.vector[1],
                                         s.vector[2]};
          };
        },
        first, 1.4);
  };
  auto const lagrangian = [I, p](auto const& xi, auto const& gamma) {
    using S = typename std::decay_t<decltype(xi)>::Scalar;
    S sum(0);
    for (int i = 0; i < 3; ++i) sum += xi.coordinates[i] * xi.coordinates[i] * (I[i] / 2) - gamma[i] * p[i];
    return sum;
  };
  auto const level = advected_momentum_level_step_left<double>(lagrangian);
  auto const from = advected_momentum_state(lagrangian, body_velocity(known.top.inertia, start.momentum),
                                            Matrix<double, 3, 1>(start.vector));
  auto const by_level = benchmark::own_way(
      system, "momentum level, order 8",
      [&](double h) {
        return [&level, h, state = from](bool) mutable {
          state = level(state, h).state;
          auto const &m = state.momentum.components, &a = state.vector;
          return std::array<double, 6>{m[0], m[1], m[2], a[0], a[1], a[2]};
        };
      },
      4, 1.1);
  return benchmark::compare(
      program, system,
      {by_level, way("chords, order 2", {1.0}, 16), way("chords composed, order 4", suzuki<double>(), 4),
       way("chords composed, order 6", kahan_li<double>(), 2),
       way("chords composed, order 8", symmetric_composition<double>(8), 1)});
}
