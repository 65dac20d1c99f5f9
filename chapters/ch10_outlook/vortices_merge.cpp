// A flow at random on the sphere, and the few large vortices into which it gathers.
//
// What is shown. Vortices of one sign merge, and the energy goes to the largest scales while enstrophy goes
// to the small ones: at the end a few vortices are left. Every invariant of the flow is what it was in the
// beginning, the whole spectrum of the matrix with it; the variant of all invariants is used. Read first.
// Section 10A.6.
//
//   W   vorticity as a matrix, of angular momentum zero       l   degree of a harmonic
//
// Compiled at -O2: it takes many steps.
#include "actio/quantized_sphere/sphere_invariants.hpp"
#include "actio/sphere_fields/sphere_transform.hpp"
#include "actio/sphere_fields/symbols.hpp"
#include "actio/vorticity/fast_vorticity_step.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"
#include "random_flow.hpp"
#include "sphere_disc.hpp"

using namespace actio;
using namespace actio::sphere;

constexpr int size = 128, steps = 1400;
constexpr double h = 0.03;
unsigned const seed = 4;

// 1. A flow of the degrees 4 to 8, whose vorticity has mean square 1.
SkewHermitian<> flow_at_random() {
  SphereHarmonics f = random_flow(size, 4, 8, seed);
  double square = 0;
  for (int l = 4; l <= 8; ++l) square += f.power(l);
  f.coefficient *= std::sqrt(4 * M_PI / square);
  return matrix_of(f);
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "vortices on the sphere merge, and every invariant stays");
  program.say("a flow at random from seed ", seed);
  SphereLaplacian const laplacian(size);
  auto w = flow_at_random();
  double const energy = vorticity_energy(laplacian, w), flow = std::sqrt(2 * energy);
  auto const values = vorticity_values(w);
  FastVorticityStep step(laplacian, Conserved::all_invariants, h);
  SphereGrid const grid = SphereGrid::uniform(128, 256);

  // 2. The run: maps of the whole sphere at three times, and the energy by degrees.
  std::string maps;
  double down = 0, largest = 0;
  auto const look = [&](int k) {
    // Berezin's symbol: the vorticity without the scales below the resolution.
    auto const field = values_on(grid, symbol_of(w, Symbol::berezin));
    if (k == 0) largest = field.cwiseAbs().maxCoeff();
    maps += book::whole_sphere({260, down + 106}, 400, book::on_sphere(grid, field), largest, 0);
    maps += book::svg::label({10, down + 18}, "time " + book::number(k * h));
    down += 220;
  };
  std::vector<double> times, large, middle;
  auto const spectrum = [&](int k) {
    auto const by_degree = energy_by_degree(harmonics_of(w));
    times.push_back(k * h), large.push_back(by_degree.head(4).sum() / energy);
    middle.push_back(by_degree.segment(4, 5).sum() / energy);
  };
  look(0), spectrum(0);
  for (int k = 1; k <= steps; ++k) {
    step.advance(w);
    if (k % 20 == 0) spectrum(k);
    if (k == steps / 7 || k == steps) look(k);
  }
  maps += book::colour_bar({160, down + 20}, 200, largest, "vorticity");
  program.picture("late", book::svg::picture(520, down + 50, maps),
                  "The vorticity on the whole sphere, in a projection of equal areas, at three times: blue "
                  "turns clockwise, red the other way.");
  auto plot = book::Plot("time", "share of the energy");
  plot.curve(times, large, "degrees 1 to 3").curve(times, middle, "degrees 4 to 8");
  program.picture("shares", plot.svg(), "The energy moves to the largest scales.");

  // 3. What has stayed.
  double const energy_change = std::abs(vorticity_energy(laplacian, w) / energy - 1);
  double const momentum = sphere_momentum(w).norm() / flow;
  double const unit = norm(w) / std::sqrt(double(size));
  double const spectrum_change = (vorticity_values(w) - values).cwiseAbs().maxCoeff() / unit;
  program.figure("large", large.back(), "share of the energy in the degrees 1 to 3 at the end");
  program.figure("energy", energy_change, "relative change of the energy");
  program.figure("momentum", momentum, "angular momentum, in units of the root of twice the energy");
  program.figure("spectrum", spectrum_change,
                 "largest change of an eigenvalue, in units of the root mean square");
  program.figure("steps", steps, std::to_string(steps), "steps");
  program.claim(book::measured(large.back()) > 0.5, "most of the energy is in the degrees 1 to 3 at the end");
  // A rounding for each step and each row.
  double const bound = 1e-12;
  program.claim(book::measured(std::max({energy_change, momentum, spectrum_change})) < bound,
                "energy, angular momentum and every eigenvalue stay");
  program.headline("every eigenvalue within " + book::number(spectrum_change, 2), spectrum_change);
  return program.finish();
}
