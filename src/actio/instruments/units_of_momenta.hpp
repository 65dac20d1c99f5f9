// Units of the components of a momentum, read off the algebra.
//
// A momentum of turning and one of gliding are measured in different units, and a norm of both needs the size
// of each. The brackets tell which components share a unit: a change of units multiplies the basis vector e_a
// by c_a and leaves [e_a, e_b] = sum_c C^c_ab e_c as it is, so that c_a c_b = c_c wherever C^c_ab is not
// zero. Components that no such change tells apart have one unit. For SO(n) there is one class, for SE(n)
// there are two, the turns and the shifts.
#pragma once

#include <vector>

#include "actio/groups/group.hpp"

namespace actio {

namespace detail {
template <class S>
using AnyVector = Matrix<S, Dynamic, 1>;
template <class S>
using AnyMatrix = Matrix<S, Dynamic, Dynamic>;

/// Square root of the sum of squares, without overflow; over the rationals the largest modulus.
template <class V>
auto length_of(V const& v) {
  using S = std::decay_t<decltype(v[0])>;
  S const largest = magnitude(v);
  if constexpr (Real<S>) {
    using std::sqrt;
    if (exact_arithmetic<S>() || !(largest > S(0))) return largest;
    S sum(0);
    for (Index i = 0; i < v.size(); ++i) sum += S(v[i] / largest) * S(v[i] / largest);
    return S(largest * sqrt(sum));
  } else {
    return largest;
  }
}
}  // namespace detail

/// The components of a momentum by their units.
struct UnitClasses {
  std::vector<int> of;  ///< the class of each component
  std::vector<bool>
      /// by class: whether elements of the group have a size in it that units change (false for turns, which
      /// are angles)
      has_length;
};

/// The classes of components that share a unit.
///
/// Components that occur in no bracket, as all of \f$\mathbb R^n\f$, make one class.
template <Group G>
UnitClasses unit_classes(G const& group) {
  int const n = group.dimension();
  // Rows in reduced echelon form: the equations w_a + w_b = w_c for the logarithms w of the units.
  Matrix<double> rows = Matrix<double>::Zero(n, n);
  std::vector<bool> solved(n, false), met(n, false);
  auto const add = [&](Vector<double> equation) {
    for (int p = 0; p < n; ++p)
      if (solved[p]) equation -= equation[p] * rows.row(p).transpose().eval();
    int q = 0;
    while (q < n && std::abs(equation[q]) < 1e-9) ++q;
    if (q == n) return;
    equation /= equation[q];
    for (int p = 0; p < n; ++p)
      if (solved[p]) rows.row(p) -= rows(p, q) * equation.transpose().eval();
    rows.row(q) = equation.transpose();
    solved[q] = true;
  };
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < n; ++b) {
      auto const ab = bracket(basis_velocity<double>(group, a), basis_velocity<double>(group, b)).coordinates;
      for (int c = 0; c < n; ++c) {
        if (std::abs(ab[c]) < 1e-12) continue;
        Vector<double> equation = Vector<double>::Zero(n);
        equation[a] += 1, equation[b] += 1, equation[c] -= 1;
        met[a] = met[b] = met[c] = true;
        add(equation);
      }
    }
  // Each w_a by the ones that are free.
  auto const weight = [&](int a) {
    Vector<double> w = Vector<double>::Zero(n);
    for (int f = 0; f < n; ++f)
      if (!solved[f]) w[f] = solved[a] ? -rows(a, f) : a == f ? 1 : 0;
    return w;
  };
  UnitClasses classes{std::vector<int>(n, -1), {}};
  for (int a = 0; a < n; ++a) {
    for (int b = 0; b < a && classes.of[a] < 0; ++b)
      if (met[a] == met[b] && (!met[a] || magnitude((weight(a) - weight(b)).eval()) < 1e-9))
        classes.of[a] = classes.of[b];
    if (classes.of[a] >= 0) continue;
    classes.of[a] = static_cast<int>(classes.has_length.size());
    classes.has_length.push_back(!met[a] || magnitude(weight(a)) > 1e-9);
  }
  return classes;
}

/// For each component of a momentum, the size of the momentum in the components that share its unit.
///
/// A class in which the momentum vanishes gets the size of the largest, in the units given; where all of it
/// vanishes the sizes are 1.
template <Group G, Plain S>
detail::AnyVector<S> sizes_by_unit(Momentum<G, S> const& mu) {
  auto const classes = unit_classes(mu.group);
  int const n = static_cast<int>(classes.of.size()), count = static_cast<int>(classes.has_length.size());
  detail::AnyVector<S> by_class(count), sizes(n);
  S largest(0);
  for (int k = 0; k < count; ++k) {
    detail::AnyVector<S> part = mu.components;
    for (int a = 0; a < n; ++a)
      if (classes.of[a] != k) part[a] = S(0);
    by_class[k] = detail::length_of(part);
    if (by_class[k] > largest) largest = by_class[k];
  }
  if (!(largest > S(0))) largest = S(1);
  for (int a = 0; a < n; ++a) sizes[a] = by_class[classes.of[a]] > S(0) ? by_class[classes.of[a]] : largest;
  return sizes;
}

}  // namespace actio
