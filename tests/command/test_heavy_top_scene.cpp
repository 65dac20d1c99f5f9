// Heavy tops through the command: a benchmark, orders, frames, what is kept, and the top without gravity.
#include <boost/test/unit_test.hpp>

#include "body_scene.hpp"

using command::apart, command::BodyScene, command::contains, command::last;

namespace {
constexpr double eps = 2.220446049250313e-16;

/// The benchmark of Bruls and Cardona.
BodyScene const benchmark{
    "kind = 'heavy_top'\nmass = 15\ninertia = [0.234375, 0.46875, 0.234375]\ncentre_of_mass = [0, 1, 0]\n"
    "gravity = [0, 0, -9.81]",
    "angular_velocity = [0, 150, -4.61538]", "order = 4\nstep = 5e-4", "until = 1", "'angular_velocity'"};
/// A top without any symmetry.
BodyScene const crooked{
    "kind = 'heavy_top'\nmass = 1.5\ninertia = [0.7, 1.1, 0.9]\ncentre_of_mass = [0.1, -0.15, 0.2]\n"
    "gravity = [1, 2, -9]",
    "attitude = [0.5, 0.5, -0.5, 0.5]\nangular_velocity = [1.5, -1, 2]", "", "until = 2\nevery = 0.25",
    "'angular_velocity', 'attitude', 'vertical_momentum', 'energy', 'casimir', 'direction_of_gravity'"};
}  // namespace

BOOST_AUTO_TEST_SUITE(heavy_top_scene)

BOOST_AUTO_TEST_CASE(the_benchmark_of_bruls_and_cardona_comes_out_to_its_digits) {
  auto const left = command::run(benchmark);
  BOOST_TEST(left.outcome.status == 0, left.outcome.err);
  // From a power series with 50 digits; twelve are printed. The top turns by 150 rad, each a rounding.
  auto const w = last(left);
  BOOST_REQUIRE(w.size() == 3u);
  BOOST_TEST(std::abs(w[0] + 0.822078101683) <= 1e-12);
  BOOST_TEST(std::abs(w[1] - 150) <= 150 * 150 * eps);
  BOOST_TEST(std::abs(w[2] + 5.92329134812) <= 1e-11);
}

BOOST_AUTO_TEST_CASE(orders_two_and_four_are_measured) {
  command::check_orders(crooked, "0.0009765625", "heavy top");
}

BOOST_AUTO_TEST_CASE(what_is_kept_is_kept_in_every_row) {
  auto const left = command::run(crooked);
  BOOST_TEST(left.outcome.status == 0, left.outcome.err);
  auto const& t = left.table;
  BOOST_TEST(t.rows.size() == 9u);
  for (std::size_t k = 0; k < t.rows.size(); ++k) {
    BOOST_TEST(std::abs(t["casimir_gamma"][k] - 1) <= 16 * eps);
    // M.Gamma, with the direction of gravity for Gamma, is the momentum about the vertical, with the other
    // sign.
    BOOST_TEST(std::abs(t["casimir_cross"][k] + t["vertical_momentum"][k]) <= 32 * eps * 3);
    BOOST_TEST(std::abs(t["vertical_momentum"][k] - t["vertical_momentum"][0]) <= 1e-13);
    BOOST_TEST(std::abs(t["energy"][k] - t["energy"][0]) <= 1e-8);
    double const x = t["direction_of_gravity_x"][k], y = t["direction_of_gravity_y"][k],
                 z = t["direction_of_gravity_z"][k];
    BOOST_TEST(std::abs(x * x + y * y + z * z - 1) <= 16 * eps);
  }
  for (std::string const name : {"vertical_momentum", "energy", "casimir_gamma", "casimir_cross"})
    BOOST_TEST(contains(left.summary, "\"" + name + "\": "));
}

BOOST_AUTO_TEST_CASE(the_energy_is_kinetic_and_potential_about_the_fixed_point) {
  // A bob of 2 on an arm of 0.5 along the second axis, with the moments of a ball of 0.1 about its centre; at
  // rest with the arm upright, and let go with a spin.
  BodyScene const scene{
      "kind = 'heavy_top'\nmass = 2\ninertia = [0.1, 0.1, 0.1]\ncentre_of_mass = [0, 0.5, 0]\n"
      "gravity = [0, -10, 0]",
      "angular_velocity = [3, 4, 0]", "", "until = 0.1",
      "'energy', 'body_momentum', 'direction_of_gravity', 'vertical_momentum'"};
  auto const left = command::run(scene);
  BOOST_TEST(left.outcome.status == 0, left.outcome.err);
  auto const& row = left.table.rows.front();
  // (0.1 + 2 * 0.25) 9/2 + 0.1 * 16/2 + 2 * 10 * 0.5
  BOOST_TEST(row[1] == 2.7 + 0.8 + 10, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(apart({row.begin() + 2, row.end()}, {1.8, 0.4, 0, 0, -1, 0, 0.4}) <= 16 * eps);
}

BOOST_AUTO_TEST_CASE(a_full_tensor_and_its_moments_tell_the_same) {
  auto full = crooked;
  full.system =
      "kind = 'heavy_top'\nmass = 1.5\ninertia = [[0.7, 0, 0], [0, 1.1, 0], [0, 0, 0.9]]\n"
      "centre_of_mass = [0.1, -0.15, 0.2]\ngravity = [1, 2, -9]";
  BOOST_TEST(apart(last(command::run(full)), last(command::run(crooked))) <= 1e-13);
  // On an axis of a body given by moments nothing is turned; the same body by its tensor is turned to
  // ascending moments and back.
  auto turned = benchmark;
  turned.system =
      "kind = 'heavy_top'\nmass = 15\ninertia = [[0.234375, 0, 0], [0, 0.46875, 0], [0, 0, 0.234375]]\n"
      "centre_of_mass = [0, 1, 0]\ngravity = [0, 0, -9.81]";
  BOOST_TEST(apart(last(command::run(turned)), last(command::run(benchmark))) <= 1e-11);
}

BOOST_AUTO_TEST_CASE(without_gravity_it_is_the_free_body_about_the_fixed_point) {
  auto top = crooked, lever = crooked;
  top.system =
      "kind = 'heavy_top'\nmass = 1.5\ninertia = [0.7, 1.1, 0.9]\ncentre_of_mass = [0, 0, 0.2]\n"
      "gravity = [0, 0, 0]";
  top.quantities = lever.quantities = "'angular_velocity', 'attitude'";
  // 0.7 + 1.5 * 0.04 and so on.
  BodyScene const free{"kind = 'rigid_body'\ninertia = [0.76, 1.16, 0.9]", top.initial, "", top.run,
                       top.quantities};
  auto const found = command::run(top);
  BOOST_TEST(found.outcome.status == 0, found.outcome.err);
  BOOST_TEST(contains(found.summary, "no gravity: free motion, exact flow"));
  BOOST_TEST(apart(last(found), last(command::run(free))) <= 64 * eps * 6);
  // Gravity next to nothing is stepped by kicks, and tells the same.
  auto little = top;
  little.system.replace(little.system.find("[0, 0, 0]"), 9, "[0, 0, -1e-200]");
  auto const kicked = command::run(little);
  BOOST_TEST(!contains(kicked.summary, "no gravity"));
  BOOST_TEST(apart(last(found), last(kicked)) <= 1000 * eps);
  // So does a top held at its centre of mass.
  lever.system =
      "kind = 'heavy_top'\nmass = 1.5\ninertia = [0.76, 1.16, 0.9]\ncentre_of_mass = [0, 0, 0]\n"
      "gravity = [0, 0, -9]";
  auto const held = command::run(lever);
  BOOST_TEST(contains(held.summary, "no gravity: free motion, exact flow"));
  BOOST_TEST(apart(last(found), last(held)) <= 64 * eps * 6);
}

BOOST_AUTO_TEST_CASE(a_top_that_hangs_and_hardly_swings_takes_steps_of_its_pendulum) {
  // It has no energy to turn fast with; the step is that of its frequency, the root of m g l / I.
  BodyScene const scene{
      "kind = 'heavy_top'\nmass = 1\ninertia = [0.1, 0.1, 0.02]\ncentre_of_mass = [0, 0, 1]\n"
      "gravity = [0, 0, -9.81]",
      "attitude = { axis = [1, 0, 0], degrees = 180 }\nangular_velocity = [0.001, 0, 0]", "",
      "until = 100\nevery = 10", "'angular_velocity', 'energy'"};
  auto const left = command::run(scene);
  BOOST_TEST(left.outcome.status == 0, left.outcome.err);
  for (auto const& row : left.table.rows)
    BOOST_TEST(std::abs(row[1] - 0.001 * std::cos(std::sqrt(9.81 / 1.1) * row[0])) <= 1e-8);
}

BOOST_AUTO_TEST_CASE(what_is_wrong_is_pointed_at) {
  auto const status = [](BodyScene const& scene, std::string const& part) {
    auto const outcome = command::run(scene).outcome;
    BOOST_TEST(contains(outcome.err, part), outcome.err);
    return outcome.status;
  };
  auto scene = crooked;
  scene.method = "order = 6";
  BOOST_TEST(status(scene, "order: variational takes 2 or 4, found 6") == 2);
  scene = crooked, scene.system.replace(scene.system.find("mass = 1.5"), 10, "mass = -1");
  BOOST_TEST(status(scene, "scene.toml:3:8: mass: a number > 0 is expected, found -1") == 2);
  scene = crooked, scene.system.replace(scene.system.find("[0.7, 1.1, 0.9]"), 15, "[0.1, 1.1, 0.9]");
  BOOST_TEST(status(scene, "scene.toml:4:11: inertia: I_2 must not exceed the sum of the other two") == 2);
  scene = crooked, scene.system += "\nbody = 'apophis'";
  BOOST_TEST(status(scene, "'body'") == 2);
  scene = crooked, scene.method = "step = 0.3";
  BOOST_TEST(status(scene, "the nearest step that would do is 0.25") == 2);
}

BOOST_AUTO_TEST_SUITE_END()
