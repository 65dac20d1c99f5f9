// Examples of the modules stored_energy, fast_media, meshes, media_on_meshes and incompressible_media; those
// of multisymplectic are lines to try of chapter 10.
#include "actio/fast_media/fast_medium_2d.hpp"
#include "actio/fast_media/fast_medium_3d.hpp"
#include "actio/incompressible_media/incompressible_medium.hpp"
#include "actio/incompressible_media/two_colour_multigrid.hpp"
#include "actio/media_on_meshes/medium_on_mesh.hpp"
#include "actio/meshes/body_shapes.hpp"
#include "actio/meshes/gmsh_mesh.hpp"
#include "actio/parallel/thread_ranks.hpp"
#include "actio/stored_energy/stored_energies.hpp"

#include "example.hpp"

BOOST_AUTO_TEST_SUITE(examples_of_media)
using namespace actio;
using namespace actio::media;

// ---- stored_energy

BOOST_AUTO_TEST_CASE(materials) {
  // [neo_hookean]
  // Rubber with lambda = 2 and mu = 1 (speeds squared: moduli over the mass density), stretched by 1.5.
  auto const rubber = stored_energy<3>(neo_hookean(2, 1));
  Matrix<double, 3, 3> F = Matrix<double, 3, 3>::Identity();
  assert(rubber->energy(F) == 0 && rubber->stress(F).norm() == 0);  // no stress at rest
  F(0, 0) = 1.5;
  double const l = std::log(1.5);  // mu/2 (tr C - 3) - mu log J + lambda/2 log^2 J
  assert(std::abs(rubber->energy(F) - (0.5 * (1.5 * 1.5 - 1) - l + l * l)) < 1e-15);
  // [neo_hookean]
  // [isentropic_gas]
  // Air of 1.2 kg/m^3 at 101325 Pa: the pressure is K (rho/J)^1.4.
  double const rho = 1.2, K = 101325 / std::pow(rho, 1.4);
  auto const air = stored_energy<2>(isentropic_gas(K, 1.4));
  Matrix<double, 2, 2> const still = Matrix<double, 2, 2>::Identity();
  assert(std::abs(-air->weight(rho) * air->stress(still)(0, 0) / 101325 - 1) < 1e-14);
  // [isentropic_gas]
  // [own_energy]
  // An energy of your own, per unit mass, over any scalar; its stress is its derivative.
  auto const spring = []<class T>(Matrix<T, 2, 2> const& A) { return T(A.squaredNorm() / 2.0 - 1.0); };
  auto const own = stored_energy<2>(spring);
  assert((own->stress(still) - still).norm() < 1e-15);
  // [own_energy]
}

// ---- fast_media

BOOST_AUTO_TEST_CASE(a_sheet_of_rubber) {
  // [fast_medium_2d]
  // A sheet of rubber, 12 by 8 cells of 0.1, is stretched, set turning and let go.
  auto const placed = [](auto const& X) { return std::array{1.3 * X[0], X[1]}; };
  auto const turning = [](auto const& X) { return std::array{-X[1], X[0]}; };
  FastMedium2d sheet(neo_hookean(2, 1), FastBox2d{{12, 8}, {0.1, 0.1}}, 0.02, 1, placed, turning);
  double const angular = sheet.angular_momentum(), energy = sheet.energy();
  sheet.step(1000);
  assert(std::abs(sheet.angular_momentum() / angular - 1) < 1e-12);  // conserved to rounding
  assert(std::abs(sheet.energy() / energy - 1) < 0.02);              // oscillates with the square of the step
  // [fast_medium_2d]
  // [fast_box_2d]
  FastBox2d box{{12, 8}, {0.1, 0.1}};             // cells and their lengths; all sides are free
  box.left_right = {Side::fixed, Side::sliding};  // held at the left, sliding along the right
  assert(box.count() == 13 * 9 && box.nodes(0) == 13 && std::abs(box.measure() - 0.01) < 1e-16);
  // [fast_box_2d]
}

BOOST_AUTO_TEST_CASE(a_sheet_on_three_ranks) {
  // [media_on_ranks]
  // The same sheet on one rank, and on three, which are threads here.
  auto const placed = [](auto const& X) { return std::array{1.3 * X[0], X[1]}; };
  auto const at_rest = [](auto const&) { return std::array{0.0, 0.0}; };
  FastBox2d const box{{12, 8}, {0.1, 0.1}};
  auto const rubber = neo_hookean(2, 1);
  FastMedium2d alone(rubber, box, 0.02, 1, placed, at_rest);
  alone.step(100);
  on_thread_ranks(3, [&](Ranks& ranks) {
    FastOptions options;
    options.ranks = &ranks;
    share_parts(
        ranks, [&](std::string const&, double step) { return medium_part(rubber, box, step, options); },
        [&] {
          FastMedium2d shared(rubber, box, 0.02, 1, placed, at_rest, options);
          shared.step(100);
          assert((shared.places() == alone.places()));
        });
  });
  // [media_on_ranks]
}

BOOST_AUTO_TEST_CASE(a_disc_on_three_ranks) {
  // [body_on_ranks]
  // A disc of rubber that is pressed at its rim, on one rank, and on three, which are threads here.
  BodyMesh const disc = disc_mesh(1, {3, 2});
  auto const law = stored_energy<2>(neo_hookean(2, 1));
  BodyStart<2> const at_rest;
  BodyStepping const steps{.step = 0.01};
  BodyLoads<2> loads;
  loads.pressures["outer"] = [](double t) { return 0.5 * t; };
  MediumOnMesh<2> alone(disc, law, at_rest, steps, {}, loads);
  alone.step(50);
  on_thread_ranks(3, [&](Ranks& ranks) {
    auto const part = [&](std::string const& told, double) {
      return std::make_unique<BodyOnRank<2>>(ranks, told, disc, law, at_rest.density, steps, BodySides<2>{},
                                             loads);
    };
    share_parts(ranks, part, [&] {
      MediumOnMesh<2> shared(disc, law, at_rest, steps, {}, loads, &ranks);
      shared.step(50);
      assert((shared.places() == alone.places()));
    });
  });
  // [body_on_ranks]
}

BOOST_AUTO_TEST_CASE(a_block_of_rubber) {
  // [fast_medium_3d]
  auto const at_home = [](auto const& X) { return X; };
  auto const pushed = [](auto const&) { return std::array{1.0, 0.0, 0.5}; };
  FastMedium3d block(neo_hookean(2, 1), FastBox3d{{4, 4, 4}, {0.1, 0.1, 0.1}}, 0.02, 1, at_home, pushed);
  block.step(50);  // it flies: one unit of time
  assert(std::abs(block.places()[0][0] - 1) < 1e-12 && std::abs(block.places()[0][2] - 0.5) < 1e-12);
  // [fast_medium_3d]
}

// ---- meshes

BOOST_AUTO_TEST_CASE(meshes) {
  // [box_mesh]
  BodyMesh const beam = box_mesh({0, 0, 0}, {4, 1, 1}, {8, 2, 2});
  assert(beam.nodes.size() == 9 * 3 * 3 && beam.sides.count("left") == 1);
  // [box_mesh]
  // [gmsh_mesh_of]
  // Two triangles, as Gmsh writes them; `gmsh_mesh` reads a file.
  std::string const text =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
      "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n"
      "$Elements\n2\n1 2 2 1 1 1 2 3\n2 2 2 1 1 1 3 4\n$EndElements\n";
  BodyMesh const square = gmsh_mesh_of(text, "square.msh");
  assert(square.cells.size() == 2 && square.nodes.size() == 4);
  // [gmsh_mesh_of]
}

// ---- media_on_meshes

BOOST_AUTO_TEST_CASE(a_beam) {
  // [medium_on_mesh]
  // A beam of rubber, held at its left end and pushed sideways.
  BodyStart<3> start;  // density 1, undeformed
  start.velocity = [](auto const& X) { return std::array{0.0, 0.1 * X[0], 0.0}; };
  MediumOnMesh<3> beam(box_mesh({0, 0, 0}, {4, 1, 1}, {8, 2, 2}), stored_energy<3>(neo_hookean(2, 1)), start,
                       {.step = 0.02}, {{"left", {Side::fixed, {}}}});
  beam.step(50);
  assert(beam.places()[0] == (std::array{0.0, 0.0, 0.0}));  // a node of the side
  assert(beam.places()[8][1] > 0.05);                       // one of the free end
  // [medium_on_mesh]
}

// ---- incompressible_media

BOOST_AUTO_TEST_CASE(a_tank) {
  // [incompressible_medium]
  // Water in a tank, which sways: the volume of each cell is kept.
  IncompressibleStart<2> start;  // density 1
  start.gravity = {0, -9.81};
  start.velocity = [](auto const& X) { return std::array{0.1 * std::sin(3.14159265 * X[0]), 0.0}; };
  start.project = true;  // takes from the velocity what would change volumes
  IncompressibleMedium<2> water(
      box_mesh({0, 0}, {1, 0.5}, {16, 8}), {}, start, 0.01,
      {{"left", {Side::sliding, {}}}, {"right", {Side::sliding, {}}}, {"bottom", {Side::sliding, {}}}});
  water.step(100);
  assert(water.volume_defect() < 2e-13);
  assert(std::abs(water.pressures()[0] / (9.81 * 0.5) - 1) < 0.2);  // at the bottom
  // [incompressible_medium]
}

BOOST_AUTO_TEST_CASE(pressures) {
  // [two_colour_multigrid]
  // Unit squares with free sides and node masses of 1: a square acts on itself, and on those beyond its
  // corners.
  NinePointMatrix S({40, 30});
  for (int j = 0; j < 30; ++j)
    for (int i = 0; i < 40; ++i) {
      std::size_t const k = S.at(i, j);
      S.self[k] = 2;
      if (S.holds(i + 1, j + 1)) S.north_east[k] = -0.5;
      if (S.holds(i - 1, j + 1)) S.north_west[k] = -0.5;
    }
  TwoColourMultigrid cycle;
  cycle.build(S);
  std::vector<double> const b(S.size(), 1.0);
  std::vector<double> x(S.size(), 0.0), r = b, delta(S.size());
  for (int count = 0; count < 15; ++count) {
    cycle.apply(r.data(), delta.data());
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += delta[k];
    S.residual(b.data(), x.data(), r.data());  // in double
  }
  for (double const rest : r) assert(std::abs(rest) < 1e-8);
  // [two_colour_multigrid]
}

BOOST_AUTO_TEST_SUITE_END()
