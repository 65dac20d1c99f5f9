// Judging integrators: seven ways to step a spinning body, and what each of them keeps.
//
// What is shown. A map is handed to five instruments, which differentiate it with dual numbers and compare what it carries along with what it should
// have kept: the symplectic form on T*SO(3), the bracket on so(3)*, the coadjoint orbit, the momentum in space, the way back. Three of the maps stay
// on their orbit to rounding and are still not Poisson: to conserve the orbit is not enough. What comes from a discrete Lagrangian, or from exact
// flows, is Poisson. Read first. The section "Judging maps" of chapter 4.
//
//   Pi     momentum as the body feels it       h      step, s
//   p      costate: attitude and momentum in space     defects   0 for what is kept, at most 1 where nothing cancels
#include "actio/foundations/draw.hpp"
#include "actio/foundations/groups/rotations.hpp"
#include "actio/instruments/leaf_defect.hpp"
#include "actio/instruments/momentum_defect.hpp"
#include "actio/instruments/poisson_defect.hpp"
#include "actio/instruments/reversibility_defect.hpp"
#include "actio/instruments/symplectic_defect.hpp"
#include "actio/variational/momentum_map.hpp"
#include "book/plot.hpp"
#include "verdicts.hpp"

using namespace actio;
using rivals::rounding, rivals::shown, rivals::worst;

constexpr LiePoissonMinus body_momenta;  // the bracket of left-invariant systems
constexpr CotangentBundle cotangent_bundle;

int main(int argc, char** argv) {
  book::Program program(argc, argv, "seven maps that step a spinning body, judged by what they keep");
  double const h = 0.2;

  // 1. On SO(3): a body with moments 2, 3, 4 kg m^2, and eight momenta of up to 5 J s, each with an attitude.
  rivals::FreeBody<SO<3>> const body{Eigen::Vector3d(2, 3, 4)};
  auto const contestants = rivals::on_rotations(body);
  Draw draw(4);
  std::vector<Momentum<SO<3>, double>> momenta;
  std::vector<Costate<SO<3>, double>> costates;
  for (int i = 0; i < 8; ++i) {
    momenta.push_back(draw.momentum<double>(SO<3>{}, 5));
    auto const g = draw.element<double>(SO<3>{});
    costates.push_back({g, Ad_star(inverse(g), momenta.back())});
  }

  // 2. The table: each defect at its worst over the eight.
  std::pair<std::string, double> headline;
  std::vector<book::Program::Row> rows;
  for (auto const& rival : contestants) {
    auto const step = rival.on_momenta.with_step(h);
    auto const lifted = rival.on_costates.with_step(h);
    double const p = rivals::order(body, rival.on_momenta, momenta[0]);
    double const symplectic = worst(costates, [&](auto const& x) { return symplectic_defect(cotangent_bundle, lifted, x); });
    double const poisson = worst(momenta, [&](auto const& x) { return poisson_defect(body_momenta, step, x); });
    double const leaf = worst(momenta, [&](auto const& x) { return leaf_defect(body_momenta, rival.on_momenta, h, x); });
    double const orbit = worst(momenta, [&](auto const& x) { return orbit_defect(step, x); });
    double const in_space = worst(costates, [&](auto const& x) {
      return worst(std::vector{0, 1, 2}, [&](int axis) {
        return momentum_defect(cotangent_bundle, lifted, x, left_translation(basis_velocity<double>(SO<3>{}, axis)));
      });
    });
    double const back = worst(momenta, [&](auto const& x) { return self_adjointness_defect(body_momenta, rival.on_momenta, h, x); });
    rows.push_back({rival.name, book::number(p, 2), shown(symplectic), shown(poisson), shown(leaf), shown(in_space), shown(back)});
    bool const classical = rival.name == "Runge-Kutta 4",
               keeps_bracket = rival.name == "Strang splitting" || rival.name == "natural chart" || rival.name == "Moser-Veselov";
    program.claim(keeps_bracket ? poisson < rounding && symplectic < rounding : poisson > rounding && symplectic > rounding,
                  rival.name + (keeps_bracket ? " is Poisson" : " is not Poisson"));
    program.claim(classical ? std::min({leaf, orbit, in_space}) > rounding : std::max({leaf, orbit, in_space}) < rounding,
                  rival.name + (classical ? " leaves the orbit" : " keeps the orbit and the momentum in space"));
    program.claim((rival.name == "Runge-Kutta 4" || rival.name == "Lie-Euler" || rival.name == "Munthe-Kaas 4") == (back > rounding),
                  rival.name + ": whether it goes back the way it came");
    if (rival.name == "implicit midpoint")
      headline = {
          "implicit midpoint keeps the orbit to " + book::number(orbit, 1) + " and misses the bracket by " + book::number(poisson, 2),
          poisson};
    program.claim(std::abs(p - std::round(p)) < 0.15, rival.name + " has the order " + book::number(std::round(p)));
  }
  program.table(
      "rotations", {"map", "order", "symplectic", "Poisson", "leaf", "momentum", "way back"}, rows,
      "Defects of one step of 0.2 s on SO(3), at their worst over eight motions; 0 (...) is rounding. Symplectic and momentum: of attitude "
      "and momentum together. "
      "Leaf: the share of the motion that points out of the coadjoint orbit. Way back: what is missing after a step of opposite sign.");

  // 3. The step grows: leaf and Poisson defects of each map at the first momentum.
  std::vector<double> steps;
  for (double s = 0.025; s < 0.5; s *= 2) steps.push_back(s);
  auto chart = book::Plot("leaf defect", "Poisson defect").log_x().log_y(),
       growth = book::Plot("step, s", "Poisson defect").log_x().log_y();
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    std::vector<double> leaf, poisson;
    for (double const s : steps) {
      leaf.push_back(std::max(0x1p-54, leaf_defect(body_momenta, contestants[i].on_momenta, s, momenta[0])));
      poisson.push_back(std::max(0x1p-54, poisson_defect(body_momenta, contestants[i].on_momenta.with_step(s), momenta[0])));
    }
    int const colour = static_cast<int>(i) % 6 + 1;
    chart.dots(leaf, poisson, contestants[i].name, {.colour = colour, .radius = i == 6 ? 4.5 : 3.2});
    growth.curve(steps, poisson, contestants[i].name, {.colour = colour, .dashed = i == 6});
    if (i > 3) continue;
    // The flow is Poisson, so the defect of one step is no larger than a step misses the flow by: one power more than the order.
    double const power = book::exponent(steps, poisson), least = std::vector{5, 3, 2, 5}[i];
    program.figure("power_" + std::to_string(i), power, book::number(power, 2),
                   contestants[i].name + ": power of the step in its Poisson defect");
    program.claim(power > least - 0.2, contestants[i].name + ": the Poisson defect falls at least as fast as the error of a step");
  }
  program.picture("keeping", chart.svg(),
                  "Each map at steps of 0.025, 0.05, 0.1, 0.2 and 0.4 s, the largest on top. On the left they keep their orbit, at the "
                  "bottom the bracket. Being on the left does not take a map "
                  "to the bottom: there are the maps that come from a discrete Lagrangian or from exact flows.");
  program.picture("growth", growth.svg(),
                  "The Poisson defect of one step against its length. What is not Poisson is so to a power of the step; the others have "
                  "rounding at every step.");
  program.headline(headline.first, headline.second);
  return program.finish();
}
