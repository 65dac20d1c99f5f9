// Media through the command: exact answers, balances, bad input.
#include <array>
#include <cmath>

#include "medium_scene.hpp"

namespace {

using namespace command;

constexpr double pi = 3.14159265358979323846;

/// A simple wave in a gas with rho = K = 1, gamma = 3: the place at X and t, by Newton's iteration for the
/// characteristic that arrives there.
double place_in_simple_wave(double X, double t) {
  auto const J = [](double from) { return 1 + 0.1 * std::cos(2 * pi * from); };
  double from = X;
  for (int k = 0; k < 60; ++k) {
    double const j = J(from), slope = -0.2 * pi * std::sin(2 * pi * from);
    double const residual = from + std::sqrt(3.0) / (j * j) * t - X;
    from -= residual / (1 - 2 * std::sqrt(3.0) / (j * j * j) * slope * t);
  }
  return from + 0.1 * std::sin(2 * pi * from) / (2 * pi) + std::sqrt(3.0) * (2 / J(from) - 1) * t;
}
/// The largest error of places at the end of a run with so many cells.
double error_of_simple_wave(int cells, std::string const& material, std::string const& method) {
  Folder const folder;
  Medium wave;
  wave.mesh = "shape = \"box\", lower = [0, 0], upper = [1, 0.125], cells = [" + std::to_string(cells) +
              ", " + std::to_string(cells / 8) + "], periodic = [true, true]";
  wave.material = material, wave.method = method;
  wave.initial =
      "placement = [\"X + 0.1*sin(2*pi*X)/(2*pi)\", \"Y\"]\n"
      "velocity = [\"sqrt(3)*(1/(1 + 0.1*cos(2*pi*X)) - 1)\", \"0\"]";
  wave.output = "snapshots = []\n";
  run_in(folder, wave);
  Table const nodes = read_csv(folder / "out/snapshots/000001.csv");
  double worst = 0;
  for (std::size_t k = 0; k < nodes.rows.size(); ++k)
    worst = std::max(worst, std::abs(nodes["x"][k] - place_in_simple_wave(nodes["X"][k], 0.2)));
  return worst;
}

/// A neo-Hookean box in a standing shear wave.
Medium shear_wave() {
  Medium out;
  out.kind = "elastic_body", out.material = "name = \"neo_hookean\", mu = 1, kappa = 3";
  out.mesh = "shape = \"box\", lower = [0, 0], upper = [1, 0.25], cells = [32, 8], periodic = [true, true]";
  out.initial = "placement = [\"X\", \"Y + 0.3*sin(2*pi*X)\"]";
  out.method = "step = 0.005", out.until = "1", out.every = "0.5";
  return out;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(medium_scenes)

BOOST_AUTO_TEST_CASE(a_simple_wave_has_order_two_on_both_ways) {
  std::string const gas = "name = \"polytropic_gas\", K = 1, gamma = 3";
  // The generic implementation steps what has order 4 in time, and still cells of order 2.
  for (std::string const method : {"", "order = 4"}) {
    double const coarse = error_of_simple_wave(32, gas, method), fine = error_of_simple_wave(64, gas, method);
    double const order = std::log2(coarse / fine);
    BOOST_TEST_MESSAGE("simple wave, '" << method << "': errors " << coarse << " and " << fine << ", order "
                                        << order);
    BOOST_TEST(std::abs(order - 2) <= 0.05);
  }
}

BOOST_AUTO_TEST_CASE(a_shear_wave_has_the_frequency_of_the_mesh_to_rounding) {
  Folder const folder;
  Medium wave = shear_wave();
  wave.output = "snapshots = []\nsnapshot_at = [0.5, 1]\n";
  run_in(folder, wave);
  // sin(w dt/2)/dt = sin(k h/2)/h with the wave number k = 2 pi, at rest at the start.
  double const h = 1.0 / 32, dt = 0.005, w = 2 / dt * std::asin(dt * std::sin(pi * h) / h);
  for (int const n : {0, 1}) {
    Table const nodes = read_csv(folder / "out/snapshots/00000" + std::to_string(n) + ".csv");
    double worst = 0;
    for (std::size_t k = 0; k < nodes.rows.size(); ++k) {
      double const exact = 0.3 * std::sin(2 * pi * nodes["X"][k]) * std::cos(w * 0.5 * (n + 1));
      worst = std::max(worst, std::abs(nodes["y"][k] - nodes["Y"][k] - exact));
      worst = std::max(worst, std::abs(nodes["x"][k] - nodes["X"][k]));
    }
    // 200 steps, each with a few roundings of numbers of about 1.
    BOOST_TEST(worst <= 200 * 20 * 2.2e-16, worst);
  }
}

BOOST_AUTO_TEST_CASE(a_thrown_block_keeps_its_momenta_and_its_energy_swings_little) {
  Folder const folder;
  Medium block;
  block.kind = "elastic_body", block.material = "name = \"neo_hookean\", mu = 1, kappa = 3";
  block.mesh = "shape = \"box\", lower = [-1, -0.5], upper = [1, 0.5], cells = [16, 8]";
  block.initial = "velocity = [\"1 - 0.7*Y + 0.3*X\", \"0.5 + 0.7*X\"]";
  block.until = "5", block.every = "0.25";
  block.quantities = "\"energy\", \"momentum\", \"angular_momentum\", \"noether_balance\", \"min_jacobian\"";
  Table const rows = run_in(folder, block);
  // Mass 2, momentum (2, 1); roundings of some thousand steps that need not be of one sign.
  double const bound = 1e-13;
  for (std::size_t k = 0; k < rows.rows.size(); ++k) {
    BOOST_TEST(std::abs(rows["momentum_x"][k] - 2) <= bound);
    BOOST_TEST(std::abs(rows["momentum_y"][k] - 1) <= bound);
    BOOST_TEST(std::abs(rows["angular_momentum_z"][k] - rows["angular_momentum_z"][0]) <= bound);
    // Sums of sixteen terms.
    BOOST_TEST(rows["noether_balance"][k] <= 16 * 2.2e-16);
    BOOST_TEST(rows["min_jacobian"][k] > 0.5);
    BOOST_TEST(std::abs(rows["energy"][k] / rows["energy"][0] - 1) <= 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(a_gas_ellipse_expands_as_dirichlet_has_it) {
  Folder const folder;
  Medium gas;
  gas.mesh = "shape = \"disc\", radius = 1, cells = [8, 16]";
  gas.material = "name = \"polytropic_gas\", K = 0.25, gamma = 2";
  gas.system = "density = \"max(0, 1 - X^2 - Y^2)\"\n";
  gas.initial = "placement = [\"X\", \"0.5*Y\"]";
  gas.until = "1", gas.every = "1", gas.output = "snapshots = []\n";
  run_in(folder, gas);
  // A'' = A^-T/det A for a diagonal A, by small Runge-Kutta steps.
  std::array<double, 4> s{1, 0.5, 0, 0};
  auto const rate = [](std::array<double, 4> const& y) {
    double const det = y[0] * y[1];
    return std::array<double, 4>{y[2], y[3], 1 / (y[0] * det), 1 / (y[1] * det)};
  };
  auto const moved = [](std::array<double, 4> y, std::array<double, 4> const& k, double h) {
    for (std::size_t i = 0; i < 4; ++i) y[i] += h * k[i];
    return y;
  };
  for (int n = 0; n < 1000; ++n) {
    auto const a = rate(s), b = rate(moved(s, a, 5e-4)), c = rate(moved(s, b, 5e-4)),
               e = rate(moved(s, c, 1e-3));
    for (std::size_t i = 0; i < 4; ++i) s[i] += 1e-3 / 6 * (a[i] + 2 * b[i] + 2 * c[i] + e[i]);
  }
  Table const nodes = read_csv(folder / "out/snapshots/000001.csv");
  double worst = 0, square = 0;
  for (std::size_t k = 0; k < nodes.rows.size(); ++k) {
    double const X = nodes["X"][k], Y = nodes["Y"][k];
    double const off = std::hypot(nodes["x"][k] - s[0] * X, nodes["y"][k] - s[1] * Y);
    worst = std::max(worst, off), square += off * off;
  }
  BOOST_TEST_MESSAGE("gas ellipse: A(1) = (" << s[0] << ", " << s[1] << "), largest error of a place "
                                             << worst << ", mean "
                                             << std::sqrt(square / static_cast<double>(nodes.rows.size())));
  // Order 2 with cells of a sixteenth: h^2 times a number of order 1.
  BOOST_TEST(worst <= 0.02);
}

BOOST_AUTO_TEST_CASE(a_block_falls_as_galileo_has_it) {
  Folder const folder;
  Medium block;
  block.kind = "elastic_body", block.material = "name = \"saint_venant_kirchhoff\", lambda = 1, mu = 1";
  block.mesh = "shape = \"box\", lower = [0, 0, 0], upper = [2, 1, 1], cells = [4, 2, 2]";
  block.system = "load = { gravity = \"z\" }\n";
  block.initial = "velocity = [\"0.5 - 0.2*Y\", \"0.2*X\", \"1\"]";
  block.until = "2", block.every = "0.5", block.quantities = "\"momentum\", \"energy\"";
  Table const rows = run_in(folder, block);
  // The force is the same everywhere, so that momentum is exact: mass 2, and 1 - t for the velocity.
  for (std::size_t k = 0; k < rows.rows.size(); ++k)
    BOOST_TEST(std::abs(rows["momentum_z"][k] - 2 * (1 - rows["t"][k])) <= 1e-12);
  BOOST_TEST(std::abs(rows["energy"].back() / rows["energy"].front() - 1) <= 1e-3);
}

BOOST_AUTO_TEST_CASE(energy_is_conserved_where_that_is_asked) {
  Folder const folder;
  Medium wave = shear_wave();
  wave.mesh = "shape = \"box\", lower = [0, 0], upper = [1, 0.25], cells = [8, 2], periodic = [true, true]";
  wave.method = "conserve = \"energy\"\nstep = 0.02", wave.quantities = "\"energy\", \"momentum\"";
  wave.initial = "placement = [\"X + 0.05*sin(2*pi*X)\", \"Y + 0.3*sin(2*pi*X)\"]";
  wave.every = "0.1";
  Table const rows = run_in(folder, wave);
  for (double const e : rows["energy"]) BOOST_TEST(std::abs(e / rows["energy"][0] - 1) <= 1e-13);
}

BOOST_AUTO_TEST_CASE(memory_is_told_and_refused_before_it_is_touched) {
  Folder const folder;
  Medium large;
  large.mesh = "shape = \"box\", lower = [0, 0], upper = [1, 1], cells = [1000000, 900]";
  check_ends(large, 2, "cells: 900000000 cells take about ");
  auto const told = actio({"run", folder.write("small.toml", Medium{}.text()), "--dry-run"});
  BOOST_TEST(told.out.find("memory      at most about ") != std::string::npos, told.out);
}

BOOST_AUTO_TEST_CASE(bad_input_has_its_own_message) {
  auto const changed = [](auto const& change) {
    Medium out;
    change(out);
    return out;
  };
  auto const initial = [&](std::string const& text) { return changed([&](Medium& m) { m.initial = text; }); };
  auto const mesh = [&](std::string const& text) { return changed([&](Medium& m) { m.mesh = text; }); };
  auto const system = [&](std::string const& text) { return changed([&](Medium& m) { m.system = text; }); };
  auto const material = [&](std::string const& text) {
    return changed([&](Medium& m) { m.material = text; });
  };

  check_ends(initial("placement = [\"X + 0.5*sin(2*pi*X)\", \"Y\"]"), 2,
             "placement: the Jacobian must be positive, and it is -2.");
  check_ends(initial("placement = [\"X + 0.5*sin(2*pi*X)\", \"Y\"]"), 2, "in cell (1");
  check_ends(initial("placement = [\"X + sqrt(X - 0.5)\", \"Y\"]"), 2, "a finite value is expected, found");
  check_ends(initial("placement = [\"X + Q\", \"Y\"]"), 2, "unknown name 'Q'");
  check_ends(initial("placement = [\"2*X\", \"Y\"]"), 2,
             "placement minus the identity is periodic along it; here it jumps by 1 ");
  check_ends(initial("velocity = [\"X\", \"0\"]"), 2, "the velocity is periodic along it");
  check_ends(initial("velocity = [\"X\"]"), 2,
             "velocity: 2 formulas in X, Y are expected, one for each dimension");
  check_ends(mesh("shape = \"cube\""), 2, "unknown shape 'cube'");
  check_ends(mesh("shape = \"disc\", radius = 1, cells = [4, 8], periodic = [true, true]"), 2, "'periodic'");
  check_ends(mesh("shape = \"box\", lower = [0, 0], upper = [1, 0], cells = [4, 4]"), 2,
             "upper: a number greater than 0 is expected, found 0");
  check_ends(mesh("shape = \"file\", file = \"none.msh\""), 2, "none.msh");
  check_ends(system("boundary = { lid = \"fixed\" }"), 2, "the body has no side 'lid'");
  check_ends(system("density = \"-1\""), 2,
             "density: a positive mass per reference volume is expected, found -1");
  check_ends(system("load = { gravity = \"9.81*h\" }"), 2, "h");
  check_ends(system("load = { traction = { lid = [0, 1] } }"), 2, "the body has no side 'lid'");
  check_ends(material("name = \"neo_hookean\", mu = 1, kappa = 1"), 2,
             "neo_hookean is a material of elastic_body");
  check_ends(material("name = \"polytropic_gas\", K = 1"), 2, "needs 'gamma'");
  check_ends(material("name = \"polytropic_gas\", K = 1, gamma = 1"), 2,
             "gamma: a number greater than 1 is expected, found 1");
  check_ends(changed([](Medium& m) { m.method = "step = 0.1"; }), 3,
             "step: steps of length 0.1 are not stable; a step of 0.0");
  check_ends(changed([](Medium& m) {
               m.quantities = "\"circulation\"", m.mesh =
                                                     "shape = \"box\", lower = [0, 0, 0], upper "
                                                     "= [1, 1, 1], cells = [2, 2, 2]";
             }),
             2, "quantities: circulation is that of bodies in the plane");
}

BOOST_AUTO_TEST_CASE(a_cell_that_would_turn_inside_out_ends_the_run_before_it_does) {
  Medium clash;
  clash.initial = "velocity = [\"-3*sin(2*pi*X)\", \"0\"]";
  clash.material = "name = \"polytropic_gas\", K = 0.001, gamma = 1.4", clash.until = "1";
  clash.every = "0.05", clash.method = "step = 0.01";
  check_ends(clash, 3, " would turn cell (", false);
  check_ends(clash, 3, "the longest stable step before it is ", false);
}

BOOST_AUTO_TEST_SUITE_END()
