// Steps with constraints that conserve the energy.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/nonholonomic/constrained_integrator.hpp"
#include "actio/reduction/composition.hpp"
#include "rolling_systems.hpp"

using namespace actio;
using namespace actio::systems;
using namespace actio::testing;

namespace {

ConservingIntegrator run_of(Constrained const& system, double h, int order, ConstrainedState const& start) {
  return {system.system, system.constraints, h, symmetric_composition<double>(order), start};
}
/// Steps, and how far the energy changes from one to another.
double change_of_energy(ConservingIntegrator& run, Constrained const& of, int count) {
  double const first = of.energy(run.state());
  double largest = 0;
  for (int k = 0; k < count; ++k) {
    run.step();
    largest = std::max(largest, std::abs(of.energy(run.state()) / first - 1));
  }
  return largest;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(conserving_steps)

BOOST_AUTO_TEST_CASE(the_sleigh_has_its_orders_and_its_energy) {
  Sleigh const sleigh;
  auto const system = sleigh.system(Chart::cayley);
  for (int const order : {2, 4}) {
    List errors;
    for (int const count : {50, 100, 200}) {
      auto run = run_of(system, 6.0 / count, order, system.state(sleigh.velocity(0)));
      BOOST_TEST(change_of_energy(run, system, count) <= 1e-13);
      List v = run.velocity_of_substep(), lambda(1, 0);
      auto const &p = run.point().momentum, &a = run.point().vectors;
      ConstrainedVelocity(*system.system, *system.constraints).solve(p, a, 0, v, lambda);
      errors.push_back(apart(v, sleigh.velocity(6)));
    }
    BOOST_TEST_MESSAGE("sleigh, energy conserved, order " << order << ": errors " << errors[0] << " "
                                                          << errors[1] << " " << errors[2]);
    BOOST_TEST(std::abs(order_of(errors) - order) < 0.1);
  }
}

BOOST_AUTO_TEST_CASE(means_of_momenta_at_both_ends_obey_the_constraints) {
  ChaplyginBall const ball;
  auto const system = ball.system(Chart::cayley);
  auto run = run_of(system, 0.05, 2, system.state(ball.velocity(), direction(ball.up)));
  ConstrainedVelocity look(*system.system, *system.constraints);
  LegendreVelocity legendre(*system.system);
  for (int k = 0; k < 100; ++k) {
    ReducedPoint const before = run.point();
    run.step();
    List mean(6), middle(4), v(6);
    for (std::size_t i = 0; i < 6; ++i) mean[i] = (before.momentum[i] + run.point().momentum[i]) / 2;
    for (std::size_t i = 0; i < 4; ++i) middle[i] = (before.vectors[i] + run.point().vectors[i]) / 2;
    legendre.solve(mean, middle, v);
    BOOST_TEST(look.defect(v, middle, 0) <= 1e-13);
    for (double const c : run.constraint()) BOOST_TEST(std::abs(c) <= 1e-13);
  }
}

BOOST_AUTO_TEST_SUITE_END()
