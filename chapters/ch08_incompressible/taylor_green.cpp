// Cells of fluid that turn beside one another: where the particles go, what becomes of a patch of dye, and the pressure that keeps its area, got in two ways.
//
// What is shown. In the steady flow of Taylor and Green, u = (sin y1 cos y2, -cos y1 sin y2), a particle goes round its cell in a time that an elliptic integral
// gives. The motion alone tells the pressure: on the body as the multiplier of the constraint J = 1, from the material equation (8.9), integrated from particle to particle;
// in space from the velocity, by the equation of the pressure (8.14) with its slope at the walls. The two meet where the particles are.
//
//   X  particle, its place at t = 0     u  velocity in space     P  pressure on the body     k = sin X1 sin X2, which a particle keeps
//   phi(t, X)  place of a particle      p  pressure in space     m = 1 - k^2, the parameter of its elliptic functions
#include <gsl/gsl_sf_elljac.h>

#include "actio/foundations/gauss_quadrature.hpp"
#include "actio/incompressible/ideal_fluid.hpp"
#include "actio/incompressible/incompressible_equations.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"

using namespace actio;
using Place = Eigen::Vector2d;
double const pi = std::acos(-1);

// The flow: velocities at points (t, y).
struct Cells {
  template <class V>
  auto operator()(V const& at) const {
    using std::cos, std::sin;
    using T = typename V::Scalar;
    return Eigen::Matrix<T, 2, 1>(T(sin(at[1]) * cos(at[2])), T(-(cos(at[1]) * sin(at[2]))));
  }
};

// The motion of its particles: classical Runge-Kutta steps up to the plain time, and from there what infinitesimals t has by the Taylor polynomial.
struct Motion {
  static constexpr double step = 2e-3;
  template <class V>
  auto operator()(V const& x) const {
    using T = typename V::Scalar;
    using Y = Eigen::Matrix<T, 2, 1>;
    auto const u = [](Y const& y) { return Cells{}(Eigen::Matrix<T, 3, 1>(T(0), y[0], y[1])); };
    double const time = base_value(x[0]);
    int const steps = std::max(1, static_cast<int>(std::ceil(std::abs(time) / step)));
    T const h(time / steps);
    Y y = x.template tail<2>();
    for (int i = 0; i < steps; ++i) {
      Y const a = u(y), b = u(y + a * T(h / 2.0)), c = u(y + b * T(h / 2.0)), d = u(y + c * h);
      y += (a + b * T(2.0) + c * T(2.0) + d) * T(h / 6.0);
    }
    T const s = x[0] - T(time);
    Y const velocity = u(y), further = u(y + velocity * s);
    return Y(y + (velocity + further) * T(s / 2.0));
  }
};

// A particle's place by Jacobi's functions: cos y1 = sqrt(m) sn(t + t0), cos y2 = -sqrt(m) cd(t + t0), for a particle that starts on cos X2 = -sqrt(m), cos X1 = 0.
Place by_elliptic_functions(double k, double t) {
  double const m = 1 - k * k;
  double sn, cn, dn;
  gsl_sf_elljac_e(t, m, &sn, &cn, &dn);
  return {std::acos(std::sqrt(m) * sn), std::acos(-std::sqrt(m) * cn / dn)};
}
Place start_of(double k) { return by_elliptic_functions(k, 0); }

Place place_of(Place const& X, double t) { return Motion{}(Eigen::Vector3d(t, X[0], X[1])); }
double closed_form(Place const& y) { return (std::cos(2 * y[0]) + std::cos(2 * y[1])) / 4; }

// The pressure of a particle less that of another: the multiplier's derivatives along the straight line between them on the body.
double multiplier_between(Place const& from, Place const& to, double t) {
  static auto const rule = gauss_quadrature<double>(24);
  auto const fluid = incompressible(Continuum{Euclidean<2>{}, Euclidean<2>{}, Homogeneous<double>{}, NoStoredEnergy{}});
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    Place const X = from + rule.nodes[i] * (to - from);
    auto const j = second_jet(Motion{}, Eigen::Vector3d(t, X[0], X[1]));
    sum += rule.weights[i] * required_pressure_gradient(fluid, j).dot(to - from);
  }
  return sum;
}

// (8.14) in one cell by cosines, whose slope at the walls is zero as the fluid asks there.
struct CosineSeries {
  static constexpr int modes = 12;
  double c[modes][modes] = {};
  double operator()(Place const& y) const {
    double sum = 0;
    for (int a = 0; a < modes; ++a)
      for (int b = 0; b < modes; ++b) sum += c[a][b] * std::cos(a * y[0]) * std::cos(b * y[1]);
    return sum;
  }
};
CosineSeries solve_for_pressure() {
  CosineSeries p;
  int const count = 2 * CosineSeries::modes;
  auto const node = [&](int i) { return pi * (i + 0.5) / count; };
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < count; ++k) {
      double const source = pressure_source(Euclidean<2>{}, Cells{}, Eigen::Vector3d(0, node(i), node(k)));
      for (int a = 0; a < CosineSeries::modes; ++a)
        for (int b = a == 0; b < CosineSeries::modes; ++b)
          p.c[a][b] -= source * std::cos(a * node(i)) * std::cos(b * node(k)) * (a ? 2 : 1) * (b ? 2 : 1) / (count * count) / (a * a + b * b);
    }
  return p;
}

void draw_paths(book::Program& program) {
  auto plot = book::Plot("y1", "y2").equal().size(560, 560);
  double worst = 0;
  for (double const k : {0.05, 0.3, 0.6, 0.85}) {
    double const period = 4 * std::comp_ellint_1(std::sqrt(1 - k * k));
    std::vector<double> x, y, dots_x, dots_y;
    for (int i = 0; i <= 240; ++i) {
      Place const at = by_elliptic_functions(k, period * i / 240);
      x.push_back(at[0]), y.push_back(at[1]);
    }
    for (int i = 0; i * 0.5 < period; ++i) {
      Place const at = place_of(start_of(k), i * 0.5);
      dots_x.push_back(at[0]), dots_y.push_back(at[1]);
      worst = std::max(worst, (at - by_elliptic_functions(k, i * 0.5)).norm());
    }
    plot.curve(x, y, k == 0.05 ? "paths, by elliptic functions" : "", {.colour = 6, .width = 1.2}).dots(dots_x, dots_y, k == 0.05 ? "particles, every half unit of time" : "", {.colour = 1});
  }
  // Isobars: cos 2 y1 + cos 2 y2 = c.
  for (double const c : {-1.2, -0.4, 0.4, 1.2}) {
    std::vector<double> x, y;
    for (int branch = 0; branch < 2; ++branch) {
      for (int i = 0; i <= 400; ++i) {
        double const at = pi * i / 400, rest = c - std::cos(2 * at), half = std::acos(std::clamp(rest, -1.0, 1.0)) / 2;
        x.push_back(at), y.push_back(std::abs(rest) > 1 ? NAN : branch ? pi - half : half);
      }
      x.push_back(NAN), y.push_back(NAN);
    }
    plot.curve(x, y, c == -1.2 ? "lines of equal pressure" : "", {.colour = 2, .width = 1, .dashed = true});
  }
  program.picture("paths", plot.svg(), "One cell: particles on their paths, and the lines of equal pressure, which is highest in the corners and lowest in the middle.");
  program.figure("path_error", worst, "largest distance of a particle from its place by elliptic functions");
  program.claim(worst < 1e-10, "particles are where elliptic functions have them");
}

void draw_dye(book::Program& program) {
  auto plot = book::Plot("y1", "y2").equal().size(560, 560).x_range(0, pi).y_range(0, pi);
  double worst = 0;
  for (double const t : {0.0, 2.0, 4.0, 8.0}) {
    std::vector<double> x, y;
    for (int i = 0; i <= 800; ++i) {
      double const turn = 2 * pi * i / 800;
      Place const at = place_of(Place(1.1, 1.1) + 0.45 * Place(std::cos(turn), std::sin(turn)), t);
      x.push_back(at[0]), y.push_back(at[1]);
      if (i % 50 == 0) {
        auto const j = first_jet(Motion{}, Eigen::Vector3d(t, 1.1 + 0.45 * std::cos(turn), 1.1 + 0.45 * std::sin(turn)));
        worst = std::max(worst, std::abs(VolumeConstraint{Euclidean<2>{}, Euclidean<2>{}}(j)[0]));
      }
    }
    plot.curve(x, y, "t = " + book::number(t));
  }
  program.picture("dye", plot.svg(), "The edge of a patch of dye at four times: the constraint keeps its area, and nothing keeps its shape.");
  program.figure("volume", worst, "largest deviation of J from 1 around the patch");
  program.claim(worst < 1e-9, "the motion keeps areas");
}

void compare_pressures(book::Program& program) {
  auto const p = solve_for_pressure();
  Place const first(0.7, 1.2);
  std::vector<book::Program::Row> rows;
  double by_multiplier = 0, by_poisson = 0;
  for (double const t : {0.0, 1.0, 2.0, 4.0})
    for (Place const& X : {Place(1.3, 0.8), Place(2.1, 2.4)}) {
      Place const here = place_of(first, t), there = place_of(X, t);
      double const exact = closed_form(there) - closed_form(here), multiplier = multiplier_between(first, X, t), poisson = p(there) - p(here);
      by_multiplier = std::max(by_multiplier, std::abs(multiplier - exact)), by_poisson = std::max(by_poisson, std::abs(poisson - exact));
      rows.push_back({book::number(t), "(" + book::number(X[0]) + ", " + book::number(X[1]) + ")", book::number(exact, 8), book::number(multiplier - exact, 2), book::number(poisson - exact, 2)});
    }
  program.table("pressures", {"t", "particle", "pressure", "error by the multiplier", "error by (8.14)"}, rows,
                "Pressure of a particle less that of the particle (0.7, 1.2): on the body by the multiplier, in space by the equation of the pressure.");
  program.figure("by_multiplier", by_multiplier, "largest error of the pressure by the multiplier");
  program.figure("by_poisson", by_poisson, "largest error of the pressure by (8.14)");
  program.claim(by_multiplier < 1e-7 && by_poisson < 1e-12, "the two pressures agree with the closed form");
  program.headline("pressure by multiplier and by Poisson's equation agree to " + book::number(by_multiplier, 2), by_multiplier);
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "cells of fluid: paths by elliptic functions, a patch of dye, and the pressure by two roads");
  draw_paths(program);
  draw_dye(program);
  compare_pressures(program);
  return program.finish();
}
