// Examples of the modules skew_matrices, quantized_sphere, sphere_fields and vorticity.
#include "actio/quantized_sphere/averaged_stream.hpp"
#include "actio/quantized_sphere/laplacian.hpp"
#include "actio/quantized_sphere/matrix_harmonics.hpp"
#include "actio/quantized_sphere/quantized_sphere.hpp"
#include "actio/quantized_sphere/sphere_invariants.hpp"
#include "actio/skew_matrices/skew_hermitian.hpp"
#include "actio/sphere_fields/sphere_flow.hpp"
#include "actio/sphere_fields/sphere_transform.hpp"
#include "actio/vorticity/fast_vorticity_step.hpp"
#include "actio/vorticity/vorticity_step.hpp"

#include "example.hpp"

BOOST_AUTO_TEST_SUITE(examples_of_sphere)
using namespace actio;
using namespace actio::sphere;

// ---- skew_matrices

BOOST_AUTO_TEST_CASE(skew_hermitian_matrices) {
  // [skew_hermitian]
  ComplexMatrix<> a(2, 2);
  a << std::complex(0.0, 1.0), 2.0, -2.0, std::complex(0.0, 3.0);
  SkewHermitian<> const W(a);
  assert(W.real(0, 1) == 2 && W.imaginary(1, 1) == 3);
  assert(std::abs(norm(W) - std::sqrt(1 + 9 + 4 + 4.0)) < 1e-15);
  assert(norm(commutator(W, W)) == 0);
  // [skew_hermitian]
}

// ---- quantized_sphere

BOOST_AUTO_TEST_CASE(functions_as_matrices) {
  // [matrix_of]
  SphereHarmonics f(16);        // degrees below N = 16
  f(3, 2) = {0.5, 0.2};         // the coefficient of Y_32; that of Y_3,-2 follows, the function is real
  SkewHermitian<> const W = matrix_of(f);
  assert(W.size() == 16);
  assert(std::abs(harmonics_of(W)(3, 2) - f(3, 2)) < 1e-14);
  // [matrix_of]
  // [sphere_laplacian]
  SphereLaplacian const laplacian(16);
  SkewHermitian<> const P = laplacian.solve(W);              // the stream function: Laplacian P = W
  assert(norm(12.0 * P + W) < 1e-14);                        // -l(l + 1) = -12 for degree 3
  // [sphere_laplacian]
  // [averaged_stream]
  AveragedStream const smooth(16, 0.3, AveragedMetric::deformation);
  double const divided = 12 * (1 + 0.3 * 0.3 * (12 - 2));    // y (1 + alpha^2 (y - 2)), y = 12
  assert(norm(divided * smooth.solve(W) + W) < 1e-13);
  // [averaged_stream]
  // [sphere_invariants]
  assert(std::abs(vorticity_energy(laplacian, W) - 0.29 / 12) < 1e-14);     // |f|^2/(l(l+1)), m and -m
  assert(std::abs(vorticity_casimirs(W, 2)[0] - 2 * 0.29) < 1e-14);         // twice the enstrophy
  assert(sphere_momentum(W).norm() < 1e-14);                               // degree 1 alone has any
  // [sphere_invariants]
}

// ---- sphere_fields

BOOST_AUTO_TEST_CASE(fields_on_grids) {
  // [values_on]
  SphereHarmonics f(8);
  f(1, 0) = 1;  // sqrt(3/(4 pi)) cos(theta)
  SphereGrid const grid = SphereGrid::gauss(8, 16);
  GridField const values = values_on(grid, f);
  double const expected = std::sqrt(3 / (4 * std::numbers::pi)) * std::cos(grid.colatitude[0]);
  assert(std::abs(values(0, 3) - expected) < 1e-14);  // on the first parallel
  assert(std::abs(harmonics_from(grid, values, 8)(1, 0) - 1.0) < 1e-14);
  // [values_on]
}

// ---- vorticity

BOOST_AUTO_TEST_CASE(steps_of_the_fluid) {
  // [fast_vorticity_step]
  // The solution of VorticityStep, to a tolerance of 1e-9 or so, in mixed precision: for large N.
  SphereHarmonics f(32);
  f(2, 1) = {0.4, 0.7}, f(5, 0) = 0.5;
  auto exact = matrix_of(f), quick = exact;
  SphereLaplacian const laplacian(32);
  VorticityStep(laplacian, Conserved::all_invariants, 0.2).advance(exact);
  FastVorticityStep(laplacian, Conserved::all_invariants, 0.2).advance(quick);
  assert(norm(quick - exact) < 1e-7 * norm(exact));
  // [fast_vorticity_step]
}

BOOST_AUTO_TEST_SUITE_END()
