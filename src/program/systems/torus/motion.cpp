#include <Eigen/Core>

#include "program/systems/torus/motion.hpp"

#include "actio/vorticity/torus_steps.hpp"
#include "program/systems/sphere/stepped_matrix.hpp"

namespace actio::scene {
namespace {

template <class Step>
class SteppedTorus : public SteppedMatrix<Step, TorusMotion> {
 public:
  SteppedTorus(std::shared_ptr<TorusFlow const> const& flow, SphereScheme const& scheme, double step)
      : SteppedMatrix<Step, TorusMotion>(flow->start, scheme, step, [flow, scheme](double length) {
          std::vector<Step> out;
          out.reserve(scheme.fractions.size());
          for (double const fraction : scheme.fractions)
            out.emplace_back(flow->stream, scheme.conserved, fraction * length, sphere::TurningFrame{},
                             flow->products);
          return out;
        }) {}
  sphere::SkewHermitian<> const& vorticity() const override { return this->state(); }
};

}  // namespace

double TorusFlow::fastest_turning() const {
  return torus::FastTorusStep::spectral_radius(stream.solve(start)) /
         torus::QuantizedTorus(stream.size()).hbar();
}

StateDistance TorusMotion::distance(Motion const& other) const {
  auto const& w = vorticity();
  return {0, sphere::norm(w - dynamic_cast<TorusMotion const&>(other).vorticity()), sphere::norm(w)};
}

std::unique_ptr<TorusMotion> stepped_torus(std::shared_ptr<TorusFlow const> flow, SphereScheme const& scheme,
                                           double step) {
  if (scheme.to_rounding) return std::make_unique<SteppedTorus<torus::TorusStep>>(flow, scheme, step);
  return std::make_unique<SteppedTorus<torus::FastTorusStep>>(flow, scheme, step);
}

}  // namespace actio::scene
