// Asynchronous steps of a string against a plain loop over its events, the longest steps of its cells in
// closed form, and what is refused with which numbers.
#include <boost/test/unit_test.hpp>

#include "actio/multisymplectic/asynchronous_steps.hpp"
#include "refused.hpp"
#include "refuses.hpp"
#include "witness/draw.hpp"

using namespace actio;
using namespace actio::media;
using testing::refuses;

namespace {
using Spot = Matrix<double, 2, 1>;

/// A string in the plane with a mass density that grows, \f$k/4\,(|F|^2-1)^2\f$, and weight.
struct String {
  double k = 3, g = 0.7;
  template <class T>
  T operator()(Jet<T, 1, 2> const& j) const {
    T const strain = j.gradient().squaredNorm() - T(1), rho = j.x[1] * 0.5 + T(1);
    return rho * (j.velocity().squaredNorm() * 0.5 - j.y[1] * g) - strain * strain * (k / 4);
  }
};
/// Cells of different lengths: nodes at 0, 0.5, 0.8, 1.8.
BodyMesh line() {
  auto mesh = box_mesh({0}, {1}, {3});
  double const at[] = {0, 0.5, 0.8, 1.8};
  for (std::size_t k = 0; k < 4; ++k) mesh.nodes[k][0] = at[k];
  return mesh;
}
/// The forces of a cell on its ends by hand, at given places.
std::array<Spot, 2> forces_by_hand(BodyMesh const& mesh, int cell, std::vector<Spot> const& y) {
  double const a = mesh.nodes[cell][0], b = mesh.nodes[cell + 1][0];
  Spot const F = (y[cell + 1] - y[cell]) / (b - a), pull = F * (3 * (F.squaredNorm() - 1));
  Spot const down(0.0, 0.7 * (b - a) / 2);
  return {Spot(pull - down * (1 + 0.5 * a)), Spot(-pull - down * (1 + 0.5 * b))};
}
struct State {
  std::vector<Spot> y, v;
  std::vector<double> mass;
};
State start(BodyMesh const& mesh) {
  State s;
  for (int k = 0; k < 4; ++k) {
    double const X = mesh.nodes[k][0];
    s.y.emplace_back(1.1 * X, 0.1 * X * X), s.v.emplace_back(0.2 - 0.1 * X, 0.3 * X);
    double const left = k > 0 ? X - mesh.nodes[k - 1][0] : 0, right = k < 3 ? mesh.nodes[k + 1][0] - X : 0;
    s.mass.push_back((left + right) / 2 * (1 + 0.5 * X));
  }
  return s;
}
std::vector<double> const steps{0.05, 0.03, 0.11};
std::vector<unsigned> const held{3, 0, 0, 2};

}  // namespace

BOOST_AUTO_TEST_SUITE(asynchronous_line)

BOOST_AUTO_TEST_CASE(events_are_those_of_a_plain_loop) {
  auto const mesh = line();
  auto s = start(mesh);
  auto run = asynchronous_steps<1>(String{}, mesh, steps, s.y, s.v, held);
  for (int node = 0; node < 4; ++node) BOOST_TEST(std::abs(run.mass(node) - s.mass[node]) < 1e-15);
  // All events by time, of one time by cell; all nodes go on from one to the next.
  std::vector<std::pair<double, int>> events;
  std::vector<long> count(3, 0);
  for (int cell = 0; cell < 3; ++cell)
    for (int k = 0; k * steps[cell] < 1; ++k) events.emplace_back(k * steps[cell], cell);
  std::sort(events.begin(), events.end());
  double now = 0;
  for (auto const& [time, cell] : events) {
    for (int node = 0; node < 4; ++node) s.y[node] += s.v[node] * (time - now);
    now = time;
    double const weight = count[cell]++ == 0 ? steps[cell] / 2 : steps[cell];
    auto const f = forces_by_hand(mesh, cell, s.y);
    for (int end = 0; end < 2; ++end)
      for (int a = 0; a < 2; ++a)
        if (!(held[cell + end] >> a & 1)) s.v[cell + end][a] += f[end][a] * weight / s.mass[cell + end];
    auto const event = run.step();
    BOOST_TEST((event.cell == cell && event.time == time && event.weight == weight));
    BOOST_TEST((run.corners(cell)[0] == cell && run.corners(cell)[1] == cell + 1));
    for (int node = 0; node < 4; ++node) {
      // Some ten roundings of numbers below four in each event.
      double const bound = 40 * double(events.size()) * epsilon<double>();
      BOOST_TEST(magnitude(Spot(run.place(node, time) - s.y[node])) <= bound);
      BOOST_TEST(magnitude(Spot(run.velocity(node) - s.v[node])) <= bound);
    }
  }
  BOOST_TEST(run.events() == long(events.size()));
  // Velocities at a time: the last kick of a cell counts for half a step to either side of it.
  double const t = now + 0.004;
  for (int node = 0; node < 4; ++node) s.y[node] += s.v[node] * (t - now);
  double energy = 0;
  auto v = s.v;
  for (int cell = 0; cell < 3; ++cell) {
    auto const f = forces_by_hand(mesh, cell, s.y);
    double const last = (double(count[cell]) - 1) * steps[cell], ahead = last + steps[cell] / 2 - t;
    for (int end = 0; end < 2; ++end)
      for (int a = 0; a < 2; ++a)
        if (!(held[cell + end] >> a & 1)) v[cell + end][a] -= f[end][a] * ahead / s.mass[cell + end];
    double const l = mesh.nodes[cell + 1][0] - mesh.nodes[cell][0],
                 strain = (s.y[cell + 1] - s.y[cell]).squaredNorm() / (l * l) - 1;
    energy += l * 3 / 4 * strain * strain;
  }
  for (int node = 0; node < 4; ++node)
    energy += s.mass[node] * (v[node].squaredNorm() / 2 + 0.7 * s.y[node][1]);
  auto const found = run.velocities(t);
  double const bound = 80 * double(events.size()) * epsilon<double>();
  for (int node = 0; node < 4; ++node) BOOST_TEST(magnitude(Spot(found[node] - v[node])) <= bound);
  BOOST_TEST(std::abs(run.energy(t) - energy) <= 4 * bound);
  auto const fresh = asynchronous_steps<1>(String{}, mesh, steps, start(mesh).y, start(mesh).v, held);
  BOOST_TEST((fresh.velocities(0) == start(mesh).v));
}

BOOST_AUTO_TEST_CASE(a_run_ends_with_the_events_at_its_time) {
  auto const s = start(line());
  auto run = asynchronous_steps<1>(String{}, line(), {0.03125, 0.0625, 0.0625}, s.y, s.v);
  run.run(0.0625);
  BOOST_TEST(run.events() == 3 + 2 + 2);
  BOOST_TEST(run.next().time == 0.09375);
  BOOST_TEST(run.next().weight == 0.03125);
  CHECK_REFUSED(run.run(HUGE_VAL), NotFinite);
}

// A stretched string is stiff along and across itself, k (3 s^2 - 1) and k (s^2 - 1) over the length, and the
// masses of its ends add as 1/m: the root of the trace of the 64th power has both.
BOOST_AUTO_TEST_CASE(the_longest_steps_of_a_string_are_known) {
  auto const mesh = line();
  std::vector<Spot> y;
  for (auto const& X : mesh.nodes) y.emplace_back(0.6 * 1.2 * X[0], 0.8 * 1.2 * X[0]);
  auto const longest = longest_steps<1, 2>(String{}, mesh, y);
  for (int cell = 0; cell < 3; ++cell) {
    double const a = mesh.nodes[cell][0], b = mesh.nodes[cell + 1][0], l = b - a;
    double const mobility = (1 / (1 + 0.5 * a) + 1 / (1 + 0.5 * b)) * 2 / l;
    double const along = 3 * (3 * 1.44 - 1) / l * mobility, across = 3 * 0.44 / l * mobility;
    double const square = along * std::pow(1 + std::pow(across / along, 64), 1.0 / 64);
    BOOST_TEST(std::abs(longest[cell] * std::sqrt(square) / 2 - 1) <= 100 * epsilon<double>());
  }
  auto const limp = longest_steps<1, 2>(String{0, 0.7}, mesh, y);
  for (double const one : limp) BOOST_TEST(one == HUGE_VAL);
  // A step of just that length is taken, and the next number is not.
  auto const made = [&](std::vector<double> const& h) {
    return asynchronous_steps<1>(String{}, mesh, h, y, y);
  };
  BOOST_CHECK_NO_THROW(made(longest));
  auto longer = longest;
  longer[1] = std::nextafter(longest[1], 1.0);
  refuses<StepTooLong>([&] { made(longer); }, longer[1], longest[1], "cell 1");
  longer[1] = 0;
  refuses<OutsideDomain>([&] { made(longer); }, 0, 0, "cell 1: a step is a positive number");
  refuses<OutsideDomain>([&] { made({0.01, 0.01}); }, 2, 3, "each cell has its entry");
  auto three = y;
  three.pop_back();
  refuses<OutsideDomain>([&] { asynchronous_steps<1>(String{}, mesh, longest, three, y); }, 3, 4,
                         "each node has its entry");
  refuses<OutsideDomain>([&] { asynchronous_steps<1>(String{}, mesh, longest, y, three); }, 3, 4,
                         "each node has its entry");
  refuses<OutsideDomain>([&] { asynchronous_steps<1>(String{}, mesh, longest, y, y, {1}); }, 1, 4,
                         "each node has its entry");
}

/// A tetrahedron whose edges have no symmetry, in a mesh of one cell.
BodyMesh tetrahedron() {
  BodyMesh mesh;
  mesh.dimension = 3, mesh.shape = CellShape::tetrahedron, mesh.cells = {{0, 1, 2, 3}};
  mesh.nodes = {{0.1, 0.2, -0.1}, {1.2, 0.3, 0.1}, {0.2, 1.1, 0.2}, {-0.1, 0.4, 0.9}};
  return mesh;
}
struct Everything {
  template <class T>
  T operator()(Jet<T, 3, 2> const& j) const {
    return j.v(0, 1) * j.v(1, 3) * j.x[2] + j.v(1, 2) * j.v(1, 2) * j.y[0] * j.x[0] -
           j.y[1] * j.y[0] * j.x[3] + (j.v(0, 0) * j.v(0, 0) + j.v(1, 0) * j.v(1, 0)) * (j.x[1] + 2.0) * 0.5;
  }
};

BOOST_AUTO_TEST_CASE(forces_on_the_corners_of_a_simplex_are_the_derivatives_of_what_it_stores) {
  auto const mesh = tetrahedron();
  auto const cell = simplex_geometry<3>(mesh, 0);
  // The functions that are 1 at a corner and 0 at the others, and an n! (n+1)th of the parallelepiped.
  for (int c = 1; c < 4; ++c)
    for (int b = 0; b < 4; ++b) {
      double value = 0;
      for (int i = 0; i < 3; ++i) value += cell.gradients(c - 1, i) * (mesh.nodes[b][i] - mesh.nodes[0][i]);
      BOOST_TEST(std::abs(value - (b == c)) <= 30 * epsilon<double>());
    }
  BOOST_TEST(std::abs(cell.volume - corner_jacobian(mesh, 0, 0).volume / 24) <= 8 * epsilon<double>());
  Draw draw(8);
  Matrix<double, 2, 4> y;
  for (int k = 0; k < 8; ++k) y.data()[k] = draw.number<double>();
  double stored = 0;
  for (int b = 0; b < 4; ++b) {
    auto const j = jet_at_rest(cell, 0.7, y, b);
    BOOST_TEST(j.x[0] == 0.7);
    stored -= Everything{}(j)*cell.volume;
    BOOST_TEST(std::abs(mass_of_corner<2>(Everything{}, cell, y, b) - (2 + mesh.nodes[b][0]) * cell.volume) <=
               8 * epsilon<double>());
  }
  BOOST_TEST(std::abs(stored_energy(Everything{}, cell, 0.7, y) - stored) <= 30 * epsilon<double>());
  auto const f = forces_on_corners(Everything{}, cell, 0.7, y);
  for (int k = 0; k < 8; ++k) {
    auto moved = Matrix<Dual<double>, 2, 4>(y.cast<Dual<double>>());
    moved.data()[k] = variable(y.data()[k]);
    BOOST_TEST(std::abs(f.data()[k] + rate_of(stored_energy(Everything{}, cell, 0.7, moved))) <=
               100 * epsilon<double>());
  }
}

BOOST_AUTO_TEST_CASE(masses_that_are_none_and_cells_that_are_no_simplices_are_refused) {
  auto const mesh = line();
  auto const cell = simplex_geometry<1>(mesh, 1);
  Matrix<double, 2, 2> y;
  y << 0, 1, 0, 0.2;
  // Momentum M v with a matrix M of the body.
  auto const with = [&](double a, double b, double c) {
    return [=] {
      mass_of_corner<2>(
          [=]<class T>(Jet<T, 1, 2> const& j) -> T {
            return j.v(0, 0) * j.v(0, 0) * (a / 2) + j.v(0, 0) * j.v(1, 0) * b +
                   j.v(1, 0) * j.v(1, 0) * (c / 2);
          },
          cell, y, 1);
    };
  };
  double const eps = epsilon<double>();
  BOOST_CHECK_NO_THROW(with(2, 0, 2)());
  BOOST_CHECK_NO_THROW(with(2, 100 * eps, 2)());
  refuses<OutsideDomain>(with(2, 0, 2.5), 0.5, 128 * eps, "mass at x = (0.8)");
  refuses<OutsideDomain>(with(2, -0.25, 2), 0.25, 128 * eps, "mass at x = (0.8)");
  refuses<OutsideDomain>(with(0, 0, 0), 0, 0, "mass at x = (0.8)");
  refuses<OutsideDomain>(with(-1, 0, -1), 0, -64 * eps, "mass at x = (0.8)");
  refuses<NotABodyMesh>(
      [] {
        simplex_geometry<2>(box_mesh({0, 0}, {1, 1}, {1, 1}), 0);
      },
      4, 3, "quadrilaterals");
  refuses<NotABodyMesh>([&] { simplex_geometry<2>(tetrahedron(), 0); }, 4, 3, "tetrahedrons");
  refuses<NotABodyMesh>([] { simplex_geometry<1>(box_mesh({0}, {1}, {3}, {true}), 0); }, 2, 2, "segments");
}

BOOST_AUTO_TEST_SUITE_END()
