// What the generic implementation costs: steps for a Lagrangian given as a callable, by group, in steps of
// the classical Runge-Kutta method on a free body.
//
// A group is given by its primitives alone: residuals by dual numbers, a derivative reused from step to
// step, starts extrapolated from the last steps. Beside each stands the same step by Newton's iteration from
// scratch. Runge-Kutta has seven numbers, momentum and quaternion, and is written for its body. All run in
// turns, so that a busy machine slows all; what is claimed is judged by the best tenth of the rounds of each.
#include <memory>

#include "actio/bodies/body_catalogue.hpp"
#include "actio/groups/linear_groups.hpp"
#include "actio/groups/motions.hpp"
#include "actio/reduction/advected_steps.hpp"
#include "actio/reduction/euler_poincare_steps.hpp"
#include "actio/reduction/galerkin.hpp"
#include "actio/rigid_body/heavy_top.hpp"
#include "actio/rigid_body/natural_chart_scheme.hpp"
#include "benchmark.hpp"
#include "peers/runge_kutta.hpp"
#include "timing.hpp"

using namespace actio;

/// What is timed, and what it says of itself.
struct Stepped {
  std::string name;
  std::function<void()> step;             ///< takes one
  std::function<void()> from_scratch;     ///< the same by Newton's iteration alone
  std::function<Report const&()> report;  ///< of the last step
  std::function<double()> sum;            ///< of the last state, so that nothing is left out
};

/// Kinetic energy with unequal moments and a product of inertia.
auto const energy = [](auto const& xi) {
  auto const& v = xi.coordinates;
  auto sum = v[0] * v[0] + v[0] * v[1] * 0.2;
  for (Index i = 1; i < v.size(); ++i) sum += v[i] * v[i] * (1 + 0.3 * i);
  return sum / 2;
};
template <class G>
Velocity<G, double> spin() {
  Velocity<G, double> xi{G{}, Coordinates<G, double>(G::dim)};
  for (int i = 0; i < G::dim; ++i) xi.coordinates[i] = std::sin(1 + 2.3 * i);
  return xi / turning_size(xi);
}

/// A tenth of a radian a step, or what corresponds to it.
constexpr double h = 0.1;

template <class G, class L>
Stepped euler_poincare(std::string const& name, L const& l, Element<G, double> const& first) {
  auto const motion =
      std::make_shared<EulerPoincareStepsLeft<std::decay_t<decltype(l)>, G, double>>(l, first);
  auto const plain = std::make_shared<Element<G, double>>(first);
  return {name, [motion] { motion->advance(); },
          [plain, l] { *plain = step_euler_poincare_left(l, *plain).value; },
          [motion]() -> Report const& { return motion->report(); },
          [motion, plain] { return motion->relative_motion().value.sum() + plain->value.sum(); }};
}
template <class G>
Stepped euler_poincare(std::string const& name) {
  return euler_poincare(name, natural_chart_lagrangian_left(energy, h),
                        Element<G, double>(exp(-h * spin<G>())));
}
Stepped brick() {
  Body const body = read_body(ACTIO_DATA "/bodies.toml", "nesc_brick");
  NaturalChartScheme<3> const scheme(body.principal.inertia, h / body.principal_spin().coordinates.norm());
  return euler_poincare(
      "SO(3)", scheme.lagrangian(),
      scheme.relative_motion(body_momentum(body.principal.inertia, body.principal_spin())).value);
}
Stepped heavy_top() {
  auto const known = kovalevskaya_top<double>();
  double const h_top = h / known.spin.coordinates.norm();
  auto const l = natural_chart_lagrangian(known.top, h_top);
  Element<SO<3>, double> const first = exp(-h_top * known.spin);
  Vector<double, 3> const up(0, 0, 1);
  auto const motion =
      std::make_shared<AdvectedStepsLeft<std::decay_t<decltype(l)>, SO<3>, double, 3>>(l, first, up);
  struct Plain {
    Element<SO<3>, double> f;
    Vector<double, 3> vertical;
  };
  auto const plain = std::make_shared<Plain>(Plain{first, up});
  return {"heavy top", [motion] { motion->advance(); },
          [plain, l] {
            auto const next = step_advected_euler_poincare_left(l, plain->f, plain->vertical).value;
            plain->vertical = advect_left(plain->f, plain->vertical), plain->f = next;
          },
          [motion]() -> Report const& { return motion->report(); },
          [motion, plain] { return motion->relative_motion().value.sum() + plain->f.value.sum(); }};
}
Stepped galerkin(int s) {
  using G = SO<3>;
  struct Run {
    decltype(galerkin_step_left<double>(energy, 1)) step;
    MomentumState<G, double> state, plain;
    Report report;
  };
  auto const start = momentum_state(energy, spin<G>());
  auto const run = std::make_shared<Run>(Run{galerkin_step_left<double>(energy, s), start, start, {}});
  run->report.residuals = {0};
  return {"Galerkin, order " + std::to_string(2 * s) + ", SO(3)",
          [run] {
            auto done = run->step(run->state, h);
            run->state = done.state, run->report.evaluations = done.evaluations;
          },
          [run, s] { run->plain = galerkin_step_left<double>(energy, s)(run->plain, h).state; },
          [run]() -> Report const& { return run->report; },
          [run] { return run->state.momentum.components.sum() + run->plain.momentum.components.sum(); }};
}

int main(int argc, char** argv) {
  benchmark::Benchmark program(argc, argv,
                               "steps of the generic implementation, in Runge-Kutta steps of a free body");
  std::vector<Stepped> const all{brick(),
                                 euler_poincare<SE<2>>("SE(2)"),
                                 euler_poincare<SE<3>>("SE(3)"),
                                 euler_poincare<SO<4>>("SO(4)"),
                                 euler_poincare<SL2>("SL(2)"),
                                 heavy_top(),
                                 galerkin(2),
                                 galerkin(3)};
  auto const classical = peers::runge_kutta().make({{0.6, 0.8, 1}, {1.8, 0.4, -0.9}}, h);
  constexpr long rk_steps = 20000, steps = 200, plain_steps = 20;
  std::vector<benchmark::Contestant> contestants{
      {"Runge-Kutta", [&] { classical->advance(rk_steps); }, rk_steps}};
  std::vector<long> evaluations(all.size(), 0), taken(all.size(), 0);
  double residual = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    contestants.push_back({all[i].name,
                           [&, i] {
                             for (long k = 0; k < steps; ++k) {
                               all[i].step();
                               Report const& report = all[i].report();
                               evaluations[i] += report.evaluations, ++taken[i];
                               if (report.tolerance > 0)
                                 residual = std::max(residual, report.residuals.back() / report.tolerance);
                             }
                           },
                           steps});
    contestants.push_back({all[i].name,
                           [&, i] {
                             for (long k = 0; k < plain_steps; ++k) all[i].from_scratch();
                           },
                           plain_steps});
  }
  auto const times = benchmark::in_turns(program.rounds(41), contestants);

  std::vector<book::Program::Row> rows;
  double sum = classical->state()[0] + classical->state()[3], so3 = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto const &step = times[2 * i + 1], &plain = times[2 * i + 2];
    double const in_rk = benchmark::ratio_of_best(step, times[0]);
    if (i == 0) so3 = in_rk;
    rows.push_back({all[i].name, book::number(1e6 * benchmark::best_tenth(step)), book::number(in_rk),
                    book::number(static_cast<double>(evaluations[i]) / static_cast<double>(taken[i])),
                    book::number(1e6 * benchmark::best_tenth(plain)),
                    book::number(benchmark::ratio_of_best(plain, step))});
    sum += all[i].sum();
  }
  program.table(
      "time",
      {"step", "microseconds", "in Runge-Kutta steps", "evaluations", "from scratch, microseconds",
       "times as long"},
      rows,
      "A step turns by 0.1, about; the time that a tenth of the rounds came under. A Runge-Kutta step of a "
      "free body, momentum and attitude, takes " +
          book::number(1e9 * benchmark::best_tenth(times[0])) +
          " ns. From scratch: Newton's iteration, which uses nothing of the last step.");
  program.figure("so3_us", 1e6 * benchmark::best_tenth(times[1]), "a DEP step on SO(3), microseconds");
  program.figure("so3", so3, "the same in Runge-Kutta steps");
  program.figure("residual", residual, "largest residual over the rounding level it has to come under");
  program.figure("sum", sum, "sum of the last states, so that nothing is left out");
  program.claim_of_time(
      so3 <= 50, "a DEP step on SO(3) costs at most 50 Runge-Kutta steps; measured " + book::number(so3));
  for (std::size_t i = 0; i < all.size(); ++i) {
    double const faster = benchmark::ratio_of_best(times[2 * i + 2], times[2 * i + 1]);
    program.claim_of_time(faster >= 1.5, all[i].name +
                                             ": a step takes at most two thirds of the time "
                                             "of one from scratch; measured " +
                                             book::number(1 / faster));
    double const most = static_cast<double>(evaluations[i]) / static_cast<double>(taken[i]);
    program.claim(most <= 6, all[i].name +
                                 ": at most six evaluations of the residual a step on average; measured " +
                                 book::number(most));
  }
  program.claim(residual <= 4, "every residual is at rounding");
  program.headline("a DEP step on SO(3) costs " + book::number(so3) + " Runge-Kutta steps", so3);
  return program.finish();
}
