#include <actio/groups/motions.hpp>
#include <actio/reduction/euler_poincare_steps.hpp>
#include <actio/reduction/natural_chart.hpp>
#include <cstdio>
using namespace actio;

int main() {
  auto const energy = [](auto const& xi) {  // of the hull, from turning and gliding as it feels them
    auto const& v = xi.coordinates;
    return (v[0] * v[0] + v[1] * v[1] + 6.0 * v[2] * v[2]) / 2;
  };
  double const h = 0.05;
  auto const l = natural_chart_lagrangian_left(energy, h);  // a discrete Lagrangian on SE(2)
  EulerPoincareStepsLeft motion(l, exp(velocity(SE<2>{}, Vector<double, 3>(-0.1, -1.0, 0.0) * h)));
  auto g = identity<double>(SE<2>{});
  auto const spatial = [&] { return Ad_star(inverse(g), momentum_before_left(l, motion.relative_motion())); };
  auto const before = spatial();
  for (int step = 0; step < 10000; ++step, motion.advance())  // the reduced equation, after
    g = reconstruct_left(g, motion.relative_motion());        // the lift to the group
  std::printf("spatial momentum kept to %.1e\n", (spatial() - before).components.norm());
}
