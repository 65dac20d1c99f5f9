// Steppers that reuse the derivative of their equation and extrapolate its solutions, against Newton's
// iteration from scratch: the same motions to rounding, what is conserved, the order, and the same refusals.
#include <boost/test/unit_test.hpp>

#include "actio/groups/linear_groups.hpp"
#include "actio/groups/motions.hpp"
#include "actio/reduction/euler_lagrange_steps.hpp"
#include "actio/reduction/euler_poincare_steps.hpp"
#include "actio/reduction/galerkin.hpp"
#include "refused.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Kinetic energy of unequal moments with a product of inertia, in any algebra.
auto const kinetic = [](auto const& xi) {
  auto const& v = xi.coordinates;
  auto sum = v[0] * v[0] + v[0] * v[1] * 0.4;
  for (Index i = 1; i < v.size(); ++i) sum += v[i] * v[i] * (1 + 0.3 * i);
  return sum / 2;
};
template <class G>
Velocity<G, double> velocity_at_start(double size) {
  Velocity<G, double> xi{G{}, Coordinates<G, double>(G::dim)};
  for (int i = 0; i < G::dim; ++i) xi.coordinates[i] = size * std::sin(1 + 2.3 * i);
  return xi;
}
template <class M>
double largest(M const& m) { return magnitude(m); }

/// By how much more than the residual, in units of its rows, a solution may be off: the largest row of |J^-1|
/// times the sizes of the rows of J.
template <class M>
double condition(M const& derivative) {
  M const inverse = inverse_matrix(derivative);
  double worst = 0;
  for (Index i = 0; i < inverse.rows(); ++i) {
    double sum = 0;
    for (Index j = 0; j < inverse.cols(); ++j)
      sum += std::abs(inverse(i, j)) * derivative.row(j).cwiseAbs().sum();
    worst = std::max(worst, sum);
  }
  return worst;
}

/// Two solvers stop within 16 eps of a row each, and the momentum is off by that of the step
/// before: four times that with what Ad adds.
template <int side, class G>
void the_same_relative_motions(double size, double h, int steps) {
  auto const l = natural_chart_lagrangian_left(kinetic, h);
  Element<G, double> const first = exp(-h * velocity_at_start<G>(size));
  auto motion = [&] {
    if constexpr (side > 0)
      return EulerPoincareStepsRight(l, first);
    else
      return EulerPoincareStepsLeft(l, first);
  }();
  double worst = 0;
  for (int k = 0; k < steps; ++k) {
    Element<G, double> const before = motion.relative_motion();
    Element<G, double> const reference =
        side > 0 ? step_euler_poincare_right(l, before).value : step_euler_poincare_left(l, before).value;
    motion.advance();
    double const bound = 64 * eps *
                         condition(side > 0 ? right_second_differential(l, reference)
                                            : left_second_differential(l, reference)) *
                         largest(reference.value);
    worst = std::max(worst, largest((motion.relative_motion().value - reference.value).eval()) / bound);
    BOOST_REQUIRE(motion.report().residuals.back() <= 4 * motion.report().tolerance);
  }
  BOOST_TEST(worst < 1);
}

template <class G>
void momentum_in_space_stays(double size, double h, int steps) {
  auto const l = natural_chart_lagrangian_left(kinetic, h);
  EulerPoincareStepsLeft motion(l, exp(-h * velocity_at_start<G>(size)));
  auto g = identity<double>(G{});
  auto const in_space = [&] { return Ad_star(inverse(g), motion.momentum()).components; };
  // Π after a step belongs to the configuration it leads to.
  auto const before = in_space();
  double worst = 0, extent = 1;
  for (int k = 0; k < steps; ++k) {
    g = reconstruct_left(g, motion.advance());
    extent = std::max(extent, largest(g.value) * largest(inverse(g).value));
    worst = std::max(worst, largest((in_space() - before).eval()) / largest(before));
  }
  // A few roundings a step, in configuration and momentum, magnified by Ad.
  BOOST_TEST(worst < 16 * steps * eps * extent);
  BOOST_TEST(largest((motion.momentum().components - before).eval()) > 1e-2 * largest(before));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(steps_that_remember)

BOOST_AUTO_TEST_CASE(relative_motions_are_those_of_newton_from_scratch) {
  for (double h : {0.02, 0.1, 0.4}) {
    BOOST_TEST_CONTEXT("SO(3) h = " << h)
    the_same_relative_motions<-1, SO<3>>(0.8, h, 60), the_same_relative_motions<1, SO<3>>(0.8, h, 60);
    BOOST_TEST_CONTEXT("SE(3) h = " << h) the_same_relative_motions<-1, SE<3>>(0.5, h, 30);
    BOOST_TEST_CONTEXT("SO(4) h = " << h) the_same_relative_motions<-1, SO<4>>(0.5, h, 30);
    BOOST_TEST_CONTEXT("SL(2) h = " << h) the_same_relative_motions<-1, SL2>(0.3, h, 30);
  }
}

BOOST_AUTO_TEST_CASE(the_momentum_in_space_stays_and_that_of_the_body_does_not) {
  momentum_in_space_stays<SO<3>>(0.8, 0.1, 5000);
  momentum_in_space_stays<SE<3>>(0.5, 0.1, 1000);
  momentum_in_space_stays<SO<4>>(0.5, 0.1, 1000);
  momentum_in_space_stays<SL2>(0.3, 0.05, 200);
}

BOOST_AUTO_TEST_CASE(the_order_is_two) {
  // The body momentum at time 4, against steps a sixteenth as long.
  auto const at_end = [](int steps) {
    double const h = 4.0 / steps;
    auto const l = natural_chart_lagrangian_left(kinetic, h);
    auto const start = gradient(kinetic, velocity_at_start<SO<3>>(0.8));
    EulerPoincareStepsLeft motion(
        l, relative_motion_from_momentum_left(l, start, exp(-h * velocity_at_start<SO<3>>(0.8))).value);
    for (int k = 1; k < steps; ++k) motion.advance();
    return motion.momentum().components;
  };
  Vector3d const fine = at_end(1280), coarse = at_end(40), half = at_end(80);
  double const ratio = (coarse - fine).norm() / (half - fine).norm();
  BOOST_TEST(ratio > 3.6);
  BOOST_TEST(ratio < 4.4);
}

BOOST_AUTO_TEST_CASE(places_are_those_of_the_unreduced_equations_from_scratch) {
  double const h = 0.1;
  auto const l = lift_left(natural_chart_lagrangian_left(kinetic, h));
  auto const weighed = [l, h](auto const& g0, auto const& g1) {
    return l(g0, g1) - (g0.value(2, 2) + g1.value(2, 2)) * (h / 2);
  };
  Element<SO<3>, double> const g0 = exp(velocity_at_start<SO<3>>(0.7)),
                               g1 = g0 * exp(h * velocity_at_start<SO<3>>(0.9));
  EulerLagrangeSteps motion(weighed, g0, g1);
  double worst = 0;
  for (int k = 0; k < 100; ++k) {
    auto const reference = step_euler_lagrange(weighed, motion.before(), motion.configuration()).value;
    worst = std::max(worst, largest((motion.advance().value - reference.value).eval()));
  }
  // Moments between 1 and 1.6, joined by a product of inertia: the condition is below 3.
  BOOST_TEST(worst < 3 * 64 * eps);
}

BOOST_AUTO_TEST_CASE(a_first_step_begins_at_the_end_of_the_geodesic) {
  // Of an energy that both translations leave alone the motion is a geodesic: g = g1 g0^-1 g1 solves the
  // equation, which is looked at once. Elsewhere it takes several looks to find it.
  auto const round = [](auto const& g0, auto const& g1) {
    return -(g0.value.transpose() * g1.value).trace();
  };
  Element<SO<3>, double> const g0 = exp(velocity_at_start<SO<3>>(0.7)),
                               g1 = g0 * exp(velocity_at_start<SO<3>>(0.3)), g = g1 * inverse(g0) * g1;
  EulerLagrangeSteps motion(round, g0, g1);
  // Eight roundings of a product of three, and as many of the equation's solution.
  BOOST_TEST(largest((motion.advance().value - g.value).eval()) < 16 * eps);
  BOOST_TEST(motion.report().evaluations == 1);
}

BOOST_AUTO_TEST_CASE(steps_on_momenta_remember_nothing_that_counts) {
  // From one motion to another and back, with another length in between: each step as if it were the first.
  auto const remembering = natural_chart_step_left(kinetic);
  auto const galerkin = galerkin_step_left<double>(kinetic, 2);
  auto a = momentum_state(kinetic, velocity_at_start<SO<3>>(0.8)),
       b = momentum_state(kinetic, velocity_at_start<SO<3>>(-0.5));
  double worst = 0;
  for (int k = 0; k < 20; ++k)
    for (double h : {0.1, 0.1, 0.25}) {
      auto& from = k % 5 == 4 ? b : a;
      auto const one = remembering(from, h), first = natural_chart_step_left(kinetic)(from, h);
      auto const two = galerkin(from, h), second = galerkin_step_left<double>(kinetic, 2)(from, h);
      worst = std::max({worst, largest((one.relative_motion.value - first.relative_motion.value).eval()),
                        largest((two.relative_motion.value - second.relative_motion.value).eval())});
      from = one.state;
    }
  // Two solvers, 16 eps each; the derivatives of the Galerkin equations have rows with slopes of polynomials,
  // of size 4.
  BOOST_TEST(worst < 4 * 2 * 16 * 3 * eps);
}

BOOST_AUTO_TEST_CASE(refusals_are_those_of_newton_and_leave_the_motion_where_it_was) {
  double const h = 0.1;
  auto const l = natural_chart_lagrangian_left(kinetic, h);
  Element<SO<3>, double> no_number = identity<double>(SO<3>{});
  no_number.value(0, 1) = std::nan("");
  CHECK_REFUSED(EulerPoincareStepsLeft(l, no_number), NotFinite);
  CHECK_REFUSED(EulerPoincareStepsRight(l, no_number), NotFinite);

  // An energy that does not know the third component of the velocity.
  auto const degenerate = natural_chart_lagrangian_left(
      [](auto const& xi) {
        return xi.coordinates[0] * xi.coordinates[0] + xi.coordinates[1] * xi.coordinates[1];
      },
      h);
  EulerPoincareStepsLeft flat(degenerate, identity<double>(SO<3>{}));
  CHECK_REFUSED(flat.advance(), Singular);
  BOOST_TEST((flat.relative_motion().value == Matrix<double, 3, 3>::Identity()));

  // An energy that ends: where it is no number there is no step, neither at the first nor after good ones.
  double end = 1e9;
  auto const ending = natural_chart_lagrangian_left(
      [&end](auto const& xi) {
        auto const all = kinetic(xi);
        return base_value(all) > end ? all * std::nan("") : all;
      },
      h);
  EulerPoincareStepsLeft motion(ending, exp(-h * velocity_at_start<SO<3>>(0.8)));
  for (int k = 0; k < 5; ++k) motion.advance();
  auto const before = motion.relative_motion().value;
  auto const momentum_before = motion.momentum().components;
  end = 0;
  CHECK_REFUSED(motion.advance(), NotFinite);
  CHECK_REFUSED(step_euler_poincare_left(ending, Element<SO<3>, double>{{}, before}), NotFinite);
  BOOST_TEST((motion.relative_motion().value == before));
  BOOST_TEST((motion.momentum().components == momentum_before));
  end = 1e9;
  auto const reference = step_euler_poincare_left(ending, Element<SO<3>, double>{{}, before}).value.value;
  BOOST_TEST(largest((motion.advance().value - reference).eval()) < 3 * 64 * eps);
}

BOOST_AUTO_TEST_SUITE_END()
