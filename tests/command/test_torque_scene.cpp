// Rigid bodies under a torque through the command: orders, what is conserved and what is not, frames, and
// what is refused.
#include <boost/test/unit_test.hpp>

#include "body_scene.hpp"

using command::apart, command::BodyScene, command::contains, command::last;

namespace {
constexpr double eps = 2.220446049250313e-16;

/// A body without any symmetry, under a torque.
BodyScene under(std::string const& torque) {
  return {"kind = 'rigid_body'\ninertia = [0.7, 1.1, 0.9]\n[system.torque]\n" + torque,
          "attitude = [0.5, 0.5, -0.5, 0.5]\nangular_velocity = [1.5, -1, 2]", "", "until = 2\nevery = 0.25",
          "'angular_velocity', 'attitude', 'energy', 'jacobi_integral', "
          "'axial_momentum', 'casimir', 'spatial_momentum'"};
}
std::string const
    still = "gravity_gradient = { strength = 0.6, direction = [1, 2, 0.5] }",
    orbit = "gravity_gradient = { rate = 0.8, direction = [1, 0, 0], normal = [0, 0, 1] }",
    weight = "uniform_gravity = { mass = 1.5, lever = [0.1, -0.15, 0.2], acceleration = [1, 2, -9] }",
    formula = "potential = 'k = 1.2; -k*r33 + 0.4*r11^2'", upright = "potential = '2*r33 + 0.3*r31*r32'",
    jets =
        "uniform_gravity = { mass = 1.5, lever = [0.1, -0.15, 0.2], acceleration = [1, 2, -9] }\n"
        "body = ['-0.2*w1', '0.1*w1*w3', '0.3*cos(2*t)']",
    wave = "potential = '-r33*(1 + 0.5*cos(3*t))'";

/// The names of what a run tells drifts of.
std::string drifts(command::Left const& left) {
  std::size_t const at = left.summary.find("\"drift\": {");
  return left.summary.substr(at, left.summary.find('}', at) - at);
}
/// What a scene is refused with.
std::string refusal(BodyScene const& scene, int status = 2) {
  auto const outcome = command::run(scene).outcome;
  BOOST_TEST(outcome.status == status, outcome.err);
  return outcome.err;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(torque_scene)

BOOST_AUTO_TEST_CASE(orders_two_and_four_are_measured_under_every_torque) {
  for (auto const& torque : {still, orbit, weight, formula, wave, jets})
    command::check_orders(under(torque), "0.001953125", torque);
}

BOOST_AUTO_TEST_CASE(drift_is_told_of_what_the_torque_conserves_and_of_nothing_else) {
  struct Case {
    std::string torque;
    bool energy, jacobi, axial;
  };
  for (auto const& c : {Case{still, true, true, true},
                        {orbit, false, true, false},
                        {weight, true, true, true},
                        {formula, true, true, false},
                        {upright, true, true, true},
                        {wave, false, false, true}}) {
    auto const left = command::run(under(c.torque));
    BOOST_REQUIRE_MESSAGE(left.outcome.status == 0, left.outcome.err);
    std::string const told = drifts(left);
    BOOST_TEST(contains(told, "energy") == c.energy, c.torque);
    BOOST_TEST(contains(told, "jacobi_integral") == c.jacobi, c.torque);
    BOOST_TEST(contains(told, "axial_momentum") == c.axial, c.torque);
    BOOST_TEST((!contains(told, "casimir") && !contains(told, "spatial_momentum")), c.torque);
    // What is told to be conserved is, and what is not moves.
    auto const& t = left.table;
    auto const moved = [&t](std::string const& name) {
      double most = 0;
      for (double const x : t[name]) most = std::max(most, std::abs(x - t[name][0]));
      return most;
    };
    for (auto const& [name, kept] : {std::pair<std::string, bool>{"energy", c.energy},
                                     {"jacobi_integral", c.jacobi},
                                     {"axial_momentum", c.axial},
                                     {"casimir", false}}) {
      BOOST_TEST((moved(name) < 1e-6) == kept, c.torque << ": " << name << " moves by " << moved(name));
      if (name == "axial_momentum" && kept) BOOST_TEST(moved(name) <= 1e-13);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_formula_of_a_torque_with_a_name_is_that_torque) {
  // 3/2 mu/r^3 n.I n with n the row of the first axis of space, at rest and going round.
  std::string const n =
      "n1 = c*r11 + s*r21; n2 = c*r12 + s*r22; n3 = c*r13 + s*r23; "
      "1.5*0.64*(0.7*n1^2 + 1.1*n2^2 + 0.9*n3^2)'";
  for (auto const& [named, own] :
       {std::pair(orbit, "potential = 'c = cos(0.8*t); s = sin(0.8*t); " + n),
        {std::string("gravity_gradient = { strength = 0.64, direction = [7, 0, 0] }"),
         "potential = 'c = 1; s = 0; " + n},
        {weight,
         "potential = '-1.5*(r11*0.1 - r12*0.15 + r13*0.2 + 2*(r21*0.1 - r22*0.15 + r23*0.2) - "
         "9*(r31*0.1 - r32*0.15 + r33*0.2))'"}}) {
    auto one = under(named), other = under(own);
    one.method = other.method = "step = 0.0125";
    one.quantities = other.quantities = "'angular_velocity', 'attitude', 'energy'";
    auto const left = command::run(other);
    BOOST_TEST(left.outcome.status == 0, left.outcome.err);
    BOOST_TEST(apart(last(command::run(one)), last(left)) <= 2e-13);
  }
}

BOOST_AUTO_TEST_CASE(uniform_gravity_is_a_heavy_top_about_its_fixed_point) {
  auto body = under(weight), top = under(weight);
  // About the fixed point: I + m (|l|^2 - l l^T).
  body.system =
      "kind = 'rigid_body'\n"
      "inertia = [[0.79375, 0.0225, -0.03], [0.0225, 1.175, 0.045], [-0.03, 0.045, 0.94875]]\n"
      "[system.torque]\n" +
      weight;
  top.system =
      "kind = 'heavy_top'\nmass = 1.5\ninertia = [0.7, 1.1, 0.9]\ncentre_of_mass = [0.1, -0.15, 0.2]\n"
      "gravity = [1, 2, -9]";
  body.method = top.method = "step = 0.0125";
  body.quantities = "'angular_velocity', 'attitude', 'energy', 'axial_momentum'";
  top.quantities = "'angular_velocity', 'attitude', 'energy', 'vertical_momentum'";
  auto const left = command::run(body);
  BOOST_TEST(left.outcome.status == 0, left.outcome.err);
  BOOST_TEST(apart(last(left), last(command::run(top))) <= 1e-12);
}

BOOST_AUTO_TEST_CASE(a_full_tensor_and_its_moments_tell_the_same) {
  for (auto const& torque : {still, orbit, weight, formula}) {
    auto full = under(torque);
    full.system.replace(full.system.find("[0.7, 1.1, 0.9]"), 15, "[[0.7, 0, 0], [0, 1.1, 0], [0, 0, 0.9]]");
    full.method = "step = 0.0125";
    auto plain = under(torque);
    plain.method = full.method;
    BOOST_TEST(apart(last(command::run(full)), last(command::run(plain))) <= 1e-12, torque);
  }
}

BOOST_AUTO_TEST_CASE(without_a_torque_the_method_is_the_free_motion) {
  auto body = under(still);
  body.system = "kind = 'rigid_body'\ninertia = [0.7, 1.1, 0.9]";
  auto exact = body;
  body.method = "name = 'variational'\nstep = 0.25";
  auto const left = command::run(body);
  BOOST_TEST(left.outcome.status == 0, left.outcome.err);
  BOOST_TEST(contains(left.summary, "no torque: free motion, exact flow"));
  BOOST_TEST(contains(left.summary, "exact: no error but that of rounding"));
  BOOST_TEST(apart(last(left), last(command::run(exact))) <= 1e-13);
  // Every conserved quantity is one of the free body.
  for (auto const* const name :
       {"energy", "jacobi_integral", "axial_momentum", "casimir", "spatial_momentum"})
    BOOST_TEST(contains(drifts(left), name), name);
}

BOOST_AUTO_TEST_CASE(defaults_are_written_back) {
  auto const left = command::run(under(orbit));
  for (auto const* const line : {"name = \"variational\"", "order = 4", "strength = 0.64"})
    BOOST_TEST(contains(left.scene, line), left.scene);
  // A row between two steps of a torque that depends on time is at its own time.
  auto between = under(wave), steps = under(wave);
  between.method = "step = 0.05", between.run = "until = 2\nat = [1.99, 2]\nbetween_steps = true";
  steps.method = "step = 0.01", steps.run = "until = 1.99";
  between.quantities = steps.quantities = "'attitude', 'angular_velocity', 'energy'";
  auto const rows = command::run(between).table.rows;
  BOOST_REQUIRE(rows.size() == 2u);
  BOOST_TEST(apart({rows[0].begin() + 1, rows[0].end()}, last(command::run(steps))) <= 1e-5);
}

BOOST_AUTO_TEST_CASE(a_torque_that_is_none_is_pointed_at) {
  auto const said = [](std::string const& torque, std::string const& part) {
    std::string const err = refusal(under(torque));
    BOOST_TEST(contains(err, part), err);
    BOOST_TEST(contains(err, "scene.toml:"), err);
  };
  said("", "[system.torque] needs one of 'gravity_gradient', 'uniform_gravity', 'potential' and 'body'");
  said(still + "\n" + formula, "gravity_gradient and potential exclude each other");
  said("potential = 3", "potential: a text is expected, found 3");
  said("gravity_gradient = 3", "gravity_gradient: a table is expected, for example gravity_gradient = {");
  said("uniform_gravity = 'g'", "uniform_gravity: a table is expected");
  said("friction = 0.1", "unknown key of [system.torque] 'friction'");
  said("gravity_gradient = { strenth = 1, direction = [1, 0, 0] }", "did you mean 'strength'?");
  said("gravity_gradient = { direction = [1, 0, 0] }", "needs 'strength', which is mu/r^3, or the 'rate'");
  said("gravity_gradient = { strength = 1 }", "needs 'direction'");
  said("gravity_gradient = { strength = 0, direction = [1, 0, 0] }", "strength: a number > 0 is expected");
  said("gravity_gradient = { strength = nan, direction = [1, 0, 0] }", "a finite number is expected");
  said("gravity_gradient = { strength = 1e308, direction = [1, 0, 0] }", "the torque is beyond 1e308");
  said("gravity_gradient = { strength = 1, direction = [1, 0] }", "3 numbers are expected, found 2");
  said("gravity_gradient = { strength = 1, direction = [0, 0, 0] }",
       "direction: a direction is expected, found one of length 0");
  said("gravity_gradient = { rate = 1, direction = [1, 0, 0] }", "turns about 'normal', which is missing");
  said("gravity_gradient = { strength = 1, direction = [1, 0, 0], normal = [0, 0, 1] }",
       "turns about it at 'rate', which is missing");
  said("gravity_gradient = { rate = 0, direction = [1, 0, 0], normal = [0, 0, 1] }",
       "rate: it is zero; without 'rate' and 'normal' the direction stands still");
  said("gravity_gradient = { rate = 1e200, direction = [1, 0, 0], normal = [0, 0, 1] }", "rate: its square");
  said("gravity_gradient = { rate = 1e-200, direction = [1, 0, 0], normal = [0, 0, 1] }", "rate: its square");
  said("gravity_gradient = { rate = 1, direction = [1, 0, 1], normal = [0, 0, 1] }", "are 45");
  said("gravity_gradient = { rate = 1, direction = [1, 0, 1], normal = [0, 0, 1] }",
       "in the plane of the orbit it is [1, 0, 0]");
  said("gravity_gradient = { rate = 1, direction = [0, 0, 1], normal = [0, 0, 1] }", "must be 90 to 1e-9");
  said("uniform_gravity = { mass = 1, lever = [0, 0, 1] }", "needs 'acceleration'");
  said("uniform_gravity = { mass = -1, lever = [0, 0, 1], acceleration = [0, 0, -9] }", "a number > 0");
  said("uniform_gravity = { mass = 1, lever = [0, 0, 0], acceleration = [0, 0, -9] }",
       "lever: it is zero, so that there is no torque");
  said("uniform_gravity = { mass = 1e200, lever = [0, 0, 1], acceleration = [0, 0, -9] }", "too large");
  said("potential = 'r33 +'", "potential: ");
  said("potential = 'r333'", "did you mean 'r33'?");
  said("potential = 'abs(r33)'", "smooth");
  said("potential = 'log(r33 - 2)'", "potential: at the start it is ");
  said("potential = '1/(r33 - r33)'", "potential: ");
  auto scalar = under(still);
  scalar.system = "kind = 'rigid_body'\ninertia = [0.7, 1.1, 0.9]\ntorque = 2";
  BOOST_TEST(contains(refusal(scalar), "torque: a table is expected, for example torque = {"));
}

BOOST_AUTO_TEST_CASE(the_place_in_a_formula_is_pointed_at) {
  // torque.potential stands in line 5, its text begins in column 14.
  BOOST_TEST(contains(refusal(under("potential = 'r33 + 2*r1 - 1'")),
                      "scene.toml:5:22: potential: unknown name 'r1'"));
}

BOOST_AUTO_TEST_CASE(a_long_formula_is_planned_and_run_without_waiting) {
  std::string sum = "0";
  for (int k = 1; k <= 600; ++k)
    sum += " + sin(" + std::to_string(k) + "*r1" + std::to_string(1 + k % 3) + " + t)";
  auto scene = under("potential = '(" + sum + ")/1000'");
  scene.run = "until = 0.01";
  scene.method = "step = 0.001";
  auto const left = command::run(scene);
  BOOST_TEST(left.outcome.status == 0, left.outcome.err);
}

BOOST_AUTO_TEST_CASE(methods_and_steps_that_do_not_fit_are_refused) {
  auto scene = under(orbit);
  scene.method = "name = 'moser_veselov'";
  BOOST_TEST(
      contains(refusal(scene), "moser_veselov steps free bodies; under a torque the method is variational"));
  scene.method = "order = 6";
  BOOST_TEST(contains(refusal(scene), "order: variational takes 2 or 4, found 6"));
  for (auto const& torque : {still, orbit, weight, formula, wave}) {
    scene = under(torque);
    scene.method = "step = 1", scene.run = "until = 2";
    std::string const err = refusal(scene, 3);
    BOOST_TEST(contains(err, "body or torque may turn by"), err);
    // The longest that would do does.
    std::string const mark = "the largest that meets the rows is ";
    std::size_t const at = err.find(mark);
    BOOST_REQUIRE(at != std::string::npos);
    scene.method = "step = " + err.substr(at + mark.size());
    BOOST_TEST(command::run(scene).outcome.status == 0);
  }
}

BOOST_AUTO_TEST_CASE(a_potential_that_runs_out_ends_the_run_with_its_rows) {
  // It falls to the edge of where its root has a value.
  auto scene = under("potential = '5*sqrt(r33 + 0.5)'");
  scene.initial = "attitude = { axis = [1, 0, 0], degrees = 60 }\nangular_velocity = [3, 0.1, 0]";
  scene.method = "step = 0.001", scene.run = "until = 2\nevery = 0.01";
  auto const left = command::run(scene);
  BOOST_TEST(left.outcome.status == 3, left.outcome.err);
  BOOST_TEST(contains(left.outcome.err, "a NaN or an infinity"), left.outcome.err);
  BOOST_TEST(left.table.rows.size() > 3u);
}

BOOST_AUTO_TEST_CASE(a_blow_that_would_drive_a_body_too_fast_is_found_before_the_run) {
  // It takes a millisecond in a thousand seconds.
  auto scene = under("potential = '-1e5*exp(-(1000*(t - 1.25))^2)*r11'");
  scene.method = "step = 0.01", scene.run = "until = 1000\nevery = 1";
  auto const left = command::run(scene);
  BOOST_TEST(left.outcome.status == 3, left.outcome.err);
  BOOST_TEST(contains(left.outcome.err, "step: body or torque may turn by"), left.outcome.err);
  BOOST_TEST(contains(left.outcome.err, "the longest that would do is"), left.outcome.err);
}

BOOST_AUTO_TEST_SUITE_END()
