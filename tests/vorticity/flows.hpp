// States of the fluid on the sphere for the tests, and what is measured of them.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <random>
#include <vector>

#include "actio/quantized_sphere/laplacian.hpp"
#include "actio/quantized_sphere/sphere_invariants.hpp"

namespace actio::testing {

/// A random state of the degrees from .. to, the same for a seed. Each degree has the same size.
inline sphere::SphereHarmonics random_harmonics(int n, int from, int to, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  sphere::SphereHarmonics f(n);
  for (int l = from; l <= to; ++l) {
    for (int m = 0; m <= l; ++m) {
      double const real = normal(random), imaginary = normal(random);
      f(l, m) = {real, m > 0 ? imaginary : 0};
    }
    f.coefficient.row(l) /= std::sqrt(f.power(l));
  }
  return f;
}
inline sphere::SkewHermitian<> random_state(int n, int from, int to, unsigned seed = 1) {
  return sphere::matrix_of(random_harmonics(n, from, to, seed));
}
/// A state whose orders are multiples of `fold`.
inline sphere::SkewHermitian<> symmetric_state(int n, int fold, unsigned seed = 5) {
  sphere::SphereHarmonics f = random_harmonics(n, 1, n - 1, seed);
  for (int m = 0; m < n; ++m)
    if (m % fold != 0) f.coefficient.col(m).setZero();
  return sphere::matrix_of(f);
}
/// All of u(N), the trace included.
inline sphere::SkewHermitian<> random_matrix(int n, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  sphere::SkewHermitian<> w(n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) w.real(i, j) = normal(random), w.imaginary(i, j) = normal(random);
  return sphere::SkewHermitian<>(w.complex());
}
/// What is farther than this from the diagonal becomes zero.
inline sphere::SkewHermitian<> banded(sphere::SkewHermitian<> w, Eigen::Index reach) {
  for (Eigen::Index c = 0; c < w.size(); ++c)
    for (Eigen::Index r = 0; r < w.size(); ++r)
      if (std::abs(r - c) > reach) w.real(r, c) = w.imaginary(r, c) = 0;
  return w;
}

/// A Rossby-Haurwitz wave: a rotation about the pole and harmonics of one degree.
struct RossbyHaurwitz {
  int degree = 5;
  double rotation = 0.7;  ///< a of the vorticity a cos(theta)
  unsigned seed = 3;

  sphere::SkewHermitian<> wave(int n) const { return random_state(n, degree, degree, seed); }
  sphere::SkewHermitian<> state(int n) const {
    return sphere::planetary_vorticity(sphere::QuantizedSphere(n), rotation / 2) + wave(n);
  }
  /// The rate at which the wave turns about the pole: that of the continuum, at every N.
  double rate() const { return rotation * (0.5 - 1.0 / (degree * (degree + 1))); }
  sphere::SkewHermitian<> after(int n, double time) const {
    sphere::QuantizedSphere const sphere(n);
    return sphere::planetary_vorticity(sphere, rotation / 2) +
           sphere::Turning(sphere, Eigen::Vector3d::UnitZ())(rate() * time, wave(n));
  }
};

/// How far the invariants of a state are from those of another, each relative to its size.
struct Changes {
  double energy, momentum, spectrum;
};

/// The invariants of a state.
struct Invariants {
  double energy;
  Eigen::Vector3d momentum;
  Eigen::VectorXd values;
  double size;  ///< |W|

  template <class Stream>
  Invariants(Stream const& stream, sphere::SkewHermitian<> const& w)
      : energy(sphere::vorticity_energy(stream, w)),
        momentum(sphere::sphere_momentum(w)),
        values(sphere::vorticity_values(w)),
        size(sphere::norm(w)) {}
  /// Momentum relative to that of a state of the same enstrophy that is all of degree 1.
  Changes operator-(Invariants const& start) const {
    double const n = static_cast<double>(values.size()), most = 4 * M_PI / n * start.size * std::sqrt(n / 3);
    return {std::abs(energy / start.energy - 1), (momentum - start.momentum).norm() / most,
            (values - start.values).cwiseAbs().maxCoeff() / start.values.cwiseAbs().maxCoeff()};
  }
};

/// The slope of a straight line through points, by least squares, and its standard error.
struct Line {
  double slope = 0, error = 0;
};
inline Line line_through(std::vector<double> const& x, std::vector<double> const& y) {
  auto const count = static_cast<double>(x.size());
  double mx = 0, my = 0, xx = 0, xy = 0, rest = 0;
  for (std::size_t k = 0; k < x.size(); ++k) mx += x[k] / count, my += y[k] / count;
  for (std::size_t k = 0; k < x.size(); ++k) xx += (x[k] - mx) * (x[k] - mx), xy += (x[k] - mx) * (y[k] - my);
  Line line{xy / xx, 0};
  for (std::size_t k = 0; k < x.size(); ++k) rest += std::pow(y[k] - my - line.slope * (x[k] - mx), 2);
  line.error = std::sqrt(rest / (count - 2) / xx);
  return line;
}
/// The order in h of errors, and its standard error.
inline Line order_of(std::vector<double> steps, std::vector<double> errors) {
  for (double& h : steps) h = std::log(h);
  for (double& e : errors) e = std::log(e);
  return line_through(steps, errors);
}

}  // namespace actio::testing
