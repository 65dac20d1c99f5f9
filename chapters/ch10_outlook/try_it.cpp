// Lines to try of chapter 10: a sheet of rubber, a density of one's own, a square of water, a step for each
// cell; a step of the fluid on the sphere, and how good its bracket is. Lines between two marks // [NAME] are
// the reference's examples as well.
//
// Compiled at -O2: it takes many steps.
#include <Eigen/Core>

#include "actio/constraints_on_meshes/step_with_multipliers.hpp"
#include "actio/fast_media/fast_medium_2d.hpp"
#include "actio/incompressible/incompressible_density.hpp"
#include "actio/meshes/body_shapes.hpp"
#include "actio/multisymplectic/asynchronous_steps.hpp"
#include "actio/multisymplectic/discrete_noether.hpp"
#include "actio/multisymplectic/step_field_equations.hpp"
#include "actio/numbers/print.hpp"
#include "book/try_it.hpp"
using namespace actio;
using namespace actio::media;

TRY_IT(sheet) {
  // A sheet of rubber is stretched, set turning and let go: what has changed after a thousand steps.
  auto const placed = [](auto const& X) { return std::array{1.3 * X[0], X[1]}; };
  auto const turning = [](auto const& X) { return std::array{-X[1], X[0]}; };
  FastMedium2d sheet(neo_hookean(2, 1), FastBox2d{{12, 8}, {0.1, 0.1}}, 0.02, 1, placed, turning);
  double const angular = sheet.angular_momentum(), energy = sheet.energy();
  sheet.step(1000);
  print("angular momentum, relative", sheet.angular_momentum() / angular - 1);
  print("energy, relative", sheet.energy() / energy - 1);
  print("the longest stable step", sheet.largest_step());
}

TRY_IT(own_density) {
  // [step_of_a_section]
  // Born and Infeld's density: every wave f(X - t) is a solution.
  auto const density = []<class T>(Jet<T, 1, 1> const& j) {
    using std::sqrt;
    T const rate = j.v(0, 0), slope = j.v(0, 1);
    return T(-sqrt(1.0 - rate * rate + slope * slope));
  };
  using Point = Matrix<double, 1, 1>;
  auto const wave = [](Event<double, 1> const& x) {  // x = (t, X)
    return Point(0.5 * std::exp(-(x[1] - x[0]) * (x[1] - x[0])));
  };
  // 400 cells and 150 steps; the wave gives the first two levels, and the values at the ends.
  SpaceTimeMesh<double, 1> const mesh(equal_steps(0.0, 0.04, 150), {400}, all_sides<1>(Side::fixed),
                                      StraightBox<double, 1>{Point(-5.0), Point(15.0)});
  auto y = restricted(mesh, wave, 2);
  while (y.last() + 1 < mesh.levels()) step(density, mesh, y, wave);
  double worst = 0;
  for (Index i = 0; i < mesh.node_count(); ++i)
    worst = std::max(worst, std::abs((y(150, i) - wave(mesh.event(150, i)))[0]));
  print("largest distance from the exact wave", worst);
  // [step_of_a_section]
  // [noether_balance]
  // A shift of y is a symmetry: Noether's theorem on a box of 60 slabs and 100 cells.
  auto const shift = motion_of_space<1>([](auto const& z) { return 0.0 * z + Point(1.0); });
  auto const sum = noether_balance(density, shift, mesh, y, CellBox<1>{50, 60, {{120}}, {{100}}});
  print("momentum over its boundary, relative", sum.sum / sum.terms);
  // [noether_balance]
}

TRY_IT(turning_water) {
  // [step_with_multipliers]
  // A square of water without weight, in a flow of shear and turn, with a multiplier for each cell and level.
  using Point = Matrix<double, 2, 1>;
  auto const water =
      incompressible(Continuum{Euclidean<2>{}, Euclidean<2>{}, Homogeneous<double>{1.0}, NoStoredEnergy{}});
  SpaceTimeMesh<double, 2> const mesh(equal_steps(0.0, 0.02, 50), {6, 6}, all_sides<2>(Side::free),
                                      StraightBox<double, 2>{Point(-0.5, -0.5), Point(0.5, 0.5)});
  Level<double, 2> places, velocities;
  for (Index i = 0; i < mesh.node_count(); ++i) {
    Point const X = mesh.place(i);
    places.push_back(X), velocities.push_back(Point(-1.5 * X[1], 0.5 * X[0]));
  }
  auto y = without_reactions<1>(mesh, DiscreteSection<double, 2, 2>{{places}});
  first_step(water, mesh, y, velocities);
  while (y.last() + 1 < mesh.levels()) step(water, mesh, y);
  double change = 0;
  mesh.for_cells([&](auto const& cell) {
    auto const here = cell_of(mesh, y.phi, 49, cell);
    change = std::max(change, std::abs(constraint_of_cell(water.constraint, here, 1)[0]) * 36);
  });
  print("largest change of an area, relative", change);
  print("pressure in the middle at the start", y.lambda[0][21][0]);
  print("and later", y.lambda[49][21][0]);
  // [step_with_multipliers]
}

TRY_IT(asynchronous) {
  // An elastic bar whose first cells grow tenfold in width, each with half its longest stable step.
  auto const bar = []<class T>(Jet<T, 1, 1> const& j) {
    T const strain = j.v(0, 1) - 1.0;
    return T((j.v(0, 0) * j.v(0, 0) - strain * strain) / 2.0);
  };
  BodyMesh mesh = box_mesh({0}, {1}, {32});
  Level<double, 1> places, velocities;
  for (int k = 0; k <= 32; ++k) {
    double& X = mesh.nodes[k][0];
    if (k > 0) X = mesh.nodes[k - 1][0] + std::pow(10, std::min(0.0, (k - 1) / 8.0 - 1));
    places.emplace_back(X), velocities.emplace_back(0.1 * std::sin(X / 4));
  }
  auto steps = longest_steps<1, 1>(bar, mesh, places);
  for (double& h : steps) h /= 2;
  auto run = asynchronous_steps<1>(bar, mesh, steps, places, velocities);
  auto const momentum = [&] {
    double sum = 0;
    for (int k = 0; k <= 32; ++k) sum += run.mass(k) * run.velocity(k)[0];
    return sum;
  };
  double const before = momentum(), energy = run.energy(0);
  run.run(100);
  double const equal = 32 * (1 + std::floor(100 / *std::min_element(steps.begin(), steps.end())));
  print("kicks with equal steps, over kicks", equal / run.events());
  print("momentum, change", momentum() - before);
  print("energy, relative", run.energy(100) / energy - 1);
}

#include "actio/quantized_sphere/sphere_invariants.hpp"
#include "actio/vorticity/vorticity_step.hpp"
using namespace actio::sphere;

TRY_IT(a_step) {
  // [vorticity_step]
  // One step of a flow of three harmonics: what has changed of energy, angular momentum and C_2 .. C_5.
  SphereHarmonics f(16);
  f(1, 0) = 1, f(3, 2) = {0.5, 0.2}, f(4, 1) = {-0.3, 0.6};
  auto const before = matrix_of(f);
  auto w = before;
  SphereLaplacian const laplacian(16);
  VorticityStep(laplacian, Conserved::all_invariants, 0.2).advance(w);
  print("energy", vorticity_energy(laplacian, w) - vorticity_energy(laplacian, before));
  print("angular momentum", (sphere_momentum(w) - sphere_momentum(before)).norm());
  print("Casimirs", (vorticity_casimirs(w, 5) - vorticity_casimirs(before, 5)).norm());
  // [vorticity_step]
  print("and the vorticity itself", norm(w - before) / norm(before));
}

TRY_IT(bracket) {
  // The bracket of two harmonics of degree l as the matrices of size N have it, against its limit: the
  // relative error, in units of l^4/(6 N^2).
  auto const bracket = [](int n, int l) {
    SphereHarmonics f(n), g(n);
    f(l, l / 2) = 1, g(l, l) = {0.6, 0.8};
    SkewHermitian<> const c = commutator(matrix_of(f), matrix_of(g));
    return harmonics_of((1 / QuantizedSphere(n).hbar()) * c).coefficient.topLeftCorner(2 * l, 2 * l).eval();
  };
  int const l = 4;
  Eigen::MatrixXcd const fine = (4.0 * bracket(96, l) - bracket(48, l)) / 3.0;  // of second order in 1/N
  for (int n : {16, 24, 32}) {
    double const error = (bracket(n, l) - fine).norm() / fine.norm();
    print(("N = " + std::to_string(n)).c_str(), error * 6 * n * n / std::pow(l, 4));
  }
}

TRY_IT_MAIN("the lines to try of chapter 10")
