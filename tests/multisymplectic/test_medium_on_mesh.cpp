// The generic implementation of media on meshes: held to the optimised implementation, and what it says of
// itself.
#include <boost/test/unit_test.hpp>

#include "actio/fast_media/fast_medium_2d.hpp"
#include "actio/media_on_meshes/medium_on_mesh.hpp"
#include "plain_body.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::media;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
using Plane2 = std::array<double, 2>;

Plane2 bent(Plane2 const& X) { return {X[0] + 0.03 * X[0] * X[1], X[1] - 0.02 * X[0] * X[0]}; }
Plane2 turning(Plane2 const& X) { return {0.1 * X[1], 0.2 - X[0] * X[1]}; }
BodyStart<2> thrown() {
  BodyStart<2> start;
  start.density = [](Plane2 const&) { return 1.7; };
  start.placement = bent, start.velocity = turning;
  return start;
}

/// Seven by five cells, thirty steps by both ways.
template <class Medium>
void ways_agree(Medium const& medium, std::array<Side, 2> across, std::array<Side, 2> up) {
  int const n = 7, m = 5, steps = 30;
  double const h1 = 0.1, h2 = 0.13, dt = 0.01;
  FastMedium2d<Medium> fast(medium, {{n, m}, {h1, h2}, across, up}, dt, 1.7, bent, turning);
  BodySides<2> sides;
  char const* const names[4] = {"left", "right", "bottom", "top"};
  for (int k = 0; k < 4; ++k) {
    Side const side = (k < 2 ? across : up)[k % 2];
    if (side != Side::free) sides[names[k]] = {side, {}};
  }
  MediumOnMesh<2> body(box_mesh({0, 0}, {n * h1, m * h2}, {n, m}), stored_energy<2>(medium), thrown(),
                       {.step = dt}, sides);
  fast.step(steps), body.step(steps);
  auto const x = fast.places(), y = body.places();
  double worst = 0;
  for (std::size_t k = 0; k < x.size(); ++k)
    worst = std::max(worst, std::hypot(x[k][0] - y[k][0], x[k][1] - y[k][1]));
  // Each step rounds places below 1 and 100 times a kick, dt^2 times a modulus below 2 over h; what a step is
  // off goes on as a velocity.
  double const a_step = eps * (2 + 100 * dt * dt * 2 / (h1 * h1));
  BOOST_TEST(worst <= a_step * steps * (steps + 1) / 2);
  BOOST_TEST_MESSAGE("the generic implementation and the optimised implementation differ by " << worst);
  // Where nothing is held both have the angular momentum of the start.
  if (sides.empty())
    BOOST_TEST(body.angular_momentum()[2] == fast.angular_momentum(), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(body.largest_step() == fast.largest_step(), boost::test_tools::tolerance(0.01));
  // Energies are those of the same places and velocities.
  BOOST_TEST(body.energies().stored + body.energies().kinetic == fast.energy(),
             boost::test_tools::tolerance(1e-12));
}
}  // namespace

namespace {
using testing::Spot;

/// A body of a sample that is where its nodes are and moves as they do.
template <int d>
MediumOnMesh<d> body_of(testing::Sample const& s, BodyStepping const& stepping) {
  auto const at = [&s](std::vector<double> const& of) {
    return [&s, &of](Spot<d> const& X) {
      Spot<d> out{};
      for (std::size_t k = 0; k < s.mesh.nodes.size(); ++k)
        if (std::equal(X.begin(), X.end(), s.mesh.nodes[k].begin()))
          std::copy_n(of.data() + k * d, d, out.begin());
      return out;
    };
  };
  BodyStart<d> start;
  start.density = [](Spot<d> const& X) { return testing::density_at(X); };
  start.placement = at(s.x), start.velocity = at(s.u);
  return {s.mesh, stored_energy<d>(Weighed{testing::Fibred{}, 2.0}), start, stepping};
}
template <int d>
std::vector<double> flat(std::vector<Spot<d>> const& places) {
  std::vector<double> out;
  for (auto const& one : places) out.insert(out.end(), one.begin(), one.end());
  return out;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(medium_on_mesh)

BOOST_AUTO_TEST_CASE(on_boxes_of_the_plane_both_ways_are_the_same_to_rounding) {
  using enum Side;
  for (auto const& [across, up] : {std::pair{std::array{free, free}, std::array{free, free}},
                                   {{fixed, free}, {sliding, free}},
                                   {{sliding, sliding}, {free, fixed}}}) {
    ways_agree(FastFluid{PolytropicByRoots<1, 2>{0.2}}, across, up);
    ways_agree(FastStVenantKirchhoff{0.9, 0.6}, across, up);
    ways_agree(neo_hookean(0.9, 0.6), across, up);
  }
}

BOOST_AUTO_TEST_CASE(a_step_that_is_set_before_the_first_one_is_that_of_the_beginning) {
  auto const made = [](double step) {
    return MediumOnMesh<2>(box_mesh({0, 0}, {1, 1}, {3, 3}), stored_energy<2>(neo_hookean(0.9, 0.6)),
                           thrown(), {.step = step});
  };
  auto one = made(0.01), other = made(1);
  other.set_time_step(0.01);
  one.step(5), other.step(5);
  BOOST_TEST((one.remember() == other.remember()));
  BOOST_TEST(other.time() == 0.05);
  CHECK_REFUSED(other.set_time_step(0.02), OutsideDomain);
  CHECK_REFUSED(made(1).set_time_step(-1), OutsideDomain);
}

// As people know them: by their places in a box, otherwise by numbers.
BOOST_AUTO_TEST_CASE(cells_have_the_names_of_the_fast_way) {
  auto const box = box_mesh({0, 0, 0}, {1, 1, 1}, {4, 3, 2});
  BOOST_TEST(box.cell_name(0) == "cell (0, 0, 0)");
  BOOST_TEST(box.cell_name(3 + 4 * (2 + 3 * 1)) == "cell (3, 2, 1)");
  BOOST_TEST(box_mesh({0}, {1}, {4}).cell_name(2) == "cell 2");
  BodyStart<2> start;
  start.placement = [](Plane2 const& X) { return Plane2{X[0] == 1 && X[1] == 2 ? 5.0 : X[0], X[1]}; };
  auto const says = [](Error const& error) {
    return std::string(error.what()).find("cell (1, 1) is inside out at the start") != std::string::npos;
  };
  auto const law = neo_hookean(0.9, 0.6);
  BOOST_CHECK_EXCEPTION(
      MediumOnMesh<2>(box_mesh({0, 0}, {3, 3}, {3, 3}), stored_energy<2>(law), start, {.step = 0.01}),
      BodyCellInverts, says);
  BOOST_CHECK_EXCEPTION(
      FastMedium2d(law, FastBox2d{{3, 3}, {1, 1}}, 0.01, 1, start.placement, start.velocity), CellInverts,
      says);
}

// On meshes and motions without any symmetry. Numbers below 30 are sums of some tens of terms, each of them
// rounded some ten times.
BOOST_AUTO_TEST_CASE(what_a_body_says_of_itself_is_what_its_cells_have) {
  testing::on_every_shape([]<int d>(testing::Sample const& s) {
    using Square = Matrix<double, d, d>;
    double const bound = 30 * 300 * eps;
    auto const body = body_of<d>(s, {.step = 0.01});
    testing::PlainBody<d> const plain{s.mesh};
    auto const m = plain.masses(), J = body.jacobians(), p = body.pressures(), w = body.energy_densities();
    auto const stresses = body.cauchy_stresses();
    for (int cell = 0; cell < int(s.mesh.cells.size()); ++cell) {
      double least = HUGE_VAL, stored = 0, volume = 0, trace = 0;
      Square stress = Square::Zero();
      for (int k = 0; k < plain.points; ++k) {
        Square const F = plain.gradient(s.x, cell, k), P = derivative(testing::Fibred{}, F).gradient();
        double const here = plain.volume(cell, k), weight = plain.weight(cell, k), det = small_determinant(F);
        least = std::min(least, det), volume += here, stored += weight * testing::Fibred{}(F);
        stress += P * F.transpose() * (weight / here / det / plain.points);
      }
      for (int a = 0; a < d; ++a) trace += stress(a, a);
      BOOST_TEST(std::abs(J[cell] - least) <= bound);
      BOOST_TEST(magnitude(Square(stresses[cell] - stress)) <= bound);
      BOOST_TEST(std::abs(p[cell] + trace / d) <= bound);
      BOOST_TEST(std::abs(w[cell] - stored / volume) <= bound);
    }
    double kinetic = 0;
    Spot<d> momentum{};
    Spot<3> spin{};
    for (std::size_t k = 0; k < m.size(); ++k) {
      Spot<3> x{}, v{};
      for (std::size_t a = 0; a < d; ++a) {
        x[a] = s.x[k * d + a], v[a] = s.u[k * d + a];
        kinetic += m[k] * v[a] * v[a] / 2, momentum[a] += m[k] * v[a];
      }
      spin[0] += m[k] * (x[1] * v[2] - x[2] * v[1]), spin[1] += m[k] * (x[2] * v[0] - x[0] * v[2]);
      spin[2] += m[k] * (x[0] * v[1] - x[1] * v[0]);
    }
    BOOST_TEST(std::abs(body.energies().kinetic - kinetic) <= bound);
    BOOST_TEST(std::abs(body.energies().stored - plain.energy(s.x)) <= bound);
    BOOST_TEST(testing::apart({spin.begin(), spin.end()}, flat<3>({body.angular_momentum()})) <= bound);
    BOOST_TEST(testing::apart(flat<d>({momentum}), flat<d>({body.momentum()})) <= bound);
    BOOST_TEST(body.numbers_of_state() == body.remember().size());
    // A state and its copy of four numbers, forces and their copy, an acceleration, and displacements with
    // the places that they are from; hexahedra have a correction each.
    bool const corrected = d == 3 && !plain.simplex;
    std::size_t const per_cell = plain.points * sizeof(CellPoint<d>) + plain.corners * sizeof(int) +
                                 (corrected ? sizeof(CornerCorrection<double, d>) : 0),
                      all = s.mesh.bytes() + s.mesh.cells.size() * per_cell + m.size() * sizeof(double) +
                            (s.mesh.wraps.empty() ? 0 : s.mesh.cells.size() * plain.corners) +
                            14 * s.x.size() * sizeof(double);
    BOOST_TEST(body.bytes() == all);
    // With viscosity two copies of its forces, one of velocities, and the masses of the points.
    BOOST_TEST(body_of<d>(s, {.step = 0.01, .viscosity = {1, 1}}).bytes() ==
               all + (3 * s.x.size() + s.mesh.cells.size() * plain.points) * sizeof(double));
  });
}

// v += h/2 a, x += h v, v += h/2 a by hand; and the frequencies of small motions by the powers of the matrix.
BOOST_AUTO_TEST_CASE(a_step_is_that_of_its_formula_and_the_longest_one_that_of_the_largest_frequency) {
  testing::on_every_shape([]<int d>(testing::Sample const& s) {
    double const h = 0.01;
    auto body = body_of<d>(s, {.step = h});
    testing::PlainBody<d> const plain{s.mesh};
    auto const m = plain.masses();
    auto const acceleration = [&](auto const& x) {
      auto a = plain.forces(x);
      for (std::size_t k = 0; k < a.size(); ++k) a[k] = a[k] / m[k / d];
      return a;
    };
    // The rate at which forces fall is held to the energy in test_body_forces.cpp.
    BodyForces<d> const forces(s.mesh, stored_energy<d>(Weighed{testing::Fibred{}, 2.0}),
                               [](Spot<d> const& X) { return testing::density_at(X); }, {});
    auto u = s.u, rate = u;
    double frequency = 0;
    for (int k = 0; k < 400; ++k) {
      forces.stiffness(s.x, u, rate);
      double square = 0, work = 0;
      for (std::size_t i = 0; i < u.size(); ++i)
        square += m[i / d] * u[i] * u[i], work += u[i] * rate[i], rate[i] /= m[i / d];
      frequency = std::sqrt(work / square);
      for (std::size_t i = 0; i < u.size(); ++i) u[i] = rate[i] / (work / square);
    }
    // From above within a per cent.
    double const longest = body.largest_step() * frequency / 2,
                 of_order_four = body_of<d>(s, {.step = h, .order = 4}).largest_step() * frequency / 2;
    double const substep = 4 / (4 - std::cbrt(4.0)) - 1;
    BOOST_TEST_CONTEXT(name_of(s.mesh.shape) << "s, periodic: " << !s.mesh.wraps.empty()) {
      BOOST_TEST((longest > 1 - 1e-6 && longest < 1.01));
      BOOST_TEST((of_order_four * substep > 1 - 1e-6 && of_order_four * substep < 1.01));
      auto v = testing::plus(s.u, acceleration(s.x), h / 2);
      auto const x = testing::plus(s.x, v, h);
      v = testing::plus(v, acceleration(x), h / 2);
      body.step();
      double const bound = 30 * 100 * eps;
      BOOST_TEST(testing::apart(flat<d>(body.places()), x) <= bound);
      BOOST_TEST(testing::apart(flat<d>(body.velocities()), v) <= bound);
      BOOST_TEST(body.time() == h);
    }
  });
}

BOOST_AUTO_TEST_SUITE_END()
