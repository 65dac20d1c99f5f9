// The optimised implementation of media held to the generic implementation: the discrete Euler-Lagrange field
// equations of the density, by duals.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/continuum/materials.hpp"
#include "actio/fast_media/fast_medium_2d.hpp"
#include "actio/multisymplectic/step_field_equations.hpp"

using namespace actio;
using namespace actio::media;

namespace {
using Place = std::array<double, 2>;

/// A medium on seven by five cells: two levels by the optimised implementation, ten more by both.
template <class Medium, class Energy>
void ways_agree(Medium const& medium, Energy const& energy, Side across, Side up) {
  constexpr double eps = std::numeric_limits<double>::epsilon();
  int const n = 7, m = 5, steps = 10;
  double const h1 = 0.1, h2 = 0.13, dt = 0.01, density = 1.7;
  FastBox2d const box{{n, m}, {h1, h2}, {across, across}, {up, up}};
  // Periodic, and nothing at the sides.
  auto const bump = [&](Place const& X) {
    return std::pow(std::sin(M_PI * X[0] / (n * h1)) * std::sin(M_PI * X[1] / (m * h2)), 2);
  };
  FastMedium2d fast(
      medium, box, dt, density,
      [&](Place const& X) {
        return Place{X[0] + 0.03 * bump(X) * X[1], X[1] - 0.02 * bump(X)};
      },
      [&](Place const& X) {
        return Place{0.2 * bump(X), -0.1 * bump(X) * X[0]};
      });

  std::vector<double> times;
  for (int k = 0; k <= steps + 1; ++k) times.push_back(k * dt);
  Sides<2> sides;
  sides[0] = {across, across}, sides[1] = {up, up};
  SpaceTimeMesh<double, 2> const mesh(times, GridIndex<2>{{n, m}}, sides,
                                      StraightBox<double, 2>{{0, 0}, {n * h1, m * h2}});
  DiscreteSection<double, 2, 2> section;
  section.jump << n * h1, 0, 0, m * h2;
  auto const add = [&] {
    section.levels.emplace_back();
    for (auto const& p : fast.places()) section.levels.back().push_back({p[0], p[1]});
  };
  add(), fast.step(), add();
  Continuum const continuum{Euclidean<2>{}, Euclidean<2>{}, Homogeneous<double>{density}, energy};
  for (int k = 0; k < steps; ++k) step(continuum, mesh, section);
  fast.step(steps);

  auto const x = fast.places();
  double worst = 0;
  for (std::size_t k = 0; k < x.size(); ++k)
    worst = std::max(worst, (section.levels.back()[k] - Eigen::Vector2d(x[k][0], x[k][1])).norm());
  // The generic implementation solves each level to 48 roundings of places below 1, and both lose some 100
  // roundings of a kick, dt^2 times a modulus below 4 over h; what a step is off goes on as a velocity.
  double const a_step = eps * (48 + 100 * dt * dt * 4 / h1 * (1 + 1 / h1));
  BOOST_TEST(worst <= a_step * steps * (steps + 1) / 2);
  BOOST_TEST_MESSAGE("the optimised implementation and the generic implementation differ by " << worst);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(fast_against_generic)

BOOST_AUTO_TEST_CASE(both_ways_are_the_same_to_rounding) {
  using enum Side;
  for (auto const& [across, up] :
       {std::pair{free, free}, {fixed, free}, {periodic, fixed}, {periodic, periodic}}) {
    ways_agree(FastFluid{PolytropicByRoots<1, 2>{0.7}}, Barotropic{WholePolytropic<double, 1>{0.7}}, across,
               up);
    ways_agree(FastFluid{PolytropicGas{0.7, 1.3}}, Barotropic{Polytropic<double>{0.7, 1.3}}, across, up);
    ways_agree(FastStVenantKirchhoff{0.9, 0.6}, OfGreenTensor{StVenantKirchhoff<double>{0.9, 0.6}}, across,
               up);
    ways_agree(neo_hookean(0.9, 0.6), OfGreenTensor{NeoHookean{0.6, LogarithmicVolume<double>{0.9}}}, across,
               up);
    ways_agree(blatz_ko<1>(0.6), OfGreenTensor{NeoHookean{0.6, PowerVolume<1>{}}}, across, up);
  }
}

BOOST_AUTO_TEST_SUITE_END()
