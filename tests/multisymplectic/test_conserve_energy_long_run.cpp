// Steps that conserve energy by a discrete gradient, and steps of order 4 by composition.
#include <boost/test/unit_test.hpp>

#include "actio/media_on_meshes/medium_on_mesh.hpp"
#include "actio/meshes/body_shapes.hpp"
#include "witness/draw.hpp"

using namespace actio;
using namespace actio::media;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
template <int d>
using Spot = std::array<double, d>;

/// How far a body comes from what it started with, relative to the sums of moduli.
struct Kept {
  double energy = 0, momentum = 0, angular_momentum = 0;
};
template <int d>
Kept kept_over(MediumOnMesh<d>& body, long steps, int samples) {
  auto const p = body.momentum();
  auto const L = body.angular_momentum();
  double const E = body.energies().total();
  Kept worst;
  for (int k = 0; k < samples; ++k) {
    body.step(steps / samples);
    double parts = 0, moments = 0, of_p = 0, of_L = 0;
    auto const x = body.places(), v = body.velocities();
    for (std::size_t i = 0; i < v.size(); ++i) {
      double speed = 0, away = 0;
      for (std::size_t a = 0; a < d; ++a) speed += v[i][a] * v[i][a], away += x[i][a] * x[i][a];
      parts += body.masses()[i] * std::sqrt(speed), moments += body.masses()[i] * std::sqrt(speed * away);
    }
    for (std::size_t a = 0; a < d; ++a) of_p = std::max(of_p, std::abs(body.momentum()[a] - p[a]));
    for (std::size_t a = 0; a < 3; ++a) of_L = std::max(of_L, std::abs(body.angular_momentum()[a] - L[a]));
    worst.energy = std::max(worst.energy, std::abs(body.energies().total() / E - 1));
    worst.momentum = std::max(worst.momentum, of_p / parts);
    worst.angular_momentum = std::max(worst.angular_momentum, of_L / moments);
  }
  return worst;
}
void report(char const* name, long steps, Kept const& kept, double bound) {
  BOOST_TEST_MESSAGE(name << ", " << steps << " steps that conserve energy: energy " << kept.energy
                          << ", momentum " << kept.momentum << ", angular momentum "
                          << kept.angular_momentum);
  BOOST_TEST(kept.energy <= bound);
  BOOST_TEST(kept.momentum <= bound);
  BOOST_TEST(kept.angular_momentum <= bound);
}
BodyStart<2> tumbling() {
  BodyStart<2> start;
  start.density = [](Spot<2> const& X) { return 2 + X[0]; };
  start.placement = [](Spot<2> const& X) { return Spot<2>{X[0] * 1.2 + 0.1 * X[1] * X[1], X[1]}; };
  start.velocity = [](Spot<2> const& X) { return Spot<2>{0.001 - 0.5 * X[1], 0.5 * X[0] - 0.002}; };
  return start;
}
BodyMesh block() { return box_mesh({-0.5, -0.3}, {0.5, 0.3}, {3, 2}); }
}  // namespace

BOOST_AUTO_TEST_SUITE(conserve_energy)

// The work of the stress is that of the energy, and it turns nothing, from changes below the rounding of C up
// to large ones. W is below 10 and rounded some twenty times.
BOOST_AUTO_TEST_CASE(the_discrete_stress_does_the_work_of_the_energy_and_turns_nothing) {
  Draw draw(7);
  auto const test = [&]<int d>(std::shared_ptr<StoredEnergy<d> const> const& law) {
    for (double size = 1e-14; size < 0.3; size *= 10)
      for (int k = 0; k < 20; ++k) {
        auto const drawn = [&](double by) {
          auto F = Matrix<double, d, d>::Identity();
          for (int i = 0; i < d * d; ++i) F.data()[i] += by * draw.vector<double, Matrix<double, 1, 1>>(1)[0];
          return F;
        };
        Matrix<double, d, d> const F0 = drawn(0.25);
        Matrix<double, d, d> const F1 = F0 + (drawn(size) - Matrix<double, d, d>::Identity());
        if (!(small_determinant(F0) > 0.1) || !(small_determinant(F1) > 0.1)) continue;
        auto const P = discrete_stress<d>([&](auto const& H) { return law->energy_beyond(H); },
                                          [&](auto const& E) { return law->green_stress_beyond(E); },
                                          without_identity<d>(F0), Matrix<double, d, d>(F1 - F0));
        double work = 0;
        for (int i = 0; i < d * d; ++i) work += P.data()[i] * (F1.data()[i] - F0.data()[i]);
        double const W0 = law->energy(F0), W1 = law->energy(F1);
        BOOST_TEST(std::abs(work - (W1 - W0)) <= 40 * eps * (10 + std::abs(W0) + std::abs(W1)));
        Matrix<double, d, d> const turn = P * (F0 + F1).transpose();
        BOOST_TEST(magnitude(turn - turn.transpose()) <= 40 * eps * (1 + magnitude(turn)) * 10);
      }
  };
  test.operator()<2>(stored_energy<2>(neo_hookean(1, 0.5)));
  test.operator()<3>(stored_energy<3>(neo_hookean(1, 0.5)));
  test.operator()<3>(stored_energy<3>(isentropic_gas(0.5, 1.4)));
  test.operator()<2>(stored_energy<2>(FastStVenantKirchhoff{1, 0.5}));
  // A reader's own law, of which nothing else is known.
  auto const own = [](auto const& F) { return F.squaredNorm() * 0.3 + 1.0 / small_determinant(F); };
  test.operator()<2>(stored_energy<2>(own));
  test.operator()<3>(stored_energy<3>(own));
}

// The bar that is set is 1e-13. What is left of a step is rounding of forces times the way of a step, and an
// iteration that ends too early, whose rest does work of one sign, does not stay below it.
BOOST_AUTO_TEST_CASE(a_tumbling_block_keeps_energy_and_both_momenta_over_1e5_steps) {
  MediumOnMesh<2> rubber(block(), stored_energy<2>(neo_hookean(1, 0.5)), tumbling(),
                         {.step = 0.02, .conserve = Conserve::energy});
  report("a tumbling block of rubber", 100000, kept_over(rubber, 100000, 200), 1e-13);
  auto less = tumbling();
  less.placement = [](Spot<2> const& X) { return Spot<2>{X[0] * 1.03, X[1]}; };
  MediumOnMesh<2> steel(disc_mesh(0.5, {1, 2}), stored_energy<2>(FastStVenantKirchhoff{1, 0.5}), less,
                        {.step = 0.02, .conserve = Conserve::energy});
  report("a tumbling disc", 10000, kept_over(steel, 10000, 50), 1e-13);
}

// Gas under pressure from outside, in space: energy with that of the pressure.
BOOST_AUTO_TEST_CASE(a_ball_of_gas_under_pressure_from_outside_does_so_too) {
  BodyStart<3> start;
  start.velocity = [](Spot<3> const& X) { return Spot<3>{-0.3 * X[1], 0.3 * X[0], 0.2 * X[2]}; };
  BodyLoads<3> loads;
  loads.outside_pressure = 0.4;
  MediumOnMesh<3> ball(ball_mesh(1, {1, 2}), stored_energy<3>(isentropic_gas(0.5, 1.4)), start,
                       {.step = 0.02, .conserve = Conserve::energy}, {}, loads);
  report("a ball of gas under pressure", 300, kept_over(ball, 300, 50), 1e-13);
}

// A block that is held at one side, pulled at the other, in a field that is no polynomial.
BOOST_AUTO_TEST_CASE(loads_that_have_a_potential_keep_energy_as_well) {
  BodyLoads<2> loads;
  loads.tractions["right"] = {0.02, -0.05};
  loads.potentials.push_back(space_potential<2>([](auto const& x) {
    using std::exp;
    return exp(-1.0 * x.squaredNorm()) * 0.1 + x[1] * 0.05;
  }));
  auto start = tumbling();
  start.velocity = [](Spot<2> const&) { return Spot<2>{}; };
  MediumOnMesh<2> body(block(), stored_energy<2>(neo_hookean(1, 0.5)), start,
                       {.step = 0.02, .conserve = Conserve::energy}, {{"left", {Side::fixed, {}}}}, loads);
  double const E = body.energies().total(),
               whole = body.energies().kinetic + std::abs(body.energies().stored);
  double worst = 0;
  for (int k = 0; k < 100; ++k)
    body.step(100), worst = std::max(worst, std::abs(body.energies().total() - E) / whole);
  BOOST_TEST_MESSAGE("a block that is held and pulled, 10000 steps: energy " << worst);
  BOOST_TEST(worst <= 1e-13);
}

// Four times the longest explicit step: the equation is solved by Newton's iteration. Where strains change by
// more than 30 % in a step energies are subtracted: each step then rounds some twenty times what W is made
// of, ten times what is stored.
BOOST_AUTO_TEST_CASE(steps_beyond_the_explicit_limit_keep_energy_too) {
  auto const law = stored_energy<2>(neo_hookean(1, 0.5));
  auto start = tumbling();
  start.placement = [](Spot<2> const& X) { return Spot<2>{X[0] * 1.05, X[1]}; };
  MediumOnMesh<2> explicitly(block(), law, start, {.step = 0.02});
  double const step = 4 * explicitly.largest_step();
  MediumOnMesh<2> body(block(), law, start, {.step = step, .conserve = Conserve::energy});
  report("a block, four times the explicit limit", 1000, kept_over(body, 1000, 50),
         20 * 10 * eps * std::sqrt(1000.0));
}

namespace {
/// The largest distance of a node from where a run with a short step has it, at time 1.
double error_in_time(BodyStepping stepping, int steps, std::vector<Spot<2>> const& exact) {
  stepping.step = 1.0 / steps;
  MediumOnMesh<2> body(block(), stored_energy<2>(neo_hookean(1, 0.5)), tumbling(), stepping);
  body.step(steps);
  double worst = 0;
  auto const x = body.places();
  for (std::size_t k = 0; k < x.size(); ++k)
    worst = std::max(worst, std::hypot(x[k][0] - exact[k][0], x[k][1] - exact[k][1]));
  return worst;
}
}  // namespace

// The motion of the same mesh with steps ten times as short as the shortest here, and order 4: its error is
// 1e-4 of what is measured.
BOOST_AUTO_TEST_CASE(both_steps_have_order_two_and_composed_order_four_which_pays) {
  MediumOnMesh<2> fine(block(), stored_energy<2>(neo_hookean(1, 0.5)), tumbling(),
                       {.step = 1.0 / 1600, .order = 4});
  fine.step(1600);
  auto const exact = fine.places();
  for (Conserve const conserve : {Conserve::form, Conserve::energy})
    for (int const order : {2, 4}) {
      double before = 0;
      for (int const steps : {20, 40, 80, 160}) {
        double const error = error_in_time({.step = 1, .order = order, .conserve = conserve}, steps, exact);
        if (before > 0) {
          double const slope = std::log2(before / error);
          BOOST_TEST_MESSAGE("order " << order << (conserve == Conserve::form ? ", form" : ", energy") << ", "
                                      << steps << " steps: error " << error << ", slope " << slope);
          BOOST_TEST(std::abs(slope - order) <= 0.1);
        }
        before = error;
      }
    }
  // With the same number of forces, five to a composed step.
  double const plain = error_in_time({.step = 1}, 400, exact),
               composed = error_in_time({.step = 1, .order = 4}, 80, exact);
  BOOST_TEST_MESSAGE("400 forces: error of order 2 " << plain << ", of order 4 " << composed);
  BOOST_TEST(composed <= plain / 10);
}

BOOST_AUTO_TEST_SUITE_END()
