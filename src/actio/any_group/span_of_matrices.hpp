// A group of the library made from an algebra that is told at run time, so that everything written for any
// group runs on it.
#pragma once

#include <memory>
#include <utility>

#include "actio/any_group/matrix_algebra.hpp"
#include "actio/groups/algebra_logarithm.hpp"
#include "actio/groups/group.hpp"
#include "actio/groups/restore_by_logarithm.hpp"

namespace actio::systems {

/// The connected group of matrices with a given algebra: \ref SpannedGroup for bases of real matrices.
///
/// It models the concept `ExponentialGroup`. Where cubes of elements of the algebra are in the algebra,
/// retraction and `restore` are by Cayley's transform; elsewhere (SL(n) and SU(n) for n > 2) the retraction
/// is the exponential, and `restore` goes through the logarithm.
struct SpanOfMatrices {
  static constexpr int size = Dynamic;
  static constexpr int dim = Dynamic;

  /// Of an algebra, which copies share.
  explicit SpanOfMatrices(std::shared_ptr<MatrixAlgebra const> algebra)
      : algebra_(std::move(algebra)), cayley_stays_(cubes_stay()) {}
  /// Of an algebra.
  explicit SpanOfMatrices(MatrixAlgebra algebra)
      : SpanOfMatrices(std::make_shared<MatrixAlgebra const>(std::move(algebra))) {}

  /// Whether both have the same algebra, by its address.
  bool operator==(SpanOfMatrices const&) const = default;

  int matrix_size() const { return algebra_->size; }
  int dimension() const { return algebra_->dimension; }
  /// The algebra.
  MatrixAlgebra const& algebra() const { return *algebra_; }
  /// Whether Cayley's transform maps the algebra into the group.
  bool cayley_stays() const { return cayley_stays_; }

  template <MatrixLike V>
  auto hat(V const& v) const { return algebra_->hat(v); }
  template <MatrixLike M>
  auto vee(M const& a) const { return algebra_->vee(a); }
  template <class S>
  Vector<S> bracket(Vector<S> const& v, Vector<S> const& w) const { return algebra_->bracket(v, w); }
  /// @throws Singular        where Cayley's transform has no value
  /// @throws NotInThisField  over the rationals, where the retraction is the exponential
  template <class S>
  Matrix<S> retract(Vector<S> const& v) const {
    if (cayley_stays_) return cayley(hat(v));
    if constexpr (Real<S>)
      return matrix_exponential(hat(v));
    else
      throw NotInThisField("retract", "an exponential is needed on " + algebra_->name + "; fractions", 1, 0);
  }
  /// @throws OutsideDomain  at and next to an eigenvalue on the negative axis, and where the principal
  ///                        logarithm is not in the algebra
  template <Real S>
  Vector<S> log(Matrix<S> const& a) const { return logarithm_in_algebra<SpanOfMatrices, S>(*this, a); }
  /// Next to an eigenvalue -1, or where the principal logarithm leaves the algebra, the element as it is.
  /// @throws OutsideDomain  where it is not even near the group
  template <Real S>
  Matrix<S> restore(Matrix<S> const& a) const {
    if (cayley_stays_) return primitive::restore_by_cayley(*this, a);
    return primitive::restore_by_logarithm(*this, a);
  }

 private:
  std::shared_ptr<MatrixAlgebra const> algebra_;
  bool cayley_stays_;

  /// Tried on one element of the algebra with coordinates that have nothing in common.
  bool cubes_stay() const;
};

}  // namespace actio::systems
