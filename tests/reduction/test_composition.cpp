// Compositions: what each substep preserves, what the base step must be, and what is refused.
#include <boost/test/unit_test.hpp>

#include "actio/reduction/composition.hpp"
#include "refused.hpp"
#include "uneven_lagrangian.hpp"

using namespace actio;
using namespace actio::testing;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

template <int side, class S, class L>
auto composed(L const& l, std::vector<S> const& fractions) {
  if constexpr (side > 0)
    return ComposedRight(natural_chart_step_right(l), fractions);
  else
    return ComposedLeft(natural_chart_step_left(l), fractions);
}

/// The natural chart, and an action of fourth order in h that an exchange of the ends does not turn around.
template <class L>
auto one_sided_step_left(L const& l) {
  return lie_poisson_step_left([l](auto const& h) {
    return [l, h](auto const& f) {
      using S = typename std::decay_t<decltype(f)>::Scalar;
      auto const xi = -log(f) / S(h);
      return (l(xi) + xi.coordinates[0] * xi.coordinates[0] * xi.coordinates[1] * S(h * h * h)) * S(h);
    };
  });
}

}  // namespace

BOOST_AUTO_TEST_SUITE(composition)

BOOST_AUTO_TEST_CASE(orders_four_and_six_on_rigid_motions) {
  // Here double carries five refinements: the last error is 1e-12.
  Draw draw(11);
  auto const& group = four_groups()[3];
  UnevenLagrangian<double> const l(draw, group);
  auto const xi = draw.velocity<double>(group);
  auto const truth = FlowByHand<double, -1>{l}.after(xi.coordinates, 0.5);
  std::vector<int> const counts{2, 3, 4, 6, 8};
  for (auto const& [fractions, order] : {std::pair{triple_jump<double>(), 4}, std::pair{suzuki<double>(), 4},
                                         std::pair{kahan_li<double>(), 6}}) {
    std::vector<double> errors;
    for (int const count : counts)
      errors.push_back(error_of_run<-1>(composed<-1>(l, fractions), momentum_state(l, xi),
                                        std::vector<double>(count, 0.5 / count), truth));
    BOOST_TEST(std::abs(order_of(counts, errors).slope - order) < 0.05);
    BOOST_TEST(errors.back() > 1e3 * eps);
  }
}

BOOST_AUTO_TEST_CASE(the_base_step_is_its_own_adjoint_and_a_composition_needs_that) {
  Draw draw(5);
  for (auto const& group : four_groups()) {
    UnevenLagrangian<double> const l(draw, group);
    auto const start = momentum_state(l, draw.velocity<double>(group));
    double const h = 0.1;
    auto const there_and_back = [&](auto const& step) {
      auto const there = step(start, h), back = step(there.state, -h);
      auto const left_over = back.relative_motion * there.relative_motion;
      return std::max(
          magnitude((back.state.momentum - start.momentum).components) / magnitude(start.momentum.components),
          magnitude((left_over.value - identity<double>(group).value).eval()));
    };
    // Either relative motion is found to 16 eps, so the momentum to 16 eps/h.
    BOOST_TEST_CONTEXT(group.name()) {
      BOOST_TEST(there_and_back(natural_chart_step_left(l)) < 2 * 16 * eps / h);
      BOOST_TEST(there_and_back(composed<-1>(l, kahan_li<double>())) < 18 * 16 * eps / h);
      BOOST_TEST(there_and_back(one_sided_step_left(l)) > 1e-8);
    }
  }
  // The error of third order in h that it has as well is cancelled, that of fourth order is not.
  auto const& group = four_groups()[2];
  UnevenLagrangian<double> const l(draw, group);
  auto const xi = draw.velocity<double>(group);
  auto const truth = FlowByHand<double, -1>{l}.after(xi.coordinates, 0.5);
  std::vector<int> const counts{64, 96, 128, 192, 256};
  std::vector<double> errors;
  for (int const count : counts)
    errors.push_back(error_of_run<-1>(ComposedLeft(one_sided_step_left(l), triple_jump<double>()),
                                      momentum_state(l, xi), std::vector<double>(count, 0.5 / count), truth));
  auto const measured = order_of(counts, errors);
  BOOST_TEST_MESSAGE("triple jump of a step that is not self-adjoint: order " << measured.slope);
  BOOST_TEST(std::abs(measured.slope - 3) < 0.1);
}

BOOST_AUTO_TEST_CASE(every_composition_keeps_orbit_momentum_and_bracket) {
  Draw draw(23);
  for (auto const& group : four_groups()) {
    UnevenLagrangian<double> const l(draw, group);
    auto const start = momentum_state(l, draw.velocity<double>(group));
    auto const step = composed<-1>(l, kahan_li<double>());
    double const h = 0.1;
    int const steps = 20;
    auto g = identity<double>(group);
    auto const end = take_steps(step, start, std::vector<double>(steps, h), [&](auto const& done, double) {
      g = next_configuration<-1>(g, done.relative_motion);
    });
    double const moved = magnitude((end.momentum - start.momentum).components) /
                         magnitude(start.momentum.components),
                 momentum_error =
                     magnitude((conserved_momentum<-1>(g, end.momentum) - start.momentum).components) /
                     magnitude(start.momentum.components);
    auto const whole = [&](auto const& m) {
      return step(MomentumState{m, like(m, start.velocity)}, h).state.momentum;
    };
    // The step with the relative motion taken the wrong way round: it preserves every orbit too.
    auto const wrong = [&](auto const& m) {
      return Ad_star(step(MomentumState{m, like(m, start.velocity)}, h).relative_motion, m);
    };
    BOOST_TEST_CONTEXT(group.name()) {
      // Ad of a configuration multiplies a few roundings a substep by its own size, at most that of its
      // square in matrices.
      double const size = std::max(1.0, magnitude(g.value) * magnitude(inverse(g).value));
      BOOST_TEST(momentum_error < 16 * 9 * steps * eps * size);
      BOOST_TEST(moved > 1e-2);
      // Derivatives of relative motions are found to 16 eps in units of motion, 16 eps/h in those of
      // velocity, nine times a step; a few such terms add up.
      BOOST_TEST(bracket_defect(whole, start.momentum) < 4 * 9 * 16 * eps / h);
      BOOST_TEST(bracket_defect(wrong, start.momentum) > 1e-6);
    }
  }
}

BOOST_AUTO_TEST_CASE(bad_fractions_and_bad_steps_are_refused) {
  Draw draw(3);
  auto const& group = four_groups()[0];
  UnevenLagrangian<double> const l(draw, group);
  auto const base = natural_chart_step_left(l);
  double const nan = std::nan("");
  BOOST_CHECK_EXCEPTION(ComposedLeft(base, std::vector<double>{0.5, 0.25}), OutsideDomain,
                        [](OutsideDomain const& e) { return e.measured == 0.75; });
  CHECK_REFUSED(ComposedLeft(base, std::vector<double>{}), OutsideDomain);
  CHECK_REFUSED(ComposedRight(base, std::vector<double>{nan}), NotFinite);
  auto const step = ComposedLeft(base, suzuki<double>());
  auto const start = momentum_state(l, draw.velocity<double>(group));
  for (double const bad : {0.0, nan, HUGE_VAL, -HUGE_VAL}) CHECK_REFUSED(step(start, bad), Error);
  auto broken = start;
  broken.momentum.components[1] = nan;
  CHECK_REFUSED(step(broken, 0.1), NotFinite);
  CHECK_REFUSED(step(start, 1e6), Error);
  // A substep of length zero has no discrete Lagrangian.
  CHECK_REFUSED(ComposedLeft(base, std::vector<double>{0.5, 0.0, 0.5})(start, 0.1), OutsideDomain);
}

BOOST_AUTO_TEST_SUITE_END()
