// Loads and sides of media on meshes: what they do to momenta, what they refuse.
#include <boost/test/unit_test.hpp>

#include "acoustic.hpp"
#include "actio/media_on_meshes/medium_on_mesh.hpp"
#include "actio/meshes/body_shapes.hpp"
#include "caught.hpp"

using namespace actio;
using namespace actio::media;
using testing::message_of;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
template <int d>
using Spot = std::array<double, d>;

BodyMesh block() { return box_mesh({-0.5, -0.3}, {0.5, 0.3}, {4, 3}); }
auto rubber() { return stored_energy<2>(neo_hookean(1, 0.5)); }
BodyStart<2> bent() {
  BodyStart<2> start;
  start.placement = [](Spot<2> const& X) { return Spot<2>{1.1 * X[0] + 0.1 * X[1] * X[1], X[1]}; };
  return start;
}
bool says(std::string const& message, std::string const& part) {
  BOOST_TEST(message.find(part) != std::string::npos, message << " does not say " << part);
  return true;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(loads_of_bodies)

// Every node falls by g t^2/2: at the times of nodes the explicit step is exact for a constant force, and so
// is the middle of a step. Each step rounds a velocity below 1.
BOOST_AUTO_TEST_CASE(a_body_falls_as_a_parabola_and_gains_momentum_by_its_weight) {
  BodyLoads<2> loads;
  loads.potentials.push_back(space_potential<2>([](auto const& x) { return x[1] * 9.81; }));
  for (Conserve const conserve : {Conserve::form, Conserve::energy}) {
    int const steps = 50;
    double const dt = 0.002;
    MediumOnMesh<2> body(block(), rubber(), {}, {.step = dt, .conserve = conserve}, {}, loads);
    double const E = body.energies().total();
    body.step(steps);
    auto const x = body.places();
    for (std::size_t k = 0; k < x.size(); ++k)
      BOOST_TEST(std::abs(x[k][1] - body.mesh().nodes[k][1] + 9.81 / 2 * body.time() * body.time()) <=
                 100 * steps * steps * eps);
    BOOST_TEST(std::abs(body.momentum()[1] + 0.6 * 9.81 * body.time()) <= 1e-13);
    BOOST_TEST(std::abs(body.energies().total() - E) <= 1e-13 * body.energies().kinetic);
  }
}

// A dead load gives its force times the time, whatever the body does: 0.6 is the length of the side.
BOOST_AUTO_TEST_CASE(a_dead_traction_gives_momentum_by_its_reference_length) {
  BodyLoads<2> loads;
  loads.tractions["right"] = {0.02, -0.05};
  MediumOnMesh<2> body(block(), rubber(), bent(), {.step = 0.02}, {}, loads);
  body.step(100);
  BOOST_TEST(std::abs(body.momentum()[0] - 0.02 * 0.6 * body.time()) <= 1e-14);
  BOOST_TEST(std::abs(body.momentum()[1] + 0.05 * 0.6 * body.time()) <= 1e-14);
  // In space, on one side of a box: the area of the side is 2 x 3.
  BodyLoads<3> load;
  load.tractions["left"] = {0.1, 0, 0};
  MediumOnMesh<3> box(box_mesh({0, 0, 0}, {1, 2, 3}, {1, 2, 2}), stored_energy<3>(neo_hookean(1, 0.5)), {},
                      {.step = 0.01}, {}, load);
  box.step(10);
  BOOST_TEST(std::abs(box.momentum()[0] - 0.1 * 6 * box.time()) <= 1e-14);
}

// Pressure on all sides, as a load that follows each of them, and as p times the volume: the corners of a
// quadrilateral have its area exactly, so that both are the same. It gives neither momentum nor spin.
BOOST_AUTO_TEST_CASE(a_pressure_that_follows_all_sides_is_the_outside_pressure) {
  BodyLoads<2> outside, following;
  outside.outside_pressure = 0.3;
  for (char const* side : {"left", "right", "bottom", "top"})
    following.pressures[side] = [](double) { return 0.3; };
  MediumOnMesh<2> one(block(), rubber(), bent(), {.step = 0.02}, {}, outside),
      other(block(), rubber(), bent(), {.step = 0.02}, {}, following);
  one.step(100), other.step(100);
  auto const x = one.places(), y = other.places();
  for (std::size_t k = 0; k < x.size(); ++k)
    BOOST_TEST(std::hypot(x[k][0] - y[k][0], x[k][1] - y[k][1]) <= 100 * 100 * eps);
  BOOST_TEST(std::hypot(other.momentum()[0], other.momentum()[1]) <= 100 * eps);
  BOOST_TEST(std::abs(other.angular_momentum()[2]) <= 100 * eps);
  MediumOnMesh<2> alone(block(), rubber(), bent(), {.step = 0.02});
  alone.step(100);
  BOOST_TEST(std::abs(alone.places()[0][0] - x[0][0]) > 1e-3);
  // Both press on facets in space as well: a ball that is pressed all around goes nowhere.
  BodyLoads<3> around;
  around.pressures["outer"] = [](double t) { return 0.2 + t; };
  MediumOnMesh<3> ball(ball_mesh(1, {1, 2}), stored_energy<3>(neo_hookean(1, 0.5)), {}, {.step = 0.02}, {},
                       around);
  ball.step(20);
  for (double const p : ball.momentum()) BOOST_TEST(std::abs(p) <= 1e-14);
  auto const J = ball.jacobians();
  BOOST_TEST(*std::min_element(J.begin(), J.end()) < 0.99);
}

// A piston drives sound into a line at rest: phi = X + f(t - X). With steps as long as a cell the discrete
// equations of a linear line have this solution at the nodes. Rounding goes on as a velocity.
BOOST_AUTO_TEST_CASE(a_piston_drives_the_exact_wave) {
  int const n = 40, steps = 30;
  double const h = 1.0 / n;
  auto const f = []<class T>(T const& t) { return base_value(t) > 0 ? T(t * t * t * 0.1) : T(0.0); };
  auto const chi = [&]<class T>(Spot<1> const& X, T const& t) { return std::array<T, 1>{f(t) + X[0]}; };
  MediumOnMesh<1> line(box_mesh({0}, {1}, {n}), stored_energy<1>(FastFluid{testing::Acoustic{}}), {},
                       {.step = h}, {{"left", {Side::moved, prescribed_motion<1>(chi)}}});
  line.step(steps);
  auto const x = line.places();
  for (std::size_t k = 0; k < x.size(); ++k) {
    double const X = line.mesh().nodes[k][0];
    BOOST_TEST(std::abs(x[k][0] - X - f(line.time() - X)) <= 4 * eps * steps * steps);
  }
}

// A line that moves with the side that moves it stays as it is: each substep has to ask for the side at its
// own beginning and end.
BOOST_AUTO_TEST_CASE(a_side_moves_with_the_substeps_of_order_four) {
  auto const chi = []<class T>(Spot<1> const& X, T const& t) { return std::array<T, 1>{0.7 * t + X[0]}; };
  BodyStart<1> start;
  start.velocity = [](Spot<1> const&) { return Spot<1>{0.7}; };
  for (Conserve const conserve : {Conserve::form, Conserve::energy}) {
    int const n = 10, steps = 20;
    MediumOnMesh<1> line(box_mesh({0}, {1}, {n}), stored_energy<1>(FastFluid{testing::Acoustic{}}), start,
                         {.step = 0.05, .order = 4, .conserve = conserve},
                         {{"left", {Side::moved, prescribed_motion<1>(chi)}}});
    line.step(steps);
    auto const x = line.places();
    for (std::size_t k = 0; k < x.size(); ++k)
      BOOST_TEST(std::abs(x[k][0] - line.mesh().nodes[k][0] - 0.7 * line.time()) <= 100 * eps * steps);
  }
}

BOOST_AUTO_TEST_CASE(sides_hold_what_they_say) {
  BodyStart<2> start = bent();
  start.velocity = [](Spot<2> const& X) { return Spot<2>{0, 0.2 * X[0] * (0.3 - X[1])}; };
  MediumOnMesh<2> body(block(), rubber(), start, {.step = 0.02},
                       {{"left", {Side::fixed, {}}}, {"top", {Side::sliding, {}}}});
  auto const before = body.places(), rates = body.velocities();
  body.step(200);
  auto const x = body.places();
  bool slid = false;
  for (auto const& facet : body.mesh().sides.at("top"))
    for (std::size_t const k : {facet[0], facet[1]}) {
      BOOST_TEST(std::abs(x[k][1] - before[k][1]) <= 1e-14);
      slid = slid || std::abs(x[k][0] - before[k][0]) > 1e-3;
    }
  BOOST_TEST(slid);
  for (auto const& facet : body.mesh().sides.at("left"))
    for (std::size_t const k : {facet[0], facet[1]})
      BOOST_TEST(std::abs(x[k][1] - before[k][1] - rates[k][1] * body.time()) <= 1e-13);
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_is_refused_by_name) {
  auto const with = [](BodySides<2> const& sides, BodyLoads<2> const& loads = {}) {
    return message_of([&] { MediumOnMesh<2>(block(), rubber(), {}, {.step = 0.01}, sides, loads); });
  };
  says(with({{"rihgt", {Side::fixed, {}}}}), "did you mean 'right'?");
  BodyLoads<2> loads;
  loads.tractions["middle"] = {1, 0};
  says(with({}, loads), "bottom, left, right, top");
  loads = {}, loads.tractions["left"] = {NAN, 0};
  says(with({}, loads), "traction on side 'left'");
  says(
      message_of([] {
        MediumOnMesh<2>(disc_mesh(1, {1, 2}), rubber(), {}, {.step = 0.01}, {{"outer", {Side::sliding, {}}}});
      }),
      "plane");
  says(message_of([] { MediumOnMesh<2>(block(), rubber(), {}, {.step = 0.01, .order = 3}); }), "2 or 4");
  says(message_of([] { MediumOnMesh<3>(block(), stored_energy<3>(neo_hookean(1, 1)), {}, {.step = 0.01}); }),
       "dimension");
  says(message_of([] {
         BodyStart<2> start;
         start.density = [](Spot<2> const& X) { return X[0]; };
         MediumOnMesh<2>(block(), rubber(), start, {.step = 0.01});
       }),
       "density");
}

// A hill whose slope is no number beyond x = 1.2: the node that comes there is named, and the state is that
// before the step.
BOOST_AUTO_TEST_CASE(a_potential_that_is_not_finite_is_refused_with_the_node_and_the_state_before) {
  BodyLoads<2> loads;
  loads.potentials.push_back(space_potential<2>([](auto const& x) {
    using std::sqrt;
    return sqrt(1.2 - x[0]) * 0.1;
  }));
  BodyStart<2> start;
  start.velocity = [](Spot<2> const&) { return Spot<2>{1, 0}; };
  MediumOnMesh<2> body(block(), rubber(), start, {.step = 0.01}, {}, loads);
  says(message_of([&] { body.step(1000); }), "potential at node");
  long const reached = body.steps();
  BOOST_TEST(reached > 10);
  auto const state = body.remember();
  says(message_of([&] { body.step(); }), "potential at node");
  BOOST_TEST((state == body.remember()));
}

// St Venant and Kirchhoff's solid does not resist collapse.
BOOST_AUTO_TEST_CASE(a_cell_about_to_turn_inside_out_is_refused_with_a_step_that_would_do) {
  BodyStart<2> start;
  start.velocity = [](Spot<2> const& X) { return Spot<2>{X[0] < 0 ? 1.5 : -1.5, 0}; };
  auto const law = stored_energy<2>(FastStVenantKirchhoff{0.3, 0.2});
  for (Conserve const conserve : {Conserve::form, Conserve::energy}) {
    MediumOnMesh<2> body(block(), law, start, {.step = 0.05, .conserve = conserve});
    try {
      body.step(1000);
      BOOST_FAIL("no cell was found inside out");
    } catch (BodyCellInverts const& error) {
      BOOST_TEST(error.step == body.steps() + 1);
      BOOST_TEST(error.measured <= 0);
      auto const J = body.jacobians();
      BOOST_TEST(*std::min_element(J.begin(), J.end()) > 0);
      BOOST_TEST((error.would_do > 0 && error.would_do < 0.05));
      // The step that would do does.
      BodyStart<2> here = start;
      MediumOnMesh<2> other(block(), law, here, {.step = error.would_do, .conserve = conserve});
      auto state = body.remember();
      state[0] = 0;
      other.restore(state), other.step();
      BOOST_TEST(other.steps() == 1);
    } catch (BodyStepUnsolved const& error) {
      // Or the equation of the step has no solution any more.
      BOOST_TEST((conserve == Conserve::energy));
      auto const J = body.jacobians();
      BOOST_TEST(error.jacobian == *std::min_element(J.begin(), J.end()));
      BOOST_TEST(error.jacobian == J[error.cell]);
      BOOST_TEST(error.jacobian > 0);
      BOOST_TEST(!(error.residual <= error.bound));
    }
  }
}

// With order 4 and a side that moves: the bits of a run that was interrupted are those of one that was not.
BOOST_AUTO_TEST_CASE(a_state_that_was_remembered_goes_on_bit_for_bit) {
  auto const chi = []<class T>(Spot<2> const& X, T const& t) {
    using std::sin;
    return std::array<T, 2>{sin(t) * 0.1 + 1.1 * X[0] + 0.1 * X[1] * X[1], T(X[1])};
  };
  BodyLoads<2> loads;
  loads.pressures["top"] = [](double t) { return 0.1 * t; };
  for (Conserve const conserve : {Conserve::form, Conserve::energy}) {
    auto const made = [&] {
      return MediumOnMesh<2>(block(), rubber(), bent(), {.step = 0.03, .order = 4, .conserve = conserve},
                             {{"left", {Side::moved, prescribed_motion<2>(chi)}}}, loads);
    };
    auto whole = made(), first = made(), second = made();
    whole.step(25), first.step(11);
    second.restore(first.remember()), second.step(14);
    BOOST_TEST((whole.remember() == second.remember()));
    BOOST_TEST(whole.time() == second.time());
    says(message_of([&] { whole.restore({1, 2, 3}); }), "remembered");
  }
}

BOOST_AUTO_TEST_SUITE_END()
