// An atmosphere that turns about a sphere as a whole: an exact motion of a barotropic gas, and the currents of its symmetries.
//
// What is shown. The gas has the pressure P = K rho/J^2 of a polytropic gas of exponent 2 and turns with the angular velocity Omega. The pressure holds it at its latitudes: the density is
// 1 + s (1/3 - z^2), z the sine of the latitude and s = Omega^2/(4K) (radius 1). Labels are chosen so that the mass of the body is its area. Then every stream function has a closed current, every loop of
// particles keeps its circulation, and each rotation of the sphere has a current of angular momentum; with labels by place only the relabellings along latitudes are left.
//
//   z, l   sine of the latitude, longitude         M      speed at the equator over that of sound at rest, M^2 = Omega^2/(2K) = 2 s
//   G      metric of the body: Z'(z) dz dl is mass  g      metric of the sphere
#include <random>

#include "actio/noether/circulation.hpp"
#include "actio/noether/current_divergence.hpp"
#include "actio/noether/isometries.hpp"
#include "actio/noether/relabelling.hpp"
#include "book/plot.hpp"
#include "book/sphere.hpp"

using namespace actio;
using std::numbers::pi;

// The sphere in the coordinates z and l, and the body of mass Z'(z) dz dl that is laid out on it.
template <class V>
auto sphere_metric(V const& at, typename V::Scalar const& stretch) {
  auto const ring = 1 - at[0] * at[0];
  Eigen::Matrix<typename V::Scalar, 2, 2> g = Eigen::Matrix<typename V::Scalar, 2, 2>::Zero();
  g(0, 0) = stretch * stretch / ring;
  g(1, 1) = ring;
  return g;
}
struct Sphere {
  template <class V>
  auto operator()(V const& y) const { return sphere_metric(y, typename V::Scalar(1)); }
};
// Density by latitude, 1 + s (1/3 - z^2): over area.
struct Density {
  double s;
  template <class V>
  auto operator()(V const& x) const { return typename V::Scalar(1 + s * (1.0 / 3 - x[0] * x[0])); }
};
struct LaidOut {
  Density density;
  template <class V>
  auto operator()(V const& x) const { return sphere_metric(x, density(x)); }
};
// The gas by places: its energy K rho(x)/J per mass varies with the label.
struct PlacedEnergy {
  double K;
  Density density;
  template <class G, class g, class T>
  T operator()(Eigen::Matrix<T, 2, 1> const& x, G const& body, g const& space, Eigen::Matrix<T, 2, 2> const& F) const {
    return density(x) * K / jacobian(body, space, F);
  }
};
struct Turning {
  double Omega;
  template <class V>
  auto operator()(V const& x) const {
    return Eigen::Matrix<typename V::Scalar, 2, 1>(x[1], x[2] + x[0] * Omega);
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
    return Eigen::Matrix<T, 1, 1>(value);
  }
};
// Rotation of the sphere about its axis (0) or about the horizontal axis at l = 0 (1); 2: both components kept where one must change, which is no rotation.
struct Spin {
  int kind;
  template <class V>
  auto operator()(V const& y) const {
    using std::cos, std::sin, std::sqrt;
    using T = typename V::Scalar;
    T const ring = sqrt(1 - y[0] * y[0]);
    if (kind == 0) return Eigen::Matrix<T, 2, 1>(T(0), T(1));
    if (kind == 1) return Eigen::Matrix<T, 2, 1>(T(ring * sin(y[1])), T(-y[0] * cos(y[1]) / ring));
    return Eigen::Matrix<T, 2, 1>(T(ring * sin(y[1])), T(0));
  }
};

// The largest value of a function of second jets over points of space-time.
template <class F>
double largest(Turning const& phi, F const& f) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> z(-0.95, 0.95), l(0, 2 * pi), t(0, 10);
  double most = 0;
  for (int i = 0; i < 400; ++i) most = std::max(most, std::abs(f(second_jet(phi, Event<double, 2>(t(random), z(random), l(random))))));
  return most;
}
// The largest divergence of a current over the largest of what its parts are.
template <class Medium, class Xi>
double leak(Medium const& gas, Xi const& xi, Turning const& phi) {
  return largest(phi, [&](auto const& j) { return current_divergence(gas, xi, j); }) /
         largest(phi, [&](auto const& j) { return noether_current(gas, xi, static_cast<Jet<double, 2, 2> const&>(j)).norm(); });
}
// The latitude's sine at which a given part of the mass lies south: Z(z) = z (1 + s/3) - s z^3/3.
double place_of_mass(double Z, double s) {
  double z = Z;
  for (int i = 0; i < 50; ++i) z -= (z * (1 + s / 3) - s * z * z * z / 3 - Z) / (1 + s / 3 - s * z * z);
  return z;
}
std::array<double, 3> on_sphere(double z, double l) { return {std::sqrt(1 - z * z) * std::cos(l), std::sqrt(1 - z * z) * std::sin(l), z}; }

void show_circulation(book::Program& program, Turning const& phi) {
  std::vector<book::Program::Row> rows;
  double worst = 0;
  auto const add = [&](std::string const& name, double z0, double wave) {
    auto const loop = [&](auto const& a) {
      using std::sin;
      using T = std::remove_cvref_t<decltype(a)>;
      return Eigen::Matrix<T, 2, 1>(z0 + wave * sin(3 * a), a);
    };
    double const closed = 2 * pi * phi.Omega * (1 - z0 * z0 - wave * wave / 2);
    double const now = circulation(phi, Sphere{}, loop, 0.0), later = circulation(phi, Sphere{}, loop, 7.0);
    worst = std::max({worst, std::abs(now / closed - 1), std::abs(later / closed - 1)});
    rows.push_back({name, book::number(now, 8), book::number(later, 8), book::number(closed, 8)});
  };
  add("equator", 0, 0);
  add("30 degrees", 0.5, 0);
  add("60 degrees", std::sqrt(0.75), 0);
  add("wave about 30 degrees", 0.5, 0.2);
  program.table("circulation", {"loop of particles", "at t = 0", "at t = 7", "closed form"}, rows, "Circulation along loops of particles: by the trapezoidal rule with 64 points, and in closed form.");
  program.figure("circulation_error", worst, "largest relative error of a circulation");
  program.claim(worst < 1e-13, "circulations are constant and have their closed forms");
}

void draw_profile(book::Program& program) {
  std::vector<double> latitude;
  for (double d = -90; d <= 90; d += 1.5) latitude.push_back(d);
  auto plot = book::Plot("latitude, degrees", "density over its mean");
  for (double const M : {0.0, 0.8, 1.2, 1.6}) {
    std::vector<double> density;
    for (double const d : latitude) density.push_back(Density{M * M / 2}(Eigen::Vector2d(std::sin(d * pi / 180), 0)));
    plot.curve(latitude, density, "M = " + book::number(M));
  }
  program.picture("profile", plot.svg(), "Density by latitude of an atmosphere that turns as a whole, M times as fast at the equator as sound.");
}

void draw_sphere(book::Program& program) {
  auto sphere = book::Sphere(20, 24).axes({"", "", "N"});
  for (double const M : {0.0, 1.6})
    for (double const Z : {-std::sqrt(0.75), -0.5, 0.5, std::sqrt(0.75)}) {
      std::vector<std::array<double, 3>> circle;
      for (int i = 0; i <= 120; ++i) circle.push_back(on_sphere(place_of_mass(Z, M * M / 2), i * pi / 60));
      sphere.curve(circle, Z > 0.6 ? (M == 0 ? "a quarter and 7 % of the mass towards the pole, at rest" : "the same, M = 1.6") : "", {.colour = M == 0 ? 6 : 2, .width = 1.6, .dashed = M == 0});
    }
  for (double const turned : {0.0, 1.2}) {
    std::vector<std::array<double, 3>> loop;
    for (int i = 0; i < 60; ++i) loop.push_back(on_sphere(0.05 + 0.22 * std::sin(i * pi / 30), -0.6 + turned + 0.35 * std::cos(i * pi / 30)));
    sphere.dots(loop, turned == 0 ? "a loop of particles" : "the same loop later", {.colour = turned == 0 ? 1 : 3, .radius = 2});
  }
  program.picture("sphere", sphere.svg(), "Circles that hold the same mass at rest and at M = 1.6, and a loop of particles that is carried along.");
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "an atmosphere that turns about a sphere: an exact motion, and the currents of its symmetries");

  // 1. The gas with labels by mass, and the same gas with labels by place.
  double const M = 1.2, s = M * M / 2, K = 0.5;
  Turning const phi{M};
  Continuum const by_mass{LaidOut{{s}}, Sphere{}, Homogeneous<double>{1}, Barotropic{WholePolytropic<double, 1>{K}}};
  Continuum const by_place{Sphere{}, Sphere{}, Density{s}, PlacedEnergy{K, {s}}};
  double const field = std::max(largest(phi, [&](auto const& j) { return euler_lagrange(by_mass, j).norm(); }), largest(phi, [&](auto const& j) { return euler_lagrange(by_place, j).norm(); }));
  program.figure("field_equations", field, "largest remainder of the field equations at 400 points");

  // 2. The currents.
  auto const by = [&](auto const& G, bool zonal) { return relabelling_field<2>(RelabellingField{G, Stream{zonal}}); };
  auto const spin = [](int kind) { return motion_of_space<2>(Spin{kind}); };
  double const all = leak(by_mass, by(by_mass.G, false), phi), zonal = leak(by_place, by(by_place.G, true), phi), broken = leak(by_place, by(by_place.G, false), phi);
  double const axis = leak(by_mass, spin(0), phi), across = leak(by_mass, spin(1), phi), no_rotation = leak(by_mass, spin(2), phi);
  program.table("currents", {"field", "labels", "divergence over current"},
                {{"any stream function", "by mass", book::number(all)},
                 {"stream function of the latitude", "by place", book::number(zonal)},
                 {"any stream function", "by place", book::number(broken)},
                 {"rotation about the axis", "by mass", book::number(axis)},
                 {"rotation about a horizontal axis", "by mass", book::number(across)},
                 {"a field that is not Killing", "by mass", book::number(no_rotation)}},
                "Largest divergence of a current at 400 points of space-time, over its largest size.");
  program.figure("broken", broken, "the relabelling current where the density of the labels varies");
  program.figure("emptying", std::sqrt(3.0), "M at which the poles are empty");
  double const closed = std::max({all, zonal, axis, across});
  program.figure("closed", closed, "largest divergence of the currents that are closed");

  // 3. Loops and pictures.
  show_circulation(program, phi);
  draw_profile(program);
  draw_sphere(program);

  program.claim(field < 1e-11, "the motion is exact");
  program.claim(closed < 1e-11, "the currents of the symmetries are closed");
  program.claim(broken > 1e-3 && no_rotation > 1e-3, "and those of fields that are no symmetries are not");
  program.headline("currents closed to " + book::number(closed, 2), closed);
  return program.finish();
}
