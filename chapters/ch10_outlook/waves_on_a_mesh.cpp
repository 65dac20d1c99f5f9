// A wave in a gas and in a solid, stepped by the multisymplectic scheme: how far it is from the exact one.
//
// What is shown. The simple waves of chapter 6 are exact motions until they break, and may run oblique to the
// mesh. The leapfrog of section 10B.3 follows them with an error of second order in the mesh width, space and
// time refined together; the slope is that of five meshes. Read first. ch06_simple_wave.
//
//   q  stretch along the direction d of the wave      c  speed of sound at this stretch
//   s  d.X, the label of a plane of particles         a  label of a characteristic, s = a + c t
//
// Compiled at -O2: it takes many steps.
#include <numbers>

#include "actio/fast_media/fast_medium_2d.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"

using namespace actio;
using namespace actio::media;
using Place = std::array<double, 2>;

// 1. Two media: the speed of sound, and its integral over the stretch.
struct Gas {  // p = K (rho/J)^2, c^2 = 2 K/q^3
  static constexpr double K = 0.5;
  static auto medium() { return FastFluid{PolytropicByRoots<1, 2>{K}}; }
  static double speed(double q) { return std::pow(q, -1.5); }
  static double travel(double q) { return -2 / std::sqrt(q); }
};
struct Solid {  // St Venant and Kirchhoff's, c^2 = (lambda + 2 mu)(3 q^2 - 1)/2 with lambda + 2 mu = 1
  static auto medium() { return FastStVenantKirchhoff{0.6, 0.2}; }
  static double speed(double q) { return std::sqrt((3 * q * q - 1) / 2); }
  static double travel(double q) {
    double const r = std::sqrt(3 * q * q - 1);
    return (q * r - std::log(q * std::sqrt(3.0) + r) / std::sqrt(3.0)) / std::sqrt(8.0);
  }
};

// 2. The exact wave: phi = X + d (f(s, t) - s). A characteristic carries the stretch that it starts with.
constexpr double height = 0.2, length = 2 * std::numbers::pi;
constexpr Place d{0.6, 0.8};

template <class Law>
struct SimpleWave {
  static double stretch(double a) { return 1 + height * std::sin(a); }
  static double label(double s, double t) {
    if (t == 0) return s;
    double low = s - 2 * t, high = s;
    for (int k = 0; k < 60; ++k) {
      double const middle = (low + high) / 2;
      (middle + Law::speed(stretch(middle)) * t < s ? low : high) = middle;
    }
    return (low + high) / 2;
  }
  static Place at(Place const& X, double t) {
    double const s = d[0] * X[0] + d[1] * X[1], a = label(s, t), q = stretch(a), c = Law::speed(q);
    double const f = a - height * std::cos(a) + (c * q - Law::travel(q) + Law::travel(1)) * t;
    return {X[0] + d[0] * (f - s), X[1] + d[1] * (f - s)};
  }
  static Place velocity(Place const& X) {
    double const v = Law::travel(1) - Law::travel(stretch(d[0] * X[0] + d[1] * X[1]));
    return {d[0] * v, d[1] * v};
  }
  // When neighbouring characteristics first meet: 1 + (dc/da) t = 0.
  static double breaks_at() {
    double const h = 1e-4;
    double steepest = 0;
    for (double a = 0; a < length; a += h)
      steepest = std::min(steepest, (Law::speed(stretch(a + h)) - Law::speed(stretch(a))) / h);
    return -1 / steepest;
  }
};

// 3. A run on n x n cells of a box that holds one wave length in both directions.
template <class Law>
auto run(int n, double time) {
  using enum Side;
  Place const spacing{length / d[0] / n, length / d[1] / n};
  FastBox2d const box{{n, n}, spacing, {periodic, periodic}, {periodic, periodic}};
  // A third of the time in which sound crosses a cell.
  int const steps = static_cast<int>(std::ceil(time * n / 2.5));
  auto const place = [](Place const& X) { return SimpleWave<Law>::at(X, 0); };
  FastMedium2d fast(Law::medium(), box, time / steps, 1, place, SimpleWave<Law>::velocity);
  fast.step(steps);
  return fast;
}
template <class Law>
double error_on(int n, double time) {
  auto const fast = run<Law>(n, time);
  auto const x = fast.places();
  double worst = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      Place const exact = SimpleWave<Law>::at(fast.box().at(i, j), time), here = x[j * n + i];
      worst = std::max(worst, std::hypot(here[0] - exact[0], here[1] - exact[1]));
    }
  return worst;
}

// 4. The slope of the errors, by least squares in logarithms.
double slope_of(std::vector<double> const& widths, std::vector<double> const& errors) {
  double x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t k = 0; k < widths.size(); ++k) {
    double const u = std::log(widths[k]), v = std::log(errors[k]);
    x += u, y += v, xx += u * u, xy += u * v;
  }
  double const n = static_cast<double>(widths.size());
  return (n * xy - x * y) / (n * xx - x * x);
}

int main(int argc, char** argv) {
  book::Program program(argc, argv,
                        "waves in a gas and in a solid, stepped on a mesh, beside the exact ones");
  std::vector<double> widths, gas, solid;
  std::vector<book::Program::Row> rows;
  double const gas_time = 0.6 * SimpleWave<Gas>::breaks_at(),
               solid_time = 0.6 * SimpleWave<Solid>::breaks_at();
  for (int const n : {24, 48, 96, 192, 384}) {
    widths.push_back(1.0 / n);
    gas.push_back(error_on<Gas>(n, gas_time)), solid.push_back(error_on<Solid>(n, solid_time));
    rows.push_back({std::to_string(n), book::number(gas.back()), book::number(solid.back())});
  }
  double const gas_order = slope_of(widths, gas), solid_order = slope_of(widths, solid);
  rows.push_back({"order", book::number(gas_order, 4), book::number(solid_order, 4)});
  program.table("errors", {"cells in each direction", "gas", "St Venant-Kirchhoff"}, rows,
                "Largest distance of a node from where the exact wave has it, when six tenths of the time "
                "to the breaking have passed; wave length 2 pi.");
  program.figure("gas_order", gas_order, book::number(gas_order, 4), "order of the error, gas");
  program.figure("solid_order", solid_order, book::number(solid_order, 4), "order of the error, solid");

  // 5. The stretch on a line of nodes of a coarse mesh, beside the exact one.
  int const n = 24;
  auto const coarse = run<Gas>(n, gas_time);
  auto const x = coarse.places();
  double const edge = coarse.box().spacing[0];
  std::vector<double> s, q, s_exact, q_exact;
  for (int i = 0; i + 1 < n; ++i) {
    double const along = (x[i + 1][0] - x[i][0]) / edge;
    s.push_back((i + 0.5) * edge * d[0]);
    q.push_back(1 + (along - 1) / (d[0] * d[0]));  // phi_x = 1 + d_1^2 (q - 1)
  }
  for (double a = -3; a < 8; a += 0.02) {
    double const stretch = SimpleWave<Gas>::stretch(a), at = a + Gas::speed(stretch) * gas_time;
    if (at >= 0 && at <= length) s_exact.push_back(at), q_exact.push_back(stretch);
  }
  auto plot = book::Plot("s, along the wave", "stretch");
  plot.curve(s_exact, q_exact, "exact").dots(s, q, "24 cells");
  program.picture("stretch", plot.svg(), "The wave in the gas after six tenths of the time to its breaking.");
  // The error has even powers of the width alone: the next one moves the slope by some hundredths at most.
  program.claim(
      book::measured(std::abs(gas_order - 2)) < 0.05 && book::measured(std::abs(solid_order - 2)) < 0.05,
      "the error falls with the square of the mesh width");
  program.headline("order " + book::number(gas_order, 4) + " on an oblique wave", gas_order);
  return program.finish();
}
