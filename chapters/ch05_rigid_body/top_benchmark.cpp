// The heavy top of Brüls and Cardona: the angular velocity after a second, to nine places.
//
// What is shown. A disc on an arm turns about the arm and falls. The scheme of the heavy top, of second order
// and composed to fourth, is compared with a power series in 50 digits, and its orders are measured. Read
// first. heavy_top.
//
//   Omega, Pi   body velocity, rad/s, and body momentum, J s     p     weight times centre of mass, J
//   Gamma       the vertical in the body frame
//
// Compiled at -O2: it takes many steps.
#include "actio/numbers/multiprecision.hpp"
#include "actio/rigid_body/heavy_top.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"
#include "witness/taylor_reference.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;

// The equations of Euler and Poisson for the power series, written out: y = (Pi, Gamma).
auto euler_poisson(Matrix<dec50, 3, 1> const& I, Matrix<dec50, 3, 1> const& p) {
  return [=](auto const& y) {
    using T = typename std::decay_t<decltype(y)>::Scalar;
    T const w[3] = {y[0] / T(I[0]), y[1] / T(I[1]), y[2] / T(I[2])};
    Matrix<T, 6, 1> rate;
    for (int i = 0; i < 3; ++i) {
      int const j = (i + 1) % 3, k = (i + 2) % 3;
      rate[i] = y[j] * w[k] - y[k] * w[j] + y[3 + j] * T(p[k]) - y[3 + k] * T(p[j]);
      rate[3 + i] = y[3 + j] * w[k] - y[3 + k] * w[j];
    }
    return rate;
  };
}

// 1. The benchmark: a disc of 15 kg on an arm of 1 m. Its angular velocity after a second, from 50 digits.
Vector3d benchmark_in_50_digits() {
  auto const [exact, exact_spin] = bruls_cardona_top<dec50>();
  auto const exact_start = release(exact, identity<dec50>(SO<3>{}), exact_spin);
  Matrix<dec50, 6, 1> y;
  y << exact_start.momentum.components, exact_start.vector;
  y = taylor_reference<dec50>(euler_poisson(exact.inertia.moments, exact.lever()), y, dec50(1));
  return y.head<3>().cwiseQuotient(exact.inertia.moments).unaryExpr([](dec50 const& x) {
    return to_double(x);
  });
}

// 2. The same from the scheme, at finer and finer steps. Gives how far order 4 is from the power series.
double benchmark(book::Program& program) {
  auto const [top, spin] = bruls_cardona_top<double>();
  std::vector<book::Program::Row> rows;
  auto const row = [](std::string const& how, Vector3d const& w, std::string const& error) {
    return book::Program::Row{how, book::number(w[0], 12), book::number(w[1], 12), book::number(w[2], 12),
                              error};
  };
  auto plot = book::Plot("step, s", "error of the angular velocity after 1 s, rad/s").log_x().log_y();
  double agreement = 0;
  Vector3d const truth = benchmark_in_50_digits();
  for (auto const& [order, counts] :
       {std::pair(2, std::vector{1000, 2000, 4000, 8000, 16000, 32000}),
        std::pair(4, std::vector{1000, 2000, 4000, 8000, 16000, 32000, 64000})}) {
    std::vector<double> steps, errors;
    for (int const count : counts) {
      HeavyTopScheme<> const scheme(top, 1.0 / count, order);
      auto state = release(top, identity<double>(SO<3>{}), spin);
      for (int k = 0; k < count; ++k) scheme.advance(state);
      Vector3d const omega = body_velocity(top.inertia, state.momentum).coordinates;
      steps.push_back(scheme.step()), errors.push_back((omega - truth).norm());
      if (count == counts.back())
        rows.push_back(
            row(book::text("order ", order, ", step 1/", count, " s"), omega, book::number(errors.back())));
    }
    double const measured = book::exponent(steps, errors);
    agreement = errors.back();
    plot.curve(steps, errors, "order " + std::to_string(order), {.dots = true});
    program.figure("order_" + std::to_string(order), measured,
                   "order of the scheme of order " + std::to_string(order));
    program.claim(book::measured(std::abs(measured - order)) < 0.05,
                  "the scheme of order " + std::to_string(order) + " has that order");
  }
  rows.push_back(row("power series, 50 digits", truth, ""));
  program.table(
      "benchmark", {"method", "Omega_1", "Omega_2", "Omega_3", "error"}, rows,
      "The top of Brüls and Cardona: its angular velocity after one second, rad/s in the body frame.");
  program.picture("orders", plot.svg(),
                  "The benchmark at finer and finer steps. The composition of five steps is of order four.");
  program.figure("agreement", agreement, "order 4 and the power series apart, rad/s");
  return agreement;
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "the benchmark of heavy tops to nine places, and two orders of steps");
  double const agreement = benchmark(program);
  program.claim(book::measured(agreement) < 1e-9, "the benchmark comes out to 1e-9 rad/s");
  program.headline("benchmark to " + book::number(agreement, 2) + " rad/s", agreement);
  return program.finish();
}
