// The projection along the orbit: it reaches the levels of energy and angular momentum, goes no farther than
// it must, and says where they are not reached.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/vorticity/orbit_projection.hpp"
#include "caught.hpp"
#include "flows.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::caught;
using testing::random_state, testing::RossbyHaurwitz, testing::Invariants;

namespace {

constexpr double unit = 0x1p-53;  // the unit round-off

/// W conjugated by a unitary matrix at some distance from 1: on the orbit, off the levels.
SkewHermitian<> moved_along_orbit(SkewHermitian<> const& w, double by, unsigned seed) {
  SkewHermitian<> y = testing::random_matrix(static_cast<int>(w.size()), seed);
  y *= by / norm(y);
  auto const n = w.size();
  ComplexMatrix<> const one = ComplexMatrix<>::Identity(n, n), a = y.complex();
  ComplexMatrix<> inverse = one;  // of 1 - a, by its series
  for (int k = 0; k < 8; ++k) inverse = one + ComplexMatrix<>(a * inverse);
  ComplexMatrix<> const u = inverse * (one + a);
  return SkewHermitian<>(ComplexMatrix<>(u * w.complex() * u.adjoint()));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(orbit_projection)

BOOST_AUTO_TEST_CASE(levels_are_reached_along_the_orbit_in_two_newton_steps) {
  for (int n : {3, 4, 16}) {
    SphereLaplacian const laplacian(n);
    OrbitProjection<> projection(laplacian);
    for (bool turning : {true, false}) {
      // For N = 3 the energy is a function of enstrophy and momentum: the directions are dependent.
      SkewHermitian<> const start = random_state(n, turning ? 1 : 2, n - 1, 5);
      EnergyMomentum const levels = energy_momentum(laplacian, start);
      for (double by : {1e-3, 1e-5, 1e-9}) {
        SkewHermitian<> w = moved_along_orbit(start, by, 8);
        double const apart = norm(w - start);
        auto const report = projection.project(levels, w);
        testing::Changes const changes = Invariants(laplacian, w) - Invariants(laplacian, start);
        BOOST_TEST_MESSAGE("N = " << n << ", moved by " << by << ": " << report.newton_steps
                                  << " Newton steps, " << report.found << " to " << report.left << "; energy "
                                  << changes.energy << ", momentum " << changes.momentum << ", spectrum "
                                  << changes.spectrum << ", farther from the start by "
                                  << norm(w - start) / apart);
        // Sums of N^2 terms.
        BOOST_TEST(changes.energy <= 32 * unit * n);
        BOOST_TEST(changes.momentum <= 32 * unit * n);
        BOOST_TEST(changes.spectrum <= 32 * unit * n);
        BOOST_TEST(report.found > 1e-3 * by);
        BOOST_TEST(report.newton_steps <= (by > 1e-4 ? 4 : 2));
        // Along the gradients, no other way: it goes no farther than it is off.
        BOOST_TEST(norm(w - start) <= 2 * apart);
        // Once there it stays.
        SkewHermitian<> const there = w;
        auto const again = projection.project(levels, w);
        BOOST_TEST(norm(w - there) <= 32 * unit * n * norm(w));
        BOOST_TEST(again.newton_steps <= 1);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(what_is_on_its_levels_is_left_alone) {
  int const n = 12;
  SphereLaplacian const laplacian(n);
  OrbitProjection<> projection(laplacian);
  // A wave, where the directions are dependent; a single degree, where that of the energy is zero; a zonal
  // flow; nothing.
  SphereHarmonics zonal = testing::random_harmonics(n, 1, n - 1);
  zonal.coefficient.rightCols(n - 1).setZero();
  for (SkewHermitian<> const& start :
       {RossbyHaurwitz{}.state(n), random_state(n, 4, 4), matrix_of(zonal), SkewHermitian<>(n)}) {
    SkewHermitian<> w = start;
    auto const report = projection.project(energy_momentum(laplacian, w), w);
    BOOST_TEST(norm(w - start) <= 32 * unit * n * norm(start));
    BOOST_TEST(report.newton_steps <= 1);
  }
}

// With its enstrophy all in the degree 1 a state has the most energy and the most angular momentum.
BOOST_AUTO_TEST_CASE(levels_that_the_orbit_does_not_reach_are_refused) {
  int const n = 8;
  SphereLaplacian const laplacian(n);
  OrbitProjection<> projection(laplacian);
  double const nan = std::numeric_limits<double>::quiet_NaN();
  SkewHermitian<> const start = random_state(n, 1, n - 1, 3);
  EnergyMomentum const levels = energy_momentum(laplacian, start);
  SkewHermitian<> w = start;
  double const most = 0.25 * QuantizedSphere(n).area_element() * inner_product(w, w);
  EnergyMomentum const too_much{2 * most, levels.momentum}, too_fast{levels.energy, 1e3 * levels.momentum};
  for (auto const& bad : {too_much, too_fast}) {
    CHECK_REFUSED(projection.project(bad, w), OutsideDomain);
    BOOST_TEST(norm(w - start) == 0);
  }
  for (auto const& bad : {EnergyMomentum{nan, levels.momentum}, {levels.energy, {0, nan, 0}}})
    CHECK_REFUSED(projection.project(bad, w), NotFinite);
  w.real(1, 2) = nan;
  CHECK_REFUSED(projection.project(levels, w), NotFinite);
  SkewHermitian<> zero(n);
  CHECK_REFUSED(projection.project(levels, zero), OutsideDomain);
}

// Newton's iteration with shorter steps, from states that a conjugation of the size of one has moved.
BOOST_AUTO_TEST_CASE(levels_are_reached_from_afar) {
  int const n = 8;
  SphereLaplacian const laplacian(n);
  OrbitProjection<> projection(laplacian);
  for (unsigned seed : {1u, 2u, 3u, 4u}) {
    SkewHermitian<> const start = random_state(n, 1, n - 1, 5);
    SkewHermitian<> w = moved_along_orbit(start, 0.5, seed);
    BOOST_TEST(norm(w - start) > 0.1 * norm(start));
    Eigen::VectorXd const values = vorticity_values(w);
    auto const report = projection.project(energy_momentum(laplacian, start), w);
    testing::Changes const changes = Invariants(laplacian, w) - Invariants(laplacian, start);
    BOOST_TEST_MESSAGE("from " << report.found << ": " << report.newton_steps << " Newton steps");
    BOOST_TEST(changes.energy <= 32 * unit * n);
    BOOST_TEST(changes.momentum <= 32 * unit * n);
    // Each of the conjugations rounds.
    BOOST_TEST((vorticity_values(w) - values).cwiseAbs().maxCoeff() <=
               8 * unit * n * report.newton_steps * values.cwiseAbs().maxCoeff());
    BOOST_TEST(report.newton_steps <= 20);
  }
}

// W, and energies with its square: a power of two is exact.
BOOST_AUTO_TEST_CASE(the_unit_changes_no_digit_of_a_projection) {
  int const n = 10;
  SphereLaplacian const laplacian(n);
  OrbitProjection<> projection(laplacian);
  SkewHermitian<> const start = random_state(n, 1, n - 1, 5), moved = moved_along_orbit(start, 1e-2, 8);
  EnergyMomentum const levels = energy_momentum(laplacian, start);
  SkewHermitian<> w = moved;
  int const steps = projection.project(levels, w).newton_steps;
  for (double scale : {0x1p-120, 0x1p120}) {
    SkewHermitian<> scaled = scale * moved;
    auto const report = projection.project({scale * scale * levels.energy, scale * levels.momentum}, scaled);
    BOOST_TEST((scaled.real == scale * w.real && scaled.imaginary == scale * w.imaginary));
    BOOST_TEST(report.newton_steps == steps);
  }
}

// A constant has one state on its orbit, without energy and angular momentum.
BOOST_AUTO_TEST_CASE(a_refusal_tells_by_how_much_the_levels_are_missed) {
  int const n = 9;
  QuantizedSphere const sphere(n);
  SphereLaplacian const laplacian(n);
  OrbitProjection<> projection(laplacian);
  SkewHermitian<> constant(n);
  constant.imaginary.diagonal().setConstant(-3);
  Eigen::Vector3d const momentum(0.2, -0.3, 0.6);
  auto const error = caught<OutsideDomain>([&] { projection.project({0, momentum}, constant); });
  // <iS_j, W>/|S_j|, with |S_j|^2 = N(N^2 - 1)/12, and |W| = 3 sqrt(N).
  double const missed =
      0.7 / (sphere.area_element() * sphere.hbar()) / std::sqrt(n * (n * n - 1) / 12.0) / (3 * std::sqrt(n));
  BOOST_TEST(std::abs(error.measured / missed - 1) <= 1e-14);
  BOOST_TEST(error.bound == 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()
