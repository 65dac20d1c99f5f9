// Heavy tops: a benchmark to nine places, a toy whose axis draws loops, cusps and waves, and the spin at
// which it goes to sleep.
//
// What is shown. A body held at a point under gravity has one symmetry, about the vertical. The scheme steps
// its momentum and the vertical in the body frame: half of the impulse of gravity, a step of Moser and
// Veselov's, the other half. Momentum about the vertical, length of the vertical and, for a symmetric top,
// momentum about its axis are conserved to rounding at every step length and every order. The benchmark of
// Brüls and Cardona is compared with a power series in 50 digits.
// Read first. The section "A vector that is carried along" of chapter 5.
//
//   Omega, Pi   body velocity, rad/s, and body momentum, J s     p     weight times centre of mass, J
//   Gamma       the vertical in the body frame u height of the axis, cosine of its angle with the vertical
#include "actio/rigid_body/heavy_top.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"
#include "book/sphere.hpp"
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

// A toy: a thin disc of 100 g, 4 cm in radius, 3 cm above the tip. The disc is flat, so that one of its
// Lambda is zero.
double const disc = 0.1 * 0.04 * 0.04 / 4;
auto const toy = held_at_a_point<double>(0.1, inertia_from_moments(disc, disc, 2 * disc),
                                         Vector3d(0, 0, 0.03), Vector3d(0, 0, -9.81));
// Leaning, spinning about its axis in the body frame, and going round the vertical at a rate of its own:
// attitude and state.
auto let_go(double lean, double spin, double round) {
  auto const g = exp(velocity(SO<3>{}, Vector3d(lean, 0, 0)));
  Vector3d const omega = round * g.value.transpose() * Vector3d::UnitZ();
  return std::pair(g, release(toy, g, velocity(SO<3>{}, Vector3d(omega[0], omega[1], spin))));
}
// Its spin, rad/s, the step, s, the rate at which it goes round, rad/s, and a degree.
double const fast = 90, h = 2e-4, rate = toy.lever()[2] / (toy.inertia.moments[2] * fast),
             degree = M_PI / 180;

// 1. The benchmark: a disc of 15 kg on an arm of 1 m. The angular velocity after a second, from 50 digits and
//    from the scheme. Here from 50 digits.
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

// And here from the scheme, at finer and finer steps. Gives how far order 4 and the power series are apart.
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

// 2. The toy spins at 90 rad/s and is let go leaning by 35, 65 and 100 degrees: going round backwards, not at
// all, and forwards. Gives how far the lowest point of the cusps is from the closed form.
double loops_cusps_and_waves(book::Program& program) {
  HeavyTopScheme<> const scheme(toy, h, 4);
  auto sphere = book::Sphere(-60, 28).axes({"", "", "up"});
  double lowest = 1, before = 1, now = 1;
  for (auto const& [lean, round, name] :
       {std::tuple(35, -1.5 * rate, "pushed back: loops"), std::tuple(65, 0.0, "let go: cusps"),
        std::tuple(100, 0.6 * rate, "pushed on: waves")}) {
    auto [g, state] = let_go(lean * degree, fast, round);
    std::vector<Vector3d> trace;
    for (int k = 0; k < 7500; ++k) {
      if (k % 10 == 0) trace.push_back(g.value.col(2));
      scheme.advance(state, g);
      double const u = state.vector[2];
      // A low point of the cusps: the end of a parabola through three heights.
      if (round == 0.0 && now < before && now < u)
        lowest = now - std::pow(u - before, 2) / (8 * (u - 2 * now + before));
      before = now, now = u;
    }
    sphere.curve(trace, name);
  }
  program.picture("loops", sphere.svg(),
                  "Where the axis of the toy points in a second and a half. All three spin at 90 rad/s; what "
                  "differs is how they are let go.");
  // Let go, the axis falls from height u0 to the root of b (1 - u^2) = a^2 (u0 - u), with a = Pi_3/I_1 and
  // b = 2p/I_1.
  double const a = toy.inertia.moments[2] * fast / toy.inertia.moments[0],
               b = 2 * toy.lever()[2] / toy.inertia.moments[0], u0 = std::cos(65 * degree);
  double const root = 2 * (a * a * u0 - b) / (a * a + std::sqrt(std::pow(a, 4) - 4 * b * (a * a * u0 - b)));
  program.figure("fall", std::acos(root) / degree, book::number(std::acos(root) / degree, 9) + "°",
                 "how far it leans at its lowest, closed form");
  program.figure("fall_error", std::abs(lowest - root),
                 "height of the lowest point of the scheme against it");
  return lowest - root;
}

// 3. Upright, a little beside it: above the spin sqrt(4 p I_1)/I_3 it sleeps, below it falls over and comes
// back. Gives the largest lean of either, degrees.
std::array<double, 2> asleep_and_awake(book::Program& program) {
  double const critical = std::sqrt(4 * toy.lever()[2] * toy.inertia.moments[0]) / toy.inertia.moments[2];
  program.figure("critical", critical, book::number(critical, 4) + " rad/s",
                 "spin above which the upright toy sleeps");
  auto sleep = book::Plot("time, s", "lean, degrees").size(660, 320);
  std::array<double, 2> most{};
  HeavyTopScheme<> const scheme(toy, h, 4);
  for (int const awake : {0, 1}) {
    auto upright = let_go(degree, (awake ? 0.9 : 1.1) * critical, 0).second;
    std::vector<double> time, lean;
    for (int k = 0; k < 20000; ++k) {
      scheme.advance(upright);
      double const angle =
          std::atan2(std::hypot(upright.vector[0], upright.vector[1]), upright.vector[2]) / degree;
      most[awake] = std::max(most[awake], angle);
      if (k % 25 == 0) time.push_back(k * h), lean.push_back(angle);
    }
    sleep.curve(time, lean, awake ? "nine tenths of the critical spin" : "eleven tenths");
  }
  program.picture("sleep", sleep.svg(), "Two tops let go one degree beside the vertical.");
  return most;
}

// 4. What is conserved over 200000 steps of 2 ms: the waves, at order two, with steps ten times as long.
std::array<double, 4> drifts_over_many_steps(book::Program& program) {
  HeavyTopScheme<> const coarse(toy, 10 * h);
  auto const start = let_go(100 * degree, fast, 0.6 * rate).second;
  double const size = start.momentum.components.norm();
  std::array<double, 4> drifts{};
  auto state = start;
  for (int k = 0; k < 200000; ++k) {
    coarse.advance(state);
    double const changes[] = {
        (state.momentum.components.dot(state.vector) - start.momentum.components.dot(start.vector)) / size,
        state.vector.norm() - 1, (state.momentum.components[2] - start.momentum.components[2]) / size,
        toy.energy(state) / toy.energy(start) - 1};
    for (int i = 0; i < 4; ++i) drifts[i] = std::max(drifts[i], std::abs(changes[i]));
  }
  auto const shown = [&](char const* name, int i) {
    return book::Program::Row{name, book::number(drifts[i], 2)};
  };
  std::vector<book::Program::Row> const rows = {shown("momentum about the vertical", 0),
                                                shown("length of the vertical", 1),
                                                shown("momentum about the axis", 2), shown("energy", 3)};
  program.table("kept", {"quantity", "largest change, relative"}, rows,
                "The toy with waves over 200 000 steps of 2 ms, order 2. No theorem conserves the energy.");
  return drifts;
}

// 5. What must be so. Three roundings in each of 200000 steps walk at random: a hundredfold of room, as
//    everywhere.
void what_must_be_so(book::Program& program, double agreement, double gap, std::array<double, 2> const& most,
                     std::array<double, 4> const& drifts) {
  double const walk = 100 * 0x1p-52 * std::sqrt(200000.0),
               casimirs_and_axis = std::max({drifts[0], drifts[1], drifts[2]});
  program.claim(book::measured(agreement) < 1e-9, "the benchmark comes out to 1e-9 rad/s");
  program.claim(book::measured(std::abs(gap)) < 1e-6, "the axis falls as far as the closed form says");
  program.claim(book::measured(most[0]) < 4 && book::measured(most[1]) > 20,
                "above the critical spin the top sleeps, below it wakes");
  program.claim(book::measured(casimirs_and_axis) < walk && book::measured(drifts[3]) < 0.01,
                "both Casimirs and the momentum about the axis are conserved to rounding, and the energy "
                "does not run away");
  program.headline("benchmark to " + book::number(agreement, 2) + " rad/s; what is conserved, to " +
                       book::number(casimirs_and_axis, 2),
                   agreement);
}

int main(int argc, char** argv) {
  book::Program program(argc, argv,
                        "heavy tops: a benchmark to nine places, loops and cusps on a sphere, and the spin "
                        "that lets a top sleep");
  double const agreement = benchmark(program);
  double const gap = loops_cusps_and_waves(program);
  auto const most = asleep_and_awake(program);
  auto const drifts = drifts_over_many_steps(program);
  what_must_be_so(program, agreement, gap, most, drifts);
  return program.finish();
}
