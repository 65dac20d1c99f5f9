// Runs on a level of the momentum, with vectors: against the step of the generic implementation, what they
// conserve, and how a vector goes where configurations take it.
#include <Eigen/Core>
#include <Eigen/LU>

#include <boost/test/unit_test.hpp>

#include "actio/any_group/level_integrator.hpp"
#include "actio/reduction/advected_momentum_level.hpp"
#include "forced_reference.hpp"

using namespace actio;
using namespace actio::systems;
using namespace actio::testing;

namespace {

/// Systems with a vector that costs energy, in columns of fixed and of any size.
struct Case {
  char const* group;
  List velocity, vector;
};
std::vector<Case> const cases{{"SO(3)", {0.3, 1.1, -0.4}, {0.6, -0.2, 0.9}},
                              {"SE(2)", {0.7, 0.8, -0.3}, {0.6, -0.2, 1}},
                              {"SL(2)", {0.2, 0.5, -0.4}, {0.6, -0.7}},
                              {"SE(3)", {0.3, 1.1, -0.4, 0.2, -0.1, 0.5}, {0.6, -0.2, 0.9, 1}},
                              {"GL(3)", uneven(9, 0.3), {0.6, -0.2, 0.9}}};
System system_of(Case const& c, Side side) {
  std::string const l = kinetic(named_algebra(c.group)) + " + a1*(1 + a2/3) - a2/2";
  return own_system(c.group, side, l.c_str(), true);
}

template <int side>
void agrees_with_the_generic_step(Case const& c) {
  System const system = system_of(c, side > 0 ? Side::right : Side::left);
  ReducedPoint const start = point_at(*system, c.velocity, c.vector);
  double const h = 0.05;
  LevelIntegrator run(system, h, start, c.velocity);
  run.follow_configuration(one(system));
  using Column = Matrix<double, Dynamic, 1>;
  Column const v(Eigen::Map<Eigen::VectorXd const>(c.velocity.data(), Index(c.velocity.size()))),
      a(Eigen::Map<Eigen::VectorXd const>(c.vector.data(), Index(c.vector.size())));
  SpanOfMatrices const group(std::shared_ptr<MatrixAlgebra const>(system, &system->algebra));
  TapeLagrangian const l{system};
  auto state = advected_momentum_state(l, Velocity<SpanOfMatrices, double>{group, v}, a);
  auto const step = [&] {
    if constexpr (side > 0)
      return advected_momentum_level_step_right<double>(l, EachVector());
    else
      return advected_momentum_level_step_left<double>(l, EachVector());
  }();
  int const steps = 20;
  for (int k = 0; k < steps; ++k) run.step(), state = step(state, h).state;
  double worst = 0, size = 0;
  for (std::size_t i = 0; i < start.momentum.size(); ++i) {
    worst = std::max(worst, std::abs(run.point().momentum[i] - state.momentum.components[Index(i)]));
    size = std::max(size, std::abs(run.point().momentum[i]));
  }
  for (std::size_t i = 0; i < c.vector.size(); ++i)
    worst = std::max(worst, std::abs(run.point().vectors[i] - state.vector[Index(i)]));
  Eigen::VectorXd const first = Eigen::Map<Eigen::VectorXd const>(c.vector.data(), Index(c.vector.size())),
                        now = Eigen::Map<Eigen::VectorXd const>(run.point().vectors.data(), first.size());
  Square const& g = run.configuration();
  double const condition = g.norm() * g.inverse().norm(),
               off = (side < 0 ? Eigen::VectorXd(g * now - first) : Eigen::VectorXd(g * first - now)).norm();
  BOOST_TEST_CONTEXT(c.group << (side > 0 ? " right" : " left")) {
    // Some twenty terms of series a step round, and Ad of a configuration multiplies what has rounded.
    BOOST_TEST(worst <= 32 * steps * eps * std::max(size, 1.0) * condition);
    BOOST_TEST(off <= 32 * steps * eps * now.norm() * condition);
    BOOST_TEST((now - first).norm() > 0.1);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(level_integrators)

BOOST_AUTO_TEST_CASE(runs_are_those_of_the_generic_step_and_vectors_go_where_configurations_take_them) {
  for (Case const& c : cases) agrees_with_the_generic_step<1>(c), agrees_with_the_generic_step<-1>(c);
}

BOOST_AUTO_TEST_CASE(casimirs_of_a_top_are_conserved_to_rounding_however_long_the_step) {
  for (Side const side : {Side::left, Side::right}) {
    System const system = system_of(cases[0], side);
    LevelIntegrator run(system, 0.4, point_at(*system, cases[0].velocity, cases[0].vector),
                        cases[0].velocity);
    auto const casimirs = [&] {
      List const &p = run.point().momentum, &a = run.point().vectors;
      return List{a[0] * a[0] + a[1] * a[1] + a[2] * a[2], p[0] * a[0] + p[1] * a[1] + p[2] * a[2]};
    };
    List const before = casimirs(), p = run.point().momentum;
    int const steps = 100;
    for (int k = 0; k < steps; ++k) run.step();
    double const size = std::max(largest(p), largest(run.point().momentum));
    // Each step rounds some twenty terms of the series of Ad*.
    BOOST_TEST(largest(minus(casimirs(), before)) < 20 * steps * eps * std::max(size, 1.0));
    BOOST_TEST(largest(minus(run.point().momentum, p)) > 0.1 * size);
  }
}

BOOST_AUTO_TEST_SUITE_END()
