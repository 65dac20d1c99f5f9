// Differentials of functions on a group, translated to the identity from either side, and of functions on
// vector spaces.
//
// The side is in the name. A differential is taken by evaluating the function on elements moved infinitely
// little: exact, and alive at every scalar. Directions are taken in small batches, so the size of a scalar
// does not depend on the group.
#pragma once

#include <type_traits>
#include <vector>

#include "actio/groups/group.hpp"
#include "actio/numbers/derivative.hpp"

namespace actio {

/// Whether infinitesimal motions are products of matrices, so that they can be written down entry by entry.
template <class G, class S>
inline constexpr bool moves_by_matrices =
    MatrixGroup<G> && !requires(G const& group, Coordinates<G, S> const& v) { group.near_identity(v); };

/// An entry other than zero of a basis matrix of an algebra.
template <class T>
struct BasisEntry {
  int row;     ///< of the entry
  int column;  ///< of the entry
  T value;     ///< the entry
};

/// The nonzero entries of each basis matrix of an algebra. Basis matrices are nearly empty.
template <class T, class G>
std::vector<std::vector<BasisEntry<T>>> basis_entries(G const& group) {
  std::vector<std::vector<BasisEntry<T>>> entries(group.dimension());
  for (int a = 0; a < group.dimension(); ++a) {
    Coordinates<G, T> direction = Coordinates<G, T>::Zero(group.dimension());
    direction[a] = T(1);
    Storage<G, T> const basis = group.hat(direction);
    for (int i = 0; i < group.matrix_size(); ++i)
      for (int j = 0; j < group.matrix_size(); ++j)
        if (!(basis(i, j) == T(0))) entries[a].push_back({i, j, T(basis(i, j))});
  }
  return entries;
}

/// Calls `visit(a, i, j, e)` for each nonzero entry e of the a-th basis matrix of a batch.
template <class T, class G, class Visit>
void over_entries(G const& group, int first, Visit const& visit) {
  auto const all = [&](auto const& entries) {
    for (int a = 0; a < batch && first + a < group.dimension(); ++a)
      for (auto const& [row, column, value] : entries[first + a]) visit(a, row, column, value);
  };
  if constexpr (std::is_empty_v<G> && !ChosenAtRunTime<T>) {
    // All groups of this type are the same one.
    static auto const entries = basis_entries<T>(group);
    all(entries);
  } else {
    all(basis_entries<T>(group));
  }
}

/// \f$\sum_a\varepsilon_a e_{first+a}\f$, an infinitesimal of the algebra.
template <class S, class G>
Coordinates<G, Moved<S>> infinitesimals(G const& group, int first) {
  Coordinates<G, Moved<S>> v = Coordinates<G, Moved<S>>::Zero(group.dimension());
  for (int a = 0; a < batch && first + a < group.dimension(); ++a) v[first + a].part[a] = S(1);
  return v;
}

/// \f$(1 + \sum_a\varepsilon_a e_{first+a})\,g\f$: g moved on the left by infinitesimals, one for each
/// direction of a batch.
template <Group G, Scalar S>
Element<G, Moved<S>> moved_left(Element<G, S> const& g, int first) {
  Storage<G, Moved<S>> value = g.value.template cast<Moved<S>>();
  if constexpr (moves_by_matrices<G, S>) {
    // The rate of change along e_a is the matrix e_a g. Basis matrices are nearly empty: add rows of g.
    over_entries<Base<S>>(g.group, first, [&](int a, int i, int k, Base<S> const& entry) {
      for (Index j = 0; j < value.cols(); ++j) value(i, j).part[a] += g.value(k, j) * entry;
    });
  } else {
    value = primitive::compose(g.group, primitive::near_identity(g.group, infinitesimals<S>(g.group, first)),
                               value);
  }
  return {g.group, value};
}
/// \f$g\,(1 + \sum_a\varepsilon_a e_{first+a})\f$: g moved on the right.
template <Group G, Scalar S>
Element<G, Moved<S>> moved_right(Element<G, S> const& g, int first) {
  Storage<G, Moved<S>> value = g.value.template cast<Moved<S>>();
  if constexpr (moves_by_matrices<G, S>) {
    over_entries<Base<S>>(g.group, first, [&](int a, int k, int j, Base<S> const& entry) {
      for (Index i = 0; i < value.rows(); ++i) value(i, j).part[a] += g.value(i, k) * entry;
    });
  } else {
    value = primitive::compose(g.group, value,
                               primitive::near_identity(g.group, infinitesimals<S>(g.group, first)));
  }
  return {g.group, value};
}

/// A derivative that is handed out as a plain number must be one.
template <class S>
void require_number(Moved<S> const& change, char const* where) {
  if constexpr (Plain<S>)
    if (!is_finite(change)) throw NotFinite(std::string(where) + ": value or derivative of the function");
}

/// A derivative that is handed out as plain numbers must be of such.
template <class S, int R, int C>
void require_number(Derivative<S, S, R, C> const& d, char const* where) {
  if constexpr (Plain<S>)
    if (!is_finite(d.value) || !is_finite(d.matrix))
      throw NotFinite(std::string(where) + ": value or derivative of the function");
}

/// Calls `visit(first)` for the first direction of each batch.
template <class Visit>
void over_batches(int dimension, Visit const& visit) {
  for (int first = 0; first < dimension; first += batch) visit(first);
}

/// \f$R_g^*\,l'(g)\f$: the differential of l at g, read on
/// \f$\vartheta\mapsto\frac{d}{d\epsilon}l(e^{\epsilon\vartheta}g)\f$.
///
/// \snippet numbers.cpp differential
/// @param l  function on G, callable at `S` and at dual numbers over it; energy x time where it is an action
/// @param g  where
/// @return   covector at the identity
/// @throws NotFinite  where l or its derivative at g is no number
/// Exact up to rounding.
template <Group G, Scalar S, FunctionOnGroup<G, Moved<S>> F>
Momentum<G, S> right_differential(F const& l, Element<G, S> const& g) {
  int const n = g.group.dimension();
  Momentum<G, S> d{g.group, Coordinates<G, S>(n)};
  over_batches(n, [&](int first) {
    Moved<S> const change = l(moved_left(g, first));
    require_number<S>(change, "right_differential");
    for (int a = 0; a < batch && first + a < n; ++a) d.components[first + a] = change.part[a];
  });
  return d;
}

/// \f$L_g^*\,l'(g)\f$: the differential of l at g, read on
/// \f$\vartheta\mapsto\frac{d}{d\epsilon}l(g\,e^{\epsilon\vartheta})\f$.
///
/// Equal to \f$\mathrm{Ad}^*_g\,R_g^*\,l'(g)\f$. Parameters and accuracy as in \ref right_differential.
template <Group G, Scalar S, FunctionOnGroup<G, Moved<S>> F>
Momentum<G, S> left_differential(F const& l, Element<G, S> const& g) {
  int const n = g.group.dimension();
  Momentum<G, S> d{g.group, Coordinates<G, S>(n)};
  over_batches(n, [&](int first) {
    Moved<S> const change = l(moved_right(g, first));
    require_number<S>(change, "left_differential");
    for (int a = 0; a < batch && first + a < n; ++a) d.components[first + a] = change.part[a];
  });
  return d;
}

/// \f$\partial l/\partial\xi\f$ of a function on the algebra: a covector.
template <Group G, Scalar S, class F>
Momentum<G, S> gradient(F const& l, Velocity<G, S> const& xi) {
  auto const d = derivative(
      [&]<class T>(Matrix<T, G::dim, 1> const& moved) -> T {
        return l(Velocity<G, T>{xi.group, moved});
      },
      xi.coordinates);
  require_number(d, "gradient");
  return {xi.group, d.gradient()};
}

/// \f$\partial h/\partial\mu\f$ of a function on the dual of the algebra: a velocity.
template <Group G, Scalar S, class F>
Velocity<G, S> gradient(F const& h, Momentum<G, S> const& mu) {
  auto const d = derivative(
      [&]<class T>(Matrix<T, G::dim, 1> const& moved) -> T {
        return h(Momentum<G, T>{mu.group, moved});
      },
      mu.components);
  require_number(d, "gradient");
  return {mu.group, d.gradient()};
}

/// The parts of a column of dual numbers along one batch, as columns of a matrix beginning at column `first`.
template <class Matrix, class Column>
void store_parts(Matrix& matrix, Column const& column, int first) {
  for (Index i = 0; i < column.size(); ++i)
    for (int a = 0; a < batch && first + a < matrix.cols(); ++a) matrix(i, first + a) = column[i].part[a];
}

}  // namespace actio
