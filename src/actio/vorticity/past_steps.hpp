// Steps that the first guess of the next one is made from: what a fast step keeps of each, and polynomials in
// time through them.
#pragma once

#include <deque>

#include "actio/vorticity/skew_hermitian.hpp"

namespace actio {

/// A step that was made, as the first guess of the next one needs it.
struct PastStep {
  /// Of what A is moved by: energy, and up to three directions.
  using Factors = Eigen::Vector4d;

  SkewHermitian<> displacement;    ///< A
  SkewHermitian<float> increment;  ///< Wt - W_0
  Factors factors;                 ///< of this step
  double first_change = 1;         ///< of A, relative, by the first of its rounds: how good the guess was
  int wait = 0;                    ///< steps for which the guess is not tried as the solution
  double radius = 0;               ///< an estimate of the largest eigenvalue of A over |A|
  int age = 0;                     ///< steps since it was made
};

/// Leaves less than so many steps.
/// @return  a step whose memory may be used again: the oldest, where there were as many
inline PastStep make_room(std::deque<PastStep>& past, int most) {
  if (static_cast<int>(past.size()) < most) return {};
  PastStep oldest = std::move(past.back());
  past.pop_back();
  return oldest;
}

/// Calls `use(step, weight)` for each of the steps before, the newest first: the weights are those of the
/// polynomial in time through all of them, one step further.
template <class Step, class Use>
void extrapolate(std::deque<Step> const& past, Use const& use) {
  auto const count = static_cast<int>(past.size());
  double binomial = 1;
  for (int k = 0; k < count; ++k) {
    binomial *= static_cast<double>(count - k) / (k + 1);
    use(past[static_cast<std::size_t>(k)], k % 2 == 0 ? binomial : -binomial);
  }
}
/// Adds that polynomial to what m has.
/// @param which  of the matrices of a step
template <class Matrix>
void add_extrapolated(std::deque<PastStep> const& past, Matrix PastStep::*which, SkewHermitian<>& m) {
  auto const n = m.size();
  // Column by column, so that what is added to is read from memory once.
  for (Eigen::Index c = 0; c < n; ++c)
    extrapolate(past, [&](PastStep const& step, double weight) {
      auto const add = [&](auto const& part, auto& to) {
        to.col(c).tail(n - c) += weight * part.col(c).tail(n - c).template cast<double>();
      };
      add((step.*which).real, m.real), add((step.*which).imaginary, m.imaginary);
    });
  mirror_lower(m);
}

}  // namespace actio
