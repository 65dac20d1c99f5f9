// Work and precision: what higher order costs, and from which accuracy on it pays.
//
// What is shown. A step of order 2 on momenta is made into steps of orders 4 and 6 in two ways: by
// composition, several steps of which some go backwards, and by Galerkin paths, polynomials in the natural
// chart. Both preserve the coadjoint orbit and the bracket as the step of order 2 does. Beside them is
// the explicit step of order 8 on a level of the momentum, which preserves the orbit alone. Each is run on
// three groups; its error, against power series, is set against how often the Lagrangian was evaluated. Read
// first. "Higher order by composition" and "Galerkin paths" of chapter 4A.
//
//   l        Lagrangian on the algebra              Pi    body momentum
//   I, b     inertia; momentum of a wheel inside    h     step
//
// Compiled at -O2: it takes many steps.
#include "actio/groups/linear_groups.hpp"
#include "actio/groups/motions.hpp"
#include "actio/reduction/composition.hpp"
#include "actio/reduction/galerkin.hpp"
#include "actio/reduction/momentum_level.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"
#include "witness/taylor_reference.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;
using Vector6d = Matrix<double, 6, 1>;

// A body with a wheel turning in it: l = <I xi, xi>/2 + <b, xi>. It counts how often it is asked.
template <class G>
struct Body {
  G group;
  Coordinates<G, double> inertia, wheel;
  long* asked;

  template <class T>
  T operator()(Velocity<G, T> const& xi) const {
    ++*asked;
    T sum(0);
    for (int a = 0; a < group.dimension(); ++a)
      sum += xi.coordinates[a] * (xi.coordinates[a] * (inertia[a] / 2) + T(wheel[a]));
    return sum;
  }
  // Pi' = ad*_xi Pi with xi = (Pi - b)/I, by power series.
  Coordinates<G, double> momentum_after(Coordinates<G, double> const& start, double time) const {
    auto const rate = [this](auto const& pi) {
      auto xi = pi;
      for (int a = 0; a < group.dimension(); ++a) xi[a] = (pi[a] - wheel[a]) / inertia[a];
      return ad_star(velocity(group, xi), momentum(group, pi)).components;
    };
    return taylor_reference<double>(rate, start, time);
  }
};

// Runs of one integrator, each with steps shorter by a factor of about the root of two.
struct Runs {
  std::string name;
  int order;
  std::vector<double> h, work, seconds, error;

  // From the five shortest steps.
  double fitted_order() const {
    auto const last = std::min<std::ptrdiff_t>(5, std::ssize(h));
    return book::exponent({h.end() - last, h.end()}, {error.end() - last, error.end()});
  }
  // What it takes to come to an accuracy, along the straight line between the two runs around it.
  double at(std::vector<double> const& cost, double accuracy) const {
    std::size_t k = 1;
    while (k + 1 < error.size() && error[k] > accuracy) ++k;
    double const share = std::log(error[k - 1] / accuracy) / std::log(error[k - 1] / error[k]);
    return cost[k - 1] * std::pow(cost[k] / cost[k - 1], share);
  }
};

template <class G>
std::vector<Runs> study(Body<G> const& body, Coordinates<G, double> const& xi, double time) {
  auto const start = momentum_state(body, velocity(body.group, xi));
  auto const truth = body.momentum_after(start.momentum.components, time);
  std::vector<Runs> all;
  auto const run = [&](std::string const& name, int order, auto const& step) {
    Runs runs{name, order, {}, {}, {}, {}};
    for (double steps = 4; steps <= 1 << 12; steps *= std::sqrt(2.0)) {
      int const count = static_cast<int>(std::lround(steps));
      *body.asked = 0;
      Coordinates<G, double> end;
      double const seconds = book::seconds_of([&] {
        end = take_steps(step, start, std::vector<double>(count, time / count)).momentum.components;
      });
      double const error = (end - truth).norm() / truth.norm();
      if (error < 1e-12) break;  // below, the rounding of many steps may show
      if (error > 1e-3) continue;
      runs.h.push_back(time / count), runs.work.push_back(double(*body.asked) / time),
          runs.seconds.push_back(seconds / time), runs.error.push_back(error);
    }
    all.push_back(runs);
  };

  // 1. The step of order 2, the compositions of it, and the Galerkin steps: each is a callable (state, h).
  // That by the natural chart is the Galerkin step of degree 1, which takes no logarithm.
  auto const chart = galerkin_step_left<double>(body, 1);
  run("natural chart", 2, chart);
  run("Suzuki, 5 stages", 4, ComposedLeft(chart, suzuki<double>()));
  run("Galerkin, s = 2", 4, galerkin_step_left<double>(body, 2));
  run("Kahan-Li, 9 stages", 6, ComposedLeft(chart, kahan_li<double>()));
  run("Galerkin, s = 3", 6, galerkin_step_left<double>(body, 3));
  run("momentum level", 8, momentum_level_step_left<double>(body));
  return all;
}

// 2. Error against work on one group, and what an error of 1e-7 costs.
struct Costs {
  double const accuracy = 1e-7;
  std::vector<book::Program::Row> rows = {};
  double least_gain = HUGE_VAL, level_gain = HUGE_VAL, largest_miss = 0, time_gain = 0;
  bool paths_are_cheapest = true;

  void take_in(book::Program& program, std::string const& name, std::string const& title,
               std::string const& what, std::vector<Runs> const& all) {
    auto plot =
        book::Plot("evaluations of the Lagrangian for a unit of time", "error of the momentum, relative")
            .log_x()
            .log_y();
    int const colours[] = {1, 2, 2, 3, 3, 4};
    double best = HUGE_VAL, fastest = HUGE_VAL;
    for (std::size_t i = 0; i < all.size(); ++i) {
      Runs const& r = all[i];
      plot.curve(r.work, r.error, r.name, {.colour = colours[i], .dashed = i == 2 || i == 4});
      double const order = r.fitted_order();
      if (r.order <= 6) largest_miss = std::max(largest_miss, std::abs(order - r.order));
      if (r.order == 4 || r.order == 6)
        best = std::min(best, r.at(r.work, accuracy)), fastest = std::min(fastest, r.at(r.seconds, accuracy));
      rows.push_back({title, r.name, book::number(order), book::number(r.at(r.work, accuracy), 2),
                      book::number(1e3 * r.at(r.seconds, accuracy), 2)});
    }
    program.picture(name, plot.svg(), what);
    paths_are_cheapest = paths_are_cheapest && best == all[4].at(all[4].work, accuracy);
    least_gain = std::min(least_gain, all[0].at(all[0].work, accuracy) / best);
    level_gain = std::min(level_gain, best / all[5].at(all[5].work, accuracy));
    if (name == "SE3") time_gain = all[0].at(all[0].seconds, accuracy) / fastest;
  }
};

// 3. A gyrostat; a body with a wheel in still water; a body that is sheared and stretched in a plane.
void study_three_groups(book::Program& program, Costs& costs) {
  long asked = 0;
  costs.take_in(program, "SO3", "SO(3)", "A body with a wheel in it, turning: error against work, on SO(3).",
                study(Body<SO<3>>{{}, Vector3d(1.0, 1.7, 2.4), Vector3d(0.3, -0.2, 0.5), &asked},
                      Vector3d(0.9, 0.4, -0.7), 4));
  Vector6d const heavy{{1.0, 1.7, 2.4, 1.2, 1.9, 2.5}}, wheel{{0.3, -0.2, 0.5, 0, 0, 0}},
      cast_off{{0.5, 0.3, -0.4, 0.8, 0.3, -0.2}};
  costs.take_in(
      program, "SE3", "SE(3)",
      "A body with a wheel in it in still water, where it tumbles as it glides: error against work, on "
      "SE(3). A curve bends where shorter steps save the solver an iteration.",
      study(Body<SE<3>>{{}, heavy, wheel, &asked}, cast_off, 4));
  costs.take_in(
      program, "SL2", "SL(2)",
      "A body that is sheared and stretched in its plane, its area unchanged: error against work, on SL(2).",
      study(Body<SL2>{{}, Vector3d(2.0, 1.5, 1.0), Vector3d(0.2, -0.1, 0.3), &asked},
            Vector3d(0.3, 0.5, -0.4), 4));
}

// 4. The energy over a long time: its error after a tenth of it and in the end, relative.
struct Energy {
  double const time = 2000, step = 0.25;
  double level_growth = 0;
  std::vector<book::Program::Row> rows = {};

  void follow() {
    long asked = 0;
    Body<SO<3>> const body{{}, Vector3d(1.0, 1.7, 2.4), Vector3d(0.3, -0.2, 0.5), &asked};
    auto const start = momentum_state(body, velocity(SO<3>{}, Vector3d(0.9, 0.4, -0.7)));
    double const first = energy(body, start.momentum.components);
    auto const run = [&](std::string const& name, auto const& step_of) {
      auto state = start;
      long const steps = std::lround(time / step);
      double early = 0, late = 0;
      for (long k = 1; k <= steps; ++k) {
        state = step_of(state, step).state;
        double const off = std::abs(energy(body, state.momentum.components) / first - 1);
        (10 * k <= steps ? early : late) = std::max(10 * k <= steps ? early : late, off);
      }
      rows.push_back({name, book::number(early), book::number(late)});
      return late / early;
    };
    run("natural chart, Kahan-Li, order 6",
        ComposedLeft(galerkin_step_left<double>(body, 1), kahan_li<double>()));
    run("Galerkin, s = 3, order 6", galerkin_step_left<double>(body, 3));
    level_growth = run("momentum level, order 8", momentum_level_step_left<double>(body));
  }
  // <(Pi - b)/I, Pi - b>/2: the wheel has no part in it.
  static double energy(Body<SO<3>> const& body, Vector3d const& pi) {
    double sum = 0;
    for (int a = 0; a < 3; ++a) sum += std::pow(pi[a] - body.wheel[a], 2) / (2 * body.inertia[a]);
    return sum;
  }
};

// 5. What it takes for seven digits.
int main(int argc, char** argv) {
  book::Program program(argc, argv, "orders 2 to 8 on three groups: how much work for how much precision");
  Costs all;
  study_three_groups(program, all);
  program.table("cost", {"group", "step", "order", "evaluations", "milliseconds"}, all.rows,
                "Order, fitted, and what a unit of time costs at an error of " + book::number(all.accuracy) +
                    ": evaluations of the Lagrangian, and time.");
  program.figure("gain", all.least_gain, book::number(all.least_gain, 2),
                 "evaluations of order 2 over those of the best higher order, where it gains least");
  program.figure("time_gain", all.time_gain, book::number(all.time_gain, 2),
                 "the same in running time, on SE(3)");
  program.figure("level_gain", all.level_gain, book::number(all.level_gain, 2),
                 "evaluations of the best of them over those of the explicit step, where it gains least");
  Energy energy;
  energy.follow();
  program.table("energy", {"step", "in the first tenth of the time", "afterwards"}, energy.rows,
                "The largest error of the energy, relative, with steps of " + book::number(energy.step) +
                    " up to t = " + book::number(energy.time) + ".");
  program.figure("long_time", energy.time, "time of the runs whose energy is followed");
  program.figure("level_growth", energy.level_growth, book::number(energy.level_growth, 2),
                 "error of the energy in the end over that in the first tenth, explicit step");
  program.figure("miss", all.largest_miss,
                 "largest distance of a measured order, up to 6, from what it should be");
  using book::measured;  // the longest of the five steps still bend the line a little
  program.claim(measured(all.largest_miss) < 0.2, "every order up to 6 is what it should be");
  program.claim(measured(all.least_gain) > 10,
                "for seven digits a higher order saves nine evaluations in ten, on every group");
  program.claim(all.paths_are_cheapest,
                "Galerkin paths of degree three need the fewest of the variational steps, on every group");
  program.claim(measured(all.level_gain) > 1, "the explicit step of order 8 needs fewer, on every group");
  program.claim(measured(std::abs(energy.level_growth - 10)) < 2,
                "its error of the energy grows in proportion to the time");
  program.headline("seven digits of the momentum: order 2 takes " + book::number(all.least_gain, 2) +
                       " times the evaluations of order 6, or more",
                   all.least_gain);
  return program.finish();
}
