// The shadow of a cloud: what it means that a flow is symplectic.
//
// What is shown. Nearby states of a pendulum form a cloud. Its motion bends and stretches it, but its area stays what it
// was; under explicit Euler the cloud grows. A flat body adrift in still water has three coordinates and three momenta, and
// its cloud three shadows, one in the plane of each pair: each of them changes, their sum does not. The sum is the
// integral of the Lagrange one-form round the rim, and that it stays is F^* omega = omega.
// Read first. The section "Letting the ends move" of chapter 2.
//
//   v        state (g, xi) in TG                      L      Lagrangian on TG
//   w        tangent vector to TG at v                theta  Lagrange one-form, p dq
//   rim      closed curve of states, each a dual      omega  Lagrange two-form, dq ^ dp
//            number that carries its tangent          h      step
#include "actio/foundations/groups/motions.hpp"
#include "actio/variational/curves.hpp"
#include "actio/variational/euler_lagrange.hpp"
#include "actio/variational/euler_poincare.hpp"
#include "actio/variational/lagrange_forms.hpp"
#include "book/plot.hpp"

using namespace actio;

// A step of the length h along the motion, at any scalar: with dual numbers the step carries tangent vectors along.
// Explicit Euler: the whole step with the velocity and acceleration of its beginning.
template <class G, class S, class Acceleration>
State<G, S> explicit_euler(Acceleration const& acceleration, State<G, S> const& v, double h) {
  return {exp(S(h) * v.velocity) * v.place, v.velocity + S(h) * acceleration(v)};
}
// The classical Runge-Kutta method, on matrices: with short steps as good as the flow itself.
template <class G, class S, class Acceleration>
State<G, S> runge_kutta(Acceleration const& acceleration, State<G, S> const& v, double h) {
  State<G, S> sum = v, stage = v;
  for (int i = 0; i < 4; ++i) {
    Storage<G, S> const place = v.place.group.hat(stage.velocity.coordinates) * stage.place.value;
    auto const rate = acceleration(stage);
    S const share(h * (i == 0 || i == 3 ? 1 : 2) / 6), next(i == 2 ? h : h / 2);
    sum.place.value += place * share, sum.velocity = sum.velocity + share * rate;
    stage.place.value = v.place.value + place * next, stage.velocity = v.velocity + next * rate;
  }
  return sum;
}
// A closed curve of states, `states(s)` for s from 0 to 2 pi, each with its tangent.
template <class States>
auto closed_curve(int points, States const& states) {
  std::vector<decltype(states(Dual<double>(0)))> rim;
  for (int k = 0; k < points; ++k) {
    Dual<double> s(2 * M_PI * k / points);
    s.part[0] = 2 * M_PI / points;
    rim.push_back(states(s));
  }
  return rim;
}
// The integral of the Lagrange one-form round the rim, the sum of the areas of the shadows: to rounding where it is smooth.
template <class Lagrangian, class Rim>
double shadows(Lagrangian const& L, Rim const& rim) {
  double sum = 0;
  for (auto const& v : rim) sum += lagrange_one_form(L, value_of(v), change_of(v));
  return sum;
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "a cloud of nearby states changes its shape and keeps its area; under explicit Euler it grows");

  // 1. A pendulum on SO(2), length and gravity 1, its angle counted from below. The cloud is a disc in the plane of angle
  //    and momentum: a rim, whose states carry its tangent, and in it a sunflower's seeds, the same on every machine.
  auto const pendulum = [](auto const& v) {
    auto const& xi = v.velocity.coordinates[0];
    return xi * xi / 2.0 + v.place.value(0, 0);  // the cosine of the angle
  };
  auto const swing = [&](auto const& v) { return lagrange_acceleration(pendulum, v); };
  auto const at = [](Dual<double> const& r, Dual<double> const& s) {
    Coordinates<SO<2>, Dual<double>> const angle(r * cos(s)), momentum(r * sin(s) + 1.35);
    return State<SO<2>, Dual<double>>{exp(velocity(SO<2>{}, angle)), velocity(SO<2>{}, momentum)};
  };
  long const edge = 240, seeds = 260;
  double const radius = 0.42;
  auto disc = closed_curve(edge, [&](auto const& s) { return at(radius, s); });
  for (int k = 0; k < seeds; ++k) disc.push_back(at(radius * std::sqrt((k + 0.5) / seeds), k * M_PI * (3 - std::sqrt(5.0))));
  auto const rim = [&](auto const& cloud) { return std::span(cloud).first(edge); };
  double const area = shadows(pendulum, rim(disc)), apart = 1.8;

  // 2. Let time pass, once with the flow and once with explicit Euler at a long step; draw the cloud four times.
  std::vector<double> angle, above, below;
  for (double q = -3.3; q < 3.3; q += 0.02)
    angle.push_back(q), above.push_back(2 * std::abs(std::cos(q / 2))), below.push_back(-above.back());
  double kept = 0, grown = 0;
  for (bool const flow : {true, false}) {
    auto plot = book::Plot("angle, radians", "momentum").size(700, 450).x_range(-3.3, 3.3).y_range(-2.2, 2.2);
    plot.curve(angle, above, "between swinging and going over", {.colour = 6, .width = 1, .dashed = true});
    plot.curve(angle, below, "", {.colour = 6, .width = 1, .dashed = true});
    auto cloud = disc;
    double const h = flow ? 0.005 : 0.2;
    for (int epoch = 0; epoch < 4; ++epoch) {
      for (int step = 0; epoch > 0 && step * h < apart - h / 2; ++step)
        for (auto& v : cloud) v = flow ? runge_kutta(swing, v, h) : explicit_euler(swing, v, h);
      std::vector<double> q, p;
      for (auto const& v : cloud) q.push_back(log(value_of(v.place)).coordinates[0]), p.push_back(v.velocity.coordinates[0].value);
      plot.dots(std::span(q).subspan(edge), std::span(p).subspan(edge), "", {.colour = epoch + 1, .radius = 1.2});
      q[edge] = q[0], p[edge] = p[0];
      plot.curve(std::span(q).first(edge + 1), std::span(p).first(edge + 1), "time " + book::number(epoch * apart), {.colour = epoch + 1});
      double const change = std::abs(shadows(pendulum, rim(cloud)) / area - 1);
      (flow ? kept : grown) = std::max(flow ? kept : grown, change);
    }
    program.picture(flow ? "flow" : "euler", plot.svg(),
                    flow ? "A cloud of states of a pendulum, at four times. Wide swings take longer, so the cloud is sheared and bent; "
                           "but every state keeps the room that it had, and the area is the same all the time."
                         : "The same cloud under explicit Euler with steps of 0.2. It takes up more and more room, and part of it has "
                           "crossed the dashed line, which no state ever does: those pendulums will go over the top.");
  }

  // 3. A flat body in still water, on SE(2): easier to push ahead than aside. It does not matter where it is, so its
  //    acceleration comes from the reduced equation. Its rim is a closed curve through all six dimensions.
  auto const l = [](auto const& xi) {
    auto const& v = xi.coordinates;
    return (0.5 * v[0] * v[0] + v[1] * v[1] + 3.0 * v[2] * v[2]) / 2.0;
  };
  auto const body = left_invariant(l);
  auto const glide = [&](auto const& v) { return Ad(v.place, euler_poincare_acceleration_left(l, body_velocity(v))); };
  auto const adrift = closed_curve(32, [](auto const& s) {
    using S = std::decay_t<decltype(s)>;
    auto const c = cos(s), d = sin(s);
    Coordinates<SE<2>, S> const place(0.15 * c, 0.15 * d, 0.2 * c), speed(0.6 + 0.15 * d, 1.0 + 0.1 * c, 0.3 - 0.1 * d);
    auto const g = exp(velocity(SE<2>{}, place));
    return State<SE<2>, S>{g, Ad(g, velocity(SE<2>{}, speed))};
  });

  // 4. A shadow's area is the integral of its momentum over its coordinate; that of the angle is about the body's centre.
  auto const shadow = [&](auto const& curve, int which) {
    double sum = 0;
    for (auto const& v : curve) {
      auto const mu = legendre(body, value_of(v)).components;
      auto const x = v.place.value(0, 2), y = v.place.value(1, 2);
      double const turn = change_of(v).place.coordinates[0];
      sum += which == 0 ? (mu[0] - x.value * mu[2] + y.value * mu[1]) * turn : which == 1 ? mu[1] * x.part[0] : mu[2] * y.part[0];
    }
    return sum;
  };
  std::vector<double> time, each[4], euler_time, euler_sum;
  double const h = 0.005, long_step = 0.1, duration = 5, sum_before = shadows(body, adrift);
  auto drift = adrift, euler_drift = adrift;
  double body_kept = 0, body_split = 0;
  for (int k = 0; k * h < duration + h / 2; ++k) {
    if (k % 10 == 0) {
      time.push_back(k * h), each[3].push_back(shadows(body, drift));
      for (int which = 0; which < 3; ++which) each[which].push_back(shadow(drift, which));
      body_kept = std::max(body_kept, std::abs(each[3].back() / sum_before - 1));
      body_split = std::max(body_split, std::abs(each[0].back() + each[1].back() + each[2].back() - each[3].back()));
    }
    for (auto& v : drift) v = runge_kutta(glide, v, h);
  }
  for (int k = 0; k * long_step < duration + h / 2; ++k) {
    euler_time.push_back(k * long_step), euler_sum.push_back(shadows(body, euler_drift));
    for (auto& v : euler_drift) v = explicit_euler(glide, v, long_step);
  }
  auto plot = book::Plot("time", "area of the shadow");
  char const* const planes[] = {"angle and its momentum", "x and its momentum", "y and its momentum", "sum of the three"};
  for (int i = 0; i < 4; ++i) plot.curve(time, each[i], planes[i], {.colour = i + 1, .width = i == 3 ? 2.4 : 1.6});
  plot.curve(euler_time, euler_sum, "sum under explicit Euler", {.colour = 4, .dashed = true});
  program.picture("shadows", plot.svg(),
                  "A cloud of a flat body adrift in still water, in three coordinates and three momenta, has a shadow in each of three "
                  "planes. Area goes from one shadow to the others; the sum stays.");
  program.figure("kept", kept, "pendulum: largest change of the area, relative");
  program.figure("grown", grown, "the same under explicit Euler");
  program.figure("body_kept", body_kept, "flat body: largest change of the sum of the shadows, relative");
  program.figure("body_split", body_split, "integral of the one-form less the sum of the shadows");

  // 5. What must be so. Runge-Kutta is of order 4, and the flat body's fastest rate is about 5 per unit of time.
  auto const [least, most] = std::ranges::minmax(each[2]);
  program.claim(kept < std::pow(h, 4), "the area of the pendulum's cloud stays as it is");
  program.claim(grown > 0.4, "under explicit Euler it grows by more than two fifths");
  program.claim(body_kept < std::pow(5 * h, 4), "the sum of the shadows stays as it is");
  program.claim(body_split < std::pow(5 * h, 4), "the integral of the one-form is the sum of the shadows");
  program.claim(most - least > std::abs(sum_before), "a single shadow changes by more than the sum");
  program.headline("area of a cloud kept to " + book::number(kept, 2) + "; explicit Euler adds " + book::number(100 * grown, 2) + " %",
                   kept);
  return program.finish();
}
