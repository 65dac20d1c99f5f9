// Examples of the module nonholonomic.
#include "actio/any_group/named_algebra.hpp"
#include "actio/formula/parse_formula.hpp"
#include "actio/nonholonomic/constrained_integrator.hpp"
#include "actio/nonholonomic/constrained_integrator.hpp"
#include "actio/nonholonomic/rolling_steps.hpp"
#include "actio/reduction/composition.hpp"

#include "example.hpp"

BOOST_AUTO_TEST_SUITE(examples_of_nonholonomic)
using namespace actio;

BOOST_AUTO_TEST_CASE(a_sleigh_from_texts) {
  using namespace actio::systems;
  // [rattle_integrator]
  // Chaplygin's sleigh: the blade at the origin does not slip across, v2 = 0.
  auto const algebra = named_algebra("SE(2)");
  auto names = algebra.components;  // w, v1, v2
  auto const l = parse_formula("(v1^2 + (v2 + w/2)^2 + 3*w^2/4)/2", names);
  auto const sleigh = std::make_shared<ReducedSystem const>(algebra, actio::systems::Side::left, 0, l);
  names.push_back("t");
  auto const blade =
      std::make_shared<VelocityConstraints const>(*sleigh, std::vector{parse_formula("v2", names)});
  RattleIntegrator motion(sleigh, blade, 0.05, suzuki<double>(),
                          constrained_state(*sleigh, *blade, {1, 0, 0}, {}));
  for (int k = 0; k < 100; ++k) motion.step();
  auto const v = motion.state().velocity;
  assert(std::abs(v[0] - 1 / std::cosh(2.5)) < 1e-6);  // w = sech(t/2)
  assert(std::abs(v[2]) < 1e-15);
  // [rattle_integrator]
}

BOOST_AUTO_TEST_CASE(a_disc_that_rolls) {
  // [rolling_steps]
  // A disc of radius 1 that rolls upright, faster than it must to stay so; its axis is the third.
  RollingBody<Ellipsoid> const disc{{{1, 1, 0}}, {0.25, 0.25, 0.5, 0, 0, 0}, 1, 9.81};
  RollingSteps<Ellipsoid> motion(disc, 0.01, {1}, {0, 0, 3}, {0, 1, 0});
  motion.follow({{{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}}, {0, 0, 1}});
  for (int k = 0; k < 100; ++k) motion.step();
  assert(std::abs(motion.place()->centre.x + 3) < 1e-3);  // three units of length to the left
  // [rolling_steps]
}

BOOST_AUTO_TEST_SUITE_END()
