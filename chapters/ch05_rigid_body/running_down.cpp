// A T-handle that flips for an hour and a half: the Moser-Veselov scheme and Runge-Kutta in the long run.
//
// What is shown. With a coarse step, half a radian, the scheme makes an error of several per cent in the time
// between two flips, and the error stays what it is: momentum and energy are conserved to rounding. The
// classical Runge-Kutta method of order 4 with the same step starts out better and then dissipates momentum
// and energy a little in every step, so that its T-handle runs down. With a step so short that it takes the
// same running time as the scheme, it still dissipates. Read first. middle_axis_flip.
//
//   I      principal moments, ascending, kg m^2        h     step, s
//   omega  body velocity, rad/s                        q     attitude as a unit quaternion (Runge-Kutta)
//   M      body momentum, J s                          m     spatial momentum, J s
//
// Compiled at -O2: it takes many steps.
#include <Eigen/Geometry>

#include "actio/bodies/body_catalogue.hpp"
#include "actio/rigid_body/body_in_motion.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;
using Vector7 = Matrix<double, 7, 1>;

// 1. Runge-Kutta: momentum and quaternion, seven numbers.
Vector7 rate(Vector3d const& I, Vector7 const& y) {
  Vector3d const M = y.head<3>(), omega = M.cwiseQuotient(I), v = y.tail<3>();
  Vector7 d;
  d << cross(M, omega), -v.dot(omega) / 2, (y[3] * omega + cross(v, omega)) / 2;
  return d;
}
Vector7 runge_kutta(Vector3d const& I, Vector7 const& y, double h) {
  Vector7 const k1 = rate(I, y), k2 = rate(I, y + h / 2 * k1), k3 = rate(I, y + h / 2 * k2),
                k4 = rate(I, y + h * k3);
  return y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}

// 2. A long run of one method: when the handle turned over, what was lost on the way, and the running time.
struct Run {
  std::string name;
  std::vector<double> time, energy_lost, flips;
  double step, energy_drift = 0, casimir_drift = 0, spatial_drift = 0, seconds = 0;
};
constexpr double coarse = 0.05, duration = 5000;  // of the long runs, s: the coarse step, and the whole

// Any method over the whole duration: next makes a step, momentum_of and spatial_of read the two momenta off
// its state.
Run follow(Body const& handle, std::string const& name, double step, auto state, auto const& next,
           auto const& momentum_of, auto const& spatial_of) {
  Vector3d const I = handle.principal.inertia.moments, omega = handle.principal_spin().coordinates;
  double const energy = kinetic_energy(handle.principal.inertia, handle.principal_spin()),
               amount = I.cwiseProduct(omega).norm();
  Run run{name, {}, {}, {}, step};
  Vector3d const start = spatial_of(state);
  long const count = std::lround(duration / step), every = count / 400;
  double before = omega[1];
  run.seconds = book::seconds_of([&] {
    for (long k = 1; k <= count; ++k) {
      state = next(state);
      Vector3d const M = momentum_of(state);
      if (before * M[1] < 0) run.flips.push_back(k * step);
      before = M[1];
      if (k % every) continue;
      run.energy_drift =
          std::max(run.energy_drift,
                   std::abs(kinetic_energy(handle.principal.inertia, momentum(SO<3>{}, M)) / energy - 1));
      run.casimir_drift = std::max(run.casimir_drift, std::abs(M.squaredNorm() / (amount * amount) - 1));
      run.spatial_drift = std::max(run.spatial_drift, (spatial_of(state) - start).norm() / amount);
      run.time.push_back(k * step), run.energy_lost.push_back(std::max(run.energy_drift, 1e-16));
    }
  });
  return run;
}

// The scheme, and Runge-Kutta with any step, followed so.
Run follow_moser_veselov(Body const& handle) {
  using State = BodyInMotion<3>;
  MoserVeselov<3> const scheme(handle.principal.inertia, coarse);
  return follow(
      handle, "Moser-Veselov", coarse,
      release(handle.principal.inertia, identity<double>(SO<3>{}), handle.principal_spin()),
      [&](State s) { return advance(scheme, s), s; },
      [](State const& s) { return Vector3d(s.body_momentum.components); },
      [](State const& s) { return Vector3d(s.spatial_momentum().components); });
}

Run follow_runge_kutta(Body const& handle, std::string const& name, double step) {
  Vector3d const I = handle.principal.inertia.moments, omega = handle.principal_spin().coordinates;
  Vector7 start;
  start << I.cwiseProduct(omega), 1, 0, 0, 0;
  return follow(
      handle, name, step, start, [&](Vector7 const& y) { return runge_kutta(I, y, step); },
      [](Vector7 const& y) { return Vector3d(y.head<3>()); },
      [](Vector7 const& y) {
        return Vector3d(Eigen::Quaterniond(y[3], y[4], y[5], y[6]).toRotationMatrix() * y.head<3>());
      });
}

// 3. An hour and a half in coarse steps: the scheme, Runge-Kutta with the same step, and Runge-Kutta with the
//    same running time.
struct Runs {
  Run ours, same_step, same_cost;
  double cost;  // of a step of the scheme, in Runge-Kutta steps
};
Runs compare_long_runs(Body const& handle) {
  Run const ours = follow_moser_veselov(handle);
  Run const same_step = follow_runge_kutta(handle, "Runge-Kutta, same step", coarse);
  double const cost = ours.seconds / same_step.seconds;
  return {
      ours, same_step,
      follow_runge_kutta(handle, "Runge-Kutta, same running time", coarse / std::max(1.0, std::round(cost))),
      cost};
}

// The time between flips at the start or at the end of a run, a mean over twenty of them.
double time_between_flips(Run const& run, bool late) {
  auto const& f = run.flips;
  return f.size() < 42 ? INFINITY : late ? (f.back() - f[f.size() - 21]) / 20 : (f[20] - f[0]) / 20;
}

// 4. What they conserved, and the time between flips at the start and at the end, each a mean over twenty of
// them.
void show_what_was_kept(book::Program& program, Runs const& runs) {
  std::vector<book::Program::Row> conserved;
  auto drift = book::Plot("time, s", "largest change of the energy so far, relative")
                   .log_y()
                   .size(660, 320)
                   .y_range(1e-16, 10);
  for (auto const* run : {&runs.ours, &runs.same_step, &runs.same_cost}) {
    conserved.push_back({run->name, book::number(run->step), book::number(run->energy_drift),
                         book::number(run->casimir_drift), book::number(run->spatial_drift),
                         book::number(time_between_flips(*run, false)) + " to " +
                             book::number(time_between_flips(*run, true))});
    drift.curve(run->time, run->energy_lost, run->name);
  }
  program.table(
      "kept",
      {"method", "step, s", "energy", "amount of momentum", "momentum in space", "time between flips, s"},
      conserved,
      "Largest relative changes over 5000 s, about 2000 flips, and the time between "
      "flips at the start and at the end.");
  program.picture("drift", drift.svg(),
                  "What the methods do to the energy. Runge-Kutta takes it away, a little every step "
                  "and always in the same direction.");
  program.figure("cost", runs.cost, "running time of a Moser-Veselov step in Runge-Kutta steps");
}

// 5. What must be so: conservation to rounding, and Runge-Kutta's loss.
void claim_what_must_be(book::Program& program, Runs const& runs) {
  Run const &ours = runs.ours, &same_step = runs.same_step;
  program.claim(book::measured(std::max({ours.energy_drift, ours.casimir_drift, ours.spatial_drift})) < 1e-11,
                "energy, Casimir and spatial momentum stay within 1e-11");
  program.claim(book::measured(same_step.energy_drift) > 0.1 && book::measured(same_step.spatial_drift) > 0.3,
                "Runge-Kutta with the same step dissipates a tenth of the energy and more");
  double const late = time_between_flips(ours, true), early = time_between_flips(ours, false);
  program.claim(book::measured(std::abs(late / early - 1)) < 0.01,
                "the T-handle turns over at the end as often as at the start");
  program.headline("energy conserved to " + book::number(ours.energy_drift, 2) +
                       " over 2000 flips; Runge-Kutta dissipates " +
                       book::number(100 * same_step.energy_drift, 2) + " %",
                   ours.energy_drift);
}

int main(int argc, char** argv) {
  book::Program program(argc, argv,
                        "a T-handle flips for an hour and a half; under Runge-Kutta it runs down");
  Body const handle = read_body(ACTIO_DATA "/bodies.toml", "t_handle");
  Runs const runs = compare_long_runs(handle);
  show_what_was_kept(program, runs);
  claim_what_must_be(program, runs);
  return program.finish();
}
