// Forces in components of the other side: in space on a left-invariant system, of the body on a
// right-invariant one. Momenta that grow in proportion to the time, the same forces by a carried vector, and
// a thrown body in closed form.
#include <Eigen/Geometry>

#include <boost/test/unit_test.hpp>

#include "actio/any_group/tape_lagrangian.hpp"
#include "actio/reduction/composition.hpp"
#include "forced_reference.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::systems;
using namespace actio::testing;

namespace {

List const fractions_of(int order) { return order == 2 ? List{1} : suzuki<double>(); }

/// A system with a force of the other side alone, in either chart.
System with_across(System const& free, std::vector<std::string> const& across, Chart chart) {
  std::vector<std::string> const none(across.size(), "0");
  auto out = std::make_shared<ReducedSystem>(*with_force(free, none, {}, across));
  out->chart = chart;
  return out;
}
/// A configuration that is not the identity.
Square turned(System const& system) {
  Square g = one(system);
  move_configuration(*system, 1, uneven(system->dimension(), 0.7), g);
  return g;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(forces_across)

BOOST_AUTO_TEST_CASE(a_constant_force_in_space_adds_itself_times_the_time_to_the_momentum) {
  for (char const* const group : {"SO(3)", "SE(2)", "SE(3)", "SU(3)", "SL(2)"})
    for (Side const side : {Side::left, Side::right})
      for (Chart const chart : {Chart::exponential, Chart::cayley}) {
        // Cayley's transform does not map into SU(3) and SL(2).
        if (chart == Chart::cayley && (group[1] == 'U' || group[1] == 'L')) continue;
        System const free = free_system(group, side);
        List const f = uneven(free->dimension(), 0.4);
        std::vector<std::string> across;
        for (double const x : f) across.push_back(std::to_string(x));
        System const system = with_across(free, across, chart);
        Square const start = turned(system);
        List const v = uneven(free->dimension(), 0.3);
        ChartIntegrator run(system, 0.05, {1}, point_at(*system, v, {}, start), v);
        run.follow_configuration(start);
        auto const momentum = [&] {
          Square const g = run.configuration();
          return momentum_across(system->algebra, side, g, Square(g.inverse()), run.point().momentum);
        };
        List const before = momentum();
        int const steps = 40;
        double size = largest(before), condition = 1, worst = 0;
        for (int k = 1; k <= steps; ++k) {
          run.step();
          List change = minus(momentum(), before);
          size = std::max(size, largest(change));
          condition = std::max(condition, run.configuration().norm() * run.configuration().inverse().norm());
          for (std::size_t i = 0; i < f.size(); ++i)
            worst = std::max(worst, std::abs(change[i] - 0.05 * k * std::stod(across[i])));
        }
        BOOST_TEST_CONTEXT(group << (side == Side::left ? " left" : " right") << ": " << worst << " of "
                                 << size)
        // Ad and its inverse multiply a few roundings a step by the condition of the configuration each.
        BOOST_TEST(worst < 64 * eps * steps * size * condition * condition);
      }
}

BOOST_AUTO_TEST_CASE(a_torque_about_an_axis_of_space_is_that_along_a_carried_vector) {
  for (Side const side : {Side::left, Side::right})
    for (int const order : {2, 4}) {
      // The vector is e_3 in space, or of the body, and enters nothing but the force.
      System const free = own_system("SO(3)", side, "(w1^2 + 1.5*w2^2 + 0.5*w3^2)/2 + 0*a1", true);
      std::string const size = "(0.3*cos(2*t) - 0.1*w1*abs(w1) + 0.05*p_w2)";
      System const by_vector = with_force(free, {size + "*a1", size + "*a2", size + "*a3"}),
                   by_frame = with_force(free, {"0", "0", "0"}, {}, {"0", "0", size});
      Square const start = turned(free);
      List const v{0.5, 0.2, 1.5};
      Eigen::Vector3d const third = (side == Side::left ? Square(start.transpose()) : start).col(2);
      List const a(third.data(), third.data() + 3);
      ChartIntegrator one_way(by_vector, 0.05, fractions_of(order), point_at(*free, v, a), v),
          other_way(by_frame, 0.05, fractions_of(order), point_at(*free, v, a, start), v);
      int const steps = 100;
      for (int k = 0; k < steps; ++k) one_way.step(), other_way.step();
      double const apart = largest(minus(one_way.point().momentum, other_way.point().momentum));
      BOOST_TEST_CONTEXT("order " << order << ": " << apart)
      // Two motions that differ by their roundings part in proportion to the time, by less than tenfold here.
      BOOST_TEST(apart < 10 * 16 * eps * steps);
      BOOST_TEST(largest(minus(one_way.point().momentum, point_at(*free, v, a).momentum)) > 0.1);
      List const now = force_at(*by_vector, one_way.velocity(), one_way.point()),
                 there = force_at(*by_frame, one_way.velocity(), other_way.point());
      BOOST_TEST(largest(minus(now, there)) < 10 * 16 * eps * steps);
    }
}

BOOST_AUTO_TEST_CASE(a_ball_that_is_pulled_along_a_line_of_space_flies_a_parabola) {
  // A force along a line through the origin of space: m x'' = f, and about the origin there is no torque, so
  // that J W + m x * x' is constant.
  Eigen::Vector3d const f(0.3, -0.2, -1), x0(0.5, 1, -0.3), v0(0.4, 0.1, 0.8), w0(0.7, -0.4, 0.2);
  double const m = 2, moment = 0.5, time = 1.5;
  System const free =
      own_system("SE(3)", Side::left, "(0.5*(w1^2 + w2^2 + w3^2) + 2*(v1^2 + v2^2 + v3^2))/2");
  Square start = Square::Identity(4, 4);
  start.topRightCorner(3, 1) = x0;
  Eigen::Vector3d const x = x0 + time * v0 + time * time / (2 * m) * f, velocity = v0 + time / m * f,
                        w = w0 + m / moment * (x0.cross(v0) - x.cross(velocity));
  for (Chart const chart : {Chart::exponential, Chart::cayley}) {
    System const system = with_across(free, {"0", "0", "0", "0.3", "-0.2", "-1"}, chart);
    List const v{w0[0], w0[1], w0[2], v0[0], v0[1], v0[2]};
    for (int const order : {2, 4}) {
      List places, turns;
      for (int const steps : {20, 40, 80}) {
        ChartIntegrator run(system, time / steps, fractions_of(order), point_at(*system, v, {}, start), v);
        run.follow_configuration(start);
        for (int k = 0; k < steps; ++k) run.step();
        Square const& g = run.configuration();
        auto const& p = run.point().momentum;
        places.push_back((g.topRightCorner(3, 1) - x).norm());
        turns.push_back((g.topLeftCorner(3, 3) * Eigen::Vector3d(p[0], p[1], p[2]) / moment - w).norm());
      }
      BOOST_TEST_CONTEXT("order " << order << ": " << places[2] << " " << turns[2]) {
        BOOST_TEST(std::abs(slope(places) - order) < 0.1);
        BOOST_TEST(std::abs(slope(turns) - order) < 0.1);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_force_across_is_refused_where_no_frame_is_known) {
  System const free = free_system("SO(3)", Side::left);
  System const system = with_across(free, {"0", "0", "1"}, Chart::exponential);
  List const v{0.5, 0.2, 1.5};
  ChartIntegrator run(system, 0.05, {1}, point_at(*system, v), v);
  CHECK_REFUSED(run.step(), OutsideDomain);
  CHECK_REFUSED(force_at(*system, v, point_at(*system, v)), OutsideDomain);
  CHECK_REFUSED(TapeForce(system, 0, 0.1), OutsideDomain);
}

BOOST_AUTO_TEST_SUITE_END()
