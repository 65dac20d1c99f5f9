// Solutions of one equation after another, as the steps of an integrator ask for them: predicted from the
// last ones, corrected by the chord iteration.
#pragma once

#include "actio/groups/chord_iteration.hpp"
#include "actio/numbers/extrapolation.hpp"

namespace actio {

/// Solves a sequence of equations on G whose solutions \f$f_k\f$ change smoothly with k.
///
/// The changes \f$\delta_k\f$, \f$f_k = e^{\delta_k}f_{k-1}\f$, are as smooth as the solutions and small, so
/// that no chart ends on the way: the next one is extrapolated (\ref Extrapolation), and what it misses is
/// left to the \ref ChordIteration. A prediction only says where the iteration starts: the solutions are
/// those of \ref solve_on_group to rounding.
///
/// Over scalars that are no plain numbers, such as dual numbers, each equation is solved by Newton's
/// iteration.
template <ExponentialGroup G, Real S>
class PredictorCorrector {
 public:
  /// Before the first equation; \ref solve starts it where it is told.
  PredictorCorrector() = default;
  /// @param last  the solution before the first
  explicit PredictorCorrector(Element<G, S> const& last) : last_(last) {}

  /// The next solution.
  ///
  /// @param residual  element at any scalar -> covector at the same scalar
  /// @param start     where to start as long as nothing is known of the sequence, and where Newton's
  /// iteration starts if the chord iteration fails
  /// @throws Singular, NotConverged, NotFinite  as \ref solve_on_group from `start`; the sequence stays what
  /// it was
  template <class Residual>
  Element<G, S> solve(Residual const& residual, Element<G, S> const& start) {
    if constexpr (Plain<S>) {
      if (!last_ || changes_.empty()) return remember(iteration_.solve(residual, start));
      Velocity<G, S> const expected{start.group, changes_.next()};
      Element<G, S> const found = iteration_.solve(residual, exp(expected) * *last_, start);
      if (iteration_.by_newton()) {
        // The sequence has turned out not to be smooth here.
        changes_.clear();
        return remember(found);
      }
      // The change that would have been right, to first order in what the extrapolation has missed.
      Velocity<G, S> const missed{start.group, iteration_.moved()};
      changes_.push((expected + missed + bracket(missed, expected) / S(2)).coordinates);
      last_ = found;
      return found;
    } else {
      auto solved = solve_on_group(residual, start);
      report_ = std::move(solved.report);
      return solved.value;
    }
  }
  /// Forgets the solutions, not the derivative: the next equation is started where \ref solve is told.
  void forget_solutions() {
    last_.reset();
    changes_.clear();
  }
  /// How the last equation was solved.
  Report const& report() const {
    if constexpr (Plain<S>)
      return iteration_.report();
    else
      return report_;
  }
  /// How often a derivative was evaluated, since the beginning.
  long derivatives() const
    requires Plain<S>
  {
    return iteration_.derivatives();
  }

 private:
  Element<G, S> const& remember(Element<G, S> const& found) {
    try {
      if (last_) changes_.push(log(found * inverse(*last_)).coordinates);
    } catch (OutsideDomain const&) {
      changes_.clear();
    }
    return last_.emplace(found);
  }

  ChordIteration<G, S> iteration_;
  Extrapolation<Coordinates<G, S>> changes_;
  std::optional<Element<G, S>> last_;
  Report report_;
};

}  // namespace actio
