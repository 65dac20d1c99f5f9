// Lines to try of chapter 10: a step of the fluid on the sphere, and how good its bracket is.
#include "book/try_it.hpp"
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

TRY_IT_MAIN("the lines to try of chapter 10")
