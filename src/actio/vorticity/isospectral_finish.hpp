// The end of a step, isospectral to the rounding of double precision, from a middle that need not solve its
// equation.
//
// For any skew A and any Wt, with C = [A, Wt] and the residual
//
//   r = W_0 + C + A Wt A - Wt,        W_1 = W_0 - r + 2C + U r U^*,  U = cay(A),
//
// is cay(A) W_0 cay(A)^*, whatever r is. The equation is evaluated once in double precision. Where r is of
// the size of a rounding in single precision, U r U^* may be found in single precision, and the spectrum of
// W_1 is that of W_0 to the rounding of double precision.
//
// What would add up over many steps is kept small (better_middle).
#pragma once

#include <Eigen/Core>

#include <cmath>

#include "actio/skew_matrices/single_cayley.hpp"

namespace actio::sphere {

/// Entries up to which size count for nothing: far from the diagonals of smooth flows there are no others.
struct Negligible {
  double of_a = 0;  ///< those of A
  double of_w = 0;  ///< those of W

  /// Those that are below the rounding of double precision in what A and W do to one another.
  /// @param radius  of A: its largest eigenvalue
  /// @param size    |W|, of n eigenvalues
  static Negligible beside(double radius, double size, Eigen::Index n) {
    constexpr double share = 1e-16;
    return {share * radius, share * size / std::sqrt(static_cast<double>(n))};
  }
};

/// From A to the middle of a step, found in single precision, and from there to its end.
/// @tparam Real  of the state
template <class Real = double>
class IsospectralFinish {
 public:
  /// With memory that is taken when the size is known.
  explicit IsospectralFinish(Products const& products) : products_(products), cayley_(products) {}

  /// The transform with which middle and end are found: of the A with which it was last factored.
  SingleCayley& transform() { return cayley_; }

  /// \f$\tilde W = (1-A)^{-1}W_0(1+A)^{-1}\f$ by the transform, and the mean of both ends.
  /// @param rounded  W_0 in single precision
  /// @param mean     whether the mean is wanted
  void find_middle(SkewHermitian<Real> const& w, SkewHermitian<float> const& rounded, bool mean,
                   SkewHermitian<Real>& middle, SkewHermitian<Real>& average) {
    for (SkewHermitian<Real>* m : {&middle, &average})
      if (m->size() != w.size()) *m = SkewHermitian<Real>(w.size());
    cayley_.conjugate(rounded, twice_, square_, reach_in_single(rounded));
    for (Eigen::Index c = 0; c < w.size(); ++c) {
      auto const below = [c, rows = w.size() - c](auto& m) { return m.col(c).tail(rows); };
      auto const put = [&](auto const& start, auto const& f, auto const& e, auto& to, auto& to_mean) {
        below(to) = below(start) + (below(f) + below(e)).template cast<Real>();
        if (mean) below(to_mean) = below(start) + (below(f) + 2.F * below(e)).template cast<Real>();
      };
      put(w.real, twice_.real, square_.real, middle.real, average.real);
      put(w.imaginary, twice_.imaginary, square_.imaginary, middle.imaginary, average.imaginary);
    }
    mirror_lower(middle);
    if (mean) mirror_lower(average);
  }

  /// Evaluates the equation of a step: C, A Wt A and r; \f$|r|\f$. Three products of real matrices, and the
  /// halves of three.
  /// @param negligible  what may be left out of them, and of those with r
  double evaluate(SkewHermitian<Real> const& w, SkewHermitian<Real> const& a,
                  SkewHermitian<Real> const& middle, Negligible const& negligible = {}) {
    negligible_ = negligible;
    products_.multiply_half(a, middle, commutator_,
                            {useful_reach(a.real, a.imaginary, negligible.of_a),
                             useful_reach(middle.real, middle.imaginary, negligible.of_w)});
    products_.multiply_again_half(a, remainder_);
    if (residual_.size() != w.size()) residual_ = SkewHermitian<float>(w.size());
    double squares = 0;
    for (Eigen::Index c = 0; c < w.size(); ++c) {
      auto const below = [c, rows = w.size() - c](auto& m) { return m.col(c).tail(rows); };
      auto const put = [&](auto const& half_change, auto const& rest, auto const& mid, auto const& start,
                           auto&& r) {
        r = ((below(half_change) + below(rest)) - (below(mid) - below(start))).template cast<float>();
        squares += 2 * static_cast<double>(r.squaredNorm()) - static_cast<double>(r[0]) * r[0];
      };
      put(commutator_.real, remainder_.real, middle.real, w.real, below(residual_.real));
      put(commutator_.imaginary, remainder_.imaginary, middle.imaginary, w.imaginary,
          below(residual_.imaginary));
    }
    mirror_lower(residual_);
    return std::sqrt(squares);
  }
  /// The middle Wt + r in the place of Wt: C and r become C + [A, r] and [A, r] + A r A.
  ///
  /// The transform has made an r that holds [W_0, dA], with what A was rounded by. A product of that r with
  /// the same rounded A makes the squares of W grow by |[dA, W_0]|^2: always to the same side, so that it
  /// would add up. So A is rounded afresh here, otherwise in each step.
  /// @param number  another one in each of some steps that follow one another
  /// @param middle  Wt, on and below the diagonal
  void better_middle(SkewHermitian<Real> const& a, int number, SkewHermitian<Real>& middle) {
    add_lower(residual_, middle);
    // Multiples of the golden section lie evenly, and none of the first is near a power of two.
    double const golden = 0.6180339887498949 * (number + 1);
    cayley_.evaluate(a, 0.5 + 0.5 * (golden - std::floor(golden)), residual_, twice_, square_,
                     reach_of_residual());
    residual_.real = twice_.real + square_.real, residual_.imaginary = twice_.imaginary + square_.imaginary;
    mirror_lower(residual_), mirror_lower(twice_);
    commutator_.real += twice_.real.template cast<Real>();
    commutator_.imaginary += twice_.imaginary.template cast<Real>();
  }
  /// \f$W_1 = W_0 + 2C + (U r U^* - r)\f$, by the transform; and the middle that belongs to A, which is
  /// \f$(1-A)^{-1}r(1+A)^{-1}\f$ away from Wt, on and below its diagonal.
  void find_end(SkewHermitian<Real> const& w, SkewHermitian<Real>& middle, SkewHermitian<Real>& end) {
    if (end.size() != w.size()) end = SkewHermitian<Real>(w.size());
    cayley_.conjugate(residual_, twice_, square_, reach_of_residual());
    for (Eigen::Index c = 0; c < w.size(); ++c) {
      auto const below = [c, rows = w.size() - c](auto& m) { return m.col(c).tail(rows); };
      auto const put = [&](auto const& start, auto const& half_change, auto const& r, auto const& f,
                           auto const& e, auto& mid, auto& to) {
        below(mid) += (below(r) + (below(f) + below(e))).template cast<Real>();
        below(to) = below(start) +
                    (2 * below(half_change) + (2.F * (below(f) + 2.F * below(e))).template cast<Real>());
      };
      put(w.real, commutator_.real, residual_.real, twice_.real, square_.real, middle.real, end.real);
      put(w.imaginary, commutator_.imaginary, residual_.imaginary, twice_.imaginary, square_.imaginary,
          middle.imaginary, end.imaginary);
    }
    mirror_lower(end);
  }

 private:
  Eigen::Index reach_of_residual() const {
    return useful_reach(residual_.real, residual_.imaginary, static_cast<float>(negligible_.of_w));
  }
  /// Adds a matrix on and below the diagonal.
  static void add_lower(SkewHermitian<float> const& x, SkewHermitian<Real>& to) {
    for (Eigen::Index c = 0; c < x.size(); ++c) {
      auto const rows = x.size() - c;
      to.real.col(c).tail(rows) += x.real.col(c).tail(rows).template cast<Real>();
      to.imaginary.col(c).tail(rows) += x.imaginary.col(c).tail(rows).template cast<Real>();
    }
  }
  SkewProducts<Real> products_;
  SingleCayley cayley_;
  SkewHermitian<Real> commutator_, remainder_;
  SkewHermitian<float> residual_, twice_, square_;
  Negligible negligible_;  ///< as the equation was evaluated
};

}  // namespace actio::sphere
