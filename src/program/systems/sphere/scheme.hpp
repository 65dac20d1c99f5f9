// How a flow is stepped: what is conserved, how exactly, in which substeps; and how long its steps are.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "actio/vorticity/step_setting.hpp"
#include "program/registry/simulation.hpp"
#include "program/registry/system.hpp"

namespace actio::scene {

/// How a flow is stepped.
struct SphereScheme {
  sphere::Conserved conserved;    ///< beside the spectrum
  bool to_rounding;               ///< whether the equation of a step is solved in double precision throughout
  std::vector<double> fractions;  ///< of a step, those of the substeps

  /// The longest fraction.
  double longest() const;
};

/// The flow from its start, in steps of a length.
using MakeStepped = std::function<std::unique_ptr<Motion>(double step)>;

/// The step of the scene: by default the largest eigenvalue of A is a tenth, where few iterations solve the
/// step.
/// @param fastest  turning of a vector by the equations of motion, 1/time
/// @throws SceneError, NumericsError  where no step of that length can be made, with one that can
double step_of_scheme(SceneTable const& method, Schedule const& schedule, double fastest,
                      SphereScheme const& scheme, MakeStepped const& make);

/// A run with longer steps takes more iterations a step, and is made where it is asked for.
/// @param wanted  whether an estimate is
Companion companion_of_scheme(MakeStepped const& make, int order, double step, std::optional<bool> wanted);

/// As many steps as take 5 ms or so: some ten evaluations of the step's equation.
long steps_in_5_ms(int n, std::size_t substeps);

}  // namespace actio::scene
