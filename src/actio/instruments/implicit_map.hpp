// Maps that solve an equation on the way: the solution and its exact derivative.
//
// The solvers of the library run at dual numbers too and end with the exact derivative, for Newton's
// iteration brings the infinitesimals to rounding one step behind the value. That costs a whole iteration on
// larger numbers. Here the iteration runs on plain numbers, and one update on dual numbers follows: the
// implicit function theorem.
#pragma once

#include "actio/groups/solve.hpp"
#include "actio/instruments/points.hpp"

namespace actio {

/// The f near `start` with residual(f, parameter) = 0, as a function of the parameter.
///
/// At plain numbers this is \ref solve_on_group. At dual numbers the values are solved for first, and then
/// \f[ \delta f\,f^{-1} = -\left(\frac{\partial r}{\partial f}\right)^{-1}\frac{\partial r}{\partial
///   p}\,\delta p . \f]
/// @param residual   (Element, parameter) -> Momentum, at every scalar; that of f may be larger than that of
///                   the parameter: write `like(f, parameter)`
/// @param parameter  a scalar, a momentum, an element, ..., or a tuple of these, at the scalar of `start` or
///                   plain
/// @throws NotConverged, Singular, NotFinite  as \ref solve_on_group
/// Accuracy: the value as \ref solve_on_group; infinitesimals to rounding times the condition of the
/// derivative of the residual.
template <ExponentialGroup G, Real S, class Residual, class Parameter>
Element<G, S> solve_implicit(Residual const& residual, Parameter const& parameter,
                             Element<G, S> const& start) {
  if constexpr (Plain<S>) {
    return solve_on_group([&](auto const& f) { return residual(f, parameter); }, start).value;
  } else {
    using Below = decltype(value_of(S()));
    int const n = start.group.dimension();
    auto const below = value_of(parameter);
    auto const f = solve_implicit(residual, below, value_of(start));
    Matrix<Below, G::dim, G::dim> derivative(n, n);
    over_batches(n, [&](int first) {
      store_parts(derivative, residual(moved_left(f, first), below).components, first);
    });

    // What the parameter does to the residual while f stays, and the change of f that makes up for it.
    auto const moved = residual(over<S>(f), parameter).components;
    constexpr int directions = static_cast<int>(std::tuple_size_v<decltype(S::part)>);
    Matrix<Below, G::dim, Dynamic> right(n, directions);
    for (int i = 0; i < n; ++i)
      for (int a = 0; a < directions; ++a) right(i, a) = -moved[i].part[a];
    auto const solved = solve_linear(derivative, right, "implicit map: derivative of the residual");
    Coordinates<G, S> update = Coordinates<G, S>::Zero(n);
    for (int i = 0; i < n; ++i)
      for (int a = 0; a < directions; ++a) update[i].part[a] = solved(i, a);
    return Element<G, S>{start.group, primitive::near_identity(start.group, update)} * over<S>(f);
  }
}

}  // namespace actio
