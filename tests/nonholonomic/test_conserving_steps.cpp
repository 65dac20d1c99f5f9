// Steps with constraints that conserve the energy.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/nonholonomic/conserving_integrator.hpp"
#include "actio/reduction/composition.hpp"
#include "rolling_systems.hpp"

using namespace actio;
using namespace actio::systems;
using namespace actio::testing;

namespace {

/// A run of such steps.
struct Conserving {
  Constrained const& of;
  std::vector<ConservingSolver> substeps;
  ReducedPoint point;
  double largest_change = 0;

  Conserving(Constrained const& system, double h, List const& fractions, ConstrainedState const& start)
      : of(system), point(start.point) {
    for (double const fraction : fractions) {
      substeps.emplace_back(*system.system, *system.constraints, fraction * h);
      substeps.back().begin_at(start.velocity);
    }
  }
  void steps(int count) {
    List velocity(substeps[0].unknowns().begin(), substeps[0].unknowns().begin() + of.constraints->dimension);
    LegendreVelocity legendre(*of.system);
    auto const energy = [&] {
      legendre.solve(point.momentum, point.vectors, velocity);
      return legendre.energy(velocity, point.vectors);
    };
    double const first = energy();
    for (int k = 0; k < count; ++k) {
      for (auto& substep : substeps) substep(point, 0);
      largest_change = std::max(largest_change, std::abs(energy() / first - 1));
    }
  }
  /// The velocity on the constraints.
  List velocity() const {
    List v(substeps.back().unknowns().begin(),
           substeps.back().unknowns().begin() + of.constraints->dimension);
    List lambda(static_cast<std::size_t>(of.constraints->count), 0);
    ConstrainedVelocity(*of.system, *of.constraints).solve(point.momentum, point.vectors, 0, v, lambda);
    return v;
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(conserving_steps)

BOOST_AUTO_TEST_CASE(the_sleigh_has_its_orders_and_its_energy) {
  Sleigh const sleigh;
  auto const system = sleigh.system(Chart::cayley);
  for (int const order : {2, 4}) {
    List errors;
    for (int const count : {50, 100, 200}) {
      Conserving run(system, 6.0 / count, symmetric_composition<double>(order),
                     system.state(sleigh.velocity(0)));
      run.steps(count);
      errors.push_back(apart(run.velocity(), sleigh.velocity(6)));
      BOOST_TEST(run.largest_change <= 1e-13);
    }
    BOOST_TEST_MESSAGE("sleigh, energy conserved, order " << order << ": errors " << errors[0] << " "
                                                          << errors[1] << " " << errors[2]);
    BOOST_TEST(std::abs(order_of(errors) - order) < 0.1);
  }
}

BOOST_AUTO_TEST_CASE(means_of_momenta_at_both_ends_obey_the_constraints) {
  ChaplyginBall const ball;
  auto const system = ball.system(Chart::cayley);
  Conserving run(system, 0.05, {1}, system.state(ball.velocity(), direction(ball.up)));
  ConstrainedVelocity look(*system.system, *system.constraints);
  LegendreVelocity legendre(*system.system);
  for (int k = 0; k < 100; ++k) {
    ReducedPoint const before = run.point;
    run.steps(1);
    List mean(6), middle(4), v(6);
    for (std::size_t i = 0; i < 6; ++i) mean[i] = (before.momentum[i] + run.point.momentum[i]) / 2;
    for (std::size_t i = 0; i < 4; ++i) middle[i] = (before.vectors[i] + run.point.vectors[i]) / 2;
    legendre.solve(mean, middle, v);
    BOOST_TEST(look.defect(v, middle, 0) <= 1e-13);
  }
}

BOOST_AUTO_TEST_SUITE_END()
