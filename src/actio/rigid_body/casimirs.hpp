// Casimir functions of so(n)*, and their pull-backs to the group (thesis, section 5.3).
//
// A skew matrix has floor(n/2) independent invariants under rotations: the coefficients of its characteristic
// polynomial, which has only every second one, with the last replaced by its root, the Pfaffian, where n is
// even. The first is the squared length of the momentum. Every one of them is constant on coadjoint orbits;
// the Legendre map of a left-invariant discrete Lagrangian carries it to a Casimir of the bracket on the
// group. The two Legendre maps, before the step and after it, differ by a coadjoint motion, so they give the
// same function.
#pragma once

#include "actio/groups/rotations_of_any_size.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"

namespace actio {
namespace detail {

/// Refuses a \f$\Lambda\f$ that is no n by n matrix of finite numbers.
template <MatrixLike L>
void require_inertia_matrix(L const& inertia, Index n, char const* where) {
  if (inertia.rows() != n || inertia.cols() != n)
    throw OutsideDomain(where, "Lambda must be as large as the matrices of the group; rows",
                        static_cast<double>(inertia.rows()), static_cast<double>(n));
  require_finite(inertia, where);
}

}  // namespace detail

/// The coefficients \f$c_1, c_2, \dots\f$ of \f$\det(z - B) = (z^m + c_1z^{m-1} + \dots + c_m)^r\f$ by
/// Faddeev's and Leverrier's recursion.
///
/// Four operations and division by whole numbers: exact over the rationals, and differentiable where the
/// matrix is singular.
/// @param b  square
/// @param r  multiplicity that every eigenvalue is known to have; divides the number of rows
/// @throws OutsideDomain  where the matrix is not square, or its size no multiple of r
/// @throws NotFinite      where an entry is no number
/// Accuracy: rounding of the largest product on the way; for up to ten rows or so.
template <MatrixLike B>
auto characteristic_coefficients(B const& b, int r = 1) {
  using S = typename B::Scalar;
  using Whole = Matrix<S, Dynamic, Dynamic>;
  int const size = static_cast<int>(b.rows());
  if (b.cols() != size)
    throw OutsideDomain("characteristic_coefficients", "a square matrix is needed; columns and rows",
                        static_cast<double>(b.cols()), size);
  if (r < 1 || size % r != 0)
    throw OutsideDomain("characteristic_coefficients", "the multiplicity must divide the size", r, size);
  require_finite(b, "characteristic_coefficients");
  Whole const matrix = b;
  Whole n = Whole::Identity(size, size);
  Matrix<S, Dynamic, 1> c(size / r);
  for (int k = 1; k <= size / r; ++k) {
    n = Whole(matrix * n);
    c[k - 1] = -n.trace() / S(r * k);
    n.diagonal().array() += c[k - 1];
  }
  return c;
}

/// The Pfaffian of a skew matrix of even size, \f$\mathrm{Pf}(M)^2 = \det M\f$, with
/// \f$\mathrm{Pf}\begin{pmatrix}0&1\\-1&0\end{pmatrix} = 1\f$.
///
/// With E made of such blocks, the eigenvalues of \f$E^TM\f$ come in equal pairs, and the Pfaffian is the
/// product of one from each pair.
/// @throws OutsideDomain  where the size is odd
template <MatrixLike M>
typename M::Scalar pfaffian(M const& m) {
  using S = typename M::Scalar;
  int const size = static_cast<int>(m.rows());
  if (size % 2 != 0)
    throw OutsideDomain("pfaffian", "a skew matrix of even size is needed; rows", size, size + 1);
  if (size == 0) return S(1);
  Matrix<S, Dynamic, Dynamic> turned(size, m.cols());
  for (int i = 0; i < size; i += 2) turned.row(i) = -m.row(i + 1), turned.row(i + 1) = m.row(i);
  auto const c = characteristic_coefficients(turned, 2);
  return (size / 2) % 2 == 0 ? c[size / 2 - 1] : -c[size / 2 - 1];
}

/// \f$C(\mu) = \mathrm{Tr}(\mu^2) = -2|\mu|^2\f$ on so(n)*: never positive.
/// \implements{claim_5_3_dual_casimir}
template <int n, Scalar S>
S trace_of_square(Momentum<SO<n>, S> const& mu) {
  auto const m = mu.group.hat(mu.components);
  // [claim_5_3_dual_casimir]
  return (m * m).trace();
  // [claim_5_3_dual_casimir]
}

/// The floor(n/2) independent Casimirs of so(n)* at mu, of degrees 2, 4, ... in mu, and n/2 for the last
/// where n is even.
///
/// \f[ \det(z - \mu) = z^n + C_1z^{n-2} + C_2z^{n-4} + \dots, \qquad C_1 = |\mu|^2, \f]
/// for even n the last one being the Pfaffian, whose square is the last coefficient.
/// @throws NotFinite  where the momentum is no number
template <int n, Scalar S>
Matrix<S, Dynamic, 1> casimirs(Momentum<SO<n>, S> const& mu) {
  auto const m = mu.group.hat(mu.components);
  auto const c = characteristic_coefficients(m);
  int const count = static_cast<int>(m.rows()) / 2;
  Matrix<S, Dynamic, 1> values(count);
  for (int k = 0; k < count; ++k) values[k] = c[2 * k + 1];
  if (m.rows() % 2 == 0) values[count - 1] = pfaffian(m);
  return values;
}

/// The Casimirs of the bracket on the group: those of so(n)* at the body momentum before the step,
/// \f$\Pi_0 = -L_f^*\ell'(f)\f$.
/// @param l  any left-invariant discrete Lagrangian, as a function of \f$f = g_1^{-1}g_0\f$; energy x time
template <int n, Scalar S, class F>
Matrix<S, Dynamic, 1> casimirs_before(F const& l, Element<SO<n>, S> const& f) {
  return casimirs(momentum_before_left(l, f));
}
/// The same functions through the other Legendre map, at the body momentum after the step,
/// \f$\Pi_1 = -R_f^*\ell'(f)\f$.
template <int n, Scalar S, class F>
Matrix<S, Dynamic, 1> casimirs_after(F const& l, Element<SO<n>, S> const& f) {
  return casimirs(-right_differential(l, f));
}

/// \f$C(f) = \mathrm{Tr}(f\Lambda f\Lambda)\f$: the first Casimir of the Moser-Veselov Lagrangian on the
/// group, which is \f$\mathrm{Tr}\Lambda^2 - h^2|\Pi|^2\f$ for the body momentum before the step and after
/// it.
///
/// \implements{eq_5_10}
/// @param lambda  \f$\Lambda\f$ as a symmetric matrix; mass x length^2
/// @throws OutsideDomain, NotFinite  where it is not as large as f, or has an entry that is no number
template <MatrixLike L, int n, Scalar S>
S trace_casimir(L const& lambda, Element<SO<n>, S> const& f) {
  detail::require_inertia_matrix(lambda, f.value.rows(), "trace_casimir");
  Storage<SO<n>, S> const x = f.value * lambda.template cast<S>();
  // [eq_5_10]
  return (x * x).trace();
  // [eq_5_10]
}

}  // namespace actio
