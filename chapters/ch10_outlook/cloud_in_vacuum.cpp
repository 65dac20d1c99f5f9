// A cloud of gas spreads into empty space: a mesh beside the exact ellipse, and both conserving variants.
//
// What is shown. The cloud of chapter 6 stays an ellipse, x = A(t) X, and A is known to rounding. A smooth
// mesh follows it with an error of second order, one whose lines have kinks with a lower one. With
// `conserve = form` the step is explicit and the energy oscillates; with `conserve = energy` it is implicit
// and the energy is constant, to rounding. Both conserve the angular momentum. Read first. ch06_gas_ellipse,
// section 10B.7.
//
// Compiled at -O2: it takes many steps.
#include <array>
#include <numbers>

#include "actio/meshes/body_shapes.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"
#include "ch06_continuum/gas_ellipse.hpp"
#include "rim_circulation.hpp"

using namespace actio;
using namespace actio::media;
using book::measured, book::number;
using Place = std::array<double, 2>;
using Square = actio::Matrix<double, 2, 2>;

// 1. The exact motion: A and its rate at a time, from power series.
EllipticGas const air{0.2, 1.4};
std::array<Square, 2> exact_at(double time) {
  auto const state = taylor_reference(state_rate<2>(air), thrown_gas(), time);
  return {part_of<2>(state, 0), part_of<2>(state, 1)};
}

// 2. Round bodies of cells, the smooth image of a square and a core in four sectors, with kinks; the cloud.
BodyMesh smooth_disc(int n) {
  BodyMesh mesh = box_mesh({-1, -1}, {1, 1}, {n, n});
  for (auto& node : mesh.nodes) {
    double const u = node[0], v = node[1];
    node[0] = u * std::sqrt(1 - v * v / 2), node[1] = v * std::sqrt(1 - u * u / 2);
  }
  return mesh;
}
BodyMesh kinked_disc(int n) { return disc_mesh(1, {n / 4, n / 2}); }

Place image(Square const& M, auto const& X) {
  return {M(0, 0) * X[0] + M(0, 1) * X[1], M(1, 0) * X[0] + M(1, 1) * X[1]};
}
MediumOnMesh<2> cloud(BodyMesh const& mesh, double step, Conserve conserve) {
  auto const [A, V] = exact_at(0);
  auto const by = [](Square const& M) { return [M](Place const& X) { return image(M, X); }; };
  BodyStart<2> body;
  body.density = [](Place const& X) {
    return std::pow(std::max(0.0, 1 - X[0] * X[0] - X[1] * X[1]), 1 / (air.gamma - 1));
  };
  body.placement = by(A), body.velocity = by(V);
  return {mesh, stored_energy<2>(isentropic_gas(air.K, air.gamma)), body, {step, 2, conserve}};
}

// 3. Distance from the ellipse, root mean square over the mass.
double distance(MediumOnMesh<2> const& gas) {
  Square const A = exact_at(gas.time())[0];
  auto const x = gas.places();
  double sum = 0, mass = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    auto const exact = image(A, gas.mesh().nodes[k]);
    double const m = gas.masses()[k], far = std::hypot(x[k][0] - exact[0], x[k][1] - exact[1]);
    sum += m * far * far, mass += m;
  }
  return std::sqrt(sum / mass);
}

// 4. A run, and what it has changed: relative, the largest; the order of its error, from a coarser mesh.
struct Run {
  double error = 0, energy = 0, angular = 0, circulation = 0, order = 0;
};
Run run(BodyMesh const& mesh, int steps, Conserve conserve) {
  auto gas = cloud(mesh, 1.5 / steps, conserve);
  double const E = gas.energies().total(), L = gas.angular_momentum()[2], around = rim_circulation(gas);
  Run out;
  for (int k = 0; k < steps; ++k) {
    gas.step();
    out.energy = std::max(out.energy, std::abs(gas.energies().total() / E - 1));
    out.angular = std::max(out.angular, std::abs(gas.angular_momentum()[2] / L - 1));
  }
  out.error = distance(gas), out.circulation = std::abs(rim_circulation(gas) / around - 1);
  return out;
}

// 5. The cells and the exact rim at three times.
std::string picture() {
  auto plot = book::Plot("x", "y").equal().size(660, 480);
  auto gas = cloud(smooth_disc(16), 0.02, Conserve::form);
  for (int shown = 0; shown < 3; ++shown, gas.step(60)) {
    auto const x = gas.places();
    auto const closed = [&](std::string const& name, double pen, int count, auto const& point) {
      std::vector<double> a, b;
      for (int k = 0; k <= count; ++k) a.push_back(point(k % count)[0]), b.push_back(point(k % count)[1]);
      plot.curve(a, b, name, {.colour = 1 + shown, .width = pen});
    };
    constexpr int around[] = {0, 1, 3, 2};  // corners of a cell
    for (auto const& cell : gas.mesh().cells) closed("", 0.6, 4, [&](int k) { return x[cell[around[k]]]; });
    closed("t = " + number(gas.time()), 1.6, 96, [A = exact_at(gas.time())[0]](int k) {
      return image(A, Place{std::cos(k * std::numbers::pi / 48), std::sin(k * std::numbers::pi / 48)});
    });
  }
  return plot.svg();
}

// 6. Runs by the explicit step on finer and finer meshes.
constexpr std::array cells_across{12, 24, 48, 96};
std::vector<Run> refined(BodyMesh (*disc)(int)) {
  std::vector<Run> runs;
  for (int const n : cells_across) {
    runs.push_back(run(disc(n), 3 * n, Conserve::form));
    if (runs.size() > 1) runs.back().order = std::log2(runs.end()[-2].error / runs.back().error);
  }
  return runs;
}
void show_refined(book::Program& program, std::vector<Run> const& smooth, std::vector<Run> const& kinked) {
  std::vector<book::Program::Row> rows;
  for (std::size_t k = 0; k < cells_across.size(); ++k) {
    auto const order = [k](Run const& r) { return k > 0 ? number(r.order, 4) : ""; };
    rows.push_back({std::to_string(cells_across[k]), number(smooth[k].error), order(smooth[k]),
                    number(kinked[k].error), order(kinked[k]), number(smooth[k].energy, 2),
                    number(smooth[k].circulation, 2)});
  }
  program.table(
      "form", {"cells across", "error", "order", "with kinks", "order", "energy", "circulation"}, rows,
      "The explicit step: distance from the exact ellipse, root mean square over the mass, on smooth "
      "meshes and on meshes with kinks; relative changes of energy and circulation on the former.");
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "a cloud of gas spreads into empty space, on a disc of cells");
  auto const smooth = refined(smooth_disc), kinked = refined(kinked_disc);
  show_refined(program, smooth, kinked);
  Run const form = smooth[1], energy = run(smooth_disc(24), 72, Conserve::energy);
  std::vector<book::Program::Row> rows;
  for (auto const& [name, r] : {std::pair{"form", form}, std::pair{"energy", energy}})
    rows.push_back(
        {name, number(r.error), number(r.energy, 2), number(r.angular, 2), number(r.circulation, 2)});
  program.table("switch", {"conserve", "error", "energy", "angular momentum", "circulation"}, rows,
                "The two variants on the smooth mesh with 24 cells across.");
  program.picture("ellipse", picture(), "The cells at three times, and the rim of the exact ellipse.");
  double const order = smooth.back().order, kinked_order = kinked.back().order;
  program.figure("order", order, number(order, 4), "order of the error between the two finest meshes");
  program.figure("kinked_order", kinked_order, number(kinked_order, 4), "the same on meshes with kinks");
  program.figure("energy", energy.energy, "change of the energy, conserve = energy");
  program.figure("band", form.energy, "change of the energy, conserve = form");
  program.claim(measured(std::abs(order - 2)) < 0.05, "on a smooth mesh the error has order 2");
  // Some tens of roundings of a sum of a few hundred terms.
  program.claim(measured(std::max(smooth.back().angular, energy.angular)) < 1e-13,
                "angular momentum stays with both variants");
  program.claim(measured(energy.energy) < 1e-13 && measured(form.energy) > 1e-6,
                "energy stays with the second, and not with the first");
  program.headline("order " + number(order, 4) + " on an ellipse in empty space", order);
  return program.finish();
}
