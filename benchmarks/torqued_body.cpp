// What a step of a rigid body under a torque costs: kicks and exact drifts, against the classical Runge-Kutta
// method on the same body.
//
// Nanoseconds of processor time for a step; contestants in turns, a tenth of the rounds below.
#include <Eigen/Core>

#include "actio/fast_body/space/torqued_body.hpp"
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
struct UnderGravity {
  Three<double> J;  // inverse moments
  GravityGradient torque;

  Seven rate(Seven const& s) const {
    double const u = s.x * J[0], v = s.y * J[1], w = s.z * J[2];
    Three<double> const t = torque({s.a, s.b, s.c, s.d}, 0);
    return {s.y * w - s.z * v + t[0],
            s.z * u - s.x * w + t[1],
            s.x * v - s.y * u + t[2],
            -0.5 * (s.b * u + s.c * v + s.d * w),
            0.5 * (s.a * u + s.c * w - s.d * v),
            0.5 * (s.a * v + s.d * u - s.b * w),
            0.5 * (s.a * w + s.b * v - s.c * u)};
  }
};
Seven runge_kutta(UnderGravity const& f, Seven const& s, double h) {
  Seven const k = f.rate(s), l = f.rate(moved(s, h / 2, k)), m = f.rate(moved(s, h / 2, l)),
              n = f.rate(moved(s, h, m));
  double const g = h / 6;
  return {s.x + g * (k.x + 2 * (l.x + m.x) + n.x), s.y + g * (k.y + 2 * (l.y + m.y) + n.y),
          s.z + g * (k.z + 2 * (l.z + m.z) + n.z), s.a + g * (k.a + 2 * (l.a + m.a) + n.a),
          s.b + g * (k.b + 2 * (l.b + m.b) + n.b), s.c + g * (k.c + 2 * (l.c + m.c) + n.c),
          s.d + g * (k.d + 2 * (l.d + m.d) + n.d)};
}

double nanoseconds(std::vector<double> const& seconds) { return 1e9 * benchmark::best_tenth(seconds); }

int main(int argc, char** argv) {
  benchmark::Benchmark program(argc, argv,
                               "a rigid body under a torque: nanoseconds for kicks and exact drifts");
  std::string const name = name_of(best_machine());
  program.say("This machine: ", name, ".");
  // A body that turns by 0.1 rad in a step of length 1.
  auto const inertia = inertia_from_moments(0.6, 0.85, 1.0);
  auto const momentum =
      body_momentum(inertia, velocity(SO<3>{}, (0.1 * Vector3d(1, 0.5, -0.7).normalized()).eval()));
  Element<SU2, double> const attitude{SU2{}, Eigen::Vector4d(1, 0, 0.2, 0.7).normalized()};
  auto const still = gravity_gradient(inertia, 1e-3, {1, 0, 0.4});
  auto const orbiting = gravity_gradient_in_orbit(inertia, 0.02, {1, 0, 0.4}, {0, 0, 1});
  auto const& I = inertia.moments;
  auto const& M = momentum.components;
  auto const& q = attitude.value;
  UnderGravity const equations{{1 / I[0], 1 / I[1], 1 / I[2]}, still};
  Seven y{M[0], M[1], M[2], q[0], q[1], q[2], q[3]};
  long const steps = 8000;
  std::vector<book::Program::Row> rows;
  double drift = 0, ratio = 0, sum = 0;
  for (auto const& method :
       {strang_splitting(), composed_splitting("Suzuki", 4, suzuki<double>()), blanes_moan_splitting()}) {
    TorquedBody body(inertia, momentum, attitude, still, 1, method),
        orbit(inertia, momentum, attitude, orbiting, 1, method);
    double const units = static_cast<double>(steps);
    auto const times =
        benchmark::in_turns(program.rounds(31), {{"kicks and drifts", [&] { body.step(steps); }, units},
                                                 {"in orbit", [&] { orbit.step(steps); }, units},
                                                 {"Runge-Kutta",
                                                  [&] {
                                                    for (long k = 0; k < steps; ++k)
                                                      y = runge_kutta(equations, y, 1);
                                                  },
                                                  units}});
    rows.push_back({method.name + ", order " + std::to_string(method.order)});
    for (auto const& seconds : times) rows.back().push_back(book::number(nanoseconds(seconds)));
    if (method.name == "Strang")
      drift = nanoseconds(times[0]), ratio = benchmark::ratio_of_best(times[0], times[2]);
    sum += body.state().body_momentum.components.sum() + orbit.state().body_momentum.components.sum() + y.a;
  }
  program.table("torqued", {"method", "one body, " + name, name + ", in orbit", "Runge-Kutta"}, rows,
                "A body under the torque of gravity: nanoseconds for a step. The centre stands still but for "
                "\"in orbit\".");
  program.figure("torqued", drift, "ns for a kick and an exact drift");
  program.figure("torqued_ratio", ratio,
                 "a kick and an exact drift, in Runge-Kutta steps under the same torque");
  program.figure("sum", sum, "sum of the last states, so that nothing is left out");
  if (best_machine() == Machine::avx2)
    program.claim_of_time(drift <= 60, "a kick and an exact drift take at most 60 ns");
  program.headline("a kick and an exact drift of a body under a torque take " + book::number(drift) +
                       " ns, " + book::number(ratio) + " Runge-Kutta steps",
                   drift);
  return program.finish();
}
