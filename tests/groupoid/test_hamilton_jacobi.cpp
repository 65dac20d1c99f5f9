// Hamilton-Jacobi theory as a reader uses it: exact generating functions against closed forms, the series
// against its first terms, the integrators it makes, refusals.
#include <boost/test/unit_test.hpp>

#include "actio/groupoid/generating_series.hpp"
#include "actio/groups/affine_line.hpp"
#include "actio/groups/rotations.hpp"
#include "actio/reduction/natural_chart.hpp"
#include "refused.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"
#include "witness/reference_solution.hpp"

using namespace actio;
using Matrix3d = actio::Matrix<double, 3, 3>;
using Vector3d = actio::Vector<double, 3>;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

QuadraticLagrangian<SO<3>, double> body(double i1, double i2, double i3) {
  return {SO<3>{}, Matrix3d(Vector3d(i1, i2, i3).asDiagonal())};
}
/// A body with a rotor in it: no symmetry, and the motion is not that of a reversed film.
QuadraticLagrangian<SO<3>, double> gyrostat() {
  Matrix3d a;
  a << 1.2, 0.1, -0.2, 0.1, 2.1, 0.3, -0.2, 0.3, 2.6;
  return {SO<3>{}, a, Vector3d(0.4, -0.3, 0.7)};
}
Momentum<SO<3>, double> some_momentum() { return momentum(SO<3>{}, Vector3d(0.7, -1.1, 0.9)); }

}  // namespace

BOOST_AUTO_TEST_SUITE(hamilton_jacobi_theory)

BOOST_AUTO_TEST_CASE(a_symmetric_body_moves_as_its_closed_form_says) {
  // g = exp(t Pi/I) exp(t (1/I3 - 1/I) Pi_3 e_3): it turns about its momentum and about its axis.
  double const across = 2, along = 0.7, t = 1.9;
  auto const pi = some_momentum();
  auto const motion = free_motion_left(body(across, across, along), pi, t);
  double const turn = t * (1 / along - 1 / across) * pi.components[2];
  auto const spin = velocity(SO<3>{}, Vector3d(0, 0, turn));
  auto const g = exp(velocity(SO<3>{}, Vector3d(t / across * pi.components))) * exp(spin);
  BOOST_TEST((motion.f.value - inverse(g).value).norm() < 64 * eps);
  BOOST_TEST((motion.pi.components - Ad_star(exp(spin), pi).components).norm() < 64 * eps);
  BOOST_TEST(std::abs(motion.action - t * body(across, across, along)(pi)) < 64 * eps);
}

BOOST_AUTO_TEST_CASE(a_gyrostat_moves_as_somebody_elses_code_says) {
  auto const l = gyrostat();
  auto const pi = some_momentum();
  double const t = 5;
  auto const rates = [&](double, Vector<double, 4> const& y) {
    auto const m = momentum(SO<3>{}, Vector3d(y.head<3>()));
    Vector3d const w = l.inverse_a * (m.components - l.b);
    Vector<double, 4> rate;
    rate << cross(m.components, w), m.components.dot(w) - l(m);
    return rate;
  };
  Vector<double, 4> start;
  start << pi.components, 0;
  auto const end = reference_solution(rates, start, 0, t);
  auto const motion = free_motion_left(l, pi, t);
  BOOST_TEST((motion.pi.components - end.head<3>()).norm() < 1e-12);
  BOOST_TEST(std::abs(motion.action - end[3]) < 1e-12);
  BOOST_TEST((motion.pi.components - final_momentum_left(motion.f, pi).components).norm() < 1e-13);
}

BOOST_AUTO_TEST_CASE(the_exact_generating_function_gives_the_motion_back) {
  auto const l = gyrostat();
  ExactGeneratingFunction const S{l};
  auto const pi = some_momentum();
  for (double const t : {0.3, 0.8, -0.5}) {
    auto const motion = free_motion_left(l, pi, t);
    BOOST_TEST(std::abs(S(motion.f, t) - motion.action) < 100 * eps);
    // Its differential is the momentum at the start, and (4.3) carries that to the end.
    double const room = 1000 * eps / std::abs(t);
    auto const start = initial_momentum_left(at_time(S, t), motion.f);
    BOOST_TEST((start.components - pi.components).norm() < room);
    BOOST_TEST((final_momentum_left(motion.f, start).components - motion.pi.components).norm() < room);
    // It solves (4.1), and no other sign of the momentum does.
    BOOST_TEST(std::abs(hamilton_jacobi_left(S, l, motion.f, t)) < room);
    auto const reversed = [&](auto const& mu) { return l(-mu); };
    BOOST_TEST(std::abs(hamilton_jacobi_left(S, reversed, motion.f, t)) > 0.1);
  }
}

BOOST_AUTO_TEST_CASE(for_a_sphere_the_discrete_lagrangian_of_the_natural_chart_is_exact) {
  auto const l = body(1.5, 1.5, 1.5);
  ExactGeneratingFunction const S{l};
  auto const series = generating_series(l, 4);
  auto const g = exp(velocity(SO<3>{}, Vector3d(0.4, -0.9, 0.6)));
  double const t = 0.7;
  double const chart = natural_chart_lagrangian_left(l, t)(g);
  BOOST_TEST(std::abs(S(g, t) - chart) < 64 * eps);
  BOOST_TEST(std::abs(series(g, t) - chart) < 16 * eps);
  for (int k = 1; k <= 4; ++k) BOOST_TEST(series.sigma[k].terms.empty());
}

BOOST_AUTO_TEST_CASE(odd_terms_vanish_and_the_first_even_one_is_the_square_of_the_acceleration) {
  WithArithmetic const exactly(Arithmetic::rationals());
  // Over the rationals, on the affine group of the line, with a linear term.
  FineDraw draw(3);
  Aff1 const group;
  using Matrix2 = Matrix<Number, 2, 2>;
  using Vector2 = Matrix<Number, 2, 1>;
  Matrix2 m;
  for (int i = 0; i < 4; ++i) m(i) = draw.number<Number>() / 4;
  QuadraticLagrangian<Aff1, Number> const l(group, Matrix2(Matrix2::Identity() + m * m.transpose()),
                                            draw.momentum<Number>(group).components);
  auto const series = generating_series(l, 3);
  BOOST_TEST(series.sigma[1].terms.empty());
  BOOST_TEST(series.sigma[3].terms.empty());
  auto const w = draw.velocity<Number>(group);
  Vector2 const force = ad_star(w, l.momentum_of(w)).components;
  BOOST_TEST((series.sigma[0].at(w.coordinates) == l(w)));
  BOOST_TEST((series.sigma[2].at(w.coordinates) == Number(-force.dot(l.inverse_a * force) / 24)));
}

BOOST_AUTO_TEST_CASE(a_truncation_after_order_k_makes_an_integrator_of_order_k_plus_two) {
  auto const l = gyrostat();
  auto const pi = some_momentum();
  double const until = 2;
  auto const exact = free_motion_left(l, pi, until).pi;
  for (int order : {0, 2, 4}) {
    auto const series = generating_series(l, order);
    std::vector<double> x, y;
    for (int n = 8; n <= 16; n *= 2) {
      auto at = pi;
      auto f = exp(-until / n * l.velocity_of(pi));
      for (int k = 0; k < n; ++k) {
        auto const step = hamilton_jacobi_step_left(at_time(series, until / n), at, f);
        at = step.final, f = step.g;
      }
      x.push_back(std::log(until / n)), y.push_back(std::log((at - exact).components.norm()));
    }
    BOOST_TEST_CONTEXT("order " << order) {
      BOOST_TEST(std::abs((y[1] - y[0]) / (x[1] - x[0]) - (order + 2)) < 0.1);
    }
  }
}

BOOST_AUTO_TEST_CASE(both_sides_have_their_own_step) {
  // The inverse of a left-invariant motion is a right-invariant one, with the opposite velocity and momentum.
  auto const l = gyrostat();
  QuadraticLagrangian<SO<3>, double> const mirrored(l.group, l.a, -l.b);
  auto const pi = some_momentum();
  double const t = 0.2;
  auto const series = generating_series(l, 2), other = generating_series(mirrored, 2);
  auto const start = exp(-t * l.velocity_of(pi));
  auto const left = hamilton_jacobi_step_left(at_time(series, t), pi, start);
  auto const right = hamilton_jacobi_step_right(at_time(other, t), -pi, inverse(start));
  BOOST_TEST((left.g.value - inverse(right.g).value).norm() < 100 * eps / t);
  BOOST_TEST((left.final + right.final).components.norm() < 100 * eps / t);
  BOOST_TEST(std::abs(hamilton_jacobi_left(series, l, left.g, t) -
                      hamilton_jacobi_right(other, mirrored, right.g, t)) < 100 * eps / t);
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused) {
  double const nan = std::nan("");
  auto const l = gyrostat();
  auto const g = exp(velocity(SO<3>{}, Vector3d(0.1, 0.2, 0.3)));
  auto const S = at_time(generating_series(l, 2), 0.5);
  CHECK_REFUSED(hamilton_jacobi_step_left(S, momentum(SO<3>{}, Vector3d(0, nan, 0)), g), NotFinite);
  CHECK_REFUSED(hamilton_jacobi_step_right(S, momentum(SO<3>{}, Vector3d(0, HUGE_VAL, 0)), g), NotFinite);
  CHECK_REFUSED(hamilton_jacobi_step_left(at_time(generating_series(l, 2), 0.0), some_momentum(), g), Error);
  CHECK_REFUSED(hamilton_jacobi_step_left(at_time(generating_series(l, 2), nan), some_momentum(), g),
                NotFinite);
  CHECK_REFUSED(generating_series(l, -1), OutsideDomain);
  CHECK_REFUSED(ExactGeneratingFunction{l}(g, 0.0), OutsideDomain);
  CHECK_REFUSED(free_motion_left(l, momentum(SO<3>{}, Vector3d(nan, 0, 0)), 1.0), NotFinite);
  CHECK_REFUSED(free_motion_left(l, some_momentum(), nan), NotFinite);
  CHECK_REFUSED(free_motion_left(l, some_momentum(), 1e9), NotConverged);
  Matrix3d skewed = l.a;
  skewed(0, 1) += 0.1;
  CHECK_REFUSED((QuadraticLagrangian<SO<3>, double>(SO<3>{}, skewed)), OutsideDomain);
  CHECK_REFUSED((QuadraticLagrangian<SO<3>, double>(SO<3>{}, Matrix3d(Vector3d(1, 2, 0).asDiagonal()))),
                Singular);
  CHECK_REFUSED((QuadraticLagrangian<SO<3>, double>(SO<3>{}, Matrix3d(Vector3d(1, 2, nan).asDiagonal()))),
                NotFinite);
  // Half a turn and more in one step: beyond the logarithm, whatever the series.
  CHECK_REFUSED(hamilton_jacobi_step_left(at_time(generating_series(l, 2), 20.0), some_momentum(),
                                          exp(-2.0 * l.velocity_of(some_momentum()))),
                Error);
}

BOOST_AUTO_TEST_CASE(the_coefficients_of_chi_are_bernoulli_numbers_over_factorials) {
  WithArithmetic const exactly(Arithmetic::rationals());
  // chi(-x) = x/(1 - e^-x) = sum B_k x^k/k! with B_1 = 1/2.
  std::vector<Number> const known{1, ratio<Number>(1, 2),    ratio<Number>(1, 12), 0, ratio<Number>(-1, 720),
                                  0, ratio<Number>(1, 30240)};
  for (int order = 0; order <= 6; ++order)
    BOOST_TEST((detail::chi_coefficients<Number>(order) ==
                std::vector<Number>(known.begin(), known.begin() + order + 1)),
               "up to " << order);
}

BOOST_AUTO_TEST_SUITE_END()
