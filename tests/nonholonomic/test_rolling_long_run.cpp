// Long runs of rolling bodies: the rattleback, momentum and energy over a hundred thousand steps.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/nonholonomic/constrained_integrator.hpp"
#include "actio/reduction/composition.hpp"
#include "rolling_systems.hpp"

using namespace actio;
using namespace actio::systems;
using namespace actio::testing;

BOOST_AUTO_TEST_SUITE(rolling_long_runs)

BOOST_AUTO_TEST_CASE(a_rattleback_reverses_when_it_should) {
  Rattleback const body;
  auto const system = body.system();
  auto const start = system.state(body.velocity(-5), direction(body.up));
  auto run = system.run(0.0005, symmetric_composition<double>(4), start);
  // By another program, to the digits that it gave.
  List const spins{-3.12322, -1.18473, 0.2684};
  double before = -5, zero = 0, change = 0;
  for (int k = 1; k <= 6000; ++k) {
    run.step();
    auto const now = run.state();
    double const spin = body.spin(now);
    if (before < 0 && spin >= 0 && zero == 0) zero = run.time() - 0.0005 * spin / (spin - before);
    if (k % 2000 == 0) BOOST_TEST(std::abs(spin - spins[static_cast<std::size_t>(k / 2000 - 1)]) < 1e-4);
    before = spin;
    if (k % 100 == 0) change = std::max(change, std::abs(system.energy(now) / system.energy(start) - 1));
  }
  BOOST_TEST_MESSAGE("rattleback: first zero of the spin " << zero << " s, energy changes by " << change);
  BOOST_TEST(std::abs(zero - 2.80443) < 1e-4);
  BOOST_TEST(change < 1e-6);
}

BOOST_AUTO_TEST_CASE(a_rattleback_the_other_way_slows_down_for_long) {
  Rattleback const body;
  auto const system = body.system();
  auto run =
      system.run(0.001, symmetric_composition<double>(4), system.state(body.velocity(5), direction(body.up)));
  double turned = 0;
  for (int k = 1; k <= 13000 && turned == 0; ++k) {
    run.step();
    if (run.velocity_of_substep()[2] < 0) turned = run.time();
  }
  BOOST_TEST_MESSAGE("rattleback, started at 5 rad/s the other way: turns at " << turned << " s");
  BOOST_TEST(std::abs(turned - 11.6) < 0.4);
}

BOOST_AUTO_TEST_CASE(the_momentum_of_chaplygins_ball_over_a_hundred_thousand_steps) {
  ChaplyginBall const ball;
  auto const system = ball.system();
  auto const start = system.state(ball.velocity(), direction(ball.up));
  Triple const k = ball.about_contact(start.point);
  for (int const order : {2, 4}) {
    auto run = system.run(0.05, symmetric_composition<double>(order), start);
    int const steps = order == 2 ? 100000 : 20000;  // as many substeps
    double square = 0, vertical = 0, length = 0;
    for (int step = 0; step < steps; ++step) {
      run.step();
      Triple const now = ball.about_contact(run.point()), up = triple(run.point().vectors, 0);
      square = std::max(square, std::abs(now.squaredNorm() / k.squaredNorm() - 1));
      vertical = std::max(vertical, std::abs(now.dot(up) / k.dot(ball.up) - 1));
      length = std::max(length, std::abs(up.norm() - 1));
    }
    BOOST_TEST_MESSAGE("Chaplygin's ball, order " << order << ": |K|^2 " << square << ", K.u " << vertical
                                                  << ", |u| " << length);
    BOOST_TEST(square <= 1e-13);
    BOOST_TEST(vertical <= 1e-13);
    BOOST_TEST(length <= 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(energy_over_a_hundred_thousand_steps) {
  auto const changes = [](char const* name, Constrained const& system, double h,
                          ConstrainedState const& start) {
    ConservingIntegrator run(system.system, system.constraints, h, {1}, start);
    double change = 0;
    for (int k = 0; k < 100000; ++k) {
      run.step();
      if (k % 16 == 0)
        change = std::max(change, std::abs(system.energy(run.state()) / system.energy(start) - 1));
    }
    BOOST_TEST_MESSAGE(name << ": energy changes by " << change);
    BOOST_TEST(change <= 1e-13, name);
  };
  Sleigh const sleigh;
  auto const on_ice = sleigh.system(Chart::cayley);
  changes("sleigh", on_ice, 0.01, on_ice.state(sleigh.velocity(0)));
  ChaplyginBall const ball;
  auto const rolling = ball.system(Chart::cayley);
  changes("Chaplygin's ball", rolling, 0.05, rolling.state(ball.velocity(), direction(ball.up)));
  Rattleback const body;
  auto const rattling = body.system(Chart::cayley);
  changes("rattleback", rattling, 0.0005, rattling.state(body.velocity(-5), direction(body.up)));
}

BOOST_AUTO_TEST_SUITE_END()
