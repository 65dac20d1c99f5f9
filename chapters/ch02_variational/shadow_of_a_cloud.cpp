// The shadow of a cloud: what it means that a flow is symplectic.
//
// What is shown. Nearby states of a pendulum form a cloud. Its motion bends and stretches it, but its area
// stays what it was, which is what F^* omega = omega says; under explicit Euler the cloud grows. Read first.
// The section "The standard geometric setting" of chapter 2.
//
//   v        state (g, xi) in TG                      L      Lagrangian on TG
//   w        tangent vector to TG at v                theta  Lagrange one-form, p dq
//   rim      closed curve of states, each a dual      omega  Lagrange two-form, dq ^ dp
//            number that carries its tangent          h      step
//
// Compiled at -O2: it takes many steps.
#include "actio/groups/rotations.hpp"
#include "actio/variational/euler_lagrange.hpp"
#include "book/plot.hpp"
#include "cloud.hpp"

using namespace actio;

// 1. The pendulum is on SO(2); its length and gravity are 1, and its angle is counted from below.
auto const pendulum = [](auto const& v) {
  auto const& xi = v.velocity.coordinates[0];
  return xi * xi / 2.0 + v.configuration.value(0, 0);  // the cosine of the angle
};
auto const swing = [](auto const& v) { return lagrange_acceleration(pendulum, v); };

// 2. The cloud is a disc in the plane of angle and momentum: a rim, whose states carry its tangent, and in it
//    a sunflower's seeds, the same on every machine.
using Cloud = std::vector<State<SO<2>, Dual<double>>>;
long const edge = 240, seeds = 260;
Cloud disc() {
  auto const at = [](Dual<double> const& r, Dual<double> const& s) {
    Coordinates<SO<2>, Dual<double>> const angle(r * cos(s)), momentum(r * sin(s) + 1.35);
    return State<SO<2>, Dual<double>>{exp(velocity(SO<2>{}, angle)), velocity(SO<2>{}, momentum)};
  };
  double const radius = 0.42;
  Cloud cloud = closed_curve(edge, [&](auto const& s) { return at(radius, s); });
  for (int k = 0; k < seeds; ++k)
    cloud.push_back(at(radius * std::sqrt((k + 0.5) / seeds), k * M_PI * (3 - std::sqrt(5.0))));
  return cloud;
}
double area_of(Cloud const& cloud) { return shadows(pendulum, std::span(cloud).first(edge)); }

// 3. The plane of angle and momentum has two lines that no state crosses.
book::Plot plane() {
  std::vector<double> angle, above, below;
  for (double q = -3.3; q < 3.3; q += 0.02)
    angle.push_back(q), above.push_back(2 * std::abs(std::cos(q / 2))), below.push_back(-above.back());
  auto plot = book::Plot("angle, radians", "momentum").size(700, 450).x_range(-3.3, 3.3).y_range(-2.2, 2.2);
  plot.curve(angle, above, "between swinging and going over", {.colour = 6, .width = 1, .dashed = true});
  plot.curve(angle, below, "", {.colour = 6, .width = 1, .dashed = true});
  return plot;
}
// The cloud at a time: its seeds, and its rim closed.
void draw(book::Plot& plot, Cloud const& cloud, double time, int colour) {
  std::vector<double> q, p;
  for (auto const& v : cloud)
    q.push_back(log(value_of(v.configuration)).coordinates[0]), p.push_back(v.velocity.coordinates[0].value);
  plot.dots(std::span(q).subspan(edge), std::span(p).subspan(edge), "", {.colour = colour, .radius = 1.2});
  q[edge] = q[0], p[edge] = p[0];
  plot.curve(std::span(q).first(edge + 1), std::span(p).first(edge + 1), "time " + book::number(time),
             {.colour = colour});
}

// 4. Let time pass, by steps of one kind, and draw the cloud four times. The result is the largest
//    relative change of its area.
template <class Step>
double let_time_pass(book::Plot& plot, Step const& step, double h) {
  double const apart = 1.8;
  Cloud cloud = disc();
  double const area = area_of(cloud);
  double largest = 0;
  for (int epoch = 0; epoch < 4; ++epoch) {
    for (int k = 0; epoch > 0 && k * h < apart - h / 2; ++k)
      for (auto& v : cloud) v = step(v, h);
    draw(plot, cloud, epoch * apart, epoch + 1);
    largest = std::max(largest, std::abs(area_of(cloud) / area - 1));
  }
  return largest;
}

int main(int argc, char** argv) {
  book::Program program(
      argc, argv,
      "a cloud of nearby states changes its shape and preserves its area; under explicit Euler it grows");

  // 5. Time passes once with the flow, and once with explicit Euler at a long step.
  double const h = 0.005;
  auto flow = plane(), euler = plane();
  double const preserved = let_time_pass(
      flow, [](auto const& v, double step) { return runge_kutta(swing, v, step); }, h);
  double const grown = let_time_pass(
      euler, [](auto const& v, double step) { return explicit_euler(swing, v, step); }, 0.2);
  program.picture("flow", flow.svg(),
                  "A cloud of states of a pendulum, at four times. Wide swings take longer, so the cloud "
                  "is sheared and bent; but the flow preserves the area, which is the same all the time.");
  program.picture("euler", euler.svg(),
                  "The same cloud under explicit Euler with steps of 0.2. Its area grows, and "
                  "part of it has crossed the dashed line, which no state ever does: those "
                  "pendulums will go over the top.");
  program.figure("kept", preserved, "largest change of the area, relative");
  program.figure("grown", grown, "the same under explicit Euler");

  // 6. What must be so. Runge-Kutta is of order 4.
  program.claim(book::measured(preserved) < std::pow(h, 4), "the area of the cloud stays as it is");
  program.claim(book::measured(grown) > 0.4, "under explicit Euler it grows by more than two fifths");
  program.headline("area of a cloud preserved to " + book::number(preserved, 2) + "; explicit Euler adds " +
                       book::number(100 * grown, 2) + " %",
                   preserved);
  return program.finish();
}
