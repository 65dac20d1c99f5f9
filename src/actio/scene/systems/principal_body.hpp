// Bodies that are moved in the frame of their principal axes, and seen in the frame of the scene.
#pragma once

#include <functional>

#include "actio/fast_body/space/free_steps.hpp"
#include "actio/fast_body/space/natural_chart_steps.hpp"
#include "actio/scene/systems/turning_body.hpp"

namespace actio::scene {

/// The way to the principal axes.
struct PrincipalStart {
  Momentum<SO<3>, double> momentum;  ///< along the principal axes
  Element<SU2, double> attitude;     ///< principal axes to space

  /// @param momentum,attitude  in the frame as given
  PrincipalStart(GivenInertia const& inertia, Eigen::Vector3d const& momentum, Eigen::Vector4d const& attitude);
};

/// And back from them.
class PrincipalBody : public TurningBody {
 public:
  /// @param inertia  says how the two frames differ
  explicit PrincipalBody(GivenInertia const& inertia);
  Eigen::Vector3d body_momentum() const override;  ///< in the frame as given
  Eigen::Vector4d attitude() const override;

 protected:
  virtual Eigen::Vector3d principal_momentum() const = 0;  ///< along the principal axes
  virtual Eigen::Vector4d principal_attitude() const = 0;  ///< principal axes to space

 private:
  GivenInertia inertia_;
  Eigen::Vector4d back_;
};

/// The steps of a scheme from a state, along the principal axes, with steps of a given length.
template <class Steps>
using StepsFrom = std::function<Steps(Momentum<SO<3>, double> const& momentum, Element<SU2, double> const& attitude, double step)>;

/// A free body that goes to any time at once.
std::unique_ptr<TurningBody> exact_motion(FreeBody body, GivenInertia const& inertia);
/// A free body in steps.
std::unique_ptr<TurningBody> stepped_motion(StepsFrom<FreeSteps> steps, PrincipalStart const& start, double step, GivenInertia const& inertia);
/// The same by the natural-chart scheme.
std::unique_ptr<TurningBody> stepped_motion(StepsFrom<NaturalChartSteps> steps, PrincipalStart const& start, double step, GivenInertia const& inertia);

}  // namespace actio::scene
