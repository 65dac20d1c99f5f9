// Strings that cannot stretch: the multiplier is the tension, and it comes out of where the string is and how it moves.
//
// What is shown. A string that runs along itself keeps its shape, whatever the shape is, and the tension is the mass per length times the speed squared. Hung
// up, a string is a catenary; set running it stays one, with the same added to its tension. Both are exact solutions of the constrained field equations, n = 1, N = 2. The tension
// is found again from the field equations at single points, and from a boundary value problem that knows the place and the velocity of the string alone.
// Read first. The chapter up to the extended bundle.
//
//   s      length along the string, m            rho    mass per length, kg/m
//   phi    place, m                              T      tension, N: the multiplier of (1 - |phi_s|^2)/2
//   X      shape, by arc length                  v      speed along itself, m/s
#include "actio/constraints/constrained_equations.hpp"
#include "actio/constraints/inextensible.hpp"
#include "actio/foundations/gauss_quadrature.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"

using namespace actio;
using Eigen::Vector2d;

double const rho = 0.05, gravity = 9.81;
using Points = std::vector<double>;

// A closed loop with three lobes, by its direction angle 2 pi s/l + a sin(6 pi s/l): of unit speed by construction, and closed.
struct Loop {
  double length, a;
  double angle(double s) const { return 2 * M_PI * s / length + a * std::sin(6 * M_PI * s / length); }
  double turning(double s) const { return 2 * M_PI / length * (1 + 3 * a * std::cos(6 * M_PI * s / length)); }
  Vector2d direction(double s) const { return {std::cos(angle(s)), std::sin(angle(s))}; }
  // The place, by Gauss's rule on pieces of the length.
  Vector2d place(double s) const {
    static auto const rule = gauss_quadrature<double>(10);
    Vector2d sum(0, 0);
    int const pieces = 16;
    for (int p = 0; p < pieces; ++p)
      for (int i = 0; i < 10; ++i) sum += rule.weights[i] * s / pieces * direction((p + rule.nodes[i]) * s / pieces);
    return sum;
  }
  // The shape over truncated polynomials, from the place and two derivatives.
  template <class T>
  Eigen::Matrix<T, 2, 1> operator()(T const& s) const {
    if constexpr (std::is_same_v<T, double>) {
      return place(s);
    } else {
      Vector2d const X = place(s.value), X1 = direction(s.value), X2 = turning(s.value) * Vector2d(-X1[1], X1[0]);
      return {chain(s, X[0], X1[0], X2[0]), chain(s, X[1], X1[1], X2[1])};
    }
  }
};

// The curve of a string that hangs, by arc length from its lowest point: (c arsinh(s/c), sqrt(c^2 + s^2)).
struct Catenary {
  double c;
  template <class T>
  Eigen::Matrix<T, 2, 1> operator()(T const& s) const {
    using std::log, std::sqrt;
    T const y = sqrt(s * s + c * c);
    return {log((s + y) / c) * c, y};
  }
};

// The section of a string that runs along its shape, and its tension: rho v^2, and with gravity rho g times the height above the directrix.
template <class Shape>
struct Running {
  Shape X;
  double v;
  template <class V>
  auto operator()(V const& x) const {
    return X(typename V::Scalar(x[1] - x[0] * v));
  }
};
template <class Shape>
struct Tension {
  Running<Shape> phi;
  double g, part = 1;  // of rho v^2
  template <class V>
  auto operator()(V const& x) const {
    using T = typename V::Scalar;
    Eigen::Matrix<T, 1, 1> tension;
    tension[0] = part * rho * phi.v * phi.v;
    if (g != 0) tension[0] += phi(x)[1] * (rho * g);
    return tension;
  }
};

// The largest of what the constrained field equations leave, over the largest force that they balance: rho |phi_tt| and the weight.
template <class Shape>
double residual(Tension<Shape> const& tension, double low, double high) {
  HeavyString<double, 2> const string{rho, {0, -tension.g}};
  AugmentedDensity const density{string, Inextensible{Euclidean<2>{}}};
  ExtendedSection const extended{tension.phi, tension};
  double worst = 0, scale = rho * tension.g;
  for (int i = 0; i <= 200; ++i) {
    Event<double, 1> const x(0.03, low + (high - low) * i / 200);
    auto const j = second_jet(tension.phi, x);
    scale = std::max(scale, rho * j.acceleration().norm());
    worst = std::max(worst, euler_lagrange(density, extended, x).cwiseAbs().maxCoeff());
  }
  return worst / scale;
}

// The tension at a point from the field equations alone: rho (phi_tt - g) = T phi_ss + T_s phi_s is two equations for T and T_s.
template <class Shape>
double from_equations(Running<Shape> const& phi, double g, Event<double, 1> const& x) {
  auto const j = second_jet(phi, x);
  Eigen::Matrix2d both;
  both << j.w[1].col(1), j.v.col(1);
  return solve_linear(both, Vector2d(rho * (j.acceleration() + Vector2d(0, g))))[0];
}

// The tension from place and velocity: differentiating the constraint twice in time leaves T'' - |phi_ss|^2 T = -rho |phi_st|^2. Second differences on a grid between
// two ends where T is known, or round a loop.
template <class Shape>
Points from_boundary_values(Running<Shape> const& phi, Points const& s, bool closed, double first, double last) {
  int const count = static_cast<int>(s.size());
  double const h = s[1] - s[0];
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd b(count);
  for (int i = 0; i < count; ++i) {
    auto const j = second_jet(phi, Event<double, 1>(0, s[i]));
    A(i, i) = -2 / (h * h) - j.w[1].col(1).squaredNorm();
    b[i] = -rho * j.w[1].col(0).squaredNorm();
    for (int side : {-1, 1})
      if (int const k = i + side; closed)
        A(i, (k + count) % count) += 1 / (h * h);
      else if (k < 0 || k == count)
        b[i] -= (k < 0 ? first : last) / (h * h);
      else
        A(i, k) = 1 / (h * h);
  }
  Eigen::VectorXd const T = solve_linear(A, b);
  return {T.data(), T.data() + count};
}

// 1. A loop in free space that runs along itself.
void show_loop(book::Program& program, Running<Loop> const& loop) {
  double const l = loop.X.length;
  auto plot = book::Plot("x, m", "y, m").equal().size(560, 470);
  Points x, y;
  for (int i = 0; i <= 400; ++i) {
    Vector2d const p = loop.X.place(l * i / 400);
    x.push_back(p[0]), y.push_back(p[1]);
  }
  plot.curve(x, y, "the string, at all times", {.colour = 6});
  for (int k = 0; k < 3; ++k) {
    Points u, w;
    for (int i = 0; i < 6; ++i) {
      Vector2d const p = loop(Event<double, 1>(0.05 * k, l * i / 24));
      u.push_back(p[0]), w.push_back(p[1]);
    }
    plot.dots(u, w, "six of its points after " + book::number(0.05 * k) + " s", {.colour = k + 1, .radius = 4.0 - 0.7 * k});
  }
  program.picture("loop", plot.svg(), "A loop of string in free space. It stands still and its points run round it at " + book::number(loop.v) + " m/s.");
}

// 2. A chain that hangs between two points, at rest and running from one to the other.
void show_chain(book::Program& program, Catenary const& shape, double end) {
  auto plot = book::Plot("x, m", "tension, N").size(560, 360);
  for (double v : {0.0, 5.0, 10.0}) {
    Running<Catenary> const chain{shape, v};
    Points x, T;
    for (int i = 0; i <= 200; ++i) {
      double const s = -end + 2 * end * i / 200;
      x.push_back(shape(s)[0]), T.push_back(Tension<Catenary>{chain, gravity}(Event<double, 1>(0, s))[0]);
    }
    plot.curve(x, T, v == 0 ? "at rest" : "running at " + book::number(v) + " m/s");
  }
  program.picture("chain", plot.svg(), "The tension of a chain along a catenary, at rest and running. Its shape is the same.");
}

template <class Shape>
double apart(Running<Shape> const& phi, Tension<Shape> const& tension, double low, double high) {
  double worst = 0;
  for (int i = 0; i <= 100; ++i) {
    Event<double, 1> const x(0.02, low + (high - low) * i / 100);
    double const T = tension(x)[0];
    worst = std::max(worst, std::abs(from_equations(phi, tension.g, x) / T - 1));
  }
  return worst;
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "a string that cannot stretch: it runs along itself in any shape, and its tension is the multiplier");
  Running<Loop> const loop{{3, 0.9}, 6};
  Running<Catenary> const still{{1}, 0}, chain{{1}, 10};
  double const l = loop.X.length, end = 1.6;
  show_loop(program, loop);
  show_chain(program, chain.X, end);

  // 3. What the equations leave, and what they leave with a tension or a shape that is wrong.
  double const of_loop = residual(Tension<Loop>{loop, 0}, 0, l), of_rest = residual(Tension<Catenary>{still, gravity}, -end, end);
  double const of_chain = residual(Tension<Catenary>{chain, gravity}, -end, end);
  double const slack = residual(Tension<Loop>{loop, 0, 0.5}, 0, l), forgotten = residual(Tension<Catenary>{chain, gravity, 0}, -end, end);
  double const apart_loop = apart(loop, {loop, 0}, 0, l), apart_rest = apart(still, {still, gravity}, -end, end), apart_chain = apart(chain, {chain, gravity}, -end, end);
  auto const cell = [](double value) { return book::number(value, 2); };
  program.table("residuals", {"string", "equations and constraint", "tension from the equations"},
                {{"loop that runs", cell(of_loop), cell(apart_loop)},
                 {"chain at rest", cell(of_rest), cell(apart_rest)},
                 {"chain that runs", cell(of_chain), cell(apart_chain)},
                 {"loop with half the tension", cell(slack), "–"},
                 {"chain that runs, with the tension of rest", cell(forgotten), "–"}},
                "What is left of the field equations, over the largest force in them, and the relative error of the tension found at single points. The last two are controls.");
  program.figure("loop_tension", rho * loop.v * loop.v, book::number(rho * loop.v * loop.v) + " N", "tension of the loop");
  program.figure("closes", loop.X.place(l).norm(), "gap of the loop, m");

  // 4. The tension from place and velocity alone.
  Points grid(200), round;
  for (std::size_t i = 0; i < grid.size(); ++i) grid[i] = l * static_cast<double>(i) / 200;
  round = from_boundary_values(loop, grid, true, 0, 0);
  double worst_round = 0;
  for (double const T : round) worst_round = std::max(worst_round, std::abs(T / (rho * loop.v * loop.v) - 1));
  Points steps, errors;
  for (int count = 15; count < 300; count = 2 * count + 1) {
    double const h = 2 * end / (count + 1);
    Points s;
    for (int i = 1; i <= count; ++i) s.push_back(-end + h * i);
    Tension<Catenary> const exact{chain, gravity};
    Points const T = from_boundary_values(chain, s, false, exact(Event<double, 1>(0, -end))[0], exact(Event<double, 1>(0, end))[0]);
    double worst = 0;
    for (int i = 0; i < count; ++i) worst = std::max(worst, std::abs(T[i] / exact(Event<double, 1>(0, s[i]))[0] - 1));
    steps.push_back(h), errors.push_back(worst);
  }
  double const order = book::exponent(steps, errors);
  program.figure("round", worst_round, "relative error of the loop's tension, found from its place and velocity");
  program.figure("order", order, "order at which the chain's tension is found so");
  program.figure("finest", errors.back(), "relative error on the finest grid");

  program.claim(std::max({of_loop, of_rest, of_chain}) < 1e-12, "the field equations and the constraint hold to rounding");
  program.claim(std::max({apart_loop, apart_rest, apart_chain}) < 1e-10, "the tension found at single points is the exact one");
  program.claim(std::min(slack, forgotten) > 0.1, "a wrong tension leaves a force as large as those in balance");
  program.claim(worst_round < 1e-10 && std::abs(order - 2) < 0.1, "place and velocity give the tension, to second order in the grid");
  program.headline("strings that run, with equations and constraint to " + book::number(std::max(of_loop, of_chain), 2), std::max(of_loop, of_chain));
  return program.finish();
}
