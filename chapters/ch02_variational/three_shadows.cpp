// Three shadows: what is conserved where there are more coordinates than one.
//
// What is shown. A flat body adrift in still water has three coordinates and three momenta, and a thin sheet
// of its states casts three shadows, one in the plane of each pair: each of them changes, their sum does not.
// The sum is the integral of the Lagrange one-form round the rim, and that it stays is F^* omega = omega.
// Read first. The section "The standard geometric setting" of chapter 2, and shadow_of_a_cloud.
//
//   v        state (g, xi) in TG                      l      reduced Lagrangian, of the body velocity
//   rim      closed curve of states, each a dual      h      step
//            number that carries its tangent
#include <algorithm>

#include "actio/groups/motions.hpp"
#include "actio/variational/euler_poincare.hpp"
#include "book/plot.hpp"
#include "cloud.hpp"

using namespace actio;

// 1. A flat body in still water, on SE(2), is easier to push ahead than aside. It does not matter where it
//    is, so its acceleration comes from the reduced equation.
auto const l = [](auto const& xi) {
  auto const& v = xi.coordinates;
  return (0.5 * v[0] * v[0] + v[1] * v[1] + 3.0 * v[2] * v[2]) / 2.0;
};
auto const body = left_invariant(l);
auto const glide = [](auto const& v) {
  return Ad(v.configuration, euler_poincare_acceleration_left(l, body_velocity(v)));
};

// 2. The rim of the cloud is a closed curve through all six dimensions.
auto rim_adrift() {
  return closed_curve(32, [](auto const& s) {
    using S = std::decay_t<decltype(s)>;
    auto const c = cos(s), d = sin(s);
    Coordinates<SE<2>, S> const configuration(0.15 * c, 0.15 * d, 0.2 * c),
        speed(0.6 + 0.15 * d, 1.0 + 0.1 * c, 0.3 - 0.1 * d);
    auto const g = exp(velocity(SE<2>{}, configuration));
    return State<SE<2>, S>{g, Ad(g, velocity(SE<2>{}, speed))};
  });
}
using Rim = decltype(rim_adrift());

// 3. A shadow's area is the integral of its momentum over its coordinate; that of the angle is about the
//    body's centre.
double shadow(Rim const& curve, int which) {
  double sum = 0;
  for (auto const& v : curve) {
    auto const mu = legendre(body, value_of(v)).components;
    auto const x = v.configuration.value(0, 2), y = v.configuration.value(1, 2);
    double const turn = change_of(v).configuration.coordinates[0];
    sum += which == 0   ? (mu[0] - x.value * mu[2] + y.value * mu[1]) * turn
           : which == 1 ? mu[1] * x.part[0]
                        : mu[2] * y.part[0];
  }
  return sum;
}

// 4. The areas of the shadows are followed along the motion, and as the fourth the integral of the one-form.
//    Its largest relative change is `change`, and `split` is how far it differs from the sum of the three.
double const h = 0.005, duration = 5;
struct Areas {
  std::vector<double> time, each[4];
  double change = 0, split = 0;
};
Areas areas_of_shadows(Rim drift) {
  Areas areas;
  auto& each = areas.each;
  double const sum_before = shadows(body, drift);
  for (int k = 0; k * h < duration + h / 2; ++k) {
    if (k % 10 == 0) {
      areas.time.push_back(k * h), each[3].push_back(shadows(body, drift));
      for (int which = 0; which < 3; ++which) each[which].push_back(shadow(drift, which));
      double const sum = each[0].back() + each[1].back() + each[2].back();
      areas.change = std::max(areas.change, std::abs(each[3].back() / sum_before - 1));
      areas.split = std::max(areas.split, std::abs(sum - each[3].back()));
    }
    for (auto& v : drift) v = runge_kutta(glide, v, h);
  }
  return areas;
}

// 5. The shadows are drawn, and with them their sum under explicit Euler with long steps.
void draw(book::Program& program, Areas const& areas, Rim euler_drift) {
  double const long_step = 0.1;
  std::vector<double> euler_time, euler_sum;
  for (int k = 0; k * long_step < duration + h / 2; ++k) {
    euler_time.push_back(k * long_step), euler_sum.push_back(shadows(body, euler_drift));
    for (auto& v : euler_drift) v = explicit_euler(glide, v, long_step);
  }
  auto plot = book::Plot("time", "area of the shadow");
  char const* const planes[] = {"angle and its momentum", "x and its momentum", "y and its momentum",
                                "sum of the three"};
  for (int i = 0; i < 4; ++i)
    plot.curve(areas.time, areas.each[i], planes[i], {.colour = i + 1, .width = i == 3 ? 2.4 : 1.6});
  plot.curve(euler_time, euler_sum, "sum under explicit Euler", {.colour = 4, .dashed = true});
  program.picture("shadows", plot.svg(),
                  "A cloud of a flat body adrift in still water, in three coordinates and "
                  "three momenta, has a shadow in each of three planes. Area goes from one "
                  "shadow to the others; the sum stays.");
}

int main(int argc, char** argv) {
  book::Program program(
      argc, argv, "a body adrift: a sheet of its states has three shadows, each changes, their sum stays");
  Rim const adrift = rim_adrift();
  Areas const areas = areas_of_shadows(adrift);
  draw(program, areas, adrift);
  program.figure("kept", areas.change, "largest change of the sum of the shadows, relative");
  program.figure("split", areas.split, "integral of the one-form less the sum of the shadows");

  // 6. What must be so. Runge-Kutta is of order 4, and the fastest rate is about 5 per unit of time.
  auto const [least, most] = std::ranges::minmax(areas.each[2]);
  program.claim(book::measured(areas.change) < std::pow(5 * h, 4), "the sum of the shadows stays as it is");
  program.claim(book::measured(areas.split) < std::pow(5 * h, 4),
                "the integral of the one-form is the sum of the shadows");
  program.claim(book::measured(most - least) > std::abs(shadows(body, adrift)),
                "a single shadow changes by more than the sum");
  program.headline("sum of three shadows conserved to " + book::number(areas.change, 2), areas.change);
  return program.finish();
}
