// Section 8.4: incompressible elastic solids.
#include "fields/incompressible_models.hpp"

#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

template <class S, int n>
using Solid = Continuum<MetricOfVolume<S, n>, MetricOfVolume<S, n>, AnyMass<S, n>, AnisotropicSolid<S, n>>;

}  // namespace

STATEMENT(claim_8_4_elasticity_components, "an incompressible solid in components") {
  claim.holds(
      "$W$ is any function $W(x, G, C)$ of the Green tensor, without symmetry. The divergence is that of "
      "section 6.2 with its index corrected.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const general = draw_medium<S, n>(draw);
    Solid<S, n> const solid{general.G, general.g, general.rho, draw_solid<S, n>(draw)};
    auto const density = incompressible(solid);
    auto const j = draw_extended_jet<S, n>(draw, draw_section<S, n, n>(draw), solid.G);
    auto const forces = per_volume(density, j);
    claim.equal("the equation and the Euler-Lagrange derivative", model, elastic_residual(density, j),
                forces);
    claim.differs("the pressure without J", model,
                  (elastic_residual(density, j) - pressure_term(solid.G, solid.g, j) +
                   spatial_pressure_gradient(solid.G, j))
                      .eval(),
                  forces);
    claim.differs("the divergence of stress with the other sign", model,
                  (elastic_residual(density, j) + S(2) * stress_divergence(solid, deformation(j))).eval(),
                  forces);
    claim.differs("an energy that is no function of the Green tensor", model,
                  elastic_residual(incompressible(general), j), per_volume(incompressible(general), j));
  });
}

STATEMENT(claim_8_4_elasticity_covariant, "an incompressible solid, as vectors of space") {
  claim.convention(
      "With $J = 1$ in the pressure's term, the index raised by $g$, and $p = P\\circ\\phi_t^{-1}$.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    Solid<S, n> const solid{draw_metric_of_volume<S, n>(draw), draw_metric_of_volume<S, n>(draw),
                            draw_mass<S, n>(draw), draw_solid<S, n>(draw)};
    auto const density = incompressible(solid);
    auto const lowered_residual = [&](SecondJet<S, n, n + 1> const& j) {
      return lowered(solid.g(deformation(j).y), covariant_elastic_residual(density, j));
    };
    auto const phi = draw_shears<S, n>(draw, solid.G.chart, solid.g.chart);
    auto const held = draw_extended_jet<S, n>(draw, phi, solid.G),
               free = draw_extended_jet<S, n>(draw, of_coordinates(phi), solid.G);
    claim.equal("where the volume is held", model, lowered_residual(held), per_volume(density, held));
    claim.differs("where the volume of coordinates is", model, lowered_residual(free),
                  per_volume(density, free));
    claim.differs("the pressure with the other sign", model,
                  (lowered_residual(held) - S(2) * spatial_pressure_gradient(solid.G, held)).eval(),
                  per_volume(density, held));
  });
}
