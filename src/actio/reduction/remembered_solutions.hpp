// What a step on momenta remembers of its last calls.
#pragma once

#include <any>

#include "actio/groups/predictor_corrector.hpp"

namespace actio::detail {

/// The solver of a step on momenta, kept from call to call where the calls follow one another. A step is a
/// callable at every group and scalar, so the type of its solver shows at the first call only.
///
/// A call with another length, or from elsewhere, finds the derivative of the last call and no prediction.
/// Solutions do not depend on what is remembered beyond rounding. For one thread at a time; copies are
/// independent.
class RememberedSolutions {
 public:
  /// The solver for a step of length h from a velocity; it predicts if both are what they were, or nearly so.
  template <Group G, Group Algebra, Real S>
  PredictorCorrector<G, S>& solver(Velocity<Algebra, S> const& velocity, Base<S> const& h) const {
    using Solver = Kept<G, Algebra, S>;
    Solver* kept = std::any_cast<Solver>(&kept_);
    if (!kept || (kept->at && kept->at->size() != velocity.coordinates.size()))
      kept = &kept_.emplace<Solver>();
    auto const jump =
        kept->at ? magnitude(Coordinates<Algebra, S>(velocity.coordinates - *kept->at)) : Base<S>(0);
    if (!kept->at || !(kept->length == h) || !(jump * Base<S>(4) <= magnitude(velocity.coordinates)))
      kept->solver.forget_solutions();
    kept->at = velocity.coordinates;
    kept->length = h;
    return kept->solver;
  }

 private:
  template <Group G, Group Algebra, Real S>
  struct Kept {
    PredictorCorrector<G, S> solver;
    std::optional<Coordinates<Algebra, S>> at;
    Base<S> length{};
  };
  mutable std::any kept_;
};

}  // namespace actio::detail
