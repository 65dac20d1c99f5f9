// The free body over many bodies and many steps: ten thousand nasty ones against power series, a thousand
// seconds of hard bodies, a million steps.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "../rigid_body/random_bodies.hpp"
#include "actio/numbers/multiprecision.hpp"
#include "actio/rigid_body/moser_veselov.hpp"
#include "hard_bodies.hpp"

using namespace actio;
using namespace actio::bodies;

namespace {
using testing::FreePath, testing::FreeProblem, testing::ConservationErrors, testing::conservation_errors;
constexpr double eps = std::numeric_limits<double>::epsilon();

/// Four roundings of the answer, and four units in the last place of each number of the question.
constexpr double units = 8;

using Quad = __float128;  // 34 digits, from the compiler

void say(std::string const& what, ConservationErrors const& k) {
  BOOST_TEST_MESSAGE(what << ": Casimir " << k.casimir << ", energy " << k.energy << ", momentum in space "
                          << k.spatial << ", length of the quaternion " << k.length);
}

// Whether the moments that make a step exact are those of a body for which the general solver has the
// solution: the step is the smallest root.
bool generic_implementation(Inertia<3> const& inertia, FreeBody const& body, double h, Inertia<3>& replaced) {
  auto const j = inertia_of(body.step_parameters(h));
  Eigen::Vector3d moments;
  int first = 0;
  while ((inertia.moments[(first + 1) % 3] - inertia.moments[first]) *
             (inertia.moments[(first + 2) % 3] - inertia.moments[(first + 1) % 3]) <
         0)
    ++first;
  for (int i = 0; i < 3; ++i) moments[(i + first) % 3] = h * body.magnitude() / (2 * j[i]);
  for (int i = 0; i < 3; ++i)
    if (!(moments[i] > 0) || moments[(i + 1) % 3] + moments[(i + 2) % 3] < moments[i]) return false;
  replaced = inertia_from_moments<double>(moments);
  return std::abs(h) <
         0.99 * largest_step(replaced, Momentum<SO<3>, double>{SO<3>{}, body.at(0).body_momentum.components});
}
}  // namespace

BOOST_AUTO_TEST_SUITE(free_body_long_run)

BOOST_AUTO_TEST_CASE(ten_thousand_nasty_bodies_against_power_series) {
  testing::HardProblems problems(testing::seed);
  double worst = 0, longest = 0;
  for (int count = 0; count < 10000;) {
    FreeProblem const p = problems.next(10);
    testing::FreeBodyWitness<long double> witness(p.moments, 20);
    auto const answer = witness.after(testing::start_of<long double>(p), p.time);
    if (witness.expansions() > 400) continue;
    ++count, longest = std::max(longest, std::abs(p.time) * p.rate());
    worst = std::max(worst, testing::units_off(p, answer, units));
  }
  BOOST_TEST_MESSAGE(
      "at(t) of 10000 nasty bodies: at most "
      << worst
      << " times (eps + what one unit in the last place of each number of the question does), angles up to "
      << longest);
  BOOST_TEST(worst <= units);
}

BOOST_AUTO_TEST_CASE(ten_thousand_exact_steps_are_those_of_the_general_solver_with_other_moments) {
  std::mt19937 random(testing::seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  double worst = 0, series = 0;
  int count = 0, without = 0;
  while (count < 10000) {
    auto const [inertia, spin] = testing::random_body<3>(random);
    Eigen::Vector3d const pi = body_momentum(inertia, spin).components;
    FreeBody const body(inertia, {SO<3>{}, pi});
    double const h = uniform(random) / spin.coordinates.norm(),
                 angle = std::abs(h) * pi.norm() / inertia.moments.minCoeff();
    Inertia<3> replaced;
    if (!generic_implementation(inertia, body, h, replaced)) {
      ++without;
      continue;
    }
    ++count;
    auto const fast = body.at(h);
    auto const f = MoserVeselov<3>(replaced, h).relative_motion({SO<3>{}, pi}).value;
    Eigen::Vector3d const after = MoserVeselov<3>::transport(f, {SO<3>{}, pi}).components;
    Eigen::Matrix3d turned;
    for (int i = 0; i < 3; ++i)
      turned.col(i) =
          Eigen::Vector3d(SU2::Ad<double>(fast.attitude.value, Eigen::Vector3d(Eigen::Vector3d::Unit(i))));
    // Moments of the new body come with a rounding each, the equation is solved to 16 epsilon of the angle:
    // over its slope at the root, which is above sqrt(1 - 0.99^2), a seventh, at 0.99 of the largest step.
    double const room = 32 * eps * (1 + 7 * angle);
    worst = std::max({worst, (fast.body_momentum.components - after).norm() / pi.norm() / room,
                      (turned - f.value.transpose()).norm() / room});
    FreeProblem const p{
        {inertia.moments[0], inertia.moments[1], inertia.moments[2]}, {pi[0], pi[1], pi[2]}, h};
    series = std::max(
        series,
        testing::apart(testing::witness_of<double>(p, 17), testing::path_of(fast), pi.norm()).larger() /
            (16 * eps * (1 + angle)));
  }
  BOOST_TEST_MESSAGE("exact steps of 10000 bodies: at most "
                     << worst << " of the room to the general solver with replaced moments, " << series
                     << " to a series in double; " << without << " drawn had no such moments");
  BOOST_TEST(worst <= 1);
  BOOST_TEST(series <= 1);
  BOOST_TEST(without < 5000);
}

BOOST_AUTO_TEST_CASE(a_thousand_seconds_of_hard_bodies_to_twelve_digits) {
  struct Case {
    char const* name;
    std::array<double, 3> moments, spin;
  };
  for (Case const& c : {Case{"asymmetric", {0.6, 0.8, 1}, {0.9, 0.35, -0.6}},
                        {"ratio 1e6", {1e-6, 1, 1 + 1e-6}, {0.7, 0.3, 0.4}},
                        {"symmetric up to 1e-12", {1, 1 + 1e-12, 1.5}, {0.3, 0.7, 0.4}},
                        {"rod up to 1e-12", {0.5, 1, 1 + 1e-12}, {0.3, 0.7, 0.4}},
                        {"planar", {0.6, 0.8, 1.4}, {0.7, 0.4, 0.3}}}) {
    FreeProblem const p{
        c.moments, {c.spin[0] * c.moments[0], c.spin[1] * c.moments[1], c.spin[2] * c.moments[2]}, 1000};
    auto const truth = testing::witness_of<Quad>(p, 27);
    auto const once = testing::apart(truth, testing::path_of(p.body().at(1000)), p.magnitude());
    // A tenth is rounded: steps of 1/8 are a thousand seconds exactly.
    FreeSteps steps(p.body(), 0.125);
    steps.advance(8000);
    auto const many = testing::apart(truth, testing::path_of(steps.state()), p.magnitude());
    BOOST_TEST_MESSAGE(c.name << ", t = 1000: at(t) momentum " << once.momentum << ", attitude "
                              << once.attitude << "; 8000 steps " << many.momentum << ", " << many.attitude);
    BOOST_TEST(once.larger() <= 1e-12);
    BOOST_TEST(many.larger() <= 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(steps_of_nasty_bodies_are_as_good_as_one_evaluation) {
  // Next to the separatrix and next to steady turns, where what is added wrongly grows, or what is set back
  // disturbs. The truth is the exact flow in 50 digits.
  auto const truth_of = [](FreeProblem const& p) { return testing::exact_path<dec50>(p); };
  testing::HardProblems problems(testing::seed + 3);
  double worst = 0;
  for (int count = 0; count < 500;) {
    FreeProblem const p = problems.next(count % 2 ? 4000 : 100);
    long const steps = 1024;
    auto const body = p.body();
    auto const truth = truth_of(p);
    double const open = testing::condition(p, truth, truth_of), h = p.time / static_cast<double>(steps);
    // A single step over several periods rounds where it lands: its own error grows with it.
    if (open > 1e-2 || (body.near_separatrix() && std::abs(h) * body.pace() > 4)) continue;
    ++count;
    FreeSteps motion(body, h);
    motion.advance(steps);
    worst = std::max(worst, testing::apart(truth, testing::path_of(motion.state()), p.magnitude()).larger() /
                                (eps + open));
  }
  BOOST_TEST_MESSAGE("1024 steps of 500 nasty bodies: at most "
                     << worst
                     << " times (eps + what one unit in the last place of each number of the question does)");
  BOOST_TEST(worst <= units);
}

BOOST_AUTO_TEST_CASE(a_million_steps_keep_everything) {
  Three<double> const moments{0.6, 0.8, 1};
  for (double const h : {0.1, 0.0731}) {
    Eigen::Vector3d const M(1.8, 0.4, -0.9);
    FreeBody const body(inertia_from_moments(0.6, 0.8, 1), {SO<3>{}, M});
    // Without the setting back.
    CompensatedHalfTurn<double> const turn(body.step_parameters(h));
    CompensatedState<double> now{body.start(), {{}, {}}};
    for (long k = 0; k < 1000000; ++k) turn.step(now);
    ConservationErrors const alone = conservation_errors(moments, now, body.start());
    say("1e6 compensated steps of " + std::to_string(h), alone);
    // A step is a map with coefficients rounded to eps/2, each missing the orbit by a part of its change, to
    // the same side: the Casimir, which no coefficient can change, and the momentum in space have the errors
    // of the sums; the energy changes by at most a rounding of the change each step.
    for (double const x : {alone.casimir, alone.energy}) BOOST_TEST(x <= 2e-14);
    BOOST_TEST(alone.spatial <= 5e-13);
    // With it.
    FreeSteps motion(body, h);
    motion.advance(1000000);
    ConservationErrors const back = conservation_errors(motion, moments);
    say("1e6 steps of FreeSteps of " + std::to_string(h), back);
    for (double const x : {back.casimir, back.energy}) BOOST_TEST(x <= 2e-14);
    BOOST_TEST(back.spatial <= 5e-13);
    // Plain steps write the momentum as a rounded whole: visibly worse, or the rest would be for nothing.
    HalfTurn<double> const plain(body.step_parameters(h));
    CompensatedState<double> whole{body.start(), {{}, {}}};
    for (long k = 0; k < 1000000; ++k) plain.step(whole.state);
    ConservationErrors const rounded = conservation_errors(moments, whole, body.start());
    say("1e6 plain steps of " + std::to_string(h), rounded);
    BOOST_TEST(std::max(rounded.casimir, rounded.energy) > 10 * std::max(alone.casimir, alone.energy));
  }
}

BOOST_AUTO_TEST_SUITE_END()
