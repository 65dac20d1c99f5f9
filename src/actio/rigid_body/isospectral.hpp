// What the Moser-Veselov scheme conserves: a matrix polynomial evolves by similarity (isospectrally), so the
// coefficients of its determinant are conserved (thesis, chapter 1 and section 5.2).
//
// With \f$X = f^T\Lambda\f$ for a relative motion f, h times the body momenta before the step and after it
// appear in
//
//     1 - lambda h M0 - lambda^2 Lambda^2 =   (1 + lambda X^T) (1 - lambda X),
//     1 - lambda h M1 - lambda^2 Lambda^2 = f (1 - lambda X) (1 + lambda X^T) f^T.
//
// The same two factors, exchanged: so the two matrices are similar for every lambda, and all coefficients of
// \f$\det(\zeta - \lambda hM - \lambda^2\Lambda^2)\f$ are conserved. Those without \f$\Lambda^2\f$ are
// Casimirs, floor(n/2) of them. The others are in involution, and they are as many as half the dimension of a
// generic coadjoint orbit. On the branch that grows out of the identity the two factors are told apart by
// their spectra, and the determinant of each is conserved: so is the discrete Lagrangian Tr(f Lambda). With
// one variable fewer some are missing: \f$\det(1 - \lambda hM - \lambda^2\Lambda^2)\f$ has n-1 coefficients
// that depend on M, enough for n = 3 only.
#pragma once

#include <vector>

#include "actio/rigid_body/casimirs.hpp"

namespace actio {

/// \f$1 - \lambda M - \lambda^2\Lambda^2\f$.
/// @param inertia   \f$\Lambda\f$ as a symmetric matrix; mass x length^2
/// @param momentum  h times a body momentum as a skew matrix; mass x length^2
/// @param lambda    1/(mass x length^2)
/// @throws OutsideDomain, NotFinite where the two matrices are of different sizes, or \f$\Lambda\f$ has an
///         entry that is no number
template <MatrixLike L, MatrixLike M>
auto lax_matrix(L const& inertia, M const& momentum, typename M::Scalar const& lambda) {
  using S = typename M::Scalar;
  detail::require_inertia_matrix(inertia, momentum.rows(), "lax_matrix");
  typename M::PlainObject const squared = inertia.template cast<S>() * inertia.template cast<S>();
  typename M::PlainObject lax = momentum * S(-lambda) - squared * S(lambda * lambda);
  lax.diagonal().array() += S(1);
  return lax;
}
/// \f$1 - \lambda X\f$ with \f$X = f^T\Lambda\f$.
template <MatrixLike L, int n, Scalar S>
Storage<SO<n>, S> lax_factor(L const& inertia, Element<SO<n>, S> const& f, S const& lambda) {
  detail::require_inertia_matrix(inertia, f.value.rows(), "lax_factor");
  Storage<SO<n>, S> factor = f.value.transpose() * inertia.template cast<S>() * S(-lambda);
  factor.diagonal().array() += S(1);
  return factor;
}
/// The Lax matrix of the momentum before the step with relative motion f, from its factors.
template <MatrixLike L, int n, Scalar S>
Storage<SO<n>, S> lax_matrix_before(L const& inertia, Element<SO<n>, S> const& f, S const& lambda) {
  return lax_factor(inertia, f, S(-lambda)).transpose() * lax_factor(inertia, f, lambda);
}
/// The Lax matrix of the momentum after it: the factors exchanged, and turned by f.
///
/// \implements{claim_1_0_moser_veselov_integrable}
template <MatrixLike L, int n, Scalar S>
Storage<SO<n>, S> lax_matrix_after(L const& inertia, Element<SO<n>, S> const& f, S const& lambda) {
  // [claim_1_0_moser_veselov_integrable]
  return f.value * lax_factor(inertia, f, lambda) * lax_factor(inertia, f, S(-lambda)).transpose() *
         f.value.transpose();
  // [claim_1_0_moser_veselov_integrable]
}

/// Of which degree an integral is in the momentum, and in \f$\Lambda^2\f$. It is a Casimir where the second
/// is zero.
struct IsospectralDegree {
  int momentum;  ///< even, at least 2
  int inertia;   ///< zero for a Casimir
};
/// The degrees of the integrals for n by n matrices: (2k, j) with \f$1\le k\le n/2\f$ and
/// \f$0\le j\le n-2k\f$.
std::vector<IsospectralDegree> isospectral_degrees(int n);

/// All integrals that the spectrum of the Lax matrix gives, in the order of \ref isospectral_degrees: the
/// coefficients of \f$z^{n-2k-j}s^j\f$ in \f$\det(z - M - s\Lambda^2)\f$.
///
/// By Faddeev's and Leverrier's recursion with matrices that are polynomials in s: exact over the rationals,
/// differentiable everywhere.
/// @param inertia  \f$\Lambda\f$ as a symmetric matrix; mass x length^2
/// @param pi       a body momentum; the unit is free, since each integral is homogeneous in it
/// @throws OutsideDomain  where the two are of different sizes
/// @throws NotFinite      where an entry is no number
template <MatrixLike L, int n, Scalar S>
Matrix<S, Dynamic, 1> isospectral_integrals(L const& inertia, Momentum<SO<n>, S> const& pi) {
  using Whole = Matrix<S, Dynamic, Dynamic>;
  Whole const m = pi.group.hat(pi.components);
  int const size = static_cast<int>(m.rows());
  detail::require_inertia_matrix(inertia, size, "isospectral_integrals: Lambda");
  require_finite(m, "isospectral_integrals: momentum");
  Whole const squared = inertia.template cast<S>() * inertia.template cast<S>();

  auto const degrees = isospectral_degrees(size);
  Matrix<S, Dynamic, 1> integrals(degrees.size());
  std::vector<Whole> power{Whole::Identity(size, size)};  // by powers of s
  for (int step = 1; step <= size; ++step) {
    std::vector<Whole> next(step + 1, Whole::Zero(size, size));
    for (int j = 0; j < step; ++j) next[j] += m * power[j], next[j + 1] += squared * power[j];
    for (int j = 0; j <= step; ++j) {
      S const c = -next[j].trace() / S(step);
      next[j].diagonal().array() += c;
      for (std::size_t a = 0; a < degrees.size(); ++a)
        if (degrees[a].inertia == j && degrees[a].momentum == step - j) integrals[a] = c;
    }
    power = std::move(next);
  }
  return integrals;
}

}  // namespace actio
