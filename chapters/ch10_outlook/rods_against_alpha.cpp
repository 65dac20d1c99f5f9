// The scheme for rods against generalised-alpha, on the same elements.
//
// What is shown. A rod is pulled, turned and let go in space (flying spaghetti), and two schemes in time are
// held to a reference of the same elements: explicit steps, which conserve momenta, and generalised-alpha,
// which solves equations in every step and damps fast waves where it is told to. Read first. Section 10G.
//
//   h   step     rho   amplification of the fastest waves by generalised-alpha
//
// Compiled at -O2: it takes many steps.
#include "ch10_outlook/rod_runs.hpp"

using namespace actio;
using namespace actio::rods;
using Table = std::vector<book::Program::Row>;
using List = std::vector<double>;

// 1. A rod of ten elements, a force and a moment at one end until time 5, and what both methods need for an
// error: orders are 2, so that a step which makes another error is known.
struct Spaghetti {
  RodSection section;
  double most;  // moment
  RodShape rest;

  Spaghetti(RodSection const& of, double moment) : section(of), most(moment) {
    double const half = std::atan2(-0.8, 0.6) / 2;
    rest = RodShape::of_strains(10, 10, {0, 8, 0}, {std::cos(half), 0, 0, std::sin(half)});
  }
  EndLoad load(double t) const {
    double const m = std::max(0.0, std::min(t, 5 - t)) * most / 2.5;
    return {{m / 10, 0, 0}, {0, -m / 2, -m}};
  }
  SemiDiscreteRod elements() const {
    SemiDiscreteRod out(section, rest);
    out.load = [*this](double t) { return load(t); };
    return out;
  }
  Rod explicit_steps(double h) const {
    RodLoads loads;
    loads.end.force = [*this](double t) { return load(t).force; };
    loads.end.moment = [*this](double t) { return load(t).moment; };
    return {section, rest, {rest, {}, {}}, loads, {.step = h}};
  }
};
double work_for(double error, RodRun const& run) {
  return run.microseconds / (run.step * std::sqrt(error / run.error));
}

double compare(book::Program& program, std::string const& name, Spaghetti const& rod) {
  auto const elements = rod.elements();
  auto const begin = RodMotion::at_rest(rod.rest);
  // The load has corners at 2.5 and 5, where the reference begins anew; steps end there.
  RodMotion truth = begin;
  double from = 0;
  for (double const to : {2.5, 5.0, 6.0}) truth = truth.later(elements, from, to, 1e-13), from = to;
  Table rows;
  List steps, errors;
  double angular = 0, lost = 0;
  RodRun own, other;
  for (double const h : {1.0 / 160, 1.0 / 320, 1.0 / 640}) {
    own = measure(rod.explicit_steps(h), h, 6, 54, truth);
    rows.push_back(row_of("explicit", own, true));
    steps.push_back(h), errors.push_back(own.error), angular = std::max(angular, own.angular);
  }
  double const order = book::exponent(steps, errors);
  program.figure(name + "_order", order, "order of the explicit steps");
  program.claim(book::measured(order) > 1.97 && book::measured(order) < 2.03,
                name + ": explicit steps and the reference meet with order 2");
  for (double const rho : {1.0, 0.9, 0.6}) {
    List long_steps, of_rho;
    for (double const h : {0.1, 0.05, 0.025}) {
      RodRun const run = measure(GeneralisedAlpha(elements, begin, rho, h), h, 6, 24, truth);
      rows.push_back(row_of("alpha, rho = " + book::number(rho), run, true));
      long_steps.push_back(h), of_rho.push_back(run.error);
      if (h == 0.1) lost = run.lost;
      if (rho == 1) other = run;
    }
    double const slope = book::exponent(long_steps, of_rho);
    program.claim(book::measured(slope) > 1.9 && book::measured(slope) < 2.1,
                  name + ": generalised-alpha with rho = " + book::number(rho) + " has order 2");
  }
  program.table(
      name, {"method", "h", "error at t = 6", "energy", "lost", "angular momentum", "solves", "microseconds"},
      rows,
      "Flying spaghetti of ten elements. Relative changes of energy (the largest, and what is lost at "
      "the end) and of angular momentum in free flight, of explicit steps until t = 60, of "
      "generalised-alpha until t = 30; systems of equations and microseconds of a step.");
  program.claim(book::measured(angular) < 1e-12, name + ": explicit steps conserve angular momentum");
  program.claim(book::measured(lost) > 1e-3,
                name + ": generalised-alpha with rho = 0.6 and h = 0.1 loses energy");
  double const gain = work_for(1e-3, other) / work_for(1e-3, own);
  program.figure(name + "_gain", gain, book::number(gain, 2),
                 "time of generalised-alpha over that of explicit steps, for the same error of 0.001");
  program.claim(book::measured(gain) > 4, name + ": explicit steps take less time for the same error");
  return gain;
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "rods in explicit steps and by generalised-alpha");
  compare(program, "softer", {{{2e3, 1e3, 1e3}, {300, 200, 150}, 2, {4, 2, 3}}, 60});
  double const gain =
      compare(program, "spaghetti", {{{1e4, 1e4, 1e4}, {500, 500, 500}, 1, {10, 10, 10}}, 200});
  program.headline("explicit steps of a rod take " + book::number(gain, 2) +
                       " times less time than generalised-alpha for the same error",
                   gain);
  return program.finish();
}
