#include "actio/vorticity/step_setting.hpp"

namespace actio::sphere {

NotContracting::NotContracting(double tried, double do_well)
    : Error("vorticity: the iteration of a step of length " + show(tried) + " does not contract; " +
            (do_well == 0 ? "nor does that of any shorter step that was tried"
                          : "the longest that does is about " + show(do_well))),
      step(tried),
      largest(do_well) {}

}  // namespace actio::sphere
