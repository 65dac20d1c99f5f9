// Steps that the first guess of the next one is made from: what a fast step keeps of each, and polynomials in
// time through them.
#pragma once

#include <algorithm>
#include <deque>

#include "actio/vorticity/skew_hermitian.hpp"

namespace actio {

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
  void take(SkewHermitian<> const& m) {
    resize(m.size());
    over_columns(m.size(), [&](Eigen::Index c, Eigen::Index at) {
      auto const rows = m.size() - c;
      real.segment(at, rows) = m.real.col(c).tail(rows);
      imaginary.segment(at, rows) = m.imaginary.col(c).tail(rows);
    });
  }
  /// That of a difference.
  void take_difference(SkewHermitian<> const& a, SkewHermitian<> const& b) {
    resize(a.size());
    over_columns(a.size(), [&](Eigen::Index c, Eigen::Index at) {
      auto const rows = a.size() - c;
      real.segment(at, rows) = a.real.col(c).tail(rows) - b.real.col(c).tail(rows);
      imaginary.segment(at, rows) = a.imaginary.col(c).tail(rows) - b.imaginary.col(c).tail(rows);
    });
  }
  /// The matrix, of the size n.
  void put(Eigen::Index n, SkewHermitian<>& m) const {
    if (m.size() != n) m = SkewHermitian<>(n);
    over_columns(n, [&](Eigen::Index c, Eigen::Index at) {
      m.real.col(c).tail(n - c) = real.segment(at, n - c);
      m.imaginary.col(c).tail(n - c) = imaginary.segment(at, n - c);
    });
    mirror_lower(m);
  }
  /// The sum of another matrix and this one.
  void put_sum(SkewHermitian<> const& other, SkewHermitian<>& m) const {
    auto const n = other.size();
    if (m.size() != n) m = SkewHermitian<>(n);
    over_columns(n, [&](Eigen::Index c, Eigen::Index at) {
      m.real.col(c).tail(n - c) = other.real.col(c).tail(n - c) + real.segment(at, n - c);
      m.imaginary.col(c).tail(n - c) = other.imaginary.col(c).tail(n - c) + imaginary.segment(at, n - c);
    });
    mirror_lower(m);
  }

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
inline PastStep make_room(std::deque<PastStep>& past, int most) {
  if (static_cast<int>(past.size()) < most) return {};
  PastStep oldest = std::move(past.back());
  past.pop_back();
  return oldest;
}

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
inline void extrapolate(std::deque<PastStep> const& past, LowerHalf PastStep::*which, int most,
                        LowerHalf& out) {
  auto const each = [&](Eigen::VectorXd LowerHalf::*part) {
    Eigen::VectorXd& sum = out.*part;
    sum.resize((past.front().*which.*part).size());
    // A piece of the sum stays near while the steps are added.
    constexpr Eigen::Index piece = 1024;
    for (Eigen::Index at = 0; at < sum.size(); at += piece) {
      auto to = sum.segment(at, std::min(piece, sum.size() - at));
      to.setZero();
      extrapolate(
          past,
          [&](PastStep const& step, double weight) {
            to += weight * (step.*which.*part).segment(at, to.size());
          },
          most);
    }
  };
  each(&LowerHalf::real), each(&LowerHalf::imaginary);
}
/// \f$|A-B|/|B|\f$ with the polynomial A of the displacements, by some of their columns.
inline double error_of_guess(std::deque<PastStep> const& past, int most, SkewHermitian<> const& b) {
  auto const n = b.size();
  double apart = 0, size = 0;
  Eigen::VectorXd difference;
  LowerHalf::over_columns(n, [&](Eigen::Index c, Eigen::Index at) {
    // Sixteen columns or so, evenly spread.
    if (n > 16 && c % (n / 16) != 0) return;
    auto const rows = n - c;
    auto const add = [&](auto const& column, Eigen::VectorXd LowerHalf::*part) {
      difference = -column;
      extrapolate(
          past,
          [&](PastStep const& step, double weight) {
            difference += weight * (step.displacement.*part).segment(at, rows);
          },
          most);
      apart += difference.squaredNorm(), size += column.squaredNorm();
    };
    add(b.real.col(c).tail(rows), &LowerHalf::real),
        add(b.imaginary.col(c).tail(rows), &LowerHalf::imaginary);
  });
  return size == 0 ? std::sqrt(apart) : std::sqrt(apart / size);
}

}  // namespace actio
