// Testing integrators: seven ways to step a spinning body, and what each of them preserves.
//
// What is shown. A map is handed to five instruments, which differentiate it with dual numbers and compare
// what it carries along with what it should have preserved: the symplectic form on T*SO(3), the bracket on
// so(3)*, the coadjoint orbit, the momentum in space, the way back. Three of the maps stay on their orbit to
// rounding and are still not Poisson: to conserve the orbit is not enough. What comes from a discrete
// Lagrangian, or from exact flows, is Poisson. Beside the defects stands the change of the energy, which two
// of the seven conserve. Read first. Chapter 4A.
//
//   Pi     momentum in the body frame          h      step, s
//   p      costate: attitude and momentum in space defects 0 for what is preserved, at most 1 where nothing
//          cancels
#include "actio/groups/rotations.hpp"
#include "actio/instruments/leaf_defect.hpp"
#include "actio/instruments/momentum_defect.hpp"
#include "actio/instruments/poisson_defect.hpp"
#include "actio/instruments/reversibility_defect.hpp"
#include "actio/instruments/symplectic_defect.hpp"
#include "actio/variational/momentum_map.hpp"
#include "book/plot.hpp"
#include "verdicts.hpp"
#include "witness/draw.hpp"

using namespace actio;
using rivals::rounding, rivals::shown, rivals::worst;

constexpr LiePoissonMinus body_momenta;  // the bracket of left-invariant systems
constexpr CotangentBundle cotangent_bundle;
constexpr double h = 0.2;

struct Trial {
  rivals::DiagonalBody<SO<3>> body;
  std::vector<rivals::Rival<SO<3>>> contestants;
  std::vector<Momentum<SO<3>, double>> momenta;
  std::vector<Costate<SO<3>, double>> costates;
};
struct Defects {
  double order, symplectic, poisson, leaf, orbit, in_space, energy, back;
};

// 1. On SO(3): a body with moments 2, 3, 4 kg m^2, and eight momenta of up to 5 J s, each with an attitude.
Trial eight_motions() {
  rivals::DiagonalBody<SO<3>> const body{Vector<double, 3>(2, 3, 4)};
  Trial trial{body, rivals::on_rotations(body), {}, {}};
  Draw draw(4);
  for (int i = 0; i < 8; ++i) {
    trial.momenta.push_back(draw.momentum<double>(SO<3>{}, 5));
    auto const g = draw.element<double>(SO<3>{});
    trial.costates.push_back({g, Ad_star(inverse(g), trial.momenta.back())});
  }
  return trial;
}

double kinetic_energy(Trial const& trial, Momentum<SO<3>, double> const& pi) {
  return pair(pi, trial.body.velocity(pi)) / 2;
}

// The order of a map, and each of its defects at its worst over the eight.
Defects worst_defects(Trial const& trial, rivals::Rival<SO<3>> const& rival) {
  auto const step = rival.on_momenta.with_step(h);
  auto const lifted = rival.on_costates.with_step(h);
  return {
      .order = rivals::order(trial.body, rival.on_momenta, trial.momenta[0]),
      .symplectic = worst(trial.costates,
                          [&](auto const& x) { return symplectic_defect(cotangent_bundle, lifted, x); }),
      .poisson = worst(trial.momenta, [&](auto const& x) { return poisson_defect(body_momenta, step, x); }),
      .leaf = worst(trial.momenta,
                    [&](auto const& x) { return leaf_defect(body_momenta, rival.on_momenta, h, x); }),
      .orbit = worst(trial.momenta, [&](auto const& x) { return orbit_defect(step, x); }),
      .in_space = worst(trial.costates,
                        [&](auto const& x) {
                          return worst(std::vector{0, 1, 2}, [&](int axis) {
                            return momentum_defect(cotangent_bundle, lifted, x,
                                                   left_translation(basis_velocity<double>(SO<3>{}, axis)));
                          });
                        }),
      .energy = worst(trial.momenta,
                      [&](auto const& x) {
                        return std::abs(kinetic_energy(trial, step(x)) / kinetic_energy(trial, x) - 1);
                      }),
      .back = worst(trial.momenta, [&](auto const& x) {
        return self_adjointness_defect(body_momenta, rival.on_momenta, h, x);
      })};
}

// What each map must preserve, and what it must not.
void claim_what_it_keeps(book::Program& program, std::string const& name, Defects const& d) {
  bool const classical = name == "Runge-Kutta 4",
             keeps_bracket = name == "Strang splitting" || name == "natural chart" || name == "Moser-Veselov";
  program.claim(keeps_bracket ? d.poisson < rounding && d.symplectic < rounding
                              : d.poisson > rounding && d.symplectic > rounding,
                name + (keeps_bracket ? " is Poisson" : " is not Poisson"));
  program.claim(
      classical ? std::min({d.leaf, d.orbit, d.in_space}) > rounding
                : std::max({d.leaf, d.orbit, d.in_space}) < rounding,
      name + (classical ? " leaves the orbit" : " preserves the orbit and conserves the momentum in space"));
  bool const keeps_energy = name == "implicit midpoint" || name == "Moser-Veselov";
  program.claim(keeps_energy ? d.energy < rounding : d.energy > rounding,
                name + (keeps_energy ? " conserves the energy" : " does not conserve the energy"));
  program.claim(
      (name == "Runge-Kutta 4" || name == "Lie-Euler" || name == "Munthe-Kaas 4") == (d.back > rounding),
      name + ": whether it goes back the way it came");
  program.claim(book::measured(std::abs(d.order - std::round(d.order))) < 0.15,
                name + " has the order " + book::number(std::round(d.order)));
}

// 2. The table: each defect at its worst over the eight. Returns the headline.
std::pair<std::string, double> judge_all(book::Program& program, Trial const& trial) {
  std::pair<std::string, double> headline;
  std::vector<book::Program::Row> rows;
  for (auto const& rival : trial.contestants) {
    auto const d = worst_defects(trial, rival);
    rows.push_back({rival.name, book::number(d.order, 2), shown(d.symplectic), shown(d.poisson),
                    shown(d.leaf), shown(d.in_space), shown(d.energy), shown(d.back)});
    if (rival.name == "Strang splitting" || rival.name == "natural chart")
      program.figure(rival.name == "natural chart" ? "energy_chart" : "energy_splitting", d.energy,
                     book::number(d.energy, 2), rival.name + ": relative change of the energy in one step");
    claim_what_it_keeps(program, rival.name, d);
    if (rival.name == "implicit midpoint")
      headline = {"implicit midpoint preserves the orbit to " + book::number(d.orbit, 1) +
                      " and misses the bracket by " + book::number(d.poisson, 2),
                  d.poisson};
  }
  program.table("rotations",
                {"map", "order", "symplectic", "Poisson", "leaf", "momentum", "energy", "way back"}, rows,
                "Defects of one step of 0.2 s on SO(3), at their worst over eight motions; 0 (...) is "
                "rounding. Symplectic and momentum: of attitude and momentum together. Leaf: the share of "
                "the motion that points out of the coadjoint orbit. Energy: its relative change. Way back: "
                "what is missing after a step of opposite sign.");
  return headline;
}

// 3. The step grows: leaf and Poisson defects of each map at the first momentum.
void let_the_step_grow(book::Program& program, Trial const& trial) {
  std::vector<double> steps;
  for (double s = 0.025; s < 0.5; s *= 2) steps.push_back(s);
  auto chart = book::Plot("leaf defect", "Poisson defect").log_x().log_y(),
       growth = book::Plot("step, s", "Poisson defect").log_x().log_y();
  for (std::size_t i = 0; i < trial.contestants.size(); ++i) {
    std::vector<double> leaf, poisson;
    for (double const s : steps) {
      leaf.push_back(
          std::max(0x1p-54, leaf_defect(body_momenta, trial.contestants[i].on_momenta, s, trial.momenta[0])));
      poisson.push_back(std::max(
          0x1p-54,
          poisson_defect(body_momenta, trial.contestants[i].on_momenta.with_step(s), trial.momenta[0])));
    }
    int const colour = static_cast<int>(i) % 6 + 1;
    chart.dots(leaf, poisson, trial.contestants[i].name, {.colour = colour, .radius = i == 6 ? 4.5 : 3.2});
    growth.curve(steps, poisson, trial.contestants[i].name, {.colour = colour, .dashed = i == 6});
    if (i > 3) continue;
    // The flow is Poisson, so the defect of one step is no larger than a step misses the flow by: one power
    // more than the order.
    double const power = book::exponent(steps, poisson), least = std::vector{5, 3, 2, 5}[i];
    program.figure("power_" + std::to_string(i), power, book::number(power, 2),
                   trial.contestants[i].name + ": power of the step in its Poisson defect");
    program.claim(
        book::measured(power) > least - 0.2,
        trial.contestants[i].name + ": the Poisson defect falls at least as fast as the error of a step");
  }
  std::vector<double> formula;
  double off = 0;
  auto const& rule = trial.contestants[1].on_momenta;
  for (double const s : steps) {
    auto const& pi = trial.momenta[0];
    formula.push_back(rivals::midpoint_defect(trial.body, s, (pi.components + rule(s, pi).components) / 2));
    off = std::max(off, std::abs(formula.back() - poisson_defect(body_momenta, rule.with_step(s), pi)));
  }
  growth.dots(steps, formula, "midpoint, closed form", {.colour = 2});
  program.figure("closed_form", off, "largest distance of the midpoint rule's defect from its closed form");
  program.claim(book::measured(off) < rounding, "the defect of the midpoint rule is its closed form");
  program.picture(
      "keeping", chart.svg(),
      "Each map at steps of 0.025, 0.05, 0.1, 0.2 and 0.4 s, the largest on top. On the left they preserve "
      "their orbit, at the bottom the bracket. Being on the left does not take a map to the bottom: there "
      "are the maps that come from a discrete Lagrangian or from exact flows.");
  program.picture("growth", growth.svg(),
                  "The Poisson defect of one step against its length. What is not Poisson is so to a power "
                  "of the step; the others have rounding at every step.");
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "seven maps that step a spinning body, judged by what they preserve");
  auto const trial = eight_motions();
  auto const headline = judge_all(program, trial);
  let_the_step_grow(program, trial);
  program.headline(headline.first, headline.second);
  return program.finish();
}
