// Bodies that are moved in the frame of their principal axes, and seen in the frame of the scene.
#pragma once

#include "actio/free_body/free_steps.hpp"
#include "actio/free_body/natural_chart_steps.hpp"
#include "actio/scene/systems/turning_body.hpp"

namespace actio::scene {

/// The way to the principal axes.
struct PrincipalStart {
  Momentum<SO<3>, double> momentum;
  Element<SU2, double> attitude;

  /// @param momentum,attitude  in the frame as given
  PrincipalStart(GivenInertia const& inertia, Eigen::Vector3d const& momentum, Eigen::Vector4d const& attitude);
};

/// And back from them.
class PrincipalBody : public TurningBody {
 public:
  explicit PrincipalBody(GivenInertia const& inertia);
  Eigen::Vector3d body_momentum() const override;
  Eigen::Vector4d attitude() const override;

 protected:
  virtual Eigen::Vector3d principal_momentum() const = 0;
  virtual Eigen::Vector4d principal_attitude() const = 0;

 private:
  GivenInertia inertia_;
  Eigen::Vector4d back_;
};

/// A free body that goes to any time at once.
std::unique_ptr<TurningBody> exact_motion(FreeBody body, GivenInertia const& inertia);
/// A free body in steps.
std::unique_ptr<TurningBody> stepped_motion(FreeSteps steps, GivenInertia const& inertia);
std::unique_ptr<TurningBody> stepped_motion(NaturalChartSteps steps, GivenInertia const& inertia);

}  // namespace actio::scene
