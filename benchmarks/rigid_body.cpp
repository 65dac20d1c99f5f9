// The free body in three dimensions: what a step costs, what an error costs, and how far what is conserved
// walks away.
//
// The exact half turns, the Moser-Veselov scheme of all orders, and those whom one would otherwise ask: the
// closed form in elliptic functions, GSL, Boost.odeint, the classical Runge-Kutta method, the algorithm of
// Hairer and Vilmart, the implicit midpoint rule, splitting. All in one process, in turns.
#include "benchmark.hpp"
#include "digits_plot.hpp"
#include "drift.hpp"
#include "peers/elliptic_functions.hpp"
#include "peers/gsl_methods.hpp"
#include "peers/implicit_midpoint.hpp"
#include "peers/odeint_methods.hpp"
#include "peers/own_methods.hpp"
#include "peers/runge_kutta.hpp"
#include "peers/splitting.hpp"
#include "work_precision.hpp"

using namespace benchmark;
using peers::Method, peers::Task;

Task const task{{0.6, 0.8, 1}, {1.8, 0.4, -0.9}};

std::vector<Method> all_methods() {
  return {peers::exact_half_turns(),
          peers::exact_momentum(),
          peers::exact_compensated(),
          peers::moser_veselov_once(2),
          peers::moser_veselov_once(10),
          peers::moser_veselov_each_step(2),
          peers::moser_veselov_each_step(4),
          peers::moser_veselov_each_step(6),
          peers::moser_veselov_each_step(8),
          peers::moser_veselov_each_step(10),
          peers::moser_veselov_general(),
          peers::preprocessed_moser_veselov(2),
          peers::preprocessed_moser_veselov(6),
          peers::preprocessed_moser_veselov(10),
          peers::elliptic_functions(),
          peers::runge_kutta(),
          peers::gsl_prince_dormand(),
          peers::odeint_fehlberg(),
          peers::odeint_dormand_prince(),
          peers::implicit_midpoint(),
          peers::splitting()};
}

std::string nanoseconds(double seconds) { return book::number(1e9 * seconds, seconds < 1e-6 ? 3 : 4); }
std::string microseconds(double seconds) { return book::number(1e6 * seconds); }

// ---- What a step costs

void step_times(Benchmark& program) {
  constexpr long steps = 10000;
  std::vector<std::unique_ptr<peers::Stepper>> steppers;
  std::vector<Contestant> contestants;
  std::size_t rk = 0;
  for (Method const& method : all_methods()) {
    if (method.name == peers::runge_kutta().name) rk = contestants.size();
    steppers.push_back(method.make(task, 0.1));
    contestants.push_back({method.name, [s = steppers.back().get()] { s->advance(steps); }, steps});
  }
  auto const times = in_turns(program.rounds(41), contestants);

  std::vector<book::Program::Row> rows;
  double sum = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    rows.push_back({contestants[i].name, nanoseconds(best_tenth(times[i])),
                    nanoseconds(quantile(times[i], 0.1)) + " - " + nanoseconds(quantile(times[i], 0.9)),
                    book::number(ratio_of_best(times[i], times[rk]))});
    sum += steppers[i]->state()[3];
  }
  program.table("steps", {"method", "ns a step", "eight rounds of ten", "in Runge-Kutta steps"}, rows,
                "A step with h = 0.1; a tenth of " + std::to_string(times[0].size()) +
                    " rounds came under the time and, of both, under that in the ratio.");
  auto const against_rk = ratios(times[0], times[rk]);
  double const ratio = ratio_of_best(times[0], times[rk]);
  program.figure("step_ns", 1e9 * best_tenth(times[0]), "exact step, momentum and attitude, ns");
  program.figure("momentum_ns", 1e9 * best_tenth(times[1]), "exact step, momentum alone, ns");
  program.figure("compensated_ns", 1e9 * best_tenth(times[2]), "compensated step, ns");
  program.figure("runge_kutta_ns", 1e9 * best_tenth(times[rk]), "Runge-Kutta step, ns");
  program.figure("step_ratio", ratio, "exact step in Runge-Kutta steps, of the best tenth of the rounds");
  program.figure("step_ratio_low", quantile(against_rk, 0.1),
                 "the same round by round, a tenth of the rounds below");
  program.figure("step_ratio_high", quantile(against_rk, 0.9), "the same, a tenth of the rounds above");
  program.figure("compensated_ratio", ratio_of_best(times[2], times[0]), "compensated step in plain ones");
  program.figure("sum", sum, "sum of the last states, so that nothing is left out");
  program.claim_of_time(ratio <= 0.6,
                        "the exact step with attitude costs at most 0.6 of a Runge-Kutta step; measured " +
                            book::number(ratio));
}

// ---- What an error costs

constexpr double duration = 1000;
constexpr double targets[] = {1e-4, 1e-8, 1e-10, 1e-12};

std::vector<Curve> all_curves(Benchmark const& program, Witnesses const& exact) {
  std::vector<Curve> curves;
  Patience const patience = program.length(Patience{}, Patience{.share = 0.3, .repeats = 2, .idle = 10});
  auto const fixed = [&](Method const& m, double first, double ratio, double longest) {
    curves.push_back(with_fixed_steps(task, duration, m, exact, first, ratio, longest, patience));
  };
  curves.push_back({{"exact, each time by one evaluation", {}}, [](double) {
                      States states;
                      for (int k = 0; k < looks; ++k)
                        states[k] = peers::seven(peers::free_body(task).at(duration * (k + 1) / looks));
                      return states;
                    }});
  curves.back().runs.push_back(run(curves.back(), looks, exact, patience));
  curves.back().runs.back().seconds /= looks;
  // The closed form that textbooks have, set up and evaluated anew for each time as well.
  curves.push_back({{peers::elliptic_functions().name, {}}, [](double) {
                      States states;
                      for (int k = 0; k < looks; ++k)
                        states[k] = peers::EllipticBody(task).at(duration * (k + 1) / looks);
                      return states;
                    }});
  curves.back().runs.push_back(run(curves.back(), looks, exact, patience));
  curves.back().runs.back().seconds /= looks;
  fixed(peers::exact_half_turns(), 1000, 1.5, 1e-3);
  fixed(peers::exact_compensated(), 1000, 1.5, 1e-3);
  for (int const order : {10, 8, 6}) fixed(peers::moser_veselov_once(order), 1000, 1.15, 0.1);
  fixed(peers::preprocessed_moser_veselov(10), 1000, 1.15, 0.1);
  fixed(peers::preprocessed_moser_veselov(6), 1000, 1.25, 0.1);
  fixed(peers::odeint_fehlberg(), 1000, 1.08, 0.03);
  fixed(peers::gsl_prince_dormand(), 1000, 1.08, 0.03);
  fixed(peers::odeint_dormand_prince(), 2000, 1.2, 0.1);
  fixed(peers::runge_kutta(), 4000, 1.25, 0.15);
  curves.push_back(with_step_control(
      "odeint, Fehlberg, step control",
      [](double tolerance) { return peers::odeint_adaptive<looks>(task, duration, tolerance); }, exact,
      patience));
  curves.push_back(with_step_control(
      "GSL, Prince-Dormand, step control",
      [](double tolerance) { return peers::gsl_adaptive<looks>(task, duration, tolerance); }, exact,
      patience));
  fixed(peers::moser_veselov_once(2), 10000, 2, 0.05);
  fixed(peers::implicit_midpoint(), 10000, 2, 0.3);
  fixed(peers::splitting(), 10000, 2, 0.15);
  return curves;
}

// A curve of a picture: the name of its method, the label, whether it is ours.
struct Shown {
  std::string method, label;
  bool ours;
};

void show_curves(book::Program& program, std::vector<Curve> const& curves) {
  std::vector<book::Program::Row> rows;
  for (Curve const& c : curves) {
    book::Program::Row row{c.name};
    for (double const target : targets) {
      Timed const* const best = c.cheapest(target);
      row.push_back(best ? microseconds(best->seconds) : "not reached");
    }
    row.push_back(book::number(c.best_error(), 2));
    rows.push_back(row);
  }
  program.table("work_precision", {"method", "1e-4", "1e-8", "1e-10", "1e-12", "best error"}, rows,
                "Microseconds to T = 1000, set-up included, with the best step for each error, which is "
                "the largest of momentum and attitude at t = 100, 200, ... 1000; the last column is the "
                "smallest error that any step reached.");
  auto const compare = [&](std::string const& name, std::vector<Shown> const& shown,
                           std::string const& caption) {
    DigitsPlot plot("correct digits of momentum and attitude, up to T = 1000");
    for (Shown const& wanted : shown)
      for (Curve const& c : curves)
        if (c.name == wanted.method) plot.line(c.runs, wanted.label, wanted.ours);
    program.picture(name, plot.svg(), caption);
  };
  compare("work_precision",
          {{curves.front().name, "exact, at one time", true},
           {peers::exact_half_turns().name, "exact steps", true},
           {peers::elliptic_functions().name, "elliptic functions", false},
           {peers::preprocessed_moser_veselov(10).name, "Hairer-Vilmart, order 10", false},
           {peers::gsl_prince_dormand().name, "GSL, Prince-Dormand", false},
           {peers::odeint_fehlberg().name, "odeint, Fehlberg", false},
           {peers::runge_kutta().name, "Runge-Kutta", false}},
          "Time for an accuracy: ours are bold. Each line has the least time in which its method reached so "
          "many digits.");
  compare("orders",
          {{peers::moser_veselov_once(2).name, "order 2", true},
           {peers::moser_veselov_once(6).name, "order 6", true},
           {peers::moser_veselov_once(8).name, "order 8", true},
           {peers::moser_veselov_once(10).name, "order 10", true},
           {peers::preprocessed_moser_veselov(6).name, "Hairer-Vilmart, order 6", false},
           {peers::preprocessed_moser_veselov(10).name, "Hairer-Vilmart, order 10", false},
           {peers::implicit_midpoint().name, "implicit midpoint", false},
           {peers::splitting().name, "splitting", false}},
          "What the order of the Moser-Veselov scheme brings, its twist found once; ours are bold.");
}

// The race at 1e-12: the exact steps and the best of the general-purpose codes, in turns.
double race(Benchmark& program, std::vector<Curve> const& curves) {
  Curve const* exact = nullptr;
  std::vector<std::pair<Curve const*, Timed const*>> others;
  for (Curve const& c : curves) {
    if (c.name == peers::exact_half_turns().name) exact = &c;
    bool const general = c.name.starts_with("GSL") || c.name.starts_with("odeint");
    if (general) others.push_back({&c, c.cheapest(std::max(1e-12, c.best_error()))});
  }
  Timed const* const own = exact->cheapest(1e-12);
  program.claim(own != nullptr, "the exact steps reach 1e-12");
  if (!own) return 0;
  // Of those that reach 1e-12 the fastest; if none does, of all, each with the step that brings it nearest.
  bool const reached =
      std::any_of(others.begin(), others.end(), [](auto const& o) { return o.second->error <= 1e-12; });
  if (reached) std::erase_if(others, [](auto const& o) { return o.second->error > 1e-12; });
  std::vector<Contestant> contestants;
  double sum = 0;
  contestants.push_back({exact->name,
                         [&] {
                           for (int k = 0; k < 50; ++k) sum += exact->solve(own->setting).back()[3];
                         },
                         50});
  for (auto const& [curve, best] : others)
    contestants.push_back(
        {curve->name,
         [&sum, curve = curve, setting = best->setting] { sum += curve->solve(setting).back()[3]; }, 1});
  auto const times = in_turns(program.rounds(15), contestants);
  std::size_t first = 1;
  for (std::size_t i = 1; i < times.size(); ++i)
    if (best_tenth(times[i]) < best_tenth(times[first])) first = i;
  auto const faster = ratios(times[first], times[0]);
  double const gain = ratio_of_best(times[first], times[0]);
  program.figure("own_us", 1e6 * best_tenth(times[0]), "exact steps to 1e-12, microseconds");
  program.figure("own_h", duration / own->setting, "their length");
  program.figure("own_error", own->error, "their error");
  program.figure("other_us", 1e6 * best_tenth(times[first]),
                 "the best of GSL and odeint, " + contestants[first].name + ", microseconds");
  program.figure("other_name", 1e6 * best_tenth(times[first]), contestants[first].name,
                 "the best of GSL and odeint");
  program.figure("other_error", others[first - 1].second->error, "its error");
  program.figure("gain", gain, "how many times faster");
  program.figure("gain_low", quantile(faster, 0.1), "the same, a tenth of the rounds below");
  program.figure("gain_high", quantile(faster, 0.9), "the same, a tenth of the rounds above");
  program.figure("race_sum", sum, "sum of the last states");
  program.claim_of_time(gain >= 300,
                        "to T = 1000 within 1e-12 the exact steps are at least 300 times faster than the "
                        "best of GSL and odeint; measured " +
                            book::number(gain));
  return gain;
}

// Only the end: body constructed, parameters computed, one step, each time another body.
void end_point(Benchmark& program, double error, double elliptic_error) {
  double sum = 0, shift = 0;
  auto const another = [&] {
    Task other = task;
    other.M[1] += shift, shift += 1e-9;
    return other;
  };
  auto const times =
      in_turns(program.rounds(41), {{"end point",
                                     [&] {
                                       for (int k = 0; k < 2000; ++k)
                                         sum += peers::free_body(another()).at(duration).attitude.value[0];
                                     },
                                     2000},
                                    {peers::elliptic_functions().name,
                                     [&] {
                                       for (int k = 0; k < 200; ++k)
                                         sum += peers::EllipticBody(another()).at(duration)[3];
                                     },
                                     200}});
  double const seconds = best_tenth(times[0]);
  program.figure("end_us", 1e6 * seconds, "end point at T = 1000 alone, set-up included, microseconds");
  program.figure("end_us_high", 1e6 * quantile(times[0], 0.9), "the same, a tenth of the rounds above");
  program.figure("end_error", error, "its error");
  program.figure("elliptic_us", 1e6 * best_tenth(times[1]),
                 "the same by elliptic functions of GSL, microseconds");
  program.figure("elliptic_error", elliptic_error, "its error");
  program.figure("elliptic_gain", ratio_of_best(times[1], times[0]),
                 "how many times longer that takes than ours");
  program.figure("end_sum", sum, "sum of the attitudes");
  program.claim_of_time(
      seconds <= 1e-6,
      "the end point alone takes at most a microsecond, set-up included; measured " + microseconds(seconds));
  program.claim(error <= 1e-12, "the end point is right to 1e-12; measured " + book::number(error));
}

// ---- How far what is conserved walks away

void drifts(Benchmark& program) {
  long const steps = program.length(10000000L, 1000000L);
  struct Entry {
    Method method;
    double h;
    std::string key;
  };
  std::vector<Entry> const entries{{peers::exact_compensated(), 0.1, "compensated"},
                                   {peers::exact_half_turns(), 0.1, "plain"},
                                   {peers::moser_veselov_once(2), 0.1, "order2"},
                                   {peers::moser_veselov_once(10), 0.1, "order10"},
                                   {peers::moser_veselov_each_step(2), 0.1, "order2_each"},
                                   {peers::preprocessed_moser_veselov(10), 0.1, "preprocessed"},
                                   {peers::implicit_midpoint(), 0.1, "midpoint"},
                                   {peers::splitting(), 0.1, "splitting"},
                                   {peers::runge_kutta(), 0.01, "runge_kutta"}};
  std::vector<book::Program::Row> rows;
  for (auto const& [method, h, key] : entries) {
    auto const stepper = method.make(task, h);
    Drift const d = drift_of(task, *stepper, steps);
    rows.push_back({method.name, book::number(h), book::number(d.amount, 2), book::number(d.energy, 2),
                    book::number(d.spatial, 2)});
    program.figure("drift_amount_" + key, d.amount, method.name + ", magnitude");
    program.figure("drift_energy_" + key, d.energy, method.name + ", energy");
    program.figure("drift_spatial_" + key, d.spatial, method.name + ", momentum in space");
  }
  program.table(
      "drift", {"method", "h", "magnitude", "energy", "momentum in space"}, rows,
      "Relative change after " + std::string(program.is_short() ? "a million" : "ten million") + " steps.");
}

int main(int argc, char** argv) {
  gsl_set_error_handler_off();
  Benchmark program(argc, argv, "the free rigid body: time of a step, time against error, drift");
  step_times(program);

  Witnesses exact;
  double const witness_seconds = processor_seconds_of([&] { exact = peers::witness<looks>(task, duration); });
  peers::Exact const early = peers::witness<1>(task, 2)[0];
  double const apart = peers::difference(early, peers::witness_by_library(task, 2));
  program.claim(apart <= 1e-22,
                "the reference solution agrees with taylor_reference at T = 2 to 1e-22; measured " +
                    book::number(apart));
  program.figure("witness_apart", apart, "the reference solution at T = 2 against taylor_reference");
  program.figure("witness_s", witness_seconds, "the reference solution, power series in 50 digits, seconds");
  auto const curves = all_curves(program, exact);
  show_curves(program, curves);
  double const gain = race(program, curves);
  end_point(program, curves[0].best_error(), curves[1].best_error());

  drifts(program);
  program.headline("to T = 1000 within 1e-12 the exact steps are " + book::number(gain) +
                       " times faster than the best of GSL and odeint",
                   gain);
  return program.finish();
}
