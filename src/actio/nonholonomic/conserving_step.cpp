#include <Eigen/Core>

#include "actio/nonholonomic/conserving_step.hpp"

namespace actio::systems {

void require_constant_metric(ReducedSystem const& system) {
  constexpr char const* where = "steps that conserve the energy";
  if (system.chart != Chart::cayley)
    throw OutsideDomain(where, "Cayley's chart is needed; chart, 0 for the exponential one", 0, 1);
  if (system.force || system.dissipation)
    throw OutsideDomain(where, "there must be no force and no friction; how many there are",
                        int(system.force.has_value()) + int(system.dissipation.has_value()), 0);
  int const d = system.dimension();
  Tape momenta = system.slopes;
  momenta.outputs = {momenta.outputs.begin() + 1, momenta.outputs.begin() + 1 + d};
  momenta = joined({momenta});
  int varying = 0, moving = 0;
  for (int i = 1 + d; i < system.curvature.size(); ++i) varying += !system.curvature.is_constant(i);
  if (varying > 0)
    throw OutsideDomain(where, "the kinetic energy must have constant coefficients as it is written; others",
                        varying, 0);
  for (int i = d; i < system.lagrangian.inputs; ++i) varying += momenta.depends_on(i);
  std::vector<double> still(static_cast<std::size_t>(system.lagrangian.inputs), 0),
      p(static_cast<std::size_t>(d)), work;
  momenta(still.data(), p.data(), work);
  for (double const x : p) moving += x != 0;
  if (varying + moving > 0)
    throw OutsideDomain(where, "there must be no momentum at rest; vectors and constants in momenta",
                        varying + moving, 0);
}

}  // namespace actio::systems
