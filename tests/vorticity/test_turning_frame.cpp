// Finite rotations of matrices, held to those of functions; and the frame in which a flow is calmest.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "flows.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::random_harmonics, testing::random_state;

namespace {

using std::cos, std::sin, std::sqrt;

/// \f$d^l_{m'm}(\beta)\f$ for l = 1, rows m' = 1, 0, -1, columns m = 1, 0, -1 (Condon and Shortley).
Eigen::Matrix3d small_d_1(double b) {
  double const c = cos(b), s = sin(b) / sqrt(2.0);
  Eigen::Matrix3d d;
  d << (1 + c) / 2, -s, (1 - c) / 2, s, c, -s, (1 - c) / 2, s, (1 + c) / 2;
  return d;
}
/// The same for l = 2, m = 2, 1, 0, -1, -2.
Eigen::Matrix<double, 5, 5> small_d_2(double b) {
  double const c = cos(b), s = sin(b), p = (1 + c) / 2, q = (1 - c) / 2, r = sqrt(3.0 / 8) * s * s,
               t = sqrt(1.5) * s * c;
  Eigen::Matrix<double, 5, 5> d;
  d << p * p, -s * p, r, -s * q, q * q, s * p, p * (2 * c - 1), -t, q * (2 * c + 1), -s * q, r, t,
      (3 * c * c - 1) / 2, -t, r, s * q, q * (2 * c + 1), t, p * (2 * c - 1), -s * p, q * q, s * q, r, s * p,
      p * p;
  return d;
}

/// All m of a degree, from l down to -l.
Eigen::VectorXcd all_orders(SphereHarmonics const& f, int l) {
  Eigen::VectorXcd all(2 * l + 1);
  for (int m = 0; m <= l; ++m) {
    all[l - m] = f(l, m);
    all[l + m] = (m % 2 == 0 ? 1.0 : -1.0) * std::conj(f(l, m));
  }
  return all;
}

/// \f$iX_jX_k\f$ summed with a symmetric matrix: the function \f$x\cdot Qx\f$.
SkewHermitian<> quadratic(QuantizedSphere const& sphere, Eigen::Matrix3d const& q) {
  ComplexMatrix<> sum = ComplexMatrix<>::Zero(sphere.n, sphere.n);
  for (int j = 0; j < 3; ++j)
    for (int k = 0; k < 3; ++k)
      sum += q(j, k) * sphere.hbar() * sphere.hbar() * sphere.spin(j) * sphere.spin(k);
  return SkewHermitian<>(ComplexMatrix<>(std::complex<double>(0, 1) * sum));
}

/// About a unit vector, by the formula of Rodrigues.
Eigen::Matrix3d rotation(Eigen::Vector3d const& e, double angle) {
  Eigen::Matrix3d hat;
  hat << 0, -e[2], e[1], e[2], 0, -e[0], -e[1], e[0], 0;
  return Eigen::Matrix3d::Identity() + sin(angle) * hat + (1 - cos(angle)) * hat * hat;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(turning_frame)

// Rounding of N terms in two products.
BOOST_AUTO_TEST_CASE(harmonics_turn_by_the_matrices_of_wigner) {
  for (int n : {3, 4, 24})
    for (double angle : {0.4, -1.3, 3.0}) {
      SphereHarmonics const f = random_harmonics(n, 0, n - 1);
      QuantizedSphere const sphere(n);
      SphereHarmonics const g = harmonics_of(Turning(sphere, Eigen::Vector3d::UnitY())(angle, matrix_of(f)));
      double const bound = 2e-15 * n;
      Eigen::VectorXcd const one = small_d_1(angle) * all_orders(f, 1),
                             two = small_d_2(angle) * all_orders(f, 2);
      BOOST_TEST((all_orders(g, 1) - one).norm() <= bound);
      BOOST_TEST((all_orders(g, 2) - two).norm() <= bound);
      Eigen::VectorXcd const back = small_d_2(-angle) * all_orders(f, 2);
      BOOST_TEST((all_orders(g, 2) - back).norm() > 0.1);
      // About the pole the orders get phases.
      SphereHarmonics const h = harmonics_of(Turning(sphere, Eigen::Vector3d::UnitZ())(angle, matrix_of(f)));
      for (int l = 0; l < n; ++l)
        for (int m = 0; m <= l; ++m)
          BOOST_TEST(std::abs(h(l, m) - std::polar(1.0, -m * angle) * f(l, m)) <= bound);
    }
}

BOOST_AUTO_TEST_CASE(about_any_axis_functions_turn_with_their_arguments) {
  Eigen::Matrix3d q;
  q << 1, 0.3, -0.2, 0.3, -2, 0.7, -0.2, 0.7, 0.4;
  for (int n : {2, 3, 30}) {
    QuantizedSphere const sphere(n);
    for (Eigen::Vector3d const& tip : {Eigen::Vector3d(1, -2, 0.5), Eigen::Vector3d(-1, 0, 0),
                                       Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(1e-9, 0, 1)}) {
      Eigen::Vector3d const axis = tip.normalized();
      Turning const turning(sphere, axis);
      for (double angle : {0.0, 0.9, -2.5}) {
        Eigen::Matrix3d const r = rotation(axis, angle);
        SkewHermitian<> const found = turning(angle, quadratic(sphere, q));
        BOOST_TEST(norm(found - quadratic(sphere, r * q * r.transpose())) <= 2e-15 * n * norm(found));
        if (angle != 0 && n > 2)
          BOOST_TEST(norm(found - quadratic(sphere, r.transpose() * q * r)) > 0.1 * norm(found));
        SkewHermitian<> const w = random_state(n, 1, n - 1);
        BOOST_TEST((sphere_momentum(turning(angle, w)) - r * sphere_momentum(w)).norm() <= 4e-15 * n);
        BOOST_TEST(norm(turning(-angle, turning(angle, w)) - w) <= 2e-15 * n * norm(w));
        BOOST_TEST(norm(turning(2 * angle, w) - turning(angle, turning(angle, w))) <= 4e-15 * n * norm(w));
      }
    }
  }
}

// d/d angle of the turned matrix at 0 is -[i e.S, W]: what the frame takes from P.
BOOST_AUTO_TEST_CASE(generators_are_the_derivatives_of_rotations) {
  int const n = 12;
  QuantizedSphere const sphere(n);
  SkewHermitian<> const w = random_state(n, 1, n - 1);
  TurningFrame const frame{Eigen::Vector3d(0.6, 0, 0.8), 1.7};
  BOOST_TEST(norm(frame.turn(sphere, w) - commutator(frame.generator(sphere), w)) <= 1e-14 * n * norm(w));
  Turning const turning(sphere, frame.axis);
  std::vector<double> steps, errors;
  for (double h = 0.02; h > 1e-3; h /= 2) {
    SkewHermitian<> const rate = (1 / (2 * h)) * (turning(h, w) - turning(-h, w));
    steps.push_back(h), errors.push_back(norm(rate + frame.turn(sphere, w)));
  }
  auto const line = testing::order_of(steps, errors);
  BOOST_TEST(std::abs(line.slope - 2) <= 0.05);
}

BOOST_AUTO_TEST_CASE(the_calmest_frame_of_a_wave_turns_with_it) {
  for (int n : {6, 32}) {
    QuantizedSphere const sphere(n);
    SphereLaplacian const laplacian(n);
    testing::RossbyHaurwitz const wave;
    TurningFrame const frame = calmest_frame(sphere, laplacian, wave.state(n));
    BOOST_TEST((frame.axis - Eigen::Vector3d::UnitZ()).norm() == 0);
    BOOST_TEST(std::abs(frame.rate / wave.rate() - 1) <= 1e-15 * n * n);
    // Turned with the sphere the axis turns, and the rate is the same.
    Eigen::Vector3d const axis = Eigen::Vector3d(1, 2, -1).normalized();
    SkewHermitian<> const tilted = Turning(sphere, axis)(0.8, wave.state(n));
    TurningFrame const other = calmest_frame(sphere, laplacian, tilted);
    BOOST_TEST((other.axis - rotation(axis, 0.8).col(2)).norm() <= 1e-15 * n * n);
    BOOST_TEST(std::abs(other.rate / wave.rate() - 1) <= 1e-15 * n * n);
  }
}

BOOST_AUTO_TEST_CASE(no_other_rate_is_calmer) {
  int const n = 20;
  QuantizedSphere const sphere(n);
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const w = random_state(n, 1, n - 1);
  TurningFrame const frame = calmest_frame(sphere, laplacian, w);
  auto const moves = [&](double rate) {
    return norm(commutator(laplacian.solve(w) + (rate * sphere.hbar()) * frame.generator(sphere), w));
  };
  double const least = moves(frame.rate);
  for (double by : {1e-3, 1e-2, 0.1}) {
    BOOST_TEST(moves(frame.rate * (1 + by)) > least);
    BOOST_TEST(moves(frame.rate * (1 - by)) > least);
  }
}

BOOST_AUTO_TEST_CASE(where_there_is_no_angular_momentum_nothing_turns) {
  for (int n : {3, 16}) {
    QuantizedSphere const sphere(n);
    SphereLaplacian const laplacian(n);
    BOOST_TEST(calmest_frame(sphere, laplacian, random_state(n, 2, n - 1)).rate == 0);
    BOOST_TEST(calmest_frame(sphere, laplacian, SkewHermitian<>(n)).rate == 0);
    BOOST_TEST((calmest_frame(sphere, laplacian, SkewHermitian<>(n)).axis == Eigen::Vector3d::UnitZ()));
    // A rotation alone is at rest in every frame about its axis.
    BOOST_TEST(calmest_frame(sphere, laplacian, random_state(n, 1, 1)).rate == 0);
  }
}

// By the sums of N terms that a moment is, up to N/2 sqrt(N) of |W|: what is within their rounding is none.
BOOST_AUTO_TEST_CASE(an_angular_momentum_within_rounding_turns_no_frame) {
  int const n = 25;
  QuantizedSphere const sphere(n);
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const rest = random_state(n, 2, n - 1, 3);
  Eigen::Vector3d const axis(0.6, 0, 0.8);
  for (double unit : {0x1p-50, 1.0, 0x1p50})
    for (double part : {0.1, 10.0}) {
      SkewHermitian<> w = rest;
      double const bound = 1e-13 * norm(rest) * 125;  // N^(3/2)
      add_spin(sphere, part * bound / sphere.spin_square() * axis, w);
      TurningFrame const frame = calmest_frame(sphere, laplacian, unit * w);
      BOOST_TEST((frame.rate != 0) == (part > 1));
      if (part > 1) BOOST_TEST((frame.axis - axis).norm() <= 0.1);
    }
}

// Along a coordinate axis it is that axis, to the last digit, and the rate goes with the unit of W.
BOOST_AUTO_TEST_CASE(the_axis_of_a_frame_is_that_of_the_angular_momentum) {
  int const n = 10;
  QuantizedSphere const sphere(n);
  SphereLaplacian const laplacian(n);
  testing::RossbyHaurwitz const wave;
  for (int j = 0; j < 3; ++j)
    for (double sign : {1.0, -1.0}) {
      Eigen::Vector3d const axis = sign * Eigen::Vector3d::Unit(j);
      SkewHermitian<> w = wave.wave(n);
      add_spin(sphere, wave.rotation * sphere.hbar() * axis, w);
      for (double unit : {0x1p-60, 1.0, 0x1p60}) {
        TurningFrame const frame = calmest_frame(sphere, laplacian, unit * w);
        BOOST_TEST((frame.axis == axis));
        BOOST_TEST(std::abs(frame.rate / (unit * wave.rate()) - 1) <= 1e-15 * n * n);
      }
    }
  // A function of the first degree is added as the combination of the spin matrices.
  SkewHermitian<> const before = random_state(n, 1, n - 1);
  SkewHermitian<> sum = before;
  Eigen::Vector3d const e(0.3, -0.7, 0.2);
  add_spin(sphere, e, sum);
  BOOST_TEST(norm(sum - before - TurningFrame{e, 0}.generator(sphere)) <= 1e-15 * n * norm(sum));
}

BOOST_AUTO_TEST_SUITE_END()
