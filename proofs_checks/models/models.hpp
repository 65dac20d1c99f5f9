// Models that can tell right from wrong: groups with sides and stars that matter, Lagrangians that are
// neither even nor symmetric.
//
// All groups are one type (SpannedGroup), so a check is compiled once and runs over all of them. All
// functions are polynomials in the entries of matrices, so every check that needs no root runs over a prime
// field and the rationals, where its residual must be exactly zero.
//
// A check that needs a discrete motion does not solve for one: it draws the configurations, and changes the
// Lagrangian by terms linear in new coefficients until they are a motion of it (`with_motion_*`). That works
// at every scalar, and no solver is on trial.
#pragma once

#include <string>
#include <vector>

#include "actio/groups/affine_line.hpp"
#include "actio/groups/linear_groups.hpp"
#include "actio/groups/motions.hpp"
#include "actio/groups/spanned_group.hpp"
#include "actio/groups/unipotent_groups.hpp"
#include "actio/reduction/discrete_euler_lagrange.hpp"
#include "actio/reduction/discrete_euler_poincare.hpp"
#include "actio/variational/state.hpp"
#include "claim.hpp"

namespace actio::checks {

// ---- The groups

/// A matrix group of the library as the span of its basis.
template <MatrixGroup G>
SpannedGroup spanned(std::string name, G const& group) {
  std::vector<SpannedGroup::WholeMatrix> basis;
  for (int a = 0; a < group.dimension(); ++a)
    basis.push_back(group.hat(Matrix<int, G::dim, 1>(Matrix<int, G::dim, 1>::Unit(a))));
  return SpannedGroup(std::move(name), std::move(basis));
}
// Written out in models.cpp, compiled once.

/// SU(2) as left multiplication of quaternions: real 4 by 4 matrices.
SpannedGroup spanned_su2();
/// The groups every statement is tried on. SO(3) alone would hide a lost star or side; Aff(1) and SE(3) do
/// not.
std::vector<SpannedGroup> const& all_groups();
/// Four of them, for checks that cost much: SO(3), SE(3), Aff(1), GL(2).
std::vector<SpannedGroup> const& few_groups();

// ---- Functions

/// \f$\langle A, B\rangle = \sum_{ij}A_{ij}B_{ij}\f$, A plain and B of any scalar.
template <class S, class T>
T contract(Matrix<S> const& a, Matrix<T> const& b) {
  T sum(0);
  for (Index i = 0; i < a.rows(); ++i)
    for (Index j = 0; j < a.cols(); ++j) sum += b(i, j) * T(a(i, j));
  return sum;
}

/// A function on a group, cubic in the entries: \f$\tfrac12\sum_k\langle W_k, f-1\rangle^2 + \langle C,
/// f\rangle + \kappa\,\langle W_1, f-1\rangle^3 + \lambda\,\langle W_1, f-1\rangle\langle W_2,
/// f-1\rangle^2\f$.
///
/// Regular near the identity; not even, so it knows the direction of time; invariant under nothing.
template <class S>
struct GroupPolynomial {
  std::vector<Matrix<S>> squares;
  Matrix<S> linear;
  S kappa, lambda;
  // corrections by sum c_k <phi_k, f> <psi_k, f>, none unless a motion was asked for
  std::vector<Matrix<S>> phi, psi;
  Vector<S> correction;

  template <class T>
  T operator()(Element<SpannedGroup, T> const& f) const {
    Matrix<T> d = f.value;
    T sum = contract(linear, d);
    d.diagonal().array() -= T(1);
    T first(0), second(0);
    for (std::size_t k = 0; k < squares.size(); ++k) {
      T const q = contract(squares[k], d);
      sum += q * q / 2;
      if (k == 0) first = q;
      if (k == 1) second = q;
    }
    for (Index k = 0; k < correction.size(); ++k)
      sum += contract(phi[k], f.value) * contract(psi[k], f.value) * T(correction[k]);
    return sum + first * first * first * T(kappa) + first * second * second * T(lambda);
  }
};
/// A function on pairs: a polynomial in both configurations, invariant under nothing:
/// \f$\tfrac12\sum_k\langle W_k, g_1-g_0\rangle^2 + \langle A, g_0\rangle\langle B, g_1\rangle + \langle C,
/// g_1\rangle\langle D, g_1\rangle^2 + \sum_a c_a\langle\Phi_a, g_0\rangle\langle\Psi_a, g_1\rangle\f$.
template <class S>
struct PairPolynomial {
  std::vector<Matrix<S>> squares;
  Matrix<S> a, b, c, d;
  std::vector<Matrix<S>> phi, psi;
  Vector<S> correction;

  template <class T>
  T operator()(Element<SpannedGroup, T> const& g0, Element<SpannedGroup, T> const& g1) const {
    Matrix<T> const x = g0.value, y = g1.value, difference = y - x;
    T const dy = contract(d, y);
    T sum = contract(a, x) * contract(b, y) + contract(c, y) * dy * dy;
    for (auto const& w : squares) {
      T const q = contract(w, difference);
      sum += q * q / 2;
    }
    for (Index k = 0; k < correction.size(); ++k)
      sum += contract(phi[k], x) * contract(psi[k], y) * T(correction[k]);
    return sum;
  }
};
/// A function on the algebra: \f$\tfrac12\xi^TA\xi + b^T\xi + \tfrac\kappa3\,(c^T\xi)^3\f$, A symmetric and
/// positive definite.
template <class S>
struct AlgebraPolynomial {
  Matrix<S> a;
  Vector<S> b, c;
  S kappa;

  template <class T>
  T operator()(Velocity<SpannedGroup, T> const& xi) const { return value(xi.coordinates); }
  template <class T>
  T operator()(Momentum<SpannedGroup, T> const& mu) const { return value(mu.components); }

 private:
  template <class T>
  T value(Vector<T> const& x) const {
    T sum(0), along(0);
    for (Index i = 0; i < x.size(); ++i) {
      T row(0);
      for (Index j = 0; j < x.size(); ++j) row += x[j] * T(a(i, j));
      sum += x[i] * row / 2 + x[i] * T(b[i]);
      along += x[i] * T(c[i]);
    }
    return sum + along * along * along * T(kappa) / 3;
  }
};
/// A Lagrangian on TG, invariant under nothing: an algebra polynomial of the velocity \f$\dot g g^{-1}\f$,
/// plus \f$\langle U, g\rangle\,(v^T\xi) + \langle W, g\rangle^2\f$.
template <class S>
struct StatePolynomial {
  AlgebraPolynomial<S> kinetic;
  Matrix<S> u, w;
  Vector<S> v;

  template <class T>
  T operator()(State<SpannedGroup, T> const& state) const {
    Matrix<T> const g = state.configuration.value;
    T along(0);
    for (Index i = 0; i < v.size(); ++i) along += state.velocity.coordinates[i] * T(v[i]);
    T const well = contract(w, g);
    return kinetic(state.velocity) + contract(u, g) * along + well * well;
  }
};

// ---- Drawing them

template <class S>
Matrix<S> draw_matrix(Draw& draw, int rows, int columns) {
  Matrix<S> m(rows, columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) m(i, j) = draw.number<S>();
  return m;
}
template <class S>
Vector<S> draw_vector(Draw& draw, int n) { return draw_matrix<S>(draw, n, 1); }
/// Rows that span the dual of the algebra: the basis itself, bent a little, and one more.
template <class S>
std::vector<Matrix<S>> draw_squares(Draw& draw, SpannedGroup const& group) {
  int const n = group.matrix_size();
  std::vector<Matrix<S>> squares;
  for (int a = 0; a < group.dimension(); ++a)
    squares.push_back(group.hat(basis_velocity<S>(group, a).coordinates) +
                      draw_matrix<S>(draw, n, n) * ratio<S>(1, 8));
  squares.push_back(draw_matrix<S>(draw, n, n));
  return squares;
}
template <class S>
GroupPolynomial<S> draw_group_polynomial(Draw& draw, SpannedGroup const& group) {
  int const n = group.matrix_size();
  return {draw_squares<S>(draw, group),
          draw_matrix<S>(draw, n, n) * ratio<S>(1, 4),
          draw.number<S>() * ratio<S>(1, 4),
          draw.number<S>() * ratio<S>(1, 4),
          {},
          {},
          {}};
}
template <class S>
PairPolynomial<S> draw_pair_polynomial(Draw& draw, SpannedGroup const& group) {
  int const n = group.matrix_size();
  auto const small = [&] { return Matrix<S>(draw_matrix<S>(draw, n, n) * ratio<S>(1, 4)); };
  PairPolynomial<S> p{draw_squares<S>(draw, group),      small(), small(), small(), small(), {}, {},
                      Vector<S>::Zero(group.dimension())};
  for (int k = 0; k < group.dimension(); ++k)
    p.phi.push_back(draw_matrix<S>(draw, n, n)), p.psi.push_back(draw_matrix<S>(draw, n, n));
  return p;
}
template <class S>
AlgebraPolynomial<S> draw_algebra_polynomial(Draw& draw, int n) {
  Matrix<S> const m = draw_matrix<S>(draw, n, n) * ratio<S>(1, 4);
  Matrix<S> const a = Matrix<S>::Identity(n, n) + m * m.transpose();
  return {a, draw_vector<S>(draw, n), draw_vector<S>(draw, n), draw.number<S>() * ratio<S>(1, 4)};
}
template <class S>
StatePolynomial<S> draw_state_polynomial(Draw& draw, SpannedGroup const& group) {
  int const n = group.matrix_size();
  auto kinetic = draw_algebra_polynomial<S>(draw, group.dimension());
  auto u = draw_matrix<S>(draw, n, n), w = draw_matrix<S>(draw, n, n);
  return {kinetic, u, w, draw_vector<S>(draw, group.dimension())};
}

// ---- Motions by design

namespace detail {
/// Adds quadratic terms to `l` until `residual(l)`, which is affine in their coefficients, vanishes.
template <class S, class Residual>
GroupPolynomial<S> corrected(GroupPolynomial<S> l, SpannedGroup const& group, Draw& draw,
                             Residual const& residual) {
  int const d = group.dimension(), n = group.matrix_size();
  for (int k = 0; k < d; ++k)
    l.phi.push_back(draw_matrix<S>(draw, n, n)), l.psi.push_back(draw_matrix<S>(draw, n, n));
  l.correction = Vector<S>::Zero(d);
  Vector<S> const left = residual(l).components;
  Matrix<S> columns(d, d);
  for (int k = 0; k < d; ++k) {
    auto one = l;
    one.correction[k] = S(1);
    columns.col(k) = residual(one).components - left;
  }
  l.correction = -solve_linear(columns, left, "with_motion");
  return l;
}
}  // namespace detail

/// `lagrangian`, changed by bilinear terms until (3.2) holds at (g0, g1, g2).
template <class S>
PairPolynomial<S> with_motion(PairPolynomial<S> lagrangian, Element<SpannedGroup, S> const& g0,
                              Element<SpannedGroup, S> const& g1, Element<SpannedGroup, S> const& g2) {
  int const d = g0.group.dimension();
  lagrangian.correction.setZero();
  Vector<S> const residual = discrete_euler_lagrange(lagrangian, g0, g1, g2).components;
  Matrix<S> columns(d, d);
  for (int k = 0; k < d; ++k) {
    auto one = lagrangian;
    one.correction[k] = S(1);
    columns.col(k) = discrete_euler_lagrange(one, g0, g1, g2).components - residual;
  }
  lagrangian.correction = -solve_linear(columns, residual, "with_motion");
  return lagrangian;
}

/// Calls `visit(group, name)` at one random point for each group.
template <class S, class Visit>
void over_groups(std::vector<SpannedGroup> const& groups, Claim<S> const&, Visit const& visit) {
  for (auto const& group : groups) visit(group, group.name());
}

}  // namespace actio::checks
