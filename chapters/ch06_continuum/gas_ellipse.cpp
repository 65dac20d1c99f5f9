// A cloud of gas spreads into empty space: an exact solution of the field equations, and what it keeps.
//
// What is shown. The cloud stays an ellipse, x = A(t) X, and A(t) is known to rounding from power series. The
// field equations of the library, which know nothing of ellipses, vanish on it at every point and time; its
// stress is a pressure, the one of the gas law. Turned ellipses keep two angular momenta, that of space and
// that of the labels of the gas, and for gamma = 2 the mean square radius is a parabola in time to the last
// digit.
//
// Dirichlet, Ovsyannikov and Dyson found the solution; graded_body.hpp has the three lines that prove it.
//
// Compiled at -O2: it takes many steps.
#include <numbers>

#include "actio/continuum/stresses.hpp"
#include "actio/jets/field_equations.hpp"
#include "book/plot.hpp"
#include "gas_ellipse.hpp"
#include "witness/draw.hpp"

using namespace actio;
using Matrix2d = actio::Matrix<double, 2, 2>;
using Vector2d = actio::Vector<double, 2>;

LinearState<double, 2> state_after(EllipticGas const& gas, double time) {
  return taylor_reference(state_rate<2>(gas), thrown_gas(), time);
}

// ---- 1. The field equations of a gas at random points, over mass times acceleration, and its stress beside
// the gas law; on the ellipses of `mover`.
struct Misses {
  double equation = 0, stress = 0;
};
Misses misses(EllipticGas const& gas, EllipticGas const& mover) {
  auto const medium = gas.medium();
  Draw draw(6);
  Misses most;
  for (int k = 0; k < 200; ++k) {
    double const start = 2.5 * (draw.number<double>() + 1), angle = std::numbers::pi * draw.number<double>(),
                 radius = 0.95 * std::abs(draw.number<double>());
    auto const motion = linear_motion<2>(mover, state_after(mover, start), start);
    Event<double, 2> const x(start + 0.02 * draw.number<double>(), radius * std::cos(angle),
                             radius * std::sin(angle));
    auto const jet = second_jet(motion, x);
    Vector2d const inertia = medium.rho(jet.particle()) * jet.acceleration();
    most.equation = std::max(most.equation, euler_lagrange(medium, jet).norm() / inertia.norm());
    double const pressure =
        gas.K * std::pow(medium.rho(jet.particle()) / determinant(jet.gradient()), gas.gamma);
    most.stress = std::max(most.stress,
                           (cauchy_stress(medium, jet) + pressure * Matrix2d::Identity()).norm() / pressure);
  }
  return most;
}

// ---- 2. What is kept: the largest change over the size of what changes, over twenty units of time.
struct Kept {
  double energy = 0, momentum = 0, circulation = 0, parabola = 0;
};
Kept kept(EllipticGas const& gas) {
  auto const first = thrown_gas();
  Matrix2d const A0 = part_of<2>(first, 0), V0 = part_of<2>(first, 1);
  auto const in_space = [](Matrix2d const& A, Matrix2d const& V) {
    return Matrix2d(A * V.transpose() - V * A.transpose());
  };
  auto const in_labels = [](Matrix2d const& A, Matrix2d const& V) {
    return Matrix2d(A.transpose() * V - V.transpose() * A);
  };
  double const E = gas.energy(A0, V0);
  Kept most;
  for (double t = 1; t <= 20; ++t) {
    auto const state = state_after(gas, t);
    Matrix2d const A = part_of<2>(state, 0), V = part_of<2>(state, 1);
    double const size = A.norm() * V.norm(),
                 parabola = A0.squaredNorm() + 2 * t * A0.cwiseProduct(V0).sum() + E * t * t;
    most.energy = std::max(most.energy, std::abs(gas.energy(A, V) - E) / E);
    most.momentum = std::max(most.momentum, (in_space(A, V) - in_space(A0, V0)).norm() / size);
    most.circulation = std::max(most.circulation, (in_labels(A, V) - in_labels(A0, V0)).norm() / size);
    most.parabola = std::max(most.parabola, std::abs(A.squaredNorm() / parabola - 1));
  }
  return most;
}

// ---- 3. The ellipses, and the paths of eight particles of the rim.
std::string ellipses(EllipticGas const& gas) {
  auto plot = book::Plot("x", "y").equal().size(660, 560);
  std::vector<Vector2d> rim;
  for (int k = 0; k <= 96; ++k)
    rim.emplace_back(std::cos(2 * std::numbers::pi * k / 96), std::sin(2 * std::numbers::pi * k / 96));
  int colour = 1;
  for (double const time : {0.0, 0.6, 1.2, 2.4}) {
    Matrix2d const A = part_of<2>(state_after(gas, time), 0);
    std::vector<double> x, y;
    for (auto const& X : rim) x.push_back((A * X)[0]), y.push_back((A * X)[1]);
    plot.curve(x, y, "t = " + book::number(time), {.colour = colour++, .width = 1.8});
  }
  for (int k = 0; k < 96; k += 12) {
    std::vector<double> x, y;
    for (double time = 0; time <= 2.4001; time += 0.08) {
      Vector2d const place = part_of<2>(state_after(gas, time), 0) * rim[k];
      x.push_back(place[0]), y.push_back(place[1]);
    }
    plot.curve(x, y, k ? "" : "paths of particles", {.colour = 6, .width = 0.9, .dashed = true});
  }
  return plot.svg();
}

int main(int argc, char** argv) {
  book::Program program(
      argc, argv, "a turning cloud of gas spreads into empty space: an exact solution, and what it keeps");
  EllipticGas const air{0.2, 1.4}, shallow{0.25, 2};

  std::vector<book::Program::Row> rows;
  double equation = 0, stress = 0, invariants = 0;
  for (auto const& [name, gas] : {std::pair{"air, 7/5", air}, std::pair{"2", shallow}}) {
    Misses const miss = misses(gas, gas);
    Kept const same = kept(gas);
    rows.push_back({name, book::number(miss.equation, 2), book::number(miss.stress, 2),
                    book::number(same.energy, 2), book::number(same.momentum, 2),
                    book::number(same.circulation, 2), book::number(same.parabola, 2)});
    equation = std::max(equation, miss.equation), stress = std::max(stress, miss.stress);
    invariants = std::max({invariants, same.energy, same.momentum, same.circulation});
  }
  program.table("misses",
                {"gamma", "field equations", "stress", "energy", "momentum", "circulation", "parabola"}, rows,
                "Residual of the field equations over mass times acceleration, of the Cauchy stress plus "
                "the pressure over the pressure; relative changes over 20 units of time.");
  program.picture("ellipses", ellipses(air), "A cloud of air spreads into empty space.");
  program.figure("equation", equation, "field equations over mass times acceleration, at 400 random points");
  double const stiffer = misses(air, {air.K * 1.01, air.gamma}).equation;
  program.figure("stiffer", stiffer,
                 "the same for air on the ellipses of a gas that is stiffer by one in a hundred");
  program.figure("stress", stress, "Cauchy stress plus pressure, over the pressure");
  program.figure("invariants", invariants, "largest relative change of energy, momentum and circulation");
  double const parabola = kept(shallow).parabola, no_parabola = kept(air).parabola;
  program.figure("parabola", parabola, "gamma = 2: mean square radius beside its parabola");
  program.figure("no_parabola", no_parabola, "air: the same");

  program.claim(book::measured(equation) < 1e-13 && book::measured(stiffer) > 5e-3,
                "the field equations vanish on the solution to rounding, and on no other gas's");
  program.claim(book::measured(stress) < 1e-13, "the stress is the pressure of the gas law");
  program.claim(book::measured(invariants) < 1e-13, "energy, momentum and circulation are kept to rounding");
  program.claim(book::measured(parabola) < 1e-13 && book::measured(no_parabola) > 1e-3,
                "the mean square radius is a parabola for gamma = 2, and not for air");
  program.headline("field equations of an exact solution to " + book::number(equation, 2), equation);
  return program.finish();
}
