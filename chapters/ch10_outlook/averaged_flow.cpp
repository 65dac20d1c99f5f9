// One flow at random by the equations of Euler and by the averaged ones.
//
// What is shown. The averaged equations carry a vorticity q by a velocity that is smooth on a length alpha.
// From the same q the large vortices come as in Euler's fluid, filaments finer than alpha stay thinner and
// weaker in the curl of the velocity, and every invariant of q stays. Read first. Section 10A.6.
//
//   q   the vorticity that is carried       psi   stream function, (1 - alpha^2 (Delta + 2)) Delta psi = q
//
// Compiled at -O2: it takes many steps.
#include "actio/quantized_sphere/sphere_invariants.hpp"
#include "actio/sphere_fields/sphere_transform.hpp"
#include "actio/sphere_fields/symbols.hpp"
#include "actio/vorticity/averaged_steps.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"
#include "random_flow.hpp"
#include "sphere_disc.hpp"

using namespace actio;
using namespace actio::sphere;

constexpr int size = 96, steps = 500;
constexpr double h = 0.03, alpha = 0.15;
unsigned const seed = 4;

// 1. The flow: degrees 4 to 8, the mean square of the vorticity 1.
SkewHermitian<> flow_at_random() {
  SphereHarmonics f = random_flow(size, 4, 8, seed);
  double square = 0;
  for (int l = 4; l <= 8; ++l) square += f.power(l);
  f.coefficient *= std::sqrt(4 * M_PI / square);
  return matrix_of(f);
}

// 2. A run, and by how much it has changed its invariants.
struct Flow {
  SkewHermitian<> q;                    // at the end
  SphereHarmonics curl;                 // of the velocity
  double energy, momentum, eigenvalue;  // changes
};
template <class Stream>
Flow run(Stream const& stream) {
  SkewHermitian<> const start = flow_at_random();
  SkewHermitian<> w = start;
  FastVorticityStep<Stream> step(stream, Conserved::all_invariants, h);
  for (int k = 0; k < steps; ++k) step.advance(w);
  double const energy = vorticity_energy(stream, start), unit = norm(start) / std::sqrt(double(size));
  return {w, harmonics_of(SphereLaplacian(size).apply(stream.solve(w))),
          std::abs(vorticity_energy(stream, w) / energy - 1),
          sphere_momentum(w).norm() / std::sqrt(2 * energy),
          (vorticity_values(w) - vorticity_values(start)).cwiseAbs().maxCoeff() / unit};
}

// 3. The kinetic energy of the velocity, half the integral of its square, in each degree from 2 on.
std::vector<double> velocity_by_degree(SphereHarmonics const& curl) {
  std::vector<double> out;
  for (int l = 2; l < size; ++l) out.push_back(0.5 * curl.power(l) / (l * (l + 1.0)));
  return out;
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "the averaged equations of Euler on the sphere beside Euler's");
  program.say("a flow at random from seed ", seed);
  auto const euler = run(SphereLaplacian(size));
  auto const averaged = run(AveragedStream(size, alpha, AveragedMetric::deformation));

  // 4. Maps at the end.
  SphereGrid const grid = SphereGrid::uniform(96, 192);
  std::string maps;
  double down = 0, largest = 0;
  auto const map = [&](SphereHarmonics const& f, std::string const& of) {
    auto const field = values_on(grid, symbol_of(f, Symbol::berezin));
    if (largest == 0) largest = field.cwiseAbs().maxCoeff();
    maps += book::whole_sphere({260, down + 106}, 400, book::on_sphere(grid, field), largest, 0);
    maps += book::svg::label({10, down + 18}, of);
    down += 220;
  };
  map(euler.curl, "Euler");
  map(harmonics_of(averaged.q), "averaged: q");
  map(averaged.curl, "averaged: curl");
  maps += book::colour_bar({160, down + 20}, 200, largest, "vorticity");
  program.picture(
      "maps", book::svg::picture(520, down + 50, maps),
      "The whole sphere at the time " + book::number(steps * h) +
          ", from the same vorticity: that of Euler's flow, and of averaged flow with the length " +
          book::number(alpha) + " the vorticity q that is carried and the curl of the velocity.");
  // The degree 1 is the angular momentum, which is zero.
  std::vector<double> degrees;
  for (int l = 2; l < size; ++l) degrees.push_back(l);
  auto plot = book::Plot("degree", "kinetic energy of the velocity").log_x().log_y();
  plot.curve(degrees, velocity_by_degree(euler.curl), "Euler");
  plot.curve(degrees, velocity_by_degree(averaged.curl), "averaged");
  program.picture(
      "spectra", plot.svg(),
      "The velocity in each degree at that time: beyond 1/alpha that of averaged flow falls faster.");

  // 5. What has stayed, and what is smooth.
  double const share =
      std::pow(averaged.curl.coefficient.norm() / harmonics_of(averaged.q).coefficient.norm(), 2);
  double const changed = std::max({averaged.energy, averaged.momentum, averaged.eigenvalue});
  program.figure("changes", changed, "largest change of energy, angular momentum or an eigenvalue");
  program.figure("share", share, "square of the curl of the velocity, as a share of that of q");

  // A rounding for each step and each row.
  program.claim(book::measured(changed) < 1e-12, "energy, angular momentum and every eigenvalue of q stay");
  auto const of_averaged = velocity_by_degree(averaged.curl), of_euler = velocity_by_degree(euler.curl);
  double const fine = of_averaged[38] / of_averaged[2], euler_fine = of_euler[38] / of_euler[2];
  program.claim(book::measured(fine) < 0.1 * euler_fine,
                "beside the degree 4 the degree 40 has less of the averaged velocity than of Euler's");
  program.headline("energy, momentum and eigenvalues within " + book::number(changed, 2), changed);
  return program.finish();
}
