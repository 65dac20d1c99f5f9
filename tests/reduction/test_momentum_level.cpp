// Steps on a level of the momentum: their coefficients, their order on four groups for a Lagrangian that is
// not quadratic, what they conserve and what they do not, gradients, and what is refused.
#include <boost/test/unit_test.hpp>

#include "actio/groups/rotations.hpp"
#include "actio/reduction/momentum_level.hpp"
#include "refused.hpp"
#include "uneven_lagrangian.hpp"

using namespace actio;
using namespace actio::testing;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

template <int side, Real S, class L>
auto level_step(L const& l) {
  if constexpr (side > 0)
    return momentum_level_step_right<S>(l);
  else
    return momentum_level_step_left<S>(l);
}

template <int side>
void has_order_eight(SpannedGroup const& group) {
  Draw draw(11);
  UnevenLagrangian<Number> const l(draw, group);
  auto const xi = draw.velocity<Number>(group);
  Number const time = ratio<Number>(1, 32);
  auto const truth = FlowByHand<Number, side>{l}.after(xi.coordinates, time);
  auto const measured =
      measured_order<side>(level_step<side, Number>(l), l, xi, time, {2, 3, 4, 6, 8}, truth);
  BOOST_TEST_CONTEXT(group.name() << (side > 0 ? " right" : " left") << ": spread " << measured.spread)
  BOOST_TEST(std::abs(measured.slope - 8) < 0.1);
}

template <int side>
void conserves_orbit_and_momentum(SpannedGroup const& group) {
  Draw draw(23);
  UnevenLagrangian<double> const l(draw, group);
  auto const start = momentum_state(l, draw.velocity<double>(group));
  int const steps = 20;
  auto g = identity<double>(group);
  // The step is so long that its error is far above rounding.
  auto const end =
      take_steps(level_step<side, double>(l), start, std::vector<double>(steps, 0.2),
                 [&](auto const& done, double) { g = next_configuration<side>(g, done.relative_motion); });
  double const whole = magnitude(start.momentum.components),
               moved = magnitude((end.momentum - start.momentum).components) / whole,
               error =
                   magnitude((conserved_momentum<side>(g, end.momentum) - start.momentum).components) / whole,
               size = std::max(1.0, magnitude(g.value) * magnitude(inverse(g).value));
  BOOST_TEST_CONTEXT(group.name() << (side > 0 ? " right" : " left")) {
    // Ad of a configuration multiplies a few roundings a step by its own size, at most that of its square in
    // matrices.
    BOOST_TEST(error < 16 * steps * eps * size);
    BOOST_TEST(moved > 1e-2);
  }
}

/// A body that turns, and its state after some steps.
auto const body = [](auto const& xi) {
  auto const& v = xi.coordinates;
  return (v[0] * v[0] * 0.6 + v[1] * v[1] * 0.8 + v[2] * v[2]) / 2;
};
/// The same with a term that is not quadratic.
auto const bent_body = [](auto const& xi) {
  auto const& v = xi.coordinates;
  return body(xi) + v[0] * v[0] * v[1] * v[1] / 8;
};
/// Gradients of each of some steps.
template <class L>
std::vector<int> gradients(L const& l, int steps) {
  auto state = momentum_state(l, velocity(SO<3>{}, Vector<double, 3>(1.8, -1, 0.7)));
  auto const step = momentum_level_step_left<double>(l);
  std::vector<int> out;
  for (int k = 0; k < steps; ++k) {
    auto const done = step(state, 0.05);
    state = done.state, out.push_back(done.evaluations);
  }
  return out;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(momentum_level)

BOOST_AUTO_TEST_CASE(coefficients_satisfy_the_conditions_of_quadrature_to_order_eight_and_no_further) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  detail::Fehlberg<Number> const method;
  auto const sum = [&](int row, auto const& of) {
    Number out(0);
    for (int k = 0; k < method.rows[row].count; ++k)
      out += method.rows[row].weight[k] * of(method.rows[row].of[k]);
    return out;
  };
  auto const node = [&](int stage) { return sum(stage, [](int) { return Number(1); }); };
  auto const power = [&](int degree) { return [=](int stage) { return Number(pow(node(stage), degree)); }; };
  int const end = method.stages;
  for (int degree = 0; degree <= 8; ++degree) {
    Number const wrong = magnitude(sum(end, power(degree)) - Number(1) / Number(degree + 1));
    BOOST_TEST_CONTEXT("degree " << degree)
    BOOST_TEST((degree < 8 ? wrong < 64 * epsilon<Number>() : wrong > ratio<Number>(1, 1000000)));
  }
  // Two trees of order 8 that are no quadrature: a chain below a power, and two chains.
  auto const chain = [&](auto const& of) { return [=](int stage) { return sum(stage, of); }; };
  Number const one = magnitude(sum(end, chain(power(6))) - Number(1) / Number(56)),
               two = magnitude(sum(end, chain(chain(power(5)))) - Number(1) / Number(336));
  BOOST_TEST((one < 64 * epsilon<Number>()));
  BOOST_TEST((two < 64 * epsilon<Number>()));
}

BOOST_AUTO_TEST_CASE(stages_without_weight_are_felt_at_the_end_in_the_third_order_alone) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  detail::Fehlberg<Number> const method;
  auto const weight = [&](int row, int stage) {
    Number out(0);
    for (int k = 0; k < method.rows[row].count; ++k)
      if (method.rows[row].of[k] == stage) out += method.rows[row].weight[k];
    return out;
  };
  auto const felt = [&](int j, auto const& of) {
    Number out(0);
    for (int i = 0; i < method.stages; ++i) out += weight(method.stages, i) * of(i, j);
    return magnitude(out);
  };
  auto const node = [&](int stage) {
    Number out(0);
    for (int k = 0; k < method.stages; ++k) out += weight(stage, k);
    return out;
  };
  auto const by_node = [&](int i, int j) { return Number(node(i) * weight(i, j)); };
  auto const twice = [&](int i, int j) {
    Number out(0);
    for (int k = 0; k < method.stages; ++k) out += weight(i, k) * weight(k, j);
    return out;
  };
  Number const rounding = 64 * epsilon<Number>();
  for (int j = 1; j < method.first_with_weight; ++j) {
    BOOST_TEST((weight(method.stages, j) == Number(0)));
    BOOST_TEST((felt(j, weight) < rounding));
    BOOST_TEST((felt(j, by_node) < rounding));
    BOOST_TEST((felt(j, twice) < rounding));
  }
  // Others are felt; the stage but one is at the start of the step.
  BOOST_TEST((felt(0, by_node) > rounding));
  BOOST_TEST((magnitude(node(method.stages - 2)) < rounding));
  BOOST_TEST((magnitude(node(method.stages - 1) - Number(1)) < rounding));
}

BOOST_AUTO_TEST_CASE(the_order_is_eight_on_either_side_of_four_groups) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  for (auto const& group : four_groups()) has_order_eight<1>(group), has_order_eight<-1>(group);
}

BOOST_AUTO_TEST_CASE(momentum_and_orbit_are_conserved_to_rounding_however_long_the_step) {
  for (auto const& group : four_groups())
    conserves_orbit_and_momentum<1>(group), conserves_orbit_and_momentum<-1>(group);
}

BOOST_AUTO_TEST_CASE(the_bracket_is_not_preserved) {
  Draw draw(23);
  auto const& group = four_groups().front();
  UnevenLagrangian<double> const l(draw, group);
  auto const start = momentum_state(l, draw.velocity<double>(group));
  auto const whole = [&](auto const& m) {
    using S = typename std::decay_t<decltype(m.components)>::Scalar;
    return momentum_level_step_left<Base<S>>(l)(MomentumState{m, like(m, start.velocity)}, 1.0)
        .state.momentum;
  };
  BOOST_TEST(bracket_defect(whole, start.momentum) > 1e-9);
}

BOOST_AUTO_TEST_CASE(a_quadratic_lagrangian_costs_two_gradients_a_step_and_another_at_most_ten_a_stage) {
  auto const quadratic = gradients(body, 40);
  BOOST_TEST(quadratic.back() == 2);
  auto const bent = gradients(bent_body, 40);
  BOOST_TEST(*std::ranges::max_element(bent) <= 10 * detail::Fehlberg<double>::stages);
  BOOST_TEST(bent.back() > 2);
}

BOOST_AUTO_TEST_CASE(one_step_serves_one_group_after_another) {
  Draw draw(31);
  auto const groups = four_groups();
  auto const step = momentum_level_step_left<double>([](auto const& xi) {
    auto sum = xi.coordinates[0] * 0.0;
    for (Index i = 0; i < xi.coordinates.size(); ++i)
      sum += xi.coordinates[i] * xi.coordinates[i] * (1 + 0.3 * double(i));
    return sum;
  });
  int pairs = 0;
  for (auto const& one : groups)
    for (auto const& other : groups) {
      if (&one == &other || one.dimension() != other.dimension()) continue;
      ++pairs;
      auto const fresh = step;
      auto const start = momentum_state(step.l, draw.velocity<double>(one));
      step(momentum_state(step.l, draw.velocity<double>(other)), 0.1);
      BOOST_TEST_CONTEXT(one.name() << " after " << other.name())
      BOOST_TEST(magnitude((step(start, 0.1).state.momentum - fresh(start, 0.1).state.momentum).components) ==
                 0);
    }
  BOOST_TEST(pairs > 0);
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused) {
  auto const start = momentum_state(body, velocity(SO<3>{}, Vector<double, 3>(1.8, -1, 0.7)));
  auto const step = momentum_level_step_left<double>(body);
  CHECK_REFUSED(step(start, 0), OutsideDomain);
  CHECK_REFUSED(step(start, std::numeric_limits<double>::infinity()), OutsideDomain);
  auto broken = start;
  broken.momentum.components[1] = std::numeric_limits<double>::quiet_NaN();
  CHECK_REFUSED(step(broken, 0.1), NotFinite);
  // A direction that the Lagrangian does not see has no velocity.
  auto const blind = momentum_level_step_left<double>([](auto const& xi) {
    auto const& v = xi.coordinates;
    return (v[0] * v[0] + v[1] * v[1]) / 2;
  });
  CHECK_REFUSED(blind(start, 0.1), Singular);
  // No velocity has this momentum: its Legendre map has momenta below 1 alone.
  auto const bounded = momentum_level_step_left<double>([](auto const& xi) {
    using std::sqrt;
    auto const& v = xi.coordinates;
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + 1.0);
  });
  CHECK_REFUSED(bounded(start, 0.1), Singular);
}

BOOST_AUTO_TEST_SUITE_END()
