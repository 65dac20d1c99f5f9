// The theorem of Lagrange multipliers in finitely many dimensions (Theorem 7.1.1), with its hypothesis as a
// check.
//
// The manifold is an open set of R^m, the bundle over it is trivial with fibre R^k and an inner product that
// may depend on the point: a metric as in metric.hpp, a callable on points. "Extremum" is a point where the
// derivative vanishes. The augmented function is affine in the multiplier, so it never has a strict minimum
// or maximum.
#pragma once

#include "actio/constraints/regularity.hpp"
#include "actio/forms/metric.hpp"

namespace actio {

/// A function h on R^m under the constraint \f$\Psi = 0\f$ with values in the fibres of an inner product
/// bundle.
///
/// \implements{thm_7_1_1}
/// @tparam k      how many components \f$\Psi\f$ has
/// @tparam H      h, a callable on points over any scalar
/// @tparam Psi    \f$\Psi\f$, a callable on points that returns a column of k numbers
/// @tparam Fibre  the inner product of the fibres: a metric over points of R^m
template <int k, class H, class Psi, class Fibre = Euclidean<k>>
struct ConstrainedFunction {
  H h;               ///< the function
  Psi constraint;    ///< what vanishes
  Fibre fibre = {};  ///< inner product of the fibres

  /// \f$dh\f$ at a point.
  template <class S, int m>
  Matrix<S, m, 1> differential(Matrix<S, m, 1> const& q) const { return derivative(h, q).gradient(); }

  /// \f$D\Psi\f$ at a point: k rows, m columns.
  template <class S, int m>
  Matrix<S, k, m> constraint_derivative(Matrix<S, m, 1> const& q) const {
    return derivative(constraint, q).matrix;
  }

  /// Refuses a point at which \f$D\Psi\f$ is not onto.
  /// @throws NotRegular
  template <class S, int m>
  void require_regular(Matrix<S, m, 1> const& q) const {
    require_onto(constraint_derivative(q), q, "ConstrainedFunction");
  }

  /// The first statement of the theorem: \f$dh\f$ on a basis of the kernel of \f$D\Psi\f$, the tangent space
  /// of the zeros. It vanishes at critical points of the restriction.
  /// @throws NotRegular  where the kernel is not a tangent space
  template <class S, int m>
  Matrix<S, Dynamic, 1> restricted_differential(Matrix<S, m, 1> const& q) const {
    require_regular(q);
    return echelon(constraint_derivative(q)).kernel().transpose() * differential(q);
  }

  /// The augmented function \f$\bar h(q, \lambda) = h(q) - \langle\lambda, \Psi(q)\rangle_q\f$.
  template <class S, int m>
  S augmented(Matrix<S, m, 1> const& q, Matrix<S, k, 1> const& lambda) const {
    // [thm_7_1_1]
    return h(q) - inner(fibre(q), lambda, Matrix<S, k, 1>(constraint(q)));
    // [thm_7_1_1]
  }

  /// The second statement: the differential of \ref augmented in q and in \f$\lambda\f$, m + k numbers.
  template <class S, int m>
  Matrix<S, m + k, 1> augmented_differential(Matrix<S, m, 1> const& q, Matrix<S, k, 1> const& lambda) const {
    Matrix<S, m + k, 1> both;
    both << q, lambda;
    auto const augmented_at = [&]<class T>(Matrix<T, m + k, 1> const& at) -> T {
      return augmented(Matrix<T, m, 1>(at.template head<m>()), Matrix<T, k, 1>(at.template tail<k>()));
    };
    return derivative(augmented_at, both).gradient();
  }

  /// The multiplier at a point: the \f$\lambda\f$ for which \f$\langle\lambda, D\Psi\rangle\f$ is closest to
  /// \f$dh\f$. At a critical point of the restriction they are equal.
  ///
  /// \implements{claim_7_1_first_to_second}
  /// @throws NotRegular  where \f$D\Psi\f$ is not onto: there may be no multiplier, or many
  /// Accuracy: that of the normal equations; exact over the rationals.
  template <class S, int m>
  Matrix<S, k, 1> multiplier(Matrix<S, m, 1> const& q) const {
    require_regular(q);
    // [claim_7_1_first_to_second]
    Matrix<S, k, m> const A = lowered(fibre(q), constraint_derivative(q));
    return solve_linear(Matrix<S, k, k>(A * A.transpose()), Matrix<S, k, 1>(A * differential(q)),
                        "multiplier");
    // [claim_7_1_first_to_second]
  }
};

/// A function under a constraint with k components, and the usual inner product of R^k.
///
/// \snippet fields.cpp constrained
template <int k, class H, class Psi>
ConstrainedFunction<k, H, Psi> constrained(H h, Psi constraint) {
  return {std::move(h), std::move(constraint), {}};
}
/// The same with an inner product of the fibres.
template <int k, class H, class Psi, class Fibre>
ConstrainedFunction<k, H, Psi, Fibre> constrained(H h, Psi constraint, Fibre fibre) {
  return {std::move(h), std::move(constraint), std::move(fibre)};
}

}  // namespace actio
