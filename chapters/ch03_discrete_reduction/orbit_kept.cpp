// On its coadjoint orbit: the Casimir functions of a submarine, over ten thousand steps.
//
// What is shown. The momenta of turning and gliding, Pi and P, change all the time in the body frame; |P|^2
// and Pi . P do not, because they belong to the coadjoint orbit. The discrete Lie-Poisson update (3.18)
// carries the momentum along its orbit, whatever the step. Runge-Kutta, which solves Kirchhoff's equations
// with the same step and more accurately at first, leaves it.
// Read first. The section "The discrete Lie-Poisson algorithm" of chapter 3, and two_ways_on_se3.
//
//   Pi, P    body momenta of turning and of gliding        f     relative motion g1^-1 g0
//   l        reduced discrete Lagrangian, J s              h     step, s
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/reduction/natural_chart.hpp"
#include "book/plot.hpp"
#include "submarine.hpp"

using namespace actio;
using Momenta = Momentum<SE<3>, double>;

// |P|^2 and Pi . P.
Vector<double, 2> casimirs(Momenta const& m) {
  return {m.components.tail<3>().squaredNorm(), m.components.head<3>().dot(m.components.tail<3>())};
}

int main(int argc, char** argv) {
  book::Program program(
      argc, argv,
      "the momenta of a submarine stay on their coadjoint orbit; under Runge-Kutta they leave it");

  // 1. The submarine of two_ways_on_se3, cast off the same way.
  Submarine const energy;
  double const h = 0.2;
  auto const l = natural_chart_lagrangian_left(energy, h);
  auto const xi = velocity(SE<3>{}, energy.cast_off);
  Momenta const cast_off = gradient(energy, xi);
  auto const error = [&](Momenta const& m) {
    return (casimirs(m).cwiseQuotient(casimirs(cast_off)) - Vector<double, 2>(1, 1)).cwiseAbs();
  };

  // 2. Ten thousand steps of the algorithm on the dual: solve for the relative motion, carry the momentum
  //    (3.18); and of Runge-Kutta.
  Momenta m = cast_off;
  auto f = exp(-h * xi);
  Motion motion{.xi = energy.cast_off};
  Vector<double, 2> discrete(0, 0), classical(0, 0);
  std::vector<double> time, turning, curves[4];
  int const steps = 10000;
  for (int k = 1; k <= steps; ++k) {
    f = relative_motion_from_momentum_left(l, m, f).value;
    m = lie_poisson_update_left(f, m);
    motion = runge_kutta(energy, motion, h);
    discrete = discrete.cwiseMax(error(m));
    classical =
        classical.cwiseMax(error(momentum(SE<3>{}, Vector6d(energy.inertia.cwiseProduct(motion.xi)))));
    if (k % 50) continue;
    time.push_back(k * h);
    for (int i = 0; i < 2; ++i) curves[i].push_back(discrete[i]), curves[2 + i].push_back(classical[i]);
  }

  // 3. The picture.
  auto plot = book::Plot("time, s", "largest error so far, relative").log_y();
  char const* const names[] = {"|P|², discrete Lie-Poisson", "Π·P, discrete Lie-Poisson", "|P|², Runge-Kutta",
                               "Π·P, Runge-Kutta"};
  for (int i = 0; i < 4; ++i)
    plot.curve(time, curves[i], names[i], {.colour = i / 2 + 1, .dashed = i % 2 == 1});
  program.picture("casimirs", plot.svg(),
                  "The Casimir functions of the coadjoint orbit, over 10 000 steps of 0.2 s.");

  // 4. What must be so: a rounding error or two a step, which add up at worst.
  program.claim(book::measured(discrete.maxCoeff()) < 2 * steps * 0x1p-52,
                "the discrete Lie-Poisson algorithm conserves both to rounding");
  program.claim(book::measured(classical.minCoeff()) > 1e-4, "Runge-Kutta does not");
  program.figure("kept", discrete.maxCoeff(),
                 "change of |P|^2 and Pi . P under the discrete Lie-Poisson algorithm, relative");
  program.figure("lost", classical.maxCoeff(), "the same under Runge-Kutta");
  program.headline("|P|² and Π·P conserved to " + book::number(discrete.maxCoeff(), 2) +
                       "; Runge-Kutta changes them by " + book::number(100 * classical.maxCoeff(), 2) + " %",
                   discrete.maxCoeff());
  return program.finish();
}
