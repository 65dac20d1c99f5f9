// What is no system with constraints is refused, with what was measured.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/nonholonomic/constrained_integrator.hpp"
#include "actio/reduction/composition.hpp"
#include "refused.hpp"
#include "rolling_systems.hpp"

using namespace actio;
using namespace actio::systems;
using namespace actio::testing;

namespace {

char const* const free_body = "(w1^2 + 2*w2^2 + 3*w3^2)/2";

Constrained turning(std::vector<std::string> const& each, char const* lagrangian = free_body,
                    Chart chart = Chart::exponential) {
  return {"SO(3)", lagrangian, each, {"a"}, {}, "", chart};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(refused_constraints)

BOOST_AUTO_TEST_CASE(formulas_that_are_no_constraints_on_the_velocity_are_refused) {
  CHECK_REFUSED(turning({}), OutsideDomain);
  CHECK_REFUSED(turning({"w1", "w2", "w3"}), OutsideDomain);
  CHECK_REFUSED(turning({"w1", "w2^2 - 1"}), OutsideDomain);
  CHECK_REFUSED(turning({"w1*w2"}), OutsideDomain);
  CHECK_REFUSED(turning({"w1", "a1 - t"}), OutsideDomain);
  CHECK_REFUSED(turning({"w1 - w1"}), OutsideDomain);
  auto const system = turning({"w1"}).system;
  CHECK_REFUSED(VelocityConstraints(*system, {parse_formula("w1", {"w1", "w2"})}), OutsideDomain);
  // Whatever else is in them, as long as the velocity is linear.
  turning({"(w1*cos(a1) + w2*sin(t))*exp(a2) - t^2"});
}

BOOST_AUTO_TEST_CASE(rows_that_depend_on_each_other_are_named) {
  CHECK_REFUSED(turning({"w1", "a1*w1"}).state({0, 0, 1}, {1, 2, 0}), Singular);
  CHECK_REFUSED(turning({"a3*w1"}).state({0, 0, 1}, {1, 2, 0}), Singular);
  // Units of rows and of components do not matter.
  Constrained const uneven("SE(2)", "(1e-12*w^2 + 1e6*v1^2 + 1e6*v2^2)/2", {"1e-20*(v2 + 1e-9*w)", "1e20*w"});
  uneven.state({0, 1, 0});
}

BOOST_AUTO_TEST_CASE(a_velocity_that_breaks_a_constraint_is_refused_or_moved) {
  auto const system = turning({"w1 + a1*w2"});
  CHECK_REFUSED(system.state({1, 1, 1}, {1, 2, 0}), OutsideDomain);
  CHECK_REFUSED(turning({"w1 - 1"}).state({0, 0, 0}, {1, 2, 0}), OutsideDomain);
  BOOST_TEST(system.state({-1 - 1e-8, 1, 1}, {1, 2, 0}).moved > 1e-9);
  CHECK_REFUSED(system.state({std::nan(""), 1, 1}, {1, 2, 0}), NotFinite);
  CHECK_REFUSED(system.state({0, 0, 1}, {1, HUGE_VAL, 0}), NotFinite);
  CHECK_REFUSED(turning({"w1 + w2/a1"}).state({0, 0, 1}, {0, 2, 0}), NotFinite);
}

BOOST_AUTO_TEST_CASE(steps_that_have_no_solution_leave_the_run_as_it_was) {
  auto const system = turning({"w1"}, "(w1^2 + w2^2 + w3^2)/2");
  auto run = system.run(2, {1}, system.state({0, 0, 2}, {1, 0, 0}));
  CHECK_REFUSED(run.step(), OutsideDomain);
  // The contact of a rattleback goes so far in a step of a hundredth of a second that sooner or later a
  // substep has no solution; those before it are undone.
  Rattleback const body;
  auto const rattling = body.system();
  auto long_steps = rattling.run(0.01, symmetric_composition<double>(4),
                                 rattling.state(body.velocity(-5), direction(body.up)));
  long_steps.follow_configuration(Eigen::MatrixXd::Identity(4, 4));
  bool refused = false;
  for (int k = 0; k < 1000 && !refused; ++k) {
    ReducedPoint const before = long_steps.point();
    Eigen::MatrixXd const configuration = long_steps.configuration();
    double const time = long_steps.time();
    try {
      long_steps.step();
    } catch (Error const&) {
      refused = true;
      BOOST_TEST((long_steps.point().momentum == before.momentum));
      BOOST_TEST((long_steps.point().vectors == before.vectors));
      BOOST_TEST((long_steps.configuration() == configuration));
      BOOST_TEST(long_steps.time() == time);
    }
  }
  BOOST_TEST(refused);
}

BOOST_AUTO_TEST_CASE(a_disc_that_lies_flat_has_no_point_of_contact) {
  Constrained const disc("SE(3)", "(w1^2/4 + w2^2/4 + w3^2/2 + v1^2 + v2^2 + v3^2)/2 - q", point_rests, {"u"},
                         {}, "q = sqrt(u1^2 + u2^2); r1 = -u1/q; r2 = -u2/q; r3 = 0*u3;");
  CHECK_REFUSED(disc.state({0, 0, 1, 0, 0, 0}, {0, 0, 1, 0}), NotFinite);
}

BOOST_AUTO_TEST_CASE(rows_that_turn_too_far_in_a_step_are_refused_with_the_angle) {
  // A disc that falls on its side: the contact goes to the other end of its diameter at once.
  Constrained const disc("SE(3)", "(w1^2/4 + w2^2/4 + w3^2/2 + v1^2 + v2^2 + v3^2)/2 - 10*q", point_rests,
                         {"u"}, {}, "q = sqrt(u1^2 + u2^2); r1 = -u1/q; r2 = -u2/q; r3 = 0*u3;");
  auto run = disc.run(0.01, {1}, disc.state({0, 0, 0, 0, 0, 0}, {0.6, 0, 0.8, 0}));
  auto const fall = [&] {
    for (int k = 0; k < 1000; ++k) run.step();
  };
  CHECK_REFUSED(fall(), RowsTurn);
  // It is left as it was before that step, with the contact on its first side.
  BOOST_TEST(run.point().vectors[0] > 0);
  BOOST_TEST(run.point().vectors[0] < 0.1);
}

BOOST_AUTO_TEST_CASE(friction_on_the_orbit_goes_with_no_constraints) {
  auto const body = turning({"w1"});
  auto rubbed = std::make_shared<ReducedSystem>(*body.system);
  rubbed->dissipation = Dissipation{Dissipation::Kind::orbit, 0.1, Eigen::MatrixXd::Identity(3, 3)};
  auto const start = body.state({0, 0, 1}, {1, 2, 0});
  CHECK_REFUSED(RattleIntegrator(rubbed, body.constraints, 0.1, {1}, start), OutsideDomain);
}

BOOST_AUTO_TEST_CASE(energy_is_conserved_for_constant_kinetic_energies_in_cayleys_chart) {
  auto const conserving = [](Constrained const& system) {
    return ConservingSolver(*system.system, *system.constraints, 0.1);
  };
  CHECK_REFUSED(conserving(turning({"w1"})), OutsideDomain);
  CHECK_REFUSED(conserving(turning({"w1"}, "(w1^2 + 2*w2^2 + a1*w3^2)/2", Chart::cayley)), OutsideDomain);
  CHECK_REFUSED(conserving(turning({"w1"}, "(w1^2 + 2*w2^2 + w3^2)/2 + w3*a1", Chart::cayley)),
                OutsideDomain);
  CHECK_REFUSED(conserving(turning({"w1"}, "(w1^2 + 2*w2^2 + w3^2)/2 + w3", Chart::cayley)), OutsideDomain);
  Constrained good = turning({"w1"}, "(w1^2 + 2*w2^2 + w3^2)/2 + w1*w3/4 - exp(a1)", Chart::cayley);
  conserving(good);
  auto const acted_on = std::make_shared<ReducedSystem>(*good.system);
  good.system = acted_on;
  acted_on->force.emplace();
  CHECK_REFUSED(conserving(good), OutsideDomain);
  acted_on->dissipation = Dissipation{Dissipation::Kind::conformal, 0.1};
  CHECK_REFUSED(conserving(good), OutsideDomain);
}

BOOST_AUTO_TEST_SUITE_END()
