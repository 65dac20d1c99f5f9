// Gerstner's wave: an exact motion of heavy water with a free surface, and its pressure as the multiplier.
//
// What is shown. Every particle goes round a circle, the smaller the deeper, and the surface is a trochoid.
// Labels are chosen for this simple form and not for their volume: the water's volume per label is
// 1 - e^(2kb), and that is what the metric of the body says. With it J = 1, exactly and at all times. The
// multiplier that the field equations then ask for depends on b alone; so a line of particles that begins as
// a surface of equal pressure is one for ever, and any of them may be the free surface.
//
//   (a, b)  labels of a particle, b <= b0 < 0      k  wave number, c = sqrt(gravity/k) speed of the wave
//   phi = (a + r sin s, b - r cos s) with r = e^(kb)/k and s = k(a + ct)
#include "actio/incompressible/incompressible_equations.hpp"
#include "actio/jets/field_equations.hpp"
#include "actio/numbers/gauss_quadrature.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"

using namespace actio;
double const k = 1, gravity = 1, c = std::sqrt(gravity / k);

// 1. The motion, and the volume that a label stands for: G = diag(1, (1 - e^(2kb))^2).
struct Wave {
  template <class V>
  auto operator()(V const& x) const {
    using std::cos, std::exp, std::sin;
    using T = typename V::Scalar;
    T const r = exp(x[2] * k) / k, s = (x[1] + x[0] * c) * k;
    return Matrix<T, 2, 1>(T(x[1] + r * sin(s)), T(x[2] - r * cos(s)));
  }
};
struct Labels {
  template <class V>
  auto operator()(V const& x) const {
    using std::exp;
    using T = typename V::Scalar;
    T const root = 1.0 - exp(x[1] * (2 * k));
    Matrix<T, 2, 2> G = Matrix<T, 2, 2>::Zero();
    G(0, 0) = T(1.0), G(1, 1) = root * root;
    return G;
  }
};

// 2. Kinetic energy less the weight, with mass 1 per volume; the constraint J = 1 makes it the
// augmented density.
struct HeavyWater {
  template <class S>
  S operator()(Jet<S, 2, 2> const& j) const {
    S const kinetic = j.velocity().squaredNorm() / 2.0, weight = j.y[1] * gravity;
    return volume<S>(Labels{}(j.particle())) * (kinetic - weight);
  }
};
AugmentedDensity const water{HeavyWater{}, VolumeConstraint{Labels{}, Euclidean<2>{}}};

// 3. The pressure in closed form, zero at the surface b = b0:
// P = (b0 - b) gravity - c^2 (e^(2kb0) - e^(2kb))/2.
struct Pressure {
  double surface;
  template <class V>
  auto operator()(V const& x) const {
    using std::exp;
    using T = typename V::Scalar;
    T const square = std::exp(2 * k * surface) - exp(x[2] * (2 * k));
    return T((surface - x[2]) * gravity - square * (c * c / 2));
  }
};

// 4. The same pressure from the motion alone. The force that the density without a multiplier
// leaves over, carried to the body through F, is dP/da and dP/db; integrated from the surface
// down it is the pressure.
Vector<double, 2> required_slope(Vector<double, 3> const& x) {
  auto const j = second_jet(Wave{}, x);
  water.constraint.examine(static_cast<Jet<double, 2, 2> const&>(j));
  double const per_label = volume<double>(Labels{}(j.particle()));
  Vector<double, 2> const force = -euler_lagrange(HeavyWater{}, j) / per_label;
  return -(j.gradient().transpose() * force) /
         water.constraint.volume_ratio(static_cast<Jet<double, 2, 2> const&>(j));
}
double pressure_by_multiplier(double surface, double t, double a, double b) {
  static auto const rule = gauss_quadrature<double>(16);
  double const depth = b - surface;
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i)
    sum += rule.weights[i] * depth * required_slope({t, a, surface + rule.nodes[i] * depth})[1];
  return sum;
}

// 5. Lines of particles with their paths, and a period of the motion of marked particles for
// the book to play.
void draw_wave(book::Program& program) {
  auto plot = book::Plot("y1", "y2").equal().size(720, 340).x_range(-6.6, 6.6).y_range(-3.4, 1.2);
  for (double const b : {-0.1, -0.4, -0.8, -1.4, -2.2}) {
    std::vector<double> x, y, orbit_x, orbit_y;
    for (int i = 0; i <= 400; ++i) {
      auto const at = Wave{}(Vector<double, 3>(0, -8 + 16.0 * i / 400, b));
      x.push_back(at[0]), y.push_back(at[1]);
    }
    for (double const a : {-3.14159, 0.0, 3.14159}) {
      for (int i = 0; i <= 60; ++i) {
        auto const at = Wave{}(Vector<double, 3>(2 * M_PI / (k * c) * i / 60, a, b));
        orbit_x.push_back(at[0]), orbit_y.push_back(at[1]);
      }
      orbit_x.push_back(NAN), orbit_y.push_back(NAN);
    }
    plot.curve(x, y, b == -0.1 ? "lines of equal pressure, the uppermost free" : "", {.colour = 1})
        .curve(orbit_x, orbit_y, b == -0.1 ? "paths of particles" : "", {.colour = 6, .width = 1});
  }
  program.picture("wave", plot.svg(),
                  "Gerstner's wave: every line of particles is a trochoid on which the pressure is "
                  "the same, every path is a circle.");
}
void report_motion(book::Program& program) {
  double const period = 2 * M_PI / (k * c);
  int const across = 24, frames = 80;
  book::Program::Row header{"t"};
  std::vector<std::vector<double>> rows;
  for (int frame = 0; frame < frames; ++frame) {
    double const t = period * frame / frames;
    std::vector<double> row{t};
    for (double const b : {-0.1, -0.5, -1.0, -1.7, -2.6})
      for (int i = 0; i < across; ++i) {
        auto const at = Wave{}(Vector<double, 3>(t, 4 * M_PI * (i + 0.5) / across - 2 * M_PI, b));
        if (frame == 0) {
          std::string const particle = std::to_string((header.size() - 1) / 2);
          header.push_back("x" + particle), header.push_back("y" + particle);
        }
        row.push_back(at[0]), row.push_back(at[1]);
      }
    rows.push_back(row);
  }
  program.motion("fluid", header, rows);
}

// 6. The claims: the field equations of the extended bundle, and both pressures beside each other.
int main(int argc, char** argv) {
  book::Program program(argc, argv,
                        "Gerstner's wave: an exact motion with a free surface, its pressure as "
                        "the multiplier of the constraint");
  draw_wave(program);
  report_motion(program);

  double field = 0, constraint = 0, along_surface = 0;
  std::vector<book::Program::Row> rows;
  double pressure_error = 0;
  double const surface = -0.1;
  for (double const b : {-0.2, -0.5, -1.0, -2.0, -4.0}) {
    double worst = 0;
    for (double const t : {0.0, 0.7, 1.9})
      for (double const a : {-1.0, 0.3, 2.0}) {
        Vector<double, 3> const x(t, a, b);
        Vector<double, 3> const E =
            euler_lagrange(water, second_jet(with_pressure(Wave{}, Pressure{surface}, Labels{}), x));
        field = std::max(field, E.head<2>().cwiseAbs().maxCoeff()),
        constraint = std::max(constraint, std::abs(E[2]));
        along_surface = std::max(along_surface, std::abs(required_slope({t, a, surface})[0]));
        worst = std::max(worst, std::abs(pressure_by_multiplier(surface, t, a, b) - Pressure{surface}(x)));
      }
    pressure_error = std::max(pressure_error, worst);
    rows.push_back({book::number(b), book::number(std::exp(k * b) / k),
                    book::number(Pressure{surface}(Vector<double, 3>(0, 0, b)), 8), book::number(worst, 2)});
  }
  program.table(
      "pressure", {"b", "radius of the paths", "pressure", "largest error by the multiplier"}, rows,
      "Pressure under the surface b = -0.1, in units of the density times gravity over the wave number.");
  program.figure("field", field, "largest force that is left over in the field equations");
  program.figure("constraint", constraint, "largest deviation of J from 1");
  program.figure("along_surface", along_surface, "largest slope of the pressure along the free surface");
  program.figure("pressure_error", pressure_error, "largest error of the pressure by the multiplier");

  // Differences of numbers of order one, a few tens of roundings; the quadrature adds none that counts.
  program.claim(book::measured(field) < 1e-13 && book::measured(constraint) < 1e-13,
                "the wave solves the field equations");
  program.claim(book::measured(along_surface) < 1e-13,
                "the pressure on the free surface is the same everywhere");
  program.claim(book::measured(pressure_error) < 1e-12, "the multiplier is the pressure");
  program.headline("pressure by the multiplier to " + book::number(pressure_error, 2), pressure_error);
  return program.finish();
}
