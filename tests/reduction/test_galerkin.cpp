// Galerkin steps: the differential of the action, what is preserved exactly, the natural chart as the case of
// degree one, and what is refused.
#include <boost/test/unit_test.hpp>

#include "actio/reduction/galerkin.hpp"
#include "refused.hpp"
#include "uneven_lagrangian.hpp"

using namespace actio;
using namespace actio::testing;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

template <int side, class L>
auto galerkin(L const& l, int s) {
  if constexpr (side > 0)
    return galerkin_step_right<double>(l, s);
  else
    return galerkin_step_left<double>(l, s);
}

/// The differential of the action, written out, against the action on dual numbers.
template <int side>
void the_differential_is_that_of_the_action(SpannedGroup const& group, int s) {
  Draw draw(41);
  UnevenLagrangian<double> const l(draw, group);
  PolynomialPath<double> const path(s);
  double const h = 0.3;
  Vector<double> const xi = draw.vector<double>(s * group.dimension()) * h;
  auto const written_out = detail::galerkin_differential<side>(
      detail::LagrangianAtNodes<std::decay_t<decltype(l)>>{l}, path, group, h, xi);
  double worst = 0;
  for (int k = 0; k < xi.size(); ++k) {
    Vector<Dual<double>> moved = xi.cast<Dual<double>>();
    moved[k].part[0] = 1;
    worst = std::max(
        worst, std::abs(detail::galerkin_action<side>(l, path, group, h, moved).part[0] - written_out[k]));
  }
  // Slopes of the polynomials grow with the degree, to about 10; sums of s nodes and as many products as the
  // group has dimensions.
  BOOST_TEST_CONTEXT(group.name() << " s = " << s)
  BOOST_TEST(worst < 10 * 16 * s * group.dimension() * eps * magnitude(written_out));
}

template <int side>
void keeps_orbit_momentum_and_bracket(SpannedGroup const& group, int s) {
  Draw draw(23);
  UnevenLagrangian<double> const l(draw, group);
  auto const start = momentum_state(l, draw.velocity<double>(group));
  auto const step = galerkin<side>(l, s);
  double const h = 0.1;
  int const steps = 20;
  auto g = identity<double>(group);
  auto const end = take_steps(step, start, std::vector<double>(steps, h), [&](auto const& done, double) {
    g = next_configuration<side>(g, done.relative_motion);
  });
  double const moved = magnitude((end.momentum - start.momentum).components) /
                       magnitude(start.momentum.components),
               momentum_error =
                   magnitude((conserved_momentum<side>(g, end.momentum) - start.momentum).components) /
                   magnitude(start.momentum.components);
  auto const whole = [&](auto const& m) {
    return step(MomentumState{m, like(m, start.velocity)}, h).state.momentum;
  };
  // The relative motion taken the wrong way round: it preserves every orbit too.
  auto const wrong = [&](auto const& m) {
    auto const f = step(MomentumState{m, like(m, start.velocity)}, h).relative_motion;
    return side > 0 ? Ad_star(inverse(f), m) : Ad_star(f, m);
  };
  BOOST_TEST_CONTEXT(group.name() << (side > 0 ? " right" : " left") << " s = " << s) {
    // Ad of a configuration multiplies a few roundings a step by its own size, at most that of its square in
    // matrices.
    double const size = std::max(1.0, magnitude(g.value) * magnitude(inverse(g).value));
    BOOST_TEST(momentum_error < 16 * steps * eps * size);
    BOOST_TEST(moved > 1e-2);
    // Derivatives of relative motions are found to 16 eps in units of motion, 16 eps/h in those of velocity;
    // a few such terms add up.
    BOOST_TEST(bracket_defect(whole, start.momentum) < 4 * 16 * eps / h);
    BOOST_TEST(bracket_defect(wrong, start.momentum) > 1e-6);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(galerkin_steps)

BOOST_AUTO_TEST_CASE(the_differential_written_out_is_that_of_the_action) {
  for (auto const& group : four_groups())
    for (int s = 1; s <= 4; ++s)
      the_differential_is_that_of_the_action<-1>(group, s),
          the_differential_is_that_of_the_action<1>(group, s);
}

BOOST_AUTO_TEST_CASE(degree_one_is_the_natural_chart) {
  Draw draw(8);
  for (auto const& group : four_groups()) {
    UnevenLagrangian<double> const l(draw, group);
    auto const start = momentum_state(l, draw.velocity<double>(group));
    for (double const h : {0.1, -0.1}) {
      auto const one = galerkin<-1>(l, 1)(start, h), chart = natural_chart_step_left(l)(start, h);
      BOOST_TEST_CONTEXT(group.name())
      BOOST_TEST(magnitude((one.relative_motion.value - chart.relative_motion.value).eval()) < 2 * 16 * eps);
    }
  }
}

BOOST_AUTO_TEST_CASE(every_degree_keeps_orbit_momentum_and_bracket) {
  for (auto const& group : four_groups())
    for (int s = 1; s <= 3; ++s)
      keeps_orbit_momentum_and_bracket<-1>(group, s), keeps_orbit_momentum_and_bracket<1>(group, s);
}

BOOST_AUTO_TEST_CASE(a_step_back_undoes_a_step_up_to_the_order_of_the_method) {
  // The chart is that of the earlier configuration, so a step of degree 2 is not its own adjoint; degree 1, a
  // one-parameter subgroup, is.
  Draw draw(5);
  auto const& group = four_groups()[3];
  UnevenLagrangian<double> const l(draw, group);
  auto const start = momentum_state(l, draw.velocity<double>(group));
  double const h = 0.1;
  auto const left_over = [&](int s) {
    auto const step = galerkin<-1>(l, s);
    auto const back = step(step(start, h).state, -h).state;
    return magnitude((back.momentum - start.momentum).components) / magnitude(start.momentum.components);
  };
  BOOST_TEST(left_over(1) < 2 * 16 * eps / h);
  BOOST_TEST(left_over(2) > 1e3 * eps);
  BOOST_TEST(left_over(2) < 1e-4);
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused) {
  Draw draw(3);
  auto const& group = four_groups()[0];
  UnevenLagrangian<double> const l(draw, group);
  auto const step = galerkin<-1>(l, 2);
  auto const start = momentum_state(l, draw.velocity<double>(group));
  double const nan = std::nan("");
  for (double const bad : {0.0, nan, HUGE_VAL, -HUGE_VAL}) CHECK_REFUSED(step(start, bad), Error);
  for (double const bad : {nan, HUGE_VAL}) {
    auto momentum = start, velocity = start;
    momentum.momentum.components[1] = bad, velocity.velocity.coordinates[0] = bad;
    CHECK_REFUSED(step(momentum, 0.1), NotFinite);
    CHECK_REFUSED(step(velocity, 0.1), NotFinite);
  }
  for (double const far : {30.0, 1e3, 1e6, 1e300}) CHECK_REFUSED(step(start, far), Error);
  CHECK_REFUSED(galerkin<-1>(l, 0), OutsideDomain);
  // A Lagrangian that does not depend on a direction, and one that is no number.
  auto const blind = [](auto const& xi) {
    return xi.coordinates[0] * xi.coordinates[0] + xi.coordinates[1] * xi.coordinates[1];
  };
  CHECK_REFUSED(galerkin_step_left<double>(blind, 2)(start, 0.1), Singular);
  auto const broken = [nan](auto const& xi) { return xi.coordinates[0] * nan; };
  CHECK_REFUSED(galerkin_step_left<double>(broken, 2)(start, 0.1), Error);
}

BOOST_AUTO_TEST_SUITE_END()
