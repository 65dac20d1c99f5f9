// Runs by the natural chart: configurations, what a run remembers, what a step costs, and where it is
// refused.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "caught.hpp"
#include "own_system.hpp"
#include "saved_numbers.hpp"

using namespace actio;
using namespace actio::systems;
using testing::message_of;
using testing::Saved;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
using List = std::vector<double>;
using Square = Eigen::MatrixXd;
using System = std::shared_ptr<ReducedSystem const>;

Square matrix(int n, std::initializer_list<double> row_by_row) {
  Square m(n, n);
  Index k = 0;
  for (double const x : row_by_row) m(k / n, k % n) = x, ++k;
  return m;
}
System with_chart(System const& of, Chart chart) {
  return std::make_shared<ReducedSystem const>(of->algebra, of->side, of->vectors, of->lagrangian, chart);
}

/// The momentum that the symmetry conserves: in space of a left-invariant system, of the body of a
/// right-invariant one.
List conserved(ReducedSystem const& system, List const& p, Square const& g, Square const& back) {
  List out;
  for (auto const& e : system.algebra.basis) {
    Square const moved = system.side == Side::left ? Square(back * e * g) : Square(g * e * back);
    auto const along = system.algebra.vee(Matrix<double>(moved));
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) sum += p[i] * along[static_cast<Index>(i)];
    out.push_back(sum);
  }
  return out;
}
double size_of(List const& x) {
  double largest = 0;
  for (double const c : x) largest = std::max(largest, std::abs(c));
  return largest;
}

/// Configurations carry momentum and vectors: neither is used to find the other.
void configurations_follow(System const& system, List const& v, List const& a, Square const& start,
                           Square const& start_back, double h) {
  List const fractions{0.75, -0.5, 0.75};
  ChartIntegrator run(system, h, fractions, point_at(*system, v, a), v);
  run.follow_configuration(start);
  bool const left = system->side == Side::left;
  auto const fixed = [&](Square const& g, Square const& back) {
    Eigen::VectorXd const x = Eigen::Map<Eigen::VectorXd const>(run.point().vectors.data(), g.rows());
    return Eigen::VectorXd((left ? g : back) * x);
  };
  auto const inverse = [](Square const& g) {
    return Square(inverse_matrix(Matrix<double>(g), "configuration"));
  };
  List const before = conserved(*system, run.point().momentum, start, start_back);
  Eigen::VectorXd const vector_before = fixed(start, start_back);
  int const steps = 6;
  double condition = 1, change = 0, vector_change = 0;
  for (int k = 0; k < steps; ++k) {
    run.step();
    Square const& g = run.configuration();
    Square const back = inverse(g);
    condition = std::max(condition, g.norm() * back.norm());
    List const now = conserved(*system, run.point().momentum, g, back);
    for (std::size_t i = 0; i < now.size(); ++i) change = std::max(change, std::abs(now[i] - before[i]));
    vector_change = std::max(vector_change, (fixed(g, back) - vector_before).norm());
  }
  // Three substeps a step, each with some ten roundings of products of matrices, seen through Ad.
  double const room = 3 * steps * 32 * eps * condition * condition;
  BOOST_TEST_CONTEXT(system->algebra.name << ", left " << left << ", Cayley "
                                          << (system->chart == Chart::cayley) << ", step " << h) {
    BOOST_TEST(change <= room * size_of(before));
    BOOST_TEST(vector_change <= room * vector_before.norm());
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(chart_integrators)

BOOST_AUTO_TEST_CASE(configurations_carry_momentum_and_vectors_on_either_side_in_either_chart) {
  // The vector costs no energy, so that all of the momentum is conserved. Steps of 0.05 are short for the
  // series of the exponential, those of 0.8 too long for it.
  for (Side const side : {Side::left, Side::right})
    for (Chart const chart : {Chart::exponential, Chart::cayley})
      for (double const h : {0.05, 0.8}) {
        configurations_follow(
            with_chart(own_system("SO(3)", side, "(w1^2 + 2*w2^2 + 4*w3^2)/2 + w1*w2/4 + 0*a1", true), chart),
            {0.3, 1.1, -0.4}, {0.6, -0.2, 0.9}, matrix(3, {0, 0, 1, 1, 0, 0, 0, 1, 0}),
            matrix(3, {0, 1, 0, 0, 0, 1, 1, 0, 0}), h);
        configurations_follow(
            with_chart(own_system("SE(2)", side, "(2*w^2 + v1^2 + 3*v2^2)/2 + w*v1/4 + 0*a1", true), chart),
            {0.7, 0.8, -0.3}, {0.6, -0.2, 1}, matrix(3, {0, -1, 2, 1, 0, -3, 0, 0, 1}),
            matrix(3, {0, 1, 3, -1, 0, 2, 0, 0, 1}), h);
        configurations_follow(
            with_chart(own_system("SL(2)", side, "(2*x1^2 + 3*x2^2 + 5*x3^2)/2 + x1*x2/4 + 0*a1", true),
                       chart),
            {0.2, 0.5, -0.4}, {0.6, -0.7}, matrix(2, {2, 1, 3, 2}), matrix(2, {2, -1, -3, 2}), h / 2);
      }
}

BOOST_AUTO_TEST_CASE(a_carried_vector_that_costs_energy_goes_where_configurations_take_it) {
  for (Side const side : {Side::left, Side::right}) {
    auto const system = own_system("SE(2)", side, "(2*w^2 + v1^2 + 3*v2^2)/2 + a1*(1 + w/4) - a2/2", true);
    List const v{0.7, 0.8, -0.3}, a{0.6, -0.2, 1};
    ChartIntegrator run(system, 0.1, {1}, point_at(*system, v, a), v);
    run.follow_configuration(Square::Identity(3, 3));
    for (int k = 0; k < 20; ++k) run.step();
    Eigen::VectorXd const now = Eigen::Map<Eigen::VectorXd const>(run.point().vectors.data(), 3),
                          first = Eigen::Map<Eigen::VectorXd const>(a.data(), 3);
    Square const& g = run.configuration();
    double const off =
        (side == Side::left ? Eigen::VectorXd(g * now - first) : Eigen::VectorXd(g * first - now)).norm();
    BOOST_TEST(off <= 20 * 32 * eps * g.norm() * now.norm());
    BOOST_TEST((now - first).norm() > 0.1);
  }
}

BOOST_AUTO_TEST_CASE(units_of_vectors_and_configurations_do_not_matter) {
  auto const system = own_system("SE(2)", Side::right, "(2*w^2 + v1^2 + 3*v2^2)/2 + 0*a1", true);
  List const v{0.7, 0.8, -0.3};
  auto const end = [&](double unit) {
    ChartIntegrator run(system, 0.1, {1}, point_at(*system, v, {0.6 * unit, -0.2 * unit, unit}), v);
    run.follow_configuration(unit * Square::Identity(3, 3));
    for (int k = 0; k < 5; ++k) run.step();
    return std::pair(run.point().vectors, Square(run.configuration() / unit));
  };
  auto const [vectors, configuration] = end(1);
  for (double const unit : {0x1p-200, 0x1p200}) {  // which round nothing
    auto const [other_vectors, other_configuration] = end(unit);
    for (std::size_t i = 0; i < 3; ++i) BOOST_TEST(other_vectors[i] == unit * vectors[i]);
    BOOST_TEST((other_configuration == configuration));
  }
}

BOOST_AUTO_TEST_CASE(what_shrinks_to_next_to_nothing_keeps_its_digits) {
  // e^-32 of a vector and of a configuration, by a long step, by a large matrix of the basis or by a fast
  // motion: the power series would leave rounding of e^32/32! times a power.
  struct Way {
    double entry, speed, step;
  };
  for (auto const& [entry, speed, step] : {Way{64, 0.25, 2}, {0.5, 0.5, 128}, {0.25, 256, 0.5}})
    for (Side const side : {Side::left, Side::right}) {
      double const sign = side == Side::left ? 1 : -1;
      auto const system =
          std::make_shared<ReducedSystem const>(spanned_algebra({Square::Constant(1, 1, entry)}), side, 1,
                                                parse_formula("x1^2/2 + 0*a1", {"x1", "a1"}, {}));
      ChartIntegrator shrinking(system, step, {1}, point_at(*system, {sign * speed}, {3}), {sign * speed});
      shrinking.step();
      // The exponential of a number of size 32 has 32 times its rounding, and some squarings more.
      double const room = 256 * eps, small = std::exp(-32.0);
      BOOST_TEST(std::abs(shrinking.point().vectors[0] / (3 * small) - 1) < room);
      ChartIntegrator run(system, step, {1}, point_at(*system, {-speed}, {3}), {-speed});
      run.follow_configuration(Square::Constant(1, 1, 5));
      run.step();
      BOOST_TEST(std::abs(run.configuration()(0, 0) / (5 * small) - 1) < room);
    }
}

BOOST_AUTO_TEST_CASE(a_run_that_is_read_back_goes_on_digit_by_digit) {
  auto const system =
      own_system("SE(2)", Side::left, "(2*w^2 + v1^2 + 3*v2^2)/2 + w*v1/4 + a1*(1 + w/4)", true);
  List const v{0.7, 0.8, -0.3}, a{0.6, -0.2, 1}, fractions{0.75, -0.5, 0.75};
  auto const fresh = [&] {
    ChartIntegrator run(system, 0.05, fractions, point_at(*system, v, a), v);
    run.follow_configuration(Square::Identity(3, 3));
    return run;
  };
  // Before the prediction knows anything, while it learns, and long after.
  for (int const until : {0, 5, 9, 70}) {
    ChartIntegrator run = fresh();
    for (int k = 0; k < until; ++k) run.step();
    Saved saved;
    run.remember(saved);
    ChartIntegrator other = fresh();
    saved.reading = true;
    other.remember(saved);
    BOOST_TEST(saved.at == saved.numbers.size());
    for (int k = 0; k < 70; ++k) run.step(), other.step();
    BOOST_TEST((run.point().momentum == other.point().momentum), until);
    BOOST_TEST((run.point().vectors == other.point().vectors), until);
    BOOST_TEST((run.velocity() == other.velocity()), until);
    BOOST_TEST((run.configuration() == other.configuration()), until);
    BOOST_TEST(run.evaluations() == other.evaluations(), until);
  }
}

BOOST_AUTO_TEST_CASE(velocities_that_are_a_polynomial_of_time_are_predicted_exactly) {
  // A fall with the kinetic energy v1 v2 and the potential a1^n: v1 is constant, a1 linear in time, and v2 a
  // polynomial of degree n. All numbers are dyadic and short, so that nothing is rounded. Once n + 2
  // velocities are known the first guess of a step is its solution, and it is looked at once.
  for (int const n : {1, 2, 3, 4}) {
    auto const system =
        own_system("R^2", Side::left, ("x1*x2 + a1^" + std::to_string(n) + " + 0*a2").c_str(), true);
    List const v{1, 0.5};
    ChartIntegrator run(system, 0.25, {1}, point_at(*system, v, {3, 0, 1}), v);
    for (int k = 0; k < 9; ++k) run.step();
    for (int k = 0; k < 80; ++k) {
      long const before = run.evaluations();
      run.step();
      BOOST_TEST(run.evaluations() == before + 1, "degree " << n << ", step " << k);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_smooth_motion_costs_two_looks_a_step) {
  // The guess misses by a high power of a short step and by the rounding of its differences; one step of the
  // iteration with the inverse that there is makes up for that, and the second look confirms.
  auto const system = own_system("SO(3)", Side::left, "(w1^2 + 2*w2^2 + 3*w3^2)/2 + w1^4/4");
  List const v{0.3, 1.1, -0.4};
  ChartIntegrator run(system, 0.005, {1}, point_at(*system, v), v);
  for (int k = 0; k < 20; ++k) run.step();
  long const before = run.evaluations();
  for (int k = 0; k < 500; ++k) run.step();
  BOOST_TEST_MESSAGE("looks a step: " << static_cast<double>(run.evaluations() - before) / 500);
  BOOST_TEST(run.evaluations() - before <= 2 * 500);
}

BOOST_AUTO_TEST_SUITE_END()
