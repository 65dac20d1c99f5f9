// What a step of two bodies costs: kicks by the mutual potential of orders 2 and 4 with exact rotors,
// straight and Kepler's orbits, against the classical Runge-Kutta method on the same forces; and 64 pairs
// side by side in SIMD lanes, against each by itself.
//
// Nanoseconds of processor time for a stage, which is a kick and a drift; contestants in turns, a tenth of
// the rounds below. The bodies are those of the binary asteroid Didymos.
#include <Eigen/Geometry>

#include <numbers>

#include "actio/fast_body/machine.hpp"
#include "actio/numbers/registers.hpp"
#include "actio/two_bodies/side_by_side.hpp"
#include "benchmark.hpp"
#include "timing.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::Vector3d;

// Runge-Kutta by hand: position, velocity, angular velocities and quaternions.
struct Twenty {
  Three<double> x, v, w1, w2;
  Four<double> q1, q2;
};
struct Equations {
  SecondOrderForce<> force;
  Three<double> I1, I2;
  double reduced, mu;

  static Three<double> spin(Three<double> const& I, Three<double> const& w, Three<double> const& t) {
    return {((I[1] - I[2]) * w[1] * w[2] + t[0]) / I[0], ((I[2] - I[0]) * w[2] * w[0] + t[1]) / I[1],
            ((I[0] - I[1]) * w[0] * w[1] + t[2]) / I[2]};
  }
  static Four<double> turn(Four<double> const& q, Three<double> const& w) {
    return compose(q, Four<double>{0, w[0] / 2, w[1] / 2, w[2] / 2});
  }
  Twenty rate(Twenty const& s) const {
    auto const kick = force(s.x, s.q1, s.q2);
    double const pull = mu * kick.inverse * kick.inverse * kick.inverse;
    Three<double> a;
    for (int i = 0; i < 3; ++i) a[i] = kick.force[i] / reduced - pull * s.x[i];
    return {s.v,
            a,
            spin(I1, s.w1, kick.torque_1),
            spin(I2, s.w2, kick.torque_2),
            turn(s.q1, s.w1),
            turn(s.q2, s.w2)};
  }
};
template <std::size_t N>
void add(std::array<double, N>& x, double h, std::array<double, N> const& k) {
  for (std::size_t i = 0; i < N; ++i) x[i] += h * k[i];
}
Twenty moved(Twenty s, double h, Twenty const& k) {
  add(s.x, h, k.x), add(s.v, h, k.v), add(s.w1, h, k.w1), add(s.w2, h, k.w2), add(s.q1, h, k.q1),
      add(s.q2, h, k.q2);
  return s;
}
Twenty runge_kutta(Equations const& f, Twenty const& s, double h) {
  Twenty const k = f.rate(s), l = f.rate(moved(s, h / 2, k)), m = f.rate(moved(s, h / 2, l)),
               n = f.rate(moved(s, h, m));
  return moved(moved(moved(moved(s, h / 6, k), h / 3, l), h / 3, m), h / 6, n);
}

/// How many times as fast many pairs are side by side as each by itself: of the first of these numbers of
/// steps, or less in a short run.
double gain_side_by_side(benchmark::Benchmark const& program, std::vector<TwoBodies> pairs) {
  auto together = pairs;
  long const steps = program.length(200, 50);
  std::vector<benchmark::Contestant> const contestants{
      {"by itself",
       [&] {
         for (auto& pair : pairs) pair.step(steps);
       },
       1},
      {"side by side", [&] { step_side_by_side(together, steps); }, 1}};
  auto const times = benchmark::in_turns(program.rounds(31), contestants);
  return benchmark::ratio_of_best(times[0], times[1]);
}

int main(int argc, char** argv) {
  benchmark::Benchmark program(argc, argv,
                               "two bodies that attract each other: nanoseconds for a kick and a drift");
  std::string const name = name_of(best_machine());
  program.say("This machine: ", name, ".");
  constexpr double pi = std::numbers::pi;
  auto const body = [](double density, std::array<double, 3> const& a) {
    return ellipsoid_body(4 * pi / 3 * density * a[0] * a[1] * a[2], a, 4);
  };
  auto const primary = body(2170, {400, 395, 340}), moon = body(2400, {85, 73, 63});
  // The same moon with a moment that an ellipsoid has not: a body of any shape.
  ExtendedBody odd = moon;
  odd.moments.set(2, 1, 0, 0.01 * odd.moments(2, 0, 0) * 85);
  double const r = 1195, G = 6.6743e-11, n = std::sqrt(G * (primary.mass() + moon.mass()) / (r * r * r));
  auto const unit = [](double angle, Vector3d const& axis) {
    Eigen::Quaterniond const q(Eigen::AngleAxisd(angle, axis));
    return Element<SU2, double>{SU2{}, Eigen::Vector4d(q.w(), q.x(), q.y(), q.z())};
  };
  auto const tilt = unit(pi / 60, Vector3d::UnitY()), roll = unit(pi / 18, Vector3d::UnitX());
  auto const start =
      state_of_velocities(primary, moon, {r, 0, 0}, {0, 0.1735, 0}, tilt, {0, 0, 7.7e-4}, roll, {0, 0, n});
  auto const pair = [&](ExtendedBody const& second, int order, PairMethod method, double step) {
    return TwoBodies(primary, second, start,
                     {.order = order, .step = step, .method = std::move(method), .G = G});
  };
  struct Entry {
    std::string name, figure;
    TwoBodies pair;
    double stages, most;  ///< stages of a step, and the most that one may take, ns
  };
  std::vector<Entry> entries{
      {"order 2, straight orbits", "straight_2", pair(moon, 2, pair_splitting(), 72), 1, 160},
      {"order 2, Moser-Veselov rotors", "moser_veselov", pair(moon, 2, moser_veselov_pair(), 72), 1, 0},
      {"order 2, Kepler's orbits", "kepler_2", pair(moon, 2, kepler_splitting(), 1440), 7, 350},
      {"order 4, Kepler's orbits, ellipsoids", "kepler_4", pair(moon, 4, kepler_splitting(), 1440), 7, 550},
      {"order 4, Kepler's orbits, any shape", "kepler_4_any", pair(odd, 4, kepler_splitting(), 1440), 7,
       750}};
  long const steps = program.length(2000, 500);
  Equations const equations{{primary, moon, G},
                            primary.inertia,
                            moon.inertia,
                            entries[0].pair.reduced_mass(),
                            G * (primary.mass() + moon.mass())};
  Twenty y{{r, 0, 0}, {0, 0.1735, 0}, {0, 0, 7.7e-4}, {0, 0, n}, {1, 0, 0, 0}, {1, 0, 0, 0}};
  std::vector<benchmark::Contestant> contestants;
  for (auto& e : entries)
    contestants.push_back({e.name, [&] { e.pair.step(steps); }, static_cast<double>(steps) * e.stages});
  contestants.push_back({"Runge-Kutta, order 2 of the potential, a step",
                         [&] {
                           for (long k = 0; k < steps; ++k) y = runge_kutta(equations, y, 10);
                         },
                         static_cast<double>(steps)});
  auto const times = benchmark::in_turns(program.rounds(31), contestants);
  std::vector<book::Program::Row> rows;
  double sum = y.x[0];
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    double const taken = 1e9 * benchmark::best_tenth(times[i]);
    rows.push_back({contestants[i].name, book::number(taken)});
    if (i == entries.size()) continue;
    auto const& e = entries[i];
    sum += e.pair.state().position.sum();
    program.figure(e.figure, taken, "ns for a kick and a drift, " + e.name);
    if (e.most > 0 && best_machine() == Machine::avx2)
      program.claim_of_time(taken <= e.most,
                            e.name + ": a kick and a drift take at most " + book::number(e.most) + " ns");
  }
  program.table("two_bodies", {"contestant", "ns"}, rows,
                "Two bodies: nanoseconds for a kick and a drift, or for a step of Runge and Kutta.");
  double const ratio = benchmark::ratio_of_best(times[0], times.back());
  program.figure("ratio", ratio,
                 "a kick and a drift with exact rotors, in Runge-Kutta steps on the same forces");
  // Eight lanes are at most eight times as fast, and four four times.
  double const least = best_registers() == Registers::avx512 ? 4 : 3;
  for (auto const& [order, kepler, figure, says] :
       {std::tuple{2, false, "side_straight_2", "64 pairs side by side, order 2, straight orbits"},
        {2, true, "side_kepler_2", "64 pairs side by side, order 2, Kepler's orbits"},
        {4, false, "side_straight_4", "64 pairs side by side, order 4, straight orbits"},
        {4, true, "side_kepler_4", "64 pairs side by side, order 4, Kepler's orbits"}}) {
    std::vector<TwoBodies> pairs;
    for (int k = 0; k < 64; ++k)
      pairs.emplace_back(primary, moon,
                         state_of_velocities(primary, moon, {r + k, 0, 0}, {0, 0.1735, 0}, tilt,
                                             {0, 0, 7.7e-4}, roll, {0, 0, n}),
                         TwoBodyOptions{.order = order,
                                        .step = kepler ? 1440.0 : 72.0,
                                        .method = kepler ? kepler_splitting() : pair_splitting(),
                                        .G = G});
    double const gain = gain_side_by_side(program, std::move(pairs));
    program.figure(figure, gain, book::number(gain, 2), std::string(says) + ": times as fast as one by one");
    if (best_registers() != Registers::plain)
      program.claim_of_time(gain >= least,
                            std::string(says) + ": at least " + book::number(least) + " times");
  }
  program.figure("sum", sum, "sum of the last states, so that nothing is left out");
  program.headline("a kick and a drift of two bodies take " +
                       book::number(1e9 * benchmark::best_tenth(times[0])) + " ns, " + book::number(ratio) +
                       " Runge-Kutta steps",
                   ratio);
  return program.finish();
}
