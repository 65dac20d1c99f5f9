#include <Eigen/Core>

#include "program/systems/sphere/states.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace actio::scene {
namespace {

constexpr double pi = std::numbers::pi;

/// \f$\bar P_{lm}\f$, l = m .. N - 1, with \f$Y_{lm} = \bar P_{lm}e^{im\varphi}\f$. In long double, since the
/// first of them are as small as \f$\sin^m\f$ of the colatitude.
class LegendreColumn {
 public:
  explicit LegendreColumn(int n) : n_(n) {}

  /// Calls `use(l, m, value)` for all m up to `most` and all l.
  template <class Use>
  void over(double sine_of_latitude, double cosine_of_latitude, int most, Use const& use) {
    long double const x = sine_of_latitude, s = cosine_of_latitude;
    long double top = std::sqrt(1 / (4 * std::numbers::pi_v<long double>));
    for (int m = 0; m <= most && m < n_; ++m) {
      if (m > 0) top *= -s * std::sqrt((2.0L * m + 1) / (2.0L * m));
      long double before = 0, now = top;
      for (int l = m; l < n_; ++l) {
        use(l, m, static_cast<double>(now));
        long double const next = (x * now - a(l, m) * before) / a(l + 1, m);
        before = now, now = next;
      }
    }
  }

 private:
  /// \f$\cos\theta\,Y_{lm} = a_{l+1}Y_{l+1,m} + a_lY_{l-1,m}\f$.
  static long double a(int l, int m) {
    long double const ll = l, mm = m;
    return std::sqrt((ll - mm) * (ll + mm) / ((2 * ll - 1) * (2 * ll + 1)));
  }
  int n_;
};

/// \f$2\pi\int e^{-(1-t)/w^2}P_l(t)\,dt = 4\pi e^{-\kappa}i_l(\kappa)\f$ with the modified spherical Bessel
/// functions and \f$\kappa = 1/w^2\f$: from their ratios, by the recurrence downwards.
std::vector<double> blob_profile(int n, double width) {
  double const kappa = 1 / (width * width);
  double const reach = std::min(1e7, n + 50 + 12 * std::sqrt(kappa));
  std::vector<double> profile(static_cast<std::size_t>(n));
  double ratio = 0;
  for (int l = static_cast<int>(reach); l > 0; --l) {
    ratio = 1 / ((2.0 * l + 1) / kappa + ratio);
    if (l < n) profile[static_cast<std::size_t>(l)] = ratio;
  }
  profile[0] = -std::expm1(-2 * kappa) / kappa * 2 * pi;
  for (std::size_t l = 1; l < profile.size(); ++l) profile[l] *= profile[l - 1];
  return profile;
}

}  // namespace

sphere::SphereHarmonics zonal_jet(int n, ZonalJet const& jet) {
  sphere::SphereHarmonics f(n);
  LegendreColumn legendre(n);
  // The rule of equal weights, which for functions that vanish at both ends with all their derivatives has no
  // order: its error falls faster than any power.
  double const width = jet.north - jet.south;
  int const nodes = 4 * n + 2000;
  double const between = width / nodes;
  for (int k = 1; k < nodes; ++k) {
    double const phi = jet.south + k * between, bump = (phi - jet.south) * (phi - jet.north);
    double const speed = jet.speed * std::exp(4 / (width * width) + 1 / bump), x = std::sin(phi),
                 c = std::cos(phi);
    // f_l0 = 2 pi int u cos(phi) d/dphi Y_l0, by parts; (1 - x^2) dP_l/dx = l (P_{l-1}/a - x P_l) in the
    // normalisation.
    double before = 0;
    legendre.over(x, c, 0, [&](int l, int, double value) {
      double const scaled = std::sqrt((2.0 * l + 1) / std::max(1.0, 2.0 * l - 1)) * before;
      f(l, 0) += 2 * pi * between * speed * l * (scaled - x * value);
      before = value;
    });
  }
  if (jet.perturbation != 0) {
    constexpr double alpha = 1.0 / 3, beta = 1.0 / 15, centre = pi / 4, reach = 6.2 * beta;
    int const rows = 2 * n + 400, most = std::min(n - 1, 37);
    double const apart = 2 * reach / rows;
    for (int k = 0; k <= rows; ++k) {
      double const phi = centre - reach + k * apart, y = (phi - centre) / beta;
      double const part = jet.perturbation * std::cos(phi) * std::exp(-y * y) * std::cos(phi) * apart;
      legendre.over(std::sin(phi), std::cos(phi), most, [&](int l, int m, double value) {
        // The integral over the longitude of exp(-(lambda/alpha)^2) e^(-im lambda), whose tail is 1e-38.
        f(l, m) += part * value * alpha * std::sqrt(pi) * std::exp(-0.25 * alpha * alpha * m * m);
      });
    }
  }
  f(0, 0) = 0;
  return f;
}

sphere::SphereHarmonics blobs(int n, std::vector<Blob> const& blobs) {
  sphere::SphereHarmonics f(n);
  LegendreColumn legendre(n);
  for (auto const& blob : blobs) {
    auto const profile = blob_profile(n, blob.width);
    legendre.over(std::sin(blob.latitude), std::cos(blob.latitude), n - 1, [&](int l, int m, double value) {
      f(l, m) +=
          blob.strength * profile[static_cast<std::size_t>(l)] * std::polar(value, -m * blob.longitude);
    });
  }
  f(0, 0) = 0;
  for (int l = 0; l < n; ++l) f(l, 0) = f(l, 0).real();
  return f;
}

sphere::SkewHermitian<> point_vortices(int n, std::vector<PointVortex> const& vortices) {
  sphere::SkewHermitian<> w(n);
  Eigen::VectorXd modulus(n);
  for (auto const& vortex : vortices) {
    double const half = 0.5 * (pi / 2 - vortex.latitude);
    double const c = std::log(std::max(1e-300, std::cos(half))),
                 s = std::log(std::max(1e-300, std::sin(half)));
    for (int k = 0; k < n; ++k)
      modulus[k] = std::exp(0.5 * (std::lgamma(n) - std::lgamma(k + 1.0) - std::lgamma(n - k)) +
                            (n - 1 - k) * c + k * s);
    modulus.normalize();
    double const scale = vortex.circulation * n / (4 * pi);
    for (int k = 0; k < n; ++k)
      for (int j = k; j < n; ++j) {
        // The entry (k, j) of -iW is scale v_k conj(v_j), v_k with the phase k times the longitude.
        double const size = scale * modulus[k] * modulus[j], angle = (j - k) * vortex.longitude;
        w.imaginary(k, j) += size * std::cos(angle);
        w.real(k, j) += j == k ? 0 : size * std::sin(angle);
      }
  }
  w.imaginary.diagonal().array() -= w.imaginary.diagonal().mean();
  for (int k = 0; k < n; ++k)
    for (int j = k + 1; j < n; ++j) w.imaginary(j, k) = w.imaginary(k, j), w.real(j, k) = -w.real(k, j);
  return w;
}

sphere::SphereHarmonics random_flow(int n, int last, long seed, std::function<double(int l)> const& weight) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  auto const uniform = [&random] { return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53; };
  // Two numbers at once (Box and Muller): the same ones with every library.
  auto const normal = [&uniform] {
    double const size = std::sqrt(-2 * std::log(uniform()));
    return std::polar(size, 2 * pi * uniform());
  };
  sphere::SphereHarmonics f(n);
  for (int l = 1; l <= last; ++l) {
    // (1/2) sum |f_lm|^2/(l (l + 1)) over 2l + 1 numbers.
    double const size = std::sqrt(2 * weight(l) * l * (l + 1.0) / (2.0 * l + 1));
    f(l, 0) = size * normal().real();
    for (int m = 1; m <= l; ++m) f(l, m) = size * std::sqrt(0.5) * normal();
  }
  return f;
}

double wave_4_coefficient(double amplitude) {
  // Y_54 = 945 sqrt(11/(4 pi 9!)) sin cos^4 e^(4 i lambda), and the term of m = -4 is its conjugate.
  return -30 * amplitude / (2 * 945 * std::sqrt(11 / (4 * pi * 362880)));
}

double rotation_coefficient(double rate) { return 2 * rate * std::sqrt(4 * pi / 3); }

}  // namespace actio::scene
