// What it costs to give a Lagrangian as a formula: whole scenes against the same systems written in C++
// by the generic implementation.
//
// A scene is read, its formula parsed and differentiated, and its steps are taken; one row is kept, that of
// the end. Beside it stands the discrete Lagrangian as a lambda on a group of the library, stepped by the
// generic implementation. Both are steps of one length from one start, of the natural chart or on a level of
// the momentum, so that both end at one momentum.
#include <fmt/format.h>

#include "actio/groups/motions.hpp"
#include "actio/groups/special_linear.hpp"
#include "actio/reduction/euler_poincare_steps.hpp"
#include "actio/reduction/momentum_level.hpp"
#include "actio/reduction/natural_chart.hpp"
#include "benchmark.hpp"
#include "program/run/run.hpp"
#include "timing.hpp"

using namespace actio;

namespace {

constexpr double h = 0.05;

/// How a system is stepped.
enum class Method { natural_chart, momentum_level };

/// A system, twice.
struct Pair {
  std::string name;
  std::function<std::vector<double>(long steps)> in_cpp;  ///< the momentum after so many steps
  std::string scene;                                      ///< without its end
};

template <class G, class L>
Pair pair_of(std::string const& group, L const& l, std::string const& formula,
             std::vector<double> const& velocity, Method method = Method::natural_chart) {
  std::string list;
  for (double const v : velocity) list += (list.empty() ? "" : ", ") + fmt::format("{}", v);
  auto const in_cpp = [=](long steps) {
    Velocity<G, double> v{G{}, Coordinates<G, double>(static_cast<Index>(velocity.size()))};
    for (std::size_t i = 0; i < velocity.size(); ++i) v.coordinates[static_cast<Index>(i)] = velocity[i];
    if (method == Method::momentum_level) {
      auto const step = momentum_level_step_left<double>(l);
      auto state = momentum_state(l, v);
      for (long k = 0; k < steps; ++k) state = step(state, h).state;
      auto const& p = state.momentum.components;
      return std::vector<double>(p.data(), p.data() + p.size());
    }
    auto const action = natural_chart_lagrangian_left(l, h);
    // The first relative motion has the momentum of the velocity at its end.
    auto const first = relative_motion_from_momentum_left(action, gradient(l, v), exp(-h * v)).value;
    EulerPoincareStepsLeft<std::decay_t<decltype(action)>, G, double> motion(action, first);
    for (long k = 1; k < steps; ++k) motion.advance();
    auto const& p = motion.momentum().components;
    return std::vector<double>(p.data(), p.data() + p.size());
  };
  bool const level = method == Method::momentum_level;
  return {
      level ? group + ", momentum level" : group, in_cpp,
      fmt::format(
          "[system]\nkind = \"euler_poincare\"\ngroup = \"{}\"\nlagrangian = \"{}\"\n"
          "[initial]\nvelocity = [{}]\n[method]\nname = \"{}\"\nstep = {}\n[output]\nerror_estimate = false\n"
          "quantities = [\"body_momentum\"]\n[run]\n",
          group, formula, list, level ? "momentum_level" : "natural_chart", h)};
}

/// The momentum after so many steps of a scene.
std::vector<double> in_scene(Pair const& pair, long steps) {
  auto scene = scene::Scene::read(scene::SceneFile::parse(
      pair.scene + fmt::format("until = {}\n", h * static_cast<double>(steps)), "scene"));
  std::vector<double> table;
  scene::RunOptions options;
  options.quiet = true;
  run_in_memory(scene, table, options);
  auto const columns = 1 + scene.simulation.quantities.row_size();
  return {table.end() - static_cast<std::ptrdiff_t>(columns) + 1, table.end()};
}

auto const tumbling = [](auto const& v) {
  auto const& x = v.coordinates;
  return (x[0] * x[0] + x[1] * x[1] * 2.0 + x[2] * x[2] * 3.0) / 2.0;
};
auto const kirchhoff = [](auto const& v) {
  auto const& x = v.coordinates;
  return (x[0] * x[0] * 2.0 + x[1] * x[1] + x[2] * x[2] * 3.0 + x[3] * x[3] + x[4] * x[4] * 2.0 +
          x[5] * x[5] * 4.0 + x[0] * x[4]) /
         2.0;
};

std::vector<Pair> pairs() {
  std::vector<double> const turn{0.3, 1.1, -0.4}, move{0.4, 0.3, -0.5, 0.2, 0.6, -0.1};
  std::string const top = "(w1^2 + 2*w2^2 + 3*w3^2)/2",
                    body = "(2*w1^2 + w2^2 + 3*w3^2 + v1^2 + 2*v2^2 + 4*v3^2 + w1*v2)/2";
  return {pair_of<SO<3>>("SO(3)", tumbling, top, turn, Method::momentum_level),
          pair_of<SE<3>>("SE(3)", kirchhoff, body, move, Method::momentum_level),
          pair_of<SE<2>>("SE(2)",
                         [](auto const& v) {
                           auto const& x = v.coordinates;
                           return (x[0] * x[0] + x[1] * x[1] + x[2] * x[2] * 6.0) / 2.0;
                         },
                         "(w^2 + v1^2 + 6*v2^2)/2", {0.7, 1.0, 0.2}),
          pair_of<SO<3>>("SO(3)", tumbling, top, turn),
          pair_of<SE<3>>("SE(3)", kirchhoff, body, move),
          pair_of<SL<2>>("SL(2)",
                         [](auto const& v) {
                           auto const& x = v.coordinates;
                           return (x[0] * x[0] + x[1] * x[1] * 2.0 + x[2] * x[2] * 3.0 + x[0] * x[1]) / 2.0;
                         },
                         "(x1^2 + 2*x2^2 + 3*x3^2 + x1*x2)/2", {0.2, 0.3, -0.1})};
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Benchmark program(
      argc, argv,
      "a Lagrangian as a formula in a scene, against the same in C++ by the generic implementation");
  auto const all = pairs();
  long const steps = program.length(20000L, 4000L);
  double const units = static_cast<double>(steps);
  std::vector<benchmark::Contestant> contestants;
  double volatile sink = 0;
  for (auto const& pair : all) {
    contestants.push_back({pair.name + " in C++", [&] { sink = sink + pair.in_cpp(steps)[0]; }, units});
    contestants.push_back(
        {pair.name + " as a scene", [&] { sink = sink + in_scene(pair, steps)[0]; }, units});
  }
  auto const times = benchmark::in_turns(program.rounds(21), contestants);
  std::vector<book::Program::Row> rows;
  double worst = 0, apart = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto const &cpp = times[2 * i], &own = times[2 * i + 1];
    double const ratio = benchmark::ratio_of_best(own, cpp);
    auto const p = all[i].in_cpp(200), q = in_scene(all[i], 200);
    double difference = 0, size = 0;
    for (std::size_t k = 0; k < p.size(); ++k)
      difference = std::max(difference, std::abs(p[k] - q[k])), size = std::max(size, std::abs(p[k]));
    worst = std::max(worst, ratio), apart = std::max(apart, difference / size);
    rows.push_back({all[i].name, book::number(1e6 * benchmark::best_tenth(cpp)),
                    book::number(1e6 * benchmark::best_tenth(own)), book::number(ratio),
                    book::number(difference / size)});
    program.claim_of_time(
        ratio <= 2,
        all[i].name + ": a scene takes at most twice the time of C++; measured " + book::number(ratio));
  }
  program.table(
      "time",
      {"group", "in C++, microseconds", "as a scene, microseconds", "scene over C++",
       "momenta apart after 200 steps"},
      rows,
      "A step, of the natural chart where nothing else is said, the group turning by about a twentieth; "
      "reading the scene and differentiating its formula are in the time of the scene.");
  program.figure("worst", worst, "time of a scene over that of C++, the largest");
  program.figure("apart", apart, "relative difference of the momenta after 200 steps, the largest");
  program.claim(apart <= 200 * 16 * std::numeric_limits<double>::epsilon(),
                "both implementations end at one momentum, to what the solvers leave in 200 steps");
  program.headline("a formula in a scene takes " + book::number(worst) + " of the time of C++ at most",
                   worst);
  return program.finish();
}
