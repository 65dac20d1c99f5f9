// Groupoids for the checks of section 4.1: pairs of configurations, groups and their opposites, a group with
// a vector it carries, a gauge groupoid; and functions on their arrows.
#pragma once

#include "actio/groupoid/action_groupoid.hpp"
#include "actio/groupoid/gauge_groupoid.hpp"
#include "actio/groupoid/group_as_groupoid.hpp"
#include "actio/groupoid/opposite_groupoid.hpp"
#include "actio/groupoid/pair_groupoid.hpp"
#include "models.hpp"

namespace actio::checks {

using Pairs = PairGroupoid<SpannedGroup>;
using Alone = GroupAsGroupoid<SpannedGroup>;
using Carrying = ActionGroupoid<SpannedGroup>;
using Gauge = GaugeGroupoid<SpannedGroup>;

// ---- Arrows at random from a point, and points at random

template <class S>
Point<Pairs, S> draw_point(Draw& draw, Pairs const& gamma) { return draw.template element<S>(gamma.group); }
template <class S, class Gamma>
  requires std::same_as<Point<Gamma, S>, SinglePoint<S>>
SinglePoint<S> draw_point(Draw&, Gamma const&) { return {}; }
template <class S>
Point<Carrying, S> draw_point(Draw& draw, Carrying const& gamma) {
  return {draw_vector<S>(draw, gamma.base_dimension())};
}
template <class S>
Point<Gauge, S> draw_point(Draw& draw, Gauge const& gamma) { return {draw_vector<S>(draw, gamma.base)}; }

template <class S>
Arrow<Pairs, S> draw_arrow(Draw& draw, Pairs const& gamma, Point<Pairs, S> const& from) {
  return {from, draw.template element<S>(gamma.group)};
}
template <class S>
Arrow<Alone, S> draw_arrow(Draw& draw, Alone const& gamma, SinglePoint<S> const&) {
  return draw.template element<S>(gamma.group);
}
template <class S>
Arrow<Alone, S> draw_arrow(Draw& draw, Opposite<Alone> const& gamma, SinglePoint<S> const&) {
  return draw.template element<S>(gamma.of.group);
}
template <class S>
Arrow<Carrying, S> draw_arrow(Draw& draw, Carrying const& gamma, Point<Carrying, S> const& from) {
  return {draw.template element<S>(gamma.group), from.value};
}
template <class S>
Arrow<Gauge, S> draw_arrow(Draw& draw, Gauge const& gamma, Point<Gauge, S> const& from) {
  return {from.value, draw_vector<S>(draw, gamma.base), draw.template element<S>(gamma.group)};
}
/// Arrows in a row, each from where the one before ends.
template <class S, class Gamma>
std::vector<Arrow<Gamma, S>> draw_arrows(Draw& draw, Gamma const& gamma, int count) {
  std::vector<Arrow<Gamma, S>> g{draw_arrow<S>(draw, gamma, draw_point<S>(draw, gamma))};
  while (static_cast<int>(g.size()) < count) g.push_back(draw_arrow<S>(draw, gamma, gamma.target(g.back())));
  return g;
}

// ---- Functions of arrows

/// A cubic polynomial in the entries of an arrow, invariant under nothing.
template <class S>
struct ArrowPolynomial {
  Matrix<S> squares;
  Vector<S> linear, cube;

  template <class T>
  T at(Vector<T> const& entries) const {
    T sum(0), along(0);
    for (Index k = 0; k < squares.rows(); ++k) {
      T q(0);
      for (Index i = 0; i < entries.size(); ++i) q += entries[i] * T(squares(k, i));
      sum += q * q / 2;
    }
    for (Index i = 0; i < entries.size(); ++i)
      sum += entries[i] * T(linear[i]), along += entries[i] * T(cube[i]);
    return sum + along * along * along;
  }
};
/// As a function of the arrows of `gamma`.
template <class S, class Gamma>
auto on_arrows(Gamma const& gamma, ArrowPolynomial<S> const& l) {
  return [gamma, l](auto const& g) { return l.at(gamma.entries(g)); };
}
template <class S, class Gamma>
ArrowPolynomial<S> draw_arrow_polynomial(Draw& draw, Gamma const& gamma, Arrow<Gamma, S> const& like) {
  int const n = static_cast<int>(gamma.entries(like).size());
  return {draw_matrix<S>(draw, n, n), draw_vector<S>(draw, n), draw_vector<S>(draw, n) * ratio<S>(1, 4)};
}

/// Calls `visit(gamma, name)` for groupoids of every kind, at several random points each. The groups are
/// small: a groupoid is larger than its group.
template <class S, class Visit>
void over_groupoids(Claim<S> const&, Visit const& visit) {
  static SpannedGroup const so3 = spanned("SO(3)", SO<3>{}), se2 = spanned("SE(2)", SE<2>{}),
                            aff = spanned("Aff(1)", Aff1{}),
                            so2("SO(2)", {(SpannedGroup::WholeMatrix(2, 2) << 0, -1, 1, 0).finished()});
  {
    for (auto const& group : {so3, aff}) visit(Pairs{group}, "pairs in " + group.name());
    for (auto const& group : {se2, aff}) visit(Alone{group}, group.name());
    visit(Opposite<Alone>{{aff}}, std::string("Aff(1), opposite"));
    for (auto const& group : {so3, se2}) visit(Carrying{group}, group.name() + " with a vector");
    visit(Gauge{so2, 1}, std::string("gauge groupoid of a circle over a line"));
    visit(Gauge{aff, 2}, std::string("gauge groupoid of Aff(1) over a plane"));
  }
}

}  // namespace actio::checks
