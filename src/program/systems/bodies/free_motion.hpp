// Motions of a free body in space: to any time at once, and in steps. All numbers are those of the frame of
// the scene.
#pragma once

#include <functional>

#include "actio/fast_body/space/free_steps.hpp"
#include "actio/fast_body/space/natural_chart_steps.hpp"
#include "program/systems/bodies/turning_body.hpp"

namespace actio::scene {

/// The steps of a scheme from a state, with steps of a given length.
template <class Steps>
using StepsFrom = std::function<Steps(bodies::FreeState const& start, double step)>;

/// A free body that goes to any time at once.
std::unique_ptr<TurningBody> exact_motion(bodies::FreeBody body);
/// A free body in steps.
std::unique_ptr<TurningBody> stepped_motion(StepsFrom<bodies::FreeSteps> steps,
                                            bodies::FreeState const& start, double step);
/// The same by the natural-chart scheme.
std::unique_ptr<TurningBody> stepped_motion(StepsFrom<bodies::NaturalChartSteps> steps,
                                            bodies::FreeState const& start, double step);

}  // namespace actio::scene
