// Which shapes of Dimorphos keep the moon upright after the impact of DART: a map of growth rates over a/b
// and b/c, half axes a > b > c, of 50 by 50 moons over a year.
//
// What is shown. Each moon starts upright and locked, and is slowed by the impact, so that it librates in the
// plane of the orbit. A tangent vector tells whether tilts out of it grow. Regular motions have it grow as
// the time does; where it is a thousand times as long as that, the motion counts as unstable. The resonances
// come from small oscillations about the locked rotation, which are compared with the tangent map.
#include <numbers>

#include "actio/linear_algebra/eigenvalues.hpp"
#include "actio/two_bodies/side_by_side.hpp"
#include "benchmark.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"

using namespace actio;
using namespace actio::bodies;

constexpr double pi = std::numbers::pi, day = 86400, distance = 1189, density = 2789.5398771860564,
                 n = 2 * pi / (11.921473 * 3600), step = 2400;
Element<SU2, double> const upright{SU2{}, Eigen::Vector4d(1, 0, 0, 0)};

/// The ratios a/b and b/c of a moon.
struct Shape {
  double ab, bc;
};
std::array<double, 3> half_axes(Shape const& s) {
  double const c = std::cbrt(88.5 * 87 * 58 / (s.bc * s.bc * s.ab)), b = s.bc * c;
  return {s.ab * b, b, c};
}
ExtendedBody ellipsoid(std::array<double, 3> const& a) {
  return ellipsoid_body(4 * pi / 3 * density * a[0] * a[1] * a[2], a, 4);
}

// 1. Didymos after the impact, as in section 10D.3.
TwoBodies after_the_impact(Shape const& s) {
  auto const primary = ellipsoid({394, 394, 290}), moon = ellipsoid(half_axes(s));
  return {primary,
          moon,
          state_of_velocities(primary, moon, {distance, 0, 0}, {0, n * distance - 2.63e-3, 0}, upright,
                              {0, 0, 2 * pi / 8136}, upright, {0, 0, n}),
          {.order = 4, .step = step}};
}
/// Decades by which tangent vectors grow, beyond what n times the time accounts for.
std::vector<double> growth(std::vector<Shape> const& shapes, double days) {
  std::vector<TwoBodies> pairs;
  for (auto const& s : shapes) pairs.push_back(after_the_impact(s));
  long const steps = std::lround(days * day / step);
  auto decades = lyapunov_exponents(pairs, steps);
  for (double& x : decades) x = x * days * day / std::numbers::ln10 - std::log10(n * days * day);
  return decades;
}
bool is_unstable(double decades) { return !(decades < 3); }

// 2. Small oscillations of a locked moon, moments A < B < C, on a circle about a point, in units of the rate
// of the orbit: libration in the plane, and two modes of the tilt, AB w^4 - (...) w^2 + 4 (C-A)(C-B) = 0.
struct Frequencies {
  double libration, slow, fast;
};
Frequencies frequencies(Shape const& s) {
  auto const [a, b, c] = half_axes(s);
  double const A = b * b + c * c, B = a * a + c * c, C = a * a + b * b,
               sum = (A + B - C) * (A + B - C) + 4 * A * (C - A) + B * (C - B),
               root = std::sqrt(sum * sum - 16 * A * B * (C - A) * (C - B));
  return {std::sqrt(3 * (B - A) / C), std::sqrt((sum - root) / (2 * A * B)),
          std::sqrt((sum + root) / (2 * A * B))};
}
/// How far these are from the nearest frequencies that the tangent map of an eighth of a revolution has, in
/// the frame that turns along; relative. The primary is a ball at rest, so heavy and so far away that the
/// moon does not move it, nor the orbit: the frequencies depend on neither mass nor distance.
double distance_from_tangent_map(Shape const& s) {
  auto const ball = sphere_body(1e18, 394, 2), moon = ellipsoid(half_axes(s));
  auto const& I = moon.inertia;
  double const G = 6.67430e-11, mu = G * (ball.mass() + moon.mass()), r = 1e5, least = std::min(I[0], I[2]),
               trace = I[0] + I[1] + I[2],
               w = std::sqrt(mu / (r * r * r) * (1 + 1.5 / (r * r) * (trace - 3 * least) / moon.mass()));
  constexpr long steps = 5;
  TwoBodies const pair(
      ball, moon,
      state_of_velocities(ball, moon, {r, 0, 0}, {0, w * r, 0}, upright, {0, 0, 0}, upright, {0, 0, w}),
      {.order = 2, .step = 2 * pi / w / 8 / steps, .G = G});
  Eigen::Matrix<double, 18, 18> back = Eigen::Matrix<double, 18, 18>::Identity();
  double const turn = std::sqrt(0.5);
  for (int at : {0, 3, 6, 9}) back.block<2, 2>(at, at) << turn, turn, -turn, turn;
  auto const unit = pair.tangent_units();
  Eigen::MatrixXd const map =
      unit.cwiseInverse().asDiagonal() * back * pair.tangent_map(steps) * unit.asDiagonal();
  double worst = 0;
  auto const known = frequencies(s);
  for (double const f : {known.libration, known.slow, known.fast}) {
    double nearest = HUGE_VAL;
    for (double const x : real_parts_of_eigenvalues(map))
      nearest = std::min(nearest, std::abs(std::acos(std::clamp(x, -1.0, 1.0)) / (pi / 4) - f) / f);
    worst = std::max(worst, nearest);
  }
  return worst;
}
/// Resonances of the tilt: twice its slow mode has the frequency of the libration, or of the orbit; or both
/// modes together have that of libration and orbit together. Positive beyond the resonance.
using Resonance = double (*)(Frequencies const&);
constexpr Resonance with_libration = [](Frequencies const& f) { return 2 * f.slow - f.libration; };
constexpr Resonance with_orbit = [](Frequencies const& f) { return 2 * f.slow - 1; };
constexpr Resonance with_both = [](Frequencies const& f) { return f.slow + f.fast - f.libration - 1; };
/// The ratio b/c at which a moon with this a/b is there, up to 2.
double where(Resonance resonance, double ab) {
  double low = 1, high = 2;
  for (int i = 0; i < 50; ++i) {
    double const middle = (low + high) / 2;
    (resonance(frequencies({ab, middle})) < 0 ? low : high) = middle;
  }
  return low;
}

void compare_frequencies(book::Program& program) {
  double off = 0;
  for (Shape const s : {Shape{1.1, 1.14}, {1.2, 1.2}, {1.3, 1.3}})
    off = std::max(off, distance_from_tangent_map(s));
  program.figure("frequencies", off,
                 "largest relative distance of a frequency from those of the tangent map");
  // The closed form leaves out that the moon moves the primary, by the ratio 5e-9 of the masses, and the
  // orbit, by the share 3e-7 of its inertia in that of the orbit over the distance of the resonance w = 1, a
  // quarter. Steps are a fortieth of a revolution.
  program.claim(book::measured(off) < 1e-5, "the closed form has the frequencies of the tangent map");
}

// 3. The map.
double draw_map(benchmark::Benchmark& program) {  // per cent of shapes that are unstable
  int const size = program.length(50, 12);
  double const days = program.length(365.0, 60.0), from = 1.005, to = 1.5;
  std::vector<Shape> shapes;
  for (int i = 0; i < size * size; ++i)
    shapes.push_back(
        {from + (to - from) * (i % size + 0.5) / size, from + (to - from) * (i / size + 0.5) / size});
  std::vector<double> decades;
  double const seconds = book::seconds_of([&] { decades = growth(shapes, days); });
  std::vector<double> x[2], y[2];
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (is_unstable(decades[i])) {
      bool const soon = decades[i] > 10 * days / 60;
      x[soon].push_back(shapes[i].ab), y[soon].push_back(shapes[i].bc);
    }
  auto plot = book::Plot("a/b", "b/c").size(560, 520).x_range(1, 1.5).y_range(1, 1.5);
  double const radius = 0.38 * 440 / size;
  plot.dots(x[0], y[0], "unstable", {.colour = 5, .radius = radius});
  plot.dots(x[1], y[1], "ten decades in sixty days", {.colour = 2, .radius = radius});
  std::vector<double> ab, lines[3];
  for (double at = 1.005; at < 1.5; at += 0.005) {
    ab.push_back(at);
    for (int k = 0; auto const resonance : {with_libration, with_both, with_orbit})
      lines[k++].push_back(where(resonance, at));
  }
  // Where the libration has half and all of the rate of the orbit.
  double const half = std::sqrt(3.25 / 2.75), whole = std::sqrt(2);
  plot.curve(ab, lines[0], "2 slow = libration", {.colour = 1});
  plot.curve(ab, lines[1], "slow + fast = libration + orbit", {.colour = 6});
  plot.curve(ab, lines[2], "2 slow = orbit", {.colour = 3});
  plot.curve(std::vector{half, half}, std::vector{1.0, 1.5}, "2 libration = orbit",
             {.colour = 4, .dashed = true});
  plot.curve(std::vector{whole, whole}, std::vector{1.0, 1.5}, "libration = orbit",
             {.colour = 3, .dashed = true});
  program.picture("map", plot.svg(),
                  "Shapes of Dimorphos with which a small tilt grows after the impact, and resonances of the "
                  "frequencies of a locked moon.");
  double const share = double(x[0].size() + x[1].size()) / double(shapes.size());
  program.figure("days", days, book::number(days, 3), "length of each motion, days");
  program.figure("moons", double(shapes.size()), std::to_string(shapes.size()), "motions of the map");
  program.figure("seconds", seconds, book::number(seconds, 2), "time for the map on one core, s");
  program.figure("share", 100 * share, book::number(100 * share, 2), "unstable shapes, per cent");
  program.claim_of_time(seconds < 300, "the map takes less than five minutes on one core");
  return 100 * share;
}

// 4. Along the resonance of the tilt with the libration, and halfway from there to b = c as a control.
void follow_resonance(book::Program& program) {
  std::vector<Shape> on, below;
  for (double at = 1.12; at < 1.305; at += 0.02) {
    double const bc = where(with_libration, at);
    on.push_back({at, bc}), below.push_back({at, (1 + bc) / 2});
  }
  auto const of_on = growth(on, 120), of_below = growth(below, 120);
  long const hit = std::ranges::count_if(of_on, is_unstable),
             missed = std::ranges::count_if(of_below, is_unstable);
  program.figure("on_resonance", double(hit), std::to_string(hit),
                 "of " + std::to_string(on.size()) + " shapes on the resonance, unstable ones");
  program.claim(hit == long(on.size()), "where the tilt has half the frequency of the libration, it grows");
  program.claim(missed == 0, "halfway from there to b = c it does not");
  double const least = *std::ranges::min_element(of_on), most = *std::ranges::max_element(of_below);
  program.figure("least_on", least, book::number(least, 2),
                 "least growth on the resonance in 120 days, decades");
  program.figure("most_off", most, book::number(most, 1), "largest growth halfway to b = c, decades");
}

// 5. The elongation that the precession asks for, with all b/c.
void vary_observed(book::Program& program) {
  std::vector<Shape> observed;
  for (double bc = 1.01; bc < 1.5; bc += 0.01) observed.push_back({1.28, bc});
  auto const of_observed = growth(observed, 120);
  std::size_t first = 0;
  while (first < observed.size() && !is_unstable(of_observed[first])) ++first;
  double const edge = observed[std::min(first, observed.size() - 1)].bc;
  program.figure("edge", edge, book::number(edge, 3), "least b/c with which a tilt grows where a/b = 1.28");
}

int main(int argc, char** argv) {
  benchmark::Benchmark program(argc, argv,
                               "shapes of Dimorphos with which it stays upright after the impact");
  compare_frequencies(program);
  double const share = draw_map(program);
  follow_resonance(program);
  vary_observed(program);
  program.headline(
      "with " + book::number(share, 2) + " per cent of the shapes of the map the moon does not stay upright",
      share);
  return program.finish();
}
