// The implementation for large meshes against the general one, from the densities of chapters 6 and 8 by
// exact derivatives: places and pressures of a block of water, and of one of rubber.
#include <boost/test/unit_test.hpp>

#include "actio/constraints_on_meshes/step_with_multipliers.hpp"
#include "actio/continuum/materials.hpp"
#include "actio/incompressible/incompressible_density.hpp"
#include "actio/incompressible_media/incompressible_medium.hpp"

using namespace actio;
using namespace actio::media;

namespace {

using Point = Matrix<double, 2, 1>;
constexpr double h = 0.02, rho = 1.5;
constexpr int steps = 40, across = 5, up = 4;

/// Both, from the same velocities, which change no area.
template <class Density>
void agree(Density const& density, std::shared_ptr<StoredEnergy<2> const> const& law) {
  SpaceTimeMesh<double, 2> const mesh(equal_steps(0.0, h, steps + 1), {across, up}, all_sides<2>(Side::free),
                                      StraightBox<double, 2>{Point(-0.5, -0.4), Point(0.5, 0.4)});
  auto const flow = [](double x, double y) { return std::array{0.3 * x - 0.8 * y + 0.2, 0.5 * x - 0.3 * y}; };
  Level<double, 2> places, velocities;
  for (Index i = 0; i < mesh.node_count(); ++i) {
    Point const X = mesh.place(i);
    auto const v = flow(X[0], X[1]);
    places.push_back(X), velocities.push_back(Point(v[0], v[1]));
  }
  auto general = without_reactions<1>(mesh, DiscreteSection<double, 2, 2>{{places}});
  first_step(density, mesh, general, velocities);
  while (general.last() + 1 < mesh.levels()) step(density, mesh, general);

  IncompressibleStart<2> start;
  start.density = [](auto const&) { return rho; };
  start.velocity = [&](auto const& X) { return flow(X[0], X[1]); };
  IncompressibleMedium<2> medium(box_mesh({-0.5, -0.4}, {0.5, 0.4}, {across, up}), law, start, h);
  double place = 0, pressure = 0, largest = 0;
  std::vector<double> P;
  for (int k = 1; k <= steps; ++k) {
    // The multiplier of the first step has half of the weight, and belongs to half a step.
    if (k > 1) {
      P = medium.pressures();
      for (std::size_t cell = 0; cell < P.size(); ++cell)
        pressure = std::max(pressure, std::abs(P[cell] - general.lambda[std::size_t(k - 1)][cell][0])),
        largest = std::max(largest, std::abs(P[cell]));
    }
    medium.step();
    auto const x = medium.places();
    for (std::size_t node = 0; node < x.size(); ++node) {
      Point const there = general.phi(k, static_cast<Index>(node));
      place = std::max(place, std::hypot(x[node][0] - there[0], x[node][1] - there[1]));
    }
  }
  BOOST_TEST_MESSAGE("places apart by " << place << ", pressures by " << pressure << " of " << largest);
  // Roundings of forty steps; a pressure is a second difference of places over the square of a step.
  BOOST_TEST(place <= 1e-12);
  BOOST_TEST(pressure <= 1e-9 * largest);
  BOOST_TEST(largest > 0.01);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(general_road)

BOOST_AUTO_TEST_CASE(water_is_stepped_alike) {
  agree(incompressible(Continuum{Euclidean<2>{}, Euclidean<2>{}, Homogeneous<double>{rho}, NoStoredEnergy{}}),
        {});
}
BOOST_AUTO_TEST_CASE(rubber_is_stepped_alike) {
  // The energy of chapter 6 is per mass.
  double const mu = 0.8;
  agree(incompressible(Continuum{Euclidean<2>{}, Euclidean<2>{}, Homogeneous<double>{rho},
                                 OfGreenTensor{actio::NeoHookean{mu / rho, LogarithmicVolume<double>{0}}}}),
        stored_energy<2>(per_volume(neo_hookean(0, mu))));
}

BOOST_AUTO_TEST_SUITE_END()
