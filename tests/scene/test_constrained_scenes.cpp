// Scenes with constraints on the velocity: against closed forms, and refused where they are wrong.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "last_row.hpp"
#include "program/systems/lagrangians/constrained_input.hpp"
#include "refusal.hpp"

using namespace actio::scene;

namespace {

/// Chaplygin's sleigh: w = sech(t/2), v1 = tanh(t/2); with a line for another.
std::string sleigh(std::string const& line = "", std::string const& instead = "") {
  std::string text =
      "[system]\nkind = \"euler_poincare\"\ngroup = \"SE(2)\"\n"
      "lagrangian = \"(v1^2 + (v2 + w/2)^2 + c*w^2)/2\"\nconstraints = [\"v2\"]\nparameters = { c = 0.75 }\n"
      "[initial]\nvelocity = [1, 0, 0]\n[method]\nname = \"natural_chart\"\norder = 4\nstep = 0.05\n[run]\n"
      "until = 4\n[output]\nquantities = [\"velocity\", \"reaction\", \"constraint\", \"energy\"]\n";
  return changed(std::move(text), line, instead);
}
void check_refused(std::string const& line, std::string const& instead, std::string const& says) {
  check_said(refusal(sleigh(line, instead), "sleigh.toml"), says);
}
bool moves(std::string const& constraint) {
  std::vector<std::string> remarks;
  std::string const lines =
      "constraints = [\"" + constraint + "\"]" +
      (constraint.find("a1") < constraint.size() ? "\nadvected = { a = [1, 2, 1] }" : "");
  auto const file = SceneFile::parse(sleigh("constraints = [\"v2\"]", lines), "sleigh.toml");
  return constraints_move(read_reduced_scene(file, remarks));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(constrained_scenes)

BOOST_AUTO_TEST_CASE(a_sleigh_goes_as_its_closed_form) {
  for (char const* const method : {"natural_chart", "cayley_chart"}) {
    auto const row = last_row(sleigh("natural_chart", method));
    double const w = 1 / std::cosh(2.0), v = std::tanh(2.0);
    BOOST_REQUIRE_EQUAL(row.size(), 6u);
    // Order 4 with steps of a fortieth of the turn: 2e-8.
    BOOST_TEST(std::abs(row[0] - w) < 1e-7);
    BOOST_TEST(std::abs(row[1] - v) < 1e-7);
    BOOST_TEST(std::abs(row[2]) < 1e-15);
    // m (a w' + v1 w) across the blade, with w' = -v1 w/2.
    BOOST_TEST(std::abs(row[3] - 0.75 * v * w) < 1e-6);
    BOOST_TEST(std::abs(row[4]) < 1e-15);
    BOOST_TEST(std::abs(row[5] - 0.5) < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(constraints_may_depend_on_the_time) {
  // A belt whose speed grows with the time carries a body along: the force is its mass.
  auto const row = last_row(
      "[system]\nkind = \"euler_poincare\"\ngroup = \"R^2\"\nlagrangian = \"3*(x1^2 + x2^2)/2\"\n"
      "constraints = [\"x1 - t\"]\n[initial]\nvelocity = [0, 1]\n[method]\nstep = 0.25\n[run]\nuntil = 2\n"
      "at = [0, 0.5, 2]\n[output]\nquantities = [\"velocity\", \"reaction\"]\n");
  BOOST_TEST(std::abs(row[0] - 2) < 1e-14);
  BOOST_TEST(row[1] == 1);
  BOOST_TEST(std::abs(row[2] - 3) < 1e-14);
}

BOOST_AUTO_TEST_CASE(a_body_at_rest_may_be_carried_off) {
  // All of its energy comes from the constraint.
  auto const row = last_row(
      "[system]\nkind = \"euler_poincare\"\ngroup = \"R^2\"\nlagrangian = \"(x1^2 + x2^2)/2\"\n"
      "constraints = [\"x1 - sin(t)\"]\n[initial]\nvelocity = [0, 0]\n[method]\nstep = 0.125\n[run]\n"
      "until = 1\n[output]\nquantities = [\"velocity\", \"energy\"]\n");
  BOOST_TEST(std::abs(row[0] - std::sin(1.0)) < 1e-14);
  BOOST_TEST(std::abs(row[2] - std::sin(1.0) * std::sin(1.0) / 2) < 1e-14);
}

BOOST_AUTO_TEST_CASE(a_velocity_is_moved_on_the_constraints_where_the_scene_says_so) {
  check_refused("velocity = [1, 0, 0]", "velocity = [1, 0, 0.5]",
                "it breaks system.constraints by 0.5 of its size, and at most 1e-06 is allowed");
  // Across the blade v2 = 0.5 is lost; the momentum about the blade is w/4 + c w + v2/2 = w.
  auto const scene = Scene::read(SceneFile::parse(
      sleigh("velocity = [1, 0, 0]", "velocity = [1, 0, 0.5]\nproject = true"), "sleigh.toml"));
  BOOST_TEST(scene.simulation.failure.empty());
  BOOST_REQUIRE_EQUAL(scene.simulation.remarks.size(), 1u);
  check_said(scene.simulation.remarks[0], "and was moved on them");
}

BOOST_AUTO_TEST_CASE(energy_is_conserved_unless_a_constraint_moves) {
  BOOST_TEST(!moves("v2"));
  BOOST_TEST(!moves("v2 + a1*w*0 - a1*v2/4"));
  BOOST_TEST(moves("v2 + (a1 - 1)/4"));
  BOOST_TEST(moves("v2 - t"));
}

BOOST_AUTO_TEST_CASE(what_is_no_constraint_is_refused) {
  check_refused("[\"v2\"]", "[]", "constraints: at least one formula is expected");
  check_refused("[\"v2\"]", "[\"v2^2\"]", "it must be linear in the velocity as it is written");
  check_refused("[\"v2\"]", "[\"t\"]", "the velocity must occur in it");
  check_refused("[\"v2\"]", "[\"v3\"]", "v3");
  check_refused("[\"v2\"]", "[\"v1\", \"2*v1\"]", "velocity constraint 2: its row must be independent");
  check_refused("[\"v2\"]", "[\"v1\", \"v2\", \"w\"]", "for a motion to be left");
  check_refused("{ c = 0.75 }", "{ c = 0.75, t = 1 }", "in system.constraints it is the time");
  check_refused("{ c = 0.75 }", "{ c = 0.75, unused = 1 }", "unused");
  check_refused("\"natural_chart\"\norder = 4", "\"galerkin\"\norder = 4",
                "it takes no constraints on the velocity");
  check_refused("\"energy\"", "\"symplectic_defect\"", "leave no bracket and no two-form");
  check_refused("constraints = [\"v2\"]\n", "",
                "reaction: it is a quantity of systems with system.constraints");
}

BOOST_AUTO_TEST_CASE(energy_is_conserved_by_steps_that_can) {
  std::string const conserving = "\"cayley_chart\"\nconserve = \"energy\"";
  BOOST_TEST(refusal(sleigh("\"natural_chart\"", conserving), "sleigh.toml") == "");
  check_refused("\"natural_chart\"", "\"natural_chart\"\nconserve = \"energy\"",
                "it needs the chart by Cayley's transform");
  check_refused("\"natural_chart\"", "\"natural_chart\"\nconserve = \"form\"", "form");
  auto const other = [&](std::string const& line, std::string const& instead) {
    return refusal(changed(sleigh("\"natural_chart\"", conserving), line, instead), "sleigh.toml");
  };
  check_said(other("c*w^2", "c*w^2*(1 + w^2)"), "the kinetic energy must have constant coefficients");
  check_said(other("c*w^2", "c*w^2 + w"), "there must be no momentum at rest");
  check_said(other("parameters", "force = [\"-w\", \"0\", \"0\"]\nparameters"),
             "there must be no force and no friction");
  check_said(other("\"energy\"]", "\"impulse\"]"), "act in their middle");
  check_said(changed(other("constraints = [\"v2\"]\n", ""), "", ""), "constraint");
}

BOOST_AUTO_TEST_CASE(an_accuracy_chooses_a_method_that_takes_constraints) {
  auto const text = changed(sleigh("[method]\nname = \"natural_chart\"\norder = 4\nstep = 0.05\n", ""),
                            "until = 4", "until = 4\naccuracy = 1e-8");
  auto const row = last_row(text);
  BOOST_TEST(std::abs(row[0] - 1 / std::cosh(2.0)) < 1e-8);
  BOOST_TEST(std::abs(row[1] - std::tanh(2.0)) < 1e-8);
}

BOOST_AUTO_TEST_CASE(a_contact_is_a_place_of_the_body) {
  // A point that is a fifth ahead of the blade, seen from above.
  auto const text = changed(sleigh("parameters", "contact = [\"0.2\", \"0\"]\nparameters"), "\"velocity\"",
                            "\"configuration\", \"contact\"");
  auto const row = last_row(text);
  BOOST_TEST(std::abs(row[9] - (row[2] + 0.2 * row[0])) < 1e-14);
  BOOST_TEST(std::abs(row[10] - (row[5] + 0.2 * row[3])) < 1e-14);
  check_refused("parameters", "contact = [\"0.2\"]\nparameters", "2 formulas are expected");
  check_refused("constraints = [\"v2\"]", "contact = [\"0.2\", \"0\"]", "it goes with system.constraints");
  check_refused("parameters", "contact = [\"v1\", \"0\"]\nparameters", "v1");
  check_refused("\"energy\"", "\"contact\"", "it is a quantity of systems with system.contact");
}

BOOST_AUTO_TEST_CASE(a_damped_sleigh_runs_along_the_free_one) {
  // The constraint is linear, so damping by p' = -c p slows the motion down: over the time t it goes on by
  // s = (1 - e^-ct)/c, and its velocity has the factor e^-ct.
  double const c = 0.2, t = 4, s = (1 - std::exp(-c * t)) / c, slower = std::exp(-c * t);
  std::string const damped = "[system.dissipation]\nkind = \"conformal\"\nrate = 0.2\n[initial]";
  auto const row = last_row(sleigh("[initial]", damped));
  // Of order 4, as without damping.
  BOOST_TEST(std::abs(row[0] - slower / std::cosh(s / 2)) < 1e-6);
  BOOST_TEST(std::abs(row[1] - slower * std::tanh(s / 2)) < 1e-6);
  BOOST_TEST(std::abs(row[3] - 0.75 * row[0] * row[1]) < 1e-14);
  check_refused("[initial]", "[system.dissipation]\nkind = \"orbit\"\nrate = 0.2\n[initial]",
                "reactions lead away from the orbit");
}

BOOST_AUTO_TEST_CASE(constraints_that_move_do_work_on_a_damped_body) {
  // On a belt at the speed 1 a body of mass 3 is pushed by what the damping takes: 3 c.
  auto const row = last_row(
      "[system]\nkind = \"euler_poincare\"\ngroup = \"R^2\"\nlagrangian = \"3*(x1^2 + x2^2)/2\"\n"
      "constraints = [\"x1 - 1\"]\ndissipation = { kind = \"conformal\", rate = 0.5 }\n"
      "[initial]\nvelocity = [1, 1]\n[method]\nstep = 0.25\n[run]\n"
      "until = 2\n[output]\nquantities = [\"velocity\", \"reaction\"]\n");
  BOOST_TEST(std::abs(row[0] - 1) < 1e-14);
  BOOST_TEST(std::abs(row[1] - std::exp(-1.0)) < 1e-14);
  BOOST_TEST(std::abs(row[2] - 1.5) < 1e-14);
}

BOOST_AUTO_TEST_CASE(a_disc_that_falls_flat_ends_the_run_with_the_angle) {
  // Let go at rest, tilted by a third: nothing makes it turn, and it falls on its side.
  std::string const disc =
      "[system]\nkind = \"euler_poincare\"\ngroup = \"SE(3)\"\n"
      "lagrangian = \"((w1^2 + w2^2)/4 + w3^2/2 + v1^2 + v2^2 + v3^2)/2 - 9.81*hypot(up1, up2)\"\n"
      "constraints = [\"v1 + w3*up2/hypot(up1, up2)\", \"v2 - w3*up1/hypot(up1, up2)\", "
      "\"v3 - (w1*up2 - w2*up1)/hypot(up1, up2)\"]\nadvected = { up = [0.6, 0, 0.8] }\n"
      "[initial]\nvelocity = [0, 0, 0, 0, 0, 0]\n[method]\norder = 2\nstep = 0.01\n[run]\nuntil = 5\n"
      "every = 0.01\n[output]\nquantities = [\"up\"]\n";
  Scene scene = Scene::read(SceneFile::parse(disc, "disc.toml"));
  BOOST_TEST(scene.simulation.failure.empty());
  std::vector<double> table;
  auto const report = run_in_memory(scene, table, {.quiet = true});
  BOOST_TEST((report.ending == Ending::numerics_failed));
  check_said(report.message, "after t = 0.");
  check_said(report.message, "its row must turn by at most a radian in a step");
  check_said(report.message, "up is ");
  check_said(report.message, "degrees from axis 3");
}

BOOST_AUTO_TEST_CASE(a_step_is_chosen_for_what_swings_under_the_constraints) {
  // A ball of radius 1 that rocks on a plane with its centre of mass 0.5 below its centre: about the contact
  // it swings at the root of g s/(I + (1 - s)^2) = 70/s with g = 3000, and nothing turns at the start.
  auto const scene = Scene::read(SceneFile::parse(
      "[system]\nkind = \"euler_poincare\"\ngroup = \"SE(3)\"\n"
      "lagrangian = \"(0.056*(w1^2 + w2^2 + w3^2) + v1^2 + v2^2 + v3^2)/2 - 3000*(1 - 0.5*u3)\"\n"
      "constraints = [\"v1 + w2*(0.5 - u3) + w3*u2\", \"v2 - w3*u1 - w1*(0.5 - u3)\", "
      "\"v3 - w1*u2 + w2*u1\"]\nadvected = { u = [0, 0.001, 1] }\n"
      "[initial]\nvelocity = [0, 0, 0, 0, 0, 0]\n"
      "[run]\nuntil = 1\n[output]\nquantities = [\"velocity\"]\n",
      "ball.toml"));
  BOOST_TEST(scene.simulation.failure.empty());
  double const rate = std::sqrt(3000 * 0.5 / (0.056 + 0.25));
  BOOST_TEST_MESSAGE("rocking ball: step " << scene.simulation.step << ", " << scene.simulation.step * rate
                                           << " of a radian");
  BOOST_TEST(scene.simulation.step * rate < 0.06);
  BOOST_TEST(scene.simulation.step * rate > 0.02);
}

BOOST_AUTO_TEST_SUITE_END()
