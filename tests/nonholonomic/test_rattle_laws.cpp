// What holds of every run with constraints: it obeys them, it can be run back, its reactions are forces.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/any_group/momentum_across.hpp"
#include "actio/reduction/composition.hpp"
#include "rolling_systems.hpp"
#include "saved_numbers.hpp"

using namespace actio;
using namespace actio::systems;
using namespace actio::testing;

namespace {

constexpr double eps = 0x1p-52;

/// A body of three different moments of inertia and a product of them in a bowl whose bottom is given by
/// formulas, on either side and in either chart.
Constrained uneven(Side side, Chart chart) {
  return {"SE(3)",
          "(w1^2 + 2*w2^2 + 2.5*w3^2 + w1*w2/3 + v1^2 + v2^2 + v3^2)/2 + v1*w2/5 - 0.9*u1 + u2*u3/4",
          {"v1 + w2*u3 - w3*u2 + w1*u4/2", "v2 + (w3*u1 - w1*u3)*(1 + u1^2/4) - 0.3*u1"},
          {"u"},
          {},
          "",
          chart,
          side};
}
List const uneven_velocity{0.9, -0.4, 0.7, 0.2, 0.1, -0.3}, uneven_vector{0.36, 0.48, 0.8, 1};

}  // namespace

BOOST_AUTO_TEST_SUITE(runs_with_constraints)

BOOST_AUTO_TEST_CASE(constraints_hold_at_the_nodes_and_in_the_middle_of_steps) {
  for (Side const side : {Side::left, Side::right})
    for (Chart const chart : {Chart::exponential, Chart::cayley})
      for (int const order : {2, 4}) {
        auto const system = uneven(side, chart);
        auto const start =
            constrained_state(*system.system, *system.constraints, uneven_velocity, uneven_vector, 0, 10);
        ConstrainedVelocity look(*system.system, *system.constraints);
        auto run = system.run(0.05, symmetric_composition<double>(order), start);
        double worst = look.defect(start.velocity, start.point.vectors, 0);
        for (int k = 0; k < 200; ++k) {
          run.step();
          auto const now = run.state();
          worst = std::max(worst, look.defect(now.velocity, now.point.vectors, 0));
          // The momentum is that of the velocity.
          auto const p = LegendreVelocity(*system.system).momentum(now.velocity, now.point.vectors);
          BOOST_TEST(apart(p, now.point.momentum) < 64 * eps * 4);
        }
        BOOST_TEST(worst <= 1e-13);
      }
}

BOOST_AUTO_TEST_CASE(a_run_backwards_returns_to_its_start) {
  for (Side const side : {Side::left, Side::right})
    for (Chart const chart : {Chart::exponential, Chart::cayley})
      for (int const order : {2, 4}) {
        auto const system = uneven(side, chart);
        auto const start =
            constrained_state(*system.system, *system.constraints, uneven_velocity, uneven_vector, 0, 10);
        auto const fractions = symmetric_composition<double>(order);
        auto there = system.run(0.05, fractions, start);
        for (int k = 0; k < 100; ++k) there.step();
        auto back = system.run(-0.05, fractions, there.state());
        for (int k = 0; k < 100; ++k) back.step();
        auto const end = back.state();
        BOOST_TEST(apart(end.velocity, start.velocity) < 1e-12);
        BOOST_TEST(apart(end.point.vectors, start.point.vectors) < 1e-12);
        BOOST_TEST(apart(there.state().velocity, start.velocity) > 0.1);
      }
}

BOOST_AUTO_TEST_CASE(configurations_carry_the_vectors) {
  for (Side const side : {Side::left, Side::right}) {
    auto const system = uneven(side, Chart::exponential);
    auto const start =
        constrained_state(*system.system, *system.constraints, uneven_velocity, uneven_vector, 0, 10);
    auto run = system.run(0.05, symmetric_composition<double>(4), start);
    run.follow_configuration(Eigen::MatrixXd::Identity(4, 4));
    for (int k = 0; k < 50; ++k) run.step();
    Eigen::Vector4d const now(run.point().vectors.data()), first(uneven_vector.data());
    Eigen::MatrixXd const& g = run.configuration();
    double const off = side == Side::left ? (g * now - first).norm() : (g * first - now).norm();
    // Five substeps a step, with some ten roundings of products each.
    BOOST_TEST(off < 5 * 50 * 10 * eps * g.norm());
  }
}

BOOST_AUTO_TEST_CASE(the_reaction_of_the_blade_is_the_force_across_it) {
  // m (a w' + v1 w) with w' = -m a v1 w/J_t: the acceleration of the centre of mass across the blade.
  Sleigh const sleigh;
  auto const system = sleigh.system();
  auto run = system.run(0.02, {1}, system.state(sleigh.velocity(0)));
  double impulse = 0, mean = 0;
  for (int k = 0; k < 100; ++k) {
    auto const before = run.state();
    run.step();
    auto const force = [&](List const& v) {
      return sleigh.mass * v[0] * v[1] * sleigh.inertia / sleigh.about_blade;
    };
    auto const now = run.state();
    BOOST_TEST(std::abs(run.reaction()[0] - force(now.velocity)) < 64 * eps * sleigh.mass * 2);
    // The multiplier of a step acts at its start. The first one is of half a step: the momentum at the start
    // obeys the constraint already.
    if (k > 0) impulse += run.impulse()[0], mean += 0.02 * force(before.velocity);
  }
  BOOST_TEST(std::abs(impulse / mean - 1) < 1e-3);  // of second order in the step, 4e-4 itself
}

BOOST_AUTO_TEST_CASE(the_energy_of_a_run_stays_near_its_start) {
  // No work is done by constraints that are linear; order 2 keeps the energy to second order, without drift.
  Sleigh const sleigh;
  auto const system = sleigh.system();
  auto const change = [&](double h) {
    auto const start = system.state(sleigh.velocity(0));
    auto run = system.run(h, {1}, start);
    double largest = 0;
    for (double t = 0; t < 12; t += h) {
      run.step();
      largest = std::max(largest, std::abs(system.energy(run.state()) / system.energy(start) - 1));
    }
    return largest;
  };
  double const coarse = change(0.1), fine = change(0.05);
  BOOST_TEST_MESSAGE("energy of the sleigh: " << coarse << " " << fine);
  BOOST_TEST(std::abs(std::log2(coarse / fine) - 2) < 0.1);
}

BOOST_AUTO_TEST_CASE(a_velocity_that_vanishes_to_rounding_obeys) {
  // What a constraint leaves of a velocity is small beside the whole of it, and not beside itself: a skate
  // that a weight drives has v2 = 0 alone.
  Constrained const skate("SE(2)", "(v1^2 + v2^2 + w^2)/2 - d1*q1 - d2*q2", {"v2"}, {"d", "q"});
  auto const start = skate.state({1.5, 0, 1e-17}, {1, 0, 0, 0, 0, 1});
  BOOST_TEST(start.moved < 1e-16);
  auto run = skate.run(0.02, symmetric_composition<double>(4), start);
  for (int k = 0; k < 100; ++k) run.step();
  BOOST_TEST(std::abs(run.state().velocity[1] - std::sin(1.5 * 2) / 1.5) < std::pow(0.02 * 1.5, 4));
}

BOOST_AUTO_TEST_CASE(forces_and_reactions_explain_the_momentum_and_the_energy) {
  // On either side, in either chart, with vectors in the constraints alone: all of the momentum of the
  // symmetry.
  for (Side const side : {Side::left, Side::right})
    for (Chart const chart : {Chart::exponential, Chart::cayley})
      for (int const order : {2, 4}) {
        Constrained system("SE(3)", "(w1^2 + 2*w2^2 + 2.5*w3^2 + w1*w2/3 + v1^2 + v2^2 + v3^2)/2 + v1*w2/5",
                           {"v1 + w2*u3 - w3*u2 + w1*u4/2 - sin(t)", "v2 + (w3*u1 - w1*u3)*(1 + u1^2/4)"},
                           {"u"}, {}, "", chart, side);
        auto const start =
            constrained_state(*system.system, *system.constraints, uneven_velocity, uneven_vector, 0, 10);
        auto run = system.run(0.05, symmetric_composition<double>(order), start);
        run.follow_configuration(Eigen::MatrixXd::Identity(4, 4));
        run.follow_ledger();
        auto const momentum = [&] {
          Eigen::MatrixXd const g = run.configuration(), back = g.inverse();
          return momentum_across(system.system->algebra, side, g, back, run.state().point.momentum);
        };
        auto const first = momentum();
        double balance = 0, changed = 0, work = 0, energy = 0;
        for (int k = 0; k < 200; ++k) {
          run.step();
          auto const now = momentum();
          auto const done = run.ledger();
          for (std::size_t i = 0; i < 6; ++i) {
            balance = std::max(balance, std::abs(now[i] - done.impulse[i] - first[i]));
            changed = std::max(changed, std::abs(now[i] - first[i]));
          }
          energy = std::max(energy, std::abs(system.energy(run.state()) - system.energy(start)));
          work = std::max(work, std::abs(system.energy(run.state()) - system.energy(start) - done.work));
        }
        // A thousand substeps of momenta up to ten, far out, with some tens of roundings each.
        BOOST_TEST(balance < 1000 * 32 * eps * 10);
        BOOST_TEST(changed > 0.1);
        BOOST_TEST(work < (order == 2 ? 0.05 : 0.002) * energy);
      }
}

BOOST_AUTO_TEST_CASE(a_velocity_is_moved_on_the_constraints_as_by_a_blow) {
  // A ball that slides and spins, dropped on a rough plane: the momentum about its contact is unchanged, the
  // new velocity rolls, and energy is lost.
  ChaplyginBall const ball;
  auto const system = ball.system();
  List const before{0.9, -0.4, 1.2, 0.3, 0.2, -0.5};
  auto const after =
      constrained_state(*system.system, *system.constraints, before, direction(ball.up), 0, 10);
  BOOST_TEST(after.moved > 0.1);
  LegendreVelocity legendre(*system.system);
  ReducedPoint const free{legendre.momentum(before, direction(ball.up)), direction(ball.up)};
  BOOST_TEST((ball.about_contact(free) - ball.about_contact(after.point)).norm() < 32 * eps * 4);
  BOOST_TEST(ConstrainedVelocity(*system.system, *system.constraints)
                 .defect(after.velocity, after.point.vectors, 0) < 16 * eps);
  BOOST_TEST(system.energy(after) < legendre.energy(before, direction(ball.up)));
  // A velocity that obeys them is left as it is.
  BOOST_TEST(apart(system.state(ball.velocity(), direction(ball.up)).velocity, ball.velocity()) < 16 * eps);
}

BOOST_AUTO_TEST_CASE(a_run_that_is_read_back_goes_on_digit_by_digit) {
  auto const system = uneven(Side::left, Chart::exponential);
  auto const start =
      constrained_state(*system.system, *system.constraints, uneven_velocity, uneven_vector, 0, 10);
  auto const fresh = [&](double time) {
    auto run = system.run(0.05, symmetric_composition<double>(4), start, time);
    run.follow_configuration(Eigen::MatrixXd::Identity(4, 4));
    return run;
  };
  for (int const until : {0, 5, 70}) {
    auto run = fresh(0.25), other = fresh(0);
    for (int k = 0; k < until; ++k) run.step();
    Saved saved;
    run.remember(saved);
    saved.reading = true;
    other.remember(saved);
    BOOST_TEST(saved.at == saved.numbers.size());
    for (int k = 0; k < 20; ++k) run.step(), other.step();
    BOOST_TEST((run.point().momentum == other.point().momentum), until);
    BOOST_TEST((run.point().vectors == other.point().vectors), until);
    BOOST_TEST((run.configuration() == other.configuration()), until);
    BOOST_TEST(run.time() == other.time(), until);
  }
}

BOOST_AUTO_TEST_CASE(the_tangent_of_a_step_is_that_of_differences) {
  auto const system = uneven(Side::left, Chart::exponential);
  auto const start =
      constrained_state(*system.system, *system.constraints, uneven_velocity, uneven_vector, 0, 10);
  double const h = 0.2;
  RattleMap const map(*system.system, *system.constraints, {1}, start.velocity);
  auto const tangent = tangent_of([&](auto const& p) { return map(Moved<double>(h), p); }, start.point);
  // Differences over 2e-3 and 1e-3, whose errors of second order cancel; those of fourth are 1e-12 of
  // derivatives below 100, and rounding is 1e-12 as well.
  double const by = 1e-3;
  auto const at = [&](std::size_t i, double x) {
    ReducedPointOver<double> moved{start.point.momentum, start.point.vectors};
    (i < 6 ? moved.momentum[i] : moved.vectors[i - 6]) += x;
    auto const image = map(h, moved);
    Eigen::VectorXd all(10);
    for (std::size_t k = 0; k < 10; ++k)
      all[static_cast<Index>(k)] = k < 6 ? image.momentum[k] : image.vectors[k - 6];
    return all;
  };
  for (std::size_t i = 0; i < 10; ++i) {
    Eigen::VectorXd const column =
        (8 * (at(i, by / 2) - at(i, -by / 2)) - (at(i, by) - at(i, -by))) / (6 * by);
    BOOST_TEST((tangent.col(static_cast<Index>(i)) - column).norm() < 1e-9, i);
  }
  // A combination of the rows added to the momentum changes nothing.
  ConstraintValues<double> rows(*system.constraints);
  rows.set_rows(start.point.vectors, 0);
  for (std::size_t k = 0; k < 2; ++k) {
    Eigen::VectorXd along = Eigen::VectorXd::Zero(10);
    for (std::size_t i = 0; i < 6; ++i) along[static_cast<Index>(i)] = rows.rows[k * 6 + i];
    BOOST_TEST((tangent * along).norm() < 256 * eps);
  }
}

BOOST_AUTO_TEST_SUITE_END()
