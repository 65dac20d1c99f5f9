// What a step of a rigid body costs when there are many, and when a torque acts: exact free steps in SIMD
// lanes, kicks and exact drifts, against the classical Runge-Kutta method on the same bodies.
//
// Nanoseconds of processor time for a step of one body; contestants in turns, a tenth of the rounds below. A
// call of a batch is 200 steps or more, so that the bodies are in the first cache, as far as a row of four is
// concerned.
#include <Eigen/Core>

#include <memory>
#include <utility>

#include "actio/fast_body/space/torqued_batch.hpp"
#include "actio/reduction/composition.hpp"
#include "benchmark.hpp"
#include "timing.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::Vector3d;

// Runge-Kutta by hand, momentum and quaternion in seven named numbers: no loop, no index, nothing to be
// unrolled.
struct Seven {
  double x, y, z, a, b, c, d;
};
inline Seven moved(Seven const& s, double h, Seven const& k) {
  return {s.x + h * k.x, s.y + h * k.y, s.z + h * k.z, s.a + h * k.a,
          s.b + h * k.b, s.c + h * k.c, s.d + h * k.d};
}
struct Free {
  Three<double> J;  // inverse moments

  Seven rate(Seven const& s) const {
    double const u = s.x * J[0], v = s.y * J[1], w = s.z * J[2];
    return {s.y * w - s.z * v,
            s.z * u - s.x * w,
            s.x * v - s.y * u,
            -0.5 * (s.b * u + s.c * v + s.d * w),
            0.5 * (s.a * u + s.c * w - s.d * v),
            0.5 * (s.a * v + s.d * u - s.b * w),
            0.5 * (s.a * w + s.b * v - s.c * u)};
  }
};
struct UnderGravity {
  Free free;
  Three<double> strength, n;  // 3 mu/r^3 (I_k - I_j), and the direction to the centre

  Seven rate(Seven const& s) const {
    Seven change = free.rate(s);
    Three<double> const t = GravityGradient::of_direction<double>(strength, {s.a, s.b, s.c, s.d}, n);
    change.x += t[0], change.y += t[1], change.z += t[2];
    return change;
  }
};
template <class Equations>
Seven runge_kutta(Equations const& f, Seven const& s, double h) {
  Seven const k = f.rate(s), l = f.rate(moved(s, h / 2, k)), m = f.rate(moved(s, h / 2, l)),
              n = f.rate(moved(s, h, m));
  double const g = h / 6;
  return {s.x + g * (k.x + 2 * (l.x + m.x) + n.x), s.y + g * (k.y + 2 * (l.y + m.y) + n.y),
          s.z + g * (k.z + 2 * (l.z + m.z) + n.z), s.a + g * (k.a + 2 * (l.a + m.a) + n.a),
          s.b + g * (k.b + 2 * (l.b + m.b) + n.b), s.c + g * (k.c + 2 * (l.c + m.c) + n.c),
          s.d + g * (k.d + 2 * (l.d + m.d) + n.d)};
}

// Bodies of all shapes, which turn by 0.1 rad in a step of length 1.
struct Cast {
  std::vector<Inertia<3>> inertias;
  std::vector<Momentum<SO<3>, double>> momenta;
  std::vector<Element<SU2, double>> attitudes;
  std::vector<GravityGradient> torques, orbits;

  explicit Cast(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      double const s = 0.37 * static_cast<double>(i);
      auto const inertia = inertia_from_moments(0.6 + 0.1 * std::sin(s), 0.8 + 0.05 * std::cos(s), 1.0);
      Vector3d const spin(std::cos(s), 0.5 + 0.3 * std::sin(3 * s), -0.7);
      inertias.push_back(inertia);
      momenta.push_back(body_momentum(inertia, velocity(SO<3>{}, (0.1 * spin.normalized()).eval())));
      attitudes.push_back({SU2{}, Eigen::Vector4d(1, 0.3 * std::sin(s), 0.2, 0.7).normalized()});
      torques.push_back(gravity_gradient(inertia, 1e-3, {1, std::sin(s), 0.4}));
      orbits.push_back(gravity_gradient_in_orbit(inertia, 0.02, {1, std::sin(s), 0.4}, {0, 0, 1}));
    }
  }
};

using Row = book::Program::Row;
double nanoseconds(std::vector<double> const& seconds) { return 1e9 * benchmark::best_tenth(seconds); }
std::string shown(std::vector<double> const& seconds) { return book::number(nanoseconds(seconds)); }

double sum = 0;  // of what was computed, so that nothing is left out

/// Momentum with attitude and alone, on both machines, against Runge-Kutta in the same rounds.
void free_bodies(benchmark::Benchmark& program) {
  std::vector<Row> rows;
  double worst = 0, worst_momentum = 0, least_ratio = 1e9;
  for (std::size_t const count : {8u, 16u, 64u, 1024u, 65536u}) {
    Cast const cast(count);
    long const steps = std::max(256L, static_cast<long>(400000 / count));
    BodyBatch whole(cast.inertias, cast.momenta, cast.attitudes, 1), momenta = whole, one = whole;
    BodyBatch plain(cast.inertias, cast.momenta, cast.attitudes, 1, Machine::plain), plain_momenta = plain;
    auto const& I = cast.inertias[0].moments;
    auto const& M = cast.momenta[0].components;
    Free const equations{{1 / I[0], 1 / I[1], 1 / I[2]}};
    Seven y{M[0], M[1], M[2], 1, 0, 0, 0};
    double const units = static_cast<double>(steps) * static_cast<double>(count);
    auto const times =
        benchmark::in_turns(program.rounds(count > 60000 ? 11 : 31),
                            {{"momentum and attitude", [&] { whole.step(steps); }, units},
                             {"momentum alone", [&] { momenta.step_momentum(steps); }, units},
                             {"baseline", [&] { plain.step(steps); }, units},
                             {"baseline, momentum alone", [&] { plain_momenta.step_momentum(steps); }, units},
                             {"one step a call",
                              [&] {
                                for (int k = 0; k < 8; ++k) one.step();
                              },
                              8.0 * static_cast<double>(count)},
                             {"Runge-Kutta",
                              [&] {
                                for (int k = 0; k < 20000; ++k) y = runge_kutta(equations, y, 1);
                              },
                              20000}});
    double const ratio = benchmark::ratio_of_best(times[5], times[0]);
    rows.push_back({std::to_string(count), shown(times[0]), shown(times[1]), shown(times[2]), shown(times[3]),
                    shown(times[4]), shown(times[5]), book::number(ratio)});
    worst = std::max(worst, nanoseconds(times[0]));
    if (count >= 16) worst_momentum = std::max(worst_momentum, nanoseconds(times[1]));
    least_ratio = std::min(least_ratio, ratio);
    sum += whole.momentum(3).components.sum() + momenta.momentum(3).components.sum() +
           plain.momentum(3).components.sum() + plain_momenta.momentum(3).components.sum() + y.a;
  }
  std::string const name = name_of(best_machine());
  program.table("free",
                {"bodies", name, name + ", momentum", "baseline", "baseline, momentum",
                 name + ", one step a call", "Runge-Kutta", "Runge-Kutta / " + name},
                rows, "Free bodies, exact steps: nanoseconds for a step of one body.");
  program.figure("free", worst, "ns for a step with attitude, the slowest size of a batch");
  program.figure("free_momentum", worst_momentum,
                 "ns for a step of the momentum, the slowest size from 16 bodies on");
  program.figure("free_ratio", least_ratio,
                 "Runge-Kutta steps of one body per exact step of a body in a batch, at least");
  if (best_machine() == Machine::avx2) {
    program.claim_of_time(worst <= 2, "an exact step with attitude takes at most 2 ns a body");
    program.claim_of_time(worst_momentum <= 1.2,
                          "an exact step of the momentum takes at most 1.2 ns a body, from 16 bodies on");
    program.claim_of_time(
        least_ratio >= 10,
        "a Runge-Kutta step of a body takes at least ten times as long as an exact step in a batch");
  }
  program.headline("an exact step of a free body in a batch takes " + book::number(worst) +
                       " ns at most, a Runge-Kutta step " + book::number(least_ratio) +
                       " times as long or more",
                   worst);
}

/// Kicks and drifts, one body and many.
void torqued_bodies(benchmark::Benchmark& program) {
  Cast const cast(64);
  auto const& I = cast.inertias[0];
  auto const& M = cast.momenta[0];
  auto const& q = cast.attitudes[0];
  UnderGravity const equations{{{1 / I.moments[0], 1 / I.moments[1], 1 / I.moments[2]}},
                               cast.torques[0].coefficients(),
                               cast.torques[0].towards};
  Seven y{M.components[0], M.components[1], M.components[2], q.value[0], q.value[1], q.value[2], q.value[3]};
  long const one = 8000, many = 200;
  std::vector<Row> rows;
  double scalar = 0, batch = 0, ratio = 0;
  for (auto const& method :
       {strang_splitting(), composed_splitting("Suzuki", 4, suzuki<double>()), blanes_moan_splitting()}) {
    TorquedBody body(I, M, q, cast.torques[0], 1, method),
        plain(I, M, q, cast.torques[0], 1, method, 0, Machine::plain),
        orbit(I, M, q, cast.orbits[0], 1, method);
    TorquedBatch lanes(cast.inertias, cast.momenta, cast.attitudes, cast.torques, 1, method),
        plain_lanes(cast.inertias, cast.momenta, cast.attitudes, cast.torques, 1, method, Machine::plain),
        orbits(cast.inertias, cast.momenta, cast.attitudes, cast.orbits, 1, method);
    double const units = static_cast<double>(one), lane_units = 64.0 * static_cast<double>(many);
    auto const times = benchmark::in_turns(program.rounds(31),
                                           {{"one body", [&] { body.step(one); }, units},
                                            {"baseline", [&] { plain.step(one); }, units},
                                            {"orbit", [&] { orbit.step(one); }, units},
                                            {"lanes", [&] { lanes.step(many); }, lane_units},
                                            {"baseline lanes", [&] { plain_lanes.step(many); }, lane_units},
                                            {"orbit lanes", [&] { orbits.step(many); }, lane_units},
                                            {"Runge-Kutta",
                                             [&] {
                                               for (long k = 0; k < one; ++k)
                                                 y = runge_kutta(equations, y, 1);
                                             },
                                             units}});
    rows.push_back({method.name + ", order " + std::to_string(method.order)});
    for (auto const& seconds : times) rows.back().push_back(shown(seconds));
    if (method.name == "Strang")
      scalar = nanoseconds(times[0]), batch = nanoseconds(times[3]),
      ratio = benchmark::ratio_of_best(times[0], times[6]);
    sum += body.state().body_momentum.components.sum() + lanes.state(5).body_momentum.components.sum() + y.a;
  }
  std::string const name = name_of(best_machine());
  program.table("torqued",
                {"method", "one body, " + name, "baseline", name + ", in orbit", "batch of 64, " + name,
                 "baseline", name + ", in orbit", "Runge-Kutta"},
                rows,
                "Bodies under the torque of gravity: nanoseconds for a step of one body. The centre "
                "stands still but for \"in orbit\".");
  program.figure("torqued", scalar, "ns for a kick and an exact drift of one body");
  program.figure("torqued_batch", batch, "ns for a kick and an exact drift of a body in a batch");
  program.figure("torqued_ratio", ratio,
                 "a kick and an exact drift, in Runge-Kutta steps under the same torque");
  if (best_machine() == Machine::avx2) {
    program.claim_of_time(scalar <= 60, "a kick and an exact drift take at most 60 ns");
    program.claim_of_time(batch <= 15, "in a batch at most 15 ns a body");
  }
}

int main(int argc, char** argv) {
  benchmark::Benchmark program(argc, argv,
                               "many rigid bodies: nanoseconds for an exact step, free and under a torque");
  program.say("This machine: ", name_of(best_machine()), ".");
  free_bodies(program);
  torqued_bodies(program);
  program.figure("sum", sum, "sum of the last states, so that nothing is left out");
  return program.finish();
}
