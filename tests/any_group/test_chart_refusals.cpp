// Steps of the natural chart at the ends of their domain, with what is measured there; and the tangent of a
// step.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/any_group/least_regular.hpp"
#include "actio/any_group/tape_lagrangian.hpp"
#include "actio/groups/rotations.hpp"
#include "actio/reduction/composition.hpp"
#include "caught.hpp"
#include "own_system.hpp"

using namespace actio;
using namespace actio::systems;
using testing::caught;

namespace {

using List = std::vector<double>;
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double least_condition = 0x1p-50;

std::shared_ptr<ReducedSystem const> with_chart(std::shared_ptr<ReducedSystem const> const& of, Chart chart) {
  return std::make_shared<ReducedSystem const>(of->algebra, of->side, of->vectors, of->lagrangian, chart);
}

/// On the line, with a mass a1 that the motion changes: over a step of 1/2 from a = (1, 1) the momentum at
/// the start is v - v^2/8, at the end v - 3 v^2/8, and a1 has become 1 - v/2.
struct ChangingMass {
  std::shared_ptr<ReducedSystem const> system = own_system("R^1", Side::left, "a1*x1^2/2 + 0*a2", true);
  ChartIntegrator run;
  explicit ChangingMass(double momentum, double near) : run(system, 0.5, {1}, {{momentum}, {1, 1}}, {near}) {}
};

}  // namespace

BOOST_AUTO_TEST_SUITE(chart_refusals)

BOOST_AUTO_TEST_CASE(a_step_of_half_a_turn_is_refused_with_its_turn) {
  for (Side const side : {Side::left, Side::right})
    for (double const sign : {1.0, -1.0}) {
      auto const system = own_system("SO(3)", side, "(w1^2 + w2^2 + w3^2)/2");
      List const v{1, -2, 2};  // three radians
      auto const turning = [&](double turn, Chart chart) {
        auto const kind = with_chart(system, chart);
        return ChartIntegrator(kind, sign * turn / 3, {1}, point_at(*kind, v), v);
      };
      ChartIntegrator near = turning(3.1, Chart::exponential);
      near.step();
      for (std::size_t i = 0; i < 3; ++i)
        BOOST_TEST(std::abs(near.point().momentum[i] - v[i]) < 64 * eps * 3);
      auto const refused = caught<OutsideDomain>([&] { turning(3.2, Chart::exponential).step(); });
      BOOST_TEST(std::abs(refused.measured - 3.2) < 64 * eps * 3.2);
      BOOST_TEST(refused.bound == std::numbers::pi);
      BOOST_CHECK_NO_THROW(turning(3.2, Chart::cayley).step());
    }
  // A motion that only stretches does not turn, however far it goes.
  auto const stretching = own_system("SL(2)", Side::left, "(2*x1^2 + 3*x2^2 + 5*x3^2)/2");
  List const v{1, 0, 0};
  ChartIntegrator run(stretching, 2, {1}, point_at(*stretching, v), v);
  BOOST_CHECK_NO_THROW(run.step());
}

BOOST_AUTO_TEST_CASE(a_step_ends_where_its_equations_say) {
  // v - v^2/8 = 3/2 at v = 2.
  ChangingMass one(1.5, 1.5);
  one.run.step();
  BOOST_TEST(std::abs(one.run.velocity()[0] - 2) < 64 * eps);
  BOOST_TEST(std::abs(one.run.point().momentum[0] - 0.5) < 64 * eps);
  BOOST_TEST(std::abs(one.run.point().vectors[0]) < 64 * eps);
  BOOST_TEST(one.run.point().vectors[1] == 1);
}

BOOST_AUTO_TEST_CASE(a_step_without_a_solution_says_what_was_left) {
  // The momentum at the start is at most 2.
  ChangingMass none(3, 3);
  auto const refused = caught<NotConverged>([&] { none.run.step(); });
  BOOST_TEST(refused.tolerance == 16 * eps);
  BOOST_TEST_REQUIRE(!refused.residuals.empty());
  // At the Legendre velocity 3: 15/8 for 3, over 3 + 15/8 and what the velocity contributes, 3/4.
  BOOST_TEST(std::abs(refused.residuals.front() - 0.2) < 8 * eps);
  BOOST_TEST((none.run.point().momentum == List{3}));
  BOOST_TEST((none.run.point().vectors == List{1, 1}));
}

BOOST_AUTO_TEST_CASE(a_step_whose_equations_have_no_derivative_is_refused_with_its_condition) {
  // At the Legendre velocity 4 the momentum at the start changes by 1 - v/4 = 0.
  ChangingMass flat(4, 4);
  auto const refused = caught<Singular>([&] { flat.run.step(); });
  BOOST_TEST(refused.measured == 0);
  BOOST_TEST(refused.bound == least_condition);
  BOOST_TEST(std::string(refused.what()).starts_with("natural chart"));
}

BOOST_AUTO_TEST_CASE(a_lagrangian_of_other_inputs_is_refused_with_their_number) {
  auto const refused = caught<OutsideDomain>([] {
    ReducedSystem(named_algebra("R^1"), Side::left, 2, parse_formula("x1^2 + a1", {"x1", "a1", "a2"}, {}));
  });
  BOOST_TEST(refused.measured == 3);
  BOOST_TEST(refused.bound == 1 + 2 * 2);
}

BOOST_AUTO_TEST_CASE(the_least_regular_direction_is_that_of_the_smallest_eigenvalue_in_units) {
  // In units of its components m is ((s, c), (c, t)): with s = t = 1 its eigenvalues are 1 + c and 1 - c
  // along (1, 1) and (1, -1).
  Eigen::Vector2d const scale(3, 0.25);
  auto const least = [&](double s, double c, double t) {
    Eigen::MatrixXd m(2, 2);
    m << s * scale[0] * scale[0], c * scale[0] * scale[1], c * scale[0] * scale[1], t * scale[1] * scale[1];
    return LeastRegular(m);
  };
  for (double const c : {0.5, -0.5, 2.0, -3.0}) {
    LeastRegular const found = least(1, c, 1);
    double const one = std::abs(1 + c), other = std::abs(1 - c), sign = one < other ? 1 : -1;
    BOOST_TEST(std::abs(found.smallest - std::min(one, other)) < 16 * eps);
    BOOST_TEST(std::abs(found.largest - std::max(one, other)) < 16 * eps);
    Eigen::Vector2d expected(1 / scale[0], sign / scale[1]);
    expected.normalize();
    BOOST_TEST(std::abs(std::abs(expected.dot(found.direction)) - 1) < 16 * eps, c);
  }
  // One of each sign: plus and minus sqrt(1 + c^2).
  BOOST_TEST(std::abs(least(-1, 0.75, 1).smallest - 1.25) < 16 * eps);
}

BOOST_AUTO_TEST_CASE(the_tangent_of_a_step_is_the_limit_of_differences) {
  auto const system = own_system(
      "SE(2)", Side::right, "(2*w^2 + v1^2 + 3*v2^2)/2 + w*v1/4 + v2^3/9 + a1*(1 + w/4) - a2*a3/2", true);
  List const v{0.7, 0.8, -0.3}, a{0.6, -0.2, 1};
  ReducedPoint const start = point_at(*system, v, a);
  double const h = 0.2;
  ChartMap const map(*system, triple_jump<double>(), v);
  using Map = ReducedPointOver<double>;
  auto const at = [&](double step, std::size_t i, double by) {
    Map moved{start.momentum, start.vectors};
    if (i < 3)
      moved.momentum[i] += by;
    else if (i < 6)
      moved.vectors[i - 3] += by;
    Map const image = map(step, moved);
    Eigen::VectorXd all(6);
    for (std::size_t k = 0; k < 6; ++k)
      all[static_cast<Index>(k)] = k < 3 ? image.momentum[k] : image.vectors[k - 3];
    return all;
  };
  // Differences over 2e-3 and 1e-3, whose errors of second order cancel; those of fourth are 1e-12 of
  // derivatives below 100, and rounding is 1e-12 as well.
  double const by = 1e-3, near = 1e-9;
  auto const differences = [&](auto const& moved) {
    return Eigen::VectorXd((8 * (moved(by / 2) - moved(-by / 2)) - (moved(by) - moved(-by))) / (6 * by));
  };
  auto const tangent = tangent_of([&](auto const& p) { return map(Moved<double>(h), p); }, start);
  for (std::size_t i = 0; i < 6; ++i) {
    Eigen::VectorXd const column = differences([&](double x) { return at(h, i, x); });
    BOOST_TEST((tangent.col(static_cast<Index>(i)) - column).norm() < near, i);
  }
  BOOST_TEST((tangent - Eigen::MatrixXd::Identity(6, 6)).norm() > 0.1);
  // The rate by the step.
  Moved<double> step(h);
  step.part[1] = 1;
  ReducedPointOver<Moved<double>> moving{{start.momentum.begin(), start.momentum.end()},
                                         {start.vectors.begin(), start.vectors.end()}};
  auto const rates = map(step, moving);
  Eigen::VectorXd const by_step = differences([&](double x) { return at(h + x, 6, 0); });
  for (std::size_t k = 0; k < 6; ++k)
    BOOST_TEST(std::abs((k < 3 ? rates.momentum[k] : rates.vectors[k - 3]).part[1] -
                        by_step[static_cast<Index>(k)]) < near);
}

BOOST_AUTO_TEST_CASE(a_map_tells_its_substeps_and_ends_where_a_run_does) {
  auto const system = own_system("SE(2)", Side::left, "(2*w^2 + v1^2 + 3*v2^2)/2 + a1*(1 + w/4)", true);
  List const v{0.7, 0.8, -0.3}, a{0.6, -0.2, 1}, fractions{0.75, -0.5, 0.75};
  ReducedPoint const start = point_at(*system, v, a);
  ChartMap const map(*system, fractions, v);
  List lengths;
  List last;
  auto const image = map(0.1, ReducedPointOver<double>{start.momentum, start.vectors},
                         [&](double h, List const& velocity) { lengths.push_back(h), last = velocity; });
  ChartIntegrator run(system, 0.1, fractions, start, v);
  run.step();
  double const room = 3 * 16 * eps * 4;
  BOOST_TEST_REQUIRE(lengths.size() == 3u);
  auto const untold = map(0.1, ReducedPointOver<double>{start.momentum, start.vectors});
  BOOST_TEST((untold.momentum == image.momentum));
  BOOST_TEST((untold.vectors == image.vectors));
  for (std::size_t i = 0; i < 3; ++i) {
    BOOST_TEST(std::abs(lengths[i] - 0.1 * fractions[i]) < eps);
    BOOST_TEST(std::abs(image.momentum[i] - run.point().momentum[i]) < room);
    BOOST_TEST(std::abs(image.vectors[i] - run.point().vectors[i]) < room);
    // A velocity is found to the rounding of a momentum over the length of the substep.
    BOOST_TEST(std::abs(last[i] - run.velocity()[i]) < room / 0.05);
  }
}

BOOST_AUTO_TEST_CASE(a_lagrangian_on_velocities_is_its_formula_at_every_scalar) {
  TapeLagrangian const l{own_system("SO(3)", Side::left, "(w1^2 + 2*w2^2 + 3*w3^2)/2 + w1*w2*w3")};
  auto const xi = velocity(SO<3>{}, Vector<double, 3>(0.5, -2, 0.25));
  BOOST_TEST(l(xi) == (0.25 + 8 + 0.1875) / 2 - 0.25);
  auto const slope = gradient(l, xi).components;
  BOOST_TEST((slope == Vector<double, 3>(0.5 - 0.5, -4 + 0.125, 0.75 - 1)));
}

BOOST_AUTO_TEST_SUITE_END()
