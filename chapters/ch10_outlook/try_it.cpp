// Lines to try of chapter 10: a step of the fluid on the sphere, how good its bracket is, and a sheet of
// rubber.
#include "book/try_it.hpp"
#include "actio/multisymplectic/fast_medium_2d.hpp"
#include "actio/numbers/print.hpp"
#include "actio/vorticity/sphere_invariants.hpp"
#include "actio/vorticity/vorticity_step.hpp"
using namespace actio;

TRY_IT(a_step) {
  // One step of a flow of three harmonics: what has changed of energy, angular momentum and C_2 .. C_5.
  SphereHarmonics f(16);
  f(1, 0) = 1, f(3, 2) = {0.5, 0.2}, f(4, 1) = {-0.3, 0.6};
  auto const before = matrix_of(f);
  auto w = before;
  SphereLaplacian const laplacian(16);
  VorticityStep(laplacian, Conserved::all_invariants, 0.2).advance(w);
  print("energy", vorticity_energy(laplacian, w) - vorticity_energy(laplacian, before));
  print("angular momentum", (sphere_momentum(w) - sphere_momentum(before)).norm());
  print("Casimirs", (vorticity_casimirs(w, 5) - vorticity_casimirs(before, 5)).norm());
  print("and the vorticity itself", norm(w - before) / norm(before));
}

TRY_IT(bracket) {
  // The bracket of two harmonics of degree l as the matrices of size N have it, against its limit: the
  // relative error, in units of l^4/(6 N^2).
  auto const bracket = [](int n, int l) {
    SphereHarmonics f(n), g(n);
    f(l, l / 2) = 1, g(l, l) = {0.6, 0.8};
    SkewHermitian<> const c = commutator(matrix_of(f), matrix_of(g));
    return harmonics_of((1 / QuantizedSphere(n).hbar()) * c).coefficient.topLeftCorner(2 * l, 2 * l).eval();
  };
  int const l = 4;
  Eigen::MatrixXcd const fine = (4.0 * bracket(96, l) - bracket(48, l)) / 3.0;  // of second order in 1/N
  for (int n : {16, 24, 32}) {
    double const error = (bracket(n, l) - fine).norm() / fine.norm();
    print(("N = " + std::to_string(n)).c_str(), error * 6 * n * n / std::pow(l, 4));
  }
}

TRY_IT(sheet) {
  // A sheet of rubber is stretched, set turning and let go: what has changed after a thousand steps.
  auto const placed = [](auto const& X) { return std::array{1.3 * X[0], X[1]}; };
  auto const turning = [](auto const& X) { return std::array{-X[1], X[0]}; };
  FastMedium2d sheet(neo_hookean(2, 1), FastBox2d{{12, 8}, {0.1, 0.1}}, 0.02, 1, placed, turning);
  double const angular = sheet.angular_momentum(), energy = sheet.energy();
  sheet.step(1000);
  print("angular momentum, relative", sheet.angular_momentum() / angular - 1);
  print("energy, relative", sheet.energy() / energy - 1);
  print("the longest stable step", sheet.largest_step());
}

TRY_IT_MAIN("the lines to try of chapter 10")
