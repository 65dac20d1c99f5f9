// Functions on the torus as matrices: clock and shift, the sine bracket, the Laplacian, grids.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/quantized_torus/torus_invariants.hpp"
#include "actio/skew_matrices/dense_matrices.hpp"
#include "caught.hpp"
#include "refused.hpp"
#include "torus_flows.hpp"

using namespace actio;
using namespace actio::torus;
using sphere::ComplexMatrix, sphere::SkewHermitian;
using testing::random_torus_harmonics, testing::random_torus_state;

namespace {

using Complex = std::complex<double>;

ComplexMatrix<> bracket(ComplexMatrix<> const& a, ComplexMatrix<> const& b) { return a * b - b * a; }

/// {f, g} = f_x g_y - f_y g_x of two functions with few coefficients, coefficient by coefficient.
TorusHarmonics poisson_bracket(TorusHarmonics const& f, TorusHarmonics const& g, int most) {
  TorusHarmonics out(f.size());
  for (int a = -most; a <= most; ++a)
    for (int b = -most; b <= most; ++b)
      for (int c = -most; c <= most; ++c)
        for (int d = -most; d <= most; ++d)
          if (b + d > 0 || (b + d == 0 && a + c > 0))
            out.set(a + c, b + d, out(a + c, b + d) + double(b * c - a * d) * f(a, b) * g(c, d));
  return out;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(quantized_torus)

BOOST_AUTO_TEST_CASE(clock_and_shift_are_as_they_are_written) {
  int const n = 5;
  QuantizedTorus const torus(n);
  ComplexMatrix<> const clock = torus.wave(1, 0), shift = torus.wave(0, 1);
  for (int j = 0; j < n; ++j)
    for (int k = 0; k < n; ++k) {
      BOOST_TEST(std::abs(clock(j, k) - (j == k ? std::polar(1.0, 2 * M_PI * k / n) : 0)) <= 1e-15);
      BOOST_TEST(std::abs(shift(j, k) - (k == (j + 1) % n ? 1.0 : 0.0)) == 0);
    }
  Complex const q = std::polar(1.0, 2 * M_PI / n);
  BOOST_TEST((shift * clock - q * clock * shift).norm() <= 1e-15 * n);
  for (int a = -2; a <= 2; ++a)
    for (int b = -2; b <= 2; ++b) {
      ComplexMatrix<> power = ComplexMatrix<>::Identity(n, n);
      for (int k = 0; k < std::abs(a); ++k) power *= a > 0 ? clock : ComplexMatrix<>(clock.adjoint());
      for (int k = 0; k < std::abs(b); ++k) power *= b > 0 ? shift : ComplexMatrix<>(shift.adjoint());
      BOOST_TEST((torus.wave(a, b) - std::polar(1.0, M_PI * a * b / n) * power).norm() <= 1e-15 * n);
      BOOST_TEST((torus.wave(a, b).adjoint() - torus.wave(-a, -b)).norm() <= 1e-15 * n);
    }
}

BOOST_AUTO_TEST_CASE(commutators_are_the_sine_bracket) {
  int const n = 11;
  QuantizedTorus const torus(n);
  int const most = torus.largest();
  for (int a = -most; a <= most; ++a)
    for (int b = -most; b <= most; ++b)
      for (auto const& [c, d] : {std::pair(1, 0), {2, -3}, {-5, 4}}) {
        int m = a + c, k = b + d;
        // Beyond the range a wave comes in again at the other side, with the sign of q^(mk/2) there.
        double sign = 1;
        if (std::abs(m) > most) m -= m > 0 ? n : -n, sign *= k % 2 == 0 ? 1 : -1;
        if (std::abs(k) > most) k -= k > 0 ? n : -n, sign *= m % 2 == 0 ? 1 : -1;
        Complex const factor(0, sign * 2 * std::sin(M_PI * (b * c - a * d) / n));
        BOOST_TEST((bracket(torus.wave(a, b), torus.wave(c, d)) - factor * torus.wave(m, k)).norm() <=
                   1e-14 * n);
      }
}

BOOST_AUTO_TEST_CASE(the_laplacian_is_the_double_commutator_with_clock_and_shift) {
  for (int n : {3, 5, 16 + 1, 27}) {
    QuantizedTorus const torus(n);
    ComplexMatrix<> const clock = torus.wave(1, 0), shift = torus.wave(0, 1);
    SkewHermitian<> const w = random_torus_state(n, torus.largest());
    ComplexMatrix<> const x = w.complex();
    ComplexMatrix<> const truth =
        -std::pow(n / (2 * M_PI), 2) *
        (bracket(clock, bracket(clock.adjoint(), x)) + bracket(shift, bracket(shift.adjoint(), x)));
    BOOST_TEST((TorusStream(n).apply(w).complex() - truth).norm() <= 1e-15 * n * truth.norm());
    for (double gamma : {0.0, 3.0}) {
      TorusStream const stream(n, gamma);
      SkewHermitian<> const p = stream.solve(w);
      BOOST_TEST(sphere::norm(stream.apply(p) - w) <= 1e-14 * sphere::norm(w));
      BOOST_TEST(std::abs(p.imaginary.trace()) <= 1e-15 * n * sphere::norm(p));
      // The constant makes no flow.
      SkewHermitian<> more = w;
      more.imaginary.diagonal().array() += 2;
      BOOST_TEST(sphere::norm(stream.solve(more) - p) <= 1e-14 * sphere::norm(w));
    }
  }
  // The eigenvalues tend to those of the torus.
  for (int n : {101, 201}) BOOST_TEST(std::abs(QuantizedTorus(n).eigenvalue(3, 4) / -25 - 1) <= 50.0 / n / n);
}

BOOST_AUTO_TEST_CASE(functions_matrices_and_grids_go_round) {
  for (int n : {3, 9, 25, 31}) {
    QuantizedTorus const torus(n);
    int const most = torus.largest();
    TorusHarmonics const f = random_torus_harmonics(n, most, 5);
    double const size = f.coefficient.norm();
    // By the definition.
    ComplexMatrix<> sum = ComplexMatrix<>::Zero(n, n);
    for (int m = -most; m <= most; ++m)
      for (int k = -most; k <= most; ++k) sum += Complex(0, 1) * f(m, k) * torus.wave(m, k);
    SkewHermitian<> const w = matrix_of(f);
    BOOST_TEST((w.complex() - sum).norm() <= 1e-15 * n * sum.norm());
    BOOST_TEST((torus::harmonics_of(w).coefficient - f.coefficient).norm() <= 1e-15 * size);
    for (int points : {n, n + 1, 2 * n + 3}) {
      GridValues const values = values_on_grid(f, points);
      BOOST_TEST((harmonics_from_grid(values, n).coefficient - f.coefficient).norm() <= 2e-15 * size);
      int const j = points / 3, i = points - 1;
      Complex here = 0;
      for (int m = -most; m <= most; ++m)
        for (int k = -most; k <= most; ++k)
          here += f(m, k) * std::polar(1.0, 2 * M_PI * (m * i + k * j) / points);
      BOOST_TEST(std::abs(values(j, i) - here) <= 1e-14 * n * size);
    }
    // Sums over matrices are integrals.
    GridValues const values = values_on_grid(f, n);
    double const cell = 4 * M_PI * M_PI / n / n;
    BOOST_TEST(std::abs(flow_enstrophy(w) / (0.5 * cell * values.squaredNorm()) - 1) <= 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(the_bracket_tends_to_that_of_functions) {
  double before = 0;
  for (int n : {63, 127}) {
    TorusHarmonics const f = random_torus_harmonics(n, 3, 1), g = random_torus_harmonics(n, 3, 2);
    SkewHermitian<> const truth = matrix_of(poisson_bracket(f, g, 3));
    // W = iF: [iF, iG]/hbar = -i {f, g}.
    SkewHermitian<> const found =
        (-1 / QuantizedTorus(n).hbar()) * sphere::commutator(matrix_of(f), matrix_of(g));
    double const error = sphere::norm(found - truth) / sphere::norm(truth);
    BOOST_TEST_MESSAGE("the bracket on N = " << n << " is off by " << error);
    if (n == 127) BOOST_TEST(std::abs(before / error / std::pow(127.0 / 63, 2) - 1) <= 0.05);
    before = error;
  }
}

// The page has this one: N = 3, vorticity 2a cos x + 4c cos x cos y.
BOOST_AUTO_TEST_CASE(three_rows_are_as_they_are_by_hand) {
  double const a = 0.7, c = 0.4;
  TorusHarmonics f(3);
  f.set(1, 0, a), f.set(1, 1, c), f.set(-1, 1, c);
  ComplexMatrix<> x(3, 3), change(3, 3);
  x << 2 * a, c, c, c, -a, -2 * c, c, -2 * c, -a;
  BOOST_TEST((matrix_of(f).hermitian() - x).norm() <= 1e-15);
  TorusStream const stream(3);
  BOOST_TEST(std::abs(QuantizedTorus(3).eigenvalue(1, 0) + 27 / (4 * M_PI * M_PI)) <= 1e-15);
  BOOST_TEST(std::abs(QuantizedTorus(3).eigenvalue(1, 1) + 27 / (2 * M_PI * M_PI)) <= 1e-15);
  SkewHermitian<> const moves =
      (1 / QuantizedTorus(3).hbar()) * sphere::commutator(stream.solve(matrix_of(f)), matrix_of(f));
  change << 0, 1, 1, -1, 0, 0, -1, 0, 0;
  change *= Complex(0, -M_PI / 3 * a * c);
  BOOST_TEST((moves.hermitian() - change).norm() <= 2e-15);
  // As a function: 4 pi/(3 sqrt 3) a c sin x sin y.
  TorusHarmonics const rate = torus::harmonics_of(moves);
  double const sine = M_PI / (3 * std::sqrt(3)) * a * c;
  BOOST_TEST(std::abs(rate(1, 1) + sine) <= 1e-15);
  BOOST_TEST(std::abs(rate(-1, 1) - sine) <= 1e-15);
  BOOST_TEST(std::abs(rate(1, 0)) + std::abs(rate(0, 1)) <= 1e-15);
}

BOOST_AUTO_TEST_CASE(energies_and_fields_are_those_of_a_known_flow) {
  int const n = 21;
  QuantizedTorus const torus(n);
  // cos(2x + y) has the square 1/2 on average.
  TorusHarmonics f(n);
  f.set(2, 1, 0.5);
  for (double gamma : {0.0, 2.0}) {
    double const divisor = gamma - torus.eigenvalue(2, 1), energy = M_PI * M_PI / divisor;
    BOOST_TEST(std::abs(flow_energy(TorusStream(n, gamma), matrix_of(f)) / energy - 1) <= 1e-14);
    Eigen::VectorXd const rings = energy_by_ring(f, gamma);
    BOOST_TEST(std::abs(rings[2] / energy - 1) <= 1e-14);
    BOOST_TEST(std::abs(rings.sum() / energy - 1) <= 1e-14);
    torus::FlowFields const fields = flow_on_grid(f, gamma, 30);
    double const x = 2 * M_PI * 7 / 30, y = 2 * M_PI * 4 / 30;
    BOOST_TEST(std::abs(fields.vorticity(4, 7) - std::cos(2 * x + y)) <= 1e-14);
    BOOST_TEST(std::abs(fields.streamfunction(4, 7) + std::cos(2 * x + y) / divisor) <= 1e-14);
    BOOST_TEST(std::abs(fields.along_x(4, 7) + std::sin(2 * x + y) / divisor) <= 1e-14);
    BOOST_TEST(std::abs(fields.along_y(4, 7) - 2 * std::sin(2 * x + y) / divisor) <= 1e-14);
  }
  TorusHarmonics const all = random_torus_harmonics(n, 10);
  BOOST_TEST(std::abs(energy_by_ring(all, 1).sum() / flow_energy(TorusStream(n, 1), matrix_of(all)) - 1) <=
             1e-14);
}

BOOST_AUTO_TEST_CASE(what_is_no_torus_is_refused) {
  CHECK_REFUSED(QuantizedTorus(4), OutsideDomain);
  CHECK_REFUSED(QuantizedTorus(1), OutsideDomain);
  CHECK_REFUSED(TorusHarmonics(10), OutsideDomain);
  CHECK_REFUSED(TorusStream(8), OutsideDomain);
  CHECK_REFUSED(TorusStream(9, -1), OutsideDomain);
  CHECK_REFUSED(TorusStream(9, std::nan("")), NotFinite);
  CHECK_REFUSED(values_on_grid(TorusHarmonics(9), 8), OutsideDomain);
  CHECK_REFUSED(harmonics_from_grid(GridValues::Zero(7, 7), 9), OutsideDomain);
  CHECK_REFUSED(harmonics_from_grid(GridValues::Zero(9, 8), 9), OutsideDomain);
}

BOOST_AUTO_TEST_SUITE_END()
