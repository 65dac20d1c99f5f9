// What acts on media through the command: loads as scenes write them, viscosity, what is said of them.
#include <cmath>

#include "medium_scene.hpp"

namespace {

using namespace command;

/// A block of rubber, two cells high, that is free on all sides.
Medium block() {
  Medium out;
  out.kind = "elastic_body", out.material = "name = \"neo_hookean\", mu = 1, kappa = 3";
  out.mesh = "shape = \"box\", lower = [0, 0], upper = [1, 1], cells = [4, 4]";
  out.until = "1", out.every = "0.25", out.quantities = "\"momentum\", \"energy\"";
  return out;
}
bool says(std::string const& text, std::string const& part) {
  BOOST_TEST(text.find(part) != std::string::npos, "expected '" << part << "', found '" << text << "'");
  return true;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(loads_of_media)

// The keys as a scene's table of loads has them, all at once.
BOOST_AUTO_TEST_CASE(a_scene_with_every_load_runs) {
  Medium all = block();
  all.system =
      "[system.load]\ngravity = \"-9.81*y\"\npressure = 0.1\ntraction.right = [0, 1]\n"
      "motion.left = [\"0.1*sin(t)\", \"Y\"]\n[system.obstacle]\npotential = \"exp(-(x - 3)^2 - y^2)\"\n";
  all.until = "0.1", all.every = "0.05", all.quantities = "\"energy\", \"min_jacobian\"";
  all.output = "snapshots = []\n";
  Folder const folder;
  run_in(folder, all);
  Table const nodes = read_csv(folder / "out/snapshots/000001.csv");
  for (std::size_t k = 0; k < nodes.rows.size(); ++k)
    if (nodes["X"][k] == 0) BOOST_TEST(std::abs(nodes["x"][k] - 0.1 * std::sin(0.1)) <= 1e-15);
}

// The side is as long as the box is high: momentum is force times time, to a rounding for each step.
BOOST_AUTO_TEST_CASE(a_traction_gives_momentum) {
  Folder const folder;
  Medium pulled = block();
  pulled.system = "load = { traction.right = [0.3, -0.2] }\n";
  Table const rows = run_in(folder, pulled);
  for (std::size_t k = 0; k < rows.rows.size(); ++k) {
    BOOST_TEST(std::abs(rows["momentum_x"][k] - 0.3 * rows["t"][k]) <= 1e-14);
    BOOST_TEST(std::abs(rows["momentum_y"][k] + 0.2 * rows["t"][k]) <= 1e-14);
  }
}

// The momentum that a pressure gives in all is that of its pulse, which is a hundredth as long as a stable
// step.
BOOST_AUTO_TEST_CASE(a_pulse_of_pressure_is_followed_by_the_default_step_and_a_longer_one_is_remarked_on) {
  Medium pressed = block();
  pressed.mesh += ", periodic = [false, true]";
  pressed.until = "0.5", pressed.every = "0.5";
  pressed.system = "load = { pressure.right = \"exp(-((t - 0.2718)/0.0005)^2)\" }\n";
  Folder const folder;
  double const impulse = 0.0005 * std::sqrt(std::acos(-1.0));
  BOOST_TEST(std::abs(run_in(folder, pressed)["momentum_x"].back() + impulse) <= 1e-6 * impulse);
  pressed.method += "step = 0.01\n";
  BOOST_TEST(says(plan_of(pressed), "step: loads change as a wave that turns by "));
}

// A column that is periodic upwards: the side has a period's length however it bends, and the force across is
// p times that. Kicks at both ends of a step are exact for a pressure that grows with time.
BOOST_AUTO_TEST_CASE(a_pressure_follows_its_side) {
  for (auto const& [pressure, power] : {std::pair{"0.3", 1}, std::pair{"\"0.3*t\"", 2}}) {
    Folder const folder;
    Medium pressed = block();
    pressed.mesh += ", periodic = [false, true]";
    pressed.initial = "placement = [\"X + 0.1*X*sin(2*pi*Y)\", \"Y\"]";
    pressed.system = std::string("load = { pressure.right = ") + pressure + " }\n";
    Table const rows = run_in(folder, pressed);
    for (std::size_t k = 0; k < rows.rows.size(); ++k) {
      BOOST_TEST(std::abs(rows["momentum_x"][k] + 0.3 * std::pow(rows["t"][k], power) / power) <= 1e-14);
      BOOST_TEST(std::abs(rows["momentum_y"][k]) <= 1e-14);
    }
  }
  Medium wrong = block();
  wrong.system = "load = { pressure.rihgt = 1 }\n";
  check_ends(wrong, 2, "the body has no side 'rihgt'; did you mean 'right'?");
  wrong.system = "load = { pressure.right = \"0.1*T\" }\n";
  check_ends(wrong, 2, "unknown name 'T'");
}

BOOST_AUTO_TEST_CASE(the_plan_says_where_gravity_pulls) {
  Medium heavy = block();
  heavy.system = "load = { gravity = \"9.81*y\" }\n";
  says(plan_of(heavy), "gravity pulls along (0, -1) with 9.81 at the centre of the body");
  heavy.system = "load = { gravity = \"-3*x - 4*y\" }\n";
  says(plan_of(heavy), "gravity pulls along (0.6, 0.8) with 5 ");
  heavy.system = "load = { gravity = \"-1/hypot(x, y + 1)\" }\n";
  says(plan_of(heavy), "gravity pulls along (-0.3162, -0.9487) with 0.4 ");
  heavy.system = "load = { gravity = \"7\" }\n";
  says(plan_of(heavy), "gravity does not pull at the centre of the body");
  BOOST_TEST(plan_of(block()).find("gravity") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(what_viscosity_takes_is_told) {
  Medium gas;
  gas.initial = "velocity = [\"-0.8*sin(2*pi*X)\", \"0\"]";
  gas.material = "name = \"polytropic_gas\", K = 1, gamma = 1.4";
  gas.quantities = "\"energy\", \"dissipated\"", gas.until = "0.5", gas.every = "0.05";
  gas.method = "step = 0.0025\nviscosity = { linear = 0.5, quadratic = 2 }";
  Folder const folder;
  Table const rows = run_in(folder, gas);
  double const all = rows["energy"].front();
  for (std::size_t k = 1; k < rows.rows.size(); ++k) {
    BOOST_TEST(rows["dissipated"][k] > rows["dissipated"][k - 1]);
    // The square of the step over that in which sound passes a cell, 1/40, of the energy that moves, 1/25.
    BOOST_TEST(std::abs(rows["energy"][k] + rows["dissipated"][k] - all) <= 0.01 * 0.04);
  }
  BOOST_TEST(rows["dissipated"].back() > 0.005);
  // Without coefficients it is none, bit for bit.
  gas.method = "step = 0.0025", gas.until = "0.1";
  run_in(folder, gas);
  std::string const without = contents(folder / "out/series.csv");
  gas.method = "step = 0.0025\nviscosity = { linear = 0 }";
  run_in(folder, gas);
  BOOST_TEST((contents(folder / "out/series.csv") == without));
  gas.method = "order = 4\nviscosity = { linear = 0.5 }";
  check_ends(gas, 2, "viscosity: it is that of steps of order 2 with conserve = \"form\"");
  gas.method = "viscosity = { linear = -0.5 }";
  check_ends(gas, 2, "linear: a coefficient of viscosity is not negative, found -0.5");
  gas.method = "viscosity = { cubic = 1 }";
  check_ends(gas, 2, "cubic");
}

BOOST_AUTO_TEST_CASE(a_metric_that_is_not_there_is_refused) {
  Medium curved = block();
  curved.system = "metric = \"euclidean\"\n";
  plan_of(curved);
  curved.system = "metric = \"sphere\"\n";
  check_ends(curved, 2, "metric: media move in Euclidean space, \"euclidean\"");
  curved.system = "metric = [\"1\", \"1\"]\n";
  check_ends(curved, 2, "metric: media move in Euclidean space, \"euclidean\"");
}

BOOST_AUTO_TEST_SUITE_END()
