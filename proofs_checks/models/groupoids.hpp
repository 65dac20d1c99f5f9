// Groupoids for the checks of section 4.1: pairs of configurations, groups and their opposites, a group with
// a vector it carries, a gauge groupoid, two copies of a group; and functions on their arrows.
#pragma once

#include "actio/groupoid/action_groupoid.hpp"
#include "actio/groupoid/algebroid.hpp"
#include "actio/groupoid/diagonal_quotient.hpp"
#include "actio/groupoid/gauge_groupoid.hpp"
#include "actio/groupoid/group_as_groupoid.hpp"
#include "actio/groupoid/opposite_groupoid.hpp"
#include "actio/groupoid/pair_groupoid.hpp"
#include "models/models.hpp"

namespace actio::checks {

using Pairs = PairGroupoid<SpannedGroup>;
using Alone = GroupAsGroupoid<SpannedGroup>;
using Carrying = ActionGroupoid<SpannedGroup>;
using Gauge = GaugeGroupoid<SpannedGroup>;
using TwoCopies = DiagonalQuotient<SpannedGroup, 2>;

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
Point<TwoCopies, S> draw_point(Draw& draw, TwoCopies const& gamma) {
  return {{draw.template element<S>(gamma.group)}};
}

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
template <class S>
Arrow<TwoCopies, S> draw_arrow(Draw& draw, TwoCopies const& gamma, Point<TwoCopies, S> const& from) {
  return {from.others, {draw.template element<S>(gamma.group)}, draw.template element<S>(gamma.group)};
}
/// Arrows in a row, each from where the one before ends.
template <class S, class Gamma>
std::vector<Arrow<Gamma, S>> draw_arrows(Draw& draw, Gamma const& gamma, int count) {
  std::vector<Arrow<Gamma, S>> g{draw_arrow<S>(draw, gamma, draw_point<S>(draw, gamma))};
  while (static_cast<int>(g.size()) < count) g.push_back(draw_arrow<S>(draw, gamma, gamma.target(g.back())));
  return g;
}

// ---- Tangent vectors of the arrows: components in the frame of `moved`, base directions first

/// The rates of the entries of an arrow that moves.
template <class S, class Gamma>
Vector<S> entry_rates(Gamma const& gamma, Arrow<Gamma, Dual<S>> const& moving) {
  auto const entries = gamma.entries(moving);
  Vector<S> rates(entries.size());
  for (Index i = 0; i < rates.size(); ++i) rates[i] = entries[i].part[0];
  return rates;
}
/// g moved along the tangent vector with these components.
template <class S, class Gamma>
Arrow<Gamma, Dual<S>> moved_arrow(Gamma const& gamma, Arrow<Gamma, S> const& g, Vector<S> const& w) {
  Vector<Dual<S>> wide(w.size());
  for (Index i = 0; i < w.size(); ++i) wide[i] = Dual<S>(S(0)), wide[i].part[0] = w[i];
  return gamma.moved(gamma.template over<Dual<S>>(g), wide);
}
/// The frame at g: column k holds the rates of the entries along its k-th vector.
template <class S, class Gamma>
Matrix<S> frame_at(Gamma const& gamma, Arrow<Gamma, S> const& g) {
  int const n = gamma.base_dimension() + gamma.dimension();
  Matrix<S> frame(gamma.entries(g).size(), n);
  for (int k = 0; k < n; ++k)
    frame.col(k) = entry_rates<S>(gamma, moved_arrow<S>(gamma, g, Vector<S>(Vector<S>::Unit(n, k))));
  return frame;
}
/// The components of tangent vectors that are given by the rates of the entries, column by column.
template <class S>
Matrix<S> in_frame(Matrix<S> const& frame, Matrix<S> const& rates) {
  Matrix<S> const transposed = frame.transpose();
  return solve_linear(Matrix<S>(transposed * frame), Matrix<S>(transposed * rates), "frame of the arrows");
}
/// The tangent vectors at g along which g x moves, x leaving the target of g along each direction of the
/// algebroid; and those along which the inverse of x times g moves, x leaving its source.
template <class S, class Gamma>
Matrix<S> rates_at_target(Gamma const& gamma, Arrow<Gamma, S> const& g) {
  Matrix<S> rates(gamma.entries(g).size(), gamma.dimension());
  for (int a = 0; a < gamma.dimension(); ++a)
    rates.col(a) = entry_rates<S>(gamma, actio::detail::moved_at_target(gamma, g, a));
  return rates;
}
template <class S, class Gamma>
Matrix<S> rates_at_source(Gamma const& gamma, Arrow<Gamma, S> const& g) {
  auto const wide = gamma.template over<Dual<S>>(g);
  Matrix<S> rates(gamma.entries(g).size(), gamma.dimension());
  for (int a = 0; a < gamma.dimension(); ++a) {
    auto const x =
        gamma.near_unit(gamma.source(wide), actio::detail::infinitesimal_along<Gamma, S>(gamma, a));
    rates.col(a) = entry_rates<S>(gamma, gamma.compose(gamma.inverse(x), wide));
  }
  return rates;
}

// ---- The cotangent groupoid

/// A covector of the groupoid at an arrow, by its components in the frame.
template <class S, class Gamma>
struct ArrowCovector {
  Arrow<Gamma, S> at;
  Vector<S> p;
};
/// \f$T^*\Gamma\f$ as a groupoid over the dual of the algebroid: the product r of p and q is the covector for
/// which \f$r(Tm(X,Y)) = p(X)+q(Y)\f$ for all composable X and Y.
template <class S, class Gamma>
struct CotangentGroupoid {
  using Covector = ArrowCovector<S, Gamma>;
  Gamma gamma;

  /// The covector on the algebroid over the target: \f$v\mapsto p(\frac{d}{d\epsilon}g x)\f$.
  Vector<S> target(Covector const& c) const { return arriving(c.at).transpose() * c.p; }
  /// Over the source: \f$v\mapsto-p(\frac{d}{d\epsilon}x^{-1}g)\f$.
  Vector<S> source(Covector const& c) const { return leaving(c.at).transpose() * c.p; }
  Matrix<S> arriving(Arrow<Gamma, S> const& g) const {
    return in_frame(frame_at<S>(gamma, g), rates_at_target<S>(gamma, g));
  }
  Matrix<S> leaving(Arrow<Gamma, S> const& g) const {
    return -in_frame(frame_at<S>(gamma, g), rates_at_source<S>(gamma, g));
  }
  /// The tangent of the multiplication on composable pairs (w, u): g moves along w, h along the rate of the
  /// target of g and u. Column by column, with the vectors of g and of h that are put in.
  struct Multiplication {
    Matrix<S> image, first, second;
  };
  Multiplication multiplication(Arrow<Gamma, S> const& g, Arrow<Gamma, S> const& h) const {
    int const m = gamma.base_dimension(), n = gamma.dimension(), all = m + 2 * n;
    Multiplication t{Matrix<S>(gamma.entries(g).size(), all), Matrix<S>::Zero(m + n, all),
                     Matrix<S>::Zero(m + n, all)};
    for (int k = 0; k < all; ++k) {
      if (k < m + n) t.first(k, k) = S(1);
      auto const moved_g = moved_arrow<S>(gamma, g, Vector<S>(t.first.col(k)));
      if (m > 0) t.second.col(k).head(m) = gamma.base_rate(gamma.target(moved_g));
      if (k >= m + n) t.second(k - n, k) = S(1);
      auto const moved_h = moved_arrow<S>(gamma, h, Vector<S>(t.second.col(k)));
      t.image.col(k) = entry_rates<S>(gamma, gamma.compose(moved_g, moved_h));
    }
    t.image = in_frame(frame_at<S>(gamma, gamma.compose(g, h)), t.image);
    return t;
  }
  struct Product {
    Covector value;
    Vector<S> mismatch;  ///< r(Tm(X, Y)) - p(X) - q(Y)
    double condition;    ///< of the system that was solved for r
  };
  Product product(Covector const& a, Covector const& b) const {
    auto const t = multiplication(a.at, b.at);
    Vector<S> const sum = t.first.transpose() * a.p + t.second.transpose() * b.p;
    Matrix<S> const across = t.image.transpose(), gram = t.image * across, back = inverse_matrix(gram);
    Vector<S> const r = back * (t.image * sum);
    return {{gamma.compose(a.at, b.at), r}, across * r - sum, to_double(row_norm(gram) * row_norm(back))};
  }
  /// At an arrow, the covector nearest to q with this source.
  Covector with_source(Arrow<Gamma, S> const& g, Vector<S> const& q, Vector<S> const& source) const {
    Matrix<S> const a = leaving(g), b = a.transpose();
    return {g, q - a * solve_linear(Matrix<S>(b * a), Vector<S>(b * q - source), "covector at an arrow")};
  }
  /// The unit over the source of g: at the unit there, zero on units, p on the algebroid.
  Covector unit_over_source(Arrow<Gamma, S> const& g, Vector<S> const& p) const {
    int const m = gamma.base_dimension(), n = gamma.dimension();
    auto const e = gamma.unit(gamma.source(g));
    Matrix<S> known(gamma.entries(e).size(), m + n);
    for (int k = 0; k < m; ++k) {
      auto const moving = moved_arrow<S>(gamma, g, Vector<S>(Vector<S>::Unit(m + n, k)));
      known.col(k) = entry_rates<S>(gamma, gamma.unit(gamma.source(moving)));
    }
    known.rightCols(n) = rates_at_target<S>(gamma, e);
    Vector<S> values = Vector<S>::Zero(m + n);
    values.tail(n) = p;
    Matrix<S> const across = in_frame(frame_at<S>(gamma, e), known).transpose();
    return {e, solve_linear(across, values, "unit of the cotangent groupoid")};
  }
  /// At the inverse arrow: minus p, carried by the inversion.
  Covector inverse(Covector const& c) const {
    int const all = gamma.base_dimension() + gamma.dimension();
    auto const back = gamma.inverse(c.at);
    Matrix<S> rates(gamma.entries(back).size(), all);
    for (int k = 0; k < all; ++k) {
      auto const moving = moved_arrow<S>(gamma, back, Vector<S>(Vector<S>::Unit(all, k)));
      rates.col(k) = entry_rates<S>(gamma, gamma.inverse(moving));
    }
    return {back, -(in_frame(frame_at<S>(gamma, c.at), rates).transpose() * c.p)};
  }
};

// ---- Functions of arrows

/// A cubic polynomial in the entries of an arrow, invariant under nothing. Where asked for, with a square
/// \f$\tfrac12\lambda\,(\varphi\cdot(x-x_0))^2\f$ that changes the second derivative at one arrow in one
/// direction.
template <class S>
struct ArrowPolynomial {
  Matrix<S> squares;
  Vector<S> linear, cube;
  Vector<S> phi = {}, centre = {};
  S lambda = S(0);

  template <class T>
  T at(Vector<T> const& entries) const {
    T sum(0), along(0);
    for (Index i = 0; i < phi.size(); ++i) along += (entries[i] - T(centre[i])) * T(phi[i]);
    sum = along * along * T(lambda) / 2, along = T(0);
    for (Index k = 0; k < squares.rows(); ++k) {
      T q(0);
      for (Index i = 0; i < entries.size(); ++i) q += entries[i] * T(squares(k, i));
      sum += q * q / 2;
    }
    for (Index i = 0; i < entries.size(); ++i)
      sum += entries[i] * T(linear[i]), along += entries[i] * T(cube[i]);
    return sum + along * along * along;
  }
  /// Its gradient, written out; of the polynomial without the square.
  template <class T>
  Vector<T> gradient(Vector<T> const& x) const {
    Matrix<T> const a = squares.template cast<T>();
    Vector<T> const c = cube.template cast<T>(), slopes = a * x;
    T const along = c.dot(x);
    return a.transpose() * slopes + linear.template cast<T>() + c * T(along * along * 3);
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
  Matrix<S> const squares = draw_matrix<S>(draw, n, n);
  Vector<S> const linear = draw_vector<S>(draw, n);
  return {.squares = squares, .linear = linear, .cube = draw_vector<S>(draw, n) * ratio<S>(1, 4)};
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
    visit(TwoCopies{aff}, std::string("two copies of Aff(1)"));
  }
}

}  // namespace actio::checks
