// Two implementations on SE(3): a submarine in still water, stepped with its configuration and without it.
//
// What is shown. The water takes part in the motion of a body: pushed aside it weighs more than pushed ahead,
// and so the submarine tumbles without any force. Its energy does not care where it is (Kirchhoff's
// equations). One way solves the discrete Euler-Lagrange equations (3.2) for configurations; the other
// solves (3.11) for relative motions and puts the configurations together afterwards (3.15). They lead to the
// same configurations, and the second is shorter.
// Read first. Section 3.2 of chapter 3, up to "Reconstruction".
//
//   g        configuration in SE(3), body to space    l     reduced discrete Lagrangian, J s
//   f        relative motion g1^-1 g0                 L     the same on pairs of configurations, l(g1^-1 g0)
//   xi       turning and gliding                      h     step, s
//
// Compiled at -O2: it takes many steps.
#include "actio/groups/motions.hpp"
#include "actio/reduction/discrete_forms.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/reduction/natural_chart.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"
#include "submarine.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;
using Configuration = Element<SE<3>, double>;

SE<3> const space;
Submarine const energy;
double const h = 0.2;
int const steps = 240;
Configuration const g0 = identity<double>(space);

// 1. The submarine (submarine.hpp) is its own Lagrangian; the discrete one comes from a natural chart (3.25),
//    and the same is a function of two configurations.
auto weigh_and_discretise(book::Program& program) {
  auto const inertia = energy.inertia;
  program.say("the water makes it ", inertia[3] / energy.mass, ", ", inertia[4] / energy.mass, ", ",
              inertia[5] / energy.mass, " times as heavy, axis by axis");
  auto const l = natural_chart_lagrangian_left(energy, h);
  return std::pair{l, lift_left(l)};
}

// 2. Cast off. The first step starts with this momentum.
template <class Reduced>
Configuration first_relative_motion(Reduced const& l, double h) {
  Vector6d const xi = energy.cast_off;
  auto const cast_off = gradient(energy, velocity(space, xi));
  return relative_motion_from_momentum_left(l, cast_off, exp(velocity(space, Vector6d(-h * xi)))).value;
}

// What the two ways lead to: the configurations, the times they took, and how far they are apart, relative.
struct Ways {
  std::vector<Configuration> reduced, unreduced;
  double reduced_time, unreduced_time, apart;
};

// 3. The two ways.
template <class Reduced, class Unreduced>
Ways take_both_ways(Reduced const& l, Unreduced const& L) {
  auto const f0 = first_relative_motion(l, h);
  std::vector<Configuration> reduced{g0, reconstruct_left(g0, f0)}, unreduced = reduced;
  double const reduced_time = book::seconds_of([&] {
    auto f = f0;
    for (int k = 1; k < steps; ++k) {
      f = step_euler_poincare_left(l, f).value;
      reduced.push_back(reconstruct_left(reduced[k], f));
    }
  });
  double const unreduced_time = book::seconds_of([&] {
    for (int k = 1; k < steps; ++k)
      unreduced.push_back(step_euler_lagrange(L, unreduced[k - 1], unreduced[k]).value);
  });
  double apart = 0;
  for (int k = 0; k <= steps; ++k)
    apart = std::max(apart, (reduced[k].value - unreduced[k].value).norm() / reduced[k].value.norm());
  return {reduced, unreduced, reduced_time, unreduced_time, apart};
}

// The section of the submarine across its axis i, at the configuration g.
std::vector<Vector3d> section_across(int i, Matrix<double, 4, 4> const& g) {
  std::vector<Vector3d> section;
  for (int degree = 0; degree <= 360; degree += 5) {
    Vector3d p = Vector3d::Zero();
    p[(i + 1) % 3] = energy.half_axes[(i + 1) % 3] * std::cos(degree * M_PI / 180);
    p[(i + 2) % 3] = energy.half_axes[(i + 2) % 3] * std::sin(degree * M_PI / 180);
    section.push_back(g.topLeftCorner<3, 3>() * p + g.topRightCorner<3, 1>());
  }
  return section;
}

// 4. Look at it from one side: the path, and the submarine by three of its sections every few seconds.
void draw_the_path(book::Program& program, Ways const& ways) {
  auto plot = book::Plot("metres to the right", "metres upwards").equal().size(660, 220);
  Vector3d const right(0.96, 0.28, 0), up(-0.5 * 0.28, 0.5 * 0.96, std::sqrt(0.75));
  auto const draw = [&](std::vector<Vector3d> const& points, std::string const& label, book::Look look) {
    std::vector<double> x, y;
    for (auto const& p : points) x.push_back(right.dot(p)), y.push_back(up.dot(p));
    plot.curve(x, y, label, look);
  };
  std::vector<Vector3d> path, dots;
  for (int k = 0; k <= steps; ++k) {
    Matrix<double, 4, 4> const& g = ways.reduced[k].value;
    path.push_back(g.topRightCorner<3, 1>());
    if (k % 4 == 0) dots.push_back(ways.unreduced[k].value.topRightCorner<3, 1>());
    for (int i = 0; k % 24 == 0 && i < 3; ++i) draw(section_across(i, g), "", {.colour = 6, .width = 1});
  }
  draw(path, "reduced steps, put together", {.colour = 1}),
      draw(dots, "unreduced steps, every fourth", {.colour = 2, .dots = true, .radius = 2.2});
  program.picture("path", plot.svg(),
                  "A submarine cast off ahead (from the left), turning slowly, and left alone for 48 "
                  "seconds; three of its sections every 4.8 seconds. It soon lies across its path and "
                  "tumbles: a long body that glides ahead is not stable in an ideal fluid. The line comes "
                  "from the reduced equation and reconstruction, the dots from the unreduced one.");
}

// 5. The order: halve the step five times, and look where the submarine is after eight seconds.
double measure_the_order(book::Program& program) {
  double const until = 8;
  Motion reference{.xi = energy.cast_off};
  for (int k = 0; k < 8000; ++k) reference = runge_kutta(energy, reference, until / 8000);
  std::vector<std::vector<std::string>> orders;
  std::vector<double> lengths, misses;
  for (int n = 20; n <= 640; n *= 2) {
    auto const l = natural_chart_lagrangian_left(energy, until / n);
    auto f = first_relative_motion(l, until / n);
    auto g = reconstruct_left(g0, f);
    for (int k = 1; k < n; ++k) f = step_euler_poincare_left(l, f).value, g = reconstruct_left(g, f);
    double const miss = (g.value - reference.g).topRightCorner<3, 1>().norm();
    lengths.push_back(until / n), misses.push_back(miss);
    orders.push_back({book::number(until / n), book::number(miss)});
  }
  double const order = book::exponent(lengths, misses);
  program.table("order", {"step, s", "miss, m"}, orders,
                "Distance of the configuration after eight seconds from that of the Kirchhoff equations.");
  return order;
}

// 6. What must be so. Rounding of the momentum, 16 times a step, moves the configuration by its square in the
//    number of steps.
void claim_what_must_be_so(book::Program& program, Ways const& ways, double order) {
  double const epsilon = 0x1p-52;
  program.claim(book::measured(std::abs(lamb(energy.half_axes).sum() - 2)) < 1e3 * epsilon,
                "Lamb's integrals add up to 2");
  program.claim(book::measured(ways.apart) < 16.0 * steps * steps * epsilon,
                "both ways lead to the same configurations");
  program.claim(book::measured(std::abs(order - 2)) < 0.05, "the order is 2");
  program.figure("apart", ways.apart, "distance of the two ways, relative");
  program.figure("cost", ways.unreduced_time / ways.reduced_time,
                 book::number(ways.unreduced_time / ways.reduced_time, 2),
                 "time of the unreduced way over that of the reduced one");
  program.figure("order", order, book::number(order, 3), "order of the reduced steps, fitted");
  program.headline("both ways end in the same configuration, to " + book::number(ways.apart, 2), ways.apart);
}

int main(int argc, char** argv) {
  book::Program program(
      argc, argv,
      "a submarine tumbles through still water: reduced and unreduced steps lead to the same configurations");
  auto const [l, L] = weigh_and_discretise(program);
  Ways const ways = take_both_ways(l, L);
  draw_the_path(program, ways);
  double const order = measure_the_order(program);
  claim_what_must_be_so(program, ways, order);
  return program.finish();
}
