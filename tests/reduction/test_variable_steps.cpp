// Steps of different lengths after each other: what is conserved with physical momenta, and what is not where
// a discrete Lagrangian is divided by its step.
#include <boost/test/unit_test.hpp>

#include "actio/reduction/composition.hpp"
#include "actio/reduction/galerkin.hpp"
#include "refused.hpp"
#include "uneven_lagrangian.hpp"

using namespace actio;
using namespace actio::testing;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Steps of 3/2, 1/2, 4/5 and 6/5 of the mean, again and again, that add up to a time; `count` is a multiple
/// of 4.
std::vector<double> irregular(int count, double time) {
  double const pattern[] = {1.5, 0.5, 0.8, 1.2};
  std::vector<double> lengths;
  for (int k = 0; k < count; ++k) lengths.push_back(pattern[k % 4] * time / count);
  return lengths;
}

/// The thesis' normalisation: the natural chart's discrete Lagrangian over the step. Its momenta are momenta
/// over a time.
template <class L>
auto divided_by_the_step_left(L const& l) {
  return lie_poisson_step_left([l](auto const& h) {
    return [action = natural_chart_lagrangian_left(l, h), h](auto const& f) {
      auto const a = action(f);
      return decltype(a)(a / typename std::decay_t<decltype(f)>::Scalar(h));
    };
  });
}

struct Run {
  UnevenLagrangian<double> l;
  MomentumState<SpannedGroup, double> start;
  std::pair<Matrix<double>, Vector<double>> truth;
};
Run run_on(SpannedGroup const& group, double time) {
  Draw draw(17);
  UnevenLagrangian<double> const l(draw, group);
  auto const xi = draw.velocity<double>(group);
  return {l, momentum_state(l, xi), FlowByHand<double, -1>{l}.after(xi.coordinates, time)};
}

/// Error of the momentum at the end of steps matched by momenta over a time: with h p at the start and p / h
/// at the end they are read as momenta.
double error_divided(Run const& run, std::vector<double> const& lengths) {
  MomentumState<SpannedGroup, double> const scaled{run.start.momentum / lengths.front(), run.start.velocity};
  auto const end = take_steps(divided_by_the_step_left(run.l), scaled, lengths);
  return magnitude((end.momentum.components * lengths.back() - run.truth.second).eval()) /
         magnitude(run.truth.second);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(variable_steps)

BOOST_AUTO_TEST_CASE(steps_of_any_lengths_have_the_order_of_equal_ones) {
  for (auto const& group : four_groups()) {
    auto const run = run_on(group, 0.5);
    auto const order = [&](auto const& step, std::vector<int> const& counts) {
      std::vector<double> errors;
      for (int const count : counts)
        errors.push_back(error_of_run<-1>(step, run.start, irregular(count, 0.5), run.truth));
      return order_of(counts, errors).slope;
    };
    BOOST_TEST_CONTEXT(group.name()) {
      BOOST_TEST(std::abs(order(natural_chart_step_left(run.l), {32, 48, 64, 96, 128}) - 2) < 0.05);
      BOOST_TEST(std::abs(order(galerkin_step_left<double>(run.l, 2), {16, 24, 32, 48, 64}) - 4) < 0.05);
      BOOST_TEST(std::abs(order(ComposedLeft(natural_chart_step_left(run.l), suzuki<double>()),
                                {16, 24, 32, 48, 64}) -
                          4) < 0.05);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_momentum_of_the_symmetry_is_kept_whatever_the_lengths) {
  for (auto const& group : four_groups()) {
    auto const run = run_on(group, 2);
    auto const lengths = irregular(40, 2);
    auto const drift = [&](auto const& step) {
      auto g = identity<double>(group);
      double worst = 0;
      take_steps(step, run.start, lengths, [&](auto const& done, double) {
        g = next_configuration<-1>(g, done.relative_motion);
        double const size = std::max(1.0, magnitude(g.value) * magnitude(inverse(g).value));
        auto const change = conserved_momentum<-1>(g, done.state.momentum) - run.start.momentum;
        worst =
            std::max(worst, magnitude(change.components) / magnitude(run.start.momentum.components) / size);
      });
      return worst;
    };
    BOOST_TEST_CONTEXT(group.name()) {
      BOOST_TEST(drift(natural_chart_step_left(run.l)) < 16 * 40 * eps);
      BOOST_TEST(drift(galerkin_step_left<double>(run.l, 3)) < 16 * 40 * eps);
      BOOST_TEST(drift(ComposedLeft(natural_chart_step_left(run.l), kahan_li<double>())) < 16 * 9 * 40 * eps);
    }
  }
}

BOOST_AUTO_TEST_CASE(steps_of_three_lengths_keep_the_bracket) {
  std::vector<double> const lengths{0.1, 0.02, 0.15};
  for (auto const& group : four_groups()) {
    auto const run = run_on(group, 0.27);
    auto const after = [&](auto const& step) {
      return [&](auto const& m) {
        return take_steps(step, MomentumState{m, like(m, run.start.velocity)}, lengths).momentum;
      };
    };
    // 16 eps over the step of each of the three, the shortest most; a few such terms add up.
    double const room = 4 * 16 * eps / 0.02;
    auto const chart = natural_chart_step_left(run.l);
    auto const galerkin = galerkin_step_left<double>(run.l, 2);
    BOOST_TEST_CONTEXT(group.name()) {
      BOOST_TEST(bracket_defect(after(chart), run.start.momentum) < room);
      BOOST_TEST(bracket_defect(after(galerkin), run.start.momentum) < room);
    }
  }
}

BOOST_AUTO_TEST_CASE(divided_by_the_step_equal_steps_are_right_and_others_are_not) {
  for (auto const& group : four_groups()) {
    auto const run = run_on(group, 0.5);
    BOOST_TEST_CONTEXT(group.name()) {
      // Equal steps: the same motion. Unequal ones: each step starts with the momentum times h_{k+1}/h_k, and
      // no refinement helps.
      std::vector<double> const equal(64, 0.5 / 64);
      BOOST_TEST(error_divided(run, equal) <
                 2 * error_of_run<-1>(natural_chart_step_left(run.l), run.start, equal, run.truth));
      for (int const count : {32, 64, 128, 256}) {
        BOOST_TEST(error_divided(run, irregular(count, 0.5)) > 0.01);
        BOOST_TEST(error_of_run<-1>(natural_chart_step_left(run.l), run.start, irregular(count, 0.5),
                                    run.truth) < 0.01);
      }
      // Yet it preserves the bracket that belongs to its momenta: structure alone does not make a flow right.
      auto const after = [&](auto const& m) {
        return take_steps(divided_by_the_step_left(run.l), MomentumState{m, like(m, run.start.velocity)},
                          std::vector<double>{0.02, 0.01})
            .momentum;
      };
      BOOST_TEST(bracket_defect(after, run.start.momentum / 0.02) < 4 * 16 * eps / 0.01);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_bad_length_anywhere_is_refused) {
  auto const run = run_on(four_groups()[0], 0.5);
  for (double const bad : {0.0, std::nan(""), HUGE_VAL}) {
    std::vector<double> const lengths{0.1, bad, 0.1};
    CHECK_REFUSED(take_steps(natural_chart_step_left(run.l), run.start, lengths), Error);
    CHECK_REFUSED(take_steps(galerkin_step_left<double>(run.l, 2), run.start, lengths), Error);
  }
  auto const end = take_steps(natural_chart_step_left(run.l), run.start, std::vector<double>{});
  BOOST_TEST(end.momentum.components == run.start.momentum.components);
}

BOOST_AUTO_TEST_SUITE_END()
