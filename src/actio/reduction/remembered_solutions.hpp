// What a step on momenta remembers of its last calls.
#pragma once

#include <any>

#include "actio/groups/predictor_corrector.hpp"

namespace actio::detail {

/// The solver of a step on momenta, stored between calls that follow one another. A step is a
/// callable at every group and scalar, so the type of its solver is determined by the first call.
///
/// A call with another length, or from another velocity, reuses the derivative of the last call and has no
/// prediction. Solutions do not depend on what is remembered beyond rounding. For one thread at a time;
/// copies are independent.
class RememberedSolutions {
 public:
  /// The solver for a step of length h from a velocity; it predicts if both are what they were, or nearly so.
  template <Group G, Group Algebra, Real S>
  PredictorCorrector<G, S>& solver(Velocity<Algebra, S> const& velocity, Base<S> const& h) const {
    using Solver = Stored<G, Algebra, S>;
    Solver* stored = std::any_cast<Solver>(&stored_);
    if (!stored || (stored->velocity && stored->velocity->size() != velocity.coordinates.size()))
      stored = &stored_.emplace<Solver>();
    auto const jump = stored->velocity
                          ? magnitude(Coordinates<Algebra, S>(velocity.coordinates - *stored->velocity))
                          : Base<S>(0);
    if (!stored->velocity || !(stored->length == h) ||
        !(jump * Base<S>(4) <= magnitude(velocity.coordinates)))
      stored->solver.forget_solutions();
    stored->velocity = velocity.coordinates;
    stored->length = h;
    return stored->solver;
  }

 private:
  template <Group G, Group Algebra, Real S>
  struct Stored {
    PredictorCorrector<G, S> solver;
    std::optional<Coordinates<Algebra, S>> velocity;
    Base<S> length{};
  };
  mutable std::any stored_;
};

}  // namespace actio::detail
