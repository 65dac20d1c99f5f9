// Testing under water: the same instruments on SE(3), where an orbit is harder to see.
//
// What is shown. A body that turns and glides in an ideal fluid has momenta Pi and P (Kirchhoff); its
// coadjoint orbits have four dimensions in a space of six, and their Casimir functions are |P|^2 and Pi . P.
// Whether a map stays on its orbit is asked in three ways, two of which do not use these functions, and they
// agree. Again three maps preserve the orbit and are not Poisson. Read first. judging_integrators.
//
//   Pi, P   momenta of turning and of gliding, in the body frame          h      step, s
#include "actio/groups/motions.hpp"
#include "actio/instruments/leaf_defect.hpp"
#include "actio/instruments/poisson_defect.hpp"
#include "actio/instruments/reversibility_defect.hpp"
#include "verdicts.hpp"
#include "witness/draw.hpp"

using namespace actio;
using rivals::rounding, rivals::shown, rivals::worst;
using Vector6d = Matrix<double, 6, 1>;

int main(int argc, char** argv) {
  book::Program program(argc, argv, "six maps that step a body under water, judged by what they preserve");
  double const h = 0.2;
  constexpr LiePoissonMinus body_momenta;

  // 1. A body under water, whose momenta of turning and gliding have two Casimir functions.
  rivals::DiagonalBody<SE<3>> const diver{Vector6d{{0.4, 1.5, 1.6, 10, 16, 17}}};
  Draw draw(4);
  std::vector<Momentum<SE<3>, double>> dives;
  for (int i = 0; i < 8; ++i)
    dives.push_back({{}, Vector6d(diver.inertia.cwiseProduct(draw.velocity<double>(SE<3>{}).coordinates))});
  auto const glide = [](auto const& m) { return m.components.template tail<3>().squaredNorm(); };
  auto const screw = [](auto const& m) {
    return m.components.template head<3>().dot(m.components.template tail<3>());
  };

  // 2. The table. Each defect at its worst over eight motions.
  std::pair<std::string, double> headline;
  std::vector<book::Program::Row> under_water;
  for (auto const& [name, family] : rivals::on_any_group(diver)) {
    auto const step = family.with_step(h);
    double const poisson = worst(dives, [&](auto const& x) { return poisson_defect(body_momenta, step, x); });
    double const leaf = worst(dives, [&](auto const& x) { return leaf_defect(body_momenta, family, h, x); });
    double const casimirs =
        worst(dives, [&](auto const& x) { return casimir_defect(body_momenta, step, x, glide, screw); });
    double const orbit = worst(dives, [&](auto const& x) { return orbit_defect(step, x); });
    double const back =
        worst(dives, [&](auto const& x) { return self_adjointness_defect(body_momenta, family, h, x); });
    under_water.push_back({name, book::number(rivals::order(diver, family, dives[0]), 2), shown(poisson),
                           shown(leaf), shown(casimirs), shown(orbit), shown(back)});
    bool const keeps_bracket = name == "Strang splitting" || name == "natural chart";
    program.claim(keeps_bracket ? poisson < rounding : poisson > rounding,
                  name + " on SE(3)" + (keeps_bracket ? " is Poisson" : " is not Poisson"));
    program.claim((std::max({leaf, casimirs, orbit}) > rounding) == (name == "Runge-Kutta 4"),
                  name + " on SE(3): whether it preserves the orbit, asked in three ways");
    if (name == "implicit midpoint")
      headline = {"implicit midpoint preserves the orbit to " + book::number(orbit, 1) +
                      " and misses the bracket by " + book::number(poisson, 2),
                  poisson};
  }
  program.table("under_water", {"map", "order", "Poisson", "leaf", "Casimirs", "orbit", "way back"},
                under_water,
                "Defects of one step of 0.2 s on SE(3), for a body that glides and turns under water, "
                "at their worst over eight motions. Three ways to ask whether it preserves its "
                "coadjoint orbit: by the direction of the step, by the Casimir functions |P|² and Π·P, "
                "by the distance from the orbit.");
  program.headline(headline.first, headline.second);
  return program.finish();
}
