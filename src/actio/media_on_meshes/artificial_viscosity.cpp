#include "actio/media_on_meshes/artificial_viscosity.hpp"

namespace actio::media {

ViscosityNeedsShorterSteps::ViscosityNeedsShorterSteps(int which, double step, double longest)
    : OutsideDomain("medium: viscosity of cell " + std::to_string(which),
                    "a step is not longer than small motions take to be damped", step, longest),
      cell(which) {}

}  // namespace actio::media
