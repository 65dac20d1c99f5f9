// A small move along the coadjoint orbit that takes energy and angular momentum back, in single precision.
//
// W <- W + [Y, W] + [Y, [Y, W]]/2 with Y = sum c_i X_i, X_0 = [P, W] where the energy is to be taken back,
// and X_j = [iS_j, W]. The four numbers change by minus the inner products of Y with the X_i. So instead of
// the X_i the Y may have any part of them, for instance that on a few diagonals: the matrix of the inner
// products is then that of the parts, and the commutators with Y take no product of matrices. Where those
// diagonals do not hold what is needed, as for a flow that many turns leave as it is, Y is whole.
//
// What is added to W has two traps. The second order is lost where it is added to the first one in single
// precision, and the squares of W then grow by that of each move. And numbers of single precision end about
// where those of W do: their sums lie half-way between two numbers of double precision often, and the second
// order, which makes W smaller, decides which of the two is taken. So Y is rounded times a number that is no
// power of two, and the orders are divided by it, and added, in double precision.
#pragma once

#include <Eigen/Core>

#include "actio/quantized_sphere/spin_columns.hpp"
#include "actio/skew_matrices/banded_commutator.hpp"
#include "actio/skew_matrices/dense_matrices.hpp"
#include "actio/skew_matrices/single_cayley.hpp"

namespace actio::sphere {

/// Adds \f$\sum c_iX_i\f$: X_0, where there is one, and \f$X_j = [iS_j, W]\f$ for the axes of the turns.
template <class Real>
void add_combination(SpinColumns<Real> const& spins, SkewHermitian<Real> const* x0,
                     SkewHermitian<Real> const& w, Eigen::VectorXd const& factors, SkewHermitian<Real>& out) {
  Eigen::Index const first = x0 ? 1 : 0;
  if (spins.count() != 0)
    spins.over(w, [&](Eigen::Index c, auto const& pieces) {
      for (std::size_t a = 0; a < pieces.size(); ++a) {
        Real const f = static_cast<Real>(factors[first + static_cast<Eigen::Index>(a)]);
        out.real.col(c).tail(w.size() - c) += f * pieces[a].real.matrix();
        out.imaginary.col(c).tail(w.size() - c) += f * pieces[a].imaginary.matrix();
      }
    });
  if (x0)
    for (Eigen::Index c = 0; c < w.size(); ++c) {
      auto const rows = w.size() - c;
      Real const f = static_cast<Real>(factors[0]);
      out.real.col(c).tail(rows) += f * x0->real.col(c).tail(rows);
      out.imaginary.col(c).tail(rows) += f * x0->imaginary.col(c).tail(rows);
    }
  mirror_lower(out);
}

/// A move along the orbit.
/// @tparam Real  in which it is found
template <class Real = float>
class OrbitMove {
 public:
  using Axes = std::vector<Eigen::Vector3d>;  ///< unit vectors

  /// @param axes  along which the angular momentum is taken back
  OrbitMove(QuantizedSphere const& sphere, Axes axes)
      : axes_(std::move(axes)),
        spins_(sphere, axes_),
        spin_scale_(std::sqrt(sphere.n / 3.0) / sphere.hbar()) {}

  /// Diagonals that Y has below its own, where that is enough.
  static constexpr Eigen::Index few_diagonals = 2;

  Axes const& axes() const { return axes_; }  ///< of the angular momentum

  /// Finds Y by a Newton step.
  /// @param p        P in single precision; null where the energy is not to be taken back
  /// @param w        W in single precision
  /// @param change   what is to be taken back: of \f$\langle P, W\rangle\f$ first, where there is a P
  /// @param scale    of the first: |P|
  /// @param longest  |Y| up to which a few diagonals will do
  /// @return         with a P the c of the whole Y, else those of the one that is taken
  Eigen::VectorXd find(SingleCayley& products, SkewHermitian<Real> const* p, SkewHermitian<Real> const& w,
                       Eigen::VectorXd const& change, double scale, double longest) {
    if (p) products.commutator(*p, w, once_);
    SkewHermitian<Real> const* const x0 = p ? &once_ : nullptr;
    Eigen::VectorXd units = Eigen::VectorXd::Constant(change.size(), spin_scale_);
    if (p) units[0] = scale;
    Eigen::VectorXd const sought = change.cwiseQuotient(units);
    Newton taken = newton(x0, w, sought, units, few_diagonals + 1);
    is_banded_ = taken.solved;
    if (is_banded_) take_band(x0, w, off_grid * taken.factors), is_banded_ = length_ <= longest;
    if (p || !is_banded_) taken = newton(x0, w, sought, units, w.size());
    if (!is_banded_) {
      y_.real.setZero(w.size(), w.size()), y_.imaginary.setZero(w.size(), w.size());
      add_combination(spins_, x0, w, off_grid * taken.factors, y_);
      length_ = static_cast<double>(norm(y_)) / off_grid;
    }
    return taken.factors;
  }
  double length() const { return length_; }      ///< |Y|
  bool is_banded() const { return is_banded_; }  ///< whether Y is on a few diagonals

  /// Adds \f$[Y, W] + \tfrac12[Y, [Y, W]]\f$ to the state of which w is the rounding.
  void move(SingleCayley& products, SkewHermitian<Real> const& w, SkewHermitian<>& state) {
    bracket(products, w, once_);
    mirror_lower(once_);
    bool const is_long = static_cast<double>(norm(once_)) > shortest * static_cast<double>(norm(w));
    if (is_long) bracket(products, once_, twice_), mirror_lower(twice_);
    auto const add = [&](auto const& one, auto const& two, auto& to) {
      if (is_long)
        to += (1 / off_grid) * one.template cast<double>() +
              (0.5 / (off_grid * off_grid)) * two.template cast<double>();
      else
        to += (1 / off_grid) * one.template cast<double>();
    };
    add(once_.real, twice_.real, state.real), add(once_.imaginary, twice_.imaginary, state.imaginary);
  }

 private:
  static constexpr double shortest = 5e-10;   ///< move of W, relative, whose square matters after many steps
  static constexpr double off_grid = 0.7236;  ///< what Y is kept times
  static constexpr double cutoff = 1e-5;      ///< of eigenvalues that single precision tells from zero
  static constexpr double left_over = 1e-6;   ///< of what is sought: more than rounding in single precision

  void bracket(SingleCayley& products, SkewHermitian<Real> const& x, SkewHermitian<Real>& out) const {
    if (is_banded_)
      banded_commutator(band_, x, out);
    else
      products.commutator(y_, x, out);
  }

  /// Of the factors.
  struct Newton {
    Eigen::VectorXd factors;
    bool solved;  ///< whether they do all that is sought
  };
  /// The Newton step: the inner products of the X, in units of what they are commutators of, inverted as far
  /// as they are regular. Entries below the diagonal count for two.
  /// @param depth  of the X as many diagonals are taken, their own among them
  Newton newton(SkewHermitian<Real> const* x0, SkewHermitian<Real> const& w, Eigen::VectorXd const& sought,
                Eigen::VectorXd const& units, Eigen::Index depth) const {
    auto const count = sought.size(), first = count - static_cast<Eigen::Index>(spins_.count());
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(count, count);
    auto const sum = [](auto const& a, auto const& b) {
      return 2 * static_cast<double>(a.dot(b)) - static_cast<double>(a[0]) * static_cast<double>(b[0]);
    };
    auto const of_first = [&](Eigen::Index c, auto const& part) {
      return part.col(c).segment(c, std::min(depth, w.size() - c));
    };
    auto const add_first = [&](Eigen::Index c) {
      auto const r = of_first(c, x0->real), i = of_first(c, x0->imaginary);
      gram(0, 0) += sum(r, r) + sum(i, i);
    };
    if (spins_.count() == 0)
      for (Eigen::Index c = 0; c < w.size(); ++c) add_first(c);
    else
      spins_.over(
          w,
          [&](Eigen::Index c, auto const& pieces) {
            if (x0) add_first(c);
            for (std::size_t a = 0; a < pieces.size(); ++a) {
              auto const i = first + static_cast<Eigen::Index>(a);
              if (x0)
                gram(i, 0) += sum(of_first(c, x0->real), pieces[a].real.matrix()) +
                              sum(of_first(c, x0->imaginary), pieces[a].imaginary.matrix());
              for (std::size_t b = 0; b <= a; ++b)
                gram(i, first + static_cast<Eigen::Index>(b)) +=
                    sum(pieces[a].real.matrix(), pieces[b].real.matrix()) +
                    sum(pieces[a].imaginary.matrix(), pieces[b].imaginary.matrix());
            }
          },
          depth);
    gram = units.cwiseInverse().asDiagonal() * gram * units.cwiseInverse().asDiagonal();
    Eigen::VectorXd const factors = regular_solution(gram, sought, cutoff);
    Eigen::VectorXd const left = gram.template selfadjointView<Eigen::Lower>() * factors - sought;
    return {factors.cwiseQuotient(units), left.norm() <= left_over * sought.norm()};
  }
  /// Y on a few diagonals, from its factors.
  void take_band(SkewHermitian<Real> const* x0, SkewHermitian<Real> const& w,
                 Eigen::VectorXd const& factors) {
    Eigen::Index const n = w.size(), depth = few_diagonals + 1, first = x0 ? 1 : 0;
    band_.real.setZero(depth, n), band_.imaginary.setZero(depth, n);
    if (spins_.count() != 0)
      spins_.over(
          w,
          [&](Eigen::Index c, auto const& pieces) {
            for (std::size_t a = 0; a < pieces.size(); ++a) {
              Real const f = static_cast<Real>(factors[first + static_cast<Eigen::Index>(a)]);
              band_.real.col(c).head(pieces[a].real.size()) += f * pieces[a].real;
              band_.imaginary.col(c).head(pieces[a].real.size()) += f * pieces[a].imaginary;
            }
          },
          depth);
    if (x0)
      for (Eigen::Index c = 0; c < n; ++c) {
        auto const rows = std::min(depth, n - c);
        Real const f = static_cast<Real>(factors[0]);
        band_.real.col(c).head(rows) += f * x0->real.col(c).segment(c, rows).array();
        band_.imaginary.col(c).head(rows) += f * x0->imaginary.col(c).segment(c, rows).array();
      }
    length_ = static_cast<double>(norm(band_)) / off_grid;
  }

  Axes axes_;
  SpinColumns<Real> spins_;
  double spin_scale_;       ///< |iS_j|
  bool is_banded_ = false;  ///< whether Y is the one on a few diagonals
  double length_ = 0;       ///< |Y|
  SkewBand<Real> band_;
  SkewHermitian<Real> y_, once_, twice_;
};

}  // namespace actio::sphere
