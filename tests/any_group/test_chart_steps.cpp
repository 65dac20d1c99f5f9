// Steps of the natural chart by structure constants: against the generic implementation on the groups of the
// library.
#include <boost/test/unit_test.hpp>

#include "actio/groups/motions.hpp"
#include "actio/groups/rotations.hpp"
#include "actio/groups/special_linear.hpp"
#include "actio/groups/unipotent_groups.hpp"
#include "actio/reduction/advected.hpp"
#include "actio/reduction/composition.hpp"
#include "actio/reduction/momentum_step.hpp"
#include "own_system.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::systems;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// The largest difference of momenta over some steps, relative to the momentum: by structure constants, and
/// by `general` on a group of the library.
template <class G, class Step>
double apart(std::shared_ptr<ReducedSystem const> const& system, G const& group, Step const& general,
             std::vector<double> const& v, double h, int steps) {
  ChartIntegrator own(system, h, {1}, point_at(*system, v), v);
  Coordinates<G, double> p(group.dimension()), w(group.dimension());
  for (std::size_t i = 0; i < v.size(); ++i)
    p[static_cast<Index>(i)] = own.point().momentum[i], w[static_cast<Index>(i)] = v[i];
  MomentumState<G, double> state{{group, p}, {group, w}};
  double largest = 0;
  for (int k = 0; k < steps; ++k) {
    own.step();
    state = general(state, h).state;
    for (std::size_t i = 0; i < v.size(); ++i)
      largest = std::max(
          largest, std::abs(own.point().momentum[i] - state.momentum.components[static_cast<Index>(i)]));
  }
  return largest / magnitude(p);
}

/// \f$2(g + 1)^{-1}(g - 1)\f$.
template <class S>
Matrix<S, 3, 3> cayley_inverse(Matrix<S, 3, 3> const& g) {
  Matrix<S, 3, 3> const one = Matrix<S, 3, 3>::Identity();
  return inverse_matrix(Matrix<S, 3, 3>(g + one), "inverse of Cayley's transform") *
         Matrix<S, 3, 3>(g - one) * S(2);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(chart_steps)

// Both ways solve to 16 epsilon of the row, fifty times.
constexpr double after_fifty_steps = 50 * 16 * eps;

BOOST_AUTO_TEST_CASE(a_sleigh_on_either_side) {
  auto const l = [](auto const& v) {
    auto const& x = v.coordinates;
    using S = std::decay_t<decltype(x[0])>;
    return S((x[0] * x[0] + x[1] * x[1] + S(6) * x[2] * x[2]) / S(2));
  };
  char const* const text = "(w^2 + v1^2 + c*v2^2)/2";
  std::vector<double> const v{0.7, 1.0, 0.2};
  BOOST_TEST(apart(own_system("SE(2)", Side::left, text, false, {{"c", 6}}), SE<2>{},
                   natural_chart_step_left(l), v, 0.1, 50) < after_fifty_steps);
  BOOST_TEST(apart(own_system("SE(2)", Side::right, text, false, {{"c", 6}}), SE<2>{},
                   natural_chart_step_right(l), v, 0.1, 50) < after_fifty_steps);
  // Another step is another motion.
  BOOST_TEST(apart(own_system("SE(2)", Side::left, text, false, {{"c", 6}}), SE<2>{},
                   natural_chart_step_right(l), v, 0.1, 50) > 1e-3);
}

BOOST_AUTO_TEST_CASE(a_body_whose_energy_is_not_quadratic) {
  auto const l = [](auto const& v) {
    auto const& x = v.coordinates;
    using S = std::decay_t<decltype(x[0])>;
    return S((x[0] * x[0] + S(2) * x[1] * x[1] + S(3) * x[2] * x[2]) / S(2) +
             x[0] * x[0] * x[0] * x[0] / S(4));
  };
  BOOST_TEST(apart(own_system("SO(3)", Side::left, "(w1^2 + 2*w2^2 + 3*w3^2)/2 + w1^4/4"), SO<3>{},
                   natural_chart_step_left(l), {0.3, 1.1, -0.4}, 0.1, 50) < after_fifty_steps);
}

BOOST_AUTO_TEST_CASE(a_group_that_is_not_compact_and_one_that_is_nilpotent) {
  auto const l = [](auto const& v) {
    auto const& x = v.coordinates;
    using S = std::decay_t<decltype(x[0])>;
    return S((x[0] * x[0] + S(2) * x[1] * x[1] + S(3) * x[2] * x[2] + x[0] * x[1]) / S(2));
  };
  char const* const text = "(x1^2 + 2*x2^2 + 3*x3^2 + x1*x2)/2";
  BOOST_TEST(apart(own_system("SL(2)", Side::right, text), SL<2>{}, natural_chart_step_right(l),
                   {0.2, 0.3, -0.1}, 0.05, 50) < after_fifty_steps);
  BOOST_TEST(apart(own_system("Heisenberg", Side::left, text), Heisenberg{}, natural_chart_step_left(l),
                   {0.2, 0.3, 0.4}, 0.1, 50) < after_fifty_steps);
}

BOOST_AUTO_TEST_CASE(a_top_with_the_direction_of_gravity_as_a_carried_vector) {
  // The action of the generic implementation: the mean of the Lagrangian at both ends of the step.
  double const h = 0.02;
  auto const l = [](auto const& v, auto const& a) {
    auto const& w = v.coordinates;
    using S = std::decay_t<decltype(w[0])>;
    return S((w[0] * w[0] + S(1.5) * w[1] * w[1] + S(0.5) * w[2] * w[2]) / S(2) + S(2) * a[2] +
             S(0.25) * a[0] * w[1]);
  };
  auto const action = [&](auto const& f, auto const& a) {
    using S = typename std::decay_t<decltype(f)>::Scalar;
    auto const v = -log(f) / S(h);
    return S((l(v, a) + l(v, advect_left(f, a))) * S(h / 2));
  };
  auto const system =
      own_system("SO(3)", Side::left, "(w1^2 + 1.5*w2^2 + 0.5*w3^2)/2 + 2*a3 + 0.25*a1*w2", true);
  std::vector<double> const v{0.5, 0.2, 6}, a0{0.1, -0.3, -1};
  ChartIntegrator own(system, h, {1}, point_at(*system, v, a0), v);
  Momentum<SO<3>, double> pi{{}, {own.point().momentum[0], own.point().momentum[1], own.point().momentum[2]}};
  Vector<double, 3> a(a0[0], a0[1], a0[2]);
  auto f = exp(Velocity<SO<3>, double>{{}, Vector<double, 3>(-h * v[0], -h * v[1], -h * v[2])});
  double largest = 0;
  for (int k = 0; k < 50; ++k) {
    own.step();
    f = advected_relative_motion_left(action, pi, a, f).value;
    pi = advected_lie_poisson_update_left(action, f, a, pi), a = advect_left(f, a);
    for (Index i = 0; i < 3; ++i) {
      auto const at = static_cast<std::size_t>(i);
      largest = std::max({largest, std::abs(own.point().momentum[at] - pi.components[i]),
                          std::abs(own.point().vectors[at] - a[i])});
    }
  }
  BOOST_TEST(largest < after_fifty_steps * 8);  // the momentum is about 3 in size, its change about 2 a time
}

BOOST_AUTO_TEST_CASE(compositions_have_their_orders) {
  auto const system = own_system("SE(3)", Side::left,
                                 "(2*w1^2 + w2^2 + 3*w3^2 + v1^2 + 2*v2^2 + 4*v3^2)/2 + w1*v2/2 + a3", true);
  std::vector<double> const v{0.4, 0.3, -0.5, 0.2, 0.6, -0.1}, a{0, 0, -1, 0};
  auto const end = [&](double h, std::vector<double> const& fractions) {
    ChartIntegrator run(system, h, fractions, point_at(*system, v, a), v);
    for (int k = 0; k < static_cast<int>(std::lround(1 / h)); ++k) run.step();
    return run.point().momentum;
  };
  auto const exact = end(1.0 / 64, kahan_li<double>());
  auto const error = [&](double h, std::vector<double> const& fractions) {
    auto const p = end(h, fractions);
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) sum += std::pow(p[i] - exact[i], 2);
    return std::sqrt(sum);
  };
  for (auto const& [order, fractions] :
       {std::pair(2, std::vector<double>{1}), {4, suzuki<double>()}, {6, kahan_li<double>()}}) {
    double const shown = std::log2(error(0.25, fractions) / error(0.125, fractions));
    BOOST_TEST_MESSAGE("order " << order << " shows " << shown);
    BOOST_TEST(std::abs(shown - order) < 0.5);
  }
}

BOOST_AUTO_TEST_CASE(the_chart_by_cayleys_transform) {
  // The discrete Lagrangian h l(c^-1(f^-1)/h) by the generic implementation, with the inverse of Cayley's
  // transform c.
  double const h = 0.1;
  auto const action = [&](auto const& f) {
    using S = typename std::decay_t<decltype(f)>::Scalar;
    auto const v = f.group.vee(Matrix<S, 3, 3>(cayley_inverse(inverse(f).value) / S(h)));
    return S((v[0] * v[0] + v[1] * v[1] + S(6) * v[2] * v[2]) / S(2) * S(h));
  };
  auto const plain = own_system("SE(2)", Side::left, "(w^2 + v1^2 + 6*v2^2)/2");
  auto const system =
      std::make_shared<ReducedSystem const>(plain->algebra, Side::left, 0, plain->lagrangian, Chart::cayley);
  auto const general = lie_poisson_step_left([&](double) { return action; });
  BOOST_TEST(apart(system, SE<2>{}, general, {0.7, 1.0, 0.2}, h, 50) < after_fifty_steps);
  BOOST_TEST(apart(plain, SE<2>{}, general, {0.7, 1.0, 0.2}, h, 50) > 1e-5);
}

BOOST_AUTO_TEST_CASE(a_vector_is_carried_by_either_chart_and_by_steps_of_any_length) {
  // Carried as the momentum is: their product and the vector's length do not change. No turn of the
  // body but that of the momentum does both.
  auto const plain = own_system("SO(3)", Side::left, "(w1^2 + 2*w2^2 + 3*w3^2)/2 + a1*0", true);
  auto const turned =
      std::make_shared<ReducedSystem const>(plain->algebra, Side::left, 1, plain->lagrangian, Chart::cayley);
  std::vector<double> const v{0.3, 1.1, -0.4}, a{0.6, 0, 0.8};
  for (auto const& system : {plain, turned})
    for (double const h : {0.1, 1.5}) BOOST_TEST_CONTEXT("chart " << (system == plain) << ", step " << h) {
        ChartIntegrator run(system, h, {1}, point_at(*system, v, a), v);
        auto const product = [&] {
          auto const &p = run.point().momentum, &w = run.point().vectors;
          return p[0] * w[0] + p[1] * w[1] + p[2] * w[2];
        };
        double const before = product();
        auto const where = run.point().vectors;
        for (int k = 0; k < 20; ++k) run.step();
        auto const& w = run.point().vectors;
        BOOST_TEST(std::abs(product() - before) < 1e-13);
        BOOST_TEST(std::abs(std::hypot(w[0], w[1], w[2]) - 1) < 1e-13);
        BOOST_TEST(std::abs(w[0] - where[0]) + std::abs(w[1] - where[1]) > 0.01);
      }
}

BOOST_AUTO_TEST_CASE(a_momentum_stays_on_its_orbit) {
  auto const system = own_system("SO(3)", Side::left, "(w1^2 + 2*w2^2 + 3*w3^2)/2");
  std::vector<double> const v{0.3, 1.1, -0.4};
  // Half a radian a step, so that the residual that is left of each step would show.
  ChartIntegrator run(system, 0.4, {1}, point_at(*system, v), v);
  auto const length = [&] {
    return std::hypot(run.point().momentum[0], run.point().momentum[1], run.point().momentum[2]);
  };
  double const before = length();
  int const steps = 100000;
  for (int k = 0; k < steps; ++k) run.step();
  double const drift = std::abs(length() / before - 1);
  BOOST_TEST_MESSAGE("|Pi| after " << steps << " steps: drift " << drift);
  BOOST_TEST(drift < 4 * eps * std::sqrt(steps));  // a random walk of some roundings a step
}

BOOST_AUTO_TEST_CASE(a_step_that_fails_leaves_the_state) {
  auto const system = own_system("SO(3)", Side::left, "(w1^2 + 2*w2^2 + 3*w3^2)/2");
  std::vector<double> const v{3, 2, 9};
  ChartIntegrator run(system, 5, {1}, point_at(*system, v), v);
  auto const before = run.point().momentum;
  CHECK_REFUSED(run.step(), Error);
  BOOST_TEST(run.point().momentum == before, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
