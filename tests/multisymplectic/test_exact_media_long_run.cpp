// The generic implementation of media against exact solutions: simple waves oblique to meshes of triangles
// and of hexahedra, gas that expands into vacuum, a disc that is deformed alike everywhere, and waves of
// which the discrete equations have a closed solution; then momenta over many steps.
#include <boost/test/unit_test.hpp>

#include "acoustic.hpp"
#include "actio/media_on_meshes/medium_on_mesh.hpp"
#include "actio/meshes/body_shapes.hpp"
#include "simple_wave.hpp"

using namespace actio;
using namespace actio::media;

namespace {
template <int d>
using Spot = std::array<double, d>;
template <int d>
using Square = Matrix<double, d, d>;

/// The same mesh with each quadrilateral cut into two triangles.
BodyMesh cut(BodyMesh mesh) {
  BodyMesh out = mesh;
  out.shape = BodyMesh::Shape::triangle;
  out.cells.clear(), out.wraps.clear(), out.sides.clear();
  for (std::size_t k = 0; k < mesh.cells.size(); ++k)
    for (auto const& corners : {std::array{0, 1, 3}, {0, 3, 2}}) {
      out.cells.push_back({}), out.wraps.push_back({});
      for (std::size_t b = 0; b < 3; ++b) {
        out.cells.back()[b] = mesh.cells[k][static_cast<std::size_t>(corners[b])];
        out.wraps.back()[b] = mesh.wraps[k][static_cast<std::size_t>(corners[b])];
      }
    }
  return out;
}
template <int d>
auto linear(Square<d> const& A) {
  return [A](Spot<d> const& X) {
    Spot<d> y{};
    for (int i = 0; i < d; ++i)
      for (int j = 0; j < d; ++j) y[i] += A(i, j) * X[j];
    return y;
  };
}
/// The largest distance of a node from where it should be, and the root of the mean square by mass.
struct Distance {
  double largest = 0, mean = 0;
};
template <int d, class Exact>
Distance distance(MediumOnMesh<d> const& body, Exact const& exact) {
  Distance out;
  double mass = 0;
  auto const x = body.places();
  for (std::size_t k = 0; k < x.size(); ++k) {
    Spot<d> X;
    for (std::size_t a = 0; a < d; ++a) X[a] = body.mesh().nodes[k][a];
    Spot<d> const y = exact(X);
    double square = 0;
    for (std::size_t a = 0; a < d; ++a) square += (x[k][a] - y[a]) * (x[k][a] - y[a]);
    out.largest = std::max(out.largest, std::sqrt(square));
    out.mean += body.masses()[k] * square, mass += body.masses()[k];
  }
  out.mean = std::sqrt(out.mean / mass);
  return out;
}
/// Calls error(n) for each n, and holds the slopes to 2.
template <class Error>
void has_order_two(char const* name, std::vector<int> const& sizes, Error const& error_on) {
  double before = 0;
  for (int const n : sizes) {
    double const error = error_on(n);
    if (before > 0) {
      double const order = std::log2(before / error);
      BOOST_TEST_MESSAGE(name << ", " << n << ": error " << error << ", order " << order);
      BOOST_TEST(std::abs(order - 2) <= 0.05);
    }
    before = error;
  }
}
/// A simple wave at time 0.125 on a periodic mesh with n cells to a unit of length.
template <int d>
double wave_error(typename MediumOnMesh<d>::Law const& law, testing::SimpleWave<d> const& wave,
                  BodyMesh const& mesh, int n) {
  double const time = 0.125;
  BodyStart<d> start;
  start.placement = [&](Spot<d> const& X) { return wave.at(X, 0); };
  start.velocity = [&](Spot<d> const& X) { return wave.velocity_at(X); };
  MediumOnMesh<d> body(mesh, law, start, {.step = time / (n / 2)});
  body.step(n / 2);
  return distance(body, [&](Spot<d> const& X) { return wave.at(X, time); }).largest;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(exact_media)

BOOST_AUTO_TEST_CASE(oblique_simple_waves_on_triangles_have_order_two) {
  double const root = std::sqrt(5.0);
  Spot<2> const n{2 / root, 1 / root};
  auto const on = [](int cells) { return cut(box_mesh({0, 0}, {1, 1}, {cells, cells}, {true, true})); };
  testing::SimpleWave<2> const in_gas{[](double q) { return std::pow(q, -1.5); }, n, 1 / root, 0.02};
  auto const gas = stored_energy<2>(FastFluid{PolytropicByRoots<1, 2>{0.5}});
  has_order_two("gas on triangles, gamma 2", {24, 48, 96, 192, 384},
                [&](int cells) { return wave_error<2>(gas, in_gas, on(cells), cells); });
}

// Oblique in the plane of the first and the third direction.
BOOST_AUTO_TEST_CASE(oblique_simple_waves_on_hexahedra_have_order_two) {
  double const root = std::sqrt(2.0);
  Spot<3> const n{1 / root, 0, 1 / root};
  auto const on = [](int cells) {
    return box_mesh({0, 0, 0}, {1, 2.0 / cells, 1}, {cells, 2, cells}, {true, true, true});
  };
  testing::SimpleWave<3> const wave{
      [](double q) { return std::sqrt(0.2 + (0.8 - 0.6 * std::log(q)) / (q * q)); }, n, 1 / root, 0.02};
  auto const solid = stored_energy<3>(neo_hookean(0.6, 0.2));
  has_order_two("neo-Hookean on hexahedra", {12, 24, 48, 96, 192},
                [&](int cells) { return wave_error<3>(solid, wave, on(cells), cells); });
}

namespace {
/// Affine motion of a polytropic gas into vacuum: \f$A'' = b\,(\det A)^{1-\gamma}A^{-T}\f$ by Runge and
/// Kutta's classical step, so short that its error is below 1e-12.
template <int d>
std::pair<Square<d>, Square<d>> expanded(Square<d> A, Square<d> V, double b, double gamma, double time) {
  int const steps = 2000;
  double const h = time / steps;
  auto const rate = [&](Square<d> const& a) -> Square<d> {
    return inverse_matrix(a).transpose() * (b * std::pow(small_determinant(a), 1 - gamma));
  };
  for (int k = 0; k < steps; ++k) {
    Square<d> const k1 = V, l1 = rate(A), k2 = V + l1 * (h / 2), l2 = rate(A + k1 * (h / 2)),
                    k3 = V + l2 * (h / 2), l3 = rate(A + k2 * (h / 2)), k4 = V + l3 * h,
                    l4 = rate(A + k3 * h);
    A += (k1 + k2 * 2.0 + k3 * 2.0 + k4) * (h / 6), V += (l1 + l2 * 2.0 + l3 * 2.0 + l4) * (h / 6);
  }
  return {A, V};
}
/// A disc or a ball of cells that is a smooth image of a square or a cube: no line of it has a kink.
template <int d>
BodyMesh smooth_round(int cells) {
  BodyMesh mesh = d == 2 ? box_mesh({-1, -1}, {1, 1}, {cells, cells})
                         : box_mesh({-1, -1, -1}, {1, 1, 1}, {cells, cells, cells});
  for (auto& node : mesh.nodes) {
    auto const u = node;
    for (int k = 0; k < d; ++k) {
      double const p = u[(k + 1) % d] * u[(k + 1) % d], q = d < 3 ? 0 : u[(k + 2) % d] * u[(k + 2) % d];
      node[k] = u[k] * std::sqrt(1 - p / 2 - q / 2 + p * q / 3);
    }
  }
  return mesh;
}
/// \f$\rho = (1-|X|^2)^{1/(\gamma-1)}\f$ deformed by A, with velocities V X.
template <int d>
MediumOnMesh<d> ellipse(BodyMesh const& mesh, Square<d> const& A, Square<d> const& V, double K, double gamma,
                        double step) {
  BodyStart<d> start;
  start.density = [=](Spot<d> const& X) {
    double square = 0;
    for (double const one : X) square += one * one;
    return std::pow(std::max(0.0, 1 - square), 1 / (gamma - 1));
  };
  start.placement = linear<d>(A), start.velocity = linear<d>(V);
  return {mesh, stored_energy<d>(isentropic_gas(K, gamma)), start, {.step = step}};
}
template <int d>
Square<d> sheared() {
  auto A = Square<d>::Identity();
  A(0, 0) = 1.1, A(0, 1) = 0.2;
  return A;
}
template <int d>
Square<d> turned() {
  auto V = Square<d>::Zero();
  V(0, 1) = -0.4, V(1, 0) = 0.3, V(1, 1) = 0.1;
  return V;
}
}  // namespace

// In the mean by mass. The outermost nodes are lighter the finer the mesh, and off by the first order.
BOOST_AUTO_TEST_CASE(a_gas_ellipse_that_expands_into_vacuum_has_order_two) {
  double const K = 0.3, gamma = 1.4, time = 0.25;
  auto const A = sheared<2>(), V = turned<2>();
  auto const exact = linear<2>(expanded<2>(A, V, 2 * K * gamma / (gamma - 1), gamma, time).first);
  has_order_two("gas ellipse, gamma 7/5", {16, 32, 64, 128, 256}, [&](int cells) {
    auto body = ellipse<2>(smooth_round<2>(cells), A, V, K, gamma, time / cells);
    body.step(cells);
    return distance(body, exact).mean;
  });
}
// Energy, angular momentum \f$AV^T-VA^T\f$ and circulation \f$A^TV-V^TA\f$ are invariants of the exact
// motion. On the mesh the first two are kept, energy up to a band; the third, read off as the moments of mass
// \f$\sum mX\otimes v\f$, has the error of the solution, about the square of the cell's width.
BOOST_AUTO_TEST_CASE(an_ellipsoid_of_gas_keeps_its_invariants) {
  double const K = 0.3, gamma = 5.0 / 3, time = 1;
  int const steps = 240;
  auto const A = sheared<3>(), V = turned<3>();
  auto const [B, W] = expanded<3>(A, V, 2 * K * gamma / (gamma - 1), gamma, time);
  Square<3> const spin = A * V.transpose() - V * A.transpose(),
                  spin_later = B * W.transpose() - W * B.transpose();
  Square<3> const curl = A.transpose() * V - V.transpose() * A,
                  curl_later = B.transpose() * W - W.transpose() * B;
  BOOST_TEST(magnitude(spin_later - spin) <= 1e-11);
  BOOST_TEST(magnitude(curl_later - curl) <= 1e-11);

  auto body = ellipse<3>(smooth_round<3>(16), A, V, K, gamma, time / steps);
  auto const L = body.angular_momentum();
  double const E = body.energies().total();
  body.step(steps);
  BOOST_TEST(std::abs(body.angular_momentum()[2] - L[2]) <= 1e-13 * std::abs(L[2]));
  BOOST_TEST(std::abs(body.energies().total() - E) <= 1e-3 * E);
  // Moments of mass on the mesh: of X with X at the start, and of places and velocities with X now.
  auto const x = body.places(), v = body.velocities();
  Square<3> inertia = Square<3>::Zero(), now = inertia, rate = inertia;
  for (std::size_t k = 0; k < x.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        double const X = body.masses()[k] * body.mesh().nodes[k][j];
        inertia(i, j) += body.mesh().nodes[k][i] * X, now(i, j) += x[k][i] * X, rate(i, j) += v[k][i] * X;
      }
  Square<3> const a = now * inverse_matrix(inertia), w = rate * inverse_matrix(inertia),
                  found = a.transpose() * w - w.transpose() * a;
  double const circulation = magnitude(found - curl) / magnitude(curl);
  BOOST_TEST_MESSAGE("gas ellipsoid, 16^3 cells: placement off by " << magnitude(a - B) << ", circulation by "
                                                                    << circulation);
  double const width = 2.0 / 16;
  BOOST_TEST(magnitude(a - B) <= width * width);
  BOOST_TEST(circulation <= width * width);
}

// With the potential k|x|^2/2 every deformation that is the same everywhere goes on as
// \f$A_0\cos\omega t+A_1\sin\omega t\f$, whatever the solid: its stress has no divergence. The outer side is
// moved so. On the mesh no force is left inside either, though its lines have kinks, so that the error is
// that of time alone.
BOOST_AUTO_TEST_CASE(a_disc_deformed_alike_everywhere_has_order_two_in_time_for_every_solid) {
  double const k = 2, omega = std::sqrt(k), time = 1;
  Square<2> A0 = sheared<2>(), A1 = turned<2>();
  auto const chi = [=]<class T>(Spot<2> const& X, T const& t) {
    using std::cos, std::sin;
    T const c = cos(t * omega), s = sin(t * omega);
    std::array<T, 2> x;
    for (int i = 0; i < 2; ++i)
      x[i] = c * (A0(i, 0) * X[0] + A0(i, 1) * X[1]) + s * (A1(i, 0) * X[0] + A1(i, 1) * X[1]);
    return x;
  };
  BodySides<2> const sides{{"outer", {Side::moved, prescribed_motion<2>(chi)}}};
  BodyLoads<2> loads;
  loads.potentials.push_back(space_potential<2>([k](auto const& x) { return x.squaredNorm() * (k / 2); }));
  BodyStart<2> start;
  start.placement = linear<2>(A0), start.velocity = linear<2>(A1 * omega);
  for (auto const& law :
       {stored_energy<2>(neo_hookean(0.3, 0.1)), stored_energy<2>(FastStVenantKirchhoff{0.3, 0.2}),
        stored_energy<2>(blatz_ko<1>(0.01))})
    has_order_two("homogeneous disc", {32, 64, 128, 256, 512}, [&](int steps) {
      MediumOnMesh<2> body(disc_mesh(1, {3, 4}), law, start, {.step = time / steps}, sides, loads);
      body.step(steps);
      return distance(body, [&](Spot<2> const& X) { return chi(X, time); }).largest;
    });
}

// Sound on a line of segments is linear: the discrete equations have the solution sin(kX) cos(wt) with
// sin(w dt/2)/dt = c sin(k h/2)/h. Each step rounds a place below 1 once or twice; that goes on as a
// velocity: n^2/2 roundings at most, n^1.5/2 as a walk, which for 200 steps is 6e-13.
BOOST_AUTO_TEST_CASE(a_standing_wave_on_segments_has_the_discrete_dispersion_relation) {
  int const n = 40;
  double const c = 1.3, h = 1.0 / n, dt = 0.6 * h / c, k = 6 * M_PI;
  double const w = 2 / dt * std::asin(dt * c * std::sin(k * h / 2) / h);
  auto const u = [&](double X, double t) { return 0.03 * std::sin(k * X) * std::cos(w * t); };
  using enum Side;
  for (bool const held : {false, true}) {
    BodyStart<1> start;
    start.placement = [&](Spot<1> const& X) { return Spot<1>{X[0] + u(X[0], 0)}; };
    BodySides<1> sides;
    if (held) sides = {{"left", {fixed, {}}}, {"right", {sliding, {}}}};
    MediumOnMesh<1> body(box_mesh({0}, {1}, {n}, {!held}), stored_energy<1>(FastFluid{testing::Acoustic{c}}),
                         start, {.step = dt}, sides);
    body.step(200);
    double const off =
        distance(body, [&](Spot<1> const& X) { return Spot<1>{X[0] + u(X[0], body.time())}; }).largest;
    BOOST_TEST_MESSAGE("standing wave on segments: difference from the discrete dispersion relation " << off);
    BOOST_TEST(off <= 1e-12);
  }
}

// A shear wave leaves J = 1 at every corner: its equation is linear at any amplitude, and here it turns about
// the direction in which it moves.
BOOST_AUTO_TEST_CASE(a_neo_hookean_shear_wave_in_space_has_it_at_any_amplitude) {
  int const n = 30;
  double const mu = 0.8, h = 1.0 / n, dt = 0.1 * h, k = 2 * M_PI, amplitude = 0.5;
  double const w = 2 / dt * std::asin(dt * std::sqrt(mu) * std::sin(k * h / 2) / h);
  // The velocity of the discrete solution at the time of a node.
  double const rate = std::sin(w * dt) / dt;
  BodyStart<3> start;
  auto const at = [&](Spot<3> const& X, double t) {
    return Spot<3>{X[0] + amplitude * std::cos(k * X[1] - w * t), X[1],
                   X[2] + amplitude * std::sin(k * X[1] - w * t)};
  };
  start.placement = [&](Spot<3> const& X) { return at(X, 0); };
  start.velocity = [&](Spot<3> const& X) {
    return Spot<3>{amplitude * rate * std::sin(k * X[1]), 0, -amplitude * rate * std::cos(k * X[1])};
  };
  MediumOnMesh<3> body(box_mesh({0, 0, 0}, {2 * h, 1, 2 * h}, {2, n, 2}, {true, true, true}),
                       stored_energy<3>(neo_hookean(2, mu)), start, {.step = dt});
  body.step(200);
  double const off = distance(body, [&](Spot<3> const& X) { return at(X, body.time()); }).largest;
  BOOST_TEST_MESSAGE("shear wave in space: difference from the discrete dispersion relation " << off);
  BOOST_TEST(off <= 1e-12);
}

// Rests of sums are carried along, so that what is left is the rounding of forces: a walk of
// eps sqrt(1e5/nodes) times dt f/(m v), a hundredth here, below 1e-15; and less than ten times that where the
// same rounding comes again and again. Relative to the sum of moduli.
BOOST_AUTO_TEST_CASE(bodies_let_go_conserve_momenta_to_1e_14_over_1e5_steps) {
  BodyStart<2> start;
  start.density = [](Spot<2> const& X) { return 3 + X[0]; };
  start.placement = [](Spot<2> const& X) { return Spot<2>{X[0] * 1.02 + 0.01 * X[1] * X[1], X[1]}; };
  start.velocity = [](Spot<2> const& X) { return Spot<2>{0.03 - 0.3 * X[1], 0.02 + 0.3 * X[0]}; };
  for (auto const& law :
       {stored_energy<2>(neo_hookean(1, 0.5)), stored_energy<2>(FastStVenantKirchhoff{1, 0.5})}) {
    MediumOnMesh<2> body(disc_mesh(0.5, {2, 3}), law, start, {.step = 0.02});
    auto const p = body.momentum();
    double const L = body.angular_momentum()[2], E = body.energies().total();
    double of_p = 0, of_L = 0, of_E = 0, drift = 0;
    for (int k = 0; k < 100; ++k) {
      body.step(1000);
      double parts = 0, moments = 0;
      auto const x = body.places(), v = body.velocities();
      for (std::size_t i = 0; i < v.size(); ++i) {
        double const part = body.masses()[i] * std::hypot(v[i][0], v[i][1]);
        parts += part, moments += part * std::hypot(x[i][0], x[i][1]);
      }
      auto const q = body.momentum();
      double const e = body.energies().total() / E - 1;
      of_p = std::max(of_p, std::hypot(q[0] - p[0], q[1] - p[1]) / parts);
      of_L = std::max(of_L, std::abs(body.angular_momentum()[2] - L) / moments);
      of_E = std::max(of_E, std::abs(e));
      drift += (k >= 75 ? e : k < 25 ? -e : 0) / 25;
    }
    BOOST_TEST_MESSAGE("a disc let go, 100000 steps: momentum " << of_p << ", angular momentum " << of_L
                                                                << ", energy " << of_E
                                                                << ", change of its mean " << drift);
    BOOST_TEST(of_p <= 1e-14);
    BOOST_TEST(of_L <= 1e-14);
    BOOST_TEST(of_E <= 1e-2);
    BOOST_TEST(std::abs(drift) <= 0.5 * of_E);
  }
}

BOOST_AUTO_TEST_SUITE_END()
