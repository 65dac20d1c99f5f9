// Examples of the module quantized_torus, and of the steps on it.
#include "actio/quantized_torus/torus_invariants.hpp"
#include "actio/skew_matrices/skew_hermitian.hpp"
#include "actio/vorticity/torus_steps.hpp"

#include "example.hpp"

BOOST_AUTO_TEST_SUITE(examples_of_torus)
using namespace actio;
using namespace actio::torus;
using sphere::SkewHermitian;

BOOST_AUTO_TEST_CASE(functions_as_matrices_and_their_flow) {
  // [torus_matrix]
  TorusHarmonics f(17);                    // wave numbers from -8 to 8
  f.set(2, 1, 0.5);                        // cos(2x + y): the coefficient of exp(-i(2x + y)) follows
  SkewHermitian<> const W = matrix_of(f);
  assert(std::abs(torus::harmonics_of(W)(2, 1) - 0.5) < 1e-15);
  GridValues const values = values_on_grid(f, 20);
  assert(std::abs(values(0, 0) - 1) < 1e-15);              // at x = y = 0
  assert(std::abs(harmonics_from_grid(values, 17)(-2, -1) - 0.5) < 1e-15);
  // [torus_matrix]
  // [torus_stream]
  TorusStream const euler(17), layer(17, 4.0);             // Laplacian psi = omega; (Laplacian - 4) psi = q
  double const eigenvalue = QuantizedTorus(17).eigenvalue(2, 1);    // about -5
  assert(sphere::norm(eigenvalue * euler.solve(W) - W) < 1e-14);
  assert(sphere::norm((eigenvalue - 4) * layer.solve(W) - W) < 1e-14);
  // [torus_stream]
  // [torus_invariants]
  double const square = std::numbers::pi * std::numbers::pi;        // cos^2 is 1/2 on average, on 4 pi^2
  assert(std::abs(flow_enstrophy(W) - square) < 1e-13);
  assert(std::abs(flow_energy(euler, W) + square / eigenvalue) < 1e-13);
  // [torus_invariants]
  // [torus_step]
  f.set(0, 1, 0.3), f.set(3, -2, 0.2);
  SkewHermitian<> w = matrix_of(f);
  double const energy = flow_energy(euler, w);
  TorusStep step(euler, sphere::Conserved::energy_casimir, 0.02);
  for (int k = 0; k < 20; ++k) step.advance(w);
  assert(std::abs(flow_energy(euler, w) / energy - 1) < 1e-14);
  // [torus_step]
}
BOOST_AUTO_TEST_SUITE_END()
