// The laws, run over the groups that come in families. Their orders are chosen at run time, so that each
// family is compiled once for a scalar.
#pragma once

#include "actio/groups/direct_product.hpp"
#include "actio/groups/semidirect_product.hpp"
#include "actio/groups/special_linear.hpp"
#include "actio/groups/symplectic_groups.hpp"
#include "actio/groups/unitary_groups.hpp"
#include "laws_of_the_groups.hpp"

namespace actio::laws {

/// A matrix group as the span of its basis.
template <MatrixGroup G>
SpannedGroup from_span(std::string const& name, G const& group, Retraction choice = Retraction::automatic) {
  std::vector<SpannedGroup::WholeMatrix> basis;
  for (int a = 0; a < group.dimension(); ++a) {
    Coordinates<G, int> unit = Coordinates<G, int>::Zero(group.dimension());
    unit[a] = 1;
    basis.push_back(group.hat(unit));
  }
  return SpannedGroup(name, basis, choice);
}

/// Near the edge of the chart of the logarithm of general matrices, which takes square roots: each cancels as
/// the eigenvalue comes near to -1. Whole multiples of the first basis vectors, seen from another frame.
template <Scalar S, Group G>
std::vector<Edge<S>> edge(G const& group, std::initializer_list<int> multiples) {
  if constexpr (Real<S>) {
    if (exact_arithmetic<S>()) return {};
    Coordinates<G, S> v = Coordinates<G, S>::Zero(group.dimension());
    int a = 0;
    for (int m : multiples) v[a++] = S(m);
    Draw draw(seed);
    return {{Ad(exp(draw.velocity<S>(group, ratio<S>(1, 2))), Velocity<G, S>{group, v}).coordinates, 100}};
  } else {
    return {};
  }
}

/// U(n), SU(n), SL(n), Sp(2n, R).
template <Scalar S>
void laws_of_families() {
  hold<S>("U(1)", U<>(1), edge<S>(U<>(1), {3}));
  hold<S>("U(2)", U<>(2), edge<S>(U<>(2), {3, -1}));
  hold<S>("SU(2) as matrices", SU<>(2), edge<S>(SU<>(2), {3}));
  hold<S>("SU(3)", SU<>(3), edge<S>(SU<>(3), {3, 1}));
  // A turn by 3 in the plane of the first two axes, beside a stretching.
  hold<S>("SL(2) of its family", SL<>(2), edge<S>(SL<>(2), {0, 3, -3}));
  hold<S>("SL(3)", SL<>(3), edge<S>(SL<>(3), {0, 0, 3, 0, -3}));
  hold<S>("SL(4)", SL<>(4));
  hold<S>("Sp(2)", Sp<>(2), edge<S>(Sp<>(2), {0, 3, -3}));
  hold<S>("Sp(4)", Sp<>(4), edge<S>(Sp<>(4), {0, 0, 0, 0, 3, 0, 1, -3, 0, -1}));
}

/// SL(3) x (U(1) x Sp(2)), SL(2) |x R^2 and SL(3) |x R^3, and SL(3), SU(3) and SU(2) from their spans.
template <Scalar S>
void laws_of_products_and_spans() {
  hold<S>("SL(3) x (U(1) x Sp(2))", DirectProduct{SL<>(3), DirectProduct{U<>(1), Sp<>(2)}});
  hold<S>("SL(2) |x R^2", SemidirectProduct{SL<>(2)});
  hold<S>("SL(3) |x R^3", SemidirectProduct{SL<>(3)});
  hold<S>("SL(3) from its span", from_span("SL(3)", SL<>(3)),
          edge<S>(from_span("SL(3)", SL<>(3)), {0, 0, 3, 0, -3}));
  hold<S>("SU(3) from its span", from_span("SU(3)", SU<>(3)));
  hold<S>("SU(2) from its span, by factors", from_span("SU(2)", SU<>(2), Retraction::elementary));
}

}  // namespace actio::laws
