// Motions with constraints whose solution is known in closed form, or by equations that know nothing of
// multipliers.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/reduction/composition.hpp"
#include "rolling_systems.hpp"
#include "witness/reference_solution.hpp"

using namespace actio;
using namespace actio::systems;
using namespace actio::testing;

namespace {

/// What a run shows at its end, for orders 2 and 4 and for several counts of steps: each has its order.
/// @param ends    (RattleIntegrator& at the end) -> list
/// @param counts  of steps
template <class Ends>
void has_its_orders(char const* name, Constrained const& system, ConstrainedState const& start, double time,
                    std::vector<int> const& counts, List const& truth, Ends const& ends) {
  for (int const order : {2, 4}) {
    List errors;
    for (int const count : counts) {
      auto run = system.run(time / count, symmetric_composition<double>(order), start);
      run.follow_configuration(Eigen::MatrixXd::Identity(system.system->length(), system.system->length()));
      for (int k = 0; k < count; ++k) run.step();
      errors.push_back(apart(ends(run), truth));
    }
    double const slope = order_of(errors);
    BOOST_TEST_MESSAGE(name << ", order " << order << ": errors " << errors[0] << " " << errors[1] << " "
                            << errors[2] << ", slope " << slope);
    BOOST_TEST(std::abs(slope - order) < 0.05, name);
  }
}

auto const velocity_of = [](RattleIntegrator const& run) { return run.state().velocity; };

}  // namespace

BOOST_AUTO_TEST_SUITE(exact_motions_with_constraints)

BOOST_AUTO_TEST_CASE(suslovs_body_turns_over_as_its_closed_form) {
  // A body that cannot spin about its third axis, w3 = 0, with products of inertia: it goes from one steady
  // rotation to the opposite one, w = sqrt(2E) (cos phi/sqrt(I1), sin phi/sqrt(I2)) with
  // sin(phi - shift) = tanh.
  double const one = 1, two = 2, with_one = 0.3, with_two = 0.2, time = 5;
  Constrained const system("SO(3)", "(I1*w1^2 + I2*w2^2 + 3*w3^2)/2 + I13*w1*w3 + I23*w2*w3", {"w3"}, {},
                           {{"I1", one}, {"I2", two}, {"I13", with_one}, {"I23", with_two}});
  List const start{0.8, -0.5, 0};
  double const root = std::sqrt(one * start[0] * start[0] + two * start[1] * start[1]),
               along = with_one * root / std::sqrt(one), across = with_two * root / std::sqrt(two),
               rate = std::hypot(along, across) / std::sqrt(one * two), shift = std::atan2(across, along),
               phase = std::atan2(start[1] * std::sqrt(two), start[0] * std::sqrt(one)) - shift,
               later = shift + std::asin(std::tanh(rate * time + std::atanh(std::sin(phase))));
  BOOST_TEST(std::cos(phase) > 0);  // the branch of asin
  has_its_orders("Suslov's body", system, system.state(start), time, {50, 100, 200},
                 {root / std::sqrt(one) * std::cos(later), root / std::sqrt(two) * std::sin(later), 0},
                 velocity_of);
}

BOOST_AUTO_TEST_CASE(chaplygins_sleigh_turns_round_as_its_closed_form) {
  Sleigh const sleigh;
  auto const system = sleigh.system();
  double const time = 6, heading = sleigh.heading(time);
  has_its_orders("sleigh", system, system.state(sleigh.velocity(0)), time, {50, 100, 200},
                 sleigh.velocity(time), velocity_of);
  has_its_orders("heading of the sleigh", system, system.state(sleigh.velocity(0)), time, {50, 100, 200},
                 {std::cos(heading), std::sin(heading)}, [](RattleIntegrator const& run) {
                   return List{run.configuration()(0, 0), run.configuration()(1, 0)};
                 });
  // From the far past to the far future it turns by pi sqrt(J_t/m)/a.
  BOOST_TEST(std::abs(sleigh.turn / sleigh.rate * std::numbers::pi -
                      std::numbers::pi * std::sqrt(sleigh.about_blade / sleigh.mass) / sleigh.ahead) < 1e-14);
}

BOOST_AUTO_TEST_CASE(chaplygins_ball_moves_by_the_momentum_about_its_contact) {
  // K = (I + 1 - u u^T) w is fixed in space, so K' = K x w, u' = u x w: no multiplier, no velocity of the
  // centre.
  ChaplyginBall const ball;
  auto const turn = [&](Triple const& k, Triple const& u) {
    Eigen::Matrix3d m = ball.inertia.asDiagonal();
    m += Eigen::Matrix3d::Identity() - u * u.transpose();
    return Triple(solve_linear(m, k, "ball"));
  };
  using Both = Eigen::Matrix<double, 6, 1>;
  Both y;
  y << ball.inertia.cwiseProduct(ball.turn) + cross(ball.up, cross(ball.turn, ball.up)), ball.up;
  auto const rate = [&](double, Both const& now) {
    Triple const k = now.head<3>(), u = now.tail<3>(), w = turn(k, u);
    Both out;
    out << cross(k, w), cross(u, w);
    return out;
  };
  double const time = 6;
  Both const end = reference_solution(rate, y, 0, time);
  Triple const w = turn(end.head<3>(), end.tail<3>());
  List truth = rolling_velocity(w, -end.tail<3>());
  for (Index i = 3; i < 6; ++i) truth.push_back(end[i]);
  auto const system = ball.system();
  has_its_orders("Chaplygin's ball", system, system.state(ball.velocity(), direction(ball.up)), time,
                 {50, 100, 200}, truth, [](RattleIntegrator const& run) {
                   List all = run.state().velocity;
                   all.insert(all.end(), run.point().vectors.begin(), run.point().vectors.begin() + 3);
                   return all;
                 });
}

BOOST_AUTO_TEST_CASE(a_ball_on_a_turntable_goes_in_circles_at_two_sevenths_of_its_rate) {
  // The plane turns: v + w x r = Omega u x (r - q) with q the axis, seen from the ball. A homogeneous ball
  // goes round a circle at 2/7 of Omega, whatever its radius and place.
  double const omega = 1.5, time = 4;
  std::string const rest = "r1 = -u1; r2 = -u2; r3 = -u3; s1 = r1 - q1; s2 = r2 - q2; s3 = r3 - q3;";
  Constrained const system(
      "SE(3)", "(v1^2 + v2^2 + v3^2)/2 + (w1^2 + w2^2 + w3^2)/5",
      {"v1 + w2*r3 - w3*r2 - Omega*(u2*s3 - u3*s2)", "v2 + w3*r1 - w1*r3 - Omega*(u3*s1 - u1*s3)",
       "v3 + w1*r2 - w2*r1 - Omega*(u1*s2 - u2*s1)"},
      {"u", "q"}, {{"Omega", omega}}, rest);
  // At the place (0.5, 0.2, 0) from the axis, with the velocity V; the plane there has Omega e3 x place.
  Triple const place(0.5, 0.2, 0), up(0, 0, 1), v(0.3, -0.4, 0), slip = v - omega * cross(up, place);
  Triple const w = cross(up, slip) + 0.7 * up;
  List const vectors{0, 0, 1, 0, -place[0], -place[1], -place[2], 1};
  auto const start = system.state({w[0], w[1], w[2], v[0], v[1], v[2]}, vectors);
  BOOST_TEST(start.moved < 1e-15);
  double const angle = 2 * omega * time / 7, c = std::cos(angle), s = std::sin(angle), rate = 2 * omega / 7;
  // V turns, and the place with it.
  List const truth{place[0] + (v[0] * s - v[1] * (1 - c)) / rate,
                   place[1] + (v[0] * (1 - c) + v[1] * s) / rate, 0};
  has_its_orders("ball on a turntable", system, start, time, {40, 80, 160}, truth,
                 [&](RattleIntegrator const& run) {
                   return List{run.configuration()(0, 3) + place[0], run.configuration()(1, 3) + place[1],
                               run.configuration()(2, 3)};
                 });
}

BOOST_AUTO_TEST_CASE(a_homogeneous_ball_rolls_straight_on) {
  Constrained const system("SE(3)", "(v1^2 + v2^2 + v3^2)/2 + (w1^2 + w2^2 + w3^2)/5", point_rests, {"up"},
                           {}, "r1 = -up1; r2 = -up2; r3 = -up3;");
  Triple const up(0, 0, 1), w(0.4, 1.1, -0.8), v = cross(w, up);
  auto const start = system.state(rolling_velocity(w, -up), direction(up));
  has_its_orders("homogeneous ball", system, start, 4, {10, 20, 40}, {4 * v[0], 4 * v[1], 0},
                 [](RattleIntegrator const& run) {
                   auto const& g = run.configuration();
                   return List{g(0, 3), g(1, 3), g(2, 3)};
                 });
  // At any step each one goes as far as the one before, and in the same direction.
  for (double const h : {0.05, 0.4}) {
    auto run = system.run(h, {1}, start);
    run.follow_configuration(Eigen::MatrixXd::Identity(4, 4));
    Triple place = Triple::Zero(), first = Triple::Zero();
    for (int k = 0; k < 20; ++k) {
      run.step();
      Triple const now = run.configuration().col(3).head<3>(), moved = now - place;
      if (k == 0) first = moved;
      // Places of size 20 h with some ten roundings a step.
      BOOST_TEST((moved - first).norm() < 20 * 16 * 0x1p-52 * 20 * h);
      place = now;
    }
  }
}

BOOST_AUTO_TEST_CASE(a_body_on_a_belt_that_speeds_up_is_pulled_by_its_mass_times_that) {
  // v1 = t^2 along a line, free across it: a constraint that depends on the time. Reaction 2 m t, and after n
  // steps of h the place is the sum of the midpoints.
  Constrained const system("R^2", "m*(x1^2 + x2^2)/2", {"x1 - t^2"}, {}, {{"m", 3}});
  auto run = system.run(0.25, {1}, system.state({1, 0.5}, {}, 1), 1);
  run.follow_configuration(Eigen::MatrixXd::Identity(3, 3));
  double place = 0;
  for (int k = 0; k < 12; ++k) {
    double const middle = 1 + 0.25 * k + 0.125, now = 1 + 0.25 * (k + 1);
    place += 0.25 * middle * middle;
    run.step();
    BOOST_TEST(std::abs(run.state().velocity[0] - now * now) < 16 * 0x1p-52 * now * now);
    BOOST_TEST(run.state().velocity[1] == 0.5);
    BOOST_TEST(std::abs(run.reaction()[0] - 6 * now) < 16 * 0x1p-52 * 6 * now);
    BOOST_TEST(std::abs(run.configuration()(0, 2) - place) < 16 * 16 * 0x1p-52 * place);
  }
}

BOOST_AUTO_TEST_CASE(a_body_at_rest_on_a_belt_that_starts_is_carried_along) {
  // The velocity at the start says nothing of the size of that of the belt.
  Constrained const system("R^2", "x1^2/2 + x2^2/2", {"x1 - t"});
  auto run = system.run(0.25, {1}, system.state({0, 0}));
  for (int k = 0; k < 8; ++k) run.step();
  BOOST_TEST(std::abs(run.state().velocity[0] - 2) < 16 * 0x1p-52);
}

BOOST_AUTO_TEST_SUITE_END()
