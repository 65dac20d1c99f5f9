// The discrete rigid body among all matrices: a multiplier holds its attitudes on the group (thesis, section
// 5.2).
//
// Attitudes are n by n matrices g_k, free to be any, and the constraint g g^T = 1 enters the action with a
// symmetric matrix of multipliers for each configuration. The action is scaled: -h times that of
// moser_veselov.hpp, in mass x length^2, up to a constant. Lambda is symmetric, not necessarily diagonal: the
// body may be described in any frame of its own.
//
// Varying configuration k over all matrices gives n^2 equations. Their symmetric half says what the
// multiplier is, their skew half is the equation of motion,
//
//     g_{k+1} Lambda + g_{k-1} Lambda = lambda_k g_k, f_{k+1k}^T Lambda + f_{kk-1} Lambda = g_k^T lambda_k
//     g_k,
//
// in space and in the body, f_{k+1k} = g_{k+1}^T g_k. No solver is here and no root: everything runs over the
// rationals.
#pragma once

#include <initializer_list>
#include <vector>

#include "actio/numbers/errors.hpp"

namespace actio {

namespace detail {
/// Refuses matrices that are not all n by n, or have an entry that is no number.
template <class M>
void require_squares(std::initializer_list<M const*> matrices, Index n, char const* where) {
  for (M const* m : matrices) {
    if (n == 0 || m->rows() != n || m->cols() != n)
      throw OutsideDomain(where, "square matrices of one size are needed; rows and size",
                          static_cast<double>(m->rows()), static_cast<double>(n));
    require_finite(*m, where);
  }
}
/// Refuses a matrix that is not symmetric up to rounding.
template <class M>
void require_symmetric(M const& m, char const* where) {
  using T = Base<typename M::Scalar>;
  T const scale = magnitude(m), skew = magnitude(M(m - m.transpose()));
  if (skew > T(16) * epsilon<T>() * scale)
    throw OutsideDomain(
        where,
        "a symmetric matrix is needed; largest difference across the diagonal, in units of the largest entry",
        to_double(T(skew / scale)), 16 * to_double(epsilon<T>()));
}
/// \f$\mathrm{Tr}(A B^T)\f$, entry by entry.
template <class M>
typename M::Scalar trace_of_product(M const& a, M const& b) {
  typename M::Scalar sum(0);
  for (Index j = 0; j < a.cols(); ++j)
    for (Index i = 0; i < a.rows(); ++i) sum += a(i, j) * b(i, j);
  return sum;
}
}  // namespace detail

/// The constraint \f$\Phi(g) = g\,g^T - 1\f$: a symmetric matrix, zero on the orthogonal group.
template <class M>
M orthogonality(M const& g) {
  M excess = g * g.transpose();
  excess.diagonal().array() -= typename M::Scalar(1);
  return excess;
}

/// The constrained action sum, a function of all configurations and all multipliers.
///
/// \f[ S = \sum_k\mathrm{Tr}(g_k\Lambda g_{k+1}^T) - \tfrac12\sum_k\mathrm{Tr}\bigl(\lambda_k\,(g_kg_k^T -
///   1)\bigr) \f]
///
/// \implements{eq_5_6}
/// @param lambda       \f$\Lambda\f$, symmetric; mass x length^2
/// @param g            the configurations: any square matrices, at least two
/// @param multipliers  \f$\lambda_k\f$, one for each configuration; mass x length^2. A skew part of them has
///   no effect
/// @throws NotFinite      where an entry is no number
/// @throws OutsideDomain  where sizes or numbers do not fit, or \f$\Lambda\f$ is not symmetric
/// Exact up to rounding.
template <class M>
typename M::Scalar constrained_action(M const& lambda, std::vector<M> const& g,
                                      std::vector<M> const& multipliers) {
  char const* const where = "constrained action";
  if (g.size() < 2 || multipliers.size() != g.size())
    throw OutsideDomain(
        where,
        "two configurations or more, and a multiplier for each, are needed; multipliers and configurations",
        static_cast<double>(multipliers.size()), static_cast<double>(g.size()));
  detail::require_squares({&lambda}, lambda.rows(), where);
  detail::require_symmetric(lambda, "constrained action: Lambda");
  for (std::size_t k = 0; k < g.size(); ++k)
    detail::require_squares({&g[k], &multipliers[k]}, lambda.rows(), where);

  typename M::Scalar sum(0), held(0);
  // [eq_5_6]
  for (std::size_t k = 0; k + 1 < g.size(); ++k) sum += detail::trace_of_product(M(g[k] * lambda), g[k + 1]);
  for (std::size_t k = 0; k < g.size(); ++k)
    held += detail::trace_of_product(multipliers[k], orthogonality(g[k]));
  return sum - held / typename M::Scalar(2);
  // [eq_5_6]
}

/// The residual at configuration k of the equations of the constrained action:
/// \f$(g_{k+1} + g_{k-1})\Lambda - \lambda_kg_k\f$, zero along motions with their multiplier, and only there.
///
/// The gradient of \ref constrained_action in the entries of \f$g_k\f$, for a symmetric multiplier.
/// @param lambda      \f$\Lambda\f$, symmetric; mass x length^2
/// @param before      \f$g_{k-1}\f$
/// @param g           \f$g_k\f$
/// @param after       \f$g_{k+1}\f$
/// @param multiplier  \f$\lambda_k\f$, symmetric; mass x length^2
/// @throws NotFinite, OutsideDomain  as \ref constrained_action
template <class M>
M constrained_stationarity(M const& lambda, M const& before, M const& g, M const& after,
                           M const& multiplier) {
  detail::require_squares({&lambda, &before, &g, &after, &multiplier}, lambda.rows(),
                          "constrained stationarity");
  detail::require_symmetric(lambda, "constrained stationarity: Lambda");
  detail::require_symmetric(multiplier, "constrained stationarity: multiplier");
  return (after + before) * lambda - multiplier * g;
}

/// The multiplier at a rotation \f$g_k\f$ between its neighbours: the symmetric half of
/// \f$(g_{k+1} + g_{k-1})\Lambda g_k^T\f$. Along a motion there is no other half.
///
/// @param lambda  \f$\Lambda\f$, symmetric; mass x length^2
/// @param before  \f$g_{k-1}\f$
/// @param g       \f$g_k\f$, a rotation
/// @param after   \f$g_{k+1}\f$
/// @return        \f$\lambda_k\f$, in the spatial frame; mass x length^2
/// @throws NotFinite, OutsideDomain  as \ref constrained_action
template <class M>
M spatial_multiplier(M const& lambda, M const& before, M const& g, M const& after) {
  detail::require_squares({&lambda, &before, &g, &after}, lambda.rows(), "multiplier");
  detail::require_symmetric(lambda, "multiplier: Lambda");
  M const pull = (after + before) * lambda * g.transpose();
  return (pull + pull.transpose()) / typename M::Scalar(2);
}

/// The multiplier in the body frame, \f$\bar\lambda_k = g_k^T\lambda_kg_k\f$: it is invariant under left
/// multiplication of all configurations.
/// \implements{claim_5_2_conjugate_multiplier}
///
/// @param g           \f$g_k\f$, a rotation
/// @param multiplier  \f$\lambda_k\f$, in the spatial frame; mass x length^2
/// @throws NotFinite, OutsideDomain  as \ref constrained_action
template <class M>
M body_multiplier(M const& g, M const& multiplier) {
  detail::require_squares({&g, &multiplier}, g.rows(), "multiplier of the body");
  // [claim_5_2_conjugate_multiplier]
  return g.transpose() * multiplier * g;
  // [claim_5_2_conjugate_multiplier]
}

/// The residual of the reduced equation with a multiplier:
/// \f$f_{21}^T\Lambda + f_{10}\Lambda - \bar\lambda\f$. \implements{claim_5_2_dep_with_multiplier}
///
/// @param lambda      \f$\Lambda\f$, symmetric; mass x length^2
/// @param f10         relative motion \f$g_1^Tg_0\f$ over the step before
/// @param f21         relative motion \f$g_2^Tg_1\f$ over the step after
/// @param multiplier  \f$\bar\lambda\f$ at the configuration between, in the body frame; mass x length^2
/// @throws NotFinite, OutsideDomain  as \ref constrained_action
template <class M>
M euler_poincare_with_multiplier(M const& lambda, M const& f10, M const& f21, M const& multiplier) {
  detail::require_squares({&lambda, &f10, &f21, &multiplier}, lambda.rows(),
                          "Euler-Poincare with multiplier");
  detail::require_symmetric(lambda, "Euler-Poincare with multiplier: Lambda");
  // [claim_5_2_dep_with_multiplier]
  return f21.transpose() * lambda + f10 * lambda - multiplier;
  // [claim_5_2_dep_with_multiplier]
}

/// Its skew half, from which the multiplier is eliminated:
/// \f$f_{21}^T\Lambda - \Lambda f_{21} - (\Lambda f_{10}^T - f_{10}\Lambda)\f$, a skew matrix.
/// \implements{eq_5_7}
///
/// For a diagonal \f$\Lambda\f$ it is h times the residual of the scheme in moser_veselov.hpp, which has it
/// in coordinates.
/// @param lambda  \f$\Lambda\f$, symmetric; mass x length^2
/// @param f10     relative motion \f$g_1^Tg_0\f$ over the step before
/// @param f21     relative motion \f$g_2^Tg_1\f$ over the step after
/// @throws NotFinite, OutsideDomain  as \ref constrained_action
template <class M>
M euler_poincare_without_multiplier(M const& lambda, M const& f10, M const& f21) {
  detail::require_squares({&lambda, &f10, &f21}, lambda.rows(), "Euler-Poincare without multiplier");
  detail::require_symmetric(lambda, "Euler-Poincare without multiplier: Lambda");
  // [eq_5_7]
  return f21.transpose() * lambda - lambda * f21 - (lambda * f10.transpose() - f10 * lambda);
  // [eq_5_7]
}

}  // namespace actio
