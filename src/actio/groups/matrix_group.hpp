// Groups of matrices: everything that follows from `hat` and `vee`.
//
// A matrix group says how coordinates become a matrix of its algebra (`hat`) and back (`vee`, a linear
// projection where the matrix is none of the algebra's). Every primitive it does not bring itself has a
// default here: the retraction is the Cayley transform (which stays in the group for all groups of the
// library but SL(n), n > 2), exp and log are those of matrices.
#pragma once

#include "actio/linear_algebra/iex.hpp"
#include "actio/linear_algebra/matrix_logarithm.hpp"

namespace actio {

/// Coordinates in the algebra of G, or in its dual: as many as the group has dimensions.
template <class G, class S>
using Coordinates = Matrix<S, G::dim, 1>;

/// Size and dimension, for a group of n by n matrices to derive from.
template <int n, int d>
struct Matrices {
  static constexpr int size = n;  ///< rows of a matrix
  static constexpr int dim = d;   ///< dimension of the group
  static constexpr int matrix_size() { return n; }
  static constexpr int dimension() { return d; }
};

/// A group of matrices given by its algebra.
template <class G>
concept MatrixGroup = requires(G const& group, Coordinates<G, double> const& v) {
  { G::size } -> std::convertible_to<int>;
  { group.matrix_size() } -> std::convertible_to<int>;
  { group.dimension() } -> std::convertible_to<int>;
  { group.hat(v) } -> std::convertible_to<Matrix<double, G::size, G::size>>;
  { group.vee(group.hat(v)) } -> std::convertible_to<Coordinates<G, double>>;
};

template <class G, class S>
struct StorageOf {};
template <class G, class S>
  requires requires { typename G::template Value<S>; }
struct StorageOf<G, S> {
  using type = typename G::template Value<S>;
};
template <MatrixGroup G, class S>
struct StorageOf<G, S> {
  using type = Matrix<S, G::size, G::size>;
};
/// What stores an element of G: a matrix, or whatever the group says.
template <class G, class S>
using Storage = typename StorageOf<G, S>::type;

/// The Cayley transform \f$(1 - A/2)^{-1}(1 + A/2)\f$: a rational stand-in for the exponential, equal to it
/// to second order.
/// @throws Singular  where A has the eigenvalue 2
template <MatrixLike M>
typename M::PlainObject cayley(M const& a) {
  using S = typename M::Scalar;
  typename M::PlainObject const one = M::PlainObject::Identity(a.rows(), a.cols());
  typename M::PlainObject const half = a / S(2);
  return solve_linear((one - half).eval(), (one + half).eval(), "cayley");
}
/// The inverse of \ref cayley: \f$2(Q - 1)(Q + 1)^{-1}\f$.
/// @throws Singular  where Q has the eigenvalue -1
template <MatrixLike M>
typename M::PlainObject inverse_cayley(M const& q) {
  using S = typename M::Scalar;
  typename M::PlainObject const one = M::PlainObject::Identity(q.rows(), q.cols());
  return solve_linear((q + one).eval(), ((q - one) * S(2)).eval(), "inverse_cayley");
}

/// The primitives of a group: its own where it has them, otherwise what follows from `hat` and `vee`.
namespace primitive {

template <class S, class G>
Storage<G, S> identity(G const& group) {
  if constexpr (requires { group.template identity<S>(); })
    return group.template identity<S>();
  else
    return Storage<G, S>::Identity(group.matrix_size(), group.matrix_size());
}

template <class G, class A>
A compose(G const& group, A const& a, A const& b) {
  if constexpr (requires { group.compose(a, b); })
    return group.compose(a, b);
  else
    return a * b;
}

template <class G, class A>
A inverse(G const& group, A const& a) {
  if constexpr (requires { group.inverse(a); })
    return group.inverse(a);
  else
    return inverse_matrix(a, "inverse");
}

template <class G, class A, class V>
V Ad(G const& group, A const& a, V const& v) {
  if constexpr (requires { group.Ad(a, v); })
    return group.Ad(a, v);
  else
    return group.vee(A(a * group.hat(v) * primitive::inverse(group, a)));
}

/// The matrix of \f$\mathrm{Ad}_a\f$.
template <class S, class G, class A>
Matrix<S, G::dim, G::dim> Ad_matrix(G const& group, A const& a) {
  using V = Coordinates<G, S>;
  int const n = group.dimension();
  Matrix<S, G::dim, G::dim> m(n, n);
  auto const fill = [&](auto const& image) {
    for (int k = 0; k < n; ++k) {
      V e = V::Zero(n);
      e[k] = S(1);
      m.col(k) = image(e);
    }
  };
  if constexpr (requires(V const& v) { group.Ad(a, v); }) {
    fill([&](V const& e) { return V(group.Ad(a, e)); });
  } else {
    A const back = primitive::inverse(group, a);
    fill([&](V const& e) { return V(group.vee(A(a * group.hat(e) * back))); });
  }
  return m;
}
/// \f$\mathrm{Ad}^*_a\f$ of a covector.
template <class G, class A, class V>
V Ad_star(G const& group, A const& a, V const& mu) {
  if constexpr (requires { group.Ad_star(a, mu); })
    return group.Ad_star(a, mu);
  else
    return primitive::Ad_matrix<typename V::Scalar>(group, a).transpose() * mu;
}

template <class G, class V>
V bracket(G const& group, V const& v, V const& w) {
  if constexpr (requires { group.bracket(v, w); }) {
    return group.bracket(v, w);
  } else {
    auto const a = group.hat(v), b = group.hat(w);
    return group.vee((a * b - b * a).eval());
  }
}

template <class G, class V>
Storage<G, typename V::Scalar> retract(G const& group, V const& v) {
  if constexpr (requires { group.retract(v); })
    return group.retract(v);
  else
    return cayley(group.hat(v));
}

/// The element that differs from the identity by an infinitesimal v of which products vanish.
template <class G, class V>
Storage<G, typename V::Scalar> near_identity(G const& group, V const& v) {
  if constexpr (requires { group.near_identity(v); })
    return group.near_identity(v);
  else
    return primitive::identity<typename V::Scalar>(group) + group.hat(v);
}

template <class G, class V>
  requires Real<typename V::Scalar>
Storage<G, typename V::Scalar> exp(G const& group, V const& v) {
  if constexpr (requires { group.exp(v); })
    return group.exp(v);
  else
    return matrix_exponential(group.hat(v));
}

template <class G, class S>
  requires Real<S>
Coordinates<G, S> log_of(G const& group, Storage<G, S> const& a);

/// The matrix of \f$\mathrm{ad}_v\f$.
template <class G, class V>
auto ad_matrix(G const& group, V const& v) {
  using S = typename V::Scalar;
  int const n = group.dimension();
  Matrix<S, G::dim, G::dim> m(n, n);
  for (int a = 0; a < n; ++a) {
    V e = V::Zero(n);
    e[a] = S(1);
    m.col(a) = primitive::bracket(group, v, e);
  }
  return m;
}

/// The logarithm extended to dual numbers by its known derivative:
/// \f$d\log = \mathrm{iex}(\mathrm{ad}_{\log g})^{-1}(dg\,g^{-1})\f$.
template <class G, class S, int N>
Coordinates<G, Dual<S, N>> lifted_log(G const& group, Matrix<Dual<S, N>, G::size, G::size> const& a) {
  int const n = group.matrix_size(), d = group.dimension();
  Storage<G, S> value(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) value(i, j) = a(i, j).value;
  Coordinates<G, S> const x = log_of<G, S>(group, value);
  Storage<G, S> const inverse_value = primitive::inverse(group, value);

  Matrix<S, G::dim, Dynamic> rates(d, N);
  for (int k = 0; k < N; ++k) {
    Storage<G, S> rate(n, n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) rate(i, j) = a(i, j).part[k];
    rates.col(k) = group.vee(Storage<G, S>(rate * inverse_value));
  }
  Matrix<S, G::dim, Dynamic> const solved = solve_linear(iex(primitive::ad_matrix(group, x)), rates, "log");

  Coordinates<G, Dual<S, N>> result(d);
  for (int c = 0; c < d; ++c) {
    result[c].value = x[c];
    for (int k = 0; k < N; ++k) result[c].part[k] = solved(c, k);
  }
  return result;
}

template <class G, class S>
  requires Real<S>
Coordinates<G, S> log_of(G const& group, Storage<G, S> const& a) {
  if constexpr (requires { group.log(a); })
    return group.log(a);
  else if constexpr (is_dual<S>)
    return lifted_log(group, a);
  else
    return group.vee(matrix_logarithm(a));
}

/// Back on the group by way of the algebra, through Cayley's transform and its inverse. Where that is badly
/// conditioned, which is next to an eigenvalue -1, the element is returned as it is.
template <class M, class G>
M restore_by_cayley(G const& group, M const& a) {
  M flat;
  try {
    flat = inverse_cayley(a);
  } catch (Singular const&) {
    return a;
  }
  if (!(row_norm(flat) < 8)) return a;
  M const restored = cayley(group.hat(group.vee(flat)));
  double const distance = row_norm(M(restored - a)) / row_norm(a);
  if (!(distance < 0.1))
    throw OutsideDomain("restore", "a matrix near the group is needed; relative distance", distance, 0.1);
  return restored;
}

template <class G, class A>
A restore(G const& group, A const& a) {
  if constexpr (requires { group.restore(a); })
    return group.restore(a);
  else
    return restore_by_cayley<A>(group, a);
}

}  // namespace primitive
}  // namespace actio
