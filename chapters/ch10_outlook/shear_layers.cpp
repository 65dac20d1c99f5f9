// Two shear layers on the torus roll up, and every value of the vorticity keeps its area.
//
// What is shown. The bracket of matrices tends to that of functions with the square of 1/N; a flow of one
// eigenvalue stands still; and two layers across which the velocity changes its sign roll up into vortices,
// while energy and all eigenvalues stay, where the Lie-Poisson form keeps the energy up to its order. Read
// first. Section 10H.3.
//
//   W   vorticity as a matrix of the odd size N P its stream function T_mn the wave exp(i(mx + ny))
//
// Compiled at -O2: it takes many steps.
#include <Eigen/Core>

#include "actio/quantized_torus/torus_invariants.hpp"
#include "actio/skew_matrices/dense_matrices.hpp"
#include "actio/vorticity/torus_steps.hpp"
#include "book/program.hpp"
#include "book/sphere_map.hpp"

using namespace actio;
using namespace actio::torus;
using sphere::Conserved, sphere::SkewHermitian;

constexpr int size = 85, steps = 600;
constexpr double h = 0.015;

// 1. Two layers at y = pi/2 and 3 pi/2, with a wave on them.
SkewHermitian<> layers() {
  double const width = 0.2, wave = 0.05;
  GridValues values(2 * size, 2 * size);
  for (int j = 0; j < 2 * size; ++j)
    for (int k = 0; k < 2 * size; ++k) {
      double const x = M_PI * j / size, y = M_PI * k / size;
      double const below = 1 / std::cosh((y - M_PI / 2) / width),
                   above = 1 / std::cosh((y - 3 * M_PI / 2) / width);
      values(k, j) = (above * above - below * below) / width + wave * std::cos(x);
    }
  TorusHarmonics f = harmonics_from_grid(values, size);
  f.set(0, 0, 0);
  return matrix_of(f);
}

// 2. {sin 2x, sin 3y} = 6 cos 2x cos 3y, by matrices of the size n: the factor is (N/pi) sin(6 pi/N).
double factor_of(int n) {
  TorusHarmonics f(n), g(n);
  f.set(2, 0, std::complex<double>(0, -0.5)), g.set(0, 3, std::complex<double>(0, -0.5));
  // [iF, iG]/hbar = -i {f, g}.
  TorusHarmonics const c =
      harmonics_of((-1 / QuantizedTorus(n).hbar()) * sphere::commutator(matrix_of(f), matrix_of(g)));
  return 4 * c(2, 3).real();
}

// 3. Cells of a map, row by row.
std::string map_of(double x, double y, SkewHermitian<> const& w, double largest) {
  GridValues const turned = values_on_grid(harmonics_of(w), size).transpose();
  return book::flat_map({x, y}, 250, std::vector<double>(turned.data(), turned.data() + turned.size()),
                        largest);
}

int main(int argc, char** argv) {
  book::Program program(argc, argv,
                        "shear layers on the torus roll up, and every value of the vorticity stays");

  std::vector<book::Program::Row> rows;
  double off = 0;
  for (int n : {15, 31, 63, 127}) {
    double const factor = factor_of(n);
    off = n * n * (6 - factor);
    rows.push_back({std::to_string(n), book::number(factor, 6), book::number(off, 5)});
  }
  program.table(
      "bracket", {"N", "factor of $\\cos2x\\cos3y$", "$N^2$ times its error"}, rows,
      "The bracket of $\\sin2x$ and $\\sin3y$ by matrices; that of the functions has the factor 6.");
  program.claim(book::measured(std::abs(off / (36 * M_PI * M_PI) - 1)) < 0.01,
                "the error of the bracket is 36 pi^2/N^2, to a hundredth");

  TorusStream const stream(size);
  SkewHermitian<> const start = layers();
  double const energy = flow_energy(stream, start);
  Eigen::VectorXd const values = sphere::hermitian_values(start.hermitian());
  double const largest = values.cwiseAbs().maxCoeff();
  std::string maps;
  double changes[2] = {0, 0}, spectrum = 0;
  for (auto const form : {Conserved::energy_casimir, Conserved::lie_poisson}) {
    bool const of_energy = form == Conserved::energy_casimir;
    SkewHermitian<> w = start;
    FastTorusStep step(stream, form, h);
    for (int k = 0; k <= steps; ++k) {
      if (k > 0) step.advance(w);
      if (k % 20 == 0)
        changes[of_energy ? 0 : 1] =
            std::max(changes[of_energy ? 0 : 1], std::abs(flow_energy(stream, w) / energy - 1));
      if (!of_energy || k % (steps / 3) != 0) continue;
      double const x = 10 + 270.0 * (3 * k / steps % 2), y = 20 + 280.0 * (3 * k / steps / 2);
      maps += map_of(x, y, w, largest) + book::svg::label({x, y - 6}, "time " + book::number(k * h));
    }
    spectrum = std::max(spectrum,
                        (sphere::hermitian_values(w.hermitian()) - values).cwiseAbs().maxCoeff() / largest);
  }
  maps += book::colour_bar({165, 575}, 200, largest, "vorticity");
  program.picture(
      "roll_up", book::svg::picture(540, 612, maps),
      "The vorticity of two shear layers at four times: blue turns clockwise, red the other way.");
  program.figure("energy", changes[0], "largest relative change of the energy, in the form that keeps it");
  program.figure("energy_of_poisson", changes[1], "the same in the Lie-Poisson form");
  program.figure("spectrum", spectrum,
                 "largest change of an eigenvalue, relative to the largest, in either form");
  program.figure("steps", steps, std::to_string(steps), "steps");
  program.claim(book::measured(changes[0]) < 1e-12, "the energy stays");
  program.claim(book::measured(changes[1]) > 1e-10, "the Lie-Poisson form keeps it up to its order");
  program.claim(book::measured(spectrum) < 1e-12, "every eigenvalue stays");
  program.headline("energy kept to " + book::number(changes[0]) + " and every eigenvalue to " +
                       book::number(spectrum) + " in " + std::to_string(steps) + " steps",
                   changes[0]);
  return program.finish();
}
