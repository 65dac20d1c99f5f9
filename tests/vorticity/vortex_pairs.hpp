// Two vortices of averaged flow that turn about each other: on matrices, and as points in closed form.
#pragma once

#include <cmath>
#include <complex>

#include "actio/quantized_sphere/averaged_stream.hpp"

namespace actio::testing {

/// Two vortices of the circulation 1 each, at an angle from the pole, on opposite meridians. The rate at
/// which they turn about the pole, in the units of 1/time.
struct VortexPair {
  double angle = 0.5;

  /// As narrow as matrices of the size n have them: each is a coherent state, a function of the size
  /// \f$n^{-1/2}\f$.
  template <class Stream>
  double rate(Stream const& stream) const {
    int const n = stream.size();
    sphere::QuantizedSphere const sphere(n);
    sphere::ComplexMatrix<> const one = vortex(n, 1), both = one + vortex(n, -1);
    std::complex<double> const i(0, 1);
    sphere::SkewHermitian<> const w(sphere::ComplexMatrix<>(i * (n / (4 * M_PI)) * both));
    // One of them moves by [P, .]/hbar; its own part of P commutes with it.
    sphere::ComplexMatrix<> const p = stream.solve(w).complex();
    sphere::ComplexMatrix<> const moves = p * one - one * p;
    return (moves * sphere.spin(1)).trace().real() / (one * sphere.spin(0)).trace().real() / sphere.hbar();
  }
  /// As points. The vorticity of one, without its mean, has the stream function
  /// \f[g=-\frac1{\alpha^2\gamma}\sum_{l\ge1}\frac{2l+1}{4\pi}\Bigl(\frac1{l(l+1)}
  /// -\frac1{l(l+1)+\gamma}\Bigr)\mathsf P_l(x),\f]
  /// with x the cosine of the distance: a logarithm, and the conical function
  /// \f$\pi\,\mathsf P_{-1/2+i\tau}(-x)/\cosh\pi\tau\f$, \f$\tau^2=\gamma-\tfrac14\f$, of Mehler.
  /// @param alpha  zero: Euler's
  double rate_of_points(double alpha, sphere::AveragedMetric metric) const {
    double const x = std::cos(2 * angle), square = alpha * alpha,
                 part = 1 - square * sphere::metric_shift(metric);
    double slope = 1 / (1 - x);
    if (alpha > 0) slope = (slope - conical_slope(std::sqrt(part / square - 0.25))) / part;
    return 2 * std::cos(angle) * slope / (4 * M_PI);
  }

 private:
  /// The coherent state at the longitude 0 or pi, as a projection.
  sphere::ComplexMatrix<> vortex(int n, double sign) const {
    Eigen::VectorXcd v(n);
    double const c = std::log(std::cos(angle / 2)), s = std::log(std::sin(angle / 2));
    for (int k = 0; k < n; ++k)
      v[k] = std::pow(sign, k) * std::exp(0.5 * (std::lgamma(n) - std::lgamma(k + 1) - std::lgamma(n - k)) +
                                          (n - 1 - k) * c + k * s);
    return v * v.adjoint();
  }
  /// Minus the derivative of \f$\pi\,\mathsf P_{-1/2+i\tau}(y)/\cosh\pi\tau\f$ at y = -cos(2 angle), by
  /// Mehler's integral \f$\mathsf P=\tfrac2\pi\int_0^{\pi/2}\cosh(\tau\varphi)/\cos(\varphi/2)\,dt\f$,
  /// \f$\sin(\varphi/2)=s\sin t\f$, \f$y=1-2s^2\f$: its integrand is smooth and periodic, and the trapezoidal
  /// rule converges faster than any power.
  double conical_slope(double tau) const {
    double const s = std::cos(angle);
    int const places = 4000;
    double sum = 0;
    for (int k = 0; k < places; ++k) {
      double const t = M_PI / 2 * (k + 0.5) / places, half = std::asin(s * std::sin(t)), c = std::cos(half),
                   grows = std::sinh(2 * tau * half), cosh = std::cosh(2 * tau * half);
      sum += (tau * grows / c + cosh * std::sin(half) / (2 * c * c)) * (2 * std::sin(t) / c) / places;
    }
    // The integral times 2/pi, by -dy = 4 s ds.
    return M_PI / std::cosh(M_PI * tau) * sum / (4 * s);
  }
};

}  // namespace actio::testing
