// One step of a body that spins freely, in a program that knows only what was installed.
#include <actio/foundations/groups/rotations.hpp>
#include <actio/reduction/discrete_euler_poincare.hpp>

#include <cstdio>

int main() {
  using namespace actio;
  // A discrete Lagrangian that sees the relative rotation alone, with three different moments.
  auto const l = [](auto const& f) {
    return 2 * f.value(0, 0) + f.value(1, 1) + f.value(2, 2) / 2;
  };
  auto const f01 = exp(velocity(SO<3>{}, Eigen::Vector3d(0.1, 0.2, -0.1)));
  auto const f12 = step_euler_poincare_right(l, f01).value;
  double const missed = euler_poincare_right(l, f01, f12).components.norm();
  std::printf("the step satisfies its equation to %.1e\n", missed);
  // Three components, each a sum of about ten products of numbers of size one.
  return missed < 64 * epsilon<double>() ? 0 : 1;
}
