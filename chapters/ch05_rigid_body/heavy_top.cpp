// A heavy top: a toy whose axis draws loops, cusps and waves, and the spin at which it goes to sleep.
//
// What is shown. A body held at a point under gravity has one symmetry, about the vertical. The scheme steps
// its momentum and the vertical in the body frame: half of the impulse of gravity, a step of Moser and
// Veselov's, the other half. Momentum about the vertical, length of the vertical and, for a symmetric top,
// momentum about its axis are conserved to rounding at every step length and every order.
// Read first. The page 5C, The heavy top.
//
//   Omega, Pi   body velocity, rad/s, and body momentum, J s     p     weight times centre of mass, J
//   Gamma       the vertical in the body frame
//   u           height of the axis, cosine of its angle with the vertical
//
// Compiled at -O2: it takes many steps.
#include "actio/rigid_body/heavy_top.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"
#include "book/sphere.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;

// A toy: a thin disc of 100 g, 4 cm in radius, 3 cm above the tip. The disc is flat, so that one of its
// Lambda is zero.
double const disc = 0.1 * 0.04 * 0.04 / 4;
auto const toy = held_at_a_point<double>(0.1, inertia_from_moments(disc, disc, 2 * disc),
                                         Vector3d(0, 0, 0.03), Vector3d(0, 0, -9.81));
// Leaning, spinning about its axis in the body frame, and going round the vertical at a rate of its own:
// attitude and state.
auto let_go(double lean, double spin, double round) {
  auto const g = exp(velocity(SO<3>{}, Vector3d(lean, 0, 0)));
  Vector3d const omega = round * g.value.transpose() * Vector3d::UnitZ();
  return std::pair(g, release(toy, g, velocity(SO<3>{}, Vector3d(omega[0], omega[1], spin))));
}
// Its spin, rad/s, the step, s, the rate at which it goes round, rad/s, and a degree.
double const fast = 90, h = 2e-4, rate = toy.lever()[2] / (toy.inertia.moments[2] * fast),
             degree = M_PI / 180;

// 1. The toy spins at 90 rad/s and is let go leaning by 35, 65 and 100 degrees: going round backwards, not at
// all, and forwards. Gives how far the lowest point of the cusps is from the closed form.
double loops_cusps_and_waves(book::Program& program) {
  HeavyTopScheme<> const scheme(toy, h, 4);
  auto sphere = book::Sphere(-60, 28).axes({"", "", "up"});
  double lowest = 1, before = 1, now = 1;
  for (auto const& [lean, round, name] :
       {std::tuple(35, -1.5 * rate, "pushed back: loops"), std::tuple(65, 0.0, "let go: cusps"),
        std::tuple(100, 0.6 * rate, "pushed on: waves")}) {
    auto [g, state] = let_go(lean * degree, fast, round);
    std::vector<Vector3d> trace;
    for (int k = 0; k < 7500; ++k) {
      if (k % 10 == 0) trace.push_back(g.value.col(2));
      scheme.advance(state, g);
      double const u = state.vector[2];
      // A low point of the cusps: the end of a parabola through three heights.
      if (round == 0.0 && now < before && now < u)
        lowest = now - std::pow(u - before, 2) / (8 * (u - 2 * now + before));
      before = now, now = u;
    }
    sphere.curve(trace, name);
  }
  program.picture("loops", sphere.svg(),
                  "Where the axis of the toy points in a second and a half. All three spin at 90 rad/s; "
                  "what differs is how they are let go.");
  // Let go, the axis falls from height u0 to the root of b (1 - u^2) = a^2 (u0 - u), with a = Pi_3/I_1 and
  // b = 2p/I_1.
  double const a = toy.inertia.moments[2] * fast / toy.inertia.moments[0],
               b = 2 * toy.lever()[2] / toy.inertia.moments[0], u0 = std::cos(65 * degree);
  double const root = 2 * (a * a * u0 - b) / (a * a + std::sqrt(std::pow(a, 4) - 4 * b * (a * a * u0 - b)));
  program.figure("fall", std::acos(root) / degree, book::number(std::acos(root) / degree, 9) + "°",
                 "how far it leans at its lowest, closed form");
  program.figure("fall_error", std::abs(lowest - root),
                 "height of the lowest point of the scheme against it");
  return lowest - root;
}

// 2. Upright, a little beside it: above the spin sqrt(4 p I_1)/I_3 it sleeps, below it falls over and comes
// back. Gives the largest lean of either, degrees.
std::array<double, 2> asleep_and_awake(book::Program& program) {
  double const critical = std::sqrt(4 * toy.lever()[2] * toy.inertia.moments[0]) / toy.inertia.moments[2];
  program.figure("critical", critical, book::number(critical, 4) + " rad/s",
                 "spin above which the upright toy sleeps");
  auto sleep = book::Plot("time, s", "lean, degrees").size(660, 320);
  std::array<double, 2> most{};
  HeavyTopScheme<> const scheme(toy, h, 4);
  for (int const awake : {0, 1}) {
    auto upright = let_go(degree, (awake ? 0.9 : 1.1) * critical, 0).second;
    std::vector<double> time, lean;
    for (int k = 0; k < 20000; ++k) {
      scheme.advance(upright);
      double const angle =
          std::atan2(std::hypot(upright.vector[0], upright.vector[1]), upright.vector[2]) / degree;
      most[awake] = std::max(most[awake], angle);
      if (k % 25 == 0) time.push_back(k * h), lean.push_back(angle);
    }
    sleep.curve(time, lean, awake ? "nine tenths of the critical spin" : "eleven tenths");
  }
  program.picture("sleep", sleep.svg(), "Two tops let go one degree beside the vertical.");
  return most;
}

// 3. What is conserved over 200000 steps of 2 ms: the waves, at order two, with steps ten times as long.
std::array<double, 4> drifts_over_many_steps(book::Program& program) {
  HeavyTopScheme<> const coarse(toy, 10 * h);
  auto const start = let_go(100 * degree, fast, 0.6 * rate).second;
  double const size = start.momentum.components.norm();
  std::array<double, 4> drifts{};
  auto state = start;
  for (int k = 0; k < 200000; ++k) {
    coarse.advance(state);
    double const changes[] = {
        (state.momentum.components.dot(state.vector) - start.momentum.components.dot(start.vector)) / size,
        state.vector.norm() - 1, (state.momentum.components[2] - start.momentum.components[2]) / size,
        toy.energy(state) / toy.energy(start) - 1};
    for (int i = 0; i < 4; ++i) drifts[i] = std::max(drifts[i], std::abs(changes[i]));
  }
  auto const shown = [&](char const* name, int i) {
    return book::Program::Row{name, book::number(drifts[i], 2)};
  };
  std::vector<book::Program::Row> const rows = {shown("momentum about the vertical", 0),
                                                shown("length of the vertical", 1),
                                                shown("momentum about the axis", 2), shown("energy", 3)};
  program.table("kept", {"quantity", "largest change, relative"}, rows,
                "The toy with waves over 200 000 steps of 2 ms, order 2. No theorem conserves the energy.");
  return drifts;
}

// 4. What must be so. Three roundings in each of 200000 steps walk at random: a hundredfold of room, as
//    everywhere.
void what_must_be_so(book::Program& program, double gap, std::array<double, 2> const& most,
                     std::array<double, 4> const& drifts) {
  double const walk = 100 * 0x1p-52 * std::sqrt(200000.0),
               casimirs_and_axis = std::max({drifts[0], drifts[1], drifts[2]});
  program.claim(book::measured(std::abs(gap)) < 1e-6, "the axis falls as far as the closed form says");
  program.claim(book::measured(most[0]) < 4 && book::measured(most[1]) > 20,
                "above the critical spin the top sleeps, below it wakes");
  program.claim(book::measured(casimirs_and_axis) < walk && book::measured(drifts[3]) < 0.01,
                "both Casimirs and the momentum about the axis are conserved to rounding, "
                "and the energy does not run away");
  program.headline("both Casimirs and the momentum about the axis to " + book::number(casimirs_and_axis, 2),
                   casimirs_and_axis);
}

int main(int argc, char** argv) {
  book::Program program(argc, argv,
                        "a heavy top: loops and cusps on a sphere, and the spin that lets it sleep");
  double const gap = loops_cusps_and_waves(program);
  auto const most = asleep_and_awake(program);
  auto const drifts = drifts_over_many_steps(program);
  what_must_be_so(program, gap, most, drifts);
  return program.finish();
}
