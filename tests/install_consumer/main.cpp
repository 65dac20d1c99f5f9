#include <actio/groups/motions.hpp>
#include <actio/reduction/euler_poincare_steps.hpp>
#include <actio/reduction/natural_chart.hpp>

#include <cstdio>
using namespace actio;

int main() {
  // A flat fish in still water, easier to push ahead than aside. Its energy, from turning and gliding as it
  // feels them:
  auto const energy = [](auto const& xi) {
    auto const& v = xi.coordinates;
    return (0.5 * v[0] * v[0] + v[1] * v[1] + 3.0 * v[2] * v[2]) / 2;
  };
  double const h = 0.05;
  auto const l = natural_chart_lagrangian_left(energy, h);  // a discrete Lagrangian on SE(2)
  auto g = identity<double>(SE<2>{});                       // where the fish is
  // the relative motion, which points backwards
  auto const f = exp(velocity(SE<2>{}, Vector<double, 3>(-0.7, -1.0, -0.2) * h));
  EulerPoincareStepsLeft motion(l, f);
  auto const spatial = [&] { return Ad_star(inverse(g), momentum_before_left(l, motion.relative_motion())); };
  auto const before = spatial();
  for (int step = 0; step < 10000; ++step) {
    g = reconstruct_left(g, motion.relative_motion());  // the lift (3.15)
    motion.advance();                                   // the reduced equation (3.11)
  }
  std::printf("10000 steps, spatial momentum kept to %.1e\n",
              (spatial() - before).components.norm() / before.components.norm());
}
