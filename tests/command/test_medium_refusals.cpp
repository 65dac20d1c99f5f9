// What scenes of media are refused for, each at its key with what was found and what would do, and runs that
// end where their steps are no longer what they claim to be.
#include "medium_scene.hpp"

namespace {

using namespace command;

/// A gas in a box that is closed by four sides.
Medium gas() {
  Medium out;
  out.mesh = "shape = \"box\", lower = [0, 0], upper = [1, 1], cells = [4, 4]";
  out.material = "name = \"polytropic_gas\", K = 1, gamma = 2";
  return out;
}
Medium with_system(Medium scene, std::string const& text) { return scene.system = text + "\n", scene; }
Medium with_start(Medium scene, std::string const& text) { return scene.initial = text, scene; }
Medium with_mesh(Medium scene, std::string const& text) { return scene.mesh = text, scene; }
Medium solid(std::string const& material, int d = 2) {
  Medium out = gas();
  out.kind = "elastic_body", out.material = material;
  if (d == 3) out.mesh = "shape = \"box\", lower = [0, 0, 0], upper = [1, 1, 1], cells = [2, 2, 2]";
  return out;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(refusals_of_media)

BOOST_AUTO_TEST_CASE(what_should_be_a_table_is_refused_where_it_is_none) {
  for (char const* const wrong : {"\"fixed\"", "[\"fixed\"]", "3"})
    check_ends(
        with_system(gas(), std::string("boundary = ") + wrong), 2,
        ":5:12: boundary: a table of sides is expected, for example boundary.left = \"fixed\", found ");
  check_ends(
      with_system(gas(), "load = \"x\""), 2,
      ":5:8: load: a table is expected, for example load = { gravity = \"0.1*y\" }, found 'x' (a text)");
  check_ends(with_system(gas(), "load = { traction = 1 }"), 2,
             "traction: a table with a side is expected, for example traction.right = [0, 1], found 1");
  check_ends(with_system(gas(), "load = { traction = [0, 1] }"), 2, "found a list of 2");
  check_ends(with_system(gas(), "load = { motion = [\"X\", \"Y\"] }"), 2,
             "motion: a table with a side is expected, for example motion.left = ");
  for (char const* const wrong : {"\"x^2\"", "[\"x^2\"]"})
    check_ends(with_system(gas(), std::string("obstacle = ") + wrong), 2,
               "obstacle: a table is expected, for example obstacle = { potential = ");
  Medium bare = gas();
  bare.method = "viscosity = 2";
  check_ends(bare, 2, "viscosity: a table is expected, for example viscosity = ");
  check_ends(with_system(gas(), "load = { gravity = 9.81 }"), 2,
             "is expected, for example gravity = \"9.81*y\", found 9.81");
}

BOOST_AUTO_TEST_CASE(solids_that_are_unstable_at_rest_are_refused) {
  // Lame's first modulus is greater than -2 mu/d.
  check_ends(solid("name = \"saint_venant_kirchhoff\", lambda = -3, mu = 1"), 2,
             "lambda: Lame's first modulus at rest must be greater than -2 mu/2 = -1, or "
             "the solid is unstable; found -3");
  plan_of(solid("name = \"saint_venant_kirchhoff\", lambda = -0.9, mu = 1"));
  check_ends(solid("name = \"saint_venant_kirchhoff\", lambda = -0.9, mu = 1", 3), 2, "-2 mu/3 = -0.6");
  plan_of(solid("name = \"neo_hookean\", mu = 1, kappa = -0.9"));
  check_ends(solid("name = \"neo_hookean\", mu = 1, kappa = -1"), 2, "kappa: Lame's first modulus at rest");
  // In space 2 (c1 + c2) and lambda + 4 c2.
  check_ends(solid("name = \"mooney_rivlin\", c1 = 1, c2 = -1.5, lambda = 9", 3), 2,
             "c2: the shear modulus at rest, 2 (c1 + c2), must be positive, and it is -1");
  check_ends(solid("name = \"mooney_rivlin\", c1 = 1, c2 = -1, lambda = 1"), 2,
             "at rest lambda + 4 c2 = -3 must be greater than -2 mu/2 = -2, or the solid is unstable; "
             "found 1, greater than 2 would do");
}

// The power of the volume of a cell would be out of the range of a double: at rest the energy is
// K/(gamma - 1).
BOOST_AUTO_TEST_CASE(a_gas_with_a_large_exponent_has_the_energy_that_it_has) {
  Folder const folder;
  Medium stiff = with_mesh(gas(), "shape = \"box\", lower = [0, 0], upper = [1, 1], cells = [8, 8]");
  stiff.material = "name = \"polytropic_gas\", K = 1, gamma = 200", stiff.until = "0.001",
  stiff.every = "0.001";
  Table const rows = run_in(folder, stiff);
  BOOST_TEST(std::abs(rows["energy"][0] * 199 - 1) <= 64 * 2.2e-16);
}

BOOST_AUTO_TEST_CASE(a_motion_begins_where_the_placement_is_and_sides_agree_in_their_corner) {
  check_ends(with_system(gas(), "load = { motion = { left = [\"-0.3\", \"Y\"] } }"), 2,
             "motion: at t = 0 it has X = (0, 0) at (-0.3, 0), and initial.placement has it at (0, 0)");
  check_ends(with_system(
                 gas(), "load = { motion = { left = [\"X+0.1*t\", \"Y\"], bottom = [\"X\", \"Y-0.3*t\"] } }"),
             2, "motion: the sides 'bottom' and 'left' share X = (0, 0), and at t = ");
  check_ends(
      with_system(gas(),
                  "boundary = { bottom = \"fixed\" }\nload = { motion = { left = [\"X+0.1*t\", \"Y\"] } }"),
      2, "the sides 'left' and 'bottom' share X = (0, 0)");
  std::string const kicked =
      plan_of(with_system(gas(), "load = { motion = { left = [\"X+0.1*sin(t)\", \"Y\"] } }"));
  BOOST_TEST(kicked.find("motion.left begins with another velocity than initial.velocity, by up to 0.1") !=
                 std::string::npos,
             kicked);
  for (char const* const way : {"", "\nobstacle = { potential = \"0*x\" }"}) {
    std::string const told = plan_of(with_start(
        with_system(gas(), std::string("boundary = { left = \"fixed\" }") + way), "velocity = [0.1, 0]"));
    BOOST_TEST(told.find("side left is fixed to the velocity that it has at the start, up to 0.1") !=
                   std::string::npos,
               told);
  }
}

BOOST_AUTO_TEST_CASE(potentials_close_across_seams_and_are_finite_where_the_body_is) {
  Medium seam = gas();
  seam.mesh += ", periodic = [true, false]";
  for (char const* const load : {"load = { gravity = \"x^2\" }", "obstacle = { potential = \"x^2\" }"})
    check_ends(
        with_system(seam, load), 2,
        "in a box that is periodic along X, the potential is periodic along it but for a constant; here "
        "its gradient is (0, 0) at x = (0, 0) and (2, 0) a period further");
  plan_of(with_system(seam, "load = { gravity = \"x\" }"));
  check_ends(
      with_system(gas(), "load = { gravity = \"log(x)\" }"), 2,
      ":5:20: gravity: the potential and its gradient must be finite where the body is; at x = (0, 0)");
}

BOOST_AUTO_TEST_CASE(forces_without_an_effect_are_refused) {
  check_ends(with_system(gas(), "boundary = { left = \"fixed\" }\nload = { traction = { left = [0, 1] } }"),
             2, "traction: the side 'left' is fixed, so that no force moves it");
  check_ends(
      with_system(gas(), "load = { traction = { left = [0, 1] }, motion = { left = [\"X\", \"Y\"] } }"), 2,
      "traction: the side 'left' is moved");
  check_ends(with_system(gas(), "boundary = { left = \"sliding\" }\nload = { pressure = { left = 1 } }"), 2,
             "pressure: the side 'left' is sliding");
  Medium closed = gas();
  closed.mesh += ", periodic = [true, true]";
  check_ends(with_system(closed, "load = { pressure = 1 }"), 2, "pressure: the body has no free side");
}

BOOST_AUTO_TEST_CASE(densities_and_sizes_that_are_none_are_told_at_their_keys) {
  check_ends(with_system(gas(), "density = \"X - 0.5\""), 2,
             ":5:11: density: a mass per reference volume is not negative, found -0.5 at X = (0, 0)");
  check_ends(with_system(gas(), "density = \"(0.5 - X)^1.5\""), 2,
             "; max(0, ...) keeps what rounding makes negative");
  check_ends(with_system(gas(), "density = \"max(0, X - 0.5)\""), 2,
             "density in cell (0, 0): a cell has mass");
  Medium round = with_system(gas(), "boundary = { outer = \"sliding\" }");
  check_ends(with_mesh(round, "shape = \"disc\", radius = 1, cells = [2, 4]"), 2,
             "boundary: side 'outer': a side along");
  check_ends(with_start(gas(), "placement = [\"1e-200*X\", \"Y\"]"), 2,
             "placement: the stored energy at the start is ");
  check_ends(with_start(gas(), "velocity = [\"1e300*X\", \"0\"]"), 2,
             "velocity: the kinetic energy at the start is ");
  Medium hard = gas();
  hard.material = "name = \"polytropic_gas\", K = 1e300, gamma = 2";
  check_ends(hard, 2, "the longest stable step is ");
  auto const cells = [](std::string const& list, std::string const& more = "") {
    return with_mesh(gas(), "shape = \"box\", lower = [0, 0], upper = [1, 1], cells = " + list + more);
  };
  check_ends(cells("[9223372036854775807, 4]"), 2,
             "cells: a whole number from 1 to 1000000000 is expected, found 9.2");
  check_ends(cells("[1, 4]", ", periodic = [true, false]"), 2, "there are at least 2, found 1");
  check_ends(with_mesh(gas(), "shape = \"box\", lower = [0, 0], upper = [1e-300, 1], cells = [8, 8]"), 2,
             "the longest edge of a cell over the shortest, of 0.125 along Y over 1.25e-301 along X");
}

// Where a start is looked at between its nodes it may be what no cell shows.
BOOST_AUTO_TEST_CASE(a_placement_that_folds_between_the_nodes_is_what_its_nodes_make_of_it) {
  Medium const folded = with_mesh(gas(), "shape = \"box\", lower = [0, 0], upper = [5, 1], cells = [8, 8]");
  BOOST_TEST(!plan_of(with_start(folded, "placement = [\"X + 0.02*sin(pi*X/0.005)\", \"Y\"]")).empty());
}

BOOST_AUTO_TEST_CASE(words_and_times_that_do_not_fit_are_told_with_what_would) {
  Medium scene = gas();
  scene.method = "conserve = \"momentum\"";
  check_ends(scene, 2, "unknown value of conserve 'momentum' (known: form, energy)");
  check_ends(with_start(gas(), "velocity = [\"x\", \"0\"]"), 2, "unknown name 'x'; did you mean 'X'?");
  check_ends(with_start(gas(), "velocity = [\"t\", \"0\"]"), 2, "unknown name 't' (known:");
  scene = gas();
  scene.method = "step = 0.02", scene.every = "0.03", scene.until = "0.09";
  check_ends(scene, 2, "step: rows are at multiples of the step, and t = 0.03 is 1.5 steps of 0.02");
}

// A liquid in a tube, squeezed until its steps are too long for it: rows are right up to there.
BOOST_AUTO_TEST_CASE(a_step_that_becomes_unstable_ends_the_run) {
  Medium tube;
  tube.mesh = "shape = \"box\", lower = [0], upper = [1], cells = [40]";
  tube.material = "name = \"tait\", B = 1, gamma = 7";
  tube.system = "boundary = { right = \"fixed\" }\nload = { motion = { left = [\"0.3*(1-cos(0.5*t))\"] } }\n";
  tube.method = "step = 0.0033333333333333335", tube.until = "2.75", tube.every = "0.01";
  check_ends(tube, 3, "is no longer stable at t = ", false);
  Medium crushed = gas();
  crushed.initial = "velocity = [\"-10*X\", \"0\"]", crushed.until = "1", crushed.every = "";
  check_ends(crushed, 3, "the longest stable step has fallen to ", false);
}

// As a shock forms, viscosity allows less than it did at the start, and steps are made in parts.
BOOST_AUTO_TEST_CASE(a_shock_with_viscosity_goes_to_its_end_with_the_default_step) {
  struct Tube {
    char const *lower, *upper, *cells, *sides;
  };
  Medium shock;
  shock.until = "0.2", shock.every = "";
  for (auto const& [lower, upper, cells, sides] :
       {Tube{"[-1]", "[1]", "[400]", ""},
        Tube{"[-1, 0]", "[1, 0.1]", "[60, 3]", ", bottom = \"sliding\", top = \"sliding\""},
        Tube{"[-1, 0, 0]", "[1, 0.1, 0.1]", "[30, 2, 2]",
             ", bottom = \"sliding\", top = \"sliding\", front = \"sliding\", back = \"sliding\""}})
    for (char const* const viscosity :
         {"linear = 0.5, quadratic = 2", "linear = 8, quadratic = 2", "linear = 0, quadratic = 40"}) {
      shock.mesh =
          std::string("shape = \"box\", lower = ") + lower + ", upper = " + upper + ", cells = " + cells;
      shock.material = "name = \"polytropic_gas\", K = 1, gamma = 1.4";
      shock.system = std::string("density = \"1+(X<0)\"\nboundary = { left = \"fixed\", right = \"fixed\"") +
                     sides + " }\n";
      shock.method = std::string("viscosity = { ") + viscosity + " }";
      shock.quantities = "\"energy\", \"dissipated\"";
      Folder const folder;
      auto const table = run_in(folder, shock);
      double const first = table["energy"][0], last = table["energy"][1] + table["dissipated"][1];
      BOOST_TEST(std::abs(last / first - 1) <= 2e-3, cells << viscosity << ": " << last / first - 1);
      BOOST_TEST(table["dissipated"][1] > 1e-4 * first, cells << viscosity);
    }
}

// On a line nothing is sheared.
BOOST_AUTO_TEST_CASE(a_gas_on_a_line_is_not_told_of_shear) {
  Medium crushed;
  crushed.mesh = "shape = \"box\", lower = [0], upper = [1], cells = [40]";
  crushed.initial = "velocity = [\"-10*X\"]", crushed.until = "1", crushed.every = "";
  Folder const folder;
  auto const ended = actio({"run", folder.write("medium.toml", crushed.text())});
  BOOST_TEST(ended.status == 3, ended.err);
  BOOST_TEST(ended.err.find("shear") == std::string::npos, ended.err);
}

BOOST_AUTO_TEST_CASE(a_wall_that_a_step_passes_over_ends_the_run) {
  Medium bar = solid("name = \"neo_hookean\", mu = 1, kappa = 1");
  bar.mesh = "shape = \"box\", lower = [1], upper = [2], cells = [10]";
  bar.system = "obstacle = { potential = \"1e-6/x^2\" }\n";
  bar.initial = "velocity = [\"-5\"]", bar.until = "1", bar.every = "0.1";
  for (char const* const method : {"step = 0.01\nconserve = \"energy\"", "step = 0.01\norder = 4"}) {
    bar.method = method;
    check_ends(bar, 3, "has passed through a potential in the step of length 0.01", false);
  }
  // What is at rest, or climbs and comes back, has passed over nothing.
  Medium hill = gas();
  hill.mesh += ", periodic = [true, true]", hill.until = "0.5", hill.every = "0.25";
  hill.system = "obstacle = { potential = \"exp(5*(cos(2*pi*x) + cos(2*pi*y) - 2))\" }\n";
  for (char const* const start : {"", "velocity = [0.3, 0]"}) {
    Folder const folder;
    hill.initial = start;
    BOOST_TEST(run_in(folder, hill).rows.size() == 3u);
  }
  Medium block = solid("name = \"neo_hookean\", mu = 1, kappa = 1");
  block.mesh = "shape = \"box\", lower = [1, 0], upper = [2, 1], cells = [5, 5]";
  block.system = "obstacle = { potential = \"exp(-2000*x^2)*1e5\" }\n";
  block.initial = "velocity = [\"-50\", \"0\"]", block.until = "0.1", block.every = "0.01";
  check_ends(block, 3, "has passed through a potential", false);
}

BOOST_AUTO_TEST_SUITE_END()
