// What the scheme does not conserve: the circulation of a gas along closed curves of its particles.
//
// What is shown. By Kelvin's theorem, the relabelling symmetry of chapter 9, the circulation of a barotropic
// gas along a material curve is constant. A mesh of labels has no such symmetry, and the circulation of the
// discrete motion changes; but by an amount of second order in the mesh width, while the momentum is constant
// to rounding. Read first. Section 10B.8.
//
// A row of nodes of a periodic box is a closed curve. Its circulation, the integral of u.dphi, is evaluated
// with differences of order 12 along the row, so that the measuring adds nothing that is seen.
//
// Compiled at -O2: it takes many steps.
#include <numbers>

#include "actio/fast_media/fast_medium_2d.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"

using namespace actio;
using namespace actio::media;
using Place = std::array<double, 2>;

// 1. A gas in a periodic box: a shear with two waves of sound in it. The shear gives vorticity, the sound
//    squeezes what is carried.
constexpr double two_pi = 2 * std::numbers::pi;
auto gas(int n, double dt) {
  using enum Side;
  FastBox2d const box{{n, n}, {1.0 / n, 1.0 / n}, {periodic, periodic}, {periodic, periodic}};
  auto const place = [](Place const& X) {
    return Place{X[0] + 0.02 * std::sin(two_pi * (X[0] + X[1])), X[1] + 0.015 * std::cos(two_pi * X[0])};
  };
  auto const velocity = [](Place const& X) {
    return Place{0.3 * std::sin(two_pi * X[1]) + 0.1 * std::cos(two_pi * X[0]),
                 0.2 * std::sin(two_pi * (X[0] - X[1]))};
  };
  return FastMedium2d(FastFluid{PolytropicByRoots<1, 2>{0.5}}, box, dt, 1, place, velocity);
}

// 2. The derivative along a row of n nodes that closes, by central differences of order 12.
double slope_along(std::vector<double> const& f, int i, double jump) {
  static constexpr double weights[] = {6. / 7, -15. / 56, 5. / 63, -1. / 56, 1. / 385, -1. / 5544};
  int const n = static_cast<int>(f.size());
  auto const at = [&](int k) {
    int const turns = k < 0 ? -1 : k >= n ? 1 : 0;
    return f[static_cast<std::size_t>(k - turns * n)] + turns * jump;
  };
  double sum = 0;
  for (int m = 1; m <= 6; ++m) sum += weights[m - 1] * (at(i + m) - at(i - m));
  return sum * n;
}

// 3. The circulation along row j: the trapezoidal rule, which is as good as its integrand on a closed curve.
template <class Medium>
double circulation(Medium const& medium, int j) {
  int const n = medium.box().cells[0];
  auto const x = medium.places(), u = medium.velocities();
  double sum = 0;
  for (int c = 0; c < 2; ++c) {
    std::vector<double> row;
    for (int i = 0; i < n; ++i) row.push_back(x[static_cast<std::size_t>(j * n + i)][c]);
    for (int i = 0; i < n; ++i)
      sum += u[static_cast<std::size_t>(j * n + i)][c] * slope_along(row, i, c == 0 ? 1 : 0) / n;
  }
  return sum;
}

struct Change {
  double circulation, momentum;
};
// 4. Four curves through one run: the largest change of their circulation, and that of the momentum.
Change change_on(int n, double time) {
  long const steps = 2 * n;
  auto medium = gas(n, time / static_cast<double>(steps));
  auto const p = medium.momentum();
  double start[4], worst = 0;
  for (int k = 0; k < 4; ++k) start[k] = circulation(medium, k * n / 4);
  medium.step(steps);
  for (int k = 0; k < 4; ++k) worst = std::max(worst, std::abs(circulation(medium, k * n / 4) - start[k]));
  auto const q = medium.momentum();
  return {worst, std::hypot(q[0] - p[0], q[1] - p[1])};
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "circulation is not exact on a mesh: how much of it changes");
  double const time = 0.5;
  std::vector<double> widths, changes, square;
  std::vector<book::Program::Row> rows;
  double momentum = 0, order = 0;
  for (int const n : {32, 64, 128, 256, 512}) {
    auto const c = change_on(n, time);
    if (!changes.empty()) order = std::log2(changes.back() / c.circulation);
    rows.push_back({std::to_string(n), book::number(c.circulation),
                    changes.empty() ? "" : book::number(order, 4), book::number(c.momentum, 2)});
    widths.push_back(1.0 / n), changes.push_back(c.circulation);
    square.push_back(changes.front() * std::pow(32.0 / n, 2));
    momentum = std::max(momentum, c.momentum);
  }
  program.table("changes", {"cells in each direction", "circulation", "order", "momentum"}, rows,
                "Largest change of the circulation along four curves in half a unit of time, and of the "
                "momentum; the circulations are of the size of 0.3.");
  auto plot = book::Plot("width of a cell", "change of circulation").log_x().log_y();
  plot.curve(widths, square, "width squared", {.dashed = true}).dots(widths, changes, "measured");
  program.picture("order", plot.svg(), "The change of circulation falls with the square of the mesh width.");
  program.figure("finest", changes.back(), "change of circulation on 512 x 512 cells");
  program.figure("order", order, book::number(order, 4), "order between the two finest meshes");
  program.figure("momentum", momentum, "largest change of the momentum");
  program.claim(book::measured(changes.back()) > 1e-8, "circulation changes by much more than rounding");
  program.claim(book::measured(std::abs(order - 2)) < 0.1, "and by an amount of second order");
  program.claim(book::measured(momentum) < 1e-13, "while the momentum stays to rounding");
  program.headline("circulation changes with order " + book::number(order, 3), order);
  return program.finish();
}
