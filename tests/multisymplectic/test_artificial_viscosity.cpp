// Von Neumann and Richtmyer's viscosity of media on meshes: its ledger, its shock, what it leaves alone.
#include <boost/test/unit_test.hpp>

#include "actio/media_on_meshes/medium_on_mesh.hpp"
#include "actio/meshes/body_shapes.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::media;

namespace {
template <int d>
using Spot = std::array<double, d>;

/// A gas with rho = K = 1, gamma = 2 on [0, 1]: p = 1/J^2, U = 1/J.
auto gas1() { return stored_energy<1>(isentropic_gas(1, 2)); }

/// How far energy and what was dissipated are from the energy at the start, at most, in a gas that is
/// compressed until t = 0.2 with steps of this length.
double imbalance(double dt, double& dissipated) {
  BodyStart<1> start;
  start.velocity = [](Spot<1> const& X) { return Spot<1>{-0.6 * std::sin(3.14159265358979 * X[0])}; };
  MediumOnMesh<1> line(box_mesh({0}, {1}, {32}), gas1(), start, {.step = dt, .viscosity = {0.5, 2}},
                       {{"left", {Side::fixed, {}}}, {"right", {Side::fixed, {}}}});
  double const E = line.energies().total();
  double worst = 0;
  while (line.time() < 0.2 - dt / 2) {
    line.step();
    worst = std::max(worst, std::abs(line.energies().total() + line.dissipated() - E));
  }
  dissipated = line.dissipated();
  return worst;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(artificial_viscosity)

// In a kick the kinetic energy loses what the forces of viscosity work, and gains what the others do. So the
// balance is that of the scheme without viscosity: off by the square of the step.
BOOST_AUTO_TEST_CASE(energy_and_what_was_dissipated_are_constant_to_the_square_of_the_step) {
  double taken[3];
  double const coarse = imbalance(2e-3, taken[0]), middle = imbalance(1e-3, taken[1]),
               fine = imbalance(5e-4, taken[2]);
  BOOST_TEST_MESSAGE("viscosity: energy + dissipated off by " << coarse << ", " << middle << ", " << fine
                                                              << ", dissipated " << taken[2]);
  BOOST_TEST(std::abs(std::log2(coarse / middle) - 2) <= 0.1);
  BOOST_TEST(std::abs(std::log2(middle / fine) - 2) <= 0.1);
  // And it is a thousand times less than what was dissipated.
  BOOST_TEST(1000 * fine <= taken[2]);
  // The motion itself is of order 2 in time: so is what it dissipates.
  BOOST_TEST(std::abs(std::log2((taken[0] - taken[1]) / (taken[1] - taken[2])) - 2) <= 0.3);
}

// Gas that meets a wall: behind the shock it is at rest, with J for which s(J - 1) = v0 and
// p(J) - p(1) = s v0, where s is the mass that the shock passes in a unit of time. What it dissipates is the
// energy that mass and momentum, which are kept, do not account for:
//     s (v0^2/2 + U(1) - U(J)) + p(1) v0.
BOOST_AUTO_TEST_CASE(a_shock_dissipates_what_mass_and_momentum_leave_of_energy) {
  double const v0 = 1;
  double low = 0.1, up = 1;
  for (int k = 0; k < 60; ++k) {
    double const J = 0.5 * (low + up), s = v0 / (1 - J);
    (1 / (J * J) - 1 > s * v0 ? low : up) = J;
  }
  double const J = low, s = v0 / (1 - J), rate = s * (v0 * v0 / 2 + 1 - 1 / J) + v0;
  BodyStart<1> start;
  start.velocity = [=](Spot<1> const& X) { return Spot<1>{X[0] == 0 ? 0 : -v0}; };
  MediumOnMesh<1> line(box_mesh({0}, {1}, {400}), gas1(), start, {.step = 2e-4, .viscosity = {0.5, 2}},
                       {{"left", {Side::fixed, {}}}, {"right", {Side::fixed, {}}}});
  line.step(500);
  double const first = line.dissipated();
  line.step(500);
  double const measured = (line.dissipated() - first) / 0.1, behind = line.jacobians()[60];
  BOOST_TEST_MESSAGE("shock: dissipates " << measured << " in a unit of time, known " << rate << "; J "
                                          << behind << ", known " << J);
  // It has the width of some cells of some hundred, and passes forty of them in that time: half a cell.
  BOOST_TEST(std::abs(measured / rate - 1) <= 0.0125);
  BOOST_TEST(std::abs(behind - J) <= 0.01);
  // Nothing swings behind it by more than that.
  auto const all = line.jacobians();
  for (std::size_t k = 40; k < 100; ++k) BOOST_TEST(std::abs(all[k] - J) <= 0.01);
}

// It is a pressure, and turns nothing.
BOOST_AUTO_TEST_CASE(a_viscous_body_keeps_its_momenta_and_goes_on_bit_for_bit) {
  BodyStart<2> start;
  start.velocity = [](Spot<2> const& X) {
    return Spot<2>{0.3 - 0.5 * X[0] - 0.7 * X[1], -0.1 - 0.4 * X[1] + 0.7 * X[0]};
  };
  double const eps = std::numeric_limits<double>::epsilon();
  for (BodyMesh const& mesh : {box_mesh({-0.5, -0.3}, {0.5, 0.3}, {8, 5}), disc_mesh(1, {2, 4})}) {
    auto const made = [&] {
      return MediumOnMesh<2>(mesh, stored_energy<2>(neo_hookean(1, 0.5)), start,
                             {.step = 0.01, .viscosity = {0.5, 1.5}});
    };
    auto body = made(), other = made();
    auto const p = body.momentum();
    double const spin = body.angular_momentum()[2];
    body.step(60);
    // Each step rounds forces and velocities of some fifty nodes, of numbers below 1.
    double const bound = 60 * 50 * eps;
    BOOST_TEST(std::hypot(body.momentum()[0] - p[0], body.momentum()[1] - p[1]) <= bound);
    BOOST_TEST(std::abs(body.angular_momentum()[2] - spin) <= bound);
    BOOST_TEST(body.dissipated() > 1e-4);
    auto const state = body.remember();
    other.restore(state), other.step(20), body.step(20);
    BOOST_TEST((body.remember() == other.remember()));
  }
}

BOOST_AUTO_TEST_CASE(a_body_that_expands_moves_as_without_viscosity) {
  BodyStart<2> start;
  start.velocity = [](Spot<2> const& X) { return Spot<2>{X[0], X[1]}; };
  auto const made = [&](ArtificialViscosity const& viscosity) {
    return MediumOnMesh<2>(box_mesh({0, 0}, {1, 1}, {4, 4}), stored_energy<2>(isentropic_gas(1, 1.4)), start,
                           {.step = 0.01, .viscosity = viscosity});
  };
  auto viscous = made({0.5, 2}), plain = made({});
  viscous.step(20), plain.step(20);
  BOOST_TEST((viscous.places() == plain.places()));
  BOOST_TEST(viscous.dissipated() == 0);
  BOOST_TEST(plain.dissipated() == 0);
}

// Compressed at the rate v.
MediumOnMesh<1> compressed(BodyStepping const& stepping, double v = 0) {
  BodyStart<1> start;
  start.velocity = [=](Spot<1> const& X) { return Spot<1>{-v * X[0]}; };
  return MediumOnMesh<1>(box_mesh({0}, {1}, {10}), gas1(), start, stepping);
}

BOOST_AUTO_TEST_CASE(steps_that_viscosity_does_not_know_are_refused) {
  CHECK_REFUSED(compressed({.step = 0.01, .order = 4, .viscosity = {0.5, 2}}), OutsideDomain);
  CHECK_REFUSED(compressed({.step = 0.01, .conserve = Conserve::energy, .viscosity = {0.5, 2}}),
                OutsideDomain);
  CHECK_REFUSED(compressed({.step = 0.01, .viscosity = {-0.5, 2}}), OutsideDomain);
  CHECK_REFUSED(compressed({.step = 0.01, .viscosity = {0.5, NAN}}), NotFinite);
  // There are a thousand parts at most.
  auto thick = compressed({.step = 0.01, .viscosity = {1e9, 0}}, 1);
  auto const state = thick.remember();
  BOOST_CHECK_THROW(thick.step(), OutsideDomain);
  BOOST_TEST((state == thick.remember()));
}

BOOST_AUTO_TEST_CASE(a_step_that_viscosity_does_not_allow_is_made_in_parts) {
  // c = sqrt(2), l = 0.1: l/(2*2*c) with the linear coefficient 2, and less where the gas is compressed.
  double const allowed = 0.1 / 4 / std::sqrt(2.0), step = 0.05;
  BOOST_TEST(std::abs(compressed({.step = 0.01, .viscosity = {2, 0}}).largest_step() - allowed) <= 1e-15);
  // Of half the length that is allowed at the end of the first attempt: six are too few by a little, and
  // seven are made.
  auto line = compressed({.step = step, .viscosity = {2, 0}}, 1),
       parts = compressed({.step = step / 7, .viscosity = {2, 0}}, 1);
  line.step(), parts.step(7);
  double worst = 0;
  for (std::size_t k = 0; k < line.places().size(); ++k)
    worst = std::max(worst, std::abs(line.places()[k][0] - parts.places()[k][0]));
  BOOST_TEST(worst <= 1e-15);
  BOOST_TEST(std::abs(line.dissipated() - parts.dissipated()) <= 1e-15);
  // A step that is allowed is whole.
  auto whole = compressed({.step = 0.9 * allowed, .viscosity = {2, 0}}),
       once = compressed({.step = 0.9 * allowed, .viscosity = {2, 0}});
  whole.step(2), once.step(), once.step();
  BOOST_TEST((whole.remember() == once.remember()));
}

BOOST_AUTO_TEST_SUITE_END()
