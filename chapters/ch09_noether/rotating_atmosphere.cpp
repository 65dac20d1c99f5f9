// An atmosphere that turns about a sphere as a whole: an exact motion of a barotropic gas, and the currents
// of its symmetries.
//
// What is shown. The body has the metric by mass, whose area is the mass of the gas. Then every stream
// function has a closed current, every loop of particles keeps its circulation, and each rotation of the
// sphere has a current of angular momentum. In the metric by place, that of the sphere, a field that
// preserves areas of the body has a closed current only if it runs along latitudes, and every field that
// preserves masses has one. Read first. atmosphere.hpp, the gas and its motion.
//
//   z, l   sine of the latitude, longitude
//   M      speed at the equator over that of sound at rest, M^2 = Omega^2/(2K) = 2 s
//   Z      coordinate by mass: the part (1 + Z)/2 of the mass lies south of z
#include <random>

#include "actio/noether/circulation.hpp"
#include "actio/noether/current_divergence.hpp"
#include "actio/noether/isometries.hpp"
#include "actio/noether/relabelling.hpp"
#include "atmosphere.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"
#include "book/sphere.hpp"

using namespace actio;
using book::number;
using std::numbers::pi;

// 1. The gas with Omega = 1.2 and K = 1/2, so that M is Omega, and its motion; the
// largest value of a function of second jets; the residual of the field equations.
Atmosphere const air{1.2, 0.5};
Turning const phi{air.Omega};

template <class F>
double largest(F const& f) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> z(-0.95, 0.95), l(0, 2 * pi), t(0, 10);
  double most = 0;
  for (int i = 0; i < 400; ++i)
    most = std::max(most, std::abs(f(second_jet(phi, Event<double, 2>(t(random), z(random), l(random))))));
  return most;
}

template <class Medium>
double residual_of(Medium const& gas) {
  return largest([&](auto const& j) { return euler_lagrange(gas, j).norm(); });
}

// 2. The currents: the largest divergence of a current over its largest size.
template <class Medium, class Xi>
double leak(Medium const& gas, Xi const& xi) {
  auto const divergence = [&](auto const& j) { return current_divergence(gas, xi, j); };
  auto const size = [&](Jet<double, 2, 2> const& j) { return noether_current(gas, xi, j).norm(); };
  return largest(divergence) / largest(size);
}
template <class Medium>
double leak_of_stream(Medium const& gas, bool zonal) {
  return leak(gas, relabelling_field<2>(RelabellingField{gas.G, Stream{zonal}}));
}
double leak_where_masses_stay() {
  auto const masses = LaidOut{{air.s()}};
  return leak(air.by_place(), relabelling_field<2>(RelabellingField{masses, Stream{false}}));
}
double leak_of_spin(int kind) { return leak(air.by_mass(), motion_of_space<2>(Spin{kind})); }
// The result is the largest of those that should vanish and the smallest of those that should not.
std::pair<double, double> show_currents(book::Program& program) {
  double const all = leak_of_stream(air.by_mass(), false);
  double const zonal = leak_of_stream(air.by_place(), true);
  double const broken = leak_of_stream(air.by_place(), false);
  double const masses = leak_where_masses_stay();
  double const axis = leak_of_spin(0), across = leak_of_spin(1), no_rotation = leak_of_spin(2);
  double const closed = std::max({all, zonal, masses, axis, across});
  program.table("currents", {"field", "metric of the body", "divergence over current"},
                {{"any stream function", "by mass", number(all)},
                 {"stream function of the latitude", "by place", number(zonal)},
                 {"any stream function", "by place", number(broken)},
                 {"any stream function, masses preserved", "by place", number(masses)},
                 {"rotation about the axis", "by mass", number(axis)},
                 {"rotation about a horizontal axis", "by mass", number(across)},
                 {"a field that is not Killing", "by mass", number(no_rotation)}},
                "Largest divergence of a current at 400 points of space-time, over its largest size.");
  program.figure("broken", broken,
                 "the relabelling current where the mass density varies from particle to particle");
  // The density at a pole is linear in s = M^2/2.
  Matrix<double, 1, 1> const pole(1.0);
  program.figure("emptying", std::sqrt(2 / (1 - Density{1}(pole))), "M at which the poles are empty");
  program.figure("closed", closed, "largest divergence of the currents that are closed");
  return {closed, std::min(broken, no_rotation)};
}

// 3. Loops of particles and their circulation, at two times and in closed form.
void show_circulation(book::Program& program) {
  std::vector<book::Program::Row> rows;
  double worst = 0;
  auto const add = [&](std::string const& name, double z0, double wave) {
    WavyLatitude const loop{z0, wave};
    double const closed = loop.circulation(phi.Omega);
    double const now = circulation(phi, Sphere{}, loop, 0.0), later = circulation(phi, Sphere{}, loop, 7.0);
    worst = std::max({worst, std::abs(now / closed - 1), std::abs(later / closed - 1)});
    rows.push_back({name, number(now, 8), number(later, 8), number(closed, 8)});
  };
  add("equator", 0, 0);
  add("30 degrees", 0.5, 0);
  add("60 degrees", std::sqrt(0.75), 0);
  add("wave about 30 degrees", 0.5, 0.2);
  program.table(
      "circulation", {"loop of particles", "at t = 0", "at t = 7", "closed form"}, rows,
      "Circulation along loops of particles: by the trapezoidal rule with 64 points, and in closed form.");
  program.figure("circulation_error", worst, "largest relative error of a circulation");
  program.claim(book::measured(worst) < 1e-13, "circulations are constant and have their closed forms");
}

// 4. Pictures: density by latitude; circles of equal mass and a loop of particles.
std::string profile() {
  std::vector<double> latitude;
  for (double d = -90; d <= 90; d += 1.5) latitude.push_back(d);
  auto plot = book::Plot("latitude, degrees", "density over its mean");
  for (double const M : {0.0, 0.8, 1.2, 1.6}) {
    std::vector<double> density;
    for (double const d : latitude)
      density.push_back(Density{M * M / 2}(Vector<double, 2>(std::sin(d * pi / 180), 0)));
    plot.curve(latitude, density, "M = " + number(M));
  }
  return plot.svg();
}
std::string sphere() {
  auto sphere = book::Sphere(20, 24).axes({"", "", "N"});
  for (double const M : {0.0, 1.6})
    for (double const Z : {-std::sqrt(0.75), -0.5, 0.5, std::sqrt(0.75)}) {
      std::string const name =
          M == 0 ? "a quarter and 7 % of the mass towards the pole, at rest" : "the same, M = 1.6";
      sphere.curve(circle_of_mass(Z, M * M / 2), Z > 0.6 ? name : "",
                   {.colour = M == 0 ? 6 : 2, .width = 1.6, .dashed = M == 0});
    }
  for (double const turned : {0.0, 1.2}) {
    Path loop;
    for (int i = 0; i < 60; ++i)
      loop.push_back(
          on_sphere(0.05 + 0.22 * std::sin(i * pi / 30), -0.6 + turned + 0.35 * std::cos(i * pi / 30)));
    sphere.dots(loop, turned == 0 ? "a loop of particles" : "the same loop later",
                {.colour = turned == 0 ? 1 : 3, .radius = 2});
  }
  return sphere.svg();
}

int main(int argc, char** argv) {
  book::Program program(
      argc, argv,
      "an atmosphere that turns about a sphere: an exact motion, and the currents of its symmetries");
  double const field = std::max(residual_of(air.by_mass()), residual_of(air.by_place()));
  program.figure("field_equations", field, "largest residual of the field equations at 400 points");
  auto const [closed, open] = show_currents(program);
  show_circulation(program);
  program.picture("profile", profile(),
                  "Density by latitude of an atmosphere that turns as a whole, M times as fast at the "
                  "equator as sound in the gas at rest.");
  program.picture("sphere", sphere(),
                  "Circles that hold the same mass at rest and at M = 1.6, and a loop of "
                  "particles that is carried along.");
  program.claim(book::measured(field) < 1e-11, "the motion is exact");
  program.claim(book::measured(closed) < 1e-11, "the currents of the symmetries are closed");
  program.claim(book::measured(open) > 1e-3, "and those of fields that are no symmetries are not");
  program.headline("currents closed to " + number(closed, 2), closed);
  return program.finish();
}
