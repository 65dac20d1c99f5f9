// An atmosphere that turns about a sphere as a whole, with two metrics of the body, and the fields of labels
// and of space that are tried on it.
//
// The gas has the pressure P = K rho/J^2 of a polytropic gas of exponent 2 and turns with the angular
// velocity Omega. The pressure holds it at its latitudes: the density is 1 + s (1/3 - z^2), z the sine of the
// latitude and s = Omega^2/(4K) (radius 1). Coordinates are z and the longitude l, of sphere and body.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "actio/continuum/continuum.hpp"
#include "actio/continuum/materials.hpp"

// The metric of the sphere, or of a body that has `stretch` dz dl of area laid out on it.
template <class V>
auto sphere_metric(V const& at, typename V::Scalar const& stretch) {
  auto const ring = 1 - at[0] * at[0];
  actio::Matrix<typename V::Scalar, 2, 2> g = actio::Matrix<typename V::Scalar, 2, 2>::Zero();
  g(0, 0) = stretch * stretch / ring;
  g(1, 1) = ring;
  return g;
}
struct Sphere {
  template <class V>
  auto operator()(V const& y) const { return sphere_metric(y, typename V::Scalar(1)); }
};
// Mass density by latitude, 1 + s (1/3 - z^2): mass per area of the sphere.
struct Density {
  double s;
  template <class V>
  auto operator()(V const& x) const { return typename V::Scalar(1 + s * (1.0 / 3 - x[0] * x[0])); }
};
// The metric of the body by mass: its area is the mass of the gas.
struct LaidOut {
  Density density;
  template <class V>
  auto operator()(V const& x) const { return sphere_metric(x, density(x)); }
};
// The gas in the metric by place: its energy K rho(x)/J per mass varies with the particle.
struct PlacedEnergy {
  double K;
  Density density;
  template <class G, class g, class T>
  T operator()(actio::Matrix<T, 2, 1> const& x, G const& body, g const& space,
               actio::Matrix<T, 2, 2> const& F) const {
    return density(x) * K / actio::jacobian(body, space, F);
  }
};
// The motion.
struct Turning {
  double Omega;
  template <class V>
  auto operator()(V const& x) const {
    return actio::Matrix<typename V::Scalar, 2, 1>(x[1], x[2] + x[0] * Omega);
  }
};

// The same gas in two metrics of the body. By mass: area is mass, and the gas is homogeneous. By place: the
// metric of the sphere, in which the mass density varies.
struct Atmosphere {
  double Omega, K;
  double s() const { return Omega * Omega / (4 * K); }
  auto by_mass() const {
    return actio::Continuum{LaidOut{{s()}}, Sphere{}, actio::Homogeneous<double>{1},
                            actio::Barotropic{actio::WholePolytropic<double, 1>{K}}};
  }
  auto by_place() const { return actio::Continuum{Sphere{}, Sphere{}, Density{s()}, PlacedEnergy{K, {s()}}}; }
};
// The latitude's sine south of which (1 + Z)/2 of the mass lies: Z(z) = z (1 + s/3) - s z^3/3.
inline double place_of_mass(double Z, double s) {
  double z = Z;
  for (int i = 0; i < 50; ++i) z -= (z * (1 + s / 3) - s * z * z * z / 3 - Z) / (1 + s / 3 - s * z * z);
  return z;
}

// Places on the unit sphere, and the circle that has this mass south of it.
using Path = std::vector<std::array<double, 3>>;
inline std::array<double, 3> on_sphere(double z, double l) {
  return {std::sqrt(1 - z * z) * std::cos(l), std::sqrt(1 - z * z) * std::sin(l), z};
}
inline Path circle_of_mass(double Z, double s) {
  Path circle;
  for (int i = 0; i <= 120; ++i) circle.push_back(on_sphere(place_of_mass(Z, s), i * std::numbers::pi / 60));
  return circle;
}

// A loop of particles that goes along a latitude in three waves, and its circulation in an atmosphere that
// turns.
struct WavyLatitude {
  double z0, wave;
  template <class T>
  actio::Matrix<T, 2, 1> operator()(T const& a) const {
    using std::sin;
    return {z0 + wave * sin(3 * a), a};
  }
  double circulation(double Omega) const {
    return 2 * std::numbers::pi * Omega * (1 - z0 * z0 - wave * wave / 2);
  }
};

// A stream function that is smooth on the sphere; `zonal` leaves only what depends on the latitude.
struct Stream {
  bool zonal;
  template <class V>
  auto operator()(V const& x) const {
    using std::cos, std::sin, std::sqrt;
    using T = typename V::Scalar;
    T value = x[0] + x[0] * x[0] * x[0];
    if (!zonal) value += sqrt(1 - x[0] * x[0]) * (cos(x[1]) + x[0] * sin(x[1]));
    return actio::Matrix<T, 1, 1>(value);
  }
};
// Rotation of the sphere about its axis (0) or about the horizontal axis at l = 0 (1); 2: both components
// kept where one must change, which is no rotation.
struct Spin {
  int kind;
  template <class V>
  auto operator()(V const& y) const {
    using std::cos, std::sin, std::sqrt;
    using T = typename V::Scalar;
    T const ring = sqrt(1 - y[0] * y[0]);
    if (kind == 0) return actio::Matrix<T, 2, 1>(T(0), T(1));
    if (kind == 1) return actio::Matrix<T, 2, 1>(T(ring * sin(y[1])), T(-y[0] * cos(y[1]) / ring));
    return actio::Matrix<T, 2, 1>(T(ring * sin(y[1])), T(0));
  }
};
