// Steps that the first guess of the next one is made from: what a fast step keeps of each, and polynomials in
// time through them.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <deque>

#include "actio/skew_matrices/skew_hermitian.hpp"

namespace actio::sphere {

/// A skew-Hermitian matrix by what is on and below its diagonal, column by column without gaps: half of the
/// memory, and read from its beginning to its end.
struct LowerHalf {
  Eigen::VectorXd real;       ///< of the real part
  Eigen::VectorXd imaginary;  ///< of the imaginary part

  /// Of how many numbers each part consists.
  static Eigen::Index count(Eigen::Index n) { return n * (n + 1) / 2; }
  /// Calls `use(c, at)` for each column, whose numbers are from `at` on.
  template <class Use>
  static void over_columns(Eigen::Index n, Use const& use) {
    for (Eigen::Index c = 0, at = 0; c < n; at += n - c, ++c) use(c, at);
  }

  /// That of a matrix.
  void take(SkewHermitian<> const& m);
  /// That of a difference.
  void take_difference(SkewHermitian<> const& a, SkewHermitian<> const& b);
  /// The matrix, of the size n.
  void put(Eigen::Index n, SkewHermitian<>& m) const;
  /// The sum of another matrix and this one.
  void put_sum(SkewHermitian<> const& other, SkewHermitian<>& m) const;

 private:
  void resize(Eigen::Index n) { real.resize(count(n)), imaginary.resize(count(n)); }
};

/// A step that was made, as the first guess of the next one needs it.
struct PastStep {
  /// Of what A is moved by: energy, and up to three directions.
  using Factors = Eigen::Vector4d;

  LowerHalf displacement;  ///< A
  LowerHalf increment;     ///< Wt - W_0
  Factors factors;         ///< of this step
  double guess_error = 1;  ///< of A, relative, by the polynomial of which a guess may be the solution
  int wait = 0;            ///< steps for which the guess is not tried as the solution
  double radius = 0;       ///< an estimate of the largest eigenvalue of A over |A|
  int age = 0;             ///< steps since it was made
};

/// Leaves less than so many steps.
/// @return  a step whose memory may be used again: the oldest, where there were as many
PastStep make_room(std::deque<PastStep>& past, int most);

/// Calls `use(step, weight)` for each of the newest steps, the newest first: the weights are those of the
/// polynomial in time through all of them, one step further.
/// @param most  of the steps, where there are more
template <class Step, class Use>
void extrapolate(std::deque<Step> const& past, Use const& use, int most = 64) {
  int const count = std::min(most, static_cast<int>(past.size()));
  double binomial = 1;
  for (int k = 0; k < count; ++k) {
    binomial *= static_cast<double>(count - k) / (k + 1);
    use(past[static_cast<std::size_t>(k)], k % 2 == 0 ? binomial : -binomial);
  }
}
/// That polynomial of the matrices of the steps.
/// @param which  of the matrices of a step
void extrapolate(std::deque<PastStep> const& past, LowerHalf PastStep::*which, int most, LowerHalf& out);
/// \f$|A-B|/|B|\f$ with the polynomial A of the displacements, by some of their columns.
double error_of_guess(std::deque<PastStep> const& past, int most, SkewHermitian<> const& b);

}  // namespace actio::sphere
