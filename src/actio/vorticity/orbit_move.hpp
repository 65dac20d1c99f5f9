// A small move along the coadjoint orbit that takes energy and angular momentum back, in single precision.
//
// W <- W + [Y, W] + [Y, [Y, W]]/2 with Y = sum c_i X_i, X_0 = [P, W] where the energy is to be taken back,
// and X_j = [iS_j, W]. The four numbers change by minus the inner products of Y with the X_i.
#pragma once

#include "actio/vorticity/dense_matrices.hpp"
#include "actio/vorticity/single_cayley.hpp"
#include "actio/vorticity/spin_columns.hpp"

namespace actio {

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

  Axes const& axes() const { return axes_; }  ///< of the angular momentum

  /// Finds Y by a Newton step.
  /// @param p       P in single precision; null where the energy is not to be taken back
  /// @param w       W in single precision
  /// @param change  what is to be taken back: of \f$\langle P, W\rangle\f$ first, where there is a P
  /// @param scale   of the first: |P|
  /// @return        the c
  Eigen::VectorXd find(SingleCayley& products, SkewHermitian<Real> const* p, SkewHermitian<Real> const& w,
                       Eigen::VectorXd const& change, double scale) {
    if (p) products.commutator(*p, w, once_);
    SkewHermitian<Real> const* const x0 = p ? &once_ : nullptr;
    Eigen::VectorXd const factors = newton(x0, w, change, scale);
    y_.real.setZero(w.size(), w.size()), y_.imaginary.setZero(w.size(), w.size());
    add_combination(spins_, x0, w, factors, y_);
    return factors;
  }
  double length() const { return static_cast<double>(norm(y_)); }  ///< |Y|

  /// Adds \f$[Y, W] + \tfrac12[Y, [Y, W]]\f$ to the state of which w is the rounding. Without the last term
  /// the squares of W would grow by that of each move, which never takes them back.
  void move(SingleCayley& products, SkewHermitian<Real> const& w, SkewHermitian<>& state) {
    products.commutator(y_, w, once_);
    mirror_lower(once_);
    if (static_cast<double>(norm(once_)) > shortest * static_cast<double>(norm(w))) {
      products.commutator(y_, once_, twice_);
      mirror_lower(twice_);
      once_.real += Real(0.5) * twice_.real, once_.imaginary += Real(0.5) * twice_.imaginary;
    }
    state.real += once_.real.template cast<double>();
    state.imaginary += once_.imaginary.template cast<double>();
  }

 private:
  static constexpr double shortest = 5e-10;  ///< move of W, relative, whose square matters after many steps
  static constexpr double cutoff = 1e-5;     ///< of eigenvalues that single precision tells from zero

  /// The Newton step of the factors: the inner products of the X, in units of what they are commutators of,
  /// inverted as far as they are regular. Entries below the diagonal count for two.
  Eigen::VectorXd newton(SkewHermitian<Real> const* x0, SkewHermitian<Real> const& w,
                         Eigen::VectorXd const& change, double scale_of_first) const {
    auto const count = change.size(), first = count - static_cast<Eigen::Index>(spins_.count());
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(count, count);
    auto const sum = [](auto const& a, auto const& b) {
      return 2 * static_cast<double>(a.dot(b)) - static_cast<double>(a[0]) * static_cast<double>(b[0]);
    };
    if (spins_.count() == 0)
      for (Eigen::Index c = 0; c < w.size(); ++c) {
        auto const r = x0->real.col(c).tail(w.size() - c), i = x0->imaginary.col(c).tail(w.size() - c);
        gram(0, 0) += sum(r, r) + sum(i, i);
      }
    else
      spins_.over(w, [&](Eigen::Index c, auto const& pieces) {
        auto const rows = w.size() - c;
        if (x0) {
          auto const r = x0->real.col(c).tail(rows), i = x0->imaginary.col(c).tail(rows);
          gram(0, 0) += sum(r, r) + sum(i, i);
          for (std::size_t a = 0; a < pieces.size(); ++a)
            gram(first + static_cast<Eigen::Index>(a), 0) +=
                sum(r, pieces[a].real.matrix()) + sum(i, pieces[a].imaginary.matrix());
        }
        for (std::size_t a = 0; a < pieces.size(); ++a)
          for (std::size_t b = 0; b <= a; ++b)
            gram(first + static_cast<Eigen::Index>(a), first + static_cast<Eigen::Index>(b)) +=
                sum(pieces[a].real.matrix(), pieces[b].real.matrix()) +
                sum(pieces[a].imaginary.matrix(), pieces[b].imaginary.matrix());
      });
    Eigen::VectorXd scale = Eigen::VectorXd::Constant(count, spin_scale_);
    if (x0) scale[0] = scale_of_first;
    gram = scale.cwiseInverse().asDiagonal() * gram * scale.cwiseInverse().asDiagonal();
    return regular_solution(gram, change.cwiseQuotient(scale), cutoff).cwiseQuotient(scale);
  }

  Axes axes_;
  SpinColumns<Real> spins_;
  double spin_scale_;  ///< |iS_j|
  SkewHermitian<Real> y_, once_, twice_;
};

}  // namespace actio
